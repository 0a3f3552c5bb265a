"""Long work in chunks: computed by threads or by a Dask cluster, kept on disk, gone on with later.

A chunk depends on its number alone, so it does not matter who computes it, when, or how often.
Those finished lie in a folder, each with a keyed digest; one that is damaged is computed anew.
"""

from __future__ import annotations

import contextlib
import itertools
import os
import sys
from collections import deque
from collections.abc import Callable, Generator, Iterator, Mapping
from concurrent.futures import Future, ThreadPoolExecutor, wait
from functools import partial
from typing import Any, Protocol, runtime_checkable

import pyarrow as pa

from hoopgen.printable import printable

from .folders import KEPT, Folder, opened, written
from .workers import Task, Workers, check_workers, hired, versions

__all__ = [
    "Folder",
    "Job",
    "Stream",
    "Task",
    "check_workers",
    "opened",
    "run",
    "versions",
    "written",
]

AHEAD = 2
"""Chunks under way or waiting for their turn, for each that is computed at once."""


class Job(Protocol):
    """Work in chunks, any of which can be computed at any time."""

    @property
    def chunks(self) -> int | None:
        """How many; None for as many as are asked for."""
        ...

    def compute(self, chunk: int) -> pa.Table:
        """Return a chunk, computed by one thread in well under a second."""
        ...

    def identity(self) -> Mapping[str, Any]:
        """Return all that the chunks depend on, in types that JSON knows."""
        ...


@runtime_checkable
class Stream(Protocol):
    """Work in chunks on something that is read in order, by the process that runs it."""

    @property
    def chunks(self) -> int | None:
        """How many are expected, for the progress; None if that is not known."""
        ...

    def tasks(self) -> Iterator[Task | None]:
        """Read, and give what computes each chunk; also of those that are on disk already.

        None is no chunk: what comes next is asked for when all chunks before have been given.
        """
        ...

    def identity(self) -> Mapping[str, Any]:
        """Return all that the chunks depend on, in types that JSON knows."""
        ...


def run(
    job: Job | Stream,
    folder: str | os.PathLike[str] | Folder | None = None,
    *,
    scheduler: str | None = None,
    threads: int | None = None,
    progress: Callable[[int, int | None], None] | None = None,
    report: Callable[[str], None] | None = None,
) -> Generator[pa.Table, None, None]:
    """Give the chunks of a job, in order and lazily; a few are computed ahead.

    The tables are the same whoever computes them. Closing the generator, or Ctrl-C, ends the
    work; what is finished by then stays in the folder.

    Parameters
    ----------
    job
        The work.
    folder
        Where finished chunks are kept and looked for; made if it is not there. None keeps none.
    scheduler
        Address of a Dask scheduler whose workers compute, such as "tcp://10.0.0.1:8786"; they need
        the same `versions`. A worker that is lost costs the time of its chunks.
    threads
        Chunks that are computed at once on this machine; None for as many as the process may use.
    progress
        Called with the number of chunks given and their total (None: not known).
    report
        Called with a line of text when a chunk was damaged, and when it is waited for workers of
        the scheduler; by default it goes to stderr.

    Yields
    ------
    pyarrow.Table
        The chunks, from 0.

    Raises
    ------
    ValueError
        If the folder holds another job; the message says what differs. If threads, or the form of
        the address, are not as described.
    RuntimeError
        If another process is at work in the folder, or the cluster cannot do the work.
    ConnectionError
        If no scheduler answers, or it is gone. Chunks that are finished are kept.
    OSError
        If the folder cannot be made or a chunk not be written. Those before it are kept.
    """
    note, report = progress or _ignore, report or _say
    check_workers(scheduler, threads)  # before a folder is made
    with contextlib.ExitStack() as stack:
        if folder is None or isinstance(folder, Folder):
            kept = folder
        else:
            kept = stack.enter_context(opened(folder, job.identity()))
        workers = stack.enter_context(hired(scheduler, threads, report))
        total, done = job.chunks, 0
        note(done, total)
        for table, damage in _in_order(_tasks(job), kept, workers):
            if damage:
                report(damage)
            yield table
            done += 1
            note(done, total)


def _ignore(done: int, total: int | None) -> None:
    pass


def _say(line: str) -> None:
    print(f"hoopgen: {printable(line)}", file=sys.stderr)


def _tasks(job: Job | Stream) -> Iterator[Task | None]:
    if isinstance(job, Stream):
        return job.tasks()
    numbers = itertools.count() if job.chunks is None else iter(range(job.chunks))
    return (partial(job.compute, chunk) for chunk in numbers)


def _in_order(
    tasks: Iterator[Task | None], folder: Folder | None, workers: Workers
) -> Iterator[tuple[pa.Table, str | None]]:
    """Give chunks, and what was wrong with those on disk, in the order of their tasks."""
    pending: deque[Future[tuple[pa.Table, str | None]]] = deque()
    ahead = AHEAD * workers.number
    pool = ThreadPoolExecutor(ahead if workers.remote else workers.number)
    try:
        numbers = itertools.count()
        for task in itertools.chain(tasks, [None]):
            if task is not None:
                pending.append(pool.submit(_fetch, folder, workers, next(numbers), task))
            while pending and (task is None or len(pending) >= ahead):
                yield _awaited(pending.popleft(), workers)
    finally:
        pool.shutdown(wait=False, cancel_futures=True)
        workers.stop()
        pool.shutdown()


def _awaited(
    chunk: Future[tuple[pa.Table, str | None]], workers: Workers
) -> tuple[pa.Table, str | None]:
    while not wait([chunk], workers.patience).done:
        workers.look()
    return chunk.result()


def _fetch(
    folder: Folder | None, workers: Workers, chunk: int, task: Task
) -> tuple[pa.Table, str | None]:
    """Return a chunk from disk, or computed and now on disk; and what was wrong with the file."""
    if folder is None:
        return workers.compute(task), None
    damage = None
    try:
        return folder.read(chunk), None
    except FileNotFoundError:
        pass
    except FileExistsError:
        raise  # as no chunk of ours, however damaged
    except (OSError, ValueError) as error:
        damage = f"{folder.file(chunk)} is damaged ({error}); it is computed anew"
    try:
        table = workers.compute(task)
    except ConnectionError as error:
        raise ConnectionError(f"{error}; {KEPT}") from error
    folder.write(chunk, table)
    return table, damage
