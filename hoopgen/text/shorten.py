"""Shortened values and lists for one-line error messages."""

from __future__ import annotations

from collections.abc import Iterable
from difflib import get_close_matches
from itertools import islice
from reprlib import Repr

MAX_LENGTH = 60
"""Characters of what was given that a message shows."""

MAX_NAMES = 20
"""Names that a list in a message has."""

_ALIKE = 0.65
"""Least similarity by difflib of a word and the one that was perhaps meant: aim is no azimuth."""

_REPR = Repr()
_REPR.maxstring = _REPR.maxother = _REPR.maxlong = 2 * MAX_LENGTH
_REPR.maxlist = _REPR.maxtuple = _REPR.maxset = _REPR.maxfrozenset = _REPR.maxdict = 10


def brief(value: object) -> str:
    """Return a representation of `value` on one short line, however large it is."""
    try:
        text = _REPR.repr(value)
    except Exception:  # of an int with 5000 digits, and of what callers wrote themselves
        text = f"<{type(value).__name__}>"
    return cut(text)


def cut(text: str, longest: int = MAX_LENGTH) -> str:
    """Return a text on one line of limited length, escaped for terminals.

    Parameters
    ----------
    text
        Any text.
    longest
        The greatest number of characters.
    """
    first, *rest = text[: 10 * longest].splitlines() or [""]
    line = " ".join([first, *(more.strip() for more in rest)])
    line = "".join(each if each.isprintable() else repr(each)[1:-1] for each in line)
    return line if len(line) <= longest else f"{line[: longest - 3]}..."


def join_alternatives(names: Iterable[str]) -> str:
    """Return names joined by commas, the last by "or"."""
    *first, last = names
    return f"{', '.join(first)} or {last}" if first else last


def join_names(names: Iterable[object]) -> str:
    """Return names joined by commas; of many the first ones."""
    left = iter(names)
    shown = [cut(str(name)) for name in islice(left, MAX_NAMES)]
    more = sum(1 for _ in left)
    return ", ".join([*shown, f"and {more} more"] if more else shown)


def suggestion(given: object, allowed: Iterable[str]) -> str:
    """Return a question for the word that was perhaps meant; nothing if none is close.

    Parameters
    ----------
    given
        The word that was given.
    allowed
        The words that are allowed.
    """
    close = get_close_matches(str(given).lower(), list(allowed), n=1, cutoff=_ALIKE)
    return f"; is {close[0]} meant?" if close else ""
