"""CSV as people save it: which character stands between cells, the encoding, and what cells are.

All cells are read as text, so that none is changed and no type depends on the first rows. What type
a column has is known when all of it was read. Before the header there may be comment lines, which
begin with ``#``, that of results also as spreadsheets save it again, and the line ``sep=;`` of
Excel. A row with too few or too many cells is told by
its number, and is a row of empty cells; a line with the wrong number of cells that begins with
``#`` is a comment.
"""

from __future__ import annotations

import codecs
import csv
import io
import itertools
import json
import re
from collections import deque
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa
import pyarrow.compute as pc
import pyarrow.csv
from numpy.typing import NDArray

from hoopgen.text.numbers import format_count
from hoopgen.text.shorten import brief

DELIMITERS = (",", ";", "\t", "|")
"""Delimiters that are looked for in the header; the first is that of a file without any."""

COMMENT = "# hoopgen: "
"""Beginning of the comment line in which results say their scene, as JSON."""

_START = 1 << 16
"""Bytes at the beginning that tell of the encoding, and of the header those that are looked at."""

_LONGEST_LINE = 1 << 24
"""Bytes of a line before the header, at most."""

_SEPARATOR = re.compile(r'"?sep=(.|\\t)"?\s*', re.IGNORECASE)

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


@dataclass(frozen=True)
class Layout:
    """The layout of a file of CSV.

    Attributes
    ----------
    about
        What results say of their scene, as JSON; empty where there is no such comment.
    """

    delimiter: str  # between the cells
    skipped: int = 0  # lines before the header: comments, empty lines, and ``sep=;``
    about: str = ""
    start: int | None = None  # bytes of these lines; None where they may end in other signs than LF


def check_delimiter(delimiter: str) -> str:
    """Return the delimiter of the cells; "tab" is one, too."""
    plain = {"tab": "\t", "\\t": "\t"}.get(delimiter, delimiter)
    if len(plain) != 1 or not plain.isascii() or plain.isalnum() or plain in "\"'\n\r.+-_#":
        raise ValueError(
            f"delimiter: expected one character such as ; or , or tab, got {brief(delimiter)}"
        )
    return plain


def layout_of(path: Path, delimiter: str = "") -> Layout:
    """Return the layout of a file.

    Parameters
    ----------
    delimiter
        That the caller names; by default the one of a line ``sep=;``, or else which of
        `DELIMITERS` is most frequent in the header, outside of quotes.
    """
    with path.open("rb") as file:
        start = file.read(_START)
        if start[:2] in (b"\xff\xfe", b"\xfe\xff") or start.count(0) * 4 > len(start):
            raise ValueError("is in UTF-16, it seems; save it as UTF-8")
        file.seek(0)
        skipped, about, named, place, whole = 0, "", "", 0, True
        while line := file.readline(_LONGEST_LINE):
            text = line.decode("utf-8", "replace").lstrip("\ufeff").strip("\r\n")
            separator = _SEPARATOR.fullmatch(text)
            if separator and not named:
                named = check_delimiter(separator[1])
            elif text.startswith((COMMENT, f'"{COMMENT}')):
                if len(line) == _LONGEST_LINE:
                    raise ValueError(
                        f"its comment line, which says the scene of the shots, is longer than "
                        f"{_LONGEST_LINE:,} bytes; expected results in Parquet or Arrow, which "
                        "have no such limit"
                    )
                about = _about(text)
            elif text.strip() and not text.startswith("#"):
                break
            skipped, place = skipped + 1, place + len(line)
            whole = whole and line.endswith(b"\n")
        if whole:
            file.seek(place)
            start = file.read(_START)
    rows = start.decode("latin-1").splitlines(keepends=True)[0 if whole else skipped :]
    header = re.sub(r'"[^"]*"', "", "".join(rows)).partition("\n")[0]
    between = delimiter or named or max(DELIMITERS, key=header.count)
    return Layout(between, skipped, about, place if whole else None)


def _about(comment: str) -> str:
    """Return the JSON in the comment line of results, also if a spreadsheet has saved it again.

    Spreadsheets break it into cells, put these in quotes and add empty ones. Which delimiters they
    read and wrote shows in the JSON that comes out.
    """
    if comment.startswith(COMMENT):
        return comment.removeprefix(COMMENT)
    for written, read_ in itertools.product(DELIMITERS, DELIMITERS):
        text = read_.join(_cells(comment, written)).removeprefix(COMMENT).rstrip(read_)
        try:
            if isinstance(json.loads(text), dict):
                return text
        except (RecursionError, ValueError):
            continue
    return comment


def _cells(line: str, delimiter: str) -> list[str]:
    """Return the cells of a line, of any length: those of the module csv have a limit."""
    cell = re.compile(rf'"((?:[^"]++|"")*+)"|([^{re.escape(delimiter)}]*+)')
    cells, place = [], 0
    while place <= len(line):
        found = cell.match(line, place)
        assert found is not None  # an empty cell matches
        quoted, plain = found.groups()
        cells.append(plain if quoted is None else quoted.replace('""', '"'))
        place = found.end() + 1
    return cells


@contextmanager
def encoded() -> Iterator[None]:
    """Name the encoding in errors of reading text that is not UTF-8."""
    try:
        yield
    except (UnicodeDecodeError, pa.ArrowInvalid) as error:
        if "straddl" in str(error) or "out of sync" in str(error):
            raise ValueError(
                "a row is too long, or a quotation mark is not closed; --memory, memory=, raises "
                "what is read at a time"
            ) from error
        if not isinstance(error, UnicodeDecodeError) and "invalid UTF8" not in str(error):
            raise
        raise ValueError(
            "is not in UTF-8 but, it seems, in Latin-1 or Windows-1252; save it as UTF-8"
        ) from error


@contextmanager
def read(
    path: Path, layout: Layout, block: int, malformed: dict[int, str]
) -> Iterator[tuple[pa.Schema, Iterable[pa.RecordBatch]]]:
    """Open a file whose cells are text.

    Parameters
    ----------
    block
        Bytes that are read at a time; the longest row.
    malformed
        Receives why a row has no cells, by its number from 1, as far as rows were read.
    """
    skipped = layout.skipped if layout.start is None else 0
    blocks = pa.csv.ReadOptions(block_size=block, skip_rows=skipped, use_threads=False)
    delimiter = layout.delimiter
    first = pa.csv.ParseOptions(delimiter=delimiter, invalid_row_handler=lambda row: "skip")
    found = _Malformed(skipped + 1)
    rest = pa.csv.ParseOptions(
        delimiter=delimiter, newlines_in_values=True, invalid_row_handler=found
    )
    with encoded():
        start = layout.start or 0
        with _Utf8File(path, start) as file, pa.csv.open_csv(file, blocks, first) as reader:
            text = dict.fromkeys(reader.schema.names, pa.string())
        types = pa.csv.ConvertOptions(column_types=text)
        with _Utf8File(path, start) as file, pa.csv.open_csv(file, blocks, rest, types) as reader:
            yield reader.schema, _with_malformed(reader, found, malformed, delimiter)


class _Utf8File(io.RawIOBase):
    """A file whose bytes are validated as UTF-8 while they are read.

    pyarrow cannot tell of a malformed row that is in another encoding.
    """

    def __init__(self, path: Path, start: int) -> None:
        self._file = path.open("rb")
        self._file.seek(start)
        self._decoder = codecs.getincrementaldecoder("utf-8")()

    def readable(self) -> bool:
        return True

    def read(self, size: int = -1) -> bytes:
        """Return so many bytes; raises UnicodeDecodeError where they are not UTF-8."""
        content = self._file.read(size)
        self._decoder.decode(content, final=not content)
        return content

    def close(self) -> None:
        self._file.close()
        super().close()


class _Malformed:
    """Notes rows with a wrong number of cells, in the order in which they are read.

    Parameters
    ----------
    before
        Rows before the first one with cells, as the reader counts them.
    """

    def __init__(self, before: int) -> None:
        self._before = before
        self.rows: deque[tuple[int, str]] = deque()

    def __call__(self, row: Any) -> str:
        self.rows.append((row.number - self._before, row.text))
        return "skip"


def _with_malformed(
    reader: Any, found: _Malformed, malformed: dict[int, str], delimiter: str
) -> Iterator[pa.RecordBatch]:
    """Give the rows of a file, and in their places malformed ones, whose cells are null."""
    schema: pa.Schema = reader.schema
    good, bad, given = 0, 0, 0  # rows of the reader until now, and rows that were given
    for batch in itertools.chain(reader, [schema.empty_table().combine_chunks()]):
        number = batch.num_rows
        order: list[NDArray[np.intp]] = []
        rows: list[list[str | None]] = []
        start = 0
        while found.rows and (until := found.rows[0][0] - 1 - bad - good) <= number:
            order.append(np.arange(start, until))
            given, start, bad = given + until - start, until, bad + 1
            for cells in _recovered(found.rows.popleft()[1], schema, delimiter):
                given += 1
                order.append(np.array([number + len(rows)]))
                if isinstance(cells, str):
                    malformed[given] = cells
                rows.append([None] * len(schema) if isinstance(cells, str) else [*cells])
        given, good = given + number - start, good + number
        if rows:
            order.append(np.arange(start, number))
            batch = _placed(batch, rows, np.concatenate(order))
        yield from batch.to_batches() if isinstance(batch, pa.Table) else [batch]


def _placed(batch: Any, rows: list[list[str | None]], order: NDArray[np.intp]) -> pa.Table:
    """Return rows of a batch and others, in an order of both one after the other."""
    columns = [pa.array(column, pa.string()) for column in zip(*rows, strict=True)]
    others = pa.Table.from_arrays(columns, schema=batch.schema)
    first = batch if isinstance(batch, pa.Table) else pa.Table.from_batches([batch])
    return pa.concat_tables([first, others]).take(pa.array(order)).combine_chunks()


def _recovered(text: str, schema: pa.Schema, delimiter: str) -> Iterator[list[str] | str]:
    """Give the rows in a malformed one: cells, or why it has none; comments are no rows.

    A quote that is not closed takes the lines after it for its own. They are rows again where
    quotes do not come in pairs, or a line is a row by itself.
    """
    lines = text.splitlines()
    apart = [next(csv.reader([line], delimiter=delimiter), []) for line in lines]
    whole = [len(cells) == len(schema) for cells in apart]
    if not (text.count('"') % 2 or any(whole[1:])):
        lines, apart, whole = [text], [next(csv.reader(lines, delimiter=delimiter), [])], [False]
    for line, cells, good in zip(lines, apart, whole, strict=True):
        if good:
            yield cells
        elif not line.lstrip().startswith("#"):
            yield (
                f"{format_count(len(cells), 'cell')} where the header has {len(schema)}: "
                f"{brief(line)}"
            )


def survey(batches: Iterable[pa.RecordBatch], names: Iterable[str], comma: bool) -> dict[str, Any]:
    """Return the types of columns of text: of those all of whose cells are such numbers, or truths.

    Parameters
    ----------
    comma
        Whether a comma in a number is a decimal one.
    """
    possible = {name: dict(_TYPES) for name in names}
    filled: set[str] = set()
    for batch in batches:
        for name, types in possible.items():
            if not types:
                continue
            cells = with_decimal_points(batch[name], comma)
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


def text_columns(
    batches: Iterable[pa.RecordBatch], names: Iterable[str], comma: bool
) -> dict[str, Any]:
    """Return the type of text for those columns in which a cell is neither empty nor a number.

    Parameters
    ----------
    names
        The columns that are looked at.
    comma
        Whether a comma in a number is a decimal one.
    """
    found: dict[str, Any] = {}
    for batch in batches:
        for name in set(names).difference(found):
            cells = batch[name]
            rest = cells.filter(pc.is_null(parsed(cells, pa.float64(), comma)))
            if pc.any(pc.match_substring_regex(rest, r"\S")).as_py():
                found[name] = pa.string()
    return found


def parsed(cells: Any, kind: Any, comma: bool) -> Any:
    """Return text as of a type that `survey` gave, or as numbers; null where it is none.

    Parameters
    ----------
    cells
        The cells of one column, as text.
    kind
        The type that the column gets.
    comma
        True if numbers have a decimal comma.
    """
    if pa.types.is_string(kind):
        return cells
    cells = with_decimal_points(cells, comma)
    if not pa.types.is_floating(kind):
        return pc.if_else(pc.equal(cells, ""), None, cells).cast(kind)
    try:
        return cells.cast(kind)
    except pa.ArrowInvalid:
        plain = pc.utf8_trim_whitespace(cells)
        number = pc.match_substring_regex(plain, _NUMBER)
        return pc.if_else(number, plain, None).cast(kind)


def with_decimal_points(cells: Any, comma: bool) -> Any:
    """Return numbers that have a decimal comma with a point, and all others as they are.

    Parameters
    ----------
    cells
        The cells of one column, as text.
    comma
        True if numbers have a decimal comma.
    """
    return pc.replace_substring_regex(cells, _OF_COMMA, r"\1.\2") if comma else cells
