"""The search for an arc that is turned about an axis: smaller margins of its condition.

With p = d² + a² - r² the condition is F = p² - 4 a² rho² (`surfaces/revolved_arc.py`). In the box
of the surface |p| may be as large as its terms, but where F is zero it is 2 |a| rho. With a bound P
of which 2 |a| rho is less than half in all of the box,

    |p| <= P:   p² is wrong by at most 2 P dp,
    |p| >  P:   F > 3/4 p², and p² is wrong by at most 2 |p| dp < 8/3 (dp/P) F,

for an error dp of p. So the error of F is at most a margin with P in place of the size of p, and a
share of F itself, which is small as P is many times dp.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import sympy as sp

from ..surfaces import RevolvedArc
from ..symbolic.conditionals import barrier, maximum, minimum
from ..symbolic.rounding import Rounded, rounding
from .polynomial import PolynomialRootFinder

LEAST_PER_ERROR = sp.Integer(2**20)
"""Least P, relative to dp."""

SHARE = sp.Rational(1, 2**16)
"""By what share of F a bound of it is lower; errors are less than half of it."""


@dataclass(frozen=True)
class ArcRootFinder(PolynomialRootFinder):
    """The root finder for an arc that is turned about an axis."""

    surface: RevolvedArc

    def _gap_rounding(self, now: Mapping[sp.Expr, Rounded]) -> Rounded:
        """Return size and error of the gap with the size of p near the surface."""
        (part,) = self.surface.small_parts
        whole = rounding(part, now)
        size = self.surface.offset_sign * self.surface.offset
        # In the box rho is at most the root of 2 times |a| + r, and a thousandth more.
        near = barrier(6 * size * barrier(size + self.surface.radius))
        error = barrier(whole.error)
        least = barrier(maximum(near, LEAST_PER_ERROR * error))
        small = Rounded(barrier(minimum(barrier(whole.magnitude), least)), error)
        return rounding(self.surface.shape, {**now, part: small})

    @property
    def error_share(self) -> sp.Expr:
        """By what share of F it may be wrong besides the margin: `SHARE`."""
        return SHARE
