"""The windows of the ring: the times at which a ball can touch it.

At a contact |z| <= R and |rho - R_H| <= R, where R = R_B + R_W. The lemma `ring_windows` in
templates/derivation/ring_search.md.j2 proves that three windows hold every contact, and says by how
much they are widened for roundings.

**Lemma (windows).** Let the errors p and v of the state fulfil p + v t <= 2^-15 R until the time t.
If the true ball is within |z| <= R and |rho - R_H| <= R at t, then t is in a window as computed, in
double and in single precision, and not on its edge.

*Proof.* The computed ball, from the same state without roundings, has |z| <= R (1 + 2^-15) then and
|rho - R_H| <= R (1 + 2^-14.4): it is within those of the windows, which are of the radius
R (1 + 2^-14) but for 4 u of it. So let t be between the exact roots for that radius, and ε = u be
the unit roundoff. In single precision the state and the parameters have one rounding each besides.

- *Slab.* D = vz² + 2 g (z - c) is off by at most 4 ε (vz² + 2 g (|z| + R)), in single precision by
  6 ε of it; the kernel counts 8. The root of D, the sum with vz, 1/g and the product are off by 5 ε
  (|vz| + sqrt(D))/g, in single precision 8 ε; 16 are counted.
- *Annulus.* |x vy| + |y vx| <= rho V and |x vx| + |y vy| <= rho V by Cauchy's inequality. So L² is
  off by 5 ε rho² V², V² A² by 4 ε V² A², and V² A² - L² in all by 7 ε V² (rho² + A²), in single
  precision 12 ε; 16 are counted. As rho V <= |q| + |L|, q is off by 2 ε (|q| + |L|), in single
  precision 4 ε; the sums, 1/V² and the product by 7 ε (|q| + root), or 9 ε; 16 are counted of
  |q| + |L| + root.

Discriminants and times are widened by these, so that no computed interval is shorter than the exact
one. The windows are cut off at zero and at the horizon, in single precision one that is 4 ε later,
since it has a rounding. ∎

`lost` is positive where p + v t exceeds 2^-16 R at the horizon, or at the time by which the ball
has fallen below the ring for good. With d = |x| + 2 R that is T = sqrt(2 d/g) + 2 |v|/g: then
|v| T - g T²/2 <= -d, so z <= -2 R, and the ball falls faster than 2 sqrt(g R), while v T is less
than 2^-16 R.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import sympy as sp

from ...symbolic.conditionals import IfAtMost, IfLess, absolute, barrier, maximum
from ...symbolic.symbols import POSITION, UNIT_ROUNDOFF, VELOCITY
from ..event_polynomials import Window, intersection
from .polar import PolarRootFinder


@dataclass(frozen=True)
class RingWindows(PolarRootFinder):
    """The part of the ring's root finder that bounds the times of its contacts."""

    unit: ClassVar[sp.Expr] = UNIT_ROUNDOFF
    """Unit roundoff of the arithmetic of the windows."""

    hardly: ClassVar[sp.Expr] = sp.Rational(1, 2**600)
    """Square of a horizontal speed below which the times of windows are unknown."""

    @property
    def windows(self) -> list[Window]:
        """The times at which |z| <= R and |rho - R_H| <= R can both hold.

        Each of the two holds in at most two intervals, Z1 < Z2 and A1 < A2. Of the four
        intersections Z1 A2 and Z2 A1 are not both possible, so three windows suffice. The
        discriminants are widened by their rounding errors, and so are the times.
        """
        (z1, z2), (a1, a2) = self._slab_intervals(), self._annulus_intervals()
        late_first = intersection(z1, a2)
        middle = tuple(
            IfAtMost(late_first[0], late_first[1], late, early)
            for late, early in zip(late_first, intersection(z2, a1), strict=True)
        )
        return [intersection(z1, a1), (middle[0], middle[1]), intersection(z2, a2)]

    def _slab_intervals(self) -> tuple[Window, Window]:
        """Return the rising and the falling interval of |z| <= R.

        The roots of z = c are (vz ± sqrt(D)) / g with D = vz² + 2 g (z0 - c).
        """
        g = self.gravity
        _, _, z = POSITION
        _, _, vz = VELOCITY
        reach = self.reach
        error = 8 * self.unit * barrier(vz**2 + 2 * g * (sp.Abs(z) + reach))
        to_bottom = barrier(vz**2 + 2 * g * barrier(z + reach) + error)
        to_top = barrier(vz**2 + 2 * g * barrier(z - reach) - error)
        outer, inner = sp.sqrt(to_bottom), sp.sqrt(maximum(to_top, 0))
        pad = barrier(16 * self.unit * barrier(sp.Abs(vz) + outer), "p_Z")
        per_g = barrier(1 / g)
        first = IfAtMost(0, to_bottom, barrier(vz - outer - pad) * per_g, sp.oo)
        last = IfAtMost(0, to_bottom, barrier(vz + outer + pad) * per_g, -sp.oo)
        up = IfLess(0, to_top, barrier(vz - inner + pad) * per_g, barrier(last, r"\overline Z_2"))
        down = IfLess(0, to_top, barrier(vz + inner - pad) * per_g, sp.oo)
        return _two(first, up, down, last, "Z")

    def _annulus_intervals(self) -> tuple[Window, Window]:
        """Return the inward and the outward interval of |rho - R_H| <= R.

        The roots of rho = c are (-q ± sqrt(V² c² - L²)) / V² with q = x vx + y vy. The rounding
        error of L² is bounded by 6 u rho² V², since (|x vy| + |y vx|)² <= 2 rho² V². A ball that
        hardly moves sideways counts as in the interval at all times: then the search decides.
        """
        rho_squared, q, speed_squared, moment = self.polar()
        innermost, outermost = self.radii()
        error = 16 * self.unit * speed_squared * barrier(rho_squared + outermost**2)
        enters = barrier(speed_squared * outermost**2 - moment**2 + error)
        passes = barrier(speed_squared * innermost**2 - moment**2 - error)
        outer, inner = sp.sqrt(enters), sp.sqrt(maximum(passes, 0))
        pad = barrier(16 * self.unit * barrier(absolute(q) + absolute(moment) + outer), "p_A")
        per = barrier(1 / speed_squared)
        hardly = self.hardly
        first = IfAtMost(0, enters, barrier(-q - outer - pad) * per, sp.oo)
        last = IfAtMost(0, enters, barrier(-q + outer + pad) * per, -sp.oo)
        first = IfLess(hardly, speed_squared, first, -sp.oo)
        last = IfLess(hardly, speed_squared, last, sp.oo)
        through = IfLess(hardly, speed_squared, passes, 0)
        inward = IfLess(
            0, through, barrier(-q - inner + pad) * per, barrier(last, r"\overline A_2")
        )
        outward = IfLess(0, through, barrier(-q + inner - pad) * per, sp.oo)
        return _two(first, inward, outward, last, "A")


def _two(
    first: sp.Expr, until: sp.Expr, again: sp.Expr, last: sp.Expr, name: str
) -> tuple[Window, Window]:
    """Return the intervals from `first` until `until` and from `again` until `last`, named.

    The pads of two roots that nearly meet would make the second begin before the first ends.
    """
    end = barrier(until, rf"\overline {name}_1")
    return (
        (barrier(first, rf"\underline {name}_1"), end),
        (
            barrier(maximum(again, end), rf"\underline {name}_2"),
            barrier(last, rf"\overline {name}_2"),
        ),
    )
