"""The growth of errors: how far a computed state can be from the true one, along the shot's path.

A vector of errors D = (dx, dv, dw) is carried from contact to contact by the derivative of flight,
contact time, normal and impact (`derivative`). At each contact it grows by the roundings of that
segment. Each rounding has the sign of the component it is added to, so that the two do not cancel.
Products of worst-case factors would grow much faster than errors do: after a few contacts D points
where errors grow most, and so does the true error. If D happens to shrink in a segment, each of its
components is raised to 1/(`MIN_GROWTH_DIVISOR` k) of what this segment, the shot's k-th, can make
of D's size in the worst case. `DECISION_FACTOR` covers the directions that D has not met.

Where balls roll, bounces become ever smaller, and an error across the surface must not count as a
delay of the next contact: with V the speed off the surface it would count |v|/V times, and D would
grow by orders of magnitude more than errors do (`errors_at_contact`).
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from ..contact.ball import Ball
from ..contact.law import Law
from ..motion.flight import Flight
from ..surfaces import Surface
from ..symbolic.conditionals import IfLess, absolute, barrier, maximum, minimum
from ..symbolic.error_terms import (
    DECISION_FACTOR,
    ERRORS,
    before_impact,
    clock,
    clock_error,
    contacts,
    curving,
    dn,
    dv,
    dw,
    dx,
    earliest_delay,
    greatest,
    left_normal,
    lifting,
    root_delay,
    shift,
    turn,
)
from ..symbolic.symbols import POSITION, UNIT_ROUNDOFF, normal, position, t, velocity
from . import derivative

REPORTED_FACTOR = 64
"""Reported bounds are this many times the carried errors. The factor is larger than that of
decisions, since a reported number must hold to its last digit while most decisions are far from
their limits, and a segment can be worse than those before it. `make exactness` tests both factors
against the judge."""

ERROR_FLOOR = sp.Rational(1, 2**100)
"""Least size of a rounding: single precision, in which errors are carried where balls do not roll,
represents hardly anything smaller. It rounds the errors themselves by 2^-24 of them, which
`DECISION_FACTOR` covers. Errors beyond its range become infinite or NaN, and then no contact is
certain. All quantities of a shot are within its range (`symbolic/number_range.py`)."""

MIN_GROWTH_DIVISOR = 8
"""Divisor of the least growth in one segment. A constant least growth would be exponential, so the
divisor is multiplied by the number of contacts."""

ARGUMENTS = (
    clock,
    clock_error,
    contacts,
    earliest_delay,
    *ERRORS,
    *dn,
    *left_normal,
    curving,
    shift,
    turn,
    lifting,
    root_delay,
)
"""Arguments of the kernels of this module, in calling order."""

_LEAST_SHARE = barrier(1 / barrier(MIN_GROWTH_DIVISOR * (1 + contacts)))
"""Share of the worst case that errors do not fall below."""


def _signed(length: sp.Expr, like: sp.Expr) -> sp.Expr:
    return IfLess(like, 0, -length, length)


def _away(error: sp.Expr, rounding: sp.Expr) -> sp.Expr:
    """Return the error, further from zero by `rounding`."""
    return error + _signed(rounding, error)


def _lifted(length: sp.Expr, floor: sp.Expr) -> sp.Expr:
    """Return the size of an error, raised to the floor."""
    return barrier(maximum(length, floor))


def _moved(flight: Flight, roundings: Sequence[sp.Expr]) -> list[sp.Expr]:
    """Return the errors of the position after a flight of time t, with its roundings."""
    places, _ = flight.along()
    shifts = zip(places, roundings, strict=True)
    return [barrier(_away(error, rounding)) for error, rounding in shifts]


def _sped(flight: Flight) -> list[sp.Expr]:
    """Return the errors of the velocity after a flight of time t, with what its path leaves out."""
    _, moving = flight.along()
    _, added = flight.added_errors()
    return moving if added == 0 else [barrier(_away(error, added)) for error in moving]


def errors_at_contact(flight: Flight, returning: bool = False) -> dict[str, sp.Expr]:
    """Return the errors at the end of a flight of time t that meets a surface there.

    Arguments of the formulas are the errors at the start of the flight, and the state and the
    normal at its end. The true contact is dt = -(n·dx)/(n·v) later; there the error lies in the
    surface.

    Parameters
    ----------
    flight
        The motion between contacts.
    returning
        True if balls can bounce ever lower on one surface. A ball that returns to a surface has the
        normal at its start in `left_normal`. Its arrival is a root of F/t, so it comes back as far
        off the surface as it began, and an offset at the start is no delay. For small bounces n·v
        goes to zero, and the offset would be nearly all of the delay.
    """
    roundings = _flight_roundings(flight)
    moved = _moved(flight, roundings)
    offset = sp.Matrix(moved).dot(normal)
    if returning:
        offset = barrier(_returning_offset(flight, roundings))
    delay = derivative.contact_delay(offset)
    # An error along the surface where the flight began lies across the surface at its end only as
    # far as the normal has turned.
    across = minimum(1, barrier(greatest(velocity) * t) * curving)
    drift = barrier(greatest(dv) * t + barrier(maximum(*roundings)))
    glancing = barrier(greatest(velocity) * absolute(derivative.per_approach()))
    drift_across, total = drift, barrier(greatest(dx) + drift)
    if returning:
        drift_across = barrier(
            greatest(dv) * t + barrier(maximum(*_returning_roundings(flight, roundings)))
        )
    worst = barrier(total + barrier(barrier(across * greatest(dx)) + drift_across) * glancing)
    places = derivative.at_contact(moved, delay)
    floor = barrier(worst * _LEAST_SHARE)
    lifts = [_signed(_lifted(absolute(value), floor), value) for value in places]
    extra: dict[str, sp.Expr] = {}
    if returning:
        # A low bounce changes errors by a small share of them, and the error of V in proportion to
        # V.
        short = sp.Rational(1, 4)
        worst = barrier(IfLess(across, short, total, worst))
        lifts = [IfLess(across, short, *both) for both in zip(places, lifts, strict=True)]
        extra["lifting"] = IfLess(across, short, sp.Rational(1, MIN_GROWTH_DIVISOR), _LEAST_SHARE)
    outputs = {str(name): value for name, value in zip(dx, lifts, strict=True)} | extra
    changes = derivative.velocity_change(flight, delay)
    sped = zip(dv, _sped(flight), changes, strict=True)
    outputs |= {str(s): error + change for s, error, change in sped}
    return outputs | {
        "delay": maximum(absolute(delay), earliest_delay / DECISION_FACTOR)
        + 4 * UNIT_ROUNDOFF * barrier(clock + t),
        "shift": worst,
    }


def flight_start(flight: Flight) -> dict[str, sp.Expr]:
    """Return the position at the start of a flight of time t, given the state at its end."""
    return {f"from_{s}": place for s, place in zip(POSITION, flight.start(), strict=True)}


def _returning_offset(flight: Flight, roundings: Sequence[sp.Expr]) -> sp.Expr:
    """Return the offset that errors cause off a surface between departure and return."""
    moved = _moved(flight, _returning_roundings(flight, roundings))
    return barrier(normal.dot(sp.Matrix(moved))) - barrier(left_normal.dot(sp.Matrix(dx)))


def _returning_roundings(flight: Flight, roundings: Sequence[sp.Expr]) -> list[sp.Expr]:
    """Return the roundings of a flight that count across the surface: on return, those of F/t.

    They are a few u of the length of the path, and as many more as the position is larger than the
    surface's radius of curvature: F/t is made of sums of such positions, times a speed. What the
    path leaves out comes with them.
    """
    wide = barrier(1 + curving * barrier(sum(map(absolute, position))))
    added = flight.returning_error()
    return [
        IfLess(curving, sp.oo, barrier(4 * UNIT_ROUNDOFF * barrier(wide * path) + added), rounding)
        for path, rounding in zip(flight.path_lengths(), roundings, strict=True)
    ]


def _flight_roundings(flight: Flight) -> list[sp.Expr]:
    """Return the rounding of each coordinate in a flight of time t, given the state at its end.

    With it comes what the path leaves out.
    """
    added, _ = flight.added_errors()
    return [
        barrier(UNIT_ROUNDOFF * barrier(absolute(place) + path) + ERROR_FLOOR + added)
        for place, path in zip(position, flight.path_lengths(), strict=True)
    ]


def errors_at_piece_end(flight: Flight) -> dict[str, sp.Expr]:
    """Return the errors at the end of a piece of a flight, of time t, from those at its start.

    The time of the end is exact, and no error of a contact counts there.
    """
    roundings = _flight_roundings(flight)
    moved = _moved(flight, roundings)
    drift = barrier(greatest(dv) * t + barrier(maximum(*roundings)))
    floor = barrier(barrier(greatest(dx) + drift) * _LEAST_SHARE)
    lifts = [_signed(_lifted(absolute(value), floor), value) for value in moved]
    values = zip((*dx, *dv), (*lifts, *_sped(flight)), strict=True)
    return {str(name): value for name, value in values}


def errors_at_time(flight: Flight) -> dict[str, sp.Expr]:
    """Return the errors at the end of a flight of time t that a time limit ends.

    Arguments of the formulas are the errors at the start, and the state at the end. The flight is
    too short or too long by the errors of the contacts' times; the time of its end is exact. The
    errors are those of the worst case in one flight, without signs, since no later flight follows.
    """
    shift_of_time = barrier(clock_error + 4 * UNIT_ROUNDOFF * barrier(clock + t))
    drift = barrier(greatest(dv) * t + barrier(maximum(*_flight_roundings(flight))))
    worst = barrier(greatest(dx) + drift)
    outputs: dict[str, sp.Expr] = {
        str(name): worst + absolute(speed) * shift_of_time
        for name, speed in zip(dx, velocity, strict=True)
    }
    changes = derivative.velocity_change(flight, shift_of_time)
    for name, error, before, change in zip(dv, _sped(flight), velocity, changes, strict=True):
        outputs[str(name)] = (
            absolute(error) + absolute(change) + 2 * UNIT_ROUNDOFF * absolute(before)
        )
    return outputs | {"clock_error": sp.Integer(0)}


def normal_error(surface: Surface) -> dict[str, sp.Expr]:
    """Return the error of a surface's normal that an error of the position causes."""
    outputs = dict(zip(map(str, dn), derivative.along_normal(surface), strict=True))
    reach = [barrier(DECISION_FACTOR * shift)] * 3
    return outputs | {"turn": shift * barrier(surface.curvature_within(reach))}


def curving_along(surface: Surface, flight: Flight) -> sp.Expr:
    """Return a bound on the rate at which the normal turns along a flight back to the surface.

    The flight has the time t, and begins and ends on the surface. It is the curvature of the part
    of the surface that is within the flight's way along each axis and the errors of the place.

    Parameters
    ----------
    surface
        The surface.
    flight
        The motion between contacts.
    """
    off = barrier(DECISION_FACTOR * barrier(greatest(dx) + greatest(dv) * t))
    return surface.curvature_within([barrier(way + off) for way in flight.path_lengths()])


def root_rounding(flight: Flight) -> dict[str, sp.Expr]:
    """Return the errors at a contact, before the impact, with what the root's arithmetic adds.

    Newton's method ends at a root of the rounded condition: it is late by `root_delay`, the error
    of the condition over its rate. It ends within 2^-49 |F'|/C besides, 16 u times R/|v| on a body
    of size R; the error of the condition is at least u R/|n·v| there, and the factors of decisions
    and of reported bounds contain the rest.
    """
    rates = zip(dx + dv, (*velocity, *flight.present_acceleration), strict=True)
    outputs = {
        str(name): _away(name, barrier(root_delay * absolute(rate)))
        for name, rate in rates
        if rate != 0
    }
    return outputs | {"shift": shift + barrier(root_delay * greatest(velocity))}


def errors_after_impact(law: Law, ball: Ball, returning: bool = False) -> dict[str, sp.Expr]:
    """Return the errors of velocity and spin after a contact, from those before it.

    Parameters
    ----------
    law
        The contact law.
    ball
        The ball.
    returning
        True if balls can bounce ever lower on one surface. Then errors of the velocity are raised
        to the floor along the surface alone: the error of the speed off it falls with that speed.
    """
    speed, worst = before_impact(ball.radius)
    outputs: dict[str, sp.Expr] = {}
    per_radius = barrier(1 / ball.radius)
    changes = derivative.along_impact(law, ball)
    for names, grown, per_length in zip((dv, dw), changes, (1, per_radius), strict=True):
        rounded = barrier(barrier(2 * UNIT_ROUNDOFF * speed + ERROR_FLOOR) * per_length)
        lengths = [barrier(absolute(one) + rounded) for one in grown]
        floor = barrier(barrier(worst * (lifting if returning else _LEAST_SHARE)) * per_length)
        lifted = [_lifted(length, floor) for length in lengths]
        lifts = [_signed(length, one) for length, one in zip(lifted, grown, strict=True)]
        if returning and names is dv:
            gained = [
                _signed(barrier(more - length), one)
                for more, length, one in zip(lifted, lengths, grown, strict=True)
            ]
            off = barrier(normal.dot(sp.Matrix(gained)))
            lifts = [more - off * n for more, n in zip(lifts, normal, strict=True)]
        outputs |= {str(name): value for name, value in zip(names, lifts, strict=True)}
    return outputs


def scaled_errors(times: int) -> dict[str, sp.Expr]:
    """Return bounds on the errors of a state and its time: the carried errors, so many times."""
    sizes = [maximum(*(absolute(e) for e in errors)) for errors in (dx, dv, dw)]
    names = ("position_error", "velocity_error", "spin_error", "time_error")
    return {name: times * s for name, s in zip(names, (*sizes, clock_error), strict=True)}
