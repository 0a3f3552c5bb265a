"""Where tables of results go: Parquet, CSV, or Arrow for those that stay in memory."""

from __future__ import annotations

import io
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import TypeAlias

import numpy as np
import pyarrow as pa
import pyarrow.compute as pc
import pyarrow.csv
import pyarrow.ipc
import pyarrow.parquet as pq

__all__ = ["RESULTS", "Sink", "check_sink", "sink"]

RESULTS = (".parquet", ".pq", ".csv")
"""What the names of files of results end in."""

Sink: TypeAlias = Callable[[pa.Table], None]
"""Takes the next rows."""


def check_sink(format: str, schema: pa.Schema, source: object) -> None:
    """Refuse columns that a format cannot have, before the work where that can be told.

    Raises
    ------
    ValueError
        The message begins with the source.
    """
    if format == ".csv":
        with _refused(source, "CSV"):
            pa.csv.write_csv(_plain(schema).empty_table(), io.BytesIO())


@contextmanager
def sink(
    file: Path,
    format: str,
    schema: pa.Schema,
    rows: int,
    shared: Mapping[str, float],
    source: object,
) -> Iterator[Sink]:
    """Write tables to a file.

    Parameters
    ----------
    file
        It lies where unfinished files may.
    format
        One of `RESULTS`, or ".arrow", a stream.
    schema
        Of the tables.
    rows
        At most, in a group.
    shared
        Columns of CSV with one number each, after the others.
    source
        That of the rows, for errors.
    """
    if format == ".arrow":
        with pa.ipc.new_stream(str(file), schema) as stream:
            yield stream.write_table
    elif format == ".csv":
        plain = _plain(schema)
        whole = pa.schema([*plain, *((name, pa.scalar(v).type) for name, v in shared.items())])
        with _refused(source, "CSV"), pa.csv.CSVWriter(str(file), whole) as text:
            yield lambda table: text.write_table(_with(table.cast(plain), shared, whole))
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


def _with(table: pa.Table, shared: Mapping[str, float], schema: pa.Schema) -> pa.Table:
    """Return a table with columns of one number each; nothing stands where there is no number."""
    cells = [
        pc.if_else(pc.is_nan(column), None, column) if pa.types.is_floating(column.type) else column
        for column in table.columns
    ]
    cells += [pa.array(np.full(table.num_rows, value)) for value in shared.values()]
    return pa.Table.from_arrays(cells, schema=schema)
