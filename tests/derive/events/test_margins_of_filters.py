"""Margins that hardly any shot needs: of a plate's filter, a box's bend, the normal's turn."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
import sympy as sp
from hoopgen.derive.events import plane_filter, root_finder_for
from hoopgen.derive.motion.parabola import Parabola
from hoopgen.derive.scenes import HOOP
from hoopgen.derive.surfaces import Box, Plane
from hoopgen.generated.numpy import court

from hoopgen import PAPER, PAPER_COURT
from tests.derive.test_evaluation import digits, exactly, in_doubles

_, BOARD, BRIDGE = HOOP.surfaces
G, REACH, SIZE = sp.symbols("g reach size", positive=True)
CUBE = Box("cube", (sp.Integer(0),) * 3, (SIZE, SIZE, SIZE), REACH)


# ----------------------------------------------------------------------------- a plate's filter


def is_apart(plate: Any, state: dict[str, float], errors: tuple[float, float]) -> list[bool]:
    """Return which conditions say that a flight of 0.5 s, with such errors, misses a plate."""
    assert isinstance(plate, Plane)
    values: dict[str, Any] = dict.fromkeys(("x", "y", "z", "vx", "vy", "vz"), 0.0) | state
    values |= {
        "horizon": 0.5,
        "extent": sum(abs(values[p]) for p in "xyz"),
        "speed": sum(abs(values[f"v{p}"]) for p in "xyz"),
        "position_error": errors[0],
        "velocity_error": errors[1],
        "pad": 1.0,
        "earliest_delay": 0.0,
    }
    conditions = {str(k): e for k, e in enumerate(plane_filter.apart(plate, HOOP.flight))}
    return [bool(found) for found in in_doubles(conditions, dict(PAPER) | values).values()]


@pytest.mark.parametrize("errors", [(1e-3, 0.0), (0.0, 2e-3), (1e-3, 2e-3)])
def test_a_ball_that_errors_bring_to_a_plate_is_not_apart_from_it(
    errors: tuple[float, float],
) -> None:
    off = errors[0] + 0.5 * errors[1]
    board = PAPER["ball_radius"] - PAPER["board_distance"]
    assert not any(is_apart(BOARD, {"x": board + 0.999 * off}, errors))
    assert any(is_apart(BOARD, {"x": board + 1.001 * off}, errors))
    # A ball at the bridge's edge, inside the ring's circle; the bridge is beyond the circle.
    circle = math.sqrt(PAPER["ring_radius"] ** 2 - PAPER["bridge_half_width"] ** 2)
    assert not any(is_apart(BRIDGE, {"x": -(circle - 0.999 * off)}, errors))
    assert any(is_apart(BRIDGE, {"x": -(circle - 4 * off)}, errors))


# ------------------------------------------------------------------------- a box's curvature


def test_the_gap_of_a_slow_ball_beside_a_box_bends_as_free_fall_bends_it() -> None:
    """A ball at rest e above a face has F'' = -2 e g; no speed hides that part of the bound."""
    search = root_finder_for(CUBE, Parabola((sp.Integer(0), sp.Integer(0), -G)))
    width = sp.Symbol("width", nonnegative=True)
    bound = search.curvature(width)
    sizes = {"size": 0.5, "reach": 0.1, "g": 9.81, "ceiling": 0.0, "width": 0.0, "t": 0.0}
    with digits(30):
        for beyond in (0.01, 0.05, 0.1):
            values = sizes | dict.fromkeys(("x", "y", "vx", "vy", "vz"), 0.0)
            values |= {"x": 0.25, "y": 0.25, "z": 0.5 + beyond}
            bend = exactly(search.bend, values)
            assert bend == pytest.approx(-2 * beyond * 9.81)
            assert exactly(bound, values) >= -bend * (1 - 1e-12)


# ---------------------------------------------------------------------- the turn of the normal


def test_errors_after_an_impact_hold_a_share_of_what_the_normal_s_turn_makes() -> None:
    """Without errors of the motion, the turn of the normal alone is the worst case."""
    given = dict.fromkeys(court.ARGUMENTS["carry_ring_impact"], 0.0)
    given |= {f"p_{name}": value for name, value in PAPER_COURT.items()}
    given |= {"vx": 1.0, "vz": -3.0, "wy": 5.0, "nz": 1.0, "turn": 1e-6, "contacts": 1.0}
    given |= {"lifting": 1 / 16, "p_ring_friction": 0.4, "p_restitution_speed": 1e6}
    arguments = [np.float64(given[name]) for name in court.ARGUMENTS["carry_ring_impact"]]
    found = dict(
        zip(court.OUTPUTS["carry_ring_impact"], court.carry_ring_impact(*arguments), strict=True)
    )
    worst = (4 + PAPER_COURT["ball_radius"] * 5) * 1e-6
    radius = PAPER_COURT["ball_radius"]
    for axis in "xy":  # along the surface; off it the speed's error falls with the speed
        assert abs(found[f"dv{axis}"]) >= worst / 16 * (1 - 1e-6)
    for axis in "xyz":
        assert abs(found[f"dw{axis}"]) >= worst / radius / 16 * (1 - 1e-6)
