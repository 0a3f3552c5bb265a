"""Bounds on how deep a recorded flight penetrates a surface, proved and not sampled."""

from __future__ import annotations

from collections.abc import Sequence

from flint import arb, arb_poly, arb_series, ctx
from hoopgen.derive.scenes import HOOP
from hoopgen.derive.scenes.scene import Scene

from hoopgen.judge.flight import arrival_at, left_by
from hoopgen.judge.formulas import Formulas, SurfaceFormulas, formulas
from hoopgen.judge.roots import sign_variations

AUDIT_BITS = 128

TOLERANCE = 1e-17
"""m: the bound is no further than this from the deepest point."""


def deepest(
    state: Sequence[float],
    duration: float,
    parameters: Sequence[float],
    leaving: int = -1,
    scene: Scene = HOOP,
) -> tuple[float, ...]:
    """Return bounds on how deep the ball penetrates each surface during a flight.

    What has no bounds may not be entered at all. What has bounds is a face: the ball may come to be
    behind it around its edges, but not through it.

    Parameters
    ----------
    state
        At the start, (9,); taken exactly.
    duration
        Of the flight, s.
    parameters
        In calling order.
    leaving
        The surface that the ball is on at the start, -1 for none.
    scene
        Of derive/.

    Returns
    -------
    tuple
        An upper bound on the depth (m) by surface, zero if the ball certainly stays outside.
    """
    with ctx.workprec(AUDIT_BITS):
        start, values = [arb(c) for c in state], [arb(p) for p in parameters]
        own, end = formulas(scene), arb(duration)
        depths = [0.0] * len(own.solids)
        left = left_by(own, start, values, leaving)  # of a box, the part that it leaves
        for k, surface in enumerate(own.surfaces[: own.faces]):
            depth = _depth(own, k, start, end, values, k == left)
            depths[surface.face] = max(depths[surface.face], depth)
        return tuple(depths)


def _depth(
    own: Formulas, place: int, start: list[arb], duration: arb, values: list[arb], leaving: bool
) -> float:
    surface = own.surfaces[place]
    if not surface.bounded:
        return _deepest(own, surface, start, arb(0), duration, values)
    depth = -surface.distance(start, values)[0] if leaving else arb(0)
    arrival = arrival_at(own, place, start, values, 0, arb.pos_inf())
    behind = 0.0
    if arrival is not None and not arrival.time > duration:
        behind = _deepest(own, surface, start, arrival.time.lower().max(0), duration, values)
    return max(behind, float(depth.upper()), 0.0)


def _deepest(
    own: Formulas,
    surface: SurfaceFormulas,
    start: list[arb],
    begin: arb,
    end: arb,
    values: list[arb],
) -> float:
    """Split the flight until each part is outside or no deeper than the known maximum."""
    coefficients = surface.coefficients(start, values)
    polynomial = arb_poly(coefficients)
    bound, reached = 0.0, arb(TOLERANCE)
    narrowest = end * arb(2) ** -(ctx.prec // 2)
    parts = [(begin, end)]
    while parts:
        low, high = parts.pop()
        if sign_variations(polynomial, len(coefficients) - 1, low, high - low)[1] == 0:
            continue
        around = _along(own, start, values, low.union(high))
        if any(part >= 0 for part in surface.inside(around, values)):
            continue
        depth = -_least_distance(own, surface, start, values, low, high)
        if depth <= reached or high - low < narrowest:
            bound = max(bound, float(depth.upper()))
            continue
        middle = ((low + high) / 2).mid()
        here = _along(own, start, values, middle)
        if all(part < 0 for part in surface.inside(here, values)):
            reached = reached.max(-surface.distance(here, values)[0].lower())
        parts += [(middle, high), (low, middle)]
    return bound


def _along(own: Formulas, start: list[arb], values: list[arb], time: arb) -> list[arb]:
    return own.flight(start, values, (time,))


def _least_distance(
    own: Formulas,
    surface: SurfaceFormulas,
    start: list[arb],
    values: list[arb],
    low: arb,
    high: arb,
) -> arb:
    """Return a lower bound of the distance from `low` to `high`.

    Where the distance's rate keeps its sign, it is the distance at one of the ends; else Taylor's
    theorem about the middle.
    """
    middle = ((low + high) / 2).mid()
    everywhere = _taylor(own, surface, start, values, low.union(high))
    rate = everywhere[1]
    if rate >= 0:
        return _taylor(own, surface, start, values, low)[0].lower()
    if rate <= 0:
        return _taylor(own, surface, start, values, high)[0].lower()
    distance, slope, _ = _taylor(own, surface, start, values, middle)
    away = low.union(high) - middle
    bounds = [distance + away * slope + away * away * everywhere[2], everywhere[0]]
    finite = [bound.lower() for bound in bounds if bound.is_finite()]
    return max(finite, key=float) if finite else arb.neg_inf()


def _taylor(
    own: Formulas, surface: SurfaceFormulas, start: list[arb], values: list[arb], time: arb
) -> list[arb]:
    """Return the distance's Taylor coefficients about each of the times, to the second."""
    along = arb_series([time, 1], prec=3)
    moving = own.flight([arb_series([c], prec=3) for c in start], values, (along,))
    distance = surface.distance(moving, values)[0]
    return [distance[k] for k in range(3)]
