"""What the other tests of derive/ evaluate with: any expression, in mpmath and in doubles.

In mpmath it is evaluated as it stands, to the working precision; in doubles as a kernel is, with
the operations and in the order that the generated code has. Infinities and what is not a number
are as in IEEE 754 in both.
"""

from __future__ import annotations

import operator
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from functools import cache, reduce
from typing import Any

import mpmath
import numpy as np
import pytest
import sympy as sp
from hoopgen.derive.choice import Held, IfAtMost, IfLess, hold, largest, size, smallest
from hoopgen.derive.events import Approach
from hoopgen.derive.kernel import Kernel
from hoopgen.derive.scenes import HOOP
from mpmath import mpf
from numpy.typing import NDArray

from hoopgen.codegen.program import Program, lower

Values = Mapping[str, Any]

NAN, INFINITY = mpf("nan"), mpf("inf")
PARAMETERS = {p.symbol.name: p.default for p in HOOP.parameters}
OPERATIONS = {
    "add": np.add,
    "sub": np.subtract,
    "mul": np.multiply,
    "div": np.divide,
    "neg": np.negative,
    "sqrt": np.sqrt,
    "abs": np.absolute,
    "less": np.less,
    "at_most": np.less_equal,
    "select": np.where,
}


@contextmanager
def digits(count: int) -> Iterator[None]:
    """Work with that many decimal digits."""
    with mpmath.workdps(count):
        yield


def divide(a: mpf, b: mpf) -> mpf:
    """Return a / b as IEEE 754 has it, all zeros positive."""
    if b != 0:
        return a / b
    return NAN if a == 0 or mpmath.isnan(a) else mpmath.sign(a) * INFINITY


def root(a: mpf) -> mpf:
    """Return the square root, not a number where it is not real."""
    return mpmath.sqrt(a) if a >= 0 else NAN


def power(base: mpf, exponent: sp.Rational) -> mpf:
    """Return an integer or half-integer power."""
    whole, half = divmod(abs(2 * exponent), 2)
    result = base ** int(whole) * (root(base) if half else 1)
    return divide(mpf(1), result) if exponent < 0 else result


@cache
def parts_first(expression: sp.Expr) -> tuple[sp.Basic, ...]:
    """Return the parts of an expression, each once and after its own parts."""
    return tuple(dict.fromkeys(sp.postorder_traversal(expression)))


def exactly(expression: sp.Expr | int, values: Values) -> mpf:
    """Return the expression's value at the working precision; `values` are by symbol name."""
    done: dict[sp.Basic, Any] = {}
    for part in parts_first(sp.sympify(expression)):
        inner = [done[argument] for argument in part.args]
        if part.is_Symbol:
            done[part] = mpf(values[part.name])
        elif part.is_Rational:
            done[part] = mpf(part.p) / part.q
        elif part.is_infinite:
            done[part] = INFINITY if part.is_extended_positive else -INFINITY
        elif part.is_Add:
            done[part] = reduce(operator.add, inner)
        elif part.is_Mul:
            done[part] = reduce(operator.mul, inner)
        elif part.is_Pow:
            done[part] = power(inner[0], part.exp)
        elif isinstance(part, Held):
            done[part] = inner[0]
        elif isinstance(part, sp.Abs):
            done[part] = abs(inner[0])
        elif isinstance(part, IfLess):
            done[part] = inner[2] if inner[0] < inner[1] else inner[3]
        elif isinstance(part, IfAtMost):
            done[part] = inner[2] if inner[0] <= inner[1] else inner[3]
        else:
            raise TypeError(f"no value for {type(part).__name__}")
    return done[sp.sympify(expression)]


@cache
def program(outputs: tuple[sp.Expr, ...]) -> Program:
    """Return the program of the generated code for these expressions."""
    arguments = sorted(set().union(*(e.free_symbols for e in outputs)), key=str)
    named = tuple((f"out{k}", e) for k, e in enumerate(outputs))
    return lower(Kernel("outputs", tuple(arguments), named, "", ""))


def in_doubles(expressions: Mapping[str, sp.Expr | int], values: Values) -> dict[str, NDArray[Any]]:
    """Return the expressions' values as the generated code has them; arrays broadcast."""
    lowered = program(tuple(sp.sympify(e) for e in expressions.values()))
    done: list[Any] = []
    with np.errstate(all="ignore"):
        for operation in lowered.operations:
            if operation.name == "argument":
                done.append(np.asarray(values[operation.symbol], np.float64))
            elif operation.name == "constant":
                done.append(np.float64(operation.value))
            else:
                operands = (done[operand] for operand in operation.operands)
                done.append(OPERATIONS[operation.name](*operands))
    return dict(zip(expressions, (done[output] for output in lowered.outputs), strict=True))


def along(approach: Approach, state: Values) -> dict[str, Any]:
    """Return state, parameters and the constants of a search, which are exact."""
    values = PARAMETERS | {"position_error": 0, "velocity_error": 0} | dict(state)
    values["extent"] = sum(abs(mpf(values[name])) for name in ("x", "y", "z"))
    values["speed"] = sum(abs(mpf(values[name])) for name in ("vx", "vy", "vz"))
    constants = {name: exactly(e, values) for name, e in approach.constants.items()}
    return values | constants


# -- Both evaluations themselves

a, b = sp.symbols("a b", real=True)


@pytest.mark.parametrize(
    ("expression", "value"),
    [
        ((a + b) ** 2 / 3, 12),
        (sp.sqrt(b - a) ** 3 / (b - 1) ** 2, 0.5),
        (largest(a, 3, b), 5),
        (smallest(a, 3, b), 1),
        (hold(a - b) * hold(b - a), -16),
        (size(a - b), 4),
        (1 / (a - 1), INFINITY),
        (-1 / (a - 1), -INFINITY),
        (IfLess(a, b, 1 / (a - 1), 2), INFINITY),
        (IfAtMost(a, 1, 7, sp.oo), 7),
        (IfLess(a, 1, 7, sp.oo), INFINITY),
        # A side that is not a number fails the condition.
        (IfLess(sp.sqrt(a - b), 9, 1, 2), 2),
        (smallest(b, sp.sqrt(a - b)), 5),
        (smallest(b, (a - 1) / (a - 1) ** 2 * hold(a - 1)), 5),
    ],
)
def test_an_expression_has_its_value_in_mpmath_and_in_doubles(
    expression: sp.Expr, value: float
) -> None:
    values = {"a": 1.0, "b": 5.0}
    assert exactly(expression, values) == value
    assert in_doubles({"it": expression}, values)["it"] == value
