"""The ring's search in single precision: half the work, and enough for nearly every flight.

The flight is expanded at its place at t0, where the first window opens. Between there and the
end of the last window, D later, the ball is over the annulus at both ends, so that horizontally it
goes no further than twice the annulus's outer radius A = R_H + R, and vertically |vz| D is at most
3/2 g D² + 2 R. With v = 2^-24, the unit roundoff of single precision, all roundings are counted as
errors of the place and of the velocity,

    p = 2^-20 (A + g D²) = 16 v (A + g D²)    and    2^-22 |v|:

the roundings of the place are 6 v A + 7/2 v g D², those of the gap's formula count as 5/2 v A,
those of times and steps as 6 v A + 5/2 v g D²; and p less the first of these covers the roundings
of the rate, 32 v A |v|. `RingRootFinder.margins` turns these errors, and those of the state that a
search allows for, into the margins used here. Of 16 v A no more than 29/2 v A are counted; the rest
is left for errors of the state (`SinglePrecisionRing.excess`).

Just after the ball has left the ring, F and F' are smaller than these margins. There

    F = t (F'_0 + t H),    F' = 2 F/t - F'_0,

with F'_0 from double precision and H, half of F'' at first, known to 69 v max(1, R/I) A/I of C,
which bounds |F''|: each of H's terms is at most C, or C max(1, R/I), and rho known to 6 v A. Where
no third derivative exceeds K, F' is off by at most K t²/6: its weights at time s in F' and in 2 F/t
differ by s (t - s)/t. Errors of the state that a search allows for are a share of it, and a short
hop bears a small share alone: how much follows from F'_0.

The roundings of the bound on F'' stay below `blur` and `ease`: rho is off by 6 v A, and rho' by
v V (15 A/I + 8), less than 2^-13 V where A <= 2^5 I; z and its tangent by 1424 v R, less than
2^-13 R, where g D² <= 2^7 R; the rest is relative, 8 v. Times at the edges of windows are off by
what the ball moves 2^-16 R in; no contact can begin there, as they are wider by 2^-14 R.

So a step contains no root of the true flight, either, and if the slope r fulfils
r² > 16 C (F - m + 2 m) one simple root follows, to which Newton's method converges: F itself is at
most F - m + 2 m, and so h < 2^-4. C bounds |F''| on twice the way to the root. A search that makes
no headway, because F is within its margin or a step does not move the time, goes on from there in
double precision; so does one of other sizes, or one that meets a NaN.

**Lemma (margins in single precision).** Let the premises of the lemma of `RingRootFinder.margins`
hold, with `SinglePrecisionRing.excess` at most zero. In the windows, at a time t since t0 that is a
number of single precision, the true F, F' and F/t are within `allowed` and `rate_allowed` of those
computed.

*Proof.* Let v = 2^-24. The place at t0 is off by 4 u X in double precision, less than 2^-35 A, for
which the share 2^-10 of 16 v A that `ROUNDING_SLACK` adds suffices. In the windows |vz t| is at
most 2 R + g D²/2, whatever is between them, since the ball is in the slab at both times; and
sideways it goes no further than 2 A, as rho² is convex. A ball that hardly moves sideways may be
beyond A; there its F, and that of the true ball, is far from zero.

So x is off by 6 v A, with the roundings of x0 and of the sum, at most v A each, of vx and of the
product, 2 v A each; z alike by 8 v R + 3/2 v g D² < 4 v A + 2 v g D². In F, d is off by
2 v rho + v R_H + v |d| <= 3 v A and R² by 5 v R²: 6 v R A + 11 v R² < 11.5 v R A, as of a
place that is off by 5/2 v A. A step rounds by 12 v of the parabola's apex (`root_finder.py`), at
most 12 v R², as of 6/5 v A, and t + s by v of the way of the ball, v (3 A + 3/2 g D²). Together
these are less than 14.5 v A + 6 v g D².

F' is off by 2 (3 v A V + 13 v R V) + 4 v R V besides, less than 32 v A V, for which 10 v A of p are
left; velocities by v |v|, v |v - g t| and v g t, less than 4 v V.

*Near the surface that the ball left.* F/t changes with errors p and v of the state by less than
5 (R v + max(1, R/I) V p), and F' of the true flight, wherever it is used, by less than
5 (R v + max(1, R/I) V (p + T v)). `excess` has that the first, with p + T v/2, is at most what
`carried` is, and the second is at most twice that. F'_0 is off by 19 u A V in double precision,
less than 2^-44 of `whole`, as X > A/2^8; then by v |F'_0|, and by as much in the sum with t H. Of
H, with C >= 2 V² + 2 z'² + 2 g R, the parts are off by

    3 v (A/I) C by d0, 6 v max(1, R/I) (A/I) C by the divisor rho + rho0,
    8 v max(1, R/I) (A/I) C by the mean w of rho' in the product with rho'_0,
    15 v (A/I) C by w², and 10 v C by the others:

less than 69 v max(1, R/I) (A/I) C, of which `quotient_margin` has 128, the sum t H included. ∎
"""

from __future__ import annotations

from typing import ClassVar

import sympy as sp

from ...symbolic.conditionals import (
    AtMost,
    Choose,
    Less,
    Not,
    absolute,
    all_of,
    any_of,
    barrier,
    maximum,
    minimum,
)
from ...symbolic.rounding import ROUNDING_SLACK, extent, speed
from ...symbolic.symbols import POSITION, VELOCITY, t
from ..box_windows import enter, opening
from ..event_polynomials import (
    ERROR_BUDGET_LEVELS,
    ceiling,
    end,
    horizon,
    leaving,
    rate_margin,
    share,
)
from ..predicates import flat, tilt
from .double import RingRootFinder
from .polar import energy2, moment2, rho_start

MAX_STEPS = 24
"""Steps after which the search goes on in double precision; it takes about two."""

start_rate, rho_rate = sp.symbols("start_rate rho_rate", real=True)
"""F' and rho' at the start of a flight, from the state in double precision."""

jerk = sp.Symbol("jerk", nonnegative=True)
"""A sixth of a bound on the third derivative of F."""

quotient_margin = sp.Symbol("quotient_margin", nonnegative=True)
"""Bound on the error of H, the curvature term of the deflated gap."""

_LONGEST, _SHORTEST = sp.Integer(2) ** 12, sp.Rational(1, 2**12)
"""Between these lengths, speeds and accelerations, in SI units, nothing over- or underflows."""

_TILTED = barrier(tilt + quotient_margin * t)
_NEAR = Less(barrier(t * _TILTED), flat)
"""True near the surface that the ball left, where F/t is more exact than F; for any other flight
`tilt` is infinite."""

_JERKED = barrier(jerk * t**2)
_QUICK = all_of(_NEAR, Less(_JERKED, rate_margin))
"""True where F' is more exact from F/t."""


SPARE = sp.Rational(3, 2**25)
"""Share of the annulus's outer radius by which margins of a place exceed the roundings: 3/2 v."""


class SinglePrecisionRing(RingRootFinder):
    """The root finder for the ring in single precision."""

    unit: ClassVar[sp.Expr] = sp.Rational(1, 2**24)
    hardly: ClassVar[sp.Expr] = sp.Rational(1, 2**60)
    ease: ClassVar[sp.Expr] = sp.Rational(1, 2**18)

    @property
    def passed(self) -> tuple[sp.Symbol, ...]:
        """Arguments of its kernels beside the constants of the flight: margins and windows."""
        return (
            flat,
            tilt,
            quotient_margin,
            jerk,
            start_rate,
            rho_rate,
            *(edge for window in self._later() for edge in window),
        )

    @property
    def excess(self) -> sp.Expr:
        """Positive if errors of the state exceed those that the margins contain.

        With c = 3/2 v A and the letters of `RingRootFinder.excess` the margins contain

            5 R (s X + c) of F,    5 (R s V + max(1, R/I) V (s X + c)) of F',
            5 (R s V + max(1, R/I) V s X) of F/t, and twice that of F' where it is 2 F/t - F'_0.

        F/t is the mean of F' since the start, so places count as off by p + T v/2 there; and F' is
        off by at most twice as much as that would make it.
        """
        _, outermost = self.radii()
        furthest, _ = self.flight.size(horizon)
        allowed = barrier(share * furthest)
        moved = barrier(self._moved_by_errors(horizon) - allowed - SPARE * outermost)
        return self._exceeding(
            moved, maximum(barrier(self._moved_by_errors(horizon / 2) - allowed), moved)
        )

    def _later(self) -> list[tuple[sp.Symbol, sp.Symbol]]:
        """Return the windows after the first, which nothing precedes."""
        return opening(len(self.windows))[1:]

    def headroom(self, low_gap: sp.Expr, turned: bool) -> sp.Expr:
        """Return 2 (F - m + 2 m), twice a bound on F itself."""
        return 2 * barrier(low_gap + 2 * self.allowed)

    def beyond(self, low_gap: sp.Expr) -> sp.Expr:
        """Return a bound on F itself: the window should contain the root."""
        return low_gap + 4 * self.allowed

    def steepest(
        self, width: sp.Expr, curvature: sp.Expr, fall: sp.Expr, reach: sp.Expr
    ) -> sp.Expr:
        """Return C on that window, if it is twice as long as the first step of Newton's method.

        -F'' <= M there; and F'' grows by no more than z sinks and rho grows.
        """
        _, moving, rho = self._here()
        inverse = self._inverses(rho)[0]
        there = self._here()[0]
        moved = self._moved(width)
        turn = barrier(moment2 * inverse**3)
        weight = 6 * self.gravity * there[2]
        sinking = barrier(barrier(maximum(-moving[2], 0) + self.gravity * width) * width)
        sinking = barrier(sinking + 2 * self.blur(width)[1])
        growing = barrier(6 * self.gravity * sinking + 3 * barrier(turn * inverse) * moved)
        slack = sp.Rational(1, 2**12) * barrier(absolute(energy2) + absolute(weight) + turn)
        upper = barrier(self.bend + barrier(growing + slack))
        return Choose(AtMost(reach, barrier(width * fall)), maximum(curvature, upper), ceiling)

    def _moved(self, width: sp.Expr) -> sp.Expr:
        """Return a bound on how far the ball moves sideways in that time."""
        vx, vy, _ = VELOCITY
        return barrier(barrier(sp.Abs(vx) + sp.Abs(vy)) * width)

    @property
    def allowed(self) -> sp.Expr:
        """The margin of F in its more exact form."""
        return barrier(Choose(_NEAR, barrier(t * _TILTED), flat))

    def _searched(self) -> sp.Expr:
        return Choose(_NEAR, barrier(self.leaving_gap, r"F_\ell"), barrier(self.gap, "F"))

    def opened(self) -> dict[str, sp.Basic]:
        """Return the first window, the others, the end of the last, and whether to rely on them.

        Other sizes may over- or underflow.
        """
        innermost, outermost = self.radii()
        latest = barrier(horizon * (1 + sp.Rational(1, 2**22)))
        found = [
            (barrier(maximum(0, low)), barrier(minimum(latest, high))) for low, high in self.windows
        ]
        first = enter(found, *(sp.Integer(0),) * 3)
        later = {
            edge.name: value
            for window, values in zip(self._later(), found[1:], strict=True)
            for edge, value in zip(window, values, strict=True)
        }
        ends = barrier(minimum(latest, maximum(0, *(high for _, high in self.windows))))
        sound = all_of(
            AtMost(outermost, 2**5 * innermost),
            AtMost(outermost, 2**5 * self.ring.reach),
            AtMost(outermost, _LONGEST),
            AtMost(_SHORTEST, innermost),
            AtMost(self.gravity, _LONGEST),
            AtMost(_SHORTEST, self.gravity),
            AtMost(extent, _LONGEST),
            AtMost(speed, _LONGEST),
        )
        return first | later | {"latest": ends, "representable": sound}

    def blur(self, width: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
        """Return the same bounds for single precision; their derivation stands above."""
        _, outermost = self.radii()
        around = sp.Rational(1, 2**20) * outermost + sp.Rational(1, 2**13) * self._moved(width)
        return around, sp.Rational(1, 2**13) * self.ring.reach

    @property
    def rate(self) -> sp.Expr:
        """F'; soon after the start 2 F/t - F'_0, off by K t²/6 and twice the error of F/t."""
        return Choose(_QUICK, barrier(2 * self._mean_rate() - start_rate), barrier(super().rate))

    @property
    def rate_allowed(self) -> sp.Expr:
        """The margin of F' in its more exact form."""
        return barrier(Choose(_QUICK, barrier(2 * _TILTED + _JERKED), rate_margin))

    @property
    def leaving_gap(self) -> sp.Expr:
        """F = t F/t."""
        return t * self._mean_rate()

    def _mean_rate(self) -> sp.Expr:
        """Return F/t = F'_0 + t H, H being half of F'' at the start and known to its own size.

        With w the mean of rho' since then,

            H = 2 (rho0 - R_H) (V² - rho'_0 w) / (rho + rho0) + w² + (vz - g t/2)² - g z0.
        """
        _, _, rho = self._here()
        _, q, speed_squared, _ = self.polar()
        _, _, z0 = POSITION
        _, _, vz = VELOCITY
        per = self._inverses(rho)[1]
        mean = barrier(barrier(2 * q + speed_squared * t) * per)
        inward = 2 * barrier(rho_start - self.ring.ring_radius)
        turning = barrier(inward * barrier(speed_squared - rho_rate * mean)) * per
        upward = barrier(vz - self.gravity * t / 2)
        return barrier(start_rate + t * barrier(turning + mean**2 + upward**2 - self.gravity * z0))

    def started(self) -> dict[str, sp.Expr]:
        """Return rho, and F' and rho', at the start of the flight, in double precision."""
        x, y, z = POSITION
        vx, vy, vz = VELOCITY
        start = barrier(self.ring.rho)
        outward = barrier(barrier(x * vx + y * vy) / start)
        depth = barrier(start - self.ring.ring_radius)
        rate = 2 * barrier(depth * outward + z * vz)
        return {"rho_start": start, "start_rate": rate, "rho_rate": outward}

    def grain(self) -> dict[str, sp.Basic]:
        """Return the search from t on, where the first window opens: all arguments of `step`.

        The state is that at t, and `horizon` is the end of the last window.
        """
        innermost, outermost = self.radii()
        lasting = barrier(horizon - t)
        dropped = barrier(self.gravity * lasting**2)
        fastest = barrier(speed + self.gravity * horizon)
        fits = all_of(
            AtMost(dropped, 2**7 * self.ring.reach),
            # F/t is of the place where the ball left.
            AtMost(leaving * t, 0),
        )
        furthest = barrier(extent + horizon * fastest)
        reach = barrier(self.ring.reach, "R")
        stretch = barrier(maximum(1, reach / innermost))
        whole = barrier(5 * barrier(reach * fastest + barrier(stretch * fastest) * furthest))
        bearable = barrier(sp.Rational(1, 2**8) * start_rate / whole)
        finer = maximum(ERROR_BUDGET_LEVELS[-1], minimum(ERROR_BUDGET_LEVELS[0], bearable))
        allowing = barrier(Choose(Less(0, leaving), finer, ERROR_BUDGET_LEVELS[0]))
        place = ROUNDING_SLACK * barrier(
            allowing * furthest + sp.Rational(1, 2**20) * barrier(outermost + dropped)
        )
        motion = (allowing + sp.Rational(1, 2**22)) * fastest
        slope = barrier(5 * barrier(reach * motion + barrier(stretch * fastest) * place))
        carried = barrier(barrier(allowing + sp.Rational(1, 2**44)) * whole)
        constants = {name: barrier(value) for name, value in self.constants.items()}
        turn = constants["moment2"] * barrier(1 / innermost) ** 3
        bend = barrier(absolute(constants["energy2"]) + 6 * self.gravity * self.reach + turn)
        tilting = carried + sp.Rational(1, 2**21) * absolute(start_rate)
        # The third derivative is at most 6 g |z'| + 3 (2 R_H L²) |rho'| / rho^4.
        vx, vy, vz = VELOCITY
        sideways, upright = (
            barrier(sp.Abs(vx) + sp.Abs(vy)),
            barrier(sp.Abs(vz) + self.gravity * lasting),
        )
        windows = {edge.name: edge - t for window in self._later() for edge in window}
        return {
            "share": allowing,
            "t": sp.Integer(0),
            "end": end - t,
            **{s.name: s for s in (*POSITION, *VELOCITY)},
            **constants,
            "ceiling": ROUNDING_SLACK * bend,
            "flat": 5 * reach * place,
            "tilt": Choose(Less(0, leaving), ROUNDING_SLACK * barrier(tilting), sp.oo),
            "jerk": ROUNDING_SLACK
            * barrier(self.gravity * upright + barrier(turn * sideways) / (2 * innermost)),
            "quotient_margin": sp.Rational(1, 2**17)
            * barrier(stretch * barrier(outermost / innermost))
            * bend,
            "start_rate": start_rate,
            "rho_rate": rho_rate,
            "rate_margin": slope,
            **windows,
            "fits": fits,
        }

    def leap(self) -> dict[str, sp.Basic]:
        """Return time and window of the search after a step, and its state.

        `certain` is true if one simple root follows, to which Newton's method converges from `t`.
        `t` is infinite if no window is left.
        """
        step_outputs = self.advance()
        gap, rate, step, following = (
            step_outputs[name] for name in ("gap", "rate", "step", "next")
        )
        allowed = self.allowed
        sure = Less(0, step_outputs["clearance"])
        closing = all_of(Less(rate, 0), AtMost(gap - allowed, allowed))
        still = all_of(Less(t, end), Not(Less(t, following)))
        stuck = all_of(Not(sure), any_of(closing, still))
        exhausted = all_of(Not(any_of(sure, stuck)), AtMost(end - t, step))
        entered = enter(self._later(), end, sp.oo)
        more = entered["searching"]
        return {
            "t": Choose(exhausted, entered["t"], Choose(stuck, t, following)),
            "end": Choose(exhausted, entered["end"], end),
            "certain": sure,
            "stepping": all_of(Not(any_of(sure, stuck)), any_of(Not(exhausted), more)),
        }
