"""Flight through air: one step's error is within its proved bound, by 40 digits."""

from __future__ import annotations

import math
from collections.abc import Callable
from operator import add, mul, sub, truediv
from typing import Any

import numpy as np
from hoopgen.derive.scenes.air import air_step
from mpmath import mp, mpf, odefun, sqrt

from hoopgen.codegen.program import Program, lower
from tests.helpers.effort import trials

PROGRAM: Program = lower(air_step())

DEFAULTS = (9.81, 0.1213, 0.624, 1.2, 0.5, 0.6, 0.05)
"""The parameters in calling order."""

NAMES = ("x", "y", "z", "vx", "vy", "vz")

_OPERATIONS: dict[str, Callable[..., Any]] = {
    "add": add,
    "sub": sub,
    "mul": mul,
    "div": truediv,
    "neg": lambda a: -a,
    "sqrt": math.sqrt,
    "abs": abs,
    "max": max,
    "min": min,
    "less": lambda a, b: a < b,
    "at_most": lambda a, b: a <= b,
    "both": lambda a, b: a and b,
    "select": lambda truth, a, b: a if truth else b,
}


def step(longest: float, state: np.ndarray, parameters: tuple[float, ...]) -> dict[str, float]:
    """Return the results of one step, each operation rounded to double precision."""
    values = dict(
        zip(
            [s.name for s in PROGRAM.kernel.arguments],
            [longest, *state, 0.0, 0.0, *parameters],
            strict=True,
        )
    )
    done: list[float] = []
    for operation in PROGRAM.operations:
        if operation.name == "argument":
            done.append(values[operation.symbol.removeprefix("p_")])
        elif operation.name == "constant":
            done.append(operation.value)
        else:
            operands = (done[k] for k in operation.operands)
            done.append(_OPERATIONS[operation.name](*operands))
    return dict(zip(PROGRAM.kernel.output_names, (done[k] for k in PROGRAM.outputs), strict=True))


def test_the_error_of_a_step_is_within_its_bound_and_the_bound_is_not_useless() -> None:
    random = np.random.default_rng(5)
    ratios = []
    for _ in range(trials(20, at_least=4)):
        state = random.normal(size=9) * np.repeat([2.0, 5.0, 20.0], 3)
        found = step(1.0, state, DEFAULTS)
        assert 1e-3 < found["step"] < 1.0
        with mp.workdps(40):
            exact = reference(state, found["step"])
            off = [abs(mpf(found[n]) - e) for n, e in zip(NAMES, exact, strict=True)]
            place, speed = mp.norm(off[:3]), mp.norm(off[3:])
        assert place <= found["position_error"] < 1e-12
        assert speed <= found["velocity_error"] < 1e-12
        ratios.append(float(found["velocity_error"] / speed))
    assert np.median(ratios) < 1000.0


def reference(state: np.ndarray, time: float) -> list[mpf]:
    """Return position and velocity by mpmath's Taylor series."""
    g, r, m, rho, cd, cm, vs = map(mpf, DEFAULTS)
    w = [mpf(c) for c in state[6:]]
    half = rho * mp.pi * r**2 / (2 * m)
    fall = g * (1 - rho * 4 * mp.pi * r**3 / (3 * m))

    def force(_: mpf, y: list[mpf]) -> list[mpf]:
        v = y[3:]
        size = sqrt(v[0] ** 2 + v[1] ** 2 + v[2] ** 2 + vs**2)
        lift = half * r * cm
        cross = [w[1] * v[2] - w[2] * v[1], w[2] * v[0] - w[0] * v[2], w[0] * v[1] - w[1] * v[0]]
        bend = [lift * c - half * cd * size * one for c, one in zip(cross, v, strict=True)]
        return [*v, bend[0], bend[1], bend[2] - fall]

    return list(odefun(force, 0, [mpf(c) for c in state[:6]])(mpf(time)))


def test_a_flight_has_the_check_value_without_spin_and_smoothing() -> None:
    """The expected place is a check value of the equations of motion, given to 17 digits."""
    state = np.array([4.191, 0.0, -0.6096, -4.5, 0.0, 5.7, 0.0, 0.0, 0.0])
    left, steps, error = 0.8, 0, 0.0
    while left > 0.0 and steps < 30:
        found = step(left, state, (*DEFAULTS[:5], 0.0, 1e-9))
        left -= found["step"]
        error += found["position_error"] + found["velocity_error"]
        state[:6] = [found[name] for name in NAMES]
        steps += 1
    assert left == 0.0
    assert steps < 15
    assert error < 1e-12
    assert abs(state[0] - 0.76222124628603537) < 1e-14
    assert abs(state[2] - 0.72679937946567789) < 1e-14
