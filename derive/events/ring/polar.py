"""A flight past the ring in polar coordinates, and the sizes of the ring's search.

With rho = sqrt(x² + y²), V² = vx² + vy² and L = x vy - y vx; gravity acts along -z.
"""

from __future__ import annotations

from abc import ABC
from dataclasses import dataclass

import sympy as sp

from ...motion.parabola import Parabola
from ...surfaces import Ring
from ...symbolic.conditionals import barrier, maximum, minimum
from ...symbolic.rounding import extent, position_error, velocity_error
from ...symbolic.symbols import POSITION, VELOCITY
from ..box_windows import time_to_leave
from ..event_polynomials import horizon
from ..root_finder import RootFinder

INFLATION_FACTOR = 1 + sp.Rational(1, 2**14)
"""Windows are computed for a ring this much thicker: contact cannot begin on their edges."""

energy2, moment2 = sp.symbols("energy2 moment2", real=True)
"""2 (V² + vz² + 2 g z) and 2 R_H L², constant along a flight."""

rho_start = sp.Symbol("rho_start", nonnegative=True)
"""rho at the flight's start."""

CONSTANTS = (energy2, moment2, rho_start)


@dataclass(frozen=True)
class PolarRootFinder(RootFinder, ABC):
    """The quantities that the ring's search and its miss filter share.

    Attributes
    ----------
    flight
        The motion between contacts.
    ring
        The ring.

    Raises
    ------
    ValueError
        If gravity does not act along -z.
    """

    flight: Parabola
    ring: Ring

    def __post_init__(self) -> None:
        if not self.flight.upright:
            raise ValueError(
                f"surface {self.ring.name}: its own search expects free fall along -z, got "
                f"{self.flight.acceleration}"
            )

    @property
    def gravity(self) -> sp.Expr:
        """The size of the acceleration."""
        return self.flight.strength

    def polar(self) -> tuple[sp.Expr, ...]:
        """Return rho², x vx + y vy, V² and L of the state."""
        x, y, _ = POSITION
        vx, vy, _ = VELOCITY
        return (
            barrier(x**2 + y**2, r"\rho_0^2"),
            barrier(x * vx + y * vy, "q"),
            barrier(vx**2 + vy**2, "V^2"),
            barrier(x * vy - y * vx, "L"),
        )

    @property
    def constants(self) -> dict[str, sp.Expr]:
        """The two constants of F'', and rho at the start."""
        _, _, speed_squared, moment = self.polar()
        _, _, z = POSITION
        _, _, vz = VELOCITY
        return {
            "energy2": 2 * (speed_squared + vz**2) + 4 * self.gravity * z,
            "moment2": 2 * self.ring.ring_radius * moment**2,
            "rho_start": self.ring.rho,
        }

    @property
    def symbols(self) -> tuple[sp.Symbol, ...]:
        """The symbols of the constants."""
        return CONSTANTS

    @property
    def reach(self) -> sp.Expr:
        """R of the inflated ring."""
        return barrier(self.ring.reach, "R") * INFLATION_FACTOR

    def radii(self) -> tuple[sp.Expr, sp.Expr]:
        """Return the radii of the annulus in which the centre can be at a contact."""
        radius = self.ring.ring_radius
        least = sp.Rational(1, 2**13) * radius  # in a narrower ring the search is `lost`
        inner = maximum(barrier(radius - self.reach), least)
        return inner, barrier(radius + self.reach, r"\rho_+")

    @property
    def lost(self) -> sp.Expr:
        """Positive if the hole is hardly wider than the ball, or errors come near to the inflation.

        They grow until the horizon, or until the ball has fallen away from the ring for good.
        """
        far = barrier(extent + 2 * self.ring.reach)
        return self.lost_by(
            barrier(minimum(horizon, time_to_leave(far, barrier(1 / self.gravity))))
        )

    def lost_by(self, latest: sp.Expr) -> sp.Expr:
        """Return the same for errors that grow until a time."""
        hole = barrier(self.ring.ring_radius - barrier(self.ring.reach, "R"))
        narrow = barrier(sp.Rational(1, 2**12) * self.ring.ring_radius - hole)
        moved = barrier(position_error + velocity_error * latest)
        return maximum(narrow, barrier(moved - sp.Rational(1, 2**16) * self.ring.reach))
