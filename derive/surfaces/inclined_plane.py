"""A flat surface with a normal in any direction, whose components are parameters."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..symbolic.conditionals import barrier
from ..symbolic.symbols import POSITION
from .directions import along, per_length
from .plane import Flat


@dataclass(frozen=True)
class InclinedPlane(Flat):
    """A flat surface with a normal in any direction.

    Its contact plane is d·p = offset for the vector d as it is, of length 1 or not: the condition,
    the distance and the unit normal d/|d| are those of the same plane, whatever the doubles are.
    """

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
