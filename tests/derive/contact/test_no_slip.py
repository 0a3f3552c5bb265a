"""The contact, Eqs. 7-17, proved for every unit normal: frame, system, frame-free form, energy."""

from __future__ import annotations

from fractions import Fraction
from itertools import permutations

import pytest
import sympy as sp
from hoopgen.derive.contact.ball import THIN_SHELL, Ball
from hoopgen.derive.contact.frame import contact_frame, frame_from_axis
from hoopgen.derive.contact.no_slip import (
    AFTER,
    BEFORE,
    impact,
    impact_equations,
    impact_inverse,
    impact_system,
    impact_through_frame,
)
from hoopgen.derive.symbolic.conditionals import Barrier, barrier, barrier_all, maximum, release
from hoopgen.derive.symbolic.symbols import NORMAL, normal, spin, velocity

AXES = pytest.mark.parametrize("axis", [0, 1, 2], ids="xyz")
ball_radius, inertia = sp.symbols("ball_radius inertia", positive=True)
BALL = Ball(ball_radius, inertia)
restitution = sp.Symbol("restitution", nonnegative=True)
root = sp.Symbol("root", positive=True)
SPHERE = normal.dot(normal) - 1


def vanishes(expression: sp.Expr, axis: int = 0) -> bool:
    """Return True if the expression is zero for every unit normal that is not along `axis`.

    It must be rational in the normal and in the length sqrt(1 - n_axis²) of Eq. 8. Its numerator is
    reduced by n·n - 1 and root² - (1 - n_axis²), whose leading terms nz² and root² have no common
    factor: they are a Gröbner basis, so the remainder is zero just if the numerator is.
    """
    length_squared = 1 - NORMAL[axis] ** 2
    rational = release(expression).replace(
        lambda e: e.is_Pow and e.base == length_squared, lambda e: root ** (2 * e.exp)
    )
    numerator, _ = sp.fraction(sp.together(rational))
    _, remainder = sp.reduced(
        sp.expand(numerator), [root**2 - length_squared, SPHERE], root, *reversed(NORMAL)
    )
    return bool(remainder == 0)


def tangential(vector: sp.Matrix) -> sp.Matrix:
    """Return the part of the vector in the tangent plane."""
    return vector - vector.dot(normal) * normal


# -- The frame, Eqs. 7-10


@AXES
def test_the_contact_frame_is_orthonormal_for_every_unit_normal(axis: int) -> None:
    frame = frame_from_axis(normal, axis)
    assert all(vanishes(entry, axis) for entry in frame.T * frame - sp.eye(3))


@AXES
def test_the_contact_frame_is_right_handed_for_every_unit_normal(axis: int) -> None:
    n1, n2, n3 = (frame_from_axis(normal, axis).col(j) for j in range(3))
    assert n3 == normal
    assert vanishes(n1.dot(n2.cross(n3)) - 1, axis)


@AXES
def test_n1_is_the_axis_less_its_normal_part_over_its_length(axis: int) -> None:
    unit = sp.eye(3).col(axis)
    part = unit - normal.dot(unit) * normal
    assert vanishes(part.dot(part) - (1 - NORMAL[axis] ** 2), axis)
    n1 = frame_from_axis(normal, axis).col(0)
    assert all(vanishes(e, axis) for e in n1 * sp.sqrt(1 - NORMAL[axis] ** 2) - part)


# Comparisons of the three squares are all that the choice depends on: one normal for each of their
# thirteen weak orders is every case there is.
ORDERS = {
    "all equal": (sp.sqrt(3) / 3,) * 3,
    "two smallest equal": (sp.Rational(4, 9), sp.Rational(4, 9), sp.Rational(7, 9)),
    "two largest equal": (sp.Rational(1, 3), sp.Rational(2, 3), sp.Rational(2, 3)),
    "all different": (sp.Rational(2, 7), sp.Rational(3, 7), sp.Rational(6, 7)),
    "along an axis": (sp.Integer(0), sp.Integer(0), sp.Integer(1)),
    "in a coordinate plane": (sp.Integer(0), sp.Rational(3, 5), sp.Rational(4, 5)),
}


@pytest.mark.slow
@pytest.mark.parametrize("sizes", ORDERS.values(), ids=list(ORDERS))
def test_the_mended_eq_7_takes_the_axis_of_the_smallest_component(sizes: tuple[sp.Expr]) -> None:
    mended = contact_frame()
    for components in set(permutations(sizes)):
        smallest = min(range(3), key=lambda i: components[i])
        for signs in ((1, 1, 1), (-1, 1, -1), (1, -1, -1)):
            values = [s * c for s, c in zip(signs, components, strict=True)]
            frame = mended.subs(dict(zip(NORMAL, values, strict=True)), simultaneous=True)
            expected = frame_from_axis(sp.Matrix(values), smallest)
            assert sp.simplify(frame - expected) == sp.zeros(3)


@AXES
def test_along_an_axis_the_frame_is_finite_and_the_articles_choice_is_0_over_0(axis: int) -> None:
    n3 = sp.eye(3).col(axis)
    frame = contact_frame().subs(dict(zip(NORMAL, n3, strict=True)), simultaneous=True)
    assert frame.T * frame == sp.eye(3)
    assert frame.det() == 1
    article = frame_from_axis(normal, max(range(3), key=lambda i: abs(n3[i])))
    assert article.subs(dict(zip(NORMAL, n3, strict=True)), simultaneous=True).has(sp.nan)


# -- The system, Eqs. 11-17


def test_the_six_equations_are_the_system_of_eq_17() -> None:
    """The last row is w3+ = w3- as the impulse gives it, times -kappa R_B."""
    r = ball_radius
    v1, v2, v3, w1, w2, w3 = BEFORE
    article = sp.Matrix(
        [
            [1, 0, 0, 0, -r, 0],
            [0, 1, 0, r, 0, 0],
            [0, 0, 1, 0, 0, 0],
            [0, 1, 0, -inertia * r, 0, 0],
            [-1, 0, 0, 0, -inertia * r, 0],
            [0, 0, 0, 0, 0, 1],
        ]
    )
    right = sp.Matrix([0, 0, -restitution * v3, v2 - inertia * r * w1, -v1 - inertia * r * w2, w3])
    scale = sp.diag(1, 1, 1, 1, 1, -inertia * r)
    matrix, vector = impact_system(BALL, restitution)
    assert matrix == scale * article
    assert sp.expand(vector - scale * right) == sp.zeros(6, 1)


def test_the_equations_are_the_impulses_eliminated_from_eqs_11_to_14() -> None:
    """A tangential impulse J at the contact point satisfies Eqs. 11 and 12 with their solution."""
    _, right = impact_system(BALL, restitution)
    after = impact_inverse(BALL) * right
    v, w = sp.Matrix(BEFORE[:3]), sp.Matrix(BEFORE[3:])
    impulse = after[:3, :] - v
    arm = sp.Matrix([0, 0, -ball_radius])
    turned = inertia * ball_radius**2 * (after[3:, :] - w)
    assert sp.simplify(arm.cross(impulse) - turned) == sp.zeros(3, 1)
    contact_velocity = sp.simplify(after[:3, :] + after[3:, :].cross(arm))
    assert contact_velocity == sp.Matrix([0, 0, -restitution * BEFORE[2]])


def test_the_closed_form_inverse_is_the_inverse_of_eq_17() -> None:
    matrix, _ = impact_system(BALL, restitution)
    inverse = impact_inverse(BALL)
    assert sp.simplify(matrix * inverse) == sp.eye(6)
    assert sp.simplify(inverse * matrix) == sp.eye(6)


def test_eq_17_has_one_solution_and_it_satisfies_the_six_equations() -> None:
    matrix, right = impact_system(BALL, restitution)
    assert sp.factor(matrix.det()) != 0
    after = dict(zip(AFTER, impact_inverse(BALL) * right, strict=True))
    equations = impact_equations(BALL, restitution)
    assert [sp.simplify(e.subs(after)) for e in equations] == [0] * 6


@pytest.mark.sampled(1)
@AXES
def test_eq_17_through_the_frame_is_the_frame_free_form_whatever_the_axis(axis: int) -> None:
    frame = frame_from_axis(normal, axis)
    through = impact_through_frame(frame, velocity, spin, BALL, restitution)
    free = impact(normal, velocity, spin, BALL, restitution)
    for one, other in zip(through, free, strict=True):
        assert all(vanishes(component, axis) for component in one - other)


def test_turning_n1_about_the_normal_changes_nothing() -> None:
    """The tangential law is isotropic; with the axes' frames that is every contact frame."""
    c, s = sp.symbols("c s", real=True)
    turn = sp.Matrix([[c, -s, 0], [s, c, 0], [0, 0, 1]])
    v, w = sp.Matrix(BEFORE[:3]), sp.Matrix(BEFORE[3:])
    turned = impact_through_frame(turn, v, w, BALL, restitution)
    plain = impact_through_frame(sp.eye(3), v, w, BALL, restitution)
    for one, other in zip(turned, plain, strict=True):
        difference = sp.expand((one - other).applyfunc(lambda e: sp.expand(e).subs(s**2, 1 - c**2)))
        assert difference == sp.zeros(3, 1)


# -- What a contact keeps and loses


def test_the_frame_free_form_is_that_of_the_model() -> None:
    shell = Ball(ball_radius, THIN_SHELL)
    after, spin_after = impact(normal, velocity, spin, shell, restitution)
    rolling = (3 * tangential(velocity) + 2 * ball_radius * spin.cross(normal)) / 5
    expected = rolling - restitution * velocity.dot(normal) * normal
    expected_spin = normal.cross(rolling) / ball_radius + spin.dot(normal) * normal
    assert sp.expand(release(after) - expected) == sp.zeros(3, 1)
    assert sp.expand(release(spin_after) - expected_spin) == sp.zeros(3, 1)


@pytest.mark.slow
def test_a_contact_ends_in_rolling_with_the_normal_velocity_restored() -> None:
    after, spin_after = map(release, impact(normal, velocity, spin, BALL, restitution))
    contact_velocity = after + spin_after.cross(-ball_radius * normal)
    assert all(vanishes(component) for component in tangential(contact_velocity))
    assert vanishes(after.dot(normal) + restitution * velocity.dot(normal))


def test_energy_never_rises_in_a_contact() -> None:
    """Per unit mass it takes kappa/(1 + kappa) |slip|²/2 + (1 - e²) (v·n)²/2 >= 0."""

    def energy(v: sp.Matrix, w: sp.Matrix) -> sp.Expr:
        return (v.dot(v) + inertia * ball_radius**2 * w.dot(w)) / 2

    after = map(release, impact(normal, velocity, spin, BALL, restitution))
    slip = tangential(velocity + spin.cross(-ball_radius * normal))
    lost = (
        inertia / (1 + inertia) * slip.dot(slip) / 2
        + (1 - restitution**2) * velocity.dot(normal) ** 2 / 2
    )
    assert vanishes(energy(*after) - energy(velocity, spin) + lost)


def test_angular_momentum_about_the_contact_point_is_kept() -> None:
    after, spin_after = map(release, impact(normal, velocity, spin, BALL, restitution))
    turned = inertia * ball_radius**2 * (spin_after - spin)
    moved = (ball_radius * normal).cross(after - velocity)
    assert all(vanishes(component) for component in turned + moved)


@pytest.mark.slow
def test_a_second_contact_at_once_changes_the_normal_velocity_only() -> None:
    once = [release(m) for m in impact(normal, velocity, spin, BALL, restitution)]
    twice = [release(m) for m in impact(normal, *once, BALL, restitution)]
    assert all(vanishes(e) for e in tangential(twice[0] - once[0]))
    assert all(vanishes(e) for e in twice[1] - once[1])


# -- Held quantities


def test_release_removes_every_held_quantity_and_keeps_the_value() -> None:
    a, b = sp.symbols("a b", real=True)
    inner = barrier(a + b)
    nested = barrier(barrier(inner * 2 + a) - maximum(barrier(a - b), 0)) ** 2
    assert nested.has(Barrier)
    free = release(nested)
    assert not free.has(Barrier)
    for values in ({a: 3, b: Fraction(1, 2)}, {a: -1, b: 4}):
        exact = {k: sp.Rational(v) for k, v in values.items()}
        assert free.subs(exact) == release(nested.subs(exact))
    assert release(barrier_all(sp.Matrix([a + b, a * b]))) == sp.Matrix([a + b, a * b])
    assert not any(release(m).has(Barrier) for m in impact(normal, velocity, spin, Ball(a), b))
