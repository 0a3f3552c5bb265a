"""A plane whose crossing ends a shot; which end that is depends on where it is crossed."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from .plane import Plane


@dataclass(frozen=True)
class Gate(Plane):
    """A plane that ends a shot, crossed against its normal.

    Attributes
    ----------
    parts
        The bounds of each end on it, in order: the first end all of whose bounds hold (are not
        positive) is the one that is reached. An end without bounds takes the rest of the plane.
    outcomes
        The number of each end's outcome.
    passed
        Whether each end is one only for a ball that has fallen through the scene's passage.
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
        """The same where each end has some; else every crossing counts."""
        return self.sides if all(self.parts) else ()

    @property
    def patches(self) -> tuple[tuple[sp.Expr, ...], ...]:
        """A crossing counts within the bounds of any end."""
        return self.parts if all(self.parts) else ((),)
