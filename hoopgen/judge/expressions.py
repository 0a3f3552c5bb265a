"""Expressions of derive/, compiled for ball arithmetic.

SymPy expressions become straight-line Python that works on whatever numbers it is given: Arb's
balls, or polynomials and power series of them. Nothing is reordered or simplified, and a rational
number is never rounded.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import sympy as sp
from flint import arb, fmpq

from hoopgen.derive.symbolic.conditionals import (
    And,
    AtMost,
    Barrier,
    False_,
    IfAtMost,
    IfLess,
    Less,
    Not,
    Or,
    all_of,
    any_of,
)

from .taylor_model import TaylorModel

Function = Callable[..., list[Any]]


def compile_expressions(
    expressions: Sequence[sp.Expr], *arguments: Sequence[sp.Symbol]
) -> Function:
    """Return a Python function from sequences of numbers to the list of the expressions' values.

    Parameters
    ----------
    expressions
        Sums, products, powers by whole and half numbers, absolute values, choices; comparisons,
        their negations, conjunctions and disjunctions, which are true only where balls prove them.
    arguments
        The symbols of each argument, in the order of its items.

    Raises
    ------
    TypeError
        If an expression holds anything else.
    """
    writer = _Writer()
    for place, symbols in enumerate(arguments):
        for item, symbol in enumerate(symbols):
            writer.names[symbol] = f"a{place}[{item}]"
    results = [writer.write(sp.sympify(expression)) for expression in expressions]
    head = f"def function({', '.join(f'a{place}' for place in range(len(arguments)))}):"
    source = "\n    ".join([head, *writer.lines, f"return [{', '.join(results)}]"])
    namespace: dict[str, Any] = {"fmpq": fmpq, "chosen": _choose, "infinity": arb.pos_inf()}
    exec(source, namespace)  # made above, from derive/ alone
    made: Function = namespace["function"]
    return made


def _choose(holds: bool, fails: bool, then: Any, other: Any) -> Any:
    """Return the branch that a comparison chooses.

    If it is undecided, NaN; of a box of releases both branches at once.
    """
    if holds or fails:
        return then if holds else other
    if isinstance(then, TaylorModel):
        return then.hull(other)
    return arb.nan()


def _opposite(condition: sp.Basic) -> sp.Basic:
    """Return a condition that holds exactly where another one, of comparisons, does not."""
    match condition:
        case Less(args=(left, right)):
            return AtMost(right, left)
        case AtMost(args=(left, right)):
            return Less(right, left)
        case And(args=parts):
            return any_of(*map(_opposite, parts))
        case Or(args=parts):
            return all_of(*map(_opposite, parts))
        case False_():
            return AtMost(0, 0)
    raise TypeError(f"no ball arithmetic for the opposite of {condition}")


class _Writer:
    """A writer of expressions as assignments, one for each distinct subexpression."""

    def __init__(self) -> None:
        self.names: dict[sp.Expr, str] = {}
        self.lines: list[str] = []

    def write(self, expression: sp.Expr) -> str:
        """Return the name of the expression's value, writing it if it is new."""
        if expression not in self.names:
            if isinstance(expression, Barrier):
                return self.write(expression.args[0])
            formula = self._formula(expression)
            if expression.is_Integer:
                return formula
            name = f"v{len(self.lines)}"
            self.lines.append(f"{name} = {formula}")
            self.names[expression] = name
        return self.names[expression]

    def _formula(self, expression: sp.Expr) -> str:
        if expression.is_Integer:
            return f"({int(expression)})"
        if expression.is_Rational:
            return f"fmpq({expression.p}, {expression.q})"
        if expression.is_Add:
            return " + ".join(self.write(term) for term in expression.args)
        if expression.is_Mul:
            return self._product(expression)
        if expression.is_Pow and expression.exp.is_Rational:
            return self._power(expression.base, expression.exp)
        if isinstance(expression, sp.Abs):
            return f"abs({self.write(expression.args[0])})"
        if isinstance(expression, IfLess | IfAtMost):
            left, right, then, other = (self.write(part) for part in expression.args)
            less, more = ("<", ">=") if isinstance(expression, IfLess) else ("<=", ">")
            return f"chosen({left} {less} {right}, {left} {more} {right}, {then}, {other})"
        if isinstance(expression, Less | AtMost | And | Or):
            relation = {Less: "<", AtMost: "<=", And: "and", Or: "or"}[type(expression)]
            left, right = (self.write(part) for part in expression.args)
            return f"{left} {relation} {right}"
        if isinstance(expression, Not):
            return self.write(_opposite(expression.args[0]))
        if isinstance(expression, False_):
            return "False"
        if expression is sp.oo:
            return "infinity"
        raise TypeError(f"no ball arithmetic for {expression}")

    def _product(self, expression: sp.Expr) -> str:
        number, factors = expression.as_coeff_mul()
        if not number.is_Rational:
            raise TypeError(f"no ball arithmetic for {number}")
        parts = [self.write(factor) for factor in factors]
        if number == -1:
            return f"-({' * '.join(parts)})"
        product = " * ".join(([f"({number.p})"] if number.p != 1 else []) + parts)
        return product if number.q == 1 else f"({product}) * fmpq(1, {number.q})"

    def _power(self, base: sp.Expr, exponent: sp.Rational) -> str:
        if exponent < 0:
            return f"1 / {self.write(base**-exponent)}"
        name = self.write(base)
        if exponent.q == 2:
            name = self._assign(f"{name}.sqrt()")
        elif exponent.q != 1:
            raise TypeError(f"no ball arithmetic for the power {exponent}")
        return " * ".join([name] * exponent.p)

    def _assign(self, formula: str) -> str:
        name = f"v{len(self.lines)}"
        self.lines.append(f"{name} = {formula}")
        return name
