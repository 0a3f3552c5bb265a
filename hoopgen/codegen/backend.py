"""The interface between the generator and a target: what a `Backend` is given, and what it returns.

A target is one folder of hoopgen/codegen/ and one of templates/. Its `Backend` says how kernels and
the event loop are written there, and into which files; `registry` lists the targets.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from importlib import resources
from importlib.resources.abc import Traversable
from itertools import groupby
from typing import Any, ClassVar, Protocol

from hoopgen.derive.ir.kernel import Kind
from hoopgen.derive.model import Model
from hoopgen.derive.state.fields import ResultField

from .cost import describe_cost, weighted
from .formatter import Spelling
from .hoisting import PartialEvaluation, partial_evaluations
from .identifiers import identifier
from .program import Program
from .variants import Variant

TEMPLATES: Traversable = resources.files("hoopgen.templates")
"""The folder of the templates of all targets that come with hoopgen."""


@dataclass(frozen=True)
class LoweredScene:
    """A scene as every target gets it: lowered kernels, and the variants of the event loop.

    Attributes
    ----------
    model
        What was derived.
    programs
        The kernels, lowered, in the order in which they are written.
    variants
        The event loop without and with bounds on errors.
    called
        The names of the kernels that the event loop evaluates.
    digest
        A hash of all that the programs compute.
    """

    model: Model
    programs: Sequence[Program] = field(repr=False)
    variants: tuple[Variant, ...]
    called: frozenset[str]
    digest: str

    @cached_property
    def partial_evaluations(self) -> dict[str, PartialEvaluation]:
        """The kernels of the event loop that have something loop invariant, by name."""
        return partial_evaluations(self.programs, [variant.loop for variant in self.variants])

    @property
    def prefix(self) -> str:
        """The name of the scene, with which names begin that are visible outside of a file."""
        return self.model.scene.name

    @property
    def costs(self) -> dict[str, int]:
        """Cost of each kernel, about, in additions."""
        return {program.kernel.name: weighted(program.cost) for program in self.programs}


@dataclass(frozen=True)
class KernelView:
    """A view of a kernel for templates."""

    program: Program
    types: ClassVar[Mapping[Kind, str]]
    """The types of outputs, in languages like C."""

    @property
    def name(self) -> str:
        """The name of its function."""
        return self.program.kernel.name

    @property
    def arguments(self) -> list[str]:
        """The names of its arguments, in calling order."""
        return [identifier(symbol) for symbol in self.program.kernel.arguments]

    @property
    def outputs(self) -> list[tuple[str, list[str]]]:
        """Type and names of the outputs that follow one another and have the same type."""
        kernel = self.program.kernel
        pairs = zip(kernel.kinds, kernel.output_names, strict=True)
        alike = groupby(pairs, lambda pair: pair[0])
        return [(self.types[kind], [name for _, name in own]) for kind, own in alike]

    @property
    def output_names(self) -> tuple[str, ...]:
        """The names of its outputs, in returning order."""
        return self.program.kernel.output_names

    @property
    def summary(self) -> str:
        """One line: what it computes."""
        return self.program.kernel.summary

    @property
    def equation(self) -> str:
        """The equation that it implements."""
        return self.program.kernel.equation

    @property
    def cost(self) -> str:
        """Its operation count, as a sentence."""
        return describe_cost(self.program)

    @property
    def single(self) -> bool:
        """True if it computes in single precision."""
        return self.program.single


@dataclass(frozen=True)
class ResultView:
    """A view of a result for templates of languages like C.

    Attributes
    ----------
    types
        The types of whole numbers, by their names in NumPy.
    """

    result: ResultField
    types: Mapping[str, str] = field(repr=False)

    def __getattr__(self, name: str) -> Any:
        return getattr(self.result, name)

    @property
    def c_type(self) -> str:
        """Its type."""
        return self.types.get(self.result.dtype, "double")

    @property
    def tests_count(self) -> bool:
        """True if it says whether a field that counts is not zero."""
        return self.result.dtype == "bool" and self.result.columns[0] != self.result.name


class Backend(Protocol):
    """A target: how kernels and the event loop are written, and into which files.

    Attributes
    ----------
    name
        What users and registries call it.
    options
        The thresholds by which it chooses between ways of writing the same.
    templates
        The folder in which its templates are, by the names of `files`.
    spelling
        How it writes operations and numbers; the templates' filter `number` is from it.
    functions
        By name, what its templates call, as filters too.
    files
        By template, the file that it makes below generated/; `{scene}` is the scene's name. A file
        without it is the same for every scene, and its template is given nothing of one.
    """

    @property
    def name(self) -> str: ...  # noqa: D102

    @property
    def options(self) -> Any: ...  # noqa: D102

    @property
    def templates(self) -> Traversable: ...  # noqa: D102

    @property
    def files(self) -> Mapping[str, str]: ...  # noqa: D102

    @property
    def spelling(self) -> Spelling: ...  # noqa: D102

    @property
    def functions(self) -> Mapping[str, Callable[..., Any]]: ...  # noqa: D102

    def kernels(self, lowered: LoweredScene) -> Mapping[str, Any]:
        """Return the templates' variables for the kernels, by key."""

    def loop(self, lowered: LoweredScene, kernels: Mapping[str, Any]) -> Mapping[str, Any]:
        """Return the templates' variables for the event loop, given the result of `kernels`.

        Parameters
        ----------
        lowered
            The scene with the operations of its kernels and the variants of its event loop.
        kernels
            The variables that `kernels` returned for it.

        Returns
        -------
        Mapping
            The variables by name, beside those of the kernels.
        """
