"""A round cylinder along any direction, whose components are parameters."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..symbolic.conditionals import barrier
from ..symbolic.symbols import POSITION
from .about_axis import AboutAxis
from .directions import Direction, squared_distance, squared_length
from .rolling_surface import RollingSurface
from .surface import Point
from .two_sided import Round


@dataclass(frozen=True)
class ObliqueCylinder(AboutAxis, Round):
    """The side of a cylinder, which ends where its bounds do.

    With d from a point of its axis to the ball's centre and the vector u along the axis, of length
    1 or not, the ball touches where |d × u|² = r² |u|².

    Attributes
    ----------
    centre
        Any point of its axis.
    direction
        A vector along the axis, about of length 1.
    radius
        Distance from the axis to the ball's centre at a contact: the sum of the radii of cylinder
        and ball, or, from inside, their difference.
    """

    centre: Point
    direction: Direction
    radius: sp.Expr

    @property
    def shape(self) -> sp.Expr:
        """|d × u|² - r² |u|², or the negative of that from inside."""
        width = squared_distance(self.direction, POSITION)
        return self._side * width - self._side * self.radius**2 * squared_length(self.direction)

    @property
    def distance_without_bounds(self) -> sp.Expr | None:
        """The distance: the body has no box along the axes of the scene."""
        return self.distance

    @property
    def normal(self) -> sp.Matrix:
        """The direction from the axis; the distance from it is r at a contact."""
        per_radius = barrier(self._side / self.radius)
        return sp.Matrix([c * per_radius for c in self._across])

    @property
    def rolling_surface(self) -> RollingSurface | None:
        """The tube about its axis: the projection is 1 - u uᵀ/|u|²."""
        unit = self._axis
        across = [
            [sp.Integer(i == j) - barrier(a * b) for j, b in enumerate(unit)]
            for i, a in enumerate(unit)
        ]
        return RollingSurface(None, self._side / self.radius, across=across)
