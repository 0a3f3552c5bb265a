"""The contact with friction, proved for every unit normal: its law, what it keeps, what it loses.

And beside the proofs another way to the same motion: the impact followed over its impulse.
"""

from __future__ import annotations

from dataclasses import dataclass

import mpmath
import numpy as np
import pytest
import sympy as sp
from hoopgen.derive.contact.ball import Ball
from hoopgen.derive.contact.friction import (
    IMPULSE,
    CoulombFriction,
    contact_velocity,
    grip_share,
    impulse_equations,
    impulse_response,
    slip_response,
)
from hoopgen.derive.contact.no_slip import AFTER, BEFORE, NoSlip, impact
from hoopgen.derive.errors.derivative import directional
from hoopgen.derive.symbolic.conditionals import IfAtMost, IfLess, release
from hoopgen.derive.symbolic.symbols import NORMAL, SPIN, VELOCITY, normal, spin, velocity
from numpy.typing import NDArray

from tests.helpers.effort import trials

ball_radius, inertia, restitution, friction, falling = sp.symbols(
    "ball_radius inertia restitution friction falling", positive=True
)
tangential, share = sp.symbols("tangential share", real=True)
LAW = CoulombFriction("slipping", restitution, friction, tangential, falling)
BALL = Ball(ball_radius, inertia)
SPHERE = normal.dot(normal) - 1
AWAY = 1 / (1 + 1 / inertia)
"""kappa / (1 + kappa), what of the slip's energy friction can take."""


def vanishes(expression: sp.Expr) -> bool:
    """Return True if the expression, rational in the normal, is zero for every unit normal."""
    numerator, _ = sp.fraction(sp.together(release(expression)))
    _, remainder = sp.reduced(sp.expand(numerator), [SPHERE], *reversed(NORMAL))
    return bool(remainder == 0)


def across(vector: sp.Matrix) -> sp.Matrix:
    """Return the part of a vector that is not along the normal."""
    return vector - vector.dot(normal) * normal


def slip(moving: sp.Matrix, turning: sp.Matrix) -> sp.Matrix:
    return across(moving + turning.cross(-ball_radius * normal))


def choice_and_after(law: CoulombFriction) -> tuple[sp.Expr, sp.Matrix, sp.Matrix]:
    """Return how the share is chosen, and the motion after a contact with any share."""
    after = [release(part) for part in law.after(normal, velocity, spin, BALL)]
    chosen = after[0].atoms(IfLess)
    (outermost,) = (c for c in chosen if not any(c is not o and o.has(c) for o in chosen))
    return outermost, *(part.xreplace({outermost: share}) for part in after)


CHOICE, MOVED, TURNED = choice_and_after(LAW)


def values(matrix: sp.Matrix) -> list[mpmath.mpf]:
    return [mpmath.mpf(str(sp.N(component, 40))) for component in matrix]


# -- From the impulse to the law


def test_the_impulse_changes_momentum_and_angular_momentum() -> None:
    after = sp.Matrix(BEFORE) + impulse_response(BALL) * sp.Matrix(IMPULSE)
    equations = impulse_equations(BALL)
    put = dict(zip(AFTER, after, strict=True))
    assert [sp.simplify(e.subs(put)) for e in equations] == [0] * 6


def test_normal_and_tangential_motion_do_not_act_on_one_another() -> None:
    """So the normal impulse is (1 + e) |v_n| by Newton's, Poisson's and Stronge's restitution."""
    gain = 1 + 1 / inertia
    assert sp.simplify(slip_response(BALL) - sp.diag(gain, gain, 1)) == sp.zeros(3)
    assert sp.simplify(contact_velocity(sp.Matrix(BEFORE), BALL)[2] - BEFORE[2]) == 0


@pytest.mark.slow
def test_a_grip_leaves_the_slip_turned_about_by_the_tangential_restitution() -> None:
    grip = grip_share(BALL, tangential)
    assert sp.simplify(grip - AWAY * (1 + tangential)) == 0
    after = [part.subs(share, grip) for part in (MOVED, TURNED)]
    left = slip(*after) + tangential * slip(velocity, spin)
    assert all(vanishes(component) for component in left)


@pytest.mark.slow
def test_the_share_is_the_smaller_of_grip_and_what_coulomb_allows() -> None:
    """The share is the grip's for an infinite mu and zero for mu = 0, without a product of them."""
    grip, u = grip_share(BALL, tangential), slip(velocity, spin)
    zero, own, inner, none = CHOICE.args
    assert (zero, own, none) == (0, friction, 0)
    assert inner.func == IfLess
    assert inner.args[:2] == (friction, sp.oo)
    assert sp.expand(inner.args[3] - grip) == 0
    switch = inner.args[2]
    assert switch.func == IfAtMost
    stops, slides, gripped, slid = switch.args
    e = restitution / (1 - velocity.dot(normal) / falling)
    push = -friction * (1 + e) * velocity.dot(normal)
    assert vanishes(stops - grip**2 * u.dot(u))
    assert sp.simplify(slides - push**2) == 0
    assert sp.expand(gripped - grip) == 0
    assert vanishes(slid**2 * u.dot(u) - push**2)
    # Where the squares are equal both are the same: the law is continuous.
    assert sp.simplify(stops / gripped**2 - slides / slid**2) == 0


@pytest.mark.slow
def test_it_is_the_articles_law_where_every_contact_grips_and_nothing_falls() -> None:
    """mu is infinite, e_t = 0 and v0 infinite, given as numbers or as values of parameters."""
    article = impact(normal, velocity, spin, BALL, restitution)
    special = CoulombFriction("slipping", restitution).after(normal, velocity, spin, BALL)
    general = LAW.after(normal, velocity, spin, BALL)
    limits = {friction: sp.oo, tangential: 0, falling: sp.oo}
    put = [sp.Matrix([release(c).subs(limits) for c in part]) for part in general]
    for found in (special, put):
        for one, other in zip(found, article, strict=True):
            assert all(vanishes(component) for component in one - other)
    assert LAW.restitution_at(falling) == restitution / 2
    assert LAW.restitution_at(sp.Symbol("v")).subs(falling, sp.oo) == restitution


# -- What a contact keeps and loses, whatever its share


@pytest.mark.slow
def test_what_a_contact_keeps() -> None:
    """The spin about the normal, v_t + kappa R_B (w × n), and the slip's direction."""
    assert vanishes((TURNED - spin).dot(normal))
    kept = across(MOVED - velocity) + inertia * ball_radius * (TURNED - spin).cross(normal)
    assert all(vanishes(component) for component in kept)
    left = slip(MOVED, TURNED) - (1 - share / AWAY) * slip(velocity, spin)
    assert all(vanishes(component) for component in left)


def test_the_normal_velocity_is_restored_by_a_restitution_that_falls_with_it() -> None:
    approach = velocity.dot(normal)
    e = LAW.restitution_at(-approach)
    assert vanishes(MOVED.dot(normal) + e * approach)
    speed = sp.Symbol("v", positive=True)
    rebound = speed * release(LAW.restitution_at(speed))
    assert sp.simplify(sp.diff(rebound, speed)).is_positive


@pytest.mark.slow
def test_energy_never_rises_in_a_contact() -> None:
    """A contact takes (1 - e²) v_n²/2 and (kappa/(1 + kappa)) (1 - s²) |u|²/2, s what is left."""

    def energy(v: sp.Matrix, w: sp.Matrix) -> sp.Expr:
        return (v.dot(v) + inertia * ball_radius**2 * w.dot(w)) / 2

    approach, u = velocity.dot(normal), slip(velocity, spin)
    e, s = LAW.restitution_at(-approach), 1 - share / AWAY
    lost = (1 - e**2) * approach**2 / 2 + AWAY * (1 - s**2) * u.dot(u) / 2
    assert vanishes(energy(MOVED, TURNED) - energy(velocity, spin) + lost)
    # The share is from 0 to the grip's, and there s is from 1 to -e_t.
    grip = grip_share(BALL, tangential)
    assert s.subs(share, 0) == 1
    assert sp.simplify(s.subs(share, grip) + tangential) == 0
    assert sp.diff(s, share).is_negative


CHOICES = {
    "IfLess": lambda left, right, then, other: then if left < right else other,
    "IfAtMost": lambda left, right, then, other: then if left <= right else other,
}


@pytest.mark.slow
def test_errors_are_carried_by_the_derivative_of_the_branch_that_is_taken() -> None:
    """Infinities and zeros of the other one do not reach it."""
    inputs = (*VELOCITY, *SPIN, *NORMAL)
    law = (ball_radius, inertia, restitution, tangential, friction, falling)
    along = sp.symbols("d:9", real=True)
    tangents = dict(zip(inputs, along, strict=True))
    after = [c for part in LAW.after(normal, velocity, spin, BALL) for c in part]
    slopes = [release(directional(component, tangents)) for component in after]
    modules = [CHOICES, "mpmath"]
    there = sp.lambdify((*inputs, *law), [release(c) for c in after], modules)
    slope = sp.lambdify((*inputs, *along, *law), slopes, modules)
    with mpmath.workdps(60):
        third, step = mpmath.mpf(1) / 3, mpmath.mpf(10) ** -20
        place = [mpmath.mpf(c) for c in (-2, 0.5, -3, 30, -70, 11, third, 2 * third, 2 * third)]
        aside = [mpmath.mpf(k * k % 7 - 3) / 5 for k in range(9)]
        for mu, v0 in ((0.2, 30), (5, mpmath.inf), (0, 30), (mpmath.inf, 30)):
            own = [mpmath.mpf(c) for c in (0.125, 0.4, 0.7, 0.1, mu, v0)]
            sides = [
                there(*(c + way * step * d for c, d in zip(place, aside, strict=True)), *own)
                for way in (1, -1)
            ]
            for found, one, other in zip(slope(*place, *aside, *own), *sides, strict=True):
                assert abs(found - (one - other) / (2 * step)) < mpmath.mpf(10) ** -30


# -- Numbers


@pytest.mark.parametrize(
    ("place", "moving", "turning", "law", "expected"),
    [
        pytest.param(
            ("1", "0", "0"),
            ("-4.5", "0.3", "-4"),
            ("0", "18.849555921538759", "0"),
            CoulombFriction("slipping", sp.Rational("0.7"), sp.Rational("0.05")),
            {
                "share": "0.2198766231369419",
                "velocity": ("3.15", "0.234037013058917417", "-3.62323066160605562"),
                "spin": ("0", "23.5086986057177919", "0.815700580475052554"),
            },
            id="along an axis",
        ),
        pytest.param(
            ("1/3", "2/3", "2/3"),
            ("-2", "0.5", "-3"),
            ("30", "-70", "11"),
            CoulombFriction(
                "slipping", sp.Rational("0.65"), sp.Rational("0.25"), sp.Rational("0.2")
            ),
            {"share": "0.1016920222254215"},
            id="aslant",
        ),
    ],
)
def test_numbers_found_in_high_precision_elsewhere(
    place: tuple[str, ...],
    moving: tuple[str, ...],
    turning: tuple[str, ...],
    law: CoulombFriction,
    expected: dict[str, str | tuple[str, ...]],
) -> None:
    n, v, w = (sp.Matrix([sp.Rational(c) for c in m]) for m in (place, moving, turning))
    radius = sp.Rational("0.1213")
    after, spin_after = law.after(n, v, w, Ball(radius))
    before = v - v.dot(n) * n - radius * w.cross(n)
    left = release(v - after) - (1 + law.restitution) * v.dot(n) * n
    found = {
        "share": [sp.sqrt(release(left.dot(left)) / before.dot(before))],
        "velocity": release(after),
        "spin": release(spin_after),
    }
    for name, numbers in expected.items():
        wanted = [numbers] if isinstance(numbers, str) else numbers
        for one, other in zip(values(sp.Matrix(found[name])), wanted, strict=True):
            assert abs(one - mpmath.mpf(other)) <= 1e-15 * max(1, abs(mpmath.mpf(other)))


# -- The impact, followed over its impulse


@dataclass(frozen=True)
class Impacts:
    """Contacts, one in a row: unit normals, motions, radii, inertia, friction, restitution."""

    normal: NDArray[np.float64]
    velocity: NDArray[np.float64]
    spin: NDArray[np.float64]
    radius: NDArray[np.float64]
    inertia: NDArray[np.float64]
    friction: NDArray[np.float64]
    restitution: NDArray[np.float64]

    def slip(self, velocity: NDArray[np.float64], spin: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the velocity of the contact point across the normal."""
        point = velocity + np.cross(spin, -self.radius[:, None] * self.normal)
        return point - np.sum(point * self.normal, axis=1, keepdims=True) * self.normal

    def followed(self, steps: int) -> tuple[NDArray[np.float64], NDArray[np.float64], float]:
        """Return the motion after the impact and how far the slip has turned.

        Force per normal force: along the normal 1, against the slip mu; where the slip would turn
        about within a step, it stops, and stays so. The normal impulse ends where the work
        done in leaving is e² of that done in arriving (Stronge).
        """
        velocity, spin = self.velocity.copy(), self.spin.copy()
        first = self.slip(velocity, spin)
        arriving = -np.sum(velocity * self.normal, axis=1)
        # Work of the normal force, v_n dp with v_n' = 1: -v²/2 until it stands still, then e² v²/2.
        whole = arriving + np.sqrt(self.restitution**2 * arriving**2)
        step, turned = (whole / steps)[:, None], 0.0
        stopped = np.zeros(len(velocity), bool)
        for _ in range(steps):
            away, falling = self._falling(velocity, spin, stopped)
            reach = falling * step[:, 0]
            part = np.where(reach > away, away / np.where(reach > away, reach, 1.0), 1.0)[:, None]
            velocity, spin = self._step(velocity, spin, part * step, stopped)
            stopped |= reach > away
            velocity, spin = self._step(velocity, spin, (1.0 - part) * step, stopped)
            now = self.slip(velocity, spin)
            assert (np.linalg.norm(now, axis=1) <= away + 1e-13).all()
            turned = max(turned, float(np.abs(np.cross(first, now)).max()))
        return velocity, spin, turned

    def _falling(
        self,
        velocity: NDArray[np.float64],
        spin: NDArray[np.float64],
        stopped: NDArray[np.bool_],
    ) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Return the size of the slip, and how fast it falls."""
        slip, rate = self.slip(velocity, spin), self.slip(*self._rates(velocity, spin, stopped))
        size = np.linalg.norm(slip, axis=1)
        return size, -np.sum(slip * rate, axis=1) / np.where(size == 0.0, 1.0, size)

    def _rates(
        self,
        velocity: NDArray[np.float64],
        spin: NDArray[np.float64],
        stopped: NDArray[np.bool_],
    ) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Return what force and torque change by normal impulse."""
        slip = self.slip(velocity, spin)
        size = np.linalg.norm(slip, axis=1, keepdims=True)
        rubbing = np.where(stopped, 0.0, self.friction)[:, None] * -slip
        rubbing /= np.where(size == 0.0, 1.0, size)
        torque = np.cross(-self.radius[:, None] * self.normal, rubbing)
        return self.normal + rubbing, torque / (self.inertia * self.radius**2)[:, None]

    def _step(
        self,
        velocity: NDArray[np.float64],
        spin: NDArray[np.float64],
        step: NDArray[np.float64],
        stopped: NDArray[np.bool_],
    ) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Go a step by the rates at its middle, which a slip that stops at its end still has."""
        moving, turning = self._rates(velocity, spin, stopped)
        halfway = (velocity + step / 2 * moving, spin + step / 2 * turning)
        moving, turning = self._rates(*halfway, stopped)
        return velocity + step * moving, spin + step * turning


def test_the_impact_followed_over_its_impulse_ends_where_the_law_says() -> None:
    """The slip keeps its direction and falls until it stops: e_t = 0."""
    rng = np.random.default_rng(14)
    rows = trials(2000, at_least=500)
    n = rng.normal(size=(rows, 3))
    n /= np.linalg.norm(n, axis=1, keepdims=True)
    v = rng.normal(0, 4, (rows, 3))
    v -= (np.sum(v * n, axis=1) + rng.uniform(0.1, 6, rows))[:, None] * n
    given = Impacts(
        n,
        v,
        rng.normal(0, 25, (rows, 3)),
        rng.uniform(0.05, 0.2, rows),
        rng.choice([2 / 3, 2 / 5, 1.0, 1 / 64], rows),
        rng.choice([0.0, 0.05, 0.3, 0.8], rows),
        rng.uniform(0, 1, rows),
    )
    moved, turned, astray = given.followed(40)
    # Roundings of 80 steps of motions up to some 30 m/s.
    assert astray < 1e-11
    law = CoulombFriction("slipping", restitution, friction)
    symbols = (*VELOCITY, *SPIN, *NORMAL, ball_radius, inertia, friction, restitution)
    where = {
        "IfLess": lambda left, right, then, other: np.where(left < right, then, other),
        "IfAtMost": lambda left, right, then, other: np.where(left <= right, then, other),
    }
    said = [release(c) for part in law.after(normal, velocity, spin, BALL) for c in part]
    columns = (
        *v.T,
        *given.spin.T,
        *n.T,
        given.radius,
        given.inertia,
        given.friction,
        given.restitution,
    )
    found = np.stack(sp.lambdify(symbols, said, [where, "numpy"])(*columns), axis=1)
    np.testing.assert_allclose(found[:, :3], moved, rtol=0, atol=1e-11)
    radius = given.radius[:, None]
    np.testing.assert_allclose(found[:, 3:] * radius, turned * radius, rtol=0, atol=1e-11)
    left = np.linalg.norm(given.slip(found[:, :3], found[:, 3:]), axis=1)
    assert min(np.sum(left < 1e-12), np.sum(left > 1e-3)) > rows / 5  # both kinds


def test_the_article_leaves_nothing_undecided_and_neither_does_a_contact_that_always_grips() -> (
    None
):
    given = (normal, velocity, spin, BALL)
    assert NoSlip("rolling", restitution).undecided(*given) is None
    assert CoulombFriction("slipping", restitution).undecided(*given) is None
    assert CoulombFriction("slipping", restitution, sp.Integer(0)).undecided(*given) is None
    assert LAW.undecided(*given) is not None
