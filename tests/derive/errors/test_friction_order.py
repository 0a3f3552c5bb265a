"""The second order of a contact with friction, which its derivative leaves out, is within bounds.

Pairs of balls meet the ring or a plane, one of them off by small amounts, and grip or slip there.
The contact of the second is found by Newton's method in extended precision. What differs from the
first ball's derivative is held against the lemma of `derive/errors/friction.py`.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
import sympy as sp
from hoopgen.derive.contact.ball import Ball
from hoopgen.derive.contact.friction import CoulombFriction
from hoopgen.derive.errors import friction
from hoopgen.derive.errors import second_order as remainder
from hoopgen.derive.errors.contact_frames import NORMS
from hoopgen.derive.ir.kernel import kernel
from numpy.typing import NDArray

from tests.derive.errors.test_second_order import (
    CIRCLE,
    RADIUS,
    REACH,
    Wide,
    along,
    directions,
    gap_and_normal,
    size,
    turned,
)
from tests.helpers.derived import evaluation
from tests.helpers.effort import trials

pytestmark = pytest.mark.skipif(
    np.finfo(np.longdouble).nmant < 63, reason="needs more digits than doubles have"
)

Floats = NDArray[np.floating[Any]]
ROWS = 300_000
FIELDS = ("impulse", "velocity", "spin")


# ---------------------------------------------------------------------------------------- the law


@dataclass(frozen=True)
class Law:
    """The parameters of contacts, (n,) each: e0, mu, e_t, v0 and kappa."""

    restitution: Floats
    friction: Floats
    tangential: Floats
    falling: Floats
    inertia: Floats

    @property
    def grip(self) -> Floats:
        """G, the share of the slip that a contact which grips takes."""
        return self.inertia * (1 + self.tangential) / (1 + self.inertia)

    def rebound(self, nearing: Floats) -> Floats:
        """Return V e(V)."""
        return nearing * self.restitution / (1 + nearing / self.falling)

    def slope(self, nearing: Floats) -> Floats:
        """Return the derivative of V e(V)."""
        return self.restitution / (1 + nearing / self.falling) ** 2

    def slide(self, nearing: Floats) -> Floats:
        """Return S."""
        return self.friction * (nearing + self.rebound(nearing))


@dataclass(frozen=True)
class Motion:
    """Motions before contacts: the normals, the velocities and the spins, (3, n) each."""

    n: Floats
    v: Floats
    w: Floats

    @property
    def nearing(self) -> Floats:
        """V."""
        return -along(self.n, self.v)

    @property
    def slip(self) -> Floats:
        """u, the velocity of the contact point along the surface."""
        across = np.cross(self.w, self.n, axis=0)
        return self.v + self.nearing * self.n - RADIUS * across

    def margin(self, law: Law) -> Floats:
        """Return S - G |u|."""
        return law.slide(self.nearing) - law.grip * size(self.slip)

    def after(self, law: Law) -> tuple[Floats, Floats, Floats]:
        """Return the impulse f of friction, and velocity and spin after the contact."""
        u, slips = self.slip, self.margin(law) < 0
        direction = u / np.where(slips, size(u), 1)
        f = np.where(slips, law.slide(self.nearing) * direction, law.grip * u)
        after = self.v + self.nearing * self.n - f + law.rebound(self.nearing) * self.n
        return f, after, self.w + np.cross(self.n, f, axis=0) / (law.inertia * RADIUS)

    def change(self, law: Law, own: Motion) -> tuple[Floats, Floats, Floats]:
        """Return the derivative of `after` along changes of n, v and w.

        Parameters
        ----------
        law
            The law.
        own
            The changes.
        """
        n, v, w = self.n, self.v, self.w
        nearer = -along(own.n, v) - along(n, own.v)
        moved = own.v + nearer * n + self.nearing * own.n
        turned_on = np.cross(own.w, n, axis=0) + np.cross(w, own.n, axis=0)
        slid, u, slips = moved - RADIUS * turned_on, self.slip, self.margin(law) < 0
        speed = np.where(slips, size(u), 1)
        direction = u / speed
        steeper = law.friction * (1 + law.slope(self.nearing)) * nearer
        aside = slid - along(slid, direction) * direction
        slipping = steeper * direction + law.slide(self.nearing) * aside / speed
        df = np.where(slips, slipping, law.grip * slid)
        dv = moved - df + law.slope(self.nearing) * nearer * n + law.rebound(self.nearing) * own.n
        f, _, _ = self.after(law)
        twisted = np.cross(own.n, f, axis=0) + np.cross(n, df, axis=0)
        return df, dv, own.w + twisted / (law.inertia * RADIUS)


def laws(random: np.random.Generator, rows: int) -> Law:
    """Return random laws, with restitution that falls with speed or not."""
    values = (
        random.choice([0.0, 0.5, 0.7, 1.0], rows),
        10 ** random.uniform(np.log10(0.05), np.log10(2), rows),
        random.uniform(-0.5, 0.9, rows),
        random.choice([0.3, 2.0, 40.0, np.inf], rows),
        random.choice([1 / 64, 0.4, 2 / 3, 1.0], rows),
    )
    return Law(*(value.astype(Wide) for value in values))


# ------------------------------------------------------------------------------------------ pairs


@dataclass(frozen=True)
class Pairs:
    """Pairs of balls.

    Attributes
    ----------
    given
        The arguments of the bounds.
    left
        The sizes of what the derivatives leave out.
    slips, exact_slips
        Whether the first and the second ball slip.
    flat
        Whether they meet a plane.
    """

    given: dict[str, Any]
    left: dict[str, Floats]
    slips: NDArray[np.bool_]
    exact_slips: NDArray[np.bool_]
    flat: NDArray[np.bool_]

    def of(self, rows: NDArray[np.bool_]) -> Pairs:
        """Return some of them."""
        law = Law(*(one[rows] for one in vars(self.given["law"]).values()))
        given = {name: one[rows] for name, one in self.given.items() if name != "law"}
        left = {name: values[rows] for name, values in self.left.items()}
        return Pairs(
            given | {"law": law}, left, self.slips[rows], self.exact_slips[rows], self.flat[rows]
        )


def slips_near_the_switch(random: np.random.Generator, switch: Floats) -> Floats:
    """Return sizes of slips, many of them close to the one at which contacts begin to slip."""
    rows = len(switch)
    beyond = 10 ** random.uniform(-6, 2, rows)
    below = 1 - 10 ** random.uniform(-6, 0, rows)
    return switch * np.where(random.random(rows) < 0.7, 1 + beyond, below)


def aimed(random: np.random.Generator, *axes: Floats) -> Floats:
    """Return unit vectors, some of them along given ones."""
    rows = axes[0].shape[1]
    found = directions(random, rows)
    which = random.integers(0, 2 * len(axes), rows)
    for k, axis in enumerate(axes):
        found = np.where(which == k, axis * random.choice([-1, 1], rows), found)
    return found


def motions(random: np.random.Generator, normal: Floats) -> tuple[Law, Motion, Floats, Floats]:
    """Return random laws, motions before contacts, and the direction and the size of their slips.

    Parameters
    ----------
    random
        The generator.
    normal
        The normals, (3, n).
    """
    rows = normal.shape[1]
    law, approach = laws(random, rows), 10 ** random.uniform(-1, 1, rows).astype(Wide)
    way = np.cross(normal, directions(random, rows), axis=0)
    way = way / size(way)
    slip = slips_near_the_switch(random, law.slide(approach) / law.grip)
    glide = np.cross(normal, directions(random, rows), axis=0)
    glide = glide * approach * random.choice([0.0, 0.3, 3.0], rows)
    rolling = np.cross(normal, glide - slip * way, axis=0) / RADIUS
    turning = normal * random.choice([0.0, 10.0, 200.0], rows)
    return law, Motion(normal, glide - approach * normal, rolling + turning), way, slip


@cache
def drawn() -> Pairs:
    """Return random pairs of balls."""
    random, rows = np.random.default_rng(5), trials(ROWS)
    flat = np.arange(rows) % 2 == 0
    around, over = random.uniform(-np.pi, np.pi, (2, rows)).astype(Wide)
    over[1::8] = np.pi  # the inside of the ring, where it curves most
    rho = CIRCLE + REACH * np.cos(over)
    place = np.array([rho * np.cos(around), rho * np.sin(around), REACH * np.sin(over)])
    place[2, flat] = 0
    _, normal = gap_and_normal(place, flat)
    law, before, way, slip = motions(random, normal)
    approach, aside = before.nearing, np.cross(normal, way, axis=0)
    pull = random.choice([0.0, 0.0, 9.81, 300.0], rows)
    # Beside the largest jolts for which the lemma holds, shares of the slip and of V, larger ones.
    most = np.minimum(slip / 5, approach / 12)
    most = np.minimum(most, np.abs(before.margin(law)) / (law.grip + 2 * law.friction))
    most = most * np.where(
        random.random(rows) < 0.5, random.uniform(0.3, 1.5, rows), 10 ** random.uniform(-5, 0, rows)
    )
    most = most * random.choice([0.0, 1.0], rows, p=[0.2, 0.8])
    part = random.choice([0.0, 0.1, 0.5, 0.9, 1.0], rows)
    jolt, twist = (aimed(random, normal, way, aside) * most * share for share in (part, 1 - part))
    twist = np.cross(normal, twist, axis=0) / RADIUS + normal * along(normal, twist) / RADIUS
    off = (
        aimed(random, normal)
        * random.choice([0.0, 1.0], rows)
        * 10 ** random.uniform(-8, -3.3, rows)
    )
    fall = -pull * normal
    given = {
        "place_bound": size(off),
        "velocity_bound": size(jolt),
        "spin_bound": size(twist),
        "speed": size(before.v),
        "spin_size": size(before.w),
        "approach": approach,
        "pull": pull,
        "curvature": np.where(flat, 0.0, 1 / min(REACH, CIRCLE - REACH)),
        "law": law,
        "slip_speed": size(before.slip),
        "slip_margin": before.margin(law),
    }
    time, begun = contact_time(place, flat, off, (before.v, jolt, fall))
    first = off + before.v * begun
    there = off + (before.v + jolt) * time + fall * time**2 / 2
    gap, own = gap_and_normal(place + there, flat)
    bent = turned(place, normal, first, flat)
    exact = Motion(own, before.v + jolt + fall * time, before.w + twist)
    change = before.change(law, Motion(bent, jolt + fall * begun, twist))
    ends = zip(FIELDS, exact.after(law), before.after(law), change, strict=True)
    left = {name: size(after - now - moved) for name, after, now, moved in ends}
    slips, exact_slips = before.margin(law) < 0, exact.margin(law) < 0
    found = Pairs(given, left, slips, exact_slips, flat)
    assert np.all(np.abs(gap[in_reach(given)]) < 1e-17)
    return found


@cache
def pairs() -> Pairs:
    """Return the random pairs for which the conditions of the lemma hold."""
    given = drawn().given
    valid = np.all([one <= 0 for one in conditions(given)], axis=0)
    return drawn().of(in_reach(given) & valid)


def contact_time(
    place: Floats, flat: NDArray[np.bool_], off: Floats, motion: tuple[Floats, ...]
) -> tuple[Floats, Floats]:
    """Return by how much balls that are off meet the surface later, and the first order of that.

    Parameters
    ----------
    place, flat
        The contacts of the first balls, and which of them are on a plane.
    off
        How far the second balls are off.
    motion
        The velocity, its error and the acceleration.
    """
    moving, jolt, fall = motion
    _, normal = gap_and_normal(place, flat)
    begun = -along(normal, off) / along(normal, moving)
    time = begun
    for _ in range(8):
        there = off + (moving + jolt) * time + fall * time**2 / 2
        gap, own = gap_and_normal(place + there, flat)
        time = time - gap / along(own, moving + jolt + fall * time)
    return time, begun


# ----------------------------------------------------------------------------------------- bounds


@dataclass(frozen=True)
class Small:
    """Bounds of the lemma of `second_order`, and A, B and U."""

    change: Any
    turn: Any
    tilt: Any
    pull: Any
    moved: Any
    spun: Any
    slid: Any


def small(given: dict[str, Any]) -> Small:
    """Return a, N, d²n, g d²t, A, B and U."""
    bounds = remainder.second_order(Ball(sp.Symbol("radius")), sp.Symbol("e"))
    late = sum(evaluated(one, given) for one in bounds.delay)
    tilt = sum(evaluated(one, given) for one in bounds.normal)
    lasting = evaluated(remainder.STRETCH * remainder.place_bound / remainder.approach, given)
    change = given["velocity_bound"] + given["pull"] * lasting
    way = given["place_bound"] + (given["speed"] + change) * lasting
    turn = float(remainder.BEND) * given["curvature"] * way
    # In the code d²n has 2 N² for 1.2 K² Q².
    tilt = tilt + (2 - 1.2 / 1.02**2) * turn**2
    moved = change + 9 / 8 * turn * (given["speed"] + change)
    spun = given["spin_bound"] + 9 / 8 * turn * (given["spin_size"] + given["spin_bound"])
    return Small(change, turn, tilt, given["pull"] * late, moved, spun, moved + RADIUS * spun)


def in_reach(given: dict[str, Any]) -> NDArray[np.bool_]:
    """Return where the lemma of `second_order` holds."""
    bounds = remainder.second_order(Ball(sp.Symbol("radius")), sp.Symbol("e"))
    return np.asarray(np.all([evaluated(one, given) <= 0 for one in bounds.valid], axis=0))


def conditions(given: dict[str, Any]) -> list[Floats]:
    """Return what must be at most zero besides: the contact is decided, and its slip not small."""
    own, law = small(given), given["law"]
    steepest = law.friction * (1 + law.restitution)
    return [
        law.grip * own.slid + steepest * own.moved - np.abs(given["slip_margin"]),
        np.where(given["slip_margin"] < 0, 5 * own.slid - given["slip_speed"], -1),
    ]


def evaluated(expression: sp.Expr, given: dict[str, Any]) -> Floats:
    """Return the value of a bound."""
    return function_of({"value": expression})(given)["value"]


def function_of(formulas: dict[str, sp.Expr]) -> Callable[[dict[str, Any]], dict[str, Floats]]:
    """Return the function from arguments of bounds to the bounds, in double precision."""
    values = map(sp.sympify, formulas.values())
    order = sorted({s for value in values for s in value.free_symbols}, key=lambda s: str(s.name))
    own = kernel("bounds", formulas, order, "Bounds.", "the lemma")
    function, names = evaluation(own, tuple(order)), [symbol.name for symbol in own.arguments]

    def values_of(given: dict[str, Any]) -> dict[str, Floats]:
        found = function(*(given[name] for name in names))
        return {name: np.asarray(one, float) for name, one in zip(formulas, found, strict=True)}

    return values_of


@cache
def terms(field: str) -> list[Floats]:
    """Return the terms of a bound of the lemma; that of the impulse is for planes."""
    given, chosen = pairs().given, pairs()
    own, law, slips = small(given), given["law"], chosen.slips
    sigma = np.where(slips, law.friction * (1 + law.restitution), 0)
    bending = law.restitution / law.falling * own.moved**2
    share = law.slide(given["approach"]) / given["slip_speed"]
    whole = given["speed"] + law.grip * (given["speed"] + RADIUS * given["spin_size"])
    spins = given["spin_size"] + whole_impulse(given) / (law.inertia * RADIUS)

    def impulse(pace: Floats, turn: Floats) -> Floats:
        """Return L."""
        return law.grip * (pace + RADIUS * turn) + sigma * pace

    tilted = (own.pull, 9 / 8 * own.tilt * given["speed"], 9 / 8 * own.turn * own.change)
    twisted = (9 / 8 * own.tilt * given["spin_size"], 9 / 8 * own.turn * given["spin_bound"])
    f = [
        impulse(own.pull, 0 * own.pull),
        impulse(tilted[1] + tilted[2], sum(twisted)),
        np.where(slips, 21 / 20 * share * own.slid**2 / given["slip_speed"], 0),
        np.where(slips, 51 / 50 * sigma * own.moved * own.slid / given["slip_speed"], 0),
        np.where(slips, law.friction * bending, 0),
    ]
    moved, per = impulse(own.moved, own.spun), 1 / (law.inertia * RADIUS)
    if field == "impulse":
        return f
    if field == "velocity":
        rest = [*tilted, bending, 9 / 8 * own.tilt * whole]
        return [*f, *rest, 9 / 8 * own.turn * own.moved, 81 / 64 * own.turn * moved]
    rest = [*twisted, 9 / 8 * own.tilt * spins, 9 / 8 * own.turn * own.spun]
    return [*(one * per for one in f), *rest, 81 / 64 * own.turn * moved * per]


def whole_impulse(given: dict[str, Any]) -> Floats:
    """Return the most that an impulse of friction can be, G (|v| + R_B |w|)."""
    return np.asarray(given["law"].grip * (given["speed"] + RADIUS * given["spin_size"]))


def of_rest() -> Callable[[dict[str, Any]], dict[str, Floats]]:
    """Return the function from arguments to the code's terms beside |T| B, and its condition.

    Roundings are left out. So are errors and roundings before the contact, with which T is tested.
    """
    with pytest.MonkeyPatch.context() as patch:
        values = _of_rest(patch)
    return function_of(values)


def _of_rest(patch: pytest.MonkeyPatch) -> dict[str, sp.Expr]:
    """Return the formulas of the code without roundings."""
    for name in ("T_ROUNDING", "UNIT_ROUNDOFF", "FLOOR"):
        patch.setitem(friction.FrictionImpact.rest.__globals__, name, sp.Integer(0))
    names = ("speed", "spin_size", "approach", "change", "turn", "tilt", "pulled")
    s = {name: sp.Symbol(name, nonnegative=True) for name in (*names, "e0", "mu", "v0", "kappa")}
    law = CoulombFriction("law", s["e0"], s["mu"], sp.Symbol("e_t", real=True), s["v0"])
    zero = (sp.Integer(0),) * 3
    arrival: Any = SimpleNamespace(
        size=s["speed"],
        spinning=s["spin_size"],
        nearing=s["approach"],
        change=s["change"],
        turn=s["turn"],
        tilt=s["tilt"],
        pull=s["pulled"],
        own=zero[:2],
        paces=zero,
        turns=zero,
        excess=sp.Integer(-1),
        longer=sp.Symbol("longer", nonnegative=True),
        **dict.fromkeys(("beyond", "turned", "summed", "spun"), sp.Integer(0)),
    )
    impact = friction.FrictionImpact(Ball(sp.Symbol("radius"), s["kappa"]), law)
    rest = impact.rest(arrival)
    values = {"across": rest.extras[3], "along": rest.extras[4], "normal": rest.extras[2]}
    values |= {"spin": rest.extras[5], "unrolled": rest.unrolled, "excess": rest.excess}
    return values


def arguments(given: dict[str, Any]) -> dict[str, Any]:
    """Return the arguments of the code's bounds."""
    own, law = small(given), given["law"]
    share = np.where(given["slip_margin"] < 0, law.slide(given["approach"]), 0)
    share = np.where(given["slip_margin"] < 0, share / given["slip_speed"], law.grip)
    return given | {
        "change": own.change,
        "turn": own.turn,
        "tilt": own.tilt,
        "pulled": own.pull,
        "e0": law.restitution,
        "mu": law.friction,
        "e_t": law.tangential,
        "v0": law.falling,
        "kappa": law.inertia,
        "radius": RADIUS,
        "slip_share": share,
        "normal_rounding": 0.0,
        "longer": 0.0,
        NORMS[2].name: given["spin_bound"],
    }


def left_out(field: str) -> Floats:
    """Return what the derivative leaves out, less the test's own roundings."""
    given = pairs().given
    sizes = given["speed"] + given["slip_speed"] + RADIUS * given["spin_size"]
    late = 2.0**-61 / given["approach"]  # roundings of lengths below 1 m, over V
    rounded = (2.0**-57 * sizes + given["pull"] * late) * (1 + 2 * given["law"].friction)
    if field == "spin":
        rounded = rounded / (RADIUS * given["law"].inertia)
    return np.asarray(pairs().left[field] - rounded)


def rows_of(field: str) -> NDArray[np.bool_]:
    """Return which pairs tell of a field: the impulse turns with the normal, but on planes."""
    return np.asarray(pairs().flat | (field != "impulse"))


# ------------------------------------------------------------------------------------------ tests


def test_pairs_grip_and_slip_on_planes_and_on_the_ring() -> None:
    chosen = pairs()
    assert len(chosen.slips) > 0.5 * len(drawn().slips)
    for surface in (chosen.flat, ~chosen.flat):
        assert np.mean(chosen.slips[surface]) > 0.3
        assert np.mean(~chosen.slips[surface]) > 0.1
    given = chosen.given
    near = chosen.slips & (small(given).slid > 0.15 * given["slip_speed"])
    assert np.count_nonzero(near) > 20  # of the limit 5 U = |u|


def test_the_exact_ball_slips_where_the_computed_one_does() -> None:
    chosen = pairs()
    assert np.array_equal(chosen.slips, chosen.exact_slips)
    own, law = small(chosen.given), chosen.given["law"]
    moved = law.grip * own.slid + law.friction * (1 + law.restitution) * own.moved
    assert np.mean(moved > 0.5 * np.abs(chosen.given["slip_margin"])) > 0.05


@pytest.mark.parametrize("field", FIELDS)
def test_what_the_derivative_leaves_out_is_within_the_bound(field: str) -> None:
    bound, rows = np.sum(terms(field), axis=0), rows_of(field)
    assert np.all(left_out(field)[rows] <= bound[rows])


@pytest.mark.parametrize(
    ("field", "missing"),
    [
        ("impulse", (0,)),
        ("impulse", (2,)),
        ("impulse", (3,)),
        ("impulse", (4,)),
        ("velocity", (0,)),
        ("velocity", (2,)),
        ("velocity", (3,)),
        ("velocity", (4,)),
        ("velocity", (5,)),
        ("velocity", (8,)),
        ("velocity", (1, 6, 9)),
        ("velocity", (1, 10, 11)),
        ("spin", (0,)),
        ("spin", (2,)),
        ("spin", (3,)),
        ("spin", (4,)),
        ("spin", (1, 5, 6, 7, 8, 9)),
    ],
)
def test_a_term_that_is_left_out_is_missed(field: str, missing: tuple[int, ...]) -> None:
    """Several effects of the normal's second order contain each other."""
    rest, rows = [term for k, term in enumerate(terms(field)) if k not in missing], rows_of(field)
    assert np.any(left_out(field)[rows] > np.sum(rest, axis=0)[rows])


@pytest.mark.parametrize(
    ("field", "slips", "least"),
    [
        ("impulse", True, 0.8),
        ("velocity", True, 0.8),
        ("velocity", False, 0.9),
        ("spin", True, 0.8),
    ],
)
def test_bounds_are_not_far_above_what_is_left_out(field: str, slips: bool, least: float) -> None:
    rows = rows_of(field) & (pairs().slips == slips)
    bound = np.sum(terms(field), axis=0)[rows]
    share = left_out(field)[rows][bound > 0] / bound[bound > 0]
    assert share.max() > least


def test_the_code_has_the_terms_of_the_lemma() -> None:
    found = of_rest()(arguments(pairs().given))
    velocity, spin = (np.sum(terms(field), axis=0).astype(float) for field in FIELDS[1:])
    wanted = {"across": velocity, "along": velocity, "normal": velocity, "spin": spin}
    wanted["unrolled"] = spin + velocity / RADIUS
    for name, bound in wanted.items():
        np.testing.assert_allclose(found[name], bound, rtol=1e-9, atol=1e-30, err_msg=name)


def test_where_the_code_s_condition_holds_so_do_those_of_the_lemma() -> None:
    """The code has room for roundings beside these: an eighth, and 2^-20 of all speeds."""
    chosen = drawn().of(in_reach(drawn().given))
    holds = of_rest()(arguments(chosen.given))["excess"] <= 0
    decided, steady = (one <= 0 for one in conditions(chosen.given))
    assert np.all((decided & steady)[holds])
    assert np.array_equal(chosen.slips[holds], chosen.exact_slips[holds])
    # Both are needed, and little more is refused.
    assert np.any(chosen.slips != chosen.exact_slips)
    assert np.any(decided & ~steady)
    assert np.count_nonzero(holds) > 0.9 * np.count_nonzero(decided & steady)


# ------------------------------------------------------------------------------ without errors


def without_errors(law: Law, before: Motion) -> dict[str, Any]:
    """Return the arguments of the code's bounds for balls without errors before the contact."""
    none = 0 * before.nearing
    given = dict.fromkeys(
        ("place_bound", "velocity_bound", "spin_bound", "pull", "curvature"), none
    )
    given |= {"speed": size(before.v), "spin_size": size(before.w), "approach": before.nearing}
    given |= {"slip_speed": size(before.slip), "slip_margin": before.margin(law)}
    return arguments(given | {"law": law})


def test_what_is_within_its_roundings_is_undecided_without_any_errors() -> None:
    """So is the direction of a slip that is 2^-20 of all speeds."""
    random = np.random.default_rng(9)
    law, before, _, _ = motions(random, directions(random, trials(20_000)))
    given, rest = without_errors(law, before), of_rest()
    total = size(before.v) + RADIUS * size(before.w)
    unit = law.grip * total + law.friction * (1 + law.restitution) * size(before.v)
    slips, blurred, small_slip = before.margin(law) < 0, 2.0**-48 * unit, 5 * 2.0**-20 * total
    given["slip_speed"] = 2 * small_slip
    for share, undecided in ((0.999, True), (1.001, False)):
        own = given | {"slip_margin": share * np.where(slips, -blurred, blurred)}
        assert np.all((rest(own)["excess"] > 0) == undecided)
        own = given | {"slip_speed": share * small_slip, "slip_margin": np.where(slips, -1, 1)}
        assert np.array_equal(rest(own)["excess"] > 0, slips & undecided)


def test_a_normal_that_is_off_changes_motions_by_no_more_than_is_counted() -> None:
    """Contacts that are decided slip with either normal, or grip with either.

    Normals are turned, or too long, or off in any direction, for which the bound is that of both.
    """
    random, off, rest = np.random.default_rng(10), Wide(2.0**-18), of_rest()
    for kind in ("turned", "longer", "any"):
        normal = directions(random, trials(100_000))
        law, before, way, _ = motions(random, normal)
        aside = np.cross(normal, way, axis=0)
        nudge = {
            "turned": aimed(random, way, aside),
            "longer": normal * random.choice([-1, 1], normal.shape[1]),
            "any": aimed(random, normal, way, aside),
        }[kind]
        if kind == "turned":
            nudge = nudge - along(nudge, normal) * normal
        other = Motion(normal + off * nudge, before.v, before.w)
        amount = {"longer" if kind == "longer" else "normal_rounding": off + 0 * before.nearing}
        bounds = rest(without_errors(law, before) | amount)
        decided, slips = bounds["excess"] <= 0, before.margin(law) < 0
        assert np.mean(decided) > 0.7
        exact_slips = other.margin(law) < 0
        assert np.array_equal(slips[decided], exact_slips[decided])
        assert np.any(slips != exact_slips)
        ends = zip(other.after(law)[1:], before.after(law)[1:], strict=True)
        moved, twisted = (one - now for one, now in ends)
        up = along(moved, normal)
        found = {"normal": np.abs(up), "across": size(moved - up * normal), "spin": size(twisted)}
        for name, one in found.items():
            share = (one / bounds[name])[decided]
            assert share.max() <= 1 + 2.0**-10, name  # the slack of all bounds
            assert share.max() > LEAST[kind].get(name, 0.8), (kind, name, share.max())


LEAST = {"turned": {"normal": 0.6, "spin": 0.45}, "longer": {}, "any": {}}
"""Shares of bounds that the effects of normals must exceed, where they are not 0.8."""


# ------------------------------------------------------------------------------------- directions


def test_directions_that_change_by_a_fifth_are_within_the_bounds() -> None:
    """A unit vector changes by r at every angle to it; the second order is largest at 1/5."""
    random, rows = np.random.default_rng(7), trials(100_000)
    angle = random.uniform(-np.pi, np.pi, rows).astype(Wide)
    r = random.choice([1.0, 10.0**-3], rows) * random.uniform(0.1, 1, rows) / 5
    r[::4] = Wide(1) / friction.LARGEST_CHANGE
    change = r * np.array([np.cos(angle), np.sin(angle)])
    start = np.array([[Wide(1)], [Wide(0)]])
    off = (start + change) / size(start + change) - start
    first = np.array([0 * r, change[1]])
    left, turn = size(off - first) / r**2, size(off) / r
    assert left.max() <= 0.94 < float(friction.DIRECTION_ORDER)
    assert left.max() > 0.59 * float(friction.DIRECTION_ORDER)
    assert turn.max() <= float(friction.DIRECTION_SLOPE)
    assert turn.max() > 0.98 * float(friction.DIRECTION_SLOPE)
