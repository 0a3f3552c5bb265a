"""Tables of releases in files, read in chunks; their columns are interpreted by `columns`.

CSV is read as `hoopgen.study.tables.delimited` says, spreadsheets as
`hoopgen.study.tables.spreadsheets` does. Reading is by pyarrow, and holds a few blocks in memory,
whatever the file's size; of Arrow, record batches as they were written. What was read is validated
before it is looked at, and measured before it is laid out in memory, see
`hoopgen.study.tables.limits`.
"""

from __future__ import annotations

import hashlib
import os
import stat
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import TypeAlias

import numpy as np
import pyarrow as pa
import pyarrow.ipc
import pyarrow.parquet as pq
from numpy.typing import NDArray

from hoopgen.core.validation import check_count
from hoopgen.engine.compiled_scene import CompiledScene
from hoopgen.simulation.hoop import HOOP
from hoopgen.text.shorten import brief, cut, join_names

from . import spreadsheets
from .columns import Column, columns_of, values
from .delimited import (
    Layout,
    check_delimiter,
    layout_of,
    parsed,
    read,
    survey,
    text_columns,
    with_decimal_points,
)
from .filters import Condition, check_columns, chosen, parse_conditions
from .limits import LEAST_MEMORY, MEMORY, Opened, read_arrow, read_parquet, regrouped, validated

FORMATS: Mapping[str, tuple[str, ...]] = {
    "csv": (".csv", ".tsv"),
    "parquet": (".parquet", ".pq"),
    "arrow": (".arrow", ".arrows", ".feather", ".ipc"),
    "xlsx": (".xlsx",),
}
"""Formats of tables, and the suffixes that say so. Arrow is the IPC file, Feather, or stream."""

_TEXT = ("csv", "xlsx")
"""Formats all of whose cells are read as text."""

ABOUT = b"hoopgen"
"""Key of a schema's metadata under which results say their scene, as JSON."""

_ROW = "\0row"
"""A column that no file has: the numbers of rows, while some are chosen."""

Stamp: TypeAlias = tuple[int, int]
"""Size of a file, and the time of its last change, ns."""

BLOCK = 1 << 22
"""Bytes of a file that are read at a time; the longest row of CSV."""

_ROWS = 1 << 20
"""Read at a time where all are."""

_SAID = 300
"""Characters of what Arrow says of a file, which may be in the words of that file."""


@dataclass(frozen=True)
class Source:
    """A file with a table.

    Attributes
    ----------
    format
        One of `FORMATS`; by default as the suffix says. All cells of CSV are text; see `typed`.
    delimiter
        Of CSV, one character; by default as its first line says. Where it is no comma, a comma in a
        number is a decimal one.
    where
        Conditions that a row meets, or is left out, such as "speed_mph >= 15"; see
        `hoopgen.study.tables.filters`.
    malformed
        Why rows of CSV have no cells, by their number from 1, as far as they were read.
    """

    path: Path  # the file
    format: str = ""
    delimiter: str = ""
    label: str = ""  # what errors call it; by default its path
    where: tuple[str, ...] = ()
    memory: int = MEMORY  # bytes that rows which are read at once may take
    conditions: tuple[Condition, ...] = field(default=(), init=False, compare=False, repr=False)
    malformed: dict[int, str] = field(default_factory=dict, init=False, compare=False, repr=False)

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
        elif self.path.suffix.lower() == ".tsv":
            object.__setattr__(self, "delimiter", "\t")
        expected = f"at least {LEAST_MEMORY:,} bytes"
        check_count("memory", self.memory, least=LEAST_MEMORY, expected=expected)
        object.__setattr__(self, "conditions", parse_conditions(self.where))

    @cached_property
    def layout(self) -> Layout:
        """Return the layout of a CSV file."""
        return layout_of(self.path, self.delimiter)

    @property
    def between(self) -> str:
        """Return the delimiter of the cells of CSV."""
        return self.layout.delimiter

    @property
    def is_text(self) -> bool:
        """Return whether all cells are read as text."""
        return self.format in _TEXT

    @property
    def comma(self) -> bool:
        """Return whether numbers in text have decimal commas."""
        return self.format == "csv" and self.between != ","

    def schema(self) -> pa.Schema:
        """Return the names and types of the columns."""
        with self._opened() as (schema, _):
            return schema

    def columns(
        self,
        own: Iterable[str] = (),
        given: Iterable[str] = (),
        scene: CompiledScene = HOOP,
        columns: Mapping[str, str] | None = None,
        *,
        implausible: bool = False,
    ) -> dict[str, Column]:
        """Return the columns with the variables of the table's shots; as `columns_of`."""
        schema = self.schema()
        with self._naming():
            return columns_of(schema, own, given, scene, columns, implausible=implausible)

    def values(
        self, table: pa.Table, columns: Mapping[str, Column], *, check: bool = True
    ) -> dict[str, NDArray[np.float64]]:
        """Return the numbers of the columns of a part of the table; as `values`."""
        with self._naming():
            return values(table, columns, self.comma, check=check)

    def labels(self, table: pa.Table, name: str) -> list[str | None]:
        """Return a column of any type as text, None where a cell is empty.

        Parameters
        ----------
        table
            A part of the rows, as they were read.
        name
            The name of the column that names the groups.

        Returns
        -------
        list of str or None
            One text for each row.

        Raises
        ------
        ValueError
            If there is no such column.
        """
        if name not in table.column_names:
            raise ValueError(
                f"{self}: there is no column {brief(name)} of groups; there are "
                f"{join_names(table.column_names)}"
            )
        cells = table[name].to_pylist()
        return [None if cell is None or cell == "" else str(cell) for cell in cells]

    def tables(self, rows: int) -> Iterator[pa.Table]:
        """Read the rows in order, lazily, so many in each table; the last has what is left.

        There is at least one table: that of an empty file has no rows. Rows that do not meet the
        conditions are left out.
        """
        for table, _ in self.numbered(rows):
            yield table

    def numbered(self, rows: int) -> Iterator[tuple[pa.Table, NDArray[np.int64]]]:
        """Read as `tables` does, and give the number of each row in the file, from 1."""
        with self._opened() as (schema, batches):
            measured = (validated(batch, self.memory) for batch in batches)
            counted = schema.append(pa.field(_ROW, pa.int64()))
            for table in regrouped(counted, self._chosen(measured), rows):
                numbers = table[_ROW].to_numpy()
                yield table.drop_columns([_ROW]).replace_schema_metadata(schema.metadata), numbers

    def _chosen(self, batches: Iterable[pa.RecordBatch]) -> Iterator[pa.RecordBatch]:
        """Give the rows that meet the conditions, with their numbers."""
        first = 1
        for batch in batches:
            numbers = np.arange(first, first + batch.num_rows)
            first += batch.num_rows
            yield chosen(
                batch.append_column(_ROW, pa.array(numbers, pa.int64())),
                self.conditions,
                self.comma,
            )

    def whole(self) -> pa.Table:
        """Read all rows into one table."""
        return pa.concat_tables(self.tables(_ROWS))

    def typed(self, columns: Mapping[str, Column], *, as_text: bool = False) -> pa.Schema:
        """Return the schema with the types that columns of CSV have, once all of it was read.

        Of `columns` they are doubles. Others are whole numbers, numbers or truths if all of their
        cells are; identifiers, with leading zeros or more than 15 digits, are text.

        Parameters
        ----------
        columns
            The columns that are read as numbers, by variable.
        as_text
            Whether those of `columns` are text in which a cell is none.
        """
        if not self.is_text:
            return self.schema()
        numbers = {column.name for column in columns.values()}
        with self._opened() as (schema, batches):
            others = [name for name in schema.names if name not in numbers]
            types = survey(batches, others, self.comma) if others else {}
        if as_text:
            with self._opened() as (_, batches):
                types |= text_columns(batches, numbers, self.comma)
        return pa.schema([(name, types.get(name, pa.float64())) for name in schema.names])

    def cast(
        self, table: pa.Table, schema: pa.Schema, columns: Mapping[str, Column] | None = None
    ) -> pa.Table:
        """Return a part of the table with the types of `typed`; no number is null.

        Parameters
        ----------
        table
            A part of the rows; of CSV and .xlsx its cells are text.
        schema
            The names and types that `typed` gave.
        columns
            Those that are read as numbers; where they are text, numbers get a decimal point.

        Returns
        -------
        pyarrow.Table
            The same rows; an empty cell of numbers is NaN.

        Raises
        ------
        ValueError
            If a cell is no number where one is needed; the message names the column and the row.
        """
        if not self.is_text:
            return table
        with self._naming():
            numbers = {column.name for column in (columns or {}).values()}
            cells = [
                with_decimal_points(column, self.comma)
                if field.name in numbers and pa.types.is_string(field.type)
                else parsed(column, field.type, self.comma)
                for column, field in zip(table.columns, schema, strict=True)
            ]
            return pa.Table.from_arrays(cells, schema=schema)

    def digest(self) -> tuple[str, int | None]:
        """Read the whole file, and return a digest of it and the rows that it seems to have."""
        digest, lines = hashlib.blake2b(digest_size=32), 0
        with self.path.open("rb") as file:
            while block := file.read(BLOCK):
                digest.update(block)
                lines += block.count(b"\n")
        if self.format == "parquet" and not self.where:
            with self._naming(), pq.ParquetFile(self.path) as table:
                return digest.hexdigest(), table.metadata.num_rows
        if self.format != "csv" or self.where:
            return digest.hexdigest(), None
        return digest.hexdigest(), lines - 1

    def stamp(self) -> Stamp:
        """Return a stamp that stays the same as long as nobody writes to the file."""
        with self._naming():
            status = self.path.stat()
        return status.st_size, status.st_mtime_ns

    def check_unchanged(self, stamp: Stamp) -> None:
        """Refuse a file that was written to since it had this stamp."""
        if self.stamp() != stamp:
            raise ValueError(
                f"{self}: changed while it was read; begin again when nobody writes to it"
            )

    @contextmanager
    def _opened(self) -> Iterator[tuple[pa.Schema, Iterable[pa.RecordBatch]]]:
        openers = {
            "csv": self._csv,
            "parquet": read_parquet,
            "arrow": read_arrow,
            "xlsx": spreadsheets.read,
        }
        with self._naming():
            if not stat.S_ISREG(self.path.stat().st_mode):
                raise ValueError("is no file, but a pipe or a device, which can be read only once")
            with openers[self.format](self.path, self.memory) as (schema, batches):
                often = Counter(schema.names)
                twice = sorted(name for name, count in often.items() if count > 1)
                if twice:
                    raise ValueError(f"two columns are named {join_names(twice)}")
                check_columns(self.conditions, schema.names)
                yield schema, batches

    @contextmanager
    def _csv(self, path: Path, memory: int) -> Opened:
        block = BLOCK * max(1, memory // MEMORY)
        with read(path, self.layout, block, self.malformed) as (schema, batches):
            about = self.layout.about.encode()
            yield schema.with_metadata({ABOUT: about} if about else None), batches

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
            text = f"damaged, or larger than the memory: {error or 'there is no more'}"
            raise ValueError(f"{self}: {text}") from error
        except (pa.ArrowException, SystemError) as error:
            raise ValueError(f"{self}: {cut(str(error), _SAID)}") from error
        except ValueError as error:
            raise ValueError(f"{self}: {cut(str(error), 10 * _SAID)}") from error
