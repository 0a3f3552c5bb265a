"""The search along a piece of a flight through air, for any surface with a polynomial condition.

The path is a polynomial of so high a degree that the condition along it is not expanded. Its second
derivative in time is F'' = Σ F_ij v_i v_j + Σ F_i a_i, and its third derivative is bounded once for
a piece, from the sizes of the surface's box and of the piece: |F'''| <= J. So within a time w

    -F''(t + s) <= -F''(t) + J w.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..motion.air import AirFlight, growth, piece_acceleration, piece_jerk, piece_place_error
from ..symbolic.conditionals import IfLess, absolute, barrier, maximum, minimum
from ..symbolic.polynomials import Coefficients, compose
from ..symbolic.rounding import Rounded, extent, position_error, rounding, velocity_error
from ..symbolic.symbols import POSITION, VELOCITY
from .box_windows import RELATIVE_INFLATION, clear
from .event_polynomials import Window, ceiling, horizon
from .polynomial import CEILING_BOX_FACTOR, PolynomialRootFinder

bend_rate = sp.Symbol("bend_rate", nonnegative=True)
"""J, a bound on the size of F''' up to the horizon."""

_ACCELERATION = sp.symbols("acceleration_x acceleration_y acceleration_z", real=True)
_JERK = sp.symbols("jerk_x jerk_y jerk_z", real=True)


@dataclass(frozen=True)
class AirRootFinder(PolynomialRootFinder):
    """The root finder along a piece of a flight through air."""

    flight: AirFlight

    @property
    def _local(self) -> Coefficients:
        """The coefficients up to the third of the condition along the path about a time."""
        local = zip(POSITION, VELOCITY, _ACCELERATION, _JERK, strict=True)
        path = {place: [place, v, a / 2, j / 6] for place, v, a, j in local}
        found = compose(self.surface.shape, path)
        return found + [sp.Integer(0)] * (4 - len(found))

    @property
    def symbols(self) -> tuple[sp.Symbol, ...]:
        """J."""
        return (bend_rate,)

    @property
    def constants(self) -> dict[str, sp.Expr]:
        """J, with every term taken positive, as in `ceiling`."""
        third = rounding(6 * self._local[3], self._sizes(CEILING_BOX_FACTOR)).magnitude
        return {bend_rate.name: barrier(third)}

    @property
    def windows(self) -> list[Window]:
        """All of the piece, if it may come into the surface's box."""
        surface, inflation = self.surface, self._inflation
        high: sp.Expr = horizon
        axes = zip(
            self.flight.enclosure(horizon), surface.reference_point, surface.half_sizes, strict=True
        )
        for (middle, reach), centre, half in axes:
            if half is not None:
                away = barrier(absolute(barrier(middle - centre)))
                near = barrier(barrier(half + inflation) + reach)
                high = IfLess(near, away, -1, high)
        return [(sp.Integer(0), high)]

    @property
    def _known(self) -> list[sp.Expr]:
        return [half for half in self.surface.half_sizes if half is not None]

    @property
    def _inflation(self) -> sp.Expr:
        return RELATIVE_INFLATION * minimum(*self._known) if self._known else sp.Integer(0)

    @property
    def lost(self) -> sp.Expr:
        """Positive if errors come near to the inflation of the box."""
        if not self._known:
            return sp.Integer(0)
        shift = barrier(
            position_error + horizon * barrier(growth * velocity_error) + piece_place_error
        )
        furthest, _ = self.flight.size(horizon)
        centre = sp.Add(*map(sp.Abs, self.surface.reference_point))
        far = barrier(furthest + extent + centre + maximum(*self._known))
        rounded = barrier(far * sp.Rational(1, 2**48))
        return barrier(shift + rounded) - self._inflation / 4

    @property
    def clear(self) -> sp.Expr:
        """Positive if no window opens before the horizon."""
        return clear(self.windows, self.lost) if self._boxed else sp.Integer(0)

    @property
    def bend(self) -> sp.Expr:
        """The second derivative at time t."""
        now = dict(zip(_ACCELERATION, self.flight.acceleration_at(), strict=True))
        return 2 * barrier(self._along(self._local[2]).xreplace(now))

    def curvature(self, width: sp.Expr) -> sp.Expr:
        """Return -F'' at time t and J on the window, rounding included."""
        return self._bounded(-self.bend, width)

    def turned_curvature(self, width: sp.Expr) -> sp.Expr:
        """Return F'' at time t and J on the window, rounding included."""
        return self._bounded(self.bend, width)

    def _bounded(self, bend: sp.Expr, width: sp.Expr) -> sp.Expr:
        upper = barrier(barrier(bend) + barrier(bend_rate * width))
        return barrier(minimum(upper, ceiling) + sp.Rational(1, 2**36) * ceiling)

    def _sizes(self, share: sp.Expr) -> dict[sp.Expr, Rounded]:
        """Return bounds on offset, velocity, acceleration and its rate within the piece."""
        known = super()._sizes(share)
        known |= dict.fromkeys(_ACCELERATION, Rounded(piece_acceleration))
        return known | dict.fromkeys(_JERK, Rounded(piece_jerk))
