"""Arrival on a plane that ends a shot, and which of its ends the crossing reaches."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..ir.kernel import Kernel, decision
from ..surfaces import EndPlane
from ..symbolic.conditionals import And, Choose, Equal, Not, Or, false
from .plane import PlaneSearch
from .predicates import through
from .root_search import PlaneRootSearch
from .search import Formula, inside, nearly, numbered, within


def reached(end_plane: EndPlane) -> sp.Basic:
    """Return the outcome of a crossing: that of the first end whose bounds hold.

    A crossing counts within the bounds of some end; if none of the others' hold, it is the last.
    """
    *others, last = zip(
        numbered(end_plane.parts), end_plane.passed, end_plane.outcomes, strict=True
    )
    found: sp.Basic = sp.Integer(last[2])
    for bounds, passed, outcome in reversed(others):
        found = Choose(_of_fallen(passed, within(bounds)), outcome, found)
    return found


def _of_fallen(passed: bool, holds: sp.Basic) -> sp.Basic:
    """Return the condition that an end's bounds hold, and that it is an end for this ball."""
    return And(holds, Equal(through, 1)) if passed else holds


def edge(end_plane: EndPlane) -> sp.Basic:
    """Return the condition that the choice of the end is undecided.

    The bounds of some end may hold, and those of no end before it certainly do.
    """
    found: sp.Basic = false
    for bounds, passed in reversed(
        list(zip(numbered(end_plane.parts), end_plane.passed, strict=True))
    ):
        if bounds:
            undecided = _of_fallen(passed, And(nearly(bounds), Not(inside(bounds))))
            later = And(Not(_of_fallen(passed, inside(bounds))), found)
            found = undecided if found == false else Or(undecided, later)
    return found


def _side_formulas(end_plane: EndPlane) -> dict[str, Formula]:
    """Return the formulas of the bounds of all ends."""
    sides = {f"g{k}": side for k, side in enumerate(end_plane.sides)}
    if not sides:
        return {}
    summary = "Bounds of the ends on a plane; the first whose bounds all hold is reached."
    return {"bounds": (sides, summary, "Table 2, success")}


def _end_decisions(end_plane: EndPlane) -> dict[str, Kernel]:
    """Return the decisions which end is reached, and whether that is undecided."""
    name = end_plane.name
    made = {"reached": reached(end_plane)}
    found = {"reached": decision(f"{name}_reached", made, "End that a crossing reaches.")}
    if end_plane.sides:
        vague = {"edge": edge(end_plane)}
        summary = "Whether the choice of the end lies within its error."
        found["edge"] = decision(f"{name}_edge", vague, summary)
    return found


@dataclass(frozen=True)
class EndPlaneSearch(PlaneSearch):
    """The search on a plane whose crossing ends a shot."""

    surface: EndPlane

    @property
    def apart(self) -> tuple[sp.Basic, ...]:
        """No condition: the plane is always searched, since it bounds the length of a flight."""
        return ()

    @property
    def formulas(self) -> dict[str, Formula]:
        """The formulas of a plane, and the bounds of all ends."""
        return super().formulas | _side_formulas(self.surface)

    @property
    def decisions(self) -> dict[str, Kernel]:
        """The decisions whether a crossing counts, and which end is reached."""
        return super().decisions | _end_decisions(self.surface)


@dataclass(frozen=True)
class EndPlaneRootSearch(PlaneRootSearch):
    """The same along a path on which the crossing is no closed form."""

    surface: EndPlane

    @property
    def formulas(self) -> dict[str, Formula]:
        """The formulas of a root search, and the bounds of all ends."""
        return super().formulas | _side_formulas(self.surface)

    @property
    def decisions(self) -> dict[str, Kernel]:
        """The decisions whether a crossing counts, and which end is reached."""
        return super().decisions | _end_decisions(self.surface)
