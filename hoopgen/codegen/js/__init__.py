"""JavaScript: flights, and where a body is touched, for pages that show shots in motion."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from importlib.resources.abc import Traversable
from typing import Any

from ..backend import TEMPLATES, KernelView, LoweredScene
from ..formatter import ONE_SHOT, Formatter, Spelling
from ..straight_line import PrintedBody, print_body, straight_line

JS = Spelling(
    operations=ONE_SHOT
    | {"sqrt": "Math.sqrt({0})", "abs": "Math.abs({0})", "equal": "({0} === {1})"},
)
JS_FORMATTER = Formatter(JS, JS, "const {name} = {value};")


@dataclass(frozen=True)
class JsKernel(KernelView):
    """A kernel in JavaScript."""

    @property
    def body(self) -> PrintedBody:
        """Its statements and results."""
        return print_body(straight_line(self.program, JS), JS_FORMATTER)


@dataclass(frozen=True)
class JsBackend:
    """The target JavaScript."""

    name: str = "js"
    options: None = None
    templates: Traversable = TEMPLATES
    files: Mapping[str, str] = field(default_factory=lambda: {"js/flight.js.j2": "js/{scene}.js"})
    spelling: Spelling = JS
    functions: Mapping[str, Callable[..., Any]] = field(default_factory=dict)

    def kernels(self, lowered: LoweredScene) -> Mapping[str, Any]:
        """Return the kernels of flights, and the normals of the bodies."""
        bodies = (body.name for body in lowered.model.scene.bodies)
        names = {"flight", "descent", *(f"{body}_normal" for body in bodies)}
        kernels = [JsKernel(program) for program in lowered.programs]
        return {"kernels": [kernel for kernel in kernels if kernel.name in names]}

    def loop(self, lowered: LoweredScene, kernels: Mapping[str, Any]) -> Mapping[str, Any]:
        """Return nothing: the event loop is not written in JavaScript."""
        return {}


JS_BACKEND = JsBackend()
