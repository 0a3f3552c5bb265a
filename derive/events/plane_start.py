"""Flights that begin at a plane to within the errors: on which side of it they do is undecided.

Balls pass planes without a contact: an end plane and the top of a plate from below, a board from
behind. So a contact with another body may be at the height of a plane to within the errors, and
nothing says on which side the true ball is: if it moves inwards, an arrival just after the start
and none at all are the same to the errors. A curved body has no such side, since no ball is inside.

Let f = c + b t - k t²/2 be the gap of the true ball, k >= 0, with c and b within p and v of those
of the computed ball, ĉ and b̂ without roundings; p and v are the errors of its place and velocity
at the start. The margin m(T) of `plane.plane_margin` has 2 p + 2 v T, and besides 10 u of the
flight and 6 u of the plane's place, more than any gap here rounds by. c = 0 = ĉ, where the ball
left the plane. T is the computed arrival, if there is one, and r its rate, less its sign.

**Lemma (start at a plane that gravity pulls to).** Let k > 0 and 8 v² <= k p. Let h be the largest
computed gap from the start on, at A = max(0, b̂/k), and |h| > m(T), or |h| > m(A) without an
arrival. Then the true ball falls through the plane exactly if the computed one does, once and after
T/2.

*Proof.* The largest true gap is off from h by at most p + ((b̂ + v)² - b̂²)/(2 k) <= p + v A + p/16
for b̂ >= 0, and by less for b̂ < 0: less than m(A), so both have one sign. If they are negative,
neither arrives. Else both gaps fall through zero once, as they are concave. At T/2, for b̂ < 0, the
computed gap is at least ĉ/2 and ĉ = h > m(T), so that f >= ĉ/2 - p - v T/2 > 0. For b̂ >= 0 it is
h - (b̂ - r)²/(8 k), with r² = 2 k h: if b̂ <= r + 2 v at least 3/4 h or h - p/16, and
f >= 3/4 h - p - v T/2 > 0. Else T/2 < A - v/k, before which f rises: it falls later. ∎

A ball that has left the plane is decided only if b̂ > 8 v, since h = b̂²/(2 k) and m(T) >= 4 v
b̂/k.

**Lemma (start at a plane along gravity).** Let k = 0, t_e be the time of the true event, and t_w
the earliest computed arrival at other planes, with t_e <= 5/3 t_w. Let b̂ >= 2 v, or |ĉ| > 2 m(n),
where n is 0 if ĉ < 0, else the earlier of T, if there is an arrival, and t_w. If the arrival is the
first event, the true ball falls through the plane once, after T/2; and no later than t_e the true
ball falls through it before T/2, or without an arrival.

*Proof.* If b̂ >= 2 v neither gap falls. Else ĉ has the sign of c, as |ĉ| > 4 p, and if it is
negative neither gap falls to zero. So let ĉ > 4 p + 4 v n.

- Without an arrival n = t_w, and f > ĉ - p - v t_e > 0 until t_e, since b >= -v.
- With T <= t_w, ĉ = r T > 4 v T: r > 4 v, and b < 0. At T/2 f is at least ĉ/2 - p - v T/2 > 0.
- With T > t_w, and until t = T/2 or t_e, f >= r (T - t) - p - v t >= ĉ/2 - p - 5/3 v t_w > 0. ∎

On the third case, the arrival is later than t_w, and only the tie with it, and bounds near T, are
looked at: not if r (T - t_w) > 6 m(t_w), since f is positive until t_e then. If it is a tie, the
undecided time is at most t_w/2, or t_w - 6 m(t_w)/r, before which f is positive as well. Where the
bounds are out of reach, they are so from the start until 6 t_w, if r <= 2 v.

t_e <= 5/3 t_w holds for the events at planes by the lemma of `plane.py`: T is off by at most
0.64 m/r; for k > 0 that is less than T/6 if b̂ >= 0, and less than 0.64 T if b̂ < 0, as ĉ <= r T.

The true ball has b >= 0 where it left the plane, and does not come back. Where b̂ < 0 after all,
its speed off the plane is nothing but an error: its gap counts as zero, and it is undecided.

A plane from which gravity pulls the ball off (k < 0) is tested like one along gravity, by the gap
and the rate at the start; so is one of which roundings decide whether it does. The lemmas say
nothing of it.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from ..ir.kernel import Kernel, decision
from ..motion.parabola import Parabola
from ..surfaces import InclinedPlane, Plane
from ..surfaces.directions import along
from ..symbolic.conditionals import Choose, IfLess, Less, absolute, any_of, barrier
from ..symbolic.rounding import Rounded, extent, position_error, rounding, velocity_error
from ..symbolic.symbols import POSITION, UNIT_ROUNDOFF, VELOCITY
from .event_polynomials import leaving
from .predicates import undecided_time


def plane_start(planes: Sequence[Plane], flight: Parabola) -> Kernel:
    """Return the decision whether errors are small enough for planes that gravity pulls to.

    Parameters
    ----------
    planes
        Planes across axes that gravity pulls to.
    flight
        The motion between contacts.
    """
    falls = (along(plane.direction, flight.acceleration) for plane in planes)
    strengths = dict.fromkeys(barrier(absolute(fall) / 2) for fall in falls)
    unsure = barrier(2 * velocity_error)
    found = [Less(barrier(each * position_error), barrier(unsure**2)) for each in strengths]
    summary = "Undecided time 0 if errors are too large to decide on which side a flight begins."
    return decision(
        "plane_start", {"undecided_time": Choose(any_of(*found), 0, undecided_time)}, summary
    )


def start_side(plane: Plane | InclinedPlane, flight: Parabola) -> dict[str, sp.Expr]:
    """Return rate, gap and margin at the start, for a plane from which gravity pulls a ball off.

    If gravity does so with some parameters only, the rate is infinite where it certainly pulls to
    the plane. A ball that leaves the plane does not come back. If its rate is negative all the
    same, that is an error.

    Parameters
    ----------
    plane
        The plane.
    flight
        The motion between contacts.
    """
    fall = along(plane.direction, flight.acceleration)
    rate = barrier(along(plane.direction, VELOCITY))
    off = IfLess(0, leaving, IfLess(rate, 0, rate, sp.oo), rate)
    known = dict.fromkeys(POSITION, Rounded(extent, position_error))
    if not fall.is_positive:
        vague = -2 * vague_pull(plane, flight) if isinstance(plane, InclinedPlane) else 0
        off = IfLess(barrier(fall), vague, sp.oo, off)
    return {
        "side_rate": off,
        "side_gap": barrier(plane.condition),
        "side_margin": 2 * rounding(plane.condition, known).error,
    }


_VAGUE = 2**8
"""Beyond that many roundings of gravity, those of an arrival that it causes are small beside its
time."""


def vague_pull(plane: InclinedPlane, flight: Parabola) -> sp.Expr:
    """Return half the acceleration across a plane up to which its sign is not certain, m/s².

    Parameters
    ----------
    plane
        The plane.
    flight
        The motion between contacts.
    """
    size = barrier(sp.Add(*map(sp.Abs, plane.direction)))
    return barrier(_VAGUE * UNIT_ROUNDOFF * barrier(size * flight.strength))
