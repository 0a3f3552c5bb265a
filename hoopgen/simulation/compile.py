"""`compile`: a scene is derived, printed, compiled, compared with NumPy and cached.

What is kept is found again by all that it is made from: the printed sources, the flags, the
compiler and its version, the lanes of the processor, Python, NumPy and hoopgen. A scene of the
pieces of `hoopgen.scene` is found by what they say, and then nothing is derived.
"""

from __future__ import annotations

import builtins
import gzip
import importlib.util
import json
import marshal
import shutil
import sys
from collections.abc import Callable
from functools import partial
from pathlib import Path
from sysconfig import get_platform
from types import ModuleType
from typing import Any

import numpy as np

from hoopgen.engine import native, verification
from hoopgen.engine.loading import load
from hoopgen.scene import compilers
from hoopgen.scene.cache import (
    MODULE,
    SOURCES,
    Entry,
    SceneStore,
    digest,
    process_store,
    user_store,
)
from hoopgen.scene.lookup import SceneLike
from hoopgen.scene.scene import Scene
from hoopgen.scene.trial_shots import trial_shots
from hoopgen.text.escape import printable

from .engine import Engine
from .hoop import HOOP
from .printed_scenes import Printed, generate_scene, shipped_scene, source_digest

_MAX_MESSAGE_LINES = 20
"""Most lines of a compiler's words."""

_ENGINES: dict[str, Engine] = {}
"""Compiled engines, by key."""

_KEY_BY_IDENTITY: dict[int, tuple[Any, Engine]] = {}
"""Keys and engines, by the identity of a scene, which is held so that the identity stays."""

_MAX_IDENTITIES = 64


def compile(scene: SceneLike) -> Engine:
    """Derive a scene, compile it for this processor, and compare it with NumPy.

    It takes seconds once. What was made is kept in a folder of the user's own, and found there by
    any later process.

    Parameters
    ----------
    scene
        A `hoopgen.scene.Scene`; or what has been compiled, which is returned.

    Returns
    -------
    Engine
        With ``simulate``, ``certify``, ``parameters``, ``surfaces``, ``outcomes``, ``backend`` and
        ``source``. Where there is no C compiler, or it fails, NumPy serves, and one line says so
        when it first does.

    Raises
    ------
    TypeError
        If it is no scene.
    ValueError
        If it is one that cannot be derived; the message says what is wrong.
    ImportError
        If SymPy or Jinja2 is missing: what brings them.
    RuntimeError
        If this thread does not compute doubles as IEEE 754 says, and `HOOP` has no C engine that
        could make it.
    """
    if scene is None:
        return HOOP
    if isinstance(scene, Engine):
        return scene
    shipped = sys.modules.get("hoopgen.derive.scenes")  # imported already, if it is one of these
    if shipped is not None and isinstance(scene, type(shipped.HOOP)):
        if scene == shipped.HOOP:
            return HOOP
        if scene == shipped.COURT:
            from .court import COURT  # whose kernels are many

            return COURT
    known, found = _KEY_BY_IDENTITY.get(id(scene), (None, None))
    if found is None or known is not scene:
        found = _find_engine(scene)
        if len(_KEY_BY_IDENTITY) >= _MAX_IDENTITIES:
            _KEY_BY_IDENTITY.clear()
        _KEY_BY_IDENTITY[id(scene)] = (scene, found)
    return found


def scene_store() -> SceneStore:
    """Return the store of compiled scenes: the user's folder, or the memory of the process."""
    there = user_store()
    return process_store(there) if isinstance(there, str) else there


def _find_engine(scene: Any) -> Engine:
    there = scene_store()
    entry = find_entry(lambda: scene, scene.key if isinstance(scene, Scene) else "", there)
    key = entry.record["key"]
    if key not in _ENGINES:
        written = scene if isinstance(scene, Scene) else None
        made = engine(
            entry, there, partial(_definition, scene), rebuild=(compile, (scene,)), written=written
        )
        _ENGINES.setdefault(key, made)
    return _ENGINES[key]


def find_entry(scene: Callable[[], Any], known: str, there: SceneStore) -> Entry:
    """Return the files of a scene, which are made if there are none.

    Parameters
    ----------
    scene
        Function that returns the scene; it is called only if the files are not there.
    known
        The identity of the scene, by which its files are found without deriving it; "": none.
    there
        Where they are kept.

    Raises
    ------
    ImportError, TypeError, ValueError, RuntimeError
        As of `compile`.
    """
    tools = _Tools()
    name = digest(f"{tools.identity} {source_digest()} {known}".encode()) if known else ""
    entry = there.pointed(name) if name else None
    if entry is None:
        with HOOP.exact_arithmetic():
            entry = _build_entry(shipped_scene(known) or _generate(scene()), tools, there)
        if name:
            there.point(name, entry.record["key"])
    return entry


def _generate(scene: Any) -> Printed:
    """Derive and print a scene, as `generate_scene`; say so at a terminal, since it takes long."""
    if sys.stderr is not None and sys.stderr.isatty():
        name = printable(str(getattr(scene, "name", "")))
        said = f"hoopgen: the scene {name} is derived and compiled, which takes up to a minute once"
        print(said, file=sys.stderr, flush=True)
    return generate_scene(scene)


def _build_entry(printed: Printed, tools: _Tools, there: SceneStore) -> Entry:
    """Return the entry of a printed scene, which is built unless it is there."""
    made_of: list[Any] = [printed.files, tools.whole]
    if printed.library is not None:
        made_of.append(digest(printed.library))
    key = digest(json.dumps(made_of, sort_keys=True).encode())
    build = partial(_build, key, printed, tools)
    found = there.entry(key)
    if found is not None:
        return found
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


class _Tools:
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


def _build(key: str, printed: Printed, tools: _Tools, folder: Path | str) -> Entry:
    """Return the entry of a scene, compiled in a folder; without C if that fails, with the reason.

    A library that came with hoopgen is taken as it is, if it gives NumPy's results.

    Parameters
    ----------
    folder
        An empty one that nobody else can change; or why there is no such folder.
    """
    scene, files = printed.scene, printed.files
    code = _compile_source(files[f"numpy/{scene}.py"], scene)
    kernels = _module(code, scene)
    packed = gzip.compress(json.dumps(files).encode(), 6, mtime=0)
    made = {MODULE: marshal.dumps(code), SOURCES: packed}
    record: dict[str, Any] = {"key": key, "scene": scene, "refused": None}
    if printed.library is not None:
        refused, width = _check(printed.library, kernels, _expected(kernels))
        if not refused:
            record |= {"compiler": "wheel", "width": width}
            return Entry(record, made | {compilers.library_name(): printed.library})
    without = record | {"compiler": "", "width": 0}
    if tools.compiler is None:
        why = f"of the scene {scene} was not compiled: no C compiler was found"
        return Entry(without | {"refused": [why, "install one, or `pip install ziglang`"]}, made)
    if isinstance(folder, str):
        why = f"of the scene {scene} was not compiled: {folder}"
        remedy = "set TMPDIR to a folder that you alone can write"
        return Entry(without | {"refused": [why, remedy]}, made)
    record |= {"compiler": tools.compiler.name, "width": tools.lanes.width}
    sources = folder / "c"
    sources.mkdir()
    try:
        for name, content in files.items():
            if name.startswith("c/"):
                (folder / name).write_text(content, encoding="utf-8")
        options = tools.lanes.options(scene)
        with tools.compiler.running(sources, f"{scene}.c", options) as result:
            wanted = _expected(kernels)  # meanwhile
            words, passing = result()
        if words:
            print(_compiler_message(tools.compiler.name, scene, words), file=sys.stderr)
            reason = f"of the scene {scene} could not be compiled by {tools.compiler.name}"
            remedy = "`hoopgen cache --clear` lets it be tried again"
            return Entry(record | {"refused": [reason, remedy], "passing": passing}, made)
        library = (sources / compilers.library_name()).read_bytes()
        refused, _ = _check(library, kernels, wanted)
    finally:
        shutil.rmtree(sources)
    if refused:
        record |= {"refused": [f"of the scene {scene} {refused}", "report it, with the scene"]}
        return Entry(record, made)
    return Entry(record, made | {compilers.library_name(): library})


def _compiler_message(compiler: str, scene: str, words: str) -> str:
    lines = words.splitlines()
    more = (
        [f"... and {len(lines) - _MAX_MESSAGE_LINES} lines more"]
        if len(lines) > _MAX_MESSAGE_LINES
        else []
    )
    said = "\n".join(["", *lines[:_MAX_MESSAGE_LINES], *more]).replace("\n", "\n    ")
    return f"hoopgen: {compiler} does not compile the scene {scene}:{said}"


def _expected(kernels: ModuleType) -> verification.Expected:
    """Return the shots with which a scene's library is compared, with NumPy's results."""
    return verification.expected(kernels, verification.batches(kernels, trial_shots(kernels)))


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


def engine(entry: Entry, there: SceneStore, scene: Callable[[], Any], **options: Any) -> Engine:
    """Return the engine of a scene from its files.

    Parameters
    ----------
    entry, there
        The files, and where they are kept.
    scene
        Function that returns the scene of derive/.
    options
        Further arguments of `Engine`.
    """
    name = entry.record["scene"]
    kernels = _module(marshal.loads(entry.files[MODULE]), name)
    found: native.Library | native.Rejection
    if entry.record["refused"]:
        found = native.Rejection(*entry.record["refused"])
    else:
        file = compilers.library_name()
        path = there.path(entry.record["key"], file)
        try:
            found = load(entry.files[file], path, lambda path: native.Library(path, kernels))
        except (OSError, AttributeError) as error:
            again = "`hoopgen cache --clear` lets it be compiled again"
            found = native.Rejection(f"of the scene {name} cannot be loaded: {error}", again)
    packed = entry.files[SOURCES]
    return Engine(
        kernels,
        find=lambda: found,
        sources=lambda: json.loads(gzip.decompress(packed)),
        scene=scene,
        trial=lambda: verification.batches(kernels, trial_shots(kernels)),
        **options,
    )


def _definition(scene: Any) -> Any:
    from hoopgen.scene.definition import definition

    return definition(scene)


def _compile_source(text: str, scene: str) -> Any:
    return builtins.compile(text, f"<hoopgen's scene {scene}>", "exec", dont_inherit=True)


def _module(code: Any, scene: str) -> ModuleType:
    module = ModuleType(f"hoopgen_scene_{scene}")
    exec(code, module.__dict__)  # printed by hoopgen, and the digest is the one on record
    return module
