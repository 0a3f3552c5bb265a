"""The cache of compiled scenes: a folder of the user's own, with checked contents.

Each scene has a folder, named by a digest of all that it is made from. It is written elsewhere and
moved to its place, so it is there wholly or not at all. What is in it is read once, and used only
if each file has the digest on record, and the record its own. Who builds holds a lock of the
operating system, which ends with the process. No other user can change the folder or those above
it (`hoopgen.core.private_folders`), and hoopgen removes from it only what it has put there
(`hoopgen.core.owned_folders`).
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
from typing import Any, BinaryIO, Protocol

from hoopgen.core.lock import read_file
from hoopgen.core.owned_folders import MARKER, Store, find_store, mark, open_store
from hoopgen.core.private_folders import private_folder
from hoopgen.engine.verification import user_cache

RECORD, MODULE, SOURCES = "record.json", "module", "sources.gz"
LIBRARIES = ("engine.so", "engine.dll")
"""Files of a scene: what was said of it, its module of NumPy, all that was printed, and C."""

MAX_POINTERS = 1000
"""Largest number of pointers; with more, all are removed, since many are out of date."""

_LOCK, _BUILD, _POINTERS = ".lock", ".build-", "pointers"

_PURPOSE = "compiled scenes"
_FILES = (
    ".[0-9a-f]*.lock",
    f"{_POINTERS}/[0-9a-f]*",
    *(f"[0-9a-f]*/{name}" for name in (RECORD, MODULE, SOURCES, *LIBRARIES)),
)
_OWN_NAMES = re.compile(
    rf"\.?(?:build-)?(?P<key>[0-9a-f]{{64}})(?:{re.escape(_LOCK)}|-\w+)?|{_POINTERS}|"
    rf"{re.escape(MARKER)}|\.hoopgen-\w+\.tmp"
)
"""Names in the folder that hoopgen gives: by them one that has no marker is known."""

_THREADS = threading.Lock()
"""Lock between the threads of this process; locks of files exclude only other processes."""


def _replace_lock() -> None:
    """Replace the lock in a forked process, since a thread of its parent may hold it."""
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

    os.register_at_fork(after_in_child=_replace_lock)

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


class SceneStore(Protocol):
    """The interface of a store of compiled scenes."""

    def path(self, key: str, name: str) -> Path | None:
        """Return the path of a scene's file; None if it has none.

        Parameters
        ----------
        key
            The key of the scene.
        name
            The name of the file.
        """

    def entry(self, key: str) -> Entry | None:
        """Return the entry of a key; None if there is no valid one."""

    def built(self, key: str, build: Callable[[Path | str], Entry]) -> Entry:
        """Return the entry of a key; build it first if there is none.

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
        """Return the entry of the key that a name points to."""

    def point(self, name: str, key: str) -> None:
        """Let a name point to a key; failures are ignored.

        Parameters
        ----------
        name
            The name of the pointer.
        key
            The key of the scene.
        """


def digest(content: bytes) -> str:
    """Return the digest of a content."""
    return hashlib.sha256(content).hexdigest()


def _check_record(record: Mapping[str, Any], files: Mapping[str, str]) -> bytes:
    """Return the content of a record's file, which ends in the digest of the rest."""
    said = json.dumps({**record, "files": dict(files)}, indent=1)
    return f"{said}\n{digest(said.encode())}\n".encode()


@dataclass(frozen=True)
class Cache:
    """A store of compiled scenes in a folder."""

    folder: Path

    @property
    def store(self) -> Store:
        """The files of the folder that hoopgen owns."""
        return Store(self.folder, _PURPOSE, frozenset(_FILES))

    def path(self, key: str, name: str) -> Path:
        """Return the path of a scene's file."""
        return self.folder / key / name

    def entry(self, key: str) -> Entry | None:
        """Return the entry of a key; None if there is no valid one."""
        folder = self.folder / key
        if not folder.is_dir():
            return None
        try:
            content = read_file(folder / RECORD)
            record = json.loads(content.rpartition(b"\n}\n")[0] + b"\n}")
            names = record.pop("files")
            files = {name: read_file(folder / name) for name in names}
            found = {name: digest(inside) for name, inside in files.items()}
            if _check_record(record, found) == content and record.get("key") == key:
                return Entry(record, files)
        except (OSError, ValueError, TypeError, KeyError, AttributeError, RecursionError):
            pass
        _warn_once(f"{folder} does not hold what was built; it is not used, and built anew.")
        return None

    def built(self, key: str, build: Callable[[Path | str], Entry]) -> Entry:
        """Return the entry of a key; build it first if there is none."""
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
                    (folder / RECORD).write_bytes(_check_record(made.record, digests))
                    self._remove_files(key)
                    folder.rename(self.folder / key)
            finally:
                shutil.rmtree(folder, ignore_errors=True)
            return made

    def pointed(self, name: str) -> Entry | None:
        """Return the entry of the key that a name points to."""
        try:
            key = read_file(self.folder / _POINTERS / name).decode("ascii")
        except (OSError, ValueError):
            return None
        return self.entry(key) if _OWN_NAMES.fullmatch(key) and key.isalnum() else None

    def point(self, name: str, key: str) -> None:
        """Let a name point to a key; failures are ignored."""
        with contextlib.suppress(OSError):
            folder = self.folder / _POINTERS
            folder.mkdir(mode=0o700, exist_ok=True)
            if sum(1 for _ in folder.iterdir()) >= MAX_POINTERS:
                self.remove_pointers()
                folder.mkdir(mode=0o700, exist_ok=True)
            part = folder / f"{name}.{os.getpid()}-{threading.get_ident()}"
            part.write_text(key, encoding="ascii")
            part.replace(folder / name)

    def entries(self) -> Iterator[Entry]:
        """Yield the valid entries."""
        for key in self.keys():
            found = self.entry(key)
            if found is not None:
                yield found

    def keys(self) -> list[str]:
        """Return the keys of all entries, valid or not, sorted."""
        names = (path.name for path in self.folder.iterdir() if path.is_dir())
        return sorted(name for name in names if name.isalnum() and _key(name))

    def remove_pointers(self) -> None:
        """Remove all pointers."""
        self._remove_files(_POINTERS)

    def remove(self, key: str) -> None:
        """Remove an entry, the remains of its builds, and its lock."""
        with self.held(key):
            self._remove_files(key)
            self._remove_builds(key)
            (self.folder / f".{key}{_LOCK}").unlink()

    def _remove_builds(self, key: str) -> None:
        for left in self.folder.glob(f"{_BUILD}{key}-*"):
            if not left.is_symlink():
                shutil.rmtree(left, ignore_errors=True)

    def _remove_files(self, name: str) -> None:
        """Remove hoopgen's files in a subfolder, and the subfolder if it is then empty."""
        folder = self.folder / name
        with contextlib.suppress(OSError):
            self.store.remove(f"{name}/{file.name}" for file in folder.iterdir())
            folder.rmdir()

    @contextlib.contextmanager
    def held(self, key: str) -> Iterator[None]:
        """Hold the lock of a key; wait while another process holds it."""
        with _THREADS, self._open_lock(key) as file:
            _lock(file.fileno())
            try:
                yield
            finally:
                _unlock(file.fileno())

    def _open_lock(self, key: str) -> BinaryIO:
        """Open the file of a key's lock; the error names the folder, whatever the key."""
        try:
            return (self.folder / f".{key}{_LOCK}").open("ab")
        except OSError as error:
            raise OSError(error.errno, error.strerror, str(self.folder)) from None


@dataclass(frozen=True)
class Memory:
    """A store of compiled scenes in the memory of this process."""

    _entries: dict[str, Entry] = field(default_factory=dict)
    _keys: dict[str, str] = field(default_factory=dict)

    def path(self, key: str, name: str) -> Path | None:
        """Return None: there are no files."""
        return None

    def entry(self, key: str) -> Entry | None:
        """Return the entry of a key."""
        return self._entries.get(key)

    def built(self, key: str, build: Callable[[Path | str], Entry]) -> Entry:
        """Return the entry of a key; build it first if there is none."""
        with _THREADS:
            if key not in self._entries:
                with tempfile.TemporaryDirectory(prefix="hoopgen-") as folder:
                    made = build(private_folder(Path(folder)))
                if made.record.get("passing"):
                    return made
                self._entries[key] = made
            return self._entries[key]

    def pointed(self, name: str) -> Entry | None:
        """Return the entry of the key that a name points to."""
        return self._entries.get(self._keys.get(name, ""))

    def point(self, name: str, key: str) -> None:
        """Let a name point to a key."""
        self._keys[name] = key


def _key(name: str) -> str:
    """Return the key of the scene to which a name in the cache belongs, "" if to none."""
    found = _OWN_NAMES.fullmatch(name)
    return (found and found["key"]) or ""


def clear_store(there: Cache) -> int:
    """Remove all entries that no process is building; return their number.

    Other files in the folder stay as they are.
    """
    there.remove_pointers()
    scenes = there.keys()
    for key in sorted({_key(path.name) for path in there.folder.iterdir()} - {""}):
        there.remove(key)
    return len(scenes)


def user_store() -> Cache | str:
    """Return the user's folder of compiled scenes, or why it cannot be used.

    One that cannot be written serves with the scenes that it has.
    """
    try:
        folder = private_folder(user_cache() / "scenes")
        if os.name != "nt" and folder.stat().st_mode & 0o077:
            return f"{folder} is open to others; its mode should be 700"
        try:
            if find_store(folder, _PURPOSE) is None:
                open_store(folder, _PURPOSE, _FILES)
        except ValueError:
            if not all(_OWN_NAMES.fullmatch(path.name) for path in folder.iterdir()):
                raise
            mark(folder, _PURPOSE, _FILES)  # of hoopgen 0.2.0, which had no marker; or damaged
    except OSError as error:
        return f"{error.filename}: {error.strerror}" if error.filename else str(error)
    except (RuntimeError, ValueError) as error:
        return str(error)
    return Cache(folder)


def is_empty_store() -> bool:
    """Return whether the user's folder of compiled scenes holds nothing, or does not exist."""
    try:
        return next((user_cache() / "scenes").iterdir(), None) is None
    except (FileNotFoundError, NotADirectoryError):
        return True
    except (OSError, RuntimeError):
        return False


@cache
def process_store(why: str) -> Memory:
    """Return a store for this process alone, and print once why."""
    _warn_once(f"{why}; scenes are compiled for this process alone.")
    return Memory()


@cache
def _warn_once(line: str) -> None:
    print(f"hoopgen: {line}", file=sys.stderr)
