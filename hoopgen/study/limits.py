"""Limits on what is read of a file at once: no table, however made, takes more memory than allowed.

A small file may hold much: a text that thousands of rows share, pages that are unpacked to a
thousand times their size, one row group of everything. Each is measured before it is laid out in
memory.
"""

from __future__ import annotations

from typing import Any

import pyarrow as pa
import pyarrow.compute as pc
import pyarrow.parquet as pq

from hoopgen.brief import cut

__all__ = ["LEAST_MEMORY", "MEMORY", "check_laid_out", "check_pages", "text_columns"]

MEMORY = 1 << 30
"""Bytes that the rows of a table which are read at once may take, unless asked for otherwise."""

LEAST_MEMORY = 1 << 24
"""Bytes that have to be allowed: less than a few blocks of a file is of no use."""

_PACKED = 1000
"""Times that pages may be larger than in the file, where a column is larger than the limit."""


def check_pages(file: pq.ParquetFile, memory: int) -> None:
    """Refuse a file of Parquet with pages that are small in the file alone.

    Raises
    ------
    ValueError
        If a column of a row group takes more than `memory` bytes, and is packed more than a
        thousandfold: then single pages may.
    """
    about = file.metadata
    for group in map(about.row_group, range(about.num_row_groups)):
        if group.total_byte_size <= memory:
            continue
        for column in map(group.column, range(about.num_columns)):
            size = column.total_uncompressed_size
            if size > memory and size > _PACKED * column.total_compressed_size:
                raise _too_large(column.path_in_schema, size, memory)


def text_columns(file: pq.ParquetFile) -> list[str]:
    """Return the columns of text: those to be read with each different text held once."""
    about = file.metadata.schema
    columns = (about.column(index) for index in range(len(about)))
    return [one.path for one in columns if one.physical_type == "BYTE_ARRAY"]


def check_laid_out(batch: pa.RecordBatch, memory: int) -> None:
    """Refuse rows that take more memory than allowed when each has its own text.

    Raises
    ------
    ValueError
        If they do; the message names the column.
    """
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
