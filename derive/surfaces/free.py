"""A surface of one's own: where a polynomial in x, y, z is zero."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..ground.choice import IfLess, hold
from ..ground.symbols import POSITION
from .bounds import length
from .surface import Surface, overlap


@dataclass(frozen=True)
class Free(Surface):
    """Where a polynomial is zero; the ball's centre is where it is positive.

    Attributes
    ----------
    formula
        In x, y, z and parameters, for the ball's centre: zero at a contact. Its gradient does not
        vanish there.
    limits
        The bounds (Eq. 2).
    """

    formula: sp.Expr
    limits: tuple[sp.Expr, ...] = ()

    @property
    def bounds(self) -> tuple[sp.Expr, ...]:
        """The bounds of the part."""
        return tuple(map(length, self.limits))

    @property
    def _gradient(self) -> list[sp.Expr]:
        return [hold(sp.diff(self.formula, place)) for place in POSITION]

    @property
    def _steepness(self) -> sp.Expr:
        return hold(sp.sqrt(hold(sp.Add(*(slope**2 for slope in self._gradient)))))

    @property
    def distance(self) -> sp.Expr:
        """F over the size of its gradient: a distance to first order, exact where it is zero."""
        return self.formula / self._steepness

    @property
    def condition(self) -> sp.Expr:
        """The formula."""
        return self.formula

    @property
    def normal(self) -> sp.Matrix:
        """The gradient over its size."""
        per = hold(1 / self._steepness)
        return sp.Matrix([slope * per for slope in self._gradient])

    @property
    def curvature(self) -> sp.Expr:
        """The size of the second derivatives over that of the gradient, at the place itself.

        Infinite where the gradient's size overflows, so that no normal of it is believed.
        """
        bends = (sp.diff(self.formula, a, b) for a in POSITION for b in POSITION)
        bent = hold(sp.sqrt(sp.Add(*(bend**2 for bend in bends)))) / self._steepness
        return IfLess(self._steepness, sp.oo, bent, sp.oo)

    @property
    def inside(self) -> tuple[sp.Expr, ...]:
        """Where the formula is negative, within the bounds."""
        return overlap(length(self.formula), self.limits, None)
