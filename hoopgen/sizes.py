"""How much memory a question would take: looked at before any is asked for.

Python would end in the middle of the work with an error that names an array; a system that has
promised more than it has would end the process without a word.
"""

from __future__ import annotations

import os
from decimal import Decimal
from functools import cache
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from .phrases import percent

__all__ = ["check_room", "evenly", "in_bytes", "in_short", "memory"]

SHARE = 0.75
"""Of the memory, at most, that one thing may take; the rest is for all else that is there."""

VALUE = 100
"""Bytes that a value of a variable takes, in an array, in a list and in text."""

UNKNOWN = 1 << 36
"""Bytes of memory, where the system does not say."""

_LIMIT = Path("/sys/fs/cgroup/memory.max")
"""What a container may use, on Linux; "max" for all there is."""


@cache
def memory() -> int:
    """Return the bytes of memory of this machine, or of the container it is."""
    try:
        there = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    except (AttributeError, OSError, ValueError):  # not on Windows
        there = 0
    try:
        allowed = int(_LIMIT.read_text(encoding="ascii"))
    except (OSError, ValueError):
        allowed = 0
    return min((size for size in (there, allowed) if size > 0), default=UNKNOWN)


def check_room(name: str, count: int, what: str, each: int) -> None:
    """Refuse what would take more than its share of the memory.

    Parameters
    ----------
    name
        The argument that says how many.
    count
        How many.
    what
        Of what, in the plural.
    each
        Bytes that one takes, all copies counted.

    Raises
    ------
    ValueError
        If it does; with how much it would take.
    """
    if count * each > SHARE * memory():
        raise ValueError(
            f"{name}: {in_short(count)} {what} would take {in_bytes(count * each)} of memory; of "
            f"the {in_bytes(memory())} there are, at most {percent(SHARE, 0)} are asked for. "
            "Give fewer"
        )


def evenly(name: str, first: float, last: float, count: int) -> NDArray[np.float64]:
    """Return so many values from the first to the last, (count,).

    Raises
    ------
    ValueError
        If there are too many, or no number is as far from the first as the last; it begins with
        `name`.
    """
    check_room(name, count, "values", VALUE)
    if not np.isfinite(last - first):
        raise ValueError(f"{name}: from {first:g} to {last:g} is further than numbers go")
    return np.linspace(first, last, count)


def in_short(count: int) -> str:
    """Say a whole number: in full, or of a long one two digits, 1.5e+11."""
    return f"{count:,}" if count < 10**9 else f"{Decimal(count):.1e}".replace(".0e", "e")


def in_bytes(size: int) -> str:
    """Say a number of bytes with about two digits: 8.9 TB."""
    for power, unit in enumerate(("bytes", "kB", "MB", "GB", "TB", "PB", "EB")):
        if size < 1000 ** (power + 1):
            number = size / 1000**power
            return f"{number:.1f} {unit}" if number < 10 and power else f"{number:.0f} {unit}"
    return f"{in_short(size)} bytes"
