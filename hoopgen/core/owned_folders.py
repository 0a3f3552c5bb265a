"""Folders that hoopgen owns: a marker names the only files that are ever touched.

A folder is used if it does not exist, is empty, or has the marker of the same purpose. Whatever
else lies in it is somebody else's: it is neither replaced nor removed, and links are not followed.
"""

from __future__ import annotations

import contextlib
import errno
import json
import os
import secrets
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from fnmatch import fnmatchcase
from pathlib import Path, PurePosixPath

from hoopgen.text.shorten import cut

from . import files as files_module
from .lock import LOCK, held, read_file

MARKER = "hoopgen.json"
"""Name of the file that says that a folder is hoopgen's, what for, and which files it owns."""

FORMAT = 1
"""Version of the marker's format."""

_EXPLANATION = (
    "hoopgen made this folder. It replaces and removes the files listed here, and no others."
)

_TEMPORARY_PATTERN = ".hoopgen-*.tmp"
"""Names of files that are not whole yet; every marker has this pattern."""

_FILES_OF_0_2 = frozenset({"identity.json", "versions.json"})
"""Files in the folders of hoopgen 0.2.0, which have no marker."""

_MAX_LISTED_NAMES = 3
"""Names of files that an error message lists."""


@dataclass
class Store:
    """A folder that hoopgen owns.

    Attributes
    ----------
    path
        The folder.
    purpose
        What it is for, as the marker says it.
    files
        Names of the files that hoopgen owns in it, relative to it and with slashes; a pattern, as
        of `fnmatch`, stands for all names of one folder that it matches.
    """

    path: Path
    purpose: str
    files: frozenset[str]

    def owns(self, name: str) -> bool:
        """Return whether the marker names a file."""
        return any(_matches(name, pattern) for pattern in self.files)

    def claim(self, *names: str) -> None:
        """Enter names into the marker, before their files are written.

        Raises
        ------
        FileExistsError
            If a file of that name is there and is not hoopgen's, or its folder is a link: which.
        OSError
            If the marker cannot be written.
        """
        for name in names:
            if (link := self._link_above(name)) is not None:
                said = "this is a link, not a folder of hoopgen; move it away"
                raise FileExistsError(errno.EEXIST, said, str(link))
        new = [name for name in names if not self.owns(name)]
        for name in new:
            if os.path.lexists(self.path / name):
                said = "hoopgen did not make this file; move it away, or give another folder"
                raise FileExistsError(errno.EEXIST, said, str(self.path / name))
        if new:
            self._record(self.files.union(new))

    def adopt(self, names: Iterable[str]) -> None:
        """Enter the names of existing files into the marker.

        The caller has made sure that these files hold what hoopgen would write.

        Raises
        ------
        OSError
            If the marker cannot be written.
        """
        new = [name for name in names if not self.owns(name)]
        if new:
            self._record(self.files.union(new))

    def write(self, name: str, content: str | bytes) -> None:
        """Claim a name and write its file atomically.

        Parameters
        ----------
        name
            The name, relative to the folder.
        content
            The whole content; text in UTF-8.

        Raises
        ------
        OSError
            As `claim` does, and if the file cannot be written.
        """
        self.claim(name)
        with files_module.atomic_file(self.path / name, self.temporary()) as file:
            file.write(content.encode() if isinstance(content, str) else content)

    def temporary(self) -> Path:
        """Return an unused name on the same file system, for a file until it is complete."""
        return self.path / _TEMPORARY_PATTERN.replace("*", secrets.token_hex(8))

    def present(self) -> list[str]:
        """Return the names of the existing files that hoopgen owns, sorted."""
        found = set()
        for pattern in self.files:
            paths = self.path.glob(pattern) if _is_pattern(pattern) else [self.path / pattern]
            names = (path.relative_to(self.path).as_posix() for path in paths)
            found |= {name for name in names if os.path.lexists(self.path / name)}
        return sorted(found)

    def remove(self, names: Iterable[str]) -> None:
        """Remove files that hoopgen owns, and their names from the marker.

        Names that the marker does not have, and what is a folder, stay as they are.

        Raises
        ------
        OSError
            If that fails.
        """
        owned = [name for name in names if self.owns(name)]
        for name in owned:
            self._unlink(name)
        if self.files.intersection(owned):
            self._record(self.files.difference(owned))

    def keep_only(self, names: Iterable[str]) -> list[str]:
        """Remove the files that hoopgen owns, except those of these names.

        Returns
        -------
        list of str
            Names of the files removed, sorted.

        Raises
        ------
        OSError
            If that fails.
        """
        kept = frozenset({*names, _TEMPORARY_PATTERN})
        stale = [name for name in self.present() if name not in kept]
        for name in stale:
            self._unlink(name)
        self._record(kept)
        return stale

    def remove_temporaries(self) -> None:
        """Remove incomplete files, which a killed process has left.

        No other process may be at work in the folder.
        """
        for path in self.path.glob(_TEMPORARY_PATTERN):
            self._unlink(path.name)

    def dissolve(self) -> None:
        """Remove all files that hoopgen owns, and the folder if it is then empty.

        Then the marker stays with them, so that the folder can be used again. While the folder is
        locked it stays, too, until the lock is gone.

        Raises
        ------
        OSError
            If a file cannot be removed.
        """
        for name in self.present():
            self._unlink(name)
        if {entry.name for entry in self.path.iterdir()} <= {MARKER, LOCK}:
            self._unlink(MARKER)
            with contextlib.suppress(OSError):
                self.path.rmdir()

    def _record(self, files: frozenset[str]) -> None:
        text = marker_text(self.purpose, files).encode()
        marker = self.path / MARKER
        if not (marker.is_file() and marker.read_bytes() == text):
            with files_module.atomic_file(marker, self.temporary()) as file:
                file.write(text)
        self.files = files

    def _unlink(self, name: str) -> None:
        """Remove a file or a link; folders and the content of linked ones stay."""
        path = self.path / name
        if self._link_above(name) is None and (path.is_symlink() or not path.is_dir()):
            path.unlink(missing_ok=True)

    def _link_above(self, name: str) -> Path | None:
        """Return a link among the folders between this one and a file, None if there is none."""
        between = (self.path / parent for parent in PurePosixPath(name).parents)
        return next((path for path in between if path != self.path and path.is_symlink()), None)


def marker_text(purpose: str, files: Iterable[str]) -> str:
    """Return the text of a folder's marker; arguments as for `open_store`."""
    names = sorted({*files, _TEMPORARY_PATTERN})
    said = {"hoopgen": purpose, "format": FORMAT, "about": _EXPLANATION, "files": names}
    return f"{json.dumps(said, indent=1)}\n"


def find_store(path: str | os.PathLike[str], purpose: str) -> Store | None:
    """Return a folder that hoopgen owns; None if it does not exist or is empty.

    Parameters
    ----------
    path
        The folder.
    purpose
        What it has to be for.

    Raises
    ------
    ValueError
        If hoopgen does not own it, or it is for another purpose: what lies there, what to do.
    OSError
        If it cannot be read.
    """
    folder = Path(path)
    try:
        names = {entry.name for entry in os.scandir(folder)}
    except (FileNotFoundError, NotADirectoryError):
        return None
    if MARKER not in names:
        others = {
            name for name in names if name != LOCK and not fnmatchcase(name, _TEMPORARY_PATTERN)
        }
        if not others:
            return None
        raise ValueError(f"{folder} {_foreign(others)}")
    try:
        said = _read_marker(folder / MARKER)
    except FileNotFoundError:  # another process has just removed all that was in the folder
        return None
    if said is None:
        raise ValueError(f"{folder / MARKER} {_DAMAGED}")
    there, version, files = said
    if there != purpose:
        raise ValueError(
            f"{folder} is a folder of hoopgen for {cut(there)}, not for {purpose}; "
            "give another folder"
        )
    if version != FORMAT:
        raise ValueError(
            f"{folder} was made by another version of hoopgen (format {version} of its marker, "
            f"here {FORMAT}); give another folder"
        )
    return Store(folder, purpose, files)


def open_store(path: str | os.PathLike[str], purpose: str, files: Iterable[str] = ()) -> Store:
    """Return a folder that hoopgen owns; make and mark it if it does not exist or is empty.

    Parameters
    ----------
    path
        The folder.
    purpose
        What it is for.
    files
        Names of files that hoopgen owns in it from the start, as in `Store`.

    Raises
    ------
    ValueError
        As `find_store` does.
    FileExistsError
        As `Store.claim` does; or if the path is no folder.
    OSError
        If it cannot be made or written.
    """
    store = find_store(path, purpose)
    if store is None:
        Path(path).mkdir(parents=True, exist_ok=True)
        return mark(path, purpose, files)
    store.claim(*files)
    return store


def mark(path: str | os.PathLike[str], purpose: str, files: Iterable[str]) -> Store:
    """Mark a folder as hoopgen's; arguments as for `open_store`.

    The caller answers for what lies in it, whatever an older marker says.

    Raises
    ------
    OSError
        If the marker cannot be written.
    """
    store = Store(Path(path), purpose, frozenset())
    store._record(frozenset({*files, _TEMPORARY_PATTERN}))
    return store


@contextlib.contextmanager
def locked_store(
    path: str | os.PathLike[str], purpose: str, files: Iterable[str] = ()
) -> Iterator[Store]:
    """Open a folder and lock it for this process; arguments as for `open_store`.

    Raises
    ------
    ValueError
        As `find_store` does, or if the path is empty.
    RuntimeError
        If another process is at work in the folder.
    OSError
        If it cannot be made or written, or has something else in the place of a file.
    """
    if not os.fspath(path):
        raise ValueError("folder: expected a name, got ''")
    find_store(path, purpose)  # before a lock is put into a folder of somebody else
    with held(Path(path)):
        store = open_store(path, purpose, files)
        store.remove_temporaries()
        yield store


_DAMAGED = (
    "cannot be read, so it does not say which files are hoopgen's; restore it, or give another "
    "folder"
)


def _foreign(names: Iterable[str]) -> str:
    """Describe the content of a folder that hoopgen does not own, and what to do."""
    there = sorted(names)
    shown = ", ".join(map(cut, there[:_MAX_LISTED_NAMES]))
    more = f" and {len(there) - _MAX_LISTED_NAMES} more" if len(there) > _MAX_LISTED_NAMES else ""
    older = (
        f" (folders of hoopgen 0.2.0 have no {MARKER} and cannot be continued)"
        if _FILES_OF_0_2.intersection(there)
        else ""
    )
    return (
        f"holds files that hoopgen did not make: {shown}{more}{older}; "
        "give another folder, one that is empty or does not exist"
    )


def _read_marker(file: Path) -> tuple[str, int, frozenset[str]] | None:
    """Return purpose, format and files of a marker; None if it has another form."""
    try:
        said = json.loads(read_file(file))
        purpose, version, files = said["hoopgen"], said["format"], said["files"]
    except (ValueError, TypeError, KeyError, RecursionError):
        return None
    if not (isinstance(purpose, str) and type(version) is int and isinstance(files, list)):
        return None
    if version == FORMAT and not all(isinstance(name, str) and _inside(name) for name in files):
        return None
    return purpose, version, frozenset(map(str, files))


def _inside(name: str) -> bool:
    """Return whether a name is of a file below the folder, other than the marker."""
    path = PurePosixPath(name)
    plain = path.as_posix() == name and "\\" not in name and "\0" not in name
    return plain and bool(path.parts) and not path.is_absolute() and ".." not in path.parts


def _is_pattern(name: str) -> bool:
    return any(sign in name for sign in "*?[")


def _matches(name: str, pattern: str) -> bool:
    if not _is_pattern(pattern):
        return name == pattern
    return name.count("/") == pattern.count("/") and fnmatchcase(name, pattern)
