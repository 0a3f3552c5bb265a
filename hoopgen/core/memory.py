"""Checks that a question fits the memory, before any is allocated.

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

from hoopgen.text.numbers import format_percent

MAX_MEMORY_SHARE = 0.75
"""Largest share of the memory that one allocation may take; the rest is for everything else."""

BYTES_PER_VALUE = 100
"""Bytes that a value of a variable takes, in an array, in a list and in text."""

DEFAULT_MEMORY = 1 << 36
"""Bytes of memory, where the system does not say."""

CONTAINER_LIMIT = Path("/sys/fs/cgroup/memory.max")
"""File of the memory limit of a container, on Linux; it contains "max" if there is none."""


@cache
def memory(limit: Path = CONTAINER_LIMIT) -> int:
    """Return the bytes of memory of this machine or container.

    Parameters
    ----------
    limit
        The file that says what a container may use.
    """
    try:
        there = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    except (AttributeError, OSError, ValueError):  # not on Windows
        there = 0
    try:
        allowed = int(limit.read_text(encoding="ascii"))
    except (OSError, ValueError):
        allowed = 0
    return min((size for size in (there, allowed) if size > 0), default=DEFAULT_MEMORY)


def check_room(name: str, count: int, what: str, each: int) -> None:
    """Raise an error if a question would take more than its share of the memory.

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
    if count * each > MAX_MEMORY_SHARE * memory():
        raise ValueError(
            f"{name}: {format_whole(count)} {what} would take {format_bytes(count * each)} of "
            "memory; of "
            f"the {format_bytes(memory())} there are, at most "
            f"{format_percent(MAX_MEMORY_SHARE, 0)} are asked for. "
            "Give fewer"
        )


def even_values(name: str, first: float, last: float, count: int) -> NDArray[np.float64]:
    """Return evenly spaced values from the first to the last, (count,).

    Parameters
    ----------
    name
        The argument, for the error message.
    first, last
        The first and the last value.
    count
        How many values.

    Raises
    ------
    ValueError
        If there are too many, or no number is as far from the first as the last; it begins with
        `name`.
    """
    check_room(name, count, "values", BYTES_PER_VALUE)
    if not np.isfinite(last - first):
        raise ValueError(f"{name}: from {first:g} to {last:g} is further than numbers go")
    return np.linspace(first, last, count)


def format_whole(count: int) -> str:
    """Format a whole number in full, or a long one with two digits, 1.5e+11."""
    return f"{count:,}" if count < 10**9 else f"{Decimal(count):.1e}".replace(".0e", "e")


def format_bytes(size: int) -> str:
    """Format a number of bytes with about two digits: 8.9 TB."""
    for power, unit in enumerate(("bytes", "kB", "MB", "GB", "TB", "PB", "EB")):
        if size < 1000 ** (power + 1):
            number = size / 1000**power
            return f"{number:.1f} {unit}" if number < 10 and power else f"{number:.0f} {unit}"
    return f"{format_whole(size)} bytes"
