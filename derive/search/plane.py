"""Arrival on a plane: its condition is linear or quadratic in time, its root a closed form."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import sympy as sp

from ..flight.parabola import Parabola
from ..ground.choice import IfAtMost, IfLess, hold, size
from ..ground.kernel import Kernel
from ..ground.rounding import SAFETY, rounding
from ..ground.symbols import POSITION, position
from ..ground.tree import Do, Guard, Node, Value
from ..surfaces import Plane
from .decisions import KERNELS
from .events import event_coefficients, horizon, leaving
from .plate import apart
from .search import Formula, Parts, Search, bounded, edges, proposed


def plane_arrival(plane: Plane, flight: Parabola) -> dict[str, sp.Expr]:
    """Return time, rate and bend (F'') of a plane's only arrival, the root with F' < 0.

    Also the time of the apex of the gap and its height there, D / (-4 a), for a ball that moves
    along the plane now: whether there is an arrival is in doubt if that is zero within its error.

    With D = b² - 4 a c the arrival is where F' = -sqrt(D): t = 2 c / (sqrt(D) - b), the same as
    -(b + sqrt(D)) / (2 a); each loses no digits for one sign of b. Without an arrival the rate is
    not negative or not a number.
    """
    coefficients = event_coefficients(plane, flight)
    c = hold(IfLess(0, leaving, 0, hold(coefficients[0])), "c")
    b = coefficients[1] if len(coefficients) > 1 else sp.Integer(0)
    if len(coefficients) < 3:
        along = {"apex": IfAtMost(size(b), 0, 0, -1), "height": c}
        return {"time": c / -b, "rate": b, "bend": sp.Integer(0)} | along
    a = coefficients[2]
    discriminant = hold(b**2 - 4 * a * c, "D")
    # On leaving it is |b|, which the root of b² is too, unless b² is less than the least number.
    root = hold(IfLess(0, leaving, size(b), sp.sqrt(discriminant)))
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


def plane_margin(plane: Plane, flight: Parabola) -> sp.Expr:
    """Return a bound on the rounding error of the plane's gap up to the time `horizon`."""
    there, _ = flight.rounding(horizon)
    # Twice: once for the gap at the computed time, once for the root's own arithmetic.
    return 2 * SAFETY * rounding(plane.distance, dict.fromkeys(POSITION, there)).error


@dataclass(frozen=True)
class PlaneSearch(Search):
    """The search on a plane; a contact counts within its bounds (Eq. 2)."""

    surface: Plane
    flight: Parabola

    @property
    def closed(self) -> bool:
        """Its only arrival is a closed form."""
        return True

    @property
    def formulas(self) -> dict[str, Formula]:
        """Arrival, margin, and the place of a contact."""
        plane = self.surface
        place = position - plane.distance * plane.normal
        return {
            "arrival": (
                plane_arrival(plane, self.flight),
                "Time of the only arrival, the gap's rate there and its bend.",
                "Eq. 3 in Table 2, solved",
            ),
            "margin": (
                {"margin": plane_margin(plane, self.flight)},
                "Rounding-error bound of the gap up to the horizon.",
                "running error analysis",
            ),
            "place": (
                dict(zip("xyz", place, strict=True)),
                "The point of the contact plane nearest to a position.",
                "Table 2",
            ),
        }

    @property
    def decisions(self) -> dict[str, Kernel]:
        """Whether a contact lies within the bounds, and whether that is in doubt."""
        return edges(self.surface)

    @property
    def apart(self) -> tuple[sp.Basic, ...]:
        """A plate is not reached where the flight's ends say so."""
        return apart(self.surface, self.flight) if self.surface.bounds else ()

    def nodes(self, common: Parts, own: Parts, index: Value) -> Iterator[Node]:
        """Propose the only arrival, if it is one and within the bounds."""
        yield Do(KERNELS["left"], {"index": index})
        yield Do(own["arrival"])
        yield Do(KERNELS["meeting_plane"])
        # An arrival in doubt about its apex is at the same time, as far as a margin can tell.
        yield Do(own["margin"], {"horizon": "nearest"})
        yield Do(common["crossing"], {"rate_margin": 0.0})
        yield Do(KERNELS["timely"])
        yield Do(KERNELS["grazed"])
        if not self.surface.bounds:
            yield Guard("possible", (Do(KERNELS["crossed"]), *proposed(index)))
            return
        yield Guard("possible", (*bounded(common, own, "time"), *proposed(index)))
