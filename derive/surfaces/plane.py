"""A flat surface: backboard, bridge, floor (Table 2)."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..ground.choice import hold
from ..ground.symbols import position
from .bounds import length
from .surface import Surface, overlap
from .tube import Tube


@dataclass(frozen=True)
class Plane(Surface):
    """A flat surface, touched from the side that its normal points to.

    Attributes
    ----------
    direction
        Unit normal, constant.
    offset
        n·p of the ball's centre when it touches.
    reach
        Distance from the plane's body to the centre of a ball that touches it.
    limits
        The bounds (Eq. 2).
    """

    direction: tuple[int, int, int]
    offset: sp.Expr
    reach: sp.Expr
    limits: tuple[sp.Expr, ...] = ()

    @property
    def distance(self) -> sp.Expr:
        """Distance of the centre from the contact plane.

        The offset is held: a ball put on the plane then has a distance of exactly zero.
        """
        return self.normal.dot(position) - hold(self.offset)

    @property
    def condition(self) -> sp.Expr:
        """The distance itself is polynomial."""
        return self.distance

    @property
    def around(self) -> sp.Expr | None:
        """The distance itself, of a level plane."""
        return None if any(self.direction[:2]) else self.distance

    @property
    def bounds(self) -> tuple[sp.Expr, ...]:
        """The bounds of the plate."""
        return tuple(map(length, self.limits))

    @property
    def normal(self) -> sp.Matrix:
        """The constant unit normal."""
        return sp.Matrix(self.direction)

    @property
    def tube(self) -> Tube | None:
        """The plane itself, if it has no bounds."""
        zero = sp.Integer(0)
        return None if self.limits else Tube((zero, zero, zero), zero)

    @property
    def inside(self) -> tuple[sp.Expr, ...]:
        """Within reach of the plate from either side, and within its bounds."""
        return overlap(self.distance, self.limits, self.reach)
