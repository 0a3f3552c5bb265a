"""Memory of large results, used again: the system clears new pages, which costs as much as a swish.

Each array has a block of its own, so that one that is kept keeps no other.
"""

from __future__ import annotations

import ctypes
import math
import os
import threading
import weakref
from collections import deque
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
"""Blocks that no array uses, by size; only who holds `_LOCK` reads or changes it."""

_LEFT: deque[NDArray[np.uint8]] = deque()
"""Blocks that arrays have left and nobody has sorted into `_FREE` yet."""

_LOCK = threading.Lock()
"""Of `_FREE`. Nobody waits for it: Python may collect garbage, and so leave a block, in the midst
of anything that this thread does, also while it holds the lock."""


def empty(shape: tuple[int, ...], dtype: np.dtype[Any]) -> NDArray[Any]:
    """Return an array that is not initialised, as `numpy.empty` does."""
    wanted = math.prod(shape) * dtype.itemsize
    if wanted < LEAST:
        return np.empty(shape, dtype)
    size = -(-wanted // STEP) * STEP
    block = _take(size)
    if block is None:
        block = np.empty(size, np.uint8)
    # Of arrays on arrays NumPy keeps the lowest alone: what lies between may be no array.
    lent: Any = (ctypes.c_char * size).from_buffer(block)  # type: ignore[arg-type]
    weakref.finalize(lent, _leave, block).atexit = False
    return np.ndarray(shape, dtype, lent)


def _take(size: int) -> NDArray[np.uint8] | None:
    """Return a block of so many bytes that no array uses; None where there is none at hand."""
    if not _LOCK.acquire(blocking=False):
        return None
    try:
        free = _FREE.get(size)
        return free.pop() if free else None
    finally:
        _LOCK.release()
        _sort()


def _leave(block: NDArray[np.uint8]) -> None:
    """Keep a block for the next array of its size, in place of some of other sizes."""
    if len(block) <= KEPT:
        _LEFT.append(block)
        _sort()


def _sort() -> None:
    """Sort what was left into `_FREE`, unless somebody is at it, who looks again after that."""
    while _LEFT and _LOCK.acquire(blocking=False):
        try:
            while _LEFT:
                block = _LEFT.popleft()
                _FREE.setdefault(len(block), []).append(block)
                _drop(len(block))
        finally:
            _LOCK.release()


def _drop(last: int) -> None:
    """Drop blocks until no more than `KEPT` bytes are kept: those of the size `last` at the end."""
    over = sum(size * len(free) for size, free in _FREE.items()) - KEPT
    for size in sorted(_FREE, key=last.__eq__):
        while over > 0 and _FREE[size]:
            over -= len(_FREE[size].pop())
        if not _FREE[size]:
            del _FREE[size]


def _anew() -> None:
    global _LOCK
    _LOCK = threading.Lock()
    _LEFT.clear()
    _FREE.clear()


if hasattr(os, "register_at_fork"):
    # A child process that writes into its parent's blocks would have them copied, page by page.
    # The lock may be another thread's, which the child has not.
    os.register_at_fork(after_in_child=_anew)
