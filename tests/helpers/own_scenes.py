"""Ways in which tests compile scenes of one's own: soonest, or as for users.

No bit depends on it. Clang without optimization takes a third of the time that GCC takes at any
level, and at 16 lanes a scene takes more than twice as long to compile as at one. The code is seven
times slower, but most scenes are compiled for longer than they are flown; the others are optimized.
"""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from functools import wraps
from pathlib import Path
from unittest.mock import patch

import hoopgen
from hoopgen.scene import compilers
from hoopgen.simulation.engine import Engine

FOR_USERS = {
    "processor_lanes": compilers.processor_lanes,
    "compiler": compilers.compiler,
    "FLAGS": compilers.FLAGS,
}
"""The lanes, the compiler and the flags of users."""


@wraps(compilers.processor_lanes)
def one_lane() -> compilers.Lanes:
    """Return a single lane."""
    return compilers.Lanes(1, 1)


BUSY_SOURCES = ("air.c", "court_air.c", "ledge.c")
"""C files of scenes that tests fly for longer than they are compiled."""


class QuickCompiler(compilers.Compiler):
    """A compiler that optimizes only the scenes that tests fly for long."""

    def arguments(self, file: str, options: Sequence[str] = ()) -> list[str]:
        """Return the arguments of a call, as `Compiler.arguments`."""
        return super().arguments(file, [*options, "-O1"] if file in BUSY_SOURCES else options)


@wraps(compilers.compiler)
def quick_compiler() -> compilers.Compiler | None:
    """Return Clang where it is installed, unless ``CC`` names a compiler."""
    clang = shutil.which("clang")
    if clang is not None and not os.environ.get("CC"):
        return QuickCompiler((clang,), Path(clang).resolve())
    found = FOR_USERS["compiler"]()
    return found and QuickCompiler(found.command, found.file)


QUICK = {
    "processor_lanes": one_lane,
    "compiler": quick_compiler,
    "FLAGS": ["-O0", *(flag for flag in compilers.FLAGS if not flag.startswith("-O"))],
}
"""The lanes, the compiler and the flags with which most scenes are compiled soonest."""


def compile_soonest() -> None:
    """From now on compile scenes one lane wide and not optimized."""
    for name, value in QUICK.items():
        setattr(compilers, name, value)


@contextmanager
def compiling_as_for_users() -> Iterator[None]:
    """Compile scenes with the compiler, the flags and the width that users have."""
    with patch.multiple(compilers, **FOR_USERS):
        yield


def compiled_as_for_users(scene: hoopgen.Scene) -> Engine:
    """Compile a scene as for a user.

    Parameters
    ----------
    scene
        A scene whose C engine is compared with something else.
    """
    with compiling_as_for_users():
        return hoopgen.compile(scene)
