"""The search for a box: a bound on F'' in closed form, the same on all parts of the box.

With e for how far a coordinate is beyond a face (`surfaces/box.py`), F = Σ e² - R_B². Where F''
exists, it is the sum of 2 v² + 2 e a over the coordinates with e not zero, at least -2 Σ |e a|. F'
is continuous, which suffices for steps from the left and Newton's method.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import sympy as sp

from ..surfaces import Box
from ..symbolic.conditionals import IfLess, absolute, barrier, minimum
from ..symbolic.rounding import ROUNDING_SLACK, Rounded, rounding
from ..symbolic.symbols import POSITION, VELOCITY, t
from .bounding_boxes import may_reach_box, may_reach_plate
from .box_windows import RELATIVE_INFLATION, lost, windows
from .event_polynomials import Window, ceiling, horizon, time_rounding
from .polynomial import CEILING_BOX_FACTOR
from .root_finder import RootFinder
from .separation import may_approach

EXCESS = sp.symbols("ex ey ez", real=True)
"""Distance of each coordinate beyond a face."""


@dataclass(frozen=True)
class BoxRootFinder(RootFinder):
    """The root finder for a box, whichever part of it comes first."""

    box: Box

    @property
    def constants(self) -> dict[str, sp.Expr]:
        """No constants."""
        return {}

    @property
    def _reach(self) -> sp.Expr:
        """Bound on how far beyond a face the ball is within the windows."""
        return barrier(self.box.radius + 2 * RELATIVE_INFLATION * minimum(*self.box.half_sizes))

    @property
    def named(self) -> dict[str, sp.Expr]:
        """Position, velocity and how far each coordinate is beyond a face."""
        excess = (e for e, _, _ in self._moving())
        return super().named | {rf"\Delta_{axis}": e for axis, e in zip("xyz", excess, strict=True)}

    @property
    def windows(self) -> list[Window]:
        """The times at which the ball is near enough along every axis."""
        offsets = (barrier(p - c) for p, c in zip(POSITION, self.box.reference_point, strict=True))
        axes = zip(offsets, VELOCITY, self.flight.acceleration, strict=True)
        return windows(list(axes), self.box.half_sizes)

    @property
    def reach_test(self) -> dict[str, sp.Basic]:
        """Compare the flight with the planes of a plate, or its halves with the rounded box."""
        axis = self._plate_axis
        if axis is None:
            return may_reach_box(self.box)
        return may_reach_plate(self.box, axis, self.flight)

    @property
    def approach_test(self) -> dict[str, sp.Basic]:
        """Test whether the ball moves away from the box in all that comes near it."""
        return may_approach(self.box, self.flight, self._plate_axis is None)

    @property
    def _plate_axis(self) -> int | None:
        """The axis across the faces of a plate, if the flight has no acceleration along it."""
        axis = self.box.plate_axis
        return None if axis is None or self.flight.acceleration[axis] != 0 else axis

    @property
    def lost(self) -> sp.Expr:
        """Positive if errors come near to the inflation of the windows."""
        return lost(self.box.reference_point, self.box.half_sizes, self.flight.acceleration)

    def _moving(self) -> list[tuple[sp.Expr, sp.Expr, sp.Expr]]:
        """Return e, velocity and acceleration of each coordinate at time t."""
        there, moving = self.flight.named()
        now = dict(zip(POSITION, there, strict=True))
        excess = [e.xreplace(now) for e in self.box.excess]
        moved = zip(self.box.turned(list(moving)), self.box.turned(self._pulls()), strict=True)
        return [(e, v, a) for e, (v, a) in zip(excess, moved, strict=True)]

    def _pulls(self) -> Sequence[sp.Expr]:
        """Return the acceleration at time t along the scene's axes."""
        return self.flight.acceleration

    @property
    def gap(self) -> sp.Expr:
        """F at the position at time t."""
        return sp.Add(*(e**2 for e, _, _ in self._moving()), -(self.box.scaled_radius**2))

    @property
    def leaving_gap(self) -> sp.Expr:
        """The sum of the changes of e².

        Each is a product with t if e has the same sign now and at the start. Else one of the two is
        zero, or they are on both sides of the box: the rest is then no further beyond its face than
        the ball has flown, and as exact as a product with t.
        """
        changes = []
        means = self.box.turned(self.flight.mean_velocity())
        for (e, _, _), start, mean in zip(self._moving(), self.box.excess, means, strict=True):
            product = t * barrier(barrier(mean) * barrier(e + start))
            changes.append(
                barrier(IfLess(0, e * start, product, barrier(e**2) - barrier(start**2)))
            )
        return sp.Add(*changes)

    @property
    def rate(self) -> sp.Expr:
        """F' = 2 Σ e v."""
        return 2 * barrier(sp.Add(*(e * v for e, v, _ in self._moving())))

    @property
    def bend(self) -> sp.Expr:
        """F'' as above."""
        parts = (IfLess(0, absolute(e), barrier(v**2 + e * a), 0) for e, v, a in self._moving())
        return 2 * barrier(sp.Add(*parts))

    def curvature(self, width: sp.Expr) -> sp.Expr:
        """Return the bound of the accelerations' part: v² bends F upwards alone."""
        return self._pull_bound(width)

    def _pull_bound(self, width: sp.Expr) -> sp.Expr:
        """Return 2 Σ |e a| with the largest e; a coordinate far away stays within the windows."""
        most = []
        for e, v, a in self._moving():
            if a != 0:
                drift = barrier(absolute(v) + absolute(a) * width / 2) * width
                most.append(absolute(a) * minimum(barrier(absolute(e) + drift), self._reach))
        slack = sp.Rational(1, 2**40) * ceiling
        return 2 * barrier(sp.Add(*most)) + slack

    def turned_curvature(self, width: sp.Expr) -> sp.Expr:
        """Return 2 Σ (v² + |e a|) with the largest v and e."""
        squares = (barrier(fastest) ** 2 for fastest in self._fastest_within(width))
        return barrier(self._pull_bound(width) + 2 * barrier(sp.Add(*squares)))

    def _fastest_within(self, width: sp.Expr) -> list[sp.Expr]:
        """Return a bound on the size of each velocity within a window."""
        return [absolute(v) + absolute(a) * width for _, v, a in self._moving()]

    @property
    def ceiling(self) -> sp.Expr:
        """The sum of the largest sizes of the terms of F''."""
        falls = (
            CEILING_BOX_FACTOR * self._reach * absolute(a)
            for a in self.box.turned(self.flight.acceleration)
            if a != 0
        )
        return 2 * barrier(3 * self._fastest**2 + sp.Add(*falls))

    @property
    def _fastest(self) -> sp.Expr:
        """The largest velocity along an axis, in the unit of length of the box's faces."""
        return self.flight.size(horizon)[1]

    def _roundings(self) -> tuple[dict[sp.Expr, Rounded], dict[sp.Expr, Rounded]]:
        """Return bounds on e and the velocity, and on e and the mean velocity."""
        there, moved = self.flight.rounding(horizon)
        mean = self.flight.mean_rounding(horizon)
        now: dict[sp.Expr, Rounded] = dict.fromkeys(VELOCITY, moved)
        faces = zip(EXCESS, POSITION, self.box.low, self.box.high, strict=True)
        for e, place, low, high in faces:
            off = rounding(place - low, {place: there}).error
            off = off + rounding(place - high, {place: there}).error
            now[e] = Rounded(self._reach, barrier(off))
        return now, now | dict.fromkeys(VELOCITY, mean)

    def _gap_rounding(self, now: Mapping[sp.Expr, Rounded]) -> Rounded:
        """Return size and error of F."""
        return rounding(sp.Add(*(e**2 for e in EXCESS), -(self.box.scaled_radius**2)), now)

    @property
    def margins(self) -> dict[str, sp.Expr]:
        """Bounds by running error analysis; e is off by its coordinate's error and one sum."""
        now, since = self._roundings()
        gap = self._gap_rounding(now)
        terms = [e * v for e, v in zip(EXCESS, VELOCITY, strict=True)]
        rate = rounding(2 * sp.Add(*terms), now)
        # F/t has the same bound with the mean velocity, for e now and at the start.
        change = rounding(2 * sp.Add(*terms), since)
        return {
            "margin": ROUNDING_SLACK * (gap.error + time_rounding(rate) * horizon),
            "leaving_margin": ROUNDING_SLACK * (2 * change.error + time_rounding(rate)),
            "rate_margin": ROUNDING_SLACK * rate.error,
        }
