"""Running error analysis: its bounds hold the errors of doubles, against exact fractions."""

from __future__ import annotations

import math
from dataclasses import replace
from fractions import Fraction
from typing import Any

import pytest
import sympy as sp
from hoopgen.derive.events.event_polynomials import displacement
from hoopgen.derive.events.plane import plane_arrival, plane_margin
from hoopgen.derive.motion.parabola import Parabola
from hoopgen.derive.scenes import HOOP
from hoopgen.derive.scenes.scene import AXES
from hoopgen.derive.surfaces import Plane
from hoopgen.derive.symbolic.conditionals import barrier
from hoopgen.derive.symbolic.rounding import (
    ROUNDING_SLACK,
    Rounded,
    exact,
    rounding,
)
from hoopgen.derive.symbolic.symbols import POSITION, UNIT_ROUNDOFF, VELOCITY
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from mpmath import mpf

from tests.derive.test_evaluation import PARAMETERS, digits, exactly, in_doubles
from tests.helpers.effort import trials

A = sp.symbols("a b c d", real=True)
often = settings(deadline=None, derandomize=True, max_examples=trials(150))
sometimes = settings(deadline=None, derandomize=True, max_examples=trials(80))

sizes = st.floats(1e-3, 1e3) | st.sampled_from((1.0, 3.0, 0.1, 1 / 3, 2.0**52 + 1))
numbers = st.builds(lambda size, sign: size * sign, sizes, st.sampled_from((-1, 1)))
constants = st.fractions(-20, 20, max_denominator=12).map(sp.Rational)


def grow(parts: st.SearchStrategy[sp.Expr]) -> st.SearchStrategy[sp.Expr]:
    """Return sums, products, powers and held sums of the parts."""
    several = st.lists(parts, min_size=2, max_size=4)
    return (
        several.map(lambda terms: sp.Add(*terms))
        | several.map(lambda factors: sp.Mul(*factors))
        | st.builds(lambda base, n: base**n, parts, st.integers(2, 5))
        | several.map(lambda terms: barrier(sp.Add(*terms)))
    )


expressions = st.recursive(st.sampled_from(A) | constants, grow, max_leaves=14)


def in_fractions(expression: sp.Expr, values: dict[str, float]) -> Fraction:
    """Return the exact value of an expression without divisions."""
    if expression.is_Symbol:
        return Fraction(values[expression.name])
    if expression.is_Rational:
        return Fraction(int(expression.p), int(expression.q))
    parts = [in_fractions(argument, values) for argument in expression.args[:1]]
    if expression.is_Pow:
        return parts[0] ** int(expression.exp)
    parts += [in_fractions(argument, values) for argument in expression.args[1:]]
    if expression.is_Add:
        return sum(parts, Fraction(0))
    if expression.is_Mul:
        return math.prod(parts, start=Fraction(1))
    (held,) = parts
    return held


def in_any_order(expression: sp.Expr, values: dict[str, float], draw: Any) -> float:
    """Return a double evaluation whose sums and products are taken in an order that is drawn."""
    if expression.is_Symbol:
        return values[expression.name]
    if expression.is_Rational:
        return float(expression)
    if expression.is_Pow:
        operands = [expression.base] * int(expression.exp)
    else:
        operands = list(expression.args)
    parts = [in_any_order(operand, values, draw) for operand in operands]
    while len(parts) > 1:
        one = parts.pop(draw(st.integers(0, len(parts) - 1)))
        other = parts.pop(draw(st.integers(0, len(parts) - 1)))
        parts.append(one + other if expression.is_Add else one * other)
    return parts[0]


def is_tame(expression: sp.Expr, values: dict[str, float]) -> bool:
    """Return True if nothing overflows or underflows, in any order."""
    parts = [e for e in sp.postorder_traversal(expression) if e.free_symbols]
    magnitudes = [exactly(rounding(part, {}).magnitude, values) for part in parts]
    return all(1e-30 < magnitude < 1e30 for magnitude in magnitudes)


def bound(expression: sp.Expr, known: dict[sp.Expr, Rounded], values: dict[str, Any]) -> mpf:
    """Return the error bound of an expression."""
    return exactly(ROUNDING_SLACK * rounding(expression, known).error, values)


def off_by(computed: float, true: Fraction) -> mpf:
    """Return the error of a double."""
    error = abs(Fraction(float(computed)) - true)
    return mpf(error.numerator) / error.denominator


states = st.fixed_dictionaries(dict.fromkeys("abcd", numbers))


@pytest.mark.slow
@often
@given(expressions, states, st.data())
def test_the_bound_holds_for_sums_and_products_in_any_order(
    expression: sp.Expr, values: dict[str, float], data: Any
) -> None:
    with digits(40):
        assume(is_tame(expression, values))
        true = in_fractions(expression, values)
        limit = bound(expression, {}, values)
        assert off_by(in_any_order(expression, values, data.draw), true) <= limit
        generated = in_doubles({"it": expression}, values)["it"]
        assert off_by(generated, true) <= limit


@often
@given(expressions, states)
def test_the_magnitude_bounds_the_value(expression: sp.Expr, values: dict[str, float]) -> None:
    with digits(40):
        assume(is_tame(expression, values))
        magnitude = exactly(rounding(expression, {}).magnitude, values)
        assert off_by(0.0, in_fractions(expression, values)) <= magnitude * (1 + mpf(10) ** -38)


@often
@given(expressions, states, st.tuples(*[st.floats(-1, 1)] * 4))
def test_the_bound_holds_for_inputs_that_are_off(
    expression: sp.Expr, values: dict[str, float], shares: tuple[float, ...]
) -> None:
    """Each input is off by a part of a bound: what is carried is added to what is rounded."""
    with digits(40):
        assume(is_tame(expression, values))
        names = [a.name for a in A]
        allowed = {f"{name}_off": abs(values[name]) * 2.0**-40 for name in names}
        known = {
            a: Rounded(sp.Abs(a), sp.Symbol(off, nonnegative=True))
            for a, off in zip(A, allowed, strict=True)
        }
        true = {
            name: Fraction(values[name]) + Fraction(share) * Fraction(off)
            for name, share, off in zip(names, shares, allowed.values(), strict=True)
        }
        generated = in_doubles({"it": expression}, values)["it"]
        error = off_by(generated, in_fractions(expression, true))
        assert error <= bound(expression, known, values | allowed)


def test_what_is_known_is_taken_before_its_parts() -> None:
    a, b = A[:2]
    known = {a + b: Rounded(sp.Integer(5), sp.Integer(0))}
    assert rounding((a + b) * a, known).magnitude == 5 * sp.Abs(a)
    assert rounding((a + b) * a, known).error == 5 * UNIT_ROUNDOFF * sp.Abs(a)


@pytest.mark.parametrize(
    ("number", "error"), [(sp.Rational(3, 8), 0), (sp.Rational(1, 3), UNIT_ROUNDOFF / 3)]
)
def test_a_constant_is_rounded_unless_it_is_a_double(number: sp.Rational, error: sp.Expr) -> None:
    assert rounding(number, {}) == Rounded(number, error)


def test_an_exact_input_has_no_error() -> None:
    assert exact(A[0]) == Rounded(sp.Abs(A[0]), sp.Integer(0))
    assert rounding(A[0], {}) == exact(A[0])


@pytest.mark.parametrize("power", [1, 2, 3])
def test_the_inverse_of_an_exact_input_has_the_error_of_its_operations(power: int) -> None:
    """The power's roundings, and the division's."""
    size = sp.Abs(A[0]) ** -power
    found = rounding(A[0] ** -power, {})
    assert sp.simplify(found.magnitude - size) == 0
    assert sp.simplify(found.error - power * UNIT_ROUNDOFF * size) == 0


@pytest.mark.parametrize(
    ("expression", "known"),
    [
        (1 / A[0], {A[0]: Rounded(sp.Integer(1))}),
        (1 / (1 + A[0]), {}),
        (sp.sqrt(A[0]), {}),
        (sp.sin(A[0]), {}),
    ],
    ids=["inverse of what is bounded", "inverse of a sum", "root", "sine"],
)
def test_what_has_no_bound_is_refused(expression: sp.Expr, known: dict[sp.Expr, Rounded]) -> None:
    with pytest.raises(ValueError, match="no rounding bound"):
        rounding(expression, known)


# -- Flights and planes

components = (*POSITION, *VELOCITY)
speeds = st.floats(-20, 20)
starts = st.fixed_dictionaries({s.name: speeds for s in components})
PLANES = [s for s in (*HOOP.surfaces, *HOOP.end_planes) if isinstance(s, Plane)]
planes = pytest.mark.parametrize("plane", PLANES, ids=lambda s: s.name)
flights = pytest.mark.parametrize(
    "flight", [replace(HOOP, gravity_axis=axis).flight for axis in AXES], ids=map(str, AXES)
)


def with_sizes(start: dict[str, float]) -> dict[str, Any]:
    """Return the start with the parameters and the sums of sizes that bounds are measured by."""
    sizes = {
        "extent": sum(abs(mpf(start[s.name])) for s in POSITION),
        "speed": sum(abs(mpf(start[s.name])) for s in VELOCITY),
    }
    return PARAMETERS | start | sizes | {"position_error": 0, "velocity_error": 0, "leaving": 0}


@pytest.mark.sampled(4)
@flights
@sometimes
@given(
    start=starts,
    time=st.floats(0, 5),
    error=st.sampled_from((0.0, 1e-13, 1e-8)),
    signs=st.integers(0, 63),
)
def test_the_flights_bounds_hold_its_roundings_and_the_errors_of_its_start(
    flight: Parabola, start: dict[str, float], time: float, error: float, signs: int
) -> None:
    with digits(40):
        values = with_sizes(start) | {"t": time, "horizon": time}
        values |= {"position_error": error, "velocity_error": 3 * error}
        true = dict(values)
        for k, symbol in enumerate(components):
            sign = 1 if signs >> k & 1 else -1
            true[symbol.name] = mpf(start[symbol.name]) + sign * error * (3 if k > 2 else 1)
        bounds = flight.rounding(sp.Symbol("horizon", positive=True))
        for vector, rounded in zip(flight.at(), bounds, strict=True):
            limit = exactly(ROUNDING_SLACK * rounded.error, values)
            magnitude = exactly(rounded.magnitude, values)
            computed = in_doubles(dict(zip("xyz", vector, strict=True)), values)
            for name, component in zip("xyz", vector, strict=True):
                there = exactly(component, true)
                assert abs(there - float(computed[name])) <= limit
                assert abs(exactly(component, values)) <= magnitude


@pytest.mark.sampled(3)
@planes
@flights
@sometimes
@given(start=starts)
def test_a_planes_margin_bounds_the_gap_at_its_computed_arrival(
    plane: Plane, flight: Parabola, start: dict[str, float]
) -> None:
    with digits(40):
        approaching = {"x": abs(start["x"]), "vx": -0.1 - abs(start["vx"]), "z": abs(start["z"])}
        # What falls away from a plane 20 m off reaches it if it is as fast as that is far.
        for name, way, fall in zip("xyz", plane.direction, flight.acceleration, strict=True):
            if way * fall != 0 and (way * fall).is_positive:
                approaching[f"v{name}"] = -20 - abs(start[f"v{name}"])
            elif way != 0 and fall == 0:
                approaching[f"v{name}"] = -way * (1 + abs(start[f"v{name}"]))
        values = with_sizes(start | approaching)
        arrival = in_doubles(plane_arrival(plane, flight), values)
        time = float(arrival["time"])
        assume(0 <= time < 10 and arrival["rate"] < 0)
        values |= {"horizon": time, "t": time}
        place, _ = flight.at()
        there = {s.name: exactly(p, values) for s, p in zip(POSITION, place, strict=True)}
        gap = exactly(plane.distance, values | there)
        assert abs(gap) <= exactly(plane_margin(plane, flight), values)


@pytest.mark.sampled(4)
@planes
@flights
@sometimes
@given(start=starts, time=st.floats(0, 3), late=st.floats(-1, 1))
def test_the_displacement_bounds_what_a_length_is_off_by_at_a_computed_arrival(
    plane: Plane, flight: Parabola, start: dict[str, float], time: float, late: float
) -> None:
    """The bounds of Eq. 2 and the target, computed at a time that is off by up to the delay."""
    with digits(40):
        delay = 1e-9
        true_time = mpf(time) + mpf(late) * delay
        values = with_sizes(start) | {"t": time, "horizon": max(time, true_time), "delay": delay}
        place, _ = flight.at()
        position = dict(zip("xyz", place, strict=True))
        rounded = in_doubles(position, values)
        there = {n: exactly(e, values | {"t": true_time}) for n, e in position.items()}
        lengths = [p.symbol for p in HOOP.parameters if p.unit == "m"]
        limit = exactly(displacement(flight, lengths), values)
        measures = {f"g{k}": g for k, g in enumerate((*plane.bounds, *HOOP.end_planes[0].sides))}
        computed = in_doubles(measures, values | rounded)
        for name, measure in measures.items():
            assert abs(exactly(measure, values | there) - float(computed[name])) <= limit
