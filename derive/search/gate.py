"""Arrival on a plane that ends a shot, and which of its ends is reached there."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..ground.choice import Both, Choose, Either, Equal, Not, Nowhere
from ..ground.kernel import Kernel, decision
from ..surfaces import Gate
from .decisions import through
from .plane import PlaneSearch
from .search import Formula, inside, nearly, numbered, within


def reached(gate: Gate) -> sp.Basic:
    """Return the outcome of a crossing: the first end whose bounds hold.

    A crossing counts within the bounds of some end: within none of the others', the last's.
    """
    *others, last = zip(numbered(gate.parts), gate.passed, gate.outcomes, strict=True)
    found: sp.Basic = sp.Integer(last[2])
    for bounds, passed, outcome in reversed(others):
        found = Choose(_of_fallen(passed, within(bounds)), outcome, found)
    return found


def _of_fallen(passed: bool, holds: sp.Basic) -> sp.Basic:
    """Return where an end's bounds hold, and the ball is one that the end is for."""
    return Both(holds, Equal(through, 1)) if passed else holds


def edge(gate: Gate) -> sp.Basic:
    """Return where that is in doubt: an end's bounds may hold, and none's before it surely do."""
    found: sp.Basic = Nowhere()
    for bounds, passed in reversed(list(zip(numbered(gate.parts), gate.passed, strict=True))):
        if bounds:
            unsure = _of_fallen(passed, Both(nearly(bounds), Not(inside(bounds))))
            later = Both(Not(_of_fallen(passed, inside(bounds))), found)
            found = unsure if found == Nowhere() else Either(unsure, later)
    return found


@dataclass(frozen=True)
class GateSearch(PlaneSearch):
    """The search on a plane whose crossing ends a shot."""

    surface: Gate

    @property
    def apart(self) -> tuple[sp.Basic, ...]:
        """It is looked at always: only then is known how long a flight is."""
        return ()

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
