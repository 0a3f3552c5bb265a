"""Flights along which the ball moves away from a box: it does not meet the box there.

With e for the vector from the nearest point of the box to the ball's centre at the start of a
flight (`surfaces/box.py`), and u(t) = v + a t/2 for the mean velocity until t, the ball has moved
by t u(t).

**Lemma (separation).** Let T be a time, let m be the margin below, and let, as computed,

    e·v > m   and   e·(v + a T/2) > m.

Then from its start until T the true ball is further from the box than it was at its start. So a
ball that has just touched the box does not come back to it, and neither does one come to it that
begins with

    e² > R_B² + 4 E Σ|e|,   E = p + W (|x| + Σ|e|).

*Proof.* Let n be the nearest point of the box. As the box is convex, e·(k - n) <= 0 for each of its
points k. With x(t) = n + e + t u(t) that is e·(x(t) - k) >= e² + t e·u(t). As u(t) lies between v
and v + a T/2, e·u(t) > 0, and so |x(t) - k| > |e| for 0 < t <= T.

All of this is about the true e and u. Each component of e changes by no more than a coordinate
does, so it is off by at most E: the error p of the position, and the roundings of the coordinate
and of a face near it. A component of u is off by the error v' of the velocity, and is at most
V = |v| + g T + v'. Together e·u is off by at most 3 E V + v' Σ|e|, and its roundings are below
W V Σ|e|/4. With

    m = 4 (E V + v' Σ|e|)

the true e·u is positive. The true e² is at least that of the computed e less 2 E Σ|e|, and the
roundings of e² and R_B² are far below that. ∎

The next event of the true ball is no later than the horizon, unless the earliest arrival may be
later. A flight whose errors exceed the largest budget of a search is left to the search, which
finds it undecided: so this test changes no result. W is that of `bounding_boxes.py`.
"""

from __future__ import annotations

import sympy as sp

from ..motion.flight import Flight
from ..surfaces import Box
from ..symbolic.conditionals import (
    AtMost,
    Less,
    Not,
    absolute,
    all_of,
    any_of,
    barrier,
    minimum,
)
from ..symbolic.error_terms import earliest_delay
from ..symbolic.rounding import extent, position_error, speed, velocity_error
from ..symbolic.symbols import VELOCITY
from .bounding_boxes import HALVES_NEAR, RELATIVE_SLACK
from .event_polynomials import ERROR_BUDGET_LEVELS, horizon, leaving
from .predicates import pad


def may_approach(box: Box, flight: Flight, halves: bool) -> dict[str, sp.Basic]:
    """Return the test whether a flight that comes near a box may come to it.

    It does not if the ball moves away from the box until the end of all that comes near.

    Parameters
    ----------
    box
        The box, along the axes.
    flight
        The motion between contacts, a parabola.
    halves
        True if it is known of each half of the flight whether it comes near.
    """
    away = box.excess
    length = barrier(sp.Add(*map(absolute, away)))
    off = barrier(position_error + RELATIVE_SLACK * barrier(extent + length))
    _, fastest = flight.size(horizon)
    error = barrier(off * barrier(fastest + velocity_error) + length * velocity_error)
    opening = barrier(sp.Add(*(e * v for e, v in zip(away, VELOCITY, strict=True))) - 4 * error)
    pulls = (e * a for e, a in zip(away, flight.acceleration, strict=True) if a != 0)
    turned = barrier(minimum(0, barrier(barrier(sp.Add(*pulls)) * horizon / 2)))
    outside = Less(
        barrier(box.radius**2 + 4 * barrier(off * length)),
        barrier(sp.Add(*(e**2 for e in away))),
    )
    budget = ERROR_BUDGET_LEVELS[0]
    starts = all_of(
        any_of(AtMost(1, leaving), outside),
        AtMost(earliest_delay, pad),
        AtMost(position_error, budget * extent),
        AtMost(velocity_error, budget * speed),
    )
    returns = AtMost(barrier(opening + turned), 0)
    if halves:
        first, later = HALVES_NEAR
        in_first = all_of(first, AtMost(barrier(opening + turned / 2), 0))
        returns = any_of(in_first, all_of(later, returns))
    return {"near": any_of(Not(starts), returns)}
