"""What callers gave, said in one short line: no error is longer than it helps."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import islice
from reprlib import Repr

__all__ = ["brief", "cut", "listed"]

LONGEST = 60
"""Characters of what was given that a message shows."""

MOST = 20
"""Names that a list in a message has."""

_REPR = Repr()
_REPR.maxstring = _REPR.maxother = _REPR.maxlong = 2 * LONGEST
_REPR.maxlist = _REPR.maxtuple = _REPR.maxset = _REPR.maxfrozenset = _REPR.maxdict = 10


def brief(value: object) -> str:
    """Return what `value` looks like, on one short line, however large it is."""
    try:
        text = _REPR.repr(value)
    except Exception:  # of an int with 5000 digits, and of what callers wrote themselves
        text = f"<{type(value).__name__}>"
    return cut(text)


def cut(text: str, longest: int = LONGEST) -> str:
    """Return a text on one line, and no longer than that; what no terminal should get, escaped."""
    first, *rest = text[: 10 * longest].splitlines() or [""]
    line = " ".join([first, *(more.strip() for more in rest)])
    line = "".join(each if each.isprintable() else repr(each)[1:-1] for each in line)
    return line if len(line) <= longest else f"{line[: longest - 3]}..."


def listed(names: Iterable[object]) -> str:
    """Return names with commas between; of many the first ones."""
    left = iter(names)
    shown = [cut(str(name)) for name in islice(left, MOST)]
    more = sum(1 for _ in left)
    return ", ".join([*shown, f"and {more} more"] if more else shown)
