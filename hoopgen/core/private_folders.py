"""Folders that only this user can change, from which libraries may be loaded.

A folder is only as safe as those above it: who can write one of them can put another folder in its
place. So each component of the path is opened relative to the one before, without following links,
and its owner and mode are read from the open descriptor.
"""

from __future__ import annotations

import contextlib
import errno
import os
import stat
from pathlib import Path

_OPEN_FLAGS = (
    getattr(os, "O_PATH", getattr(os, "O_SEARCH", os.O_RDONLY))
    | getattr(os, "O_DIRECTORY", 0)
    | getattr(os, "O_NOFOLLOW", 0)
    | getattr(os, "O_CLOEXEC", 0)
)
_WRITABLE = stat.S_IWGRP | stat.S_IWOTH


def private_folder(path: Path) -> Path:
    """Return a folder that no other user can change; make it if it does not exist.

    It is owned by this user. It and all folders above it are owned by this user or the system's
    administrator, and nobody else can write them, unless they are sticky, as /tmp is: there nobody
    else can move what belongs to this user. On Windows, where folders have no such modes, the
    profile of a user is private anyway, and the folder is only made.

    Parameters
    ----------
    path
        The folder; links in it are followed once, and then stand for what they led to.

    Returns
    -------
    Path
        The folder without links.

    Raises
    ------
    OSError
        If it is not such a folder, or cannot be made: why, and what to do.
    """
    real = Path(os.path.realpath(path))
    if os.name == "nt":
        real.mkdir(parents=True, exist_ok=True)
        return real
    place = Path(real.anchor)
    descriptor = os.open(place, _OPEN_FLAGS)
    try:
        for name in real.parts[1:]:
            _check(place, os.fstat(descriptor), last=False)
            place /= name
            below = _open_below(name, descriptor, place)
            os.close(descriptor)
            descriptor = below
        _check(place, os.fstat(descriptor), last=True)
    finally:
        os.close(descriptor)
    return real


def _open_below(name: str, descriptor: int, place: Path) -> int:
    """Open a folder below an open one; make it if it does not exist."""
    try:
        try:
            return os.open(name, _OPEN_FLAGS, dir_fd=descriptor)
        except FileNotFoundError:
            with contextlib.suppress(FileExistsError):  # another process may make it meanwhile
                os.mkdir(name, 0o700, dir_fd=descriptor)
            return os.open(name, _OPEN_FLAGS, dir_fd=descriptor)
    except OSError as error:
        raise OSError(error.errno, error.strerror, str(place)) from None


def _check(place: Path, status: os.stat_result, last: bool) -> None:
    """Raise an error if another user can change a folder; parents may be sticky."""
    if status.st_uid != os.getuid() and (last or status.st_uid != 0):
        raise PermissionError(errno.EPERM, "this folder is another user's", str(place))
    if status.st_mode & _WRITABLE and (last or not status.st_mode & stat.S_ISVTX):
        said = "other users can write this folder; take that right from them (chmod go-w)"
        raise PermissionError(errno.EPERM, said, str(place))
