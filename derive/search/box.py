"""The search for a box: a bound on F'' in closed form that needs not to know which part is near.

With e how far a coordinate is beyond a face (`surfaces/box.py`), F = Σ e² - R_B², and wherever F''
is, it is the sum of 2 v² + 2 e a over the coordinates with e not zero: never less than -2 Σ |e a|.
F' is continuous, which is all that steps from the left and Newton's method ask for.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..ground.choice import IfLess, hold, size, smallest
from ..ground.rounding import (
    SAFETY,
    Rounded,
    rounding,
    velocity_error,
)
from ..ground.symbols import POSITION, UNIT_ROUNDOFF, VELOCITY, t
from ..surfaces import Box
from .approach import Approach
from .bernstein import BEYOND
from .events import Window, ceiling, horizon, time_rounding
from .windows import WIDER, lost, windows

EXCESS = sp.symbols("ex ey ez", real=True)


@dataclass(frozen=True)
class BoxApproach(Approach):
    """The search for a box, whatever part of it comes first."""

    box: Box

    @property
    def constants(self) -> dict[str, sp.Expr]:
        """None."""
        return {}

    @property
    def _reach(self) -> sp.Expr:
        """How far beyond a face the ball can be within the windows."""
        return hold(self.box.radius + 2 * WIDER * smallest(*self.box.halves))

    @property
    def named(self) -> dict[str, sp.Expr]:
        """The place and the velocity, and how far each coordinate is beyond a face."""
        excess = (e for e, _, _ in self._moving())
        return super().named | {rf"\Delta_{axis}": e for axis, e in zip("xyz", excess, strict=True)}

    @property
    def windows(self) -> list[Window]:
        """When the ball is near enough along every axis."""
        offsets = (hold(p - c) for p, c in zip(POSITION, self.box.about, strict=True))
        axes = zip(offsets, VELOCITY, self.flight.acceleration, strict=True)
        return windows(list(axes), self.box.halves)

    @property
    def lost(self) -> sp.Expr:
        """Errors near to what the windows are wider by."""
        return lost(self.box.about, self.box.halves, self.flight.acceleration)

    def _moving(self) -> list[tuple[sp.Expr, sp.Expr, sp.Expr]]:
        """Return e, velocity and acceleration of each coordinate at time t."""
        there, moving = self.flight.named()
        now = dict(zip(POSITION, there, strict=True))
        excess = [e.xreplace(now) for e in self.box.excess]
        return list(zip(excess, moving, self.flight.acceleration, strict=True))

    @property
    def gap(self) -> sp.Expr:
        """F at the position at time t."""
        return sp.Add(*(e**2 for e, _, _ in self._moving()), -(self.box.radius**2))

    @property
    def leaving_gap(self) -> sp.Expr:
        """Each e² less what it was, where that is on the same side as a product with t.

        Elsewhere one of the two is zero, or they are on both sides of the box: what is left is no
        further beyond its face than the ball has flown, and as good as a product with t.
        """
        changes = []
        for (e, _, a), start, v in zip(self._moving(), self.box.excess, VELOCITY, strict=True):
            product = t * hold(hold(v + a * t / 2) * hold(e + start))
            changes.append(hold(IfLess(0, e * start, product, hold(e**2) - hold(start**2))))
        return sp.Add(*changes)

    @property
    def rate(self) -> sp.Expr:
        """F' = 2 Σ e v."""
        return 2 * hold(sp.Add(*(e * v for e, v, _ in self._moving())))

    @property
    def bend(self) -> sp.Expr:
        """F'' as in the head of this file."""
        parts = (IfLess(0, size(e), hold(v**2 + e * a), 0) for e, v, a in self._moving())
        return 2 * hold(sp.Add(*parts))

    def curvature(self, width: sp.Expr) -> sp.Expr:
        """2 Σ |e a|, with e at its largest; one that is far grows no further than the windows."""
        most = []
        for e, v, a in self._moving():
            if a != 0:
                drift = hold(size(v) + size(a) * width / 2) * width
                most.append(size(a) * smallest(hold(size(e) + drift), self._reach))
        slack = sp.Rational(1, 2**40) * ceiling
        return 2 * hold(sp.Add(*most)) + slack

    @property
    def ceiling(self) -> sp.Expr:
        """Each term of F'' at its largest."""
        _, fastest = self.flight.size(horizon)
        falls = (BEYOND * self._reach * size(a) for a in self.flight.acceleration if a != 0)
        return 2 * hold(3 * fastest**2 + sp.Add(*falls))

    @property
    def margins(self) -> dict[str, sp.Expr]:
        """By running error analysis; e is off by no more than its coordinate and one sum."""
        there, moved = self.flight.rounding(horizon)
        _, fastest = self.flight.size(horizon)
        mean = Rounded(fastest, hold(velocity_error + 3 * UNIT_ROUNDOFF * fastest))
        now: dict[sp.Expr, Rounded] = dict.fromkeys(VELOCITY, moved)
        faces = zip(EXCESS, POSITION, self.box.low, self.box.high, strict=True)
        for e, place, low, high in faces:
            off = rounding(place - low, {place: there}).error
            off = off + rounding(place - high, {place: there}).error
            now[e] = Rounded(self._reach, hold(off))
        gap = rounding(sp.Add(*(e**2 for e in EXCESS), -(self.box.radius**2)), now)
        terms = [e * v for e, v in zip(EXCESS, VELOCITY, strict=True)]
        rate = rounding(2 * sp.Add(*terms), now)
        # Of F/t the same with the mean velocity, for e now and then.
        change = rounding(2 * sp.Add(*terms), now | dict.fromkeys(VELOCITY, mean))
        return {
            "margin": SAFETY * (gap.error + time_rounding(rate) * horizon),
            "leaving_margin": SAFETY * (2 * change.error + time_rounding(rate)),
            "rate_margin": SAFETY * rate.error,
        }
