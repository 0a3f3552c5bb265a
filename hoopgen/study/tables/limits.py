"""Parquet and Arrow files, read in batches, and limits on what is read of a file at once.

No table, however made, takes more memory than allowed.

A small file may hold much: a text that thousands of rows share, pages that are unpacked to a
thousand times their size, one row group of everything. Each is measured before it is laid out in
memory.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, TypeAlias

import pyarrow as pa
import pyarrow.compute as pc
import pyarrow.ipc
import pyarrow.parquet as pq

from hoopgen.text.shorten import cut

MEMORY = 1 << 30
"""Bytes that the rows of a table which are read at once may take, unless asked for otherwise."""

LEAST_MEMORY = 1 << 24
"""Bytes that have to be allowed: less than a few blocks of a file is of no use."""

_PACKED = 1000
"""Times that pages may be larger than in the file, where a column is larger than the limit."""


def _check_pages(file: pq.ParquetFile, memory: int) -> None:
    """Refuse a file with pages that are small in the file alone, many times larger in memory."""
    about = file.metadata
    for group in map(about.row_group, range(about.num_row_groups)):
        if group.total_byte_size <= memory:
            continue
        for column in map(group.column, range(about.num_columns)):
            size = column.total_uncompressed_size
            if size > memory and size > _PACKED * column.total_compressed_size:
                raise _too_large(column.path_in_schema, size, memory)


def _text_columns(file: pq.ParquetFile) -> list[str]:
    """Return the columns of text: those to be read with each different text held once."""
    about = file.metadata.schema
    columns = (about.column(index) for index in range(len(about)))
    return [one.path for one in columns if one.physical_type == "BYTE_ARRAY"]


def _check_laid_out(batch: pa.RecordBatch, memory: int) -> None:
    """Refuse rows that take more memory than allowed when each has its own text."""
    if batch.nbytes > memory:
        raise _too_large(None, batch.nbytes, memory)
    for name, column in zip(batch.schema.names, batch.columns, strict=True):
        size = _laid_out(column)
        if size > memory:
            raise _too_large(name, size, memory)


def _laid_out(column: Any) -> int:
    """Return the bytes of all texts of a column, those shared by several rows each time."""
    kind = column.type
    if pa.types.is_dictionary(kind):
        if pa.types.is_nested(kind.value_type):
            return int(column.dictionary.nbytes) * len(column)
        try:
            lengths = pc.binary_length(column.dictionary)
        except pa.ArrowNotImplementedError:  # of numbers
            return 0
        return pc.sum(lengths.cast(pa.int64()).take(column.indices)).as_py() or 0
    if pa.types.is_list(kind) or pa.types.is_large_list(kind) or pa.types.is_map(kind):
        return _laid_out(column.flatten() if not pa.types.is_map(kind) else column.items)
    if pa.types.is_struct(kind):
        return sum(_laid_out(part) for part in column.flatten())
    return 0


def _too_large(name: str | None, size: int, memory: int) -> ValueError:
    what = "rows that are read at once have" if name is None else f"column {cut(name)} has"
    return ValueError(
        f"{what} {size:,} bytes, more than {memory:,}; --memory, memory=, allows more"
    )


_BLOCK = 1 << 22
"""Bytes that are read at a time."""

_ARROW_FILE = b"ARROW1"
"""First bytes of an Arrow file; a stream has others."""

Read: TypeAlias = tuple[pa.Schema, Iterable[pa.RecordBatch]]
Opened = Iterator[Read]


@contextmanager
def read_parquet(path: Path, memory: int) -> Opened:
    """Yield the schema of a Parquet file and its batches, none larger than `memory` in bytes.

    Parameters
    ----------
    path
        The file.
    memory
        The largest size of a batch, bytes.

    Raises
    ------
    ValueError
        If a page or a batch takes more.
    """
    # Else a row group's pages are all read at once, and it may be all the file.
    options: dict[str, Any] = {"buffer_size": _BLOCK, "pre_buffer": False}
    with pq.ParquetFile(path, **options) as file:
        _check_pages(file, memory)
        schema, text = file.schema_arrow, _text_columns(file)
    # A text that many rows share is held once until its size is known.
    with pq.ParquetFile(path, read_dictionary=text, **options) as file:
        yield schema, (_checked_batch(batch, schema, memory) for batch in file.iter_batches())


def _checked_batch(batch: pa.RecordBatch, schema: pa.Schema, memory: int) -> pa.RecordBatch:
    _check_laid_out(batch, memory)
    return batch if batch.schema.equals(schema) else batch.cast(schema)


@contextmanager
def read_arrow(path: Path, memory: int) -> Opened:
    """Yield the schema of an Arrow file or stream and its batches, as they were written.

    Parameters
    ----------
    path
        The file.
    memory
        The largest number of bytes of a batch; Arrow's own reader does not need it.

    Raises
    ------
    pyarrow.ArrowException
        If it is neither.
    """
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

    Parameters
    ----------
    batch
        Rows as Arrow read them.
    memory
        The largest size of the rows, bytes.
    """
    batch.validate(full=True)
    _check_laid_out(batch, memory)
    return batch


def regrouped(
    schema: pa.Schema, batches: Iterable[pa.RecordBatch], rows: int
) -> Iterator[pa.Table]:
    """Give tables of so many rows, whatever the batches have.

    Parameters
    ----------
    schema
        The schema of all batches.
    batches
        The rows in order.
    rows
        The number of rows of each table but the last, which may have fewer. Without any row there
        is one empty table.
    """
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
