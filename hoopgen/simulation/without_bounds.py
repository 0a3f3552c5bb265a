"""The C engine of calls that need no bounds on errors: compiled by itself, once that pays."""

from __future__ import annotations

import gzip
import json
import sys
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from types import ModuleType

from hoopgen.engine import native
from hoopgen.engine.loading import load
from hoopgen.scene import compilers
from hoopgen.scene.cache import SOURCES, Entry, SceneStore, digest

from .compiled_files import Tools, announce, built_entry, compile_loop
from .hoop import HOOP

SHOTS_WORTH_A_LOOP = 1 << 21
"""Shots without bounds on errors that pay for the compilation of a loop without them. On one thread
each saves a microsecond or two, and the compiler takes a few seconds."""


@dataclass
class LoopWithoutBounds:
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
                entry = built_entry(self._key, self._build, self.there)
            if entry is not None:
                self._found = self._load(entry)
        return self._found or self.library

    @cached_property
    def _key(self) -> str:
        tools = Tools()
        return digest(f"{self.entry.record['key']} without bounds, {tools.identity}".encode())

    def _build(self, folder: Path | str) -> Entry:
        tools, scene = Tools(), self.entry.record["scene"]
        record = {"key": self._key, "scene": scene, "bounds": False, "refused": None}
        record |= {"compiler": "", "width": 0}
        if tools.compiler is None or isinstance(folder, str):
            why = folder if isinstance(folder, str) else compilers.missing_compiler()
            refused = [f"of the scene {scene} was not compiled: {why}", ""]
            made = Entry({**record, "refused": refused, "passing": True}, {})
        else:
            announce(f"the scene {scene} is compiled without bounds on errors, for many shots")
            files = json.loads(gzip.decompress(self.entry.files[SOURCES]))
            with HOOP.exact_arithmetic():
                made = compile_loop(
                    record, files, lambda: (self.kernels, {}), tools, folder, bounds=False
                )
        if made.record["refused"]:
            said = f"the loop without bounds on errors {made.record['refused'][0]}"
            print(f"hoopgen: {said}. Calls without them stay slower.", file=sys.stderr)
        return made

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
