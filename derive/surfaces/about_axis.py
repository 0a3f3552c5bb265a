"""The coordinates of surfaces about an axis in any direction."""

from __future__ import annotations

import sympy as sp

from ..symbolic.conditionals import barrier
from ..symbolic.symbols import POSITION
from .directions import Direction, along, distance_from_axis, per_length, perpendicular
from .surface import Surface


class AboutAxis(Surface):
    """A surface about an axis through its `reference_point`; the direction stands in each kind."""

    direction: Direction

    @property
    def _offset(self) -> list[sp.Expr]:
        """The way from the reference point to the ball's centre."""
        return [place - own for place, own in zip(POSITION, self.reference_point, strict=True)]

    @property
    def _rho(self) -> sp.Expr:
        """The distance from the axis."""
        return distance_from_axis(self.direction, self._offset)

    @property
    def _height(self) -> sp.Expr:
        """The way along the axis, from the reference point."""
        return barrier(barrier(along(self.direction, self._offset)) * per_length(self.direction))

    @property
    def _axis(self) -> tuple[sp.Expr, sp.Expr, sp.Expr]:
        """The unit vector along the axis."""
        per = per_length(self.direction)
        u, v, w = (barrier(part * per) for part in self.direction)
        return u, v, w

    @property
    def _across(self) -> list[sp.Expr]:
        """The way from the axis to the ball's centre."""
        return perpendicular(self.direction, self._offset)
