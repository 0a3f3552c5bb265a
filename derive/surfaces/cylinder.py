"""A round cylinder, or the part of one within bounds, touched from outside or from inside."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..symbolic.conditionals import barrier, release
from ..symbolic.symbols import POSITION, position
from .rolling_surface import RollingSurface
from .surface import Point, translated
from .two_sided import Round


@dataclass(frozen=True)
class Cylinder(Round):
    """The side of a cylinder, which ends where its bounds do.

    Attributes
    ----------
    centre
        Any point of its axis.
    direction
        The direction of the axis: a unit vector of rational numbers.
    radius
        Distance from the axis to the ball's centre at a contact: the sum of the radii of cylinder
        and ball, or, from inside, their difference.
    """

    centre: Point
    direction: tuple[sp.Rational | int, ...]
    radius: sp.Expr

    def __post_init__(self) -> None:
        check_direction(self.name, self.direction)

    @property
    def _across(self) -> sp.Matrix:
        """The component of (x, y, z) across the axis."""
        return perpendicular_part(sp.Matrix(self.direction))

    @property
    def _offset(self) -> sp.Matrix:
        return self._across.applyfunc(lambda component: translated(component, self.centre))

    @property
    def _rho(self) -> sp.Expr:
        return sp.sqrt(sum(component**2 for component in self._offset))

    @property
    def shape(self) -> sp.Expr:
        """The squared distance from the axis less r², or the negative of that from inside."""
        return sp.Add(*(self._side * c**2 for c in self._across), -self._side * self.radius**2)

    @property
    def reference_point(self) -> Point:
        """The point of the axis half way between the ends, if both are known."""
        if self._span is None:
            return self.centre
        low, high = self._span
        middle = barrier((low + high) / 2)
        x, y, z = (middle if u else own for u, own in zip(self.direction, self.centre, strict=True))
        return x, y, z

    @property
    def half_sizes(self) -> tuple[sp.Expr | None, ...]:
        """The radius across the axis, if that is a coordinate axis, and half of the length."""
        if 1 not in map(abs, self.direction):
            return (None, None, None)
        half = None if self._span is None else barrier((self._span[1] - self._span[0]) / 2)
        return tuple(half if u else self.radius for u in self.direction)

    @property
    def _span(self) -> tuple[sp.Expr, sp.Expr] | None:
        """Coordinates of both ends along an axis of the scene, from bounds across it."""
        if 1 not in map(abs, self.direction):
            return None
        along = POSITION[list(map(abs, self.direction)).index(1)]
        ends: dict[sp.Expr, sp.Expr] = {}
        for limit in map(release, self.limits):
            if limit.free_symbols & set(POSITION) == {along}:
                ends.setdefault(sp.diff(limit, along), limit)
        if not {1, -1} <= ends.keys():
            return None
        return sp.expand(ends[sp.Integer(-1)] + along), sp.expand(along - ends[sp.Integer(1)])

    @property
    def enclosed(self) -> bool:
        """True if the ball is outside."""
        return not self.inward

    @property
    def normal(self) -> sp.Matrix:
        """The direction from the axis; the distance from it is r at a contact."""
        return self._offset * (self._side / self.radius)

    @property
    def rolling_surface(self) -> RollingSurface | None:
        """The tube about its axis, if that is along a coordinate axis."""
        if 1 not in map(abs, self.direction):
            return None
        x, y, z = (sp.Integer(not u) for u in self.direction)
        return RollingSurface((x, y, z), self._side / self.radius)


def perpendicular_part(direction: sp.Matrix) -> sp.Matrix:
    """Return the component of (x, y, z) across a unit vector."""
    return position - direction * sp.Add(*(u * c for u, c in zip(direction, POSITION, strict=True)))


def check_direction(name: str, direction: tuple[sp.Rational | int, ...]) -> None:
    """Check that a direction is a unit vector of rational numbers.

    Parameters
    ----------
    name
        The name of the surface, for the message.
    direction
        Its components along x, y and z.

    Raises
    ------
    ValueError
        If it is not; the message names the surface.
    """
    given = [sp.sympify(component) for component in direction]
    if len(given) != 3 or not all(u.is_Rational for u in given) or sum(u**2 for u in given) != 1:
        raise ValueError(
            f"surface {name}: direction: expected three rational numbers whose squares make 1, "
            f"got {tuple(direction)!r}"
        )
