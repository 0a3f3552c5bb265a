"""Formulas of sizes and bounds: read from text without running it, and evaluated.

Text goes through Python's `ast` and a whitelist: `+ - * /`, whole powers, `sqrt`, numbers, and the
names that are declared. Nothing is evaluated by Python, SymPy or NumPy as text, and what is read is
small: its length, depth and degree are limited, so that no formula takes long.
"""

from __future__ import annotations

import ast
import re
import sys
from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import reduce
from typing import Any

import numpy as np

from hoopgen.brief import brief, listed

__all__ = [
    "ONE",
    "POSITION",
    "ZERO",
    "Formula",
    "FormulaError",
    "constant",
    "name",
    "parse",
    "read",
]

LONGEST = 300
"""Characters of a formula."""

DEEPEST = 30
"""Operations within one another."""

DEGREE = 8
"""Factors in a product, all powers multiplied out."""

SMALLEST, LARGEST = Fraction(1, 10**100), Fraction(10**100)
"""Sizes of a number that is not zero: no product of a few overflows."""

POSITION = ("x", "y", "z")
"""Where the ball's centre is, in bounds and free surfaces."""


class FormulaError(ValueError):
    """What is wrong with a formula; whoever knows whose it is says so before it."""


@dataclass(frozen=True)
class Formula:
    """A formula as a tree.

    Attributes
    ----------
    kind
        "number", "name", "+", "*", "/", "**" or "sqrt".
    parts
        The operands.
    value
        Of a number its exact value, of a name itself, of a power the exponent.
    """

    kind: str
    parts: tuple[Formula, ...] = ()
    value: Fraction | str | int = 0

    @property
    def number(self) -> Fraction | None:
        """Its value, if it is a number."""
        return self.value if isinstance(self.value, Fraction) else None

    @property
    def names(self) -> frozenset[str]:
        """The names in it."""
        if self.kind == "name":
            return frozenset([str(self.value)])
        return frozenset().union(*(part.names for part in self.parts))

    @property
    def degree(self) -> int:
        """Factors in its longest product."""
        degrees = [part.degree for part in self.parts]
        if self.kind in ("*", "/"):
            return sum(degrees)
        if self.kind == "**":
            return max(1, *degrees) * int(self.value)
        return max(degrees, default=int(self.kind == "name"))

    def __add__(self, other: Formula) -> Formula:
        """Return the sum, what is the same but for a number taken together."""
        collected: dict[Formula, Fraction] = {}
        for term in (*self._terms, *other._terms):
            number, rest = term._split
            collected[rest] = collected.get(rest, Fraction(0)) + number
        terms = [constant(number) * rest for rest, number in collected.items() if number]
        return reduce(lambda left, right: Formula("+", (left, right)), terms) if terms else ZERO

    @property
    def _terms(self) -> tuple[Formula, ...]:
        if self.kind != "+":
            return (self,)
        return tuple(term for part in self.parts for term in part._terms)

    @property
    def _split(self) -> tuple[Fraction, Formula]:
        """A number and what it multiplies."""
        if self.number is not None:
            return self.number, ONE
        if self.kind == "*" and self.parts[0].number is not None:
            return self.parts[0].number, self.parts[1]
        return Fraction(1), self

    def __neg__(self) -> Formula:
        return constant(-1) * self

    def __sub__(self, other: Formula) -> Formula:
        return self + -other

    def __mul__(self, other: Formula) -> Formula:
        (mine, left), (its, right) = self._split, other._split
        number = constant(mine * its)
        if number == ZERO or right == ONE:
            left, right = right, left
        if number == ZERO or (left == ONE and right == ONE):
            return number
        if left == right:
            product = left**2
        else:
            product = right if left == ONE else Formula("*", (left, right))
        return product if number == ONE else Formula("*", (number, product))

    def __truediv__(self, other: Formula) -> Formula:
        number = other.number
        if number == 0:
            raise FormulaError("division by zero")
        if number is not None and (self.number is not None or abs(number) in (1, 2)):
            return constant(1 / number) * self
        return Formula("/", (self, other))

    def __pow__(self, exponent: int) -> Formula:
        if self.number is not None:
            return constant(self.number**exponent)
        if exponent < 2:
            return self if exponent else constant(1)
        return Formula("**", (self,), exponent)

    def sqrt(self) -> Formula:
        """Return its square root."""
        if self.number is not None and self.number < 0:
            raise FormulaError("the square root of a negative number")
        if self.number in (0, 1):
            return self
        return Formula("sqrt", (self,))

    def evaluate(self, values: Mapping[str, Any]) -> Any:
        """Return its value in doubles; what is not finite is not refused here.

        Parameters
        ----------
        values
            A number or an array for each of its names.
        """
        with np.errstate(all="ignore"):
            return self.fold(values, lambda value: np.float64(float(value)), np.sqrt)

    def fold(
        self, values: Mapping[str, Any], number: Callable[[Fraction], Any], root: Callable[..., Any]
    ) -> Any:
        """Return its value in whatever numbers those are."""
        if self.kind == "number":
            return number(Fraction(self.value))
        if self.kind == "name":
            return values[str(self.value)]
        first, *rest = [part.fold(values, number, root) for part in self.parts]
        if self.kind == "+":
            return first + rest[0]
        if self.kind == "*":
            return first * rest[0]
        if self.kind == "/":
            return first / rest[0]
        if self.kind == "sqrt":
            return root(first)
        product = first
        for _ in range(int(self.value) - 1):
            product = product * first
        return product

    def __str__(self) -> str:
        """Return it as it may be written; of a number its double."""
        if self.kind == "number":
            value = Fraction(self.value)
            return str(value) if value.denominator == 1 else repr(float(value))
        if self.kind == "name":
            return str(self.value)
        if self.kind == "sqrt":
            return f"sqrt({self.parts[0]})"
        if self.kind == "+":
            first, *rest = map(str, self._terms)
            signed = (f" - {t[1:]}" if t.startswith("-") else f" + {t}" for t in rest)
            return "".join([first, *signed])
        if self.kind == "**":
            return f"{self.parts[0]._within()}**{self.value}"
        left, right = self.parts
        if self.kind == "*" and left.number == -1:
            return f"-{right._within('*', '/', '**')}"
        factor = str(left) if left.number is not None else left._within("*", "/", "**")
        return f"{factor}{self.kind}{right._within('**')}"

    def _within(self, *kinds: str) -> str:
        """Return it as an operand: in brackets but for those kinds, names and roots."""
        plain = self.kind in ("name", "sqrt", *kinds)
        positive = self.number is not None and self.number >= 0
        return str(self) if plain or positive else f"({self})"


def constant(value: Fraction | int) -> Formula:
    """Return a number as a formula."""
    return Formula("number", (), Fraction(value))


ZERO, ONE = constant(0), constant(1)


def name(text: str) -> Formula:
    """Return a name as a formula."""
    return Formula("name", (), text)


def read(value: object, names: Collection[str]) -> Formula:
    """Return what a user gave as a formula: a number, text, or an expression of SymPy.

    Raises
    ------
    FormulaError
        If it is none of them, not finite, or not what formulas may be.
    """
    if isinstance(value, Formula):
        return value
    if isinstance(value, str):
        return parse(value, names)
    if isinstance(value, bool | np.bool_):
        raise FormulaError(f"expected a number or a formula, got {brief(value)}")
    if isinstance(value, int | float | np.integer | np.floating):
        return _number(value.item() if isinstance(value, np.generic) else value)
    sympy = sys.modules.get("sympy")
    if sympy is not None and isinstance(value, sympy.Basic):
        return _from_sympy(value, names, 0)
    raise FormulaError(f"expected a number or a formula, got {brief(value)}")


def _number(value: float | int) -> Formula:
    try:
        exact = Fraction(float(value))  # the double: what engines compute with
    except (OverflowError, ValueError):
        raise FormulaError(f"expected a finite number, got {brief(value)}") from None
    if exact and not SMALLEST <= abs(exact) <= LARGEST:
        raise FormulaError(f"expected a number from 1e-100 to 1e100 in size, got {brief(value)}")
    return constant(exact)


_TOKEN = re.compile(
    r"\s*(?:(?P<number>(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?)(?![\w.])"
    r"|(?P<name>[A-Za-z_]\w*)|\*\*|[-+*/()])",
    re.ASCII,
)


def parse(text: str, names: Collection[str]) -> Formula:
    """Return the formula that a text says. Nothing in it is run.

    Parameters
    ----------
    text
        With `+ - * /`, whole powers `**`, `sqrt(...)`, numbers and names.
    names
        That it may have.

    Raises
    ------
    FormulaError
        If it is anything else, or too large.
    """
    if len(text) > LONGEST:
        raise FormulaError(f"expected at most {LONGEST} characters, got {len(text)}")
    text = text.strip(" \t")
    if text in names:
        return name(text)  # whatever Python makes of it
    place = 0
    while place < len(text):
        token = _TOKEN.match(text, place)
        if token is None:
            raise FormulaError(f"{brief(text)}: {brief(text[place:].strip()[:1])} is not allowed")
        found = token["name"]
        if found is not None and found != "sqrt" and found not in names:
            raise FormulaError(
                f"{brief(text)}: unknown name {brief(found)}; there are {listed(sorted(names))}"
            )
        place = token.end()
    try:
        tree = ast.parse(text.replace("\t", " "), mode="eval")
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        raise FormulaError(f"{brief(text)} is not a formula") from None
    try:
        return _Reader(names).read(tree.body, 0)
    except FormulaError as error:
        raise FormulaError(f"{brief(text)}: {error}") from None


def _limited(formula: Formula) -> Formula:
    """Refuse too high a degree; round what is a number, so that no power of it grows long."""
    if formula.degree > DEGREE:
        raise FormulaError(f"expected a degree of at most {DEGREE}")
    number = formula.number
    if number and not SMALLEST <= abs(number) <= LARGEST:
        raise FormulaError("expected numbers from 1e-100 to 1e100 in size")
    return formula if number is None else constant(Fraction(float(number)))


@dataclass(frozen=True)
class _Reader:
    """Python's syntax tree to ours: one line for each node that is allowed."""

    names: Collection[str]

    def read(self, node: ast.expr, depth: int) -> Formula:
        """Return the node as a formula."""
        if depth > DEEPEST:
            raise FormulaError(f"more than {DEEPEST} operations deep")
        return _limited(self._node(node, depth + 1))

    def _node(self, node: ast.expr, depth: int) -> Formula:
        match node:
            case ast.Constant(value=int() | float() as value) if not isinstance(value, bool):
                return _number(value)
            case ast.Name(id=found) if found in self.names:
                return name(found)
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
            and 0 <= exponent.value <= DEGREE
        ):
            raise FormulaError(f"expected a whole power from 0 to {DEGREE}, as in x**2")
        return self.read(base, depth) ** int(exponent.value)


def _from_sympy(expression: Any, names: Collection[str], depth: int) -> Formula:
    """Return an expression of SymPy as a formula, by the same whitelist."""
    if depth > DEEPEST:
        raise FormulaError(f"more than {DEEPEST} operations deep")
    if expression.is_Symbol:
        if expression.name not in names:
            raise FormulaError(
                f"unknown symbol {brief(expression.name)}; there are {listed(sorted(names))}"
            )
        return name(expression.name)
    if expression.is_Rational or expression.is_Float:
        return _number(float(expression))
    if expression.is_Pow and expression.exp.is_Rational and expression.exp.q <= 2:
        power = int(expression.exp.p)
        if abs(power) > DEGREE:
            raise FormulaError(f"expected a degree of at most {DEGREE}")
        base = _from_sympy(expression.base, names, depth + 1)
        result = (base.sqrt() if expression.exp.q == 2 else base) ** abs(power)
        return _limited(ONE / result if power < 0 else result)
    if not (expression.is_Add or expression.is_Mul):
        raise FormulaError(f"{type(expression).__name__} is not allowed; + - * / ** sqrt are")
    result, *rest = (_from_sympy(part, names, depth + 1) for part in expression.args)
    for part in rest:
        result = _limited(result + part if expression.is_Add else result * part)
    return result
