"""Arrival on a plane that ends a shot, and which of its ends is reached there."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..ground.choice import Both, Choose, Either, Not, Nowhere
from ..ground.kernel import Kernel, decision
from ..surfaces import Gate
from .plane import PlaneSearch
from .search import Formula, inside, nearly, numbered, within


def reached(gate: Gate) -> sp.Basic:
    """Return the outcome of a crossing: the first end whose bounds hold.

    A crossing counts within the bounds of some end: within none of the others', the last's.
    """
    *others, last = zip(numbered(gate.parts), gate.outcomes, strict=True)
    found: sp.Basic = sp.Integer(last[1])
    for bounds, outcome in reversed(others):
        found = Choose(within(bounds), outcome, found)
    return found


def edge(gate: Gate) -> sp.Basic:
    """Return where that is in doubt: an end's bounds may hold, and none's before it surely do."""
    found: sp.Basic = Nowhere()
    for bounds in reversed(numbered(gate.parts)):
        if bounds:
            unsure = Both(nearly(bounds), Not(inside(bounds)))
            later = Both(Not(inside(bounds)), found)
            found = unsure if found == Nowhere() else Either(unsure, later)
    return found


@dataclass(frozen=True)
class GateSearch(PlaneSearch):
    """The search on a plane whose crossing ends a shot."""

    surface: Gate

    @property
    def formulas(self) -> dict[str, Formula]:
        """Those of a plane, and the bounds of all ends."""
        sides = {f"g{k}": side for k, side in enumerate(self.surface.sides)}
        if not sides:
            return super().formulas
        said = "The bounds of the ends on a plane: the first whose bounds all hold is reached."
        return super().formulas | {"bounds": (sides, said, "Table 2, success")}

    @property
    def decisions(self) -> dict[str, Kernel]:
        """Whether a crossing counts, and which end is reached."""
        name = self.surface.name
        made = {"reached": reached(self.surface)}
        found = {"reached": decision(f"{name}_reached", made, "The end that a crossing reaches.")}
        if self.surface.sides:
            vague = {"edge": edge(self.surface)}
            said = "Whether that lies within its error."
            found["edge"] = decision(f"{name}_edge", vague, said)
        return super().decisions | found
