"""An implicit surface: the zero set of a polynomial in x, y, z."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..symbolic.conditionals import IfLess, barrier
from ..symbolic.symbols import POSITION
from .bounds import as_length
from .surface import Surface, overlap


@dataclass(frozen=True)
class ImplicitSurface(Surface):
    """The zero set of a polynomial; the ball's centre is where the polynomial is positive.

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
        """The bounds as lengths."""
        return (*map(as_length, self.limits), *self.cuts)

    @property
    def _gradient(self) -> list[sp.Expr]:
        return [barrier(sp.diff(self.formula, place)) for place in POSITION]

    @property
    def _steepness(self) -> sp.Expr:
        return barrier(sp.sqrt(barrier(sp.Add(*(slope**2 for slope in self._gradient)))))

    @property
    def distance(self) -> sp.Expr:
        """The polynomial over the size of its gradient: a distance to first order, exact at 0."""
        return self.formula / self._steepness

    @property
    def condition(self) -> sp.Expr:
        """The polynomial."""
        return self.formula

    @property
    def normal(self) -> sp.Matrix:
        """The gradient over its size."""
        per = barrier(1 / self._steepness)
        return sp.Matrix([slope * per for slope in self._gradient])

    @property
    def curvature(self) -> sp.Expr:
        """The size of the second derivatives over that of the gradient, at the place itself.

        Infinite if the gradient's size overflows, so that no normal there is trusted.
        """
        bends = (sp.diff(self.formula, a, b) for a in POSITION for b in POSITION)
        bent = barrier(sp.sqrt(sp.Add(*(bend**2 for bend in bends)))) / self._steepness
        return IfLess(self._steepness, sp.oo, bent, sp.oo)

    @property
    def max_concavity(self) -> sp.Expr:
        """Infinite: nothing bounds how it bends, so scenes refuse it beside a rolling ball."""
        return sp.oo

    @property
    def inside(self) -> tuple[sp.Expr, ...]:
        """The polynomial as a length, and the bounds."""
        return overlap(as_length(self.formula), self.bounds, None)
