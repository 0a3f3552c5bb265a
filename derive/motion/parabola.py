"""Free flight between contacts (Eq. 3): a parabola, with constant angular velocity."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..symbolic.conditionals import absolute, barrier
from ..symbolic.error_terms import dv, dx
from ..symbolic.polynomials import Coefficients
from ..symbolic.rounding import Rounded, extent, position_error, speed, velocity_error
from ..symbolic.symbols import POSITION, UNIT_ROUNDOFF, VELOCITY, t, velocity
from .flight import Flight


@dataclass(frozen=True)
class Parabola(Flight):
    """Eq. 3, with an acceleration in any direction, which may be zero."""

    @property
    def source(self) -> str:
        """Eq. 3."""
        return "Eq. 3"

    @property
    def path(self) -> dict[sp.Symbol, Coefficients]:
        """Position, velocity and half the acceleration; without acceleration the degree is 1."""
        parts = zip(POSITION, VELOCITY, self.acceleration, strict=True)
        return {place: [place, v, a / 2] if a != 0 else [place, v] for place, v, a in parts}

    @property
    def span(self) -> sp.Expr:
        """Infinite: Eq. 3 holds at all times."""
        return sp.oo

    @property
    def remainder(self) -> sp.Expr:
        """Zero: the path is Eq. 3 itself."""
        return sp.Integer(0)

    def mean_velocity(self, time: sp.Expr = t) -> list[sp.Expr]:
        """Return v + a t/2."""
        falls = zip(VELOCITY, self.acceleration, strict=True)
        return [barrier(v + a * time / 2) for v, a in falls]

    def mean_rounding(self, latest: sp.Expr) -> Rounded:
        """Return the size of the flight, and at most three roundings of it."""
        _, fastest = self.size(latest)
        return Rounded(fastest, barrier(velocity_error + 3 * UNIT_ROUNDOFF * fastest))

    @property
    def present_acceleration(self) -> tuple[sp.Expr, ...]:
        """The acceleration of free fall, at all velocities."""
        return self.acceleration

    def along(self) -> tuple[list[sp.Expr], list[sp.Expr]]:
        """Return dx + t dv, and dv."""
        places = [barrier(error + drift * t) for error, drift in zip(dx, dv, strict=True)]
        return places, list(dv)

    def path_lengths(self) -> list[sp.Expr]:
        """Return 2 |v| t + |a| t² of each axis."""
        return [
            2 * absolute(v) * t + sp.Abs(pull) * t**2
            for v, pull in zip(velocity, self.acceleration, strict=True)
        ]

    def size(self, latest: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
        """Return the values for position, velocity and gravity of one direction."""
        fastest = barrier(speed + self.strength * latest)
        return barrier(extent + latest * fastest), fastest

    def rounding(self, latest: sp.Expr) -> tuple[Rounded, Rounded]:
        """Return error bounds of Eq. 3 from the flight's size.

        **Lemma (flight).** Until the time T the true ball, whose state at the start is off by p and
        v in each component, is in each coordinate within p + v T + 4 u X of the one that Eq. 3
        gives in doubles, and its velocity within v + 2 u V; X = |x| + T V and V = |v| + g T are the
        sums of the sizes of all coordinates, as computed.

        *Proof.* The state's errors count p + v T and v. A coordinate x + t (v - (g/2) t) has the
        roundings u (g/2) t², u |v - (g/2) t| t twice and that of the sum, u |x_t|: together at most
        u (|x| + 3 |v| t + 2 g t²) <= 3 u X, and without acceleration u (|x| + 2 |v| t). A velocity
        has u g t and u |v_t|. X and V as computed are off by less than 8 u of themselves. ∎
        """
        furthest, fastest = self.size(latest)
        shift = barrier(position_error + velocity_error * latest + 4 * UNIT_ROUNDOFF * furthest)
        return Rounded(furthest, shift), Rounded(
            fastest, barrier(velocity_error + 2 * UNIT_ROUNDOFF * fastest)
        )
