"""Surfaces that the ball can touch (Table 2): distance, bounds, normal.

A surface is given for the ball's *centre*: its distance is zero when the ball touches, positive
outside. The same distance, made polynomial, becomes the event condition (`events.py`).
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass

import sympy as sp


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
    @abstractmethod
    def inside(self) -> tuple[sp.Expr, ...]:
        """Expressions that are all negative exactly when the ball overlaps the body."""

    @property
    def steepness(self) -> sp.Expr:
        """How much `inside` changes with a length, at most, near where it is zero."""
        return sp.Integer(1)
