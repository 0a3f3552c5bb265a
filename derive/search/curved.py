"""The search on a curved surface, from the left, whatever bounds it stands on."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import sympy as sp

from ..errors.tangent import carried_normal
from ..ground.choice import AtMost, Choose, Either, Less, Nowhere, every
from ..ground.kernel import Kernel, decision
from ..ground.tree import Do, Guard, Node, Repeat, Value
from .approach import Approach
from .decisions import KERNELS, end, side, t
from .search import Formula, Parts, Search, bounded, edges, given, proposed

STEP_LIMIT = 201
"""Steps after which a search gives up and the shot is uncertain; a search takes about five."""

_BOUNDS = "bounds of the event condition"


def enter(count: int) -> dict[str, sp.Basic]:
    """Return the first window, of those that a search has, that begins no earlier than `after`."""
    after = sp.Symbol("after", real=True)
    lows, highs = (sp.symbols(f"{name}:{count}", real=True) for name in ("low", "high"))
    start, stop, found = t, end, Nowhere()
    for low, high in reversed(list(zip(lows, highs, strict=True))):
        opens = every(Less(low, high), AtMost(after, low))
        start, stop = Choose(opens, low, start), Choose(opens, high, stop)
        found = Either(found, opens)
    return {"t": start, "end": stop, "searching": found}


@dataclass(frozen=True)
class CurvedSearch(Search):
    """The search with what an approach knows of the surface along a flight."""

    approach: Approach

    @property
    def constants(self) -> tuple[sp.Symbol, ...]:
        """What does not change during the flight, and on which side of bounds the search is."""
        return (*self.approach.symbols, side) if self.surface.bounds else self.approach.symbols

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
            "clear": (
                {"clear": approach.clear},
                "Positive if there certainly is no contact before the horizon.",
                _BOUNDS,
            ),
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
                "Newton's next value of a root near t, and the rate there.",
                "Newton's method",
            ),
            "advance": (
                approach.advance(side) if self.surface.bounds else approach.advance(),
                "Gap, rate, bend, a step without a root and its end, Newton's root and its "
                "clearance.",
                "Newton from the left under a curvature bound",
            ),
        }

    @property
    def decisions(self) -> dict[str, Kernel]:
        """Which window comes next, and what lies within the bounds."""
        return edges(self.surface) | {
            "enter": decision(
                f"{self.surface.name}_enter",
                enter(len(self.approach.windows)),
                "The first window that begins no earlier than a time, if there is one.",
            )
        }

    def nodes(self, common: Parts, own: Parts, index: Value) -> Iterator[Node]:
        """Search the first arrival; what certainly misses the surface sits out."""
        yield Do(common["horizon"], {"t": "when"}, {"horizon": "until"})
        yield given(own["clear"], horizon="until")
        yield Do(common.get("opens_in_flight", KERNELS["opens"]))
        step = _bounded_step if self.surface.bounds else _step
        body = (
            given(own["prepare"], horizon="until"),
            Do(KERNELS["beginning"]),
            *_allowing(common, own),
            Do(KERNELS["beyond"]),
            Do(own["enter"], {"after": 0.0, "t": 0.0, "end": 0.0}),
            Do(KERNELS["outside"]),
            Repeat("searching", STEP_LIMIT, tuple(step(common, own, index))),
            Do(KERNELS["questioned"], {"unsure": "searching", "time": "t"}),
            *_landing(common, own, index),
            *proposed(index),
        )
        yield Guard("open", body)


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


def _step(common: Parts, own: Parts, index: Value) -> Iterator[Node]:
    """Step as far as there can be no root, or take the one that is there."""
    yield Do(KERNELS["nearby"], {"index": index})
    yield given(own["advance"], rate_margin="rate_slack")
    yield Do(KERNELS["struck"], {"rate_margin": "rate_slack"})
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
    for _ in range(2):
        yield Do(own["refine"], {"t": "arrival"}, {"time": "refined"})
        yield Do(KERNELS["polished"])
    yield Do(own["margins"], {"horizon": "latest"}, {"margin": "flat", "leaving_margin": "tilt"})
    yield Do(KERNELS["own_margin"])
    yield Do(common["crossing"])
    yield Do(KERNELS["landed"])
    yield Do(KERNELS["landed_surely"])
