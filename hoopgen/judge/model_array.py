"""Numbers with errors of common causes, on arrays: affine arithmetic in double-double.

A model is a sum of two doubles h + l, |l| <= u |h|, slopes s_1 ... s_9, and a radius r. With what
is unknown of a state as e in [-1, 1]^9, the same e for all models of a shot, it stands for a number

    x(e) = h + l + s_1 e_1 + ... + s_9 e_9 + δ,    |δ| <= r.

So errors that have one cause still cancel, where a ball adds their sizes. Midpoints have some 106
bits; slopes are those of errors, and doubles suffice for them. Below, S is the sum of |s_k|.

**Lemma (operations).** If x(e) and y(e) are of the models a and b for some e, then x + y, x y, x/y
and sqrt(x) are of the models that `+`, `*`, `/` and `sqrt` return, for the same e, unless a radius
is infinite or no number.

*Midpoint of a sum.* Knuth's sum gives ha + hb = p + q exactly. With t = fl(la + lb) and
m = fl(q + t), Knuth's sum of p and m is the new h + l, exactly. Only t and m are rounded, by at
most u |t| and u |m|.

*Midpoint of a product.* Dekker's product gives ha hb = p + q exactly. With f = fl(ha lb),
g = fl(la hb), t = fl(f + g) and m = fl(q + t), the midpoint is p + m. The roundings of f, g, t
and m are at most u times their sizes, and la lb, which is left out, is at most u |ha lb|: together
u (2 |f| + |g| + |t| + |m|) <= u (3 (|f| + |g|) + |m|) to first order.

*Slopes.* Those of a sum are fl(sa + sb), with roundings u |s|. Those of a product are
fl(fl(ha sb) + fl(hb sa)): two products and a sum have roundings of at most 2 u (|ha| |sb| + |hb|
|sa|) to first order, and l in place of h + l another u: together 3 u (|ha| Sb + |hb| Sa), for which
`SLOPE` = 4 u stands. Exactly, with x = ca + sa e + δa, the product has the further terms (sa e)(sb
e), at most Sa Sb, and δa y + δb (ca + sa e), at most ra (|cb| + Sb + rb) + rb (|ca| + Sa).

*Quotient and root.* For any model q and y ≠ 0, |x/y - q(e)| = |x - q(e) y|/|y|; for any model s
with s(e) > 0, and x >= 0, |sqrt(x) - s(e)| = |x - s(e)²|/(sqrt(x) + s(e)) <= |x - s(e)²|/s(e). The
models a - q b and a - s s hold the numerators, whatever q and s are; so bounds on these, over the
least size of the divisor, are radii.

Radii, underflow and overflow are as in `ball_array.py`: at most 32 operations on numbers that are
not negative, sums of nine slopes included, are too small by less than a factor 1 + 2^-47, and
`OUTWARDS` also covers terms of higher order in u, |l| <= u |h| among them. ∎
"""

from __future__ import annotations

from functools import lru_cache
from typing import TypeAlias

import numpy as np
from flint import fmpq

from .ball_array import OUTWARDS, TINY, UNIT, BallArray, Floats, Rows, exact_integer

Factor: TypeAlias = "ModelArray | int | fmpq"

SLOPES = 9
SLOPE = 4 * UNIT
_SPLITTER = 2.0**27 + 1
_NONE = np.zeros(1)


def exact_sum(a: Floats, b: Floats) -> tuple[Floats, Floats]:
    """Return the rounded sum of two arrays of doubles and its error (Knuth), exactly.

    Parameters
    ----------
    a, b
        In any relation of their sizes.
    """
    s = a + b
    c = s - a
    return s, (a - (s - c)) + (b - c)


def _halves(a: Floats) -> tuple[Floats, Floats]:
    """Return two numbers of at most 26 bits that sum to a double (Veltkamp), exactly."""
    c = a * _SPLITTER
    high = c - (c - a)
    return high, a - high


class ModelArray:
    """An array of models; the lemma above says what its operations hold.

    Attributes
    ----------
    high, low, radius
        float64, (n,) each, or (1,): one number for all shots.
    slopes
        (9, n), or None where all are zero.
    """

    __slots__ = ("_parts", "_spread", "high", "low", "radius", "slopes")

    def __init__(self, high: Floats, low: Floats, radius: Floats, slopes: Floats | None) -> None:
        self.high, self.low, self.radius, self.slopes = high, low, radius, slopes
        self._parts: tuple[Floats, Floats] | None = None
        self._spread: Floats | None = None

    @classmethod
    def exact(cls, values: Floats) -> ModelArray:
        """Return doubles as models without errors."""
        return cls(values, np.zeros_like(values), np.zeros_like(values), None)

    @classmethod
    def of_balls(cls, balls: BallArray) -> ModelArray:
        """Return balls as models without slopes."""
        return cls(balls.middle, np.zeros_like(balls.middle), balls.radius, None)

    def midpoint(self) -> ModelArray:
        """Return the midpoints as numbers without errors."""
        return ModelArray(self.high, self.low, np.zeros_like(self.high), None)

    def __getitem__(self, rows: Rows) -> ModelArray:
        slopes = None if self.slopes is None else self.slopes[:, rows]
        return ModelArray(self.high[rows], self.low[rows], self.radius[rows], slopes)

    def parts(self) -> tuple[Floats, Floats]:
        """Return the halves of `high`, computed once."""
        if self._parts is None:
            self._parts = _halves(self.high)
        return self._parts

    @property
    def spread(self) -> Floats:
        """S, the sum of the slopes' sizes, computed once."""
        if self._spread is None:
            slopes = self.slopes
            self._spread = _NONE if slopes is None else np.abs(slopes).sum(axis=0)
        return self._spread

    def size(self) -> Floats:
        """Return upper bounds on the sizes of the numbers."""
        return np.asarray((np.abs(self.high) + self.spread + self.radius) * OUTWARDS)

    def balls(self) -> BallArray:
        """Return balls of doubles that hold the numbers."""
        return BallArray(self.high, self.away())

    def away(self) -> Floats:
        """Return bounds on the distances of the numbers from `high`, the nearest doubles."""
        return np.asarray((np.abs(self.low) + self.errors()) * OUTWARDS)

    def errors(self) -> Floats:
        """Return bounds on the distances from the midpoints."""
        return np.asarray((self.spread + self.radius) * OUTWARDS)

    def put(self, rows: Rows, other: ModelArray) -> None:
        """Write models in place of some.

        Parameters
        ----------
        rows
            The places.
        other
            As many models, or one for all places.
        """
        for own, more in zip(self.arrays(), other.arrays(), strict=True):
            own[rows] = more
        if self.slopes is None and other.slopes is not None:
            self.slopes = np.zeros((SLOPES, len(self.high)))
        if self.slopes is not None:
            self.slopes[:, rows] = 0.0 if other.slopes is None else other.slopes
        self._parts = self._spread = None

    def arrays(self) -> tuple[Floats, Floats, Floats]:
        """Return high, low and radius."""
        return self.high, self.low, self.radius

    def copied(self, shots: int) -> ModelArray:
        """Return models of their own memory, one by shot."""
        high, low, radius = (np.broadcast_to(a, shots).copy() for a in self.arrays())
        slopes = None if self.slopes is None else self.slopes.copy()
        return ModelArray(high, low, radius, slopes)

    # ------------------------------------------------------------------------------- arithmetic

    def __add__(self, other: Factor) -> ModelArray:
        if isinstance(other, int) and other == 0:
            return self
        b = as_models(other)
        p, q = exact_sum(self.high, b.high)
        t = self.low + b.low
        m = q + t
        high, low = exact_sum(p, m)
        radius = self.radius + b.radius + UNIT * (np.abs(t) + np.abs(m))
        if self.slopes is None or b.slopes is None:
            slopes = self.slopes if b.slopes is None else b.slopes
            return _outwards(high, low, radius, slopes)
        radius = radius + SLOPE * (self.spread + b.spread)
        return _outwards(high, low, radius, self.slopes + b.slopes)

    __radd__ = __add__

    def __neg__(self) -> ModelArray:
        slopes = None if self.slopes is None else -self.slopes
        return ModelArray(-self.high, -self.low, self.radius, slopes)

    def __sub__(self, other: Factor) -> ModelArray:
        return self + -as_models(other)

    def __rsub__(self, other: Factor) -> ModelArray:
        return as_models(other) + -self

    def __mul__(self, other: Factor) -> ModelArray:
        if isinstance(other, int) and other in (-1, 0, 1):  # of a plane's normal
            return self if other > 0 else -self if other else as_models(0)
        b = as_models(other)
        (a1, a2), (b1, b2) = self.parts(), b.parts()
        p = self.high * b.high
        q = ((a1 * b1 - p) + a1 * b2 + a2 * b1) + a2 * b2
        f, g = self.high * b.low, self.low * b.high
        m = q + (f + g)
        high, low = exact_sum(p, m)
        size, other_size = np.abs(self.high), np.abs(b.high)
        radius = UNIT * (3 * (np.abs(f) + np.abs(g)) + np.abs(m))
        radius = radius + self.radius * (other_size + b.spread + b.radius)
        radius = radius + b.radius * (size + self.spread)
        slopes = None
        if self.slopes is not None:
            slopes = b.high * self.slopes
            radius = radius + self.spread * (SLOPE * other_size + b.spread)
        if b.slopes is not None:
            more = self.high * b.slopes
            slopes = more if slopes is None else slopes + more
            radius = radius + SLOPE * size * b.spread
        return _outwards(high, low, radius, slopes)

    __rmul__ = __mul__

    def __truediv__(self, other: Factor) -> ModelArray:
        b = as_models(other)
        first = self.high / b.high
        second = (self.midpoint() - b.midpoint() * ModelArray.exact(first)).high / b.high
        slopes = None
        if self.slopes is not None or b.slopes is not None:
            own, less = (0.0 if m.slopes is None else m.slopes for m in (self, b))
            slopes = (own - first * less) / b.high
        quotient = ModelArray(*exact_sum(first, second), np.zeros_like(first), slopes)
        error = (self - quotient * b).size() / b.balls().least_size()
        return _outwards(quotient.high, quotient.low, error, slopes)

    def __rtruediv__(self, other: Factor) -> ModelArray:
        return as_models(other) / self

    def sqrt(self) -> ModelArray:
        """Return the roots of numbers that are not negative, no number where one may be zero."""
        first = np.sqrt(self.high)
        square = ModelArray.exact(first) * ModelArray.exact(first)
        second = (self.midpoint() - square).high / (2 * first)
        slopes = None if self.slopes is None else self.slopes / (2 * first)
        root = ModelArray(*exact_sum(first, second), np.zeros_like(first), slopes)
        error = (self - root * root).size() / root.balls().least_size()
        return _outwards(root.high, root.low, error, slopes)


def _outwards(high: Floats, low: Floats, radius: Floats, slopes: Floats | None) -> ModelArray:
    return ModelArray(high, low, radius * OUTWARDS + TINY, slopes)


def as_models(number: Factor) -> ModelArray:
    """Return a number of a formula as one model for all shots."""
    return number if isinstance(number, ModelArray) else _constant(number)


@lru_cache(maxsize=256)
def _constant(number: int | fmpq) -> ModelArray:
    if isinstance(number, fmpq):
        return _constant(int(number.p)) / _constant(int(number.q))
    return ModelArray.exact(exact_integer(number))
