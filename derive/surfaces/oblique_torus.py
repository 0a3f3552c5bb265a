"""A torus about any direction, whose components are parameters, or the part within bounds."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..symbolic.conditionals import barrier
from ..symbolic.symbols import POSITION
from .about_axis import AboutAxis
from .directions import per_length, squared_distance, squared_length
from .rolling_surface import RollingSurface, toroidal
from .torus import Toroidal


@dataclass(frozen=True)
class ObliqueTorus(AboutAxis, Toroidal):
    """A torus whose axis has any direction.

    With d from the centre of the torus to the ball's centre and the vector u along its axis, of
    length 1 or not, the ball touches where |u|² (d² + R² - r²)² = 4 R² |d × u|².
    """

    @property
    def distance(self) -> sp.Expr:
        """sqrt((rho - R)² + h²) - r, with h along the axis."""
        depth = barrier(self._rho - self.ring_radius)
        return sp.sqrt(barrier(depth**2 + self._height**2)) - self.reach

    @property
    def shape(self) -> sp.Expr:
        """|u|² (x² + y² + z² + R² - r²)² - 4 R² |d × u|²."""
        squared = sp.Add(*(c**2 for c in POSITION), self.ring_radius**2 - self.reach**2)
        wide = squared_distance(self.direction, POSITION)
        return squared_length(self.direction) * squared**2 - 4 * self.ring_radius**2 * wide

    @property
    def half_sizes(self) -> tuple[sp.Expr | None, ...]:
        """R + r along every axis."""
        return (self.ring_radius + self.reach,) * 3

    @property
    def normal(self) -> sp.Matrix:
        """The direction from the nearest point of the tube's centre circle."""
        per_reach, rho = barrier(1 / self.reach), barrier(self._rho)
        outward = barrier(barrier(rho - self.ring_radius) * per_reach * barrier(1 / rho))
        up = barrier(barrier(self._height * per_length(self.direction)) * per_reach)
        parts = zip(self._across, self.direction, strict=True)
        return sp.Matrix([c * outward + u * up for c, u in parts])

    @property
    def max_concavity(self) -> sp.Expr:
        """The rate at which the distance from the axis bends, 1/rho: as of `Torus`."""
        return 1 / self._rho

    @property
    def rolling_surface(self) -> RollingSurface:
        """The torus of the ball's centre."""
        return toroidal(self._axis, self._across, self._rho, self.ring_radius, self.reach)
