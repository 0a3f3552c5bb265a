"""The decisions of the event loop, each a kernel, so that every target makes them alike.

Numbers that count or name something (surfaces, contacts, outcomes) are doubles like all others.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import sympy as sp

from ..events import predicates as searching
from ..events.predicates import delay, excess, index, last, undecided, undecided_time, when, which
from ..ir.kernel import Kernel, decision
from ..state.fields import IN_FLIGHT, NONE, REPORTED_ERRORS
from ..symbolic.conditionals import (
    And,
    AtMost,
    Boolean,
    Choose,
    Equal,
    Less,
    Not,
    Or,
    absolute,
    all_of,
    barrier,
    false,
    maximum,
)
from ..symbolic.error_terms import (
    clock,
    clock_error,
    contacts,
    dv,
    dx,
    earliest_delay,
    shift,
    time_error,
)
from ..symbolic.number_range import MAX_SIZE
from ..symbolic.rounding import position_error, velocity_error
from ..symbolic.symbols import STATE, UNIT_ROUNDOFF, velocity

first, body, reached, outcome, most_contacts, claims, count, valid, uncertain = sp.symbols(
    "first body reached outcome most_contacts claims count valid uncertain", real=True
)
"""First body touched, and body of this event; outcome of an event that ends the shot; contact limit
and other numbers of the caller; validity of the start."""
tightening = sp.Symbol("tightening", nonnegative=True)
"""1 where bounds on errors are tightened, else 0."""
time_limit = sp.Symbol("time_limit", nonnegative=True)
"""Time since the release at which a shot ends, s; infinite: there is no limit."""
ends, edge, touches, in_range, permitted = map(
    Boolean, ("ends", "edge", "touches", "in_range", "permitted")
)

GOES_ON = "goes_on"
"""The variable that is true if a flight goes on with another piece."""

_OWN_ROUNDING = barrier(UNIT_ROUNDOFF / 16 * barrier(maximum(*map(absolute, velocity))))
"""A 16th of the rounding of a velocity, of which four times as much is reported: a v + a t is off
by u |v| besides the rounding of a t, which the delay of the end contains."""
_bounded = all_of(Less(position_error, sp.oo), Less(velocity_error, sp.oo), AtMost(excess, 0))


def body_of(faces: Sequence[int], end_planes: int) -> sp.Expr:
    """Return the body that a surface belongs to; an end plane has the index after the last body.

    Parameters
    ----------
    faces
        For each surface the index of its body.
    end_planes
        The number of end planes, whose indices follow those of the surfaces.
    """
    if list(faces) == list(range(len(faces))) and end_planes < 2:
        return which
    found: sp.Expr = sp.Integer(max(faces, default=-1) + 1)
    for face, own in enumerate(faces):
        found = Choose(Equal(which, face), own, found)
    return Choose(Less(which, 0), NONE, found)


def kernels(
    faces: Sequence[int],
    outcomes: Mapping[str, int],
    end_planes: int,
    single: bool,
    open_ended: bool,
) -> dict[str, Kernel]:
    """Return the decisions of a scene.

    Parameters
    ----------
    faces
        The body of each surface.
    outcomes
        The number of each outcome, by name.
    end_planes
        How many planes end a shot.
    single
        True if errors are carried in single precision.
    open_ended
        True if the time limit ends every shot.
    """
    own = (*_of_scene(faces, outcomes, end_planes, open_ended), *_of_errors(single, open_ended))
    if open_ended:  # the time limit is an arrival, too
        late = sp.Integer(1)
        own = (*own, *searching.out_of_budget(late), searching.overdue(late))
    return searching.KERNELS | KERNELS | {kernel.name: kernel for kernel in own}


def _of_scene(
    faces: Sequence[int], outcomes: Mapping[str, int], end_planes: int, open_ended: bool
) -> tuple[Kernel, ...]:
    bodies = max(faces, default=-1) + 1
    timed = Equal(which, index)
    capped = Choose(AtMost(most_contacts, contacts + 1), outcomes["capped"], IN_FLIGHT)
    startable = Choose(all_of(permitted, in_range, Less(0, valid)), IN_FLIGHT, outcomes["invalid"])
    return (
        decision("body_of", {"body": body_of(faces, end_planes)}, "Body that the event is on."),
        decision(
            "admitted",
            {
                "outcome": startable,
                "uncertain": Choose(all_of(permitted, in_range, Less(0, undecided_time)), 1, 0),
            },
            "Outcome of a shot at its start, and whether that is uncertain.",
        ),
        decision(
            "loose",
            {
                "loose": all_of(
                    Less(0, uncertain), Less(0, contacts), Not(Equal(outcome, outcomes["capped"]))
                )
            },
            "Whether a shot that has ended may be certain with tighter bounds: it is not capped.",
        ),
        decision("expiry", expiry(open_ended), "The time limit as an arrival."),
        decision(
            "departed",
            {
                "stays": Less(which, 0),
                "moves": Not(Less(which, 0)),
                "ends": AtMost(index, which),
                "touches": all_of(Not(Less(which, 0)), Less(which, index)),
                "reached": outcomes["short"],
                "edge": false,
            },
            "Whether there is no event, an end, or a contact, and the outcome without one.",
        ),
        decision(
            "expired",
            {
                "clock": Choose(timed, time_limit, clock),
                "body": Choose(timed, bodies, body),
                "reached": Choose(timed, outcomes["endless"], reached),
                "ends": all_of(ends, Not(timed)),
            },
            "Time, body and outcome of a shot that the time limit ends.",
        ),
        decision(
            "accounted",
            {
                "contacts": Choose(touches, contacts + 1, contacts),
                "outcome": Choose(touches, capped, reached),
            },
            "Number of contacts, and the outcome if the shot ends.",
        ),
    )


def _of_errors(single: bool, open_ended: bool) -> tuple[Kernel, ...]:
    floors = dict.fromkeys(dx, shift)
    if open_ended:  # gravity may be so small that a delay of the end changes no velocity
        floors |= dict.fromkeys(dv, _OWN_ROUNDING)
    return (
        decision(
            "clock_error_sum",
            {"clock_error": clock_error + delay},
            "Sum of the errors of the contacts' times.",
            single,
        ),
        decision(
            "closing",
            {
                "reports": Or(all_of(Less(0, claims), AtMost(0, outcome)), Less(1, claims)),
                **dict.fromkeys(REPORTED_ERRORS, sp.Integer(0)),
            },
            "Whether bounds on errors are wanted here, and their start values.",
            single,
        ),
        decision(
            "error_floor",
            {s.name: Choose(Less(absolute(s), least), least, s) for s, least in floors.items()},
            "Errors at the end, not below the largest that one flight can cause.",
            single,
        ),
        decision(
            "no_normal_error",
            {"dnx": 0, "dny": 0, "dnz": 0, "turn": 0},
            "Start values: a normal without error.",
            single,
        ),
    )


def expiry(open_ended: bool) -> dict[str, sp.Basic]:
    """Return the time limit as an arrival.

    In a scene with ends, the limit ends only balls that meet something again; any other ball can
    never reach an end. Whether a ball meets something is undecided if its earliest arrival is.
    """
    found = {
        "time": maximum(0, barrier(time_limit - clock)),
        "delay": time_error + 4 * UNIT_ROUNDOFF * time_limit,
    }
    if open_ended:
        return found | {"arrives": Less(time_limit, sp.oo)}
    undecided = all_of(
        Not(Less(when + earliest_delay, undecided_time)), Less(undecided_time, sp.oo)
    )
    return found | {
        "arrives": AtMost(0, which),
        "undecided_time": Choose(undecided, 0, undecided_time),
    }


KERNELS = {
    kernel.name: kernel
    for kernel in (
        decision(
            "state_in_range",
            {"in_range": all_of(*(AtMost(absolute(s), MAX_SIZE) for s in STATE))},
            "Whether all numbers of a release are small enough not to overflow.",
        ),
        decision(
            "opening",
            {
                "when": sp.oo,
                "which": NONE,
                "earliest_delay": 0,
                "undecided_time": Choose(_bounded, sp.oo, 0),
            },
            "Start values: no arrival; an uncertain shot if its errors are not bounded.",
        ),
        decision(
            "limited",
            {"limited": Less(time_limit, sp.oo)},
            "Whether there is a time limit.",
        ),
        decision("event_clock", {"clock": clock + when}, "Time of the event."),
        decision(
            "flight_undecided",
            {
                "uncertain": Choose(
                    Or(
                        all_of(
                            Not(Less(when + earliest_delay, undecided_time)),
                            Less(undecided_time, sp.oo),
                        ),
                        edge,
                    ),
                    1,
                    uncertain,
                )
            },
            "1 if a decision up to this event, or the choice of the end, lies within its error.",
        ),
        decision(
            "meeting",
            {"meeting": Or(touches, all_of(ends, Less(0, claims)))},
            "Whether an event changes the motion, or its errors are wanted.",
        ),
        decision(
            GOES_ON,
            {
                GOES_ON: Equal(which, index),
                "ends": all_of(ends, Not(Equal(which, index))),
                "reached": Choose(Equal(which, index), IN_FLIGHT, reached),
                "body": Choose(Equal(which, index), NONE, body),
            },
            "Whether the event is the end of a piece, after which the flight goes on.",
        ),
        decision(
            "sinks",
            {"which": Choose(And(Equal(which, index), searching.sunk), NONE, which)},
            "No event, if the ball can never meet anything again.",
        ),
        decision("aloft", {"last": NONE}, "The next piece of a flight begins on no surface."),
        decision("here", {"here": Equal(which, index)}, "Whether the event is on a surface."),
        decision("counted", {"count": count + 1}, "One more contact."),
        decision("elsewhere", {"curving": sp.oo}, "Start value: another surface."),
        decision(
            "without_bounds",
            {"uncertain": Choose(Boolean("unbounded"), 1, uncertain)},
            "1 if a bound on an error is not finite.",
        ),
        decision(
            "tightens",
            {
                "carries": all_of(touches, AtMost(tightening, 0)),
                "tightens": all_of(touches, Less(0, tightening)),
            },
            "How the bounds on errors are carried over a contact.",
        ),
        decision(
            "came_back",
            {"back": Choose(Equal(last, which), 1, 0)},
            "1 if the flight began on the surface that the ball meets.",
        ),
        decision(
            "again",
            {"again": all_of(Equal(which, index), Equal(last, which))},
            "Whether the ball meets the same surface again.",
        ),
        decision(
            "touched",
            {"first": Choose(Less(first, 0), body, first), "last": which},
            "Body touched first and surface touched last.",
        ),
        decision(
            "ends_by_time_limit",
            {"ends_by_time_limit": all_of(Equal(which, index), Less(0, claims))},
            "Whether a shot has ended at the time limit and its errors are wanted.",
        ),
        decision(
            "undecided",
            {"uncertain": Choose(undecided, 1, uncertain)},
            "1 if a decision within a contact lies within its error.",
        ),
    )
}
