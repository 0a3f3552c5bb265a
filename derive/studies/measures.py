"""Measures of a flight: its apex, its descent to a height, its distance from the wire.

The distance of the centre from the ring's wire is the root of

    G = (rho - R_H)² + z²,    G'' = 2 V² + 2 (vz² + 2 g z) - 6 g z - 2 R_H L²/rho³,

with the constants of `events/ring/polar.py`. On an interval of time it is bounded from below in two
ways: by the ranges of rho and z, and, with -G'' <= M, by the parabola through its middle. If M is
negative, G has at most one minimum.
"""

from __future__ import annotations

import sympy as sp

from ..events.event_polynomials import leaving
from ..events.plane import plane_arrival
from ..motion.parabola import Parabola
from ..surfaces import Plane, Ring
from ..symbolic.conditionals import IfLess, absolute, barrier, barrier_all, maximum, minimum
from ..symbolic.symbols import POSITION, UNIT_ROUNDOFF, VELOCITY, t

level = sp.Symbol("level", real=True)
"""Height of a horizontal plane above the ring's, m."""
half = sp.Symbol("half", nonnegative=True)
"""Half the width of an interval of time, s."""
place_x, place_y = sp.symbols("place_x place_y", real=True)
"""Place on the floor plan from which the ring's centre is seen, m."""

ARGUMENTS = (level, half, place_x, place_y)

RESOLUTION = 64 * UNIT_ROUNDOFF
"""Resolution of distances along a flight, relative to its size: at most 8 roundings meet in one,
each of the coordinates' size; twice that is a margin in bounds, and the rest keeps searches
short."""


def descent(flight: Parabola) -> dict[str, sp.Expr]:
    """Return when the centre comes down to a height, and its upward velocity then."""
    plane = Plane("level", direction=(0, 0, 1), offset=level, reach=sp.Integer(0))
    arrival = plane_arrival(plane, flight)
    return {
        name: arrival[part].subs(leaving, 0) for name, part in (("time", "time"), ("vz", "rate"))
    }


def apex(flight: Parabola) -> dict[str, sp.Expr]:
    """Return the time and the height of the highest point; a falling ball is there at once."""
    gravity, (_, _, z), (_, _, vz) = flight.strength, POSITION, VELOCITY
    return {
        "time": IfLess(0, vz, vz / gravity, 0),
        "height": IfLess(0, vz, z + vz**2 / (2 * gravity), z),
    }


def line_of_sight() -> dict[str, sp.Expr]:
    """Return the distances of a point past the centre and to the left, as seen from the place."""
    x, y, _ = POSITION
    away = barrier(sp.sqrt(barrier(place_x**2 + place_y**2)))
    return {
        "past": -barrier(place_x * x + place_y * y) / away,
        "left": barrier(place_y * x - place_x * y) / away,
    }


def nearness(ring: Ring, flight: Parabola) -> dict[str, sp.Expr]:
    """Return the ball's distance from the wire at time t, and bounds within `half` of t.

    `gap` is the distance, `rate` G', `lower` a bound on the distance but for `resolution`, and
    `concavity` M, infinite if the interval comes within rounding of the axis.

    Parameters
    ----------
    ring
        The ring whose wire is meant.
    flight
        The motion between contacts, a parabola along -z.

    Returns
    -------
    dict
        `gap`, m; `rate`, m/s; `lower`, m; `concavity`, m/s²; and `resolution`, m.
    """
    x, y, z = POSITION
    vx, vy, vz = VELOCITY
    gravity, begin, end = flight.strength, barrier(t - half), barrier(t + half)

    def away(time: sp.Expr) -> sp.Expr:
        return barrier(sp.sqrt(barrier(barrier(x + vx * time) ** 2 + barrier(y + vy * time) ** 2)))

    def height(time: sp.Expr) -> sp.Expr:
        return barrier(flight.at(time)[0][2])

    def within(time: sp.Expr) -> sp.Expr:
        return barrier(maximum(begin, minimum(end, time)))

    square = barrier(vx**2 + vy**2)
    resolution = barrier(RESOLUTION * barrier(_furthest(end, gravity) + ring.ring_radius))
    # Both rho and -z are convex in time.
    inner = away(within(barrier(-barrier(x * vx + y * vy) / square)))
    outer = barrier(maximum(away(begin), away(end)))
    top = height(within(barrier(vz / gravity)))
    bottom = barrier(minimum(height(begin), height(end)))
    aside = maximum(0, barrier(inner - ring.ring_radius), barrier(ring.ring_radius - outer))
    above = maximum(0, bottom, -top)
    by_ranges = barrier(barrier(aside) ** 2 + barrier(above) ** 2)
    safe = barrier(inner - resolution)
    swing = barrier(2 * ring.ring_radius * barrier(x * vy - y * vx) ** 2)
    energy = barrier(barrier(square + vz**2) + 2 * gravity * z)
    concavity = IfLess(0, safe, barrier(6 * gravity * top - 2 * energy) + swing / safe**3, sp.oo)
    there, moving = map(barrier_all, flight.at())
    rho = away(t)
    outward = barrier(barrier(there[0] * vx + there[1] * vy) / rho)
    rate = barrier(2 * barrier(barrier(rho - ring.ring_radius) * outward + there[2] * moving[2]))
    here = barrier(barrier(rho - ring.ring_radius) ** 2 + there[2] ** 2)
    by_parabola = barrier(here - half * barrier(absolute(rate) + half * maximum(0, concavity) / 2))
    return {
        "gap": sp.sqrt(here) - barrier(ring.reach),
        "rate": rate,
        "lower": sp.sqrt(maximum(by_ranges, by_parabola)) - barrier(ring.reach),
        "concavity": concavity,
        "resolution": resolution,
    }


def _furthest(end: sp.Expr, gravity: sp.Expr) -> sp.Expr:
    """Return a bound on every coordinate up to a time."""
    speeds = barrier(sp.Add(*map(sp.Abs, VELOCITY)) + gravity * end)
    return barrier(sp.Add(*map(sp.Abs, POSITION)) + end * speeds)
