"""Long work in chunks: computed by threads or by a Dask cluster, kept on disk, gone on with later.

A chunk depends on its number alone, so it does not matter who computes it, when, or how often.
Those finished lie in a folder, each with a keyed digest; one that is damaged is computed anew, and
an incomplete one, from a request for fewer shots, is continued.
"""

from __future__ import annotations

import contextlib
import itertools
import os
import sys
from abc import ABC, abstractmethod
from collections import deque
from collections.abc import Callable, Generator, Iterator, Mapping
from concurrent.futures import Future, wait
from contextvars import ContextVar
from dataclasses import dataclass
from functools import partial
from typing import Any, Protocol, TypeAlias, runtime_checkable

import pyarrow as pa

from hoopgen.engine.thread_pools import SerialExecutor, executor
from hoopgen.text.escape import printable

from .chunk_store import KEPT, ChunkStore, opened
from .executors import Task, Workers, check_workers, make_workers

_PREPARING: ContextVar[bool] = ContextVar("questions are prepared alone", default=False)


class _PreparedError(Exception):
    """The checks of a question are done, and no work is wanted."""


@contextlib.contextmanager
def preparing() -> Iterator[None]:
    """Make all checks of a question, and end it where its work would begin.

    A question calls `run`, or `task_runner`, once all that may be wrong with its arguments has been
    said. As long as this context lasts, that ends the question and the context, without an error.
    """
    token = _PREPARING.set(True)
    try:
        yield
    except _PreparedError:
        pass
    finally:
        _PREPARING.reset(token)


def begin_work() -> None:
    """Mark where the work of a question begins; see `preparing`."""
    if _PREPARING.get():
        raise _PreparedError


AHEAD = 2
"""Chunks under way or waiting for their turn, for each that is computed at once."""


class Job(Protocol):
    """Work in chunks, any of which can be computed at any time."""

    @property
    def chunks(self) -> int | None:
        """The number of chunks; None for as many as are asked for."""
        ...

    def compute(self, chunk: int) -> pa.Table:
        """Return a chunk, computed by one thread in well under a second."""
        ...

    def identity(self) -> Mapping[str, Any]:
        """Return all that the chunks depend on, in types that JSON knows."""
        ...


Rest: TypeAlias = tuple[Task, bool]
"""The task that turns a stored chunk into the one that is asked for, and whether that is more than
what is kept, and takes its place."""


class ShotsJob(ABC):
    """A job that may be asked for more shots later.

    Their number is not in its identity, and only cuts the last chunks.
    """

    @abstractmethod
    def shots_of(self, chunk: int) -> tuple[int, int]:
        """Return the first shot of a chunk, and the one after its last."""

    @abstractmethod
    def shots_in(self, kept: pa.Table) -> int:
        """Return the number of shots of a stored chunk."""

    @abstractmethod
    def counted(
        self, chunk: int, start: int, stop: int, before: pa.Table | None = None
    ) -> pa.Table:
        """Return the numbers of some shots of a chunk, and of those before them.

        Parameters
        ----------
        chunk
            The number of the chunk.
        start, stop
            The number of the first shot, and of the one after the last.
        before
            What is stored of the earlier shots of this chunk; None: nothing.

        Returns
        -------
        Table
            The numbers of all these shots.
        """

    def compute(self, chunk: int) -> pa.Table:
        """Return the numbers of a chunk."""
        return self.counted(chunk, *self.shots_of(chunk))

    def rest(self, chunk: int, kept: pa.Table) -> Rest | None:
        """Return the task for a stored chunk; None if it is the requested one.

        Parameters
        ----------
        chunk
            The number of the chunk.
        kept
            The chunk as it is stored, with fewer or more shots.
        """
        start, stop = self.shots_of(chunk)
        there = start + self.shots_in(kept)
        if there == stop:
            return None
        if there > stop:
            return partial(self.counted, chunk, start, stop), False
        return partial(self.counted, chunk, there, stop, kept), True


@runtime_checkable
class Stream(Protocol):
    """Work in chunks on something that is read in order, by the process that runs it."""

    @property
    def chunks(self) -> int | None:
        """The expected number of chunks, for the progress; None if that is not known."""
        ...

    def tasks(self) -> Iterator[Task | None]:
        """Read, and give what computes each chunk; also of those that are on disk already.

        None is no chunk: what comes next is asked for when all chunks before have been given.
        """
        ...

    def identity(self) -> Mapping[str, Any]:
        """Return all that the chunks depend on, in types that JSON knows."""
        ...


Progress: TypeAlias = Callable[[int, int | None], None]
"""A function of the chunks that are done and of their number, None as long as that is not known."""


def run(
    job: Job | Stream,
    folder: str | os.PathLike[str] | ChunkStore | None = None,
    *,
    scheduler: str | None = None,
    threads: int | None = None,
    progress: Progress | None = None,
    report: Callable[[str], None] | None = None,
) -> Generator[pa.Table, None, None]:
    """Give the chunks of a job, in order and lazily; a few are computed ahead.

    The tables are the same whoever computes them. Closing the generator, or Ctrl-C, ends the
    work; what is finished by then stays in the folder.

    Parameters
    ----------
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
    note = progress or (lambda done, total: None)
    report = report or (lambda line: print(f"hoopgen: {printable(line)}", file=sys.stderr))
    check_workers(scheduler, threads)  # before a folder is made
    begin_work()
    with contextlib.ExitStack() as stack:
        if folder is None or isinstance(folder, ChunkStore):
            kept = folder
        else:
            kept = stack.enter_context(opened(folder, job.identity()))
        workers = stack.enter_context(make_workers(scheduler, threads, report))
        total, done = job.chunks, 0
        note(done, total)
        for table, damage in _in_order(_parts(job), kept, workers):
            if damage:
                report(damage)
            yield table
            done += 1
            note(done, total)


@dataclass(frozen=True)
class _Part:
    """A chunk: its number, what computes it, and what goes on with one that is kept."""

    chunk: int
    task: Task
    rest: Callable[[int, pa.Table], Rest | None]


def _parts(job: Job | Stream) -> Iterator[_Part | None]:
    """Give all chunks of a job; None where a stream does."""
    numbers = itertools.count()
    if isinstance(job, Stream):
        for task in job.tasks():
            yield None if task is None else _Part(next(numbers), task, _nothing)
        return
    rest = job.rest if isinstance(job, ShotsJob) else _nothing
    for chunk in numbers if job.chunks is None else range(job.chunks):
        yield _Part(chunk, partial(job.compute, chunk), rest)


def _nothing(chunk: int, kept: pa.Table) -> None:
    """A chunk that is kept is the one asked for."""


def _in_order(
    parts: Iterator[_Part | None], folder: ChunkStore | None, workers: Workers
) -> Iterator[tuple[pa.Table, str | None]]:
    """Give chunks, and what was wrong with those on disk, in the order of their numbers."""
    pending: deque[Future[tuple[pa.Table, str | None]]] = deque()
    ahead = AHEAD * workers.number
    pool = executor(ahead if workers.remote else workers.number)
    if isinstance(pool, SerialExecutor):
        ahead = 1
    try:
        for part in itertools.chain(parts, [None]):
            if part is not None:
                pending.append(pool.submit(_fetch, folder, workers, part))
            while pending and (part is None or len(pending) >= ahead):
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


def _fetch(folder: ChunkStore | None, workers: Workers, part: _Part) -> tuple[pa.Table, str | None]:
    """Return a chunk from disk, or computed and now on disk, and the damage to its file, if any."""
    if folder is None:
        return workers.compute(part.task), None
    task, more, damage = part.task, True, None
    try:
        kept = folder.read(part.chunk)
    except FileNotFoundError:
        pass
    except FileExistsError:
        raise  # as no chunk of ours, however damaged
    except (OSError, ValueError) as error:
        damage = f"{folder.file(part.chunk)} is damaged ({error}); it is computed anew"
    else:
        rest = part.rest(part.chunk, kept)
        if rest is None:
            return kept, None
        task, more = rest
    try:
        table = workers.compute(task)
    except ConnectionError as error:
        raise ConnectionError(f"{error}; {KEPT}") from error
    if more:
        folder.write(part.chunk, table)
    return table, damage
