"""What is measured of a flight: its apex, where it comes down to a height, how near the wire it is.

The distance to the ring's wire, of the centre, is the root of

    G = (rho - R_H)² + z²,    G'' = 2 V² + 2 (vz² + 2 g z) - 6 g z - 2 R_H L²/rho³,

with the constants of `ring.py`. On an interval of time it is bounded from below in two ways: by the
ranges of rho and z, and, with -G'' <= M, by the parabola through its middle. Where M is negative,
G has at most one minimum.
"""

from __future__ import annotations

import sympy as sp

from ..flight.parabola import Parabola
from ..ground.choice import IfLess, hold, hold_all, largest, size, smallest
from ..ground.symbols import POSITION, UNIT_ROUNDOFF, VELOCITY, t
from ..search.events import leaving
from ..search.plane import plane_arrival
from ..surfaces import Plane, Ring

level = sp.Symbol("level", real=True)
"""Height of a horizontal plane above the ring's, m."""
half = sp.Symbol("half", nonnegative=True)
"""Half the width of an interval of time, s."""
place_x, place_y = sp.symbols("place_x place_y", real=True)
"""From where on the floor plan the ring's centre is looked at, m."""

ARGUMENTS = (level, half, place_x, place_y)

RESOLUTION = 64 * UNIT_ROUNDOFF
"""Of distances along a flight, relative to its size: no more than 8 roundings meet in one, each of
the coordinates' size, and twice that is a margin in bounds; the rest keeps searches short."""


def descent(flight: Parabola) -> dict[str, sp.Expr]:
    """Return when the centre comes down to a height, and its upward velocity then."""
    plane = Plane("level", direction=(0, 0, 1), offset=level, reach=sp.Integer(0))
    arrival = plane_arrival(plane, flight)
    return {
        name: arrival[part].subs(leaving, 0) for name, part in (("time", "time"), ("vz", "rate"))
    }


def apex(flight: Parabola) -> dict[str, sp.Expr]:
    """Return when the centre is highest, and its height then; at once if it is falling."""
    gravity, (_, _, z), (_, _, vz) = flight.strength, POSITION, VELOCITY
    return {
        "time": IfLess(0, vz, vz / gravity, 0),
        "height": IfLess(0, vz, z + vz**2 / (2 * gravity), z),
    }


def sighted() -> dict[str, sp.Expr]:
    """Return how far a point is past the centre and to the left, as seen from the place."""
    x, y, _ = POSITION
    away = hold(sp.sqrt(hold(place_x**2 + place_y**2)))
    return {
        "past": -hold(place_x * x + place_y * y) / away,
        "left": hold(place_y * x - place_x * y) / away,
    }


def nearness(ring: Ring, flight: Parabola) -> dict[str, sp.Expr]:
    """Return the ball's distance from the wire at time t, and bounds within `half` of t.

    `gap` is the distance, `rate` G', `lower` a bound on the distance that holds but for
    `resolution`, and `concavity` M, infinite if the interval comes within rounding of the axis.
    """
    x, y, z = POSITION
    vx, vy, vz = VELOCITY
    gravity, begin, end = flight.strength, hold(t - half), hold(t + half)

    def away(time: sp.Expr) -> sp.Expr:
        return hold(sp.sqrt(hold(hold(x + vx * time) ** 2 + hold(y + vy * time) ** 2)))

    def height(time: sp.Expr) -> sp.Expr:
        return hold(flight.at(time)[0][2])

    def within(time: sp.Expr) -> sp.Expr:
        return hold(largest(begin, smallest(end, time)))

    square = hold(vx**2 + vy**2)
    resolution = hold(RESOLUTION * hold(_furthest(end, gravity) + ring.ring_radius))
    # Both rho and -z are convex in time.
    inner = away(within(hold(-hold(x * vx + y * vy) / square)))
    outer = hold(largest(away(begin), away(end)))
    top = height(within(hold(vz / gravity)))
    bottom = hold(smallest(height(begin), height(end)))
    aside = largest(0, hold(inner - ring.ring_radius), hold(ring.ring_radius - outer))
    above = largest(0, bottom, -top)
    by_ranges = hold(hold(aside) ** 2 + hold(above) ** 2)
    safe = hold(inner - resolution)
    swing = hold(2 * ring.ring_radius * hold(x * vy - y * vx) ** 2)
    energy = hold(hold(square + vz**2) + 2 * gravity * z)
    concavity = IfLess(0, safe, hold(6 * gravity * top - 2 * energy) + swing / safe**3, sp.oo)
    there, moving = map(hold_all, flight.at())
    rho = away(t)
    outward = hold(hold(there[0] * vx + there[1] * vy) / rho)
    rate = hold(2 * hold(hold(rho - ring.ring_radius) * outward + there[2] * moving[2]))
    here = hold(hold(rho - ring.ring_radius) ** 2 + there[2] ** 2)
    by_parabola = hold(here - half * hold(size(rate) + half * largest(0, concavity) / 2))
    return {
        "gap": sp.sqrt(here) - hold(ring.reach),
        "rate": rate,
        "lower": sp.sqrt(largest(by_ranges, by_parabola)) - hold(ring.reach),
        "concavity": concavity,
        "resolution": resolution,
    }


def _furthest(end: sp.Expr, gravity: sp.Expr) -> sp.Expr:
    """Return a bound on every coordinate up to a time."""
    speeds = hold(sp.Add(*map(sp.Abs, VELOCITY)) + gravity * end)
    return hold(sp.Add(*map(sp.Abs, POSITION)) + end * speeds)
