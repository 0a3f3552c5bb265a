"""Random samples of the rows of a table of releases, in one pass."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from hoopgen.core.variables import Releases
from hoopgen.engine.compiled_scene import CompiledScene
from hoopgen.simulation.hoop import HOOP
from hoopgen.study.models.random import ROW_OF_SAMPLE, uniforms
from hoopgen.study.models.release_model import check_turns, from_columns
from hoopgen.study.tables.interpretation import Interpretation
from hoopgen.study.tables.reading import ReadingOptions
from hoopgen.study.tables.source import Source
from hoopgen.text.shorten import brief, cut, join_names

ROWS = 1 << 16
"""Rows that are read at a time."""

_MAX_LABEL_LENGTH = 40
"""Characters of a cell that a row is called by; with more, names would not fit on the page."""


@dataclass(frozen=True)
class Sample:
    """A sample of the rows of a table.

    Attributes
    ----------
    rows
        Which, (n,), from 0, in the table's order.
    total
        How many it has.
    releases
        What they say.
    max_contacts
        Contacts after which their shots end as capped.
    labels
        What each is called: its cell in a column, and where rows share that, the row too.
    interpretation
        What each column of the table was read as.
    """

    rows: NDArray[np.int64]
    total: int
    releases: Releases
    max_contacts: int
    labels: Sequence[str]
    interpretation: Interpretation


_DEFAULT_READING = ReadingOptions()


def sample(
    source: str | Path,
    count: int,
    seed: int = 0,
    parameters: Mapping[str, Any] | None = None,
    *,
    release: Mapping[str, float] | None = None,
    max_contacts: int | None = None,
    override: bool = False,
    reading: ReadingOptions = _DEFAULT_READING,
    label: str | None = None,
    scene: CompiledScene = HOOP,
    rows_at_once: int = ROWS,
) -> Sample:
    """Return a uniform sample of the rows of a table of releases.

    The table may be larger than the memory. The same table, count and seed give the same rows.

    Parameters
    ----------
    source
        CSV, Parquet, Arrow or .xlsx; see `hoopgen.study.tables.columns`.
    count
        How many, from 1; all of them if the table has no more.
    seed
        From 0 to 2^64 - 1.
    parameters
        Of the scene, where no column says otherwise; by default those that a file of results says,
        else the scene's usual ones.
    release
        Variables that all shots share, in place of columns.
    max_contacts
        By default as many as a file of results says, else as is usual in the scene.
    override
        Whether those three may contradict what the file says.
    reading
        What the caller says of how the table is read.
    label
        A column that says what each row is called; by default its number, from 1.
    scene
        In which the shots are flown.
    rows_at_once
        How many rows are read at a time.

    Raises
    ------
    ValueError
        If the count is below 1, the table is empty or not as described, or an argument contradicts
        what it says.
    OSError
        If it cannot be read.
    """
    if count < 1:
        raise ValueError(f"count: expected a whole number from 1, got {brief(count)}")
    table = reading.source(Path(source))
    check_turns("release", release or {}, release or {})
    read = reading.interpreted(
        table, parameters, release, max_contacts, override=override, scene=scene
    )
    origin, columns, shared = read.origin, read.columns, read.origin.release
    named = _label_reader(table, label)
    # Every row draws a number, and the lowest win: that does not depend on how the rows are read.
    kept = {"draw": np.empty(0), "row": np.empty(0), **{name: np.empty(0) for name in columns}}
    called: NDArray[np.object_] = np.empty(0, np.object_)
    total = 0
    for part, numbers in table.numbered(rows_at_once):
        drawn = uniforms(seed, ROW_OF_SAMPLE, total, total + part.num_rows)
        best = np.argsort(drawn, kind="stable")[:count]
        taken = part.take(best)
        found = {
            "draw": drawn[best],
            "row": numbers[best] - 1.0,
            **table.values(taken, columns, check=total == 0),
        }
        joined = {name: np.concatenate([kept[name], found[name]]) for name in kept}
        lowest = np.argsort(joined["draw"], kind="stable")[:count]
        kept = {name: column[lowest] for name, column in joined.items()}
        called = np.concatenate([called, named(taken)])[lowest]
        total += part.num_rows
    if not total:
        raise ValueError(f"{table.path}: the table has no rows")
    order = np.argsort(kept["row"])
    rows = kept["row"][order].astype(np.int64)
    given = {name: kept[name][order] for name in columns}
    releases = from_columns({**given, **shared}, origin.parameters)
    labels = _labels(rows, called[order].tolist())
    return Sample(rows, total, releases, origin.max_contacts, labels, read.interpretation)


def _label_reader(table: Source, label: str | None) -> Callable[[pa.Table], NDArray[np.object_]]:
    """Return a reader of the column with the rows' labels; None without one.

    Raises
    ------
    ValueError
        If the table has no such column.
    """
    if label is None:
        return lambda part: np.full(part.num_rows, None)
    names = table.schema().names
    if label not in names:
        raise ValueError(
            f"label: {table.path} has no column {brief(label)}. The columns are {join_names(names)}"
        )

    def cells(part: pa.Table) -> NDArray[np.object_]:
        read: NDArray[np.object_] = np.empty(part.num_rows, np.object_)
        read[:] = part[label].to_pylist()
        return read

    return cells


def _labels(rows: NDArray[np.int64], cells: Sequence[Any]) -> list[str]:
    """Return the rows' labels, unique and not empty."""
    words = ["" if cell is None else cut(str(cell).strip(), _MAX_LABEL_LENGTH) for cell in cells]
    often = Counter(words)
    numbers = [f"row {row + 1}" for row in rows.tolist()]
    return [
        number.capitalize() if not word else word if often[word] == 1 else f"{word}, {number}"
        for word, number in zip(words, numbers, strict=True)
    ]
