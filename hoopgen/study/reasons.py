"""Why rows of a table are invalid, in words."""

from __future__ import annotations

from collections.abc import Mapping
from math import isnan
from typing import Any

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from hoopgen.brief import brief, cut
from hoopgen.engines import Engine
from hoopgen.invalid import allowed, reason
from hoopgen.variables import Releases

from .columns import Column

__all__ = ["reasons"]


def reasons(
    table: pa.Table,
    columns: Mapping[str, Column],
    given: Mapping[str, NDArray[np.float64]],
    releases: Releases,
    scene: Engine,
) -> list[str]:
    """Return why each row cannot be simulated.

    Parameters
    ----------
    table
        Rows that are invalid, all of them.
    columns
        Where their numbers are.
    given
        The numbers that were read, (n,) each, NaN where a cell has none.
    releases
        What was made of them.
    scene
        In which they could not be flown.
    """
    cells = [
        [_cell(column.name, table[column.name][int(row)].as_py()) for row in np.flatnonzero(wrong)]
        for column, wrong in ((columns[name], np.isnan(given[name])) for name in columns)
    ]
    said: list[list[str]] = [[] for _ in range(table.num_rows)]
    for name, texts in zip(columns, cells, strict=True):
        for row, text in zip(np.flatnonzero(np.isnan(given[name])), texts, strict=True):
            said[row].append(text)
    return ["; ".join(texts) or _shot(releases, row, scene) for row, texts in enumerate(said)]


def _cell(name: str, cell: Any) -> str:
    """Say what is wrong with a cell that gave no number that is allowed."""
    column = cut(name)
    if cell is None or (isinstance(cell, str) and not cell.strip()):
        return f"no value in {column}"
    try:
        number = float(cell)
    except ValueError:
        return f"no number in {column}: {brief(cell)}"
    return f"no value in {column}" if isnan(number) else f"not finite: {column}"


def _shot(releases: Releases, row: int, scene: Engine) -> str:
    """Return what is wrong with a shot all of whose cells are numbers."""
    own = {
        name: np.float64(np.broadcast_to(value, len(releases))[row])
        for name, value in releases.parameters.items()
    }
    speed = releases.columns.get("speed")
    if speed is not None and np.isnan(speed[row]) and allowed(scene, own):
        return "no speed brings the ball down through the point aimed at"
    return reason(releases.states[row], own, scene)
