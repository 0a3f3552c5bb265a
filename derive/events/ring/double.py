"""The search for the ring of Table 2: fast bounds in closed form.

The search uses Table 2's condition with its root kept and the distance squared,

    F = (rho - R_H)² + z² - R²,    rho = sqrt(x² + y²).

Along a flight rho² is quadratic in time with leading coefficient V² = vx² + vy², and
L = x vy - y vx is constant, so rho'' = L²/rho³; with the energy constant vz² + 2 g z,

    F'' = 2 (V² + vz² + 2 g z) - 6 g z - 2 R_H L²/rho³:

a constant less two terms that a bound on z and on rho limits.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import sympy as sp

from ...symbolic.conditionals import absolute, barrier, maximum, minimum
from ...symbolic.rounding import ROUNDING_SLACK, Rounded, position_error, velocity_error
from ...symbolic.symbols import POSITION, UNIT_ROUNDOFF, VELOCITY, t
from ..event_polynomials import horizon, share, time_rounding
from .miss_filter import clear, drops_through
from .polar import energy2, moment2, rho_start
from .windows import RingWindows


@dataclass(frozen=True)
class RingRootFinder(RingWindows):
    """The root finder for the ring: windows, curvature and margins in closed form."""

    ease: ClassVar[sp.Expr] = sp.Rational(1, 2**40)
    """Bound on the roundings of the bound on F'', relative to the size of its terms."""

    @property
    def named(self) -> dict[str, sp.Expr]:
        """The sizes of ring and windows, and the flight in polar coordinates."""
        _, _, rho = self._here()
        innermost, outermost = self.radii()
        sizes = {"R": self.ring.reach, r"\hat R": self.reach}
        radii = {r"\rho_-": innermost, outermost.name: outermost}
        polar = {e.name: e for e in (*self.polar(), rho.base)}
        return sizes | radii | super().named | polar | {r"\rho_t": rho}

    def _here(self) -> tuple[sp.Matrix, sp.Matrix, sp.Expr]:
        """Return position, velocity and rho at time t."""
        there, moving = self.flight.named()
        return there, moving, sp.sqrt(barrier(there[0] ** 2 + there[1] ** 2, r"\rho_t^2"))

    def _inverses(self, rho: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
        """Return 1/rho and 1/(rho + rho0) by one division."""
        both = barrier(rho + rho_start)
        inverse = barrier(1 / barrier(rho * both))
        return barrier(inverse * both), barrier(inverse * rho)

    def _outward_speed(self) -> sp.Expr:
        """Return the rate of rho."""
        there, moving, rho = self._here()
        per_rho, _ = self._inverses(rho)
        return barrier(barrier(there[0] * moving[0] + there[1] * moving[1]) * per_rho)

    @property
    def gap(self) -> sp.Expr:
        """F at the position at time t."""
        there, _, rho = self._here()
        reach = barrier(self.ring.reach, "R")
        return barrier(rho - self.ring.ring_radius) ** 2 + there[2] ** 2 - reach**2

    @property
    def leaving_gap(self) -> sp.Expr:
        """F = t P (rho - R_H + rho0 - R_H)/(rho + rho0) + t Z (z + z0), without cancellation.

        P = (rho² - rho0²)/t and Z = (z - z0)/t are polynomials in t: this is F less its value at
        t = 0, which is zero at a contact, with the factor t in the open.
        """
        there, _, rho = self._here()
        _, q, speed_squared, _ = self.polar()
        _, _, z0 = POSITION
        _, _, vz = VELOCITY
        radius = self.ring.ring_radius
        outward = 2 * q + speed_squared * t
        upward = vz - self.gravity * t / 2
        inward = barrier(barrier(rho - radius) + barrier(rho_start - radius))
        radial = barrier(barrier(outward) * inward) * self._inverses(rho)[1]
        return t * barrier(radial + barrier(upward) * barrier(there[2] + z0))

    @property
    def rate(self) -> sp.Expr:
        """F' = 2 ((rho - R_H) rho' + z z')."""
        there, moving, rho = self._here()
        depth = barrier(rho - self.ring.ring_radius)
        return 2 * barrier(depth * self._outward_speed() + there[2] * moving[2])

    @property
    def bend(self) -> sp.Expr:
        """F'' as above."""
        there, _, rho = self._here()
        return energy2 - 6 * self.gravity * there[2] - moment2 * self._inverses(rho)[0] ** 3

    def curvature(self, width: sp.Expr) -> sp.Expr:
        """Return the bound, with z highest and rho smallest, each bounded separately.

        rho is convex in time, and so never below its tangent.
        """
        there, moving, rho = self._here()
        innermost, _ = self.radii()
        around, above = self.blur(width)
        rising = barrier(there[2] + maximum(moving[2], 0) * width)
        highest = minimum(barrier(rising + above), self.reach)
        tangent = barrier(rho + minimum(self._outward_speed(), 0) * width)
        least = maximum(barrier(tangent - around), innermost)
        fall = 6 * self.gravity * highest
        turn = moment2 * barrier(1 / barrier(least)) ** 3
        slack = self.ease * barrier(absolute(fall) + turn + absolute(energy2))
        return fall + turn - energy2 + slack

    def blur(self, width: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
        """Return bounds on the roundings of rho and of z, along their tangents."""
        del width
        _, outermost = self.radii()
        return (self.ease * outermost,) * 2

    @property
    def clear(self) -> sp.Expr:
        """Positive if the ball certainly misses the ring before the horizon (`miss_filter.py`)."""
        return clear(self)

    @property
    def drops_through(self) -> sp.Basic:
        """Condition that the ball rises and then drops through the hole (`miss_filter.py`)."""
        return drops_through(self)

    @property
    def ceiling(self) -> sp.Expr:
        """The sum of the largest sizes of the terms of F'', with |z| <= R and rho >= I."""
        innermost, _ = self.radii()
        turn = self.constants["moment2"] * barrier(1 / innermost) ** 3
        return absolute(self.constants["energy2"]) + 6 * self.gravity * self.reach + turn

    @property
    def excess(self) -> sp.Expr:
        """Positive if errors of the state exceed those that the margins of a search contain.

        A search allows for a share s of X = |x| + T V, the size of the flight up to the end T of
        its windows, and of its speed V. Its margins contain

            5 R s Y of F,    5 (R s V + max(1, R/I) V s Y) of F' and F/t,    Y = X + T V.

        Errors of the position and the velocity, p and v in each coordinate, are at most P = p + T v
        of any position until T. By the inequalities of `margins` they change F, F' and F/t by no
        more than that if

            P <= s Y    and    R (v - s V) + max(1, R/I) V (P - s Y) <= 0.

        So v may exceed s V where P is less than s Y, and mostly it is the velocity that is known
        less well. The roundings of this difference are a few u of s Y, less than what
        `ROUNDING_SLACK` adds to the margins.
        """
        furthest, fastest = self.flight.size(horizon)
        moved = barrier(self._moved_by_errors(horizon) - share * (furthest + horizon * fastest))
        return self._exceeding(moved, moved)

    @staticmethod
    def _moved_by_errors(time: sp.Expr) -> sp.Expr:
        """Return a bound on the error of any coordinate until a time."""
        return barrier(position_error + velocity_error * time)

    def _exceeding(self, moved: sp.Expr, mean: sp.Expr) -> sp.Expr:
        """Return the excess, given by how much P exceeds what counts in F, and in F' and F/t."""
        _, fastest = self.flight.size(horizon)
        innermost, _ = self.radii()
        stretch = maximum(1, self.reach / innermost)
        sped = barrier(velocity_error - share * fastest)
        return maximum(moved, barrier(self.reach * sped + barrier(stretch * fastest) * mean))

    @property
    def margins(self) -> dict[str, sp.Expr]:
        """Bounds on the errors of F, F/t and F' within the windows, from state and roundings.

        F is the squared distance to the wire's circle less R²: |grad F| <= 2 sqrt(2) R. Its
        Hessian, 2 along rho and z and 2 (rho - R_H)/rho across, is at most 2 max(1, R/I) with
        I = R_H - R.
        An error p of the position and v of the velocity (in each coordinate; roundings of Eq. 3
        count as such) change

            F by 2 R sqrt(6) p,    F' by 2 sqrt(6) (R v + max(1, R/I) |v| p),

        and F/t, the mean of F' since the contact, by no more than F'. To these come the roundings
        of the formulas: rho is known to 3 u (R_H + R), so F to 12 u R (R_H + R) and F' to
        32 u (R_H + R) |v|; P (rho - R_H + rho0 - R_H)/(rho + rho0) of F/t to
        16 u max(1, R/I) |p| |v|, P being (rho + rho0) (rho - rho0)/t.

        The last two are generous. The largest errors of F/t and F' that a search found are below a
        tenth of their margins, and below two fifths without these roundings: the roundings of
        Eq. 3, which are bounded on every axis at once, cover them.

        **Lemma (margins).** Let 3/2 R <= R_H <= 2^4 R, the flight be no larger than 2^16 R, and the
        errors of the state at most P = p + v T <= 2^-16 R of any coordinate until T, with `excess`
        at most zero. Within the windows F, F/t and F' of the true flight are within these margins
        of those computed at the same time.

        *Proof.* sqrt(F + R²) is the distance from the wire's circle, at most sqrt(2) R̂, and
        changes by no more than the place. So with q = P + 4 u X, the error of a coordinate, F
        changes by at most sqrt(3) q (2 sqrt(2) R̂ + sqrt(3) q) < 4.91 R̂ q, as q < 2^-15 R.

        The Hessian of F is at most 2 max(1, R̂/I) where rho >= I, and on the way between the true
        place and the computed one 1.01 times that, as q < I/100. Hence F' changes by at most
        4.96 (R̂ (v + 2 u V) + max(1, R̂/I) V q).

        With w the mean velocity, the derivative of F/t by the place at the start is the change of
        grad F = 2 (d e, z) over t, and that by w is grad F. The way |w| t has the square
        (rho - rho0)² + rho rho0 |e - e0|² + (z - z0)², and d e - d0 e0 has (d - d0)² +
        d d0 |e - e0|², with |d| <= max(1, R̂/I) rho at both ends. So F/t changes by at most
        2 sqrt(6) R̂ v + 2 sqrt(3) max(1, R̂/I) |w| p, and 1.01 times that along the way of the
        state, wherever the ball was in between.

        *Roundings.* rho is off by 2 u rho, d by 2 u rho + u |d| <= 3 u A with A the outer radius,
        and R² by 3 u R². So F = d² + z² - R² is off by at most 6 u R̂ A + 9 u R̂² <= 10.5 u R̂ A,
        as 2 R̂ < A. In F', 1/rho has four roundings and rho' eight, so F' is off by 2 (3 u A V + 11
        u R̂ V) + 4 u R̂ V <= 19 u A V. In F/t the rate of rho² is off by 5 u V X, its divisor by 8
        u and the sum of both d by 7 u A: with the rest less than (5 max(1, R̂/I) X + 25 A) u V.
        Those of the place at t count in d, z and rho alone, not over t. `ROUNDING_SLACK` is for the
        roundings of the margins (`symbolic/rounding.py`). ∎

        *Where Newton's method ends.* A step that begins with h = C F/F'² <= 2^-24 leaves
        |F| <= 2^-49 F'²/C besides roundings. At a contact F'² <= 4 R² |v|² and C >= 2 |v|², so that
        is at most 32 u R²; and m has 24 u R² at least. So |F| <= 7/3 m for the root's lemma in
        `event_polynomials.crossing`; the rate is that before the last step, which turns it by less
        than 2^-24 of it. If C m is so near r² that h stays above 2^-24, the last steps leave 9/8 m.
        """
        u, root = UNIT_ROUNDOFF, sp.Rational(5, 2)
        reach = self.reach
        innermost, outermost = self.radii()
        stretch = maximum(1, reach / innermost)
        furthest, fastest = self.flight.size(horizon)
        there, moving = self.flight.rounding(horizon)
        slope = barrier(
            2 * root * barrier(reach * moving.error + barrier(stretch * fastest) * there.error)
        )
        steepest = Rounded(2 * barrier(reach * fastest))
        gap = 2 * root * reach * there.error + 12 * u * reach * outermost
        mean = slope + 32 * u * fastest * barrier(stretch * furthest + outermost)
        return {
            "margin": ROUNDING_SLACK * barrier(gap + time_rounding(steepest) * horizon),
            "leaving_margin": ROUNDING_SLACK * barrier(mean + time_rounding(steepest)),
            "rate_margin": ROUNDING_SLACK * barrier(slope + 32 * u * barrier(outermost * fastest)),
        }
