"""The interpretation of a table in words: the meaning of each column, and what is assumed."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from shlex import quote

from hoopgen.core.units import unit_symbol
from hoopgen.core.variables import STATE, is_state
from hoopgen.engine.compiled_scene import CompiledScene
from hoopgen.report.provenance import describe_release
from hoopgen.scene.lookup import STATES, variables_of
from hoopgen.text.shorten import cut, join_names

from .columns import Column
from .suggestions import likely_variable

_NO_SPIN = STATE[6:]
_DEFAULTS = ("azimuth", "backspin", "sidespin", "angle")
"""Arguments of `hoopgen.release` that are 0 where nothing says them."""


@dataclass(frozen=True)
class Interpretation:
    """The interpretation of each column, and the values of variables without a column.

    Attributes
    ----------
    read
        By column that is read: the variable, and its unit, empty for a plain number.
    not_read
        By column that is not read: the variable that it may be meant for, or nothing.
    """

    read: Mapping[str, tuple[str, str]]
    not_read: Mapping[str, str]
    results: Sequence[str]  # columns of earlier results, which are not read
    given: Mapping[str, float]  # values of variables that all rows share, SI
    assumed: Mapping[str, float]  # values of variables that nothing says, SI
    decimal_comma: bool  # whether numbers have decimal commas
    scene: CompiledScene  # in which the shots are

    def __str__(self) -> str:
        read = [
            f"{cut(column)} as {variable}{f' in {unit}' if unit else ''}"
            for column, (variable, unit) in self.read.items()
        ]
        plain = [name for name, variable in self.not_read.items() if not variable]
        asked = [
            f"{cut(name)} (did you mean --column {quote(f'{variable}={cut(name)}')}?)"
            for name, variable in self.not_read.items()
            if variable
        ]
        comma = ", with decimal commas" if self.decimal_comma else ""
        lines = {
            "read": ", ".join(read) + comma,
            "not read": ", ".join([*asked, *([join_names(plain)] if plain else [])]),
            "earlier results, not read": join_names(self.results),
            "given": self._values(self.given),
            "assumed": self._values(self.assumed),
        }
        return "\n".join(f"{name}: {text}" for name, text in lines.items() if text)

    def _values(self, values: Mapping[str, float]) -> str:
        return describe_release(values, self.scene)


def interpret(
    names: Iterable[str],
    columns: Mapping[str, Column],
    given: Mapping[str, float],
    scene: CompiledScene,
    *,
    own: Iterable[str] = (),
    results: Sequence[str] = (),
    decimal_comma: bool = False,
) -> Interpretation:
    """Return the interpretation of a table.

    Parameters
    ----------
    given
        Values of variables that all rows share, SI.
    own
        Columns that the caller says are not to be read.
    """
    known = {**STATES, **variables_of(scene)}
    read = {
        one.name: (variable, unit_symbol(one.unit, known[variable].kind))
        for variable, one in columns.items()
    }
    said = {*columns, *given}
    absent = _absent(said)
    kinds = {name: one.kind for name, one in known.items()}
    kept, former = set(own), set(results)
    not_read = {
        name: "" if name in kept else likely_variable(name, kinds, absent)
        for name in names
        if name not in read and name not in former
    }
    return Interpretation(read, not_read, tuple(results), dict(given), absent, decimal_comma, scene)


def _absent(said: set[str]) -> dict[str, float]:
    """Return the variables that nothing says and that are 0 then."""
    if is_state(said):
        return {name: 0.0 for name in _NO_SPIN if name not in said}
    placed = "x" in said or "y" in said
    return {
        name: 0.0 for name in _DEFAULTS if name not in said and not (placed and name == "angle")
    }
