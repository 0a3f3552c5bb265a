"""HTML tables of results for notebooks, with all texts escaped."""

from __future__ import annotations

import html
from collections.abc import Iterable, Sequence

MAX_ROWS = 10
"""Shown of a long table: half of them from its start, half from its end."""


class Printed:
    """A result that is represented, and shown in notebooks, as it is printed."""

    def __repr__(self) -> str:
        return str(self)

    def _repr_html_(self) -> str:
        return f"<pre>{html.escape(str(self))}</pre>"


def some_rows(count: int) -> list[int]:
    """Return the indices of the rows that a table shows; long tables lose their middle."""
    if count <= MAX_ROWS:
        return list(range(count))
    return [*range(MAX_ROWS // 2), *range(count - MAX_ROWS // 2, count)]


def table(
    about: str, head: Sequence[str], rows: Iterable[Sequence[object]], *, gap: int | None = None
) -> str:
    """Return a table as HTML.

    Parameters
    ----------
    about
        A line above it; none where empty.
    head
        Names of the columns.
    rows
        Cells; numbers that are not whole have four decimals.
    gap
        Rows before those that are left out, if some are.
    """
    lines = ["".join(_cell(cell) for cell in row) for row in rows]
    if gap is not None:
        lines.insert(gap, "<td>…</td>" * len(head))
    above = f"<p>{html.escape(about)}</p>" if about else ""
    top = "".join(f"<th>{html.escape(name)}</th>" for name in head)
    body = "".join(f"<tr>{line}</tr>" for line in lines)
    return f"{above}<table><thead><tr>{top}</tr></thead><tbody>{body}</tbody></table>"


def _cell(value: object) -> str:
    text = f"{value:.4f}" if isinstance(value, float) else str(value)
    return f"<td>{html.escape(text)}</td>"
