"""NumPy: rows of shots, and numbers where shots are few."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from importlib.resources.abc import Traversable
from typing import Any

from hoopgen.derive.ir.event_tree import live_before, reads, writes
from hoopgen.derive.ir.kernel import Kernel
from hoopgen.derive.model import Model
from hoopgen.derive.motion.air_series import SERIES_KERNELS
from hoopgen.derive.symbolic.isomorphism import Symbols
from hoopgen.derive.symbolic.symbols import change_of

from ..backend import TEMPLATES, KernelView, LoweredScene
from ..formatter import Spelling
from ..identifiers import identifier
from ..program import Program
from ..straight_line import PrintedBody, print_body, straight_line
from ..variants import Variant
from .constants import Constants, number_type
from .formatter import ONE_SHOT_FORMATTER, ROWS_FORMATTER
from .loop import NumPyLoop, local
from .options import Options
from .record import ResultRecord
from .scalar import ScalarKernel
from .scratch import in_rows
from .spelling import NUMPY, ONE_SHOT

__all__ = ["NUMPY_BACKEND", "NumPyBackend"]

FUNCTIONS: dict[str, Callable[..., Any]] = {
    "annotated": lambda name: f"{name}: Any",
    "local": lambda name: local(name, 0),
    "row_names": lambda many: ", ".join(f"_r{k}" for k in range(many)),
}


@dataclass(frozen=True)
class NumPyKernel(KernelView):
    """A kernel in NumPy.

    Attributes
    ----------
    numpy, alone
        It for rows of shots, and for one shot.
    """

    numpy: PrintedBody
    alone: PrintedBody


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
        """The arguments of the function, each once."""
        return list(dict.fromkeys(self.given))


_BY_NAME = ("normal", "distance", "rolling_surface", "seam", "round", "vary")
"""Parts of a surface that drawing a contact, following a roll, or a variation asks for by the
body's name."""


def _own_arguments(kernel: Kernel, own: Symbols) -> list[str]:
    """Return the arguments of a kernel for another surface or law than the first of its kind."""
    own = {**own, **{change_of(first): change_of(other) for first, other in own.items()}}
    return [identifier(own.get(symbol, symbol)) for symbol in kernel.arguments]


def _shared(model: Model) -> list[SharedKernelView]:
    """Return such kernels of the surfaces that are not the first of their kind."""
    views = []
    for made in model.surfaces:
        for part, kernel in made.kernels.items():
            name = f"{made.surface.name}_{part}"
            if part.startswith(_BY_NAME) and name != kernel.name:
                given, outputs = _own_arguments(kernel, made.parameters), kernel.output_names
                views.append(SharedKernelView(name, kernel.name, given, outputs, kernel.summary))
    return views


def _laws(model: Model) -> dict[str, tuple[str, list[str]]]:
    """Return by body the kernel of its contact law's variation, and what it is given."""
    varied = {law: kernels["vary"] for law, kernels in model.laws.items()}
    return {
        body.name: (
            varied[body.law].name,
            _own_arguments(varied[body.law], model.law_parameters[body.law]),
        )
        for body in model.scene.bodies
    }


@dataclass(frozen=True)
class NumPyVariant:
    """A variant of the event loop in NumPy.

    Attributes
    ----------
    lines
        The lines of each stage.
    columns
        By stage, the variables that it reads, and those that it writes with their names.
    """

    variant: Variant
    lines: Mapping[str, list[str]] = field(repr=False)
    columns: Mapping[str, tuple[list[str], dict[str, str]]]

    def __getattr__(self, name: str) -> Any:
        return getattr(self.variant, name)


@dataclass(frozen=True)
class NumPyBackend:
    """The target NumPy."""

    name: str = "numpy"
    options: Options = field(default_factory=Options)
    templates: Traversable = TEMPLATES
    files: Mapping[str, str] = field(
        default_factory=lambda: {"numpy/kernels.py.j2": "numpy/{scene}.py"}
    )
    spelling: Spelling = NUMPY
    functions: Mapping[str, Callable[..., Any]] = field(default_factory=lambda: dict(FUNCTIONS))

    def kernels(self, lowered: LoweredScene) -> Mapping[str, Any]:
        """Return the kernels, and the numbers in them."""
        constants = Constants()
        views = [self._kernel(p, lowered.called, constants) for p in lowered.programs]
        rows = max((view.numpy.rows for view in views), default=0)
        return {"kernels": views, "constants": constants, "rows": rows or 1}

    def _kernel(self, program: Program, called: Iterable[str], constants: Constants) -> NumPyKernel:
        body = None
        if program.kernel.name in called:
            body = in_rows(program, constants, self.options.min_operations_in_rows)
        own = number_type(program.single)
        # One number of Python's cannot be divided by zero.
        alone = straight_line(program, ONE_SHOT, lambda value: constants.name(value, own))
        return NumPyKernel(
            program,
            print_body(body or straight_line(program, NUMPY), ROWS_FORMATTER),
            print_body(alone, ONE_SHOT_FORMATTER),
        )

    def loop(self, lowered: LoweredScene, kernels: Mapping[str, Any]) -> Mapping[str, Any]:
        """Return the event loop in its variants, and the functions for one shot."""
        alone = ScalarKernel(kernels["constants"])
        with_rows = {view.name for view in kernels["kernels"] if view.numpy.rows}
        views = [self._variant(lowered, v, alone, with_rows) for v in lowered.variants]
        return {
            "loops": views,
            "alone": alone,
            "fixed": any(
                "_fixed(" in line for v in views for own in v.lines.values() for line in own
            ),
            "grouped": any(each.groups for each in lowered.model.loop.tables),
            "shared": _shared(lowered.model),
            "laws": _laws(lowered.model),
            "pieces": [] if lowered.model.scene.flight.exact else ["scale", *SERIES_KERNELS],
            "record": ResultRecord(lowered.model),
        }

    def _variant(
        self,
        lowered: LoweredScene,
        variant: Variant,
        alone: ScalarKernel,
        with_rows: Iterable[str],
    ) -> NumPyVariant:
        loop = variant.loop
        short = {name for name, kind in loop.kinds.items() if kind == "single"}
        available = {*(field.name for field in loop.fields), *loop.parameters, *loop.job}
        lines: dict[str, list[str]] = {}
        columns: dict[str, tuple[list[str], dict[str, str]]] = {}
        for stage, (nodes, after) in variant.stages.items():
            lowering = NumPyLoop(
                lowered.prefix,
                lowered.costs,
                self.options.max_inline_cost,
                max_inline_cost_in_turns=self.options.max_inline_cost_in_turns,
                rows=frozenset(with_rows),
                alone=alone,
                short=set(short),
            )
            assigned = set(writes(nodes))
            read: Sequence[str] = sorted(
                live_before(nodes, after) & available & (reads(nodes) | assigned)
            )
            names = {name: local(name, 0) for name in read}
            statements = lowering.body(nodes, names, set(after))
            written = {name: names[name] for name in sorted(after & assigned & set(names))}
            lines[stage] = ROWS_FORMATTER.lines(statements)
            columns[stage] = (list(read), written)
            available |= set(written)
        return NumPyVariant(variant, lines, columns)


NUMPY_BACKEND = NumPyBackend()
