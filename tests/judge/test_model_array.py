"""Models of many shots hold exact results of operations, for the same causes of errors."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from tests.helpers.effort import trials

pytest.importorskip("flint")

import flint

from hoopgen.judge import error_set_array
from hoopgen.judge.ball_array import Floats
from hoopgen.judge.model_array import SLOPES, ModelArray, as_models
from tests.judge.test_ball_array import OPERATIONS, numbers

ROWS = 300


def models(random: np.random.Generator, rows: int) -> ModelArray:
    """Return models of which midpoints, slopes and radii are sometimes zero."""
    high = numbers(random, rows)
    low = high * random.normal(size=rows) * 2.0**-55 * random.integers(0, 2, rows)
    low *= 2.0 ** -(20.0 * random.integers(0, 2, rows))
    radius = np.abs(numbers(random, rows)) * random.integers(0, 2, rows)
    slopes = random.normal(size=(SLOPES, rows)) * 2.0 ** random.integers(-40, 1, rows)
    return ModelArray(high, low, radius, slopes * random.integers(0, 2, rows))


def cancelling(random: np.random.Generator, rows: int) -> tuple[ModelArray, ModelArray]:
    """Return exact models whose low parts cancel the rounding of the sum or product of the high."""
    a, b = (random.normal(size=rows) for _ in range(2))
    sums = np.arange(rows) % 2 == 0
    exact = [Fraction(float(x)) for x in a], [Fraction(float(y)) for y in b]
    left = [
        float((Fraction(float(x + y)) - (p + q)) if add else (Fraction(float(x * y)) - p * q) / p)
        for x, y, p, q, add in zip(a, b, *exact, sums, strict=True)
    ]
    part = random.random(rows) * 0.5 * 2.0**-54 * np.abs(a) * sums
    other = np.clip(np.array(left) - part, -(2.0**-53) * np.abs(b), 2.0**-53 * np.abs(b))
    none = np.zeros((2, rows))
    return ModelArray(a, part, none[0], None), ModelArray(b, other, none[1], None)


def values(model: ModelArray, row: int, signs: Floats, end: int) -> Fraction:
    """Return a number of a model: for causes at the ends, and one end of the radius."""
    found = Fraction(float(model.high[row])) + Fraction(float(model.low[row]))
    if model.slopes is not None:
        found += sum(
            Fraction(float(s)) * int(e) for s, e in zip(model.slopes[:, row], signs, strict=True)
        )
    return found + end * Fraction(float(model.radius[row]))


def off_by(found: ModelArray, row: int, signs: Floats, true: Fraction) -> Fraction:
    return abs(true - values(found, row, signs, 0)) - Fraction(float(found.radius[row]))


def check_operation(operation: Callable[[Any, Any], Any], a: ModelArray, b: ModelArray) -> int:
    """Check all rows; return how many are so close to the bound that half would not do."""
    random, close = np.random.default_rng(4), 0
    with np.errstate(all="ignore"):
        found = operation(a, b)
    for row in range(len(a.high)):
        if not np.isfinite(found.radius[row]):
            continue
        for end in (-1, 0, 1):
            for other in (-1, 1):
                signs = random.choice([-1, 1], SLOPES)
                x, y = values(a, row, signs, end), values(b, row, signs, other)
                true = operation(x, y)
                off = off_by(found, row, signs, true)
                assert off <= 0
                close += off > -Fraction(float(found.radius[row])) / 2
    return close


@pytest.mark.sampled(1)
@pytest.mark.parametrize("name", OPERATIONS)
def test_results_are_of_the_models_for_the_same_causes(name: str) -> None:
    random, rows = np.random.default_rng(5), ROWS
    a, b = models(random, rows), models(random, rows)
    if name == "/":  # what divides must not be zero
        for array in (b.radius, b.slopes):
            assert array is not None
            array *= 2.0**-80
    assert check_operation(OPERATIONS[name], a, b) > rows / 4


@pytest.mark.parametrize("name", ["+", "*"])
def test_midpoints_are_exact_but_for_their_bound_where_low_parts_cancel(name: str) -> None:
    random = np.random.default_rng(6)
    a, b = cancelling(random, trials(ROWS))
    check_operation(OPERATIONS[name], a, b)
    check_operation(OPERATIONS[name], b, a)
    # And where a low part is much smaller than the rounding that it is added to.
    a.low, b.low = 0 * a.low, b.high * random.normal(size=len(a.high)) * 2.0**-75
    check_operation(OPERATIONS[name], a, b)
    check_operation(OPERATIONS[name], b, a)


def test_products_that_underflow_are_held() -> None:
    a = ModelArray.exact(np.array([3e-200, 2.0**-540]))
    check_operation(OPERATIONS["*"], a, a)


def test_roots_are_of_the_models_for_the_same_causes() -> None:
    random, rows = np.random.default_rng(7), trials(ROWS)
    a = models(random, rows)
    a.high, a.low = np.abs(a.high), np.zeros(rows)
    assert a.slopes is not None
    a.slopes *= 2.0 ** random.integers(-60, -20, rows) * a.high
    a.radius *= 2.0**-80 * a.high
    with np.errstate(all="ignore"):
        found = a.sqrt()
    for row in range(rows):
        if not np.isfinite(found.radius[row]):
            assert a.high[row] == 0
            continue
        for end in (-1, 1):
            signs = random.choice([-1, 1], SLOPES)
            x = values(a, row, signs, end)
            middle, radius = values(found, row, signs, 0), Fraction(float(found.radius[row]))
            assert middle - radius > 0
            assert (middle - radius) ** 2 <= x <= (middle + radius) ** 2


def test_errors_of_one_cause_cancel() -> None:
    slopes = np.zeros((SLOPES, 1))
    slopes[3] = 1e-9
    x = ModelArray(np.array([1.25]), np.zeros(1), np.zeros(1), slopes)
    assert (x - x).size()[0] < 1e-24
    assert (x * x - x * x).size()[0] < 1e-15
    assert (x / x - 1).size()[0] < 1e-16


def test_balls_of_models_hold_them() -> None:
    random, rows = np.random.default_rng(8), trials(ROWS)
    a = models(random, rows)
    found, away, size = a.balls(), a.away(), a.size()
    for row in range(rows):
        assert a.slopes is not None
        for end in (-1, 1):
            signs = np.where(a.slopes[:, row] < 0, -end, end)
            x = values(a, row, signs, end)
            assert abs(x - Fraction(float(a.high[row]))) <= Fraction(float(away[row]))
            assert abs(x - Fraction(float(found.middle[row]))) <= Fraction(float(found.radius[row]))
            assert abs(x) <= Fraction(float(size[row]))


def test_rational_constants_have_the_digits_of_two_doubles() -> None:
    fifth = as_models(flint.fmpq(2, 5))
    off = abs(values(fifth, 0, np.zeros(SLOPES), 0) - Fraction(2, 5))
    assert 0 < off <= Fraction(float(fifth.radius[0])) < Fraction(1, 10**30)


# --------------------------------------------------------------------------------- error sets


def solved(matrix: list[list[Fraction]], right: list[Fraction]) -> list[Fraction]:
    """Return the exact solution of a linear system (Gauss and Jordan)."""
    rows = [[*row, value] for row, value in zip(matrix, right, strict=True)]
    size = len(rows)
    for k in range(size):
        pivot = max(range(k, size), key=lambda j: abs(rows[j][k]))
        rows[k], rows[pivot] = rows[pivot], rows[k]
        rows[k] = [value / rows[k][k] for value in rows[k]]
        for j in range(size):
            if j != k:
                factor = rows[j][k]
                rows[j] = [a - factor * b for a, b in zip(rows[j], rows[k], strict=True)]
    return [row[-1] for row in rows]


def check_error_sets(skew: float = 0.0) -> None:
    """Check that all numbers of models are of those with one error set.

    With `skew` the sides are not quite orthogonal.
    """
    random, rows = np.random.default_rng(9), 3
    state = [ModelArray.exact(random.normal(size=rows)) for _ in range(9)]
    for k, model in enumerate(state):
        size = 2.0 ** -random.integers(60, 80)
        model.slopes = random.normal(size=(SLOPES, rows)) * size
        model.slopes[:, ::3] *= k % 4 == 0
        model.radius = np.abs(random.normal(size=rows)) * size * (np.arange(rows) % 2)
    usual = error_set_array._sides

    def skewed(slopes: Floats, radii: Floats) -> Floats:
        return usual(slopes, radii) * (1 - skew * np.tri(9)[:, :, None])

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(error_set_array, "_sides", skewed)
        found = error_set_array.condensed(state)
    sizes, reached = error_set_array.SCALES[:, 0], 0.0
    for row in range(rows):
        own = np.array([m.slopes[:, row] for m in found]) / sizes[:, None]  # type: ignore[index]
        inverse = np.linalg.inv(own)
        given = np.array([m.slopes[:, row] for m in state]) / sizes[:, None]  # type: ignore[index]
        sides = [[Fraction(float(s)) for s in m.slopes[:, row]] for m in found]  # type: ignore[index]
        for k in range(9):  # as far as one of the new causes can be reached
            signs, ends = np.sign((inverse @ given)[k]), np.sign(inverse[k])
            off = [
                values(m, row, signs, int(e)) - Fraction(float(m.high[row]))
                for m, e in zip(state, ends, strict=True)
            ]
            causes = solved(sides, off)
            assert max(map(abs, causes)) <= 1
            reached = max(reached, float(abs(causes[k])))
    assert reached > 1 - max(2.0**-20, 64 * skew) or skew > 0.1


def test_an_error_set_holds_all_numbers_of_the_models() -> None:
    check_error_sets()


def test_an_error_set_whose_sides_are_not_quite_orthogonal_holds_them_too() -> None:
    check_error_sets(2.0**-24)


def test_an_error_set_without_orthogonal_sides_becomes_a_box() -> None:
    check_error_sets(0.25)
