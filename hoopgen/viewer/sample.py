"""Some rows of a table of releases, chosen at random while it is read once."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hoopgen.brief import brief
from hoopgen.engines import HOOP, Engine
from hoopgen.study.draws import ROW_OF_SAMPLE, uniforms
from hoopgen.study.models import check_turns, from_columns
from hoopgen.study.origin import settle
from hoopgen.study.tables import Source
from hoopgen.variables import Releases

__all__ = ["Sample", "sample"]

_ROWS = 1 << 16
"""Read at a time."""


@dataclass(frozen=True)
class Sample:
    """Rows of a table.

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
    """

    rows: NDArray[np.int64]
    total: int
    releases: Releases
    max_contacts: int


def sample(
    source: str | Path,
    count: int,
    seed: int = 0,
    parameters: Mapping[str, Any] | None = None,
    *,
    release: Mapping[str, float] | None = None,
    max_contacts: int | None = None,
    override: bool = False,
    format: str | None = None,
    own: Sequence[str] = (),
    scene: Engine = HOOP,
) -> Sample:
    """Choose rows of a table of releases; each is as likely as any other.

    The table may be larger than the memory. The same table, count and seed give the same rows.

    Parameters
    ----------
    source
        CSV, Parquet or Arrow; see `hoopgen.study.columns`.
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
    format
        "csv", "parquet" or "arrow"; by default as the suffix says.
    own
        Columns that are not to be read, though they are named like variables.
    scene
        In which the shots are flown.

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
    table = Source(Path(source), format or "")
    check_turns("release", release or {}, release or {})
    origin = settle(table, parameters, release, max_contacts, own, override=override, scene=scene)
    shared = origin.release
    columns = table.columns(origin.own, shared, scene)
    # Every row draws a number, and the lowest win: that does not hang on how the rows are read.
    kept = {"draw": np.empty(0), "row": np.empty(0), **{name: np.empty(0) for name in columns}}
    total = 0
    for part in table.tables(_ROWS):
        drawn = uniforms(seed, ROW_OF_SAMPLE, total, total + part.num_rows)
        best = np.argsort(drawn, kind="stable")[:count]
        found = {
            "draw": drawn[best],
            "row": best + float(total),
            **table.values(part.take(best), columns),
        }
        joined = {name: np.concatenate([kept[name], found[name]]) for name in kept}
        lowest = np.argsort(joined["draw"], kind="stable")[:count]
        kept = {name: column[lowest] for name, column in joined.items()}
        total += part.num_rows
    if not total:
        raise ValueError(f"{table.path}: the table has no rows")
    order = np.argsort(kept["row"])
    rows = kept["row"][order].astype(np.int64)
    given = {name: kept[name][order] for name in columns}
    releases = from_columns({**given, **shared}, origin.parameters)
    return Sample(rows, total, releases, origin.max_contacts)
