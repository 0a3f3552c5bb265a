"""The interface of a search: kernels of a surface along a flight, and nodes of the event loop."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import sympy as sp

from ..errors.propagation import root_rounding
from ..ir.event_tree import Call, Node, Value
from ..ir.kernel import Kernel, decision
from ..motion.flight import Flight
from ..surfaces import Surface
from ..symbolic.conditionals import AtMost, Less, Not, all_of, any_of
from ..symbolic.symbols import variable
from .predicates import KERNELS, clearance

slack = sp.Symbol("slack", nonnegative=True)
"""Bound on the error of a length at a computed arrival (`event_polynomials.displacement`)."""

Parts = Mapping[str, Kernel]
"""Kernels by part."""

Formula = tuple[Mapping[str, sp.Basic], str, str]
"""The outputs of a kernel, its summary, and the equation it implements."""


@dataclass(frozen=True)
class Search(ABC):
    """A search for the arrivals on a surface; times are since the last contact.

    Attributes
    ----------
    surface
        The surface.
    flight
        The motion between contacts.
    """

    surface: Surface
    flight: Flight

    @property
    @abstractmethod
    def formulas(self) -> dict[str, Formula]:
        """The formulas of the kernels that it needs of the surface, by part."""

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
    def remembered(self) -> bool:
        """True if a flight from another body knows that it began on this surface, too."""
        return False

    @property
    def closed(self) -> bool:
        """True if the only arrival is a closed form: such surfaces are searched first."""
        return False

    @property
    def level(self) -> bool:
        """True of a plane along gravity of which a flight's side is decided."""
        return False

    @property
    def reach_test(self) -> dict[str, sp.Basic]:
        """Test of one surface's box against those of a flight; empty if there is none."""
        return {}

    @property
    def approach_test(self) -> dict[str, sp.Basic]:
        """Test whether a flight that comes near may come to the surface; empty if there is none."""
        return {}

    @property
    def apart(self) -> tuple[sp.Basic, ...]:
        """Conditions, each of which implies that a flight does not reach the surface."""
        return ()

    @abstractmethod
    def nodes(self, common: Parts, own: Parts, index: Value) -> Iterator[Node]:
        """Propose the first arrival on the surface of that index.

        Parameters
        ----------
        common
            The kernels that all surfaces share, by part.
        own
            The kernels of this surface, by part.
        index
            The index of the surface in the event log: a number, or the name of a variable that
            holds it.
        """


def proposed(index: Value) -> Iterator[Node]:
    """Take an arrival that is earlier than those found so far."""
    yield Call(KERNELS["tie_undecided"])
    yield Call(KERNELS["earliest"], {"index": index})


def edges(surface: Surface) -> dict[str, Kernel]:
    """Return the decisions whether a contact lies within the bounds (Eq. 2), and is undecided."""
    if not surface.bounds:
        return {}
    patches = numbered(surface.patches)
    surely = all_of(any_of(*(inside(patch) for patch in patches)), Less(0, clearance))
    near = any_of(*(nearly(patch) for patch in patches))
    return {
        "within": decision(
            f"{surface.name}_within",
            {"arrives": any_of(*(within(patch) for patch in patches))},
            "Whether a contact counts (Eq. 2).",
        ),
        "edges": decision(
            f"{surface.name}_edges",
            {"undecided": all_of(near, Not(surely))},
            "Whether the bounds or the crossing lie within their errors.",
        ),
    }


def root_formulas(delay: sp.Expr, flight: Flight) -> dict[str, Formula]:
    """Return the formulas of a contact that the roundings of its condition delay.

    Parameters
    ----------
    delay
        The bound, s.
    flight
        The motion between contacts.
    """
    return {
        "root_delay": (
            {"root_delay": delay},
            "Delay of a contact by the roundings of its condition.",
            "running error analysis",
        ),
        "carry_root": (
            root_rounding(flight),
            "Errors at a contact, with the roundings of the root.",
            "running error analysis",
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
    """Return the condition that all bounds hold (Eq. 2)."""
    return all_of(*(AtMost(g, 0) for g in patch))


def inside(patch: Sequence[sp.Symbol]) -> sp.Basic:
    """Return the condition that all bounds hold whatever the error."""
    return all_of(*(Less(g, -slack) for g in patch))


def nearly(patch: Sequence[sp.Symbol]) -> sp.Basic:
    """Return the condition that all bounds may hold within the error."""
    return all_of(*(AtMost(g, slack) for g in patch))


def bounded(common: Parts, own: Parts, time: str, **inputs: float) -> Iterator[Node]:
    """Test whether a contact at a time lies within the bounds.

    Parameters
    ----------
    common, own
        As for `Search.nodes`.
    time
        The variable that holds the time.
    """
    there = {name: f"there_{name}" for name in "xyz"}
    yield Call(common["flight"], {"t": time}, there, frozenset(there))
    yield given(own["bounds"], **there)
    slackened = given(common["displacement"], horizon=time, **inputs)
    yield Call(slackened.kernel, slackened.inputs, {"margin": "slack"})
    yield given(own["edges"], **inputs)
    yield given(KERNELS["bounds_undecided"], time=time, **inputs)
    yield Call(own["within"])


def given(kernel: Kernel, **inputs: str | float) -> Call:
    """Return the call of a kernel with those of the inputs that it takes."""
    names = set(map(variable, kernel.arguments))
    return Call(kernel, {name: value for name, value in inputs.items() if name in names})
