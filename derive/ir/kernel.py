"""A kernel: a named function from symbols to SymPy expressions, with the equation it implements."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Literal

import sympy as sp

from ..symbolic.conditionals import Boolean, Condition
from ..symbolic.ordering import in_order

Kind = Literal["double", "single", "truth"]
"""The type of a variable of the event loop: a number of either precision, or a truth value."""


@dataclass(frozen=True)
class Kernel:
    """A function that the code generator prints for every target.

    Attributes
    ----------
    name
        Function name, the same in every target.
    arguments
        Symbols, in calling order.
    outputs
        Output names and expressions, in returning order.
    summary
        One line: the meaning of its outputs.
    equation
        The equation of the article, or the source, that it implements.
    single
        True if arguments and operations are rounded to single precision.
    """

    name: str
    arguments: tuple[sp.Symbol, ...]
    outputs: tuple[tuple[str, sp.Expr], ...] = field(repr=False)
    summary: str
    equation: str
    single: bool = False

    def __post_init__(self) -> None:
        unbound = sorted(map(str, symbols_in(self.expressions) - set(self.arguments)))
        if unbound:
            raise ValueError(f"kernel {self.name}: not among its arguments: {', '.join(unbound)}")

    # The event loop asks for these a hundred thousand times while it is printed.

    @cached_property
    def truths(self) -> tuple[bool, ...]:
        """True for each output that is a truth value."""
        return tuple(isinstance(e, Condition | Boolean) for e in self.expressions)

    @cached_property
    def kinds(self) -> tuple[Kind, ...]:
        """The type of each output."""
        value: Kind = "single" if self.single else "double"
        return tuple("truth" if truth else value for truth in self.truths)

    @cached_property
    def expressions(self) -> tuple[sp.Expr, ...]:
        """The output expressions, in order."""
        return tuple(expression for _, expression in self.outputs)

    @cached_property
    def output_names(self) -> tuple[str, ...]:
        """The output names, in order."""
        return tuple(name for name, _ in self.outputs)


def symbols_in(expressions: Iterable[sp.Basic]) -> set[sp.Symbol]:
    """Return the symbols in expressions; unlike `free_symbols`, it visits each part only once."""
    seen: set[sp.Basic] = set()
    rest = list(expressions)
    while rest:
        part = rest.pop()
        if part not in seen:
            seen.add(part)
            rest += part.args
    return {part for part in seen if part.is_Symbol}


def kernel(
    name: str,
    outputs: Mapping[str, sp.Expr],
    order: Iterable[sp.Symbol],
    summary: str,
    equation: str,
    single: bool = False,
) -> Kernel:
    """Return the kernel whose arguments are those symbols of `order` that its outputs use.

    Parameters
    ----------
    name
        The name of the function in every target.
    outputs
        The expressions by name, in returning order.
    order
        All symbols that there may be, in calling order.
    summary
        One line: the meaning of the outputs.
    equation
        The equation of the article, or the source.
    single
        True if the kernel is rounded to single precision.
    """
    sympified = {key: sp.sympify(value) for key, value in outputs.items()}
    free = symbols_in(sympified.values())
    arguments = tuple(symbol for symbol in order if symbol in free)
    return Kernel(name, arguments, tuple(sympified.items()), summary, equation, single)


def loop_kernel(
    name: str,
    outputs: Mapping[str, sp.Basic],
    summary: str,
    equation: str,
    single: bool = False,
) -> Kernel:
    """Return a kernel of the event loop, whose arguments are sorted by their declaration.

    Parameters
    ----------
    name, outputs, summary, equation, single
        As for `kernel`.
    """
    sympified = {key: sp.sympify(value) for key, value in outputs.items()}
    free = symbols_in(sympified.values())
    return Kernel(name, in_order(free), tuple(sympified.items()), summary, equation, single)


def decision(
    name: str, outputs: Mapping[str, sp.Basic], summary: str, single: bool = False
) -> Kernel:
    """Return a kernel of the event loop that decides or counts (Table 1).

    Parameters
    ----------
    name, outputs, summary, single
        As for `kernel`.
    """
    return loop_kernel(name, outputs, summary, "Table 1", single)
