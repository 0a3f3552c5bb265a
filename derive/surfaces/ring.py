"""The ring of Table 2: a horizontal torus about the origin."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..ground.choice import hold, largest, smallest
from ..ground.symbols import POSITION
from .surface import Surface
from .tube import Tube


@dataclass(frozen=True)
class Ring(Surface):
    """A horizontal ring about the origin.

    Attributes
    ----------
    ring_radius
        R_H, radius of the wire's centre circle.
    reach
        R, radii of ball and wire together; less than R_H.
    below
        Whether balls are expected below it that fall for ever: then their errors count only as long
        as they can be near. The article's come from above, and its kernels stay as they are.
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
        """sqrt((rho - R_H)² + z²) - R: finite on the axis, where Table 2 is 0/0."""
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
    def halves(self) -> tuple[sp.Expr | None, ...]:
        """R_H + R across the axis, R along it."""
        widest = self.ring_radius + self.reach
        return (widest, widest, self.reach)

    @property
    def enclosed(self) -> bool:
        """It is."""
        return True

    @property
    def normal(self) -> sp.Matrix:
        """From the nearest point of the wire's centre circle, (x_C, y_C, 0), over R."""
        x, y, z = POSITION
        per_reach, rho = hold(1 / self.reach), hold(self.rho)
        outward = hold(hold(rho - self.ring_radius) * per_reach * hold(1 / rho))
        return sp.Matrix([x * outward, y * outward, z * per_reach])

    @property
    def curvature(self) -> sp.Expr:
        """1/R around the wire; along it, |rho - R_H|/(rho R) is less than 1/(R_H - R)."""
        return 1 / hold(smallest(self.reach, hold(self.ring_radius - self.reach)))

    @property
    def tube(self) -> Tube:
        """About the wire's centre circle."""
        one = sp.Integer(1)
        return Tube((one, one, one), 1 / self.reach, self.ring_radius)

    @property
    def dent(self) -> sp.Expr:
        """Along the wire, inside it: (R_H - rho)/(rho R), for half of this rho or more."""
        wide = 2 * self.ring_radius / hold(self.rho)
        return hold(largest(0, hold(wide - 1))) / self.reach

    @property
    def inside(self) -> tuple[sp.Expr, ...]:
        """Nearer to the wire than touching, by the squares of both: one root less."""
        _, _, z = POSITION
        depth = hold(self.rho - self.ring_radius)
        return (hold(depth**2 + z**2) - hold(self.reach) ** 2,)

    @property
    def steepness(self) -> sp.Expr:
        """The gradient of the squared distance is 2 R at a contact; as much again for rounding."""
        return 4 * self.reach
