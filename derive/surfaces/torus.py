"""A torus anywhere, with any axis, or the part of one within bounds."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..ground.choice import hold
from ..ground.symbols import POSITION
from .bounds import length
from .cylinder import across, check_direction
from .ring import Ring
from .surface import Point, Surface, moved, overlap


@dataclass(frozen=True)
class Torus(Surface):
    """A torus, touched from outside its tube.

    Attributes
    ----------
    centre
        Of the torus.
    direction
        Of its axis: a unit vector of rational numbers.
    ring_radius
        R, radius of the tube's centre circle.
    reach
        r, radii of ball and tube together. Where that is more than R, the parts about the axis
        must be out of bounds: no ball can touch them.
    limits
        The bounds (Eq. 2).
    """

    centre: Point
    direction: tuple[sp.Rational | int, ...]
    ring_radius: sp.Expr
    reach: sp.Expr
    limits: tuple[sp.Expr, ...] = ()

    def __post_init__(self) -> None:
        check_direction(self.name, self.direction)

    @property
    def bounds(self) -> tuple[sp.Expr, ...]:
        """The bounds of the part."""
        return tuple(map(length, self.limits))

    @property
    def _along(self) -> sp.Expr:
        """What x, y, z have along the axis."""
        return sp.Add(*(u * c for u, c in zip(self.direction, POSITION, strict=True)))

    @property
    def _across(self) -> sp.Matrix:
        return across(sp.Matrix(self.direction))

    @property
    def _rho(self) -> sp.Expr:
        """Distance from the axis."""
        return sp.sqrt(sp.Add(*(component**2 for component in self._across)))

    @property
    def distance(self) -> sp.Expr:
        """sqrt((rho - R)² + h²) - r, with h along the axis."""
        depth = hold(self._rho - self.ring_radius)
        return moved(sp.sqrt(depth**2 + self._along**2) - self.reach, self.centre)

    @property
    def about(self) -> Point:
        """Its centre."""
        return self.centre

    @property
    def shape(self) -> sp.Expr:
        """(x² + y² + z² + R² - r²)² - 4 R² rho²."""
        squared = sp.Add(*(c**2 for c in POSITION), self.ring_radius**2 - self.reach**2)
        wide = sp.Add(*(component**2 for component in self._across))
        return squared**2 - 4 * self.ring_radius**2 * wide

    @property
    def halves(self) -> tuple[sp.Expr | None, ...]:
        """R + r across the axis, r along it; R + r throughout if it is oblique."""
        widest = self.ring_radius + self.reach
        return tuple(self.reach if abs(u) == 1 else widest for u in self.direction)

    @property
    def enclosed(self) -> bool:
        """It is."""
        return True

    @property
    def condition(self) -> sp.Expr:
        """The shape about its place: free of roots."""
        return moved(self.shape, self.centre)

    @property
    def normal(self) -> sp.Matrix:
        """From the nearest point of the tube's centre circle, over r."""
        per_reach, rho = hold(1 / self.reach), hold(self._rho)
        outward = hold(hold(rho - self.ring_radius) * per_reach * hold(1 / rho))
        along = self._along * per_reach
        parts = zip(self._across, self.direction, strict=True)
        return sp.Matrix([moved(c * outward + u * along, self.centre) for c, u in parts])

    @property
    def curvature(self) -> sp.Expr:
        """1/r around the tube; along it, |rho - R|/(rho r), at most 1/rho + 1/r anywhere."""
        return moved(1 / self._rho, self.centre) + 1 / self.reach

    @property
    def inside(self) -> tuple[sp.Expr, ...]:
        """Nearer to the centre circle than touching, and within the bounds."""
        return overlap(self.distance, self.limits, None)


def torus(
    name: str,
    centre: Point,
    direction: tuple[sp.Rational | int, ...],
    ring_radius: sp.Expr,
    reach: sp.Expr,
    limits: tuple[sp.Expr, ...] = (),
) -> Surface:
    """Return a torus; one about the origin and the z axis is a `Ring`, whose search is quicker."""
    plain = not limits and all(sp.sympify(c) == 0 for c in (*centre, *direction[:2]))
    if plain:
        return Ring(name, ring_radius, reach)
    return Torus(name, centre, direction, ring_radius, reach, limits)
