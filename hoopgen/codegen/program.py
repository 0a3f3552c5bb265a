"""Lowering: SymPy expressions to straight-line programs of IEEE 754 operations.

Every operation is binary, in one fixed order, and equal operations are computed once. All targets
print the same program, which is why they give the same bits.
"""

from __future__ import annotations

import hashlib
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any

import sympy as sp

from hoopgen.derive.ir.kernel import Kernel
from hoopgen.derive.symbolic.conditionals import (
    And,
    AtMost,
    Barrier,
    Boolean,
    Choose,
    Condition,
    Equal,
    False_,
    IfAtMost,
    IfLess,
    Less,
    Not,
    Or,
)
from hoopgen.derive.symbolic.ordering import ordering

from .identifiers import identifier

CONDITIONS = {
    Less: "less",
    AtMost: "at_most",
    Equal: "equal",
    And: "both",
    Or: "either",
    Not: "not",
    False_: "nowhere",
}
"""The operations whose result holds or does not."""

CHOOSING = (Condition, Choose, Barrier, IfAtMost, IfLess)
"""Classes of conditions and of choices."""

INLINE_DEPTH = 6
"""An operation used once is printed inside its user, up to this depth."""


@dataclass(frozen=True)
class Operation:
    """One operation: its name, and its operands as indices of earlier operations.

    Names: argument, truth (an argument that holds or does not), constant, add, sub, mul, div, neg,
    sqrt, abs, max, min, select, and those of `CONDITIONS`.
    """

    name: str
    operands: tuple[int, ...] = ()
    symbol: str = ""
    value: float = 0.0

    @property
    def is_truth(self) -> bool:
        """True if its result holds or does not."""
        return self.name == "truth" or self.name in CONDITIONS.values()

    @property
    def is_free(self) -> bool:
        """True if nothing is to be done for it."""
        return self.name in ("argument", "truth", "constant", "nowhere")


@dataclass
class Operations:
    """Operations in an order in which each comes after its operands; no two are equal.

    Attributes
    ----------
    operations
        All of them.
    outputs
        Indices of those that are wanted.
    single
        Whether they are of single precision.
    """

    operations: list[Operation] = field(default_factory=list, repr=False)
    outputs: list[int] = field(default_factory=list)
    single: bool = False
    _index: dict[Operation, int] = field(default_factory=dict, repr=False)

    @property
    def cost(self) -> Counter[str]:
        """Numbers of operations of each kind in one evaluation; inputs and constants are free.

        A maximum or minimum, which some targets have as one, is a comparison and a selection.
        """
        names = (o.name for o in self.operations if not o.is_free)
        parts = ((("less", "select") if n in ("max", "min") else (n,)) for n in names)
        return Counter(part for several in parts for part in several)

    def add(self, operation: Operation) -> int:
        """Return the index of an operation, appended if it is new."""
        if operation not in self._index:
            self._index[operation] = len(self.operations)
            self.operations.append(operation)
        return self._index[operation]

    def _add(self, name: str, *operands: int, symbol: str = "", value: float = 0.0) -> int:
        return self.add(Operation(name, operands, symbol, value))

    def named(self) -> set[int]:
        """Return the operations that are worth a line of their own."""
        uses = Counter(operand for o in self.operations for operand in o.operands)
        # A target without maxima and minima writes their operands twice.
        uses.update(k for o in self.operations if o.name in ("max", "min") for k in o.operands)
        uses.update(self.outputs)
        depth: list[int] = []
        named: set[int] = set()
        for index, operation in enumerate(self.operations):
            if operation.is_free:
                depth.append(0)
                continue
            own = 1 + max(depth[operand] for operand in operation.operands)
            if uses[index] > 1 or own >= INLINE_DEPTH:
                named.add(index)
                own = 0
            depth.append(own)
        return named


@dataclass(kw_only=True)
class Program(Operations):
    """A kernel, lowered.

    Attributes
    ----------
    kernel
        What it computes.
    order
        The key by which terms and factors are sorted.
    """

    kernel: Kernel
    order: Callable[[sp.Expr], Any]
    _lowered: dict[sp.Basic, int] = field(default_factory=dict, repr=False)

    def lower(self, expression: sp.Basic) -> int:
        """Append what computes `expression` and return its index."""
        if expression not in self._lowered:
            for part in self._inward(expression):
                if part not in self._lowered:
                    self._lowered[part] = self._lower(part)
        return self._lowered[expression]

    def _inward(self, expression: sp.Basic) -> Iterator[sp.Basic]:
        """Yield choices and conditions, each after its parts.

        Those of a scene with many bodies lie in each other deeper than functions can.
        """
        rest = [(expression, False)]
        while rest:
            part, met = rest.pop()
            if met or not isinstance(part, CHOOSING):
                yield part
            elif part not in self._lowered:
                rest.append((part, True))
                rest += [(operand, False) for operand in reversed(part.args)]

    def _lower(self, expression: sp.Basic) -> int:
        if isinstance(expression, Boolean):
            return self._add("truth", symbol=identifier(expression))
        if expression.is_Symbol:
            return self._add("argument", symbol=identifier(expression))
        if expression.is_Number:
            return self._constant(expression)
        if expression.is_Add:
            return self._sum(expression)
        if expression.is_Mul:
            return self._product(expression)
        if expression.is_Pow:
            return self._power(expression.base, expression.exp)
        if isinstance(expression, Barrier):
            return self.lower(expression.args[0])
        if isinstance(expression, sp.Abs):
            return self._add("abs", self.lower(expression.args[0]))
        if isinstance(expression, IfLess | IfAtMost):
            left, right, then, other = (self.lower(a) for a in expression.args)
            if isinstance(expression, IfLess) and {then, other} == {left, right}:
                return self._add("max" if then == right else "min", left, right)
            name = "less" if isinstance(expression, IfLess) else "at_most"
            return self._add("select", self._add(name, left, right), then, other)
        if isinstance(expression, Choose):
            return self._add("select", *map(self.lower, expression.args))
        if isinstance(expression, Condition):
            return self._add(CONDITIONS[type(expression)], *map(self.lower, expression.args))
        raise TypeError(f"kernel {self.kernel.name}: cannot lower {type(expression).__name__}")

    def _constant(self, number: sp.Number) -> int:
        # float() of an exact rational is correctly rounded; adding 0.0 turns -0.0 into 0.0.
        return self._add("constant", value=float(number) + 0.0)

    def _sum(self, expression: sp.Add) -> int:
        """Lower a sum from left to right, positive terms first."""
        terms = sorted(expression.args, key=self.order)
        negative = [term for term in terms if term.as_coeff_Mul()[0].is_negative]
        positive = [term for term in terms if term not in negative]
        if not positive:
            return self._add("neg", self.lower(-expression))
        total = self.lower(positive[0])
        for term in positive[1:]:
            total = self._add("add", total, self.lower(term))
        for term in negative:
            total = self._add("sub", total, self.lower(-term))
        return total

    def _product(self, expression: sp.Mul) -> int:
        """Lower a product from left to right, its divisors multiplied and divided by once."""
        coefficient, factors = expression.as_coeff_mul()
        if coefficient.is_negative:
            return self._add("neg", self.lower(-expression))
        above: list[int] = [] if coefficient == 1 else [self._constant(coefficient)]
        below: list[int] = []
        for factor in sorted(factors, key=self.order):
            base, exponent = factor.as_base_exp()
            if exponent.is_negative:
                below.append(self._power(base, -exponent))
            else:
                above.append(self.lower(factor))
        numerator = self._chain(above) if above else self._constant(sp.Integer(1))
        return self._add("div", numerator, self._chain(below)) if below else numerator

    def _chain(self, factors: Sequence[int]) -> int:
        total = factors[0]
        for factor in factors[1:]:
            total = self._add("mul", total, factor)
        return total

    def _power(self, base: sp.Expr, exponent: sp.Expr) -> int:
        """Lower integer and half-integer powers to products and one square root."""
        if exponent.is_negative:
            return self._add("div", self._constant(sp.Integer(1)), self._power(base, -exponent))
        whole, half = divmod(2 * exponent, 2)
        if not whole.is_Integer or half not in (0, 1):
            raise TypeError(f"kernel {self.kernel.name}: no exact power {exponent}")
        factor = self.lower(base)
        result = self._add("sqrt", factor) if half else None
        square = factor
        remaining = int(whole)
        while remaining:
            if remaining & 1:
                result = square if result is None else self._add("mul", result, square)
            remaining >>= 1
            if remaining:
                square = self._add("mul", square, square)
        assert result is not None  # SymPy has turned a zeroth power into 1
        return result


def lower(kernel: Kernel, parameters: Sequence[sp.Symbol] = ()) -> Program:
    """Return the program of a kernel.

    Parameters
    ----------
    kernel
        What is lowered.
    parameters
        The scene's, in its order; a kernel without a scene has them in the order of its arguments.

    Raises
    ------
    TypeError
        If an expression holds something that is not exactly rounded by IEEE 754 doubles.
    """
    order = ordering(dict.fromkeys((*parameters, *kernel.arguments)))
    program = Program(kernel=kernel, order=order, single=kernel.single)
    for argument in kernel.arguments:
        program.lower(argument)
    program.outputs = [program.lower(expression) for expression in kernel.expressions]
    return program


def derivation_hash(programs: Sequence[Program]) -> str:
    """Return a hash of what the programs compute, the same on every machine."""
    lines = [
        repr((p.kernel.name, p.kernel.output_names, p.operations, p.outputs, p.kernel.single))
        for p in programs
    ]
    return hashlib.sha256("\n".join(lines).encode()).hexdigest()[:16]
