"""The passage of a ball through a ring in a piece of a flight through air.

The height z is a polynomial of time in which no root has a closed form. While the air's force is
less than the weight, z'' <= -b < 0: z passes the ring's plane upwards at most once in a piece, then
downwards at most once. Each passing is the root of a parabola through both ends of the piece,
improved by Newton's method. With r the height that is left there, and e a bound on the errors of z,
the true passing is within sqrt(8 (|r| + e)/b) of the computed one.

A ball cannot be at the edge of the disc, since the wire is there, so that the place of a passing
need not be known well. Most pieces are far from the plane; then nothing is computed.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..motion.air import VELOCITIES, AirFlight, magnus_rate, piece_acceleration, piece_speed
from ..motion.flight import divisor
from ..symbolic.conditionals import (
    And,
    AtMost,
    Choose,
    IfLess,
    Less,
    Not,
    Or,
    absolute,
    all_of,
    any_of,
    barrier,
    maximum,
    minimum,
)
from ..symbolic.polynomials import horner
from ..symbolic.rounding import ROUNDING_SLACK, position_error
from ..symbolic.symbols import POSITION, VELOCITY, t

x, y, z = POSITION
vz = VELOCITY[2]

NEWTON_STEPS = 3
"""Steps of Newton's method from the root of the parabola, which is within some millimetres."""

APEX_STEPS = 4
"""Steps towards the apex, each with the parabola's second derivative in place of the true one."""


@dataclass(frozen=True)
class PiecePassings:
    """The passings of the disc's plane in a piece of a flight, up to time t.

    Attributes
    ----------
    flight
        The flight.
    """

    flight: AirFlight

    def _height(self, time: sp.Expr) -> sp.Expr:
        return barrier(horner(self.flight.path[z], time))

    def _climb(self, time: sp.Expr) -> sp.Expr:
        return barrier(horner([v[2] for v in VELOCITIES], time))

    @property
    def end(self) -> sp.Expr:
        """Z at time t."""
        return self._height(t)

    @property
    def _half_bend(self) -> sp.Expr:
        """Half the second derivative of the parabola through both ends."""
        rise = barrier(barrier(self.end - z) - barrier(vz * t))
        return barrier(rise / divisor(barrier(t**2)))

    @property
    def apex(self) -> sp.Expr:
        """The time of the apex, or the end of the piece that is nearest to it."""
        per = barrier(1 / divisor(barrier(-2 * self._half_bend)))
        time = self._within(vz * per)
        for _ in range(APEX_STEPS):
            time = self._within(time + barrier(self._climb(time) * per))
        return time

    @property
    def top(self) -> sp.Expr:
        """The height at the apex."""
        return self._height(self.apex)

    @staticmethod
    def _within(time: sp.Expr) -> sp.Expr:
        return barrier(minimum(t, maximum(0, barrier(time))))

    def _root(self, side: int) -> sp.Expr:
        """Return the time of the passing upwards, -1, or downwards, 1."""
        half = self._half_bend
        root = barrier(sp.sqrt(maximum(0, barrier(vz**2 - 4 * barrier(half * z)))))
        time = self._beside(side, barrier(vz + side * root) / divisor(barrier(-2 * half)))
        for _ in range(NEWTON_STEPS):
            climb = self._climb(time)
            size = divisor(absolute(climb))
            step = barrier(self._height(time) / size)
            time = self._beside(side, time - IfLess(climb, 0, -step, step))
        return time

    def _beside(self, side: int, time: sp.Expr) -> sp.Expr:
        """Return a time within the piece, on one side of the apex."""
        within = self._within(time)
        return barrier((maximum if side > 0 else minimum)(self.apex, within))

    @property
    def rises(self) -> sp.Basic:
        """Whether the ball passes the plane upwards."""
        return any_of(self.arch, And(Less(z, 0), AtMost(0, self.end)))

    @property
    def falls(self) -> sp.Basic:
        """Whether the ball passes the plane downwards."""
        return any_of(self.arch, And(Less(self.end, 0), AtMost(0, z)))

    @property
    def arch(self) -> sp.Basic:
        """Whether the ball is below at both ends and above in between."""
        return all_of(Less(z, 0), Less(self.end, 0), Less(0, vz), Less(0, self.top))

    def away(self, side: int) -> sp.Expr:
        """Return the squared distance from the axis at the passing upwards, -1, or downwards."""
        time, path = self._root(side), self.flight.path
        across = (barrier(horner(path[axis], time)) for axis in (x, y))
        return barrier(sum(c**2 for c in across))

    @property
    def near(self) -> sp.Basic:
        """Whether the ball may come to the plane: a path is off its chord by at most a t²/8."""
        least = minimum(absolute(z), absolute(self.end))
        bulge = barrier(piece_acceleration * t**2 / 8)
        alike = Or(And(Less(z, 0), Less(self.end, 0)), And(Less(0, z), Less(0, self.end)))
        return Not(And(alike, Less(barrier(bulge + 2 * self._error), least)))

    @property
    def _error(self) -> sp.Expr:
        there, _ = self.flight.rounding(t)
        return barrier(ROUNDING_SLACK * there.error)

    def undecided(self, radius: sp.Expr) -> sp.Basic:
        """Return the condition that the passings of a disc of that radius are undecided."""
        _, moving = self.flight.rounding(t)
        weight = barrier(absolute(self.flight.fall[2]))
        drag, turning = self._forces()
        least = barrier(weight * (1 - sp.Rational(1, 2**20)) - barrier(drag + turning))
        concave = Less(0, least)
        per = barrier(1 / divisor(least))
        speed = barrier(absolute(self._climb(self.apex)) + moving.error)
        inside = And(Less(0, self.apex), Less(self.apex, t))
        # By so much the apex, and the height there, are off.
        astray = barrier(Choose(inside, barrier(speed * per), 0))
        off = barrier(self._error + barrier(speed * astray))
        distances = {side: barrier(sp.sqrt(self.away(side))) for side in (-1, 1)}
        slacks = {}
        for side in (-1, 1):
            left = barrier(absolute(self._height(self._root(side))) + off)
            late = barrier(sp.sqrt(barrier(8 * barrier(left * per))) + astray)
            slacks[side] = barrier(ROUNDING_SLACK * barrier(self._error + piece_speed * late))
        nearest = minimum(barrier(distances[-1] - slacks[-1]), barrier(distances[1] - slacks[1]))
        starts = all_of(Less(0, position_error), AtMost(absolute(z), position_error))
        stops = AtMost(absolute(self.end), off)
        turns = all_of(Less(z, 0), Less(self.end, 0), AtMost(absolute(self.top), off))
        at_ends = And(any_of(starts, stops, turns), AtMost(nearest, radius))

        def edge(passes: sp.Basic, side: int) -> sp.Basic:
            off_edge = absolute(barrier(distances[side] - radius))
            return And(passes, AtMost(off_edge, slacks[side]))

        way = barrier(piece_speed * t)
        beginning = barrier(sp.sqrt(barrier(x**2 + y**2)))
        over = AtMost(barrier(beginning - barrier(way + self._error)), radius)
        return any_of(
            And(Not(concave), over),
            at_ends,
            edge(self.rises, -1),
            edge(self.falls, 1),
        )

    def _forces(self) -> tuple[sp.Expr, sp.Expr]:
        """Return bounds on drag and Magnus force within the piece."""
        drag = self.flight.resistance(piece_speed)
        turning = barrier(sum(map(absolute, magnus_rate)))
        return drag, barrier(turning * piece_speed)
