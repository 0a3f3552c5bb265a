"""The constants in the text of the derivation page."""

from __future__ import annotations

import sympy as sp

from hoopgen.derive.errors import (
    contact_frames,
    friction,
    propagation,
    provisional,
    second_order,
    surface_frames,
    tighter_bounds,
)
from hoopgen.derive.events import air as air_search
from hoopgen.derive.events import (
    air_near,
    bounding_boxes,
    box_windows,
    event_polynomials,
    polynomial,
    predicates,
    root_search,
)
from hoopgen.derive.events.ring import air as ring_in_air
from hoopgen.derive.events.ring import double, polar, single
from hoopgen.derive.motion import air_piece, air_series, ring_rolling_series, rolling_series
from hoopgen.derive.rolling import apex, friction_limit, neighbour
from hoopgen.derive.scenes import premises, sinking, validity
from hoopgen.derive.symbolic import error_terms, rounding

from .latex import number, show


def constants() -> dict[str, str]:
    """Return the constants in the text, in LaTeX."""
    found: dict[str, sp.Expr | int] = {
        "safety": rounding.ROUNDING_SLACK,
        "thicker": polar.INFLATION_FACTOR,
        "wider": box_windows.RELATIVE_INFLATION,
        "ease": double.RingRootFinder.ease,
        "single": single.SinglePrecisionRing.unit,
        "first_share": event_polynomials.ERROR_BUDGET_LEVELS[0],
        "last_share": event_polynomials.ERROR_BUDGET_LEVELS[-1],
        "finer": event_polynomials.ERROR_BUDGET_LEVELS[1]
        / event_polynomials.ERROR_BUDGET_LEVELS[0],
        "converged": predicates.CONVERGED,
        "found": predicates.CONVERGED**2 / 2,
        "steps": root_search.STEP_LIMIT,
        "newton": root_search.NEWTON_LIMIT,
        "turns": single.MAX_STEPS,
        "guard": error_terms.DECISION_FACTOR,
        "claim": propagation.REPORTED_FACTOR,
        "lift": propagation.MIN_GROWTH_DIVISOR,
        "frame_rounding": contact_frames.T_ROUNDING,
        "product_rounding": tighter_bounds.PRODUCT_ROUNDING,
        "renewal": tighter_bounds.RENEWAL,
        "law_roundings": contact_frames.LAW_ROUNDINGS,
        "slip_room": friction.ROOM,
        "slip_change": friction.LARGEST_CHANGE,
        "direction_order": friction.DIRECTION_ORDER,
        "direction_slope": friction.DIRECTION_SLOPE,
        "motion_roundings": friction.MOTION_ROUNDINGS,
        "spin_roundings": friction.SPIN_ROUNDINGS,
        "share_roundings": friction.SHARE_ROUNDINGS,
        "slope_roundings": friction.SLOPE_ROUNDINGS,
        "margin_rounding": friction.MARGIN_ROUNDING,
        "seam_share": surface_frames.SEAM_SHARE,
        "largest_place": provisional.LARGEST_PLACE,
        "slowest": provisional.SLOWEST,
        "stretch": second_order.STRETCH,
        "largest_flight": premises.LARGEST,
        "largest_by_ball": premises.LARGEST_BY_BALL,
        "narrowest": premises.NARROWEST,
        "widest": premises.WIDEST,
        "least": propagation.ERROR_FLOOR,
        "far": bounding_boxes.RELATIVE_SLACK,
        "beyond": polynomial.CEILING_BOX_FACTOR,
        "missed": rolling_series.LAST_TERM_TOLERANCE,
        "missed_round": ring_rolling_series.LAST_TERM_TOLERANCE,
        "order": rolling_series.ORDER,
        "order_round": ring_rolling_series.ORDER,
        "neighbour": neighbour.NEIGHBOUR_DISTANCE,
        "near_axis": apex.NEAREST_TO_AXIS,
        "vague_axis": apex.LARGEST_ERROR,
        "watched": friction_limit.NEWTON_STEPS,
        "room": validity.CERTAIN_DISTANCE_FACTOR,
        "piece_order": air_series.ORDER,
        "first_single": air_series.FIRST_SINGLE,
        "longest_radius": air_piece.MAX_RADIUS,
        "piece_unit": air_piece.PIECE_UNIT,
        "longest_piece": air_piece.LONGEST,
        "shortest_piece": air_piece.SHORTEST,
        "piece_overlap": air_piece.OVERLAP,
        "piece_tube": air_series.TUBE,
        "single_roundoff": air_piece.SINGLE_ROUNDOFF,
        "square_roundings": air_piece.SQUARE_ROUNDINGS,
        "drag_roundings": air_piece.DRAG_ROUNDINGS,
        "magnus_roundings": air_piece.MAGNUS_ROUNDINGS,
        "weight_roundings": air_piece.WEIGHT_ROUNDINGS,
        "carried_share": air_series.CARRIED_SHARE,
        "cancellation": air_piece.CANCELLATION,
        "underflow": air_piece.UNDERFLOW,
        "past": sinking.ROOM,
        "steep": ring_in_air.STEEP,
        "budget": air_search.BUDGET,
        "near_share": air_near.SHARE,
    }
    values = {name: sp.Rational(value) for name, value in found.items()}
    tolerance = f"2^{{{int(sp.log(air_piece.TOLERANCE, 2))}}}"
    return {name: number(value) or show(value) for name, value in values.items()} | {
        "piece_tolerance": tolerance
    }
