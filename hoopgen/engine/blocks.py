"""Memory of large results, used again: the system clears new pages, which costs as much as a swish.

Each array has a block of its own, so that one that is kept keeps no other.
"""

from __future__ import annotations

import ctypes
import math
import os
import threading
import weakref
from typing import Any

import numpy as np
from numpy.typing import NDArray

LEAST = 1 << 18
"""Bytes of the smallest block; what is smaller is given out again by the allocator itself."""

STEP = 1 << 16
"""Blocks are a multiple of it: arrays of nearly one size take each other's."""

KEPT = 1 << 27
"""Most bytes that are kept while nobody uses them."""

_FREE: dict[int, list[NDArray[np.uint8]]] = {}
"""Blocks that no array uses, by size."""

_LOCK = threading.RLock()
"""Of those; a collection of garbage may leave a block while its thread takes one."""


def empty(shape: tuple[int, ...], dtype: np.dtype[Any]) -> NDArray[Any]:
    """Return an array that is not initialised, as `numpy.empty` does."""
    wanted = math.prod(shape) * dtype.itemsize
    if wanted < LEAST:
        return np.empty(shape, dtype)
    size = -(-wanted // STEP) * STEP
    with _LOCK:
        free = _FREE.get(size)
        block = free.pop() if free else None
    if block is None:
        block = np.empty(size, np.uint8)
    # Of arrays on arrays NumPy keeps the lowest alone: what lies between may be no array.
    lent: Any = (ctypes.c_char * size).from_buffer(block)  # type: ignore[arg-type]
    weakref.finalize(lent, _leave, block).atexit = False
    return np.ndarray(shape, dtype, lent)


def _leave(block: NDArray[np.uint8]) -> None:
    """Keep a block for the next array of its size, in place of some of other sizes."""
    if len(block) > KEPT:
        return
    with _LOCK:
        _FREE.setdefault(len(block), []).append(block)
        over = sum(size * len(free) for size, free in _FREE.items()) - KEPT
        # Those of other sizes go first.
        for size in sorted(_FREE, key=len(block).__eq__):
            while over > 0 and _FREE[size]:
                over -= len(_FREE[size].pop())
            if not _FREE[size]:
                del _FREE[size]


def _anew() -> None:
    global _LOCK
    _LOCK = threading.RLock()
    _FREE.clear()


if hasattr(os, "register_at_fork"):
    # A child process that writes into its parent's blocks would have them copied, page by page.
    # The lock may be another thread's, which the child has not.
    os.register_at_fork(after_in_child=_anew)
