"""The common part of spheres and cylinders: a distance from a centre or an axis, on either side."""

from __future__ import annotations

from abc import abstractmethod
from dataclasses import dataclass, field

import sympy as sp

from .bounds import as_length
from .surface import Point, Surface, overlap, translated


@dataclass(frozen=True)
class TwoSided(Surface):
    """A surface, or the part of one within bounds, touched from outside or from inside.

    Attributes
    ----------
    limits
        The bounds (Eq. 2).
    inward
        True if the ball touches it from inside.
    reach
        The ball's radius, if the surface is a thin shell; None if all behind the surface is body.
    furthest
        Distance from the `reference_point` within which the ball is at every contact; None: it is
        not known.
    """

    limits: tuple[sp.Expr, ...] = field(default=(), kw_only=True)
    inward: bool = field(default=False, kw_only=True)
    reach: sp.Expr | None = field(default=None, kw_only=True)
    furthest: sp.Expr | None = field(default=None, kw_only=True)

    @property
    def _side(self) -> int:
        return -1 if self.inward else 1

    @property
    def bounds(self) -> tuple[sp.Expr, ...]:
        """The bounds as lengths."""
        return self._ends

    @property
    def _ends(self) -> tuple[sp.Expr, ...]:
        """The bounds of the body itself."""
        return (*map(as_length, self.limits), *self.cuts)

    @property
    def inside(self) -> tuple[sp.Expr, ...]:
        """The distance, the thickness of a shell, and the bounds."""
        return overlap(self.distance, self._ends, self.reach)


class Round(TwoSided):
    """A sphere or a cylinder: with rho from its centre or its axis, the ball touches at rho = r."""

    centre: Point
    radius: sp.Expr

    @property
    @abstractmethod
    def _rho(self) -> sp.Expr:
        """The distance of the ball's centre from the centre or the axis."""

    @property
    def distance(self) -> sp.Expr:
        """The way from the contact surface: rho - r, or r - rho from inside."""
        return self._side * self._rho - self._side * self.radius

    @property
    def reference_point(self) -> Point:
        """The centre, or a point of the axis."""
        return self.centre

    @property
    def condition(self) -> sp.Expr:
        """The shape, seen from the origin."""
        return translated(self.shape, self.centre)

    @property
    def curvature(self) -> sp.Expr:
        """The curvature of a sphere, and of a cylinder around its axis, 1/r."""
        return 1 / self.radius

    @property
    def max_concavity(self) -> sp.Expr:
        """Zero outside; inside a bound on 1/rho down to half of rho."""
        return 2 / self._rho if self.inward else sp.Integer(0)

    @property
    def max_convexity(self) -> sp.Expr:
        """A bound on 1/rho down to half of rho; zero inside."""
        return sp.Integer(0) if self.inward else 2 / self._rho
