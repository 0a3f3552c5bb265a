"""The ring's search along a sketch of a piece in air: few terms, in single precision.

It proves of most pieces that come near the ring that the ball misses it, and of the others up to
which time; from there on the search with the whole series goes on (`air`).

W = |x| + V T + R_H is no less than any coordinate up to the end T of the window, nor than rho or
|d|, and V no less than the speed. A sketch is used where the terms that it leaves out are at most
2^-18 V together, so they move the place by at most 2^-18 W. With v = 2^-24, the unit roundoff of
single precision, the roundings of a place are at most 16 v W: one each of x and the coefficients,
ten of Horner's rule relative to T V, that of the last sum, and two of times; those of a velocity
are at most 16 v V. Errors of the state, those of the velocity over the whole piece included,
move the place by at most 2^-25 W: a piece in which they are larger is uncertain (`over_budget`). So

    e = 2^-17 W    and    e' = 2^-17 V

bound the errors of a coordinate and a velocity. They are at most 3 e for rho and d and, where rho
is at least N, half of R_H - R, at most 2 e' + 8 V e/N for rho'. With the roundings of their own
formulas, and those of a step, which count as less than 16 v W² of F and 16 v W V of F', F is off by
at most 8 W e = m, and F' by at most

    8 W e' + 8 V e + 16 W V e/N = m'.

The bounds on F'' are those of the whole series, where rho, L and D count as off by B = 4 e, B V and
B, v² by 4 e' V, and rho' by 4 e' (1 + W/N). The search ends where F <= 2 m, and where a step does
not move the time. A ball that leaves the ring has F = 0 at first, whatever the errors of its place:
its first step is that of the parabola with F = 0 and the slope F' - m', if this is positive.

If the slope r fulfils r² > 16 C (F - m + 2 m), one simple root follows, as in single precision
along parabolas (`single`): F is at most F - m + 2 m, and so h < 2^-4.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import sympy as sp

from ...motion.air import AirFlight, AirSketch
from ...motion.air_series import piece_acceleration, piece_rest, piece_speed
from ...surfaces import Ring
from ...symbolic.conditionals import (
    AtMost,
    Choose,
    Less,
    Not,
    all_of,
    any_of,
    barrier,
    false,
    maximum,
    minimum,
)
from ...symbolic.rounding import ROUNDING_SLACK, extent
from ...symbolic.symbols import POSITION, t
from ..event_polynomials import end, horizon, leaving
from ..predicates import landed
from .air import STEEP, AirRingRootFinder

MAX_STEPS = 24
"""Steps after which the search goes on with the whole series; it takes about three."""

sketch_size = sp.Symbol("sketch_size", nonnegative=True)
"""W, m."""

_LONGEST, _SHORTEST = sp.Integer(2) ** 12, sp.Rational(1, 2**12)
"""Between these lengths, speeds and accelerations, in SI units, nothing over- or underflows."""

_OFF = sp.Rational(1, 2**15)
"""B by W, and four times e' by V."""


@dataclass(frozen=True)
class AirRingSketch(AirRingRootFinder):
    """The root finder for a ring along a sketch of a piece."""

    off: ClassVar[sp.Expr] = _OFF

    @classmethod
    def of(cls, flight: AirFlight, ring: Ring) -> AirRingSketch:
        """Return the root finder of a ring along the sketches of a flight.

        Parameters
        ----------
        flight
            The motion between contacts.
        ring
            The ring.
        """
        return cls(AirSketch(flight.acceleration, constants=flight.constants), ring)

    @property
    def allowed(self) -> sp.Expr:
        """The margin m of F."""
        return barrier(sp.Rational(1, 2**14) * sketch_size**2)

    @property
    def rate_allowed(self) -> sp.Expr:
        """The margin m' of F'."""
        per = barrier(sp.Rational(1, 2**13) * barrier(1 + barrier(sketch_size / self._nearest)))
        return barrier(per * barrier(sketch_size * piece_speed))

    def _size(self) -> sp.Expr:
        return sketch_size

    def _inward(self) -> sp.Expr:
        *_, outward = self._now()
        tilted = barrier(_OFF * barrier(1 + barrier(sketch_size / self._nearest)))
        return barrier(maximum(0, -outward) + tilted * piece_speed)

    def _searched(self) -> sp.Expr:
        return barrier(self.gap, "F")

    def beyond(self, low_gap: sp.Expr) -> sp.Expr:
        """Return a gap whose local line ends behind the root."""
        return low_gap + 4 * self.allowed

    def lengthened(self, stride: sp.Expr) -> sp.Expr:
        """Return the time in which the ball comes no nearer than to the ring, if that is longer."""
        return barrier(maximum(stride, barrier(minimum(barrier(end - t), self._approach()))))

    def headroom(self, low_gap: sp.Expr, turned: bool) -> sp.Expr:
        """Return 2 (F - m + 2 m), twice a bound on F itself."""
        del turned
        return 2 * barrier(low_gap + 2 * self.allowed)

    def steepest(
        self, width: sp.Expr, curvature: sp.Expr, fall: sp.Expr, reach: sp.Expr
    ) -> sp.Expr:
        """Return C on that window, if it is twice as long as the first step of Newton's method."""
        within = AtMost(reach, barrier(width * fall))
        return Choose(within, self._largest(width, curvature), STEEP)

    def _rising(self) -> sp.Basic:
        """Return whether the ball is just leaving the ring, and F is zero."""
        return all_of(Less(0, leaving), AtMost(t, 0))

    def _low_gap(self, gap: sp.Expr) -> sp.Expr:
        return barrier(Choose(self._rising(), 0, super()._low_gap(gap)))

    def begin(self) -> dict[str, sp.Basic]:
        """Return the search's start, place, sizes and window, and whether there is a sketch."""
        latest = barrier(horizon * (1 + sp.Rational(1, 2**22)))
        ring = self.ring.ring_radius
        size = barrier(ROUNDING_SLACK * barrier(barrier(extent + latest * piece_speed) + ring))
        serves = all_of(
            AtMost(piece_rest, sp.Rational(1, 2**18) * piece_speed),
            AtMost(_SHORTEST, self._nearest),
            AtMost(size, _LONGEST),
            AtMost(piece_speed, _LONGEST),
            AtMost(piece_acceleration, _LONGEST),
        )
        return {
            "t": sp.Integer(0),
            "end": latest,
            sketch_size.name: size,
            **{s.name: s for s in POSITION},
            "sketching": serves,
            "misses": false,
            landed.name: sp.Integer(0),
        }

    def step(self) -> dict[str, sp.Basic]:
        """Return the time after a step, and the state of the search.

        It goes on, or there is no root, or one simple root follows, for which there are two of
        Newton's steps; else it proves nothing more, as where anything is no number.
        """
        found = self.advance()
        rising = Less(0, barrier(found["rate"] - self.rate_allowed))
        apart = Less(2 * self.allowed, found["gap"])
        sound = any_of(all_of(self._rising(), rising), all_of(Not(self._rising()), apart))
        certain = any_of(Less(0, landed), Less(0, found["clearance"]))
        missed = all_of(sound, Not(certain), AtMost(end - t, found["step"]))
        goes = all_of(sound, Not(missed), Less(t, found["next"]))
        newton = t - barrier(found["gap"] / found["rate"])
        return {
            "t": Choose(certain, newton, Choose(goes, found["next"], t)),
            "sketching": all_of(AtMost(landed, 0), any_of(certain, goes)),
            "misses": missed,
            landed.name: Choose(certain, 1, 0),
        }
