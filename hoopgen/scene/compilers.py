"""The C compiler that is here, and how it is called: the flags are those of hoopgen's own build."""

from __future__ import annotations

import os
import shlex
import shutil
import subprocess
import sys
import sysconfig
from dataclasses import dataclass
from functools import cache
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path

import numpy as np

from hoopgen.brief import brief
from hoopgen.engine import sources

FLAGS = ["-O1", *(flag for flag in sources.FLAGS if not flag.startswith("-O"))]
"""As the hoop's, but for how long the compiler tries: its results are two in a hundred faster, and
take two to four times as long to make."""

__all__ = ["Compiler", "compiler", "library_name", "processor_width"]

_NEEDS = {16: ("AVX512F", "AVX512DQ", "AVX512VL"), 8: ("AVX2",)}
"""What a processor has that runs so many lanes."""

_PASSING = ("Killed", "No space left", "annot allocate memory", "out of memory", "Terminated")
"""In the words of a compiler that did not fail by itself."""


def processor_width() -> int:
    """Return how many lanes this processor runs at most."""
    core = "numpy._core" if hasattr(np, "_core") else "numpy.core"  # before NumPy 2
    features = import_module(f"{core}._multiarray_umath").__cpu_features__
    widths = (width for width, needs in _NEEDS.items() if all(map(features.get, needs)))
    return next(widths, 4)


def library_name() -> str:
    """Return the name of a compiled scene."""
    return "engine.dll" if sys.platform == "win32" else "engine.so"


@dataclass(frozen=True)
class Compiler:
    """A C compiler.

    Attributes
    ----------
    command
        With which it is called.
    file
        That is run, or that it comes with.
    """

    command: tuple[str, ...]
    file: Path

    @property
    def name(self) -> str:
        """What it is called."""
        return "ziglang" if "ziglang" in self.command else Path(self.command[0]).name

    @property
    def identity(self) -> str:
        """Its file, when and how large that was: known without running it."""
        try:
            status = self.file.stat()
        except OSError:
            return f"{self.command}"
        return f"{self.command} {self.file} {status.st_size} {status.st_mtime_ns}"

    def version(self) -> str:
        """Return what it says of itself, "" if it does not run."""
        asked = [*self.command, "--version"]
        try:
            told = subprocess.run(
                asked, stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False
            )
        except OSError:
            return ""
        return told.stdout.strip() if told.returncode == 0 else ""

    def arguments(self, scene: str, width: int) -> list[str]:
        """Return what it is called with, in the folder of the sources."""
        by_place = [] if sys.platform == "win32" else ["-fPIC"]
        mathematics = [] if sys.platform == "win32" else ["-lm"]
        only = f"-D{scene.upper()}_ONLY={width}"
        files = [f"{scene}.c", "-o", library_name()]
        return [*self.command, *FLAGS, "-w", *by_place, only, "-shared", *files, *mathematics]

    def run(self, folder: Path, scene: str, width: int) -> tuple[str, bool]:
        """Compile a scene whose sources are in a folder, where the library then is.

        Returns
        -------
        tuple
            Its words where it fails, "" where it does not; and whether that may pass.
        """
        # Its own temporary files go with the folder, should it be killed.
        environment = os.environ | {"TMPDIR": str(folder), "LC_ALL": "C"}
        try:
            told = subprocess.run(
                self.arguments(scene, width),
                cwd=folder,
                env=environment,
                stdin=subprocess.DEVNULL,
                capture_output=True,
                text=True,
                errors="replace",
                check=False,
            )
        except OSError as error:
            return str(error), True
        if told.returncode == 0 and (folder / library_name()).is_file():
            return "", False
        words = (told.stderr + told.stdout).strip() or f"it ended with {told.returncode}"
        return words, told.returncode < 0 or any(sign in words for sign in _PASSING)


def compiler() -> Compiler | None:
    """Return the compiler that is here: that of ``CC``, where it is set; None if there is none.

    Raises
    ------
    ValueError
        If ``CC`` is no command, such as one with a quotation mark that is not closed.
    """
    return _compiler(os.environ.get("CC", ""), os.environ.get("PATH", ""))


def _words(named: str) -> list[str]:
    """Return the words of ``CC``."""
    try:
        return shlex.split(named)
    except ValueError as error:
        said = str(error).rstrip(".").lower()
        raise ValueError(
            f"the environment variable CC is {brief(named)}, which is no command ({said}); "
            "expected the name of a C compiler and its options, such as CC=gcc, or no CC"
        ) from None


@cache
def _compiler(named: str, path: str) -> Compiler | None:
    usual = (sysconfig.get_config_var("CC") or "", "cc", "gcc", "clang")
    for command in [_words(named)] if named else map(shlex.split, usual):
        file = shutil.which(command[0], path=path) if command else None
        if file is not None:
            return Compiler((file, *command[1:]), Path(file).resolve())
    there = find_spec("ziglang") if not named else None
    if there is not None and there.origin is not None:
        zig = (sys.executable, "-m", "ziglang", "cc", "-mcpu=baseline")
        return Compiler(zig, Path(there.origin))
    return None
