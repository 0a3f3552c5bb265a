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

where Σ d² > (1 + W) R_B².
"""

from __future__ import annotations

import sympy as sp

from ..errors.tangent import late
from ..flight.parabola import Parabola
from ..ground.choice import IfLess, Less, Not, hold, largest, size, smallest, some
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


LEASTS = sp.symbols("least_x least_y least_z", real=True)
MOSTS = sp.symbols("most_x most_y most_z", real=True)
WIDES = sp.symbols("wide_x wide_y wide_z", real=True)
"""The largest of -c, of c, and of (1 + W) h among bodies."""


def swept(flight: Parabola) -> dict[str, sp.Expr]:
    """Return a box that the ball is within until the horizon.

    Against free fall it is never higher than v²/2g above its start, and lowest at an end. Where
    the earliest arrival may be later than the horizon, the box has no end.
    """
    furthest, _ = flight.size(horizon)
    shift = hold(position_error + velocity_error * horizon + SHARE * furthest)
    spare = hold(IfLess(pad, late, sp.oo, shift))
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
        reaches[REACHES[k].name] = (1 + SHARE) * hold(hold(high - low) / 2 + spare)
    return middles | reaches


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
    square: sp.Expr = sp.Integer(0)
    for k, (low, high) in enumerate(zip(box.low, box.high, strict=True)):
        side = hold((1 + SHARE) * hold((high - low) / 2))
        between = hold(size(hold(hold((low + high) / 2) - MIDDLES[k])) - hold(side + REACHES[k]))
        square = hold(square + hold(largest(between, 0)) ** 2)
    return {"near": Not(Less((1 + SHARE) * hold(box.radius**2), square))}


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
