"""When a ball that flies through air can never meet anything again.

Let gravity act along an axis, and u be the velocity along it. Where u = 0, its rate is the gravity
g_e less a part of the Magnus force of at most |Ω| |v|. The speed never grows beyond the larger of
the present one and sqrt(g_e / k_d), at which drag balances gravity. So if |Ω| |v| < g_e now and
|Ω|² < g_e k_d, a ball with u >= 0 moves that way for ever. It meets nothing if it is past every
surface and every end on that side (`Surface.beyond`). All of this must hold of the true ball, whose
velocity and spin are off by their errors.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from ..motion.air import AirFlight, drag_rate, magnus_rate
from ..motion.flight import has_sign
from ..symbolic.conditionals import AtMost, Less, absolute, all_of, any_of, barrier, false
from ..symbolic.rounding import extent, speed, velocity_error
from ..symbolic.symbols import VELOCITY
from .scene import Scene

spin_error = sp.Symbol("spin_error", nonnegative=True)
"""Bound on the error of each component of the spin, 1/s."""

ROOM = sp.Rational(1, 2**20)
"""Distance from a surface, relative to the sizes of place and scene, within which the ball is not
past it."""

FORCE_SLACK = sp.Rational(1, 2**20)
"""Share of a force that covers roundings of forces."""


def room(scene: Scene) -> sp.Expr:
    """Return the distance within which the ball is not past a surface."""
    return barrier(ROOM * barrier(extent + sum(map(sp.Abs, scene.lengths))))


def sinks(scene: Scene) -> sp.Basic:
    """Return the condition that the ball can never meet anything again; false: it is not known."""
    flight = scene.flight
    assert isinstance(flight, AirFlight)
    along = [k for k, a in enumerate(flight.acceleration) if a != 0]
    if len(along) != 1 or not has_sign(flight.acceleration[along[0]]):
        return false
    (axis,) = along
    side = 1 if flight.acceleration[axis].is_positive else -1
    past = [_past(found, room(scene)) for found in _distances(scene, axis, side)]
    if false in past:
        return false
    fall = barrier(side * flight.fall[axis])
    lift = absolute(flight.constants.lift_per_spin)
    turning = barrier(barrier(sum(map(absolute, magnus_rate))) + 3 * barrier(lift * spin_error))
    fastest = barrier(speed + 3 * velocity_error)
    return all_of(
        AtMost(velocity_error, barrier(side * VELOCITY[axis])),
        *past,
        Less(barrier(turning * fastest), (1 - FORCE_SLACK) * fall),
        any_of(
            Less(barrier(turning**2), (1 - FORCE_SLACK) * barrier(fall * drag_rate)),
            AtMost(turning, 0),
        ),
    )


def _distances(scene: Scene, axis: int, side: int) -> list[tuple[sp.Expr, ...]]:
    surfaces = (*scene.surfaces, *scene.end_planes)
    return [surface.beyond(axis, side) for surface in surfaces]


def _past(distances: Sequence[sp.Expr], least: sp.Expr) -> sp.Basic:
    found = [Less(least, barrier(distance)) for distance in distances]
    return any_of(*found) if found else false
