"""Bounds of bodies that balls roll on: for scenes that parameters turn, and as functions."""

from __future__ import annotations

import re
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from hoopgen.simulation.engine import Engine

Floats = NDArray[np.float64]

_TURNED = {
    "x": "(cos_turn*x + mirror*sin_turn*y)",
    "y": "(mirror*cos_turn*y - sin_turn*x)",
}


def turned_bounds(*bounds: str) -> list[str]:
    """Return bounds in the coordinates of a scene turned about z by an angle and then mirrored."""
    return [re.sub(r"\b[xy]\b", lambda found: _TURNED[found[0]], bound) for bound in bounds]


def bound(formula: str) -> Callable[[Floats], float]:
    """Return the function from a point to a bound there."""
    code = compile(formula, "bound", "eval")
    return lambda q: float(eval(code, {}, {"x": q[0], "y": q[1], "z": q[2]}))


def check_turned(
    engine: Engine, states: Floats, time_limit: float = 2, share: float = 0.85
) -> None:
    """Turn and mirror a scene and its shots; the spin, an axial vector, is mirrored back."""
    c, s, mirror = np.cos(0.7), np.sin(0.7), -1.0
    turn = np.diag([1, mirror, 1]) @ np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
    axial = mirror * turn
    moved = np.hstack([states[:, :3] @ turn.T, states[:, 3:6] @ turn.T, states[:, 6:] @ axial.T])
    values = {"cos_turn": c, "sin_turn": s, "mirror": mirror}
    fields = ("outcome", "rolls", "state", "state_error", "uncertain")
    first = engine.simulate(states, time_limit=time_limit, fields=fields)
    other = engine.simulate(moved, values, time_limit=time_limit, fields=fields)
    sure = ~(first.uncertain | other.uncertain)
    assert np.count_nonzero(sure) > share * len(states)
    assert np.array_equal(first.outcome[sure], other.outcome[sure])
    assert np.array_equal(first.rolls[sure], other.rolls[sure])
    for k, by in enumerate((turn, turn, axial)):
        part = slice(3 * k, 3 * k + 3)
        off = np.linalg.norm(first.state[sure, part] @ by.T - other.state[sure, part], axis=1)
        allowed = first.state_error[sure, k] + other.state_error[sure, k]
        # The turn itself rounds the start, by some units in the last place.
        assert np.all(off <= 4 * allowed), np.max(off / allowed)
