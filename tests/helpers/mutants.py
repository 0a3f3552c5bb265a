"""Faults put into derive/ on purpose: a text, a decision or the event loop changed; engines of it.

A fault is put in once, and the scene is derived and printed anew: every target runs what was
changed. What it would replace must be there: a fault that no longer applies fails.
"""

from __future__ import annotations

import inspect
import sys
import textwrap
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest
from hoopgen.derive import model
from hoopgen.derive.ir.event_tree import Call, Node
from hoopgen.derive.loop.loop import Loop
from hoopgen.derive.scenes.hoop import HOOP
from hoopgen.derive.scenes.scene import Scene
from hoopgen.derive.surfaces import Surface
from hoopgen.generated.numpy import hoop
from numpy.typing import NDArray

from hoopgen.codegen import render
from hoopgen.engine import native, numpy_backend
from hoopgen.engine.result_arrays import ResultArrays
from tests.helpers.compiled import load_module, shared_library

Patch = Callable[[pytest.MonkeyPatch], None]
Run = Callable[[NDArray[np.float64], list[Any], int, ResultArrays], None]
"""An engine's call: states, parameters, max_contacts, and the arrays for its results."""


def changed(function: Any, old: str, new: str) -> Any:
    """Return the function, the property or the class with `old` replaced in its text."""
    inner = function.fget if isinstance(function, property) else function
    source = textwrap.dedent(inspect.getsource(inner))
    assert old in source, f"{inner.__name__} has no {old!r}"
    namespace = dict(vars(sys.modules[inner.__module__]))
    exec("from __future__ import annotations\n" + source.replace(old, new), namespace)
    return namespace[inner.__name__]


def in_text(owner: Any, name: str, old: str, new: str) -> Patch:
    """Replace text of a function where it is looked up."""
    return lambda patch: patch.setattr(owner, name, changed(getattr(owner, name), old, new))


def in_text_for(surface: str, owner: Any, name: str, old: str, new: str) -> Patch:
    """Replace text of a function of a surface, for that surface alone."""

    def patched(patch: pytest.MonkeyPatch) -> None:
        usual = getattr(owner, name)
        faulty = changed(usual, old, new)

        def chosen(given: Surface, *rest: Any) -> Any:
            return (faulty if given.name == surface else usual)(given, *rest)

        patch.setattr(owner, name, chosen)

    return patched


def in_decisions(module: ModuleType, old: str, new: str) -> Patch:
    """Replace text of a module whose decisions are its `KERNELS`."""

    def patched(patch: pytest.MonkeyPatch) -> None:
        source = inspect.getsource(module)
        assert old in source, f"{module.__name__} has no {old!r}"
        namespace = {"__name__": module.__name__, "__package__": module.__package__}
        exec(source.replace(old, new), namespace)
        faulty = {
            name: kernel
            for name, kernel in namespace["KERNELS"].items()
            if kernel != module.KERNELS[name]
        }
        assert faulty, f"no decision has {old!r}"
        for name, kernel in faulty.items():
            patch.setitem(module.KERNELS, name, kernel)

    return patched


def in_tree(change: Callable[[Node], Iterable[Node]]) -> Patch:
    """Replace every node of the event loop by others, a body before what guards it."""

    def changed_nodes(nodes: Iterable[Node]) -> tuple[Node, ...]:
        inner = (
            n if isinstance(n, Call) else replace(n, body=changed_nodes(n.body)) for n in nodes
        )
        return tuple(new for node in inner for new in change(node))

    def patched(patch: pytest.MonkeyPatch) -> None:
        usual = model.event_loop

        def faulty(*given: Any) -> Loop:
            loop = usual(*given)
            stages = {name: changed_nodes(nodes) for name, nodes in loop.stages.items()}
            assert stages != dict(loop.stages), "the event loop has no such node"
            return replace(loop, stages=stages)

        patch.setattr(model, "event_loop", faulty)

    return patched


def with_limits(scene: Scene, plate: str, change: Callable[[tuple[Any, ...]], Any]) -> Scene:
    """Return the scene with other limits of a plate."""

    def other(face: Surface) -> Surface:
        return replace(face, limits=change(face.limits)) if face.name == plate else face

    bodies = (replace(body, faces=tuple(map(other, body.faces))) for body in scene.bodies)
    return replace(scene, bodies=tuple(bodies))


@dataclass(frozen=True)
class Fault:
    """A fault put into derive/.

    Attributes
    ----------
    patch
        Of texts, decisions or the loop, as long as it is derived.
    scene
        Of the scene.
    in_c
        Whether C runs it, too: that takes seconds to compile.
    """

    name: str
    patch: Patch = lambda _: None
    scene: Callable[[Scene], Scene] = lambda scene: scene
    in_c: bool = False


def derived(fault: Fault) -> dict[str, str]:
    """Return the generated files of the hoop with a fault: a module of NumPy, and all of C."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(model, "check", lambda _: None)  # what it refuses is to trip engines, too
        fault.patch(patch)
        return render.render_scene(fault.scene(HOOP), page=False, targets=("numpy", "c"))


def numpy_module(files: dict[str, str], folder: Path) -> ModuleType:
    """Return the generated NumPy module, imported."""
    source = folder / "derived.py"
    source.write_text(files["numpy/hoop.py"], encoding="utf-8")
    return load_module(source)


def numpy_engine(kernels: ModuleType) -> Run:
    """Return the NumPy engine of a generated module."""

    def run(
        states: NDArray[np.float64], parameters: list[Any], most: int, out: ResultArrays
    ) -> None:
        numpy_backend.run(kernels, states, parameters, None, most, out)

    return run


def c_engine(files: dict[str, str], folder: Path) -> Run:
    """Return the C engine, compiled in two seconds: one lane, hardly optimized."""
    for name, text in files.items():
        if name.startswith("c/"):
            (folder / name.removeprefix("c/")).write_text(text, encoding="utf-8")
    library = shared_library(folder / "hoop.c", "-O1", "-DHOOP_WIDEST=1")
    scene = native.Library(library, hoop)

    def run(
        states: NDArray[np.float64], parameters: list[Any], most: int, out: ResultArrays
    ) -> None:
        given = [p if isinstance(p, float) else np.ascontiguousarray(p) for p in parameters]
        scene.run(np.ascontiguousarray(states), given, None, most, out, np.zeros(1, np.int32))

    return run
