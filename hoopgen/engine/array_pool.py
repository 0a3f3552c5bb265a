"""A pool of the memory of large results, since clearing new pages costs as much as a swish.

Each array has a block of its own, so that no array keeps the memory of another.
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

MIN_BLOCK_SIZE = 1 << 18
"""Bytes of the smallest block; what is smaller is given out again by the allocator itself."""

BLOCK_SIZE_STEP = 1 << 16
"""Blocks are a multiple of it: arrays of nearly one size take each other's."""

MAX_IDLE_BYTES = 1 << 27
"""Most bytes that are kept while nobody uses them."""

LINE = 64
"""Bytes of a line of the caches. Each block begins with one, because C then writes rows of states
past the caches in whole lines."""

_FREE: dict[int, list[NDArray[np.uint8]]] = {}
"""Blocks that no array uses, by size; reading and changing it needs `_LOCK`."""

_RETURNED: deque[NDArray[np.uint8]] = deque()
"""Blocks that no array uses any more and that are not in `_FREE` yet."""

_LOCK = threading.Lock()
"""The lock of `_FREE`. No thread waits for it: the garbage collector may return a block at any
time, also while this thread holds the lock."""


def empty(shape: tuple[int, ...], dtype: np.dtype[Any]) -> NDArray[Any]:
    """Return an uninitialised array, as `numpy.empty` does.

    Parameters
    ----------
    shape
        The shape.
    dtype
        The type of the elements.
    """
    wanted = math.prod(shape) * dtype.itemsize
    if wanted < MIN_BLOCK_SIZE:
        return np.empty(shape, dtype)
    size = -(-wanted // BLOCK_SIZE_STEP) * BLOCK_SIZE_STEP
    block = _take(size)
    if block is None:
        room = np.empty(size + LINE, np.uint8)
        begin = -room.ctypes.data % LINE
        block = room[begin : begin + size]
    # Of arrays on arrays NumPy keeps the lowest alone: what lies between may be no array.
    lent: Any = (ctypes.c_char * size).from_buffer(block)  # type: ignore[arg-type]
    weakref.finalize(lent, _return, block).atexit = False
    return np.ndarray(shape, dtype, lent)


def _take(size: int) -> NDArray[np.uint8] | None:
    """Return an unused block of a size in bytes; None if there is none."""
    if not _LOCK.acquire(blocking=False):
        return None
    try:
        free = _FREE.get(size)
        return free.pop() if free else None
    finally:
        _LOCK.release()
        _sort()


def _return(block: NDArray[np.uint8]) -> None:
    """Return a block to the pool, in place of some of other sizes."""
    if len(block) <= MAX_IDLE_BYTES:
        _RETURNED.append(block)
        _sort()


def _sort() -> None:
    """Sort returned blocks into `_FREE`, unless another thread does so already."""
    while _RETURNED and _LOCK.acquire(blocking=False):
        try:
            while _RETURNED:
                block = _RETURNED.popleft()
                _FREE.setdefault(len(block), []).append(block)
                _drop(len(block))
        finally:
            _LOCK.release()


def _drop(last: int) -> None:
    """Drop blocks until at most `MAX_IDLE_BYTES` bytes are kept; those of size `last` go last."""
    over = sum(size * len(free) for size, free in _FREE.items()) - MAX_IDLE_BYTES
    for size in sorted(_FREE, key=last.__eq__):
        while over > 0 and _FREE[size]:
            over -= len(_FREE[size].pop())
        if not _FREE[size]:
            del _FREE[size]


def _reset_after_fork() -> None:
    global _LOCK
    _LOCK = threading.Lock()
    _RETURNED.clear()
    _FREE.clear()


if hasattr(os, "register_at_fork"):
    # A child process that writes into its parent's blocks would have them copied, page by page.
    # The lock may be another thread's, which the child has not.
    os.register_at_fork(after_in_child=_reset_after_fork)
