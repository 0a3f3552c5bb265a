"""The passage of a ball through a ring in a piece of a flight through air.

The height z is a polynomial of time in which no root has a closed form. While the air's force is
less than the weight, z'' <= -b < 0: z passes the ring's plane upwards at most once in a piece, then
downwards at most once. Each passing is the root of a parabola through both ends of the piece,
improved by Newton's method. With r the height that is left there, and e a bound on the errors of z,
the true passing is within sqrt(8 (|r| + e)/b) of the computed one.

A ball cannot be at the edge of the disc, since the wire is there, so that the place of a passing
need not be known well. Most pieces are far from the plane; then nothing is computed.
"""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from ..motion.air import AirFlight
from ..motion.air_series import VELOCITIES, magnus_rate, piece_acceleration, piece_speed
from ..motion.flight import divisor
from ..symbolic.conditionals import (
    And,
    AtMost,
    Choose,
    IfLess,
    Less,
    Not,
    Or,
    absolute,
    all_of,
    any_of,
    barrier,
    maximum,
    minimum,
)
from ..symbolic.polynomials import horner
from ..symbolic.rounding import ROUNDING_SLACK, position_error
from ..symbolic.symbols import POSITION, VELOCITY, t

x, y, z = POSITION
vz = VELOCITY[2]

NEWTON_STEPS = 3
"""Steps of Newton's method from the root of the parabola, which is within some millimetres."""

APEX_STEPS = 4
"""Steps towards the apex, each with the parabola's second derivative in place of the true one."""

end_height, half_bend, apex_time, apex_height, apex_climb = sp.symbols(
    "end_height half_bend apex_time apex_height apex_climb", real=True
)
"""z at time t; half the second derivative of the parabola through both ends; the time of the apex
within the piece; z and its rate then."""

rise_time, fall_time, rise_height, fall_height, rise_away, fall_away = sp.symbols(
    "rise_time fall_time rise_height fall_height rise_away fall_away", real=True
)
"""Times of the passings upwards and downwards, what is left of z there, and squared distances from
the axis."""

SYMBOLS = (
    *(end_height, half_bend, apex_time, apex_height, apex_climb),
    *(rise_time, fall_time, rise_height, fall_height, rise_away, fall_away),
)
"""The symbols that the kernels of this module pass to one another."""

KERNELS = (
    "passing_apex",
    *("passing_apex_step",) * APEX_STEPS,
    "passing_parabola",
    *("passing_step",) * NEWTON_STEPS,
    "passing_places",
)
"""The kernels that find the passings of a piece that comes near the plane, in order."""

_ARCH = all_of(Less(z, 0), Less(end_height, 0), Less(0, vz), Less(0, apex_height))
"""The condition that the ball is below the plane at both ends and above it in between."""

RISES = any_of(_ARCH, And(Less(z, 0), AtMost(0, end_height)))
"""The condition that the ball passes the plane upwards."""

FALLS = any_of(_ARCH, And(Less(end_height, 0), AtMost(0, z)))
"""The condition that the ball passes the plane downwards."""

Formula = tuple[Mapping[str, sp.Basic], str, str]
"""Outputs, summary and source of a kernel."""


def formulas(flight: AirFlight) -> dict[str, Formula]:
    """Return the kernels that find the passings of the plane in a piece, up to time t."""
    parabola = "a parabola through both ends of the piece"
    return {
        "passing_near": (
            {"near_disc": _near(flight)},
            "Whether a piece of a flight may come to the ring's plane.",
            "what a piece is off its chord",
        ),
        "passing_apex": (
            _apex(flight),
            "Height at the end of a piece, and the apex of the parabola through its ends.",
            parabola,
        ),
        "passing_apex_step": (
            {apex_time.name: _within(apex_time + barrier(_climb(apex_time) * _per_bend()))},
            "The apex of a piece after a step of the method of chords.",
            flight.source,
        ),
        "passing_parabola": (
            _parabola(flight),
            "Height and climb at the apex, and the passings of the parabola.",
            parabola,
        ),
        "passing_step": (
            {
                rise_time.name: _beside(-1, _improved(flight, rise_time)),
                fall_time.name: _beside(1, _improved(flight, fall_time)),
            },
            "The passings after a step of Newton's method.",
            flight.source,
        ),
        "passing_places": (
            {
                rise_height.name: _height(flight, rise_time),
                fall_height.name: _height(flight, fall_time),
                rise_away.name: _away(flight, rise_time),
                fall_away.name: _away(flight, fall_time),
            },
            "What is left of z at the passings, and their squared distances from the axis.",
            flight.source,
        ),
    }


def _height(flight: AirFlight, time: sp.Expr) -> sp.Expr:
    return barrier(horner(flight.path[z], time))


def _climb(time: sp.Expr) -> sp.Expr:
    return barrier(horner([v[2] for v in VELOCITIES], time))


def _away(flight: AirFlight, time: sp.Expr) -> sp.Expr:
    across = (barrier(horner(flight.path[axis], time)) for axis in (x, y))
    return barrier(sum(c**2 for c in across))


def _within(time: sp.Expr) -> sp.Expr:
    return barrier(minimum(t, maximum(0, barrier(time))))


def _beside(side: int, time: sp.Expr) -> sp.Expr:
    """Return a time within the piece: after the apex, or before it."""
    return barrier((maximum if side > 0 else minimum)(apex_time, _within(time)))


def _per_bend() -> sp.Expr:
    return barrier(1 / divisor(barrier(-2 * half_bend)))


def _error(flight: AirFlight) -> sp.Expr:
    there, _ = flight.rounding(t)
    return barrier(ROUNDING_SLACK * there.error)


def _near(flight: AirFlight) -> sp.Basic:
    """Return whether the ball may come to the plane: a path is off its chord by a t²/8 at most."""
    end = _height(flight, t)
    least = minimum(absolute(z), absolute(end))
    bulge = barrier(piece_acceleration * t**2 / 8)
    alike = Or(And(Less(z, 0), Less(end, 0)), And(Less(0, z), Less(0, end)))
    return Not(And(alike, Less(barrier(bulge + 2 * _error(flight)), least)))


def _apex(flight: AirFlight) -> dict[str, sp.Basic]:
    end = _height(flight, t)
    rise = barrier(barrier(end - z) - barrier(vz * t))
    half = barrier(rise / divisor(barrier(t**2)))
    return {
        end_height.name: end,
        half_bend.name: half,
        apex_time.name: _within(vz * barrier(1 / divisor(barrier(-2 * half)))),
    }


def _parabola(flight: AirFlight) -> dict[str, sp.Basic]:
    root = barrier(sp.sqrt(maximum(0, barrier(vz**2 - 4 * barrier(half_bend * z)))))
    return {
        apex_height.name: _height(flight, apex_time),
        apex_climb.name: _climb(apex_time),
        rise_time.name: _beside(-1, barrier(vz - root) * _per_bend()),
        fall_time.name: _beside(1, barrier(vz + root) * _per_bend()),
    }


def _improved(flight: AirFlight, time: sp.Expr) -> sp.Expr:
    climb = _climb(time)
    step = barrier(_height(flight, time) / divisor(absolute(climb)))
    return barrier(time - IfLess(climb, 0, -step, step))


def undecided(flight: AirFlight, radius: sp.Expr) -> sp.Basic:
    """Return the condition that the passings of a disc of that radius are undecided.

    Parameters
    ----------
    flight
        The motion between contacts, in pieces.
    radius
        The radius of the disc, m.
    """
    error = _error(flight)
    _, moving = flight.rounding(t)
    weight = barrier(absolute(flight.fall[2]))
    turning = barrier(barrier(sum(map(absolute, magnus_rate))) * piece_speed)
    forces = barrier(flight.resistance(piece_speed) + turning)
    least = barrier(weight * (1 - sp.Rational(1, 2**20)) - forces)
    per = barrier(1 / divisor(least))
    speed = barrier(absolute(apex_climb) + moving.error)
    inside = And(Less(0, apex_time), Less(apex_time, t))
    # By so much the apex, and the height there, are off.
    astray = barrier(Choose(inside, barrier(speed * per), 0))
    off = barrier(error + barrier(speed * astray))

    def slack(height: sp.Expr) -> sp.Expr:
        left = barrier(absolute(height) + off)
        late = barrier(sp.sqrt(barrier(8 * barrier(left * per))) + astray)
        return barrier(ROUNDING_SLACK * barrier(error + piece_speed * late))

    rise, fall = (barrier(sp.sqrt(squared)) for squared in (rise_away, fall_away))
    rise_slack, fall_slack = slack(rise_height), slack(fall_height)
    nearest = minimum(barrier(rise - rise_slack), barrier(fall - fall_slack))
    starts = all_of(Less(0, position_error), AtMost(absolute(z), position_error))
    stops = AtMost(absolute(end_height), off)
    turns = all_of(Less(z, 0), Less(end_height, 0), AtMost(absolute(apex_height), off))
    way = barrier(piece_speed * t)
    begun = barrier(sp.sqrt(barrier(x**2 + y**2)))
    return any_of(
        And(Not(Less(0, least)), AtMost(barrier(begun - barrier(way + error)), radius)),
        And(any_of(starts, stops, turns), AtMost(nearest, radius)),
        And(RISES, AtMost(absolute(barrier(rise - radius)), rise_slack)),
        And(FALLS, AtMost(absolute(barrier(fall - radius)), fall_slack)),
    )
