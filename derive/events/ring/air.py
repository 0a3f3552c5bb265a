"""The search on a ring along a piece of a flight through air.

With the distance rho from the axis and d = rho - R_H the gap is F = d² + z² - R². Its derivatives
are

    F' = 2 (d rho' + z v_z),   F'' = 2 (rho'² + d rho'' + v_z² + z a_z),
    rho' = (x v_x + y v_y) / rho,   rho'' = (v_x² + v_y² - rho'² + x a_x + y a_y) / rho.

So -A <= rho'' <= A + v²/rho for a ball no faster than v whose acceleration is at most A, and within
a time w, in which rho stays above r, the largest of -F'' is at most

    2 (|d| + v w + |z| + v w) A + 2 max(0, v w - d) v² / r.

These bounds are used where rho is at least half of R_H - R; no contact is nearer to the axis. Where
it may be less, the ball is as far from the ring as it is, and flies there no faster than v.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ...motion.air import (
    AirFlight,
    growth,
    piece_acceleration,
    piece_jerk,
    piece_speed,
    piece_speed_error,
)
from ...surfaces import Ring
from ...symbolic.conditionals import IfLess, absolute, barrier, maximum, minimum
from ...symbolic.rounding import ROUNDING_SLACK, velocity_error
from ...symbolic.symbols import POSITION, UNIT_ROUNDOFF, t
from ..air import opening_time, piece_lost, piece_windows
from ..box_windows import clear
from ..event_polynomials import Window, ceiling, end, horizon, leaving, margin
from ..root_finder import RootFinder

STEEP = sp.Integer(2) ** 80
"""A bound on -F'' with which a step is as short as none, where none is known."""

Vector = tuple[sp.Expr, sp.Expr, sp.Expr]


@dataclass(frozen=True)
class AirRingRootFinder(RootFinder):
    """The root finder for a ring along a piece of a flight through air."""

    flight: AirFlight
    ring: Ring

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
    def clear(self) -> sp.Expr:
        """Positive if no window opens before the horizon."""
        return clear(self.windows, self.lost)

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
        """F'' at time t."""
        (x, y, z), (vx, vy, vz), rho, depth, outward = self._now()
        ax, ay, az = self.flight.acceleration_at()
        along = barrier(vx**2 + vy**2 + x * ax + y * ay - outward**2)
        turned = barrier(along / barrier(IfLess(0, rho, rho, 1)))
        return 2 * barrier(outward**2 + vz**2 + barrier(depth * turned) + z * az)

    def _least_distance(self, width: sp.Expr) -> sp.Expr:
        """Return a bound below rho within the width."""
        _, _, rho, _, _ = self._now()
        return barrier(rho - barrier(piece_speed * width) * (1 + sp.Rational(1, 2**20)))

    def narrowed(self, width: sp.Expr) -> sp.Expr:
        """Return the part of the window in which rho is at least half of R_H - R."""
        return barrier(minimum(width, self._known()), "w_1")

    def _known(self) -> sp.Expr:
        """Return the time for which rho is certainly at least half of R_H - R."""
        _, _, rho, _, _ = self._now()
        room = barrier(maximum(0, barrier(rho - self._nearest)))
        return barrier(barrier(room * (1 - sp.Rational(1, 2**10))) * barrier(1 / piece_speed))

    def curvature(self, width: sp.Expr) -> sp.Expr:
        """Return the bound on -F'' as above."""
        (_, _, z), _, _, depth, _ = self._now()
        way = barrier(piece_speed * width)
        least = self._least_distance(width)
        known = barrier(IfLess(self._nearest, least, least, self._nearest))
        inside = barrier(maximum(0, barrier(way - depth)))
        pulled = barrier(absolute(depth) + absolute(z) + 2 * way) * piece_acceleration
        turned = barrier(inside * barrier(piece_speed**2)) / known
        bound = 2 * ROUNDING_SLACK * barrier(barrier(pulled) + barrier(turned))
        return IfLess(self._nearest, least, barrier(bound), STEEP)

    @property
    def ceiling(self) -> sp.Expr:
        """The sizes of the terms of F'' where rho is at least half of R_H - R."""
        square = barrier(piece_speed**2)
        turned = barrier(piece_acceleration + square / self._nearest)
        pulled = barrier(self._widest * turned) + barrier(self._widest * piece_acceleration)
        return 2 * ROUNDING_SLACK * barrier(2 * square + barrier(pulled))

    def steepest(
        self, width: sp.Expr, curvature: sp.Expr, fall: sp.Expr, reach: sp.Expr
    ) -> sp.Expr:
        """Return the ceiling where it is known to hold, else a number that proves nothing."""
        del curvature, fall, reach
        return barrier(IfLess(self._nearest, self._least_distance(width), ceiling, STEEP))

    def lengthened(self, stride: sp.Expr) -> sp.Expr:
        """Return the time in which the ball comes no nearer than to the ring, if that is longer."""
        (_, _, z), _, _, depth, _ = self._now()
        away = barrier(sp.sqrt(barrier(depth**2 + z**2)) - self.ring.reach)
        sure = barrier(away - margin * barrier(1 / self.ring.reach))
        time = barrier(barrier(sure * (1 - sp.Rational(1, 2**10))) * barrier(1 / piece_speed))
        longer = barrier(minimum(barrier(end - t), IfLess(0, leaving, 0, time)))
        stride = barrier(maximum(stride, longer))
        return barrier(maximum(stride, self._opening())) if self.flight.departs else stride

    def _opening(self) -> sp.Expr:
        """Return a time in which the gap of a ball that has rolled certainly opens.

        With |rho''| <= A + v²/r, the third derivative of rho is at most 3 v (|rho''| + A)/r + j.
        """
        (_, _, z), _, _, depth, _ = self._now()
        known = barrier(minimum(barrier(end - t), self._known()))
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
