"""The search on a curved surface, from the left, whatever bounds it stands on."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import sympy as sp

from ..errors.tangent import carried_normal
from ..ground.kernel import Kernel, decision
from ..ground.symbols import variable
from ..ground.tree import Do, Guard, Node, Repeat, Value
from .approach import Approach
from .coarse import TURNS, CoarseRing
from .decisions import KERNELS, side
from .search import Formula, Parts, Search, bounded, edges, given, proposed
from .windows import enter, opening

STEP_LIMIT = 201
"""Steps after which a search gives up and the shot is uncertain; a search takes about five."""

NEWTON_LIMIT = 8
"""Steps of Newton's method at the most; from h < 2^-3 it takes four."""

_BOUNDS = "bounds of the event condition"


@dataclass(frozen=True)
class CurvedSearch(Search):
    """The search with what an approach knows of the surface along a flight.

    Attributes
    ----------
    approach
        That knowledge.
    coarse
        The same in single precision, if that serves.
    """

    approach: Approach
    coarse: CoarseRing | None = None

    @property
    def constants(self) -> tuple[sp.Symbol, ...]:
        """What does not change during the flight, and what the search keeps of its way."""
        if self.surface.bounds:
            return (*self.approach.symbols, side)
        return (*self.approach.symbols, *(self.coarse.passed if self.coarse else ()))

    @property
    def formulas(self) -> dict[str, Formula]:
        """What the approach says, as kernels."""
        approach = self.approach
        return {
            "carry_normal": (
                carried_normal(self.surface),
                "Error of the normal, from that of the position.",
                "derivative of Table 2's normal",
            ),
            **({} if approach.clear is None else _clear(approach.clear)),
            "prepare": (
                approach.prepare(),
                "Constants and windows of the search along a flight, and the errors it allows for.",
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
                approach.advance(side) if self.surface.bounds else approach.advance(),
                "Gap, rate, bend, a step without a root, its end, and the clearance of a root.",
                "Newton from the left under a curvature bound",
            ),
            **({} if self.coarse is None else _coarse(self.coarse)),
        }

    @property
    def single(self) -> frozenset[str]:
        """What of the search in single precision is computed in it."""
        return frozenset({"opened", "grain", "leap"})

    @property
    def decisions(self) -> dict[str, Kernel]:
        """Which window comes next, and what lies within the bounds."""
        return edges(self.surface) | {
            "enter": decision(
                f"{self.surface.name}_enter",
                enter(opening(len(self.approach.windows))),
                "The first window that ends later than a time, if there is one, from then on.",
            )
        }

    def nodes(self, common: Parts, own: Parts, index: Value) -> Iterator[Node]:
        """Search the first arrival; what certainly misses the surface sits out."""
        yield Do(common["horizon"], {"t": "when"}, {"horizon": "until"})
        step = tuple(self._step(common, own, index))
        prepared = given(own["prepare"], horizon="until")
        allowing = tuple(_allowing(common, own))
        found = (
            Repeat("searching", STEP_LIMIT, step),
            Do(KERNELS["questioned"], {"unsure": "searching", "time": "t"}),
        )
        if self.coarse is None:
            first = Do(own["enter"], {"after": 0.0, "t": 0.0, "end": 0.0})
            begun = (prepared, Do(KERNELS["beginning"]), *allowing, Do(KERNELS["outside"]))
            if "clear" in own:
                begun = (*begun, Do(KERNELS["beyond"]), first)
            else:
                # Most searches end with the first step: it needs no list.
                begun = (*begun, first, Do(KERNELS["beyond_windows"]), Guard("searching", step))
            search: tuple[Node, ...] = (*begun, *found)
        else:
            entered = Do(own["enter"], {"after": "t", "end": 0.0})
            again = (prepared, *allowing, entered, *found)
            leaping = _leaping(common, own, index)
            search = (*leaping, Guard("searching", again))
        searched = (*search, *_landing(common, own, index), *proposed(index))
        if "clear" not in own:
            yield from searched
            return
        yield given(own["clear"], horizon="until")
        yield Do(common.get("opens_in_flight", KERNELS["opens"]))
        yield Guard("open", searched)

    def _step(self, common: Parts, own: Parts, index: Value) -> Iterator[Node]:
        """Step as far as there can be no root, or take the one that is there."""
        if self.surface.bounds:
            return _bounded_step(common, own, index)
        return _step(common, own, index, "struck" if self.coarse else "struck_or_still")


def _clear(clear: sp.Expr) -> dict[str, Formula]:
    said = "Positive if there certainly is no contact before the horizon."
    return {"clear": ({"clear": clear}, said, _BOUNDS)}


def _coarse(coarse: CoarseRing) -> dict[str, Formula]:
    """Return the kernels of the search in single precision."""
    return {
        "opened": (
            coarse.opened(),
            "Windows of the search along a flight, and whether single precision serves for it.",
            _BOUNDS,
        ),
        "grain": (
            coarse.grain(),
            "What a search in single precision is given, from where it begins.",
            "running error analysis",
        ),
        "leap": (
            coarse.leap(),
            "Where a search is after a step, in which window, whether surely before a root, "
            "and whether it goes on.",
            "Newton from the left under a curvature bound",
        ),
        "started": (
            coarse.started(),
            "Distance from the axis, its rate and that of the gap, at the start of a flight.",
            "Table 2",
        ),
        "lost": (
            {"lost": coarse.lost},
            "Positive where the bounds of the search do not hold.",
            _BOUNDS,
        ),
    }


def _leaping(common: Parts, own: Parts, index: Value) -> Iterator[Node]:
    """Search in single precision, from where the first window opens."""
    yield Do(KERNELS["beginning"])
    yield Do(KERNELS["left"], {"index": index})
    opened = given(own["opened"], horizon="until")
    windows = ("end", "low1", "high1", "low2", "high2")
    wide = {name: f"wide_{name}" for name in windows if name in opened.kernel.output_names}
    yield Do(opened.kernel, opened.inputs, {**wide, "t": "onset", "latest": "lapsed"})
    yield Do(KERNELS["opened"], {"time": "onset", "horizon": "lapsed"}, {"time": "since"})
    yield Do(own["started"])
    there = {name: f"near_{name}" for name in ("x", "y", "z", "vz")}
    yield Do(common["flight"], {"t": "since"}, there, frozenset(there))
    grain = given(own["grain"], t="onset", horizon="lapsed", **wide, **there)
    given_away = ("ceiling", "flat", "rate_margin", "share")
    short = {name: f"short_{name}" for name in grain.kernel.output_names if name != "fits"}
    yield Do(grain.kernel, grain.inputs, short)
    yield Do(KERNELS["coarse"], {name: short[name] for name in given_away})
    allowance = Do(common["allowance"], {"horizon": "latest", "share": "allowing"})
    yield from (allowance, given(own["lost"], horizon="until"), Do(KERNELS["beyond"]))
    leap = own["leap"]
    kept = {name: short[name] for name in map(variable, leap.arguments) if name in short}
    step = Do(leap, kept, {"t": "short_t", "end": "short_end"})
    # Most searches end with the first step: it needs no list.
    yield Guard("leaping", (step,))
    yield Repeat("leaping", TURNS, (step,))
    yield Do(KERNELS["leapt"], {"lasting": "short_t"})


def _allowing(common: Parts, own: Parts) -> Iterator[Node]:
    """Allow for errors that are a share of the flight."""
    yield Do(common["allowance"], {"horizon": "latest"})
    margins = given(
        own["margins"],
        horizon="latest",
        position_error="position_level",
        velocity_error="velocity_level",
    )
    renamed = {"margin": "flat", "leaving_margin": "tilt", "rate_margin": "rate_slack"}
    yield Do(margins.kernel, margins.inputs, renamed)


def _step(common: Parts, own: Parts, index: Value, struck: str) -> Iterator[Node]:
    """Step as far as there can be no root, or take the one that is there, as a decision says."""
    yield Do(KERNELS["nearby"], {"index": index})
    yield given(own["advance"], rate_margin="rate_slack")
    yield Do(KERNELS[struck], {"rate_margin": "rate_slack"})
    # A root that is not certain is looked at again, with smaller errors allowed.
    finer = (Do(KERNELS["finer"]), *_allowing(common, own), Do(KERNELS["exceeded"]))
    yield Guard("vague", finer)
    yield Do(KERNELS["advanced"])
    yield Guard("exhausted", (Do(own["enter"], {"after": "end"}),))


def _bounded_step(common: Parts, own: Parts, index: Value) -> Iterator[Node]:
    """Step as `_step` does; a root out of bounds is passed, and so is the way out behind it."""
    yield Do(KERNELS["nearby"], {"index": index})
    yield given(own["advance"], rate_margin="rate_slack")
    yield Do(KERNELS["struck_bounded"], {"rate_margin": "rate_slack"})
    finer = (Do(KERNELS["finer"]), *_allowing(common, own), Do(KERNELS["exceeded"]))
    yield Guard("vague", finer)
    yield Do(KERNELS["candidate"])
    polish = (
        Do(own["refine"], {"t": "candidate"}, {"time": "refined"}, frozenset({"time"})),
        Do(KERNELS["refined_candidate"]),
    )
    within = bounded(common, own, "candidate", delay=0.0, clearance=1.0)
    yield Guard("met", (*polish, *polish, *within))
    yield Do(KERNELS["passed"])
    yield Guard("exhausted", (Do(own["enter"], {"after": "end"}),))


def _landing(common: Parts, own: Parts, index: Value) -> Iterator[Node]:
    """Refine what was found, with the shot's own errors."""
    yield Do(KERNELS["found"])
    yield Do(KERNELS["nearby"], {"index": index, "t": "arrival"})
    newton = (
        Do(own["refine"], {"t": "arrival"}, {"time": "refined"}),
        Do(KERNELS["polished"]),
    )
    # Most need two: these need no list.
    yield Guard("refining", newton)
    yield Guard("refining", newton)
    yield Repeat("refining", NEWTON_LIMIT, newton)
    yield Do(own["margins"], {"horizon": "latest"}, {"margin": "flat", "leaving_margin": "tilt"})
    yield Do(KERNELS["own_margin"])
    yield Do(common["crossing"])
    yield Do(KERNELS["landed"])
    yield Do(KERNELS["landed_surely"])
