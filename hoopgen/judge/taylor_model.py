"""Taylor models of order one: functions of a box's variables with an enclosed linear part.

A model stands for a function f of e in [-1, 1]^n, a number or a polynomial in the time. It holds
balls c and s_1 ... s_n such that for every e

    f(e) = c + s_1 e_1 + ... + s_n e_n    for some numbers in these balls,

and a ball that holds all values of f by plain ball arithmetic. Each operation keeps both promises:
what is not linear goes into c as a ball, by Taylor's theorem with Lagrange's remainder (Makino and
Berz, Int. J. Pure Appl. Math. 4, 2003; Moore, Kearfott and Cloud, Introduction to Interval
Analysis, 2009, ch. 6), and ball arithmetic counts every rounding. Models take the place of balls in
the compiled formulas and in the judge's code.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from itertools import zip_longest
from typing import Any, TypeAlias

from flint import arb, arb_poly

Ring: TypeAlias = Any
"""Either arb or arb_poly, which have the same operators."""

Number: TypeAlias = Any
"""A number of the judge: an arb or a `TaylorModel`, which have the same operators."""


class TaylorModel:
    """A function of the variables of a box, enclosed as a ball plus a linear part.

    Attributes
    ----------
    centre
        The ball c, or a polynomial of balls.
    slopes
        The balls or polynomials s_1 ... s_n; those left out are 0.
    plain
        Enclosure of all values by plain ball arithmetic.
    """

    def __init__(self, centre: Ring, slopes: Sequence[Ring] = (), plain: Ring = None) -> None:
        if isinstance(centre, arb_poly):
            slopes = [s if isinstance(s, arb_poly) else arb_poly([s]) for s in slopes]
        self.centre = centre
        self.slopes = tuple(slopes)
        if plain is None:
            plain = centre + _around_zero(_size(self.slopes))
        elif self.slopes and not _is_finite(self):
            self.centre, self.slopes = plain, ()
        self.plain = plain

    @classmethod
    def variable(cls, low: arb, high: arb, index: int) -> TaylorModel:
        """Return the model of a variable of a box.

        Parameters
        ----------
        low, high
            The ends of its interval.
        index
            The number of the variable in the box.
        """
        whole = low.union(high)
        slopes = [arb(0)] * index + [whole.rad()]
        return cls(whole.mid(), slopes, whole)

    @classmethod
    def polynomial(cls, coefficients: Sequence[Number]) -> TaylorModel:
        """Return the polynomial with the given coefficients, lowest power first."""
        models = [as_model(coefficient) for coefficient in coefficients]
        slopes = zip_longest(*(model.slopes for model in models), fillvalue=arb(0))
        return cls(
            arb_poly([model.centre for model in models]),
            [arb_poly(list(row)) for row in slopes],
            arb_poly([model.range for model in models]),
        )

    @cached_property
    def deviation(self) -> Ring:
        """An upper bound on the size of the linear part, by coefficient."""
        return _size(self.slopes)

    @cached_property
    def range(self) -> Ring:
        """An enclosure of all values, by coefficient: that of both promises at once."""
        linear = self.centre + _around_zero(self.deviation)
        if isinstance(linear, arb):
            return _common(linear, self.plain)
        pairs = zip_longest(linear.coeffs(), self.plain.coeffs(), fillvalue=arb(0))
        return arb_poly([_common(one, other) for one, other in pairs])

    def __add__(self, other: Any) -> TaylorModel:
        if not isinstance(other, TaylorModel):
            return TaylorModel(self.centre + other, self.slopes, self.range + other)
        slopes = _sums(self.slopes, other.slopes)
        return TaylorModel(self.centre + other.centre, slopes, self.range + other.range)

    __radd__ = __add__

    def __neg__(self) -> TaylorModel:
        return TaylorModel(-self.centre, [-slope for slope in self.slopes], -self.range)

    def __sub__(self, other: Any) -> TaylorModel:
        return self.__add__(-other)

    def __rsub__(self, other: Any) -> TaylorModel:
        return (-self).__add__(other)

    def __mul__(self, other: Any) -> TaylorModel:
        if not isinstance(other, TaylorModel):
            slopes = [slope * other for slope in self.slopes]
            return TaylorModel(self.centre * other, slopes, self.range * other)
        centre = self.centre * other.centre
        if self is other:
            # The square of the linear part is not negative.
            square = self.deviation * self.deviation
            if isinstance(square, arb):
                half = square / 2
                slopes = [2 * self.centre * slope for slope in self.slopes]
                plain = self.range * self.range
                return TaylorModel(centre + half + _around_zero(half), slopes, plain)
        remainder = _around_zero(self.deviation * other.deviation)
        slopes = _sums(
            [other.centre * slope for slope in self.slopes],
            [self.centre * slope for slope in other.slopes],
        )
        return TaylorModel(centre + remainder, slopes, self.range * other.range)

    __rmul__ = __mul__

    def __truediv__(self, other: Any) -> TaylorModel:
        if isinstance(other, TaylorModel):
            return self * other.inverse()
        return self * (1 / arb(other))

    def __rtruediv__(self, other: Any) -> TaylorModel:
        return self.inverse().__mul__(other)

    def __abs__(self) -> TaylorModel:
        if self.range >= 0:
            return self
        return -self if self.range <= 0 else TaylorModel(abs(self.range))

    def inverse(self) -> TaylorModel:
        """Return 1/f, not finite where f may be 0."""
        middle, where = self._places()
        curvature = 1 / (where * where * where)
        return self._smooth(1 / middle, -1 / (middle * middle), curvature, 1 / self.range)

    def sqrt(self) -> TaylorModel:
        """Return the square root, not finite where f may be negative."""
        middle, where = self._places()
        root = middle.sqrt()
        return self._smooth(
            root, 1 / (2 * root), -1 / (8 * where * where.sqrt()), self.range.sqrt()
        )

    def sin(self) -> TaylorModel:
        """Return the sine."""
        middle, where = self._places()
        return self._smooth(middle.sin(), middle.cos(), -where.sin() / 2, self.range.sin())

    def cos(self) -> TaylorModel:
        """Return the cosine."""
        middle, where = self._places()
        return self._smooth(middle.cos(), -middle.sin(), -where.cos() / 2, self.range.cos())

    def _places(self) -> tuple[arb, arb]:
        """Return the point of expansion, and a ball that holds it and all values."""
        middle = self.centre.mid()
        return middle, self.range.union(middle)

    def _smooth(self, value: arb, slope: arb, half_curvature: arb, plain: arb) -> TaylorModel:
        """Return g(f): Taylor's theorem about the middle of the centre, with its remainder.

        Parameters
        ----------
        value, slope
            Of g at the point of expansion.
        half_curvature
            Of g over all values and the point of expansion.
        plain
            Enclosure of all values.
        """
        offset = self.centre - self.centre.mid()
        away = offset.abs_upper() + self.deviation
        remainder = half_curvature * arb(0).union(away * away)
        slopes = [slope * s for s in self.slopes]
        return TaylorModel(value + slope * offset + remainder, slopes, plain)

    def hull(self, other: Number) -> TaylorModel:
        """Return a model of every function that is this or another one at each point.

        Parameters
        ----------
        other
            The other one.
        """
        mean, half = (self + other) / 2, (self - other) / 2
        plain = self.range.union(ball(other))
        return TaylorModel(mean.centre + _around_zero(half.abs_upper()), mean.slopes, plain)

    # Polynomials in the time.

    def coeffs(self) -> list[TaylorModel]:
        """Return the coefficients of a polynomial, lowest power first."""
        rows = [self.centre.coeffs(), *(slope.coeffs() for slope in self.slopes)]
        columns = list(zip_longest(*rows, fillvalue=arb(0)))
        ranges = self.range.coeffs()
        columns += [(arb(0),)] * (len(ranges) - len(columns))
        ranges += [arb(0)] * (len(columns) - len(ranges))
        return [TaylorModel(c[0], c[1:], r) for c, r in zip(columns, ranges, strict=True)]

    def derivative(self) -> TaylorModel:
        """Return the derivative of a polynomial by the time."""
        slopes = [slope.derivative() for slope in self.slopes]
        return TaylorModel(self.centre.derivative(), slopes, self.range.derivative())

    def __call__(self, time: Any) -> TaylorModel:
        """Return a polynomial at a time, a ball or a model, or of another polynomial of balls."""
        if not isinstance(time, TaylorModel):
            slopes = [slope(time) for slope in self.slopes]
            return TaylorModel(self.centre(time), slopes, self.range(time))
        middle = time.mid()
        since, value = time - middle, TaylorModel(arb(0))
        for coefficient in reversed(self(arb_poly([middle, 1])).coeffs()):
            value = value * since + coefficient
        return TaylorModel(value.centre, value.slopes, _common(value.plain, self.range(time.range)))

    # Decisions: true only where they hold at every point of the box.

    def __lt__(self, other: Any) -> bool:
        return bool(self.range < ball(other)) or self._differs(other, lambda d: d < 0)

    def __le__(self, other: Any) -> bool:
        return bool(self.range <= ball(other)) or self._differs(other, lambda d: d <= 0)

    def __gt__(self, other: Any) -> bool:
        return bool(self.range > ball(other)) or self._differs(other, lambda d: d > 0)

    def __ge__(self, other: Any) -> bool:
        return bool(self.range >= ball(other)) or self._differs(other, lambda d: d >= 0)

    def _differs(self, other: Any, holds: Any) -> bool:
        return isinstance(other, TaylorModel) and bool(holds((self - other).range))

    def is_zero(self) -> bool:
        """Return whether every value is exactly 0."""
        return bool(self.range.is_zero())

    def is_nan(self) -> bool:
        """Return whether nothing is known of the values."""
        return bool(self.range.is_nan())

    def is_finite(self) -> bool:
        """Return whether all values are bounded."""
        return bool(self.range.is_finite())

    def mid(self) -> Ring:
        """Return the middle of the centre."""
        return self.centre.mid()

    def lower(self) -> Ring:
        """Return a lower bound on all values."""
        return self.range.lower()

    def upper(self) -> Ring:
        """Return an upper bound on all values."""
        return self.range.upper()

    def abs_lower(self) -> Ring:
        """Return a lower bound on the size of all values."""
        return self.range.abs_lower()

    def abs_upper(self) -> Ring:
        """Return an upper bound on the size of all values."""
        return self.range.abs_upper()


def as_model(number: Any) -> TaylorModel:
    """Return a number as a model; a ball is one without a linear part."""
    return number if isinstance(number, TaylorModel) else TaylorModel(number)


def ball(number: Any) -> Any:
    """Return an enclosure of all values of a number; of a ball, itself."""
    return number.range if isinstance(number, TaylorModel) else number


def polynomial(coefficients: Sequence[Number]) -> Any:
    """Return the polynomial of balls or models with the given coefficients."""
    if any(isinstance(coefficient, TaylorModel) for coefficient in coefficients):
        return TaylorModel.polynomial(coefficients)
    return arb_poly(list(coefficients))


def _size(slopes: Sequence[Ring]) -> Ring:
    """Return an upper bound on the size of a sum of slopes, each times a number in [-1, 1]."""
    if slopes and isinstance(slopes[0], arb_poly):
        rows = zip_longest(*(slope.coeffs() for slope in slopes), fillvalue=arb(0))
        return arb_poly([_size(row) for row in rows])
    return sum((slope.abs_upper() for slope in slopes), arb(0))


def _around_zero(size: Ring) -> Ring:
    """Return balls about zero with the given radii, by coefficient."""
    if isinstance(size, arb_poly):
        return arb_poly([arb(0, radius.abs_upper()) for radius in size.coeffs()])
    return arb(0, size.abs_upper())


def _sums(left: Sequence[Ring], right: Sequence[Ring]) -> list[Ring]:
    longer, shorter = (left, right) if len(left) >= len(right) else (right, left)
    return [a + b for a, b in zip(longer, shorter, strict=False)] + list(longer[len(shorter) :])


def _common(one: arb, other: arb) -> arb:
    """Return the intersection of two enclosures of the same numbers."""
    if not one.is_finite():
        return other
    return one.intersection(other) if other.is_finite() else one


def _is_finite(model: TaylorModel) -> bool:
    parts = (model.centre, model.deviation)
    numbers = [
        n for part in parts for n in (part.coeffs() if isinstance(part, arb_poly) else [part])
    ]
    return all(number.is_finite() for number in numbers)
