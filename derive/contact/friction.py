"""Impact with Coulomb friction: the contact point grips, or slips.

The law is derived here from Eqs. 11 and 12 (momentum, and angular momentum about the centre) and
Coulomb's law, not typed in. While the surfaces touch, friction pushes against the slip with mu
times the normal force; the slip keeps its direction and falls in proportion to the normal impulse.
If it stops before the normal impulse is spent, the contact grips, and the slip after it is -e_t
times the slip before. Normal and tangential motion do not act on one another, so Newton's,
Poisson's and Stronge's restitution are the same. With mu infinite and e_t = 0 this is the article's
law (`no_slip.py`).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import ClassVar

import sympy as sp

from ..symbolic.conditionals import (
    IfAtMost,
    IfLess,
    Less,
    Not,
    absolute,
    all_of,
    barrier,
    barrier_all,
    minimum,
)
from ..symbolic.error_terms import DECISION_FACTOR, before_impact
from ..symbolic.symbols import UNIT_ROUNDOFF
from .ball import Ball
from .law import Law
from .no_slip import AFTER, BEFORE

IMPULSE = sp.symbols("p1 p2 p3", real=True)
"""Impulse of the surface on the ball, per unit mass, contact-frame components."""


def impulse_equations(ball: Ball) -> list[sp.Expr]:
    """Return Eqs. 11 and 12 per unit mass, each component an expression that is zero.

    The impulse acts at the contact point, r = -R_B n3 from the centre.
    """
    impulse, arm = sp.Matrix(IMPULSE), sp.Matrix([0, 0, -ball.radius])
    moved = sp.Matrix(AFTER[:3]) - sp.Matrix(BEFORE[:3])
    turned = sp.Matrix(AFTER[3:]) - sp.Matrix(BEFORE[3:])
    return [*(moved - impulse), *(ball.inertia * ball.radius**2 * turned - arm.cross(impulse))]


@cache
def impulse_response(ball: Ball) -> sp.Matrix:
    """Return the change of velocity and spin by a unit of impulse, a matrix (6, 3)."""
    after = sp.solve(impulse_equations(ball), AFTER, dict=True)[0]
    return sp.Matrix([after[symbol] for symbol in AFTER]).jacobian(sp.Matrix(IMPULSE))


def contact_velocity(motion: sp.Matrix, ball: Ball) -> sp.Matrix:
    """Return the velocity of the contact point (Eq. 13) of a motion (6,) in the contact frame.

    Parameters
    ----------
    motion
        The velocity of the ball's centre, then its angular velocity, in the contact frame.
    ball
        The radius and the inertia of the ball.

    Returns
    -------
    Matrix
        (3,); along the surface it is the slip.
    """
    velocity, spin = motion[:3, :], motion[3:, :]
    return velocity + spin.cross(sp.Matrix([0, 0, -ball.radius]))


@cache
def slip_response(ball: Ball) -> sp.Matrix:
    """Return the change of the contact point's velocity by a unit of impulse, diagonal, (3, 3)."""
    columns = [contact_velocity(impulse_response(ball).col(k), ball) for k in range(3)]
    return sp.simplify(sp.Matrix.hstack(*columns))


def grip_share(ball: Ball, tangential: sp.Expr) -> sp.Expr:
    """Return the share of the slip that a contact which grips takes from the velocity.

    The impulse is -share times the slip u, after which the slip is -e_t u.

    Parameters
    ----------
    ball
        The radius and the inertia of the ball.
    tangential
        e_t, the coefficient of restitution along the surface.
    """
    share = sp.Symbol("share", real=True)
    left = 1 - slip_response(ball)[0, 0] * share
    return sp.factor(sp.solve(left + tangential, share)[0])


def energy_change(
    ball: Ball, impulse: sp.Expr, slip: sp.Expr, speed: sp.Expr, restitution: sp.Expr
) -> sp.Expr:
    """Return the change of the kinetic energy per unit mass by a contact.

    Parameters
    ----------
    ball
        The ball.
    impulse
        Impulse of friction against the slip, per unit mass.
    slip, speed
        Speed of the contact point along the surface, and speed of approach, before the contact; not
        negative.
    restitution
        Restitution of the contact.
    """
    before = sp.Matrix(BEFORE).subs({BEFORE[1]: 0, BEFORE[2]: -speed, BEFORE[4]: 0})
    before = before.subs(BEFORE[0], slip)
    pushed = sp.Matrix([-impulse, 0, (1 + restitution) * speed])
    after = before + impulse_response(ball) * pushed

    def energy(motion: sp.Matrix) -> sp.Expr:
        v, w = motion[:3, :], motion[3:, :]
        return (v.dot(v) + ball.inertia * ball.radius**2 * w.dot(w)) / 2

    return sp.expand(energy(after) - energy(before))


@dataclass(frozen=True)
class CoulombFriction(Law):
    """Coulomb's law of friction, with tangential restitution and restitution that falls with speed.

    Attributes
    ----------
    restitution
        Restitution of a contact without speed, e0.
    friction
        Coulomb's mu; infinite: every contact grips.
    tangential
        e_t: the slip after a contact that grips is -e_t times the slip before.
    falling
        v0, the normal speed at which the restitution is e0/2; infinite: it does not fall.
    """

    restitution: sp.Expr
    friction: sp.Expr = sp.oo
    tangential: sp.Expr = sp.Integer(0)
    falling: sp.Expr = sp.oo

    source: ClassVar[str] = "momentum, angular momentum and Coulomb's law of friction"
    description: ClassVar[str] = "the contact with friction"

    @property
    def friction_coefficient(self) -> sp.Expr:
        """Coulomb's mu."""
        return self.friction

    @property
    def decides(self) -> bool:
        """True if a contact may grip or slip: mu is neither 0 nor infinite for every ball."""
        return self.friction not in (0, sp.oo)

    def friction_impulse(self, ball: Ball, slip: sp.Expr, speed: sp.Expr) -> sp.Expr:
        """Return lambda, the impulse of friction against the slip, per unit mass.

        It is the smaller of the impulse that stops the slip and turns it about by e_t, and of mu
        times the normal impulse. `after` uses it as a share of the slip.

        Parameters
        ----------
        ball, slip, speed
            As for `energy_change`.
        """
        grip = grip_share(ball, self.tangential) * slip
        return minimum(grip, self.friction * barrier(1 + self.restitution_at(speed)) * speed)

    def restitution_at(self, speed: sp.Expr) -> sp.Expr:
        """Return e0 / (1 + v/v0)."""
        return self.restitution / barrier(1 + speed / self.falling)

    def after(
        self, normal: sp.Matrix, velocity: sp.Matrix, spin: sp.Matrix, ball: Ball
    ) -> tuple[sp.Matrix, sp.Matrix]:
        """Return velocity and spin: v - share u - (1 + e) v_n n, and the spin that goes with it."""
        met = self._before(normal, velocity, spin, ball)
        share = barrier(self._share(met))
        moved = barrier_all(met.tangential - share * met.slip)
        after = moved - met.restitution * met.approach * normal
        # A unit of impulse along n1 turns the ball about n2 = n3 × n1.
        turning = barrier(-impulse_response(ball)[4, 0] * share)
        return after, spin + turning * barrier_all(normal.cross(met.slip))

    def undecided(
        self, normal: sp.Matrix, velocity: sp.Matrix, spin: sp.Matrix, ball: Ball
    ) -> sp.Basic | None:
        """Return the condition that the true contact may slip where the computed grips, or reverse.

        The error of the slip is at most twice the root of three times that of its parts. The error
        of the normal impulse (1 + e) |v_n| is at most twice that of v_n.
        """
        if not self.decides:
            return None
        met = self._before(normal, velocity, spin, ball)
        speed, error = before_impact(ball.radius)
        off = barrier(4 * DECISION_FACTOR * barrier(error + 4 * UNIT_ROUNDOFF * speed))
        difference = absolute(barrier(met.grip * sp.sqrt(met.squared)) - met.slide)
        undecided = Not(Less(barrier(met.grip + 2 * self.friction) * off, difference))
        return all_of(Less(0, self.friction), Less(self.friction, sp.oo), undecided)

    def grip_margin(
        self, normal: sp.Matrix, velocity: sp.Matrix, spin: sp.Matrix, ball: Ball
    ) -> sp.Expr | None:
        """Return the impulse that friction can give less the one that stops the slip, per mass.

        With a mu of 0 or infinity nothing is decided; the margin is then a constant, 1 m/s.
        """
        if not self.decides:
            return None
        met = self._before(normal, velocity, spin, ball)
        margin = met.slide - barrier(met.grip * sp.sqrt(met.squared))
        one = sp.Integer(1)
        return IfLess(0, self.friction, IfLess(self.friction, sp.oo, margin, one), one)

    def slip(self, normal: sp.Matrix, velocity: sp.Matrix, spin: sp.Matrix, ball: Ball) -> Slip:
        """Return the slip of a contact that may grip or slip.

        Parameters
        ----------
        normal, velocity, spin, ball
            As for `after`.
        """
        met = self._before(normal, velocity, spin, ball)
        speed = barrier(sp.sqrt(met.squared))
        per_speed = barrier(1 / speed)
        direction = (IfLess(0, speed, one * per_speed, 0) for one in met.slip)
        margin = self.grip_margin(normal, velocity, spin, ball)
        return Slip(barrier(self._share(met)), margin, speed, tuple(direction))

    def _share(self, met: _ContactMotion) -> sp.Expr:
        """Return the share of the slip that is taken from the velocity.

        An infinite mu is a case of its own, since without normal speed it would be multiplied by
        zero; so is 0, with which nothing is undecided. Squares are compared: a ball that contains
        zero has no root.
        """
        stops = barrier(met.grip**2) * met.squared
        either = IfAtMost(stops, barrier(met.slide**2), met.grip, met.slide / sp.sqrt(met.squared))
        return IfLess(0, self.friction, IfLess(self.friction, sp.oo, either, met.grip), 0)

    def _before(
        self, normal: sp.Matrix, velocity: sp.Matrix, spin: sp.Matrix, ball: Ball
    ) -> _ContactMotion:
        approach = barrier(velocity.dot(normal))
        tangential = barrier_all(velocity - approach * normal)
        slip = barrier_all(tangential - ball.radius * barrier_all(spin.cross(normal)))
        restitution = barrier(self.restitution_at(-approach))
        slide = sp.Integer(0)
        if self.friction != sp.oo:
            slide = barrier(-self.friction * barrier((1 + restitution) * approach))
        return _ContactMotion(
            approach,
            tangential,
            slip,
            barrier(slip.dot(slip)),
            restitution,
            barrier(grip_share(ball, self.tangential)),
            slide,
        )


@dataclass(frozen=True)
class Slip:
    """The slip of a contact before its impulse.

    Attributes
    ----------
    share
        The share of it that friction takes.
    margin
        By how much the contact grips, m/s; negative: it slips.
    speed
        Its size, m/s.
    direction
        Its direction, (3,); zero without slip.
    """

    share: sp.Expr
    margin: sp.Expr
    speed: sp.Expr
    direction: tuple[sp.Expr, ...]


@dataclass(frozen=True)
class _ContactMotion:
    """The motion at a contact before its impulse.

    Attributes
    ----------
    approach, tangential
        The velocity along the normal, not positive, and the velocity across it.
    slip, squared
        The velocity of the contact point, and the square of its size.
    restitution
        Restitution at that speed.
    grip
        Share of the slip that is taken if it stops.
    slide
        Impulse per unit mass of a contact that slips to its end: mu (1 + e) |v_n|.
    """

    approach: sp.Expr
    tangential: sp.Matrix
    slip: sp.Matrix
    squared: sp.Expr
    restitution: sp.Expr
    grip: sp.Expr
    slide: sp.Expr
