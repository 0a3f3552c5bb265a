"""The ring's search in single precision: half the work, and nearly every flight needs no more.

The flight is drawn anew from its place at t0, where the first window opens. Between there and the
end of the last window, D later, the ball is over the annulus at both ends, so that horizontally it
goes no further than twice the annulus's outer radius A = R_H + R, and vertically |vz| D is at most
3/2 g D² + 2 R. With v = 2^-24, the unit roundoff of single precision, all roundings are counted as
errors of the place and of the velocity,

    p = 2^-20 (A + g D²) = 16 v (A + g D²)    and    2^-22 |v|:

of the place itself there are 6 v A + 7/2 v g D², of the gap's formula what 5/2 v A would make, of
times and steps what 6 v A + 5/2 v g D² would; and p less the first of these makes more than the
roundings of the rate, 32 v A |v|. What `RingApproach.margins` makes of these errors, and of those
of the state that a search allows for, are the margins here.

Where the ball has just left the ring, F and F' are less than that. There

    F = t (F'_0 + t H),    F' = 2 F/t - F'_0,

with F'_0 from double precision and H, half of F'' at first, known to 69 v max(1, R/I) A/I of C,
which bounds |F''|: each of H's terms is at most C, or C max(1, R/I), and rho known to 6 v A. F' is
off by K t²/6 at the most where no third derivative exceeds K, whose weights in both differ by
s (t - s)/t. Errors of the state that a search allows for are a share of it, and a short hop bears
a small share alone: how much follows from F'_0.

Of the bound on F'' the roundings stay below `blur` and `ease`: rho is off by 6 v A, and rho' by
v V (15 A/I + 8), less than 2^-13 V where A <= 2^5 I; z and its tangent by 1424 v R, less than
2^-13 R, where g D² <= 2^7 R; the rest is relative, 8 v. Times at the edges of windows are off by
what the ball moves 2^-16 R in; no contact can begin there, as they are wider by 2^-14 R.

So a step is without a root for the true flight, too, and where the slope r fulfils
r² > 16 C (F - m + 2 m) one simple root follows, to which Newton's method converges: F itself is at
most F - m + 2 m, and so h < 2^-4. C bounds |F''| on twice the way to the root. A search that gets
no further, because F is within its margin or a step is none, goes on from there in double
precision; so does one that is not of those sizes, or in which anything is not a number.
"""

from __future__ import annotations

from typing import ClassVar

import sympy as sp

from ..ground.choice import (
    AtMost,
    Choose,
    Less,
    Not,
    every,
    hold,
    largest,
    size,
    smallest,
    some,
)
from ..ground.rounding import SAFETY, extent, speed
from ..ground.symbols import POSITION, VELOCITY, t
from .decisions import flat, tilt
from .events import SHARES, ceiling, end, horizon, leaving, rate_margin
from .polar import rho_start, steady, swing
from .ring import RingApproach
from .windows import enter, opening

TURNS = 24
"""Steps after which the search goes on in double precision; it takes about two."""

parting, drift = sp.symbols("parting drift", real=True)
"""F' and rho' at the start of a flight, from the state in double precision."""

jerk = sp.Symbol("jerk", nonnegative=True)
"""A sixth of a bound on the third derivative of F."""

grit = sp.Symbol("grit", nonnegative=True)
"""Bound on the error of what the deflated gap is bent by."""

_LONGEST, _SHORTEST = sp.Integer(2) ** 12, sp.Rational(1, 2**12)
"""Between these lengths, speeds and accelerations, in SI units, nothing over- or underflows."""

_TILTED = hold(tilt + grit * t)
_NEAR = Less(hold(t * _TILTED), flat)
"""Near the surface that the ball left, where F/t is known better than F; without one `tilt` is
infinite."""

_JERKED = hold(jerk * t**2)
_QUICK = every(_NEAR, Less(_JERKED, rate_margin))
"""Where F' is better known from F/t."""


class CoarseRing(RingApproach):
    """The search for the ring, as single precision has it."""

    unit: ClassVar[sp.Expr] = sp.Rational(1, 2**24)
    hardly: ClassVar[sp.Expr] = sp.Rational(1, 2**60)
    ease: ClassVar[sp.Expr] = sp.Rational(1, 2**18)

    @property
    def passed(self) -> tuple[sp.Symbol, ...]:
        """What its kernels are given beside the constants of the flight: margins and windows."""
        return (
            flat,
            tilt,
            grit,
            jerk,
            parting,
            drift,
            *(edge for window in self._later() for edge in window),
        )

    def _later(self) -> list[tuple[sp.Symbol, sp.Symbol]]:
        """The windows after the first, which nothing is before."""
        return opening(len(self.windows))[1:]

    def headroom(self, low_gap: sp.Expr, turned: bool) -> sp.Expr:
        """Return 2 (F - m + 2 m), half of which F itself is at most."""
        return 2 * hold(low_gap + 2 * self.allowed)

    def beyond(self, low_gap: sp.Expr) -> sp.Expr:
        """Return more than F itself can be: the window is to have the root."""
        return low_gap + 4 * self.allowed

    def steepest(
        self, width: sp.Expr, curvature: sp.Expr, fall: sp.Expr, reach: sp.Expr
    ) -> sp.Expr:
        """Return C on that window, where it is twice as long as the first step of Newton's method.

        -F'' <= M there; and F'' grows by no more than z sinks and rho grows.
        """
        _, moving, rho = self._here()
        inverse = self._inverses(rho)[0]
        there = self._here()[0]
        moved = self._moved(width)
        turn = hold(swing * inverse**3)
        weight = 6 * self.gravity * there[2]
        sinking = hold(hold(largest(-moving[2], 0) + self.gravity * width) * width)
        sinking = hold(sinking + 2 * self.blur(width)[1])
        growing = hold(6 * self.gravity * sinking + 3 * hold(turn * inverse) * moved)
        slack = sp.Rational(1, 2**12) * hold(size(steady) + size(weight) + turn)
        upper = hold(self.bend + hold(growing + slack))
        return Choose(AtMost(reach, hold(width * fall)), largest(curvature, upper), ceiling)

    def _moved(self, width: sp.Expr) -> sp.Expr:
        """No less than the ball moves sideways in that time."""
        vx, vy, _ = VELOCITY
        return hold(hold(sp.Abs(vx) + sp.Abs(vy)) * width)

    @property
    def allowed(self) -> sp.Expr:
        """The margin of the form that F is known better in."""
        return hold(Choose(_NEAR, hold(t * _TILTED), flat))

    def _searched(self) -> sp.Expr:
        return Choose(_NEAR, hold(self.leaving_gap, r"F_\ell"), hold(self.gap, "F"))

    def opened(self) -> dict[str, sp.Basic]:
        """Return the first window, the others, when the last one ends, and whether to rely on that.

        What is not of such sizes may over- or underflow.
        """
        innermost, outermost = self.radii()
        latest = hold(horizon * (1 + sp.Rational(1, 2**22)))
        found = [
            (hold(largest(0, low)), hold(smallest(latest, high))) for low, high in self.windows
        ]
        first = enter(found, *(sp.Integer(0),) * 3)
        later = {
            edge.name: value
            for window, values in zip(self._later(), found[1:], strict=True)
            for edge, value in zip(window, values, strict=True)
        }
        ends = hold(smallest(latest, largest(0, *(high for _, high in self.windows))))
        sound = every(
            AtMost(outermost, 2**5 * innermost),
            AtMost(outermost, 2**5 * self.ring.reach),
            AtMost(outermost, _LONGEST),
            AtMost(_SHORTEST, innermost),
            AtMost(self.gravity, _LONGEST),
            AtMost(_SHORTEST, self.gravity),
            AtMost(extent, _LONGEST),
            AtMost(speed, _LONGEST),
        )
        return first | later | {"latest": ends, "sound": sound}

    def blur(self, width: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
        """Return the same of single precision: see the head of this file."""
        _, outermost = self.radii()
        around = sp.Rational(1, 2**20) * outermost + sp.Rational(1, 2**13) * self._moved(width)
        return around, sp.Rational(1, 2**13) * self.ring.reach

    @property
    def rate(self) -> sp.Expr:
        """F'; soon after the start 2 F/t - F'_0, off by K t²/6 and twice what F/t is off by."""
        return Choose(_QUICK, hold(2 * self._mean_rate() - parting), hold(super().rate))

    @property
    def rate_allowed(self) -> sp.Expr:
        """The margin of that."""
        return hold(Choose(_QUICK, hold(2 * _TILTED + _JERKED), rate_margin))

    @property
    def leaving_gap(self) -> sp.Expr:
        """F = t F/t."""
        return t * self._mean_rate()

    def _mean_rate(self) -> sp.Expr:
        """F/t = F'_0 + t H, H being half of F'' at the start and known to its own size.

        With w the mean of rho' since then,

            H = 2 (rho0 - R_H) (V² - rho'_0 w) / (rho + rho0) + w² + (vz - g t/2)² - g z0.
        """
        _, _, rho = self._here()
        _, q, speed_squared, _ = self.polar()
        _, _, z0 = POSITION
        _, _, vz = VELOCITY
        per = self._inverses(rho)[1]
        mean = hold(hold(2 * q + speed_squared * t) * per)
        inward = 2 * hold(rho_start - self.ring.ring_radius)
        turning = hold(inward * hold(speed_squared - drift * mean)) * per
        upward = hold(vz - self.gravity * t / 2)
        return hold(parting + t * hold(turning + mean**2 + upward**2 - self.gravity * z0))

    def started(self) -> dict[str, sp.Expr]:
        """Return rho, and F' and rho', at the start of the flight, in double precision."""
        x, y, z = POSITION
        vx, vy, vz = VELOCITY
        start = hold(self.ring.rho)
        outward = hold(hold(x * vx + y * vy) / start)
        depth = hold(start - self.ring.ring_radius)
        rate = 2 * hold(depth * outward + z * vz)
        return {"rho_start": start, "parting": rate, "drift": outward}

    def grain(self) -> dict[str, sp.Basic]:
        """Return the search from t on, where the first window opens: all that `leap` is given.

        The state is that at t, and `horizon` is when the last window ends.
        """
        innermost, outermost = self.radii()
        lasting = hold(horizon - t)
        dropped = hold(self.gravity * lasting**2)
        fastest = hold(speed + self.gravity * horizon)
        fits = every(
            AtMost(dropped, 2**7 * self.ring.reach),
            # F/t is of the place where the ball left.
            AtMost(leaving * t, 0),
        )
        furthest = hold(extent + horizon * fastest)
        reach = hold(self.ring.reach, "R")
        stretch = hold(largest(1, reach / innermost))
        whole = hold(5 * hold(reach * fastest + hold(stretch * fastest) * furthest))
        bearable = hold(sp.Rational(1, 2**8) * parting / whole)
        finer = largest(SHARES[-1], smallest(SHARES[0], bearable))
        allowing = hold(Choose(Less(0, leaving), finer, SHARES[0]))
        place = SAFETY * hold(
            allowing * furthest + sp.Rational(1, 2**20) * hold(outermost + dropped)
        )
        motion = (allowing + sp.Rational(1, 2**22)) * fastest
        slope = hold(5 * hold(reach * motion + hold(stretch * fastest) * place))
        carried = hold(hold(allowing + sp.Rational(1, 2**44)) * whole)
        constants = {name: hold(value) for name, value in self.constants.items()}
        turn = constants["swing"] * hold(1 / innermost) ** 3
        bend = hold(size(constants["steady"]) + 6 * self.gravity * self.reach + turn)
        tilting = carried + sp.Rational(1, 2**21) * size(parting)
        # The third derivative is at most 6 g |z'| + 3 (2 R_H L²) |rho'| / rho^4.
        vx, vy, vz = VELOCITY
        sideways, upright = hold(sp.Abs(vx) + sp.Abs(vy)), hold(sp.Abs(vz) + self.gravity * lasting)
        windows = {edge.name: edge - t for window in self._later() for edge in window}
        return {
            "share": allowing,
            "t": sp.Integer(0),
            "end": end - t,
            **{s.name: s for s in (*POSITION, *VELOCITY)},
            **constants,
            "ceiling": SAFETY * bend,
            "flat": 5 * reach * place,
            "tilt": Choose(Less(0, leaving), SAFETY * hold(tilting), sp.oo),
            "jerk": SAFETY * hold(self.gravity * upright + hold(turn * sideways) / (2 * innermost)),
            "grit": sp.Rational(1, 2**17) * hold(stretch * hold(outermost / innermost)) * bend,
            "parting": parting,
            "drift": drift,
            "rate_margin": slope,
            **windows,
            "fits": fits,
        }

    def leap(self) -> dict[str, sp.Basic]:
        """Return where the search is after a step, in which window, and how it stands.

        `certain` where one simple root follows, to which Newton's method converges from `t`.
        `t` is infinite where no window is left.
        """
        said = self.advance()
        gap, rate, step, following = (said[name] for name in ("gap", "rate", "step", "next"))
        allowed = self.allowed
        sure = Less(0, said["clearance"])
        closing = every(Less(rate, 0), AtMost(gap - allowed, allowed))
        still = every(Less(t, end), Not(Less(t, following)))
        stuck = every(Not(sure), some(closing, still))
        exhausted = every(Not(some(sure, stuck)), AtMost(end - t, step))
        entered = enter(self._later(), end, sp.oo)
        more = entered["searching"]
        return {
            "t": Choose(exhausted, entered["t"], Choose(stuck, t, following)),
            "end": Choose(exhausted, entered["end"], end),
            "certain": sure,
            "leaping": every(Not(some(sure, stuck)), some(Not(exhausted), more)),
        }
