"""C: lanes of shots abreast, and lists of those that do the same."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from importlib.resources.abc import Traversable
from typing import Any

from hoopgen.derive.scenes import SCENES

from ..backend import TEMPLATES, LoweredScene, ResultView
from ..formatter import Spelling
from ..identifiers import identifier
from ..rerolling import parameter_kernels
from .formatter import macro_definitions
from .hoisted import Hoisted
from .merging import merge_variants
from .options import Options
from .spelling import LANES
from .view import CKernel, loop_view

FILES = {
    "c/kernels.h.j2": "c/{scene}_kernels.h",
    "c/lanes.h.j2": "c/lanes.h",
    "c/loop.h.j2": "c/{scene}_loop.h",
    "c/engine.h.j2": "c/{scene}_engine.h",
    "c/environment.h.j2": "c/environment.h",
    "c/arithmetic.h.j2": "c/arithmetic.h",
    "c/exact.h.j2": "c/exact.h",
    "c/scene.h.j2": "c/{scene}.h",
    "c/scene.c.j2": "c/{scene}.c",
}

C_TYPES = {name: f"{name}_t" for name in ("uint8", "int8", "int16", "int32")} | {"bool": "uint8_t"}

FUNCTIONS: dict[str, Callable[..., Any]] = {
    "before": lambda name: f"{name}_before",
    "macro_definitions": macro_definitions,
}


@dataclass(frozen=True)
class CBackend:
    """The target C."""

    name: str = "c"
    options: Options = field(default_factory=Options)
    templates: Traversable = TEMPLATES
    files: Mapping[str, str] = field(default_factory=lambda: dict(FILES))
    spelling: Spelling = LANES
    functions: Mapping[str, Callable[..., Any]] = field(default_factory=lambda: dict(FUNCTIONS))

    def kernels(self, lowered: LoweredScene) -> Mapping[str, Any]:
        """Return the kernels that the event loop evaluates: the library serves its engine alone."""
        own = lowered.partial_evaluations
        names = lowered.called | {call.kernel.name for call in lowered.model.loop.shortcuts}
        called = [p for p in lowered.programs if p.kernel.name in names]
        by_columns = parameter_kernels(lowered.model.loop)
        symbols = lowered.model.scene.symbols
        numbers = {identifier(symbol): k for k, symbol in enumerate(symbols)}
        kernels = [
            CKernel(p, own.get(p.kernel.name), numbers if p.kernel.name in by_columns else {})
            for p in called
        ]
        return {"kernels": kernels}

    def loop(self, lowered: LoweredScene, kernels: Mapping[str, Any]) -> Mapping[str, Any]:
        """Return the event loop in its variants, and the results that it writes."""
        own = lowered.partial_evaluations
        hoisted = Hoisted(own)
        # The last bounds errors, and has all that the first has.
        # A compiler's time grows faster than a function, and most of these scenes have many bodies.
        apart = lowered.model.scene not in SCENES
        views = [
            loop_view(lowered, v, self.options, hoisted, apart=apart)
            for v in reversed(lowered.variants)
        ]
        return {
            "loops": views[::-1],
            "fixed": hoisted.counts,
            "merge_variants": merge_variants,
            "results": [ResultView(r, C_TYPES) for r in lowered.model.results],
        }


C_BACKEND = CBackend()
