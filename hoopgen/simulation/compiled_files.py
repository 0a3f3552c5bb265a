"""The files of a scene: its printed sources, compiled and compared with NumPy.

The loop with bounds on errors is compiled at once, in less than two thirds of the time of both. It
serves every call. The loop without bounds, which is up to twice as fast, is compiled once so many
shots have asked for no bounds that it pays (`without_bounds`).
"""

from __future__ import annotations

import builtins
import gzip
import importlib.util
import json
import marshal
import shutil
import sys
from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path
from sysconfig import get_platform
from types import ModuleType
from typing import Any

import numpy as np

from hoopgen.engine import native, verification
from hoopgen.engine.loading import load
from hoopgen.scene import compilers
from hoopgen.scene.cache import MODULE, SOURCES, Entry, SceneStore, digest, process_store
from hoopgen.scene.trial_shots import trial_batches
from hoopgen.text.escape import printable

from .printed_scenes import Printed

WHEEL = "wheel"
"""The compiler on record of a library that came with hoopgen, which has both loops."""

_MAX_MESSAGE_LINES = 20
"""Most lines of a compiler's words."""


class Tools:
    """The compiler, its flags and the lanes with which scenes are compiled."""

    def __init__(self) -> None:
        self.compiler = compilers.compiler()
        self.lanes = compilers.processor_lanes()

    @property
    def identity(self) -> str:
        """The identity that is known without running the compiler."""
        return self._toolchain(self.compiler.identity if self.compiler else "none")

    @property
    def whole(self) -> str:
        """The identity with the compiler's version."""
        from hoopgen.core.extras import version  # reads metadata, which takes its time

        compiler = self.compiler
        called = f"{compiler.command} {compiler.version()}" if compiler else "none"
        return f"{self._toolchain(called)}, hoopgen {version()}"

    def _toolchain(self, compiler: str) -> str:
        python = importlib.util.MAGIC_NUMBER.hex()
        versions = f"NumPy {np.__version__}, Python {python}"
        return f"{compiler}; {compilers.FLAGS}; {self.lanes}, {get_platform()}; {versions}"


def build_entry(printed: Printed, tools: Tools, there: SceneStore) -> Entry:
    """Return the entry of a printed scene, which is built unless it is there.

    Parameters
    ----------
    printed
        The scene.
    tools
        With which it is compiled.
    there
        Where it is kept.
    """
    made_of: list[Any] = [printed.files, tools.whole]
    if printed.library is not None:
        made_of.append(digest(printed.library))
    key = digest(json.dumps(made_of, sort_keys=True).encode())
    build = partial(_build, key, printed, tools)
    return there.entry(key) or built_entry(key, build, there)


def built_entry(key: str, build: Callable[[Path | str], Entry], there: SceneStore) -> Entry:
    """Return the entry of a key, built for this process alone where it cannot be kept.

    Parameters
    ----------
    key
        The key.
    build
        As for `SceneStore.built`; it is given why there is no folder, where there can be none.
    there
        Where it is kept.
    """
    try:
        return there.built(key, build)
    except OSError as error:
        why = _explain(error)
    try:
        return process_store(why).built(key, build)
    except OSError as error:
        return build(_explain(error))


def _explain(error: OSError) -> str:
    said = error.strerror or str(error)
    return f"{error.filename}: {said}" if error.filename else said


def _build(key: str, printed: Printed, tools: Tools, folder: Path | str) -> Entry:
    """Return the entry of a scene, compiled in a folder; without C if that fails, with the reason.

    A library that came with hoopgen is taken as it is, if it gives NumPy's results.

    Parameters
    ----------
    folder
        An empty one that nobody else can change; or why there is no such folder.
    """
    scene, files = printed.scene, printed.files
    record: dict[str, Any] = {"key": key, "scene": scene, "refused": None}

    def kernels_and_files() -> tuple[ModuleType, dict[str, bytes]]:
        code = _compile_source(files[f"numpy/{scene}.py"], scene)
        packed = gzip.compress(json.dumps(files).encode(), 6, mtime=0)
        return load_module(code, scene), {MODULE: marshal.dumps(code), SOURCES: packed}

    if printed.library is not None:
        kernels, made = kernels_and_files()
        refused, width = _check(printed.library, kernels, _expected(kernels))
        if not refused:
            record |= {"compiler": WHEEL, "width": width}
            return Entry(record, made | {compilers.library_name(): printed.library})
    without = record | {"compiler": "", "width": 0}
    if tools.compiler is None:
        why = f"of the scene {scene} was not compiled: {compilers.missing_compiler()}"
        refusal = [why, "install one, or `pip install ziglang`"]
        return Entry(without | {"refused": refusal}, kernels_and_files()[1])
    if isinstance(folder, str):
        why = f"of the scene {scene} was not compiled: {folder}"
        remedy = "set TMPDIR to a folder that you alone can write"
        return Entry(without | {"refused": [why, remedy]}, kernels_and_files()[1])
    return compile_loop(record, files, kernels_and_files, tools, folder, bounds=True)


def compile_loop(
    record: Mapping[str, Any],
    files: Mapping[str, str],
    meanwhile: Callable[[], tuple[ModuleType, dict[str, bytes]]],
    tools: Tools,
    folder: Path,
    *,
    bounds: bool,
) -> Entry:
    """Return an entry with one of a scene's loops, compiled in a folder, or why there is none.

    Parameters
    ----------
    record
        What is known of the entry.
    files
        What was printed, by path.
    meanwhile
        Returns the scene's NumPy module, and the entry's files but for the library; called while
        the compiler works.
    tools
        With which it is compiled.
    folder
        An empty one that nobody else can change.
    bounds
        Whether it is the loop with bounds on errors.
    """
    scene, compiler = record["scene"], tools.compiler
    assert compiler is not None
    record = {**record, "compiler": compiler.name, "width": tools.lanes.width}
    sources = folder / "c"
    sources.mkdir()
    try:
        for name, content in files.items():
            if name.startswith("c/"):
                (folder / name).write_text(content, encoding="utf-8")
        options = [*tools.lanes.options(scene), compilers.loop_option(scene, bounds=bounds)]
        with compiler.running(sources, f"{scene}.c", options) as result:
            kernels, made = meanwhile()
            wanted = _expected(kernels, bounds=bounds)
            words, passing = result()
        if words:
            print(_compiler_message(compiler.name, scene, words), file=sys.stderr)
            reason = f"of the scene {scene} could not be compiled by {compiler.name}"
            remedy = "`hoopgen cache --clear` lets it be tried again"
            return Entry({**record, "refused": [reason, remedy], "passing": passing}, made)
        library = (sources / compilers.library_name()).read_bytes()
        refused, _ = _check(library, kernels, wanted)
    finally:
        shutil.rmtree(sources)
    if refused:
        record["refused"] = [f"of the scene {scene} {refused}", "report it, with the scene"]
        return Entry(record, made)
    return Entry(record, {**made, compilers.library_name(): library})


def _compiler_message(compiler: str, scene: str, words: str) -> str:
    lines = words.splitlines()
    more = (
        [f"... and {len(lines) - _MAX_MESSAGE_LINES} lines more"]
        if len(lines) > _MAX_MESSAGE_LINES
        else []
    )
    said = "\n".join(["", *lines[:_MAX_MESSAGE_LINES], *more]).replace("\n", "\n    ")
    return f"hoopgen: {compiler} does not compile the scene {scene}:{said}"


def _expected(kernels: ModuleType, *, bounds: bool = True) -> verification.Expected:
    """Return the shots with which a scene's library is compared, with NumPy's results."""
    return verification.expected(kernels, trial_batches(kernels), bounds=bounds)


def _check(content: bytes, kernels: ModuleType, wanted: verification.Expected) -> tuple[str, int]:
    """Return why a library cannot be trusted, "" if it can; and the lanes of its widest vector."""
    try:
        library = load(content, None, lambda path: native.Library(path, kernels))
    except (OSError, AttributeError) as error:
        return f"cannot be loaded: {error}", 0
    widths = verification.available_widths(library, kernels)
    if not widths:
        return "is not for this processor", 0
    found = verification.differences(library, kernels, wanted)
    return f"does not give NumPy's results ({found})" if found else "", widths[-1]


def _compile_source(text: str, scene: str) -> Any:
    return builtins.compile(text, f"<hoopgen's scene {scene}>", "exec", dont_inherit=True)


def load_module(code: Any, scene: str) -> ModuleType:
    """Return the NumPy module of a scene.

    Parameters
    ----------
    code
        The compiled code of what was printed.
    scene
        The name of the scene.
    """
    module = ModuleType(f"hoopgen_scene_{scene}")
    exec(code, module.__dict__)  # printed by hoopgen, and the digest is the one on record
    return module


def announce(work: str) -> None:
    """Say at a terminal what is done, and that it takes long.

    Parameters
    ----------
    work
        What is done, as a sentence.
    """
    if sys.stderr is not None and sys.stderr.isatty():
        said = f"hoopgen: {printable(work)}, which takes up to a minute once"
        print(said, file=sys.stderr, flush=True)
