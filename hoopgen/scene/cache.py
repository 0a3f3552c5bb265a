"""Compiled scenes on disk: a folder of the user's own, in which nothing is trusted by its name.

Each scene has a folder, named by a digest of all that it is made from. It is written elsewhere and
moved to its place, so it is there wholly or not at all; what is in it is used only if its digest is
the one on record. Who builds holds a lock of the operating system, which ends with the process.
"""

from __future__ import annotations

import atexit
import contextlib
import hashlib
import json
import os
import shutil
import stat
import sys
import tempfile
import threading
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

from hoopgen.engine.trust import user_cache

__all__ = ["Cache", "Entry", "cleared", "own", "private"]

RECORD = "record.json"
MOST_POINTERS = 1000
"""After so many, those there are are forgotten: of what changed, they point nowhere any more."""

_LOCK, _BUILD, _POINTERS = ".lock", ".build-", "pointers"

_THREADS = threading.Lock()
"""Of this process, whose locks of files exclude other processes alone."""


def _renew() -> None:
    """Give a forked process a lock that no thread of its parent holds."""
    global _THREADS
    _THREADS = threading.Lock()


if sys.platform == "win32":
    import msvcrt

    def _lock(descriptor: int) -> None:
        msvcrt.locking(descriptor, msvcrt.LK_LOCK, 1)

    def _unlock(descriptor: int) -> None:
        msvcrt.locking(descriptor, msvcrt.LK_UNLCK, 1)
else:
    import fcntl

    os.register_at_fork(after_in_child=_renew)

    # Of a process, not of an open file: no forked process keeps it.
    def _lock(descriptor: int) -> None:
        fcntl.lockf(descriptor, fcntl.LOCK_EX)

    def _unlock(descriptor: int) -> None:
        fcntl.lockf(descriptor, fcntl.LOCK_UN)


@dataclass(frozen=True)
class Entry:
    """A compiled scene on disk.

    Attributes
    ----------
    folder
        That holds its files.
    record
        What was said of it when it was built.
    """

    folder: Path
    record: Mapping[str, Any]

    def read(self, name: str) -> bytes:
        """Return a file that is the one on record.

        Raises
        ------
        ValueError
            If it is another.
        OSError
            If it cannot be read.
        """
        content = (self.folder / name).read_bytes()
        if digest(content) != self.record["files"].get(name):
            raise ValueError(f"{self.folder / name} is not the file that was built")
        return content

    def checked(self, name: str) -> Path:
        """Return the path of a file that is the one on record; raises as `read` does."""
        self.read(name)
        return self.folder / name


def digest(content: bytes) -> str:
    """Return what tells a content from others."""
    return hashlib.sha256(content).hexdigest()


@dataclass(frozen=True)
class Cache:
    """A folder of compiled scenes."""

    folder: Path

    def entry(self, key: str) -> Entry | None:
        """Return what is kept under a key; None if there is nothing, or nothing that holds good."""
        folder = self.folder / key
        try:
            record = json.loads((folder / RECORD).read_bytes())
            files = dict(record["files"])
        except (OSError, ValueError, TypeError, KeyError):
            return None
        found = Entry(folder, record | {"files": files})
        try:
            for name in files:
                found.read(name)
        except OSError:
            return None
        except ValueError as error:
            print(f"hoopgen: {error}; it is not used, and built anew.", file=sys.stderr)
            return None
        return found

    def built(self, key: str, build: Callable[[Path], Mapping[str, Any]]) -> Entry:
        """Return what is kept under a key, built first if it is not there.

        Parameters
        ----------
        build
            Writes files into an empty folder, and returns what is to be said of them. What it says
            is not kept where that has ``"passing": True``.

        Raises
        ------
        OSError
            If it cannot be written.
        """
        with self.held(key):
            found = self.entry(key)
            if found is not None:
                return found
            for left in self.folder.glob(f"{_BUILD}{key}-*"):  # its builder was killed
                shutil.rmtree(left, ignore_errors=True)
            folder = Path(tempfile.mkdtemp(prefix=f"{_BUILD}{key}-", dir=self.folder))
            try:
                record = dict(build(folder))
                record["files"] = {
                    file.name: digest(file.read_bytes()) for file in sorted(folder.iterdir())
                }
                (folder / RECORD).write_text(json.dumps(record, indent=1), encoding="utf-8")
                if record.get("passing"):
                    return Entry(_kept_here(folder), record)
                place = self.folder / key
                shutil.rmtree(place, ignore_errors=True)
                folder.rename(place)
            finally:
                shutil.rmtree(folder, ignore_errors=True)
            return Entry(place, record)

    def pointed(self, name: str) -> Entry | None:
        """Return what was kept under the key that a name points to."""
        try:
            key = (self.folder / _POINTERS / name).read_text(encoding="ascii")
        except (OSError, ValueError):
            return None
        return self.entry(key) if len(key) == len(name) and key.isalnum() else None

    def point(self, name: str, key: str) -> None:
        """Let a name point to a key; of no matter if it cannot."""
        with contextlib.suppress(OSError):
            folder = self.folder / _POINTERS
            folder.mkdir(mode=0o700, exist_ok=True)
            if sum(1 for _ in folder.iterdir()) >= MOST_POINTERS:
                shutil.rmtree(folder)
                folder.mkdir(mode=0o700)
            part = folder / f"{name}.{os.getpid()}-{threading.get_ident()}"
            part.write_text(key, encoding="ascii")
            part.replace(folder / name)

    def entries(self) -> Iterator[Entry]:
        """Give what is kept."""
        for folder in sorted(self.folder.iterdir()):
            found = self.entry(folder.name) if not folder.name.startswith(".") else None
            if found is not None:
                yield found

    @contextlib.contextmanager
    def held(self, key: str) -> Iterator[None]:
        """Hold the lock of a key; waits while another holds it."""
        with _THREADS, (self.folder / f".{key}{_LOCK}").open("ab") as file:
            _lock(file.fileno())
            try:
                yield
            finally:
                _unlock(file.fileno())


def cleared(there: Cache) -> int:
    """Remove all that is kept and that nobody is building; return how many scenes that were."""
    shutil.rmtree(there.folder / _POINTERS, ignore_errors=True)
    names = [path.name for path in there.folder.iterdir()]
    keys = {name.removeprefix(_BUILD).removeprefix(".").partition("-")[0] for name in names}
    for key in {key.removesuffix(_LOCK) for key in keys}:
        with there.held(key):
            for path in (there.folder / key, *there.folder.glob(f"{_BUILD}{key}-*")):
                shutil.rmtree(path, ignore_errors=True)
            (there.folder / f".{key}{_LOCK}").unlink()
    return sum(not name.startswith(".") and name != _POINTERS for name in names)


def own() -> Cache | str:
    """Return the user's own folder of compiled scenes, or why it cannot be used."""
    try:
        above = user_cache()
        above.mkdir(mode=0o700, parents=True, exist_ok=True)
        folder = above / "scenes"
        folder.mkdir(mode=0o700, exist_ok=True)
        status = folder.lstat()
    except (OSError, RuntimeError) as error:
        return str(error)
    if not stat.S_ISDIR(status.st_mode):
        return f"{folder} is no folder"
    if os.name != "nt" and status.st_uid != os.getuid():
        return f"{folder} is another user's"
    if os.name != "nt" and status.st_mode & 0o077:
        return f"{folder} is open to others; its mode should be 700"
    if not os.access(folder, os.W_OK | os.X_OK):
        return f"{folder} cannot be written"
    return Cache(folder)


@cache
def private(why: str) -> Cache:
    """Return a folder for this process alone, and say why, once."""
    folder = Path(tempfile.mkdtemp(prefix="hoopgen-"))
    _removed_at_exit(folder)
    print(
        f"hoopgen: {why}; scenes are compiled for this process alone, in {folder}.", file=sys.stderr
    )
    return Cache(folder)


def _removed_at_exit(folder: Path) -> None:
    process = os.getpid()

    def remove() -> None:
        if os.getpid() == process:  # and not one that it has forked
            shutil.rmtree(folder, ignore_errors=True)

    atexit.register(remove)


def _kept_here(folder: Path) -> Path:
    """Return a copy of a folder that goes with this process."""
    place = Path(tempfile.mkdtemp(prefix="hoopgen-"))
    _removed_at_exit(place)
    shutil.copytree(folder, place, dirs_exist_ok=True)
    return place
