"""A plane whose crossing ends a shot; the place of the crossing decides which end it is."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from .bounds import as_length
from .plane import Plane
from .surface import overlap


@dataclass(frozen=True)
class EndPlane(Plane):
    """A plane that ends a shot, crossed against its normal.

    Attributes
    ----------
    parts
        The bounds of each end on it, in order. A crossing reaches the first end whose bounds all
        hold (are not positive). An end without bounds takes the rest of the plane.
    outcomes
        The number of each end's outcome.
    passed
        True for each end that only a ball that has fallen through the scene's passage can reach.
    """

    parts: tuple[tuple[sp.Expr, ...], ...] = ()
    outcomes: tuple[int, ...] = ()
    passed: tuple[bool, ...] = ()

    @property
    def sides(self) -> tuple[sp.Expr, ...]:
        """The bounds of all ends, one after another."""
        return tuple(bound for part in self.parts for bound in part)

    @property
    def bounds(self) -> tuple[sp.Expr, ...]:
        """The bounds of all ends if each has some; else every crossing counts."""
        return self.sides if all(self.parts) else ()

    @property
    def patches(self) -> tuple[tuple[sp.Expr, ...], ...]:
        """The bounds by end: a crossing counts within the bounds of any."""
        return self.parts if all(self.parts) else ((),)

    @property
    def inside(self) -> tuple[sp.Expr, ...]:
        """The distance from the plane, within reach from either side: a ball may be behind it."""
        return overlap(self.distance, tuple(map(as_length, self.limits)), self.reach)
