"""Locks on folders, one process at a time, and reading of regular files."""

from __future__ import annotations

import contextlib
import errno
import os
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import IO

from .regular_files import NotRegularError, open_regular

if sys.platform == "win32":
    import msvcrt

    def _take(file: IO[bytes]) -> None:
        msvcrt.locking(file.fileno(), msvcrt.LK_NBLCK, 1)

    def _drop(file: IO[bytes], path: Path) -> None:
        file.close()
        path.unlink()  # fails where another has opened it: it stays theirs
else:
    import fcntl

    def _take(file: IO[bytes]) -> None:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)

    def _drop(file: IO[bytes], path: Path) -> None:
        with file:
            path.unlink()  # while it is held: after that it may be another's


LOCK = "hoopgen.lock"
"""Name of the file that is locked."""

_TRIES = 100  # to lock what others remove

_NO_LINK = getattr(os, "O_NOFOLLOW", 0)


def read_file(path: Path) -> bytes:
    """Return the content of a file.

    Raises
    ------
    FileExistsError
        If it is none, but a folder, a pipe, a device or a link without an end.
    OSError
        If it is not there, or cannot be read.
    """
    with _opened(path, os.O_RDONLY, "rb") as file:
        return file.read()


def _opened(path: Path, flags: int, mode: str) -> IO[bytes]:
    """Open a regular file, and nothing else."""
    try:
        return open_regular(path, flags, mode)
    except NotRegularError:
        raise FileExistsError(errno.EEXIST, "this is no file; move it away", str(path)) from None


@contextlib.contextmanager
def held(folder: Path) -> Iterator[None]:
    """Make a folder and lock it; the system releases it however the process ends.

    A folder in which nothing is left at the end is removed.

    Raises
    ------
    RuntimeError
        If another process holds it.
    OSError
        If it cannot be made or written, or is no folder.
    """
    file = _lock(folder)
    try:
        yield
    finally:
        with contextlib.suppress(OSError):
            _drop(file, folder / LOCK)
            folder.rmdir()


def _lock(folder: Path) -> IO[bytes]:
    """Return the locked file of a folder; another process may remove both meanwhile."""
    refused: OSError | None = None
    for _ in range(_TRIES):
        with contextlib.ExitStack() as stack:
            try:
                _make(folder)
                file = stack.enter_context(_lock_file(folder))
            except (FileExistsError, FileNotFoundError) as error:
                refused = error  # or it was there, and is no more
                continue
            try:
                _take(file)
            except (BlockingIOError, PermissionError):
                raise RuntimeError(f"{folder}: another process is at work in this folder") from None
            except OSError as error:
                said = f"this folder cannot be locked ({error.strerror})"
                raise OSError(error.errno, said, str(folder)) from None
            # Else the lock is of a file that nobody will find any more.
            with contextlib.suppress(FileNotFoundError):
                if os.path.samestat(os.fstat(file.fileno()), (folder / LOCK).lstat()):
                    stack.pop_all()
                    return file
            refused = None
    if refused is None:
        raise RuntimeError(f"{folder}: other processes make and remove this folder all the time")
    if isinstance(refused, FileNotFoundError):
        said = f"this folder cannot be made or written ({refused.strerror})"
        raise FileNotFoundError(refused.errno, said, str(folder)) from None
    raise refused


def _make(folder: Path) -> None:
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except FileExistsError as error:
        raise FileExistsError(error.errno, "this is no folder", str(folder)) from None


def _lock_file(folder: Path) -> IO[bytes]:
    # Not where a link leads: there it would make a file, or lock one of somebody else.
    return _opened(folder / LOCK, os.O_RDWR | os.O_CREAT | os.O_APPEND | _NO_LINK, "ab")
