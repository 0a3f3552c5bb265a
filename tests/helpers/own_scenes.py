"""Ways in which tests compile scenes of one's own: one lane wide, as for users, or soonest.

No bit depends on it. Clang without optimization takes a third of the time that GCC takes at any
level, but its code is seven times slower: that is for tests that compile much and fly little.
"""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from functools import wraps
from pathlib import Path
from unittest.mock import patch

import hoopgen
from hoopgen.scene import compilers
from hoopgen.simulation.engine import Engine

FOR_USERS = {
    "processor_width": compilers.processor_width,
    "compiler": compilers.compiler,
    "FLAGS": compilers.FLAGS,
}
"""The width, the compiler and the flags of users."""


@wraps(compilers.processor_width)
def one_lane() -> int:
    """Return the least width."""
    return 1


@wraps(compilers.compiler)
def quick_compiler() -> compilers.Compiler | None:
    """Return Clang where it is installed, unless ``CC`` names a compiler."""
    clang = shutil.which("clang")
    if os.environ.get("CC") or clang is None:
        return FOR_USERS["compiler"]()
    return compilers.Compiler((clang,), Path(clang).resolve())


QUICK = {
    "processor_width": one_lane,
    "compiler": quick_compiler,
    "FLAGS": ["-O0", *(flag for flag in compilers.FLAGS if not flag.startswith("-O"))],
}
"""The width, the compiler and the flags with which a scene is compiled soonest."""


@contextmanager
def compiling_soonest() -> Iterator[None]:
    """Compile scenes one lane wide and not optimized."""
    with patch.multiple(compilers, **QUICK):
        yield


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
