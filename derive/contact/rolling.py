"""The collision response (Eqs. 11-17): rolling without slip, and restitution along the normal.

The ball is a thin shell, I = (2/3) m R_B². The 6×6 system of Eq. 17 is built here from the
impulse-momentum, rolling and restitution equations, not typed in.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import sympy as sp

from ..ground.choice import hold, hold_all
from .law import Law

INERTIA_FACTOR = sp.Rational(2, 3)
"""I / (m R_B²) of a thin shell."""

BEFORE = sp.symbols("v1 v2 v3 w1 w2 w3", real=True)
"""Velocity and spin before the contact, contact-frame components."""

AFTER = sp.symbols("v1_after v2_after v3_after w1_after w2_after w3_after", real=True)
"""The same after it: the unknowns u+ of Eq. 17."""


def impact_equations(ball_radius: sp.Expr, restitution: sp.Expr) -> list[sp.Expr]:
    """Return the six equations of Eqs. 15 and 16, each an expression that is zero.

    They follow from Eq. 11 (linear impulse), Eq. 12 (angular impulse about the centre, with
    r = -R_B n3), Eq. 13 (velocity of the contact point) and Eq. 14 (no slip, restitution); the
    tangential impulse and the mass are eliminated.
    """
    v_before, w_before = sp.Matrix(BEFORE[:3]), sp.Matrix(BEFORE[3:])
    v_after, w_after = sp.Matrix(AFTER[:3]), sp.Matrix(AFTER[3:])
    n3 = sp.Matrix([0, 0, 1])
    arm = -ball_radius * n3
    contact_after = v_after + w_after.cross(arm)
    rolling_and_restitution = [
        contact_after[0],
        contact_after[1],
        v_after[2] + restitution * v_before[2],
    ]
    # Per unit mass: impulse = v+ - v- (Eq. 11); r × impulse = (I/m) (w+ - w-) (Eq. 12).
    angular = arm.cross(v_after - v_before) - INERTIA_FACTOR * ball_radius**2 * (w_after - w_before)
    return rolling_and_restitution + [sp.expand(component / ball_radius) for component in angular]


def impact_system(ball_radius: sp.Expr, restitution: sp.Expr) -> tuple[sp.Matrix, sp.Matrix]:
    """Return A (6, 6) and b (6,) of Eq. 17: A u+ = b(u-)."""
    matrix, right = sp.linear_eq_to_matrix(impact_equations(ball_radius, restitution), AFTER)
    return matrix, right


@cache
def impact_inverse(ball_radius: sp.Expr) -> sp.Matrix:
    """Return the closed-form inverse of A of Eq. 17; it does not depend on the restitution."""
    matrix, _ = impact_system(ball_radius, sp.Symbol("restitution"))
    return sp.simplify(matrix.inv())


def impact_through_frame(
    frame: sp.Matrix,
    velocity: sp.Matrix,
    spin: sp.Matrix,
    ball_radius: sp.Expr,
    restitution: sp.Expr,
) -> tuple[sp.Matrix, sp.Matrix]:
    """Return velocity and spin after the contact: into the frame, Eq. 17, and back (Eq. 10)."""
    _, right = impact_system(ball_radius, restitution)
    into = list(frame.T * velocity) + list(frame.T * spin)
    solution = impact_inverse(ball_radius) * right
    solution = solution.subs(dict(zip(BEFORE, into, strict=True)), simultaneous=True)
    return frame * solution[:3, :], frame * solution[3:, :]


def impact(
    normal: sp.Matrix,
    velocity: sp.Matrix,
    spin: sp.Matrix,
    ball_radius: sp.Expr,
    restitution: sp.Expr,
) -> tuple[sp.Matrix, sp.Matrix]:
    """Return velocity and spin after the contact without a frame.

    v_t+ = (3 v_t + 2 R_B (w × n)) / 5,  v_n+ = -e v_n,  w+ = (n × v_t+) / R_B + (w·n) n.
    The tangential law is isotropic, so the choice of n1 cancels from Eq. 17.
    """
    approach = hold(velocity.dot(normal))
    tangential = hold_all(velocity - approach * normal)
    across = hold_all(spin.cross(normal))
    rolling = hold_all((3 * tangential + 2 * ball_radius * across) / 5)
    after = rolling - restitution * approach * normal
    turning = hold_all(normal.cross(rolling))
    spin_after = turning * hold(1 / ball_radius) + hold(spin.dot(normal)) * normal
    return after, spin_after


@dataclass(frozen=True)
class Rolling(Law):
    """The article's law: the ball leaves rolling, with one restitution for all speeds."""

    restitution: sp.Expr

    def restitution_at(self, speed: sp.Expr) -> sp.Expr:
        """Return the same at every speed."""
        return self.restitution

    def after(
        self, normal: sp.Matrix, velocity: sp.Matrix, spin: sp.Matrix, ball_radius: sp.Expr
    ) -> tuple[sp.Matrix, sp.Matrix]:
        """Return Eq. 17 with the frame eliminated."""
        return impact(normal, velocity, spin, ball_radius, self.restitution)
