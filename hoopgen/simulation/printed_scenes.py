"""The printed files of a scene: generated now, or those that came with the wheel.

A wheel can bring along the hoops in air, printed and compiled for every vector width, so that they
need neither SymPy nor a compiler. Before it is built, ``python -m
hoopgen.simulation.printed_scenes`` prints them into the folder ``hoopgen/shipped``; setup.py
compiles what lies there into libraries beside it, if it is asked for all widths.
"""

from __future__ import annotations

import gzip
import hashlib
import importlib.util
import json
import zlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

from hoopgen.core.backend_names import RUNTIME_BACKENDS
from hoopgen.core.garbage import rare_collection

_PACKAGE = Path(__file__).resolve().parent.parent

SHIPPED_FOLDER = _PACKAGE / "shipped"
"""The folder of the scenes that a wheel brings along."""

SHIPPED_SCENES = ("hoopgen.AIR", "hoopgen.COURT_AIR")
"""The public names of these scenes."""


COMPILED_TARGETS = ("c", "numpy")
"""Targets for which a scene is printed before it is compiled; for others it is when they are asked
for."""


@dataclass(frozen=True)
class Printed:
    """A scene as text.

    Attributes
    ----------
    scene
        The name of the scene, with which its C functions begin.
    files
        What was printed, by path.
    library
        The C of it, compiled for every vector width; None if it is still to be compiled.
    """

    scene: str
    files: Mapping[str, str]
    library: bytes | None = None


def generate_scene(scene: Any, targets: Sequence[str] = COMPILED_TARGETS) -> Printed:
    """Derive a scene and print it.

    Parameters
    ----------
    scene
        A scene of `hoopgen.scene` or of derive/.
    targets
        The targets for which it is printed.

    Raises
    ------
    ImportError
        If SymPy or Jinja2 is missing: what brings them.
    TypeError, ValueError
        If it is none that can be derived.
    """
    try:
        # Here, and not above: what has been printed needs neither SymPy nor Jinja2.
        from hoopgen.codegen.render import render_scene
        from hoopgen.scene.definition import definition
    except ImportError as error:
        from hoopgen.core import extras

        raise extras.explain_import_error(error, "hoopgen.compile") from None
    derived = definition(scene)
    with rare_collection():
        files = render_scene(derived, page=False, targets=targets)
    return Printed(derived.name, files)


def shipped_scene(name: str, folder: Path = SHIPPED_FOLDER) -> Printed | None:
    """Return a scene that came with hoopgen; None if it did not, or if hoopgen has changed since.

    Parameters
    ----------
    name
        Its public name.
    folder
        Where such scenes are.
    """
    if name not in SHIPPED_SCENES:
        return None
    stem = _stem(name)
    try:
        record = json.loads(gzip.decompress((folder / f"{stem}.json.gz").read_bytes()))
    except (OSError, EOFError, ValueError, zlib.error):
        return None
    if record["source_digest"] != source_digest():
        return None
    library = folder / f"_{stem}.so"
    return Printed(stem, record["files"], library.read_bytes() if library.is_file() else None)


def write_shipped_scenes() -> None:
    """Print the scenes that a wheel brings along; the same files are replaced."""
    from hoopgen.derive.scenes import air

    SHIPPED_FOLDER.mkdir(exist_ok=True)
    for name in SHIPPED_SCENES:
        printed = generate_scene(getattr(air, name.rpartition(".")[2]), RUNTIME_BACKENDS)
        record = {"source_digest": source_digest(), "files": printed.files}
        packed = gzip.compress(json.dumps(record).encode(), mtime=0)
        (SHIPPED_FOLDER / f"{_stem(name)}.json.gz").write_bytes(packed)
        print(f"printed {name} into {SHIPPED_FOLDER}", flush=True)


def _stem(name: str) -> str:
    return name.rpartition(".")[2].lower()


@cache
def source_digest() -> str:
    """Return a digest of what generates a scene's sources: hoopgen's version and edited files."""
    total = hashlib.sha256()
    rooms = [_PACKAGE / name for name in ("codegen", "scene", "engine", "simulation")]
    for name in ("derive", "templates"):
        found = importlib.util.find_spec(f"hoopgen.{name}")
        rooms += [Path(folder) for folder in (found and found.submodule_search_locations) or ()]
    for room in rooms:
        for file in sorted(room.rglob("*")):
            if file.suffix in (".py", ".j2"):
                content = hashlib.sha256(file.read_bytes()).hexdigest()
                total.update(file.name.encode() + content.encode())
    return total.hexdigest()


if __name__ == "__main__":
    write_shipped_scenes()
