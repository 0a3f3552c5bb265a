"""The C compiler of this machine, with the flags of hoopgen's own build."""

from __future__ import annotations

import os
import shlex
import shutil
import subprocess
import sys
import sysconfig
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache, partial
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path

import numpy as np

from hoopgen.engine import c_build
from hoopgen.text.shorten import brief

FLAGS = ["-O1", *(flag for flag in c_build.FLAGS if not flag.startswith("-O"))]
"""The hoop's flags with less optimization: the hoop's give code that is 2% faster, and take two to
four times as long to make."""


@dataclass(frozen=True)
class Lanes:
    """The vectors of a compiled scene.

    Attributes
    ----------
    width
        Shots abreast.
    vectors
        Native vectors of a value, if there is more than one lane.
    """

    width: int
    vectors: int

    def options(self, scene: str) -> list[str]:
        """Return the compiler's options, for a scene of that name."""
        prefix = f"-D{scene.upper()}"
        return [f"{prefix}_ONLY={self.width}", f"{prefix}_VECTORS={self.vectors}"]


def loop_option(scene: str, *, bounds: bool) -> str:
    """Return the compiler's option for one of the event loops alone.

    Parameters
    ----------
    scene
        The name of the scene.
    bounds
        Whether it is the loop with bounds on errors.
    """
    return f"-D{scene.upper()}_{'PLAIN' if bounds else 'BOUNDED'}=0"


_LANES_BY_FEATURES = {("AVX512F", "AVX512DQ", "AVX512VL"): Lanes(8, 1), ("AVX2",): Lanes(4, 1)}
"""Lanes by the processor features that they need, the widest first.

With one native vector to a value a scene of one's own is compiled in 0.4 to 0.6 of the time that
two take (docs/performance.md)."""

_TRANSIENT_ERRORS = (
    "Killed",
    "No space left",
    "annot allocate memory",
    "out of memory",
    "Terminated",
)
"""Words in the output of a compiler that was stopped from outside."""


def available_lanes() -> list[Lanes]:
    """Return the lanes for which scenes can be compiled on this processor, the widest first."""
    core = "numpy._core" if hasattr(np, "_core") else "numpy.core"  # before NumPy 2
    features = import_module(f"{core}._multiarray_umath").__cpu_features__
    found = [
        lanes for needed, lanes in _LANES_BY_FEATURES.items() if all(map(features.get, needed))
    ]
    return [*found, Lanes(4, 2)]


def processor_lanes() -> Lanes:
    """Return the widest lanes for which scenes can be compiled on this processor."""
    return available_lanes()[0]


def library_name() -> str:
    """Return the file name of a compiled scene."""
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
        """The compiler's name."""
        return "ziglang" if "ziglang" in self.command else Path(self.command[0]).name

    @property
    def identity(self) -> str:
        """The file with its time and size, known without running it."""
        try:
            status = self.file.stat()
        except OSError:
            return f"{self.command}"
        return f"{self.command} {self.file} {status.st_size} {status.st_mtime_ns}"

    def version(self) -> str:
        """Return the compiler's own version text, "" if it does not run."""
        asked = [*self.command, "--version"]
        try:
            told = subprocess.run(
                asked, stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False
            )
        except OSError:
            return ""
        return told.stdout.strip() if told.returncode == 0 else ""

    def arguments(self, file: str, options: Sequence[str] = ()) -> list[str]:
        """Return the arguments of a call in the folder of the sources.

        Parameters
        ----------
        file
            The C file that is compiled.
        options
            Options beside hoopgen's flags.
        """
        by_place = [] if sys.platform == "win32" else ["-fPIC"]
        mathematics = [] if sys.platform == "win32" else ["-lm"]
        files = [file, "-o", library_name()]
        return [*self.command, *FLAGS, "-w", *by_place, *options, "-shared", *files, *mathematics]

    def run(self, folder: Path, file: str, options: Sequence[str] = ()) -> tuple[str, bool]:
        """Compile a file in a folder, as `running`; return the same as its function does."""
        with self.running(folder, file, options) as result:
            return result()

    @contextmanager
    def running(
        self, folder: Path, file: str, options: Sequence[str] = ()
    ) -> Iterator[Callable[[], tuple[str, bool]]]:
        """Compile a file in a folder while other work is done; the library lies beside it.

        The compiler ends with the context at the latest.

        Parameters
        ----------
        folder
            The folder of the sources.
        file, options
            As for `arguments`.

        Yields
        ------
        Callable
            A function that waits for the compiler. It returns the compiler's words where it fails,
            "" where it does not; and whether that may pass.
        """
        # Its own temporary files go with the folder, should it be killed.
        environment = os.environ | {"TMPDIR": str(folder), "LC_ALL": "C"}
        try:
            process = subprocess.Popen(
                self.arguments(file, options),
                cwd=folder,
                env=environment,
                stdin=subprocess.DEVNULL,
                stdout=subprocess.PIPE,
                stderr=subprocess.PIPE,
                text=True,
                errors="replace",
            )
        except OSError as error:
            said = str(error)
            yield lambda: (said, True)
            return
        with process:
            try:
                yield partial(_result, process, folder)
            finally:
                process.kill()  # nothing, if it has ended


def _result(process: subprocess.Popen[str], folder: Path) -> tuple[str, bool]:
    """Wait for a compiler; return its words and whether they may pass, as `Compiler.running`."""
    output, errors = process.communicate()
    if process.returncode == 0 and (folder / library_name()).is_file():
        return "", False
    words = (errors + output).strip() or f"it ended with {process.returncode}"
    return words, process.returncode < 0 or any(sign in words for sign in _TRANSIENT_ERRORS)


def compiler() -> Compiler | None:
    """Return the compiler of this machine, that of ``CC`` if it is set; None without one.

    Raises
    ------
    ValueError
        If ``CC`` is no command, such as one with a quotation mark that is not closed.
    """
    return _compiler(os.environ.get("CC", ""), os.environ.get("PATH", ""))


def missing_compiler() -> str:
    """Return the sentence that says that there is no compiler."""
    named = os.environ.get("CC", "")
    found = "no C compiler was found"
    return f"{found}, as the environment variable CC is {brief(named)}" if named else found


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
