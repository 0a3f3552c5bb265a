"""The search for the first root of a curved surface's condition.

It is approached from the left: on a window where -F'' <= M,

    F(t + s) >= F(t) + F'(t) s - M s²/2,

so stepping to the first root of that parabola cannot pass a root of F, a parabola without a root
proves that there is none, and near a simple root the steps converge quadratically. With F less its
margin m in the parabola the same holds for the true F, of which only rounded values are known; the
search ends where F <= 2 m, a distance that every step still makes headway in.

It may end earlier. Where the slope r = -F' - m' fulfils r² > 8 C (2 (F - m) + m) with |F''| <= C,
one root follows and is simple, also of the true F (Kantorovich, with h = C F / r²). Newton's method
reaches it: F > 2 m means h < 2^-3, which each step squares and halves. The step after which h is at
most 2^-49 is the last; F <= 2 m means that any is within the root's own error. Where a root may be
out of bounds, which is asked after three steps, it is 2^5 in the place of 2.

That of the ring goes as far as it gets in single precision first, with margins that hold for that
(`coarse.py`).
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass

import sympy as sp

from ..flight.flight import Flight
from ..ground.choice import Held, IfAtMost, IfLess, hold, largest, smallest
from ..ground.symbols import t
from .events import Window, ceiling, end, horizon, leaving, margin, rate_margin


@dataclass(frozen=True)
class Approach(ABC):
    """What the search needs to know of a surface along a flight; times since the last contact."""

    flight: Flight

    @property
    @abstractmethod
    def constants(self) -> dict[str, sp.Expr]:
        """What does not change during the flight, by the name under which the rest uses it."""

    @property
    def symbols(self) -> tuple[sp.Symbol, ...]:
        """The symbols of `constants`, in calling order."""
        return ()

    @property
    def named(self) -> dict[str, sp.Expr]:
        """What formulas have names for, by its LaTeX, each after those that it uses."""
        there, moving = self.flight.named()
        return {e.name: e for e in (*there, *moving) if isinstance(e, Held)}

    @property
    @abstractmethod
    def windows(self) -> list[Window]:
        """Intervals of time, in order, outside which there is no contact; empty if lo > hi."""

    @property
    @abstractmethod
    def gap(self) -> sp.Expr:
        """F at time t."""

    @property
    @abstractmethod
    def leaving_gap(self) -> sp.Expr:
        """F at time t when the flight starts on the surface, from its deflated form."""

    @property
    @abstractmethod
    def rate(self) -> sp.Expr:
        """F' at time t."""

    @property
    @abstractmethod
    def bend(self) -> sp.Expr:
        """F'' at time t."""

    @property
    def lost(self) -> sp.Expr:
        """Positive where the bounds of this class do not hold, and no result is certain."""
        return sp.Integer(0)

    @property
    def clear(self) -> sp.Expr | None:
        """Positive if there certainly is no contact before the horizon; None: it is not asked."""
        return None

    @abstractmethod
    def curvature(self, width: sp.Expr) -> sp.Expr:
        """Return M with -F'' <= M on [t, t + width]."""

    @property
    @abstractmethod
    def ceiling(self) -> sp.Expr:
        """Bound on |F''| up to the horizon."""

    @property
    @abstractmethod
    def margins(self) -> dict[str, sp.Expr]:
        """Error bounds up to the horizon: `margin` of F, `leaving_margin` of F/t, `rate_margin`."""

    def prepare(self) -> dict[str, sp.Expr]:
        """Return the outputs of the kernel that opens the search of a flight."""
        outputs = dict(self.constants)
        for k, (low, high) in enumerate(self.windows):
            outputs |= {f"low{k}": largest(0, low), f"high{k}": smallest(horizon, high)}
        latest = hold(smallest(horizon, largest(0, *(high for _, high in self.windows))))
        outputs |= {"ceiling": self.ceiling.subs(horizon, latest), "latest": latest}
        return outputs | {"lost": self.lost}

    @property
    def allowed(self) -> sp.Expr:
        """The margin m of F in that form."""
        return margin

    @property
    def rate_allowed(self) -> sp.Expr:
        """The margin of F'."""
        return rate_margin

    def _searched(self) -> sp.Expr:
        """F in the form that is known better."""
        return IfLess(0, leaving, hold(self.leaving_gap, r"F_\ell"), hold(self.gap, "F"))

    def refine(self) -> dict[str, sp.Expr]:
        """Return Newton's next value of a root near t, and gap and rate there."""
        gap = self._searched()
        rate_here = hold(self.rate, "F'")
        return {"time": t - gap / rate_here, "gap": gap, "rate": rate_here}

    def advance(self, side: sp.Expr = sp.Integer(1)) -> dict[str, sp.Expr]:
        """Return gap, rate, bend, a step without a root, where it ends, and the clearance.

        The curvature is bounded on a window twice as long as the local line (falling) or, on
        leaving the surface, the local parabola says, so that M is nearly exact; where even that
        window ends first, so does the step. A falling gap with a positive clearance has one simple
        root nearby.

        Where a root may be out of bounds the search goes on behind it: with `side` -1 it looks for
        the way out, a root of -F, whose curvature the ceiling bounds, and needs Newton's root.
        """
        turned = side != 1
        gap, rate, bend = self._searched(), self.rate, self.bend
        if turned:
            gap, rate, bend = hold(side * gap), hold(side * rate), hold(side * bend)
        low_gap = hold(largest(hold(gap - self.allowed), 0))
        slope = hold(hold(rate, "" if turned else "F'") - self.rate_allowed)
        numerator = IfLess(slope, 0, 2 * self.beyond(low_gap), 4 * slope)
        denominator = IfLess(slope, 0, -slope, _positive(hold(-bend)))
        rising = IfAtMost(0, slope, low_gap, 0)
        guess = IfLess(0, rising, sp.oo, numerator / hold(denominator))
        width = hold(smallest(hold(end - t), guess), "w")
        curvature = self.curvature(width)
        if turned:
            curvature = IfLess(0, side, hold(curvature), ceiling)
        step = first_root(low_gap, slope, hold(curvature, "M"))
        stride = smallest(width, step)
        least_fall = hold(-rate - self.rate_allowed)
        reach = hold(self.headroom(low_gap, turned))
        enough = least_fall**2 - 8 * self.steepest(width, curvature, least_fall, reach) * reach
        return {
            "gap": gap,
            "rate": rate,
            "bend": bend,
            "step": stride,
            "next": t + hold(stride),
            **({"root": t - gap / rate} if turned else {}),
            "clearance": IfLess(0, least_fall, enough, least_fall),
        }

    def beyond(self, low_gap: sp.Expr) -> sp.Expr:
        """Return the gap whose local line says how wide a window bounds the curvature."""
        return low_gap

    def steepest(
        self, width: sp.Expr, curvature: sp.Expr, fall: sp.Expr, reach: sp.Expr
    ) -> sp.Expr:
        """Return C, given the window and M on it, -F' at least, and what that must reach over."""
        del width, curvature, fall, reach
        return ceiling

    def headroom(self, low_gap: sp.Expr, turned: bool) -> sp.Expr:
        """Return k (F - m) + m, of which a root that follows needs so much slope.

        With k = 2 Newton's method converges; with 2^5 three steps, of which the first is done here,
        find the root.
        """
        return (2**5 if turned else 2) * low_gap + self.allowed


def _positive(quantity: sp.Expr) -> sp.Expr:
    """Return the quantity where it is positive, else a zero that is: -0 is a divisor, too."""
    return IfLess(0, quantity, quantity, 0)


def first_root(gap: sp.Expr, slope: sp.Expr, curvature: sp.Expr) -> sp.Expr:
    """Return the first root s >= 0 of gap + slope s - curvature s²/2, infinite if none.

    Of the two forms of the root, the one whose sums do not cancel.
    """
    discriminant = hold(slope**2 + 2 * curvature * gap)
    root = sp.sqrt(discriminant)
    numerator = IfLess(slope, 0, 2 * gap, slope + root)
    denominator = IfLess(slope, 0, root - slope, _positive(curvature))
    # Rising and bent upwards, the denominator is zero and the quotient infinite, as it should be.
    # 0/0 is a parabola that is zero throughout: it limits no step, and `smallest` passes over it.
    return IfAtMost(0, discriminant, numerator / denominator, sp.oo)
