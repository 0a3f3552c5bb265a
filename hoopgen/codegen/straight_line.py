"""Straight-line code: the statements of a program, and the expressions of its outputs."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from .formatter import Formatter, Spelling
from .program import Operations
from .statements import Apply, Declare, Expression, Name, Number, Operate, Statement


@dataclass(frozen=True)
class Body:
    """Statements, then one expression for each output; how many rows they write into."""

    statements: tuple[Statement, ...]
    outputs: tuple[Expression, ...]
    rows: int = 0


@dataclass(frozen=True)
class PrintedBody:
    """A body as a template writes it."""

    statements: list[str]
    outputs: list[str]
    rows: int = 0


def print_body(body: Body, formatter: Formatter) -> PrintedBody:
    """Return the text of a body.

    Parameters
    ----------
    body
        Statements and outputs.
    formatter
        The formatter of the target's language.
    """
    outputs = [formatter.expression(output) for output in body.outputs]
    return PrintedBody(formatter.lines(body.statements), outputs, body.rows)


def straight_line(
    program: Operations,
    spelling: Spelling,
    number: Callable[[float], Expression] | None = None,
    numbers: Sequence[int] = (),
) -> Body:
    """Return the statements and outputs of a program, with the types of a spelling.

    What is used once is written inside its user; `number` says how numbers are, if not as they are.
    Names are numbered in order, or have the number that `numbers` gives each operation.

    Parameters
    ----------
    program
        The operations of a kernel, in order.
    spelling
        How the target writes operations, and the types of its variables.
    number
        A function that gives the expression of a number; None for literals.
    numbers
        The number in the name of each operation's variable; empty for 0, 1, 2 …
    """
    named = program.named()
    values: list[Expression] = []
    statements: list[Statement] = []
    for index, operation in enumerate(program.operations):
        if operation.name in ("argument", "truth"):
            values.append(Name(operation.symbol))
        elif operation.name == "constant":
            own = number(operation.value) if number else Number(operation.value, program.single)
            values.append(own)
        else:
            operands = tuple(values[operand] for operand in operation.operands)
            value: Expression = Operate(operation.name, operands, program.single)
            if index in named:
                kind = spelling.truth if operation.is_truth else spelling.number
                name = f"_s{numbers[index] if numbers else len(statements)}"
                statements.append(Declare(name, kind, value, constant=True))
                value = Name(name)
            values.append(value)
    outputs = (_output(program, output, values[output], spelling) for output in program.outputs)
    return Body(tuple(statements), tuple(outputs))


def _output(program: Operations, index: int, value: Expression, spelling: Spelling) -> Expression:
    if spelling.truth_output and program.operations[index].is_truth:
        return Apply(spelling.truth_output, (value,))
    return value
