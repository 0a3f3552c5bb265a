"""The search for a box: a bound on F'' in closed form, the same on all parts of the box.

With e for how far a coordinate is beyond a face (`surfaces/box.py`), F = Σ e² - R_B². Where F''
exists, it is the sum of 2 v² + 2 e a over the coordinates with e not zero, at least -2 Σ |e a|. F'
is continuous, which suffices for steps from the left and Newton's method.

In the lemmas gravity g is along an axis; F, E, F^, m, m', G, S, M and C are those of
`root_finder.py`, w is the inflation of the box, and T the end of its last window. V = |v| + g T and
X = |x| + T V are sums of sizes, X <= 2^40 R_B: it is at most 2^16 R (`scenes/premises.py`). The
error of a coordinate until T is at most d = p + v T + 4 u X (`Parabola.rounding`), with the errors
p and v of the budget. The faces' places are inputs of the scene; in `COURT` some are sums
f = a + b of two, of the opposite face and the width. R̂ = R_B + 2 w.

**Lemma (reach).** In the windows |e| <= R̂, for the true ball, the computed state's, and as
computed. The last are off by at most δ/2 >= d, with δ of `_roundings`.

*Proof.* By the lemma of `box_windows.py` the ball of the computed state is within h + w + η, so
that its e is at most R_B + 5/4 w; the true ball is off by w/4, and roundings are less than that. e
changes by no more than its coordinate does, d, and is one difference from an input, off by u |e|. δ
is 2 d and both differences' u (X + |low|) and u (X + |high|), of which either is at least u |e|. A
face that is a sum is off by u |f| besides, and δ/2 has 3/2 u (X + |a|) + u |b| for u (|e| + |f|).
Beyond it, on the side that is further from zero, |e| + |f| is the coordinate, at most X. Only under
a bridge that is thinner than the wire f is of the other sign: 0 < f < a, the wire's radius, which
is at most |x| <= X there, since R_H >= 3/2 R. Then |e| + |f| <= X + a. ∎

**Lemma (curvature).** While t + s is in a window, E'(t + s) >= E'(t) - M s - 2 V d; and |F''| <= C
as long as each |e| is at most 5/4 R̂ and |v|² at most 3 V². M has at least 2^-41 C to spare.

*Proof.* E' and F' are continuous, at the seams too, so they are integrals of their derivatives. As
v² is not negative, -E'' <= 2 g |e_z|; and |e_z| at t + s is at most that at t, |v_z| s and g s²/2
together, and at most R̂. As computed, e_z is off by ε <= 3 u X besides roundings relative to R̂; with
those of M, all relative, they make less than 2^-41 (5/2 g R̂ + 6 V²) = 2^-41 C. ε makes E' smaller
by no more than 2 g ε s <= 2 V ε < 2 V d. |F''| <= 2 |v|² + 2 g |e_z| <= C. ∎

m' has 2 V d to spare, as it has 2 V δ and needs half of that: so the lemma of steps holds.

*Roundings of a step.* Where the parabola rises first, the root is off by 4 u of itself, and the sum
t + s by u (t + s); if t <= s, they move the parabola by less than 12 u M s², which the spare part
of M contains. Where it falls first, they move it by 8 u G, and by 4 u G if t <= s. As s <= T, or
the step ends with the window, G <= |S| s + M s²/2 <= 3 R̂ V T + 2^46 R̂ d, with 2 m' T of |S|. Of m 6
R̂ d >= 24 u R̂ X are left over, and 10 u R̂ V T of the 12 for neighbouring times, of which the sum, if
t > s, needs 2. On a return G <= 2 R̂ V t, and of 60 u R̂ V t 10 are used (`margins`).

**Lemma (certain root).** Let r = -F^' - m' > 0 and r² > 8 C (2 G + m). Then the true F has a zero
after t, where the ball meets the box, and the first one is simple.

*Proof.* F(t) <= G + 2 m <= 2 (2 G + m), and so r² > 4 C F(t); as r <= 2 R̂ V and C >= 6 V², F(t) <
R̂²/6. While F' < 0, Σ e² does not grow beyond F(t) + R_B² < 7/6 R̂², so that each |e| < 5/4 R̂: this
is where a coordinate that grows takes part in a sum that falls. Until 2 F(t)/r, also if that is
after T, the velocity changes by g 2 F/r < g sqrt(F/C) <= V/2, since C >= 5/2 g R̂ and g F < 0.4 R̂
V²; and the errors are a tiny part of V. So |F''| <= C as long as F' < 0, and F'(t + s) <= -r + C s
is negative until r/C > 2 F(t)/r, when F has fallen through zero, as F(t) - r s + C s²/2 has. F is
the squared distance from the box less R_B² everywhere, so this is a contact. ∎

*Where Newton's method ends.* As on the ring, |F| <= 2^-49 F'²/C besides roundings, and C >= 6 V²
makes that at most 11 u R̂², while m has 12 u R̂² + 4 u R_B² at least. On a return m has 96 u R̂ V t
at least. Either F' = 0 in between and |F''| <= C, so that |F'| <= C t, and it is at most 2^-49 |F'|
t <= 32 u R̂ V t; or the ball was beyond 5/4 R̂, so that V t >= R̂/2, and 11 u R̂² are less than a
third of m. So |F| <= 7/3 m for the lemma in `event_polynomials.crossing`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import sympy as sp

from ..surfaces import Box
from ..symbolic.conditionals import IfLess, absolute, barrier, minimum
from ..symbolic.error_terms import earliest_delay
from ..symbolic.rounding import ROUNDING_SLACK, Rounded, rounding
from ..symbolic.symbols import POSITION, VELOCITY, t
from .bounding_boxes import may_reach_box, may_reach_plate
from .box_windows import RELATIVE_INFLATION, lost, windows
from .event_polynomials import Window, ceiling, horizon, time_rounding
from .polynomial import CEILING_BOX_FACTOR
from .predicates import pad
from .root_finder import RootFinder
from .separation import may_approach

EXCESS = sp.symbols("ex ey ez", real=True)
"""Distance of each coordinate beyond a face."""


@dataclass(frozen=True)
class BoxRootFinder(RootFinder):
    """The root finder for a box, whichever part of it comes first."""

    box: Box

    @property
    def constants(self) -> dict[str, sp.Expr]:
        """No constants."""
        return {}

    @property
    def _reach(self) -> sp.Expr:
        """Bound on how far beyond a face the ball is within the windows."""
        return barrier(self.box.radius + 2 * RELATIVE_INFLATION * minimum(*self.box.half_sizes))

    @property
    def named(self) -> dict[str, sp.Expr]:
        """Position, velocity and how far each coordinate is beyond a face."""
        excess = (e for e, _, _ in self._moving())
        return super().named | {rf"\Delta_{axis}": e for axis, e in zip("xyz", excess, strict=True)}

    @property
    def windows(self) -> list[Window]:
        """The times at which the ball is near enough along every axis."""
        offsets = (barrier(p - c) for p, c in zip(POSITION, self.box.reference_point, strict=True))
        axes = zip(offsets, VELOCITY, self.flight.acceleration, strict=True)
        return windows(list(axes), self.box.half_sizes)

    @property
    def reach_test(self) -> dict[str, sp.Basic]:
        """Compare the flight with the planes of a plate, or its halves with the rounded box."""
        axis = self._plate_axis
        if axis is None:
            return may_reach_box(self.box)
        return may_reach_plate(self.box, axis, self.flight)

    @property
    def approach_test(self) -> dict[str, sp.Basic]:
        """Test whether the ball moves away from the box in all that comes near it."""
        return may_approach(self.box, self.flight, self._plate_axis is None)

    @property
    def _plate_axis(self) -> int | None:
        """The axis across the faces of a plate, if the flight has no acceleration along it."""
        axis = self.box.plate_axis
        return None if axis is None or self.flight.acceleration[axis] != 0 else axis

    @property
    def lost(self) -> sp.Expr:
        """Positive if errors come near to the inflation of the windows.

        Or if the earliest arrival may be so late that the ball flies on by more than a quarter of
        the inflation until then. Else a contact until then has its window open at the horizon, and
        there it is undecided if the horizon is too early (`out_of_budget`).
        """
        _, fastest = self.flight.size(horizon)
        late = barrier(IfLess(2 * pad, earliest_delay, fastest * earliest_delay, 0))
        excess = lost(self.box.reference_point, self.box.half_sizes, self.flight.acceleration)
        return barrier(excess + late)

    def _moving(self) -> list[tuple[sp.Expr, sp.Expr, sp.Expr]]:
        """Return e, velocity and acceleration of each coordinate at time t."""
        there, moving = self.flight.named()
        now = dict(zip(POSITION, there, strict=True))
        excess = [e.xreplace(now) for e in self.box.excess]
        moved = zip(self.box.turned(list(moving)), self.box.turned(self._pulls()), strict=True)
        return [(e, v, a) for e, (v, a) in zip(excess, moved, strict=True)]

    def _pulls(self) -> Sequence[sp.Expr]:
        """Return the acceleration at time t along the scene's axes."""
        return self.flight.acceleration

    @property
    def gap(self) -> sp.Expr:
        """F at the position at time t."""
        return sp.Add(*(e**2 for e, _, _ in self._moving()), -(self.box.scaled_radius**2))

    @property
    def leaving_gap(self) -> sp.Expr:
        """The sum of the changes of e².

        Each is a product with t if e has the same sign now and at the start. Else one of the two is
        zero, or they are on both sides of the box: the rest is then no further beyond its face than
        the ball has flown, and as exact as a product with t (`margins`).
        """
        changes = []
        means = self.box.turned(self.flight.mean_velocity())
        for (e, _, _), start, mean in zip(self._moving(), self.box.excess, means, strict=True):
            product = t * barrier(barrier(mean) * barrier(e + start))
            changes.append(
                barrier(IfLess(0, e * start, product, barrier(e**2) - barrier(start**2)))
            )
        return sp.Add(*changes)

    @property
    def rate(self) -> sp.Expr:
        """F' = 2 Σ e v."""
        return 2 * barrier(sp.Add(*(e * v for e, v, _ in self._moving())))

    @property
    def bend(self) -> sp.Expr:
        """F'' as above."""
        parts = (IfLess(0, absolute(e), barrier(v**2 + e * a), 0) for e, v, a in self._moving())
        return 2 * barrier(sp.Add(*parts))

    def curvature(self, width: sp.Expr) -> sp.Expr:
        """Return the bound of the accelerations' part: v² bends F upwards alone."""
        return self._pull_bound(width)

    def _pull_bound(self, width: sp.Expr) -> sp.Expr:
        """Return 2 Σ |e a| with the largest e; a coordinate far away stays within the windows."""
        most = []
        for e, v, a in self._moving():
            if a != 0:
                drift = barrier(absolute(v) + absolute(a) * width / 2) * width
                most.append(absolute(a) * minimum(barrier(absolute(e) + drift), self._reach))
        slack = sp.Rational(1, 2**40) * ceiling
        return 2 * barrier(sp.Add(*most)) + slack

    def turned_curvature(self, width: sp.Expr) -> sp.Expr:
        """Return 2 Σ (v² + |e a|) with the largest v and e."""
        squares = (barrier(fastest) ** 2 for fastest in self._fastest_within(width))
        return barrier(self._pull_bound(width) + 2 * barrier(sp.Add(*squares)))

    def _fastest_within(self, width: sp.Expr) -> list[sp.Expr]:
        """Return a bound on the size of each velocity within a window."""
        return [absolute(v) + absolute(a) * width for _, v, a in self._moving()]

    @property
    def ceiling(self) -> sp.Expr:
        """The sum of the largest sizes of the terms of F''."""
        falls = (
            CEILING_BOX_FACTOR * self._reach * absolute(a)
            for a in self.box.turned(self.flight.acceleration)
            if a != 0
        )
        return 2 * barrier(3 * self._fastest**2 + sp.Add(*falls))

    @property
    def _fastest(self) -> sp.Expr:
        """The largest velocity along an axis, in the unit of length of the box's faces."""
        return self.flight.size(horizon)[1]

    def _roundings(self) -> tuple[dict[sp.Expr, Rounded], dict[sp.Expr, Rounded]]:
        """Return bounds on e and the velocity, and on e and the mean velocity."""
        there, moved = self.flight.rounding(horizon)
        mean = self.flight.mean_rounding(horizon)
        now: dict[sp.Expr, Rounded] = dict.fromkeys(VELOCITY, moved)
        faces = zip(EXCESS, POSITION, self.box.low, self.box.high, strict=True)
        for e, place, low, high in faces:
            off = rounding(place - low, {place: there}).error
            off = off + rounding(place - high, {place: there}).error
            now[e] = Rounded(self._reach, barrier(off))
        return now, now | dict.fromkeys(VELOCITY, mean)

    def _gap_rounding(self, now: Mapping[sp.Expr, Rounded]) -> Rounded:
        """Return size and error of F."""
        return rounding(sp.Add(*(e**2 for e in EXCESS), -(self.box.scaled_radius**2)), now)

    @property
    def margins(self) -> dict[str, sp.Expr]:
        """Bounds by running error analysis; e is off by its coordinate's error and one sum.

        **Lemma (margins of a box).** In the windows F and F' of the true ball are within m and m'
        of those computed at the same time. On a return, F/t is within its margin of the one
        computed.

        *Proof.* By the lemma "reach" e² changes by at most R̂ δ. The squares, their sum and R_B²
        have roundings of 4 u Σ e² + 4 u R_B² <= 12 u R̂² + 4 u R_B². m has 2 R̂ δ of each axis and
        as many roundings. So F' changes by at most 2 Σ (V δ/2 + R̂ (v + 2 u V)), and has roundings
        of 3 u 2 R̂ V.

        On a return let s be e at the start, and k the mean velocity, off by v + 3 u V. A product
        k (e + s) is off by V δ + 2 R̂ (v + 3 u V). If e s <= 0 for the true ball alone, one of e
        and s is within δ/2 of zero, the other is at most |k| t, and e² - s² is off k t (e + s) by
        V δ t/2 more. As computed |e| and |s| are then at most 2 |k| t: the start is a double, and
        the place at t the one that is nearest to the sum of it and k t. So if e s <= 0 as computed
        alone, it is V δ t more. If it is so for both, e² and s² are each off by at most
        (1 + 2) V t δ/2. The roundings of the sum are less than 10 u R̂ V. The margin has 4 V δ +
        4 R̂ (v + 3 u V) of each axis and 60 u R̂ V. ∎
        """
        now, since = self._roundings()
        gap = self._gap_rounding(now)
        terms = [e * v for e, v in zip(EXCESS, VELOCITY, strict=True)]
        rate = rounding(2 * sp.Add(*terms), now)
        # F/t has the same bound with the mean velocity, for e now and at the start.
        change = rounding(2 * sp.Add(*terms), since)
        return {
            "margin": ROUNDING_SLACK * (gap.error + time_rounding(rate) * horizon),
            "leaving_margin": ROUNDING_SLACK * (2 * change.error + time_rounding(rate)),
            "rate_margin": ROUNDING_SLACK * rate.error,
        }
