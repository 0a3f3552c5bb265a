"""Formatting statements as C."""

from __future__ import annotations

from dataclasses import dataclass

from ..formatter import Formatter
from ..statements import (
    Apply,
    Assign,
    Block,
    Break,
    Call,
    Cast,
    Choose,
    Column,
    Compact,
    Declare,
    Execute,
    Expression,
    For,
    ForLanes,
    If,
    Name,
    Return,
    Statement,
    Table,
    Tuple,
    While,
)
from .columns import alike
from .spelling import LANES, SINGLES


@dataclass(frozen=True)
class CFormatter(Formatter):
    """A formatter of C: columns are arrays of the struct `worklist`, values are lanes."""

    def column(self, column: Column) -> str:
        """Return a column of a list."""
        return f"worklist->{column.name}"

    def other(self, value: Expression) -> str:
        """Return a choice, a cast, or several values."""
        match value:
            case Choose(test, then, other):
                return (
                    f"{self.expression(test)} ? {self.expression(then)} : {self.expression(other)}"
                )
            case Cast(kind, inner):
                return f"({kind}){self.operand(inner)}"
            case Tuple(values):
                return f"{{{self.expressions(values)}}}"
        return super().other(value)

    def statement(self, statement: Statement) -> list[str]:
        """Return the lines of one statement."""
        if found := alike(statement):
            return [f"EACH({', '.join(found)})"]
        match statement:
            case Declare():
                return [self._declaration(statement)]
            case Table(name, kind, rows):
                entries = [f"    {{{self.expressions(row)}}}," for row in rows]
                return [f"{kind} {name}[][{len(rows[0])}] = {{", *entries, "};"]
            case Assign(target, value, operator):
                return [f"{self.expression(target)} {operator} {self.expression(value)};"]
            case Call(called, arguments, (result,)):
                return [f"CALL({called}, {result})({self.expressions(arguments)});"]
            case Execute(value):
                return [f"{self.expression(value)};"]
            case Return(value):
                return [f"return {self.expression(value)};"]
            case Break():
                return ["break;"]
            case Block(body, True):
                return ["{", *self.lines(body), "}"]
            case Block(body):
                return self._braces("", body)
            case If(test, body, ()):
                return self._if(f"if ({self.expression(test)})", body)
            case Compact(count, mask, body):
                more = Assign(Name(count), Apply("popcount", (mask,)), "+=")
                return self._braces(f"if (lanes_any({mask.name}))", (*body, more))
        return self._loop(statement)

    def _loop(self, statement: Statement) -> list[str]:
        match statement:
            case While(None, body):
                return self._braces("for (;;)", body)
            case While(test, body) if test is not None:
                return self._braces(f"while ({self.expression(test)})", body)
            case For(index, end, body, ()):
                start, past = self.expression(statement.first), self.expression(end)
                head = f"for (size_t {index} = {start}; {index} < {past}; {index}++)"
                return self._braces(head, body)
            case ForLanes(index, first, count, body):
                start, past = self.expression(first), self.expression(count)
                head = f"for (size_t {index} = {start}; {index} < {past}; {index} += LANES_WIDTH)"
                return self._braces(head, body)
        return super().statement(statement)

    def _declaration(self, new: Declare) -> str:
        room = "".join(f"[{self.expression(n) if n else ''}]" for n in new.room)
        value = f" = {self.expression(new.value)}" if new.value is not None else ""
        return f"{'const ' if new.constant else ''}{new.type} {new.name}{room}{value};"

    def _if(self, head: str, body: tuple[Statement, ...]) -> list[str]:
        """Return a test and its body, without braces around a single line."""
        own = self.body(body)
        return [head, *own] if len(own) == 1 and len(body) == 1 else [f"{head} {{", *own, "}"]

    def _braces(self, head: str, body: tuple[Statement, ...]) -> list[str]:
        return [f"{head} {{".lstrip(), *self.body(body), "}"]


C_FORMATTER = CFormatter(LANES, SINGLES)
