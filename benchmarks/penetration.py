"""Bounds on how deep a recorded flight penetrates a surface, proved and not sampled."""

from __future__ import annotations

from collections.abc import Sequence

from flint import arb, arb_poly, arb_series, ctx
from hoopgen.derive.scenes import HOOP
from hoopgen.derive.scenes.scene import Scene

from hoopgen.judge.arrivals import arrival_at
from hoopgen.judge.formulas import Formulas, SurfaceFormulas, formulas
from hoopgen.judge.pieces import Piece, next_piece
from hoopgen.judge.roots import sign_variations
from hoopgen.judge.start import left_by

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

    Raises
    ------
    ValueError
        If the ball flies through air.
    """
    if scene.air is not None:
        raise ValueError(f"scene {scene.name}: air: expected flights on parabolas")
    with ctx.workprec(AUDIT_BITS):
        start, values = [arb(c) for c in state], [arb(p) for p in parameters]
        own, end = formulas(scene), arb(duration)
        piece = next_piece(own, start, values)
        depths = [0.0] * len(own.solids)
        left = left_by(own, start, values, leaving)  # of a box, the part that it leaves
        for k, surface in enumerate(own.surfaces[: own.faces]):
            depth = _depth(own, k, piece, end, values, k == left)
            depths[surface.face] = max(depths[surface.face], depth)
        return tuple(depths)


def _depth(
    own: Formulas, place: int, piece: Piece, duration: arb, values: list[arb], leaving: bool
) -> float:
    surface = own.surfaces[place]
    if not surface.bounded:
        return _deepest(surface, piece, arb(0), duration, values)
    depth = -surface.distance(piece.start, values)[0] if leaving else arb(0)
    arrival = arrival_at(own, place, piece, values, 0, arb.pos_inf())
    behind = 0.0
    if arrival is not None and not arrival.time > duration:
        behind = _deepest(surface, piece, arrival.time.lower().max(0), duration, values)
    return max(behind, float(depth.upper()), 0.0)


def _deepest(
    surface: SurfaceFormulas,
    piece: Piece,
    begin: arb,
    end: arb,
    values: list[arb],
) -> float:
    """Split the flight until each part is outside or no deeper than the known maximum."""
    polynomial = surface.condition(piece.path, values)[0]
    bound, reached = 0.0, arb(TOLERANCE)
    narrowest = end * arb(2) ** -(ctx.prec // 2)
    parts = [(begin, end)]
    while parts:
        low, high = parts.pop()
        if sign_variations(polynomial, polynomial.degree(), low, high - low)[1] == 0:
            continue
        around = piece.at(low.union(high))
        if any(part >= 0 for part in surface.inside(around, values)):
            continue
        depth = -_least_distance(surface, piece, values, low, high)
        if depth <= reached or high - low < narrowest:
            bound = max(bound, float(depth.upper()))
            continue
        middle = ((low + high) / 2).mid()
        here = piece.at(middle)
        if all(part < 0 for part in surface.inside(here, values)):
            reached = reached.max(-surface.distance(here, values)[0].lower())
        parts += [(middle, high), (low, middle)]
    return bound


def _least_distance(
    surface: SurfaceFormulas,
    piece: Piece,
    values: list[arb],
    low: arb,
    high: arb,
) -> arb:
    """Return a lower bound of the distance from `low` to `high`.

    Where the distance's rate keeps its sign, it is the distance at one of the ends; else Taylor's
    theorem about the middle.
    """
    middle = ((low + high) / 2).mid()
    everywhere = _taylor(surface, piece, values, low.union(high))
    rate = everywhere[1]
    if rate >= 0:
        return _taylor(surface, piece, values, low)[0].lower()
    if rate <= 0:
        return _taylor(surface, piece, values, high)[0].lower()
    distance, slope, _ = _taylor(surface, piece, values, middle)
    away = low.union(high) - middle
    bounds = [distance + away * slope + away * away * everywhere[2], everywhere[0]]
    finite = [bound.lower() for bound in bounds if bound.is_finite()]
    return max(finite, key=float) if finite else arb.neg_inf()


def _taylor(surface: SurfaceFormulas, piece: Piece, values: list[arb], time: arb) -> list[arb]:
    """Return the distance's Taylor coefficients about each of the times, to the second."""
    about = (coordinate(arb_poly([time, 1])) for coordinate in piece.path)
    place = [arb_series([local[k] for k in range(3)], prec=3) for local in about]
    distance = surface.distance(place, values)[0]
    return [distance[k] for k in range(3)]
