"""Reading of regular files only, up to a size."""

from __future__ import annotations

import errno
import os
import stat
from pathlib import Path
from typing import IO

# A pipe is not waited for; Windows has neither, but does something to the ends of lines.
_OPEN_FLAGS = getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0)

_NO_FILE = (errno.ELOOP, errno.EISDIR, errno.ENXIO)
"""Error numbers of the system for links, folders and sockets in place of a file."""

_KINDS = {
    stat.S_IFDIR: "a folder",
    stat.S_IFIFO: "a pipe",
    stat.S_IFSOCK: "a socket",
    stat.S_IFCHR: "a device",
    stat.S_IFBLK: "a device",
    stat.S_IFLNK: "a link without an end",
}


class NotRegularError(OSError):
    """An error: a path leads to a pipe, device, folder or socket instead of a file."""


class FileSizeError(ValueError):
    """An error: a file is larger than the limit.

    Attributes
    ----------
    size
        Of the file, bytes.
    """

    def __init__(self, path: Path, size: int, max_size: int) -> None:
        self.size = size
        super().__init__(f"{path}: expected at most {max_size:,} bytes, got {size:,}")


def open_regular(path: Path, flags: int = os.O_RDONLY, mode: str = "rb") -> IO[bytes]:
    """Open a regular file and nothing else, without waiting for a pipe.

    Parameters
    ----------
    path
        The file, or a link that leads to one.
    flags, mode
        As of `os.open` and of `open`.

    Raises
    ------
    NotRegularError
        If it is a folder, a pipe, a device, a socket or a link without an end.
    OSError
        If it is not there, or cannot be opened.
    """
    try:
        descriptor = os.open(path, flags | _OPEN_FLAGS, 0o666)
    except OSError as error:
        if error.errno in _NO_FILE:
            raise _not_regular(path, _mode(path)) from None
        raise
    found = os.fstat(descriptor).st_mode
    if not stat.S_ISREG(found):
        os.close(descriptor)
        raise _not_regular(path, found)
    file: IO[bytes] = os.fdopen(descriptor, mode)
    return file


def read_regular(path: Path, max_size: int) -> bytes:
    """Return the content of a regular file.

    Parameters
    ----------
    path
        The file, or a link that leads to one.
    max_size
        The largest size that is read, bytes.

    Raises
    ------
    NotRegularError
        As of `open_regular`.
    OSError
        If it is not there, or cannot be read.
    FileSizeError
        If it is larger than `max_size`; the message names the file and both sizes.
    """
    with open_regular(path) as file:
        content = file.read(max_size + 1)
        if len(content) > max_size:
            size = max(os.fstat(file.fileno()).st_size, len(content))
            raise FileSizeError(path, size, max_size)
    return content


def _mode(path: Path) -> int:
    try:
        return path.lstat().st_mode
    except OSError:
        return 0


def _not_regular(path: Path, mode: int) -> NotRegularError:
    kind = _KINDS.get(stat.S_IFMT(mode), "something else")
    return NotRegularError(errno.EINVAL, f"expected a regular file, found {kind}", str(path))
