"""Errors that are carried through a piece of a flight through air, by 40 digits."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import pytest
import sympy as sp
from hoopgen.derive.motion.air import AirFlight
from hoopgen.derive.scenes.air import AIR
from hoopgen.derive.symbolic.conditionals import release
from mpmath import mp, mpf, odefun

from tests.helpers.effort import trials

SIZES = {p.name: p.default for p in AIR.parameters}
STATE = ("x", "y", "z", "vx", "vy", "vz", "wx", "wy", "wz")


def _flight() -> AirFlight:
    flight = AIR.flight
    assert isinstance(flight, AirFlight)
    return flight


def _values(state: Sequence[mpf]) -> dict[str, mpf]:
    """Return parameters, state and the constants of its flight, by name."""
    known = {name: mpf(value) for name, value in SIZES.items()}
    known |= dict(zip(STATE, state, strict=True))
    return known | {name: _value(rate, known) for name, rate in _flight().rates().items()}


def _value(expression: sp.Expr, known: dict[str, mpf]) -> mpf:
    plain = release(expression)
    symbols = sorted(plain.free_symbols, key=lambda symbol: symbol.name)
    return mpf(sp.lambdify(symbols, plain, "mpmath")(*(known[s.name] for s in symbols)))


def _flown(state: Sequence[mpf], time: mpf) -> list[mpf]:
    """Return place and velocity at a time, from the force at the present velocity."""
    known = _values(state)
    forces = [release(one) for one in _flight().present_acceleration]
    velocity = sp.symbols("vx vy vz", real=True)
    rest = {s: sp.Float(known[s.name], 45) for f in forces for s in f.free_symbols}
    fixed = [f.xreplace({s: v for s, v in rest.items() if s not in velocity}) for f in forces]
    force = sp.lambdify(velocity, fixed, "mpmath")
    solved = odefun(lambda _, y: [*y[3:], *force(*y[3:])], 0, list(state[:6]))
    return list(solved(time))


def _carried(state: Sequence[mpf], error: Sequence[mpf], time: mpf) -> list[mpf]:
    """Return the errors of place and velocity at a time, as the kernels carry them."""
    end = _flown(state, time)
    known = _values([*end, *state[6:]])
    known |= {f"d{name}": e for name, e in zip(STATE, error, strict=True)} | {"t": time}
    places, moving = _flight().along()
    return [_value(one, known) for one in (*places, *moving)]


def _off(state: Sequence[mpf], error: Sequence[mpf], time: mpf) -> float:
    """Return by how much carried errors are off, relative to them."""
    small = mpf(10) ** -18
    moved = [a + small * b for a, b in zip(state, error, strict=True)]
    pairs = zip(_flown(moved, time), _flown(state, time), strict=True)
    true = [(there - here) / small for there, here in pairs]
    wrong = [a - b for a, b in zip(_carried(state, error, time), true, strict=True)]
    return float(mp.norm(wrong) / mp.norm(true))


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(trials(4, at_least=2)))
def test_carried_errors_are_those_of_a_neighbour_but_for_the_second_order_in_time(
    seed: int,
) -> None:
    random = np.random.default_rng(seed)
    state = random.normal(size=9) * np.repeat([2.0, 5.0, 20.0], 3)
    error = random.normal(size=9)
    with mp.workdps(40):
        starts, errors = [mpf(c) for c in state], [mpf(c) for c in error]
        long, short = (_off(starts, errors, mpf(1) / n) for n in (16, 64))
    assert long < 0.01
    assert 1.5 < math.log(long / short, 4) < 3.5
