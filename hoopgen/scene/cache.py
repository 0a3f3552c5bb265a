"""Compiled scenes on disk: a folder of the user's own, in which nothing is trusted by its name.

Each scene has a folder, named by a digest of all that it is made from. It is written elsewhere and
moved to its place, so it is there wholly or not at all. What is in it is read once, and used only
if each file has the digest on record, and the record its own. Who builds holds a lock of the
operating system, which ends with the process. No other user can change the folder or those above
it (`hoopgen.core.private`), and hoopgen removes from it only what it has put there
(`hoopgen.core.store`).
"""

from __future__ import annotations

import contextlib
import hashlib
import json
import os
import re
import shutil
import sys
import tempfile
import threading
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import Any, Protocol

from hoopgen.core.lock import read_file
from hoopgen.core.private import private_folder
from hoopgen.core.store import MARKER, Store, find_store, mark, open_store
from hoopgen.engine.trust import user_cache

__all__ = ["Cache", "Entry", "Kept", "cleared", "digest", "own", "private"]

RECORD, MODULE, SOURCES = "record.json", "module", "sources.gz"
LIBRARIES = ("engine.so", "engine.dll")
"""Files of a scene: what was said of it, its module of NumPy, all that was printed, and C."""

MOST_POINTERS = 1000
"""After so many, those there are are forgotten: of what changed, they point nowhere any more."""

_LOCK, _BUILD, _POINTERS = ".lock", ".build-", "pointers"

_PURPOSE = "compiled scenes"
_FILES = (
    ".[0-9a-f]*.lock",
    f"{_POINTERS}/[0-9a-f]*",
    *(f"[0-9a-f]*/{name}" for name in (RECORD, MODULE, SOURCES, *LIBRARIES)),
)
_OURS = re.compile(
    rf"\.?(?:build-)?(?P<key>[0-9a-f]{{64}})(?:{re.escape(_LOCK)}|-\w+)?|{_POINTERS}|"
    rf"{re.escape(MARKER)}|\.hoopgen-\w+\.tmp"
)
"""Names in the folder that hoopgen gives: by them one that has no marker is known."""

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
    """A compiled scene.

    Attributes
    ----------
    record
        What was said of it when it was built.
    files
        Content by name.
    """

    record: Mapping[str, Any]
    files: Mapping[str, bytes]


class Kept(Protocol):
    """Where compiled scenes are kept."""

    def path(self, key: str, name: str) -> Path | None:
        """Return where a file of a scene lies; None if nowhere."""

    def entry(self, key: str) -> Entry | None:
        """Return what is kept under a key; None if there is nothing, or nothing that holds good."""

    def built(self, key: str, build: Callable[[Path | str], Entry]) -> Entry:
        """Return what is kept under a key, built first if it is not there.

        Parameters
        ----------
        build
            Builds it with the help of an empty folder. It is not kept where its record has
            ``"passing": True``.

        Raises
        ------
        OSError
            If it cannot be written.
        """

    def pointed(self, name: str) -> Entry | None:
        """Return what was kept under the key that a name points to."""

    def point(self, name: str, key: str) -> None:
        """Let a name point to a key; of no matter if it cannot."""


def digest(content: bytes) -> str:
    """Return what tells a content from others."""
    return hashlib.sha256(content).hexdigest()


def _recorded(record: Mapping[str, Any], files: Mapping[str, str]) -> bytes:
    """Return what the record's file holds; the last of it is the digest of the rest."""
    said = json.dumps({**record, "files": dict(files)}, indent=1)
    return f"{said}\n{digest(said.encode())}\n".encode()


@dataclass(frozen=True)
class Cache:
    """A folder of compiled scenes."""

    folder: Path

    @property
    def store(self) -> Store:
        """What of it is hoopgen's."""
        return Store(self.folder, _PURPOSE, frozenset(_FILES))

    def path(self, key: str, name: str) -> Path:
        """Return where a file of a scene lies."""
        return self.folder / key / name

    def entry(self, key: str) -> Entry | None:
        """Return what is kept under a key; None if there is nothing, or nothing that holds good."""
        folder = self.folder / key
        if not folder.is_dir():
            return None
        try:
            content = read_file(folder / RECORD)
            record = json.loads(content.rpartition(b"\n}\n")[0] + b"\n}")
            names = record.pop("files")
            files = {name: read_file(folder / name) for name in names}
            found = {name: digest(inside) for name, inside in files.items()}
            if _recorded(record, found) == content and record.get("key") == key:
                return Entry(record, files)
        except (OSError, ValueError, TypeError, KeyError, AttributeError, RecursionError):
            pass
        _say_once(f"{folder} does not hold what was built; it is not used, and built anew.")
        return None

    def built(self, key: str, build: Callable[[Path | str], Entry]) -> Entry:
        """Return what is kept under a key, built first if it is not there; as `Kept` says."""
        with self.held(key):
            found = self.entry(key)
            if found is not None:
                return found
            self._remove_builds(key)  # whose builder was killed
            folder = Path(tempfile.mkdtemp(prefix=f"{_BUILD}{key}-", dir=self.folder))
            try:
                made = build(folder)
                if not made.record.get("passing"):
                    for name, content in made.files.items():
                        (folder / name).write_bytes(content)
                    digests = {name: digest(content) for name, content in made.files.items()}
                    (folder / RECORD).write_bytes(_recorded(made.record, digests))
                    self._remove_files(key)
                    folder.rename(self.folder / key)
            finally:
                shutil.rmtree(folder, ignore_errors=True)
            return made

    def pointed(self, name: str) -> Entry | None:
        """Return what was kept under the key that a name points to."""
        try:
            key = read_file(self.folder / _POINTERS / name).decode("ascii")
        except (OSError, ValueError):
            return None
        return self.entry(key) if _OURS.fullmatch(key) and key.isalnum() else None

    def point(self, name: str, key: str) -> None:
        """Let a name point to a key; of no matter if it cannot."""
        with contextlib.suppress(OSError):
            folder = self.folder / _POINTERS
            folder.mkdir(mode=0o700, exist_ok=True)
            if sum(1 for _ in folder.iterdir()) >= MOST_POINTERS:
                self.remove_pointers()
                folder.mkdir(mode=0o700, exist_ok=True)
            part = folder / f"{name}.{os.getpid()}-{threading.get_ident()}"
            part.write_text(key, encoding="ascii")
            part.replace(folder / name)

    def entries(self) -> Iterator[Entry]:
        """Give what is kept."""
        for key in self.keys():
            found = self.entry(key)
            if found is not None:
                yield found

    def keys(self) -> list[str]:
        """Return the keys of what is kept, whether or not it holds good, sorted."""
        names = (path.name for path in self.folder.iterdir() if path.is_dir())
        return sorted(name for name in names if name.isalnum() and _key(name))

    def remove_pointers(self) -> None:
        """Remove all pointers."""
        self._remove_files(_POINTERS)

    def remove(self, key: str) -> None:
        """Remove what is kept under a key, what is left of its builds, and its lock."""
        with self.held(key):
            self._remove_files(key)
            self._remove_builds(key)
            (self.folder / f".{key}{_LOCK}").unlink()

    def _remove_builds(self, key: str) -> None:
        for left in self.folder.glob(f"{_BUILD}{key}-*"):
            if not left.is_symlink():
                shutil.rmtree(left, ignore_errors=True)

    def _remove_files(self, name: str) -> None:
        """Remove the files of a folder in this one, and the folder if nothing else is in it."""
        folder = self.folder / name
        with contextlib.suppress(OSError):
            self.store.remove(f"{name}/{file.name}" for file in folder.iterdir())
            folder.rmdir()

    @contextlib.contextmanager
    def held(self, key: str) -> Iterator[None]:
        """Hold the lock of a key; waits while another holds it."""
        with _THREADS, (self.folder / f".{key}{_LOCK}").open("ab") as file:
            _lock(file.fileno())
            try:
                yield
            finally:
                _unlock(file.fileno())


@dataclass(frozen=True)
class Memory:
    """Scenes that are compiled for this process alone."""

    _entries: dict[str, Entry] = field(default_factory=dict)
    _keys: dict[str, str] = field(default_factory=dict)

    def path(self, key: str, name: str) -> Path | None:
        """Return None: its files lie nowhere."""
        return None

    def entry(self, key: str) -> Entry | None:
        """Return what is kept under a key."""
        return self._entries.get(key)

    def built(self, key: str, build: Callable[[Path | str], Entry]) -> Entry:
        """Return what is kept under a key, built first if it is not there; as `Kept` says."""
        with _THREADS:
            if key not in self._entries:
                with tempfile.TemporaryDirectory(prefix="hoopgen-") as folder:
                    made = build(private_folder(Path(folder)))
                if made.record.get("passing"):
                    return made
                self._entries[key] = made
            return self._entries[key]

    def pointed(self, name: str) -> Entry | None:
        """Return what was kept under the key that a name points to."""
        return self._entries.get(self._keys.get(name, ""))

    def point(self, name: str, key: str) -> None:
        """Let a name point to a key."""
        self._keys[name] = key


def _key(name: str) -> str:
    """Return the key of the scene that a file or folder of the cache belongs to, "" of others."""
    found = _OURS.fullmatch(name)
    return (found and found["key"]) or ""


def cleared(there: Cache) -> int:
    """Remove all that is kept and that nobody is building; return how many scenes that were.

    Other files in the folder stay as they are.
    """
    there.remove_pointers()
    scenes = there.keys()
    for key in sorted({_key(path.name) for path in there.folder.iterdir()} - {""}):
        there.remove(key)
    return len(scenes)


def own() -> Cache | str:
    """Return the user's own folder of compiled scenes, or why it cannot be used."""
    try:
        folder = private_folder(user_cache() / "scenes")
        if os.name != "nt" and folder.stat().st_mode & 0o077:
            return f"{folder} is open to others; its mode should be 700"
        if not os.access(folder, os.W_OK | os.X_OK):
            return f"{folder} cannot be written"
        try:
            if find_store(folder, _PURPOSE) is None:
                open_store(folder, _PURPOSE, _FILES)
        except ValueError:
            if not all(_OURS.fullmatch(path.name) for path in folder.iterdir()):
                raise
            mark(folder, _PURPOSE, _FILES)  # of hoopgen 0.2.0, which had no marker; or damaged
    except OSError as error:
        return f"{error.filename}: {error.strerror}" if error.filename else str(error)
    except (RuntimeError, ValueError) as error:
        return str(error)
    return Cache(folder)


@cache
def private(why: str) -> Memory:
    """Return a place for what this process compiles, and say why, once."""
    _say_once(f"{why}; scenes are compiled for this process alone.")
    return Memory()


@cache
def _say_once(line: str) -> None:
    print(f"hoopgen: {line}", file=sys.stderr)
