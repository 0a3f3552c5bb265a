"""Long work in chunks: computed by threads or by a Dask cluster, kept on disk, gone on with later.

A chunk depends on its number alone, so it does not matter who computes it, when, or how often.
Those finished lie in a folder, each with a keyed digest; one that is damaged is computed anew.
"""

from __future__ import annotations

import contextlib
import hashlib
import itertools
import json
import os
import sys
from collections import deque
from collections.abc import Callable, Generator, Iterator, Mapping, Sequence
from concurrent.futures import Future, ThreadPoolExecutor, wait
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import IO, Any, Protocol, runtime_checkable

import pyarrow as pa

from hoopgen import outputs
from hoopgen.printable import printable

from .lock import LOCK, held, read_file
from .workers import Task, Workers, check_workers, hired, versions

__all__ = [
    "Folder",
    "Job",
    "Stream",
    "Task",
    "check_workers",
    "differences",
    "flat",
    "in_short",
    "opened",
    "read_record",
    "run",
    "versions",
    "written",
]

AHEAD = 2
"""Chunks under way or waiting for their turn, for each that is computed at once."""

_DIGEST = 32  # bytes
_TEMPORARY = ".tmp"
_CHUNKS = "chunk-*.arrow"


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
        raise ConnectionError(f"{error}; {_KEPT}") from error
    folder.write(chunk, table)
    return table, damage


# ------------------------------------------------------------------------------------ on disk


@dataclass(frozen=True)
class Folder:
    """The finished chunks of one job on disk.

    A file is an Arrow IPC stream, and after its end a digest, keyed by the job and by the chunk:
    a file that is damaged, of another job or of another chunk does not pass.
    """

    path: Path
    key: bytes

    def file(self, chunk: int) -> Path:
        """Return where the chunk lies, or will."""
        return self.path / f"chunk-{chunk:09d}.arrow"

    def read(self, chunk: int) -> pa.Table:
        """Return a chunk.

        Raises
        ------
        FileNotFoundError
            If it is not there.
        FileExistsError
            If what is there is no file.
        OSError, ValueError
            If it is damaged.
        """
        content = memoryview(read_file(self.file(chunk)))
        stream, digest = content[:-_DIGEST], content[-_DIGEST:]
        if self._digest(chunk, stream) != digest:
            raise ValueError("its checksum is wrong")
        return pa.ipc.open_stream(pa.py_buffer(stream)).read_all()

    def write(self, chunk: int, table: pa.Table) -> None:
        """Keep a chunk; it is there wholly or not at all, whatever happens.

        Raises
        ------
        OSError
            If that fails.
        """
        sink = pa.BufferOutputStream()
        with pa.ipc.new_stream(sink, table.schema) as writer:
            writer.write_table(table)
        stream = memoryview(sink.getvalue())
        with written(self.file(chunk)) as file:
            file.write(stream)
            file.write(self._digest(chunk, stream))

    def remove(self) -> None:
        """Remove the chunks; and the folder, as soon as it is closed.

        What others put into it stays, and the folder with it.
        """
        for file in (*self.path.glob(_CHUNKS), self.path / _IDENTITY):
            file.unlink(missing_ok=True)

    def _digest(self, chunk: int, stream: memoryview) -> bytes:
        return hashlib.blake2b(
            stream, digest_size=_DIGEST, key=self.key, salt=chunk.to_bytes(16, "little")
        ).digest()

    def holds_chunks(self) -> bool:
        """Tell whether there is a chunk."""
        return any(self.path.glob(_CHUNKS))


_IDENTITY = "identity.json"

_KEPT = "finished chunks are kept, and the same call goes on from there"


@contextlib.contextmanager
def opened(path: str | os.PathLike[str], identity: Mapping[str, Any]) -> Iterator[Folder]:
    """Open the folder of a job, for one process at a time; make it if it is not there.

    One that has no chunks at the end goes again, unless there is something else in it.

    Parameters
    ----------
    path
        The folder.
    identity
        All that the job's chunks depend on, in types that JSON knows; `versions` are added.

    Raises
    ------
    ValueError
        If the folder has no name, or holds another job; the message says what differs.
    RuntimeError
        If another process is at work in it.
    OSError
        If it cannot be made or written, or has something else in the place of a file.
    """
    if not os.fspath(path):
        raise ValueError("folder: expected a name, got ''")
    folder = Path(path)
    here = flat({**versions(), **identity})
    with held(folder, _IDENTITY):
        for stale in folder.glob(f"*{_TEMPORARY}"):
            stale.unlink()
        _identify(folder, here)
        text = json.dumps(here, sort_keys=True).encode()
        kept = Folder(folder, hashlib.blake2b(text, digest_size=_DIGEST).digest())
        try:
            yield kept
        except KeyboardInterrupt as error:
            if {entry.name for entry in folder.iterdir()} - {_IDENTITY, LOCK}:
                error.add_note(f"finished chunks are in {folder}: the same call goes on from there")
            raise
        finally:
            if not kept.holds_chunks():
                kept.remove()


def _identify(folder: Path, here: dict[str, str]) -> None:
    """Write what the job is; or compare it with what is written, if there are chunks."""
    file = folder / _IDENTITY
    if not any(folder.glob(_CHUNKS)):
        with written(file) as out:
            out.write(json.dumps(here, indent=1).encode())
        return
    try:
        there = read_record(file)
        if not all(isinstance(value, str) for value in there.values()):
            raise ValueError(f"{file}: expected text by name, as `flat` gives it")
    except (FileNotFoundError, ValueError):
        raise ValueError(f"{file} cannot be read; delete the folder to begin anew") from None
    if found := differences(there, here):
        raise ValueError(
            f"{folder} holds another job: {in_short(found)}. Give the same job, "
            "or another folder; or delete this one to begin anew"
        )


def read_record(file: Path) -> dict[str, Any]:
    """Return what a file of JSON says, names and values.

    Raises
    ------
    OSError
        If it cannot be read.
    ValueError
        If it is not JSON, or says something else.
    """
    try:
        record = json.loads(read_file(file).decode())
    except RecursionError:
        raise ValueError(f"{file}: nested too deep") from None
    if not isinstance(record, dict):
        raise ValueError(f"{file}: expected names and values")
    return record


def differences(there: Mapping[str, str], here: Mapping[str, str]) -> list[str]:
    """Say what is not the same in two identities as of `flat`."""
    return [
        f"{name} is {_short(there.get(name))} there and {_short(here.get(name))} here"
        for name in dict.fromkeys((*here, *there))
        if there.get(name) != here.get(name)
    ]


def in_short(found: Sequence[str]) -> str:
    """Say the first few of what is not the same, and how many more there are."""
    more = [f"and {len(found) - _FEW} more"] if len(found) > _FEW else []
    return "; ".join([*found[:_FEW], *more])


_FEW = 3
"""Differences that are told."""


def flat(values: Mapping[str, Any], prefix: str = "") -> dict[str, str]:
    """Return the leaves of nested mappings as JSON, by dotted names."""
    leaves: dict[str, str] = {}
    for name, value in values.items():
        if isinstance(value, Mapping):
            leaves |= flat(value, f"{prefix}{name}.")
        else:
            leaves[f"{prefix}{name}"] = json.dumps(value)
    return leaves


def _short(text: str | None) -> str:
    if text is None:
        return "missing"
    return text if len(text) <= 60 else f"{text[:57]}..."


@contextlib.contextmanager
def written(path: Path, temporary: Path | None = None) -> Iterator[IO[bytes]]:
    """Write a file of long work as `outputs.written` does; an error says what is not lost.

    Until it is whole it lies beside under a name that the next start removes, if this one is
    killed, or under that of `temporary`.
    """
    try:
        with outputs.written(path, temporary or path.with_name(path.name + _TEMPORARY)) as file:
            yield file
    except OSError as error:
        if error.filename != str(path):
            raise  # of something else
        raise OSError(error.errno, f"{error.strerror}; {_KEPT}", str(path)) from error
