"""A fixed sphere, or the part of one within bounds, touched from outside or from inside."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..symbolic.symbols import POSITION, position
from .contact_bounds import ContactPath, path_about_axis
from .rolling_surface import RollingSurface
from .surface import Point
from .two_sided import Round


@dataclass(frozen=True)
class Sphere(Round):
    """A fixed sphere.

    Attributes
    ----------
    centre
        The centre of the sphere.
    radius
        Distance from there to the ball's centre at a contact: the sum of the radii of sphere and
        ball, or, from inside, their difference.
    """

    centre: Point
    radius: sp.Expr

    @property
    def _offset(self) -> sp.Matrix:
        return position - sp.Matrix(self.centre)

    @property
    def _rho(self) -> sp.Expr:
        return sp.sqrt(sum(component**2 for component in self._offset))

    @property
    def shape(self) -> sp.Expr:
        """x² + y² + z² - r², or the negative of that from inside."""
        return sp.Add(*(self._side * c**2 for c in POSITION), -self._side * self.radius**2)

    @property
    def half_sizes(self) -> tuple[sp.Expr | None, ...]:
        """The radius along every axis."""
        return (self.radius,) * 3

    @property
    def enclosed(self) -> bool:
        """True if the ball is outside."""
        return not self.inward

    @property
    def normal(self) -> sp.Matrix:
        """The radial direction; |p - c| = r at a contact."""
        return self._offset * (self._side / self.radius)

    @property
    def contact_path(self) -> ContactPath | None:
        """The normal is linear in the centre."""
        if self.contact_bounds is None:
            return None
        radius, zero = self.contact_bounds.ball_radius, sp.Integer(0)
        place = self.nearest_point(radius)
        return path_about_axis(place, radius, 1 / self.radius, zero, zero)

    @property
    def rolling_surface(self) -> RollingSurface | None:
        """The tube about its centre."""
        one = sp.Integer(1)
        return RollingSurface((one, one, one), self._side / self.radius)
