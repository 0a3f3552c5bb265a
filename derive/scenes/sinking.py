"""When a ball that flies through air can never meet anything again.

Let gravity act along an axis, and u be the velocity along it. Where u = 0, its rate is the gravity
g_e less a part of the Magnus force of at most |Ω| |v|. The speed never grows beyond the larger of
the present one and sqrt(g_e / k_d), at which drag balances gravity. So if |Ω| |v| < g_e now and
|Ω|² < g_e k_d, a ball with u >= 0 moves that way for ever. It meets nothing if it is past every
surface and every end on that side (`Surface.beyond`). Without ends the time limit ends every shot.
Errors of the true ball are within what these conditions leave, or its shot is uncertain (`excess`).
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from ..events.predicates import sunk
from ..motion.air import AirFlight
from ..motion.air_series import TUBE, drag_rate, magnus_rate, piece
from ..motion.flight import has_sign
from ..symbolic.conditionals import (
    AtMost,
    Choose,
    IfLess,
    Less,
    Not,
    absolute,
    all_of,
    any_of,
    barrier,
    false,
    maximum,
)
from ..symbolic.rounding import extent, position_error, speed, velocity_error
from ..symbolic.symbols import VELOCITY
from .scene import Scene

spin_error = sp.Symbol("spin_error", nonnegative=True)
"""Bound on the error of each component of the spin, 1/s."""

ROOM = sp.Rational(1, 2**20)
"""Distance from a surface, relative to the sizes of place and scene, within which the ball is not
past it; and shares of speeds and forces that cover their errors and roundings."""


def room(scene: Scene) -> sp.Expr:
    """Return the distance within which the ball is not past a surface."""
    return barrier(ROOM * barrier(extent + sum(map(sp.Abs, scene.lengths))))


def sinks(scene: Scene) -> sp.Basic:
    """Return the condition that the ball can never meet anything again; false: it is not known."""
    flight = scene.flight
    assert isinstance(flight, AirFlight)
    along = [k for k, a in enumerate(flight.acceleration) if a != 0]
    if not scene.ends or len(along) != 1 or not has_sign(flight.acceleration[along[0]]):
        return false
    (axis,) = along
    side = 1 if flight.acceleration[axis].is_positive else -1
    past = [_past(found, room(scene)) for found in _distances(scene, axis, side)]
    if false in past:
        return false
    fall = barrier(side * flight.fall[axis])
    lift = barrier(absolute(flight.constants.lift_per_spin))
    turning = barrier(sum(map(absolute, magnus_rate)) + IfLess(0, lift, ROOM, 0))
    fastest = barrier(speed + 3 * _least_speed())
    most = (1 - ROOM) * barrier(fall)
    return all_of(
        AtMost(_least_speed(), barrier(side * VELOCITY[axis])),
        *past,
        Less(barrier(turning * fastest), most),
        any_of(Less(barrier(turning**2), barrier(most * drag_rate)), AtMost(turning, 0)),
    )


def _least_speed() -> sp.Expr:
    """Return the least speed along gravity of a ball that certainly falls."""
    return barrier(ROOM * barrier(speed + TUBE))


def excess(scene: Scene) -> sp.Expr:
    """Return by how much errors exceed what `sinks` allows for, which does not depend on them.

    They are at most `room` of the place, the least speed, and `ROOM` of the Magnus rate, 1/s.
    """
    flight = scene.flight
    assert isinstance(flight, AirFlight)
    lift = barrier(absolute(flight.constants.lift_per_spin))
    return maximum(
        barrier(position_error - room(scene)),
        barrier(velocity_error - _least_speed()),
        barrier(3 * barrier(lift * spin_error) - ROOM),
    )


def piece_end(scene: Scene) -> dict[str, sp.Basic]:
    """Return the end of a piece as an arrival, and whether the ball can never meet anything again.

    If so, the arrival is now: nothing is searched, and no time limit comes before.
    """
    never = sinks(scene)
    return {
        "time": Choose(never, 0, piece),
        "delay": sp.Integer(0),
        "arrives": Not(false),
        sunk.name: never,
    }


def _distances(scene: Scene, axis: int, side: int) -> list[tuple[sp.Expr, ...]]:
    surfaces = (*scene.surfaces, *scene.end_planes)
    return [surface.beyond(axis, side) for surface in surfaces]


def _past(distances: Sequence[sp.Expr], least: sp.Expr) -> sp.Basic:
    found = [Less(least, barrier(distance)) for distance in distances]
    return any_of(*found) if found else false
