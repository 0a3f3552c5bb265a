"""The general search: polynomials, planes' arrivals, parabolas, certificates, Bernstein bounds."""

from __future__ import annotations

from itertools import product

import pytest
import sympy as sp
from hoopgen.derive.events import event_polynomials, root_finder_for
from hoopgen.derive.events.event_polynomials import crossing, event_coefficients
from hoopgen.derive.events.plane import plane_arrival
from hoopgen.derive.events.polynomial import PolynomialRootFinder
from hoopgen.derive.events.root_finder import first_root
from hoopgen.derive.scenes import HOOP
from hoopgen.derive.surfaces import Plane, Sphere
from hoopgen.derive.symbolic.conditionals import IfLess, minimum, release
from hoopgen.derive.symbolic.polynomials import (
    add,
    bernstein,
    compose,
    derivative,
    horner,
    multiply,
)
from hoopgen.derive.symbolic.symbols import POSITION, VELOCITY, t
from hypothesis import given, settings
from hypothesis import strategies as st
from mpmath import mpf

from tests.derive.test_evaluation import INFINITY, digits, exactly, in_doubles
from tests.helpers.effort import trials

x, y, z = POSITION
width, start = sp.symbols("width start", real=True)
P = list(sp.symbols("p0:6", real=True))
Q = list(sp.symbols("q0:3", real=True))
BALL = Sphere("ball", tuple(sp.symbols("cx cy cz", real=True)), sp.Symbol("r", positive=True))
quick = settings(deadline=None, derandomize=True, max_examples=trials(60))


def same(one: sp.Expr, other: sp.Expr) -> bool:
    """Return True if two polynomials are identical."""
    return bool(sp.expand(one - other) == 0)


# -- Polynomials as coefficient lists


def test_sums_and_products_of_coefficient_lists_are_those_of_the_polynomials() -> None:
    one, other = horner(P, t), horner(Q, t)
    assert same(horner(add(P, Q), t), one + other)
    assert same(horner(multiply(P, Q), t), one * other)


def test_horner_is_the_polynomial_and_derivative_its_derivative() -> None:
    polynomial = sum(c * t**k for k, c in enumerate(P))
    assert same(horner(P, t), polynomial)
    assert same(horner(derivative(P), t), sp.diff(polynomial, t))
    assert derivative(P[:1]) == [0]


@pytest.mark.parametrize("degree", range(6))
def test_bernstein_coefficients_are_weights_of_a_partition_of_one(degree: int) -> None:
    """On [0, width] the weights are not negative and add up to 1, so the coefficients enclose."""
    s = sp.Symbol("s", nonnegative=True)
    rest = sp.Symbol("rest", nonnegative=True)
    weights = [sp.binomial(degree, i) * s**i * rest ** (degree - i) for i in range(degree + 1)]
    assert all(weight.is_nonnegative for weight in weights)
    assert same(sum(weights).subs(rest, 1 - s), sp.Integer(1))
    enclosing = bernstein(P[: degree + 1], width)
    combined = sum(c * w for c, w in zip(enclosing, weights, strict=True))
    assert same(combined.subs(rest, 1 - s), horner(P[: degree + 1], s * width))


@pytest.mark.slow
@quick
@given(st.lists(st.fractions(-9, 9), min_size=1, max_size=7), st.fractions(0, 9))
def test_bernstein_coefficients_enclose_the_polynomial(coefficients: list, extent: object) -> None:
    values = [sp.Rational(c) for c in coefficients]
    enclosing = bernstein(values, sp.Rational(extent))
    for k in range(9):
        value = horner(values, sp.Rational(extent) * k / 8)
        assert min(enclosing) <= value <= max(enclosing)


def test_composition_is_substitution() -> None:
    a = sp.Symbol("a")
    expression = (a * x**2 - (y + 3 * z) ** 2 * x + a) ** 2 - 7 * y + a**-1
    paths = HOOP.flight.path
    substituted = expression.subs({s: horner(c, t) for s, c in paths.items()}, simultaneous=True)
    assert same(horner(compose(expression, paths), t), substituted)


@pytest.mark.parametrize(
    "expression", [sp.sqrt(x), 1 / x, 2**x, 1 + sp.Abs(x)], ids=["root", "inverse", "power", "size"]
)
def test_composition_refuses_what_is_not_polynomial(expression: sp.Expr) -> None:
    with pytest.raises(ValueError, match="not polynomial"):
        compose(expression, HOOP.flight.path)


# -- A plane's arrival: a closed form

PLANES = [s for s in (*HOOP.surfaces, *HOOP.end_planes) if isinstance(s, Plane)]
planes = pytest.mark.parametrize("plane", PLANES, ids=lambda s: s.name)


def branches(expression: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Return the expression where all its conditions hold, and where none does."""
    kept = release(expression)
    return (
        kept.replace(IfLess, lambda left, right, then, other: then),
        kept.replace(IfLess, lambda left, right, then, other: other),
    )


@planes
@pytest.mark.parametrize("left", [0, 1], ids=["from elsewhere", "from this plane"])
def test_a_planes_arrival_is_the_root_with_a_falling_gap_in_both_forms(
    plane: Plane, left: int
) -> None:
    """At the quadratic's other root F' = +sqrt(D): that one is no arrival."""
    coefficients = [release(c) for c in event_coefficients(plane, HOOP.flight)]
    coefficients[0] *= 1 - left
    gap = horner(coefficients, t)
    arrival = {
        name: branches(sp.sympify(e).subs(event_polynomials.leaving, left))
        for name, e in plane_arrival(plane, HOOP.flight).items()
    }
    speed = sp.Symbol("speed", positive=True)
    # The first form is for a ball that moves towards the plane, the second for one that leaves.
    for form, direction in ((0, -1), (1, 1)):
        time, rate, bend = (arrival[name][form] for name in ("time", "rate", "bend"))
        errors = [
            gap.subs(t, time),
            sp.diff(gap, t).subs(t, time) - rate,
            sp.diff(gap, t, 2) - bend,
        ]
        if len(coefficients) == 3:
            c, b, a = coefficients
            errors.append(rate + sp.sqrt(b**2 - 4 * a * c))
        moving = dict.fromkeys(VELOCITY, direction * speed)
        assert [sp.simplify(error.subs(moving)) for error in errors] == [0] * len(errors)


@planes
def test_the_apex_is_where_the_gap_is_highest(plane: Plane) -> None:
    """From the start on: that is now along a straight line, and for a ball that falls."""
    arrival = {n: release(sp.sympify(e)) for n, e in plane_arrival(plane, HOOP.flight).items()}
    apex, height = arrival["apex"], arrival["height"].subs(event_polynomials.leaving, 0)
    gap = horner([release(c) for c in event_coefficients(plane, HOOP.flight)], t)
    speed = sp.Symbol("speed", positive=True)

    def moving(expression: sp.Expr, sign: int) -> sp.Expr:
        along = sp.sympify(expression).subs(dict.fromkeys(VELOCITY, sign * speed))
        return along.replace(
            IfLess,
            lambda left, right, then, other: then if (right - left).is_positive else other,
        )

    if arrival["bend"] != 0:
        assert sp.simplify(moving(sp.diff(gap, t), 1).subs(t, moving(apex, 1))) == 0
    for sign in (1, -1):
        there = moving(gap, sign).subs(t, moving(apex, sign))
        assert sp.simplify(there - moving(height, sign)) == 0
    assert moving(apex, -1) == 0


# -- The parabola below F

gap_, slope_, bent = sp.symbols("gap slope bent", real=True)
FIRST_ROOT = first_root(gap_, slope_, bent)


def parabola(gap: mpf, slope: mpf, curvature: mpf, s: mpf) -> mpf:
    """Return the parabola that is below F."""
    return gap + slope * s - curvature * s**2 / 2


def test_both_forms_of_thefirst_root_are_roots() -> None:
    s = release(FIRST_ROOT).replace(IfLess, lambda left, right, then, other: then).args[2]
    assert sp.simplify(gap_ + slope_ * s - bent * s**2 / 2) == 0
    root = sp.sqrt(slope_**2 + 2 * bent * gap_)
    s = (slope_ + root) / bent
    assert sp.simplify(gap_ + slope_ * s - bent * s**2 / 2) == 0


@pytest.mark.parametrize(
    ("gap", "slope", "curvature"),
    list(product((mpf(1) / 2**30, mpf(2), mpf(10) ** 6), (-3, -1, 0, 2), (-9, -1, 0, 1, 7))),
)
def test_the_parabola_falls_below_zero_first_at_itsfirst_root(
    gap: mpf, slope: int, curvature: int
) -> None:
    with digits(40):
        step = exactly(FIRST_ROOT, {"gap": gap, "slope": slope, "bent": curvature})
        ends = step < INFINITY
        last = step if ends else mpf(10) ** 9
        before = [last * mpf(k) / 64 for k in range(64)] + [last * mpf(2) ** -k for k in range(64)]
        assert all(parabola(gap, slope, curvature, s) > 0 for s in before if s < last)
        discriminant = slope**2 + 2 * curvature * gap
        has_root = discriminant >= 0 and (curvature > 0 or slope < 0)
        assert ends == has_root
        if ends:
            assert step > 0
            nearly = mpf(10) ** -36 * (gap + abs(slope) * step + abs(curvature) * step**2)
            assert abs(parabola(gap, slope, curvature, step)) <= nearly
            assert discriminant == 0 or parabola(gap, slope, curvature, step * 1.0001) < 0


@pytest.mark.parametrize(
    ("slope", "curvature", "step"),
    [(-2, 3, 0), (-2, 0, 0), (-2, -3, 0), (2, 4, 1), (2, 0, INFINITY), (2, -4, INFINITY)],
)
def test_from_zero_thefirst_root_is_where_the_parabola_falls_below_it(
    slope: int, curvature: int, step: float
) -> None:
    assert exactly(FIRST_ROOT, {"gap": 0, "slope": slope, "bent": curvature}) == step


@pytest.mark.parametrize("curvature", [-1, 0])
def test_a_parabola_that_never_falls_below_zero_limits_no_step(curvature: int) -> None:
    """0/0 passes through `minimum`, whose first operand is the window's end."""
    step = exactly(FIRST_ROOT, {"gap": 0, "slope": 0, "bent": curvature})
    assert step != step
    assert exactly(minimum(sp.Integer(5), sp.Symbol("s")), {"s": step}) == 5


SIZES = st.just(0.0) | st.floats(1e-9, 1e3)
SIGNED = st.builds(lambda size, sign: size * sign, SIZES, st.sampled_from((-1, 1)))


@pytest.mark.slow
@quick
@given(SIZES, SIGNED, SIGNED)
def test_neither_form_of_thefirst_root_cancels(gap: float, slope: float, curvature: float) -> None:
    """The root in doubles is exact to a few u where its discriminant is: four an operation."""
    values = {"gap": gap, "slope": slope, "bent": curvature}
    computed = float(in_doubles({"step": FIRST_ROOT}, values)["step"])
    with digits(60):
        exact = exactly(FIRST_ROOT, values)
        square, product_ = mpf(slope) ** 2, 2 * mpf(curvature) * gap
        if abs(square + product_) < (square + abs(product_)) / 16:
            return
        if exact < INFINITY:
            # The discriminant is off by 3 u (square + |product|) <= 48 u of itself.
            assert abs(computed - exact) <= 64 * mpf(2) ** -53 * exact
        else:
            assert not computed < float("inf")


# -- What makes a crossing certain


def test_a_crossing_with_a_clearance_is_certain_and_within_its_delay() -> None:
    """F(t + s) <= m - r s + C s²/2 at a computed root: negative at some s up to the delay."""
    r, clearance = sp.symbols("r clearance", positive=True)
    m = sp.Symbol("m", positive=True)
    falling = {
        event_polynomials.rate: -r - event_polynomials.rate_margin,
        event_polynomials.margin: m,
    }
    outputs = {name: branches(e)[0].subs(falling) for name, e in crossing().items()}
    assert (
        sp.simplify(
            branches(-event_polynomials.rate - event_polynomials.rate_margin)[0].subs(falling)
        )
        == r
    )
    (ceiling,) = sp.solve(outputs["clearance"] - clearance, event_polynomials.ceiling)
    s = outputs["delay"]
    bound = m - r * s + ceiling * s**2 / 2
    assert sp.expand(bound).is_negative


@pytest.mark.parametrize("slope", [-1, 0])
def test_without_a_falling_gap_there_is_no_clearance(slope: int) -> None:
    values = {"rate": -slope, "rate_margin": 0, "ceiling": 0, "margin": 0}
    assert not exactly(crossing()["clearance"], values) > 0


# -- The search that any curved surface has

SEARCHES = {
    "octic": PolynomialRootFinder(HOOP.flight, HOOP.surfaces[0]),
    "sphere": root_finder_for(BALL, HOOP.flight),
}
searches = pytest.mark.parametrize("search", SEARCHES.values(), ids=list(SEARCHES))


@pytest.mark.slow
@searches
def test_the_general_search_has_gap_rate_and_bend_of_its_condition(
    search: PolynomialRootFinder,
) -> None:
    polynomial = horner(search._coefficients, t)
    gap, rate = release(search.gap), release(search.rate)
    assert same(gap, release(polynomial))
    assert same(rate, sp.diff(release(polynomial), t))
    assert same(release(search.bend), sp.diff(release(polynomial), t, 2))
    assert same(release(search.leaving_gap), gap - gap.subs(t, 0))
