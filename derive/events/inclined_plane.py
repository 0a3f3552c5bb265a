"""Arrival on a plane with a normal in any direction: a closed form, whose roundings delay it.

On a plane across an axis the roundings of the flight contain those of its condition. Here the
condition is a sum over all coordinates, d·p - offset, which exceed it where the ball meets it.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..motion.parabola import Parabola
from ..surfaces import InclinedPlane
from ..surfaces.directions import along
from ..symbolic.conditionals import IfLess, absolute, barrier
from ..symbolic.error_terms import curving
from ..symbolic.rounding import Rounded, rounding
from ..symbolic.symbols import POSITION, UNIT_ROUNDOFF, VELOCITY, t
from .event_polynomials import leaving
from .plane import PlaneSearch, mean_rate_error
from .search import Formula, root_formulas


def root_delay(plane: InclinedPlane, flight: Parabola) -> sp.Expr:
    """Return a bound on how late a contact is by the roundings of its condition.

    Arguments of the formula are the state and time t of the contact. The condition is
    c + b t + a t², with c = d·p - offset and b = d·v at the start of the flight and a = d·g/2, each
    with the roundings of its sum; on return c is zero without one. The root's own arithmetic is
    backward stable: with s for the computed root of D, all its errors together move the condition
    by at most 4 u t (|b| + s), where s is the speed towards the plane at the contact. The sum of
    these over s is the delay.

    Parameters
    ----------
    plane
        The surface.
    flight
        The motion between contacts.

    Returns
    -------
    Expr
        s.
    """
    starts = [barrier(place) for place in flight.start()]
    falls = zip(VELOCITY, flight.acceleration, strict=True)
    speeds = [barrier(v - a * t) for v, a in falls]
    there = {p: Rounded(barrier(absolute(own))) for p, own in zip(POSITION, starts, strict=True)}
    moving = {v: Rounded(barrier(absolute(own))) for v, own in zip(VELOCITY, speeds, strict=True)}
    pull = rounding(along(plane.direction, flight.acceleration), {}).error / 2
    rate = barrier(absolute(barrier(along(plane.direction, VELOCITY))))
    begin = barrier(absolute(barrier(along(plane.direction, speeds))))
    mean = barrier(rounding(along(plane.direction, VELOCITY), moving).error + pull * t)
    own = barrier(4 * UNIT_ROUNDOFF * barrier(begin + rate))
    again = barrier(t * barrier(mean + own))
    first = barrier(barrier(rounding(plane.condition, there).error) + again)
    return barrier(IfLess(curving, sp.oo, again, first)) / rate


@dataclass(frozen=True)
class InclinedPlaneSearch(PlaneSearch):
    """The search on a plane with a normal in any direction."""

    surface: InclinedPlane

    @property
    def returns(self) -> bool:
        """True: the condition of a low bounce is a small sum of large terms."""
        return True

    @property
    def remembered(self) -> bool:
        """True if a ball can roll on the plane, and meet another body there."""
        return self.flight.departs

    @property
    def formulas(self) -> dict[str, Formula]:
        """The formulas of a plane, and the roundings of the root."""
        found = super().formulas
        if self.remembered:
            # A ball that another body throws onto the plane meets it at once if its velocity
            # towards it is certain; with an error of that size it may hop.
            off = mean_rate_error(self.surface, self.flight)
            outputs, _, source = found["margin"]
            found["margin"] = (
                {**outputs, "rate_margin": IfLess(1, leaving, 2 * barrier(off), 0)},
                "Rounding-error bounds of the gap up to the horizon, and of the rate at its start.",
                source,
            )
        return found | root_formulas(root_delay(self.surface, self.flight), self.flight)
