"""Formatting statements as Python."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from ..formatter import Formatter
from ..statements import (
    Assign,
    Break,
    Call,
    Continue,
    Execute,
    Expression,
    For,
    ForEach,
    Function,
    If,
    Return,
    Statement,
    Table,
    Tuple,
)
from .spelling import NUMPY, NUMPY_SINGLE, ONE_SHOT


@dataclass(frozen=True)
class PythonFormatter(Formatter):
    """A formatter of Python."""

    def other(self, value: Expression) -> str:
        """Return several values as a tuple."""
        if isinstance(value, Tuple):
            return f"({''.join(f'{self.expression(v)}, ' for v in value.values).rstrip()})"
        return super().other(value)

    def statement(self, statement: Statement) -> list[str]:
        """Return the lines of one statement."""
        match statement:
            case Assign(target, value):
                return [f"{self.expression(target)} = {self.expression(value)}"]
            case Call(function, arguments, results):
                targets = ", ".join(results) + "," * (len(results) == 1)
                return [f"{targets} = {function}({self.expressions(arguments)})"]
            case Execute(value):
                return [self.expression(value)]
            case Return(value):
                return [f"return {self.expression(value)}"]
            case Break():
                return ["break"]
            case Continue():
                return ["continue"]
            case Table(name, _, rows):
                return [f"{name} = (", *self._rows(rows), ")"]
            case If(test, body, otherwise):
                head = f"if {self.expression(test)}:"
                return [head, *self.body(body), *self._otherwise(otherwise)]
            case For(index, end, body, otherwise):
                head = f"for {index} in range({self.expression(end)}):"
                return [head, *self.body(body), *self._otherwise(otherwise)]
            case ForEach(names, table, body):
                return [*self._for_each(names, table), *self.body(body)]
            case Function(name, parameters, body):
                given = ", ".join(f"{parameter}: {kind}" for parameter, kind in parameters)
                head = f"def {name}({given}) -> tuple[Any, ...]:"
                return [head, f'    """{statement.summary}"""', *self.body(body)]
        return super().statement(statement)

    def _otherwise(self, body: Sequence[Statement]) -> list[str]:
        if len(body) == 1 and isinstance(body[0], If):
            first, *rest = self.statement(body[0])
            return [f"el{first}", *rest]
        return ["else:", *self.body(body)] if body else []

    def _for_each(self, names: Sequence[str], table: Expression) -> list[str]:
        head = f"for {', '.join(names)}, in"
        if not isinstance(table, Tuple):
            return [f"{head} {self.expression(table)}:"]
        rows = (row.values for row in table.values if isinstance(row, Tuple))
        return [f"{head} (", *self._rows(tuple(rows)), "):"]

    def _rows(self, rows: Sequence[Sequence[Expression]]) -> list[str]:
        return [f"    {self.expression(Tuple(tuple(row)))}," for row in rows]


ROWS_FORMATTER = PythonFormatter(NUMPY, NUMPY_SINGLE)
ONE_SHOT_FORMATTER = PythonFormatter(ONE_SHOT, ONE_SHOT)
