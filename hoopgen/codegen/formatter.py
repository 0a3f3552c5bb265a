"""Formatting statements: what all targets have in common, and a table of spellings for each."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from .statements import (
    Apply,
    Cast,
    Choose,
    Column,
    Declare,
    Expression,
    Infix,
    Item,
    Member,
    Name,
    Number,
    Operate,
    Scalar,
    Statement,
)


@dataclass(frozen=True)
class Spelling:
    """A target's spelling of the operations; `{0}` … are the operands, already formatted.

    Attributes
    ----------
    constant, infinity
        How it writes a finite number, and an infinite one.
    number, truth
        The types of what has a value, and of what holds or does not.
    truth_output
        The function through which a kernel returns a truth, if there is one.
    """

    operations: Mapping[str, str]
    constant: str = "{0}"
    infinity: str = "Infinity"
    number: str = ""
    truth: str = ""
    truth_output: str = ""

    def number_text(self, value: float) -> str:
        """Return a double so that it reads back to the same bits."""
        if not math.isinf(value):
            return self.constant.format(repr(value))
        if value > 0:
            return self.infinity
        # Minus infinity is within the brackets of a constant, if it has some.
        opening, bracket, rest = self.infinity.partition("(")
        return f"{opening}(-{rest}" if bracket else f"(-{self.infinity})"


INFIX = {
    "add": "({0} + {1})",
    "sub": "({0} - {1})",
    "mul": "({0} * {1})",
    "div": "({0} / {1})",
    "neg": "(-{0})",
}
"""Operations as most languages write them."""

ONE_SHOT = INFIX | {
    "max": "({0} < {1} ? {1} : {0})",
    "min": "({0} < {1} ? {0} : {1})",
    "less": "({0} < {1})",
    "at_most": "({0} <= {1})",
    "equal": "({0} == {1})",
    "both": "({0} && {1})",
    "either": "({0} || {1})",
    "not": "(!{0})",
    "nowhere": "false",
    "select": "({0} ? {1} : {2})",
}
"""Operations on the numbers of one shot, as languages with the expressions of C write them."""


@dataclass(frozen=True)
class Formatter:
    """A formatter of expressions and of straight-line code; a target adds its other statements.

    Attributes
    ----------
    double, single
        How operations of each precision are spelled.
    declaration
        How a new variable is written: its type, name and value.
    """

    double: Spelling
    single: Spelling
    declaration: str = "{name} = {value}"

    def lines(self, statements: Iterable[Statement]) -> list[str]:
        """Return the lines of statements, each body indented by four spaces."""
        return [line for statement in statements for line in self.statement(statement)]

    def statement(self, statement: Statement) -> list[str]:
        """Return the lines of one statement."""
        match statement:
            case Declare(name, kind, value) if value is not None:
                text = self.expression(value)
                return [self.declaration.format(type=kind, name=name, value=text)]
        raise TypeError(f"{type(self).__name__} does not write {type(statement).__name__}")

    def body(self, statements: Iterable[Statement]) -> list[str]:
        """Return the lines of a body."""
        return [f"    {line}" for line in self.lines(statements)]

    def expressions(self, values: Iterable[Expression]) -> str:
        """Return expressions with commas between them."""
        return ", ".join(map(self.expression, values))

    def operand(self, value: Expression) -> str:
        """Return an expression as the operand of another."""
        if isinstance(value, Number):
            return self._number(value)
        text = self.expression(value)
        brackets = isinstance(value, Infix | Choose | Cast) or (
            isinstance(value, Operate) and self._spelled(value).startswith("(")
        )
        return f"({text})" if brackets else text

    def _number(self, value: Number) -> str:
        return (self.single if value.single else self.double).number_text(value.value)

    def _spelled(self, value: Operate) -> str:
        return (self.single if value.single else self.double).operations[value.operation]

    def expression(self, value: Expression) -> str:
        """Return an expression, without brackets around it."""
        match value:
            case Name(name):
                return name
            case Scalar(number):
                return repr(number)
            case Number():
                return _bare(self._number(value))
            case Operate(_, operands):
                return _bare(self._spelled(value)).format(*map(self.operand, operands))
            case Apply(function, arguments):
                return f"{function}({self.expressions(arguments)})"
            case Infix(operator, left, right):
                return f"{self.operand(left)} {operator} {self.operand(right)}"
            case Member(whole, name):
                return f"{self.operand(whole)}.{name}"
            case Item(array, index):
                return f"{self.operand(array)}[{self.expression(index)}]"
            case Column():
                return self.column(value)
        return self.other(value)

    def column(self, column: Column) -> str:
        """Return a column of a list."""
        return column.name

    def other(self, value: Expression) -> str:
        """Return an expression that targets write in ways of their own."""
        raise TypeError(f"{type(self).__name__} does not write {type(value).__name__}")


def _bare(text: str) -> str:
    """Return the spelling of an expression without the brackets that it has as an operand."""
    return text[1:-1] if text.startswith("(") else text
