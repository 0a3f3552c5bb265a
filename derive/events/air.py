"""The search along a piece of a flight through air, for any surface with a polynomial condition.

The path is a polynomial of so high a degree that the condition along it is not expanded. Its second
derivative in time is F'' = Σ F_ij v_i v_j + Σ F_i a_i, and its third derivative is bounded once for
a piece, from the sizes of the surface's box and of the piece: |F'''| <= J. So within a time w

    -F''(t + s) <= -F''(t) + J w.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import sympy as sp

from ..motion.air import AirFlight
from ..motion.air_series import piece_acceleration, piece_jerk
from ..surfaces import Surface
from ..symbolic.conditionals import IfLess, Less, Not, absolute, barrier, maximum, minimum
from ..symbolic.polynomials import Coefficients, compose
from ..symbolic.rounding import Rounded, rounding
from ..symbolic.symbols import POSITION, VELOCITY, t
from .air_near import in_single, near_box, near_plane, slopes
from .box import BoxRootFinder
from .box_windows import RELATIVE_INFLATION
from .event_polynomials import ERROR_BUDGET_LEVELS, Window, ceiling, end, horizon
from .polynomial import CEILING_BOX_FACTOR, PolynomialRootFinder

bend_rate = sp.Symbol("bend_rate", nonnegative=True)
"""J, a bound on the size of F''' up to the horizon."""

BUDGET = ERROR_BUDGET_LEVELS[0]
"""The largest errors that a search allows for, relative to the flight."""

_ACCELERATION = sp.symbols("acceleration_x acceleration_y acceleration_z", real=True)
_JERK = sp.symbols("jerk_x jerk_y jerk_z", real=True)


def _inflation(surface: Surface) -> sp.Expr:
    known = [half for half in surface.half_sizes if half is not None]
    return RELATIVE_INFLATION * minimum(*known) if known else sp.Integer(0)


def piece_windows(surface: Surface, flight: AirFlight) -> list[Window]:
    """Return the window of a piece: all of it, if it may come into the surface's box.

    Parameters
    ----------
    surface
        A curved surface, whose box may be infinite along some axes.
    flight
        A piece of a flight, a series with a bound on its remainder.

    Returns
    -------
    list of Window
        One window from 0 to the horizon; it ends at -1 if the ball stays out of the box.
    """
    inflation, high = _inflation(surface), horizon
    axes = zip(flight.enclosure(horizon), surface.reference_point, surface.half_sizes, strict=True)
    for (middle, reach), centre, half in axes:
        if half is not None:
            away = barrier(absolute(barrier(middle - centre)))
            near = barrier(barrier(half + inflation) + reach)
            high = IfLess(near, away, -1, high)
    return [(sp.Integer(0), high)]


def over_budget(flight: AirFlight) -> sp.Expr:
    """Return by how much errors within a piece exceed the largest budget of a search."""
    there, _ = flight.rounding(flight.span)
    return barrier(there.error - BUDGET * there.magnitude)


def piece_lost(surface: Surface, flight: AirFlight) -> sp.Expr:
    """Return a quantity that is positive if errors come near to the inflation of the box.

    Parameters
    ----------
    surface, flight
        As for `piece_windows`.

    Returns
    -------
    Expr
        A length; if it is positive the windows of `piece_windows` are unreliable.
    """
    known = [half for half in surface.half_sizes if half is not None]
    there, _ = flight.rounding(horizon)
    if not known:
        return sp.Integer(0)
    centre = sp.Add(*map(sp.Abs, surface.reference_point))
    far = barrier(barrier(there.magnitude + centre) + maximum(*known))
    rounded = barrier(far * sp.Rational(1, 2**48))
    return barrier(there.error + rounded) - _inflation(surface) / 4


def opening_time(slope: sp.Expr, bend: sp.Expr, third: sp.Expr) -> sp.Expr:
    """Return a time in which a gap that opens has no root; 0 if it does not open.

    A ball that leaves a surface tangentially has a gap that grows as t³. It is outside now, and
    with F' not negative and J a bound on the third derivative F(t + s) >= F' s + F" s²/2 - J s³/6:
    no root until s² = 6 F'/J or s = 3 F"/J where F" is positive, else while s <= F'/|F"| and
    s² <= 3 F'/J.

    Parameters
    ----------
    slope, bend
        Bounds below F' and F".
    third
        J.
    """
    falling = barrier(maximum(0, -bend))
    per = barrier(1 / third)
    curved = barrier(IfLess(0, falling, slope / barrier(IfLess(0, falling, falling, 1)), sp.oo))
    sure = barrier(minimum(curved, barrier(sp.sqrt(barrier(3 * maximum(0, slope) * per)))))
    bent = barrier(3 * maximum(0, bend) * per)
    opening = barrier(barrier(maximum(sure, bent)) * (1 - sp.Rational(1, 2**10)))
    return barrier(IfLess(slope, 0, 0, opening))


@dataclass(frozen=True)
class AirRootFinder(PolynomialRootFinder):
    """The root finder along a piece of a flight through air."""

    flight: AirFlight

    @property
    def _local(self) -> Coefficients:
        """The coefficients up to the third of the condition along the path about a time."""
        local = zip(POSITION, VELOCITY, _ACCELERATION, _JERK, strict=True)
        path = {place: [place, v, a / 2, j / 6] for place, v, a, j in local}
        found = compose(self.surface.shape, path)
        return found + [sp.Integer(0)] * (4 - len(found))

    @property
    def symbols(self) -> tuple[sp.Symbol, ...]:
        """J."""
        return (bend_rate,)

    @property
    def constants(self) -> dict[str, sp.Expr]:
        """J, with every term taken positive, as in `ceiling`."""
        third = rounding(6 * self._local[3], self._sizes(CEILING_BOX_FACTOR)).magnitude
        return {bend_rate.name: barrier(third)}

    @property
    def windows(self) -> list[Window]:
        """All of the piece, if it may come into the surface's box."""
        return piece_windows(self.surface, self.flight)

    @property
    def lost(self) -> sp.Expr:
        """Positive if errors come near to the inflation of the box."""
        return piece_lost(self.surface, self.flight)

    @property
    def clear(self) -> None:
        """None: `near` is the test."""
        return

    @property
    def near(self) -> sp.Basic:
        """The condition that the piece may come to the surface before the horizon (`air_near`).

        Without a box F keeps its sign where it is curved, too, if it changes by less than |F|: by
        at most |F'| T + C T²/2. Errors of the state may add no more than the largest budget of a
        search does (`over_budget`).
        """
        if self._boxed:
            return near_box(self.surface, self.flight)
        if slopes(self.surface.shape) is not None:
            return near_plane(self.surface, self.flight)
        error = rounding(self.surface.shape, self._budgeted()).error
        return Not(Less(0, barrier(barrier(self._least_gap) - 4 * error)))

    @property
    def near_in_single(self) -> bool:
        """True if that test is in single precision."""
        return in_single(self.surface)

    @property
    def _least_gap(self) -> sp.Expr:
        """A bound below |F| until the horizon, without errors; negative if F may become zero."""
        start = dict(zip(POSITION, self._offsets, strict=True))
        gap, rate = (barrier(e.xreplace(start)) for e in (self.surface.shape, self._rate))
        change = barrier(absolute(rate) + barrier(self.ceiling * horizon / 2))
        return barrier(absolute(gap) - barrier(horizon * change) * (1 + BUDGET))

    @property
    def _offsets(self) -> list[sp.Expr]:
        places = zip(POSITION, self.surface.reference_point, strict=True)
        return [barrier(place - own) for place, own in places]

    def _budgeted(self) -> dict[sp.Expr, Rounded]:
        """Return sizes of places with the largest errors that a search allows for."""
        furthest, fastest = self.flight.size(horizon)
        known: dict[sp.Expr, Rounded] = dict.fromkeys(VELOCITY, Rounded(fastest, BUDGET * fastest))
        for place, centre in zip(POSITION, self.surface.reference_point, strict=True):
            offset = rounding(place - centre, {place: Rounded(furthest, BUDGET * furthest)})
            known[place] = offset
        return known

    @property
    def bend(self) -> sp.Expr:
        """The second derivative at time t."""
        now = dict(zip(_ACCELERATION, self.flight.acceleration_at(), strict=True))
        return 2 * barrier(self._along(self._local[2]).xreplace(now))

    def curvature(self, width: sp.Expr) -> sp.Expr:
        """Return -F'' at time t and J on the window, rounding included."""
        return self._bounded(-self.bend, width)

    def turned_curvature(self, width: sp.Expr) -> sp.Expr:
        """Return F'' at time t and J on the window, rounding included."""
        return self._bounded(self.bend, width)

    def lengthened(self, stride: sp.Expr) -> sp.Expr:
        """Return the time in which the gap of a ball that has rolled certainly opens, if longer."""
        if not self.flight.departs:
            return stride
        slope = barrier(barrier(self.rate) - self.rate_allowed)
        low = barrier(barrier(self.bend) - sp.Rational(1, 2**36) * ceiling)
        time = opening_time(slope, low, bend_rate)
        return barrier(maximum(stride, barrier(minimum(barrier(end - t), time))))

    def _bounded(self, bend: sp.Expr, width: sp.Expr) -> sp.Expr:
        upper = barrier(barrier(bend) + barrier(bend_rate * width))
        return barrier(minimum(upper, ceiling) + sp.Rational(1, 2**36) * ceiling)

    def _flown(self, offsets: Sequence[sp.Expr]) -> tuple[list[sp.Expr], list[sp.Expr]]:
        """Return bounds on the offset at the piece's start and on the mean velocity.

        Arguments of the formulas are the state at the end of a time t within the piece; `offsets`
        are its offsets then. The ball returns to a surface within one piece, or the bounds that are
        made of these do not count. With |a| <= A the mean velocity differs from the last by at most
        A t/2.
        """
        moved = barrier(piece_acceleration * t / 2)
        along = zip(offsets, VELOCITY, strict=True)
        return (
            [barrier(absolute(barrier(d - v * t)) + moved * t) for d, v in along],
            [barrier(absolute(v) + moved) for v in VELOCITY],
        )

    def _sizes(self, share: sp.Expr) -> dict[sp.Expr, Rounded]:
        """Return bounds on offset, velocity, acceleration and its rate within the piece."""
        known = super()._sizes(share)
        known |= dict.fromkeys(_ACCELERATION, Rounded(piece_acceleration))
        return known | dict.fromkeys(_JERK, Rounded(piece_jerk))


@dataclass(frozen=True)
class AirBoxRootFinder(BoxRootFinder):
    """The root finder for a box along a piece of a flight through air."""

    flight: AirFlight

    @property
    def windows(self) -> list[Window]:
        """All of the piece, if it may come near enough."""
        return piece_windows(self.box, self.flight)

    @property
    def reach_test(self) -> dict[str, sp.Basic]:
        """No test besides that of the windows."""
        return {}

    @property
    def approach_test(self) -> dict[str, sp.Basic]:
        """No test besides that of the windows."""
        return {}

    @property
    def lost(self) -> sp.Expr:
        """Positive if errors come near to the inflation of the windows."""
        return piece_lost(self.box, self.flight)

    def _pulls(self) -> list[sp.Expr]:
        return self.flight.acceleration_at()

    def _pull_bound(self, width: sp.Expr) -> sp.Expr:
        """Return 2 Σ |e a| with the largest e and a; one far away stays within the windows."""
        sums = []
        for e, v, _ in self._moving():
            drift = barrier(absolute(v) + self._pull * width / 2) * width
            sums.append(minimum(barrier(absolute(e) + drift), self._reach))
        return 2 * barrier(self._pull * barrier(sp.Add(*sums))) + sp.Rational(1, 2**40) * ceiling

    def _fastest_within(self, width: sp.Expr) -> list[sp.Expr]:
        """Return a bound on the size of each velocity within a window."""
        return [absolute(v) + self._pull * width for _, v, _ in self._moving()]

    @property
    def _pull(self) -> sp.Expr:
        """A bound on the acceleration along each axis of the box."""
        return piece_acceleration

    @property
    def ceiling(self) -> sp.Expr:
        """The sum of the largest sizes of the terms of F''."""
        pulled = barrier(CEILING_BOX_FACTOR * self._reach * self._pull)
        return 2 * barrier(3 * self._fastest**2 + 3 * pulled)
