"""Surfaces that the ball can touch (Table 2): distance, bounds, normal.

A surface is given for the ball's *centre*: its distance is zero when the ball touches, positive
outside. The same distance, made polynomial, becomes the event condition (`events.py`).
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass

import sympy as sp

from ..ground.choice import hold, size
from ..ground.symbols import POSITION
from .bounds import length
from .tube import Tube

Point = tuple[sp.Expr, sp.Expr, sp.Expr]

_ORIGIN = (sp.Integer(0), sp.Integer(0), sp.Integer(0))


def moved(shape: sp.Expr, centre: Point) -> sp.Expr:
    """Return a formula in x, y, z as one of the position from a centre."""
    offsets = (place - own for place, own in zip(POSITION, centre, strict=True))
    return shape.xreplace(dict(zip(POSITION, offsets, strict=True)))


def overlap(
    distance: sp.Expr, limits: Sequence[sp.Expr], reach: sp.Expr | None
) -> tuple[sp.Expr, ...]:
    """Return what is negative where a ball overlaps a surface within its bounds.

    With a reach the surface is thin, and behind it is free space again; else all of it is body.
    """
    behind = () if reach is None else (-distance - 2 * reach,)
    return (distance, *behind, *map(length, limits))


@dataclass(frozen=True)
class Surface(ABC):
    """A stationary surface.

    Attributes
    ----------
    name
        Its name in results and in the names of its kernels.
    """

    name: str

    @property
    @abstractmethod
    def distance(self) -> sp.Expr:
        """Signed distance (m) from the ball to the surface, positive outside."""

    @property
    @abstractmethod
    def condition(self) -> sp.Expr:
        """Polynomial in x, y, z that is zero at a contact and positive outside."""

    @property
    def polynomial(self) -> bool:
        """Whether the condition is one polynomial; else it is one on each of several parts."""
        return True

    @property
    def about(self) -> Point:
        """A point that the surface is about; by default the origin."""
        return _ORIGIN

    @property
    def shape(self) -> sp.Expr:
        """The condition in x, y, z as seen from that point."""
        return self.condition

    @property
    def halves(self) -> tuple[sp.Expr | None, ...]:
        """Half sizes of a box about that point that holds every contact; None: not known."""
        return (None, None, None)

    @property
    def enclosed(self) -> bool:
        """Whether all of the body is in that box: out of it, `inside` has the distance from it.

        Or that distance as many times as `steepness` is, for half of the latter or more.
        """
        return False

    def aside(self, axis: int) -> tuple[sp.Expr, ...]:
        """Distances along an axis: where any is positive, the ball is that far from overlapping."""
        place, half = POSITION[axis], self.halves[axis]
        if self.enclosed and half is not None:
            return (hold(size(hold(place - hold(self.about[axis])))) - hold(half),)
        alone = (d for d in self.inside if d.free_symbols & set(POSITION) == {place})
        return tuple(alone) if self.steepness == 1 else ()

    @property
    def bounds(self) -> tuple[sp.Expr, ...]:
        """The g of Eq. 2: a contact counts only where every one is <= 0."""
        return ()

    @property
    def patches(self) -> tuple[tuple[sp.Expr, ...], ...]:
        """The bounds by part: a contact counts where all of any one part hold."""
        return (self.bounds,)

    @property
    @abstractmethod
    def normal(self) -> sp.Matrix:
        """Outward unit normal n3 at a contact, the gradient of the distance there."""

    @property
    def curvature(self) -> sp.Expr:
        """Bound on the rate (1/m) at which the normal turns along the contact surface."""
        return sp.Integer(0)

    @property
    def tube(self) -> Tube | None:
        """What a ball that stays on it rolls on; None: no such motion is known."""
        return None

    @property
    def dent(self) -> sp.Expr:
        """Bound on how fast the distance bends down, by the squared speed (1/m); 0 if convex."""
        return sp.Integer(0)

    @property
    def around(self) -> sp.Expr | None:
        """Bound below the distance from every place at this height and distance from the z axis.

        It is convex in these two; None: no such bound is known.
        """
        return None

    @property
    @abstractmethod
    def inside(self) -> tuple[sp.Expr, ...]:
        """Expressions that are all negative exactly when the ball overlaps the body."""

    @property
    def steepness(self) -> sp.Expr:
        """How much `inside` changes with a length, at most, near where it is zero."""
        return sp.Integer(1)
