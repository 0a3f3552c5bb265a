"""Atomic writing of files, and checks of their paths before the work."""

from __future__ import annotations

import contextlib
import errno
import io
import os
import secrets
import sys
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import IO

from hoopgen.text.shorten import brief

PICTURES, PAGES, MAPS = (".png", ".svg", ".pdf"), (".html", ".htm"), (".nc", ".csv")
FILMS = (".gif", ".mp4")
"""Suffixes of the names of such files."""

_DEVICES = ("/dev/", "/proc/")
"""Names here stand for what is open already, such as /dev/stdout, also where that is a file."""


def check_output(path: str | os.PathLike[str], suffixes: Sequence[str] = ()) -> Path:
    """Check the path of a file before the work, as far as is possible.

    Parameters
    ----------
    path
        The file.
    suffixes
        In one of which its name must end, ".csv"; none: in anything.

    Raises
    ------
    ValueError
        If its name ends in something else.
    OSError
        If it is a folder, its folder is not there, or it may not be written.
    """
    target = Path(path)
    if suffixes and target.suffix.lower() not in suffixes:
        raise ValueError(f"{brief(target.name)} ends in none of {', '.join(suffixes)}")
    if target.is_dir():
        raise _access_error(errno.EISDIR, target)
    folder = resolve_link(target).parent
    if not _is_special(target):
        if not folder.is_dir():
            raise _access_error(errno.ENOENT, folder)
        if not os.access(folder, os.W_OK | os.X_OK):
            raise _access_error(errno.EACCES, folder)
    if target.exists() and not os.access(target, os.W_OK):
        raise _access_error(errno.EACCES, target)
    return target


def same_file(one: str | os.PathLike[str], other: str | os.PathLike[str]) -> bool:
    """Return whether two paths lead to one file, also by links; a terminal or pipe is no file.

    Parameters
    ----------
    one, other
        The two paths, which need not exist.
    """
    first, second = Path(one), Path(other)
    try:
        if first.exists() and second.exists():
            return first.is_file() and first.samefile(second)
    except OSError:
        return False
    return os.path.realpath(first) == os.path.realpath(second)


def check_not_read(name: str, target: Path, what: str, read: Iterable[Path]) -> None:
    """Raise an error if the output is a file that the same work reads.

    Parameters
    ----------
    name
        Of the argument that names the file to be written.
    target
        That file.
    what
        What reads files, for the message: "the study".
    read
        The files that it reads.

    Raises
    ------
    ValueError
        If it is one of them.
    """
    if any(same_file(target, one) for one in read):
        raise ValueError(f"{name}: {target} is a file that {what} reads; give another file")


def check_folder(path: str | os.PathLike[str]) -> Path:
    """Check that a folder exists or can be made, as far as is possible.

    Raises
    ------
    OSError
        If it or what it lies in is no folder, or may not be written.
    """
    target = Path(path)
    there = next(one for one in (target, *target.absolute().parents) if one.exists())
    if not there.is_dir():
        raise _access_error(errno.ENOTDIR, there)
    if not os.access(there, os.W_OK | os.X_OK):
        raise _access_error(errno.EACCES, there)
    return target


def _access_error(number: int, path: Path) -> OSError:
    return OSError(number, os.strerror(number), str(path))


@contextlib.contextmanager
def atomic_file(path: str | os.PathLike[str], temporary: Path | None = None) -> Iterator[IO[bytes]]:
    """Open a file that appears completely or not at all, also after a loss of power.

    It is written beside and moved: until it is whole, what was there before stays. A file that was
    there keeps its permissions; a link stays and the file that it leads to is written. What is no
    file, such as a pipe or /dev/stdout, is written as it is.

    Parameters
    ----------
    path
        The file.
    temporary
        Its name until it is whole, on the same file system; by default one of its own. It is moved
        to the place of whatever is there, links and pipes too.

    Raises
    ------
    OSError
        If it cannot be written. Nothing is left then, and what was there before stays.
    """
    target = Path(path)
    if temporary is None and _is_special(target):
        with _name_file_in_errors(target), target.open("wb") as file:
            yield file
        return
    place = target if temporary else resolve_link(target)
    part = temporary or temporary_beside(place)
    try:
        with _name_file_in_errors(target, part):
            with part.open("wb") as file:
                _copy_ownership(place, part)
                yield file
                file.flush()
                os.fsync(file.fileno())
            part.replace(place)
            sync({place.parent, part.parent})
    finally:
        with contextlib.suppress(OSError):  # that of writing is the one to be told
            part.unlink()


@contextlib.contextmanager
def atomic_text_file(path: str | os.PathLike[str]) -> Iterator[IO[str]]:
    """Open a text file as `atomic_file` does: UTF-8, with line ends as given."""
    with atomic_file(path) as file:
        text = io.TextIOWrapper(file, encoding="utf-8", newline="")
        yield text
        text.flush()
        text.detach()


def write(path: str | os.PathLike[str], content: str | bytes) -> Path:
    """Write a whole file as `atomic_file` does, text in UTF-8; return its path.

    Parameters
    ----------
    path
        The file to write or replace.
    content
        The whole content.
    """
    with atomic_file(path) as file:
        file.write(content.encode() if isinstance(content, str) else content)
    return Path(path)


def temporary_beside(path: Path) -> Path:
    """Return an unused name in the same folder, for a file until it is complete."""
    return path.with_name(f".hoopgen-{secrets.token_hex(8)}.tmp")


def resolve_link(path: Path) -> Path:
    """Return the target of a link; any other path unchanged."""
    return Path(os.path.realpath(path)) if path.is_symlink() else path


def _is_special(path: Path) -> bool:
    """Return whether a path is a device or pipe, which no finished file can replace."""
    return path.absolute().as_posix().startswith(_DEVICES) or (path.exists() and not path.is_file())


def _copy_ownership(there: Path, part: Path) -> None:
    """Copy owner and permissions of the replaced file to the new one, as far as allowed."""
    with contextlib.suppress(OSError):
        before = there.stat()
        if sys.platform != "win32":
            os.chown(part, before.st_uid, before.st_gid)
        part.chmod(before.st_mode & 0o7777)


@contextlib.contextmanager
def _name_file_in_errors(target: Path, part: Path | None = None) -> Iterator[None]:
    """Name the target in errors of writing it, which the system does not."""
    try:
        yield
    except OSError as error:
        if error.filename not in (None, str(part)) or isinstance(error, ConnectionError):
            raise  # of something else
        said = os.strerror(error.errno) if error.errno else str(error)
        raise OSError(error.errno, said, str(target)) from error


def sync(folders: Iterable[Path]) -> None:
    """Flush folders, so that new names last; only POSIX systems can open a folder."""
    if sys.platform == "win32":
        return
    for folder in folders:
        descriptor = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(descriptor)
        finally:
            os.close(descriptor)
