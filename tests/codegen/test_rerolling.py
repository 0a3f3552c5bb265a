"""Long chains over parameters are loops in C, and both loops one text: nothing else changes."""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import pytest
import sympy as sp
from hoopgen.derive.ir.kernel import Kernel
from hoopgen.derive.symbolic.conditionals import AtMost, IfLess, Less, absolute, all_of
from hoopgen.derive.symbolic.symbols import ParameterSymbol

from hoopgen.codegen.c.merging import merge_variants
from hoopgen.codegen.c.spelling import LANES, parameter_of_row
from hoopgen.codegen.identifiers import identifier
from hoopgen.codegen.program import Program, lower
from hoopgen.codegen.rerolling import rerolled
from hoopgen.codegen.statements import (
    Apply,
    Assign,
    Declare,
    Expression,
    For,
    Infix,
    Item,
    Name,
    Number,
    Operate,
    Scalar,
    Statement,
    Table,
)

OPERATIONS: Mapping[str, Callable[..., Any]] = {
    "add": lambda a, b: a + b,
    "sub": lambda a, b: a - b,
    "mul": lambda a, b: a * b,
    "abs": abs,
    "less": lambda a, b: a < b,
    "at_most": lambda a, b: a <= b,
    "both": lambda a, b: a and b,
    "select": lambda m, a, b: a if m else b,
}


def evaluated(program: Program, values: Sequence[float], other: float) -> list[Any]:
    """Return what a program computes, as it was lowered."""
    names = [identifier(symbol) for symbol in program.kernel.arguments]
    given = dict(zip(names, (*values, other), strict=True))
    found: list[Any] = []
    for operation in program.operations:
        operands = [found[k] for k in operation.operands]
        match operation.name:
            case "argument":
                found.append(given[operation.symbol])
            case "constant":
                found.append(operation.value)
            case name:
                found.append(OPERATIONS[name](*operands))
    return [found[k] for k in program.outputs]


def run(statements: Sequence[Statement], known: dict[str, Any]) -> None:
    for statement in statements:
        match statement:
            case Declare(name, _, value) if value is not None:
                known[name] = worth(value, known)
            case Assign(Name(name), value):
                known[name] = worth(value, known)
            case Table(name, _, rows):
                known[name] = [[worth(value, known) for value in row] for row in rows]
            case For(index, end, body):
                for k in range(worth(end, known)):
                    known[index] = k
                    run(body, known)
            case _:
                raise AssertionError(statement)


def worth(value: Expression, known: Mapping[str, Any]) -> Any:
    match value:
        case Name(name):
            return known[name]
        case Number(number) | Scalar(number):
            return number
        case Operate(name, operands):
            return OPERATIONS[name](*(worth(part, known) for part in operands))
        case Item(array, index):
            return worth(array, known)[worth(index, known)]
        case Apply("lanes_load", (Infix("+", place, _),)):
            return worth(place, known)
    raise AssertionError(value)


def symbols(count: int) -> list[sp.Symbol]:
    return [ParameterSymbol(f"size_{k}", real=True) for k in range(count)]


def program_of(outputs: Mapping[str, sp.Basic], arguments: Sequence[sp.Symbol]) -> Program:
    made = Kernel("chain", tuple(arguments), tuple(outputs.items()), "A chain.", "none")
    return lower(made)


@pytest.mark.parametrize("count", [2, 5, 9, 40])
def test_a_chain_is_a_loop_of_the_same_operations(count: int) -> None:
    sizes, other = symbols(count), sp.Symbol("other", real=True)
    verdict: sp.Expr = sp.Integer(1)
    for k, size in enumerate(sizes):
        verdict = IfLess(0, size, verdict, 0)
        if k % 2:  # two steps a turn
            verdict = IfLess(size, other, verdict, 0)
    outputs = {
        "total": sp.Add(*map(sp.Abs, sizes)),
        "verdict": verdict,
        "range": all_of(
            Less(0, other), *(AtMost(absolute(size), 2.0**k) for k, size in enumerate(sizes))
        ),
    }
    program = program_of(outputs, (*sizes, other))
    numbers = {identifier(size): k for k, size in enumerate(sizes)}
    body = rerolled(program, numbers, LANES, parameter_of_row)
    loops = [statement for statement in body.statements if isinstance(statement, For)]
    assert bool(loops) == (count > 5)
    random.seed(count)
    for trial in range(200):
        values = [random.choice((1, 1, 1, -1)) * math.exp(random.gauss(0, 9)) for _ in sizes]
        if trial % 2:
            values = [abs(value) % 1 for value in values]
        if trial % 7 == 0:
            values[trial % count] = math.nan
        wanted = evaluated(program, values, 3.0)
        known: dict[str, Any] = {"p": values, "row": 0, "other": 3.0}
        run(body.statements, known)
        found = [worth(output, known) for output in body.outputs]
        assert list(map(repr, found)) == list(map(repr, wanted))


def preprocessed(text: str, bounded: bool) -> list[str]:
    kept, taken = [], [True]
    for line in text.splitlines():
        if line in ("#if BOUNDED", "#if !BOUNDED"):
            taken.append(bounded == (line == "#if BOUNDED"))
        elif line == "#else":
            taken[-1] = not taken[-1]
        elif line == "#endif":
            taken.pop()
        elif all(taken):
            kept.append(line)
    return kept


def test_each_variant_can_be_had_again_from_the_text_of_both() -> None:
    random.seed(5)
    for _ in range(100):
        bounded = random.choices("abcdef", k=30)
        plain = [random.choice("abx") if random.random() < 0.1 else line for line in bounded]
        plain = [line for line in plain if random.random() < 0.8]
        text = merge_variants("\n".join(plain), "\n".join(bounded))
        assert preprocessed(text, bounded=False) == plain
        assert preprocessed(text, bounded=True) == bounded
