"""Rendering: kernels into templates into generated/, and the check that generated/ is current."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass
from importlib import resources
from pathlib import PurePosixPath
from typing import Any

import jinja2

from hoopgen.derive.follow.fields import EVENTS, Result
from hoopgen.derive.follow.loop import Loop
from hoopgen.derive.ground.choice import Truth
from hoopgen.derive.ground.kernel import Kernel
from hoopgen.derive.ground.number_range import MAX_SIZE, MAX_TIME
from hoopgen.derive.ground.symbols import STATE
from hoopgen.derive.model import Model, build
from hoopgen.derive.scenes import SCENES
from hoopgen.derive.scenes.ends import meanings
from hoopgen.derive.scenes.scene import Scene
from hoopgen.derive.scenes.validity import size_limits

from .alone import Alone
from .cost import describe_cost
from .derivation import anchor, derivation_context
from .derivation.summary import worked_shot
from .fixed import Split, splits
from .loop import TYPES, weighted
from .names import FILTERS, identifier
from .numpy_loop import local
from .printers import (
    ALONE,
    C_SINGLE,
    JS,
    NUMPY,
    NUMPY_SINGLE,
    Body,
    C,
    Constants,
    constant,
    print_program,
)
from .program import Program, lower
from .rows import print_in_rows
from .stamp import stamp_of
from .view import loop_view

OUTPUTS = {
    "numpy/kernels.py.j2": "numpy/{scene}.py",
    "c/kernels.h.j2": "c/{scene}_kernels.h",
    "c/lanes.h.j2": "c/{scene}_lanes.h",
    "c/engine.h.j2": "c/{scene}_engine.h",
    "c/exact.h.j2": "c/{scene}_exact.h",
    "c/scene.h.j2": "c/{scene}.h",
    "c/scene.c.j2": "c/{scene}.c",
    "js/flight.js.j2": "js/{scene}.js",
    "derivation.md.j2": "derivation.md",
    "summary.md.j2": "summary.md",
}
"""Each template, and the file that it makes."""


@dataclass(frozen=True)
class KernelView:
    """What a template sees of a kernel."""

    name: str
    arguments: list[str]
    output_names: tuple[str, ...]
    summary: str
    equation: str
    cost: str
    single: bool
    numpy: Body
    alone: Body
    c: Body
    c_cost: str
    js: Body
    c_arguments: list[str]
    c_outputs: list[tuple[str, str]]


@dataclass(frozen=True)
class SharedKernelView:
    """A view, for templates, of a kernel that a surface shares with the first of its kind."""

    name: str
    kernel: str
    given: list[str]
    output_names: tuple[str, ...]
    summary: str

    @property
    def arguments(self) -> list[str]:
        """What is given, each once."""
        return list(dict.fromkeys(self.given))


_BY_NAME = ("normal", "off", "tube", "seam", "round")
"""Parts of a surface that drawing a contact, or following a roll, asks for by the body's name."""


def _shared(model: Model) -> list[SharedKernelView]:
    """Return such kernels of the surfaces that are not the first of their kind."""
    views = []
    for made in model.surfaces:
        for part, kernel in made.kernels.items():
            name = f"{made.surface.name}_{part}"
            if part.startswith(_BY_NAME) and name != kernel.name:
                given = [identifier(made.sizes.get(symbol, symbol)) for symbol in kernel.arguments]
                outputs = kernel.output_names
                views.append(SharedKernelView(name, kernel.name, given, outputs, kernel.summary))
    return views


C_TYPES = {name: f"{name}_t" for name in ("uint8", "int8", "int16", "int32")} | {"bool": "uint8_t"}


@dataclass(frozen=True)
class ResultView:
    """What a template sees of a result."""

    result: Result

    def __getattr__(self, name: str) -> Any:
        return getattr(self.result, name)

    @property
    def c_type(self) -> str:
        """Its type in C."""
        return C_TYPES.get(self.result.dtype, "double")


def _kernel_view(
    program: Program, in_loop: bool, constants: Constants, split: Split | None = None
) -> KernelView:
    kernel: Kernel = program.kernel
    rest = split.rest if split else program
    kept = range(len(kernel.arguments)) if split is None else split.kept
    spelling, numpy = (C_SINGLE, NUMPY_SINGLE) if kernel.single else (C, NUMPY)
    return KernelView(
        kernel.name,
        [identifier(symbol) for symbol in kernel.arguments],
        kernel.output_names,
        kernel.summary,
        kernel.equation,
        describe_cost(program),
        kernel.single,
        (print_in_rows(program, constants) if in_loop else None) or print_program(program, numpy),
        print_program(program, ALONE, constants),
        print_program(rest, spelling),
        describe_cost(rest),
        print_program(program, JS),
        [
            f"{'M' if isinstance(a, Truth) else spelling.number} {identifier(a)}"
            for a in (kernel.arguments[k] for k in kept)
        ]
        + [f"{spelling.number} _c{k}" for k in range(len(split.made) if split else 0)],
        [(TYPES[kind], n) for n, kind in zip(kernel.output_names, kernel.kinds, strict=True)],
    )


def derivation_hash(programs: list[Program]) -> str:
    """Return a hash of what the programs compute, the same on every machine."""
    lines = [
        repr((p.kernel.name, p.kernel.output_names, p.operations, p.outputs, p.kernel.single))
        for p in programs
    ]
    return hashlib.sha256("\n".join(lines).encode()).hexdigest()[:16]


def _environment() -> jinja2.Environment:
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(str(resources.files("hoopgen.templates"))),
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        autoescape=False,
    )
    environment.filters |= FILTERS
    environment.filters["number"] = lambda value: constant(float(value), NUMPY)
    environment.filters["c_number"] = lambda value: constant(float(value), C)
    environment.filters["local"] = lambda name: local(name, 0)
    environment.filters["rows"] = lambda many: ", ".join(f"_r{k}" for k in range(many))
    environment.filters["annotated"] = lambda name: f"{name}: Any"
    environment.filters["before"] = lambda name: f"{name}_before"
    environment.filters["waiting"] = lambda name: f"waiting_{name}"
    environment.filters["c_argument"] = lambda name: f"V {name}"
    environment.filters["anchor"] = anchor
    return environment


PAGE, SUMMARY = "derivation.md.j2", "summary.md.j2"
"""The templates of what is for readers alone, and takes longest; the summary is of one scene."""


@dataclass(frozen=True)
class _Derived:
    """A scene's kernels, lowered and printed: what the templates are rendered with."""

    model: Model
    plain: Loop
    views: dict[str, KernelView]
    constants: Constants
    ready: dict[str, Split]
    costs: dict[str, int]
    derivation: str

    @property
    def context(self) -> dict[str, Any]:
        """Return the context of every template."""
        scene = self.model.scene
        return {
            "scene": scene,
            "parameters": [identifier(symbol) for symbol in scene.symbols],
            "kernels": list(self.views.values()),
        }

    def stamp(self, template: str) -> dict[str, Any]:
        """Return what says how the file of a template is made."""
        return {"stamp": stamp_of(template, self.model.scene, self.derivation)}

    def page(self) -> dict[str, Any]:
        """Return what the template of the page is given besides."""
        scene = self.model.scene
        return {
            "derivation": derivation_context(self.model),
            "house": scene in SCENES,
            "summary": scene == SCENES[0],
        }


def _derived(scene: Scene) -> _Derived:
    model: Model = build(scene)
    programs = [lower(kernel) for kernel in model.kernels]
    constants = Constants()
    plain = model.loop.plain()
    ready = splits(programs, (plain, model.loop))
    called = model.loop.called
    views = {
        p.kernel.name: _kernel_view(p, p.kernel.name in called, constants, ready.get(p.kernel.name))
        for p in programs
    }
    costs = {p.kernel.name: weighted(p.cost) for p in programs}
    return _Derived(model, plain, views, constants, ready, costs, derivation_hash(programs))


def explanation(scene: Scene) -> str:
    """Return the derivation's page of a scene, in Markdown with LaTeX."""
    derived = _derived(scene)
    own = derived.stamp(PAGE) | derived.page()
    return _environment().get_template(PAGE).render(derived.context | own)


def render_scene(scene: Scene, page: bool = True) -> dict[str, str]:
    """Return every generated file of a scene: path below generated/, and text.

    Parameters
    ----------
    scene
        What is derived.
    page
        Whether the derivation's page is wanted too.
    """
    derived = _derived(scene)
    model, views, constants, ready = derived.model, derived.views, derived.constants, derived.ready
    plain = derived.plain
    rows = {name: view.numpy.rows for name, view in views.items() if view.numpy.rows}
    alone = Alone(constants)
    loops = [
        loop_view(scene.name, derived.costs, rows, alone, ready, plain, bounds=False),
        loop_view(scene.name, derived.costs, rows, alone, ready, model.loop, bounds=True),
    ]
    environment = _environment()
    context: dict[str, Any] = derived.context | {
        "size_limits": [size_limits(scene, parameter) for parameter in scene.parameters],
        "max_size": MAX_SIZE,
        "max_time": MAX_TIME,
        "shared": _shared(model),
        "state": tuple(symbol.name for symbol in STATE),
        "loops": loops,
        "grouped": any(e.groups for e in model.loop.tables),
        "constants": constants.lines,
        "alone": alone,
        "rows": max(rows.values(), default=1),
        "outcomes": meanings(scene.ends),
        "events": EVENTS,
        "log_rows": 3 if scene.rolls else 1,
        "results": [ResultView(r) for r in model.results],
    }
    files = {}
    written = derived.page() if page else {}
    # The library in C is for its engine; the others are read, tested and called by studies.
    in_c = [view for view in views.values() if view.name in model.loop.called]
    for template, target in OUTPUTS.items():
        own = derived.stamp(template)
        if template.startswith("c/"):
            own |= {"kernels": in_c}
        if template in (PAGE, SUMMARY):
            if not page or (template == SUMMARY and scene != SCENES[0]):
                continue
            own |= written
        if template == SUMMARY:
            own |= {"worked": worked_shot(scene)}
        text = environment.get_template(template).render(context | own)
        files[_path(target, scene)] = text
    return files


def _path(target: str, scene: Scene) -> str:
    """Return where a file goes; one whose name no scene is part of is the first scene's."""
    path = PurePosixPath(target.format(scene=scene.name))
    if "{scene}" in target or scene.name == SCENES[0].name:
        return str(path)
    return str(path.with_stem(f"{path.stem}_{scene.name}"))
