"""How deep a recorded flight goes into a surface: a bound on the deepest point, not a sample."""

from __future__ import annotations

from collections.abc import Sequence

from flint import arb, arb_poly, arb_series, ctx

from .formulas import SurfaceFormulas, formulas
from .roots import positive_within, sign

AUDIT_BITS = 128

TOLERANCE = 1e-17
"""m: the bound is no further than this from the deepest point."""


def deepest(
    state: Sequence[float], duration: float, parameters: Sequence[float]
) -> tuple[float, ...]:
    """Bound how deep the ball is inside each surface during a flight.

    Parameters
    ----------
    state
        At the start, (9,); taken exactly.
    duration
        Of the flight, s.
    parameters
        In calling order.

    Returns
    -------
    tuple
        An upper bound on the depth (m) by surface, zero if the ball certainly stays outside.
    """
    with ctx.workprec(AUDIT_BITS):
        start, values = [arb(c) for c in state], [arb(p) for p in parameters]
        found = (_deepest(s, start, arb(duration), values) for s in formulas().surfaces[:-1])
        return tuple(found)


def _deepest(surface: SurfaceFormulas, start: list[arb], end: arb, values: list[arb]) -> float:
    """Split the flight until each part is outside, or no deeper than is known already."""
    coefficients = surface.coefficients(start, values)
    polynomial = arb_poly(coefficients)
    bound, reached = 0.0, arb(TOLERANCE)
    parts = [(arb(0), end)]
    while parts:
        low, high = parts.pop()
        if positive_within(polynomial, len(coefficients) - 1, low, high - low):
            continue
        middle = ((low + high) / 2).mid()
        time = low.union(high)
        around = _along(start, values, time)
        if any(part >= 0 for part in surface.inside(around, values)):
            continue
        depth = -_least_distance(surface, start, values, low, high)
        if depth <= reached or (high - low) < end * arb(2) ** -(ctx.prec // 2):
            bound = max(bound, float(depth.upper()))
            continue
        here = _along(start, values, middle)
        if all(sign(part) == -1 for part in surface.inside(here, values)):
            reached = reached.max(-surface.distance(here, values)[0].lower())
        parts += [(middle, high), (low, middle)]
    return bound


def _along(start: list[arb], values: list[arb], time: arb) -> list[arb]:
    return formulas().flight(start, values, (time,))


def _least_distance(
    surface: SurfaceFormulas, start: list[arb], values: list[arb], low: arb, high: arb
) -> arb:
    """Return a lower bound of the distance from `low` to `high`.

    Where the distance's rate keeps its sign, it is the distance at one of the ends; else Taylor's
    theorem about the middle.
    """
    middle = ((low + high) / 2).mid()
    everywhere = _taylor(surface, start, values, low.union(high))
    rate = everywhere[1]
    if rate >= 0:
        return _taylor(surface, start, values, low)[0].lower()
    if rate <= 0:
        return _taylor(surface, start, values, high)[0].lower()
    distance, slope, _ = _taylor(surface, start, values, middle)
    away = low.union(high) - middle
    bounds = [distance + away * slope + away * away * everywhere[2], everywhere[0]]
    finite = [bound.lower() for bound in bounds if bound.is_finite()]
    return max(finite, key=float) if finite else arb.neg_inf()


def _taylor(surface: SurfaceFormulas, start: list[arb], values: list[arb], time: arb) -> list[arb]:
    """Return the distance's Taylor coefficients about each of the times, to the second."""
    along = arb_series([time, 1], prec=3)
    moving = formulas().flight([arb_series([c], prec=3) for c in start], values, (along,))
    distance = surface.distance(moving, values)[0]
    return [distance[k] for k in range(3)]
