"""The C engines of the two hoops as WebAssembly, for pages: how they are compiled, and from what.

Each module has the engine of its scene and the drawing of releases, both as they run in Python.

The modules are committed in generated/wasm/, so that who has no compiler can make a page. Each
contains a digest of the sources, the options and the compiler that it was made with: with others
it is stale, and is not used.
"""

from __future__ import annotations

import hashlib
import os
import subprocess
import sys
from collections.abc import Iterable, Mapping
from importlib.resources import files
from pathlib import Path
from tempfile import TemporaryDirectory
from types import MappingProxyType

from hoopgen.core.extras import MissingExtra, require
from hoopgen.core.files import write

from . import c_build

ZIG = "0.17.1"
"""The version of zig: another one gives other bytes, of the same results. The extra `compile` has
it, and with another version every module is stale."""

MODULES: Mapping[str, tuple[str, int]] = MappingProxyType(
    {
        "hoop.wasm": ("hoop", 1),
        "hoop_simd.wasm": ("hoop", 4),
        "court.wasm": ("court", 1),
        "court_simd.wasm": ("court", 4),
    }
)
"""Scene and lanes of each file. Four lanes are in vectors of 128 bits. Relaxed vectors are off: how
they round is the processor's choice."""

_OPTIONS = ("-target", "wasm32-wasi", *c_build.FLAGS, "-w", "-mexec-model=reactor")
_OPTIONS += ("-Wl,--no-entry", "-Wl,--strip-all")

_VECTORS = {1: (), 4: ("-msimd128",)}
"""Further options, by the number of lanes."""


def _libraries(scene: str) -> tuple[str, ...]:
    """Return the engine, and the library that draws releases."""
    return scene, "elementary"


def _options(name: str) -> tuple[str, ...]:
    """Return the compiler's options for a module, but for the digest."""
    scene, lanes = MODULES[name]
    drawing = ("elementary_noise", "elementary_release_states")
    exported = (f"{scene}_simulate", *drawing, "malloc", "free", f"{scene}_sources")
    return (
        *_OPTIONS,
        *(f"-Wl,--export={function}" for function in exported),
        f"-D{scene.upper()}_ONLY={lanes}",
        *_VECTORS[lanes],
    )


def _digest(folder: Path, name: str) -> str:
    """Return the digest of all that a module depends on, a C identifier."""
    made_of = (
        *(c_build.source_digest(folder / "c", library) for library in _libraries(MODULES[name][0])),
        _options(name),
        ZIG,
    )
    return f"w{hashlib.sha256(repr(made_of).encode()).hexdigest()}"


def _is_current(folder: Path, name: str) -> bool:
    file = folder / "wasm" / name
    return file.is_file() and _digest(folder, name).encode() in file.read_bytes()


def stale_modules(folder: Path) -> list[str]:
    """Return the names of the modules that are missing, or of other sources than those beside them.

    Parameters
    ----------
    folder
        The folder generated/. Without C sources no module is missing.
    """
    there = (n for n, (scene, _) in MODULES.items() if (folder / "c" / f"{scene}.c").is_file())
    return [name for name in there if not _is_current(folder, name)]


def module_bytes(name: str) -> bytes:
    """Return a module of the installation.

    Parameters
    ----------
    name
        A key of `MODULES`.

    Raises
    ------
    RuntimeError
        If it is missing, or of other sources than those installed.
    """
    folder = Path(str(files("hoopgen.generated")))
    if not _is_current(folder, name):
        raise RuntimeError(
            f"generated/wasm/{name} is missing, or of other sources than generated/c: "
            "`hoopgen generate` in the checkout compiles it"
        )
    return (folder / "wasm" / name).read_bytes()


def build(folder: Path, names: list[str]) -> list[Path]:
    """Compile modules and return their files.

    Parameters
    ----------
    folder
        The folder generated/.
    names
        Keys of `MODULES`.

    Raises
    ------
    ImportError
        If zig is not installed.
    RuntimeError
        If it is another version, or fails.
    """
    if not names:
        return []
    check_compiler()
    return [_compiled(folder, name) for name in names]


def check_compiler() -> None:
    """Refuse to go on without the zig that compiles the modules.

    Raises
    ------
    ImportError
        If zig is not installed.
    RuntimeError
        If it is another version.
    """
    try:
        require("ziglang", "compiling generated/wasm")
    except MissingExtra as error:
        raise MissingExtra(
            f"compiling generated/wasm needs zig {ZIG}: pip install ziglang=={ZIG}", name=error.name
        ) from None
    version = _run(*_COMPILER, "version").strip()
    if version != ZIG:
        raise RuntimeError(
            f"compiling generated/wasm needs zig {ZIG}, and zig {version} gives other bytes: "
            f"pip install ziglang=={ZIG}"
        )


def check_before_writing(folder: Path, changed: Iterable[str]) -> None:
    """Refuse changes of C sources, all of them the modules', without the zig that compiles these.

    Parameters
    ----------
    folder
        The folder generated/.
    changed
        Files that will be written, by their paths below it.

    Raises
    ------
    ImportError, RuntimeError
        As for `check_compiler`.
    """
    if stale_modules(folder) or any(name.startswith("c/") for name in changed):
        check_compiler()


_COMPILER = (sys.executable, "-m", "ziglang")


def _compiled(folder: Path, name: str) -> Path:
    """Compile a module beside, and put it in its place."""
    scene, _ = MODULES[name]
    sources = f"-D{scene.upper()}_SOURCES={_digest(folder, name)}"
    with TemporaryDirectory() as place:
        out = Path(place) / name
        files = [f"{library}.c" for library in _libraries(scene)]
        _run(*_COMPILER, "cc", *_options(name), sources, *files, "-o", str(out), cwd=folder / "c")
        target = folder / "wasm" / name
        target.parent.mkdir(exist_ok=True)
        return write(target, out.read_bytes())


def _run(*command: str, cwd: Path | None = None) -> str:
    done = subprocess.run(
        command,
        cwd=cwd,
        env=os.environ | {"LC_ALL": "C"},
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        errors="replace",
        check=False,
    )
    if done.returncode:
        raise RuntimeError(f"zig failed: {(done.stderr or done.stdout).strip()[-2000:]}")
    return done.stdout
