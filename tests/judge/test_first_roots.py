"""The first roots of many polynomials, and the arrivals at planes, are proved or left open."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest

from tests.helpers.effort import trials

pytest.importorskip("flint")

from hoopgen.judge import first_roots as roots_of_many
from hoopgen.judge.ball_array import BallArray

END = 1.0
DEGREE = 8
ROWS = 300


def value(coefficients: list[Fraction], time: Fraction) -> Fraction:
    found = Fraction(0)
    for coefficient in reversed(coefficients):
        found = found * time + coefficient
    return found


def from_roots(roots: list[Fraction], lead: Fraction) -> list[Fraction]:
    found = [lead]
    for root in roots:
        found = [
            a - root * b for a, b in zip([Fraction(0), *found], [*found, Fraction(0)], strict=True)
        ]
    return found


def as_coefficients(polynomials: list[list[Fraction]]) -> list[BallArray]:
    """Return polynomials as balls, whose radii are the roundings of the coefficients alone."""
    columns = [
        [polynomial[k] if k < len(polynomial) else Fraction(0) for polynomial in polynomials]
        for k in range(DEGREE + 1)
    ]
    middles = [np.array([float(c) for c in column]) for column in columns]
    radii = [
        np.array([float(abs(c - Fraction(float(m)))) for c, m in zip(own, middle, strict=True)])
        for own, middle in zip(columns, middles, strict=True)
    ]
    return [BallArray(m, r * (1 + 2.0**-50)) for m, r in zip(middles, radii, strict=True)]


def check_roots(roots: list[list[Fraction]], lead: int = 1) -> tuple[int, int]:
    """Check polynomials with given roots and others that are complex; count those decided."""
    random = np.random.default_rng(10)
    polynomials = []
    for own in roots:
        # Factors (t - p)² + q² have no real roots.
        found = from_roots(own, Fraction(lead * (-1) ** len(own)))
        while len(found) <= DEGREE - 2:
            p, q = (Fraction(int(k), 64) for k in random.integers(1, 100, 2))
            more = [p * p + q * q, -2 * p, Fraction(1)]
            found = [
                sum(
                    (found[j] * more[k - j] for j in range(len(found)) if 0 <= k - j < 3),
                    Fraction(0),
                )
                for k in range(len(found) + 2)
            ]
        polynomials.append(found)
    end = np.full(len(roots), END)
    part = roots_of_many.first_roots(as_coefficients(polynomials), end)
    for row, own in enumerate(roots):
        inside = sorted(root for root in own if 0 < root < END)
        assert not (part.found[row] and part.none[row])
        if part.none[row]:
            assert not inside
        if part.found[row]:
            low, high = (Fraction(float(side[row])) for side in (part.low, part.high))
            assert low < inside[0] < high
            assert len(inside) == 1 or inside[1] > high
    return int(part.found.sum()), int(part.none.sum())


def test_the_first_of_several_roots_is_isolated() -> None:
    random, rows = np.random.default_rng(11), trials(ROWS)
    roots = [
        sorted(
            Fraction(int(k), 1009)
            for k in random.choice(np.arange(1, 1500), random.integers(0, 6), replace=False)
        )
        for _ in range(rows)
    ]
    found, none = check_roots(roots)
    assert found > rows / 2
    assert found + none > 0.98 * rows


@pytest.mark.slow
def test_roots_that_are_too_close_are_left_open_and_none_is_missed() -> None:
    """Two roots a tiny way apart lie below the roundings; a simple root comes behind them."""
    rows = ROWS
    for exponent in (10, 20, 26, 30, 45):
        roots = [
            [Fraction(k + 1, 3 * rows), Fraction(k + 1, 3 * rows) + Fraction(1, 2**exponent)]
            + [Fraction(1023, 1024)]
            for k in range(rows)
        ]
        found, none = check_roots(roots)
        assert none == 0
        assert found > 0.9 * rows if exponent == 10 else found == 0 or exponent < 30
        triple = [[*own[:2], own[0] + Fraction(2, 2**exponent)] for own in roots]
        check_roots(triple)


def test_an_exact_touch_is_left_open() -> None:
    roots = [[Fraction(k, 64)] * 2 for k in range(1, 64)]
    assert check_roots(roots) == (0, 0)
    with_later = [[*own, Fraction(127, 128)] for own in roots]
    assert check_roots(with_later) == (0, 0)


def test_a_polynomial_that_begins_at_zero_or_below_is_left_open() -> None:
    assert check_roots([[Fraction(0), Fraction(1, 2)]]) == (0, 0)
    assert check_roots([[Fraction(1, 2)]], lead=-1) == (0, 0)


def test_coefficients_that_are_hardly_known_decide_nothing() -> None:
    coefficients = as_coefficients([from_roots([Fraction(1, 3)], Fraction(-1))] * 2)
    coefficients[0].radius = np.array([1e-9, 0.5])
    part = roots_of_many.first_roots(coefficients, np.array([END, END]))
    assert part.found.tolist() == [True, False]
    assert not part.none.any()
    coefficients[0].radius = np.array([np.inf, np.nan])
    part = roots_of_many.first_roots(coefficients, np.array([END, END]))
    assert not part.found.any()
    assert not part.none.any()


def test_a_number_near_the_root_is_found_in_its_part() -> None:
    roots = [Fraction(k, 1009) for k in range(1, 1009, 10)]
    coefficients = as_coefficients([from_roots([root], Fraction(-1)) for root in roots])
    ends = np.zeros(len(roots)), np.ones(len(roots))
    near = roots_of_many.near_roots(coefficients, *ends)
    assert np.allclose(near, [float(root) for root in roots], rtol=1e-10, atol=0)


# ------------------------------------------------------------------------------------------ planes


def check_planes(curved: bool, returning: bool) -> int:
    """Check arrivals at planes, some of them close to a touch; return how many are certain."""
    random, rows = np.random.default_rng(12), trials(4 * ROWS)
    c, b = random.normal(size=(2, rows)) * 2.0 ** random.integers(-30, 3, (2, rows))
    a = -(2.0 ** random.uniform(-2, 3, rows))
    touch = np.arange(rows) % 3 == 0
    if curved:
        c[touch] = (b**2 / (4 * a))[touch] * (1 + 2.0**-50 * random.integers(-3, 3, touch.sum()))
    else:
        b[touch] = 0.0
    c[1::7] = 0.0
    # Some are known within a radius, at an end of which the exact number is.
    middles = np.array([c, b, a][: 3 if curved else 2])
    radii = 2.0**-40 * random.integers(0, 2, middles.shape)
    ends = random.choice([-1, 1], middles.shape)
    with np.errstate(all="ignore"):
        balls = [BallArray(m, r) for m, r in zip(middles, radii, strict=True)]
        found = roots_of_many.plane_arrivals(balls, np.full(rows, returning))
    for row in range(rows):
        exact = [
            Fraction(float(m)) + int(e) * Fraction(float(r))
            for m, e, r in zip(middles[:, row], ends[:, row], radii[:, row], strict=True)
        ] + [Fraction(0)] * (not curved)
        check_arrival(exact, returning, found, row)
    return int(found.certain.sum())


def check_arrival(exact: list[Fraction], returning: bool, found: object, row: int) -> None:
    c, b, a = exact
    c = Fraction(0) if returning else c
    certain, earliest = found.certain[row], found.earliest[row]  # type: ignore[attr-defined]
    time = found.time  # type: ignore[attr-defined]
    squared = b * b - 4 * a * c

    def after(moment: Fraction) -> bool:
        """Return whether the gap falls through zero after a positive time."""
        if a == 0:
            return b < 0 < c and -c / b >= moment
        return squared > 0 and (slope(moment) >= 0 or value([c, b, a], moment) >= 0)

    def slope(moment: Fraction) -> Fraction:
        return b + 2 * a * moment

    if certain:
        middle, radius = Fraction(float(time.middle[row])), Fraction(float(time.radius[row]))
        low, high = middle - radius, middle + radius
        assert low > 0
        assert value([c, b, a], low) >= 0 >= value([c, b, a], high)
        assert slope(low) < 0 or a < 0
        assert Fraction(float(earliest)) <= low
    elif np.isinf(earliest):
        falls = after(Fraction(0)) and not (a != 0 and larger_root_is_not_positive(c, b, a))
        assert not falls
    elif earliest > 0:
        assert squared <= 0 or a == 0 or after(Fraction(float(earliest)))
        assert not (a == 0 and b < 0 < c) or after(Fraction(float(earliest)))


def larger_root_is_not_positive(c: Fraction, b: Fraction, a: Fraction) -> bool:
    """Return whether no root of a parabola that opens downwards is positive."""
    return b <= 0 and c <= 0


@pytest.mark.parametrize("returning", [False, True])
@pytest.mark.parametrize("curved", [False, True])
def test_arrivals_at_planes_are_those_of_exact_arithmetic(curved: bool, returning: bool) -> None:
    certain = check_planes(curved, returning)
    assert (certain == 0) == (returning and not curved)


def test_a_plane_that_gravity_pulls_a_ball_off_is_left_open() -> None:
    given = [np.array([1.0]), np.array([-3.0]), np.array([1.0])]
    found = roots_of_many.plane_arrivals([BallArray.exact(x) for x in given], np.array([False]))
    assert not found.certain[0]
    assert found.earliest[0] == 0
