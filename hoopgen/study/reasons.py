"""Why rows of a table are invalid, in words."""

from __future__ import annotations

from collections.abc import Mapping
from inspect import signature
from math import isnan
from typing import Any

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from hoopgen.brief import brief, cut
from hoopgen.generated.numpy import hoop
from hoopgen.hoop.presets import PAPER
from hoopgen.results import SURFACES
from hoopgen.variables import Releases

from .columns import Column

__all__ = ["reasons"]


def reasons(
    table: pa.Table,
    columns: Mapping[str, Column],
    given: Mapping[str, NDArray[np.float64]],
    releases: Releases,
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
    """
    cells = [
        [_cell(column.name, table[column.name][int(row)].as_py()) for row in np.flatnonzero(wrong)]
        for column, wrong in ((columns[name], np.isnan(given[name])) for name in columns)
    ]
    said: list[list[str]] = [[] for _ in range(table.num_rows)]
    for name, texts in zip(columns, cells, strict=True):
        for row, text in zip(np.flatnonzero(np.isnan(given[name])), texts, strict=True):
            said[row].append(text)
    return ["; ".join(texts) or _shot(releases, row) for row, texts in enumerate(said)]


def _cell(name: str, cell: Any) -> str:
    """Say what is wrong with a cell that gave no finite number."""
    column = cut(name)
    if cell is None or (isinstance(cell, str) and not cell.strip()):
        return f"no value in {column}"
    try:
        number = float(cell)
    except ValueError:
        return f"no number in {column}: {brief(cell)}"
    return f"no value in {column}" if isnan(number) else f"not finite: {column}"


def _shot(releases: Releases, row: int) -> str:
    """Say what is wrong with a shot all of whose cells are numbers, as the loop begins it."""
    state = releases.states[row]
    scene = {
        name: np.float64(np.broadcast_to(value, len(releases))[row])
        for name, value in releases.parameters.items()
    }
    finite = np.array([np.isfinite(value) for value in scene.values()])
    if not finite.all():
        wrong = [name for name, fine in zip(scene, finite, strict=True) if not fine]
        return f"not finite: {', '.join(wrong)}"
    if not _allowed(scene):
        alone = [name for name in scene if _allowed(scene | {name: np.float64(PAPER[name])})]
        named = [f"{name} {scene[name]:g}" for name in alone]
        return f"parameter not allowed: {', '.join(named) or 'several'}"
    speed = releases.columns.get("speed")
    if speed is not None and np.isnan(speed[row]):
        return "no speed brings the ball down through the point aimed at"
    if not np.isfinite(state).all():
        return "not finite: the release"
    outside = [
        surface
        for index, surface in enumerate(SURFACES)
        if _valid(float(index), state, scene)  # as if it left that one
    ]
    return f"inside the {outside[0]}" if len(outside) == 1 else "inside several surfaces"


def _allowed(scene: Mapping[str, Any]) -> bool:
    return bool(_called(hoop.allowed, scene)[0] > 0.0)


def _valid(last: float, state: NDArray[np.float64], scene: Mapping[str, Any]) -> bool:
    place = dict(zip("xyz", state[:3], strict=True))
    return bool(_called(hoop.valid, scene, last=np.float64(last), **place)[0] > 0.0)


def _called(kernel: Any, scene: Mapping[str, Any], **more: Any) -> Any:
    """Call a kernel with those parameters of the scene that it takes."""
    values = {**{f"p_{name}": value for name, value in scene.items()}, **more}
    with np.errstate(all="ignore"):
        return kernel(**{name: values[name] for name in signature(kernel).parameters})
