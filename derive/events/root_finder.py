"""The first root of a curved surface's condition, by steps from the left and Newton's method.

On a window with -F'' <= M,

    F(t + s) >= F(t) + F'(t) s - M s²/2,

so stepping to the first root of that parabola cannot pass a root of F, a parabola without a root
proves that there is none, and near a simple root the steps converge quadratically. With F less its
margin m in the parabola the same holds for the true F, of which only rounded values are known; the
search ends where F <= 2 m, since every step from further away makes headway.

It may end earlier. If the slope r = -F' - m' fulfils r² > 8 C (2 (F - m) + m) with |F''| <= C, one
root follows and is simple, also of the true F (Kantorovich, with h = C F / r²). Newton's method
converges to it: F > 2 m means h < 2^-3, and each step squares h and halves it. The step after which
h is at most 2^-49 is the last; F <= 2 m means that any value is within the root's own error. Where
a root may be out of bounds, which is decided after three steps, the factor is 2^5 instead of 2.
Where balls roll, a return to the surface just touched is refined even if it is not certain, since
it is not flagged if bounces end there for certain. It is undecided from where the search stands.

The ring's search first goes as far as it gets in single precision, with margins that hold for that
(`ring/single.py`).

In the lemmas F is the gap of the true flight, and E that of the computed state without roundings;
F^ and F^' are the computed values at t. In a window |F - E| <= m_s, |F' - E'| <= m_s' at all times,
and |F^ - F| <= m, |F^' - F'| <= m' at t, where m and m' contain m_s and m_s'; -E'' <= M and
|E''| <= C. On a return the same is known of F/t, in place of F, of which m is t times as much.

**Lemma (steps).** Let F(t) >= 0, G = max(0, F^ - m), S = F^' - m'. Then F has no zero in (t, t + s)
as long as G + S s - M s²/2 > 0 and t + s is in the window.

*Proof.* F(t) >= G. F'(t + s) >= E'(t + s) - m_s' >= E'(t) - M s - m_s' >= S - M s, which is
integrated. ∎

No bound on F'' of the true flight is needed. F(t) >= 0 holds at the start: the true ball is inside
no body, or leaves this one, with F = 0; then G = 0, and S > 0 or nothing is decided.

*Roundings of a step.* The root of the parabola is off by at most 4 u of itself, and the parabola
there by at most 8 u G, or 12 u of its apex where it rises first: the latter is no higher than F in
the window, at most d² + z² - R². Of these roundings m has 3/2 u R (R_H + R) and 7 u R X in double
precision besides those that it is made for, X >= rho + |z|, which suffices if 3/2 R <= R_H: at a
corner of slab and annulus 12 R² <= (15/4 + 7 + 7/2) R². The sum t + s is off by u (t + s), for
which m has the change of F between neighbouring times. In single precision times and steps are
counted as errors of the place.

**Lemma (certain root).** Let r = -F^' - m' > 0, and r² > 8 C (2 G + m). Then F has a
zero after t; the first one is simple, and the ball is in slab and annulus until then.

*Proof.* F(t) <= G + 2 m, and 2 C (G + 2 m) <= 4 C (2 G + m) < r²/2. As F'(t + s) <= -r + C s, F has
fallen through zero by 2 F(t)/r, and F' < 0 until then, if C holds until then. It holds in the slab
|z| <= R̂ and the annulus |rho - R_H| <= R̂. There H = E'² - 2 C E does not fall while E' <= 0,
since H' = 2 E' (E'' - C) >= 0; and H > 0 at t, as E'(t) <= -r and E(t) <= G + 2 m. So E' stays
negative as long as E >= 0. Where the ball leaves slab or annulus, say through |z| = R̂, z z' > 0
and -E' <= 2 |d d'| with d = rho - R_H, so that E'² <= 4 d² V² <= 4 V² E, as E >= d² there. But C is
at least 2 V² + 2 z'², so H <= 0: a contradiction. Through |d| = R̂ it is the same with z and z'. ∎

In single precision C is a bound on the next 2 (G + 2 m)/r alone, in the window, and r² > 16 C
(G + 2 m) implies the same.

A ball may be behind a surface that has bounds, or a plane in air. It is in front at the start if
F^ > m there, or if it leaves the surface; it is behind if F^ < -m. If neither holds, and F falls
there, the true ball may be behind and meet nothing: an arrival of that step is undecided (`behind`
in `predicates.py`). The m of that decision has the shot's own errors in place of the error budget.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass

import sympy as sp

from ..motion.flight import Flight
from ..symbolic.conditionals import IfAtMost, IfLess, barrier, maximum, minimum
from ..symbolic.rounding import ROUNDING_SLACK
from ..symbolic.symbols import t
from .event_polynomials import Window, ceiling, end, horizon, leaving, margin, rate_margin


@dataclass(frozen=True)
class RootFinder(ABC):
    """The properties of a surface along a flight that the search uses.

    Times are since the last contact.

    Attributes
    ----------
    flight
        The motion between contacts.
    """

    flight: Flight

    @property
    @abstractmethod
    def constants(self) -> dict[str, sp.Expr]:
        """Quantities that are constant along the flight, by name."""

    @property
    def symbols(self) -> tuple[sp.Symbol, ...]:
        """The symbols of `constants`, in calling order."""
        return ()

    @property
    def named(self) -> dict[str, sp.Expr]:
        """Quantities with a name in the derivation, by its LaTeX, each after those that it uses."""
        return self.flight.quantities()

    @property
    @abstractmethod
    def windows(self) -> list[Window]:
        """Intervals of time, in order, outside which there is no contact; empty if low > high."""

    @property
    @abstractmethod
    def gap(self) -> sp.Expr:
        """F at time t."""

    @property
    @abstractmethod
    def leaving_gap(self) -> sp.Expr:
        """F at time t for a flight that starts on the surface, from the deflated form."""

    @property
    @abstractmethod
    def rate(self) -> sp.Expr:
        """F' at time t."""

    @property
    @abstractmethod
    def bend(self) -> sp.Expr:
        """F'' at time t."""

    @property
    def root_delay(self) -> sp.Expr | None:
        """Delay of a root by roundings of F, at the contact; None: the flight's contain it."""
        return None

    @property
    def lost(self) -> sp.Expr:
        """Positive if the bounds of this class do not hold, so that no result is certain."""
        return sp.Integer(0)

    @property
    def excess(self) -> sp.Expr | None:
        """Positive if errors of the state exceed a search's budget; None: as in `error_budget`."""
        return None

    @property
    def clear(self) -> sp.Expr | None:
        """Positive if there is certainly no contact before the horizon; None: there is no test."""
        return None

    @property
    def near(self) -> sp.Basic | None:
        """The condition that there may be a contact before the horizon; None: there is no test."""
        return None

    @property
    def near_in_single(self) -> bool:
        """True if that test is in single precision."""
        return False

    @property
    def drops_through(self) -> sp.Basic | None:
        """A cheaper condition under which there is certainly no contact; None: there is none."""
        return None

    @property
    def reach_test(self) -> dict[str, sp.Basic]:
        """Test whether the boxes of a flight may meet the surface's; empty if there is none."""
        return {}

    @property
    def approach_test(self) -> dict[str, sp.Basic]:
        """Test whether a flight that comes near may come to the surface; empty if there is none."""
        return {}

    @abstractmethod
    def curvature(self, width: sp.Expr) -> sp.Expr:
        """Return M with -F'' <= M on [t, t + width]."""

    def turned_curvature(self, width: sp.Expr) -> sp.Expr:
        """Return M with F'' <= M on [t, t + width], for the search of the way out of a surface."""
        del width
        return ceiling

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
            outputs |= {f"low{k}": maximum(0, low), f"high{k}": minimum(horizon, high)}
        latest = barrier(minimum(horizon, maximum(0, *(high for _, high in self.windows))))
        outputs |= {"ceiling": self.ceiling.subs(horizon, latest), "latest": latest}
        return outputs | {"budget_exceeded": self.lost}

    @property
    def allowed(self) -> sp.Expr:
        """The margin m of F in the form that is searched."""
        return margin

    @property
    def error_share(self) -> sp.Expr:
        """By what share of F it may be wrong besides the margin: none."""
        return sp.Integer(0)

    @property
    def rate_allowed(self) -> sp.Expr:
        """The margin of F'."""
        return rate_margin

    def _searched(self) -> sp.Expr:
        """Return F in the more exact form."""
        return IfLess(0, leaving, barrier(self.leaving_gap, r"F_\ell"), barrier(self.gap, "F"))

    def refine(self) -> dict[str, sp.Expr]:
        """Return Newton's next value of a root near t, and gap and rate at t."""
        gap = self._searched()
        rate_here = barrier(self.rate, "F'")
        return {"time": t - gap / rate_here, "gap": gap, "rate": rate_here}

    def advance(self, side: sp.Expr = sp.Integer(1)) -> dict[str, sp.Expr]:
        """Return gap, rate, second derivative, a step without a root, its end, and the clearance.

        The curvature is bounded on a window twice as long as the local line (falling) or, on
        leaving the surface, the local parabola suggests, so that M is nearly exact; if even that
        window ends first, so does the step. A falling gap with a positive clearance has one simple
        root nearby.

        Where a root may be out of bounds the search goes on behind it: with `side` -1 it looks for
        the way out, a root of -F, and needs Newton's root. `turned_curvature` bounds its curvature.
        """
        turned = side != 1
        gap, rate, bend = self._searched(), self.rate, self.bend
        if turned:
            gap, rate, bend = barrier(side * gap), barrier(side * rate), barrier(side * bend)
        low_gap = self._low_gap(gap)
        slope = barrier(barrier(rate, "" if turned else "F'") - self.rate_allowed)
        numerator = IfLess(slope, 0, 2 * self.beyond(low_gap), 4 * slope)
        denominator = IfLess(slope, 0, -slope, _positive(barrier(-bend)))
        rising = IfAtMost(0, slope, low_gap, 0)
        guess = IfLess(0, rising, sp.oo, numerator / barrier(denominator))
        width = self.narrowed(barrier(minimum(barrier(end - t), guess), "w"))
        curvature = self.curvature(width)
        if turned:
            curvature = IfLess(0, side, barrier(curvature), self.turned_curvature(width))
        step = first_root(low_gap, slope, barrier(curvature, "M"))
        if turned:
            # A gap within its margin may have either sign: nothing says that the ball is outside. A
            # ball that began inside may be about to come out.
            least = barrier(IfLess(0, slope, barrier(gap - self.allowed), low_gap))
            step = IfLess(least, 0, _last_root(least, slope, barrier(curvature)), step)
        stride = self.lengthened(minimum(width, step))
        least_fall = barrier(-rate - self.rate_allowed)
        reach = barrier(self.headroom(low_gap, turned))
        enough = least_fall**2 - 8 * self.steepest(width, curvature, least_fall, reach) * reach
        return {
            "gap": gap,
            "rate": rate,
            "bend": bend,
            "step": stride,
            "next": t + barrier(stride),
            **({"root": t - gap / rate} if turned else {}),
            "clearance": IfLess(0, least_fall, enough, least_fall),
        }

    def _low_gap(self, gap: sp.Expr) -> sp.Expr:
        """Return a bound below F."""
        sure = gap if self.error_share == 0 else gap * (1 - self.error_share)
        return barrier(maximum(barrier(sure - self.allowed), 0))

    def narrowed(self, width: sp.Expr) -> sp.Expr:
        """Return the window on which the curvature is bounded, or the part where that is known."""
        return width

    def opening(self, steps: int) -> sp.Expr:
        """Return so many times F'/F'' where the gap opens more and more; elsewhere infinity, s.

        Parameters
        ----------
        steps
            The number of times.
        """
        rate, bend = barrier(self.rate), barrier(self.bend)
        opens = steps * rate / IfLess(0, bend, bend, 1)
        return barrier(IfLess(0, rate, IfLess(0, bend, opens, sp.oo), sp.oo))

    def lengthened(self, stride: sp.Expr) -> sp.Expr:
        """Return a longer step without a root, where the surface knows one."""
        return stride

    def beyond(self, low_gap: sp.Expr) -> sp.Expr:
        """Return the gap whose local line determines the width of the window."""
        return low_gap

    def steepest(
        self, width: sp.Expr, curvature: sp.Expr, fall: sp.Expr, reach: sp.Expr
    ) -> sp.Expr:
        """Return C, given the window, M on it, the least -F', and the reach it must suffice for.

        Parameters
        ----------
        width
            The length of the window, s.
        curvature
            M, a bound on -F'' within it.
        fall
            The smallest -F' within it.
        reach
            The result of `headroom`, a gap: C must hold as far as a fall by it.
        """
        del width, curvature, fall, reach
        return ceiling

    def headroom(self, low_gap: sp.Expr, turned: bool) -> sp.Expr:
        """Return k (F - m) + m, which determines the slope from which a root follows.

        With k = 2 Newton's method converges; with 2^5 three steps, of which the first is done here,
        find the root.

        Parameters
        ----------
        low_gap
            F - m, the gap less its margin.
        turned
            True if the root may be out of bounds; then the step itself gives Newton's first.
        """
        if self.error_share != 0:
            low_gap = barrier(low_gap * ROUNDING_SLACK)
        return (2**5 if turned else 2) * low_gap + self.allowed


def _positive(quantity: sp.Expr) -> sp.Expr:
    """Return the quantity if it is positive, else +0; -0 is a divisor of another sign."""
    return IfLess(0, quantity, quantity, 0)


def _last_root(gap: sp.Expr, slope: sp.Expr, curvature: sp.Expr) -> sp.Expr:
    """Return up to where a gap that rises, and may be as low as that, does not fall through zero.

    That is the second root of gap + slope s - curvature s²/2, or its apex if it stays below zero:
    until the first root, and until the apex, F' is positive.
    """
    discriminant = barrier(slope**2 + 2 * curvature * gap)
    root = sp.sqrt(barrier(maximum(discriminant, 0)))
    return barrier(slope + root) / _positive(curvature)


def first_root(gap: sp.Expr, slope: sp.Expr, curvature: sp.Expr) -> sp.Expr:
    """Return the first root s >= 0 of gap + slope s - curvature s²/2, infinite if none.

    Of the two forms of the root, the one whose sums do not cancel is used.

    Parameters
    ----------
    gap
        The gap at s = 0; it is not negative.
    slope
        The rate of the gap there.
    curvature
        A bound on -F'', so that the gap stays above the parabola.

    Returns
    -------
    Expr
        A time before which the gap is not zero, s.
    """
    discriminant = barrier(slope**2 + 2 * curvature * gap)
    root = sp.sqrt(discriminant)
    numerator = IfLess(slope, 0, 2 * gap, slope + root)
    denominator = IfLess(slope, 0, root - slope, _positive(curvature))
    # If the parabola rises and bends upwards, the denominator is zero and the quotient correctly
    # infinite. 0/0 is a parabola that is zero throughout: it limits no step, and `minimum` ignores
    # it.
    return IfAtMost(0, discriminant, numerator / denominator, sp.oo)
