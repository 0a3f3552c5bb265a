"""The collision response with Coulomb friction: the contact point grips, or slips.

Found here from Eqs. 11 and 12 (momentum, and angular momentum about the centre) and Coulomb's law,
not typed in. While the surfaces touch, friction pushes against the slip, with mu times what the
normal force pushes, and the slip keeps its direction and falls in step with the normal impulse. If
it stops before the normal impulse is spent, the contact grips and leaves it at -e_t times what it
was. Normal and tangential motion do not act on one another, so Newton's, Poisson's and Stronge's
restitution are the same. With mu infinite and e_t = 0 this is the article's law (`rolling.py`).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import ClassVar

import sympy as sp

from ..errors.tangent import GUARD, before_impact
from ..ground.choice import IfAtMost, IfLess, Less, Not, every, hold, hold_all, size, smallest
from ..ground.symbols import UNIT_ROUNDOFF
from .law import Law
from .rolling import AFTER, BEFORE, INERTIA_FACTOR

IMPULSE = sp.symbols("p1 p2 p3", real=True)
"""Of the surface on the ball, per unit mass, contact-frame components."""


def impulse_equations(ball_radius: sp.Expr) -> list[sp.Expr]:
    """Return Eqs. 11 and 12 per unit mass, each component an expression that is zero.

    The impulse acts at the contact point, r = -R_B n3 from the centre.
    """
    impulse, arm = sp.Matrix(IMPULSE), sp.Matrix([0, 0, -ball_radius])
    moved = sp.Matrix(AFTER[:3]) - sp.Matrix(BEFORE[:3])
    turned = sp.Matrix(AFTER[3:]) - sp.Matrix(BEFORE[3:])
    return [*(moved - impulse), *(INERTIA_FACTOR * ball_radius**2 * turned - arm.cross(impulse))]


@cache
def response(ball_radius: sp.Expr) -> sp.Matrix:
    """Return what a unit of impulse changes: (6, 3), velocity and spin by the impulse."""
    after = sp.solve(impulse_equations(ball_radius), AFTER, dict=True)[0]
    return sp.Matrix([after[symbol] for symbol in AFTER]).jacobian(sp.Matrix(IMPULSE))


def contact_velocity(motion: sp.Matrix, ball_radius: sp.Expr) -> sp.Matrix:
    """Return the velocity of the contact point (Eq. 13) of a motion (6,) in the contact frame."""
    velocity, spin = motion[:3, :], motion[3:, :]
    return velocity + spin.cross(sp.Matrix([0, 0, -ball_radius]))


@cache
def yielding(ball_radius: sp.Expr) -> sp.Matrix:
    """Return what a unit of impulse changes of the contact point's velocity, (3, 3): diagonal."""
    columns = [contact_velocity(response(ball_radius).col(k), ball_radius) for k in range(3)]
    return sp.simplify(sp.Matrix.hstack(*columns))


def gripping(ball_radius: sp.Expr, tangential: sp.Expr) -> sp.Expr:
    """Return the share of the slip that a contact that grips takes from the velocity.

    The impulse is -share times the slip u, after which the slip is -e_t u.
    """
    share = sp.Symbol("share", real=True)
    left = 1 - yielding(ball_radius)[0, 0] * share
    return sp.solve(left + tangential, share)[0]


def lost_energy(
    ball_radius: sp.Expr, impulse: sp.Expr, slip: sp.Expr, speed: sp.Expr, restitution: sp.Expr
) -> sp.Expr:
    """Return by how much a contact changes the kinetic energy per unit mass.

    Parameters
    ----------
    ball_radius
        R_B.
    impulse
        What friction pushes against the slip, per unit mass.
    slip, speed
        Of the contact point along the surface, and off it, before the contact; not negative.
    restitution
        That of the contact.
    """
    before = sp.Matrix(BEFORE).subs({BEFORE[1]: 0, BEFORE[2]: -speed, BEFORE[4]: 0})
    before = before.subs(BEFORE[0], slip)
    pushed = sp.Matrix([-impulse, 0, (1 + restitution) * speed])
    after = before + response(ball_radius) * pushed

    def energy(motion: sp.Matrix) -> sp.Expr:
        v, w = motion[:3, :], motion[3:, :]
        return (v.dot(v) + INERTIA_FACTOR * ball_radius**2 * w.dot(w)) / 2

    return sp.expand(energy(after) - energy(before))


@dataclass(frozen=True)
class Slipping(Law):
    """Coulomb's law of friction, tangential restitution, restitution that falls with speed.

    Attributes
    ----------
    restitution
        Of a contact without speed, e0.
    friction
        Coulomb's mu; infinite: every contact grips.
    tangential
        e_t: a contact that grips leaves the slip at -e_t times what it was.
    falling
        v0, the normal speed at which the restitution is e0/2; infinite: it does not fall.
    """

    restitution: sp.Expr
    friction: sp.Expr = sp.oo
    tangential: sp.Expr = sp.Integer(0)
    falling: sp.Expr = sp.oo

    source: ClassVar[str] = "momentum, angular momentum and Coulomb's law of friction"
    called: ClassVar[str] = "the contact with friction"

    @property
    def coefficient(self) -> sp.Expr:
        """Its own."""
        return self.friction

    def friction_impulse(self, ball_radius: sp.Expr, slip: sp.Expr, speed: sp.Expr) -> sp.Expr:
        """Return lambda, what friction pushes against the slip, per unit mass: grip or friction.

        It is the smaller of what stops the slip, and turns it about by e_t, and of mu times the
        normal impulse. `after` has it as a share of the slip.

        Parameters
        ----------
        ball_radius
            R_B.
        slip, speed
            Of the contact point along the surface, and off it, before the contact; not negative.
        """
        grip = gripping(ball_radius, self.tangential) * slip
        return smallest(grip, self.friction * hold(1 + self.restitution_at(speed)) * speed)

    def restitution_at(self, speed: sp.Expr) -> sp.Expr:
        """Return e0 / (1 + v/v0)."""
        return self.restitution / hold(1 + speed / self.falling)

    def after(
        self, normal: sp.Matrix, velocity: sp.Matrix, spin: sp.Matrix, ball_radius: sp.Expr
    ) -> tuple[sp.Matrix, sp.Matrix]:
        """Return velocity and spin: v - share u - (1 + e) v_n n, and the spin that goes with it."""
        met = self._met(normal, velocity, spin, ball_radius)
        share = hold(self._share(met))
        moved = hold_all(met.tangential - share * met.slip)
        after = moved - met.restitution * met.approach * normal
        # A unit of impulse along n1 turns the ball about n2 = n3 × n1.
        turning = hold(-response(ball_radius)[4, 0] * share)
        return after, spin + turning * hold_all(normal.cross(met.slip))

    def doubt(
        self, normal: sp.Matrix, velocity: sp.Matrix, spin: sp.Matrix, ball_radius: sp.Expr
    ) -> sp.Basic | None:
        """Return where it may be that what seems to grip slips, or the other way about.

        The slip is off by at most twice the root of three times what its parts are, the normal
        impulse (1 + e) |v_n| by no more than twice what v_n is.
        """
        if self.friction in (0, sp.oo):
            return None
        met = self._met(normal, velocity, spin, ball_radius)
        speed, error = before_impact(ball_radius)
        off = hold(4 * GUARD * hold(error + 4 * UNIT_ROUNDOFF * speed))
        apart = size(hold(met.grip * sp.sqrt(met.squared)) - met.slide)
        near = Not(Less(hold(met.grip + 2 * self.friction) * off, apart))
        return every(Less(0, self.friction), Less(self.friction, sp.oo), near)

    def _share(self, met: _Met) -> sp.Expr:
        """Return the share of the slip that is taken from the velocity.

        An infinite mu is told apart, for without normal speed it would be multiplied by zero; and
        so is 0, with which nothing is in doubt. Squares are compared: a ball that holds zero has
        no root.
        """
        stops = hold(met.grip**2) * met.squared
        either = IfAtMost(stops, hold(met.slide**2), met.grip, met.slide / sp.sqrt(met.squared))
        return IfLess(0, self.friction, IfLess(self.friction, sp.oo, either, met.grip), 0)

    def _met(
        self, normal: sp.Matrix, velocity: sp.Matrix, spin: sp.Matrix, ball_radius: sp.Expr
    ) -> _Met:
        approach = hold(velocity.dot(normal))
        tangential = hold_all(velocity - approach * normal)
        slip = hold_all(tangential - ball_radius * hold_all(spin.cross(normal)))
        restitution = hold(self.restitution_at(-approach))
        slide = sp.Integer(0)
        if self.friction != sp.oo:
            slide = hold(-self.friction * hold((1 + restitution) * approach))
        return _Met(
            approach,
            tangential,
            slip,
            hold(slip.dot(slip)),
            restitution,
            hold(gripping(ball_radius, self.tangential)),
            slide,
        )


@dataclass(frozen=True)
class _Met:
    """A contact before its impulse.

    Attributes
    ----------
    approach, tangential
        The velocity along the normal, not positive, and across it.
    slip, squared
        Of the contact point, and the square of its size.
    restitution
        At that speed.
    grip
        The share of the slip that is taken where it stops.
    slide
        The impulse per unit mass of a contact that slips to its end: mu (1 + e) |v_n|.
    """

    approach: sp.Expr
    tangential: sp.Matrix
    slip: sp.Matrix
    squared: sp.Expr
    restitution: sp.Expr
    grip: sp.Expr
    slide: sp.Expr
