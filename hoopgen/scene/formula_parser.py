"""A parser of formulas of sizes and bounds, which runs nothing.

Text goes through Python's `ast` and a whitelist: `+ - * /`, whole powers, `sqrt`, numbers, and the
names that are declared. Nothing is evaluated by Python, SymPy or NumPy as text, and what is read is
small: its length, depth and degree are limited, so that no formula takes long.
"""

from __future__ import annotations

import ast
import math
import re
import sys
from collections.abc import Collection
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np

from hoopgen.core.units import unit_size
from hoopgen.text.shorten import brief, join_names

from .formulas import ONE, Formula, FormulaError, constant, name
from .limits import current

MAX_DENOMINATOR = 10**30
"""Denominators of exact decimals stay below it."""

MIN_NUMBER, MAX_NUMBER = Fraction(1, 10**100), Fraction(10**100)
"""Sizes of a number that is not zero: no product of a few overflows."""


def read(value: object, names: Collection[str], decimal: bool = False) -> Formula:
    """Return a formula from a number, a text or an expression of SymPy.

    Parameters
    ----------
    value
        What the user gave.
    names
        Names that it may have.
    decimal
        True: numbers are the decimals that the user wrote, and arithmetic of numbers is exact, for
        readers. False: they are the doubles that engines compute with.

    Raises
    ------
    FormulaError
        If it is none of them, not finite, or not what formulas may be.
    """
    if isinstance(value, Formula):
        return value
    if isinstance(value, str):
        return parse(value, names, decimal)
    if isinstance(value, bool | np.bool_):
        raise FormulaError(f"expected a number or a formula, got {brief(value)}")
    if isinstance(value, int | float | np.integer | np.floating):
        return _number(value.item() if isinstance(value, np.generic) else value, decimal)
    sympy = sys.modules.get("sympy")
    if sympy is not None and isinstance(value, sympy.Basic):
        return _from_sympy(value, names, 0, decimal)
    raise FormulaError(f"expected a number or a formula, got {brief(value)}")


def _number(value: float | int, decimal: bool = False) -> Formula:
    try:
        double = float(value)
        exact = Fraction(repr(double)) if decimal and math.isfinite(double) else Fraction(double)
    except (OverflowError, ValueError):
        raise FormulaError(f"expected a finite number, got {brief(value)}") from None
    if exact and not MIN_NUMBER <= abs(exact) <= MAX_NUMBER:
        raise FormulaError(f"expected a number from 1e-100 to 1e100 in size, got {brief(value)}")
    return constant(exact)


_TOKEN = re.compile(
    r"\s*(?:(?P<number>(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?)(?![\w.])"
    r"|(?P<name>[A-Za-z_]\w*)|\*\*|[-+*/()])",
    re.ASCII,
)


_WITH_UNIT = re.compile(r"[-+]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?\s*([A-Za-z°%]+)")
"""A number with a unit, as in "30cm": never a formula."""

_MARK = "name_"
"""Before each name in what Python's parser reads."""


def parse(text: str, names: Collection[str], decimal: bool = False) -> Formula:
    """Return the formula of a text. Nothing in it is run.

    Parameters
    ----------
    text
        With `+ - * /`, whole powers `**`, `sqrt(...)`, numbers and names.
    names
        That it may have.
    decimal
        As for `read`.

    Raises
    ------
    FormulaError
        If it is anything else, or too large.
    """
    if excess := current().excess("formula_length", len(text)):
        raise FormulaError(excess)
    text = text.strip(" \t")
    if text in names:
        return name(text)  # whatever Python makes of it
    if quantity := _WITH_UNIT.fullmatch(text):
        metres = " (lengths in m)" if unit_size(quantity[1], "length") is not None else ""
        raise FormulaError(
            f"expected a number without a unit{metres}, or a formula; got {brief(text)}"
        )
    place = 0
    parts: list[str] = []
    while place < len(text):
        token = _TOKEN.match(text, place)
        if token is None:
            raise FormulaError(f"{brief(text)}: {brief(text[place:].strip()[:1])} is not allowed")
        found = token["name"]
        if found is not None and found != "sqrt" and found not in names:
            raise FormulaError(f"{brief(text)}: unknown name {brief(found)}; {_known(names)}")
        # A name may be a word of Python's, such as lambda.
        own = found not in (None, "sqrt")
        parts.append(f"{text[place : token.start('name')]}{_MARK}{found}" if own else token[0])
        place = token.end()
    try:
        marked = "".join(parts).replace("\t", " ")
        tree = ast.parse(marked, mode="eval")
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        raise FormulaError(f"{brief(text)} is not a formula") from None
    try:
        return _Reader(names, decimal).read(tree.body, 0)
    except FormulaError as error:
        raise FormulaError(f"{brief(text)}: {error}") from None


def _check_depth(depth: int) -> None:
    if excess := current().excess("formula_depth", depth, exact=False):
        raise FormulaError(excess)


def _check_degree(formula: Formula, decimal: bool) -> Formula:
    """Check the degree of a formula, and round numbers so that no power of one grows long.

    A decimal stays exact where it is short enough.
    """
    if excess := current().excess("formula_degree", formula.degree):
        raise FormulaError(excess)
    number = formula.number
    if number and not MIN_NUMBER <= abs(number) <= MAX_NUMBER:
        raise FormulaError("expected numbers from 1e-100 to 1e100 in size")
    if number is None or (decimal and number.denominator < MAX_DENOMINATOR):
        return formula
    return constant(Fraction(float(number)))


@dataclass(frozen=True)
class _Reader:
    """A conversion of Python's syntax tree to formulas, one line for each allowed node."""

    names: Collection[str]
    decimal: bool

    def read(self, node: ast.expr, depth: int) -> Formula:
        """Return the node as a formula."""
        _check_depth(depth)
        return _check_degree(self._node(node, depth + 1), self.decimal)

    def _node(self, node: ast.expr, depth: int) -> Formula:
        match node:
            case ast.Constant(value=int() | float() as value) if not isinstance(value, bool):
                return _number(value, self.decimal)
            case ast.Name(id=found) if found.removeprefix(_MARK) in self.names:
                return name(found.removeprefix(_MARK))
            case ast.UnaryOp(op=ast.USub(), operand=operand):
                return -self.read(operand, depth)
            case ast.UnaryOp(op=ast.UAdd(), operand=operand):
                return self.read(operand, depth)
            case ast.BinOp(left=base, op=ast.Pow(), right=exponent):
                return self._power(base, exponent, depth)
            case ast.BinOp(left=left, op=operation, right=right):
                return self._binary(operation, self.read(left, depth), self.read(right, depth))
            case ast.Call(func=ast.Name(id="sqrt"), args=[operand], keywords=[]):
                return self.read(operand, depth).sqrt()
        raise FormulaError(f"{type(node).__name__} is not allowed; + - * / ** sqrt( ) are")

    def _binary(self, operation: ast.operator, left: Formula, right: Formula) -> Formula:
        match operation:
            case ast.Add():
                return left + right
            case ast.Sub():
                return left - right
            case ast.Mult():
                return left * right
            case ast.Div():
                return left / right
        raise FormulaError(f"{type(operation).__name__} is not allowed")

    def _power(self, base: ast.expr, exponent: ast.expr, depth: int) -> Formula:
        if not (
            isinstance(exponent, ast.Constant)
            and type(exponent.value) is int
            and exponent.value >= 0
        ):
            most = current().formula_degree
            raise FormulaError(f"expected a whole power from 0 to {most}, as in x**2")
        if excess := current().excess("formula_degree", exponent.value):
            raise FormulaError(excess)
        return self.read(base, depth) ** int(exponent.value)


def _known(names: Collection[str]) -> str:
    return f"there are {join_names(sorted(names))}" if names else "the scene has no parameters"


def _from_sympy(
    expression: Any, names: Collection[str], depth: int, decimal: bool = False
) -> Formula:
    """Return an expression of SymPy as a formula, by the same whitelist."""
    _check_depth(depth)
    if expression.is_Symbol:
        if expression.name not in names:
            raise FormulaError(f"unknown symbol {brief(expression.name)}; {_known(names)}")
        return name(expression.name)
    if expression.is_Rational or expression.is_Float:
        return _number(float(expression), decimal)
    if expression.is_Pow and expression.exp.is_Rational and expression.exp.q <= 2:
        power = int(expression.exp.p)
        if excess := current().excess("formula_degree", abs(power)):
            raise FormulaError(excess)
        base = _from_sympy(expression.base, names, depth + 1, decimal)
        result = (base.sqrt() if expression.exp.q == 2 else base) ** abs(power)
        return _check_degree(ONE / result if power < 0 else result, decimal)
    if not (expression.is_Add or expression.is_Mul):
        raise FormulaError(f"{type(expression).__name__} is not allowed; + - * / ** sqrt are")
    result, *rest = (_from_sympy(part, names, depth + 1, decimal) for part in expression.args)
    for part in rest:
        result = _check_degree(result + part if expression.is_Add else result * part, decimal)
    return result
