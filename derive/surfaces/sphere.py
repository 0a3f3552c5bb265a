"""A fixed sphere, touched from outside."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..ground.symbols import position
from .surface import Surface


@dataclass(frozen=True)
class Sphere(Surface):
    """A fixed sphere; `radius` is its own radius and the ball's together."""

    centre: tuple[sp.Expr, sp.Expr, sp.Expr]
    radius: sp.Expr

    @property
    def _offset(self) -> sp.Matrix:
        return position - sp.Matrix(self.centre)

    @property
    def distance(self) -> sp.Expr:
        """|p - c| - r."""
        return sp.sqrt(sum(component**2 for component in self._offset)) - self.radius

    @property
    def condition(self) -> sp.Expr:
        """|p - c|² - r²: free of the root."""
        return sum(component**2 for component in self._offset) - self.radius**2

    @property
    def normal(self) -> sp.Matrix:
        """Radial; |p - c| = r at a contact."""
        return self._offset / self.radius

    @property
    def curvature(self) -> sp.Expr:
        """1/r."""
        return 1 / self.radius

    @property
    def inside(self) -> tuple[sp.Expr, ...]:
        """Nearer than touching."""
        return (self.distance,)
