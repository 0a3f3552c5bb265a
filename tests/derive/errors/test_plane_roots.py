"""The rounding of the time of an arrival on a plane, whose root is a closed form: a proved bound.

It is of first order in u, times `ROUNDING_SLACK`, and held against 200 bits at random inputs.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache, cached_property
from typing import Any

import numpy as np
import pytest

from tests.derive.errors.test_kernel_roundings import EXACT, SLACK, Floats, U, called, off_by
from tests.derive.errors.test_ring_condition import ROOT, ROWS
from tests.helpers.effort import trials


def plane_terms(size: Any, gap: Any, path: Any, roundings: Any) -> list[Floats]:
    """Return the terms of a bound on V |t - t*|, t the computed time of an arrival on a plane.

    The gap c at the start is a difference with the computed place X of the plane: it is off by
    u |X| + u |c|, and the root t* by that over V, the speed at which the exact ball meets the
    plane. **Board.** t = -c/vx has a rounding, u V t, besides.
    **Bridge, end plane.** D = vz² + 2 g c has two products and a sum, and s = sqrt(D) a rounding:
    besides what c is off by, s = V is off by u (vz² + 2 g |c| + D)/(2 V) + u V, which is 2 u V for
    c >= 0 and 2 u g |c|/V more for c < 0. For vz >= 0 the time t = (vz + s)/g has two roundings
    besides: 2 u V²/g + 2 u V t <= 4 u V t in all, and 2 u |c| more for c < 0. For vz < 0 the time
    2 c/(s - vz) is positive if c is; what s is off by counts t/(s - vz) times, and there are two
    roundings: at most 4 u V t again. With k = 1 on the board and k = 4 on the others

        V |t - t*| <= u (|X| + |c| + max(0, -2 c) + k V t).

    **Return.** c = 0 and s = |vz| are exact, and t = 2 vz/g has one rounding: u V t, for the root
    at which the gap is that of the start.

    This is the first order in u; `ROUNDING_SLACK` covers the rest if g times it is at most V²/2^11.

    Parameters
    ----------
    size, gap, path, roundings
        |X| and c, 0 on a return, V t, and k.
    """
    return [U * size, U * (np.abs(gap) + np.maximum(0, -2 * gap)), U * roundings * path]


class Arrival:
    """Arrivals on a plane: what its kernel computes, the exact root, and the bound.

    Attributes
    ----------
    time, bound
        The computed time, s, and the bound on its error, infinite where none is proved.
    approach, terms
        V, and the terms of V times the bound.
    """

    def __init__(self, plane: str, given: dict[str, Any], leaving: Any) -> None:
        self.plane, self.given, self.leaving = plane, given, np.asarray(leaving, bool)
        self.level = LEVELS[plane](given)
        self.axis = "x" if plane == "backboard" else "z"
        place, speed, g = given[self.axis], given["v" + self.axis], given["p_gravity"]
        self.time, *_ = called(f"{plane}_arrival", leaving=self.leaving * 1.0, **given)
        gap = np.where(self.leaving, 0, place - self.level)
        curved = 0 if self.axis == "x" else 1
        squared = np.maximum(speed**2 + curved * 2 * g * gap, 0)
        approach = np.sqrt(squared)
        size = np.where(self.leaving | (plane == "end"), 0, np.abs(self.level))
        roundings = np.where(curved * ~self.leaving, 4, 1)
        self.terms = plane_terms(size, gap, approach * self.time, roundings)
        total = SLACK * sum(self.terms)
        self.valid = (squared > 0) & (curved * g * total <= squared / 2**11)
        self.bound = np.where(self.valid, total, np.inf) / np.where(self.valid, approach, 1)
        self.approach = approach

    def root(self) -> list[Any]:
        """Return the exact times of the arrivals, in balls."""
        own = {name: EXACT(value) for name, value in self.given.items()}
        speed, g = own["v" + self.axis], own["p_gravity"]
        gap = np.where(self.leaving, 0 * speed, own[self.axis] - LEVELS[self.plane](own))
        if self.axis == "x":
            return list(-gap / speed)
        return list((speed + ROOT(speed * speed + 2 * g * gap)) / g)

    @cached_property
    def error(self) -> Floats:
        """The errors of the computed times, s."""
        return off_by(self.time, self.root)


LEVELS: dict[str, Callable[[dict[str, Any]], Any]] = {
    "backboard": lambda own: own["p_ball_radius"] - own["p_board_distance"],
    "bridge": lambda own: own["p_ball_radius"] + own["p_wire_radius"],
    "end": lambda own: -own["p_end_depth"],
}
"""The coordinate of the ball's centre at a contact with each plane (Table 2)."""


@cache
def arrivals(plane: str, leaving: bool) -> Arrival:
    """Return random arrivals on a plane, from near and far, a quarter of them from below it."""
    random, rows = np.random.default_rng(8), trials(ROWS)
    sizes = ("p_ball_radius", "p_wire_radius", "p_board_distance", "p_end_depth")
    given = {name: random.uniform(0.01, 0.4, rows) for name in sizes}
    given["p_gravity"] = 2.0 ** random.uniform(-3, 5, rows)
    gap = 2.0 ** random.uniform(-30, 3, rows)
    speed = random.uniform(-9, 9, rows)
    speed[::3] *= 2.0**-10
    if leaving or plane == "backboard":
        speed = np.abs(speed) * (1 if leaving else -1)
    else:
        below = np.arange(rows) % 4 == 0
        gap[below] *= -1
        climb = np.sqrt(2 * given["p_gravity"] * np.abs(gap)) * (
            1 + 2.0 ** random.uniform(-9, 9, rows)
        )
        speed[below] = climb[below]
    axis = "x" if plane == "backboard" else "z"
    given |= {axis: LEVELS[plane](given) + (0 if leaving else gap), "v" + axis: speed}
    return Arrival(plane, given, leaving)


PLANES = [("backboard", False), ("bridge", False), ("bridge", True), ("end", False)]


@pytest.mark.sampled(2)
@pytest.mark.parametrize(("plane", "leaving"), PLANES)
def test_the_rounding_of_an_arrival_on_a_plane_is_within_its_proved_bound(
    plane: str, leaving: bool
) -> None:
    at = arrivals(plane, leaving)
    assert np.mean(at.valid) > 0.95
    share = at.error / at.bound
    assert share.max() <= 1
    assert share.max() > 0.5


@pytest.mark.parametrize(
    ("plane", "left_out"), [("backboard", k) for k in range(3)] + [("bridge", k) for k in range(3)]
)
def test_no_term_of_an_arrival_s_bound_may_be_left_out(plane: str, left_out: int) -> None:
    at = arrivals(plane, False)
    rest = SLACK * sum(term for k, term in enumerate(at.terms) if k != left_out)
    assert np.any((at.error * at.approach > rest)[at.valid])
