"""The search for any surface with a polynomial condition: bounds from Bernstein coefficients.

The condition is expanded about the surface's reference point, and along the flight about the
present time: its coefficients are as small as the surface, however long the flight.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import sympy as sp

from ..surfaces import Plane, Surface
from ..surfaces.torus import Toroidal
from ..surfaces.two_sided import TwoSided
from ..symbolic.conditionals import IfAtMost, IfLess, absolute, barrier, maximum, minimum, release
from ..symbolic.error_terms import curving, earliest_delay
from ..symbolic.polynomials import Coefficients, bernstein, compose, derivative, mean_rate
from ..symbolic.rounding import (
    ROUNDING_SLACK,
    Rounded,
    extent,
    position_error,
    rounding,
    speed,
    velocity_error,
)
from ..symbolic.symbols import POSITION, UNIT_ROUNDOFF, VELOCITY, t
from .box_windows import clear, exit_time, lost, windows
from .event_polynomials import Window, ceiling, event_coefficients, horizon, time_rounding
from .root_finder import RootFinder

STARTS = sp.symbols("x_start y_start z_start", real=True)
"""Position at the start of the flight, relative to the reference point."""

CEILING_BOX_FACTOR = sp.Rational(5, 4)
"""Size of the box for which |F''| is bounded, relative to the surface's box. Newton's steps that
a clearance promises may leave the surface's box. They go no further than twice F / |F'| < sqrt(F
/ C) / 8, and |F| within the box is at most 3 h² and C at least 2 v² on a sphere or a cylinder,
16 h^4 and 160 h² v² on a torus."""


_CLEAR_SLACK = sp.Rational(1, 2**30)
"""Exceeds the roundings of a distance and of the way flown. They are some u of the lengths in them,
which are place and reference point, since a radius is no larger than these and the distance."""


def _once_rounded(quantity: sp.Expr) -> Rounded:
    """Return the bounds of a quantity with a rounding of its own."""
    size = barrier(absolute(quantity))
    return Rounded(size, UNIT_ROUNDOFF * size)


@dataclass(frozen=True)
class PolynomialRootFinder(RootFinder):
    """The root finder for any surface with a polynomial condition, by Bernstein bounds.

    Attributes
    ----------
    surface
        The surface.
    two_sided
        True if F'' is bounded from both sides: then a ball that is long behind a surface, beyond
        its bounds, needs fewer steps.
    """

    surface: Surface
    two_sided: bool = False

    @property
    def _coefficients(self) -> Coefficients:
        return event_coefficients(self.surface, self.flight)

    @property
    def _boxed(self) -> bool:
        return any(half is not None for half in self.surface.half_sizes)

    def _along(self, expression: sp.Expr) -> sp.Expr:
        """Return the expression at the offset and the velocity of time t."""
        there, moving = self.flight.named()
        offsets = (barrier(p - c) for p, c in zip(there, self.surface.reference_point, strict=True))
        now = dict(zip((*POSITION, *VELOCITY), (*offsets, *moving), strict=True))
        return expression.xreplace(now)

    @property
    def _local(self) -> Coefficients:
        """The coefficients of the condition along the flight from offset and velocity."""
        found = compose(self.surface.shape, self.flight.path)
        return found + [sp.Integer(0)] * (3 - len(found))

    @property
    def _change(self) -> sp.Expr:
        """F/t since the start, in the offsets now and then; velocities are mean ones."""
        starts = dict(zip(POSITION, STARTS, strict=True))
        return mean_rate(self.surface.shape, starts, dict(zip(POSITION, VELOCITY, strict=True)))

    @property
    def _rate(self) -> sp.Expr:
        shape = release(self.surface.shape)
        gradient = [sp.diff(shape, place) for place in POSITION]
        return sp.Add(*(g * v for g, v in zip(gradient, VELOCITY, strict=True)))

    @property
    def constants(self) -> dict[str, sp.Expr]:
        """No constants."""
        return {}

    @property
    def windows(self) -> list[Window]:
        """The times at which the ball is in the surface's box, or up to Cauchy's bound.

        Without a box they end where the ball has left the surface for good, if that is known.
        """
        centre, halves = self.surface.reference_point, self.surface.half_sizes
        if not self._boxed:
            last, higher = self._last_sure_root()
            beyond = IfLess(horizon, sp.oo, sp.oo, last)
            until = IfLess(0, higher, beyond, last)
            if self._exit is not None:
                until = minimum(barrier(until), self._exit[0])
            return [(sp.Integer(0), until)]
        offsets = (barrier(p - c) for p, c in zip(POSITION, centre, strict=True))
        found = windows(list(zip(offsets, VELOCITY, self.flight.acceleration, strict=True)), halves)
        if None in halves:
            last = self._last_root()
            found = [(low, minimum(high, last)) for low, high in found]
        return found

    @property
    def _exit(self) -> tuple[sp.Expr, sp.Expr] | None:
        """Time after which the ball is too far off for good, as in `exit_time`, if known."""
        furthest = self.surface.furthest if isinstance(self.surface, TwoSided) else None
        if furthest is None:
            return None
        pull = self.flight.acceleration
        until, excess = exit_time(self.surface.reference_point, furthest, pull)
        return barrier(until), barrier(excess)

    def _sized_coefficients(self) -> list[tuple[sp.Expr, sp.Expr]]:
        """Return a bound below the size of each coefficient, and one above it, constant first."""
        share = sp.Rational(1, 2**20)  # errors beyond that exceed what a search allows for
        known = {place: Rounded(extent, share * extent) for place in POSITION}
        known |= {v: Rounded(speed, share * speed) for v in VELOCITY}
        found = [(c, rounding(c, known)) for c in self._coefficients]
        return [
            (barrier(absolute(c) - size.error), barrier(size.magnitude + size.error))
            for c, size in found
        ]

    def _last_root(self) -> sp.Expr:
        """Cauchy's bound on the roots, infinite where the degree is not certain."""
        *rest, (least, _) = self._sized_coefficients()
        most = barrier(sp.Add(*(size for _, size in rest)))
        return IfLess(0, least, 1 + most / least, sp.oo)

    def _last_sure_root(self) -> tuple[sp.Expr, sp.Expr]:
        """Return Cauchy's bound for the degree that is certain, and 1 if it may be higher, else 0.

        A coefficient of which each term is zero is zero: along an axis on which gravity lies, the
        ball comes to a cylinder at a constant speed.
        """
        last: sp.Expr = sp.Integer(0)
        higher: sp.Expr = sp.Integer(0)
        sizes = self._sized_coefficients()
        for degree, (least, most) in enumerate(sizes[1:], 1):
            rest = barrier(sp.Add(*(size for _, size in sizes[:degree])))
            last = IfLess(0, least, 1 + rest / least, last)
            higher = IfLess(0, least, 0, IfLess(0, most, 1, higher))
        return last, higher

    @property
    def lost(self) -> sp.Expr:
        """Positive if errors come near to the inflation of the box, or a last root is not certain.

        Without a box that is so if the degree is not certain, and nothing else ends the search.
        """
        if not self._boxed:
            higher = self._last_sure_root()[1]
            if self._exit is None:
                return IfLess(horizon, sp.oo, 0, higher)
            until, excess = self._exit
            return IfLess(0, excess, 1, IfLess(until, sp.oo, 0, higher))
        return lost(self.surface.reference_point, self.surface.half_sizes, self.flight.acceleration)

    @property
    def clear(self) -> sp.Expr | None:
        """Positive if no window opens before the horizon, or the surface is further off than that.

        Then there is no contact before the horizon, nor until the earliest arrival is certainly
        over. In the time T until then the ball flies no further than V T + A T²/2, with the sum V
        of the speeds and the sum A of the accelerations along the axes.
        """
        if self._boxed:
            return clear(self.windows, self.lost)
        distance = self.surface.distance_without_bounds
        if distance is None:
            return sp.Integer(0)
        until = barrier(horizon + earliest_delay)
        pull = sp.Add(*map(sp.Abs, self.flight.acceleration))
        way = barrier(until * barrier(speed + barrier(pull * until) / 2))
        errors = barrier(2 * barrier(position_error + velocity_error * until))
        lengths = barrier(extent + sp.Add(*map(sp.Abs, self.surface.reference_point)))
        room = barrier((1 + _CLEAR_SLACK) * barrier(way + errors) + _CLEAR_SLACK * lengths)
        return barrier(absolute(distance)) - room

    @property
    def gap(self) -> sp.Expr:
        """The condition at the offset at time t, which loses less than its coefficients do."""
        return self._along(self.surface.shape)

    @property
    def leaving_gap(self) -> sp.Expr:
        """The change since the start, with its factor t divided out and multiplied again."""
        rates = map(barrier, self.flight.mean_velocity())
        starts = (
            barrier(p - c) for p, c in zip(POSITION, self.surface.reference_point, strict=True)
        )
        there, _ = self.flight.named()
        offsets = (barrier(p - c) for p, c in zip(there, self.surface.reference_point, strict=True))
        now = dict(zip((*POSITION, *VELOCITY, *STARTS), (*offsets, *rates, *starts), strict=True))
        return t * barrier(self._change.xreplace(now))

    @property
    def rate(self) -> sp.Expr:
        """The gradient times the velocity."""
        return self._along(self._rate)

    @property
    def bend(self) -> sp.Expr:
        """The second derivative at time t."""
        return 2 * barrier(self._along(self._local[2]))

    def refine(self) -> dict[str, sp.Expr]:
        """Return the next value of a root near t, and gap and rate there.

        Newton's method ends within 2^-49 |F'|/C of the root. On a body of size R this is no more
        than a few roundings of R/|v|, since C >= 2 v² and |F'| <= 2 R |v| on a sphere, and alike on
        others. A surface without such a size may be as flat as can be, and gravity lie along it:
        then C is no measure. There the root of the local parabola is taken, in the form whose sums
        do not cancel: on a plane that is the root itself, and on any other surface it is no further
        off than 2 h², as |F''| <= C. Without such a root the contact is not certain: its rate is 0.
        """
        found = RootFinder.refine(self)
        if self._boxed:
            return found
        gap, rate = found["gap"], found["rate"]
        square = barrier(rate**2 - 2 * self.bend * gap)
        later = t + 2 * gap / barrier(sp.sqrt(square) - rate)
        return found | {
            "time": IfAtMost(0, square, later, t),
            "rate": IfAtMost(0, square, rate, 0),
        }

    @property
    def root_delay(self) -> sp.Expr | None:
        """The rounding of F, of F/t on return, over F', at the state and time t of the contact.

        On a plane across an axis, and on a quadric about its reference point, F is as exact as the
        offset from there: then the roundings of the flight contain those of F if that point is the
        origin, and those of F/t.
        """
        centre = self.surface.reference_point
        simple = isinstance(self.surface, Plane) or (
            self._boxed and sp.Poly(release(self.surface.shape), *POSITION).total_degree() <= 2
        )
        if simple and all(c == 0 for c in centre):
            return None
        offsets = [barrier(p - c) for p, c in zip(POSITION, centre, strict=True)]
        sizes = {p: _once_rounded(d) for p, d in zip(POSITION, offsets, strict=True)}
        rate = barrier(self._rate.xreplace(dict(zip(POSITION, offsets, strict=True))))
        sizes |= self._small(sizes, dict(zip(POSITION, offsets, strict=True)))
        first = barrier(rounding(self.surface.shape, sizes).error)
        starts, means = self._flown(offsets)
        sizes |= {s: _once_rounded(d) for s, d in zip(STARTS, starts, strict=True)}
        sizes |= {v: _once_rounded(mean) for v, mean in zip(VELOCITY, means, strict=True)}
        begin = dict(zip(POSITION, STARTS, strict=True))
        sizes |= self._small(sizes, dict(zip(STARTS, starts, strict=True)), begin)
        again = 0 if simple else barrier(rounding(self._change, sizes).error) * t
        return barrier(IfLess(curving, sp.oo, again, first)) / barrier(absolute(rate))

    def _small(
        self,
        sizes: Mapping[sp.Expr, Rounded],
        there: Mapping[sp.Symbol, sp.Expr],
        named: Mapping[sp.Symbol, sp.Symbol] | None = None,
    ) -> dict[sp.Expr, Rounded]:
        """Return the sizes that parts of the shape have at a place, which their terms exceed.

        Parameters
        ----------
        sizes
            Those of the coordinates of the place.
        there
            The value of each coordinate.
        named
            The names of the coordinates, if they are not those of a position.
        """
        found = {}
        for part in self.surface.small_parts:
            own = part.xreplace(dict(named or {}))
            error = barrier(rounding(own, sizes).error)
            value = barrier(absolute(barrier(own.xreplace(dict(there)))))
            found[own] = Rounded(barrier(value + error), error)
        return found

    def _flown(self, offsets: Sequence[sp.Expr]) -> tuple[list[sp.Expr], list[sp.Expr]]:
        """Return the sizes of the offset at the start and of the mean velocity.

        Arguments of the formulas are the state at the end of a flight of time t.
        """
        del offsets
        back, _ = self.flight.at(-t)
        places = zip(back, self.surface.reference_point, strict=True)
        falls = zip(VELOCITY, self.flight.acceleration, strict=True)
        return (
            [barrier(barrier(p) - c) for p, c in places],
            [barrier(v - a * t / 2) for v, a in falls],
        )

    def curvature(self, width: sp.Expr) -> sp.Expr:
        """Return the largest Bernstein coefficient of -F'' on the window, rounding included."""
        upper = maximum(*(-c for c in self._bends(width)))
        return upper + sp.Rational(1, 2**36) * ceiling

    def narrowed(self, width: sp.Expr) -> sp.Expr:
        """Return a shorter window where the gap of a torus opens more and more, as after a roll.

        There F is about k t³ at first: with the largest -F'' of the whole flight a step would be as
        short as t², and there would be hundreds of them. A window of 4 F'/F'', here about 2 t, is
        passed at once where F'' stays positive.
        """
        if not (self.flight.departs and isinstance(self.surface, Toroidal)):
            return width
        return barrier(minimum(width, self.opening(4)))

    def turned_curvature(self, width: sp.Expr) -> sp.Expr:
        """Return the largest Bernstein coefficient of F'', if that is bounded from both sides."""
        if not self.two_sided:
            return super().turned_curvature(width)
        upper = maximum(*self._bends(width))
        return barrier(upper + sp.Rational(1, 2**36) * ceiling)

    def _bends(self, width: sp.Expr) -> list[sp.Expr]:
        """Return the Bernstein coefficients of F'' on the window."""
        second = derivative(derivative([barrier(self._along(c)) for c in self._local]))
        return [barrier(c) for c in bernstein(second, width)]

    def _sizes(self, share: sp.Expr) -> dict[sp.Expr, Rounded]:
        """Return bounds on offset and velocity within the windows, with a share of the box."""
        there, moved = self.flight.rounding(horizon)
        known: dict[sp.Expr, Rounded] = dict.fromkeys(VELOCITY, moved)
        places = zip(POSITION, self.surface.reference_point, self.surface.half_sizes, strict=True)
        for place, centre, half in places:
            offset = rounding(place - centre, {place: there})
            known[place] = offset if half is None else Rounded(share * half, barrier(offset.error))
        return known

    @property
    def ceiling(self) -> sp.Expr:
        """|F''| with every term taken positive, up to the horizon and somewhat outside the box."""
        return rounding(2 * self._local[2], self._sizes(CEILING_BOX_FACTOR)).magnitude

    def _gap_rounding(self, now: Mapping[sp.Expr, Rounded]) -> Rounded:
        """Return size and error of the gap, given those of the coordinates of its place."""
        return rounding(self.surface.shape, now)

    @property
    def margins(self) -> dict[str, sp.Expr]:
        """Bounds by running error analysis of the gap, its mean rate and its rate."""
        now = self._sizes(1 + sp.Rational(1, 2**10))
        mean = self.flight.mean_rounding(horizon)
        start = {place: Rounded(extent, position_error) for place in POSITION}
        since = now | dict.fromkeys(VELOCITY, mean)
        for own, place, centre in zip(STARTS, POSITION, self.surface.reference_point, strict=True):
            # The ball left the surface there, or this bound is not used.
            since[own] = Rounded(
                now[place].magnitude, barrier(rounding(place - centre, start).error)
            )
        gap = self._gap_rounding(now)
        change = rounding(self._change, since)
        rate = rounding(self._rate, now)
        return {
            "margin": ROUNDING_SLACK * (gap.error + time_rounding(rate) * horizon),
            "leaving_margin": ROUNDING_SLACK * (change.error + time_rounding(rate)),
            "rate_margin": ROUNDING_SLACK * rate.error,
        }
