"""CSV as people save it: which character stands between cells, the encoding, and what cells are.

All cells are read as text, so that none is changed and no type hangs on what comes first. What type
a column has is known when all of it was read.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pyarrow as pa
import pyarrow.compute as pc
import pyarrow.csv

from hoopgen.brief import brief

__all__ = ["DELIMITERS", "check_delimiter", "delimiter_of", "encoded", "parsed", "read", "survey"]

DELIMITERS = (",", ";", "\t", "|")
"""Those that are looked for in the first line; the first is that of a file without any."""

_START = 1 << 16
"""Bytes at the beginning that tell of encoding and delimiter."""

_NUMBER = r"^[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?$"

_OF_COMMA = r"^([+-]?\d*),(\d+([eE][+-]?\d+)?)$"
"""A number with a decimal comma, as ``7,5``; of ``1.234,5`` nobody says what it is."""

# Identifiers stay text: 0022400001, 12E4, and what is longer than doubles tell apart.
_WHOLE = r"(0|[1-9]\d{0,14})"
_TYPES = (
    (pa.int64(), rf"^-?{_WHOLE}$"),
    (pa.float64(), rf"^-?({_WHOLE}(\.\d*)?|\.\d+)([eE][+-]\d{{1,2}})?$"),
    (pa.bool_(), r"^([Tt]rue|[Ff]alse)$"),
)


def check_delimiter(delimiter: str) -> str:
    """Return what stands between the cells; "tab" too.

    Raises
    ------
    ValueError
        If it is not one character, or one that cells consist of.
    """
    plain = {"tab": "\t", "\\t": "\t"}.get(delimiter, delimiter)
    if len(plain) != 1 or not plain.isascii() or plain.isalnum() or plain in "\"'\n\r.+-_":
        raise ValueError(
            f"delimiter: expected one character such as ; or , or tab, got {brief(delimiter)}"
        )
    return plain


def delimiter_of(path: Path) -> str:
    """Return which of `DELIMITERS` is most frequent in the first line, outside of quotes.

    Raises
    ------
    ValueError
        If the file is in UTF-16.
    """
    with path.open("rb") as file:
        start = file.read(_START)
    if start[:2] in (b"\xff\xfe", b"\xfe\xff") or start.count(0) * 4 > len(start):
        raise ValueError("is in UTF-16, it seems; save it as UTF-8")
    text = start.decode("latin-1").lstrip("\r\n")
    first = re.sub(r'"[^"]*"', "", text).lstrip("\r\n").partition("\n")[0]
    return max(DELIMITERS, key=first.count)


@contextmanager
def encoded() -> Iterator[None]:
    """Name the encoding in errors of reading text that is not UTF-8."""
    try:
        yield
    except (UnicodeDecodeError, pa.ArrowInvalid) as error:
        if not isinstance(error, UnicodeDecodeError) and "invalid UTF8" not in str(error):
            raise
        raise ValueError(
            "is not in UTF-8 but, it seems, in Latin-1 or Windows-1252; save it as UTF-8"
        ) from error


@contextmanager
def read(
    path: Path, delimiter: str, block: int
) -> Iterator[tuple[pa.Schema, Iterable[pa.RecordBatch]]]:
    """Open a file whose cells are text."""
    blocks = pa.csv.ReadOptions(block_size=block)
    first = pa.csv.ParseOptions(delimiter=delimiter)
    layout = pa.csv.ParseOptions(delimiter=delimiter, newlines_in_values=True)
    with encoded():
        with pa.csv.open_csv(path, blocks, first) as reader:
            text = dict.fromkeys(reader.schema.names, pa.string())
        types = pa.csv.ConvertOptions(column_types=text)
        with pa.csv.open_csv(path, blocks, layout, types) as reader:
            yield reader.schema, reader


def survey(batches: Iterable[pa.RecordBatch], names: Iterable[str], comma: bool) -> dict[str, Any]:
    """Return the types of columns of text: of those all of whose cells are such numbers, or truths.

    Parameters
    ----------
    batches
        All of the file.
    names
        Of the columns that are wanted.
    comma
        Whether a comma in a number is a decimal one.
    """
    possible = {name: dict(_TYPES) for name in names}
    filled: set[str] = set()
    for batch in batches:
        for name, types in possible.items():
            if not types:
                continue
            cells = _pointed(batch[name], comma)
            cells = cells.filter(pc.not_equal(cells, ""))
            if len(cells):
                filled.add(name)
                possible[name] = {
                    kind: pattern
                    for kind, pattern in types.items()
                    if pc.all(pc.match_substring_regex(cells, pattern)).as_py()
                }
    return {
        name: next(iter(types)) if types and name in filled else pa.string()
        for name, types in possible.items()
    }


def parsed(cells: Any, kind: Any, comma: bool) -> Any:
    """Return text as of a type that `survey` gave, or as numbers; null where it is none."""
    if pa.types.is_string(kind):
        return cells
    cells = _pointed(cells, comma)
    if not pa.types.is_floating(kind):
        return pc.if_else(pc.equal(cells, ""), None, cells).cast(kind)
    try:
        return cells.cast(kind)
    except pa.ArrowInvalid:
        plain = pc.utf8_trim_whitespace(cells)
        number = pc.match_substring_regex(plain, _NUMBER)
        return pc.if_else(number, plain, None).cast(kind)


def _pointed(cells: Any, comma: bool) -> Any:
    """Return numbers that have a decimal comma with a point, and all others as they are."""
    return pc.replace_substring_regex(cells, _OF_COMMA, r"\1.\2") if comma else cells
