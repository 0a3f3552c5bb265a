"""Bounds on what the derivative of a contact leaves out, to the second order and beyond: a lemma.

A ball is flown to a contact at the place c, where it has the velocity v and the spin w; n is the
normal there, V = |n·v|, and g the size of the acceleration. Another ball is off by at most A from
c at that time, by E from v, and by W from w, in Euclid's norm. It meets the surface s later, at
c + q, with the normal n + ν. The first order is s = -(n·a)/(n·v), q = a + v s, ν = Dn q with the
other ball's offset a, and the law's derivative.

The surface's distance G is smooth within Q of c, with |DG| = 1, |DDG| <= 1.02 K and
|DDDG| <= 2.4 K². Of a ring with the radii R_H and R that holds for K = 1/min(R, R_H - R) if
K Q <= 1/100, and of a plane for K = 0:

    With r = |distance from the wire's centre circle|, ρ the distance from the axis and θ the angle
    about the wire, DDG has the eigenvalues 0, 1/r and cos θ/ρ, and along a unit vector u

        DDDG(u, u) = - (θ'² + φ'² cos² θ) n + (-2 u_τ u_n/r² - u_φ² sin θ/(r ρ)
                     + φ'² sin θ cos θ) τ - 2 (sin θ θ' φ' + cos θ u_φ ρ'/ρ²) e_φ,

    θ' = u_τ/r, φ' = u_φ/ρ, ρ' = cos θ u_n - sin θ u_τ. With 1/r, 1/ρ <= k the three parts are at
    most k², 3/2 k² and sqrt(2) k²: together less than 2.3 k², and k <= K/(1 - K Q).

**Delay.** Let S = 1.1 A/V, a = E + g S and Q = A + (|v| + a) S. With h(s) = G(c + q(s)),
|h(0)| <= A and h'(s) <= -V + a + 1.02 K Q (|v| + a) while |s| <= S. If a + 1.02 K Q (|v| + a) is at
most V/11, then h' <= -V/1.1, and h has exactly one root in |s| <= S. By Taylor's theorem
0 = n·q + DDG(q, q)/2, so that s is off its first order by

    d²t = (E S + g S²/2 + 0.51 K Q²)/V.

**Place and normal.** q = a + v s + δv s + g s²/2, hence d²c = |v| d²t + E S + g S²/2; and
ν = Dn q + DDDG(q, q)/2, hence d²n = 1.02 K d²c + 1.2 K² Q² and |ν| <= N = 1.02 K Q.

**Impact.** Without slip, with the share m of the tangential velocity that stays, f = 1 - m and the
ball's radius R_B,

    v+ = m v - (m + e) (v·n) n + f R_B w × n,     w+ = m n × v/R_B + f w + (1 - f) (w·n) n.

Both are polynomials. What is not linear in the change of v, at most a, of w and of n, and what
d²t and d²n change, is at most

    d²v = max(m, e) g d²t + (2 (m + e) |v| + f R_B |w|) d²n
          + (m + e) (2 a N + (|v| + a) N²) + f R_B W N,
    d²w = m g d²t/R_B + (m |v|/R_B + 2 (1 - f) |w|) d²n + m a N/R_B
          + (1 - f) (2 W N + (|w| + W) N²).

`contact_frames` adds them to the bounds that it carries.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..contact.ball import Ball
from ..symbolic.conditionals import maximum

place_bound, velocity_bound, spin_bound = sp.symbols(
    "place_bound velocity_bound spin_bound", nonnegative=True
)
"""A, E and W: bounds on the norms of the errors just before the contact, at a fixed time."""
speed, spin_size, approach, pull, curvature = sp.symbols(
    "speed spin_size approach pull curvature", nonnegative=True
)
"""|v|, |w|, V, g and K."""

STRETCH = sp.Rational(11, 10)
"""S V/A, where h' is at least V over this."""

BEND = sp.Rational(51, 50)
"""The largest curvature within Q over K."""

TURN = sp.Rational(6, 5)
"""Half of the largest third derivative within Q over K²."""


@dataclass(frozen=True)
class SecondOrder:
    """The bounds of the lemma, each a list of terms whose sum it is.

    Attributes
    ----------
    valid
        Quantities that must all be at most zero.
    delay, place, normal, velocity, spin
        Terms of d²t (s), d²c (m), d²n, d²v (m/s) and d²w (1/s).
    """

    valid: tuple[sp.Expr, ...]
    delay: tuple[sp.Expr, ...]
    place: tuple[sp.Expr, ...]
    normal: tuple[sp.Expr, ...]
    velocity: tuple[sp.Expr, ...]
    spin: tuple[sp.Expr, ...]


def second_order(ball: Ball, restitution: sp.Expr) -> SecondOrder:
    """Return the bounds on what the derivative of a contact without slip leaves out.

    Parameters
    ----------
    ball
        The radius and the inertia of the ball.
    restitution
        e of the normal velocity.
    """
    stays, share, radius = ball.moving_share, ball.friction_share, ball.radius
    lasting = STRETCH * place_bound / approach
    change = velocity_bound + pull * lasting
    way = place_bound + (speed + change) * lasting
    turn = BEND * curvature * way
    fall = pull * lasting**2 / 2
    delay = (
        velocity_bound * lasting / approach,
        fall / approach,
        BEND / 2 * curvature * way**2 / approach,
    )
    late = sp.Add(*delay)
    place = (speed * late, velocity_bound * lasting, fall)
    normal = (BEND * curvature * sp.Add(*place), TURN * curvature**2 * way**2)
    tilted = sp.Add(*normal)
    both = stays + restitution
    return SecondOrder(
        valid=(
            change + turn * (speed + change) - approach / 11,
            curvature * way - sp.Rational(1, 100),
        ),
        delay=delay,
        place=place,
        normal=normal,
        velocity=(
            maximum(stays, restitution) * pull * late,
            (2 * both * speed + share * radius * spin_size) * tilted,
            2 * both * change * turn,
            both * (speed + change) * turn**2,
            share * radius * spin_bound * turn,
        ),
        spin=(
            stays * pull * late / radius,
            (stays * speed / radius + 2 * (1 - share) * spin_size) * tilted,
            stays * change * turn / radius,
            2 * (1 - share) * spin_bound * turn,
            (1 - share) * (spin_size + spin_bound) * turn**2,
        ),
    )
