"""The search for the ring of Table 2: bounds in closed form that make it quick.

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

from ..ground.choice import IfAtMost, IfLess, hold, largest, size, smallest
from ..ground.rounding import SAFETY, Rounded
from ..ground.symbols import POSITION, UNIT_ROUNDOFF, VELOCITY, t
from .clear import clear
from .events import Window, horizon, time_rounding
from .polar import PolarApproach, rho_start, steady, swing


@dataclass(frozen=True)
class RingApproach(PolarApproach):
    """The search for the ring: windows, curvature and margins in closed form."""

    unit: ClassVar[sp.Expr] = UNIT_ROUNDOFF
    """The unit roundoff of what windows are computed in."""

    hardly: ClassVar[sp.Expr] = sp.Rational(1, 2**600)
    """The square of a horizontal speed at which no times of windows are known."""

    ease: ClassVar[sp.Expr] = sp.Rational(1, 2**40)
    """More than what roundings make of the bound on F'', of the size of its terms."""

    @property
    def named(self) -> dict[str, sp.Expr]:
        """The sizes of ring and windows, and the flight in polar coordinates."""
        _, _, rho = self._here()
        innermost, outermost = self.radii()
        sizes = {"R": self.ring.reach, r"\hat R": self.reach}
        radii = {r"\rho_-": innermost, outermost.name: outermost}
        polar = {e.name: e for e in (*self.polar(), rho.base)}
        return sizes | radii | super().named | polar | {r"\rho_t": rho}

    @property
    def windows(self) -> list[Window]:
        """When |z| <= R and |rho - R_H| <= R can both hold.

        Each of the two holds in at most two intervals, Z1 < Z2 and A1 < A2. Of the four
        intersections Z1 A2 and Z2 A1 are not both possible, so three windows suffice. The
        discriminants are widened by their rounding errors, and so are the times.
        """
        (z1, z2), (a1, a2) = self._slab_intervals(), self._annulus_intervals()
        late_first = _meet(z1, a2)
        middle = tuple(
            IfAtMost(late_first[0], late_first[1], late, early)
            for late, early in zip(late_first, _meet(z2, a1), strict=True)
        )
        return [_meet(z1, a1), (middle[0], middle[1]), _meet(z2, a2)]

    def _slab_intervals(self) -> tuple[Window, Window]:
        """Return the rising and the falling interval of |z| <= R.

        The roots of z = c are (vz ± sqrt(D)) / g with D = vz² + 2 g (z0 - c).
        """
        g = self.gravity
        _, _, z = POSITION
        _, _, vz = VELOCITY
        reach = self.reach
        error = 8 * self.unit * hold(vz**2 + 2 * g * (sp.Abs(z) + reach))
        to_bottom = hold(vz**2 + 2 * g * hold(z + reach) + error)
        to_top = hold(vz**2 + 2 * g * hold(z - reach) - error)
        outer, inner = sp.sqrt(to_bottom), sp.sqrt(largest(to_top, 0))
        pad = hold(16 * self.unit * hold(sp.Abs(vz) + outer), "p_Z")
        per_g = hold(1 / g)
        first = IfAtMost(0, to_bottom, hold(vz - outer - pad) * per_g, sp.oo)
        last = IfAtMost(0, to_bottom, hold(vz + outer + pad) * per_g, -sp.oo)
        up = IfLess(0, to_top, hold(vz - inner + pad) * per_g, hold(last, r"\overline Z_2"))
        down = IfLess(0, to_top, hold(vz + inner - pad) * per_g, sp.oo)
        return _two(first, up, down, last, "Z")

    def _annulus_intervals(self) -> tuple[Window, Window]:
        """Return the inward and the outward interval of |rho - R_H| <= R.

        The roots of rho = c are (-q ± sqrt(V² c² - L²)) / V² with q = x vx + y vy. The rounding
        error of L² is bounded by 6 u rho² V², since (|x vy| + |y vx|)² <= 2 rho² V². A ball that
        hardly moves sideways is always in the interval: the search then decides.
        """
        rho_squared, q, speed_squared, moment = self.polar()
        innermost, outermost = self.radii()
        error = 16 * self.unit * speed_squared * hold(rho_squared + outermost**2)
        enters = hold(speed_squared * outermost**2 - moment**2 + error)
        passes = hold(speed_squared * innermost**2 - moment**2 - error)
        outer, inner = sp.sqrt(enters), sp.sqrt(largest(passes, 0))
        pad = hold(16 * self.unit * hold(size(q) + size(moment) + outer), "p_A")
        per = hold(1 / speed_squared)
        hardly = self.hardly
        first = IfAtMost(0, enters, hold(-q - outer - pad) * per, sp.oo)
        last = IfAtMost(0, enters, hold(-q + outer + pad) * per, -sp.oo)
        first = IfLess(hardly, speed_squared, first, -sp.oo)
        last = IfLess(hardly, speed_squared, last, sp.oo)
        through = IfLess(hardly, speed_squared, passes, 0)
        inward = IfLess(0, through, hold(-q - inner + pad) * per, hold(last, r"\overline A_2"))
        outward = IfLess(0, through, hold(-q + inner - pad) * per, sp.oo)
        return _two(first, inward, outward, last, "A")

    def _here(self) -> tuple[sp.Matrix, sp.Matrix, sp.Expr]:
        """Return position, velocity and rho at time t."""
        there, moving = self.flight.named()
        return there, moving, sp.sqrt(hold(there[0] ** 2 + there[1] ** 2, r"\rho_t^2"))

    def _inverses(self, rho: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
        """Return 1/rho and 1/(rho + rho0) by one division."""
        both = hold(rho + rho_start)
        inverse = hold(1 / hold(rho * both))
        return hold(inverse * both), hold(inverse * rho)

    def _outward_speed(self) -> sp.Expr:
        """The rate of rho."""
        there, moving, rho = self._here()
        per_rho, _ = self._inverses(rho)
        return hold(hold(there[0] * moving[0] + there[1] * moving[1]) * per_rho)

    @property
    def gap(self) -> sp.Expr:
        """F at the position at time t."""
        there, _, rho = self._here()
        reach = hold(self.ring.reach, "R")
        return hold(rho - self.ring.ring_radius) ** 2 + there[2] ** 2 - reach**2

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
        inward = hold(hold(rho - radius) + hold(rho_start - radius))
        radial = hold(hold(outward) * inward) * self._inverses(rho)[1]
        return t * hold(radial + hold(upward) * hold(there[2] + z0))

    @property
    def rate(self) -> sp.Expr:
        """F' = 2 ((rho - R_H) rho' + z z')."""
        there, moving, rho = self._here()
        depth = hold(rho - self.ring.ring_radius)
        return 2 * hold(depth * self._outward_speed() + there[2] * moving[2])

    @property
    def bend(self) -> sp.Expr:
        """F'' as in the head of this file."""
        there, _, rho = self._here()
        return steady - 6 * self.gravity * there[2] - swing * self._inverses(rho)[0] ** 3

    def curvature(self, width: sp.Expr) -> sp.Expr:
        """-F'' is largest where z is highest and rho smallest; each is bounded on its own.

        rho is convex in time, and so never below its tangent.
        """
        there, moving, rho = self._here()
        innermost, _ = self.radii()
        around, above = self.blur(width)
        rising = hold(there[2] + largest(moving[2], 0) * width)
        highest = smallest(hold(rising + above), self.reach)
        tangent = hold(rho + smallest(self._outward_speed(), 0) * width)
        least = largest(hold(tangent - around), innermost)
        fall = 6 * self.gravity * highest
        turn = swing * hold(1 / hold(least)) ** 3
        slack = self.ease * hold(size(fall) + turn + size(steady))
        return fall + turn - steady + slack

    def blur(self, width: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
        """Return more than what roundings make of rho and of z, along their tangents."""
        del width
        _, outermost = self.radii()
        return (self.ease * outermost,) * 2

    @property
    def clear(self) -> sp.Expr:
        """Positive if the ball certainly misses the ring before the horizon (`clear.py`)."""
        return clear(self)

    @property
    def ceiling(self) -> sp.Expr:
        """Each term of F'' at its largest: |z| <= R and rho >= I in every window."""
        innermost, _ = self.radii()
        turn = self.constants["swing"] * hold(1 / innermost) ** 3
        return size(self.constants["steady"]) + 6 * self.gravity * self.reach + turn

    @property
    def margins(self) -> dict[str, sp.Expr]:
        """What errors of the state and roundings make of F, F/t and F' within the windows.

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

        The last two are generous. Errors of F/t and F' that were sought out stay below a tenth of
        their margins, and would below two fifths with nothing for these roundings: Eq. 3's own,
        which are bounded on every axis at once, cover them.
        """
        u, root = UNIT_ROUNDOFF, sp.Rational(5, 2)
        reach = self.reach
        innermost, outermost = self.radii()
        stretch = largest(1, reach / innermost)
        furthest, fastest = self.flight.size(horizon)
        there, moving = self.flight.rounding(horizon)
        slope = hold(2 * root * hold(reach * moving.error + hold(stretch * fastest) * there.error))
        steepest = Rounded(2 * hold(reach * fastest))
        gap = 2 * root * reach * there.error + 12 * u * reach * outermost
        mean = slope + 32 * u * fastest * hold(stretch * furthest + outermost)
        return {
            "margin": SAFETY * hold(gap + time_rounding(steepest) * horizon),
            "leaving_margin": SAFETY * hold(mean + time_rounding(steepest)),
            "rate_margin": SAFETY * hold(slope + 32 * u * hold(outermost * fastest)),
        }


def _two(
    first: sp.Expr, until: sp.Expr, again: sp.Expr, last: sp.Expr, name: str
) -> tuple[Window, Window]:
    """Return the intervals from `first` until `until` and from `again` until `last`, named.

    The pads of two roots that nearly meet would make the second begin before the first ends.
    """
    end = hold(until, rf"\overline {name}_1")
    return (
        (hold(first, rf"\underline {name}_1"), end),
        (hold(largest(again, end), rf"\underline {name}_2"), hold(last, rf"\overline {name}_2")),
    )


def _meet(left: Window, right: Window) -> Window:
    return largest(left[0], right[0]), smallest(left[1], right[1])
