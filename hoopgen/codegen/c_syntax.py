"""The statements that C and languages like it write alike: assignments, branches, loops."""

from __future__ import annotations

from dataclasses import dataclass

from .formatter import Formatter
from .statements import (
    Assign,
    Block,
    Break,
    Cast,
    Choose,
    Declare,
    Execute,
    Expression,
    For,
    If,
    Return,
    Statement,
    Table,
    Tuple,
    While,
)


@dataclass(frozen=True)
class CSyntax(Formatter):
    """A formatter of what C and C++ have in common; a target adds how it calls kernels."""

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
        match statement:
            case Declare():
                return [self._declaration(statement)]
            case Table(name, kind, rows):
                entries = [f"    {{{self.expressions(row)}}}," for row in rows]
                return [f"{kind} {name}[][{len(rows[0])}] = {{", *entries, "};"]
            case Assign(target, value, operator):
                return [f"{self.expression(target)} {operator} {self.expression(value)};"]
            case Execute(value):
                return [f"{self.expression(value)};"]
            case Return(value):
                return [f"return {self.expression(value)};"]
            case Break():
                return ["break;"]
            case Block(body, True):
                return ["{", *self.lines(body), "}"]
            case Block(body):
                return self.braces("", body)
            case If(test, body, ()):
                return self._if(f"if ({self.expression(test)})", body)
            case While(None, body):
                return self.braces("for (;;)", body)
            case While(test, body) if test is not None:
                return self.braces(f"while ({self.expression(test)})", body)
            case For(index, end, body, ()):
                start, past = self.expression(statement.first), self.expression(end)
                head = f"for (size_t {index} = {start}; {index} < {past}; {index}++)"
                return self.braces(head, body)
        return super().statement(statement)

    def _declaration(self, new: Declare) -> str:
        room = "".join(f"[{self.expression(n) if n else ''}]" for n in new.room)
        value = f" = {self.expression(new.value)}" if new.value is not None else ""
        return f"{'const ' if new.constant else ''}{new.type} {new.name}{room}{value};"

    def _if(self, head: str, body: tuple[Statement, ...]) -> list[str]:
        """Return a test and its body, without braces around a single line."""
        own = self.body(body)
        return [head, *own] if len(own) == 1 and len(body) == 1 else [f"{head} {{", *own, "}"]

    def braces(self, head: str, body: tuple[Statement, ...]) -> list[str]:
        """Return a head and its body, with braces around the body.

        Parameters
        ----------
        head
            The text before the opening brace; it may be empty.
        body
            The statements between the braces, which are indented.
        """
        return [f"{head} {{".lstrip(), *self.body(body), "}"]
