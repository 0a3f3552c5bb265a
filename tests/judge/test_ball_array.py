"""Balls of doubles hold the exact results of their operations, rounded outwards."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from tests.helpers.effort import trials

pytest.importorskip("flint")

import flint

from hoopgen.judge import ball_array
from hoopgen.judge.ball_array import BallArray, Floats, PolynomialArray

ROWS = 400

OPERATIONS: dict[str, Callable[[Any, Any], Any]] = {
    "+": lambda a, b: a + b,
    "-": lambda a, b: a - b,
    "*": lambda a, b: a * b,
    "/": lambda a, b: a / b,
}


def numbers(random: np.random.Generator, rows: int) -> Floats:
    """Return numbers of many sizes, a third of them zero, and some with few digits."""
    found = random.normal(size=rows) * 2.0 ** random.integers(-60, 4, rows)
    found *= random.integers(0, 3, rows) > 0
    return np.where(random.random(rows) < 0.2, np.round(found * 8) / 8, found)


def balls(random: np.random.Generator, rows: int) -> BallArray:
    return BallArray(numbers(random, rows), np.abs(numbers(random, rows)))


def ends(ball: BallArray, row: int) -> list[Fraction]:
    middle, radius = Fraction(float(ball.middle[row])), Fraction(float(ball.radius[row]))
    return [middle - radius, middle, middle + radius]


def holds(found: BallArray, row: int, true: Fraction) -> bool:
    if not np.isfinite(found.radius[row]):
        return True
    low, _, high = ends(found, row)
    return low <= true <= high


@pytest.mark.parametrize("name", OPERATIONS)
def test_results_hold_the_exact_ones_of_all_numbers_in_the_balls(name: str) -> None:
    """Ends of balls are tried, where the bounds are reached, and products that underflow."""
    random, rows = np.random.default_rng(1), trials(ROWS)
    a, b = balls(random, rows), balls(random, rows)
    tiny = np.arange(rows) % 16 == 0
    a.middle[tiny] *= 2.0**-600
    b.middle[tiny] *= 2.0**-600 if name == "*" else 1.0
    a.radius[tiny] = b.radius[tiny] = 0.0
    with np.errstate(all="ignore"):
        found = OPERATIONS[name](a, b)
    close = 0
    for row in range(rows):
        for x in ends(a, row):
            for y in ends(b, row):
                if name == "/" and not (ends(b, row)[0] > 0 or ends(b, row)[2] < 0):
                    assert not np.isfinite(found.radius[row])
                    continue
                true = OPERATIONS[name](x, y)
                assert holds(found, row, true)
                wide = Fraction(float(found.radius[row]))
                close += abs(true - Fraction(float(found.middle[row]))) > wide / 2
    assert close > rows


def test_roots_hold_the_exact_ones_of_all_numbers_in_the_balls() -> None:
    random, rows = np.random.default_rng(2), trials(ROWS)
    a = balls(random, rows)
    a.middle = np.abs(a.middle)
    with np.errstate(all="ignore"):
        found = a.sqrt()
    for row in range(rows):
        low, _, high = ends(found, row)
        for x in ends(a, row):
            if x >= 0:
                assert low <= 0 or low**2 <= x
                assert x <= high**2
    with np.errstate(all="ignore"):
        assert np.isnan(BallArray(np.array([-1.0]), np.array([0.5])).sqrt().radius[0])


def test_signs_sizes_and_ends_are_those_of_all_numbers_in_the_balls() -> None:
    random, rows = np.random.default_rng(3), trials(ROWS)
    a = balls(random, rows)
    a.radius[::4] = np.abs(a.middle[::4]) * (1 - 2.0**-53)
    least, upper, lower, size = a.least_size(), a.upper(), a.lower(), a.size()
    for row in range(rows):
        low, _, high = ends(a, row)
        assert a.positive()[row] == (low > 0)
        assert a.negative()[row] == (high < 0)
        assert Fraction(float(lower[row])) <= low
        assert Fraction(float(upper[row])) >= high
        assert Fraction(float(size[row])) >= max(abs(low), abs(high))
        if np.isfinite(least[row]):
            assert Fraction(float(least[row])) <= min(abs(low), abs(high))
            assert low > 0 or high < 0


def test_a_number_that_is_not_finite_decides_nothing() -> None:
    with np.errstate(all="ignore"):
        huge = BallArray.exact(np.array([1e300, -1e300, np.nan]))
        for found in (huge * huge, huge * huge - huge * huge, huge / BallArray.exact(np.zeros(3))):
            assert not found.positive().any()
            assert not found.negative().any()


def test_constants_of_formulas_are_held_and_large_ones_refused() -> None:
    third = ball_array.as_balls(flint.fmpq(1, 3))
    assert holds(third, 0, Fraction(1, 3))
    assert third.radius[0] < 1e-16
    with pytest.raises(ValueError, match="2\\^53"):
        ball_array.as_balls(2**53 + 1)


def test_polynomials_multiply_and_add_as_their_coefficients_do() -> None:
    one, two = (BallArray.exact(np.array([value])) for value in (3.0, 5.0))
    time = PolynomialArray([0, 1])
    product = (one + two * time) * (two + one * (time * time)) + one
    assert [float(c.middle[0]) for c in product.coeffs()] == [18.0, 25.0, 9.0, 15.0]
    assert [float(c.middle[0]) for c in (-product).coeffs()] == [-18.0, -25.0, -9.0, -15.0]
