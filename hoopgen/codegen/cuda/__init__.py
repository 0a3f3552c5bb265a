"""CUDA: one thread for each shot, in scalars; any compiler of C++ compiles it, too."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from importlib.resources.abc import Traversable
from typing import Any

from hoopgen.derive.ir.event_tree import writes
from hoopgen.derive.symbolic.conditionals import Boolean

from ..backend import TEMPLATES, KernelView, LoweredScene, ResultView
from ..formatter import Spelling
from ..identifiers import identifier
from ..rerolling import parameter_kernels, rerolled
from ..statements import Number
from ..straight_line import PrintedBody, print_body, straight_line
from .loop import ShotLoop, function
from .spelling import CUDA_FORMATTER, DOUBLE, SINGLE, TYPES, parameter_of_shot

__all__ = ["CUDA_BACKEND", "CudaBackend"]


C_TYPES = {
    "bool": "unsigned char",
    "uint8": "unsigned char",
    "int8": "signed char",
    "int16": "short",
    "int32": "int",
}
"""The types of results that are whole numbers; without headers these have no other names."""


_LINE = 92
"""Characters of a line of declarations."""


@dataclass(frozen=True)
class CudaKernel(KernelView):
    """A kernel in CUDA.

    Attributes
    ----------
    numbers
        By name, the numbers of the scene's parameters, if it is given all of them.
    """

    types = TYPES
    numbers: Mapping[str, int] = field(default_factory=dict)

    @property
    def function(self) -> str:
        """The name of its function; the struct of its results has `_out` behind it."""
        return function(self.name)

    @property
    def body(self) -> PrintedBody:
        """Its statements and results."""
        if self.numbers:
            own = rerolled(self.program, self.numbers, DOUBLE, parameter_of_shot)
        else:
            own = straight_line(self.program, SINGLE if self.single else DOUBLE)
        return print_body(own, CUDA_FORMATTER)

    @property
    def parameters(self) -> list[str]:
        """Its parameters, each with its type."""
        number = "float" if self.single else "double"
        found = [
            f"{'bool' if isinstance(argument, Boolean) else number} {identifier(argument)}"
            for argument in self.program.kernel.arguments
            if identifier(argument) not in self.numbers
        ]
        return ["const shot_parameters &_given", *found] if self.numbers else found


@dataclass(frozen=True)
class CudaBackend:
    """The target CUDA."""

    name: str = "cuda"
    options: None = None
    templates: Traversable = TEMPLATES
    files: Mapping[str, str] = field(
        default_factory=lambda: {"cuda/scene.cu.j2": "cuda/{scene}.cu"}
    )
    spelling: Spelling = DOUBLE
    functions: Mapping[str, Callable[..., Any]] = field(default_factory=dict)

    def kernels(self, lowered: LoweredScene) -> Mapping[str, Any]:
        """Return the kernels that the event loop evaluates."""
        by_numbers = parameter_kernels(lowered.model.loop)
        numbers = {identifier(s): k for k, s in enumerate(lowered.model.scene.symbols)}
        return {
            "kernels": [
                CudaKernel(program, numbers if program.kernel.name in by_numbers else {})
                for program in lowered.programs
                if program.kernel.name in lowered.called
            ]
        }

    def loop(self, lowered: LoweredScene, kernels: Mapping[str, Any]) -> Mapping[str, Any]:
        """Return the event loop, its tables, and the results that it writes.

        `lines` are the lines of each stage, `used` the parameters that these read by name, with
        their numbers, and `variables` by type those of a shot, with their values before its start.
        """
        loop, (plain, bounded) = lowered.model.loop, lowered.variants
        lowering = ShotLoop(loop.parameters, parameter_kernels(loop), loop.plain_values)
        lines = {
            name: CUDA_FORMATTER.lines(lowering.body(nodes, plain.stages.get(name, ((), set()))[0]))
            for name, (nodes, _) in bounded.stages.items()
        }
        nodes = [node for own, _ in bounded.stages.values() for node in own]
        starts = {f.name: f.start for f in loop.fields if f.start is not None} | loop.plain_values
        variables: dict[str, list[str]] = {}
        for name, kind in (bounded.kinds | writes(nodes)).items():
            start = Number(float(starts.get(name, 0.0)), kind == "single")
            value = "false" if kind == "truth" else CUDA_FORMATTER.expression(start)
            variables.setdefault(TYPES[kind], []).append(f"{name} = {value}")
        return {
            "loops": lowered.variants,
            "lines": lines,
            "used": {n: k for k, n in enumerate(lowering.parameters) if n in lowering.used},
            "variables": {kind: _wrapped(names) for kind, names in variables.items()},
            "tables": [CUDA_FORMATTER.statement(table) for table in lowering.tables],
            "results": [ResultView(result, C_TYPES) for result in lowered.model.results],
        }


def _wrapped(declared: Sequence[str]) -> str:
    """Return declarations in lines, none of which begins within an entry."""
    found = ""
    room = 0
    for own in declared:
        if len(own) + 2 > room:
            found, room = found.rstrip() + "\n" * bool(found), _LINE
        found, room = f"{found}{own}, ", room - len(own) - 2
    return found.removesuffix(", ")


CUDA_BACKEND = CudaBackend()
