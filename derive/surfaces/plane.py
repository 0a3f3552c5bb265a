"""A flat surface: backboard, bridge, floor (Table 2)."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..symbolic.conditionals import barrier
from ..symbolic.symbols import position
from .bounds import as_length
from .directions import Direction
from .rolling_surface import RollingSurface
from .surface import Surface, overlap


@dataclass(frozen=True)
class Flat(Surface):
    """A flat surface, or the part of one within bounds, touched from where its normal points.

    Attributes
    ----------
    direction
        d, the unit normal, or a vector along it that is about of length 1.
    offset
        d·p of the ball's centre at a contact.
    reach
        Distance from the plane's body to the centre of a ball that touches it.
    limits
        The bounds (Eq. 2).
    """

    direction: Direction
    offset: sp.Expr
    reach: sp.Expr
    limits: tuple[sp.Expr, ...] = ()

    @property
    def bounds(self) -> tuple[sp.Expr, ...]:
        """The bounds of the plate as lengths."""
        return (*map(as_length, self.limits), *self.cuts)

    @property
    def inside(self) -> tuple[sp.Expr, ...]:
        """The distance, and of a plate its thickness, within reach from either side, and bounds."""
        bounds = self.bounds
        return overlap(self.distance, bounds, self.reach if bounds else None)

    @property
    def rolling_surface(self) -> RollingSurface | None:
        """The plane itself; it ends where its bounds do."""
        zero = sp.Integer(0)
        return RollingSurface((zero, zero, zero), zero)


@dataclass(frozen=True)
class Plane(Flat):
    """A flat surface across an axis of the scene."""

    direction: tuple[int, int, int]

    @property
    def distance(self) -> sp.Expr:
        """The distance of the centre from the contact plane.

        The offset is held: a ball put on the plane then has a distance of exactly zero.
        """
        return self.normal.dot(position) - barrier(self.offset)

    @property
    def condition(self) -> sp.Expr:
        """The distance, which is polynomial."""
        return self.distance

    @property
    def azimuth_free_distance(self) -> sp.Expr | None:
        """The distance, if the plane is level."""
        return None if any(self.direction[:2]) else self.distance

    @property
    def normal(self) -> sp.Matrix:
        """The constant unit normal."""
        return sp.Matrix(self.direction)
