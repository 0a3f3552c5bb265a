"""The decisions of a search, each a kernel, so that every target makes them alike.

Numbers that name something (surfaces) are doubles like all others.

**Lemma (first event).** A surface is searched up to a time that is no earlier than the true event.
Let each search have one of three results: no true arrival until then; an arrival at T that counts,
within δ of a true one that is the first there; or that something is undecided, from a time on
before which no true arrival is. Let t be the earliest of these T, δ* its delay, and θ the earliest
undecided time. If t + δ* < θ the true ball has its first event at the surface of t, within δ* of t.

*Proof.* An arrival that the loop keeps is certainly before another if they are further apart than
both delays; one that takes its place is before both then. Where they are not, `tie_undecided`
lowers θ to a time before both true arrivals: no later than the earlier one less both delays, nor
than half of it. Arrivals that are later than t by more than both delays are not looked at. What is
undecided is from θ > t + δ* on, after the true arrival of t. ∎

The searches come to these results as follows.

- *Planes*: `plane.py` and `plane_start.py`. From when on a contact near an edge is undecided,
  `bounds_undecided` has: not before T/2.
- *Bounds*: `event_polynomials.displacement`. If all g < -slack the true contact counts, and if some
  g > slack it does not; else it is undecided.
- *Ring*: `root_finder.py`. What is not certain is undecided from where the search stands, before
  which there is no root; a root that was certain, but not with the shot's own errors, by its delay
  before.
- *The horizon*: the plane of the earliest arrival is met by t + δ*/3, which is before t + pad if δ*
  <= 2 pad (`overdue`; at boxes `lost` in `box.py`). Without an arrival at a plane the horizon is
  infinite.
- *The time limit*: the time left is off by the error of the clock and by 4 u of the limit, its
  roundings; it is an arrival like others (`loop/predicates.py`, `expiry`).
"""

from __future__ import annotations

import sympy as sp

from ..ir.kernel import Kernel, decision
from ..symbolic.conditionals import (
    AtMost,
    Boolean,
    Choose,
    Equal,
    IfLess,
    Less,
    Not,
    Or,
    absolute,
    all_of,
    any_of,
    barrier,
    false,
    minimum,
)
from ..symbolic.error_terms import earliest_delay
from ..symbolic.rounding import velocity_error
from .event_polynomials import ERROR_BUDGET_LEVELS, ceiling, horizon

when, which, last, index, time, undecided_time, delay = sp.symbols(
    "when which last index time undecided_time delay", real=True
)
"""Time and surface of the earliest arrival so far; surface touched last; index of the surface
that is searched; an arrival on it; the earliest time of a decision that lies within its rounding
error; a bound on the arrival's delay."""
excess, pad, budget_exceeded, share, clear, leaving = sp.symbols(
    "excess pad budget_exceeded share clear leaving", real=True
)
rate, bend, apex, height, margin, rate_margin = sp.symbols(
    "rate bend apex height margin rate_margin", real=True
)
gap, step, following, root, clearance = sp.symbols("gap step next root clearance", real=True)
side, candidate, gap_at_start = sp.symbols("side candidate gap_at_start", real=True)
second = sp.Symbol("second", real=True)
"""A plane that the flight began on besides the surface touched last; -1: none."""
through = sp.Symbol("through", real=True)
"""1 for a ball that has fallen through the scene's passage."""
flat, tilt, arrival, t, end, refined = sp.symbols("flat tilt arrival t end refined", real=True)
since, lasting = sp.symbols("since lasting", real=True)
"""Begin of a search in single precision, and the time since then; infinite after all windows."""
undecided, arrives, certain, hit, sure, needs_refinement, met, penetrates = map(
    Boolean,
    ("undecided", "arrives", "certain", "hit", "sure", "needs_refinement", "met", "penetrates"),
)
searching, representable, fits, single_precision = map(
    Boolean, ("searching", "representable", "fits", "single_precision")
)

misses, open_ = Boolean("misses"), Boolean("open")
"""True of a flight that certainly misses a surface, or comes near it."""
landed, lands = sp.symbols("landed lands", real=True)
"""1 if a sketch of the path certainly meets a surface, in single and in double precision."""
onset = sp.Symbol("onset", real=True)
"""Time up to which a sketch of the path proves that there is no contact, s."""

sunk = Boolean("sunk")
"""True of a ball that flies through air and can never meet anything again."""


def earlier(condition: sp.Basic, at: sp.Expr) -> sp.Expr:
    """Return the earliest undecided time, given one at which a condition holds.

    Parameters
    ----------
    condition
        The condition of an undecided decision.
    at
        The time of that decision since the last contact, s.
    """
    return Choose(all_of(condition, Less(at, undecided_time)), at, undecided_time)


def overdue(late: sp.Expr) -> Kernel:
    """Return the decision whether the earliest arrival may be after the horizon.

    A test that a flight misses a surface until the horizon says nothing of what is after it.

    Parameters
    ----------
    late
        As for `out_of_budget`.
    """
    return decision(
        "overdue",
        {"undecided_time": Choose(Less(pad, late * earliest_delay), 0, undecided_time)},
        "Undecided time 0 if the earliest arrival may be after the horizon.",
    )


def out_of_budget(late: sp.Expr) -> tuple[Kernel, Kernel]:
    """Return the decisions whether errors exceed the budget of a search, or its bounds fail.

    Parameters
    ----------
    late
        The share of its delay by which an arrival may be late. That of a crossing is six times the
        margin over the slope, of which a third is what `event_polynomials.crossing` proves.
    """
    exceeded = any_of(Less(0, excess), Less(pad, late * earliest_delay))

    def undecided_if(condition: sp.Basic) -> dict[str, sp.Basic]:
        lost = any_of(condition, Less(0, budget_exceeded))
        return {"undecided_time": Choose(lost, 0, undecided_time)}

    return (
        decision(
            "out_of_budget",
            undecided_if(exceeded),
            "Undecided time 0 if errors exceed the budget of a search, or its bounds fail.",
        ),
        decision(
            "out_of_budget_in_windows",
            undecided_if(all_of(searching, exceeded)),
            "Undecided time 0 if errors exceed the budget of an open window, or its bounds fail.",
        ),
    )


CONVERGED = sp.Rational(1, 2**24)
"""Newton's method from a smaller h ends with h below 2^-49."""

_sooner = all_of(arrives, Less(time, when))
_sooner_time = barrier(Choose(Less(time, when), time, when))
_delays = barrier(delay + earliest_delay)
_tie = AtMost(absolute(time - when), _delays)
_meets = any_of(Less(rate, 0), all_of(AtMost(rate, 0), Less(bend, 0), Equal(time, 0)))
_plane_met = all_of(_meets, AtMost(0, time), Less(time, sp.oo))
_falling = any_of(Less(rate, 0), all_of(AtMost(rate, rate_margin), Less(bend, 0)))
_clears = all_of(_falling, Less(0, clearance))
_strikes = all_of(_falling, any_of(AtMost(gap - margin, margin), Less(0, clearance)))
_unclear = all_of(_strikes, Not(_clears), Less(0, share))
_grazes = all_of(AtMost(0, apex), AtMost(absolute(height), margin))
_graze_delay = 3 * sp.sqrt(barrier(margin / barrier(IfLess(0, absolute(bend), absolute(bend), 1))))
_still = all_of(Less(t, end), Not(Less(t, following)))
_sunk = Less(gap, -margin)
_lands = all_of(met, arrives)
_at_start = all_of(_lands, AtMost(t, 0), AtMost(leaving, 0))
_near = all_of(Equal(last, index), Less(tilt * t, flat))
_exhausted = all_of(Not(hit), Not(needs_refinement), AtMost(end - t, step))


def _refined(refines: sp.Basic) -> dict[str, sp.Basic]:
    """Return the outputs of the decision that takes Newton's next value where a condition holds."""
    distant = Less(CONVERGED * rate**2, ceiling * absolute(gap))
    return {"arrival": Choose(refines, refined, arrival), "refining": all_of(refines, distant)}


def _certainty(since: sp.Expr) -> dict[str, sp.Basic]:
    """Return the outputs of the decision on an arrival; an uncertain one may be since then."""
    sound = all_of(certain, Less(0, clearance))
    return {
        "delay": Choose(sound, delay, 0),
        "undecided_time": earlier(
            all_of(arrives, Not(sound)), Choose(certain, time - delay, since)
        ),
    }


KERNELS = {
    kernel.name: kernel
    for kernel in (
        decision(
            "left",
            {"leaving": Choose(Equal(last, index), 1, 0)},
            "1 if the flight starts on this surface.",
        ),
        decision(
            "left_either",
            {"leaving": Choose(Equal(last, index), 1, Choose(Equal(second, index), 2, 0))},
            "1 if the flight starts on this surface; 2 if it is not the one touched last.",
        ),
        decision(
            "released",
            {"released": Less(last, 0), "reachable": Not(Less(last, 0))},
            "Whether the ball has touched nothing yet.",
        ),
        decision(
            "plane_root",
            {
                "arrives": _plane_met,
                "ceiling": absolute(bend),
                "nearest": Choose(_plane_met, time, apex),
            },
            "Whether a plane's only root is an arrival, the size of F'', and the nearest time.",
        ),
        decision(
            "level_root",
            {
                "arrives": _plane_met,
                "ceiling": absolute(bend),
                "nearest": minimum(
                    barrier(Choose(_plane_met, time, Choose(Less(height, 0), 0, sp.oo))), when
                ),
            },
            "Whether a plane's only root is an arrival, the size of F'', and the nearest time.",
        ),
        decision(
            "within_time",
            {"possible": all_of(arrives, Not(Less(earliest_delay + delay, time - when)))},
            "Whether an arrival may be the earliest within the delays.",
        ),
        decision(
            "graze_undecided",
            {
                "undecided_time": earlier(_grazes, apex),
            },
            "Earliest undecided time, with that of an apex whose gap is zero within its error.",
        ),
        decision(
            "apex_undecided",
            {"undecided_time": Choose(_grazes, 0, undecided_time)},
            "Undecided time 0 if the largest gap from the start on is zero within its error.",
        ),
        decision(
            "side_undecided",
            {
                "undecided_time": Choose(
                    all_of(
                        Less(rate, barrier(2 * velocity_error)),
                        AtMost(absolute(height), barrier(2 * margin)),
                    ),
                    0,
                    undecided_time,
                )
            },
            "Undecided time 0 if the gap of a plane is zero within its error, and falls.",
        ),
        decision(
            "graze_delay",
            {
                "grazes": all_of(_grazes, Less(0, absolute(bend))),
                "graze_delay": _graze_delay,
                "graze_end": apex + _graze_delay,
                "undecided_time": earlier(all_of(_grazes, AtMost(absolute(bend), 0)), apex),
            },
            "Whether the gap at an apex is zero within its error, and how far a contact may be.",
        ),
        decision(
            "predicate_undecided",
            {"undecided_time": earlier(undecided, time)},
            "Earliest undecided time, with that of an undecided predicate.",
        ),
        decision(
            "bounds_undecided",
            {"undecided_time": earlier(undecided, time / 2)},
            "Earliest undecided time, with that from which on a contact near an edge may be.",
        ),
        decision(
            "crossing_undecided",
            {"undecided_time": earlier(all_of(arrives, Not(Less(0, clearance))), time)},
            "Earliest undecided time, with that of an arrival whose crossing is not certain.",
        ),
        decision(
            "tie_undecided",
            {
                "undecided_time": earlier(
                    all_of(arrives, _tie),
                    _sooner_time - minimum(_delays, barrier(_sooner_time / 2)),
                ),
                "earliest_delay": Choose(_sooner, delay, earliest_delay),
            },
            "Earliest undecided time, with that of a tie; the delay of the earlier arrival.",
        ),
        decision(
            "earliest",
            {"when": Choose(_sooner, time, when), "which": Choose(_sooner, index, which)},
            "Time and surface of the earliest arrival, with this one.",
        ),
        decision("missed", {"clear": 1}, "Start value: the surface is certainly missed."),
        decision(
            "opens",
            {"open": Not(Less(0, clear))},
            "Whether the flight may hit a surface.",
        ),
        decision(
            "unsketched",
            {"unsettled": open_, "onset": 0, "lands": 0},
            "Whether a flight comes near a surface, and the begin of a search.",
        ),
        decision(
            "sketched",
            {"unsettled": Not(misses), "onset": t, "lands": landed},
            "Whether a search along a sketch of the path leaves something, and from when on.",
        ),
        decision(
            "landing",
            {
                "arrival": Choose(Less(0, lands), onset, arrival),
                "certain": Or(certain, Less(0, lands)),
                "searching": all_of(searching, AtMost(lands, 0)),
            },
            "Root from a search along a sketch of the path, and whether the search goes on.",
        ),
        decision(
            "beginning",
            {"share": ERROR_BUDGET_LEVELS[0], "arrival": sp.oo, "certain": false},
            "Start values of a search: its error budget, and no arrival.",
        ),
        *out_of_budget(sp.Rational(1, 2)),
        overdue(sp.Rational(1, 2)),
        decision(
            "nearby",
            {
                "leaving": Choose(_near, 1, 0),
                "margin": Choose(_near, tilt * t, flat),
            },
            "1 near the surface that the ball left, where F/t is more exact than F; the margin.",
        ),
        decision(
            "opened",
            {"time": time, "latest": horizon},
            "Begin of the first window and end of the last one, from single precision.",
        ),
        decision(
            "coarse",
            {
                "stepping": all_of(searching, representable, fits),
                "searching": any_of(searching, Not(representable)),
                "single_precision": all_of(searching, representable, fits),
                "ceiling": ceiling,
                "flat": flat,
                "tilt": rate_margin,
                "allowing": Choose(all_of(representable, fits), share, ERROR_BUDGET_LEVELS[0]),
            },
            "Whether a search begins in single precision; its ceiling, margins and error budget.",
        ),
        decision(
            "stepped",
            {
                "arrival": Choose(certain, since + lasting, arrival),
                "t": Choose(single_precision, since + lasting, 0),
                "searching": all_of(searching, Not(certain), Less(lasting, sp.oo)),
            },
            "Root from the search in single precision; whether and where the search goes on.",
        ),
        decision(
            "gap_closes",
            {
                "hit": all_of(_strikes, Not(_unclear)),
                "sure": _clears,
                "needs_refinement": _unclear,
            },
            "Whether the gap closes, certainly closes, or needs a smaller error budget.",
        ),
        decision(
            "gap_closes_or_stalls",
            {
                "hit": all_of(_strikes, Not(_unclear)),
                "sure": _clears,
                "needs_refinement": any_of(_unclear, all_of(Not(_strikes), _still, Less(0, share))),
            },
            "Whether the gap closes; a step that moves nothing needs a smaller budget, too.",
        ),
        decision(
            "smaller_budget",
            {
                "share": Choose(
                    Less(ERROR_BUDGET_LEVELS[-1], share),
                    share * (ERROR_BUDGET_LEVELS[1] / ERROR_BUDGET_LEVELS[0]),
                    0,
                )
            },
            "Next smaller error budget.",
        ),
        decision(
            "budget_undecided",
            {"undecided_time": earlier(Less(0, excess), t)},
            "Earliest undecided time, with the present one if the errors exceed the budget.",
        ),
        decision(
            "advanced",
            {
                "arrival": Choose(hit, Choose(sure, following, t), arrival),
                "certain": Or(certain, all_of(hit, sure)),
                "exhausted": _exhausted,
                "searching": all_of(Not(hit), Not(_exhausted)),
                "t": Choose(Or(hit, needs_refinement), t, following),
            },
            "Root, time and state of a search after a step, and whether its window is exhausted.",
        ),
        decision(
            "found",
            {"arrives": Less(arrival, sp.oo), "refining": Less(arrival, sp.oo), "rate": 0},
            "Whether a search found an arrival.",
        ),
        decision(
            "refined_root",
            _refined(certain),
            "A certain root, refined, and whether h is above 2^-24, so that it is refined again.",
        ),
        decision(
            "refined_return",
            _refined(Or(certain, all_of(Less(0, leaving), Less(rate, 0)))),
            "A root or a return that is not certain, refined, and whether it is refined again.",
        ),
        decision(
            "own_margin",
            {"margin": Choose(Less(0, leaving), tilt * arrival, flat)},
            "Margin of the form, F or F/t, in which an arrival was found.",
        ),
        decision(
            "behind",
            {"undecided_time": Choose(AtMost(gap_at_start, margin), 0, undecided_time)},
            "Undecided time 0 if an arrival at the start may be that of a ball behind the surface.",
        ),
        decision(
            "arrival_time",
            {"time": Choose(Less(arrival, 0), 0, arrival)},
            "Time of an arrival, not before the flight.",
        ),
        decision(
            "arrival_certainty",
            _certainty(time),
            "Delay of a certain arrival; the earliest undecided time, with that of any other one.",
        ),
        decision(
            "return_certainty",
            _certainty(minimum(t, time)),
            "Delay of a certain arrival; the earliest undecided time, with where the search of any "
            "other one stands, which may have been refined since.",
        ),
        decision(
            "outside",
            {"side": 1, "gap_at_start": sp.oo},
            "Start values: the ball is outside the surface, and not known to begin at it.",
        ),
        decision(
            "gap_closes_bounded",
            {
                "hit": all_of(_strikes, Not(_unclear), Not(_sunk)),
                "sure": _clears,
                "needs_refinement": all_of(_unclear, Not(_sunk)),
                "penetrates": _sunk,
            },
            "Whether the gap closes, for a ball that may be inside a surface, beyond its bounds.",
        ),
        decision(
            "candidate",
            {
                "candidate": Choose(sure, root, t),
                "met": all_of(hit, Less(0, side)),
                "arrives": false,
            },
            "Time of a root, and whether the ball comes in there.",
        ),
        decision(
            "refined_candidate",
            {"candidate": Choose(sure, refined, candidate)},
            "A certain root, refined.",
        ),
        decision(
            "passed",
            {
                "arrival": Choose(_lands, candidate, arrival),
                "certain": Or(certain, all_of(_lands, sure)),
                "exhausted": all_of(_exhausted, Not(penetrates)),
                "searching": all_of(Not(_lands), Not(all_of(_exhausted, Not(penetrates)))),
                "side": Choose(Or(penetrates, all_of(hit, Not(_lands))), -side, side),
                "t": Choose(hit, candidate, Choose(Or(needs_refinement, penetrates), t, following)),
                "gap_at_start": Choose(_at_start, gap, gap_at_start),
            },
            "The search after a step that passes a root out of bounds and goes on behind it.",
        ),
    )
}
