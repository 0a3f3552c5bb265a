"""Formulas of sizes and bounds as trees: construction, evaluation and printing."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import reduce
from typing import Any

import numpy as np

POSITION = ("x", "y", "z")
"""Names of the coordinates of the ball's centre, in bounds and implicit surfaces."""


class FormulaError(ValueError):
    """An error in a formula; who knows whose formula it is names the owner before it."""


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
        """The number of factors in its longest product."""
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
        """A numerical factor and the rest of the product."""
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
        """Return its value in doubles, finite or not.

        Parameters
        ----------
        values
            A number or an array for each of its names.
        """
        with np.errstate(all="ignore"):
            return self.fold(values, lambda value: np.float64(float(value)), np.sqrt)

    def derivative(self, values: Mapping[str, Any], by: str) -> Any:
        """Return its derivative by one of its names, in doubles, finite or not.

        Parameters
        ----------
        values
            A number or an array for each of its names.
        by
            The name.
        """
        if self.kind in ("number", "name"):
            return np.float64(self.kind == "name" and self.value == by)
        with np.errstate(all="ignore"):
            first, *rest = [part.evaluate(values) for part in self.parts]
            change, *changes = [part.derivative(values, by) for part in self.parts]
            if self.kind == "+":
                return change + changes[0]
            if self.kind == "*":
                return change * rest[0] + first * changes[0]
            if self.kind == "/":
                return (change - first / rest[0] * changes[0]) / rest[0]
            if self.kind == "sqrt":
                return change / (2.0 * np.sqrt(first))
            return int(self.value) * first ** (int(self.value) - 1) * change

    def fold(
        self, values: Mapping[str, Any], number: Callable[[Fraction], Any], root: Callable[..., Any]
    ) -> Any:
        """Return its value in the type of the given numbers.

        Parameters
        ----------
        values
            Values by name.
        number
            Converts a fraction to the type of the values.
        root
            The square root of that type.
        """
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
        """Return it as it may be written; a number as the decimal or quotient that it is."""
        if self.kind == "number":
            value = Fraction(self.value)
            double = float(value)
            if value.denominator == 1 or Fraction(double) != value != Fraction(repr(double)):
                return str(value)
            return repr(double)
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
        """Return its text as an operand, in brackets except for these kinds, names and roots."""
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
