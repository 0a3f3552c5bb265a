"""Proved bounds of shots that have not rolled, in scenes in which balls roll.

A shot carries both: the proved bounds of `contact_frames`, and the vector of `propagation`, which
rolls need. Until it is `estimated` its decisions allow for the proved bounds, and from then on for
the vector times a factor. It is estimated from the contact on

- after which the ball is so slow off the surface that its bounces may soon end there, at the latest
  where it is decided whether they do (`rolling/settling.py`); on a body, from the start on;
- after which no lemma holds, or the bound on its place exceeds `LARGEST_PLACE`. Proved bounds grow
  faster than errors do; what they would flag then is mostly certain.

So the theorem about flags and bounds holds for every shot with its premises (`scenes/premises.py`)
that is not estimated at its end.
"""

from __future__ import annotations

import sympy as sp

from ..contact.ball import Ball
from ..ir.kernel import decision
from ..motion.parabola import Parabola
from ..symbolic.conditionals import (
    AtMost,
    Boolean,
    Choose,
    IfLess,
    Less,
    Not,
    all_of,
    any_of,
    barrier,
)
from ..symbolic.error_terms import clock_error, left_normal
from ..symbolic.symbols import normal, velocity
from . import contact_frames
from .contact_frames import NORMS, errors_at_time
from .propagation import scaled_errors

estimated = sp.Symbol("estimated", nonnegative=True)
"""1: the bounds of a shot are estimated from here on."""
clock_bound = sp.Symbol("clock_bound", nonnegative=True)
"""The sum of the proved bounds on the delays of contacts, s."""

LEFT_NORMAL = {str(n): f"frame_{str(n).removeprefix('left_')}" for n in left_normal}
"""The variables of the normal of the last contact, which is another for the vector of errors."""

CARRIED = (
    *(symbol for symbol in contact_frames.CARRIED if str(symbol) not in LEFT_NORMAL),
    *(sp.Symbol(name, real=True) for name in LEFT_NORMAL.values()),
    *(estimated, clock_bound),
)
"""The numbers that are carried besides the vector of errors."""

LARGEST_PLACE = sp.Rational(1, 2**33)
"""The largest proved bound on the error of a place that decisions allow for, m."""

SLOWEST = sp.Rational(1, 2**16)
"""The smallest square of a speed off a surface over g R_B: far above that at which bounces end."""


def error_bounds(times: int) -> dict[str, sp.Expr]:
    """Return bounds on the errors of a state and its time, proved or estimated.

    Parameters
    ----------
    times
        How many times the carried errors are the estimated bounds.
    """
    proved = (*NORMS, clock_bound)
    pairs = zip(scaled_errors(times).items(), proved, strict=True)
    return {name: IfLess(0, estimated, value, bound) for (name, value), bound in pairs}


def bounds_at_time(flight: Parabola) -> dict[str, sp.Expr]:
    """Return the proved bounds at the end of a flight of time t that a time limit ends.

    Parameters
    ----------
    flight
        The motion between contacts.
    """
    found = errors_at_time(flight)
    del found[clock_error.name]
    own = {name: bound.xreplace({clock_error: clock_bound}) for name, bound in found.items()}
    return own | {clock_bound.name: sp.Integer(0)}


def estimated_after_contact(ball: Ball, strength: sp.Expr) -> dict[str, sp.Basic]:
    """Return whether a shot is estimated from a contact on.

    Parameters
    ----------
    ball
        The ball.
    strength
        The size of the free ball's acceleration, m/s².
    """
    off = barrier(velocity.dot(normal))
    slow = Less(barrier(off**2), barrier(SLOWEST * barrier(strength * ball.radius)))
    place, pace, turn = NORMS
    known = all_of(AtMost(place, LARGEST_PLACE), Less(pace, sp.oo), Less(turn, sp.oo))
    return {estimated.name: Choose(any_of(Less(0, estimated), Not(known), slow), 1, 0)}


delay = sp.Symbol("delay", real=True)
"""The proved bound on the delay of one contact, s."""

KERNELS = {
    kernel.name: kernel
    for kernel in (
        decision(
            "proves",
            {
                "proves_contact": all_of(Boolean("touches"), AtMost(estimated, 0)),
                "proves_end": all_of(Boolean("ends"), AtMost(estimated, 0)),
            },
            "Whether a contact, and an end, of a shot is met that is not estimated.",
        ),
        decision(
            "estimates",
            {estimated.name: 1},
            "A ball that may begin to roll is estimated from then on.",
        ),
        decision(
            "clock_bound_sum",
            {clock_bound.name: clock_bound + delay},
            "Sum of the proved bounds on the delays of contacts.",
            True,
        ),
    )
}
