"""What callers give: checked, and as the engines take it."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .engine.raw import STATE_SIZE
from .results import SURFACES

__all__ = [
    "check_angles",
    "check_contacts",
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


def check_angles(name: str, angles: Mapping[str, ArrayLike]) -> None:
    """Refuse angles that are degrees, by their median: all are radians, and within a turn.

    Raises
    ------
    ValueError
        The message begins with `name`.
    """
    for angle, value in angles.items():
        sizes = np.abs(np.asarray(value, dtype=np.float64))
        if not np.any(sizes > 2 * np.pi):
            continue
        sizes = sizes[np.isfinite(sizes)]
        if sizes.size and np.median(sizes) > 2 * np.pi:
            raise ValueError(
                f"{name}: {angle} is in radians, and these are more than a turn: "
                f"{np.median(sizes):.6g}. Degrees would be np.radians(...), or in a table a column "
                f"{angle}_deg"
            )


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
    if not isinstance(max_contacts, int | np.integer) or not 1 <= max_contacts < 2**31:
        raise ValueError(f"max_contacts: expected a whole number from 1, got {max_contacts!r}")
    return int(max_contacts)


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
    if not isinstance(threads, int | np.integer) or threads < 1:
        raise ValueError(f"threads: expected a whole number from 1, or None, got {threads!r}")
    return int(threads)
