"""Thread pools that are reused by batches; starting one takes as long as thousands of shots."""

from __future__ import annotations

import os
import threading
from collections.abc import Callable
from concurrent.futures import Executor, Future, ThreadPoolExecutor
from typing import Any, TypeVar

Result = TypeVar("Result")


class SerialExecutor(Executor):
    """An executor that computes at once, in the thread that submits."""

    def submit(self, fn: Callable[..., Result], /, *args: Any, **kwargs: Any) -> Future[Result]:
        """Return a future that is done."""
        future: Future[Result] = Future()
        try:
            future.set_result(fn(*args, **kwargs))
        except Exception as error:
            future.set_exception(error)
        return future


def executor(threads: int) -> Executor:
    """Return an executor with so many threads, or without any where none can be started.

    In a browser, for example, Python has no threads.
    """
    trial = threading.Thread(target=lambda: None)
    try:
        trial.start()
    except RuntimeError:  # "can't start new thread"
        return SerialExecutor()
    trial.join()
    return ThreadPoolExecutor(threads, thread_name_prefix="hoopgen")


_IDLE: dict[int, list[Executor]] = {}
"""Pools that no batch uses, by their number of threads; appending and popping are atomic."""

MAX_IDLE_POOLS = 2
"""Largest number of idle pools of one size. Batches that run at the same time use one each."""


def acquire_pool(threads: int) -> Executor:
    """Return an unused pool of so many threads, as `executor` gives it."""
    try:
        return _IDLE.setdefault(threads, []).pop()
    except IndexError:
        return executor(threads)


def return_pool(pool: Executor, threads: int) -> None:
    """Return an idle pool for the next batch.

    Parameters
    ----------
    pool
        The pool, whose work is done.
    threads
        The number of its threads.
    """
    idle = _IDLE.setdefault(threads, [])
    if len(idle) < MAX_IDLE_POOLS:
        idle.append(pool)
    else:
        pool.shutdown(wait=False)


if hasattr(os, "register_at_fork"):
    # A child process has none of its parent's threads.
    os.register_at_fork(after_in_child=_IDLE.clear)
