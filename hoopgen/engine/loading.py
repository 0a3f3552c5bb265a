"""Loading of a compiled library from checked bytes, even if its file changes.

On Linux the bytes lie in memory and are loaded through /proc; elsewhere they are copied into a
folder of this process. Windows keeps the file of a library that is loaded, so there its own file is
taken, if it has one: it is in the user's profile.
"""

from __future__ import annotations

import contextlib
import itertools
import os
import sys
from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TypeVar

from hoopgen.core.private_folders import private_folder

T = TypeVar("T")

_COUNT = itertools.count(1)


def load(content: bytes, file: Path | None, library: Callable[[Path], T]) -> T:
    """Return `library(path)` for a path from which exactly these bytes are loaded.

    Parameters
    ----------
    content
        Content of the shared library.
    file
        Permanent file of the library, or None.
    library
        Function that loads a library from a path; the path may not exist afterwards.

    Raises
    ------
    OSError
        If it cannot be loaded.
    """
    if sys.platform == "win32" and file is not None:
        return library(file)
    if hasattr(os, "memfd_create") and Path("/proc/self/fd").is_dir():
        with contextlib.suppress(OSError):  # where memory must not be executed, a copy may be
            return _from_memory(content, library)
    with TemporaryDirectory(prefix="hoopgen-", ignore_cleanup_errors=True) as folder:
        copy = private_folder(Path(folder)) / ("engine.dll" if os.name == "nt" else "engine.so")
        copy.write_bytes(content)
        return library(copy)


def _from_memory(content: bytes, library: Callable[[Path], T]) -> T:
    descriptor = os.memfd_create("hoopgen", os.MFD_CLOEXEC)
    try:
        with os.fdopen(descriptor, "wb", closefd=False) as file:
            file.write(content)
        return library(_path_of(descriptor))
    finally:
        os.close(descriptor)


def _path_of(descriptor: int) -> Path:
    """Return a path to an open file that no earlier file had.

    The C library gives for the same path the library that it loaded first, and numbers of
    descriptors come again. So the path makes detours, which spell a number that does not.
    """
    detours = {"0": "/fd/..", "1": "/task/.."}
    spelt = "".join(detours[digit] for digit in f"{next(_COUNT):b}")
    return Path(f"/proc/self{spelt}/fd/{descriptor}")
