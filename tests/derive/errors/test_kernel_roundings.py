"""The roundings of the kernels that move a ball: proved bounds, and those that are carried.

Three kernels of the article's hoop make a new state: the flight (Eq. 3), the ring's normal (Table
2) and the impact (Eq. 17). For each there is a bound on its rounding error, for exact inputs, with
its proof, to first order in u times `ROUNDING_SLACK`. Random inputs are held against it with 200
bits. Bounds on errors are carried with simpler terms, which contain these.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np
import pytest
import sympy as sp
from hoopgen.derive.errors import contact_frames
from hoopgen.derive.scenes import HOOP
from hoopgen.derive.symbolic.conditionals import Barrier
from hoopgen.derive.symbolic.error_terms import left_normal
from hoopgen.derive.symbolic.rounding import ROUNDING_SLACK, Rounded, rounding
from hoopgen.derive.symbolic.symbols import POSITION, UNIT_ROUNDOFF, normal, spin, velocity
from hoopgen.generated.numpy import hoop
from numpy.typing import NDArray

from hoopgen import PAPER
from tests.helpers.effort import trials

flint = pytest.importorskip("flint")

Floats = NDArray[np.float64]
U = float(UNIT_ROUNDOFF)
SLACK = float(ROUNDING_SLACK)
ROWS = 100_000
SIZES = {f"p_{name}": float(value) for name, value in PAPER.items()}
RADIUS, WIRE, CIRCLE = (SIZES[f"p_{n}"] for n in ("ball_radius", "wire_radius", "ring_radius"))
GRAVITY, RESTITUTION = SIZES["p_gravity"], SIZES["p_restitution"]
NORMALS = tuple(normal)
EXACT = np.vectorize(lambda number: flint.arb(float(number)), otypes=[object])


def called(name: str, **arguments: Any) -> Floats:
    """Return what a kernel of the hoop computes in doubles, a column a row."""
    names = hoop.ARGUMENTS[name]
    given = SIZES | arguments
    found = getattr(hoop, name)(*(given[n] for n in names))
    return np.array(np.broadcast_arrays(*found), float)


def off_by(computed: Floats, true: Callable[[], list[Any]]) -> Floats:
    """Return the errors of doubles, from the exact formula evaluated with 200 bits."""
    with flint.ctx.workprec(200):
        exact = np.array(true(), object)
        return np.abs(np.array(exact - EXACT(computed), float))


def evaluated(expression: sp.Expr, values: dict[str, Any]) -> Any:
    """Return the value of a formula in doubles."""
    plain = expression.replace(lambda e: isinstance(e, Barrier), lambda e: e.args[0])
    symbols = sorted(plain.free_symbols, key=lambda s: s.name)
    return sp.lambdify(symbols, plain, "numpy")(*(values[s.name] for s in symbols))


# ------------------------------------------------------------------------------------- the flight


def flights() -> dict[str, Floats]:
    """Return starts and times of flights.

    A third of them end near zero, and another third have hardly any mean speed upwards: there a
    sum cancels, and each term of the bound matters.
    """
    random, rows = np.random.default_rng(1), trials(ROWS)
    time = 2.0 ** random.uniform(-12, 1, rows)
    place, speed = random.uniform(-4, 4, (3, rows)), random.uniform(-9, 9, (3, rows))
    third = rows // 3
    half_fall = 0.5 * GRAVITY * time
    speed[2, :third] = half_fall[:third] * (1 + random.normal(0, 1e-3, third))
    place[:, :third] *= 2.0**-12
    mean = speed - np.array([[0], [0], [1]]) * half_fall
    place[:, third : 2 * third] = -(time * mean)[:, third : 2 * third]
    names = ("x", "y", "z", "vx", "vy", "vz")
    return {"t": time} | dict(zip(names, (*place, *speed), strict=True))


@cache
def flown() -> tuple[dict[str, Floats], Floats, Floats]:
    """Return flights, their computed ends and the errors of these."""
    start = flights()
    ends = called("flight", **start)

    def true() -> list[Any]:
        own = {name: EXACT(value) for name, value in start.items()}
        g, time = flint.arb(GRAVITY), own["t"]
        pulls = (0 * g, 0 * g, -g)
        places = [
            own[p] + own["v" + p] * time + time * time * a / 2
            for p, a in zip("xyz", pulls, strict=True)
        ]
        return [*places, *(own["v" + p] + a * time for p, a in zip("xyz", pulls, strict=True))]

    return start, ends, off_by(ends, true)


def flight_terms(start: dict[str, Floats], ends: Floats, gravity: Any = GRAVITY) -> list[Floats]:
    """Return the terms of the bound on the rounding of a position, given the end of the flight.

    Eq. 3 is evaluated as x + t (v + t a/2). Its two sums and two products are each off by at most
    u times their value (a/2 is exact): u (|x'| + 2 t |m| + t² |a|/2), m = v + t a/2 the mean
    velocity. At the end the velocity is v', and |m| = |v' - t a/2| <= |v'| + t |a|/2.
    """
    pull = np.array([0.0, 0.0, 1.0])[:, None] * gravity
    return [
        U * np.abs(ends[:3]),
        U * 2 * start["t"] * np.abs(ends[3:]),
        U * pull * start["t"] ** 2,
        U * pull * start["t"] ** 2 / 2,
    ]


def test_a_flight_s_roundings_are_within_their_proved_bound() -> None:
    start, ends, errors = flown()
    assert np.all(errors[:3] <= SLACK * sum(flight_terms(start, ends)))
    # A velocity has one product and one sum.
    falls = np.array([[0.0], [0.0], [GRAVITY]]) * start["t"]
    assert np.all(errors[3:] <= SLACK * U * (np.abs(ends[3:]) + falls))


@pytest.mark.parametrize("left_out", [(0,), (1,), (2, 3)])
def test_no_term_of_a_flight_s_bound_may_be_left_out(left_out: tuple[int, ...]) -> None:
    start, ends, errors = flown()
    rest = sum(term for k, term in enumerate(flight_terms(start, ends)) if k not in left_out)
    assert np.any(errors[:3] > SLACK * rest)


def test_what_is_carried_for_a_flight_contains_its_roundings() -> None:
    """The bound with the mean velocity is at most the one with the velocity at the end."""
    start, ends, errors = flown()
    given = {"t": start["t"], "gravity": GRAVITY}
    given |= dict(zip(map(str, (*POSITION, *velocity)), ends, strict=True))
    places, speeds = contact_frames.flight_roundings(HOOP.flight)
    carried = np.array([evaluated(e, given) for e in places])
    assert np.all(errors[:3] <= SLACK * carried)
    assert np.any(errors[:3] > carried / 2)
    assert np.all(carried <= SLACK * sum(flight_terms(start, ends)) + 2.0**-99)
    assert np.all(errors[3:].max(axis=0) <= SLACK * evaluated(speeds, given))


# ------------------------------------------------------------------------------ the ring's normal


@cache
def normals() -> tuple[Floats, Floats, Floats]:
    """Return places on the ring, many above the wire, computed normals and their errors."""
    random, rows = np.random.default_rng(2), trials(ROWS)
    around, over = random.uniform(-np.pi, np.pi, (2, rows))
    over[: rows // 3] = np.pi / 2 + random.normal(0, 1e-3, rows // 3)
    rho = CIRCLE + (RADIUS + WIRE) * np.cos(over)
    height = (RADIUS + WIRE) * np.sin(over)
    places = np.array([rho * np.cos(around), rho * np.sin(around), height])
    found = called("ring_normal", **dict(zip("xyz", places, strict=True)))

    return places, found, off_by(found, lambda: exact_normal(places))


def exact_normal(places: Floats) -> list[Any]:
    """Return the exact normals of the ring (Table 2), in balls."""
    x, y, z = EXACT(places)
    reach = flint.arb(RADIUS) + flint.arb(WIRE)
    far = np.array([(a * a + b * b).sqrt() for a, b in zip(x, y, strict=True)], object)
    out = (far - flint.arb(CIRCLE)) / far / reach
    return [x * out, y * out, z / reach]


def normal_terms() -> list[Floats]:
    """Return the terms of the bound on the rounding of the ring's normal.

    The distance ρ from the axis is a root of a sum of squares, off by 2 u ρ. It enters
    n_x = x f, f = (ρ - R_H)/(R ρ) = 1/R - R_H/(R ρ), through R_H/(R ρ) alone: what it changes in
    ρ - R_H and in 1/ρ is one error, 2 u |x| R_H/(R ρ). Beside it f has six roundings relative to
    its value: two of 1/R, with R a sum, and one each of ρ - R_H, of 1/ρ and of two products. The
    product with x is the seventh. Of z/R there are three.
    """
    places, found, _ = normals()
    far = np.hypot(places[0], places[1])
    across = 2 * U * CIRCLE / ((RADIUS + WIRE) * far) * np.abs(places)
    return [
        across * np.array([[1.0], [1.0], [0.0]]),
        U * np.array([[7.0], [7.0], [3.0]]) * np.abs(found),
    ]


def test_the_roundings_of_the_ring_s_normal_are_within_their_proved_bound() -> None:
    _, _, errors = normals()
    bounds = sum(normal_terms())
    assert np.all(errors <= SLACK * bounds)
    assert np.any(errors > bounds / 2)


@pytest.mark.parametrize("left_out", [0, 1])
def test_no_term_of_the_normal_s_bound_may_be_left_out(left_out: int) -> None:
    _, _, errors = normals()
    assert np.any(errors > SLACK * normal_terms()[1 - left_out])


def turned_aside(factors: tuple[Any, Any] = (1, 1)) -> Floats:
    """Return the part of the error of n across (x, y), times ρ, of normals times given factors."""
    places, found, _ = normals()

    def aside(x: Any, y: Any, nx: Any, ny: Any) -> Any:
        return x * (ny * factors[1]) - y * (nx * factors[0])

    with flint.ctx.workprec(200):
        return np.abs(np.array(aside(*EXACT(places[:2]), *EXACT(found[:2])), float))


def test_the_normal_s_error_lies_along_the_radius_but_for_the_last_products() -> None:
    """n_x and n_y are x and y times the same computed f; only these products are off by u each."""
    (x, y, _), (nx, ny, _), _ = normals()
    bound = SLACK * U * (np.abs(x * ny) + np.abs(y * nx))
    assert np.all(turned_aside() <= bound)
    assert np.any(turned_aside() > bound / 2)
    assert np.any(turned_aside((1 + 2 * U, 1)) > bound)  # a last place is noticed


# ------------------------------------------------------------------------------------- the impact


@cache
def impacts() -> tuple[dict[str, Any], Floats, Floats]:
    """Return motions before contacts with the ring, computed motions after, and their errors.

    The normal is exact here; half of the motions roll, so that the tangential velocity is small.
    """
    random = np.random.default_rng(3)
    _, found, _ = normals()
    rows = found.shape[1]
    moving, turning = random.normal(0, 3, (3, rows)), random.normal(0, 25, (3, rows))
    half = rows // 2
    moving[:, :half] = found[:, :half] * random.uniform(-3, 0, half)
    turning[:, :half] *= 2.0**-20
    names = ("vx", "vy", "vz", "wx", "wy", "wz", "nx", "ny", "nz")
    given = dict(zip(names, (*moving, *turning, *found), strict=True))
    after = called("impact", **given)
    return given, after, off_by(after, lambda: after_impact(given, EXACT(found)))


def after_impact(given: dict[str, Any], n: NDArray[Any]) -> list[Any]:
    """Return the exact motion after contacts of a thin shell with a normal (Eq. 17), in balls."""
    v, w = (np.array([EXACT(given[a + p]) for p in "xyz"]) for a in "vw")
    radius, e = flint.arb(RADIUS), flint.arb(RESTITUTION)
    onto, own = (v * n).sum(axis=0), (w * n).sum(axis=0)
    slid = [3 * (v[k] - onto * n[k]) + 2 * radius * part for k, part in enumerate(cross(w, n))]
    rolling = [part / flint.arb(5) for part in slid]
    turned = [part / radius for part in cross(n, rolling)]
    return [
        *(rolling[k] - e * onto * n[k] for k in range(3)),
        *(turned[k] + own * n[k] for k in range(3)),
    ]


def cross(a: Any, b: Any) -> list[Any]:
    """Return the product a × b."""
    return [a[k - 2] * b[k - 1] - a[k - 1] * b[k - 2] for k in range(3)]


def impact_bounds(normal_error: list[Any] | None = None) -> Floats:
    """Return the running error bounds of the impact (Higham, sections 3.1 and 4.2).

    Parameters
    ----------
    normal_error
        Bounds on the error of the normal's components; none by default.
    """
    law, ball = HOOP.bodies[0].law, HOOP.ball
    offs = sp.symbols("off_x off_y off_z", nonnegative=True)
    known = {
        n: Rounded(sp.Abs(n), off if normal_error is not None else sp.Integer(0))
        for n, off in zip(NORMALS, offs, strict=True)
    }
    given, _, _ = impacts()
    values = given | {"ball_radius": RADIUS, "restitution": RESTITUTION}
    if normal_error is not None:
        values |= dict(zip(map(str, offs), normal_error, strict=True))
    after = law.after(normal, velocity, spin, ball)
    return np.array(
        [
            evaluated(rounding(component, known).error, values)
            for part in after
            for component in part
        ]
    )


def carried_for_impacts() -> Floats:
    """Return the bounds on velocity and spin after impacts on the ring without errors before."""
    given, _, _ = impacts()
    places, _, _ = normals()
    own = given | dict(zip("xyz", places, strict=True))
    (own["normal_velocity"],) = called("normal_velocity", **own)
    none = {s.name: 0.0 for s in (*contact_frames.ARGUMENTS, *left_normal)} | {"clock": 0.0}
    none |= {"t": 0.0} | own
    tangents = called("ring_tangents", **none)
    names = ("tangent_x", "tangent_y", "bend_s", "bend_e", "sharpest_bend")
    none |= dict(
        zip((*names, "root_offset", "root_level", "normal_rounding"), tangents, strict=True)
    )
    bounds = dict(zip(hoop.OUTPUTS["carry_impact"], called("carry_impact", **none), strict=True))
    return np.array([bounds["velocity_bound"]] * 3 + [bounds["spin_bound"]] * 3)


@pytest.mark.slow
def test_an_impact_s_roundings_are_within_their_proved_bound() -> None:
    _, _, errors = impacts()
    bounds = impact_bounds()
    assert np.all(errors <= SLACK * bounds)
    assert np.any(errors > bounds / 8)


@pytest.mark.slow
def test_normal_and_impact_together_are_within_their_proved_bound() -> None:
    """The normal's error is carried through the impact, and the impact's roundings are added."""
    errors, bounds = together()
    assert np.all(errors <= SLACK * bounds)
    assert np.any(errors > SLACK * impact_bounds())  # the normal's error must not be left out


@pytest.mark.slow
def test_what_is_carried_contains_the_roundings_of_normal_and_impact() -> None:
    """The 14 roundings of an impact contain its proved bound, and the rest that of the normal."""
    given, _, _ = impacts()
    motion = (sum(np.abs(given[a + p]) for p in "xyz") for a in "vw")
    speed = (
        U
        * contact_frames.LAW_ROUNDINGS
        * sum(x * y for x, y in zip(motion, (1, RADIUS), strict=True))
    )
    share = impact_bounds() / np.array([speed] * 3 + [speed / RADIUS] * 3)
    assert share.max() * SLACK <= 1
    assert share.max() > 1 / 2
    errors, _ = together()
    carried = carried_for_impacts()
    assert np.all(errors <= carried)
    assert np.any(errors > carried / 50)


@cache
def together() -> tuple[Floats, Floats]:
    """Return the errors after contacts by the roundings of normal and impact, and their bounds."""
    given, after, _ = impacts()
    places, _, _ = normals()
    errors = off_by(after, lambda: after_impact(given, np.array(exact_normal(places))))
    return errors, impact_bounds(list(SLACK * sum(normal_terms())))
