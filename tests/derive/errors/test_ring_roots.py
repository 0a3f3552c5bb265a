"""Proved bounds on the errors of time and place of a computed contact with the ring.

They are made of the computed F and F' at the accepted time, with their roundings, and of the
lemma of the second order. Random inputs are held against them with 200 bits.
`test_contact_roundings.py` has the contacts of shots.
"""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest
import sympy as sp
from hoopgen.derive.errors.second_order import STRETCH, second_order
from hoopgen.derive.scenes import HOOP
from numpy.typing import NDArray

from tests.derive.errors.test_kernel_roundings import (
    EXACT,
    SLACK,
    Floats,
    evaluated,
    flight_terms,
    flint,
    off_by,
)
from tests.derive.errors.test_ring_condition import (
    TERMS,
    Meeting,
    random_meetings,
    rate_terms,
)


def root_bound(at: Meeting, leaving: NDArray[np.bool_]) -> Floats:
    """Return the bound on the error of the computed time of a contact with the ring.

    The start is exact. At the computed time t the exact ball is at the distance D from the wire's
    circle and moves with v; F = D² - R², F' = 2 D (n·v). With φ, the computed |F| and its rounding,
    and φ', the computed |F'| less its own, it is off the surface by A = φ/(2 R) and nears it with
    V = φ'/(2 R), but for a factor within `ROUNDING_SLACK`. The ball at the nearest point of the
    surface with the same velocity is the first ball of the lemma in `second_order`, the exact one
    the other, with E = 0: there is exactly one root t* within

        |t - t*| <= S = 1.1 φ/φ'.

    On a return to the ring F is less its value at the start; all this then holds for the root at
    which D is that of the start, D(0), and for A = |D - D(0)|.

    Parameters
    ----------
    at
        The flights until their contacts.
    leaving
        True for a return that was found with F less its value at the start, (n,).

    Returns
    -------
    ndarray
        S, (n,), s, infinite where the lemma's conditions do not hold.
    """
    low = [SLACK * sum(TERMS[name](at)) for name in ("gap", "deflated", "rate")]
    size = np.where(leaving, np.abs(at.deflated) + low[1], np.abs(at.gap) + low[0])
    slope = np.abs(at.rate) - low[2]
    proved = (slope > 0) & (size <= at.reach**2 / 2**10)
    slope = np.where(proved, slope, 1)
    values = {
        "place_bound": SLACK * size / (2 * at.reach),
        "velocity_bound": 0.0,
        "speed": SLACK * np.sqrt((at.ends[3:] ** 2).sum(axis=0)),
        "approach": slope / (2 * at.reach) / SLACK,
        "pull": at.given["p_gravity"],
        "curvature": 1 / np.minimum(at.reach, at.given["p_ring_radius"] - at.reach),
    }
    proved = np.all([proved, *(evaluated(one, values) <= 0 for one in CONDITIONS)], axis=0)
    return np.where(proved, float(STRETCH) * SLACK * size / slope, np.inf)


CONDITIONS = second_order(HOOP.ball, sp.Integer(0)).valid


def place_terms(start: dict[str, Any], ends: Floats, late: Floats) -> list[Floats]:
    """Return the terms of the bound on the error of the place of a contact, (3, n) each.

    The flight's rounding p, and the way during the time S = `late`:
    |x_i - x_i(t*)| <= p_i + |v_i| S + |a_i| S²/2. What is linear in S lies along v.
    """
    pull = np.array([0.0, 0.0, 1.0])[:, None] * start["p_gravity"]
    path = sum(flight_terms(start, ends, start["p_gravity"]))
    return [SLACK * path, SLACK * np.abs(ends[3:]) * late, SLACK * pull * late**2 / 2]


def root_errors(at: Meeting, leaving: NDArray[np.bool_]) -> tuple[Floats, Floats]:
    """Return the errors of computed times and places, from the root that Newton's method finds.

    It starts at the computed time, and has 200 bits.
    """
    with flint.ctx.workprec(200):
        time = EXACT(at.given["t"])
        for _ in range(7):
            found = at.exact(time)
            step = np.where(leaving, found["deflated"], found["gap"]) / found["rate"]
            time = MIDDLE(time - step)
        assert np.all(np.abs(np.array(step, float)) < 1e-40)
        place = np.array(at.path(time)[0])
    return off_by(at.given["t"], lambda: list(time)), off_by(at.ends[:3], lambda: list(place))


MIDDLE = np.vectorize(lambda ball: ball.mid(), otypes=[object])


def returns(at: Meeting) -> NDArray[np.bool_]:
    """Return which flights start on the ring."""
    return np.abs(at.gap - at.deflated) < 1e-12


def random_roots(earliest: float, latest: float) -> Meeting:
    """Return random flights to the ring, a third early, and another late, by shares of the time."""
    random, at = np.random.default_rng(7), random_meetings()
    near = (np.abs(at.gap) < 1e-9) & (at.rate < 0)
    given = {name: values[near] for name, values in at.given.items()}
    rows = len(given["t"])
    share = random.integers(-1, 2, rows) * np.exp2(random.uniform(earliest, latest, rows))
    return Meeting(given | {"t": given["t"] * (1 + share)})


@cache
def met_roots() -> Meeting:
    """Return those of the random flights of which a root is proved."""
    at = random_roots(-52, -10)
    proved = np.isfinite(root_bound(at, returns(at)))
    assert np.mean(proved) > 0.8
    return Meeting({name: values[proved] for name, values in at.given.items()})


@cache
def errors_of_roots() -> tuple[Floats, Floats]:
    at = met_roots()
    return root_errors(at, returns(at))


@pytest.mark.slow
def test_the_errors_of_a_root_on_the_ring_are_within_their_proved_bounds() -> None:
    at = met_roots()
    assert np.sum(returns(at)) > 0.05 * len(at.rho)
    late = root_bound(at, returns(at))
    place = place_terms(at.given, at.ends, late)
    time_errors, place_errors = errors_of_roots()
    assert np.all(time_errors <= late)
    assert np.all(place_errors <= sum(place))
    assert np.median(time_errors / late) > 0.05


@pytest.mark.slow
@pytest.mark.parametrize("left_out", range(3))
def test_no_term_of_a_place_s_bound_may_be_left_out(left_out: int) -> None:
    """These are the flight's rounding, the way during the delay, and the fall during it."""
    at = met_roots()
    place = place_terms(at.given, at.ends, root_bound(at, returns(at)))
    rest = sum(term for k, term in enumerate(place) if k != left_out)
    assert np.any(errors_of_roots()[1] > rest)


@pytest.mark.slow
@pytest.mark.parametrize("leaving", [False, True])
def test_neither_the_computed_condition_nor_its_rounding_may_be_left_out(leaving: bool) -> None:
    at = met_roots()
    own = returns(at) == leaving
    name = "deflated" if leaving else "gap"
    found, rounding = np.abs(getattr(at, name)), SLACK * sum(TERMS[name](at))
    slope = np.abs(at.rate) - SLACK * sum(rate_terms(at))
    for size in (found, rounding):
        assert np.any((errors_of_roots()[0] > float(STRETCH) * SLACK * size / slope)[own])
    # Nor may the stretch: the speed towards the ring falls during the delay.
    assert np.any((errors_of_roots()[0] > SLACK * (found + rounding) / slope)[own])


def test_the_lemma_s_conditions_may_not_be_left_out() -> None:
    """The ball can be later than S where they do not hold."""
    at, exact = random_roots(-6, -3), random_roots(-99, -99)
    assert np.array_equal(at.given["x"], exact.given["x"])
    unproved = np.isinf(root_bound(at, returns(at))) & (at.rate < 0)
    errors = np.abs(at.given["t"] - exact.given["t"])
    assert np.any((errors > 2 * np.abs(at.gap / at.rate))[unproved])
