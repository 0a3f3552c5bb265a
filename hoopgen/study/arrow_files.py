"""Parquet and Arrow files, read a batch at a time and measured before they are laid out."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, TypeAlias

import pyarrow as pa
import pyarrow.ipc
import pyarrow.parquet as pq

from .limits import check_laid_out, check_pages, text_columns

__all__ = ["Opened", "Read", "read_arrow", "read_parquet", "regrouped", "validated"]

_BLOCK = 1 << 22
"""Bytes that are read at a time."""

_ARROW_FILE = b"ARROW1"
"""First bytes of an Arrow file; a stream has others."""

Read: TypeAlias = tuple[pa.Schema, Iterable[pa.RecordBatch]]
Opened = Iterator[Read]


@contextmanager
def read_parquet(path: Path, memory: int) -> Opened:
    """Yield the schema of a Parquet file and its batches, none larger than `memory` in bytes."""
    # Else a row group's pages are all read at once, and it may be all the file.
    options: dict[str, Any] = {"buffer_size": _BLOCK, "pre_buffer": False}
    with pq.ParquetFile(path, **options) as file:
        check_pages(file, memory)
        schema, text = file.schema_arrow, text_columns(file)
    # A text that many rows share is held once until its size is known.
    with pq.ParquetFile(path, read_dictionary=text, **options) as file:
        yield schema, (_laid_out(batch, schema, memory) for batch in file.iter_batches())


def _laid_out(batch: pa.RecordBatch, schema: pa.Schema, memory: int) -> pa.RecordBatch:
    check_laid_out(batch, memory)
    return batch if batch.schema.equals(schema) else batch.cast(schema)


@contextmanager
def read_arrow(path: Path, memory: int) -> Opened:
    """Yield the schema of an Arrow file or stream and its batches, as they were written."""
    # No memory map: a file that becomes shorter while it is read would end the process.
    with pa.OSFile(str(path)) as file:
        if file.read(len(_ARROW_FILE)) != _ARROW_FILE:
            file.seek(0)
            stream = pa.ipc.open_stream(file)
            yield stream.schema, stream
        else:
            blocks = pa.ipc.open_file(file)
            yield blocks.schema, map(blocks.get_batch, range(blocks.num_record_batches))


def validated(batch: pa.RecordBatch, memory: int) -> pa.RecordBatch:
    """Return the rows that were read, all of whose offsets and indices lie within them.

    Arrow takes those of a file as they are, and follows them wherever they lead.
    """
    batch.validate(full=True)
    check_laid_out(batch, memory)
    return batch


def regrouped(
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
