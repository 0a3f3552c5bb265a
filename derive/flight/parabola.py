"""Free flight between contacts (Eq. 3): a parabola, with constant angular velocity."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..ground.choice import hold
from ..ground.polynomials import Coefficients
from ..ground.rounding import Rounded, extent, position_error, speed, velocity_error
from ..ground.symbols import POSITION, UNIT_ROUNDOFF, VELOCITY
from .flight import Flight


@dataclass(frozen=True)
class Parabola(Flight):
    """Eq. 3, with an acceleration along any axis."""

    @property
    def upright(self) -> bool:
        """Whether free fall is down, along -z."""
        ax, ay, az = self.acceleration
        return bool(ax == 0 and ay == 0 and az.is_negative)

    @property
    def path(self) -> dict[sp.Symbol, Coefficients]:
        """Place, velocity and half the acceleration; of degree 1 where there is none."""
        parts = zip(POSITION, VELOCITY, self.acceleration, strict=True)
        return {place: [place, v, a / 2] if a != 0 else [place, v] for place, v, a in parts}

    @property
    def span(self) -> sp.Expr:
        """For ever."""
        return sp.oo

    @property
    def remainder(self) -> sp.Expr:
        """None: it is Eq. 3 itself."""
        return sp.Integer(0)

    def size(self, latest: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
        """Return what they are where all at the start points one way, and free fall with it."""
        fastest = hold(speed + self.strength * latest)
        return hold(extent + latest * fastest), fastest

    def rounding(self, latest: sp.Expr) -> tuple[Rounded, Rounded]:
        """Return bounds of Eq. 3, by its size.

        No more than four roundings meet in a coordinate, each at most u times the largest it can
        be.
        """
        furthest, fastest = self.size(latest)
        shift = hold(position_error + velocity_error * latest + 4 * UNIT_ROUNDOFF * furthest)
        return Rounded(furthest, shift), Rounded(
            fastest, hold(velocity_error + 2 * UNIT_ROUNDOFF * fastest)
        )
