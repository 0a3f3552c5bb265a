"""The decisions of the loop itself: each is a kernel, so that it stands once for every target.

Numbers that count or name something (surfaces, contacts, outcomes) are doubles like all others.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from ..errors.tangent import clock, clock_error, contacts, dx, late, shift
from ..ground.choice import AtMost, Choose, Either, Equal, Less, Not, Truth, every, size
from ..ground.kernel import Kernel, decision
from ..ground.rounding import position_error, velocity_error
from ..ground.symbols import STATE
from ..search import decisions as searching
from ..search.decisions import delay, doubt, excess, index, last, unsure, when, which
from .fields import IN_FLIGHT, NONE, Outcome

first, body, miss, slack, outcome, most_contacts, claims, count, valid, uncertain = sp.symbols(
    "first body miss slack outcome most_contacts claims count valid uncertain", real=True
)
"""The bodies touched first and now; how far from the target; and what the caller gives."""
ends, touches, finite, permitted = map(Truth, ("ends", "touches", "finite", "permitted"))

_bounded = every(Less(position_error, sp.oo), Less(velocity_error, sp.oo), AtMost(excess, 0))


def body_of(faces: Sequence[int]) -> sp.Expr:
    """Return the body that a surface belongs to; the end, which is none, comes after them all."""
    if list(faces) == list(range(len(faces))):
        return which
    found: sp.Expr = sp.Integer(max(faces, default=-1) + 1)
    for face, own in enumerate(faces):
        found = Choose(Equal(which, face), own, found)
    return Choose(Less(which, 0), NONE, found)


def kernels(faces: Sequence[int]) -> dict[str, Kernel]:
    """Return the decisions of a scene whose surfaces belong to those bodies."""
    named = decision("body_of", {"body": body_of(faces)}, "The body that the event is on.")
    return searching.KERNELS | KERNELS | {named.name: named}


KERNELS = {
    kernel.name: kernel
    for kernel in (
        decision(
            "admitted",
            {
                "outcome": Choose(
                    every(permitted, finite, Less(0, valid)), IN_FLIGHT, Outcome.INVALID
                ),
                "uncertain": Choose(every(permitted, finite, Less(0, doubt)), 1, 0),
            },
            "Whether a shot can start, and whether that is in doubt.",
        ),
        decision(
            "finite_state",
            {"finite": every(*(Less(size(s), sp.oo) for s in STATE))},
            "Where every number of a state is finite.",
        ),
        decision(
            "opening",
            {"when": sp.oo, "which": NONE, "late": 0, "doubt": Choose(_bounded, sp.oo, 0)},
            "No arrival yet; nothing is certain where the errors are not bounded.",
        ),
        decision(
            "departed",
            {
                "stays": Less(which, 0),
                "moves": Not(Less(which, 0)),
                "ends": Equal(which, index),
                "touches": every(Not(Less(which, 0)), Not(Equal(which, index))),
            },
            "Whether there is no event, the end, or a contact.",
        ),
        decision("ticked", {"clock": clock + when}, "The time of the event."),
        decision(
            "doubted",
            {
                "uncertain": Choose(
                    Either(
                        every(Not(Less(when + late, doubt)), Less(doubt, sp.oo)),
                        every(ends, AtMost(size(miss), slack)),
                    ),
                    1,
                    uncertain,
                )
            },
            "1 where a decision up to this event, or on the target, lies within its error.",
        ),
        decision(
            "accounted",
            {
                "contacts": Choose(touches, contacts + 1, contacts),
                "outcome": Choose(
                    touches,
                    Choose(AtMost(most_contacts, contacts + 1), Outcome.CAPPED, IN_FLIGHT),
                    Choose(
                        ends,
                        Choose(AtMost(miss, 0), Outcome.MADE, Outcome.MISSED),
                        Outcome.SHORT,
                    ),
                ),
            },
            "How many contacts there were, and whether the shot ends and how.",
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
        decision("delayed", {"clock_error": clock_error + delay}, "The error of the event's time."),
        decision(
            "floored",
            {s.name: Choose(Less(size(s), shift), shift, s) for s in dx},
            "Errors of the position at the end, not below what one flight can make.",
        ),
        decision(
            "unturned",
            {"dnx": 0, "dny": 0, "dnz": 0, "turn": 0},
            "A normal without error.",
        ),
        decision(
            "touched",
            {"first": Choose(Less(first, 0), body, first), "last": which},
            "The surfaces that were touched first and last.",
        ),
        decision(
            "closing",
            {"closed": every(Less(0, claims), AtMost(0, outcome))},
            "Where a shot has ended whose errors are asked for.",
        ),
        decision(
            "undecided",
            {"uncertain": Choose(unsure, 1, uncertain)},
            "1 where a decision within a contact lies within its error.",
        ),
    )
}
