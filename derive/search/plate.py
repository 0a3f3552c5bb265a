"""Which flights come to a plate at all, by where they begin and end: neither root nor division.

Where nothing accelerates the ball along an axis, its coordinate is between those of the flight's
start and of its end. With s for all that is not exact in a length, no contact is

- on a plane across that axis that is further than s off;
- within a bound a - sqrt(q) <= 0, with q a sum of such coordinates' squares, where q < (a - 2 s)²
  at the largest that they can be within the plate's other bounds.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import sympy as sp

from ..flight.parabola import Parabola
from ..ground.choice import Less, Not, every, hold, largest, smallest, some
from ..ground.kernel import Kernel, decision
from ..ground.symbols import POSITION, VELOCITY
from ..surfaces import Plane
from .events import horizon
from .far import spare

_ROUNDED = 1 + sp.Rational(1, 2**40)
"""More than roundings make of a sum of squares."""

Spans = Mapping[sp.Symbol, tuple[sp.Expr, sp.Expr]]
"""The smallest and the largest value of a coordinate."""


def apart(plane: Plane, flight: Parabola) -> tuple[sp.Basic, ...]:
    """Return conditions, each of which means that a flight does not come to a plate."""
    return tuple(_apart(plane, _spans(flight), spare(flight)))


def reachable(plates: Sequence[Sequence[sp.Basic]]) -> Kernel:
    """Return whether a flight may come to any of several plates."""
    missed = [some(*conditions) for conditions in plates]
    said = "Where a flight that begins and ends like that may come to a plate."
    return decision("reachable", {"reachable": Not(every(*missed))}, said)


def _spans(flight: Parabola) -> Spans:
    """Return what coordinates are until the horizon, along axes without acceleration."""
    spans = {}
    for place, v, a in zip(POSITION, VELOCITY, flight.acceleration, strict=True):
        if a == 0:
            there = hold(place + v * horizon)
            spans[place] = hold(smallest(place, there)), hold(largest(place, there))
    return spans


def _apart(plane: Plane, spans: Spans, slack: sp.Expr) -> Iterator[sp.Basic]:
    for place, sign in zip(POSITION, plane.direction, strict=True):
        if sign and place in spans:
            low, high = spans[place]
            yield Less(slack, (low if sign > 0 else -high) - hold(plane.offset))
    yield from _inside(plane, spans, slack)


def _sides(plane: Plane, place: sp.Symbol) -> tuple[list[sp.Expr], list[sp.Expr]]:
    """Return what a plate's bounds say that a coordinate is not less, and not more than."""
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

    Where the bounds are as far on both sides it is that of the bounds; on one side of zero alone,
    that of what is further from it.
    """
    least, most = _sides(plane, place)
    if len(least) == len(most) == 1 and least[0] == -most[0]:
        return hold(most[0] ** 2)
    ends = [hold(smallest(hold(largest(side, *least)), *most)) for side in span]
    if 0 in (*least, *most):
        return hold(ends[0 if 0 in most else 1] ** 2)
    return hold(largest(*(hold(end**2) for end in ends)))


def _inside(plane: Plane, spans: Spans, slack: sp.Expr) -> Iterator[sp.Basic]:
    """Return conditions that what is within all other bounds is in a circle that a plate is not."""
    squares = {place**2: place for place in spans}
    for limit in plane.limits:
        for root in limit.atoms(sp.Pow):
            radius, terms = limit + root, sp.Add.make_args(root.base)
            if root.exp != sp.Rational(1, 2) or radius.free_symbols & set(POSITION):
                continue
            if all(term in squares for term in terms):
                places = [squares[term] for term in terms]
                most = sum(_square(plane, place, spans[place]) for place in places)
                inner = hold(radius - 2 * slack)
                yield every(Less(0, inner), Less(_ROUNDED * hold(most), inner**2))
