"""Constraint polynomials, the flight (Eq. 3) put into a surface (Table 2); shared bounds."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from ..motion.flight import Flight, divisor
from ..surfaces import Surface
from ..symbolic.conditionals import IfLess, barrier, maximum, minimum
from ..symbolic.polynomials import Coefficients, compose
from ..symbolic.rounding import ROUNDING_SLACK, Rounded, position_error, speed, velocity_error
from ..symbolic.symbols import UNIT_ROUNDOFF, t

Window = tuple[sp.Expr, sp.Expr]
"""An interval of time outside of which a contact is impossible."""

end = sp.Symbol("end", real=True)
"""End of the window that is searched, s."""
horizon = sp.Symbol("horizon", positive=True)
"""Time after which no event is wanted, s."""
leaving = sp.Symbol("leaving", real=True)
"""1 if the flight starts with the ball on this very surface, 2 if it touched another one last; else
0."""
margin, rate_margin = sp.symbols("margin rate_margin", nonnegative=True)
"""Bounds on the errors of the computed gap and of its computed rate."""
delay = sp.Symbol("delay", nonnegative=True)
"""Bound on how far a computed arrival is from the true one, s."""
rate, ceiling = sp.symbols("rate ceiling", real=True)
"""The gap's rate F', and a bound on |F''|."""


share = sp.Symbol("share", nonnegative=True)
"""Error of the state, relative to the size of its flight, that a search allows for."""

ERROR_BUDGET_LEVELS = [sp.Rational(1, 2**k) for k in (25, 30, 35, 40, 45)]
"""Values of `share` that a search tries one after another, and then 0, until a root is certain."""


def intersection(left: Window, right: Window) -> Window:
    """Return the part that two windows have in common; without any it ends before it begins.

    Parameters
    ----------
    left, right
        Begin and end of each window, s.
    """
    return maximum(left[0], right[0]), minimum(left[1], right[1])


def event_coefficients(surface: Surface, flight: Flight) -> Coefficients:
    """Return the surface's condition along the flight: coefficients in time, constant first.

    Degree 1 for the backboard, 2 for the bridge and the end plane, 8 for the ring.

    Parameters
    ----------
    surface
        The surface.
    flight
        A flight along which the position is a polynomial in time.
    """
    coefficients = compose(surface.condition, flight.path)
    while len(coefficients) > 1 and coefficients[-1] == 0:
        coefficients.pop()
    return coefficients


def deflated_coefficients(surface: Surface, flight: Flight) -> Coefficients:
    """Return the coefficients of F(t)/t after a contact at t = 0.

    The constant term of F is zero there by construction: it is dropped, never tested.

    Parameters
    ----------
    surface, flight
        As for `event_coefficients`.
    """
    return event_coefficients(surface, flight)[1:]


def crossing() -> dict[str, sp.Expr]:
    """Return the quantity that certifies a crossing at an arrival, and a bound on its delay.

    At a computed root F <= m. With the slope r = -F' - m' > 0 and |F''| <= C,
    F(t + s) <= m - r s + C s²/2, which is negative at s = r/C if r² > 2 C m: the crossing is
    certain if `clearance` > 0, and then within 2 m / r. The bounds are taken three times as wide;
    without a slope the delay is not bounded. For planes see the lemma of `plane.py`.

    **Lemma (root on a curved surface).** Let |F(t)| <= 7/3 m, F'(t) <= -r and |F''| <= C near t,
    and let there be no zero of F before t while F > 0. If r² > 6 C m one zero, where F falls, is
    within 14/3 m/r, less than the delay.

    *Proof.* F(t + s) and -F(t - s) are at most 7/3 m - r s + C s²/2. At s = 14/3 m/r that is
    -7/3 m (1 - 14/3 C m/r²) < 0, and F' <= -r + C s < 0 until then. ∎

    On the ring Newton's method ends where |F| <= m + 32 u R² (`ring/double.py`).
    """
    slope = barrier(-rate - rate_margin)
    return {
        "clearance": IfLess(0, slope, slope**2 - 6 * ceiling * margin, slope),
        "delay": IfLess(0, slope, 6 * margin / slope, sp.oo),
    }


def displacement(flight: Flight, lengths: Sequence[sp.Expr]) -> sp.Expr:
    """Return a bound on the error of a bound g (Eq. 2) or of the target at a computed arrival.

    **Lemma (length at an arrival).** Let g be a length with a gradient of at most 1, in which at
    most four roundings meet, each of at most u times the sum of the coordinates and the scene's
    lengths. Let the true arrival be within `delay` of the computed one. Then g at the computed
    arrival, as computed, is within this bound of g of the true ball at its own.

    *Proof.* At the computed time no coordinate is off by more than E of `Parabola.rounding`, and
    the place by no more than sqrt(3) E < 3 E. Until its own arrival the true ball flies no further
    than the delay times V. The rest is 4 u of the sum. ∎ (On a plane the delay times V has 12 (p +
    v T), so that 3 E is a small part.)

    Parameters
    ----------
    flight
        The motion between contacts.
    lengths
        The lengths of the scene that the bound or the target contains.

    Returns
    -------
    Expr
        m.
    """
    there, moving = flight.rounding(horizon)
    size = there.magnitude + total_length(lengths)
    return ROUNDING_SLACK * (
        3 * there.error + delay * moving.magnitude + 4 * UNIT_ROUNDOFF * barrier(size)
    )


def total_length(lengths: Sequence[sp.Expr]) -> sp.Expr:
    """Return the sum of the sizes of a scene's lengths."""
    return barrier(sum(map(sp.Abs, lengths)))


def error_budget(flight: Flight) -> dict[str, sp.Expr]:
    """Return the errors that a search allows for, and by how much the state's errors exceed them.

    The budget does not depend on the errors, so that the search takes the same steps whatever they
    are.
    """
    furthest, fastest = flight.size(horizon)
    level, velocity_level = barrier(share * furthest), barrier(share * fastest)
    return {
        "position_level": level,
        "velocity_level": velocity_level,
        "excess": maximum(
            barrier(position_error - level), barrier(velocity_error - velocity_level)
        ),
    }


def padded_horizon(flight: Flight) -> dict[str, sp.Expr]:
    """Return a time after which no event is wanted, given the earliest arrival so far.

    It does not depend on the bound on that arrival's delay, which must not exceed `pad`. Without
    gravity no other time is known than that of the arrival, and in pieces the length of the piece.
    """
    if not flight.exact:
        turning = flight.span
    elif flight.falls:
        turning = speed * barrier(1 / flight.strength)
    elif flight.strength == 0:
        turning = t
    else:
        strength = barrier(flight.strength)
        turning = IfLess(0, strength, speed * barrier(1 / divisor(strength)), t)
    pad = barrier(t + turning) * sp.Rational(1, 2**20)
    return {"horizon": t + barrier(pad), "pad": pad}


def time_rounding(rate: Rounded) -> sp.Expr:
    """Return the change of the gap between two neighbouring doubles of time, per unit of time.

    A margin that contains it ends every search: a step that does not move the time is within it.
    """
    return 2 * UNIT_ROUNDOFF * rate.magnitude
