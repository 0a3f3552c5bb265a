"""Why rows of a table are invalid, in words."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import isnan
from typing import Any

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from hoopgen.brief import brief, cut
from hoopgen.engines import Engine
from hoopgen.variables import Releases

from .columns import Column, numbers
from .tallies import allowed, not_allowed

__all__ = ["cause", "reasons"]


def reasons(
    table: pa.Table,
    columns: Mapping[str, Column],
    given: Mapping[str, NDArray[np.float64]],
    releases: Releases,
    scene: Engine,
    *,
    malformed: Sequence[str],
    comma: bool = False,
) -> list[str]:
    """Return why each row cannot be simulated, or is not.

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
    said: list[list[str]] = [[] for _ in range(table.num_rows)]
    for name, texts in zip(columns, cells, strict=True):
        for row, text in zip(np.flatnonzero(np.isnan(given[name])), texts, strict=True):
            said[row].append(text)
    return [
        malformed[row] or "; ".join(texts) or _shot(releases, row, scene)
        for row, texts in enumerate(said)
    ]


def cause(reason: str) -> str:
    """Return the cause in a reason, which many rows may have in common."""
    return reason.partition(": ")[0].partition("; ")[0]


def _cells(table: pa.Table, column: Column, wrong: NDArray[np.bool_], comma: bool) -> list[str]:
    """Say what is wrong with the cells of a column that gave no number."""
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
    """Say what is wrong with a cell that gave no number that is allowed."""
    if cell is None or (isinstance(cell, str) and not cell.strip()):
        return f"no value in {column}"
    try:
        number = float(cell)
    except ValueError:
        return f"no number in {column}: {brief(cell)}"
    return f"no value in {column}" if isnan(number) else f"not finite: {column}"


def _shot(releases: Releases, row: int, scene: Engine) -> str:
    """Say what is wrong with a shot all of whose cells are numbers, as the loop begins it."""
    state = releases.states[row]
    own = {
        name: np.float64(np.broadcast_to(value, len(releases))[row])
        for name, value in releases.parameters.items()
    }
    wrong = [
        n
        for n, value in own.items()
        if not np.isfinite(value) and not (n in scene.infinite and value == np.inf)
    ]
    if wrong:
        return f"not finite: {', '.join(wrong)}"
    if not allowed(scene, own):
        named = [f"{name} {own[name]:g}" for name in not_allowed(scene, own)]
        return f"parameter not allowed: {', '.join(named) or 'several'}"
    speed = releases.columns.get("speed")
    if speed is not None and np.isnan(speed[row]):
        return "no speed brings the ball down through the point aimed at"
    if not np.isfinite(state).all():
        return "not finite: the release"
    outside = [
        surface
        for index, surface in enumerate(scene.surfaces)
        if _valid(float(index), state, own, scene)  # as if it left that one
    ]
    return f"inside the {outside[0]}" if len(outside) == 1 else "inside several surfaces"


def _valid(
    last: float, state: NDArray[np.float64], parameters: Mapping[str, Any], scene: Engine
) -> bool:
    kernels = scene.kernels
    inputs = map(np.float64, scene.table.inputs(parameters))
    given = dict(zip(kernels.VARIABLES.values(), inputs, strict=True))
    given |= {"last": np.float64(last), **dict(zip("xyz", state[:3], strict=True))}
    with np.errstate(all="ignore"):
        found = kernels.valid(*(given[name] for name in kernels.ARGUMENTS["valid"]))
    return bool(found[0] > 0.0)
