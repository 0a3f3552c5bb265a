"""A fixed sphere, or the part of one within bounds, touched from outside or from inside."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..ground.symbols import POSITION, position
from .bounds import length
from .surface import Point, Surface, moved, overlap
from .tube import Tube


@dataclass(frozen=True)
class Sphere(Surface):
    """A fixed sphere.

    Attributes
    ----------
    centre
        Of the sphere.
    radius
        From there to the ball's centre at a contact: the sphere's own radius and the ball's
        together, or, from inside, the one less the other.
    limits
        The bounds (Eq. 2).
    inward
        Whether the ball touches it from inside.
    reach
        Of a thin shell: the ball's radius. Without, all beyond the surface is body.
    """

    centre: Point
    radius: sp.Expr
    limits: tuple[sp.Expr, ...] = ()
    inward: bool = False
    reach: sp.Expr | None = None

    @property
    def bounds(self) -> tuple[sp.Expr, ...]:
        """The bounds of the part."""
        return tuple(map(length, self.limits))

    @property
    def _side(self) -> int:
        return -1 if self.inward else 1

    @property
    def _offset(self) -> sp.Matrix:
        return position - sp.Matrix(self.centre)

    @property
    def distance(self) -> sp.Expr:
        """|p - c| - r, from inside r - |p - c|."""
        away = sp.sqrt(sum(component**2 for component in self._offset))
        return self._side * away - self._side * self.radius

    @property
    def about(self) -> Point:
        """Its centre."""
        return self.centre

    @property
    def shape(self) -> sp.Expr:
        """x² + y² + z² - r², from inside r² - x² - y² - z²."""
        return sp.Add(*(self._side * c**2 for c in POSITION), -self._side * self.radius**2)

    @property
    def halves(self) -> tuple[sp.Expr | None, ...]:
        """The radius."""
        return (self.radius,) * 3

    @property
    def enclosed(self) -> bool:
        """If the ball is outside."""
        return not self.inward

    @property
    def condition(self) -> sp.Expr:
        """|p - c|² - r², free of the root, or the same with the other sign."""
        return moved(self.shape, self.centre)

    @property
    def normal(self) -> sp.Matrix:
        """Radial; |p - c| = r at a contact."""
        return self._offset * (self._side / self.radius)

    @property
    def curvature(self) -> sp.Expr:
        """1/r."""
        return 1 / self.radius

    @property
    def tube(self) -> Tube | None:
        """About its centre, if it has no bounds."""
        one = sp.Integer(1)
        return None if self.limits else Tube((one, one, one), self._side / self.radius)

    @property
    def dent(self) -> sp.Expr:
        """None outside; inside, 1/|p - c|, for half of it or more."""
        if not self.inward:
            return sp.Integer(0)
        return 2 / sp.sqrt(sum(component**2 for component in self._offset))

    @property
    def inside(self) -> tuple[sp.Expr, ...]:
        """Nearer than touching, and within the bounds."""
        return overlap(self.distance, self.limits, self.reach)
