"""`compile`: a scene is derived, printed, compiled, compared with NumPy and cached.

What is kept is found again by all that it is made from: the printed sources, the flags, the
compiler and its version, the lanes of the processor, Python, NumPy and hoopgen. A scene of the
pieces of `hoopgen.scene` is found by what they say, and then nothing is derived.
"""

from __future__ import annotations

import gzip
import json
import marshal
import sys
from collections.abc import Callable, Mapping
from functools import partial
from typing import Any

from hoopgen.engine import native
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
from hoopgen.scene.trial_shots import trial_batches

from .compiled_files import WHEEL, Tools, announce, build_entry, load_module
from .engine import Engine
from .hoop import HOOP
from .printed_scenes import Printed, generate_scene, shipped_scene, source_digest
from .without_bounds import LoopWithoutBounds

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
    tools = Tools()
    name = digest(f"{tools.identity} {source_digest()} {known}".encode()) if known else ""
    entry = there.pointed(name) if name else None
    if entry is None:
        with HOOP.exact_arithmetic():
            entry = build_entry(shipped_scene(known) or _generate(scene()), tools, there)
        if name:
            there.point(name, entry.record["key"])
    return entry


def _generate(scene: Any) -> Printed:
    """Derive and print a scene, as `generate_scene`; say so at a terminal, since it takes long."""
    announce(f"the scene {getattr(scene, 'name', '')} is derived and compiled")
    return generate_scene(scene)


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
    kernels = load_module(marshal.loads(entry.files[MODULE]), name)
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
        without = LoopWithoutBounds(entry, there, kernels, found)
    return Engine(
        kernels,
        find=lambda: found,
        without_bounds=without,
        sources=partial(_sources, packed, scene),
        scene=scene,
        trial=partial(trial_batches, kernels),
        **options,
    )


def _sources(packed: bytes, scene: Callable[[], Any], target: str) -> Mapping[str, str]:
    """Return the printed files of a scene, or those of a target for which it was not printed."""
    files: dict[str, str] = json.loads(gzip.decompress(packed))
    if any(name.startswith(f"{target}/") for name in files):
        return files
    return generate_scene(scene(), (target,)).files


def _definition(scene: Any) -> Any:
    from hoopgen.scene.definition import definition

    return definition(scene)
