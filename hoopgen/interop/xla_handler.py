"""The function through which XLA calls a scene's C engine; compiled once, kept like a scene.

xla_call.c is written against the stable C interface of XLA's foreign functions, whose header comes
with jaxlib.
"""

from __future__ import annotations

import ctypes
import json
import shutil
import threading
from functools import cache
from pathlib import Path
from typing import Any

import jax.ffi

from hoopgen.engine import native
from hoopgen.engine.compiled_scene import CompiledScene
from hoopgen.engine.loading import load
from hoopgen.scene import compilers
from hoopgen.scene.cache import Entry, digest
from hoopgen.simulation.compile import scene_store
from hoopgen.simulation.compiled_files import built_entry
from hoopgen.text.shorten import brief

SOURCE = Path(__file__).with_name("xla_call.c")
HEADER = Path("xla", "ffi", "api", "c_api.h")

_TARGETS: dict[str, ctypes.CDLL] = {}
"""Libraries by the names under which XLA knows their functions; XLA never forgets one."""

_LOCK = threading.Lock()


def target_of(engine: CompiledScene) -> str:
    """Return the name under which XLA calls the C engine of a scene.

    Parameters
    ----------
    engine
        The scene.

    Raises
    ------
    RuntimeError
        If there is no C engine, no C compiler, or the compiler fails; the message says why.
    """
    library = engine.found
    if isinstance(library, native.Rejection):
        raise RuntimeError(f"the C engine {library.reason}; {library.remedy}")
    identity = engine.identity
    name = f"hoopgen_{identity['name']}_{identity['sha256'][:16]}"
    with _LOCK:
        if name not in _TARGETS:
            # Loaded anew for each scene, so that each has its own function to call.
            handler = load(_compiled(), None, lambda path: ctypes.CDLL(str(path)))
            handler.hoopgen_bind.argtypes = [ctypes.c_void_p]
            handler.hoopgen_bind.restype = None
            handler.hoopgen_bind(library.function)
            capsule: Any = jax.ffi.pycapsule(handler.hoopgen_simulate)  # type: ignore[no-untyped-call]
            jax.ffi.register_ffi_target(name, capsule, platform="cpu")
            _TARGETS[name] = handler
    return name


@cache
def _compiled() -> bytes:
    """Return the compiled library, from the store of compiled scenes if it is there."""
    include = Path(jax.ffi.include_dir())
    try:
        content, header = SOURCE.read_bytes(), (include / HEADER).read_bytes()
    except OSError as error:
        raise RuntimeError(f"the header of XLA's interface is missing: {error}") from None
    compiler = compilers.compiler()
    if compiler is None:
        missing = compilers.missing_compiler()
        raise RuntimeError(f"{missing}; install one, or `pip install ziglang`")
    tools = [compiler.identity, compiler.version(), *compilers.FLAGS]
    key = digest(json.dumps([digest(content), digest(header), *tools]).encode())

    def build(folder: Path | str) -> Entry:
        return _build(key, compiler, include, folder)

    store = scene_store()
    entry = store.entry(key) or built_entry(key, build, store)
    refused = entry.record["refused"]
    if refused:
        raise RuntimeError(" ".join(refused))
    return entry.files[compilers.library_name()]


def _build(key: str, compiler: compilers.Compiler, include: Path, folder: Path | str) -> Entry:
    """Return the entry of the library, compiled in a folder, or of the reason why it is not."""
    record: dict[str, Any] = {"key": key, "scene": "(call of JAX)", "refused": None}
    record |= {"compiler": compiler.name, "width": 0}
    if isinstance(folder, str):
        return Entry(record | {"refused": [folder], "passing": True}, {})
    sources = folder / "c"
    sources.mkdir()
    try:
        shutil.copy2(SOURCE, sources)
        words, passing = compiler.run(sources, SOURCE.name, [f"-I{include}"])
        if words:
            reason = f"{compiler.name} does not compile the call of XLA: {brief(words)}"
            remedy = "(`hoopgen cache --clear` lets it be tried again)"
            return Entry(record | {"refused": [reason, remedy], "passing": passing}, {})
        name = compilers.library_name()
        return Entry(record, {name: (sources / name).read_bytes()})
    finally:
        shutil.rmtree(sources)
