"""The evaluators of the tests of derive/: any expression, in mpmath and in doubles.

In mpmath it is evaluated as it stands, to the working precision; in doubles as a kernel is, with
the operations and in the order that the generated code has. Infinities and what is not a number
are as in IEEE 754 in both.
"""

from __future__ import annotations

import math
import operator
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache, reduce
from itertools import pairwise
from typing import Any

import mpmath
import numpy as np
import pytest
import sympy as sp
from hoopgen.derive.events.root_finder import RootFinder
from hoopgen.derive.ir.kernel import Kernel
from hoopgen.derive.scenes import HOOP
from hoopgen.derive.symbolic.conditionals import (
    Barrier,
    IfAtMost,
    IfLess,
    absolute,
    barrier,
    maximum,
    minimum,
)
from hypothesis import strategies as st
from mpmath import mpf
from numpy.typing import NDArray

from hoopgen.codegen.program import Program, lower
from tests.helpers.derived import OPERATIONS

Values = Mapping[str, Any]

NAN, INFINITY = mpf("nan"), mpf("inf")
PARAMETERS = {p.name: p.default for p in HOOP.parameters}


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


def power(exponent: sp.Rational) -> Callable[[mpf], mpf]:
    """Return the function that raises to an integer or half-integer power."""
    whole, half = map(int, divmod(abs(2 * exponent), 2))
    inverse = exponent < 0

    def raised(base: mpf, _: mpf) -> mpf:
        result = base**whole * (root(base) if half else 1)
        return divide(mpf(1), result) if inverse else result

    return raised


def meaning(part: sp.Basic) -> Callable[..., mpf]:
    """Return what computes an expression from its parts."""
    if part.is_Rational:
        return lambda p=part.p, q=part.q: mpf(p) / q
    if part in (sp.oo, -sp.oo):
        limit = INFINITY if part is sp.oo else -INFINITY
        return lambda: limit
    if part.is_Add:
        return lambda *terms: reduce(operator.add, terms)
    if part.is_Mul:
        return lambda *factors: reduce(operator.mul, factors)
    if part.is_Pow:
        return power(part.exp)
    if isinstance(part, Barrier):
        return lambda quantity: quantity
    if isinstance(part, sp.Abs):
        return abs
    if isinstance(part, IfLess):
        return lambda left, right, then, other: then if left < right else other
    if isinstance(part, IfAtMost):
        return lambda left, right, then, other: then if left <= right else other
    raise TypeError(f"no value for {type(part).__name__}")


Step = tuple[str, Callable[..., mpf] | None, tuple[int, ...]]


@cache
def plan(expression: sp.Expr) -> list[Step]:
    """Return what to do for each part of an expression, its own parts first."""
    order: dict[sp.Basic, int] = {}
    steps: list[Step] = []

    def visit(part: sp.Basic) -> int:
        if part not in order:
            inner = tuple(map(visit, part.args))
            name = part.name if part.is_Symbol else ""
            steps.append((name, None if name else meaning(part), inner))
            order[part] = len(order)
        return order[part]

    visit(expression)
    return steps


def exactly(expression: sp.Expr | int, values: Values) -> mpf:
    """Return the expression's value at the working precision; `values` are by symbol name."""
    done: list[mpf] = []
    for name, compute, inner in plan(sp.sympify(expression)):
        done.append(mpf(values[name]) if compute is None else compute(*[done[i] for i in inner]))
    return done[-1]


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
                name = operation.symbol.removeprefix("p_")  # of a parameter
                done.append(np.asarray(values[name], np.float64))
            elif operation.name == "truth":
                done.append(np.asarray(values[operation.symbol], bool))
            elif operation.name == "constant":
                done.append(np.float64(operation.value))
            else:
                operands = (done[operand] for operand in operation.operands)
                done.append(OPERATIONS[operation.name](*operands))
    return dict(zip(expressions, (done[output] for output in lowered.outputs), strict=True))


def along(approach: RootFinder, state: Values) -> dict[str, Any]:
    """Return state, parameters and the constants of a search, which are exact."""
    values = PARAMETERS | {"position_error": 0, "velocity_error": 0} | dict(state)
    values["extent"] = sum(abs(mpf(values[name])) for name in ("x", "y", "z"))
    values["speed"] = sum(abs(mpf(values[name])) for name in ("vx", "vy", "vz"))
    constants = {name: exactly(e, values) for name, e in approach.constants.items()}
    return values | constants


@dataclass(frozen=True)
class Path:
    """A flight near the ring in mpmath: what the derivation's claims are held against."""

    values: dict[str, Any]

    def __getitem__(self, name: str) -> mpf:
        return mpf(self.values[name])

    @property
    def reach(self) -> mpf:
        """R."""
        return self["ball_radius"] + self["wire_radius"]

    def place(self, t: mpf) -> tuple[mpf, mpf]:
        """Return rho and z (Eq. 3)."""
        x, y = self["x"] + self["vx"] * t, self["y"] + self["vy"] * t
        z = self["z"] + t * (self["vz"] - self["gravity"] * t / 2)
        return mpmath.sqrt(x * x + y * y), z

    def gap(self, t: mpf) -> mpf:
        """Return F of Table 2's ring."""
        rho, z = self.place(t)
        return (rho - self["ring_radius"]) ** 2 + z * z - self.reach**2

    def near(self) -> list[tuple[mpf, mpf]]:
        """Return the intervals of time in which |z| <= R and |rho - R_H| <= R.

        Between neighbouring roots of z = ±R and rho = R_H ± R either holds all along or nowhere.
        """
        x, y, vx, vy = (self[name] for name in ("x", "y", "vx", "vy"))
        times = []
        for level in (self.reach, -self.reach):
            times += quadratic(-self["gravity"] / 2, self["vz"], self["z"] - level)
        for radius in (self["ring_radius"] - self.reach, self["ring_radius"] + self.reach):
            times += quadratic(
                vx * vx + vy * vy, 2 * (x * vx + y * vy), x * x + y * y - radius * radius
            )
        times.sort()
        return [pair for pair in pairwise(times) if self._is_near((pair[0] + pair[1]) / 2)]

    def _is_near(self, t: mpf) -> bool:
        rho, z = self.place(t)
        return bool(abs(z) <= self.reach and abs(rho - self["ring_radius"]) <= self.reach)


def quadratic(a: mpf, b: mpf, c: mpf) -> list[mpf]:
    """Return the real roots of a t² + b t + c, by digits enough for its two forms to cancel."""
    with mpmath.extradps(400):
        if a == 0:
            return [] if b == 0 else [-c / b]
        discriminant = b * b - 4 * a * c
        if discriminant < 0:
            return []
        return [
            (-b - mpmath.sqrt(discriminant)) / (2 * a),
            (-b + mpmath.sqrt(discriminant)) / (2 * a),
        ]


GEOMETRIES = (
    (0.235, 0.12128, 0.01),
    (0.235, 0.001, 0.0001),
    (1.0, 0.5, 0.4999),
    (30.0, 0.12, 0.01),
)
"""Radii of ring, ball and wire."""


@st.composite
def paths(draw: st.DrawFn) -> Path:
    """Draw flights that touch the ring, graze it or pass it by, some of them peculiar."""
    ring_radius, ball_radius, wire_radius = draw(st.sampled_from(GEOMETRIES))
    reach = (ball_radius + wire_radius) * draw(st.sampled_from((1.0, 0.5)) | st.floats(0.9, 1.1))
    along, around, heading = (draw(st.floats(0, 6.3)) for _ in range(3))
    kind = draw(st.sampled_from(("any", "any", "radial", "vertical", "slow", "tangent", "apex")))
    speed = 10 ** draw(st.floats(-3, 2))
    if kind == "vertical":
        speed = 0.0
    elif kind == "slow":
        speed = 10 ** draw(st.floats(-320, -3))
    elif kind == "radial":
        along, heading = 0.0, draw(st.sampled_from((0.0, math.pi)))
    elif kind == "tangent":
        heading = along + math.pi / 2
    time, gravity = draw(st.floats(0, 2)), PARAMETERS["gravity"]
    out, rising = ring_radius + reach * math.cos(around), draw(st.floats(-10, 10))
    # sin(pi) is not zero in doubles; a radial path is to be exactly radial.
    sideways = 0.0 if kind == "radial" else 1.0
    vx, vy = speed * math.cos(heading), sideways * speed * math.sin(heading)
    vz = rising + gravity * time
    height = reach * math.sin(around)
    if kind == "apex":
        vz, height = gravity * time, reach
    values = {
        "x": out * math.cos(along) - vx * time,
        "y": sideways * out * math.sin(along) - vy * time,
        "z": height - vz * time + gravity * time**2 / 2,
        "vx": vx,
        "vy": vy,
        "vz": vz,
        "ring_radius": ring_radius,
        "ball_radius": ball_radius,
        "wire_radius": wire_radius,
    }
    return Path(PARAMETERS | values)


def resting(**state: float) -> Path:
    """Return a flight with the state and parameters given; the rest of the state is zero."""
    return Path(PARAMETERS | dict.fromkeys(("x", "y", "z", "vx", "vy", "vz"), 0.0) | state)


# -- Both evaluations themselves

a, b = sp.symbols("a b", real=True)


@pytest.mark.parametrize(
    ("expression", "value"),
    [
        ((a + b) ** 2 / 3, 12),
        (sp.sqrt(b - a) ** 3 / (b - 1) ** 2, 0.5),
        (maximum(a, 3, b), 5),
        (minimum(a, 3, b), 1),
        (barrier(a - b) * barrier(b - a), -16),
        (absolute(a - b), 4),
        (1 / (a - 1), INFINITY),
        (-1 / (a - 1), -INFINITY),
        (IfLess(a, b, 1 / (a - 1), 2), INFINITY),
        (IfAtMost(a, 1, 7, sp.oo), 7),
        (IfLess(a, 1, 7, sp.oo), INFINITY),
        # A side that is not a number fails the condition.
        (IfLess(sp.sqrt(a - b), 9, 1, 2), 2),
        (minimum(b, sp.sqrt(a - b)), 5),
        (minimum(b, (a - 1) / (a - 1) ** 2 * barrier(a - 1)), 5),
    ],
)
def test_an_expression_has_its_value_in_mpmath_and_in_doubles(
    expression: sp.Expr, value: float
) -> None:
    values = {"a": 1.0, "b": 5.0}
    assert exactly(expression, values) == value
    assert in_doubles({"it": expression}, values)["it"] == value
