"""The table of results: the rows of a source with their results, counted and written to a file."""

from __future__ import annotations

import io
import os
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import TypeAlias

import numpy as np
import pyarrow as pa
import pyarrow.compute as pc
import pyarrow.csv
import pyarrow.ipc
import pyarrow.parquet as pq
from numpy.typing import NDArray

from hoopgen.hoop.kinds import hoop_outcomes
from hoopgen.scene.lookup import outcomes_of
from hoopgen.study.measures.rebounds import caught_at
from hoopgen.study.named_units import named
from hoopgen.text.shorten import brief, join_alternatives, join_names

from .columns import Column
from .delimited import COMMENT
from .event_log import EVENTS, event_log, log_schema
from .flights import Flights
from .groups import Group, GroupCounts
from .invalid_rows import InvalidRows, reasons, shot_reason
from .provenance import Origin
from .source import ABOUT, FORMATS, Source


@dataclass
class Results:
    """The written table: the rows of the source and their results.

    Attributes
    ----------
    source, columns
        The table, and where it has the variables of its shots.
    log, log_schema
        Takes the event log, if there is one; and that one's schema, known once `schema` is.
    invalid
        Rows of the source that are.
    """

    source: Source
    columns: Mapping[str, Column]
    shots: Flights  # what all flights share
    origin: Origin  # what the table says of its shots
    prefix: str  # of the names of the results
    reason: bool  # whether a column says why a row is invalid
    by: str | None  # the column by whose values results are counted; None for none
    format: str = ""  # of the file, as `check_sink` takes it
    log: Sink | None = None
    log_schema: pa.Schema = field(default=None, init=False)
    outcomes: NDArray[np.int64] = field(init=False)  # counts of the rows that were written, by code
    invalid: InvalidRows = field(default_factory=InvalidRows, init=False)

    def __post_init__(self) -> None:
        self.outcomes = np.zeros(len(self.shots.scene.outcomes), np.int64)
        as_text = self.format in _DELIMITERS
        self._types = self.source.typed(self.columns, as_text=as_text)
        self._kept = self._types.names
        self._counts: GroupCounts | None = None
        if self.by is not None:
            if self.by not in self._kept:
                raise ValueError(
                    f"by: {self.source} has no column {brief(self.by)}; the columns are "
                    f"{join_names(self._kept)}"
                )
            self._counts = GroupCounts(self.by, outcomes_of(self.shots.scene))

    @property
    def ended(self) -> tuple[str, ...]:
        """Return the names of the outcomes that shots of the scene can have."""
        scene = self.shots.scene
        if scene.has_hoop:
            return tuple(one.name.lower() for one in hoop_outcomes(scene.rolls))
        return outcomes_of(scene)

    @property
    def groups(self) -> dict[str, Group]:
        """Return the results by group."""
        return {} if self._counts is None else self._counts.groups(self.ended)

    def schema(self, scene: str) -> pa.Schema:
        """Return the schema of the results; arguments that shots cannot have raise an error here.

        Former results are left out where new ones have their names.
        """
        types = self._types
        read = pa.schema([types.field(column.name) for column in self.columns.values()])
        empty = self.source.values(read.empty_table(), self.columns)
        results = list(self.shots.results(empty).schema)
        if self.shots.events:
            self.log_schema = log_schema(results.pop().type)
        if self.reason:
            results.append(pa.field("reason", pa.string()))
        results = [column.with_name(self.prefix + column.name) for column in results]
        names = [column.name for column in results]
        former = set(self.origin.results)
        if not former.isdisjoint(names):
            self._kept = [name for name in types.names if name not in former]
        both = sorted({*names} & {*self._kept}, key=names.index)
        if both:
            raise ValueError(
                f"{self.source}: has columns named like results: {join_names(both)}; give a prefix "
                "(--prefix)"
            )
        height = caught_at(self.shots.measures, self.shots.catching_height)
        more = {named(name): value for name, value in height.items()}
        still = [name for name in self.origin.results if name in self._kept]
        about = self.origin.metadata(scene, **more, results=[*still, *names])
        kept = [types.field(name) for name in self._kept]
        return pa.schema([*kept, *results], {**(types.metadata or {}), **about})

    def table(
        self, read: pa.Table, numbers: NDArray[np.int64], results: pa.Table, schema: pa.Schema
    ) -> pa.Table:
        """Return the next rows, with their results, and count them.

        Parameters
        ----------
        read, numbers
            Rows of the source, and their numbers there.
        schema
            As of `schema`.
        """
        outcomes = _codes(results["outcome"])
        rows = np.flatnonzero(outcomes == self.shots.scene.outcomes["INVALID"])
        why = self._reasons(read, rows, numbers)
        self.invalid.add(numbers[rows].tolist(), why)
        if self.log is not None:
            self.log(event_log(results[EVENTS], int(self.outcomes.sum())))
            results = results.drop_columns([EVENTS])
        self.outcomes += np.bincount(outcomes, minlength=len(self.outcomes))
        cast = self.source.cast(read, self._types, self.columns)
        if self._counts is not None:
            self._counts.add(cast[self._counts.column], outcomes)
        cells = [*cast.select(self._kept).columns, *results.columns]
        if self.reason:
            reasons: NDArray[np.object_] = np.full(read.num_rows, None)
            reasons[rows] = why
            cells.append(pa.array(reasons, pa.string()))
        return pa.Table.from_arrays(cells, schema=schema)

    def _reasons(
        self, read: pa.Table, rows: NDArray[np.int64], numbers: NDArray[np.int64]
    ) -> list[str]:
        if not len(rows):
            return []
        taken = read.take(rows)
        given = self.source.values(taken, self.columns, check=False)
        found = self.shots.releases(given)
        malformed = [self.source.malformed.get(number, "") for number in numbers[rows].tolist()]
        scene, comma = self.shots.scene, self.source.comma
        return reasons(
            *(taken, self.columns, given),
            partial(shot_reason, found, scene=scene),
            malformed=malformed,
            comma=comma,
        )


def _codes(column: pa.ChunkedArray) -> NDArray[np.int64]:
    """Return the outcomes of rows as numbers."""
    parts = [part.indices.to_numpy(zero_copy_only=False) for part in column.chunks]
    return np.concatenate([np.empty(0, np.int64), *parts])


_DELIMITERS = {".csv": ",", ".tsv": "\t"}

RESULTS = tuple(suffix for name, listed in FORMATS.items() if name != "xlsx" for suffix in listed)
"""Suffixes of the names of files of results: of all formats that are read but spreadsheets."""

Sink: TypeAlias = Callable[[pa.Table], None]
"""Takes the next rows."""


def check_suffix(name: str, file: str | os.PathLike[str]) -> None:
    """Raise a ValueError for a file of results whose suffix is none of `RESULTS`.

    Parameters
    ----------
    name
        The argument that names the file.
    file
        The file.
    """
    if Path(file).suffix.lower() not in RESULTS:
        raise ValueError(f"{name}: expected a file {join_alternatives(RESULTS)}, got {file}")


def check_sink(format: str, schema: pa.Schema, source: object) -> None:
    """Raise an error for columns that a format cannot have, before the work if possible.

    Parameters
    ----------
    format
        The suffix of the file, one of `RESULTS`.
    schema
        The names and types of the columns of results.
    source
        The table that is read, whose name the message has.

    Raises
    ------
    ValueError
        If a column has a type that text cannot hold, such as a list.
    """
    if format in _DELIMITERS:
        with _refused(source, "CSV"):
            pa.csv.write_csv(_plain(schema).empty_table(), io.BytesIO())


@contextmanager
def sink(file: Path, format: str, schema: pa.Schema, rows: int, source: object) -> Iterator[Sink]:
    """Write tables to a file.

    Parameters
    ----------
    format
        One of `RESULTS`; ".arrows" is a stream.
    schema
        Of the tables; CSV has what its metadata says of the scene in a comment line at its start.
    """
    if format == ".arrows":
        with pa.ipc.new_stream(str(file), schema) as stream:
            yield stream.write_table
    elif format in FORMATS["arrow"]:
        plain = _plain(schema).with_metadata(schema.metadata)  # words may differ from part to part
        with pa.ipc.new_file(str(file), plain) as arrow:
            yield lambda table: arrow.write_table(table.cast(plain))
    elif format in _DELIMITERS:
        plain = _plain(schema)
        options = pa.csv.WriteOptions(delimiter=_DELIMITERS[format])
        with (
            _refused(source, "CSV"),
            pa.OSFile(str(file), "wb") as bytes_out,
        ):
            about = (schema.metadata or {}).get(ABOUT)
            if about:
                bytes_out.write(COMMENT.encode() + about + b"\n")
            with pa.csv.CSVWriter(bytes_out, plain, write_options=options) as text:
                yield lambda table: text.write_table(_without_nan(table.cast(plain)))
    else:
        # A dictionary of doubles that hardly repeat is larger and slower than they are.
        repeat = [column.name for column in schema if not pa.types.is_floating(column.type)]
        # By its name: every write of a Python file would wait for the interpreter's lock.
        with (
            _refused(source, "Parquet"),
            pq.ParquetWriter(str(file), schema, compression="zstd", use_dictionary=repeat) as new,
        ):
            yield lambda table: new.write_table(table, rows)


@contextmanager
def _refused(source: object, format: str) -> Iterator[None]:
    try:
        yield
    except pa.ArrowNotImplementedError as error:  # of reading it is none: that names the file
        raise ValueError(f"{source}: {format} has no such column: {error}") from error
    except pa.ArrowInvalid as error:
        if "Unsupported Type" not in str(error):
            raise
        raise ValueError(f"{source}: {format} has no such column: {error}") from error


def _plain(schema: pa.Schema) -> pa.Schema:
    """Return a schema whose words are plain text."""
    return pa.schema(
        [
            (
                column.name,
                column.type.value_type if pa.types.is_dictionary(column.type) else column.type,
            )
            for column in schema
        ]
    )


def _without_nan(table: pa.Table) -> pa.Table:
    """Return a table in which nothing stands where there is no number."""
    cells = [
        pc.if_else(pc.is_nan(column), None, column) if pa.types.is_floating(column.type) else column
        for column in table.columns
    ]
    return pa.Table.from_arrays(cells, schema=table.schema)
