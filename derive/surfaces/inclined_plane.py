"""A flat surface with a normal in any direction, whose components are parameters."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..symbolic.conditionals import barrier
from ..symbolic.symbols import POSITION
from .directions import Direction, along, per_length
from .plane import Flat
from .surface import overlap


@dataclass(frozen=True)
class InclinedPlane(Flat):
    """A flat surface, touched from the side that its normal points to.

    Its contact plane is d·p = offset for the vector d as it is, of length 1 or not: the condition,
    the distance and the unit normal d/|d| are those of the same plane, whatever the doubles are.

    Attributes
    ----------
    direction
        A vector along the normal, about of length 1.
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
    def distance(self) -> sp.Expr:
        """The distance of the centre from the contact plane, (d·p - offset)/|d|."""
        return barrier(self.condition) * per_length(self.direction)

    @property
    def condition(self) -> sp.Expr:
        """d·p - offset, free of the root."""
        return sp.Add(along(self.direction, POSITION), -self.offset)

    @property
    def normal(self) -> sp.Matrix:
        """The constant unit normal d/|d|."""
        return sp.Matrix([u * per_length(self.direction) for u in self.direction])

    @property
    def inside(self) -> tuple[sp.Expr, ...]:
        """The distance, and of a plate its thickness, within reach from either side, and bounds."""
        bounds = self.bounds
        return overlap(self.distance, bounds, self.reach if bounds else None)
