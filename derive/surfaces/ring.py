"""The ring of Table 2: a horizontal torus about the origin."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..symbolic.conditionals import barrier, maximum, minimum
from ..symbolic.symbols import POSITION
from .rolling_surface import RollingSurface, toroidal
from .surface import Surface


@dataclass(frozen=True)
class Ring(Surface):
    """A horizontal ring about the origin.

    Attributes
    ----------
    ring_radius
        R_H, radius of the wire's centre circle.
    reach
        R, the sum of the radii of ball and wire; less than R_H.
    below
        True if balls are expected below the ring that fall for ever: then their errors count only
        while they can be near. In the article balls come from above, and its kernels stay as they
        are.
    """

    ring_radius: sp.Expr
    reach: sp.Expr
    below: bool = False

    @property
    def rho(self) -> sp.Expr:
        """Distance of the centre from the axis."""
        x, y, _ = POSITION
        return sp.sqrt(x**2 + y**2)

    @property
    def distance(self) -> sp.Expr:
        """sqrt((rho - R_H)² + z²) - R, which is finite on the axis, where Table 2 is 0/0."""
        _, _, z = POSITION
        return sp.sqrt((self.rho - self.ring_radius) ** 2 + z**2) - self.reach

    @property
    def condition(self) -> sp.Expr:
        """(rho² + z² + R_H² - R²)² - 4 R_H² rho²: Table 2's f1, squared free of its root."""
        x, y, z = POSITION
        rho_squared = x**2 + y**2
        return (
            rho_squared + z**2 + (self.ring_radius**2 - self.reach**2)
        ) ** 2 - 4 * self.ring_radius**2 * rho_squared

    @property
    def half_sizes(self) -> tuple[sp.Expr | None, ...]:
        """R_H + R across the axis, R along it."""
        widest = self.ring_radius + self.reach
        return (widest, widest, self.reach)

    @property
    def enclosed(self) -> bool:
        """True: a ring is bounded."""
        return True

    @property
    def normal(self) -> sp.Matrix:
        """The direction from the nearest point of the wire's centre circle, (x_C, y_C, 0)."""
        x, y, z = POSITION
        per_reach, rho = barrier(1 / self.reach), barrier(self.rho)
        outward = barrier(barrier(rho - self.ring_radius) * per_reach * barrier(1 / rho))
        return sp.Matrix([x * outward, y * outward, z * per_reach])

    @property
    def curvature(self) -> sp.Expr:
        """The larger of 1/R around the wire, and 1/(R_H - R) as a bound along it.

        Along the wire the curvature is |rho - R_H|/(rho R).
        """
        return 1 / barrier(minimum(self.reach, barrier(self.ring_radius - self.reach)))

    @property
    def rolling_surface(self) -> RollingSurface:
        """The tube about the wire's centre circle."""
        one = sp.Integer(1)
        return RollingSurface((one, one, one), 1 / self.reach, self.ring_radius)

    @property
    def rolling_surface_across_gravity(self) -> RollingSurface:
        """The torus of the ball's centre."""
        (x, y, _), zero = POSITION, sp.Integer(0)
        up = (zero, zero, sp.Integer(1))
        return toroidal(up, (x, y, zero), self.rho, self.ring_radius, self.reach)

    @property
    def max_concavity(self) -> sp.Expr:
        """Bound on the curvature along the wire, inside it: (R_H - rho)/(rho R).

        It holds down to half of this rho.
        """
        wide = 2 * self.ring_radius / barrier(self.rho)
        return barrier(maximum(0, barrier(wide - 1))) / self.reach

    @property
    def inside(self) -> tuple[sp.Expr, ...]:
        """The squared distance from the centre circle less R², which needs one root less."""
        _, _, z = POSITION
        depth = barrier(self.rho - self.ring_radius)
        return (barrier(depth**2 + z**2) - barrier(self.reach) ** 2,)

    @property
    def steepness(self) -> sp.Expr:
        """Twice the gradient of the squared distance at a contact, 2 R, with room for roundings."""
        return 4 * self.reach
