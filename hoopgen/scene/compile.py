"""`compile`: a scene derived, printed, compiled, compared with NumPy, and kept on disk.

What is kept is found again by all that it is made from: the printed sources, the flags, the
compiler and its version, the lanes of the processor, Python, NumPy and hoopgen. A scene of the
pieces of `hoopgen.scene` is found by what they say, and then nothing is derived.
"""

from __future__ import annotations

import builtins
import gzip
import hashlib
import importlib.util
import json
import marshal
import shutil
import sys
from collections.abc import Mapping
from functools import cache, partial
from pathlib import Path
from sysconfig import get_platform
from types import ModuleType
from typing import Any

import numpy as np

from hoopgen import engines
from hoopgen.engine import native, trust
from hoopgen.engine.loading import load
from hoopgen.engines import HOOP, Engine

from . import compilers
from .cache import MODULE, SOURCES, Entry, Kept, digest, own, private
from .scene import Scene
from .trial import trial

__all__ = ["compile", "place"]

_LINES = 20
"""Most lines of a compiler's words."""

_ENGINES: dict[str, Engine] = {}
"""By key."""

_KNOWN: dict[int, tuple[Any, Engine]] = {}
"""By the identity of a scene, which is kept with it."""

_MOST_KNOWN = 64


def compile(scene: Any) -> Engine:
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
        If this thread does not compute doubles as IEEE 754 says, so that nothing can be compared.
    """
    if scene is None:
        return HOOP
    if isinstance(scene, Engine):
        return scene
    shipped = sys.modules.get("hoopgen.derive.scenes")  # imported already, if it is one of these
    if shipped is not None and scene == shipped.HOOP:
        return HOOP
    if shipped is not None and scene == shipped.COURT:
        from hoopgen.court import COURT  # whose kernels are many

        return COURT
    known, engine = _KNOWN.get(id(scene), (None, None))
    if engine is None or known is not scene:
        engine = _found(scene)
        if len(_KNOWN) >= _MOST_KNOWN:
            _KNOWN.clear()
        _KNOWN[id(scene)] = (scene, engine)
    return engine


def place() -> Kept:
    """Return where compiled scenes are kept: the user's own folder, or the memory of a process."""
    there = own()
    return private(there) if isinstance(there, str) else there


def _found(scene: Any) -> Engine:
    tools = _Tools()
    there = place()
    written = isinstance(scene, Scene)
    name = digest(f"{tools.identity} {_word()} {scene.key}".encode()) if written else ""
    entry = there.pointed(name) if name else None
    if entry is None:
        entry = _made(scene, tools, there)
        if name:
            there.point(name, entry.record["key"])
    key = entry.record["key"]
    if key not in _ENGINES:
        _ENGINES.setdefault(key, _engine(entry, scene, there))
    return _ENGINES[key]


def _made(scene: Any, tools: _Tools, there: Kept) -> Entry:
    """Return a scene's files, printed anew."""
    try:
        # Here, and not above: what has been compiled needs neither SymPy nor Jinja2.
        from hoopgen.codegen.render import render_scene

        from .definition import definition
    except ImportError as error:
        from hoopgen import installed

        raise installed.explained(error, "hoopgen.compile") from None
    derived = definition(scene)
    files = {
        name: text
        for name, text in render_scene(derived, page=False).items()
        if name.startswith(("c/", "numpy/"))
    }
    key = digest(json.dumps([files, tools.whole], sort_keys=True).encode())
    build = partial(_build, key, derived.name, files, tools)
    found = there.entry(key)
    if found is not None:
        return found
    try:
        return there.built(key, build)
    except OSError as error:
        why = _in_words(error)
    try:
        return private(why).built(key, build)
    except OSError as error:
        return build(_in_words(error))


def _in_words(error: OSError) -> str:
    said = error.strerror or str(error)
    return f"{error.filename}: {said}" if error.filename else said


class _Tools:
    """What a scene is compiled with here."""

    def __init__(self) -> None:
        self.compiler = compilers.compiler()
        self.width = compilers.processor_width()

    @property
    def identity(self) -> str:
        """All that can be said without running the compiler."""
        return self._said(self.compiler.identity if self.compiler else "none")

    @property
    def whole(self) -> str:
        """All, the compiler's version with it."""
        from hoopgen.installed import version  # reads metadata, which takes its time

        compiler = self.compiler
        called = f"{compiler.command} {compiler.version()}" if compiler else "none"
        return f"{self._said(called)}, hoopgen {version()}"

    def _said(self, compiler: str) -> str:
        python = importlib.util.MAGIC_NUMBER.hex()
        versions = f"NumPy {np.__version__}, Python {python}"
        return f"{compiler}; {compilers.FLAGS}; {self.width} lanes, {get_platform()}; {versions}"


def _build(
    key: str, scene: str, files: Mapping[str, str], tools: _Tools, folder: Path | str
) -> Entry:
    """Return all that is kept of a scene, compiled in a folder; or NumPy's, and why there is none.

    Parameters
    ----------
    folder
        An empty one that nobody else can change; or why there is no such folder.
    """
    code = _compiled(files[f"numpy/{scene}.py"], scene)
    packed = gzip.compress(json.dumps(files).encode(), 6, mtime=0)
    made = {MODULE: marshal.dumps(code), SOURCES: packed}
    record: dict[str, Any] = {"key": key, "scene": scene, "refused": None}
    without = record | {"compiler": "", "width": 0}
    if tools.compiler is None:
        why = f"of the scene {scene} was not compiled: no C compiler was found"
        return Entry(without | {"refused": [why, "install one, or `pip install ziglang`"]}, made)
    if isinstance(folder, str):
        why = f"of the scene {scene} was not compiled: {folder}"
        remedy = "set TMPDIR to a folder that you alone can write"
        return Entry(without | {"refused": [why, remedy]}, made)
    record |= {"compiler": tools.compiler.name, "width": tools.width}
    sources = folder / "c"
    sources.mkdir()
    try:
        for name, content in files.items():
            if name.startswith("c/"):
                (folder / name).write_text(content, encoding="utf-8")
        words, passing = tools.compiler.run(sources, scene, tools.width)
        if words:
            print(_told(tools.compiler.name, scene, words), file=sys.stderr)
            reason = f"of the scene {scene} could not be compiled by {tools.compiler.name}"
            remedy = "`hoopgen cache --clear` lets it be tried again"
            return Entry(record | {"refused": [reason, remedy], "passing": passing}, made)
        library = (sources / compilers.library_name()).read_bytes()
        refused = _differences(library, _module(code, scene))
    finally:
        shutil.rmtree(sources)
    if refused:
        record |= {"refused": [f"of the scene {scene} {refused}", "report it, with the scene"]}
        return Entry(record, made)
    return Entry(record, made | {compilers.library_name(): library})


def _told(compiler: str, scene: str, words: str) -> str:
    lines = words.splitlines()
    more = [f"... and {len(lines) - _LINES} lines more"] if len(lines) > _LINES else []
    said = "\n".join(["", *lines[:_LINES], *more]).replace("\n", "\n    ")
    return f"hoopgen: {compiler} does not compile the scene {scene}:{said}"


def _differences(content: bytes, kernels: ModuleType) -> str:
    """Return why a library is not to be trusted, "" if it is."""
    try:
        library = load(content, None, lambda path: native.Library(path, kernels))
    except (OSError, AttributeError) as error:
        return f"cannot be loaded: {error}"
    if not trust.widths(library, kernels):
        return "is not for this processor"
    found = trust.differences(library, kernels, trust.batches(kernels, trial(kernels)))
    return f"does not give NumPy's results ({found})" if found else ""


def _engine(entry: Entry, scene: Any, there: Kept) -> Engine:
    """Return what simulates a scene, from its files."""
    name = entry.record["scene"]
    kernels = _module(marshal.loads(entry.files[MODULE]), name)
    found: native.Library | native.Refused
    if entry.record["refused"]:
        found = native.Refused(*entry.record["refused"])
    else:
        file = compilers.library_name()
        path = there.path(entry.record["key"], file)
        try:
            found = load(entry.files[file], path, lambda path: native.Library(path, kernels))
        except (OSError, AttributeError) as error:
            again = "`hoopgen cache --clear` lets it be compiled again"
            found = native.Refused(f"of the scene {name} cannot be loaded: {error}", again)
    packed = entry.files[SOURCES]
    return Engine(
        kernels,
        find=lambda: found,
        sources=lambda: json.loads(gzip.decompress(packed)),
        scene=partial(_definition, scene),
        again=(compile, (scene,)),
        written=scene if isinstance(scene, Scene) else None,
    )


def _definition(scene: Any) -> Any:
    from .definition import definition

    return definition(scene)


def _compiled(text: str, scene: str) -> Any:
    return builtins.compile(text, f"<hoopgen's scene {scene}>", "exec", dont_inherit=True)


def _module(code: Any, scene: str) -> ModuleType:
    module = ModuleType(f"hoopgen_scene_{scene}")
    exec(code, module.__dict__)  # printed by hoopgen, and the digest is the one on record
    return module


@cache
def _word() -> str:
    """Return a word for what makes a scene's sources: hoopgen's version, and what was edited."""
    total = hashlib.sha256()
    package = Path(engines.__file__).parent
    rooms = [package / "codegen", package / "scene", package / "engine"]
    for name in ("derive", "templates"):
        found = importlib.util.find_spec(f"hoopgen.{name}")
        rooms += [Path(folder) for folder in (found and found.submodule_search_locations) or ()]
    for room in rooms:
        for file in sorted(room.rglob("*")):
            if file.suffix in (".py", ".j2"):
                total.update(file.name.encode() + digest(file.read_bytes()).encode())
    return total.hexdigest()
