"""A filter of flights that cannot reach a plate, from their ends: without root or division.

Along an axis without acceleration, the coordinate of the ball is between those at the flight's
start and end. With s for the error of a length, there is no contact

- on a plane across that axis that is further than s away;
- within a bound a - sqrt(q) <= 0, with q a sum of such coordinates' squares, if q < (a - 2 s)²
  for the largest values of the coordinates within the plate's other bounds.

**Lemma (plates that are missed).** If one of these holds as computed, the true ball meets the plate
at no time until the horizon.

*Proof.* s is p + v T + 2^-30 X, with X the size of the flight: no place of the true ball is further
than s from the computed path, whose ends are off by 2 u X. The true coordinate is linear in time,
so it is between those of the true ends, which differ by less than s from the computed ones; what
2^-30 X has besides exceeds the roundings of the plane's place and of the difference. On the plate
such a coordinate is, besides, within the plate's bounds, so that sqrt(q) of the true ball is at
most s above the largest value at which the test looks, and less than a - s: the bound does not
hold. The factor 1 + 2^-40 exceeds the roundings of q. ∎ (X is less than 2^20 times the plate's
lengths.)
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import sympy as sp

from ..ir.kernel import Kernel, decision
from ..motion.parabola import Parabola
from ..surfaces import Plane
from ..symbolic.conditionals import Less, Not, all_of, any_of, barrier, maximum, minimum
from ..symbolic.symbols import POSITION, VELOCITY
from .bounding_boxes import path_slack
from .event_polynomials import horizon

_ROUNDED = 1 + sp.Rational(1, 2**40)
"""Exceeds the roundings of a sum of squares."""

Spans = Mapping[sp.Symbol, tuple[sp.Expr, sp.Expr]]
"""The smallest and the largest value of a coordinate."""


def apart(plane: Plane, flight: Parabola) -> tuple[sp.Basic, ...]:
    """Return conditions, each of which implies that a flight does not come to a plate.

    Parameters
    ----------
    plane
        A surface with bounds.
    flight
        The motion between contacts.
    """
    return tuple(_apart(plane, _spans(flight), path_slack(flight)))


def reachable(plates: Sequence[Sequence[sp.Basic]]) -> Kernel:
    """Return the test whether a flight may come to any of several plates."""
    missed = [any_of(*conditions) for conditions in plates]
    summary = "Whether a flight with these ends may come to a plate."
    return decision("reachable", {"reachable": Not(all_of(*missed))}, summary)


def _spans(flight: Parabola) -> Spans:
    """Return the ranges of coordinates until the horizon, along axes without acceleration."""
    spans = {}
    for place, v, a in zip(POSITION, VELOCITY, flight.acceleration, strict=True):
        if a == 0:
            there = barrier(place + v * horizon)
            spans[place] = barrier(minimum(place, there)), barrier(maximum(place, there))
    return spans


def _apart(plane: Plane, spans: Spans, slack: sp.Expr) -> Iterator[sp.Basic]:
    for place, sign in zip(POSITION, plane.direction, strict=True):
        if sign and place in spans:
            low, high = spans[place]
            yield Less(slack, (low if sign > 0 else -high) - barrier(plane.offset))
    yield from _inside(plane, spans, slack)


def _sides(plane: Plane, place: sp.Symbol) -> tuple[list[sp.Expr], list[sp.Expr]]:
    """Return the lower and the upper limits of a coordinate in a plate's bounds."""
    least: list[sp.Expr] = []
    most: list[sp.Expr] = []
    for limit in plane.limits:
        sign, rest = limit.coeff(place), limit.coeff(place, 0)
        alone = sp.expand(limit - sign * place - rest) == 0
        if alone and abs(sign) == 1 and rest.free_symbols.isdisjoint(POSITION):
            (most if sign > 0 else least).append(-sign * rest)
    return least, most


def _square(plane: Plane, place: sp.Symbol, span: tuple[sp.Expr, sp.Expr]) -> sp.Expr:
    """Return the largest square of a coordinate on a plate.

    If the bounds are symmetric it is their square; if they leave one side of zero, that of the
    farther end.
    """
    least, most = _sides(plane, place)
    if len(least) == len(most) == 1 and least[0] == -most[0]:
        return barrier(most[0] ** 2)
    ends = [barrier(minimum(barrier(maximum(side, *least)), *most)) for side in span]
    if 0 in (*least, *most):
        return barrier(ends[0 if 0 in most else 1] ** 2)
    return barrier(maximum(*(barrier(end**2) for end in ends)))


def _inside(plane: Plane, spans: Spans, slack: sp.Expr) -> Iterator[sp.Basic]:
    """Return conditions that the other bounds lie in a circle that the plate excludes."""
    squares = {place**2: place for place in spans}
    for limit in plane.limits:
        for root in limit.atoms(sp.Pow):
            radius, terms = limit + root, sp.Add.make_args(root.base)
            if root.exp != sp.Rational(1, 2) or radius.free_symbols & set(POSITION):
                continue
            if all(term in squares for term in terms):
                places = [squares[term] for term in terms]
                most = sum(_square(plane, place, spans[place]) for place in places)
                inner = barrier(radius - 2 * slack)
                yield all_of(Less(0, inner), Less(_ROUNDED * barrier(most), inner**2))
