"""The roundings of the ring's condition F, of F less its value at the start, and of F'.

The kernel `ring_refine` computes them. For each there is a bound on its rounding error, for an
exact start, with its proof, to first order in u times `ROUNDING_SLACK`. Random inputs are held
against it with 200 bits. `test_ring_roots.py` makes a bound on the root's error of them.
"""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from tests.derive.errors.test_kernel_roundings import (
    EXACT,
    SLACK,
    Floats,
    U,
    called,
    flight_terms,
    off_by,
)
from tests.helpers.effort import trials

ROWS = 100_000
STATE = ("x", "y", "z", "vx", "vy", "vz")


class Meeting:
    """Flights until a time, beside the ring of each: what is computed, and what is exact.

    Attributes
    ----------
    given
        The start, the time and the sizes, by name.
    ends
        The computed end of each flight, (6, n).
    gap, deflated, rate
        The computed F, F less its value at the start, and F', by `ring_refine`.
    """

    def __init__(self, given: dict[str, Any]) -> None:
        self.given = given
        self.ends = called("flight", **given)
        rho_start, *_ = called("ring_started", **given)
        _, self.gap, self.rate = called("ring_refine", leaving=0.0, rho_start=rho_start, **given)
        _, self.deflated, _ = called("ring_refine", leaving=1.0, rho_start=rho_start, **given)
        self.start_rho, self.rho = rho_start, np.hypot(*self.ends[:2])
        self.depth, self.start_depth = (
            far - given["p_ring_radius"] for far in (self.rho, rho_start)
        )
        self.reach = given["p_ball_radius"] + given["p_wire_radius"]
        self.off = sum(flight_terms(given, self.ends, given["p_gravity"]))
        x, y, _ = np.abs(self.ends[:3])
        self.off_rho = (x * self.off[0] + y * self.off[1]) / self.rho

    def path(self, time: Any) -> tuple[list[Any], list[Any]]:
        """Return the exact place and velocity at exact times, in balls."""
        own = {name: EXACT(self.given[name]) for name in (*STATE, "p_gravity")}
        fall = own["p_gravity"] * time
        there = [own[s] + own["v" + s] * time for s in "xyz"]
        return [*there[:2], there[2] - fall * time / 2], [own["vx"], own["vy"], own["vz"] - fall]

    def exact(self, time: Any = None) -> dict[str, NDArray[Any]]:
        """Return the exact F, F less its value at the start, and F', at the end, in balls."""
        names = ("p_ball_radius", "p_wire_radius", "p_ring_radius", "t")
        ball, wire, circle, end = (EXACT(self.given[name]) for name in names)
        there, moving = self.path(end if time is None else time)
        start, _ = self.path(0 * end)

        def gap(x: Any, y: Any, z: Any) -> Any:
            return (ROOT(x * x + y * y) - circle) ** 2 + z * z - (ball + wire) ** 2

        rho = ROOT(there[0] ** 2 + there[1] ** 2)
        out = (there[0] * moving[0] + there[1] * moving[1]) / rho
        rate = 2 * ((rho - circle) * out + there[2] * moving[2])
        return {"gap": gap(*there), "deflated": gap(*there) - gap(*start), "rate": rate}

    def errors(self, name: str) -> Floats:
        """Return the error of a computed quantity."""
        return off_by(getattr(self, name), lambda: list(self.exact()[name]))


ROOT = np.vectorize(lambda ball: ball.sqrt(), otypes=[object])


def gap_terms(at: Meeting) -> list[Floats]:
    """Return the terms of the bound on the rounding of F.

    F = d² + z² - R², d = ρ - R_H. The computed ρ is off by 2 u ρ and by what the place is off by
    along it, p_ρ = (|x| p_x + |y| p_y)/ρ; so d is off by 2 u ρ + p_ρ + u |d|, and z by p_z. Two
    products, their sum, and R² with R a sum, add u (d² + z²) twice and 3 u R², and the last sum
    u |F|. At a root d² + z² = R², and

        |δF| <= u (4 ρ |d| + 2 d² + 5 R²) + 2 |d| p_ρ + 2 |z| p_z.
    """
    height = np.abs(at.ends[2])
    depth = np.abs(at.depth)
    return [
        U * 4 * at.rho * depth,
        U * (2 * depth**2 + 2 * (depth**2 + height**2) + 3 * at.reach**2 + np.abs(at.gap)),
        2 * depth * at.off_rho,
        2 * height * at.off[2],
    ]


def deflated_terms(at: Meeting) -> list[Floats]:
    """Return the terms of the bound on the rounding of F less its value at the start.

    It is t (T + Z), T = P (d + d0)/(ρ + ρ0), P = (ρ² - ρ0²)/t = 2 (x vx + y vy) + t (vx² + vy²) and
    Z = m (z + z0), m = vz - g t/2 the mean velocity.

    **P** has the sizes |2 x vx|, |2 y vy| and t V²: three roundings of t V², two of each product,
    with the sum of these, and one of P.
    **T** = P (1 - 2 R_H/(ρ + ρ0)): ρ + ρ0 is off by s = 2 u (ρ + ρ0) + p_ρ, which changes T by
    2 R_H |P| s/(ρ + ρ0)². d and d0 are off by u of each besides, and T by seven more roundings:
    the sum d + d0, two products with it, and in ρ/((ρ + ρ0) ρ) a sum, two products and a quotient.
    **Z**: m is off by u (g t/2 + |m|), z by p_z, their sum by u of it, the product by u of it.
    The sum T + Z and the product with t are off by u each.
    """
    own = at.given
    t, g = own["t"], own["p_gravity"]
    parts = np.abs(own["x"] * own["vx"]), np.abs(own["y"] * own["vy"])
    dot = own["x"] * own["vx"] + own["y"] * own["vy"]
    squared = own["vx"] ** 2 + own["vy"] ** 2
    slope = np.abs(2 * dot + t * squared)
    both, deep = at.rho + at.start_rho, np.abs(at.depth + at.start_depth)
    radial = slope * deep / both
    depths = np.abs(at.depth) + np.abs(at.start_depth)
    mean = own["vz"] - g * t / 2
    high = at.ends[2] + own["z"]
    return [
        t * U * (3 * t * squared + 2 * sum(parts) + 2 * np.abs(dot) + slope) * deep / both,
        t * 2 * own["p_ring_radius"] * slope / both**2 * (2 * U * both + at.off_rho),
        t * U * (slope * depths / both + 7 * radial),
        t * np.abs(mean) * at.off[2],
        t * U * np.abs(high) * (g * t / 2 + 3 * np.abs(mean)),
        2 * U * np.abs(at.deflated),
    ]


def rate_terms(at: Meeting) -> list[Floats]:
    """Return the terms of the bound on the rounding of F' = 2 (d ρ' + z vz'), ρ' = (x vx + y vy)/ρ.

    x vx + y vy is off by u of its value and of each product, and by what the place is off by. 1/ρ
    is (ρ + ρ0)/((ρ + ρ0) ρ): off by two products, a quotient and what ρ is off by. d ρ' has two
    products and the difference d besides. z is off by p_z, vz' by u (g t + |vz'|); a product and
    the sum are off by u each.
    """
    own = at.given
    parts = np.abs(own["vx"] * at.ends[0]), np.abs(own["vy"] * at.ends[1])
    dot = np.abs(own["vx"] * at.ends[0] + own["vy"] * at.ends[1])
    moved = np.abs(own["vx"]) * at.off[0] + np.abs(own["vy"]) * at.off[1]
    depth, out = np.abs(at.depth), dot / at.rho
    height, fall = np.abs(at.ends[2]), np.abs(at.ends[5])
    off_rho = 2 * U * at.rho + at.off_rho
    return [
        2 * depth / at.rho * (U * (sum(parts) + dot) + moved),
        2 * out * (6 * U * depth + off_rho * (1 + depth / at.rho)),
        2 * fall * at.off[2],
        2 * height * U * (own["p_gravity"] * own["t"] + 2 * fall),
        U * np.abs(at.rate),
    ]


TERMS = {"gap": gap_terms, "deflated": deflated_terms, "rate": rate_terms}


@cache
def random_meetings() -> Meeting:
    """Return flights to rings of many sizes.

    Some are such that one term of a bound is larger than the others: short flights to the ring (0)
    or to its top (1), up and down almost alone (3, 8, 9, 10), chords inside the ring (4), flights
    far outside a small ring (5), over the top of the wire (6), along tangents (7, 11).
    """
    random, rows = np.random.default_rng(6), trials(ROWS, at_least=ROWS // 2)
    kind = np.arange(rows) % 12
    radius, wire = random.uniform(0.05, 0.2, rows), random.uniform(0.002, 0.02, rows)
    reach = radius + wire
    circle = reach * (1 + 2.0 ** random.uniform(-4, 5, rows))
    circle[kind == 0] *= 32
    gravity, time = 2.0 ** random.uniform(-3, 5, rows), 2.0 ** random.uniform(-12, 1, rows)
    around, over = random.uniform(-np.pi, np.pi, (2, rows))
    outward, sideways, falling = random.uniform(-9, 9, (3, rows))
    time[kind <= 1] *= 2.0**-16
    over[kind == 1] = np.pi / 2
    over[kind == 4] = np.pi
    over[kind == 6] = (np.pi / 2 + 0.01 * np.sin(around))[kind == 6]
    over[kind == 8] *= 2.0**-20
    rho, height = circle + reach * np.cos(over), reach * np.sin(over)
    circle[kind == 5] *= 2.0**-8
    outward[kind >= 7] = 0
    outward[kind == 3] *= 2.0**-10
    sideways[np.isin(kind, (5, 6, 8, 9, 10))] = 0
    sideways[kind == 3] *= 2.0**-10
    falling[np.isin(kind, (2, 7, 9))] *= 2.0**-20
    half = random.uniform(0.1, 1.5, rows)  # of the chord's angle
    for own, new in (
        (outward, rho * np.sin(half)),
        (sideways, rho * np.cos(half)),
        (time, 2 * np.sin(half)),
    ):
        own[kind == 4] = new[kind == 4]
    time[kind == 6] = 2.0**-10
    outward[kind == 6] = (2 * (rho - circle) / time)[kind == 6]
    mean = falling + gravity * time / 2
    mean[np.isin(kind, (4, 5, 6))] = 0
    mean[kind == 10] = (2 * height / time)[kind == 10]
    out = np.array([np.cos(around), np.sin(around)])
    moving = out * outward + np.array([-out[1], out[0]]) * sideways
    places = (*(out * rho - moving * time), height - mean * time)
    given = dict(zip(STATE, (*places, *moving, mean + gravity * time / 2), strict=True))
    sizes = {"p_ball_radius": radius, "p_wire_radius": wire, "p_ring_radius": circle}
    return Meeting(given | sizes | {"t": time, "p_gravity": gravity})


@cache
def random_errors(name: str) -> tuple[Floats, list[Floats]]:
    """Return the errors of a computed quantity at random flights, and the terms of their bound."""
    at = random_meetings()
    return at.errors(name), TERMS[name](at)


@pytest.mark.slow
@pytest.mark.parametrize("name", TERMS)
def test_the_roundings_of_the_ring_s_condition_are_within_their_proved_bound(name: str) -> None:
    errors, terms = random_errors(name)
    bounds = sum(terms)
    assert np.all(errors <= SLACK * bounds)
    assert np.any(errors > bounds / 2)


LEFT_OUT = {
    "gap": [(0,), (1,), (2,), (3,)],
    "deflated": [(0,), (1,), (2,), (3,), (4, 5)],
    "rate": [(0,), (1, 4), (2,), (3,)],
}


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "left_out"), [(name, one) for name, some in LEFT_OUT.items() for one in some]
)
def test_no_term_of_the_condition_s_bound_may_be_left_out(
    name: str, left_out: tuple[int, ...]
) -> None:
    errors, terms = random_errors(name)
    rest = sum(term for k, term in enumerate(terms) if k not in left_out)
    assert np.any(errors > SLACK * rest)
