"""The decisions of a search: each is a kernel, so that it stands once for every target.

Numbers that name something (surfaces) are doubles like all others.
"""

from __future__ import annotations

import sympy as sp

from ..errors.tangent import late
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
    size,
    some,
)
from ..ground.kernel import decision
from .events import SHARES, ceiling, horizon

when, which, last, index, time, doubt, delay = sp.symbols(
    "when which last index time doubt delay", real=True
)
"""The earliest arrival so far: its time and surface; the surface touched last; the one that is
asked about; an arrival there; the earliest time of a decision that lies within its rounding error;
and a bound on the arrival's delay."""
excess, pad, lost, share, clear, leaving = sp.symbols(
    "excess pad lost share clear leaving", real=True
)
rate, bend, apex, height, margin, rate_margin = sp.symbols(
    "rate bend apex height margin rate_margin", real=True
)
gap, step, following, root, clearance = sp.symbols("gap step next root clearance", real=True)
side, candidate = sp.symbols("side candidate", real=True)
through = sp.Symbol("through", real=True)
"""1 for a ball that has fallen through the scene's passage, where it has one."""
flat, tilt, arrival, t, end, refined = sp.symbols("flat tilt arrival t end refined", real=True)
since, lasting = sp.symbols("since lasting", real=True)
"""When a search in single precision began, and how long after that it is; infinite behind all
windows."""
unsure, arrives, certain, hit, sure, vague, met, sunk = map(
    Truth, ("unsure", "arrives", "certain", "hit", "sure", "vague", "met", "sunk")
)
searching, sound, fits, served = map(Truth, ("searching", "sound", "fits", "served"))


def earlier(condition: sp.Basic, at: sp.Expr) -> sp.Expr:
    """Return the earliest doubt, with one at a time where a condition holds."""
    return Choose(every(condition, Less(at, doubt)), at, doubt)


CONVERGED = sp.Rational(1, 2**24)
"""Newton's method from where h is less ends with h below 2^-49."""

_sooner = every(arrives, Less(time, when))
_tie = AtMost(size(time - when), delay + late)
_meets = some(Less(rate, 0), every(AtMost(rate, 0), Less(bend, 0), Equal(time, 0)))
_plane_met = every(_meets, AtMost(0, time), Less(time, sp.oo))
_falling = some(Less(rate, 0), every(AtMost(rate, rate_margin), Less(bend, 0)))
_clears = every(_falling, Less(0, clearance))
_strikes = every(_falling, some(AtMost(gap - margin, margin), Less(0, clearance)))
_unclear = every(_strikes, Not(_clears), Less(0, share))
_still = every(Less(t, end), Not(Less(t, following)))
_sunk = Less(gap, -margin)
_lands = every(met, arrives)
_near = every(Equal(last, index), Less(tilt * t, flat))
_strays = every(searching, some(Less(0, excess), Less(pad, late)))
_exhausted = every(Not(hit), Not(vague), AtMost(end - t, step))

KERNELS = {
    kernel.name: kernel
    for kernel in (
        decision(
            "left",
            {"leaving": Choose(Equal(last, index), 1, 0)},
            "1 where the ball leaves a surface.",
        ),
        decision(
            "released",
            {"released": Less(last, 0), "reachable": Not(Less(last, 0))},
            "Where a ball has touched nothing yet: only then is asked whether it comes to a plate.",
        ),
        decision(
            "meeting_plane",
            {
                "arrives": _plane_met,
                "ceiling": size(bend),
                "nearest": Choose(_plane_met, time, apex),
            },
            "Whether a plane's only arrival is one, the bend's size; when the ball is nearest.",
        ),
        decision(
            "timely",
            {"possible": every(arrives, Not(Less(late + delay, time - when)))},
            "Whether an arrival may be the earliest, as far as their delays are bounded.",
        ),
        decision(
            "grazed",
            {"doubt": earlier(every(AtMost(0, apex), AtMost(size(height), margin)), apex)},
            "A doubt where the gap's apex is zero within its error.",
        ),
        decision(
            "questioned",
            {"doubt": earlier(unsure, time)},
            "A doubt about a decision at a time.",
        ),
        decision(
            "crossed",
            {"doubt": earlier(every(arrives, Not(Less(0, clearance))), time)},
            "A doubt about an arrival whose crossing is not certain.",
        ),
        decision(
            "tied",
            {
                "doubt": earlier(every(arrives, _tie), Choose(Less(time, when), time, when)),
                "late": Choose(_sooner, delay, late),
            },
            "A doubt about two arrivals within their delays; the delay of the earlier one.",
        ),
        decision(
            "sooner",
            {"when": Choose(_sooner, time, when), "which": Choose(_sooner, index, which)},
            "The earlier of the earliest arrival so far and this one.",
        ),
        decision(
            "opens",
            {"open": Not(Less(0, clear))},
            "Where a surface is not certainly missed.",
        ),
        decision(
            "beginning",
            {"share": SHARES[0], "arrival": sp.oo, "certain": Nowhere()},
            "How a search begins: with the errors that it allows for, and nothing found.",
        ),
        decision(
            "beyond",
            {"doubt": Choose(some(Less(0, excess), Less(0, lost), Less(pad, late)), 0, doubt)},
            "Nothing is certain where the errors exceed what the search allows for.",
        ),
        decision(
            "beyond_windows",
            {"doubt": Choose(some(_strays, Less(0, lost)), 0, doubt)},
            "The same where a search has windows: with none its errors do not matter.",
        ),
        decision(
            "nearby",
            {
                "leaving": Choose(_near, 1, 0),
                "margin": Choose(_near, tilt * t, flat),
            },
            "1 near the surface that the ball left, where F/t is known better than F; the margin.",
        ),
        decision(
            "opened",
            {"time": time, "latest": horizon},
            "When the first window opens, in single precision, and when the last one ends.",
        ),
        decision(
            "coarse",
            {
                "leaping": every(searching, sound, fits),
                "searching": some(searching, Not(sound)),
                "served": every(searching, sound, fits),
                "ceiling": ceiling,
                "flat": flat,
                "tilt": rate_margin,
                "allowing": Choose(every(sound, fits), share, SHARES[0]),
            },
            "Whether a search begins in single precision, and what it is known by.",
        ),
        decision(
            "leapt",
            {
                "arrival": Choose(certain, since + lasting, arrival),
                "t": Choose(served, since + lasting, 0),
                "searching": every(searching, Not(certain), Less(lasting, sp.oo)),
            },
            "What a search in single precision found, and whether it goes on, and from when.",
        ),
        decision(
            "struck",
            {
                "hit": every(_strikes, Not(_unclear)),
                "sure": _clears,
                "vague": _unclear,
            },
            "Whether the gap closes, surely, or is to be looked at with smaller errors allowed.",
        ),
        decision(
            "struck_or_still",
            {
                "hit": every(_strikes, Not(_unclear)),
                "sure": _clears,
                "vague": some(_unclear, every(Not(_strikes), _still, Less(0, share))),
            },
            "The same; or that it is, as no step is possible with errors as large as these.",
        ),
        decision(
            "finer",
            {"share": Choose(Less(SHARES[-1], share), share * (SHARES[1] / SHARES[0]), 0)},
            "The next smaller errors that a search allows for.",
        ),
        decision(
            "exceeded",
            {"doubt": earlier(Less(0, excess), t)},
            "A doubt where the errors exceed what is allowed for.",
        ),
        decision(
            "advanced",
            {
                "arrival": Choose(hit, Choose(sure, following, t), arrival),
                "certain": Either(certain, every(hit, sure)),
                "exhausted": _exhausted,
                "searching": every(Not(hit), Not(_exhausted)),
                "t": Choose(Either(hit, vague), t, following),
            },
            "The search after a step: what it found, whether its window is exhausted, where it is.",
        ),
        decision(
            "found",
            {"arrives": Less(arrival, sp.oo), "refining": Less(arrival, sp.oo), "rate": 0},
            "Whether a search found an arrival.",
        ),
        decision(
            "polished",
            {
                "arrival": Choose(certain, refined, arrival),
                "refining": every(certain, Less(CONVERGED * rate**2, ceiling * size(gap))),
            },
            "A root that is certain, refined, and whether h is above 2^-24: then it is again.",
        ),
        decision(
            "own_margin",
            {"margin": Choose(Less(0, leaving), tilt * arrival, flat)},
            "The margin of the form that an arrival was found with.",
        ),
        decision(
            "landed",
            {"time": Choose(Less(arrival, 0), 0, arrival)},
            "The time of an arrival, not before the flight.",
        ),
        decision(
            "landed_surely",
            {
                "delay": Choose(every(certain, Less(0, clearance)), delay, 0),
                "doubt": earlier(every(arrives, Not(every(certain, Less(0, clearance)))), time),
            },
            "The delay of an arrival that is certain, a doubt about another one.",
        ),
        decision(
            "outside",
            {"side": 1},
            "A search that begins outside the surface.",
        ),
        decision(
            "struck_bounded",
            {
                "hit": every(_strikes, Not(_unclear), Not(_sunk)),
                "sure": _clears,
                "vague": every(_unclear, Not(_sunk)),
                "sunk": _sunk,
            },
            "The same where the ball may be inside a surface, beyond its bounds.",
        ),
        decision(
            "candidate",
            {
                "candidate": Choose(sure, root, t),
                "met": every(hit, Less(0, side)),
                "arrives": Nowhere(),
            },
            "The time of a root, and whether it is a way in.",
        ),
        decision(
            "refined_candidate",
            {"candidate": Choose(sure, refined, candidate)},
            "A root that is certain, refined.",
        ),
        decision(
            "passed",
            {
                "arrival": Choose(_lands, candidate, arrival),
                "certain": Either(certain, every(_lands, sure)),
                "exhausted": every(_exhausted, Not(sunk)),
                "searching": every(Not(_lands), Not(every(_exhausted, Not(sunk)))),
                "side": Choose(Either(sunk, every(hit, Not(_lands))), -side, side),
                "t": Choose(hit, candidate, Choose(Either(vague, sunk), t, following)),
            },
            "The same where a root out of bounds is passed, and the search goes on behind it.",
        ),
    )
}
