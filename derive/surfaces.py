"""Surfaces that the ball can touch (Table 2): distance, bounds, normal.

A surface is given for the ball's *centre*: its distance is zero when the ball touches, positive
outside. The same distance, made polynomial, becomes the event condition (`events.py`).
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass

import sympy as sp

from .choice import hold
from .symbols import position


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
    def bounds(self) -> tuple[sp.Expr, ...]:
        """The g of Eq. 2: a contact counts only where every one is <= 0."""
        return ()

    @property
    @abstractmethod
    def normal(self) -> sp.Matrix:
        """Outward unit normal n3 at a contact, the gradient of the distance there."""

    @property
    def curvature(self) -> sp.Expr:
        """Bound on the rate (1/m) at which the normal turns along the contact surface."""
        return sp.Integer(0)

    @property
    @abstractmethod
    def inside(self) -> tuple[sp.Expr, ...]:
        """Expressions that are all negative exactly when the ball overlaps the body."""

    @property
    def steepness(self) -> sp.Expr:
        """How much `inside` changes with a length, at most, near where it is zero."""
        return sp.Integer(1)


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
    def bounds(self) -> tuple[sp.Expr, ...]:
        """The bounds of the plate."""
        return self.limits

    @property
    def normal(self) -> sp.Matrix:
        """The constant unit normal."""
        return sp.Matrix(self.direction)

    @property
    def inside(self) -> tuple[sp.Expr, ...]:
        """Within reach of the plate from either side, and within its bounds."""
        return (self.distance, -self.distance - 2 * self.reach, *self.limits)


@dataclass(frozen=True)
class Sphere(Surface):
    """A fixed sphere; `radius` is its own radius and the ball's together."""

    centre: tuple[sp.Expr, sp.Expr, sp.Expr]
    radius: sp.Expr

    @property
    def _offset(self) -> sp.Matrix:
        return position - sp.Matrix(self.centre)

    @property
    def distance(self) -> sp.Expr:
        """|p - c| - r."""
        return sp.sqrt(sum(component**2 for component in self._offset)) - self.radius

    @property
    def condition(self) -> sp.Expr:
        """|p - c|² - r²: free of the root."""
        return sum(component**2 for component in self._offset) - self.radius**2

    @property
    def normal(self) -> sp.Matrix:
        """Radial; |p - c| = r at a contact."""
        return self._offset / self.radius

    @property
    def curvature(self) -> sp.Expr:
        """1/r."""
        return 1 / self.radius

    @property
    def inside(self) -> tuple[sp.Expr, ...]:
        """Nearer than touching."""
        return (self.distance,)
