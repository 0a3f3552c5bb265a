"""The calling order of kernels: the arguments that they may have."""

from __future__ import annotations

import sympy as sp

from ..errors import contact_frames, friction, propagation, provisional, tighter_bounds
from ..events import bounding_boxes, event_polynomials, search_for
from ..events.predicates import pad
from ..scenes import validity
from ..scenes.scene import Scene
from ..studies import ARGUMENTS
from ..symbolic.rounding import extent, position_error, speed, velocity_error
from ..symbolic.symbols import NORMAL, STATE, change_of, t
from .variation import contact_delay, variation_symbols

FRAME = sp.Matrix(3, 3, lambda i, j: sp.Symbol(f"n{i + 1}{j + 1}", real=True))
"""Components of the contact frame, R of Eq. 10."""

RESTITUTION = sp.Symbol("restitution", nonnegative=True)
"""Restitution of the impact through the frame, which belongs to no law of a scene."""

_SEARCH = (
    t,
    event_polynomials.end,
    event_polynomials.leaving,
    event_polynomials.margin,
    event_polynomials.rate_margin,
    event_polynomials.rate,
    event_polynomials.ceiling,
    event_polynomials.delay,
    event_polynomials.share,
    event_polynomials.horizon,
)

_BOXES = (
    validity.lengths,
    pad,
    *bounding_boxes.BOX_CENTRES,
    *bounding_boxes.HALF_SIZES,
    *bounding_boxes.LATER_BOX_CENTRES,
    *bounding_boxes.LATER_HALF_SIZES,
    *bounding_boxes.HALVES_NEAR,
    *bounding_boxes.NEGATED_MINIMA,
    *bounding_boxes.MAXIMA,
    *bounding_boxes.MAX_HALF_SIZES,
)


def argument_order(scene: Scene) -> tuple[sp.Symbol, ...]:
    """Return all symbols that kernels of valid shots may have as arguments, in calling order."""
    surfaces = (*scene.surfaces, *scene.end_planes)
    searches = (search_for(surface, scene.flight) for surface in surfaces)
    constants = (symbol for search in searches for symbol in search.constants)
    return (
        *(*_SEARCH, *STATE, *NORMAL, *FRAME),
        *(extent, speed, position_error, velocity_error),
        *propagation.ARGUMENTS,
        *contact_frames.ARGUMENTS,
        *friction.ARGUMENTS,
        *(provisional.estimated, provisional.clock_bound),
        *tighter_bounds.TIGHTENING,
        *_BOXES,
        *scene.flight.symbols,
        *variation_symbols(scene),
        *dict.fromkeys(constants),
        *ARGUMENTS,
        *scene.symbols,
        contact_delay,
        *map(change_of, scene.symbols),
        RESTITUTION,
    )


def unchecked_argument_order(scene: Scene) -> tuple[sp.Symbol, ...]:
    """Return the symbols of kernels that run before the parameters are known to be valid."""
    so_far = (
        *(validity.left_middle, validity.left_reach),
        *(validity.index, validity.blur, validity.measured),
        *(validity.valid_so_far, validity.undecided_so_far),
    )
    parameters = map(validity.without_assumptions, scene.symbols)
    return (validity.last, *so_far, *STATE, *parameters)


def components(names: tuple[sp.Symbol, ...], *vectors: sp.Matrix) -> dict[str, sp.Expr]:
    """Return the components of vectors as outputs that are called as the symbols are."""
    values = [component for vector in vectors for component in vector]
    return {symbol.name: value for symbol, value in zip(names, values, strict=True)}
