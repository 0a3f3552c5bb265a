"""Threads that stay from batch to batch: to start them takes as long as thousands of shots."""

from __future__ import annotations

import os
from concurrent.futures import ThreadPoolExecutor

_IDLE: dict[int, list[ThreadPoolExecutor]] = {}
"""By how many threads they have, the pools that no batch uses; appending and popping are atomic."""

KEPT = 2
"""Most idle pools of one size: batches that run beside each other have one each."""


def take(threads: int) -> ThreadPoolExecutor:
    """Return a pool of so many threads that nobody else uses."""
    try:
        return _IDLE.setdefault(threads, []).pop()
    except IndexError:
        return ThreadPoolExecutor(threads, thread_name_prefix="hoopgen")


def leave(pool: ThreadPoolExecutor, threads: int) -> None:
    """Keep a pool, whose work is done, for the next batch."""
    idle = _IDLE.setdefault(threads, [])
    if len(idle) < KEPT:
        idle.append(pool)
    else:
        pool.shutdown(wait=False)


if hasattr(os, "register_at_fork"):
    # A child process has none of its parent's threads.
    os.register_at_fork(after_in_child=_IDLE.clear)
