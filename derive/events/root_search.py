"""The search on a curved surface, from the left, with the bounds of its root finder."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import sympy as sp

from ..errors.propagation import normal_error
from ..ir.event_tree import UNPROVED, Call, If, Node, Value, While
from ..ir.kernel import Kernel, decision
from ..surfaces import Ring
from ..symbolic.conditionals import Not, false
from ..symbolic.symbols import variable
from .box_windows import enter, opening
from .predicates import KERNELS, landed, side
from .ring.air_sketch import MAX_STEPS as MAX_SKETCH_STEPS
from .ring.air_sketch import AirRingSketch, sketch_size
from .ring.single import MAX_STEPS, SinglePrecisionRing
from .root_finder import RootFinder
from .search import Formula, Parts, Search, bounded, edges, given, proposed, root_formulas

STEP_LIMIT = 201
"""Steps after which a search gives up and the shot is uncertain; a search takes about five."""

NEWTON_LIMIT = 8
"""Largest number of Newton's steps; from h < 2^-3 it takes four."""

_BOUNDS = "bounds of the event condition"


@dataclass(frozen=True)
class RootSearch(Search):
    """The search on a curved surface.

    Attributes
    ----------
    root_finder
        The properties of the surface along the flight.
    coarse
        The same in single precision, if that serves.
    sketch
        The same along a sketch of the path, if there is one.
    """

    root_finder: RootFinder
    coarse: SinglePrecisionRing | None = None
    sketch: AirRingSketch | None = None

    @property
    def passes(self) -> bool:
        """True if the ball may pass through the surface, and the search goes on behind it."""
        return bool(self.surface.bounds)

    @property
    def constants(self) -> tuple[sp.Symbol, ...]:
        """Quantities that are constant along the flight, and the state of the search."""
        if self.passes:
            return (*self.root_finder.symbols, side)
        sketched = () if self.sketch is None else (sketch_size, landed)
        return (*self.root_finder.symbols, *(self.coarse.passed if self.coarse else ()), *sketched)

    @property
    def formulas(self) -> dict[str, Formula]:
        """The formulas of the root finder."""
        approach = self.root_finder
        return {
            "carry_normal": (
                normal_error(self.surface),
                "Error of the normal, from that of the position.",
                "derivative of Table 2's normal",
            ),
            **self._root_rounding,
            **({} if approach.excess is None else _excess("excess", approach.excess)),
            **({} if approach.clear is None else _clear(approach.clear)),
            **({} if approach.near is None else _open(approach.near)),
            "prepare": (
                approach.prepare(),
                "Constants and windows of the search along a flight, and its error budget.",
                _BOUNDS,
            ),
            "margins": (
                approach.margins,
                "Bounds on the errors of the gap, of the gap over t when leaving, and of its rate.",
                "running error analysis",
            ),
            "refine": (
                approach.refine(),
                "Newton's next value of a root near t, and gap and rate there.",
                "Newton's method",
            ),
            "advance": (
                approach.advance(side) if self.passes else approach.advance(),
                "Gap, rate, second derivative, a step without a root, its end, and the clearance.",
                "Newton from the left under a curvature bound",
            ),
            **({} if self.coarse is None else _coarse(self.coarse)),
            **({} if self.sketch is None else _sketch(self.sketch)),
        }

    @property
    def _root_rounding(self) -> dict[str, Formula]:
        """The roundings of the root, where the flight's own do not contain them."""
        late = self.root_finder.root_delay
        return {} if late is None else root_formulas(late, self.flight)

    @property
    def reach_test(self) -> dict[str, sp.Basic]:
        """The root finder's test."""
        return self.root_finder.reach_test

    @property
    def approach_test(self) -> dict[str, sp.Basic]:
        """The root finder's test."""
        return self.root_finder.approach_test

    @property
    def single(self) -> frozenset[str]:
        """The parts of the search that are computed in single precision."""
        tested = {"open"} if self.root_finder.near_in_single else set()
        return frozenset({"opened", "resolution", "step", "sketched", "sketch"} | tested)

    @property
    def decisions(self) -> dict[str, Kernel]:
        """The decisions of the next window, and of the bounds."""
        return (
            edges(self.surface)
            | self._shortcut
            | {
                "enter": decision(
                    f"{self.surface.name}_enter",
                    enter(opening(len(self.root_finder.windows))),
                    "First window that ends later than a time, from then on.",
                )
            }
        )

    @property
    def _shortcut(self) -> dict[str, Kernel]:
        """The condition that takes the place of `clear` where it holds, if there is one."""
        missed = self.root_finder.drops_through
        if missed is None:
            return {}
        return {
            "drops_through": decision(
                f"{self.surface.name}_drops_through",
                {UNPROVED: Not(missed)},
                "Whether the ball may do other than rise and drop through the hole.",
                single=True,
            )
        }

    def nodes(self, common: Parts, own: Parts, index: Value) -> Iterator[Node]:
        """Search the first arrival; a shot that certainly misses the surface does not take part."""
        yield Call(common["horizon"], {"t": "when"}, {"horizon": "until"})
        # Where balls roll, flags of shots with such a test are proved for rings alone.
        if "clear" in own and (not self.flight.departs or isinstance(self.surface, Ring)):
            yield Call(common["overdue"])
        step = tuple(self._step(common, own, index))
        prepared = given(own["prepare"], horizon="until")
        allowing = tuple(_allowing(common, own))
        found = (
            While("searching", STEP_LIMIT, step),
            Call(KERNELS["predicate_undecided"], {"undecided": "searching", "time": "t"}),
        )
        if self.coarse is None:
            onset: Value = 0.0 if self.sketch is None else "onset"
            first = Call(own["enter"], {"after": onset, "t": 0.0, "end": 0.0})
            begun = (prepared, Call(KERNELS["beginning"]), *allowing, Call(KERNELS["outside"]))
            if _tested(own):
                landing = () if self.sketch is None else (Call(KERNELS["landing"]),)
                begun = (*begun, Call(common["out_of_budget"]), first, *landing)
            else:
                # Most searches end with the first step, so lanes are not compacted for it.
                begun = (
                    *begun,
                    first,
                    Call(common["out_of_budget_in_windows"]),
                    If("searching", step),
                )
            search: tuple[Node, ...] = (*begun, *found)
        else:
            entered = Call(own["enter"], {"after": "t", "end": 0.0})
            # Margins differ from those in single precision.
            within = Call(KERNELS["budget_undecided"])
            again = (prepared, *allowing, within, entered, *found)
            leaping = _leaping(common, own, index)
            search = (*leaping, If("searching", again))
        root = _landing(common, own, index, passes=self.passes)
        searched = (*search, *root, *proposed(index))
        if not _tested(own):
            yield from searched
            return
        if "open" in own:
            yield given(own["open"], horizon="until")
            if "open_in_flight" in common:
                yield Call(common["open_in_flight"])
        else:
            yield from self._cleared(common, own)
        if self.sketch is None:
            # Most flights of a scene with a ring may come near it.
            yield If("open", searched, usual=self.coarse is not None)
            return
        yield Call(KERNELS["unsketched"])
        yield If("open", tuple(_sketched(own, index)))
        yield If("unsettled", searched)

    @staticmethod
    def _cleared(common: Parts, own: Parts) -> Iterator[Node]:
        """Decide whether the search opens by a quantity that is positive if it does not."""
        cleared = given(own["clear"], horizon="until")
        if "drops_through" in own:
            dropped = given(own["drops_through"], horizon="until")
            cleared = replace(cleared, shortcut=(Call(KERNELS["missed"]), dropped))
        yield cleared
        yield Call(common.get("opens_in_flight", KERNELS["opens"]))

    def counted(self, common: Parts, own: Parts) -> Iterator[Node]:
        """Test whether a root that the ball may pass counts.

        Parameters
        ----------
        common
            The kernels that all surfaces share, by part.
        own
            The kernels of this surface, by part.
        """
        return bounded(common, own, "candidate", delay=0.0, clearance=1.0)

    def _step(self, common: Parts, own: Parts, index: Value) -> Iterator[Node]:
        """Step as far as there can be no root, or take the root."""
        if self.passes:
            return _passing_step(common, own, index, tuple(self.counted(common, own)))
        return _step(common, own, index, "gap_closes" if self.coarse else "gap_closes_or_stalls")


_CROSSED = decision("crossed", {"arrives": Not(false)}, "Every crossing counts.")


@dataclass(frozen=True)
class PlaneRootSearch(RootSearch):
    """The search on a plane along a path on which the arrival is no closed form."""

    @property
    def passes(self) -> bool:
        """True: a plane is thin, and a ball may be behind it."""
        return True

    @property
    def decisions(self) -> dict[str, Kernel]:
        """The decisions of a root search, and that a crossing counts if there are no bounds."""
        return super().decisions | ({} if self.surface.bounds else {"crossed": _CROSSED})

    def counted(self, common: Parts, own: Parts) -> Iterator[Node]:
        """Test whether a crossing is within the bounds, if there are any.

        Arguments as for `RootSearch.counted`.
        """
        return super().counted(common, own) if self.surface.bounds else iter([Call(own["crossed"])])


def _excess(part: str, excess: sp.Expr) -> dict[str, Formula]:
    summary = "Positive if errors of the state exceed those that a search allows for."
    return {part: ({"excess": excess}, summary, "running error analysis")}


def _clear(clear: sp.Expr) -> dict[str, Formula]:
    summary = "Positive if there is certainly no contact before the horizon."
    return {"clear": ({"clear": clear}, summary, _BOUNDS)}


def _open(near: sp.Basic) -> dict[str, Formula]:
    return {"open": ({"open": near}, "Whether there may be a contact before the horizon.", _BOUNDS)}


def _tested(own: Parts) -> bool:
    """Return whether a test comes before the search, so that only some shots take part in it."""
    return "clear" in own or "open" in own


def _coarse(coarse: SinglePrecisionRing) -> dict[str, Formula]:
    """Return the kernels of the search in single precision."""
    return {
        "opened": (
            coarse.opened(),
            "Windows of the search along a flight, and whether single precision serves for it.",
            _BOUNDS,
        ),
        "resolution": (
            coarse.grain(),
            "Constants, margins and windows of the search in single precision, from its begin.",
            "running error analysis",
        ),
        "step": (
            coarse.leap(),
            "Time and window of the search after a step, whether a root is certain, and whether it "
            "goes on.",
            "Newton from the left under a curvature bound",
        ),
        "started": (
            coarse.started(),
            "Distance from the axis, its rate and that of the gap, at the start of a flight.",
            "Table 2",
        ),
        **_excess("coarse_excess", coarse.excess),
        "budget_exceeded": (
            {"budget_exceeded": coarse.lost},
            "Positive if the bounds of the search do not hold.",
            _BOUNDS,
        ),
    }


def _sketch(sketch: AirRingSketch) -> dict[str, Formula]:
    """Return the kernels of the search along a sketch of the path."""
    return {
        "sketched": (
            sketch.begin(),
            "Begin of the search along a sketch of the path, and whether there is one.",
            _BOUNDS,
        ),
        "sketch": (
            sketch.step(),
            "Time of that search after a step, whether it goes on, and whether there is no root.",
            "Newton from the left under a curvature bound",
        ),
    }


def _sketched(own: Parts, index: Value) -> Iterator[Node]:
    """Search along the sketch of the path as far as there can be no root."""
    yield Call(KERNELS["left"], {"index": index})
    begin = given(own["sketched"], horizon="until")
    short = {name: f"short_{name}" for name in ("x", "y", "z", "end")}
    yield Call(begin.kernel, begin.inputs, {**short, "t": "short_t"})
    step = Call(own["sketch"], short | {"t": "short_t"}, {"t": "short_t"})
    # Most searches take more than one step, so lanes are not compacted for the first.
    yield If("sketching", (step,), usual=True)
    yield While("sketching", MAX_SKETCH_STEPS, (step,))
    yield Call(KERNELS["sketched"], {"t": "short_t"})


def _leaping(common: Parts, own: Parts, index: Value) -> Iterator[Node]:
    """Search in single precision, from the begin of the first window."""
    yield Call(KERNELS["beginning"])
    yield Call(KERNELS["left"], {"index": index})
    opened = given(own["opened"], horizon="until")
    windows = ("end", "low1", "high1", "low2", "high2")
    wide = {name: f"wide_{name}" for name in windows if name in opened.kernel.output_names}
    yield Call(opened.kernel, opened.inputs, {**wide, "t": "onset", "latest": "lapsed"})
    yield Call(KERNELS["opened"], {"time": "onset", "horizon": "lapsed"}, {"time": "since"})
    yield Call(own["started"])
    there = {name: f"near_{name}" for name in ("x", "y", "z", "vz")}
    yield Call(common["flight"], {"t": "since"}, there, frozenset(there))
    grain = given(own["resolution"], t="onset", horizon="lapsed", **wide, **there)
    given_away = ("ceiling", "flat", "rate_margin", "share")
    short = {name: f"short_{name}" for name in grain.kernel.output_names if name != "fits"}
    yield Call(grain.kernel, grain.inputs, short)
    yield Call(KERNELS["coarse"], {name: short[name] for name in given_away})
    yield from (
        given(own["coarse_excess"], horizon="latest", share="allowing"),
        given(own["budget_exceeded"], horizon="until"),
        Call(common["out_of_budget"]),
    )
    leap = own["step"]
    inputs = {name: short[name] for name in map(variable, leap.arguments) if name in short}
    step = Call(leap, inputs, {"t": "short_t", "end": "short_end"})
    # Most searches end with the first step, so lanes are not compacted for it.
    yield If("stepping", (step,), usual=True)
    yield While("stepping", MAX_STEPS, (step,))
    yield Call(KERNELS["stepped"], {"lasting": "short_t"})


def _allowing(common: Parts, own: Parts) -> Iterator[Node]:
    """Evaluate the margins for an error budget relative to the flight."""
    allowance = Call(common["allowance"], {"horizon": "latest"})
    if "excess" in own:
        allowance = replace(allowance, wanted=frozenset({"position_level", "velocity_level"}))
        yield given(own["excess"], horizon="latest")
    yield allowance
    margins = given(
        own["margins"],
        horizon="latest",
        position_error="position_level",
        velocity_error="velocity_level",
    )
    renamed = {"margin": "flat", "leaving_margin": "tilt", "rate_margin": "rate_slack"}
    yield Call(margins.kernel, margins.inputs, renamed)


def _decided_advance(common: Parts, own: Parts, index: Value, closes: str) -> Iterator[Node]:
    """Step, and decide whether there is a root; one that is not certain has a smaller budget."""
    yield Call(KERNELS["nearby"], {"index": index})
    yield given(own["advance"], rate_margin="rate_slack")
    yield Call(KERNELS[closes], {"rate_margin": "rate_slack"})
    # A root that is not certain is searched again with a smaller error budget.
    finer = (
        Call(KERNELS["smaller_budget"]),
        *_allowing(common, own),
        Call(KERNELS["budget_undecided"]),
    )
    yield If("needs_refinement", finer)


def _step(common: Parts, own: Parts, index: Value, closes: str) -> Iterator[Node]:
    """Step as far as there can be no root, or take the root, as a decision says."""
    yield from _decided_advance(common, own, index, closes)
    yield Call(KERNELS["advanced"])
    yield If("exhausted", (Call(own["enter"], {"after": "end"}),))


def _passing_step(
    common: Parts, own: Parts, index: Value, counted: tuple[Node, ...]
) -> Iterator[Node]:
    """Step as `_step` does; pass a root that does not count, and the way out behind it."""
    yield from _decided_advance(common, own, index, "gap_closes_bounded")
    yield Call(KERNELS["candidate"])
    polish = (
        Call(own["refine"], {"t": "candidate"}, {"time": "refined"}, frozenset({"time"})),
        Call(KERNELS["refined_candidate"]),
    )
    yield If("met", (*polish, *polish, *counted))
    yield Call(KERNELS["passed"])
    yield If("exhausted", (Call(own["enter"], {"after": "end"}),))


def _landing(common: Parts, own: Parts, index: Value, *, passes: bool) -> Iterator[Node]:
    """Refine the root that was found, with the shot's own errors.

    Bounces that end on this surface for certain are not flagged, whatever is uncertain of a return:
    where balls roll, it is refined, too.
    """
    rolls = "in_contact" in common
    yield Call(KERNELS["found"])
    yield Call(KERNELS["nearby"], {"index": index, "t": "arrival"})
    newton = (
        Call(own["refine"], {"t": "arrival"}, {"time": "refined"}),
        Call(KERNELS["refined_return" if rolls else "refined_root"]),
    )
    # Most roots need two steps, so lanes are not compacted for these.
    usual = _tested(own)
    yield If("refining", newton, usual=usual)
    yield If("refining", newton, usual=usual)
    yield While("refining", NEWTON_LIMIT, newton)
    yield Call(own["margins"], {"horizon": "latest"}, {"margin": "flat", "leaving_margin": "tilt"})
    yield Call(KERNELS["own_margin"])
    if passes:
        yield Call(KERNELS["behind"])
    yield Call(common["crossing"])
    yield Call(KERNELS["arrival_time"])
    yield Call(KERNELS["return_certainty" if rolls else "arrival_certainty"])
