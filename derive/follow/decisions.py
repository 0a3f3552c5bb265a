"""The decisions between the formulas: each is a kernel, so that it stands once for every target.

Numbers that count or name something (surfaces, contacts, outcomes) are doubles like all others.
"""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from ..choice import AtMost, Choose, Either, Equal, Less, Not, Nowhere, Truth, every, size, some
from ..events import SHARES, horizon
from ..kernel import Kernel
from ..rounding import position_error, velocity_error
from ..sensitivity import clock, clock_error, contacts, curving, dx, late, shift
from ..symbols import STATE
from .fields import IN_FLIGHT, NONE, Outcome

when, which, last, first, index, time, doubt, delay = sp.symbols(
    "when which last first index time doubt delay", real=True
)
"""The next event: its time and surface; the surfaces touched last and first; one that is asked
about; an arrival there; the earliest time of a decision that lies within its rounding error; and a
bound on the arrival's delay."""

excess, pad, lost, share = sp.symbols("excess pad lost share", real=True)
rate, bend, apex, height, margin, rate_margin = sp.symbols(
    "rate bend apex height margin rate_margin", real=True
)
gap, step, following, root, clearance = sp.symbols("gap step next root clearance", real=True)
flat, tilt, arrival, end, t, refined = sp.symbols("flat tilt arrival end t refined", real=True)
miss, slack, outcome, most_contacts, claims = sp.symbols(
    "miss slack outcome most_contacts claims", real=True
)
count, allowed, valid, clear, uncertain, floor = sp.symbols(
    "count allowed valid clear uncertain floor", real=True
)

unsure, arrives, certain, hit, sure, vague = map(
    Truth, ("unsure", "arrives", "certain", "hit", "sure", "vague")
)
stays, ends, touches, finite, permitted = map(
    Truth, ("stays", "ends", "touches", "finite", "permitted")
)


def decided(name: str, outputs: Mapping[str, sp.Basic], summary: str) -> Kernel:
    """Return a kernel whose arguments come in the order of their names."""
    sympified = {key: sp.sympify(value) for key, value in outputs.items()}
    free = set().union(*(e.free_symbols for e in sympified.values()))
    arguments = tuple(sorted(free, key=lambda symbol: symbol.name))
    return Kernel(name, arguments, tuple(sympified.items()), summary, "Table 1")


def _earlier(condition: sp.Basic, at: sp.Expr) -> sp.Expr:
    """Return the earliest doubt, with one at a time where a condition holds."""
    return Choose(every(condition, Less(at, doubt)), at, doubt)


def _sooner() -> sp.Basic:
    return every(arrives, Less(time, when))


bounded = every(Less(position_error, sp.oo), Less(velocity_error, sp.oo), AtMost(excess, 0))
meets = some(Less(rate, 0), every(AtMost(rate, 0), Less(bend, 0), Equal(time, 0)))
falling = some(Less(rate, 0), every(AtMost(rate, rate_margin), Less(bend, 0)))
clears = every(falling, Less(0, clearance))
strikes = every(falling, some(AtMost(gap - margin, margin), Less(0, clearance)))
unclear = every(strikes, Not(clears), Less(0, share))
near = Less(tilt * t, flat)
near_last = every(Equal(last, index), near)
exhausted = every(Not(hit), Not(vague), AtMost(end - t, step))
_tie = AtMost(size(time - when), delay + late)

KERNELS = {
    kernel.name: kernel
    for kernel in (
        decided(
            "admitted",
            {
                "outcome": Choose(
                    every(permitted, finite, Less(0, valid)), IN_FLIGHT, Outcome.INVALID
                ),
                "uncertain": Choose(every(permitted, finite, Less(0, doubt)), 1, 0),
            },
            "Whether a shot can start, and whether that is in doubt.",
        ),
        decided(
            "finite_state",
            {"finite": every(*(Less(size(s), sp.oo) for s in STATE))},
            "Where every number of a state is finite.",
        ),
        decided(
            "opening",
            {"when": sp.oo, "which": NONE, "late": 0, "doubt": Choose(bounded, sp.oo, 0)},
            "No arrival yet; nothing is certain where the errors are not bounded.",
        ),
        decided(
            "left",
            {"leaving": Choose(Equal(last, index), 1, 0)},
            "1 where the ball leaves a surface.",
        ),
        decided(
            "meeting_plane",
            {
                "arrives": every(meets, AtMost(0, time), Less(time, sp.oo)),
                "ceiling": size(bend),
            },
            "Whether a plane's only arrival is one, and the size of the bend there.",
        ),
        decided(
            "timely",
            {"possible": every(arrives, Not(Less(late + delay, time - when)))},
            "Whether an arrival may be the earliest, as far as their delays are bounded.",
        ),
        decided(
            "grazed",
            {"doubt": _earlier(every(AtMost(0, apex), AtMost(size(height), margin)), apex)},
            "A doubt where the gap's apex is zero within its error.",
        ),
        decided(
            "questioned",
            {"doubt": _earlier(unsure, time)},
            "A doubt about a decision at a time.",
        ),
        decided(
            "crossed",
            {"doubt": _earlier(every(arrives, Not(Less(0, clearance))), time)},
            "A doubt about an arrival whose crossing is not certain.",
        ),
        decided(
            "tied",
            {
                "doubt": _earlier(every(arrives, _tie), Choose(Less(time, when), time, when)),
                "late": Choose(_sooner(), delay, late),
            },
            "A doubt about two arrivals within their delays; the delay of the earlier one.",
        ),
        decided(
            "sooner",
            {"when": Choose(_sooner(), time, when), "which": Choose(_sooner(), index, which)},
            "The earlier of the earliest arrival so far and this one.",
        ),
        decided(
            "opens",
            {"open": Not(Less(0, clear))},
            "Where a surface is not certainly missed.",
        ),
        decided(
            "beginning",
            {"share": SHARES[0], "arrival": sp.oo, "certain": Nowhere()},
            "How a search begins: with the errors that it allows for, and nothing found.",
        ),
        decided(
            "beyond",
            {
                "doubt": Choose(
                    some(Less(0, excess), Less(0, lost), Less(pad, late)), 0, doubt
                )
            },
            "Nothing is certain where the errors exceed what the search allows for.",
        ),
        decided(
            "nearby",
            {
                "leaving": Choose(near_last, 1, 0),
                "margin": Choose(near_last, tilt * t, flat),
            },
            "1 near the surface that the ball left, where F/t is known better than F; the margin.",
        ),
        decided(
            "struck",
            {
                "hit": every(strikes, Not(unclear)),
                "sure": clears,
                "vague": unclear,
            },
            "Whether the gap closes, surely, or is to be looked at with smaller errors allowed.",
        ),
        decided(
            "finer",
            {"share": Choose(Less(SHARES[-1], share), share * (SHARES[1] / SHARES[0]), 0)},
            "The next smaller errors that a search allows for.",
        ),
        decided(
            "exceeded",
            {"doubt": _earlier(Less(0, excess), t)},
            "A doubt where the errors exceed what is allowed for.",
        ),
        decided(
            "advanced",
            {
                "arrival": Choose(hit, Choose(sure, root, t), arrival),
                "certain": Either(certain, every(hit, sure)),
                "exhausted": exhausted,
                "searching": every(Not(hit), Not(exhausted)),
                "t": Choose(Either(hit, vague), t, following),
            },
            "The search after a step: what it found, whether its window is exhausted, where it is.",
        ),
        decided(
            "found",
            {"arrives": Less(arrival, sp.oo)},
            "Whether a search found an arrival.",
        ),
        decided(
            "polished",
            {"arrival": Choose(certain, refined, arrival)},
            "A root that is certain, refined.",
        ),
        decided(
            "own_margin",
            {"margin": Choose(Less(0, sp.Symbol("leaving", real=True)), tilt * arrival, flat)},
            "The margin of the form that an arrival was found with.",
        ),
        decided(
            "landed",
            {"time": Choose(Less(arrival, 0), 0, arrival)},
            "The time of an arrival, not before the flight.",
        ),
        decided(
            "landed_surely",
            {
                "delay": Choose(every(certain, Less(0, clearance)), delay, 0),
                "doubt": _earlier(
                    every(arrives, Not(every(certain, Less(0, clearance)))), time
                ),
            },
            "The delay of an arrival that is certain, a doubt about another one.",
        ),
        decided(
            "departed",
            {
                "stays": Less(which, 0),
                "moves": Not(Less(which, 0)),
                "ends": Equal(which, index),
                "touches": every(Not(Less(which, 0)), Not(Equal(which, index))),
            },
            "Whether there is no event, the end, or a contact.",
        ),
        decided("ticked", {"clock": clock + when}, "The time of the event."),
        decided(
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
        decided(
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
        decided(
            "meeting",
            {"meeting": Either(touches, every(ends, Less(0, claims)))},
            "Where an event changes the ball, or its errors are asked for.",
        ),
        decided("here", {"here": Equal(which, index)}, "Whether the event is on a surface."),
        decided("counted", {"count": count + 1}, "One more contact."),
        decided("elsewhere", {"curving": sp.oo}, "A ball that meets another surface."),
        decided(
            "again",
            {"again": every(Equal(which, index), Equal(last, which))},
            "Whether the ball meets the surface that it touched last.",
        ),
        decided(
            "delayed", {"clock_error": clock_error + delay}, "The error of the event's time."
        ),
        decided(
            "floored",
            {s.name: Choose(Less(size(s), shift), shift, s) for s in dx},
            "Errors of the position at the end, not below what one flight can make.",
        ),
        decided(
            "unturned",
            {"dnx": 0, "dny": 0, "dnz": 0, "turn": 0},
            "A normal without error.",
        ),
        decided(
            "touched",
            {"first": Choose(Less(first, 0), which, first), "last": which},
            "The surfaces that were touched first and last.",
        ),
        decided(
            "closing",
            {"closed": every(Less(0, claims), AtMost(0, outcome))},
            "Where a shot has ended whose errors are asked for.",
        ),
    )
}
