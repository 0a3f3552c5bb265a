"""What callers give: checked, and as the engines take it."""

from __future__ import annotations

import os
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .engine.raw import STATE_SIZE
from .results import SURFACES

__all__ = [
    "check_contacts",
    "check_count",
    "check_leaving",
    "check_states",
    "check_threads",
    "doubles",
]


def doubles(name: str, value: ArrayLike, expected: str = "numbers") -> NDArray[np.float64]:
    """Return `value` as float64.

    Raises
    ------
    TypeError
        If it is not real numbers; the message begins with `name`.
    """
    try:
        array = np.asarray(value)
        if array.dtype == object:  # float() is stricter: NumPy makes a NaN of None
            array = np.array([float(v) for v in array.flat]).reshape(array.shape)
        if not np.iscomplexobj(array):
            return array.astype(np.float64, copy=False)
    except (TypeError, ValueError):
        pass
    raise TypeError(f"{name}: expected {expected}, got {value!r}")


def check_states(states: ArrayLike) -> NDArray[np.float64]:
    """Return releases as float64 (n, 9), each row together in memory.

    Raises
    ------
    TypeError, ValueError
        If they are not numbers of shape (n, 9) or (9,).
    """
    array = doubles("states", states, "numbers of shape (n, 9) or (9,)")
    if array.ndim == 1:
        array = array[None]
    if array.ndim != 2 or array.shape[1] != STATE_SIZE:
        raise ValueError(
            f"states: expected shape (n, 9) or (9,), got {np.shape(states)}; "
            "a row is x y z vx vy vz wx wy wz"
        )
    return np.ascontiguousarray(array)


def check_leaving(leaving: ArrayLike | None, shots: int) -> NDArray[np.int8] | None:
    """Return the surface that each shot leaves at the start, (shots,); None if none is given.

    Raises
    ------
    ValueError
        If they are not indices into `SURFACES` or -1, one or so many.
    """
    if leaving is None:
        return None
    array = np.asarray(leaving)
    whole = np.issubdtype(array.dtype, np.integer)
    if not whole or array.shape not in ((), (shots,)):
        raise ValueError(f"leaving: expected whole numbers, one or {shots}, got {leaving!r}")
    if np.any((array < -1) | (array >= len(SURFACES))):
        raise ValueError(f"leaving: expected -1 to {len(SURFACES) - 1}, got {leaving!r}")
    return np.ascontiguousarray(np.broadcast_to(array, shots), dtype=np.int8)


def check_contacts(max_contacts: Any) -> int:
    """Return the contacts with which a shot ends as capped.

    Raises
    ------
    ValueError
        If it is no whole number from 1, or more than the engines count.
    """
    return check_count("max_contacts", max_contacts, most=2**31 - 1)


def check_count(
    name: str, value: Any, *, least: int = 1, most: int = 2**63 - 1, expected: str = ""
) -> int:
    """Return a whole number from `least` to `most`; neither a truth value nor a time is one.

    Raises
    ------
    ValueError
        If it is none; the message begins with `name` and says what is expected, by default the
        ends.
    """
    whole = isinstance(value, int | np.integer) and not isinstance(value, bool | np.timedelta64)
    if not whole or not least <= value <= most:
        said = expected or f"a whole number from {least}"
        # An end that nobody comes near is told only to those who pass it.
        beyond = f"; at most {most}" if whole and value > most else ""
        raise ValueError(f"{name}: expected {said}, got {value!r}{beyond}")
    return int(value)


def check_threads(threads: Any) -> int:
    """Return how many threads work; of None, as many as the process may use.

    Raises
    ------
    ValueError
        If it is neither None nor a whole number from 1.
    """
    if threads is None:
        own = getattr(os, "sched_getaffinity", None)
        return len(own(0)) if own else os.cpu_count() or 1
    return check_count("threads", threads, expected="a whole number from 1, or None")
