"""Arrival on a plane: its condition is linear or quadratic in time, its root a closed form.

**Lemma (arrival on a plane).** Let k >= 0 be the size of gravity across a plane, towards it, and p
and v the errors of the place and velocity at the start. Let an arrival be computed at T > 0 with
the rate -r, and the margin m of `plane_margin` up to T. Let nothing be undecided at the start or at
an apex (`plane_start.py`). If the arrival is certain, r² > 6 k m, the true ball falls through the
plane once, within 2 m/r = delay/3 of T. If k > 0 and it is not certain, the true ball is no sooner
there than delay/5 before T.

*Proof.* By the lemma of `plane_start.py` the true gap f falls through zero once; it is concave. T
is the root of the computed gap to within u (|X| + |c| + max(0, -2 c) + 4 r T) of the gap, with X
the plane's place (`tests/derive/errors/test_plane_roots.py`), which is less than the 4 u of the
flight and the u of the plane's place that m/2 has besides p + v T. So |f(T)| <= m/2. Let r' be the
rate of f at T, less its sign: of -r that is off by at most v and k times by what the root is.

- *Certain, k > 0.* 8 v² <= k p and m >= 2 p give r² > 12 k p >= 96 v², v < r/9. The root is off by
  less than 1.01 m/(2 r), and k times that is less than r/11: r' > 0.79 r. At s = 2 m/r after T the
  gap is at most m/2 - r' s < 0, and s before T at least r' s - m/2 - k s²/2 > m (1.58 - 1/2 - 1/3).
- *k = 0.* The margin is that of T or of an earlier arrival, which then is the event. Else r > 4 v
  (`plane_start.py`): r' > 3/4 r. At s after T the gap is less than m/2 - 3/2 m < 0, and s before T
  more than 3/2 m - m/2 > 0.
- *Not certain.* With h, the largest gap from the start on, r² >= 2 k h > 2 k m.
  Let q be the share of p + v T in m/2. Then v <= sqrt(k p/8) < 0.18 sqrt(q) r, and the root's
  rounding turns r by at most 0.2 (1 - q) r: r' > 0.76 r. At 6/5 m/r before T the gap is more than
  m (0.91 - 1/2 - 0.36) > 0. ∎

The bounds of planes on which a ball may roll, and of planes from which gravity pulls it off, are
not those of this lemma. No ball rolls on a plane that ends a shot.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import sympy as sp

from ..ir.event_tree import Call, If, Node, Value
from ..ir.kernel import Kernel
from ..motion.flight import has_sign
from ..motion.parabola import Parabola
from ..surfaces import EndPlane, InclinedPlane, Plane
from ..surfaces.directions import along
from ..symbolic.conditionals import IfAtMost, IfLess, absolute, barrier
from ..symbolic.rounding import ROUNDING_SLACK, rounding
from ..symbolic.symbols import POSITION, VELOCITY, position
from .event_polynomials import event_coefficients, horizon, leaving
from .plane_filter import apart
from .plane_start import start_side, vague_pull
from .predicates import KERNELS
from .search import Formula, Parts, Search, bounded, edges, given, proposed

AnyPlane = Plane | InclinedPlane
"""A plane across an axis, or with a normal in any direction."""


def asks_side(plane: AnyPlane, flight: Parabola) -> bool:
    """Return whether it is decided on which side of a plane every flight begins.

    Where balls roll, that is not so of bodies that gravity pulls to, or may pull to: a ball that
    begins on one may stay there. Of other flights it is decided there, too.

    Parameters
    ----------
    plane, flight
        As for `plane_arrival`.
    """
    pulls = along(plane.direction, flight.acceleration).is_negative
    return not flight.departs or isinstance(plane, EndPlane) or pulls is False


def plane_arrival(plane: AnyPlane, flight: Parabola) -> dict[str, sp.Expr]:
    """Return time, rate and second derivative of a plane's only arrival, the root with F' < 0.

    Also the time of the gap's apex and the gap there, D / (-4 a), for a ball that moves along the
    plane at that time: whether there is an arrival is undecided if that gap is zero within its
    error. The gap at the start stands for that of a ball that falls from then on, unless it begins
    on the plane and may stay there; and of a plane along gravity, if `asks_side`.

    With D = b² - 4 a c the arrival is where F' = -sqrt(D): t = 2 c / (sqrt(D) - b), the same as
    -(b + sqrt(D)) / (2 a); each loses no digits for one sign of b. Without an arrival the rate is
    not negative, or NaN.

    Parameters
    ----------
    plane
        The surface, whose bounds are not looked at.
    flight
        The motion between contacts.

    Returns
    -------
    dict
        `time`, s; `rate`, F' there; `bend`, F''; `apex`, s; and `height`, the gap at it, m.
    """
    coefficients = event_coefficients(plane, flight)
    c = barrier(IfLess(0, leaving, 0, barrier(coefficients[0])), "c")
    b = _held(coefficients[1]) if len(coefficients) > 1 else sp.Integer(0)
    if len(coefficients) < 3:
        still = {"apex": IfAtMost(absolute(b), 0, 0, -1), "height": c}
        if asks_side(plane, flight):
            left = IfLess(b, 0, 0, sp.oo)
            still = {"apex": sp.Integer(0), "height": IfLess(0, leaving, left, c)}
        return {"time": c / -b, "rate": b, "bend": sp.Integer(0)} | still
    a = _held(coefficients[2])
    bend = 2 * a
    discriminant = barrier(b**2 - 4 * a * c, "D")
    # On leaving the root is |b|; that of b² is the same unless b² underflows.
    root = barrier(IfLess(0, leaving, absolute(b), sp.sqrt(discriminant)))
    numerator = IfLess(b, 0, 2 * c, b + root)
    denominator = IfLess(b, 0, root - b, -2 * a)
    rate = -root
    if has_sign(a):
        per_bend = barrier(1 / (2 * a))
        apex, height = -b * per_bend, -discriminant * per_bend / 2
        if a.is_negative:
            apex, height = _largest(b, c, (apex, height), asks_side(plane, flight))
    else:
        # Without acceleration the formulas above hold, where 0/0 and an infinite time are no
        # arrival; the gap has no apex.
        size = barrier(absolute(a))
        per_bend = barrier(1 / (2 * barrier(IfLess(0, size, a, 1))))
        apex = IfLess(0, size, -b * per_bend, IfAtMost(absolute(b), 0, 0, -1))
        height = IfLess(0, size, -discriminant * per_bend / 2, c)
        first, largest = _largest(b, c, (apex, height), asks_side(plane, flight))
        apex, height = IfLess(a, 0, first, apex), IfLess(a, 0, largest, height)
        if isinstance(plane, InclinedPlane):
            error = vague_pull(plane, flight)
            met, apex, height, bend = _without_sign(a, b, c, error, (discriminant, apex, height))
            rate = IfLess(0, met, rate, root)
    return {
        "time": numerator / denominator,
        "rate": rate,
        "bend": bend,
        "apex": apex,
        "height": height,
    }


def _largest(
    b: sp.Expr, c: sp.Expr, usual: tuple[sp.Expr, sp.Expr], asked: bool
) -> tuple[sp.Expr, sp.Expr]:
    """Return the time from the start on at which the gap is largest, and the gap then.

    Gravity pulls to the plane. Of a ball that falls from the start on, that is the start. If the
    side is not asked of every flight, one that begins on the plane keeps its apex, before the
    start.

    Parameters
    ----------
    b, c
        The rate of the gap at the start, and the gap.
    usual
        Time of the apex, and the gap there.
    asked
        What `asks_side` returns.
    """
    apex, height = usual
    if asked:
        return IfLess(b, 0, 0, apex), IfLess(b, 0, c, height)
    falls = barrier(IfLess(b, 0, IfLess(0, leaving, 0, 1), 0))
    return IfLess(0, falls, 0, apex), IfLess(0, falls, c, height)


def _held(coefficient: sp.Expr) -> sp.Expr:
    """Return a coefficient that is rounded once: a sum would else join those that it stands in."""
    return barrier(coefficient) if coefficient.is_Add else coefficient


def _without_sign(
    a: sp.Expr, b: sp.Expr, c: sp.Expr, error: sp.Expr, usual: tuple[sp.Expr, sp.Expr, sp.Expr]
) -> tuple[sp.Expr, sp.Expr, sp.Expr, sp.Expr]:
    """Return an arrival up to roundings: if there is any, apex, height and F''.

    The acceleration across the plane is a sum a = d·g/2, which cancels where the plane is along
    gravity, and the path has roundings of g t²/2. With E for `vague_pull` and |a| <= E, the
    true size is at most 2 E. Then a ball that does not approach the plane, or slows down before it,
    comes to it no sooner than at the first root T of c + b t - 2 E t². From then on it may: T takes
    the place of the apex, with a gap of zero, and F'' is zero, so that the place of the contact is
    not known. Of the arrival of any other ball F'' is at most |2 a| + 2 E.

    Parameters
    ----------
    a, b, c
        The coefficients of the gap, m/s², m/s and m.
    error
        E, m/s².
    usual
        b² - 4 a c, and apex and height where the sign of a is certain.
    """
    early = barrier(sp.sqrt(barrier(b**2 + 8 * barrier(error * c))))
    first = IfLess(b, 0, 2 * c, b + early) / barrier(IfLess(b, 0, early - b, 4 * error))
    discriminant, apex, height = usual
    arrives = IfLess(b, 0, IfAtMost(0, discriminant, 1, 0), 0)
    vague = IfLess(0, error, IfAtMost(absolute(a), error, 1, 0), 0)
    size = barrier(2 * barrier(absolute(a) + error))
    return (
        IfLess(0, vague, arrives, 1),
        IfLess(0, vague, IfLess(0, arrives, -1, barrier(first)), apex),
        IfLess(0, vague, 0, height),
        IfLess(0, vague, IfLess(0, arrives, IfLess(a, 0, -size, size), 0), 2 * a),
    )


def plane_margin(plane: AnyPlane, flight: Parabola) -> sp.Expr:
    """Return a bound on the rounding error of the plane's gap up to the time `horizon`.

    Parameters
    ----------
    plane
        The surface.
    flight
        The motion between contacts.

    Returns
    -------
    Expr
        m.
    """
    there, _ = flight.rounding(horizon)
    # Twice: once for the gap at the computed time, once for the root's own arithmetic.
    return 2 * ROUNDING_SLACK * rounding(plane.condition, dict.fromkeys(POSITION, there)).error


def returning_margin(plane: AnyPlane, flight: Parabola) -> sp.Expr:
    """Return a bound on the error of the gap of a ball that left this plane, up to `horizon`.

    The ball began on the plane, and so did the true one: both gaps are t times the mean velocity
    off the plane, w = n·(v + a t/2). The errors of the position do not count, and with the bound
    e(t) on the error of a mean velocity that of the gap is |w - w'| t <= e(t) t. It bounds the
    computed gap, too, whose constant term is exactly zero. For small bounces t goes to zero, and
    the margin of `plane_margin` would exceed the height of the hop.

    Parameters
    ----------
    plane, flight
        As for `plane_margin`.

    Returns
    -------
    Expr
        m.
    """
    # Twice, as in `plane_margin`.
    return 2 * ROUNDING_SLACK * barrier(mean_rate_error(plane, flight) * horizon)


def mean_rate_error(plane: AnyPlane, flight: Parabola) -> sp.Expr:
    """Return a bound on the error of the mean velocity off a plane, up to the time `horizon`.

    Parameters
    ----------
    plane, flight
        As for `plane_margin`.

    Returns
    -------
    Expr
        m/s.
    """
    mean = flight.mean_rounding(horizon)
    return rounding(along(plane.direction, VELOCITY), dict.fromkeys(VELOCITY, mean)).error


@dataclass(frozen=True)
class PlaneSearch(Search):
    """The search on a plane; a contact counts within its bounds (Eq. 2)."""

    surface: AnyPlane
    flight: Parabola

    @property
    def closed(self) -> bool:
        """True: the only arrival is a closed form."""
        return True

    @property
    def returns(self) -> bool:
        """True if bounces on the plane can become ever smaller until the ball rolls."""
        return self.flight.departs and not isinstance(self.surface, EndPlane)

    @property
    def level(self) -> bool:
        """True of a plane along gravity of which a flight's side is decided."""
        fall = along(self.surface.direction, self.flight.acceleration)
        return asks_side(self.surface, self.flight) and fall == 0

    @property
    def pulled_off(self) -> bool:
        """True of a plane that gravity pulls a ball off, or may, as its parameters have it."""
        fall = along(self.surface.direction, self.flight.acceleration)
        return fall != 0 and not fall.is_negative

    @property
    def formulas(self) -> dict[str, Formula]:
        """Arrival, margin, the place of a contact, and the start if gravity pulls a ball off."""
        plane = self.surface
        margin = plane_margin(plane, self.flight)
        if self.returns:
            margin = IfLess(0, leaving, returning_margin(plane, self.flight), margin)
        place = position - plane.distance * plane.normal
        start: dict[str, Formula] = {}
        if self.pulled_off:
            start["start_side"] = (
                start_side(plane, self.flight),
                "Rate and gap at the start, and its margin.",
                "running error analysis",
            )
        return {
            "arrival": (
                plane_arrival(plane, self.flight),
                "Time of the only arrival, the gap's first two derivatives there, and its apex.",
                "Eq. 3 in Table 2, solved",
            ),
            "margin": (
                {"margin": margin},
                "Rounding-error bound of the gap up to the horizon.",
                "running error analysis",
            ),
            "place": (
                dict(zip("xyz", place, strict=True)),
                "Point of the contact plane nearest to a position.",
                "Table 2",
            ),
        } | start

    @property
    def decisions(self) -> dict[str, Kernel]:
        """The decisions whether a contact lies within the bounds, and whether that is undecided."""
        return edges(self.surface)

    @property
    def apart(self) -> tuple[sp.Basic, ...]:
        """Conditions of a plate across an axis by the ends of the flight.

        Along an axis, these do not tell on which side of another plane the ball is.
        """
        plate = self.surface
        return apart(plate, self.flight) if isinstance(plate, Plane) and plate.bounds else ()

    def nodes(self, common: Parts, own: Parts, index: Value) -> Iterator[Node]:
        """Propose the only arrival, if it exists and lies within the bounds."""
        yield Call(KERNELS["left_either" if self.remembered else "left"], {"index": index})
        yield Call(own["arrival"])
        yield Call(KERNELS["level_root" if self.level else "plane_root"])
        # An arrival that is undecided at its apex is at the same time within the margin.
        yield Call(own["margin"], {"horizon": "nearest"})
        yield Call(common["crossing"], {} if self.remembered else {"rate_margin": 0.0})
        yield Call(KERNELS["within_time"])
        if self.pulled_off:
            yield Call(own["start_side"])
            side = {"rate": "side_rate", "height": "side_gap", "margin": "side_margin"}
            yield Call(KERNELS["side_undecided"], side)
        # Balls that begin to roll have apexes within the margin all the time.
        asked = asks_side(self.surface, self.flight)
        apex = "side_undecided" if self.level else "apex_undecided"
        grazing = Call(KERNELS[apex if asked else "graze_undecided"])
        if not self.surface.bounds:
            yield grazing
            yield If("possible", (Call(KERNELS["crossing_undecided"]), *proposed(index)))
            return
        if self.returns and not asked:
            yield from _graze_within_bounds(common, own)
        else:
            yield grazing
        yield If("possible", (*bounded(common, own, "time"), *proposed(index)))


def _graze_within_bounds(common: Parts, own: Parts) -> Iterator[Node]:
    """Test whether an apex is undecided, where the bounds may hold.

    On a floor of several planes each hop of a ball that begins to roll, and each departure, has its
    apex at the height of all of them. With the computed gap F(t) = H + F'' (t - A)²/2, whose error
    until a contact is at most the margin m, a contact has |F| <= m. If |H| <= m, it is at most
    2 sqrt(m/|F''|) away from the computed apex A. The bounds are evaluated at A, and their errors
    contain the way flown in the time of 3 sqrt(m/|F''|). Without F'' the gap stays zero. Of a ball
    that falls from the start on, A is the start and H the gap then: it falls faster, and is within
    m no longer.

    Arguments as for `Search.nodes`.
    """
    there = {name: f"there_{name}" for name in "xyz"}
    slackened = given(common["displacement"], horizon="graze_end", delay="graze_delay")
    yield Call(KERNELS["graze_delay"])
    tested = (
        Call(common["flight"], {"t": "apex"}, there, frozenset(there)),
        given(own["bounds"], **there),
        Call(slackened.kernel, slackened.inputs, {"margin": "slack"}),
        # A graze is never a certain crossing: what may be within the bounds is undecided.
        given(own["edges"], clearance=0.0),
        given(KERNELS["predicate_undecided"], time="apex"),
    )
    yield If("grazes", tested, rare=True)
