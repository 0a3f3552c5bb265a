"""Plain text tables: columns as wide as they need, two spaces between them."""

from __future__ import annotations

import textwrap
from collections.abc import Mapping, Sequence
from itertools import zip_longest

NO_BREAK = "\N{NO-BREAK SPACE}"

_GAP = "  "


def table(
    headers: Sequence[str],
    rows: Sequence[Sequence[str]],
    *,
    right: Sequence[int] = (),
    wrap: Mapping[int, int] | None = None,
    groups: Sequence[tuple[int, int, str]] = (),
) -> str:
    """Lay out a table.

    Parameters
    ----------
    headers
        One for each column.
    rows
        As many cells each.
    right
        Columns set flush right: numbers.
    wrap
        Greatest width of a column whose cells are broken into lines, though not at a
        no-break space.
    groups
        Titles over several columns: first column, last column, title.

    Returns
    -------
    str
        Lines without trailing blanks.
    """
    narrow = wrap or {}
    cells = [
        [_wrap_cell(cell, narrow.get(column)) for column, cell in enumerate(row)] for row in rows
    ]
    widths = [
        max([len(header), *(len(line) for row in cells for line in row[column])])
        for column, header in enumerate(headers)
    ]
    lines = [_group_line(groups, widths)] if groups else []
    lines.append(_line(headers, widths, right))
    lines.append(_GAP.join("-" * width for width in widths))
    for row in cells:
        lines.extend(_line(line, widths, right) for line in zip_longest(*row, fillvalue=""))
    return "\n".join(lines)


def _wrap_cell(cell: str, width: int | None) -> list[str]:
    return [cell] if width is None else textwrap.wrap(cell, width)


def _line(cells: Sequence[str], widths: Sequence[int], right: Sequence[int]) -> str:
    flush = [
        cell.rjust(width) if column in right else cell.ljust(width)
        for column, (cell, width) in enumerate(zip(cells, widths, strict=True))
    ]
    return _GAP.join(flush).rstrip().replace(NO_BREAK, " ")


def _group_line(groups: Sequence[tuple[int, int, str]], widths: Sequence[int]) -> str:
    """Return a line with each title centred over its columns."""
    line = ""
    for first, last, title in groups:
        start = sum(widths[:first]) + len(_GAP) * first
        span = sum(widths[first : last + 1]) + len(_GAP) * (last - first)
        line = line.ljust(start) + f" {title} ".center(span, "-")
    return line
