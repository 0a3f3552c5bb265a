"""Events: the flight (Eq. 3) put into a surface (Table 2), and what every search shares."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from ..flight.flight import Flight
from ..ground.choice import IfLess, hold, largest
from ..ground.polynomials import Coefficients, compose
from ..ground.rounding import (
    SAFETY,
    Rounded,
    position_error,
    speed,
    velocity_error,
)
from ..ground.symbols import UNIT_ROUNDOFF, t
from ..surfaces import Surface

Window = tuple[sp.Expr, sp.Expr]

end = sp.Symbol("end", real=True)
"""End of the window that is searched, s."""
horizon = sp.Symbol("horizon", positive=True)
"""No event later than this is wanted, s."""
leaving = sp.Symbol("leaving", real=True)
"""1 if the flight starts with the ball on this very surface, else 0."""
margin, rate_margin = sp.symbols("margin rate_margin", nonnegative=True)
"""Bounds on the errors of the computed gap and of its computed rate."""
delay = sp.Symbol("delay", nonnegative=True)
"""Bound on how far a computed arrival is from the true one, s."""
rate, ceiling = sp.symbols("rate ceiling", real=True)
"""The gap's rate F' and a bound on |F''|."""


share = sp.Symbol("share", nonnegative=True)
"""Errors of a state, relative to its flight, that a search allows for."""

SHARES = [sp.Rational(1, 2**k) for k in (25, 30, 35, 40, 45)]
"""Those that are tried, one after another and then 0, where a root is not certain."""


def event_coefficients(surface: Surface, flight: Flight) -> Coefficients:
    """Return the surface's condition along the flight: coefficients in time, constant first.

    Degree 1 for the backboard, 2 for the bridge and the end plane, 8 for the ring.
    """
    coefficients = compose(surface.condition, flight.path)
    while len(coefficients) > 1 and coefficients[-1] == 0:
        coefficients.pop()
    return coefficients


def deflated_coefficients(surface: Surface, flight: Flight) -> Coefficients:
    """Return the coefficients of F(t)/t after a contact at t = 0.

    The constant term of F is zero there by construction: it is dropped, never tested.
    """
    return event_coefficients(surface, flight)[1:]


def crossing() -> dict[str, sp.Expr]:
    """Return what certifies a crossing at a computed arrival, and bounds its delay.

    At a computed root F <= m. With the slope r = -F' - m' > 0 and |F''| <= C,
    F(t + s) <= m - r s + C s²/2, which is negative at s = r/C if r² > 2 C m: the crossing is
    certain if `clearance` > 0, and then within 2 m / r. The bounds are taken three times as wide;
    without a slope the delay is not bounded.
    """
    slope = hold(-rate - rate_margin)
    return {
        "clearance": IfLess(0, slope, slope**2 - 6 * ceiling * margin, slope),
        "delay": IfLess(0, slope, 6 * margin / slope, sp.oo),
    }


def displacement(flight: Flight, lengths: Sequence[sp.Expr]) -> sp.Expr:
    """Return a bound on the error of a bound g (Eq. 2) or of the target at a computed arrival.

    Each of them is a length whose gradient is at most 1: the position's rounding errors, the
    distance flown during the delay, and the roundings of sums with the scene's lengths.
    """
    there, moving = flight.rounding(horizon)
    size = there.magnitude + total(lengths)
    return SAFETY * (3 * there.error + delay * moving.magnitude + 4 * UNIT_ROUNDOFF * hold(size))


def total(lengths: Sequence[sp.Expr]) -> sp.Expr:
    """Return the sum of the sizes of a scene's lengths."""
    return hold(sum(map(sp.Abs, lengths)))


def allowance(flight: Flight) -> dict[str, sp.Expr]:
    """Return the errors of a state that a search allows for, and by how much the errors exceed it.

    They do not depend on the errors, so that the search takes the same steps whatever these are.
    """
    furthest, fastest = flight.size(horizon)
    level, velocity_level = hold(share * furthest), hold(share * fastest)
    return {
        "position_level": level,
        "velocity_level": velocity_level,
        "excess": largest(hold(position_error - level), hold(velocity_error - velocity_level)),
    }


def padded_horizon(flight: Flight) -> dict[str, sp.Expr]:
    """Return a time after which no event is wanted, given the earliest arrival found.

    It does not depend on the bound on that arrival's delay, which must not exceed `pad`.
    """
    pad = hold(t + speed * hold(1 / flight.strength)) * sp.Rational(1, 2**20)
    return {"horizon": t + hold(pad), "pad": pad}


def time_rounding(rate: Rounded) -> sp.Expr:
    """Return what the gap changes, per unit of time, between two neighbouring doubles of time.

    A margin that holds it ends every search: a step that no longer moves the time is within it.
    """
    return 2 * UNIT_ROUNDOFF * rate.magnitude
