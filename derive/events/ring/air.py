"""The search on a ring along a piece of a flight through air.

With the distance rho from the axis and d = rho - R_H the gap is F = d² + z² - R². Its derivatives
are

    F' = 2 (d rho' + z v_z),   F'' = 2 (rho'² + d rho'' + v_z² + z a_z),
    rho' = (x v_x + y v_y) / rho,   rho'' = (v_x² + v_y² - rho'² + x a_x + y a_y) / rho.

With the speed v, L = x v_y - y v_x, the distance D from the wire's circle, D² = d² + z², and the
radial acceleration a_r that is

    F''/2 = v² - R_H L²/rho³ + d a_r + z a_z.

The bounds on it within a time w follow from the largest speed V and acceleration A of the piece:

    |v² - v_t²| <= 2 V A w,   D <= D_t + V w,   |L| <= |L_t| + (rho_t + V w) A w,
    rho >= rho_t + min(0, rho'_t) w - A w²/2,

the last since rho'' = L²/rho³ + a_r >= -A. They are those of the series' path. The true path is
off by what a search allows for, a share of 2^-25 of the place and the velocity, so D, rho and L
count as off by B = 2^-20 (|x| + V T), B and B V up to the end T of the window, and v² by 2^-20 V².

These bounds are used where rho is at least half of R_H - R; no contact is nearer to the axis. Where
it may be less, the ball is as far from the ring as it is, and flies there no faster than V.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import sympy as sp

from ...motion.air import AirFlight
from ...motion.air_series import (
    growth,
    piece_acceleration,
    piece_jerk,
    piece_speed,
    piece_speed_error,
)
from ...surfaces import Ring
from ...symbolic.conditionals import Choose, IfLess, Less, absolute, barrier, maximum, minimum
from ...symbolic.rounding import ROUNDING_SLACK, extent, velocity_error
from ...symbolic.symbols import POSITION, UNIT_ROUNDOFF, t
from ..air import opening_time, piece_lost, piece_windows
from ..air_near import in_single, near_box
from ..event_polynomials import Window, ceiling, end, horizon, leaving, margin
from ..root_finder import RootFinder

OFF = sp.Rational(1, 2**20)
"""Share of place and velocity that covers errors a search allows for, and roundings."""

BEND_TERMS = 6
"""So many terms of the acceleration give F'' where nothing but a guess depends on it."""

STEEP = sp.Integer(2) ** 80
"""A bound on -F'' with which a step is as short as none, where none is known."""

Vector = tuple[sp.Expr, sp.Expr, sp.Expr]


@dataclass(frozen=True)
class AirRingRootFinder(RootFinder):
    """The root finder for a ring along a piece of a flight through air."""

    flight: AirFlight
    ring: Ring
    off: ClassVar[sp.Expr] = OFF

    @property
    def constants(self) -> dict[str, sp.Expr]:
        """No constants."""
        return {}

    @property
    def windows(self) -> list[Window]:
        """All of the piece, if it may come into the ring's box."""
        return piece_windows(self.ring, self.flight)

    @property
    def lost(self) -> sp.Expr:
        """Positive if errors come near to the inflation of the box."""
        return piece_lost(self.ring, self.flight)

    @property
    def near(self) -> sp.Basic:
        """The condition that the piece may come into the ring's box before the horizon."""
        return near_box(self.ring, self.flight)

    @property
    def near_in_single(self) -> bool:
        """True if that test is in single precision."""
        return in_single(self.ring)

    @property
    def _nearest(self) -> sp.Expr:
        """Half the least distance from the axis of a ball that touches the ring."""
        return barrier(self.ring.ring_radius - self.ring.reach) / 2

    @property
    def _widest(self) -> sp.Expr:
        """A bound on |d| within the ring's box, inflated."""
        outer = barrier(self.ring.ring_radius + self.ring.reach)
        inner = self.ring.ring_radius
        return barrier(maximum(inner, barrier(sp.Rational(3, 2) * outer - inner)))

    @staticmethod
    def _distance(place: sp.Matrix, name: str = "") -> sp.Expr:
        x, y, _ = place
        return barrier(sp.sqrt(barrier(x**2 + y**2)), name)

    @property
    def named(self) -> dict[str, sp.Expr]:
        """The quantities of the flight, rho, d and rho' at time t."""
        _, _, *own = self._now()
        return super().named | {str(e.name): e for e in own}

    def _now(self) -> tuple[Vector, Vector, sp.Expr, sp.Expr, sp.Expr]:
        """Return place, velocity, rho, d and rho' at time t."""
        there, moving = self.flight.named()
        x, y, z = there
        vx, vy, vz = moving
        rho = self._distance(there, r"\rho_t")
        outward = barrier(x * vx + y * vy) / barrier(IfLess(0, rho, rho, 1))
        depth = barrier(rho - self.ring.ring_radius, "d_t")
        return (x, y, z), (vx, vy, vz), rho, depth, barrier(outward, r"\dot\rho_t")

    @property
    def gap(self) -> sp.Expr:
        """F at time t."""
        (_, _, z), _, _, depth, _ = self._now()
        return barrier(depth**2 + z**2) - barrier(self.ring.reach**2)

    @property
    def leaving_gap(self) -> sp.Expr:
        """F as t times its mean rate since the start, where it is zero.

        The mean rate of rho is ((x + x_0) u_x + (y + y_0) u_y) / (rho + rho_0), with u for the mean
        velocity.
        """
        (x, y, z), _, rho, depth, _ = self._now()
        begun = self._distance(sp.Matrix(POSITION))
        ux, uy, uz = self.flight.mean_velocity()
        x_0, y_0, z_0 = POSITION
        across = barrier(barrier(x + x_0) * ux + barrier(y + y_0) * uy) / barrier(rho + begun)
        start = barrier(begun - self.ring.ring_radius)
        return t * barrier(barrier(depth + start) * barrier(across) + barrier(z + z_0) * uz)

    @property
    def rate(self) -> sp.Expr:
        """F' at time t."""
        (_, _, z), (_, _, vz), _, depth, outward = self._now()
        return 2 * barrier(depth * outward + z * vz)

    @property
    def bend(self) -> sp.Expr:
        """F'' at time t; the width of a window is guessed from it, which needs few terms."""
        (x, y, z), (vx, vy, vz), rho, depth, outward = self._now()
        terms = None if self.flight.departs else BEND_TERMS
        ax, ay, az = self.flight.acceleration_at(terms=terms)
        along = barrier(vx**2 + vy**2 + x * ax + y * ay - outward**2)
        turned = barrier(along / barrier(IfLess(0, rho, rho, 1)))
        return 2 * barrier(outward**2 + vz**2 + barrier(depth * turned) + z * az)

    def _off(self) -> sp.Expr:
        """Return B, by which places are off at most."""
        return barrier(self.off * self._size())

    def _size(self) -> sp.Expr:
        """Return |x| + V T."""
        return barrier(extent + end * piece_speed)

    def _inward(self) -> sp.Expr:
        """Return a bound on the size of a negative rho', without that by the acceleration."""
        *_, outward = self._now()
        return barrier(maximum(0, -outward) + self.off * piece_speed)

    def least_distance(self, width: sp.Expr) -> sp.Expr:
        """Return a bound below rho within the width."""
        _, _, rho, _, _ = self._now()
        inward = barrier(self._inward() + piece_acceleration * width)
        return barrier(barrier(rho - self._off()) - barrier(inward * width))

    def narrowed(self, width: sp.Expr) -> sp.Expr:
        """Return the part of the window in which rho is at least half of R_H - R."""
        return barrier(minimum(width, self._known(width)), "w_1")

    def _known(self, width: sp.Expr) -> sp.Expr:
        """Return a time for which rho is certainly at least half of R_H - R, at most the width."""
        _, _, rho, _, _ = self._now()
        room = barrier(maximum(0, barrier(rho - self._nearest) - 2 * self._off()))
        inward = barrier(self._inward() + piece_acceleration * width)
        return barrier(barrier(room * (1 - sp.Rational(1, 2**10))) / inward)

    def _distance_from_wire(self) -> sp.Expr:
        """Return D."""
        (_, _, z), _, _, depth, _ = self._now()
        return barrier(sp.sqrt(barrier(depth**2 + z**2)), "D_t")

    def _pulled(self, width: sp.Expr) -> sp.Expr:
        """Return a bound on the size of d a_r + z a_z within the width."""
        away = barrier(self._distance_from_wire() + piece_speed * width)
        return barrier(barrier(away + self._off()) * piece_acceleration)

    def _square(self) -> sp.Expr:
        _, (vx, vy, vz), *_ = self._now()
        return barrier(vx**2 + vy**2 + vz**2)

    def _quickened(self, width: sp.Expr) -> sp.Expr:
        """Return a bound on the change of v² within the width, and on what it is off by."""
        gained = barrier(2 * barrier(piece_acceleration * width) + self.off * piece_speed)
        return barrier(gained * piece_speed)

    def moment(self, width: sp.Expr) -> sp.Expr:
        """Return a bound on |L| within the width."""
        (x, y, _), (vx, vy, _), rho, _, _ = self._now()
        wide = barrier(barrier(rho + piece_speed * width) + self._off())
        turning = barrier(wide * barrier(piece_acceleration * width) + self._off() * piece_speed)
        return barrier(absolute(barrier(x * vy - y * vx)) + turning)

    def curvature(self, width: sp.Expr) -> sp.Expr:
        """Return the bound on -F'' as above."""
        least = self.least_distance(width)
        known = barrier(IfLess(self._nearest, least, least, self._nearest))
        square = barrier(self.moment(width) ** 2)
        turned = barrier(self.ring.ring_radius * square) / barrier(barrier(known**2) * known)
        least_square = barrier(self._square() - ROUNDING_SLACK * self._quickened(width))
        bound = barrier(ROUNDING_SLACK * barrier(barrier(turned) + self._pulled(width)))
        return IfLess(self._nearest, least, barrier(2 * barrier(bound - least_square)), STEEP)

    @property
    def ceiling(self) -> sp.Expr:
        """The sizes of the terms of F'' where rho is at least half of R_H - R."""
        square = barrier(piece_speed**2)
        turned = barrier(piece_acceleration + square / self._nearest)
        pulled = barrier(self._widest * turned) + barrier(self._widest * piece_acceleration)
        return 2 * ROUNDING_SLACK * barrier(2 * square + barrier(pulled))

    def beyond(self, low_gap: sp.Expr) -> sp.Expr:
        """Return a gap whose local line ends behind the root."""
        return low_gap + 4 * margin

    def steepest(
        self, width: sp.Expr, curvature: sp.Expr, fall: sp.Expr, reach: sp.Expr
    ) -> sp.Expr:
        """Return C on that window, if it is twice as long as the first step of Newton's method.

        F itself is at most F - m + 2 m. On a shorter window the ceiling counts, where it is known
        to hold; else a number that proves nothing.
        """
        within = Less(barrier(reach + 3 * margin), barrier(width * fall))
        found = Choose(within, self._largest(width, curvature), ceiling)
        return barrier(IfLess(self._nearest, self.least_distance(width), found, STEEP))

    def _largest(self, width: sp.Expr, curvature: sp.Expr) -> sp.Expr:
        """Return a bound on |F''| within the width, given M there."""
        fastest = barrier(self._square() + self._quickened(width))
        upper = barrier(2 * ROUNDING_SLACK * barrier(fastest + self._pulled(width)))
        return maximum(curvature, upper)

    def lengthened(self, stride: sp.Expr) -> sp.Expr:
        """Return the time in which the ball comes no nearer than to the ring, if that is longer."""
        longer = barrier(minimum(barrier(end - t), IfLess(0, leaving, 0, self._approach())))
        stride = barrier(maximum(stride, longer))
        return barrier(maximum(stride, self._opening())) if self.flight.departs else stride

    def _approach(self) -> sp.Expr:
        """Return the least time in which the ball comes to the ring."""
        away = barrier(self._distance_from_wire() - self.ring.reach)
        sure = barrier(away - self.allowed * barrier(1 / self.ring.reach))
        return barrier(barrier(sure * (1 - sp.Rational(1, 2**10))) * barrier(1 / piece_speed))

    def _opening(self) -> sp.Expr:
        """Return a time in which the gap of a ball that has rolled certainly opens.

        With |rho''| <= A + v²/r, the third derivative of rho is at most 3 v (|rho''| + A)/r + j.
        """
        (_, _, z), _, _, depth, _ = self._now()
        left = barrier(end - t)
        known = barrier(minimum(left, self._known(left)))
        way, square = barrier(piece_speed * known), barrier(piece_speed**2)
        turned = barrier(piece_acceleration + square / self._nearest)
        quick = barrier(3 * piece_speed * barrier(turned + piece_acceleration))
        bent = barrier(quick / self._nearest) + piece_jerk
        deep, high = barrier(absolute(depth) + way), barrier(absolute(z) + way)
        third = barrier(2 * barrier(quick + barrier(deep * barrier(bent) + high * piece_jerk)))
        pulled = barrier(deep * turned) + barrier(high * piece_acceleration)
        size = barrier(2 * barrier(2 * square + pulled))
        low = barrier(barrier(self.bend) - sp.Rational(1, 2**36) * size)
        slope = barrier(barrier(self.rate) - self.rate_allowed)
        time = opening_time(slope, low, barrier(ROUNDING_SLACK * third))
        return barrier(minimum(known, time))

    @property
    def margins(self) -> dict[str, sp.Expr]:
        """Bounds on the errors of F, of F/t when leaving, and of F'.

        An error e of each coordinate is one of at most 2 e of rho. Roundings of rho and d are a few
        u of R_H and of rho. The mean rate of rho is one of a velocity and, relative to its size,
        those of two sums of coordinates over rho + rho_0 >= R_H - R.
        """
        there, moved = self.flight.rounding(horizon)
        u, ring = UNIT_ROUNDOFF, self.ring
        wide = barrier(ring.ring_radius + ring.reach) * 2
        place, swift = there.error, piece_speed
        off = barrier(2 * place + 8 * u * wide)
        mean = barrier(growth * velocity_error + piece_speed_error + 2 * u * swift)
        deep, high = self._widest, barrier(ring.reach * (1 + sp.Rational(1, 2**10)))
        squares = barrier(deep**2 + high**2 + ring.reach**2)
        gap = barrier(2 * barrier(deep * off) + 2 * barrier(high * place) + 4 * u * squares)
        near = barrier(self._nearest)
        turned = barrier(barrier(swift * barrier(8 * place + 16 * u * wide)) / near)
        across = barrier(2 * mean + barrier(turned))
        speeds = barrier(barrier(deep + high) * swift)
        change = barrier(
            2 * barrier(deep * across)
            + 2 * barrier(swift * off)
            + 2 * barrier(high * mean)
            + 2 * barrier(swift * place)
            + 16 * u * speeds
        )
        outward = barrier(2 * moved.error + barrier(turned))
        rate = barrier(
            2 * barrier(deep * outward)
            + 2 * barrier(swift * off)
            + 2 * barrier(high * moved.error)
            + 2 * barrier(swift * place)
            + 16 * u * speeds
        )
        tick = 4 * u * speeds
        return {
            "margin": ROUNDING_SLACK * barrier(gap + tick * horizon),
            "leaving_margin": ROUNDING_SLACK * barrier(change + tick),
            "rate_margin": ROUNDING_SLACK * rate,
        }
