"""`compile`: a scene is derived, printed, compiled, compared with NumPy and cached.

The loop with bounds on errors is compiled at once, in three fifths of the time of both. It serves
every call. The loop without bounds, which is up to twice as fast, is compiled once so many shots
have asked for no bounds that it pays.

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
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property, partial
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

WHEEL = "wheel"
"""The compiler on record of a library that came with hoopgen, which has both loops."""

SHOTS_WORTH_A_LOOP = 1 << 21
"""Shots without bounds on errors that pay for the compilation of a loop without them. On one thread
each saves a microsecond or two, and the compiler takes a few seconds."""


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
    _say(f"the scene {getattr(scene, 'name', '')} is derived and compiled")
    return generate_scene(scene)


def _say(work: str) -> None:
    """Say at a terminal what is done, and that it takes long."""
    if sys.stderr is not None and sys.stderr.isatty():
        said = f"hoopgen: {printable(work)}, which takes up to a minute once"
        print(said, file=sys.stderr, flush=True)


def _build_entry(printed: Printed, tools: _Tools, there: SceneStore) -> Entry:
    """Return the entry of a printed scene, which is built unless it is there."""
    made_of: list[Any] = [printed.files, tools.whole]
    if printed.library is not None:
        made_of.append(digest(printed.library))
    key = digest(json.dumps(made_of, sort_keys=True).encode())
    build = partial(_build, key, printed, tools)
    return there.entry(key) or _built(key, build, there)


def _built(key: str, build: Callable[[Path | str], Entry], there: SceneStore) -> Entry:
    """Return the entry of a key, built for this process alone where it cannot be kept."""
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
            record |= {"compiler": WHEEL, "width": width}
            return Entry(record, made | {compilers.library_name(): printed.library})
    without = record | {"compiler": "", "width": 0}
    if tools.compiler is None:
        why = f"of the scene {scene} was not compiled: no C compiler was found"
        return Entry(without | {"refused": [why, "install one, or `pip install ziglang`"]}, made)
    if isinstance(folder, str):
        why = f"of the scene {scene} was not compiled: {folder}"
        remedy = "set TMPDIR to a folder that you alone can write"
        return Entry(without | {"refused": [why, remedy]}, made)
    return _compile_loop(Entry(record, made), files, kernels, tools, folder, bounds=True)


def _compile_loop(
    entry: Entry,
    files: Mapping[str, str],
    kernels: ModuleType,
    tools: _Tools,
    folder: Path,
    *,
    bounds: bool,
) -> Entry:
    """Return an entry with one of a scene's loops, compiled in a folder, or why there is none.

    Parameters
    ----------
    entry
        The entry without the library.
    files
        What was printed, by path.
    bounds
        Whether it is the loop with bounds on errors.
    """
    scene, compiler = entry.record["scene"], tools.compiler
    assert compiler is not None
    record = {**entry.record, "compiler": compiler.name, "width": tools.lanes.width}
    sources = folder / "c"
    sources.mkdir()
    try:
        for name, content in files.items():
            if name.startswith("c/"):
                (folder / name).write_text(content, encoding="utf-8")
        options = [*tools.lanes.options(scene), compilers.loop_option(scene, bounds=bounds)]
        with compiler.running(sources, f"{scene}.c", options) as result:
            wanted = _expected(kernels, bounds=bounds)  # meanwhile
            words, passing = result()
        if words:
            print(_compiler_message(compiler.name, scene, words), file=sys.stderr)
            reason = f"of the scene {scene} could not be compiled by {compiler.name}"
            remedy = "`hoopgen cache --clear` lets it be tried again"
            return Entry({**record, "refused": [reason, remedy], "passing": passing}, entry.files)
        library = (sources / compilers.library_name()).read_bytes()
        refused, _ = _check(library, kernels, wanted)
    finally:
        shutil.rmtree(sources)
    if refused:
        record["refused"] = [f"of the scene {scene} {refused}", "report it, with the scene"]
        return Entry(record, entry.files)
    return Entry(record, {**entry.files, compilers.library_name(): library})


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
    shots = verification.batches(kernels, trial_shots(kernels))
    return verification.expected(kernels, shots, bounds=bounds)


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
    without = None
    if isinstance(found, native.Library) and entry.record["compiler"] != WHEEL:
        without = _LoopWithoutBounds(entry, there, kernels, found)
    return Engine(
        kernels,
        find=lambda: found,
        without_bounds=without,
        sources=lambda: json.loads(gzip.decompress(packed)),
        scene=scene,
        trial=lambda: verification.batches(kernels, trial_shots(kernels)),
        **options,
    )


@dataclass
class _LoopWithoutBounds:
    """Finds the C engine of calls that need no bounds on errors: another one once that pays.

    Attributes
    ----------
    entry, there
        The files of the scene, and where they are kept.
    kernels
        The generated NumPy module of the scene.
    library
        The C engine with bounds on errors, which serves else.
    """

    entry: Entry
    there: SceneStore
    kernels: ModuleType
    library: native.Library
    _shots: int = 0
    _found: native.Library | None = None

    def __call__(self, shots: int) -> native.Library:
        """Return the C engine for so many more shots."""
        if self._found is None:
            entry = self.there.entry(self._key) if self._shots == 0 else None
            self._shots += shots
            if entry is None and self._shots >= SHOTS_WORTH_A_LOOP:
                entry = _built(self._key, self._build, self.there)
            if entry is not None:
                self._found = self._load(entry)
        return self._found or self.library

    @cached_property
    def _key(self) -> str:
        tools = _Tools()
        return digest(f"{self.entry.record['key']} without bounds, {tools.identity}".encode())

    def _build(self, folder: Path | str) -> Entry:
        tools, scene = _Tools(), self.entry.record["scene"]
        record = {"key": self._key, "scene": scene, "bounds": False, "refused": None}
        record |= {"compiler": "", "width": 0}
        if tools.compiler is None or isinstance(folder, str):
            return Entry({**record, "refused": ["", ""], "passing": True}, {})
        _say(f"the scene {scene} is compiled without bounds on errors, for many shots")
        files = json.loads(gzip.decompress(self.entry.files[SOURCES]))
        with HOOP.exact_arithmetic():
            empty = Entry(record, {})
            return _compile_loop(empty, files, self.kernels, tools, folder, bounds=False)

    def _load(self, entry: Entry) -> native.Library:
        """Return the library of an entry; that with bounds if it has none."""
        file = compilers.library_name()
        if entry.record["refused"]:
            return self.library
        path = self.there.path(entry.record["key"], file)
        try:
            return load(entry.files[file], path, lambda path: native.Library(path, self.kernels))
        except (OSError, AttributeError):
            return self.library


def _definition(scene: Any) -> Any:
    from hoopgen.scene.definition import definition

    return definition(scene)


def _compile_source(text: str, scene: str) -> Any:
    return builtins.compile(text, f"<hoopgen's scene {scene}>", "exec", dont_inherit=True)


def _module(code: Any, scene: str) -> ModuleType:
    module = ModuleType(f"hoopgen_scene_{scene}")
    exec(code, module.__dict__)  # printed by hoopgen, and the digest is the one on record
    return module
