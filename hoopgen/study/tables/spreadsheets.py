"""Spreadsheets: the first sheet of an .xlsx file as a table of text, which is read as CSV is."""

from __future__ import annotations

import datetime
import zipfile
from collections.abc import Iterator
from contextlib import contextmanager
from itertools import islice
from pathlib import Path
from typing import Any

import pyarrow as pa

from hoopgen.core.extras import require

_ROWS = 1 << 14
"""Number of rows in a batch."""


@contextmanager
def read(path: Path, memory: int) -> Iterator[tuple[pa.Schema, Iterator[pa.RecordBatch]]]:
    """Open the first sheet of a file; formulas are the values that were last computed.

    The first row that is not empty is the header. Columns without a header and without cells are
    left out, and so are empty rows.

    Parameters
    ----------
    memory
        Bytes that its parts may have, unpacked.

    Raises
    ------
    MissingExtra
        If openpyxl is missing: what brings it.
    ValueError
        If it is no such file, it is larger than that, or two cells of the header agree.
    """
    openpyxl = require("openpyxl", "a table in .xlsx")
    try:
        with zipfile.ZipFile(path) as parts:
            size = sum(part.file_size for part in parts.infolist())
        if size > memory:
            raise ValueError(
                f"has {size:,} bytes unpacked, more than {memory:,}; --memory, memory=, allows more"
            )
        book = openpyxl.load_workbook(path, read_only=True, data_only=True)
    except (KeyError, zipfile.BadZipFile, openpyxl.utils.exceptions.InvalidFileException) as error:
        raise ValueError(f"is no workbook in .xlsx: {error}") from error
    try:
        sheet = book.worksheets[0]
        sheet.reset_dimensions()  # what the file says of its size may be wrong
        rows = (
            row for row in sheet.iter_rows(values_only=True) if any(_text(cell) for cell in row)
        )
        header = [_text(cell) for cell in next(rows, ())]
        while header and not header[-1]:
            header.pop()
        schema = pa.schema([(name, pa.string()) for name in header])
        yield schema, _batches(rows, schema)
    finally:
        book.close()


def _batches(rows: Iterator[tuple[Any, ...]], schema: pa.Schema) -> Iterator[pa.RecordBatch]:
    width = len(schema)
    while some := list(islice(rows, _ROWS)):
        cells = [[_text(cell) for cell in row[:width]] for row in some]
        full = [[*row, *[""] * (width - len(row))] for row in cells]
        columns = zip(*full, strict=True)
        arrays = [pa.array(column, pa.string()) for column in columns]
        yield pa.RecordBatch.from_arrays(arrays, schema=schema)


def _text(cell: Any) -> str:
    """Return a cell as text; a number as it was stored, a whole one without a point."""
    if cell is None:
        return ""
    if isinstance(cell, float):
        return str(int(cell)) if cell.is_integer() and abs(cell) < 2**53 else repr(cell)
    if isinstance(cell, datetime.datetime | datetime.date | datetime.time):
        return cell.isoformat()
    return str(cell)
