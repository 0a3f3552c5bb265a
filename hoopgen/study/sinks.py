"""Where tables of results go: Parquet, CSV, or Arrow for those that stay in memory."""

from __future__ import annotations

import io
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TypeAlias

import pyarrow as pa
import pyarrow.compute as pc
import pyarrow.csv
import pyarrow.ipc
import pyarrow.parquet as pq

from .delimited import COMMENT
from .tables import ABOUT

__all__ = ["RESULTS", "Sink", "check_sink", "sink"]

RESULTS = (".parquet", ".pq", ".csv", ".tsv")
"""What the names of files of results end in."""

_DELIMITERS = {".csv": ",", ".tsv": "\t"}

Sink: TypeAlias = Callable[[pa.Table], None]
"""Takes the next rows."""


def check_sink(format: str, schema: pa.Schema, source: object) -> None:
    """Refuse columns that a format cannot have, before the work where that can be told.

    Raises
    ------
    ValueError
        The message begins with the source.
    """
    if format in _DELIMITERS:
        with _refused(source, "CSV"):
            pa.csv.write_csv(_plain(schema).empty_table(), io.BytesIO())


@contextmanager
def sink(file: Path, format: str, schema: pa.Schema, rows: int, source: object) -> Iterator[Sink]:
    """Write tables to a file.

    Parameters
    ----------
    file
        It lies where unfinished files may.
    format
        One of `RESULTS`, or ".arrow", a stream.
    schema
        Of the tables; CSV has what its metadata says of the scene in a comment line at its start.
    rows
        At most, in a group.
    source
        That of the rows, for errors.
    """
    if format == ".arrow":
        with pa.ipc.new_stream(str(file), schema) as stream:
            yield stream.write_table
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
