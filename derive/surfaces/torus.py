"""A torus anywhere, with any axis, or the part of one within bounds."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..symbolic.conditionals import barrier
from ..symbolic.symbols import POSITION
from .bounds import as_length
from .cylinder import check_direction, perpendicular_part
from .directions import Direction
from .ring import Ring
from .rolling_surface import RollingSurface, toroidal
from .surface import Point, Surface, overlap, translated


@dataclass(frozen=True)
class Toroidal(Surface):
    """A torus about any axis, touched from outside its tube.

    Attributes
    ----------
    centre
        The centre of the torus.
    direction
        A vector along its axis, of length 1 or about.
    ring_radius
        R, radius of the tube's centre circle.
    reach
        r, the sum of the radii of ball and tube. If that is more than R, `contact_limits` must
        exclude the part about the axis: no ball can touch it.
    limits
        The bounds (Eq. 2).
    contact_limits
        More bounds, of contacts alone: a ball past them may overlap the tube all the same.
    """

    centre: Point
    direction: Direction
    ring_radius: sp.Expr
    reach: sp.Expr
    limits: tuple[sp.Expr, ...] = ()
    contact_limits: tuple[sp.Expr, ...] = ()

    @property
    def bounds(self) -> tuple[sp.Expr, ...]:
        """The bounds as lengths."""
        return (*map(as_length, (*self.limits, *self.contact_limits)), *self.cuts)

    @property
    def reference_point(self) -> Point:
        """The centre."""
        return self.centre

    @property
    def enclosed(self) -> bool:
        """True: a torus is bounded."""
        return True

    @property
    def condition(self) -> sp.Expr:
        """The shape, seen from the origin."""
        return translated(self.shape, self.centre)

    @property
    def curvature(self) -> sp.Expr:
        """A bound on 1/r around the tube and |rho - R|/(rho r) along it: 1/rho + 1/r."""
        return self.max_concavity + 1 / self.reach

    @property
    def inside(self) -> tuple[sp.Expr, ...]:
        """The distance, and the bounds."""
        return overlap(self.distance, (*map(as_length, self.limits), *self.cuts), None)


@dataclass(frozen=True)
class Torus(Toroidal):
    """A torus whose axis has a direction of rational numbers, of length 1."""

    def __post_init__(self) -> None:
        check_direction(self.name, self.direction)

    @property
    def _along(self) -> sp.Expr:
        """The component of (x, y, z) along the axis."""
        return sp.Add(*(u * c for u, c in zip(self.direction, POSITION, strict=True)))

    @property
    def _across(self) -> sp.Matrix:
        return perpendicular_part(sp.Matrix(self.direction))

    @property
    def _rho(self) -> sp.Expr:
        """The distance from the axis."""
        return sp.sqrt(sp.Add(*(component**2 for component in self._across)))

    @property
    def distance(self) -> sp.Expr:
        """sqrt((rho - R)² + h²) - r, with h along the axis."""
        depth = barrier(self._rho - self.ring_radius)
        return translated(sp.sqrt(depth**2 + self._along**2) - self.reach, self.centre)

    @property
    def shape(self) -> sp.Expr:
        """(x² + y² + z² + R² - r²)² - 4 R² rho²."""
        squared = sp.Add(*(c**2 for c in POSITION), self.ring_radius**2 - self.reach**2)
        wide = sp.Add(*(component**2 for component in self._across))
        return squared**2 - 4 * self.ring_radius**2 * wide

    @property
    def half_sizes(self) -> tuple[sp.Expr | None, ...]:
        """R + r across the axis, r along it; R + r throughout if the axis is oblique."""
        widest = self.ring_radius + self.reach
        return tuple(self.reach if abs(u) == 1 else widest for u in self.direction)

    @property
    def normal(self) -> sp.Matrix:
        """The direction from the nearest point of the tube's centre circle."""
        per_reach, rho = barrier(1 / self.reach), barrier(self._rho)
        outward = barrier(barrier(rho - self.ring_radius) * per_reach * barrier(1 / rho))
        along = self._along * per_reach
        parts = zip(self._across, self.direction, strict=True)
        return sp.Matrix([translated(c * outward + u * along, self.centre) for c, u in parts])

    @property
    def max_concavity(self) -> sp.Expr:
        """The rate at which the distance from the axis bends, 1/rho.

        The distance D from the tube's centre circle is a convex function of rho and h, which falls
        at most by the rise of rho. Along a straight line with the speed v, from the distance rho
        from the axis on, rho(t) <= rho + rho' t + v² t²/(2 rho), however far it goes.
        """
        return translated(1 / self._rho, self.centre)

    @property
    def rolling_surface(self) -> RollingSurface:
        """The torus of the ball's centre."""
        across = [barrier(translated(part, self.centre)) for part in self._across]
        axis = [sp.sympify(u) for u in self.direction]
        rho = translated(self._rho, self.centre)
        return toroidal(axis, across, rho, self.ring_radius, self.reach)


def torus(
    name: str,
    centre: Point,
    direction: Direction,
    ring_radius: sp.Expr,
    reach: sp.Expr,
) -> Surface:
    """Return a torus; about the origin and the z axis it is a `Ring`, whose search is faster.

    Parameters
    ----------
    name
        The name of the surface.
    centre
        Its centre, (3,), m.
    direction
        The unit vector along its axis; its components are rational numbers.
    ring_radius
        The radius of the wire's centre circle, m.
    reach
        The radius of the wire and of the ball together, m.
    """
    if all(sp.sympify(c) == 0 for c in (*centre, *direction[:2])):
        return Ring(name, ring_radius, reach)
    return Torus(name, centre, direction, ring_radius, reach)
