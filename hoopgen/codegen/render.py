"""Rendering: what each target's backend prints, in its templates, as the files of generated/."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from pathlib import PurePosixPath
from typing import Any

import jinja2

from hoopgen.derive.model import build
from hoopgen.derive.scenes import SCENES
from hoopgen.derive.scenes.ends import meanings
from hoopgen.derive.scenes.scene import Scene
from hoopgen.derive.scenes.validity import size_limits
from hoopgen.derive.state.fields import EVENTS
from hoopgen.derive.symbolic.number_range import MAX_SIZE, MAX_TIME
from hoopgen.derive.symbolic.symbols import STATE

from .backend import TEMPLATES, Backend, KernelView, LoweredScene
from .derivation import REFERENCE_FILE, PageData, anchor, derivation_context
from .derivation.summary import worked_shot
from .elementary import FILES as ELEMENTARY_FILES
from .elementary import elementary_context
from .identifiers import FILTERS, identifier
from .program import derivation_hash, lower
from .registry import BACKENDS
from .stamp import shared_stamp_of, stamp_of
from .studies import FILES as STUDIES_FILES
from .studies import studies_context
from .variants import variants

PAGE, SUMMARY = "derivation.md.j2", "summary.md.j2"
"""The templates of what is for readers alone, and takes longest; the summary is of one scene."""

PAGES = {PAGE: REFERENCE_FILE, SUMMARY: "summary.md"}
"""The file that each of them makes."""


def outputs(targets: Iterable[str] | None = None) -> dict[str, str]:
    """Return each template of some targets, all by default, and the file that it makes."""
    chosen = BACKENDS if targets is None else targets
    return {name: file for target in chosen for name, file in BACKENDS[target].files.items()}


def _environment(backend: Backend | None = None) -> jinja2.Environment:
    """Return the environment of the templates of a target, or of the pages."""
    templates = TEMPLATES if backend is None else backend.templates
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(str(templates)),
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        autoescape=False,
    )
    environment.filters |= FILTERS
    if backend is None:
        environment.filters["anchor"] = anchor
    else:
        spelling = backend.spelling
        environment.filters["number"] = lambda value: spelling.number_text(float(value))
        environment.filters |= backend.functions
        environment.globals |= backend.functions
    return environment


def derive(scene: Scene) -> LoweredScene:
    """Return a scene, derived and lowered, as every target gets it."""
    model = build(scene)
    programs = [lower(kernel, scene.symbols) for kernel in model.kernels]
    called = model.loop.called
    return LoweredScene(model, programs, variants(model.loop), called, derivation_hash(programs))


def _context(lowered: LoweredScene, template: str) -> dict[str, Any]:
    """Return the variables of every template."""
    scene = lowered.model.scene
    return {
        "scene": scene,
        "parameters": [identifier(symbol) for symbol in scene.symbols],
        "stamp": stamp_of(template, scene, lowered.digest),
    }


def _page(lowered: LoweredScene, reference: PageData | None = None) -> dict[str, Any]:
    """Return the additional variables of the templates of the pages."""
    scene = lowered.model.scene
    return {
        "kernels": [KernelView(program) for program in lowered.programs],
        "derivation": derivation_context(lowered.model, reference),
        "house": scene in SCENES,
        "summary": scene == SCENES[0],
    }


def explanation(scene: Scene) -> str:
    """Return the whole derivation's page of a scene, in Markdown with LaTeX."""
    lowered = derive(scene)
    context = _context(lowered, PAGE) | _page(lowered)
    return _environment().get_template(PAGE).render(context)


def render_scene(
    scene: Scene, page: bool = True, targets: Iterable[str] | None = None
) -> dict[str, str]:
    """Return generated files of a scene: path below generated/, and text.

    Parameters
    ----------
    scene
        What is derived.
    page
        Whether the derivation's page is wanted too.
    targets
        The names of the targets whose files are wanted; None: of all that are registered.
    """
    lowered = derive(scene)
    files: dict[str, str] = {}
    for target in BACKENDS if targets is None else targets:
        files |= _render_target(lowered, target)
    for name, text in _pages(lowered) if page else ():
        files[name] = text
    return files


def render_elementary() -> dict[str, str]:
    """Return the files of the elementary functions: path below generated/, and text."""
    return {
        file: _render_shared(template, elementary_context(template))
        for template, file in ELEMENTARY_FILES.items()
    }


def render_studies() -> dict[str, str]:
    """Return the files of the formulas of studies that need no scene, as `render_elementary`."""
    return {
        file: _render_shared(template, studies_context(template))
        for template, file in STUDIES_FILES.items()
    }


def _render_shared(template: str, context: Mapping[str, Any]) -> str:
    """Return the text of a file that all scenes share; its template is in its target's folder."""
    environment = _environment(BACKENDS[template.partition("/")[0]])
    return environment.get_template(template).render(context)


def _render_target(lowered: LoweredScene, target: str) -> dict[str, str]:
    """Return the files of one target: path below generated/, and text."""
    backend, scene = BACKENDS[target], lowered.model.scene
    environment = _environment(backend)
    kernels = backend.kernels(lowered)
    printed = {**kernels, **backend.loop(lowered, kernels)}
    shared = _of_scene(lowered) | printed
    files: dict[str, str] = {}
    for template, file in backend.files.items():
        if "{scene}" in file:
            context = shared | _context(lowered, template)
        else:
            context = {"stamp": shared_stamp_of(template, scene)}
        files[file.format(scene=scene.name)] = environment.get_template(template).render(context)
    return files


def _of_scene(lowered: LoweredScene) -> dict[str, Any]:
    """Return the variables of a scene for the templates of every target."""
    scene = lowered.model.scene
    return {
        "size_limits": [size_limits(scene, parameter) for parameter in scene.parameters],
        "max_size": MAX_SIZE,
        "max_time": MAX_TIME,
        "state": tuple(symbol.name for symbol in STATE),
        "outcomes": meanings(scene.ends),
        "events": EVENTS,
        "log_rows": 3 if scene.rolls else 1,
    }


def _pages(lowered: LoweredScene) -> Iterator[tuple[str, str]]:
    """Yield the pages for readers: path below generated/, and text."""
    scene, environment = lowered.model.scene, _environment()
    reference = derivation_context(build(SCENES[0])) if scene in SCENES[1:] else None
    own = _page(lowered, reference)
    for template, file in PAGES.items():
        if template == SUMMARY:
            if scene != SCENES[0]:
                continue
            own |= {"worked": worked_shot(scene)}
        context = _context(lowered, template) | own
        yield _page_path(file, scene), environment.get_template(template).render(context)


def _page_path(page: str, scene: Scene) -> str:
    """Return the path of a scene's page; the name without a scene is the first scene's."""
    path = PurePosixPath(page)
    if scene.name == SCENES[0].name:
        return str(path)
    return str(path.with_stem(f"{path.stem}_{scene.name}"))
