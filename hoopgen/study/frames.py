"""Tables in memory, of pandas, Polars or whatever speaks Arrow: files for as long as needed."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import pyarrow as pa
import pyarrow.ipc

from hoopgen.brief import brief

from .reading import Reading
from .tables import Source

__all__ = ["sourced"]

_ROWS = 1 << 16
"""Written at a time."""

# Of Polars; files and the reading of numbers know the others.
_OLDER = {pa.string_view(): pa.large_string(), pa.binary_view(): pa.large_binary()}


@contextmanager
def sourced(source: Any, reading: Reading) -> Iterator[Source]:
    """Give a table to be read from a file, also one in memory.

    Raises
    ------
    TypeError
        If `source` is neither a path nor a table.
    ValueError
        If format or delimiter are not as for `Source`.
    """
    if isinstance(source, str | os.PathLike):
        yield reading.source(Path(source))
        return
    if not hasattr(source, "__arrow_c_stream__"):
        raise TypeError(
            "source: expected a file, or a table of pandas (from 2.2), Polars or Arrow; "
            f"got {brief(source)}"
        )
    if reading.format or reading.delimiter:
        raise ValueError("format, delimiter: a table in memory has none")
    with TemporaryDirectory(prefix="hoopgen-") as folder:
        file = Path(folder, "source.arrow")
        reader = pa.RecordBatchReader.from_stream(source)
        schema = _older(reader.schema)
        with pa.ipc.new_stream(str(file), schema) as stream:
            for batch in reader:
                # In parts, as of a file: a frame may be one batch, however large it is.
                stream.write_table(pa.Table.from_batches([batch]).cast(schema), _ROWS)
        yield reading.source(file, "the table")


def _older(schema: pa.Schema) -> pa.Schema:
    for index, column in enumerate(schema):
        if column.type in _OLDER:
            schema = schema.set(index, column.with_type(_OLDER[column.type]))
    return schema
