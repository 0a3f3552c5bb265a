"""The search for a turned box: that of a box, with places and velocities turned at every time.

Along the axes of the box, in its unit of length (`surfaces/oblique_box.py`), the formulas are those
of `events/box.py`. Windows are those of a box along the scene's axes that holds every contact; what
bounds F'' within them is as far as its corner. Turning adds roundings, which margins contain.

There e may be many times R_B, but where F = Σ e² - R_B² is zero no e is above R_B. With a bound
E >= 2 R_B in place of the size of e, and a bound d on the error of each e,

    all |e| <= E:   F is wrong by at most 6 E d,
    one |e| >  E:   F > 3/4 e², and F is wrong by at most 6 |e| d < 8 (d/E) F.

So its error is at most a margin with E, and a share of F itself, as for an arc (`events/arc.py`).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import sympy as sp

from ..motion.flight import Flight
from ..surfaces import ObliqueBox
from ..symbolic.conditionals import (
    And,
    Choose,
    IfLess,
    Less,
    absolute,
    all_of,
    barrier,
    maximum,
    minimum,
)
from ..symbolic.error_terms import curving
from ..symbolic.rounding import Rounded, rounding
from ..symbolic.symbols import POSITION, UNIT_ROUNDOFF, VELOCITY
from .air import AirBoxRootFinder
from .arc import LEAST_PER_ERROR, SHARE
from .bounding_boxes import may_reach_in_halves
from .box import EXCESS, BoxRootFinder
from .event_polynomials import ceiling, horizon

TURN_ROUNDINGS = 8
"""Most roundings of a turned component: four of an entry, as a share of |q|², one of the vector,
one of a product and two of their sum."""

DIAGONAL = sp.Rational(7, 4)
"""More than sqrt(3): the length of a vector by its largest component."""


class _Turned(BoxRootFinder):
    """The parts of the search that are the same along any flight."""

    flight: Flight
    box: ObliqueBox

    @property
    def _reach(self) -> sp.Expr:
        """Bound on every coordinate along the box's axes within the windows."""
        square = barrier(sp.Add(*(half**2 for half in self.box.half_sizes if half is not None)))
        corner = barrier(sp.sqrt(square))
        return barrier(barrier(self.box.scale * corner) * (1 + sp.Rational(1, 2**10)))

    @property
    def _fastest(self) -> sp.Expr:
        """The largest velocity along an axis of the scene, in the box's unit of length.

        Its three squares are, in sum, those along the axes of the box.
        """
        return barrier(self.box.scale * self.flight.size(horizon)[1])

    def _excess_errors(self, known: dict[sp.Expr, Rounded]) -> list[sp.Expr]:
        """Return bounds on the error of each e, given those of the offsets from the centre."""
        return [
            barrier(rounding(place - low, known).error + rounding(place - high, known).error)
            for place, low, high in self.box.faces
        ]

    def _roundings(self) -> tuple[dict[sp.Expr, Rounded], dict[sp.Expr, Rounded]]:
        """Return bounds on e and the velocity, and on e and the mean velocity.

        The velocities are those along the axes of the box.
        """
        there, moved = self.flight.rounding(horizon)
        mean = self.flight.mean_rounding(horizon)
        box, known = self.box, {}
        places = zip(box.offsets, POSITION, box.centre, box.half_sizes, strict=True)
        for offset, place, own, half in places:
            off = rounding(place - own, {place: there}).error
            known[offset] = Rounded(barrier(sp.Rational(9, 8) * half), barrier(off))
        errors = zip(EXCESS, self._excess_errors(known), strict=True)
        excess: dict[sp.Expr, Rounded] = {e: Rounded(self._reach, error) for e, error in errors}
        return excess | self._velocities(moved), excess | self._velocities(mean)

    def _gap_rounding(self, now: Mapping[sp.Expr, Rounded]) -> Rounded:
        """Return size and error of F with the size of e near the box."""
        near = dict(now)
        for e in EXCESS:
            least = barrier(maximum(2 * self.box.scaled_radius, LEAST_PER_ERROR * now[e].error))
            near[e] = Rounded(barrier(minimum(self._reach, least)), now[e].error)
        return BoxRootFinder._gap_rounding(self, near)

    @property
    def error_share(self) -> sp.Expr:
        """By what share of F it may be wrong besides the margin: `SHARE`."""
        return SHARE

    def _velocities(self, given: Rounded) -> dict[sp.Expr, Rounded]:
        """Return bounds on the velocity along the axes of the box from those along the scene's."""
        found: dict[sp.Expr, Rounded] = {}
        for v, along in zip(VELOCITY, self.box.turned(VELOCITY), strict=True):
            turned = rounding(along, dict.fromkeys(VELOCITY, given))
            found[v] = Rounded(barrier(turned.magnitude), barrier(turned.error))
        return found

    @property
    def root_delay(self) -> sp.Expr | None:
        """The rounding of F, of F/t on return, over F', at the state and time t of the contact.

        Along an axis along which the ball is certainly between the faces, e is 0 without an error.
        """
        box = self.box
        starts = [barrier(place) for place in self.flight.start()]
        held = {d: Rounded(barrier(absolute(d)), UNIT_ROUNDOFF * absolute(d)) for d in box.offsets}
        errors = [barrier(error) for error in self._excess_errors(held)]
        lengths = self.flight.path_lengths()
        now: dict[sp.Expr, Rounded] = {}
        # On return, F/t times t is a sum of products of changes and of sums of e.
        since: dict[sp.Expr, Rounded] = {}
        for k, (symbol, e, error) in enumerate(zip(EXCESS, box.excess, errors, strict=True)):
            way = barrier(sp.Add(*(absolute(box.rotation[j][k]) * lengths[j] for j in range(3))))
            turned = barrier(TURN_ROUNDINGS * UNIT_ROUNDOFF * way)
            off = barrier(error + turned)
            free = all_of(self._is_between(k, POSITION, off), self._is_between(k, starts, off))
            there = barrier(Choose(self._is_between(k, POSITION, off), 0, error))
            now[symbol] = Rounded(barrier(absolute(e)), there)
            moved, off, turned = (barrier(Choose(free, 0, size)) for size in (way, off, turned))
            since[symbol] = Rounded(barrier(absolute(e) + moved), off)
            since[VELOCITY[k]] = Rounded(moved, turned)
        first = rounding(sp.Add(*(e**2 for e in EXCESS), -(box.scaled_radius**2)), now).error
        changes = (e * way for e, way in zip(EXCESS, VELOCITY, strict=True))
        again = rounding(2 * sp.Add(*changes), since).error
        along = zip(box.excess, box.turned(VELOCITY), strict=True)
        rate = barrier(2 * barrier(sp.Add(*(e * v for e, v in along))))
        return barrier(IfLess(curving, sp.oo, barrier(again), barrier(first))) / absolute(rate)

    def _is_between(self, axis: int, places: Sequence[sp.Expr], room: sp.Expr) -> sp.Basic:
        """Return whether a place is between two faces, with that much room to both.

        Parameters
        ----------
        axis
            The axis of the box across which the faces are.
        places
            The place, (3,), m.
        room
            A length in the box's unit.
        """
        _, low, high = self.box.faces[axis]
        offsets = [barrier(place - own) for place, own in zip(places, self.box.centre, strict=True)]
        place = self.box.turned(offsets)[axis]
        return And(Less(barrier(place + room), high), Less(low, barrier(place - room)))


@dataclass(frozen=True)
class ObliqueBoxRootFinder(_Turned):
    """The root finder for a turned box."""

    box: ObliqueBox

    @property
    def reach_test(self) -> dict[str, sp.Basic]:
        """Compare the boxes of both halves of the flight with one that the turned box is in."""
        return may_reach_in_halves(self.box)

    @property
    def approach_test(self) -> dict[str, sp.Basic]:
        """No test besides that."""
        return {}

    def narrowed(self, width: sp.Expr) -> sp.Expr:
        """Return a shorter window where the gap opens more and more, as after a roll over an edge.

        There F is about k t³ at first, and a step that all of the acceleration limits is far
        shorter than t: there would be hundreds of them.
        """
        if not self.flight.departs:
            return width
        return barrier(minimum(width, self.opening(1)))

    def curvature(self, width: sp.Expr) -> sp.Expr:
        """Return a smaller bound in scenes where balls roll, which takes v² into account.

        As long as e keeps its sign, v² + e a has the rate 3 v a and bends upwards. Within a time s
        it is at least v² + e a + 3 min(0, v a) s; at all times it is at least -|e a|.
        """
        if not self.flight.departs:
            return super().curvature(width)
        lowest = []
        for e, v, a in self._moving():
            drift = barrier(barrier(absolute(v) + absolute(a) * width / 2) * width)
            general = barrier(-absolute(a) * minimum(barrier(absolute(e) + drift), self._reach))
            local = barrier(barrier(v**2 + e * a) + 3 * minimum(0, barrier(v * a)) * width)
            lowest.append(IfLess(drift, absolute(e), barrier(maximum(general, local)), general))
        slack = sp.Rational(1, 2**40) * ceiling
        return slack - 2 * barrier(sp.Add(*lowest))


@dataclass(frozen=True)
class AirObliqueBoxRootFinder(_Turned, AirBoxRootFinder):
    """The root finder for a turned box along a piece of a flight through air."""

    box: ObliqueBox

    @property
    def _pull(self) -> sp.Expr:
        """A bound on the acceleration along each axis of the box."""
        return barrier(DIAGONAL * self.box.scale * super()._pull)
