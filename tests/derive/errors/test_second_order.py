"""The second order of a contact, which its derivative leaves out, is within the lemma's bounds.

Pairs of balls meet the ring or a plane, one of them off by small amounts. The contact of the second
is found by Newton's method, and what differs from the first ball's derivative is held against the
bounds.
"""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest
import sympy as sp
from hoopgen.derive.contact.ball import Ball
from hoopgen.derive.errors import second_order as lemma
from hoopgen.derive.symbolic.conditionals import IfLess, release
from numpy.typing import NDArray

from hoopgen import PAPER
from tests.helpers.effort import trials

pytestmark = pytest.mark.skipif(
    np.finfo(np.longdouble).nmant < 63, reason="needs more digits than doubles have"
)

Floats = NDArray[np.floating[Any]]
Wide = np.longdouble
ROWS = 200_000
CIRCLE, RADIUS = PAPER["ring_radius"], PAPER["ball_radius"]
REACH = RADIUS + PAPER["wire_radius"]
STAYS, SHARE, RESTITUTION = Wide(3) / 5, Wide(2) / 5, Wide(PAPER["restitution"])
FIELDS = ("delay", "place", "normal", "velocity", "spin")


def size(vectors: Floats) -> Floats:
    return np.sqrt((vectors * vectors).sum(axis=0))


def along(one: Floats, other: Floats) -> Floats:
    return (one * other).sum(axis=0)


def directions(random: np.random.Generator, rows: int) -> Floats:
    found = random.normal(size=(3, rows)).astype(Wide)
    return found / size(found)


def gap_and_normal(place: Floats, flat: NDArray[np.bool_]) -> tuple[Floats, Floats]:
    """Return the distance from the ring, or from the plane z = 0, and its gradient."""
    x, y, z = place
    rho = np.hypot(x, y)
    away = np.hypot(rho - CIRCLE, z)
    out = (rho - CIRCLE) / (away * rho)
    normal = np.where(flat, np.array([0 * x, 0 * x, 0 * x + 1]), [x * out, y * out, z / away])
    return np.where(flat, z, away - REACH), normal


def turned(place: Floats, normal: Floats, way: Floats, flat: NDArray[np.bool_]) -> Floats:
    """Return Dn q on the ring: the meridian's curvature 1/R, and along the wire cos(theta)/rho."""
    x, y, _ = place
    rho = np.hypot(x, y)
    around = np.array([-y, x, 0 * x]) / rho
    over = np.cross(normal, around, axis=0)
    circling = (rho - CIRCLE) / (REACH * rho)
    bent = over * along(over, way) / REACH + around * along(around, way) * circling
    return np.where(flat, 0 * bent, bent)


def impact(n: Floats, v: Floats, w: Floats) -> tuple[Floats, Floats]:
    """Return the motion after a contact without slip, of a thin shell."""
    onto, across = along(v, n), np.cross(w, n, axis=0)
    after = STAYS * v - (STAYS + RESTITUTION) * onto * n + SHARE * RADIUS * across
    spin = STAYS * np.cross(n, v, axis=0) / RADIUS + SHARE * w + (1 - SHARE) * along(w, n) * n
    return after, spin


def impact_change(n: Floats, v: Floats, w: Floats, *changes: Floats) -> tuple[Floats, Floats]:
    """Return the derivative of `impact` along changes of n, v and w: both are polynomials."""
    dn, dv, dw = changes
    turned_after, turned_spin = impact(n, dv, dw)
    onto = along(v, dn) * n + along(v, n) * dn
    after = SHARE * RADIUS * np.cross(w, dn, axis=0) - (STAYS + RESTITUTION) * onto
    spin = STAYS * np.cross(dn, v, axis=0) / RADIUS
    spin = spin + (1 - SHARE) * (along(w, dn) * n + along(w, n) * dn)
    return turned_after + after, turned_spin + spin


@cache
def pairs() -> tuple[dict[str, Any], dict[str, Floats]]:
    """Return the arguments of the bounds, and the sizes of what the derivatives leave out."""
    random, rows = np.random.default_rng(5), trials(ROWS)
    flat = np.arange(rows) % 4 == 0
    around, over = random.uniform(-np.pi, np.pi, (2, rows)).astype(Wide)
    over[1::8] = np.pi  # the inside of the ring, where it curves most
    rho = CIRCLE + REACH * np.cos(over)
    place = np.array([rho * np.cos(around), rho * np.sin(around), REACH * np.sin(over)])
    place[2, flat] = 0
    _, normal = gap_and_normal(place, flat)
    tangent = np.cross(normal, directions(random, rows), axis=0)
    tangent = tangent / size(tangent)
    approach = 10 ** random.uniform(-1, 1, rows).astype(Wide)
    slides = random.choice([0.0, 0.3, 3.0], rows)
    moving = -approach * normal + slides * approach * tangent
    spin = directions(random, rows) * random.choice([0.0, 10.0, 200.0], rows)
    pull = random.choice([0.0, 9.81, 300.0], rows)
    off, jolt, twist = (
        directions(random, rows) * factor * random.choice([0.0, 1e-3, 1e-5, 1e-7], rows)
        for factor in (0.3, approach, 30.0)
    )
    straight = random.random(rows) < 0.3
    off = np.where(straight, normal * size(off) * random.choice([-1, 1], rows), off)
    jolt = np.where(straight, normal * size(jolt) * random.choice([-1, 1], rows), jolt)
    fall = -pull * normal
    given = {
        "place_bound": size(off),
        "velocity_bound": size(jolt),
        "spin_bound": size(twist),
        "speed": size(moving),
        "spin_size": size(spin),
        "approach": approach,
        "pull": pull,
        "curvature": np.where(flat, 0.0, 1 / min(REACH, CIRCLE - REACH)),
    }
    bounds = lemma.second_order(Ball(sp.Symbol("radius", positive=True)), sp.Symbol("e"))
    valid = np.all([evaluated(one, given) <= 0 for one in bounds.valid], axis=0)
    time = -along(normal, off) / along(normal, moving)
    first = off + moving * time
    for _ in range(8):
        there = off + (moving + jolt) * time + fall * time**2 / 2
        gap, own = gap_and_normal(place + there, flat)
        time = time - gap / along(own, moving + jolt + fall * time)
    there = off + (moving + jolt) * time + fall * time**2 / 2
    gap, own = gap_and_normal(place + there, flat)
    assert np.all(np.abs(gap[valid]) < 1e-17)
    begun = -along(normal, off) / along(normal, moving)
    bent = turned(place, normal, first, flat)
    after, turning = impact(own, moving + jolt + fall * time, spin + twist)
    before = impact(normal, moving, spin)
    change = impact_change(normal, moving, spin, bent, jolt + fall * begun, twist)
    left = {
        "delay": np.abs(time - begun),
        "place": size(there - first),
        "normal": size(own - normal - bent),
        "velocity": size(after - before[0] - change[0]),
        "spin": size(turning - before[1] - change[1]),
    }
    kept = {name: np.broadcast_to(values, rows)[valid] for name, values in given.items()}
    return kept, {name: values[valid] for name, values in left.items()}


def evaluated(expression: sp.Expr, given: dict[str, Any]) -> Floats:
    """Return the value of a bound."""
    plain = release(sp.sympify(expression)).replace(
        lambda e: isinstance(e, IfLess),
        lambda e: sp.Piecewise((e.args[2], e.args[0] < e.args[1]), (e.args[3], True)),
    )
    values = given | {"radius": RADIUS, "e": float(RESTITUTION)}
    names = sorted(symbol.name for symbol in plain.free_symbols)
    function = sp.lambdify(names, plain, "numpy")
    return np.asarray(function(*(values[name] for name in names)), float)


@cache
def terms(field: str) -> list[Floats]:
    """Return the terms of a bound."""
    given, _ = pairs()
    bounds = lemma.second_order(Ball(sp.Symbol("radius", positive=True)), sp.Symbol("e"))
    return [
        np.broadcast_to(evaluated(e, given), given["speed"].shape) for e in getattr(bounds, field)
    ]


ROUNDINGS = {"delay": 1e-17, "place": 1e-17, "normal": 1e-16, "velocity": 1e-15, "spin": 1e-13}
"""The roundings of the test's own arithmetic, in extended precision."""


def left_out(field: str) -> Floats:
    """Return what the derivative leaves out, less the test's own roundings."""
    return np.asarray(pairs()[1][field] - ROUNDINGS[field])


@pytest.mark.sampled(4)
@pytest.mark.parametrize("field", FIELDS)
def test_what_the_derivative_leaves_out_is_within_the_bound(field: str) -> None:
    bound = np.sum(terms(field), axis=0)
    assert len(bound) > 0.3 * trials(ROWS)
    assert np.all(left_out(field) <= bound)


@pytest.mark.parametrize(
    ("field", "left_out_term"),
    [
        ("delay", 0),
        ("delay", 1),
        ("delay", 2),
        ("place", 0),
        ("normal", 0),
        ("velocity", 0),
        ("velocity", 1),
        ("velocity", 4),
        ("spin", 1),
        ("spin", 3),
    ],
)
def test_a_term_that_is_left_out_is_missed(field: str, left_out_term: int) -> None:
    """The terms that are not here are small beside others that have the same cause."""
    rest = [term for k, term in enumerate(terms(field)) if k != left_out_term]
    assert np.any(left_out(field) > np.sum(rest, axis=0))


@pytest.mark.parametrize("field", ["delay", "velocity"])
def test_bounds_are_not_far_above_what_is_left_out(field: str) -> None:
    bound = np.sum(terms(field), axis=0)
    share = left_out(field)[bound > 0] / bound[bound > 0]
    assert share.max() > 0.8
