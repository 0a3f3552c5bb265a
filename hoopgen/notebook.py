"""What notebooks show of results: HTML in which every word is text."""

from __future__ import annotations

import html
from collections.abc import Iterable, Sequence
from typing import Any

from .installed import need

__all__ = ["Said", "some_rows", "table"]

ROWS = 10
"""Shown of a long table: half of them from its start, half from its end."""


class Said:
    """A result that is shown and represented as it is printed, and becomes a row of a table."""

    def as_dict(self) -> dict[str, Any]:
        """Return everything, in types that JSON knows."""
        raise NotImplementedError

    def to_pandas(self) -> Any:
        """Return a pandas.DataFrame of one row: what `as_dict` gives, nested names joined by _.

        Units are in the columns' names.

        Raises
        ------
        ImportError
            If pandas is missing: what brings it.
        """
        from .study.named import in_units

        return need("pandas", "to_pandas").json_normalize([in_units(self.as_dict())], sep="_")

    def __repr__(self) -> str:
        return str(self)

    def _repr_html_(self) -> str:
        return f"<pre>{html.escape(str(self))}</pre>"


def some_rows(count: int) -> list[int]:
    """Return which rows of so many are shown; fewer than `count` leave out the middle."""
    if count <= ROWS:
        return list(range(count))
    return [*range(ROWS // 2), *range(count - ROWS // 2, count)]


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
