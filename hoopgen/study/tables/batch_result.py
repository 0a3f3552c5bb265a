"""The result of a batch: counts, the place of the results, and the interpretation of the table."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pyarrow as pa
import pyarrow.ipc
import pyarrow.parquet as pq

from hoopgen.core.extras import require
from hoopgen.text.html import table as rendered
from hoopgen.text.numbers import format_count

from .groups import Group
from .invalid_rows import InvalidRows
from .source import Source

if TYPE_CHECKING:
    from pandas import DataFrame


_ROWS = 1 << 16
"""Number of rows of CSV that are read at a time."""


class Batch(dict[str, int]):
    """Number of shots by outcome, in lower case; and where the results are.

    Attributes
    ----------
    path
        The file written; None for results in memory.
    scene
        In words: the preset, what differs from it, and what is each row's own.
    read
        In words, line by line: which column was read as which variable, which were not read, and
        which values were assumed.
    invalid
        The first five rows that are: their numbers, from 1 and without a header, and reasons.
    causes
        Number of invalid rows by cause; of several causes of a row the first.
    groups
        Results by the value of a column: see `hoopgen.study.tables.groups.Group`. Empty where none
        is asked for.
    events
        The file with the event log; None where none is asked for.
    """

    def __init__(
        self,
        counts: Mapping[str, int],
        path: Path | None,
        scene: str = "",
        read: str = "",
        invalid: InvalidRows | None = None,
        table: pa.Table | None = None,
        groups: Mapping[str, Group] | None = None,
        events: Path | None = None,
    ) -> None:
        super().__init__(counts)
        self.path = path
        self.scene = scene
        self.read = read
        self._invalid = invalid or InvalidRows()
        self.invalid = tuple(self._invalid.first)
        self.causes = dict(self._invalid.causes)
        self.groups = dict(groups or {})
        self.events = events
        self._table = table

    def __reduce__(self) -> tuple[Any, ...]:
        about = (self.path, self.scene, self.read, self._invalid, self._table)
        return type(self), (dict(self), *about, self.groups, self.events)

    @property
    def invalid_lines(self) -> str:
        """The first invalid rows in words, line by line, and how many more there are by cause."""
        return str(self._invalid)

    def to_arrow(self) -> pa.Table:
        """Return the rows with their results as a pyarrow.Table, which Polars takes too.

        Raises
        ------
        OSError
            If the file is not there any more.
        """
        if self._table is not None:
            return self._table
        assert self.path is not None  # the one or the other
        if self.path.suffix.lower() in (".csv", ".tsv"):
            table = Source(self.path)
            types = table.typed({})
            return pa.concat_tables(table.cast(part, types) for part in table.tables(_ROWS))
        return pq.read_table(self.path, partitioning=None)

    def to_pandas(self) -> DataFrame:
        """Return the rows with their results as a pandas.DataFrame.

        Raises
        ------
        ImportError
            If pandas is missing: what brings it.
        """
        require("pandas", "to_pandas")
        frame: DataFrame = self.to_arrow().to_pandas()
        return frame

    def _repr_html_(self) -> str:
        where = "memory" if self.path is None else self.path
        about = f"{format_count(sum(self.values()), 'shot')} in {where}; {self.scene}"
        rows = [(name, f"{count:,}") for name, count in self.items()]
        return rendered(about, ("outcome", "shots"), rows)


def in_memory(file: Path) -> pa.Table:
    """Return a stream of Arrow in a file as a table that does not depend on it."""
    with pa.OSFile(str(file)) as stream:
        return pa.ipc.open_stream(stream).read_all()
