"""Tables of releases in files, read in chunks; what their columns say, see `hoopgen.study.columns`.

CSV is read as `hoopgen.study.delimited` says. Reading is by pyarrow, and holds a few blocks in
memory, whatever the file's size; of Arrow, record batches as they were written. What was read is
validated before it is looked at.
"""

from __future__ import annotations

import hashlib
import os
from collections.abc import Iterable, Iterator, Mapping
from contextlib import AbstractContextManager, contextmanager
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from types import MappingProxyType
from typing import TypeAlias

import numpy as np
import pyarrow as pa
import pyarrow.ipc
import pyarrow.parquet as pq
from numpy.typing import NDArray

from hoopgen.brief import brief, cut, listed
from hoopgen.engines import HOOP, Engine

from .columns import Column, columns_of, values
from .delimited import check_delimiter, delimiter_of, parsed, read, survey

__all__ = ["FORMATS", "Source", "Stamp"]

FORMATS: Mapping[str, tuple[str, ...]] = MappingProxyType(
    {
        "csv": (".csv",),
        "parquet": (".parquet", ".pq"),
        "arrow": (".arrow", ".arrows", ".feather", ".ipc"),
    }
)
"""Formats of tables, and the suffixes that say so. Arrow is the IPC file, Feather, or stream."""

Stamp: TypeAlias = tuple[int, int]
"""Of a file: its size, and the time of its last change, ns."""

_BLOCK = 1 << 22
"""Bytes of a file that are read at a time; the longest row of CSV."""

_ROWS = 1 << 20
"""Read at a time where all are."""

_SAID = 300
"""Characters of what Arrow says of a file, which may be in the words of that file."""

_ARROW_FILE = b"ARROW1"


@dataclass(frozen=True)
class Source:
    """A file with a table.

    Attributes
    ----------
    path
        The file.
    format
        One of `FORMATS`; by default as the suffix says. All cells of CSV are text; see `typed`.
    delimiter
        Of CSV, one character; by default as its first line says. Where it is no comma, a comma in a
        number is a decimal one.
    label
        What errors call it; by default its path.

    Raises
    ------
    ValueError
        If the format is none of them, or the delimiter no such character.
    """

    path: Path
    format: str = ""
    delimiter: str = ""
    label: str = ""

    def __str__(self) -> str:
        return self.label or str(self.path)

    def __post_init__(self) -> None:
        suffixes = {suffix: name for name, listed in FORMATS.items() for suffix in listed}
        found = self.format or suffixes.get(self.path.suffix.lower(), "")
        if not found:
            raise ValueError(
                f"{self.path}: the suffix is none of {', '.join(suffixes)}; say format"
            )
        if found not in FORMATS:
            raise ValueError(f"format: expected one of {', '.join(FORMATS)}, got {brief(found)}")
        object.__setattr__(self, "format", found)
        if self.delimiter:
            if found != "csv":
                raise ValueError(f"delimiter: {self.path} is {found}; only CSV has one")
            object.__setattr__(self, "delimiter", check_delimiter(self.delimiter))

    @cached_property
    def between(self) -> str:
        """What stands between the cells of CSV."""
        return self.delimiter or delimiter_of(self.path)

    @property
    def comma(self) -> bool:
        """Whether numbers in text have decimal commas."""
        return self.format == "csv" and self.between != ","

    def schema(self) -> pa.Schema:
        """Return the names and types of the columns.

        Raises
        ------
        ValueError
            If the file is not of its format, or two columns have one name.
        """
        with self._opened() as (schema, _):
            return schema

    def columns(
        self, own: Iterable[str] = (), given: Iterable[str] = (), scene: Engine = HOOP
    ) -> dict[str, Column]:
        """Return where the table has the variables of its shots; as `columns_of`."""
        schema = self.schema()
        with self._naming():
            return columns_of(schema, own, given, scene)

    def values(
        self, table: pa.Table, columns: Mapping[str, Column]
    ) -> dict[str, NDArray[np.float64]]:
        """Return the numbers of the columns of a part of the table; as `values`."""
        with self._naming():
            return values(table, columns, self.comma)

    def labels(self, table: pa.Table, name: str) -> list[str | None]:
        """Return a column of any type as text, None where a cell is empty.

        Raises
        ------
        ValueError
            If there is no such column; the message names it.
        """
        if name not in table.column_names:
            raise ValueError(
                f"{self}: there is no column {brief(name)} of groups; there are "
                f"{listed(table.column_names)}"
            )
        cells = table[name].to_pylist()
        return [None if cell is None or cell == "" else str(cell) for cell in cells]

    def tables(self, rows: int) -> Iterator[pa.Table]:
        """Read the rows in order, lazily, so many in each table; the last has what is left.

        There is at least one table: that of an empty file has no rows.

        Raises
        ------
        ValueError
            If the file is not of its format.
        """
        with self._opened() as (schema, batches):
            yield from _regrouped(schema, map(_validated, batches), rows)

    def whole(self) -> pa.Table:
        """Read all rows into one table.

        Raises
        ------
        ValueError
            If the file is not of its format.
        """
        return pa.concat_tables(self.tables(_ROWS))

    def typed(self, columns: Mapping[str, Column]) -> pa.Schema:
        """Return the schema with the types that columns of CSV have, once all of it was read.

        Of `columns` they are doubles. Others are whole numbers, numbers or truths if all of their
        cells are; identifiers, with leading zeros or more than 15 digits, are text.
        """
        if self.format != "csv":
            return self.schema()
        numbers = {column.name for column in columns.values()}
        with self._opened() as (schema, batches):
            others = [name for name in schema.names if name not in numbers]
            types = survey(batches, others, self.comma) if others else {}
            return pa.schema([(name, types.get(name, pa.float64())) for name in schema.names])

    def cast(self, table: pa.Table, schema: pa.Schema) -> pa.Table:
        """Return a part of the table with the types of `typed`; no number is null."""
        if self.format != "csv":
            return table
        with self._naming():
            cells = [
                parsed(column, field.type, self.comma)
                for column, field in zip(table.columns, schema, strict=True)
            ]
            return pa.Table.from_arrays(cells, schema=schema)

    def digest(self) -> tuple[str, int | None]:
        """Read the whole file, and return a digest of it and the rows that it seems to have."""
        digest, lines = hashlib.blake2b(digest_size=32), 0
        with self.path.open("rb") as file:
            while block := file.read(_BLOCK):
                digest.update(block)
                lines += block.count(b"\n")
        if self.format == "parquet":
            with self._naming(), pq.ParquetFile(self.path) as table:
                return digest.hexdigest(), table.metadata.num_rows
        return digest.hexdigest(), lines - 1 if self.format == "csv" else None

    def stamp(self) -> Stamp:
        """Return what is the same for as long as nobody writes to the file."""
        with self._naming():
            status = self.path.stat()
        return status.st_size, status.st_mtime_ns

    def check_unchanged(self, stamp: Stamp) -> None:
        """Refuse a file that was written to since it had this stamp.

        Raises
        ------
        ValueError
            If it was.
        """
        if self.stamp() != stamp:
            raise ValueError(
                f"{self}: changed while it was read; begin again when nobody writes to it"
            )

    @contextmanager
    def _opened(self) -> Iterator[tuple[pa.Schema, Iterable[pa.RecordBatch]]]:
        openers = {"csv": self._csv, "parquet": _parquet, "arrow": _arrow}
        with self._naming(), openers[self.format](self.path) as (schema, batches):
            twice = sorted({name for name in schema.names if schema.names.count(name) > 1})
            if twice:
                raise ValueError(f"two columns are named {listed(twice)}")
            yield schema, batches

    def _csv(self, path: Path) -> AbstractContextManager[_Read]:
        return read(path, self.between, _BLOCK)

    @contextmanager
    def _naming(self) -> Iterator[None]:
        """Name the file in errors of reading it."""
        try:
            yield
        except OSError as error:
            if error.errno is None:  # Arrow's word for damage
                raise ValueError(f"{self}: {cut(str(error), _SAID)}") from error
            raise OSError(error.errno, os.strerror(error.errno), str(self.path)) from error
        except MemoryError as error:  # of a length that no file has, or of one that is too long
            said = f"damaged, or larger than the memory: {error or 'there is no more'}"
            raise ValueError(f"{self}: {said}") from error
        except (pa.ArrowException, SystemError) as error:
            raise ValueError(f"{self}: {cut(str(error), _SAID)}") from error
        except ValueError as error:
            raise ValueError(f"{self}: {cut(str(error), 10 * _SAID)}") from error


_Read: TypeAlias = tuple[pa.Schema, Iterable[pa.RecordBatch]]
_Opened = Iterator[_Read]


@contextmanager
def _parquet(path: Path) -> _Opened:
    # Else a row group's pages are all read at once, and it may be all the file.
    with pq.ParquetFile(path, buffer_size=_BLOCK, pre_buffer=False) as file:
        yield file.schema_arrow, file.iter_batches()


@contextmanager
def _arrow(path: Path) -> _Opened:
    # No memory map: a file that becomes shorter while it is read would end the process.
    with pa.OSFile(str(path)) as file:
        if file.read(len(_ARROW_FILE)) != _ARROW_FILE:
            file.seek(0)
            stream = pa.ipc.open_stream(file)
            yield stream.schema, stream
        else:
            blocks = pa.ipc.open_file(file)
            yield blocks.schema, map(blocks.get_batch, range(blocks.num_record_batches))


def _validated(batch: pa.RecordBatch) -> pa.RecordBatch:
    """Return the rows that were read, all of whose offsets and indices lie within them.

    Arrow takes those of a file as they are, and follows them wherever they lead.
    """
    batch.validate(full=True)
    return batch


def _regrouped(
    schema: pa.Schema, batches: Iterable[pa.RecordBatch], rows: int
) -> Iterator[pa.Table]:
    """Give tables of so many rows, whatever the batches have."""
    held: list[pa.RecordBatch] = []
    count, first = 0, True
    for batch in batches:
        while count + batch.num_rows >= rows:
            wanted = rows - count
            yield pa.Table.from_batches([*held, batch.slice(0, wanted)], schema)
            batch, held, count, first = batch.slice(wanted), [], 0, False
        held.append(batch)
        count += batch.num_rows
    if count or first:
        yield pa.Table.from_batches(held, schema)
