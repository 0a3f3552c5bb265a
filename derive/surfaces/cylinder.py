"""A round cylinder, or the part of one within bounds, touched from outside or from inside."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..ground.symbols import POSITION, position
from .bounds import length
from .surface import Point, Surface, moved, overlap
from .tube import Tube


@dataclass(frozen=True)
class Cylinder(Surface):
    """The side of a cylinder; it ends where its bounds say.

    Attributes
    ----------
    centre
        Of the cylinder: any point of its axis.
    direction
        Of the axis: a unit vector of rational numbers.
    radius
        From the axis to the ball's centre at a contact: the cylinder's own radius and the ball's
        together, or, from inside, the one less the other.
    limits
        The bounds (Eq. 2).
    inward
        Whether the ball touches it from inside.
    reach
        Of a thin shell: the ball's radius. Without, all beyond the surface is body.
    """

    centre: Point
    direction: tuple[sp.Rational | int, ...]
    radius: sp.Expr
    limits: tuple[sp.Expr, ...] = ()
    inward: bool = False
    reach: sp.Expr | None = None

    def __post_init__(self) -> None:
        check_direction(self.name, self.direction)

    @property
    def bounds(self) -> tuple[sp.Expr, ...]:
        """The bounds of the part."""
        return tuple(map(length, self.limits))

    @property
    def _side(self) -> int:
        return -1 if self.inward else 1

    @property
    def _across(self) -> sp.Matrix:
        """What is left of x, y, z across the axis."""
        return across(sp.Matrix(self.direction))

    @property
    def _offset(self) -> sp.Matrix:
        return self._across.applyfunc(lambda component: moved(component, self.centre))

    @property
    def distance(self) -> sp.Expr:
        """The distance from the axis less the radius, from inside the other way round."""
        away = sp.sqrt(sum(component**2 for component in self._offset))
        return self._side * away - self._side * self.radius

    @property
    def about(self) -> Point:
        """A point of its axis."""
        return self.centre

    @property
    def shape(self) -> sp.Expr:
        """The squared distance from the axis less r², or the same with the other sign."""
        return sp.Add(*(self._side * c**2 for c in self._across), -self._side * self.radius**2)

    @property
    def halves(self) -> tuple[sp.Expr | None, ...]:
        """The radius across the axis, if that is one of the coordinates'."""
        known = 1 in map(abs, self.direction)
        return tuple(self.radius if known and not u else None for u in self.direction)

    @property
    def enclosed(self) -> bool:
        """If the ball is outside."""
        return not self.inward

    @property
    def condition(self) -> sp.Expr:
        """The shape about its place."""
        return moved(self.shape, self.centre)

    @property
    def normal(self) -> sp.Matrix:
        """From the axis; the distance is r at a contact."""
        return self._offset * (self._side / self.radius)

    @property
    def curvature(self) -> sp.Expr:
        """1/r around the axis, none along it."""
        return 1 / self.radius

    @property
    def tube(self) -> Tube | None:
        """About its axis, if that is along a coordinate's and it has no bounds."""
        if self.limits or 1 not in map(abs, self.direction):
            return None
        x, y, z = (sp.Integer(not u) for u in self.direction)
        return Tube((x, y, z), self._side / self.radius)

    @property
    def dent(self) -> sp.Expr:
        """None outside; inside, 1/rho, for half of it or more."""
        if not self.inward:
            return sp.Integer(0)
        return 2 / sp.sqrt(sum(component**2 for component in self._offset))

    @property
    def inside(self) -> tuple[sp.Expr, ...]:
        """Nearer than touching, and within the bounds."""
        return overlap(self.distance, self.limits, self.reach)


def across(direction: sp.Matrix) -> sp.Matrix:
    """Return what is left of x, y, z across a unit vector."""
    return position - direction * sp.Add(*(u * c for u, c in zip(direction, POSITION, strict=True)))


def check_direction(name: str, direction: tuple[sp.Rational | int, ...]) -> None:
    """Refuse what is no unit vector of rational numbers.

    Raises
    ------
    ValueError
        Naming the surface.
    """
    given = [sp.sympify(component) for component in direction]
    if len(given) != 3 or not all(u.is_Rational for u in given) or sum(u**2 for u in given) != 1:
        raise ValueError(
            f"surface {name}: direction: expected three rational numbers whose squares make 1, "
            f"got {tuple(direction)!r}"
        )
