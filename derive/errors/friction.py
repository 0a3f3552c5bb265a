"""Bounds on the errors that a contact with Coulomb friction makes of those before it.

The law is that of `contact/friction.py`. With the slip u = v_t - R_B w × n, V = -n·v, the share λ
that friction takes of it, and f = λ u, it is

    v+ = v_t - f + V e(V) n,     w+ = w + n × f/(κ R_B),     u+ = u - (1 + 1/κ) f.

Where the contact grips, λ is the constant G = κ (1 + e_t)/(1 + κ). Where it slips, f = S(V) u/|u|
with S(V) = μ (1 + e(V)) V < G |u|. In the coordinates of `contact_frames`, R_B y_z is the error of
the slip after the contact, turned by a right angle; T has rows for it.

**Lemma (friction).** Let the lemma of `second_order` hold up to its normal, with its bounds S on
the delay, Q on the way, a on the change of the velocity, W on that of the spin, N on that of the
normal, d²t and d²n. Then let

    A = a + 9/8 N (|v| + a),   B = W + 9/8 N (|w| + W),   U = A + R_B B

and let G U + μ (1 + e_0) A <= |S - G |u||, and 5 U <= |u| if the contact slips. The exact ball then
grips where the computed one grips, and slips where it slips. With the slopes
σ = μ (1 + e_0) where it slips and σ = 0 where it grips, and L(x, y) = G (x + R_B y) + σ x, what the
derivative of flight, contact and impact leaves out in the coordinates y and in the spin is at most

    d²f = L(E_v, E_w), where it slips with (21/20 λ U + 51/50 σ A) U/|u| + μ (e_0/v_0) A² besides,
    d²v = E_v + d²f + (e_0/v_0) A² + 9/8 d²n |v+| + 9/8 N (A + 9/8 L(A, B)),
    d²w = E_w + d²f/(κ R_B) + 9/8 d²n |w+| + 9/8 N (B + 9/8 L(A, B)/(κ R_B)),
    E_v = g d²t + 9/8 (d²n |v| + N a),   E_w = 9/8 (d²n |w| + N W),

and what the second order of q makes of Ω q × v+ and Ω q × w+.

*Proof.* The law is the same in every frame: law(Q n, Q v, Q w) = Q law(n, v, w) for each rotation
Q. The first order q_1 of q turns n by Ω q_1, whose size is at most N; exp(Ω q_1) n differs from
n + Dn q_1 by at most 0.51 N², and so from the exact normal by d²n + 0.51 N². A rotation by 1.01
times this takes one to the other, and d²n counts 2 N², of which its lemma needs 1.16 N². So there
is a rotation Q by at most 9/8 N with Q n the exact normal, and |Q - 1 - Ω q_1 ×| <= 9/8 d²n. Turned
back by Q, the exact motion differs from the computed one by less than A and B, and from the first
order of that by E_v and E_w, since Q⁻¹ (v + c) - v - c_1 + Ω q_1 × v = (Q⁻¹ - 1 + Ω q_1 ×) v
+ (Q⁻¹ - 1) c + c - c_1, where c - c_1 is g d²t.
So its slip differs by at most U. |u| and S change by at most U and μ (1 + e_0) A, as V e(V) has a
slope between 0 and e_0, so that S - G |u| keeps its sign.
Where the contact grips, f is linear. Where it slips, let r |u| be the size of the change of u, at
an angle θ to u, and m |u| that of the new slip, with r <= 1/5 and m >= 4/5. The direction turns by
at most arcsin r <= 51/50 r. It loses r² sin² θ/(m (m + 1 + r cos θ)) along u, and across u it is
off its derivative by r² sin θ |2 cos θ + r|/(m (m + 1)): together at most 0.94 r². And V e(V) =
e_0 V/(1 + V/v_0) has a second derivative of at most 2 e_0/v_0. The derivative of f is at most L:
that of u/|u| is at most 1/|u|, and S <= G |u|. Turned on by Q, the law's change is turned by 9/8 N
besides, and the motion after the contact by what Q differs from its first order. ∎

**Roundings.** The slip, its direction, its share and the margin are computed in double precision.
An impact is off by at most u (20 (|v| + R_B |w|) + F), with the roundings of the impulse, F = 32 G
(|v| + R_B |w|) + 4 σ |v|, and its spin by u (4 |w| + F/(κ R_B)); |v| and |w| are sums of sizes
here. The normal velocity, the tangential one and w × n have 3, 5 and 3 roundings of these sizes, so
that u is off by at most 8 u (|v| + R_B |w|) and |u| by 11 u; S has the seven of its products and
sums, and σ times that of V. The direction has the roundings of u over |u|. The impulse has S times
these, at most G times the roundings of u since S <= G |u|, however small |u| is. The margin is off
by half of 2^-48 (G (|v| + R_B |w|) + μ (1 + e_0) |v|).
A normal that is off by ν changes the tangential velocity by (|v| + V) ν, of which V ν is along the
surface, w × n by |w| ν and V by |v| ν; L gives what that makes of f.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..contact.ball import Ball
from ..contact.friction import CoulombFriction, Slip, grip_share
from ..symbolic.conditionals import IfLess, absolute, barrier, maximum
from ..symbolic.symbols import UNIT_ROUNDOFF, normal
from .contact_frames import (
    BENDS,
    FLOOR,
    NORMS,
    T_ROUNDING,
    TANGENT,
    Arrival,
    Frame,
    Impact,
    Rest,
    Vector,
    held,
    normal_rounding,
    normal_velocity,
    weighted_sum,
)
from .derivative import directional

slip_share, slip_margin = sp.symbols("slip_share slip_margin", real=True)
"""λ, and S - G |u|: negative if the contact slips."""
slip_speed = sp.Symbol("slip_speed", nonnegative=True)
"""|u|."""
DIRECTION = sp.symbols("slip_x slip_y slip_z", real=True)
"""u/|u|, zero if there is no slip."""

ARGUMENTS = (slip_share, slip_margin, slip_speed, *DIRECTION)
"""Arguments of the kernels of this module besides those of `contact_frames`, in calling order."""

ROOM = sp.Rational(9, 8)
"""Room for what is small beside a bound's first order."""

LARGEST_CHANGE = 5
"""One over the largest relative change of a slip."""

DIRECTION_ORDER = sp.Rational(21, 20)
"""The second order and beyond of a direction, over the square of the relative change r."""

DIRECTION_SLOPE = sp.Rational(51, 50)
"""The change of a direction, over the relative change."""

LEAST_SLIP = sp.Rational(1, 2**20)
"""The smallest slip whose direction is known to single precision, as a share of all speeds."""

MOTION_ROUNDINGS, SPIN_ROUNDINGS = 20, 4
"""Roundings of an impact beside those of its impulse, of the sums of sizes."""

SHARE_ROUNDINGS, SLOPE_ROUNDINGS = 32, 4
"""Roundings of the impulse, of G (|v| + R_B |w|) and of σ |v|."""

MARGIN_ROUNDING = sp.Rational(1, 2**48)
"""Roundings of the margin, of G (|v| + R_B |w|) + μ (1 + e_0) |v|."""


def slip_outputs(slip: Slip) -> dict[str, sp.Expr]:
    """Return the outputs of the kernel that computes a contact's slip in double precision.

    Parameters
    ----------
    slip
        The slip of a contact.
    """
    values = (slip.share, slip.margin, slip.speed, *slip.direction)
    return {symbol.name: value for symbol, value in zip(ARGUMENTS, values, strict=True)}


def _where_it_slips(value: sp.Expr) -> sp.Expr:
    """Return a value where the contact slips, and zero where it grips."""
    return IfLess(slip_margin, 0, value, 0)


@dataclass(frozen=True)
class FrictionImpact(Impact):
    """The impact with Coulomb friction.

    Attributes
    ----------
    ball
        The ball.
    friction
        The law.
    """

    ball: Ball
    friction: CoulombFriction

    @property
    def _grip(self) -> sp.Expr:
        """G; zero if no contact has friction."""
        if self.friction.friction == 0:
            return sp.Integer(0)
        return barrier(grip_share(self.ball, self.friction.tangential))

    @property
    def _share(self) -> sp.Expr:
        """The share λ."""
        return slip_share if self.friction.decides else self._grip

    @property
    def _turning(self) -> sp.Expr:
        """The spin that a unit of impulse gives, 1/(κ R_B)."""
        return barrier(1 / barrier(self.ball.inertia * self.ball.radius))

    @property
    def _rebound_slope(self) -> sp.Expr:
        """The derivative of V e(V)."""
        speed = sp.Symbol("speed_of_approach", positive=True)
        slope = directional(speed * self.friction.restitution_at(speed), {speed: sp.Integer(1)})
        return barrier(slope.xreplace({speed: absolute(normal_velocity)}))

    @property
    def _steepest(self) -> sp.Expr:
        """The largest derivative of S, zero if it is infinite and decides nothing."""
        steepest = barrier(self.friction.friction * barrier(1 + self.friction.restitution))
        return IfLess(self.friction.friction, sp.oo, steepest, 0)

    @property
    def _bending(self) -> sp.Expr:
        """Half of the largest second derivative of V e(V), e_0/v_0."""
        if self.friction.falling == sp.oo:
            return sp.Integer(0)
        return barrier(self.friction.restitution / self.friction.falling)

    @property
    def _direction(self) -> tuple[sp.Expr, sp.Expr]:
        """The components of the slip's direction along s and e."""
        _, s, e = Frame.of(normal, TANGENT, BENDS).of_vector(DIRECTION)
        return s, e

    def _slip(self, pace: Vector, turn: Vector) -> tuple[sp.Expr, sp.Expr]:
        """Return the components of the slip of a motion along s and e."""
        radius = self.ball.radius
        return held(pace[1] - radius * turn[2]), held(pace[2] + radius * turn[1])

    def law(self, pace: Vector, turn: Vector) -> list[sp.Expr]:
        """Return y_n, y_s, y_e, y_w and y_z after a change of the motion before the impact.

        Parameters
        ----------
        pace, turn
            The change of velocity and spin.
        """
        slip = self._slip(pace, turn)
        impulse = [held(self._share * one) for one in slip]
        rebound = self._rebound_slope
        if self.friction.decides:
            direction = self._direction
            along = held(sum(u * one for u, one in zip(direction, slip, strict=True)))
            steeper = _where_it_slips(barrier(self.friction.friction * barrier(1 + rebound)))
            more = held(-_where_it_slips(slip_share) * along - steeper * pace[0])
            impulse = [held(one + u * more) for one, u in zip(impulse, direction, strict=True)]
        stops = barrier(1 + barrier(1 / self.ball.inertia))
        left = [held(u - stops * f) for u, f in zip(slip, impulse, strict=True)]
        per_radius = barrier(1 / self.ball.radius)
        return [
            held(-rebound * pace[0]),
            *(held(v - f) for v, f in zip(pace[1:], impulse, strict=True)),
            turn[0],
            held(left[1] * per_radius),
            held(-left[0] * per_radius),
        ]

    def after(self, moving: Vector, turning: Vector) -> tuple[Vector, Vector]:
        """Return velocity and spin after the impact.

        Parameters
        ----------
        moving, turning
            Those before it.
        """
        f_s, f_e = (held(self._share * one) for one in self._slip(moving, turning))
        nearing = absolute(normal_velocity)
        away = barrier(nearing * barrier(self.friction.restitution_at(nearing)))
        gives = self._turning
        return (
            (away, barrier(moving[1] - f_s), barrier(moving[2] - f_e)),
            (turning[0], barrier(turning[1] - gives * f_e), barrier(turning[2] + gives * f_s)),
        )

    def rest(self, arrival: Arrival) -> Rest:
        """Return the terms beside |T| B, of the lemma and its roundings.

        Parameters
        ----------
        arrival
            The bounds before the impact.
        """
        here, radius, share, turning = arrival, self.ball.radius, self._grip, self._turning
        size, spinning, nearing = here.size, here.spinning, here.nearing
        steepest = self._steepest if self.friction.decides else sp.Integer(0)
        slope = _where_it_slips(steepest) if self.friction.decides else steepest
        e_0, bending, w = self.friction.restitution, self._bending, NORMS[2]

        def impulse(pace: sp.Expr, turn: sp.Expr) -> sp.Expr:
            """Return L, a bound on the change of f."""
            return barrier(share * barrier(pace + radius * turn) + slope * pace)

        total = barrier(size + radius * spinning)
        change = barrier(here.change + ROOM * here.turn * barrier(size + here.change))
        twist = barrier(w + ROOM * here.turn * barrier(spinning + w))
        # What the computed normal makes of the slip and of V.
        off = barrier(normal_rounding + here.longer)
        bumped = barrier(barrier(size + nearing) * normal_rounding + 2 * nearing * here.longer)
        slid = barrier(bumped + radius * spinning * off)
        steered = barrier(size * off)
        rubbed = barrier(ROOM * barrier(share * slid + slope * steered))
        # The second order, and the roundings of T.
        speeds = barrier(here.pull + ROOM * barrier(here.tilt * size + here.turn * here.change))
        spins = barrier(ROOM * barrier(here.tilt * spinning + here.turn * w))
        bent = impulse(speeds, spins)
        if self.friction.decides:
            unit = barrier(barrier(change + radius * twist) / slip_speed)
            first = barrier(DIRECTION_ORDER * slip_share * barrier(change + radius * twist))
            curving = barrier(barrier(first + DIRECTION_SLOPE * slope * change) * unit)
            falling = barrier(self.friction.friction * bending * change**2)
            bent = barrier(bent + _where_it_slips(barrier(curving + falling)))
        speed_after = barrier(size + share * total)
        spin_after = barrier(spinning + turning * barrier(share * total))
        moved = impulse(change, twist)
        paced = barrier(2 * barrier(here.change + here.summed) + 4 * size * here.turn)
        spun = barrier(2 * here.spun + 4 * spinning * here.turn)
        products = barrier(2 * impulse(paced, spun))
        curved = barrier(
            speeds
            + bent
            + bending * change**2
            + ROOM * here.tilt * speed_after
            + ROOM * here.turn * barrier(change + ROOM * moved)
            + speed_after * here.turned
            + T_ROUNDING * barrier(paced + products)
        )
        curved_spin = barrier(
            spins
            + turning * bent
            + ROOM * here.tilt * spin_after
            + ROOM * here.turn * barrier(twist + ROOM * turning * moved)
            + spin_after * here.turned
            + T_ROUNDING * barrier(spun + turning * products)
        )
        # Roundings of the law.
        pushed = barrier(SHARE_ROUNDINGS * share * total + SLOPE_ROUNDINGS * slope * size)
        law = barrier(UNIT_ROUNDOFF * barrier(MOTION_ROUNDINGS * total + pushed) + FLOOR)
        law_spin = barrier(
            UNIT_ROUNDOFF * barrier(SPIN_ROUNDINGS * spinning + turning * pushed) + FLOOR
        )
        bounce = barrier(1 + e_0)
        across = barrier(law + bounce * nearing * normal_rounding + rubbed + curved)
        twisted = barrier(law_spin + turning * barrier(rubbed + share * total * off) + curved_spin)
        before = (*here.paces, *here.turns[1:])
        rows = [barrier(weighted_sum(row, before)) for row in self._rows()]
        extras = (
            here.own[0] + here.beyond,
            here.own[1] + here.beyond,
            rows[0] + bounce * bumped + barrier(law + rubbed + curved),
            rows[1] + across,
            rows[2] + across,
            here.turns[0] + twisted,
        )
        unrolled = maximum(*rows[3:]) + twisted + across * barrier(1 / radius)
        excess = here.excess
        if self.friction.decides:
            changed = barrier(barrier(change + radius * twist) + slid)
            small = barrier(LARGEST_CHANGE * barrier(changed + LEAST_SLIP * total) - slip_speed)
            turned = barrier(share * changed + steepest * barrier(change + steered))
            blurred = barrier(MARGIN_ROUNDING * barrier(share * total + steepest * size))
            decided = barrier(ROOM * turned + blurred - absolute(slip_margin))
            excess = maximum(excess, decided, IfLess(slip_margin, 0, small, -1))
        return Rest(arrival, speed_after, spin_after, extras, unrolled, excess)

    def _rows(self) -> list[list[sp.Expr]]:
        """Return the rows y_n, y_s, y_e and y_z of the law, by v_n, v_s, v_e, w_s and w_e."""
        zero, one = sp.Integer(0), sp.Integer(1)
        units: list[Vector] = [(one, zero, zero), (zero, one, zero), (zero, zero, one)]
        still: Vector = (zero, zero, zero)
        columns = [self.law(unit, still) for unit in units]
        columns += [self.law(still, unit) for unit in units[1:]]
        rows = [list(row) for row in zip(*columns, strict=True)]
        return [*rows[:3], *rows[4:]]
