"""The motion of a ball that rolls on a surface, as a power series in time.

While the ball grips, its contact point is at rest: v = R_B (w × n), and with kappa = I/(m R_B²) and
the free fall a, all per unit mass,

    v' = a + N n + F,   w' = -n × F / (kappa R_B),   N = -a·n - v·n',

where the normal force N keeps the gap at zero, and friction F keeps the contact point at rest. With
s = R_B (w·n) and beta = kappa/(1 + kappa) that leaves

    F = beta (-a_t + s n × n'),   v' = (1 - beta) a + L n + beta s n × n',
    L = -(1 - beta) a·n - v·n',   s' = -v·(n × n'),

quadratic or cubic in the unknowns, so that each coefficient of the series follows from those before
it by sums of products. The surface is a tube about a point or a line (see
`surfaces/rolling_surface.py`), or a plane: n' = v/R across its line. Rings have coordinates of
their own (`ring_rolling_series.py`). Each step expands the series anew, and puts position, velocity
and spin back onto the surface: the differential equation alone would leave it exponentially.

On a surface of revolution with the unit vector u along its axis, the ball's centre is at the
distance rho from the axis, in the direction of the unit vector e. With the rate Omega of the
azimuth, and the curvature 1/R of the section, a line of a cone or a circle of a torus,

    n' = v/R + c Omega (u × e),   e' = Omega (u × e),   rho Omega = v·(u × e),   rho' = v·e.

On a cone 1/R = 0, and c is the cosine of the half-angle, negative inside. On a torus the centre is
at R_H e + R n, so that c = -R_H/R. All that is quadratic in the unknowns, too, but for the quotient
by rho: its term of each order is what the product rho Omega lacks.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from ..contact.ball import Ball
from ..symbolic.conditionals import absolute, barrier, maximum, minimum
from ..symbolic.polynomials import horner
from ..symbolic.symbols import normal, position, spin, t, velocity
from .flight import NO_FORCE, SurfaceForce

ORDER = 8
"""Order of the series: a power of two, so that the step is a root of roots. A lower order makes
kernels shorter, a higher one steps longer."""

LAST_TERM_TOLERANCE = sp.Rational(1, 2**46)
"""Largest last term of a step, relative to the speed; the truncation error is then about 2^-49."""

bent = sp.symbols("bent_x bent_y bent_z", real=True)
"""1 along the axes across which the surface is curved, else 0."""
across = tuple(tuple(sp.Symbol(f"across_{i}{j}", real=True) for j in "xyz") for i in "xyz")
"""P, the projection onto the directions across which the surface is curved, in rows: in scenes with
a tube that lies along no axis."""
per_reach = sp.Symbol("per_reach", real=True)
"""1/R of the tube, negative on its inside, 0 of a plane; of a cone and a torus a bound."""
axis = sp.symbols("axis_x axis_y axis_z", real=True)
"""u, along the axis of a cone or a torus, 0 of any other surface: in scenes with one to roll on."""
outward = sp.symbols("outward_x outward_y outward_z", real=True)
"""e, away from that axis, 0 of any other surface."""
per_tube, azimuth_factor, per_width = sp.symbols("per_tube azimuth_factor per_width", real=True)
"""1/R of the section, c and 1/rho of a cone or a torus, 0 of any other surface."""
REVOLVED = (*axis, *outward, per_width, per_tube, azimuth_factor)
"""All of them, in the order of `surfaces.rolling_surface.RevolvedSurface`."""
gap = sp.Symbol("gap", real=True)
"""Distance of the ball from the surface, m."""

SERIES = ("vx", "vy", "vz", "nx", "ny", "nz", "turn_rate")
"""The unknowns: velocity, normal, s."""
WITHIN = ("lift", "tx", "ty", "tz")
"""The auxiliary series: L, and n × n'."""
OUTWARD = ("ex", "ey", "ez")
"""The unknowns on a cone or a torus besides: e."""
AROUND = ("cx", "cy", "cz")
"""The auxiliary series there: u × e. Those of Omega and rho are `azimuth_rate` and `width`."""


def term(name: str, order: int) -> sp.Symbol:
    """Return the symbol of a coefficient of a series.

    Parameters
    ----------
    name
        The name of the quantity.
    order
        The power of the time, from 0.
    """
    return sp.Symbol(f"{name}_{order}", real=True)


def _row(name: str, order: int) -> list[sp.Symbol]:
    return [term(name, k) for k in range(order + 1)]


def _rows(names: Sequence[str], order: int) -> list[list[sp.Symbol]]:
    return [_row(name, order) for name in names]


def product(left: Sequence[sp.Expr], right: Sequence[sp.Expr]) -> sp.Expr:
    """Return the coefficient of the highest common order in the product of two series.

    Parameters
    ----------
    left, right
        The coefficients of both series, the constant first; as many of each.
    """
    pairs = zip(left, reversed(right), strict=True)
    return barrier(sp.Add(*(a * b for a, b in pairs)))


def start(ball: Ball, revolved: bool = False) -> dict[str, sp.Expr]:
    """Return the constant terms, for a ball at its place on the surface.

    Parameters
    ----------
    ball
        The ball.
    revolved
        True if a surface of the scene is a cone or a torus.
    """
    moving = dict(zip(("vx", "vy", "vz", "nx", "ny", "nz"), (*velocity, *normal), strict=True))
    outputs = moving | {"turn_rate": ball.radius * barrier(spin.dot(normal))}
    if revolved:
        outputs |= dict(zip(OUTWARD, outward, strict=True))
    return {f"{name}_0": value for name, value in outputs.items()}


def next_terms(
    order: int,
    acceleration: Sequence[sp.Expr],
    ball: Ball,
    oblique: bool = False,
    revolved: bool = False,
) -> dict[str, sp.Expr]:
    """Return the coefficients of the next order, given those up to this one.

    Parameters
    ----------
    order
        The order of the coefficients that are known.
    acceleration
        That of the free ball, (3,), m/s².
    ball
        The radius and the inertia of the ball.
    oblique
        True if a surface of the scene is a tube that lies along no axis.
    revolved
        True if a surface of the scene is a cone or a torus.

    Returns
    -------
    dict
        The coefficients of `order` + 1, by the names of their symbols.
    """
    v, n = _rows(SERIES[:3], order), _rows(SERIES[3:6], order)
    s = _row(SERIES[6], order)
    now = [own[order] for own in v]
    if oblique:
        parts = [sp.Add(*(p * own for p, own in zip(row, now, strict=True))) for row in across]
        turned = [barrier(barrier(part) * per_reach) for part in parts]
    else:
        turned = [barrier(b * own * per_reach) for b, own in zip(bent, now, strict=True)]
    outputs: dict[str, sp.Expr] = {}
    if revolved:
        outputs, swept = _around_axis(order)
        turned = [barrier(own + round_) for own, round_ in zip(turned, swept, strict=True)]
    turning = [
        [*(k * n_i[k] for k in range(1, order + 1)), new]
        for n_i, new in zip(n, turned, strict=True)
    ]
    pressed = barrier(sum(product(a, b) for a, b in zip(v, turning, strict=True)))
    weighed = sum(a * n_i[order] for a, n_i in zip(acceleration, n, strict=True) if a != 0)
    own = barrier(-ball.moving_share * weighed - pressed)
    lifts = [*_row("lift", order)[:-1], own]
    twists = []
    for i in range(3):
        j, k = (i + 1) % 3, (i + 2) % 3
        twists.append(barrier(product(n[j], turning[k]) - product(n[k], turning[j])))
    twisted = [
        [*_row(name, order)[:-1], new] for name, new in zip(("tx", "ty", "tz"), twists, strict=True)
    ]
    scale = sp.Rational(1, order + 1)
    outputs |= {f"lift_{order}": own}
    outputs |= {f"{w}_{order}": new for w, new in zip(WITHIN[1:], twists, strict=True)}
    for name, a, n_i, m_i in zip(SERIES[:3], acceleration, n, twisted, strict=True):
        pushed = product(lifts, n_i) + ball.friction_share * product(s, m_i)
        fallen = ball.moving_share * a if order == 0 else 0
        outputs[f"{name}_{order + 1}"] = barrier(pushed + fallen) * scale
    for name, new in zip(SERIES[3:6], turned, strict=True):
        outputs[f"{name}_{order + 1}"] = new * scale
    spun = sum(product(a, b) for a, b in zip(v, twisted, strict=True))
    outputs[f"turn_rate_{order + 1}"] = -barrier(spun) * scale
    return outputs


def _around_axis(order: int) -> tuple[dict[str, sp.Expr], list[sp.Expr]]:
    """Return the coefficients of the series about an axis, and those of v/R + c Omega (u × e)."""
    v, out = _rows(SERIES[:3], order), _rows(OUTWARD, order)
    crossed = []
    for i in range(3):
        j, k = (i + 1) % 3, (i + 2) % 3
        crossed.append(barrier(axis[j] * out[k][order] - axis[k] * out[j][order]))
    rows = [[*_row(name, order)[:-1], new] for name, new in zip(AROUND, crossed, strict=True)]
    along = barrier(sum(product(a, b) for a, b in zip(v, rows, strict=True)))
    rates, widths = _row("azimuth_rate", order)[:-1], _row("width", order)[1:]
    known = product(widths, rates) if order else sp.Integer(0)
    rate = barrier(barrier(along - known) * per_width)
    rising = barrier(sum(product(a, b) for a, b in zip(v, out, strict=True)))
    turned = [product([*rates, rate], row) for row in rows]
    scale = sp.Rational(1, order + 1)
    outputs = {f"{name}_{order}": new for name, new in zip(AROUND, crossed, strict=True)}
    outputs |= {f"azimuth_rate_{order}": rate, f"width_{order + 1}": rising * scale}
    outputs |= {
        f"{name}_{order + 1}": new * scale for name, new in zip(OUTWARD, turned, strict=True)
    }
    moved = [barrier(per_tube * own[order]) for own in v]
    return outputs, [barrier(a + azimuth_factor * b) for a, b in zip(moved, turned, strict=True)]


def moved() -> dict[str, sp.Expr]:
    """Return position, velocity and s at time t after the start of the step, on the series."""
    outputs: dict[str, sp.Expr] = {}
    for place, name in zip(position, SERIES[:3], strict=True):
        row = _row(name, ORDER)
        outputs[str(place)] = horner([place, *(c / (k + 1) for k, c in enumerate(row))], t)
        outputs[name] = horner(row, t)
    outputs["turn_rate"] = horner(_row("turn_rate", ORDER), t)
    return outputs


def placed(ball: Ball) -> dict[str, sp.Expr]:
    """Return the state on the surface: no gap, no normal speed, and the spin of rolling."""
    turn_rate = sp.Symbol("turn_rate", real=True)
    tangential = [barrier(v) for v in velocity - barrier(velocity.dot(normal)) * normal]
    turning = normal.cross(sp.Matrix(tangential)) + turn_rate * normal
    per = barrier(1 / ball.radius)
    outputs = {str(p): p - gap * n for p, n in zip(position, normal, strict=True)}
    outputs |= {str(v): own for v, own in zip(velocity, tangential, strict=True)}
    return outputs | {str(w): barrier(own) * per for w, own in zip(spin, turning, strict=True)}


def force(
    acceleration: Sequence[sp.Expr], ball: Ball, besides: SurfaceForce = NO_FORCE
) -> list[sp.Expr]:
    """Return the force per unit mass that presses the ball on, as a series.

    Parameters
    ----------
    acceleration
        That of free fall.
    ball
        The ball.
    besides
        What presses it on besides its weight.
    """
    found = []
    for k in range(ORDER):
        row = [term(name, k) for name in SERIES[3:6]]
        fall = sum(a * n for a, n in zip(acceleration, row, strict=True) if a != 0)
        speeds = [_row(name, k) for name in SERIES[:3]]
        squared = barrier(sp.Add(*(product(v, v) for v in speeds)))
        pressed = besides.at(barrier(fall), squared)
        found.append(barrier(term("lift", k) - ball.friction_share * fall + pressed))
    return found


def step(
    acceleration: Sequence[sp.Expr],
    gravity: sp.Expr,
    ball: Ball,
    besides: SurfaceForce = NO_FORCE,
    revolved: bool = False,
) -> dict[str, sp.Expr]:
    """Return a step in which the series is as good as rounded, and bounds on the motion in it.

    The first term that is left out is about the last one times the step over the time in which the
    motion changes: at most an eighth. If the last term happens to be small, the one before it
    counts.

    Parameters
    ----------
    acceleration, ball
        As for `next_terms`.
    gravity
        The size of the acceleration, m/s².
    besides
        The force that presses the ball onto its surface besides its weight.
    revolved
        True if a surface of the scene is a cone or a torus. A step there is at most an eighth of
        the time in which the motion changes: the distance from the axis changes by less than a
        quarter.

    Returns
    -------
    dict
        The length of the step, s, and the bounds, by the names of their symbols.
    """
    rows = [[*(term(name, k) for name in (*SERIES[:3], "turn_rate"))] for k in range(ORDER + 1)]
    sizes = [barrier(sp.Add(*map(absolute, row))) for row in rows]
    ways = [
        barrier(sp.Add(*(absolute(term(name, k)) for name in SERIES[3:6])))
        for k in range(ORDER + 1)
    ]
    speed = sizes[0]
    rate = barrier(speed * absolute(per_reach) + sp.sqrt(barrier(gravity * absolute(per_reach))))
    scale = barrier(speed + gravity * sp.Rational(1, 2**6))
    last = barrier(
        maximum(barrier(sizes[ORDER] + rate * sizes[ORDER - 1]), barrier(scale * ways[ORDER]))
    )
    most = sp.Integer(1)
    ratio = barrier(LAST_TERM_TOLERANCE * scale / last)
    root = ratio
    for _ in range(ORDER.bit_length() - 1):
        root = barrier(sp.sqrt(root))
    step = barrier(minimum(most, root))
    if revolved:
        swift = barrier(speed * per_width + sp.sqrt(barrier(gravity * per_width)))
        step = barrier(minimum(step, barrier(sp.Rational(1, 8) / swift)))
    powers = [step**k for k in range(ORDER)]
    strongest = barrier(sum((k + 1) * sizes[k + 1] * powers[k] for k in range(ORDER)))
    forces = force(acceleration, ball, besides)
    braced = [(a, n) for a, n in zip(acceleration, SERIES[3:6], strict=True) if a != 0]
    bend = barrier(sum(k * (k - 1) * absolute(forces[k]) * powers[k - 2] for k in range(2, ORDER)))
    return {
        "stride": step,
        "missed": barrier(LAST_TERM_TOLERANCE / 8 * scale),
        "strongest": strongest,
        "fastest": barrier(speed + step * strongest),
        "force": forces[0],
        "force_rate": forces[1],
        "force_bend": bend,
        "friction_force_rate": barrier(
            -2 * ball.friction_share * barrier(sum(a * term(n, 1) for a, n in braced))
        ),
    }
