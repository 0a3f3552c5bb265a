"""The decisions of the loop itself: each is a kernel, so that it stands once for every target.

Numbers that count or name something (surfaces, contacts, outcomes) are doubles like all others.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import sympy as sp

from ..errors.tangent import clock, clock_error, contacts, dx, late, shift, time_error
from ..ground.choice import (
    AtMost,
    Choose,
    Either,
    Equal,
    Less,
    Not,
    Nowhere,
    Truth,
    every,
    hold,
    largest,
    size,
)
from ..ground.kernel import Kernel, decision
from ..ground.number_range import MAX_SIZE
from ..ground.rounding import position_error, velocity_error
from ..ground.symbols import STATE, UNIT_ROUNDOFF
from ..search import decisions as searching
from ..search.decisions import delay, doubt, excess, index, last, unsure, when, which
from .fields import CLAIMS, IN_FLIGHT, NONE

first, body, reached, outcome, most_contacts, claims, count, valid, uncertain = sp.symbols(
    "first body reached outcome most_contacts claims count valid uncertain", real=True
)
"""The bodies touched first and now; the outcome of an event that ends the shot; and what the
caller gives."""
time_limit = sp.Symbol("time_limit", nonnegative=True)
"""Time since the release at which a shot ends, s; infinite: it does not."""
ends, edge, touches, in_range, permitted = map(
    Truth, ("ends", "edge", "touches", "in_range", "permitted")
)

_bounded = every(Less(position_error, sp.oo), Less(velocity_error, sp.oo), AtMost(excess, 0))


def body_of(faces: Sequence[int], gates: int) -> sp.Expr:
    """Return the body that a surface belongs to; ends, which are none, come after them all."""
    if list(faces) == list(range(len(faces))) and gates < 2:
        return which
    found: sp.Expr = sp.Integer(max(faces, default=-1) + 1)
    for face, own in enumerate(faces):
        found = Choose(Equal(which, face), own, found)
    return Choose(Less(which, 0), NONE, found)


def kernels(
    faces: Sequence[int], outcomes: Mapping[str, int], gates: int, single: bool
) -> dict[str, Kernel]:
    """Return the decisions of a scene.

    Parameters
    ----------
    faces
        The bodies that its surfaces belong to.
    outcomes
        The number of each outcome, by name.
    gates
        How many planes end a shot.
    single
        Whether errors are carried in single precision.
    """
    own = (*_of_scene(faces, outcomes, gates), *_of_errors(single))
    return searching.KERNELS | KERNELS | {kernel.name: kernel for kernel in own}


def _of_scene(faces: Sequence[int], outcomes: Mapping[str, int], gates: int) -> tuple[Kernel, ...]:
    bodies = max(faces, default=-1) + 1
    timed = Equal(which, index)
    capped = Choose(AtMost(most_contacts, contacts + 1), outcomes["capped"], IN_FLIGHT)
    startable = Choose(every(permitted, in_range, Less(0, valid)), IN_FLIGHT, outcomes["invalid"])
    return (
        decision("body_of", {"body": body_of(faces, gates)}, "The body that the event is on."),
        decision(
            "admitted",
            {
                "outcome": startable,
                "uncertain": Choose(every(permitted, in_range, Less(0, doubt)), 1, 0),
            },
            "Whether a shot can start, and whether that is in doubt.",
        ),
        decision("expiry", expiry(open_ended=not gates), "The time limit, taken for an arrival."),
        decision(
            "departed",
            {
                "stays": Less(which, 0),
                "moves": Not(Less(which, 0)),
                "ends": AtMost(index, which),
                "touches": every(Not(Less(which, 0)), Less(which, index)),
                "reached": outcomes["short"],
                "edge": Nowhere(),
            },
            "Whether there is no event, an end, or a contact.",
        ),
        decision(
            "expired",
            {
                "clock": Choose(timed, time_limit, clock),
                "body": Choose(timed, bodies, body),
                "reached": Choose(timed, outcomes["endless"], reached),
                "ends": every(ends, Not(timed)),
            },
            "What a shot ends with that the time limit ends.",
        ),
        decision(
            "accounted",
            {
                "contacts": Choose(touches, contacts + 1, contacts),
                "outcome": Choose(touches, capped, reached),
            },
            "How many contacts there were, and whether the shot ends and how.",
        ),
    )


def _of_errors(single: bool) -> tuple[Kernel, ...]:
    return (
        decision(
            "delayed",
            {"clock_error": clock_error + delay},
            "The error of the event's time.",
            single,
        ),
        decision(
            "closing",
            {
                "closed": every(Less(0, claims), AtMost(0, outcome)),
                **dict.fromkeys(CLAIMS, sp.Integer(0)),
            },
            "Where a shot has ended whose errors are asked for; no other one claims any.",
            single,
        ),
        decision(
            "floored",
            {s.name: Choose(Less(size(s), shift), shift, s) for s in dx},
            "Errors of the position at the end, not below what one flight can make.",
            single,
        ),
        decision(
            "unturned",
            {"dnx": 0, "dny": 0, "dnz": 0, "turn": 0},
            "A normal without error.",
            single,
        ),
    )


def expiry(open_ended: bool) -> dict[str, sp.Basic]:
    """Return the time limit as an arrival: how long the ball flies until then.

    Where there are ends, a ball that meets nothing any more can reach none of them, and ends so;
    the limit ends others. Whether it meets something is then in doubt if its earliest arrival is.
    """
    found = {
        "time": largest(0, hold(time_limit - clock)),
        "delay": time_error + 4 * UNIT_ROUNDOFF * time_limit,
    }
    if open_ended:
        return found | {"arrives": Less(time_limit, sp.oo)}
    vague = every(Not(Less(when + late, doubt)), Less(doubt, sp.oo))
    return found | {"arrives": AtMost(0, which), "doubt": Choose(vague, 0, doubt)}


KERNELS = {
    kernel.name: kernel
    for kernel in (
        decision(
            "state_in_range",
            {"in_range": every(*(AtMost(size(s), MAX_SIZE) for s in STATE))},
            "Where no number of a release is so large that arithmetic with it could overflow.",
        ),
        decision(
            "opening",
            {"when": sp.oo, "which": NONE, "late": 0, "doubt": Choose(_bounded, sp.oo, 0)},
            "No arrival yet; nothing is certain where the errors are not bounded.",
        ),
        decision(
            "limited",
            {"limited": Less(time_limit, sp.oo)},
            "Whether there is a time limit.",
        ),
        decision("ticked", {"clock": clock + when}, "The time of the event."),
        decision(
            "doubted",
            {
                "uncertain": Choose(
                    Either(
                        every(Not(Less(when + late, doubt)), Less(doubt, sp.oo)),
                        edge,
                    ),
                    1,
                    uncertain,
                )
            },
            "1 where a decision up to this event, or which end it is, lies within its error.",
        ),
        decision(
            "meeting",
            {"meeting": Either(touches, every(ends, Less(0, claims)))},
            "Where an event changes the ball, or its errors are asked for.",
        ),
        decision("here", {"here": Equal(which, index)}, "Whether the event is on a surface."),
        decision("counted", {"count": count + 1}, "One more contact."),
        decision("elsewhere", {"curving": sp.oo}, "A ball that meets another surface."),
        decision(
            "again",
            {"again": every(Equal(which, index), Equal(last, which))},
            "Whether the ball meets the surface that it touched last.",
        ),
        decision(
            "touched",
            {"first": Choose(Less(first, 0), body, first), "last": which},
            "The surfaces that were touched first and last.",
        ),
        decision(
            "timed",
            {"timed": every(Equal(which, index), Less(0, claims))},
            "Where a shot has ended at the time limit whose errors are asked for.",
        ),
        decision(
            "undecided",
            {"uncertain": Choose(unsure, 1, uncertain)},
            "1 where a decision within a contact lies within its error.",
        ),
    )
}
