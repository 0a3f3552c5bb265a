"""The line of a key in a TOML file: tomllib says what a file holds, not where.

No grammar is repeated here. A statement, a key with its value or the head of a table, begins where
the text before it is a document; and a key is in the first statement with which the text up to its
end holds it.
"""

from __future__ import annotations

import tomllib
from bisect import bisect_left
from collections.abc import Iterator, Sequence
from itertools import product
from typing import Any

Path = tuple[str | int, ...]
"""Keys of tables, and places in arrays from 0."""

_CLOSED = tuple(
    # On a line of its own, since the line before may end in a comment; but no line ends inside a
    # table in braces.
    "\n" * (brackets[0] == "]") + "".join(brackets)
    for depth in range(1, 4)
    for brackets in product("]}", repeat=depth)
)
"""Texts that may end a statement that goes on: arrays and tables within one another."""


def line_of(text: str, path: Path) -> int:
    """Return the line, from 1, in which a value of a TOML document begins.

    Parameters
    ----------
    text
        A document that `tomllib.loads` accepts.
    path
        Of the value. What is not there is where the longest part of its path is; line 1 if none is.
    """
    lines = text.replace("\r\n", "\n").split("\n")
    while not _holds(text, path):
        path = path[:-1]
    if not path:
        return 1
    ends = list(_ends(lines))
    place = bisect_left(ends, True, key=lambda end: _holds(_joined(lines[:end]), path))
    first = ends[place - 1] + 1 if place else 1
    return _within(lines, first, ends[place], path)


def _ends(lines: Sequence[str]) -> Iterator[int]:
    """Yield the last line of each statement, and every line without one."""
    first = 0
    for number in range(1, len(lines) + 1):
        if _parsed(_joined(lines[first:number])) is not None:
            yield number
            first = number


def _within(lines: Sequence[str], first: int, last: int, path: Path) -> int:
    """Return the line of a value in the statement that adds it: where its array has got so far."""
    found = first
    for number in range(first, last):
        for closed in _CLOSED:
            part = _joined(lines[:number]) + closed
            if _parsed(part) is not None:
                if _holds(part, path):
                    return number
                found = number + 1
                break
    return found


def _joined(lines: Sequence[str]) -> str:
    return "\n".join(lines)


def _parsed(text: str) -> dict[str, Any] | None:
    try:
        return tomllib.loads(text)
    except tomllib.TOMLDecodeError:
        return None


def _holds(text: str, path: Path) -> bool:
    value: Any = _parsed(text)
    for step in path:
        if isinstance(step, int) and isinstance(value, list):
            if step >= len(value):
                return False
        elif not isinstance(value, dict) or step not in value:
            return False
        value = value[step]
    return True
