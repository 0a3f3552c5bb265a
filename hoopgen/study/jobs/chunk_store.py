"""Finished chunks on disk: each with a keyed digest, in a folder that says of which job.

One that is damaged, of another job or of another chunk does not pass. The folder is one that
hoopgen owns (`hoopgen.core.owned_folders`): other files in it stay as they are.
"""

from __future__ import annotations

import contextlib
import hashlib
import json
import os
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fnmatch import fnmatchcase
from pathlib import Path
from typing import IO, Any

import pyarrow as pa

from hoopgen.core import files
from hoopgen.core.lock import LOCK, read_file
from hoopgen.core.owned_folders import MARKER, Store, find_store, locked_store
from hoopgen.report.quantities import for_json

from .executors import versions

_DIGEST = 32  # bytes
_PURPOSE = "finished chunks"
_IDENTITY = "identity.json"
_CHUNKS = f"chunk-{'[0-9]' * 9}.arrow"
_SHOWN = "chunk-*.arrow"
"""The same in an error message."""

_FILES = (_CHUNKS, _IDENTITY)

KEPT = "finished chunks are kept, and the same call goes on from there"

_MAX_DIFFERENCES = 3
"""Number of differences that a message lists."""


@dataclass(frozen=True)
class ChunkStore:
    """The finished chunks of one job on disk.

    A file is an Arrow IPC stream, and after its end a digest, keyed by the job and by the chunk:
    a file that is damaged, of another job or of another chunk does not pass.
    """

    store: Store
    key: bytes

    @property
    def path(self) -> Path:
        """The folder."""
        return self.store.path

    def temporary(self) -> Path:
        """Return a path for incomplete results; the next start removes what is left there."""
        return self.store.temporary()

    def file(self, chunk: int) -> Path:
        """Return the path of a chunk."""
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

        Parameters
        ----------
        chunk
            The number of the chunk, from 0.
        table
            Its numbers, as the job computes them.

        Raises
        ------
        OSError
            If the file cannot be written, as on a full disk; then no part of it stays.
        """
        sink = pa.BufferOutputStream()
        with pa.ipc.new_stream(sink, table.schema) as writer:
            writer.write_table(table)
        stream = memoryview(sink.getvalue())
        with written(self.file(chunk), self.store.temporary()) as file:
            file.write(stream)
            file.write(self._digest(chunk, stream))

    def remove(self) -> None:
        """Remove the chunks; and the folder, as soon as it is closed.

        What others put into it stays, and the folder with it.
        """
        self.store.dissolve()

    def _digest(self, chunk: int, stream: memoryview) -> bytes:
        return hashlib.blake2b(
            stream, digest_size=_DIGEST, key=self.key, salt=chunk.to_bytes(16, "little")
        ).digest()

    def holds_chunks(self) -> bool:
        """Tell whether there is a chunk."""
        return any(self.path.glob(_CHUNKS))


@contextlib.contextmanager
def opened(path: str | os.PathLike[str], identity: Mapping[str, Any]) -> Iterator[ChunkStore]:
    """Open the folder of a job, for one process at a time; make it if it is not there.

    One that has no chunks at the end goes again, unless there is something else in it.

    Parameters
    ----------
    identity
        All that the job's chunks depend on, in types that JSON knows; `versions` are added.

    Raises
    ------
    ValueError
        If the folder has no name, is not hoopgen's, or holds another job: what differs.
    RuntimeError
        If another process is at work in it.
    OSError
        If it cannot be made or written, or has something else in the place of a file.
    """
    here = flat({**versions(), **identity})
    with locked_store(path, _PURPOSE, _FILES) as store:
        _identify(store, here)
        text = json.dumps(here, sort_keys=True).encode()
        kept = ChunkStore(store, hashlib.blake2b(text, digest_size=_DIGEST).digest())
        try:
            yield kept
        except KeyboardInterrupt as error:
            if {entry.name for entry in store.path.iterdir()} - {_IDENTITY, LOCK, MARKER}:
                note = f"finished chunks are in {store.path}: the same call goes on from there"
                error.add_note(note)
            raise
        finally:
            if not kept.holds_chunks():
                kept.remove()


def _identify(store: Store, here: dict[str, str]) -> None:
    """Write what the job is; or compare it with what is written, if there are chunks."""
    folder, file = store.path, store.path / _IDENTITY
    if not any(folder.glob(_CHUNKS)):
        with written(file, store.temporary()) as out:
            out.write(json.dumps(here, indent=1).encode())
        return
    try:
        there = read_record(file)
        if not all(isinstance(value, str) for value in there.values()):
            raise ValueError(f"{file}: expected text by name, as `flat` gives it")
    except (FileNotFoundError, ValueError):
        raise ValueError(
            f"{file} cannot be read, so it does not say of which job the chunks are; "
            f"give another folder, or remove {_SHOWN} from {folder} to begin anew"
        ) from None
    if found := differences(there, here):
        raise ValueError(
            f"{folder} holds another job: {in_short(found)}. Give the same job, "
            f"or another folder; or remove {_SHOWN} from this one to begin anew"
        )


def check_folder(path: str | os.PathLike[str]) -> None:
    """Refuse a folder that is not one of chunks, before any work."""
    find_store(path, _PURPOSE)


def trim(folder: Path, chunks: int) -> None:
    """Remove all but the first chunks: how many were computed ahead depends on the threads.

    Parameters
    ----------
    folder
        The folder of the chunks; without one nothing is done.
    chunks
        The number of chunks that are kept.
    """
    store = find_store(folder, _PURPOSE)
    if store is not None:
        found = [name for name in store.present() if fnmatchcase(name, _CHUNKS)]
        store.remove(name for name in found if int(name[6:15]) >= chunks)


def remove_chunks(folder: Path) -> None:
    """Remove finished chunks, and their folder if nothing else is in it."""
    store = find_store(folder, _PURPOSE)
    if store is not None:
        store.dissolve()


def count_chunks(folder: Path) -> int:
    """Return the number of chunks in a folder; 0 if it does not exist."""
    return sum(1 for _ in folder.glob(_CHUNKS))


def read_record(file: Path) -> dict[str, Any]:
    """Return the names and values in a file of JSON."""
    try:
        record = json.loads(read_file(file).decode())
    except RecursionError:
        raise ValueError(f"{file}: nested too deep") from None
    if not isinstance(record, dict):
        raise ValueError(f"{file}: expected names and values")
    return record


def differences(there: Mapping[str, str], here: Mapping[str, str]) -> list[str]:
    """Return the differences between two identities as of `flat`, as text.

    Parameters
    ----------
    there
        The identity of the work in the folder.
    here
        The identity of the work that is asked for.

    Returns
    -------
    list of str
        A sentence for each name whose values differ; empty if the folder is of the same work.
    """
    return [
        f"{name} is {_short(there.get(name))} there and {_short(here.get(name))} here"
        for name in dict.fromkeys((*here, *there))
        if there.get(name) != here.get(name)
    ]


def in_short(found: Sequence[str]) -> str:
    """Say the first few of what is not the same, and how many more there are."""
    more = [f"and {len(found) - _MAX_DIFFERENCES} more"] if len(found) > _MAX_DIFFERENCES else []
    return "; ".join([*found[:_MAX_DIFFERENCES], *more])


def flat(values: Mapping[str, Any], prefix: str = "") -> dict[str, str]:
    """Return the leaves of nested mappings as JSON, by dotted names.

    Parameters
    ----------
    values
        Numbers, texts and mappings by name.
    prefix
        The text before each name, with its dot.
    """
    leaves: dict[str, str] = {}
    for name, value in values.items():
        if isinstance(value, Mapping):
            leaves |= flat(value, f"{prefix}{name}.")
        else:
            leaves[f"{prefix}{name}"] = json.dumps(for_json(value))
    return leaves


def _short(text: str | None) -> str:
    if text is None:
        return "missing"
    return text if len(text) <= 60 else f"{text[:57]}..."


@contextlib.contextmanager
def written(path: Path, temporary: Path) -> Iterator[IO[bytes]]:
    """Write a file of long work as `atomic_file` does; an error says what is not lost.

    Parameters
    ----------
    path
        The file.
    temporary
        The file that is written first and takes its place when it is complete.

    Raises
    ------
    OSError
        If the file cannot be written; the message says that the work so far is kept.
    """
    try:
        with files.atomic_file(path, temporary) as file:
            yield file
    except OSError as error:
        if error.filename != str(path):
            raise  # of something else
        raise OSError(error.errno, f"{error.strerror}; {KEPT}", str(path)) from error
