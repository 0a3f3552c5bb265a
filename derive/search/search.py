"""What a search is: kernels of a surface along a flight, and what the event loop does with them."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import sympy as sp

from ..flight.flight import Flight
from ..ground.choice import AtMost, Less, Not, every, some
from ..ground.kernel import Kernel, decision
from ..ground.symbols import variable
from ..ground.tree import Do, Node, Value
from ..surfaces import Surface
from .decisions import KERNELS, clearance

slack = sp.Symbol("slack", nonnegative=True)
"""Bound on the error of a length at a computed arrival (`events.displacement`)."""

Parts = Mapping[str, Kernel]

Formula = tuple[Mapping[str, sp.Basic], str, str]
"""The outputs of a kernel, its summary, and the equation it implements."""


@dataclass(frozen=True)
class Search(ABC):
    """How the arrivals on a surface are found; times since the last contact."""

    surface: Surface
    flight: Flight

    @property
    @abstractmethod
    def formulas(self) -> dict[str, Formula]:
        """The kernels that it needs of the surface, by part."""

    @property
    def decisions(self) -> dict[str, Kernel]:
        """The decisions that it needs of the surface, by part."""
        return {}

    @property
    def constants(self) -> tuple[sp.Symbol, ...]:
        """Symbols of its own that its kernels pass to each other."""
        return ()

    @property
    def single(self) -> frozenset[str]:
        """The parts of `formulas` that are computed in single precision."""
        return frozenset()

    @property
    def closed(self) -> bool:
        """True if its only arrival is a closed form: such surfaces are looked at first."""
        return False

    @property
    def apart(self) -> tuple[sp.Basic, ...]:
        """Conditions, each of which means that a flight does not come to it until the horizon."""
        return ()

    @abstractmethod
    def nodes(self, common: Parts, own: Parts, index: Value) -> Iterator[Node]:
        """Propose the first arrival on the surface of that index."""


def proposed(index: Value) -> Iterator[Node]:
    """Take an arrival that is earlier than those found so far."""
    yield Do(KERNELS["tied"])
    yield Do(KERNELS["sooner"], {"index": index})


def edges(surface: Surface) -> dict[str, Kernel]:
    """Return whether a contact lies within the bounds (Eq. 2), and whether that is in doubt."""
    if not surface.bounds:
        return {}
    patches = numbered(surface.patches)
    surely = every(some(*(inside(patch) for patch in patches)), Less(0, clearance))
    near = some(*(nearly(patch) for patch in patches))
    return {
        "within": decision(
            f"{surface.name}_within",
            {"arrives": some(*(within(patch) for patch in patches))},
            "Where a contact counts (Eq. 2).",
        ),
        "edges": decision(
            f"{surface.name}_edges",
            {"unsure": every(near, Not(surely))},
            "Where that, or the crossing, lies within its error.",
        ),
    }


def numbered(patches: Sequence[Sequence[sp.Expr]]) -> list[tuple[sp.Symbol, ...]]:
    """Return the symbols of bounds by part: g0, g1, ... through all of them."""
    starts = [sum(map(len, patches[:k])) for k in range(len(patches))]
    return [
        sp.symbols(f"g{start}:{start + len(patch)}", real=True)
        for start, patch in zip(starts, patches, strict=True)
    ]


def within(patch: Sequence[sp.Symbol]) -> sp.Basic:
    """Return where all bounds hold (Eq. 2)."""
    return every(*(AtMost(g, 0) for g in patch))


def inside(patch: Sequence[sp.Symbol]) -> sp.Basic:
    """Return where they hold whatever the error."""
    return every(*(Less(g, -slack) for g in patch))


def nearly(patch: Sequence[sp.Symbol]) -> sp.Basic:
    """Return where they hold, or could but for the error."""
    return every(*(AtMost(g, slack) for g in patch))


def bounded(common: Parts, own: Parts, time: str, **inputs: float) -> Iterator[Node]:
    """Look whether a contact at a time lies within the bounds."""
    there = {name: f"there_{name}" for name in "xyz"}
    yield Do(common["flight"], {"t": time}, there, frozenset(there))
    yield given(own["bounds"], **there)
    slackened = given(common["displacement"], horizon=time, **inputs)
    yield Do(slackened.kernel, slackened.inputs, {"margin": "slack"})
    yield given(own["edges"], **inputs)
    yield given(KERNELS["questioned"], time=time)
    yield Do(own["within"])


def given(kernel: Kernel, **inputs: str | float) -> Do:
    """Return the evaluation of a kernel, given those of the inputs that it takes."""
    names = set(map(variable, kernel.arguments))
    return Do(kernel, {name: value for name, value in inputs.items() if name in names})
