"""The article's impact (Eqs. 11-17): rolling without slip, and restitution along the normal.

The article's ball is a thin shell, I = (2/3) m R_B²; here I is kappa m R_B². The 6×6 system of
Eq. 17 is derived here from the impulse-momentum, rolling and restitution equations, not typed in.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import sympy as sp

from ..symbolic.conditionals import barrier, barrier_all
from .ball import Ball
from .law import Law

BEFORE = sp.symbols("v1 v2 v3 w1 w2 w3", real=True)
"""Velocity and spin before the contact, contact-frame components."""

AFTER = sp.symbols("v1_after v2_after v3_after w1_after w2_after w3_after", real=True)
"""Velocity and spin after the contact: the unknowns u+ of Eq. 17."""


def impact_equations(ball: Ball, restitution: sp.Expr) -> list[sp.Expr]:
    """Return the six equations of Eqs. 15 and 16, each an expression that is zero.

    They follow from Eq. 11 (linear impulse), Eq. 12 (angular impulse about the centre, with
    r = -R_B n3), Eq. 13 (velocity of the contact point) and Eq. 14 (no slip, restitution) by
    eliminating the tangential impulse and the mass.

    Parameters
    ----------
    ball
        The radius and the inertia of the ball.
    restitution
        e of the normal velocity.
    """
    v_before, w_before = sp.Matrix(BEFORE[:3]), sp.Matrix(BEFORE[3:])
    v_after, w_after = sp.Matrix(AFTER[:3]), sp.Matrix(AFTER[3:])
    n3 = sp.Matrix([0, 0, 1])
    arm = -ball.radius * n3
    contact_after = v_after + w_after.cross(arm)
    rolling_and_restitution = [
        contact_after[0],
        contact_after[1],
        v_after[2] + restitution * v_before[2],
    ]
    # Per unit mass: impulse = v+ - v- (Eq. 11); r × impulse = (I/m) (w+ - w-) (Eq. 12).
    turned = ball.inertia * ball.radius**2 * (w_after - w_before)
    angular = arm.cross(v_after - v_before) - turned
    return rolling_and_restitution + [sp.expand(component / ball.radius) for component in angular]


def impact_system(ball: Ball, restitution: sp.Expr) -> tuple[sp.Matrix, sp.Matrix]:
    """Return A (6, 6) and b (6,) of Eq. 17: A u+ = b(u-).

    Parameters
    ----------
    ball
        The radius and the inertia of the ball.
    restitution
        e, along the normal.
    """
    matrix, right = sp.linear_eq_to_matrix(impact_equations(ball, restitution), AFTER)
    return matrix, right


@cache
def impact_inverse(ball: Ball) -> sp.Matrix:
    """Return the closed-form inverse of A of Eq. 17; it does not depend on the restitution."""
    matrix, _ = impact_system(ball, sp.Symbol("restitution"))
    return sp.simplify(matrix.inv())


def impact_through_frame(
    frame: sp.Matrix,
    velocity: sp.Matrix,
    spin: sp.Matrix,
    ball: Ball,
    restitution: sp.Expr,
) -> tuple[sp.Matrix, sp.Matrix]:
    """Return velocity and spin after the contact: into the frame, Eq. 17, and back (Eq. 10).

    Parameters
    ----------
    frame
        R = [n1 n2 n3], (3, 3), as of `frame_from_axis`.
    velocity, spin
        Before the contact, (3,) each.
    ball, restitution
        As for `impact_equations`.

    Returns
    -------
    tuple
        Velocity and spin, (3,) each.
    """
    _, right = impact_system(ball, restitution)
    into = list(frame.T * velocity) + list(frame.T * spin)
    solution = impact_inverse(ball) * right
    solution = solution.subs(dict(zip(BEFORE, into, strict=True)), simultaneous=True)
    return frame * solution[:3, :], frame * solution[3:, :]


def impact(
    normal: sp.Matrix,
    velocity: sp.Matrix,
    spin: sp.Matrix,
    ball: Ball,
    restitution: sp.Expr,
) -> tuple[sp.Matrix, sp.Matrix]:
    """Return velocity and spin after the contact without a frame.

    v_t+ = (v_t + kappa R_B (w × n)) / (1 + kappa),  v_n+ = -e v_n,
    w+ = (n × v_t+) / R_B + (w·n) n.

    The tangential law is isotropic, so the choice of n1 cancels from Eq. 17.

    Parameters
    ----------
    normal
        The outward unit normal, (3,).
    velocity, spin, ball, restitution
        As for `impact_through_frame`.

    Returns
    -------
    tuple
        Velocity and spin, (3,) each.
    """
    approach = barrier(velocity.dot(normal))
    tangential = barrier_all(velocity - approach * normal)
    across = barrier_all(spin.cross(normal))
    spun = ball.friction_share * ball.radius * across
    rolling = barrier_all(ball.moving_share * tangential + spun)
    after = rolling - restitution * approach * normal
    turning = barrier_all(normal.cross(rolling))
    spin_after = turning * barrier(1 / ball.radius) + barrier(spin.dot(normal)) * normal
    return after, spin_after


@dataclass(frozen=True)
class NoSlip(Law):
    """The article's law: the ball leaves rolling, with one restitution for all speeds."""

    restitution: sp.Expr

    def restitution_at(self, speed: sp.Expr) -> sp.Expr:
        """Return the restitution, the same at every speed."""
        return self.restitution

    def after(
        self, normal: sp.Matrix, velocity: sp.Matrix, spin: sp.Matrix, ball: Ball
    ) -> tuple[sp.Matrix, sp.Matrix]:
        """Return the solution of Eq. 17 with the frame eliminated."""
        return impact(normal, velocity, spin, ball, self.restitution)
