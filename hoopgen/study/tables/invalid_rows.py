"""The invalid rows of a table, and the reasons, as text."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import islice
from math import isnan
from typing import Any

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from hoopgen.core.variables import Releases
from hoopgen.engine.compiled_scene import CompiledScene
from hoopgen.simulation.invalid_shots import allowed, reason
from hoopgen.text.shorten import brief, cut

from .columns import Column, numbers

SHOWN = 5
"""Invalid rows that are listed."""


@dataclass
class InvalidRows:
    """The rows of a table that cannot be simulated, or are not: the first ones, and all by cause.

    Attributes
    ----------
    first
        Numbers of rows, from 1, and why each is invalid: the first `SHOWN`.
    causes
        Number of rows by cause; of several causes of a row the first.
    """

    first: list[tuple[int, str]] = field(default_factory=list)
    causes: Counter[str] = field(default_factory=Counter)

    def add(self, numbers: Sequence[int], why: Sequence[str]) -> None:
        """Note rows and their reasons.

        Parameters
        ----------
        numbers
            The numbers of the rows in the table, from 1.
        why
            The reason of each, as `shot_reason` gives it.
        """
        more = zip(numbers, why, strict=True)
        self.first += list(islice(more, max(0, SHOWN - len(self.first))))
        self.causes.update(map(cause, why))

    def __str__(self) -> str:
        lines = [f"invalid: row {row:,}: {why}" for row, why in self.first]
        more = self.causes.total() - len(self.first)
        if more:
            causes = ", ".join(f"{count:,} {why}" for why, count in self.causes.most_common())
            lines += [f"invalid: and {more:,} more; by cause {causes}"]
        return "\n".join(lines)


def reasons(
    table: pa.Table,
    columns: Mapping[str, Column],
    given: Mapping[str, NDArray[np.float64]],
    shot: Callable[[int], str] | None = None,
    *,
    malformed: Sequence[str],
    comma: bool = False,
) -> list[str]:
    """Return why each row cannot be simulated, or is not.

    Parameters
    ----------
    table
        Rows that are invalid, all of them.
    given
        The numbers that were read, (n,) each, NaN where a cell has none.
    shot
        Says what is wrong with the shot of a row all of whose cells are numbers; see `shot_reason`.
        None where there is no such row.
    malformed
        Why a row has no cells, "" where it has.
    comma
        Whether numbers in text may have decimal commas.

    Returns
    -------
    list of str
        A text for each row; before its first colon or semicolon stands the cause, see `cause`.
    """
    cells = [_cells(table, columns[name], np.isnan(given[name]), comma) for name in columns]
    parts: list[list[str]] = [[] for _ in range(table.num_rows)]
    for name, texts in zip(columns, cells, strict=True):
        for row, text in zip(np.flatnonzero(np.isnan(given[name])), texts, strict=True):
            parts[row].append(text)
    return [
        malformed[row] or "; ".join(texts) or (shot(row) if shot else "")
        for row, texts in enumerate(parts)
    ]


def cause(reason: str) -> str:
    """Return the cause in a reason, which many rows may have in common."""
    return reason.partition(": ")[0].partition("; ")[0]


def _cells(table: pa.Table, column: Column, wrong: NDArray[np.bool_], comma: bool) -> list[str]:
    """Return the reasons why cells of a column gave no number."""
    rows = np.flatnonzero(wrong)
    part = table.select([column.name]).take(rows)
    found, name = numbers(part, column, comma), cut(column.name)
    low, high = (f"{end / column.unit:g}" for end in column.limits)
    return [
        _cell(name, cell)
        if isnan(number)
        else f"implausible {name}: {number / column.unit:g} is not within {low} to {high}"
        for number, cell in zip(found, part[column.name].to_pylist(), strict=True)
    ]


def _cell(column: str, cell: Any) -> str:
    """Return the reason why a cell gave no allowed number."""
    if cell is None or (isinstance(cell, str) and not cell.strip()):
        return f"no value in {column}"
    try:
        number = float(cell)
    except ValueError:
        return f"no number in {column}: {brief(cell)}"
    return f"no value in {column}" if isnan(number) else f"not finite: {column}"


def shot_reason(releases: Releases, row: int, scene: CompiledScene, *, aimed: bool = True) -> str:
    """Return the reason why a shot is invalid although all of its cells are numbers.

    Parameters
    ----------
    releases
        The releases of all rows, with their parameters.
    row
        The number of the invalid one among them, from 0.
    scene
        The scene that the shots were flown in.
    aimed
        Whether a speed that is not there was to be found; else it was to be given.

    Returns
    -------
    str
        The cause in words, such as a speed that does not exist or a ball that starts inside a body.
    """
    own = {
        name: np.float64(np.broadcast_to(value, len(releases))[row])
        for name, value in releases.parameters.items()
    }
    speed = releases.columns.get("speed")
    if speed is not None and np.isnan(speed[row]) and allowed(scene, own):
        if not aimed:
            return "no value in speed"
        return "no speed brings the ball down through the point aimed at"
    return reason(releases.states[row], own, scene)
