"""Which of many bodies a flight can reach at all: boxes that do not meet.

Until its horizon the true ball is within a box, found once: as the path is, with all that is not
exact added. What of a surface can be touched is in another, of half sizes h about c. The two are
apart where along some axis, with a middle m and a half size r of the flight's,

    |c - m| > (1 + W) (h + r).

The roundings of c, of h, of the difference and of the sum are a few u of |c - m|, of h, of r and of
|m|, and W is far above that: m is no larger than the flight, of which r has a share W already.

Bodies that stand together are in one box, so that a flight may be apart from all of them at once.
With the smallest and the largest of their c, and the largest of their h, it is where

    min c - m > (1 + W) max h + r   or   m - max c > (1 + W) max h + r.

Whatever is rounded is no smaller for what is larger. So where this holds as computed, what is above
holds as computed, for each of the bodies: to leave them out changes nothing.

Of a box that the ball meets all around, with half sides s, what can be touched is round: a flight
is apart from it, too, where its box is further from that one than the ball's radius, for

    d = |c - m| - (1 + W) (s + r)   along each axis, or zero if that is less,

where Σ d² > (1 + W) R_B². A flight that goes over it is told better by two boxes, of its first and
its second half. In each, q long and beginning with the velocity v, the ball moves by v q + a q²/2;
in between it is off the chord by a q²/8 at most, against a: the box's middle is a q²/16 off the
chord's, and its half size |v q + a q²/2| / 2 + |a| q²/16.
"""

from __future__ import annotations

import sympy as sp

from ..errors.tangent import late
from ..flight.parabola import Parabola
from ..ground.choice import IfLess, Less, Not, every, hold, largest, size, smallest, some
from ..ground.rounding import position_error, velocity_error
from ..ground.symbols import POSITION, VELOCITY
from ..surfaces import Box, Surface
from .decisions import pad
from .events import horizon

SHARE = sp.Rational(1, 2**30)
"""W."""

MIDDLES = sp.symbols("middle_x middle_y middle_z", real=True)
REACHES = sp.symbols("reach_x reach_y reach_z", real=True)
"""The middle and the half sizes of a flight's box; these times 1 + W."""


LATER_MIDDLES = sp.symbols("later_middle_x later_middle_y later_middle_z", real=True)
LATER_REACHES = sp.symbols("later_reach_x later_reach_y later_reach_z", real=True)
"""The same of the second half of a flight."""

LEASTS = sp.symbols("least_x least_y least_z", real=True)
MOSTS = sp.symbols("most_x most_y most_z", real=True)
WIDES = sp.symbols("wide_x wide_y wide_z", real=True)
"""The largest of -c, of c, and of (1 + W) h among bodies."""


def swept(flight: Parabola) -> dict[str, sp.Expr]:
    """Return a box that the ball is within until the horizon.

    Against free fall it is never higher than v²/2g above its start, and lowest at an end. Where
    the earliest arrival may be later than the horizon, the box has no end.
    """
    slack = spare(flight)
    middles, reaches = {}, {}
    for k, (place, v, a) in enumerate(zip(POSITION, VELOCITY, flight.acceleration, strict=True)):
        there = hold(place + hold(v + a * horizon / 2) * horizon)
        low, high = hold(smallest(place, there)), hold(largest(place, there))
        if a != 0:
            apex = hold(place - v**2 / (2 * a))
            against = (0, v) if a.is_negative else (v, 0)
            turned = hold(IfLess(*against, apex, place))
            low, high = hold(smallest(low, turned)), hold(largest(high, turned))
        middles[MIDDLES[k].name] = hold(low + high) / 2
        reaches[REACHES[k].name] = (1 + SHARE) * hold(hold(high - low) / 2 + slack)
    return middles | reaches


def spare(flight: Parabola) -> sp.Expr:
    """Return what is not exact; endless where the earliest arrival may be after the horizon."""
    furthest, _ = flight.size(horizon)
    shift = hold(position_error + velocity_error * horizon + SHARE * furthest)
    return hold(IfLess(pad, late, sp.oo, shift))


def halved(flight: Parabola) -> dict[str, sp.Expr]:
    """Return the boxes of the first and the second half of a flight until the horizon."""
    slack, half = spare(flight), hold(horizon / 2)
    outputs: dict[str, sp.Expr] = {}
    for k, (place, v, a) in enumerate(zip(POSITION, VELOCITY, flight.acceleration, strict=True)):
        bulge = hold(a * half**2 / 16)
        begun, swift = place, v
        for middles, reaches in ((MIDDLES, REACHES), (LATER_MIDDLES, LATER_REACHES)):
            moved = hold(hold(swift + a * half / 2) * half)
            outputs[middles[k].name] = hold(begun + moved / 2) - bulge
            outputs[reaches[k].name] = (1 + SHARE) * hold(size(moved) / 2 + size(bulge) + slack)
            begun, swift = hold(begun + moved), hold(swift + a * half)
    return outputs


def _sides(surface: Surface) -> list[tuple[int, sp.Expr, sp.Expr]]:
    """Return the axes along which a surface has an end: where it is about, and how wide."""
    return [
        (k, hold(centre), hold((1 + SHARE) * half))
        for k, (centre, half) in enumerate(zip(surface.about, surface.halves, strict=True))
        if half is not None
    ]


def near(surface: Surface) -> dict[str, sp.Basic]:
    """Return where a flight may reach a surface; nothing where the surface has no box."""
    apart = [
        Less(wide + REACHES[k], size(centre - MIDDLES[k])) for k, centre, wide in _sides(surface)
    ]
    return {"near": Not(some(*apart))} if apart else {}


def near_box(box: Box) -> dict[str, sp.Basic]:
    """Return where a flight may reach a box, whose edges and corners are round to the ball."""
    apart = []
    for middles, reaches in ((MIDDLES, REACHES), (LATER_MIDDLES, LATER_REACHES)):
        square: sp.Expr = sp.Integer(0)
        for low, high, m, r in zip(box.low, box.high, middles, reaches, strict=True):
            side = hold((1 + SHARE) * hold((high - low) / 2))
            between = hold(size(hold(hold((low + high) / 2) - m)) - hold(side + r))
            square = hold(square + hold(largest(between, 0)) ** 2)
        apart.append(Less((1 + SHARE) * hold(box.radius**2), square))
    return {"near": Not(every(*apart))}


def box(surface: Surface) -> dict[str, sp.Expr]:
    """Return what a group has the largest of, in the order of its symbols."""
    sides = _sides(surface)
    least = {LEASTS[k].name: -centre for k, centre, _ in sides}
    most = {MOSTS[k].name: centre for k, centre, _ in sides}
    return least | most | {WIDES[k].name: wide for k, _, wide in sides}


def near_any(surface: Surface) -> dict[str, sp.Basic]:
    """Return where a flight may reach any surface of a group of such."""
    apart = [
        Less(WIDES[k] + REACHES[k], away)
        for k, _, _ in _sides(surface)
        for away in (-hold(LEASTS[k] + MIDDLES[k]), MIDDLES[k] - MOSTS[k])
    ]
    return {"near": Not(some(*apart))}
