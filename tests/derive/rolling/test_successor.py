"""A surface takes over a ball at the edge of another one, or it is undecided whether it does."""

from __future__ import annotations

from typing import Any

import pytest
import sympy as sp
from hoopgen.derive.rolling import edges
from hoopgen.derive.state.fields import NONE

from tests.helpers.derived import evaluation

BALL = 0.05
INDEX = 3.0
NEAR_ENOUGH = 1e-12
"""Just more than twice the error of the position, m: as near to a bound it is undecided."""


def taken_over(**given: Any) -> tuple[float, float]:
    """Return the successor and the undecided time of a ball that touches a surface where it is."""
    kernel = edges._successor(sp.Float(BALL))
    known: dict[str, Any] = dict.fromkeys(("x", "y", "z", "vx", "vy", "vz"), 0.1)
    known |= {"gap": 0.0, "nearing": 0.0, "normal_cosine": 1.0, "index": INDEX}
    known |= {"position_error": 0.45 * NEAR_ENOUGH, "velocity_error": 1e-12}
    known |= {"outside_time": 0.0, "outside_distance": -1.0, "on_bound": False}
    known |= {"successor": float(NONE), "undecided_time": sp.oo} | given
    values = [known[str(symbol)] for symbol in kernel.arguments]
    successor, undecided = evaluation(kernel, kernel.arguments)(*map(float, values))
    return float(successor), float(undecided)


@pytest.mark.parametrize(
    ("outside", "undecided"),
    [
        ({}, False),
        ({"outside_time": 1e-9, "outside_distance": 0.9 * NEAR_ENOUGH}, False),
        ({"outside_time": 1e-9, "outside_distance": 0.9 * NEAR_ENOUGH, "on_bound": True}, True),
        ({"outside_time": 1e-9, "outside_distance": 2 * NEAR_ENOUGH, "on_bound": True}, False),
    ],
)
def test_a_ball_that_is_outside_a_bound_by_roundings_is_taken_over_nearly(
    outside: dict[str, Any], undecided: bool
) -> None:
    """Bounds at one place are lengths of different scales, of which one may say that it is past."""
    successor, time = taken_over(**outside)
    assert successor == (NONE if outside else INDEX)
    assert (time == 0) == undecided
    # Beside the surface the bound does not matter.
    assert taken_over(**outside, gap=1e-3) == (NONE, float("inf"))
    assert taken_over(**outside, nearing=1.0) == (NONE, float("inf"))


def test_a_second_surface_that_would_take_a_ball_over_leaves_it_undecided() -> None:
    assert taken_over(successor=1.0) == (1.0, 0.0)
