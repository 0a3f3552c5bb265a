"""A scene's C sources as a package: with headers of tools, CMake, and pkg-config."""

from __future__ import annotations

import re
import zipfile
from collections.abc import Mapping
from importlib import resources
from pathlib import Path
from typing import Any

import jinja2
import sympy as sp
from sympy.printing.c import C99CodePrinter

from hoopgen.core.extras import version
from hoopgen.derive.studies import release
from hoopgen.engine.c_build import FLAGS
from hoopgen.engine.compiled_scene import CompiledScene
from hoopgen.hoop.releases import RING_HEIGHT

TEMPLATES = resources.files("hoopgen.templates") / "package"

FILES = {
    "tools.h.j2": "include/{scene}_tools.h",
    "CMakeLists.txt.j2": "CMakeLists.txt",
    "scene.pc.in.j2": "{scene}.pc.in",
}
"""Each template, and the file that it makes."""

EXAMPLE = {"share.c.j2": "example/share.c"}
"""The same for a scene with releases."""

ERRORS: Mapping[str, str] = {
    "WIDTH": "this processor or build does not have that width",
    "ARITHMETIC": "flags of the compiler changed how doubles are computed",
    "MEMORY": "there is no memory for the shots in flight",
    "SHOTS": "there are more shots than an array can hold",
    "STATES": "states is NULL, and there are shots",
    "PARAMETERS": "parameters or one of its pointers is NULL",
    "STRIDES": "strides is NULL, or one of them is neither 0 nor 1",
    "LEAVING": "an entry of leaving is less than -1, or no surface",
    "MAX_CONTACTS": "max_contacts is less than 1",
    "TIME_LIMIT": "time_limit is NaN, or not more than 0",
    "RESULTS": "results is NULL, or asks for bounds on errors, which the build leaves out",
    "EVENTS": "events and event_counts go together, and their log must fit in memory",
    "NEXT": "next is NULL",
    "PARTS": "parts is less than 1",
}
"""Texts of the codes that a call returns, by their names in the header."""

_MEANINGS = {
    "speed": "m/s",
    "elevation": "rad, above the horizontal",
    "azimuth": "rad, 0 aims at the ring's centre, positive to the shooter's left",
    "backspin": "rad/s",
    "sidespin": "rad/s",
    "height": "m, of the ball's centre above the floor",
    "distance": "m, from the ring's centre on the floor plan",
    "angle": "rad, of the place around the ring's centre, 0 on +x",
}

_VERSION = re.compile(r"\d+")

_README = """\
# {name}: the C sources of a scene of hoopgen {version}

    cmake -S . -B build && cmake --build build && cmake --install build --prefix WHERE

A program then finds the library by `find_package({name})` and `{name}::{name}` in CMake, or by
`pkg-config --cflags --libs {name}`. Without CMake, compile src/{name}.c with the folder include in
the search path of headers, -ffp-contract=off, and without fast-math.

include/{name}.h is the interface. include/{name}_tools.h has the version, texts of errors and
presets.
"""


def package_files(scene: CompiledScene) -> dict[str, str]:
    """Return the files of a scene's package for C: path, and text.

    Parameters
    ----------
    scene
        The scene.
    """
    name = scene.name
    header = f"{name}.h"
    sources = scene.source("c")
    files = {
        f"{'include' if file == header else 'src'}/{file}": text for file, text in sources.items()
    }
    context = _context(scene)
    environment = jinja2.Environment(
        loader=jinja2.FunctionLoader(lambda file: (TEMPLATES / file).read_text("utf-8")),
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )
    for template, file in (FILES | (EXAMPLE if scene.has_hoop else {})).items():
        files[file.format(scene=name)] = environment.get_template(template).render(context)
    files["README.md"] = _README.format(name=name, version=context["version"])
    return dict(sorted(files.items()))


def write_package(scene: CompiledScene, path: Path) -> None:
    """Write a scene's package for C as a ZIP file: the same bytes for the same files.

    Parameters
    ----------
    scene
        The scene.
    path
        The file.

    Raises
    ------
    OSError
        If it cannot be written.
    """
    top = f"{scene.name}-c"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for file, text in package_files(scene).items():
            member = zipfile.ZipInfo(f"{top}/{file}", (1980, 1, 1, 0, 0, 0))
            member.compress_type, member.external_attr = zipfile.ZIP_DEFLATED, 0o644 << 16
            archive.writestr(member, text)


def _context(scene: CompiledScene) -> dict[str, Any]:
    """Return the variables of the templates."""
    said = version()
    presets = scene.presets or {"usual": scene.parameters}
    inputs = scene.kernels.PARAMETERS
    values = {
        preset: dict(zip(inputs, map(_number, scene.table.inputs(dict(given))), strict=True))
        for preset, given in presets.items()
    }
    context: dict[str, Any] = {
        "name": scene.name,
        "N": scene.name.upper(),
        "version": said,
        "numbers": _VERSION.findall(said)[:3],
        "description": f"a ball among {', '.join(scene.surfaces)}, from contact to contact",
        "flags": " ".join(flag for flag in FLAGS if flag.startswith("-f")),
        "errors": ERRORS,
        "outcomes": list(scene.outcomes.__members__),
        "presets": values,
        "releases": scene.has_hoop,
    }
    return context | (_release(scene.name) if scene.has_hoop else {})


def _number(value: Any) -> str:
    """Return a double in C; repr is the shortest text that is read as the same double."""
    return {"inf": "INFINITY", "-inf": "-INFINITY"}.get(repr(float(value)), repr(float(value)))


def _release(name: str) -> dict[str, Any]:
    """Return the templates' variables for releases."""
    given = {symbol: sp.Symbol(f"given->{symbol.name}") for symbol in release.ARGUMENTS}
    given[release.ring_height] = sp.Symbol(f"{name.upper()}_RING_HEIGHT")
    text = C99CodePrinter().doprint
    steps, state = release.release()
    return {
        "ring_height": _number(RING_HEIGHT),
        "arguments": {symbol.name: _MEANINGS[symbol.name] for symbol in release.ARGUMENTS},
        "steps": {symbol.name: text(value.xreplace(given)) for symbol, value in steps.items()},
        "state": [text(value.xreplace(given)) for value in state.values()],
    }
