"""Rendering: kernels into templates into generated/, and the check that generated/ is current."""

from __future__ import annotations

import difflib
import hashlib
from collections.abc import Callable
from dataclasses import dataclass
from importlib import resources
from importlib.metadata import version
from pathlib import Path, PurePosixPath

import jinja2

from hoopgen.derive.events import SHARES
from hoopgen.derive.kernel import Kernel
from hoopgen.derive.model import Model, SurfaceKernels, build
from hoopgen.derive.scene import Scene
from hoopgen.derive.scenes import SCENES
from hoopgen.outputs import write

from .derivation import derivation_context
from .printers import JS, NUMPY, Body, C, print_program
from .program import Program, lower

OUTPUTS = {
    "numpy/kernels.py.j2": "numpy/{scene}.py",
    "c/kernels.h.j2": "c/{scene}_kernels.h",
    "c/engine.h.j2": "c/{scene}_engine.h",
    "c/scene.h.j2": "c/{scene}.h",
    "c/scene.c.j2": "c/{scene}.c",
    "js/flight.js.j2": "js/{scene}.js",
    "derivation.md.j2": "derivation.md",
}
"""Each template, and the file that it makes."""

KEPT = ("__init__.py", "numpy/__init__.py")
"""Files of generated/ that are not generated."""

STEP_LIMIT = 200
"""Steps after which a search gives up and the shot is uncertain; a search takes about five."""

COST_WORDS = {
    "add": "additions",
    "sub": "subtractions",
    "mul": "multiplications",
    "div": "divisions",
    "sqrt": "square roots",
    "neg": "negations",
    "abs": "absolute values",
    "less": "comparisons",
    "at_most": "comparisons",
    "select": "selections",
}


@dataclass(frozen=True)
class KernelView:
    """What a template sees of a kernel."""

    name: str
    arguments: list[str]
    output_names: tuple[str, ...]
    summary: str
    equation: str
    cost: str
    numpy: Body
    c: Body
    js: Body


@dataclass(frozen=True)
class SurfaceView:
    """What a template sees of a surface."""

    index: int
    name: str
    windows: int
    bounds: tuple[str, ...]
    constants: dict[str, str]

    @property
    def bounded(self) -> bool:
        """True if it has bounds."""
        return bool(self.bounds)


def describe_cost(program: Program) -> str:
    """Return the operation count of a program as a sentence."""
    words: dict[str, int] = {}
    for name, count in program.cost.items():
        words[COST_WORDS[name]] = words.get(COST_WORDS[name], 0) + count
    total = sum(words.values())
    if not total:
        return "No operations."
    ordered = [w for w in dict.fromkeys(COST_WORDS.values()) if w in words]
    parts = [f"{words[w]} {w if words[w] > 1 else w.removesuffix('s')}" for w in ordered]
    return f"{total} operation{'s' * (total > 1)}: {', '.join(parts)}."


def _kernel_view(program: Program) -> KernelView:
    kernel: Kernel = program.kernel
    return KernelView(
        kernel.name,
        [symbol.name for symbol in kernel.arguments],
        kernel.output_names,
        kernel.summary,
        kernel.equation,
        describe_cost(program),
        print_program(program, NUMPY),
        print_program(program, C),
        print_program(program, JS),
    )


def _surface_view(index: int, surface: SurfaceKernels) -> SurfaceView:
    bounds = surface.kernels["bounds"].output_names if "bounds" in surface.kernels else ()
    constants = {name: f"p.{name}" for name in surface.constants}
    return SurfaceView(index, surface.surface.name, surface.window_count, bounds, constants)


def derivation_hash(programs: list[Program]) -> str:
    """Return a hash of what the programs compute, the same on every machine."""
    lines = [
        repr((p.kernel.name, p.kernel.output_names, p.operations, p.outputs)) for p in programs
    ]
    return hashlib.sha256("\n".join(lines).encode()).hexdigest()[:16]


def _caller(views: dict[str, KernelView], scene: str) -> Callable[..., str]:
    """Return the template function that writes a call: arguments by name, some renamed."""

    def call(name: str, **renamed: str) -> str:
        arguments = [renamed.pop(a, a) for a in views[name].arguments]
        return f"LANES({scene}_{name})({', '.join(arguments)})"

    return call


def _environment() -> jinja2.Environment:
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(str(resources.files("hoopgen.templates"))),
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        autoescape=False,
    )
    environment.filters["annotated"] = lambda name: f"{name}: Any"
    environment.filters["quoted"] = lambda name: f'"{name}"'
    environment.filters["c_argument"] = lambda name: f"V {name}"
    return environment


def _stamp(template: str, scene: str, derivation: str) -> Callable[[str], str]:
    lines = [
        f"Generated from templates/{template}, scene {scene}, derivation {derivation},",
        f"with SymPy {version('sympy')} and Jinja2 {version('jinja2')}. Do not edit: "
        "change derive/ or templates/",
        "and run `make generate`.",
    ]

    def stamp(indent: str) -> str:
        return "\n".join(indent + line for line in lines)

    return stamp


def render_scene(scene: Scene) -> dict[str, str]:
    """Return every generated file of a scene: path below generated/, and text."""
    model: Model = build(scene)
    programs = [lower(kernel) for kernel in model.kernels]
    views = {p.kernel.name: _kernel_view(p) for p in programs}
    surfaces = [_surface_view(i, s) for i, s in enumerate((*model.surfaces, model.finish))]
    derivation = derivation_hash(programs)
    environment = _environment()
    context = {
        "scene": scene,
        "parameters": [p.symbol.name for p in scene.parameters],
        "kernels": list(views.values()),
        "surfaces": surfaces[:-1],
        "finish": surfaces[-1],
        "all_surfaces": surfaces,
        "step_limit": STEP_LIMIT,
        "shares": [float(share) for share in SHARES],
        "call": _caller(views, scene.name),
        "derivation": derivation_context(model),
    }
    files = {}
    for template, target in OUTPUTS.items():
        stamp = _stamp(template, scene.name, derivation)
        text = environment.get_template(template).render(context | {"stamp": stamp})
        files[_path(target, scene)] = text
    return files


def _path(target: str, scene: Scene) -> str:
    """Return where a file goes; one whose name no scene is part of is the first scene's."""
    path = PurePosixPath(target.format(scene=scene.name))
    if "{scene}" in target or scene.name == SCENES[0].name:
        return str(path)
    return str(path.with_stem(f"{path.stem}_{scene.name}"))


def _render_all() -> dict[str, str]:
    files: dict[str, str] = {}
    for scene in SCENES:
        files |= render_scene(scene)
    return files


def generate(root: Path) -> list[Path]:
    """Write generated/ below `root` and return the files that changed.

    Parameters
    ----------
    root
        A source checkout. Extra files in generated/ are removed.
    """
    folder = root / "generated"
    files = _render_all()
    changed = []
    for name, text in files.items():
        path = folder / name
        if not path.exists() or path.read_text(encoding="utf-8") != text:
            path.parent.mkdir(parents=True, exist_ok=True)
            write(path, text)
            changed.append(path)
    for name in _extra(folder, files):
        (folder / name).unlink()
        changed.append(folder / name)
    return changed


def check(root: Path) -> list[str]:
    """Return how generated/ below `root` differs from what would be generated.

    Each entry is a missing file, an extra file, or a unified difference; there is none if all is
    as it should be.
    """
    folder = root / "generated"
    files = _render_all()
    differences = [f"extra file: generated/{name}" for name in _extra(folder, files)]
    for name, text in files.items():
        path = folder / name
        if not path.exists():
            differences.append(f"missing file: generated/{name}")
            continue
        found = path.read_text(encoding="utf-8")
        if found != text:
            lines = difflib.unified_diff(
                found.splitlines(),
                text.splitlines(),
                f"generated/{name} (as it is)",
                f"generated/{name} (as derived)",
                lineterm="",
                n=1,
            )
            differences.append("\n".join(lines))
    return differences


def _extra(folder: Path, files: dict[str, str]) -> list[str]:
    present = (p for p in folder.rglob("*") if p.is_file() and "__pycache__" not in p.parts)
    names = sorted(p.relative_to(folder).as_posix() for p in present)
    return [name for name in names if name not in files and name not in KEPT]
