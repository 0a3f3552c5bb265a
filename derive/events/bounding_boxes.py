"""Bounding boxes: which of many bodies a flight can reach at all.

Until its horizon the true ball is within a box that is computed once from the path and all errors.
The contacts with a surface are in another box, of half sizes h about c. The two are disjoint if
along some axis, with a centre m and a half size r of the flight's box,

    |c - m| > (1 + W) (h + r).

The roundings of c, of h, of the difference and of the sum are a few u of |c - m|, of h, of r and of
|m|. W is far above that: m is no larger than the flight, of which r contains a share W already.

Adjacent bodies share a group's box, so that a flight can be apart from all of them at once. With
the smallest and the largest of their c, and the largest of their h, that is so if

    min c - m > (1 + W) max h + r   or   m - max c > (1 + W) max h + r.

Rounding is monotone: if this test holds in floating point, so does the test of each body above, and
skipping the group cannot change a result.

The contacts with a body that is a box fill a box with round edges: with half sides s, a flight is
also apart from it if the two boxes are further apart than the ball's radius, that is, for

    d = |c - m| - (1 + W) (s + r)   along each axis, or zero if that is less,

if Σ d² > (1 + W) R_B². Two boxes, of the first and the second half of the flight, enclose a flight
over the body more tightly. In each half, q long and beginning with the velocity v, the ball moves
by v q + a q²/2; its distance from the chord, against a, is at most a q²/8. So the centre of the box
is a q²/16 off that of the chord, and its half size is |v q + a q²/2| / 2 + |a| q²/16.

A plate is large across one axis, and the planes of its two faces there are test enough, if a flight
has no acceleration along that axis. The ball's coordinate is then between those at the start and
at the end of the flight, and at a contact within R_B of the plate's. So a flight is apart from the
plate if the smaller of its ends exceeds the upper face by more than R_B + s, or the larger one is
as far below the lower face. Here s is the error of the path, p + v T + W X with X the size of the
flight, of which the roundings of all of this are a tiny part.

**Lemma (apart).** Let the places of a body's faces be inputs, or sums of two. If one of these tests
has the body apart from a flight, or from a half of it, the true ball does not meet it until the
horizon, or in that half.

*Proof.* By the lemma "flight" (`motion/parabola.py`) a coordinate of the true ball is within p + v
T + 4 u X of that of the computed state without roundings, which is between both ends, or one end
and the apex, or within a q²/8 of the chord of a half; a half lasts horizon/2 exactly. As computed
these are off by less than 8 u (X + r), and r has W (X + r) = 2^23 u (X + r) besides p + v T. So the
true ball is within r of m, less 2^22 u (X + r).

c, h and s are means and differences of these, with R_B: with them the differences and sums are off
by less than 8 u (|c - m| + |m| + h + r), and |m| <= X + r. If |c - m| > (1 + W) (h + r) as
computed, it exceeds h and the distance of the true ball from m along that axis, and at a contact
the ball is within h of c. d as computed is at most 1 + 8 u times the distance between the boxes of
half sizes s and r, and W R_B² is more than the roundings of Σ d²: so at no time has the true ball
Σ e² = R_B² (`surfaces/box.py`). A plate is met within R_B of its planes alone, between which and
the two ends is more than s. If the earliest arrival may be later than the horizon, r and s are
infinite, and no body is apart. ∎
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from ..motion.air import AirFlight
from ..motion.flight import Flight, has_sign
from ..motion.parabola import Parabola
from ..surfaces import Box, Surface
from ..symbolic.conditionals import (
    Boolean,
    IfLess,
    Less,
    Not,
    absolute,
    all_of,
    any_of,
    barrier,
    maximum,
    minimum,
)
from ..symbolic.error_terms import earliest_delay
from ..symbolic.rounding import position_error, velocity_error
from ..symbolic.symbols import POSITION, VELOCITY
from .event_polynomials import horizon
from .predicates import pad

RELATIVE_SLACK = sp.Rational(1, 2**30)
"""W."""

BOX_CENTRES = sp.symbols("middle_x middle_y middle_z", real=True)
"""The centre of a flight's box; its half sizes times 1 + W."""
HALF_SIZES = sp.symbols("reach_x reach_y reach_z", real=True)
"""The centre of a flight's box; its half sizes times 1 + W."""


LATER_BOX_CENTRES = sp.symbols("later_middle_x later_middle_y later_middle_z", real=True)
"""Centre and half sizes of the box of the second half of a flight."""
LATER_HALF_SIZES = sp.symbols("later_reach_x later_reach_y later_reach_z", real=True)
"""Centre and half sizes of the box of the second half of a flight."""

HALVES_NEAR = (Boolean("first_near"), Boolean("later_near"))
"""True if the first, and the second, half of a flight may reach a surface."""

NEGATED_MINIMA = sp.symbols("least_x least_y least_z", real=True)
"""The largest of -c, of c, and of (1 + W) h in a group."""
MAXIMA = sp.symbols("most_x most_y most_z", real=True)
MAX_HALF_SIZES = sp.symbols("wide_x wide_y wide_z", real=True)
"""The largest of -c, of c, and of (1 + W) h in a group."""


def piece_box(flight: AirFlight) -> dict[str, sp.Expr]:
    """Return a box that the ball is in until the horizon, in a piece of its flight."""
    there, _ = flight.rounding(horizon)
    slack = barrier(there.error + RELATIVE_SLACK * there.magnitude)
    slack = barrier(IfLess(pad, earliest_delay, sp.oo, slack))
    outputs = {}
    for k, (middle, reach) in enumerate(flight.enclosure(horizon)):
        outputs[BOX_CENTRES[k].name] = middle
        outputs[HALF_SIZES[k].name] = (1 + RELATIVE_SLACK) * barrier(reach + slack)
    return outputs


def flight_box(flight: Parabola) -> dict[str, sp.Expr]:
    """Return a box that the ball is in until the horizon.

    Against gravity the ball is at most v²/2g above its start, and lowest at an end. If the earliest
    arrival may be later than the horizon, the box is infinite.
    """
    slack = path_slack(flight)
    middles, reaches = {}, {}
    for k, (place, v, a) in enumerate(zip(POSITION, VELOCITY, flight.acceleration, strict=True)):
        there = barrier(place + barrier(v + a * horizon / 2) * horizon)
        low, high = barrier(minimum(place, there)), barrier(maximum(place, there))
        if a != 0:
            known = a if has_sign(a) else barrier(IfLess(0, absolute(a), a, 1))
            apex = barrier(place - v**2 / (2 * known))
            turned = barrier(_turned(a, v, apex, place))
            low, high = barrier(minimum(low, turned)), barrier(maximum(high, turned))
        middles[BOX_CENTRES[k].name] = barrier(low + high) / 2
        reaches[HALF_SIZES[k].name] = (1 + RELATIVE_SLACK) * barrier(
            barrier(high - low) / 2 + slack
        )
    return middles | reaches


def _turned(a: sp.Expr, v: sp.Expr, apex: sp.Expr, place: sp.Expr) -> sp.Expr:
    """Return the apex of a coordinate that first moves against its acceleration, else its start."""
    falling, rising = IfLess(0, v, apex, place), IfLess(v, 0, apex, place)
    if a.is_negative:
        return falling
    if a.is_positive:
        return rising
    return IfLess(0, a, rising, IfLess(a, 0, falling, place))


def path_slack(flight: Flight) -> sp.Expr:
    """Return a bound on the errors of the path.

    It is infinite if the earliest arrival may be later than the horizon.
    """
    furthest, _ = flight.size(horizon)
    shift = barrier(position_error + velocity_error * horizon + RELATIVE_SLACK * furthest)
    return barrier(IfLess(pad, earliest_delay, sp.oo, shift))


def half_flight_boxes(flight: Parabola) -> dict[str, sp.Expr]:
    """Return the boxes of the first and the second half of a flight until the horizon."""
    slack, half = path_slack(flight), barrier(horizon / 2)
    outputs: dict[str, sp.Expr] = {}
    for k, (place, v, a) in enumerate(zip(POSITION, VELOCITY, flight.acceleration, strict=True)):
        bulge = barrier(a * half**2 / 16)
        begun, swift = place, v
        for middles, reaches in ((BOX_CENTRES, HALF_SIZES), (LATER_BOX_CENTRES, LATER_HALF_SIZES)):
            moved = barrier(barrier(swift + a * half / 2) * half)
            outputs[middles[k].name] = barrier(begun + moved / 2) - bulge
            outputs[reaches[k].name] = (1 + RELATIVE_SLACK) * barrier(
                absolute(moved) / 2 + absolute(bulge) + slack
            )
            begun, swift = barrier(begun + moved), barrier(swift + a * half)
    return outputs


def _sides(surface: Surface) -> list[tuple[int, sp.Expr, sp.Expr]]:
    """Return the axes along which a surface is bounded, with centre and half size."""
    return [
        (k, barrier(centre), barrier((1 + RELATIVE_SLACK) * half))
        for k, (centre, half) in enumerate(
            zip(surface.reference_point, surface.half_sizes, strict=True)
        )
        if half is not None
    ]


def may_reach(surface: Surface) -> dict[str, sp.Basic]:
    """Return the test whether a flight may reach a surface; nothing if the surface has no box."""
    apart = _apart(surface, BOX_CENTRES, HALF_SIZES)
    return {"near": Not(any_of(*apart))} if apart else {}


def may_reach_in_halves(surface: Surface) -> dict[str, sp.Basic]:
    """Return the test whether either half of a flight may reach a surface, which has a box."""
    first = _apart(surface, BOX_CENTRES, HALF_SIZES)
    later = _apart(surface, LATER_BOX_CENTRES, LATER_HALF_SIZES)
    return {"near": Not(all_of(any_of(*first), any_of(*later)))}


def _apart(
    surface: Surface, middles: Sequence[sp.Symbol], reaches: Sequence[sp.Symbol]
) -> list[sp.Basic]:
    """Return whether the boxes of a flight and of a surface are apart along each axis."""
    return [
        Less(wide + reaches[k], absolute(centre - middles[k]))
        for k, centre, wide in _sides(surface)
    ]


def may_reach_box(box: Box) -> dict[str, sp.Basic]:
    """Return the tests whether a flight, and each half of it, may reach a box with round edges."""
    near = []
    for middles, reaches in ((BOX_CENTRES, HALF_SIZES), (LATER_BOX_CENTRES, LATER_HALF_SIZES)):
        square: sp.Expr = sp.Integer(0)
        for low, high, m, r in zip(box.low, box.high, middles, reaches, strict=True):
            side = barrier((1 + RELATIVE_SLACK) * barrier((high - low) / 2))
            between = barrier(absolute(barrier(barrier((low + high) / 2) - m)) - barrier(side + r))
            square = barrier(square + barrier(maximum(between, 0)) ** 2)
        near.append(Not(Less((1 + RELATIVE_SLACK) * barrier(box.radius**2), square)))
    halves = zip(HALVES_NEAR, near, strict=True)
    return {"near": any_of(*near)} | {half.name: test for half, test in halves}


def may_reach_plate(box: Box, axis: int, flight: Flight) -> dict[str, sp.Basic]:
    """Return the test whether a flight may reach the planes of a plate's faces.

    Parameters
    ----------
    box
        The plate.
    axis
        The axis across the faces, along which the flight has no acceleration.
    flight
        The motion between contacts.
    """
    place, low, high = box.faces[axis]
    there = barrier(place + VELOCITY[axis] * horizon)
    slack = path_slack(flight)
    above = barrier(minimum(place, there)) - barrier(high + box.radius)
    below = barrier(low - box.radius) - barrier(maximum(place, there))
    return {"near": all_of(*(Not(Less(slack, barrier(away))) for away in (above, below)))}


def body_box(surface: Surface) -> dict[str, sp.Expr]:
    """Return the numbers of which a group has the maximum, in the order of its symbols."""
    sides = _sides(surface)
    least = {NEGATED_MINIMA[k].name: -centre for k, centre, _ in sides}
    most = {MAXIMA[k].name: centre for k, centre, _ in sides}
    return least | most | {MAX_HALF_SIZES[k].name: wide for k, _, wide in sides}


def may_reach_group(surface: Surface) -> dict[str, sp.Basic]:
    """Return the test whether a flight may reach any surface of a group."""
    apart = [
        Less(MAX_HALF_SIZES[k] + HALF_SIZES[k], away)
        for k, _, _ in _sides(surface)
        for away in (-barrier(NEGATED_MINIMA[k] + BOX_CENTRES[k]), BOX_CENTRES[k] - MAXIMA[k])
    ]
    return {"near": Not(any_of(*apart))}
