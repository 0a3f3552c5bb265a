"""`Counterfactual`: the smallest changes with which a shot ends otherwise, in words and numbers."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from decimal import ROUND_CEILING, Decimal
from typing import TYPE_CHECKING, Any, Unpack

import numpy as np

from hoopgen.core.plotting import plotting_module
from hoopgen.core.units import DisplayUnit, display_unit
from hoopgen.report.provenance import describe_scene
from hoopgen.report.quantities import for_json
from hoopgen.results.drawing import CounterfactualOptions
from hoopgen.results.shots import Shots
from hoopgen.scene.lookup import variables_of
from hoopgen.study.result import Result
from hoopgen.text.numbers import MINUS, format_count
from hoopgen.text.shorten import join_names
from hoopgen.text.tables import table

if TYPE_CHECKING:
    from hoopgen.results.drawing import Drawn

_DIGITS = 3
"""Significant digits of a change in a sentence, rounded up."""

_WAYS: Mapping[str, tuple[str, str]] = {
    "azimuth": ("further to the left", "further to the right"),
    "height": ("higher up", "lower down"),
    "distance": ("further away", "closer"),
}
"""Words for more and for less of a variable; of all others they are those two."""


@dataclass(frozen=True)
class Change:
    """A change of one variable with which a shot ends otherwise, the other variables as they are.

    Attributes
    ----------
    name
        The variable.
    value
        Of the shot; SI.
    unchanged
        A value just before `changed`, with which it still ends as it did.
    changed
        The value with which it ends otherwise; NaN if there is none in `searched`.
    outcome
        How it then ends; empty if there is none.
    contacts
        How many contacts it then has; 0 if there is none.
    searched
        The range in which values were tried. A narrower interval than the steps between them may be
        overlooked.
    proved
        Whether ball arithmetic has proved how the shot ends with `unchanged` and with `changed`;
        None if no proof was wanted, or there is no change.
    """

    name: str
    value: float
    unchanged: float
    changed: float
    outcome: str
    contacts: int
    searched: tuple[float, float]
    proved: bool | None

    @property
    def amount(self) -> float:
        """The change itself, `changed` less `value`; NaN if there is none."""
        return self.changed - self.value


@dataclass(frozen=True, repr=False)
class Counterfactual(Result):
    """A shot and the smallest changes with which it ends otherwise.

    Attributes
    ----------
    outcome
        How the shot ends.
    end
        The end that counts.
    succeeds
        Whether the shot ends there. If so, the changes lose it; if not, they win it.
    contacts
        How many contacts the shot has.
    proved
        Whether ball arithmetic has proved how it ends; None if no proof was wanted.
    changes
        Of each variable its smallest change, in the order of the question.
    shots
        The shot itself, then it with each of the changes that there are, simulated with
        ``record=True``.
    """

    outcome: str
    end: str
    succeeds: bool
    contacts: int
    proved: bool | None
    changes: tuple[Change, ...]
    shots: Shots

    def __str__(self) -> str:
        lines = [self.sentence, "", table(*self._table(), right=[1, 2])]
        proofs = [self.proved, *(change.proved for change in self.changes)]
        if any(one is False for one in proofs):
            names = ("how the shot ends", *(f"the change of {one.name}" for one in self.changes))
            without = (name for name, one in zip(names, proofs, strict=True) if one is False)
            lines += ["", f"Not proved: {join_names(without)}."]
        elif self.proved:
            lines += ["", "Proved in ball arithmetic: the shot itself, and both sides of a change."]
        return "\n".join([*lines, f"scene  {self.scene}"])

    @property
    def sentence(self) -> str:
        """The answer in a sentence."""
        found = [change for change in self.changes if not math.isnan(change.changed)]
        others = [change for change in self.changes if math.isnan(change.changed)]
        said = f"The shot is {self.outcome}."
        if found:
            ways = _alternatives([self._words(change) for change in found])
            said += f" It is {'lost' if self.succeeds else self.end} with {ways}."
        if others:
            names = _alternatives([self._label(change) for change in others])
            said += f" No change of {names} that was tried alters this."
        return said

    def as_dict(self) -> dict[str, Any]:
        """Return everything but the shots, in types that JSON knows; SI."""
        return {
            "outcome": self.outcome,
            "end": self.end,
            "succeeds": self.succeeds,
            "contacts": self.contacts,
            "proved": self.proved,
            "changes": [for_json(asdict(one) | {"amount": one.amount}) for one in self.changes],
            "scene": self.scene,
        }

    @property
    def names(self) -> list[str]:
        """Names of `shots`: the outcome of the first one, and the changes of the others."""
        found = [change for change in self.changes if not math.isnan(change.changed)]
        return [self.outcome, *(f"{self._words(one)}: {one.outcome}" for one in found)]

    @property
    def scene(self) -> str:
        """The scene in words."""
        parameters = {name: float(np.ravel(v)[0]) for name, v in self.shots.parameters.items()}
        return describe_scene(self.shots.scene, parameters)

    def plot(self, *, ax: Drawn | None = None, **options: Unpack[CounterfactualOptions]) -> Drawn:
        """Draw the path of the shot and those with the changes.

        Parameters
        ----------
        ax, **options
            As for `hoopgen.plots.plot_counterfactual`.

        Returns
        -------
        Figure or Axes
            As of `hoopgen.plots.plot_counterfactual`.

        Raises
        ------
        ImportError
            If matplotlib is missing.
        """
        drawn: Drawn = plotting_module().plot_counterfactual(self, ax=ax, **options)
        return drawn

    def _label(self, change: Change) -> str:
        return str(change.name.replace("_", " "))

    def _unit(self, change: Change) -> DisplayUnit:
        return display_unit(variables_of(self.shots.scene)[change.name].kind)

    def _words(self, change: Change) -> str:
        unit, more = self._unit(change), change.amount > 0.0
        amount = f"{_rounded_up(abs(change.amount) / unit.size)}{_spaced(unit.symbol)}"
        if change.name in _WAYS:
            return f"{amount} {_WAYS[change.name][not more]}"
        return f"{amount} {'more' if more else 'less'} {self._label(change)}"

    def _table(self) -> tuple[list[str], list[list[str]]]:
        head = ["variable", "change", "value", "then"]
        rows = []
        for change in self.changes:
            unit = self._unit(change)
            symbol = _spaced(unit.symbol)
            if math.isnan(change.changed):
                low, high = (f"{end / unit.size:.4g}" for end in change.searched)
                rows.append([self._label(change), "none", "", f"from {low} to {high}{symbol}"])
                continue
            sign = "+" if change.amount > 0.0 else MINUS
            digits = _digits(change.amount / unit.size, change.changed / unit.size)
            rows.append(
                [
                    self._label(change),
                    f"{sign}{_rounded_up(abs(change.amount) / unit.size)}{symbol}",
                    f"{change.changed / unit.size:.{digits}f}{symbol}".replace("-", MINUS),
                    f"{change.outcome}, {format_count(change.contacts, 'contact')}",
                ]
            )
        return head, rows


def _alternatives(words: Sequence[str]) -> str:
    *others, last = words
    return f"{', '.join(others)} or {last}" if others else last


def _spaced(symbol: str) -> str:
    return symbol if symbol in ("", "°") else f" {symbol}"


def _rounded_up(size: float) -> str:
    """Return a positive number with a few significant digits, rounded up."""
    places = _DIGITS - 1 - math.floor(math.log10(size))
    up = Decimal(size).quantize(Decimal(1).scaleb(-places), ROUND_CEILING)
    return f"{up:f}" if places < 7 else f"{up:.{_DIGITS - 1}e}"


def _digits(change: float, value: float) -> int:
    """Return the number of decimals that show a change of a value."""
    size = abs(change) or abs(value) or 1.0
    return min(max(_DIGITS - 1 - math.floor(math.log10(size)), 0), 15)
