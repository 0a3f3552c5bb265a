"""A flight through air in balls: its force, and pieces of it that are proved.

The force per unit mass is that of `derive/motion/air.py`: f(v, s), linear in s = √q(v), the speed
through the air. The rest is the judge's own. Picard's iteration of power series, one evaluation of
f for each order, gives polynomials v_n and s_n with exact coefficients; the engines use
recurrences. Ball arithmetic then bounds what they leave of both equations on [0, T], roundings and
the radii of the parameters included:

    |q(v_n) - s_n²| <= D,   |√q(v_n) - s_n| <= D / min s_n,
    |v_n' - f(v_n, √q(v_n))| <= d = |v_n' - f(v_n, s_n)| + |∂f/∂s| D / min s_n.

Let L bound the derivative of f within a tube about v_n, and E_0 the error of v at the start. By
Gronwall's lemma |v - v_n| <= E = exp(L T) (E_0 + d T) if that is within the tube, and then
|v' - v_n'| <= w = L E + d. So the polynomials of position with the balls of the start, and with the
coefficient of t² widened by w/2, hold position and velocity at every time on [0, T], those of a
motion that begins on a surface or along it included: the error is of first or second order in t.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass

import sympy as sp
from flint import arb, arb_poly, arb_series, ctx

from hoopgen.derive.motion.air import AirFlight
from hoopgen.derive.motion.air_series import drag_rate, free_fall, magnus_rate
from hoopgen.derive.scenes.scene import Scene
from hoopgen.derive.scenes.sinking import sinks
from hoopgen.derive.symbolic.conditionals import Not, release
from hoopgen.derive.symbolic.rounding import extent, speed
from hoopgen.derive.symbolic.symbols import POSITION, SPIN, VELOCITY

from .expressions import Function, compile_expressions
from .roots import Undecided

RATES = (drag_rate, *magnus_rate, *free_fall)
"""The rates that are constant in a flight."""

OVERLAP = arb(2) ** -10
"""Share of a piece for which it is proved beyond its end."""

LONGEST = 1.0
"""The longest piece, s."""

_HALVINGS = 40
"""Number of times that a piece is halved for which no bound is proved."""


@dataclass(frozen=True)
class AirFormulas:
    """The formulas of a flight through air; q is the square of the speed through the air.

    Attributes
    ----------
    rates
        (state, parameters) to the rates.
    square
        (velocity, parameters) to q, as a list of one.
    force
        (velocity, (speed,), rates, parameters) to f.
    by_speed
        As `force`, to ∂f/∂s.
    jacobian
        As `force`, to the nine derivatives of f(v, √q(v)) by v.
    sinks
        (state, rates, parameters) to whether the ball certainly sinks (`derive.scenes.sinking`),
        and whether it certainly does not.
    """

    rates: Function
    square: Function
    force: Function
    by_speed: Function
    jacobian: Function
    sinks: Function


def air_formulas(scene: Scene) -> AirFormulas:
    """Return the formulas of the flight of a scene in air."""
    flight = scene.flight
    assert isinstance(flight, AirFlight)
    through = sp.Symbol("through_air", positive=True)
    law = [release(component) for component in flight.present_acceleration]
    (root,) = {p for f in law for p in f.atoms(sp.Pow) if p.exp == sp.Rational(1, 2)}
    force = [f.xreplace({root: through}) for f in law]
    by_speed = [sp.diff(f, through) for f in force]
    assert all(sp.diff(f, through) == 0 for f in by_speed)
    bend = [sp.diff(root.base, v) / (2 * through) for v in VELOCITY]
    jacobian = [
        sp.diff(f, v) + b * bent
        for f, b in zip(force, by_speed, strict=True)
        for v, bent in zip(VELOCITY, bend, strict=True)
    ]
    sizes = {extent: sum(map(sp.Abs, POSITION)), speed: sum(map(sp.Abs, VELOCITY))}
    constants = flight.rates()
    state, parameters = (*POSITION, *VELOCITY, *SPIN), scene.symbols
    sunk = sinks(scene).xreplace(sizes)

    def of_velocity(expressions: Sequence[sp.Expr]) -> Function:
        return compile_expressions(expressions, VELOCITY, (through,), RATES, parameters)

    return AirFormulas(
        compile_expressions([constants.get(r.name, sp.S.Zero) for r in RATES], state, parameters),
        compile_expressions([root.base], VELOCITY, parameters),
        of_velocity(force),
        of_velocity(by_speed),
        of_velocity(jacobian),
        compile_expressions([sunk, Not(sunk)], state, RATES, parameters),
    )


def proved_piece(
    air: AirFormulas, state: Sequence[arb], values: Sequence[arb]
) -> tuple[list[arb_poly], arb]:
    """Return polynomials that hold the position from a state on, and how long they do.

    Their derivatives hold the velocity. They hold both a share `OVERLAP` longer than that.

    Parameters
    ----------
    air
        The formulas of the flight.
    state
        The state, nine balls.
    values
        The kernels' inputs.

    Raises
    ------
    Undecided
        If no bound is proved: of a ball that is known too little.
    """
    start = [component.mid() for component in state[3:6]]
    rates = [arb(rate) for rate in air.rates(state, values)]
    moving, through = _series(air, start, rates, values)
    span = _length([*moving, through])
    for _ in range(_HALVINGS):
        until = span * (1 + OVERLAP)
        bend = _proved_bend(air, state, values, rates, moving, through, until)
        if bend is not None:
            paths = zip(state[:3], state[3:6], moving, strict=True)
            return [_path(x, v, series, bend) for x, v, series in paths], span
        span = span / 2
    raise Undecided("how the ball flies through the air")


def _series(
    air: AirFormulas, start: Sequence[arb], rates: Sequence[arb], values: Sequence[arb]
) -> tuple[list[arb_poly], arb_poly]:
    """Return Taylor polynomials of velocity and speed with exact coefficients, without a proof."""
    order = ctx.prec // 4 + 8
    exact = [rate.mid() for rate in rates]
    with _terms(order + 2):
        moving = [arb_series([component], prec=1) for component in start]
        for _ in range(order):
            through = air.square(moving, values)[0].sqrt()
            forces = air.force(moving, (through,), exact, values)
            moving = [
                force.integral() + component for force, component in zip(forces, start, strict=True)
            ]
        through = air.square(moving, values)[0].sqrt()
    made = [arb_poly([c.mid() for c in series.coeffs()]) for series in (*moving, through)]
    return made[:3], made[3]


@contextmanager
def _terms(most: int) -> Iterator[None]:
    """Let power series have as many terms."""
    before, ctx.cap = ctx.cap, most
    try:
        yield
    finally:
        ctx.cap = before


def _length(series: Sequence[arb_poly]) -> arb:
    """Return a time, a double, at which the last terms of the series are about a rounding."""
    order = ctx.prec // 4 + 8
    longest = arb(LONGEST)
    for polynomial in series:
        for k in (order - 1, order):
            size = abs(polynomial[k])
            if not size.is_zero():
                longest = longest.min((arb(2) ** -ctx.prec / size).root(k))
    return arb(float(longest.mid()))


def _proved_bend(
    air: AirFormulas,
    state: Sequence[arb],
    values: Sequence[arb],
    rates: Sequence[arb],
    moving: Sequence[arb_poly],
    through: arb_poly,
    until: arb,
) -> arb | None:
    """Return w, a bound on |v' - v_n'| up to a time; None if none is proved."""
    square = _size(air.square(moving, values)[0] - through * through, until)
    slowest = (abs(through[0]) - _size(through - through[0], until)).lower()
    if not slowest > 0:
        return None
    off = square / slowest
    forces = air.force(moving, (through,), rates, values)
    slopes = air.by_speed(moving, (through,), rates, values)
    defect = _norm(
        _size(v.derivative() - force, until) + _size(slope, until) * off
        for v, force, slope in zip(moving, forces, slopes, strict=True)
    )
    begun = _norm(component.rad() for component in state[3:6])
    tube = (2 * begun + arb(2) ** -(ctx.prec // 2)).upper()
    # |√q(v) - √q(v_n)| <= |v - v_n|, since v_s is constant.
    times = (until / 2) + arb(0, until / 2)
    box = [v(times) + arb(0, tube) for v in moving]
    speeds = through(times).union(slowest) + arb(0, (off + tube).upper())
    if not speeds > 0:
        return None
    rate = _norm(air.jacobian(box, (speeds,), rates, values))
    error = (rate * until).exp() * (begun + defect * until)
    if not error < tube:
        return None
    return (rate * error + defect).upper()


def _path(place: arb, moving: arb, series: arb_poly, bend: arb) -> arb_poly:
    """Return the polynomial of one coordinate."""
    rates = series.coeffs() + [arb(0)] * (2 - len(series))
    terms = [rate / (k + 1) for k, rate in enumerate(rates)]
    return arb_poly([place, moving, terms[1] + arb(0, bend / 2), *terms[2:]])


def _size(polynomial: arb_poly, until: arb) -> arb:
    """Return a bound on the size of a polynomial up to a time."""
    return arb_poly([c.abs_upper() for c in polynomial.coeffs()])(until).upper()


def _norm(components: Iterator[arb] | Sequence[arb]) -> arb:
    """Return a bound on the Euclidean norm of a vector or a matrix."""
    sizes = (arb(component).abs_upper() for component in components)
    return sum((size * size for size in sizes), arb(0)).sqrt().upper()
