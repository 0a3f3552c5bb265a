"""Ball arithmetic on arrays of doubles, many shots at once.

A ball (m, r) holds all reals within r of m. Operations are those of doubles, rounded to nearest, so
that NumPy does them; the terms and radii of each count every rounding, with u = 2^-53.

**Lemma (operations).** If x is in the ball a and y in the ball b, then x + y, x y, x/y and sqrt(x)
are in the balls that `+`, `*`, `/` and `sqrt` return, unless a radius is infinite or no number.

*Proof.* A rounded result m is off by at most u |m|. Besides, |x + y - (ma + mb)| <= ra + rb;
|x y - ma mb| <= |ma| rb + |mb| ra + ra rb; |x/y - ma/mb| = |(x - ma) mb - ma (y - mb)|/|y mb| is at
most (ra + |ma/mb| rb)/|y|; |sqrt(x) - sqrt(ma)| = |x - ma|/(sqrt(x) + sqrt(ma)) <= ra/sqrt(ma). The
root of a ball that holds zero is within [0, sqrt(upper end)], as x >= 0.

*Radii are rounded outwards.* A radius is made of sums, products and quotients of numbers that are
not negative, by at most 16 operations, each off by a factor within 1 ± u, so that it is too small
by less than (1 + u)^16 < 1 + 2^-48. The factor `OUTWARDS` = 1 + 2^-40, which is rounded once
itself, makes up for that, and for |ma/mb| in place of its rounded value. A difference |m| - r that
divides is rounded inwards, by `INWARDS` = 1 - 2^-40, which makes up for its own rounding. An end
m ± r of a ball is rounded by at most u (|m| + r), for which `ENDS` |m| + 2^-40 r is added.

*Underflow.* A sum of doubles has none. A product, quotient or square that underflows is off by at
most 2^-1074, and an operation has fewer than 32 of them; `TINY` = 2^-1000 is added to each radius.
Overflow makes a midpoint or a radius infinite or no number, and the decisions below are false. ∎
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import TypeAlias

import numpy as np
from flint import fmpq
from numpy.typing import NDArray

Floats: TypeAlias = NDArray[np.float64]
Bools: TypeAlias = NDArray[np.bool_]
Rows: TypeAlias = NDArray[np.int64]
Factor: TypeAlias = "BallArray | int | fmpq"

UNIT = 2.0**-53
OUTWARDS = 1 + 2.0**-40
INWARDS = 1 - 2.0**-40
TINY = 2.0**-1000
ENDS = 2.0**-51


class BallArray:
    """An array of balls; the lemma above says what its operations hold.

    Attributes
    ----------
    middle, radius
        float64, (n,) each, or (1,): one ball for all shots.
    """

    __slots__ = ("middle", "radius")

    def __init__(self, middle: Floats, radius: Floats) -> None:
        self.middle, self.radius = middle, radius

    @classmethod
    def exact(cls, values: Floats) -> BallArray:
        """Return doubles as balls without radii."""
        return cls(values, np.zeros_like(values))

    def __getitem__(self, rows: Rows | Bools) -> BallArray:
        if len(self.middle) == 1:
            return self
        return BallArray(self.middle[rows], self.radius[rows])

    # ------------------------------------------------------------------------------- arithmetic

    def __add__(self, other: Factor) -> BallArray:
        if isinstance(other, PolynomialArray):
            return NotImplemented
        b = as_balls(other)
        middle = self.middle + b.middle
        return _rounded(middle, self.radius + b.radius)

    __radd__ = __add__

    def __neg__(self) -> BallArray:
        return BallArray(-self.middle, self.radius)

    def __sub__(self, other: Factor) -> BallArray:
        return self + -as_balls(other)

    def __rsub__(self, other: Factor) -> BallArray:
        return as_balls(other) + -self

    def __mul__(self, other: Factor) -> BallArray:
        if isinstance(other, PolynomialArray):
            return NotImplemented
        b = as_balls(other)
        radius = np.abs(self.middle) * b.radius + (np.abs(b.middle) + b.radius) * self.radius
        return _rounded(self.middle * b.middle, radius)

    __rmul__ = __mul__

    def __truediv__(self, other: Factor) -> BallArray:
        b = as_balls(other)
        quotient = self.middle / b.middle
        return _rounded(quotient, (self.radius + np.abs(quotient) * b.radius) / b.least_size())

    def __rtruediv__(self, other: Factor) -> BallArray:
        return as_balls(other) / self

    def __abs__(self) -> BallArray:
        return BallArray(np.abs(self.middle), self.radius)

    def sqrt(self) -> BallArray:
        """Return the roots of numbers that are not negative."""
        above = self.positive()
        root = np.sqrt(np.where(above, self.middle, 0.0))
        # A ball that is negative as a whole has no roots: no number.
        widest = np.sqrt(np.where(self.negative(), np.nan, self.size()))
        return _rounded(root, np.where(above, self.radius / root, widest))

    # -------------------------------------------------------------------------------- decisions

    def positive(self) -> Bools:
        """Return a mask of the balls whose numbers are all positive."""
        return np.asarray(self.middle > self.radius)

    def negative(self) -> Bools:
        """Return a mask of the balls whose numbers are all negative."""
        return np.asarray(-self.middle > self.radius)

    def size(self) -> Floats:
        """Return upper bounds on the sizes of the numbers in the balls."""
        return np.asarray((np.abs(self.middle) + self.radius) * OUTWARDS)

    def least_size(self) -> Floats:
        """Return lower bounds on those sizes, no number where a ball may hold zero."""
        least = (np.abs(self.middle) - self.radius) * INWARDS
        return np.asarray(np.where(least > 0, least, np.nan))

    def upper(self) -> Floats:
        """Return doubles above the balls."""
        return np.asarray(self.middle + (ENDS * np.abs(self.middle) + self.radius) * OUTWARDS)

    def lower(self) -> Floats:
        """Return doubles below the balls."""
        return np.asarray(self.middle - (ENDS * np.abs(self.middle) + self.radius) * OUTWARDS)


def _rounded(middle: Floats, radius: Floats) -> BallArray:
    """Return the ball of a rounded result, from what the arguments' radii add to its own."""
    return BallArray(middle, (radius + UNIT * np.abs(middle)) * OUTWARDS + TINY)


def as_balls(number: Factor) -> BallArray:
    """Return a number of a formula as one ball for all shots."""
    return number if isinstance(number, BallArray) else _constant(number)


@lru_cache(maxsize=256)
def _constant(number: int | fmpq) -> BallArray:
    if isinstance(number, fmpq):
        return _constant(int(number.p)) / _constant(int(number.q))
    return BallArray.exact(exact_integer(number))


def exact_integer(number: int) -> Floats:
    """Return a whole number of a formula as a double, (1,)."""
    if abs(number) > 2**53:
        raise ValueError(f"expected a whole number up to 2^53; got {number}")
    return np.array([float(number)])


def where(condition: Bools, one: BallArray, other: BallArray) -> BallArray:
    """Return balls of one array where a condition holds, of the other elsewhere.

    Parameters
    ----------
    condition
        (n,).
    one, other
        Balls, by shot or one for all shots.
    """
    return BallArray(
        np.where(condition, one.middle, other.middle),
        np.where(condition, one.radius, other.radius),
    )


class PolynomialArray:
    """Polynomials in the time whose coefficients are arrays of balls, lowest power first."""

    __slots__ = ("_coefficients",)

    def __init__(self, coefficients: Sequence[BallArray | int]) -> None:
        self._coefficients = list(coefficients)

    def coeffs(self) -> list[BallArray]:
        """Return the coefficients."""
        return [as_balls(c) for c in self._coefficients]

    def __add__(self, other: PolynomialArray | Factor) -> PolynomialArray:
        own, more = self._coefficients, _coefficients_of(other)
        if len(own) < len(more):
            own, more = more, own
        summed = [_sum(a, b) for a, b in zip(own, more, strict=False)]
        return PolynomialArray(summed + own[len(more) :])

    __radd__ = __add__

    def __neg__(self) -> PolynomialArray:
        return PolynomialArray([-c for c in self._coefficients])

    def __mul__(self, other: PolynomialArray | Factor) -> PolynomialArray:
        own, more = self._coefficients, _coefficients_of(other)
        found: list[BallArray | int] = [0] * (len(own) + len(more) - 1)
        for j, a in enumerate(own):
            for k, b in enumerate(more):
                found[j + k] = _sum(found[j + k], _product(a, b))
        return PolynomialArray(found)

    __rmul__ = __mul__


def _coefficients_of(number: PolynomialArray | Factor) -> list[BallArray | int]:
    if isinstance(number, PolynomialArray):
        return number._coefficients
    return [number if isinstance(number, int) else as_balls(number)]


def _sum(a: BallArray | int, b: BallArray | int) -> BallArray | int:
    if isinstance(a, int) and a == 0:
        return b
    return a if isinstance(b, int) and b == 0 else a + b


def _product(a: BallArray | int, b: BallArray | int) -> BallArray | int:
    for one, other in ((a, b), (b, a)):
        if isinstance(one, int) and one in (0, 1):
            return other if one else 0
    return a * b
