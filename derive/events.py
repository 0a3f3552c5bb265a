"""Events: the flight (Eq. 3) put into a surface (Table 2), and the search for its first root.

Two kinds of search follow from the degree in time. A plane's condition is linear or quadratic: its
one arrival is a closed form. Any other surface is approached from the left: on a window where
-F'' <= M,

    F(t + s) >= F(t) + F'(t) s - M s²/2,

so stepping to the first root of that parabola cannot pass a root of F, a parabola without a root
proves that there is none, and near a simple root the steps converge quadratically. With F less its
margin m in the parabola the same holds for the true F, of which only rounded values are known; the
search ends where F <= 2 m, a distance that every step still makes headway in.

It may end earlier. Where the slope r = -F' - m' fulfils r² > 8 C (2^5 (F - m) + m) with |F''| <= C,
one root follows and is simple, also of the true F (Kantorovich, with h = C F / r²). Three steps of
Newton's method reach it: F > 2 m means h < 2^-7, and the steps end within 2^-48 of the first of
them; F <= 2 m means that the first is within the root's own error.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass

import sympy as sp

from .choice import IfAtMost, IfLess, hold, hold_all, largest, size, smallest
from .flight import flight, flight_polynomials
from .polynomials import Coefficients, bernstein, compose, derivative, horner, taylor
from .rounding import (
    SAFETY,
    Rounded,
    flight_rounding,
    flight_size,
    position_error,
    rounding,
    speed,
    start_rounding,
    velocity_error,
)
from .surfaces import Plane, Surface
from .symbols import POSITION, UNIT_ROUNDOFF, VELOCITY, t

Window = tuple[sp.Expr, sp.Expr]

end = sp.Symbol("end", real=True)
"""End of the window that is searched, s."""
horizon = sp.Symbol("horizon", positive=True)
"""No event later than this is wanted, s."""
leaving = sp.Symbol("leaving", real=True)
"""1 if the flight starts with the ball on this very surface, else 0."""
margin, rate_margin = sp.symbols("margin rate_margin", nonnegative=True)
"""Bounds on the errors of the computed gap and of its computed rate."""
delay = sp.Symbol("delay", nonnegative=True)
"""Bound on how far a computed arrival is from the true one, s."""
rate, ceiling = sp.symbols("rate ceiling", real=True)
"""The gap's rate F' and a bound on |F''|."""


share = sp.Symbol("share", nonnegative=True)
"""Errors of a state, relative to its flight, that a search allows for."""

SHARES = [sp.Rational(1, 2**k) for k in (25, 30, 35, 40, 45)]
"""Those that are tried, one after another and then 0, where a root is not certain."""


def event_coefficients(surface: Surface, gravity: sp.Expr) -> Coefficients:
    """Return the surface's condition along the flight: coefficients in time, constant first.

    Degree 1 for the backboard, 2 for the bridge and the end plane, 8 for the ring.
    """
    coefficients = compose(surface.condition, flight_polynomials(gravity))
    while len(coefficients) > 1 and coefficients[-1] == 0:
        coefficients.pop()
    return coefficients


def deflated_coefficients(surface: Surface, gravity: sp.Expr) -> Coefficients:
    """Return the coefficients of F(t)/t after a contact at t = 0.

    The constant term of F is zero there by construction: it is dropped, never tested.
    """
    return event_coefficients(surface, gravity)[1:]


def plane_arrival(plane: Plane, gravity: sp.Expr) -> dict[str, sp.Expr]:
    """Return time, rate and bend (F'') of a plane's only arrival, the root with F' < 0.

    Also the time of the apex of the gap and its height there, D / (-4 a), for a ball that moves
    along the plane now: whether there is an arrival is in doubt if that is zero within its error.

    With D = b² - 4 a c the arrival is where F' = -sqrt(D): t = 2 c / (sqrt(D) - b), the same as
    -(b + sqrt(D)) / (2 a); each loses no digits for one sign of b. Without an arrival the rate is
    not negative or not a number.
    """
    coefficients = event_coefficients(plane, gravity)
    c = IfLess(0, leaving, 0, hold(coefficients[0]))
    b = coefficients[1] if len(coefficients) > 1 else sp.Integer(0)
    if len(coefficients) < 3:
        along = {"apex": IfAtMost(size(b), 0, 0, -1), "height": c}
        return {"time": c / -b, "rate": b, "bend": sp.Integer(0)} | along
    a = coefficients[2]
    discriminant = hold(b**2 - 4 * a * c)
    root = sp.sqrt(discriminant)
    numerator = IfLess(b, 0, 2 * c, b + root)
    denominator = IfLess(b, 0, root - b, -2 * a)
    per_bend = hold(1 / (2 * a))
    return {
        "time": numerator / denominator,
        "rate": -root,
        "bend": 2 * a,
        "apex": -b * per_bend,
        "height": -discriminant * per_bend / 2,
    }


def plane_margin(plane: Plane, gravity: sp.Expr) -> sp.Expr:
    """Return a bound on the rounding error of the plane's gap up to the time `horizon`."""
    there, _ = flight_rounding(gravity, horizon)
    # Twice: once for the gap at the computed time, once for the root's own arithmetic.
    return 2 * SAFETY * rounding(plane.distance, dict.fromkeys(POSITION, there)).error


def crossing() -> dict[str, sp.Expr]:
    """Return what certifies a crossing at a computed arrival, and bounds its delay.

    At a computed root F <= m. With the slope r = -F' - m' > 0 and |F''| <= C,
    F(t + s) <= m - r s + C s²/2, which is negative at s = r/C if r² > 2 C m: the crossing is
    certain if `clearance` > 0, and then within 2 m / r. The bounds are taken three times as wide;
    without a slope the delay is not bounded.
    """
    slope = hold(-rate - rate_margin)
    return {
        "clearance": IfLess(0, slope, slope**2 - 6 * ceiling * margin, slope),
        "delay": IfLess(0, slope, 6 * margin / slope, sp.oo),
    }


def displacement(gravity: sp.Expr, lengths: Sequence[sp.Expr]) -> sp.Expr:
    """Return a bound on the error of a bound g (Eq. 2) or of the target at a computed arrival.

    Each of them is a length whose gradient is at most 1: the position's rounding errors, the
    distance flown during the delay, and the roundings of sums with the scene's lengths.
    """
    there, moving = flight_rounding(gravity, horizon)
    size = there.magnitude + hold(sum(map(sp.Abs, lengths)))
    return SAFETY * (3 * there.error + delay * moving.magnitude + 4 * UNIT_ROUNDOFF * hold(size))


def allowance(gravity: sp.Expr) -> dict[str, sp.Expr]:
    """Return the errors of a state that a search allows for, and by how much the errors exceed it.

    They do not depend on the errors, so that the search takes the same steps whatever these are.
    """
    furthest, fastest = flight_size(gravity, horizon)
    level, velocity_level = hold(share * furthest), hold(share * fastest)
    return {
        "level": level,
        "velocity_level": velocity_level,
        "excess": largest(hold(position_error - level), hold(velocity_error - velocity_level)),
    }


def padded_horizon(gravity: sp.Expr) -> dict[str, sp.Expr]:
    """Return a time after which no event is wanted, given the earliest arrival found.

    It does not depend on the bound on that arrival's delay, which must not exceed `pad`.
    """
    pad = hold(t + speed * hold(1 / gravity)) * sp.Rational(1, 2**20)
    return {"horizon": t + hold(pad), "pad": pad}


def time_rounding(rate: Rounded) -> sp.Expr:
    """Return what the gap changes, per unit of time, between two neighbouring doubles of time.

    A margin that holds it ends every search: a step that no longer moves the time is within it.
    """
    return 2 * UNIT_ROUNDOFF * rate.magnitude


@dataclass(frozen=True)
class Approach(ABC):
    """What the search needs to know of a surface along a flight; times since the last contact."""

    gravity: sp.Expr

    @property
    @abstractmethod
    def constants(self) -> dict[str, sp.Expr]:
        """What does not change during the flight, by the name under which the rest uses it."""

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
    def clear(self) -> sp.Expr:
        """Positive if there certainly is no contact before the horizon; by default unknown."""
        return sp.Integer(0)

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

    def refine(self) -> dict[str, sp.Expr]:
        """Return Newton's next value of a root near t, and the rate there."""
        gap = IfLess(0, leaving, hold(self.leaving_gap), hold(self.gap))
        rate_here = hold(self.rate)
        return {"time": t - gap / rate_here, "rate": rate_here}

    def advance(self) -> dict[str, sp.Expr]:
        """Return gap, rate, bend, a step without a root, where it ends, Newton's root, clearance.

        The curvature is bounded on a window twice as long as the local line (falling) or, on
        leaving the surface, the local parabola says, so that M is nearly exact; where even that
        window ends first, so does the step. A falling gap with a positive clearance has one simple
        root nearby.
        """
        gap = IfLess(0, leaving, hold(self.leaving_gap), hold(self.gap))
        low_gap = hold(largest(hold(gap - margin), 0))
        slope = hold(hold(self.rate) - rate_margin)
        numerator = IfLess(slope, 0, 2 * low_gap, 4 * slope)
        denominator = IfLess(slope, 0, -slope, _positive(hold(-self.bend)))
        rising = IfAtMost(0, slope, low_gap, 0)
        guess = IfLess(0, rising, sp.oo, numerator / hold(denominator))
        width = hold(smallest(hold(end - t), guess))
        step = _first_root(low_gap, slope, hold(self.curvature(width)))
        stride = smallest(width, step)
        least_fall = hold(-self.rate - rate_margin)
        enough = least_fall**2 - 8 * ceiling * hold(2**5 * low_gap + margin)
        return {
            "gap": gap,
            "rate": self.rate,
            "bend": self.bend,
            "step": stride,
            "next": t + hold(stride),
            "root": t - gap / self.rate,
            "clearance": IfLess(0, least_fall, enough, least_fall),
        }


def _positive(quantity: sp.Expr) -> sp.Expr:
    """Return the quantity where it is positive, else a zero that is: -0 is a divisor, too."""
    return IfLess(0, quantity, quantity, 0)


def _first_root(gap: sp.Expr, slope: sp.Expr, curvature: sp.Expr) -> sp.Expr:
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


@dataclass(frozen=True)
class PolynomialApproach(Approach):
    """The search for any surface with a polynomial condition: M from Bernstein coefficients."""

    surface: Surface

    @property
    def _coefficients(self) -> Coefficients:
        return event_coefficients(self.surface, self.gravity)

    def _along(self, expression: sp.Expr) -> sp.Expr:
        held = (hold_all(vector) for vector in flight(self.gravity))
        there = [component for vector in held for component in vector]
        moved = dict(zip((*POSITION, *VELOCITY), there, strict=True))
        return expression.subs(moved, simultaneous=True)

    @property
    def constants(self) -> dict[str, sp.Expr]:
        """None."""
        return {}

    @property
    def windows(self) -> list[Window]:
        """Up to Cauchy's bound on the roots."""
        *rest, leading = self._coefficients
        return [(sp.Integer(0), 1 + sum(sp.Abs(c) for c in rest) / sp.Abs(leading))]

    @property
    def gap(self) -> sp.Expr:
        """The condition at the position at time t, which loses less than its coefficients do."""
        return self._along(self.surface.condition)

    @property
    def leaving_gap(self) -> sp.Expr:
        """The deflated polynomial, times t."""
        return t * horner(self._coefficients[1:], t)

    @property
    def rate(self) -> sp.Expr:
        """Gradient times velocity."""
        gradient = [sp.diff(self.surface.condition, coordinate) for coordinate in POSITION]
        return self._along(sum(g * v for g, v in zip(gradient, VELOCITY, strict=True)))

    @property
    def bend(self) -> sp.Expr:
        """The polynomial's second derivative."""
        return horner(derivative(derivative(self._coefficients)), t)

    def curvature(self, width: sp.Expr) -> sp.Expr:
        """The largest Bernstein coefficient of -F'' on the window, rounding included."""
        second = derivative(derivative(self._coefficients))
        upper = largest(*(-c for c in bernstein(taylor(second, t), width)))
        return upper + sp.Rational(1, 2**40) * ceiling

    @property
    def ceiling(self) -> sp.Expr:
        """|F''| with every term taken positive, up to the horizon."""
        second = derivative(derivative(self._coefficients))
        return horner([rounding(c, start_rounding()).magnitude for c in second], horizon)

    @property
    def margins(self) -> dict[str, sp.Expr]:
        """By running error analysis of the gap, the deflated polynomial and the rate."""
        there, moved = flight_rounding(self.gravity, horizon)
        moving = dict.fromkeys(POSITION, there) | dict.fromkeys(VELOCITY, moved)
        start = start_rounding()
        start[t] = Rounded(horizon)
        condition = self.surface.condition
        gradient = [sp.diff(condition, coordinate) for coordinate in POSITION]
        gap = rounding(condition, moving)
        deflated = rounding(horner(self._coefficients[1:], t), start)
        rate = rounding(sum(g * v for g, v in zip(gradient, VELOCITY, strict=True)), moving)
        return {
            "margin": SAFETY * (gap.error + time_rounding(rate) * horizon),
            "leaving_margin": SAFETY * (deflated.error + time_rounding(rate)),
            "rate_margin": SAFETY * rate.error,
        }


def approach(surface: Surface, gravity: sp.Expr) -> Approach:
    """Return the search of a curved surface: its own where it has one, else the general one."""
    if surface.bounds:
        raise ValueError(f"surface {surface.name}: only a plane can have bounds")
    own = getattr(surface, "approach", None)
    return own(gravity) if own is not None else PolynomialApproach(gravity, surface)
