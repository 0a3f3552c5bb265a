"""The least distance of ball and wire along flights, by branch and bound."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hoopgen.generated.numpy import hoop
from hoopgen.installed import need
from hoopgen.parameters import Value

__all__ = ["nearest", "rows_of"]

Floats = NDArray[np.float64]

_HALVINGS = 50
"""Of a flight's time in the search for the wire: then a cell is shorter than the resolution."""

_SIZES = ("ball_radius", "ring_radius", "wire_radius", "gravity")


def rows_of(value: Value, rows: slice | NDArray[np.intp]) -> Value:
    """Return a parameter of some shots; one number for all stays."""
    return value if isinstance(value, float) else value[rows]


def nearest(states: Floats, durations: Floats, parameters: Mapping[str, Value]) -> Floats:
    """Return the least distance of ball and wire along flights, within their resolution.

    Branch and bound: a cell of time is left where the kernel's bound shows that no place in it is
    nearer than the nearest one known, and halved until the distance has at most one minimum in it.
    """

    def near(rows: NDArray[np.intp], t: Floats, half: Floats) -> Any:
        sizes = (rows_of(parameters[name], rows) for name in _SIZES)
        arguments = [t, *states[rows].T[:6], half, *sizes]
        return hoop.ring_nearness(*arguments)

    def note(rows: NDArray[np.intp], t: Floats) -> Any:
        gap, rate, *_ = near(rows, t, np.zeros_like(t))
        np.minimum.at(best, rows, gap)
        return rate

    rows = np.arange(len(states))
    best = np.full(len(states), np.inf)
    note(rows, np.zeros(len(states)))
    note(rows, durations)
    t = half = durations / 2
    for _ in range(_HALVINGS):
        gap, _, lower, concavity, resolution = near(rows, t, half)
        np.minimum.at(best, rows, gap)
        open_ = lower < best[rows] - resolution
        single = open_ & (concavity < 0.0)
        _bottom(near, note, rows[single], t[single], half[single])
        # What was found there may leave less to do.
        split = open_ & ~single & (lower < best[rows] - resolution)
        rows, half = np.repeat(rows[split], 2), np.repeat(half[split] / 2, 2)
        t = np.repeat(t[split], 2) + half * np.tile([-1.0, 1.0], len(t[split]))
        if not len(rows):
            break
    return best


def _bottom(
    near: Callable[..., Any],
    note: Callable[..., Any],
    rows: NDArray[np.intp],
    t: Floats,
    half: Floats,
) -> None:
    """Note the least distance in cells in which its rate rises throughout."""
    # Here, since a picture that needs a `Kind` need not have SciPy.
    elementwise = need("scipy.optimize.elementwise", "this measure")

    begin, end = t - half, t + half
    falls, rises = note(rows, begin) < 0.0, note(rows, end) > 0.0
    inside = falls & rises
    if np.any(inside):
        ends = (begin[inside], end[inside])
        found = elementwise.find_root(
            lambda at, row: near(row.astype(np.intp), at, np.zeros_like(at))[1],
            ends,
            args=(rows[inside],),
        )
        note(rows[inside], found.x)
