"""A flight past the ring in polar coordinates, and the sizes that its search is drawn with.

With rho = sqrt(x² + y²), V² = vx² + vy² and L = x vy - y vx, free fall being along -z.
"""

from __future__ import annotations

from abc import ABC
from dataclasses import dataclass

import sympy as sp

from ..flight.parabola import Parabola
from ..ground.choice import hold, largest, smallest
from ..ground.rounding import extent, position_error, velocity_error
from ..ground.symbols import POSITION, VELOCITY
from ..surfaces import Ring
from .approach import Approach
from .events import horizon
from .windows import left

WIDER = 1 + sp.Rational(1, 2**14)
"""Windows are drawn for a ring this much thicker: contact cannot begin on their edges."""

steady, swing = sp.symbols("steady swing", real=True)
"""2 (V² + vz² + 2 g z) and 2 R_H L², constant along a flight."""

rho_start = sp.Symbol("rho_start", nonnegative=True)
"""rho at the flight's start."""

CONSTANTS = (steady, swing, rho_start)


@dataclass(frozen=True)
class PolarApproach(Approach, ABC):
    """What the ring's search and its filter share.

    Raises
    ------
    ValueError
        If free fall is not along -z.
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
        """The acceleration downwards."""
        return self.flight.strength

    def polar(self) -> tuple[sp.Expr, ...]:
        """Return rho², x vx + y vy, V² and L of the state."""
        x, y, _ = POSITION
        vx, vy, _ = VELOCITY
        return (
            hold(x**2 + y**2, r"\rho_0^2"),
            hold(x * vx + y * vy, "q"),
            hold(vx**2 + vy**2, "V^2"),
            hold(x * vy - y * vx, "L"),
        )

    @property
    def constants(self) -> dict[str, sp.Expr]:
        """The two constants of F'', and rho at the start."""
        _, _, speed_squared, moment = self.polar()
        _, _, z = POSITION
        _, _, vz = VELOCITY
        return {
            "steady": 2 * (speed_squared + vz**2) + 4 * self.gravity * z,
            "swing": 2 * self.ring.ring_radius * moment**2,
            "rho_start": self.ring.rho,
        }

    @property
    def symbols(self) -> tuple[sp.Symbol, ...]:
        """Those of the head of this file."""
        return CONSTANTS

    @property
    def reach(self) -> sp.Expr:
        """R, wider."""
        return hold(self.ring.reach, "R") * WIDER

    def radii(self) -> tuple[sp.Expr, sp.Expr]:
        """Return the radii of the annulus in which the centre can be at a contact."""
        radius = self.ring.ring_radius
        least = sp.Rational(1, 2**13) * radius  # narrower than that, the ring is `lost`
        inner = largest(hold(radius - self.reach), least)
        return inner, hold(radius + self.reach, r"\rho_+")

    @property
    def lost(self) -> sp.Expr:
        """A hole hardly wider than the ball, or errors near to what the windows are widened by.

        They grow until the horizon, or until the ball has fallen away from the ring for good.
        """
        far = hold(extent + 2 * self.ring.reach)
        return self.lost_by(hold(smallest(horizon, left(far, hold(1 / self.gravity)))))

    def lost_by(self, latest: sp.Expr) -> sp.Expr:
        """Return the same for errors that grow until then."""
        hole = hold(self.ring.ring_radius - hold(self.ring.reach, "R"))
        narrow = hold(sp.Rational(1, 2**12) * self.ring.ring_radius - hole)
        moved = hold(position_error + velocity_error * latest)
        return largest(narrow, hold(moved - sp.Rational(1, 2**16) * self.ring.reach))
