"""A fixed sphere, or the part of one within bounds, touched from outside."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..ground.symbols import position
from .surface import Surface


@dataclass(frozen=True)
class Sphere(Surface):
    """A fixed sphere.

    Attributes
    ----------
    centre
        Of the sphere.
    radius
        Its own radius and the ball's together.
    limits
        The bounds (Eq. 2): lengths whose gradient is at most 1.
    """

    centre: tuple[sp.Expr, sp.Expr, sp.Expr]
    radius: sp.Expr
    limits: tuple[sp.Expr, ...] = ()

    @property
    def bounds(self) -> tuple[sp.Expr, ...]:
        """The bounds of the part."""
        return self.limits

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
        """Nearer than touching, and within the bounds."""
        return (self.distance, *self.limits)
