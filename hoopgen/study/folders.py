"""Finished chunks on disk: each with a keyed digest, in a folder that says of which job.

One that is damaged, of another job or of another chunk does not pass.
"""

from __future__ import annotations

import contextlib
import hashlib
import json
import os
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import IO, Any

import pyarrow as pa

from hoopgen import outputs
from hoopgen.words import for_json

from .lock import LOCK, held, read_file
from .workers import versions

__all__ = [
    "KEPT",
    "Folder",
    "differences",
    "flat",
    "in_short",
    "opened",
    "read_record",
    "trim",
    "written",
]

_DIGEST = 32  # bytes
_TEMPORARY = ".tmp"
_CHUNKS = "chunk-*.arrow"
_IDENTITY = "identity.json"

KEPT = "finished chunks are kept, and the same call goes on from there"

_FEW = 3
"""Differences that are told."""


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


def trim(folder: Path, chunks: int) -> None:
    """Remove all but the first chunks: how many were computed ahead hangs on the threads.

    Raises
    ------
    OSError
        If that fails.
    """
    for file in folder.glob(_CHUNKS):
        if int(file.stem.rpartition("-")[2]) >= chunks:
            file.unlink()


def count_chunks(folder: Path) -> int:
    """Return how many chunks there are in a folder, which need not be there."""
    return sum(1 for _ in folder.glob(_CHUNKS))


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


def flat(values: Mapping[str, Any], prefix: str = "") -> dict[str, str]:
    """Return the leaves of nested mappings as JSON, by dotted names."""
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
        raise OSError(error.errno, f"{error.strerror}; {KEPT}", str(path)) from error
