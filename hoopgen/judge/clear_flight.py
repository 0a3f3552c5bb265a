"""Proof that a box of flights meets nothing for a while, so that it may be followed from there.

The event polynomials of a flight that begins far from all bodies have large coefficients that
cancel near a contact; of a box of flights that costs many times its width. From a place near the
contact on they do not. Pieces of a flight through air are short enough.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from flint import arb

from .expressions import Function
from .formulas import Formulas
from .pieces import Piece
from .taylor_model import Number

_FIRST_STEP = 2.0**-6
"""The part of a flight that is tried first, s."""

_FINEST = 2.0**-10
"""Share of the time since the start below which a part is not made shorter."""

_STEPS = 400
"""Parts that are tried at most."""


def clear_until(
    formulas: Formulas, piece: Piece, values: list[arb], begin: float, end: float
) -> float:
    """Return a time between two others until which all flights of a box certainly meet nothing.

    From `begin` to that time certainly no ball overlaps a body, none crosses the plane of an end
    against its normal, and none crosses the plane of the scene's passage within its disc.

    Parameters
    ----------
    formulas
        The formulas of the scene.
    piece
        The flights.
    values
        The kernels' inputs.
    begin
        Time since the start of the flights, s.
    end
        The latest time, s; may be infinite.

    Returns
    -------
    float
        s; `begin` if nothing is proved.
    """
    passage = None if formulas.passage is None else formulas.passage(values)

    def is_clear(there: Sequence[Number]) -> bool:
        return (
            all(_is_outside(solid, there, values) for solid in formulas.solids)
            and _crosses_no_plane(formulas, there, values)
            and (passage is None or _is_outside_passage(there, passage[0]))
        )

    return _holds_until(is_clear, piece, begin, end)


def misses_body(
    formulas: Formulas, surface: int, piece: Piece, values: list[arb], begin: float, end: float
) -> bool:
    """Return whether all flights of a box certainly miss a whole body between two times.

    Parameters
    ----------
    formulas, piece, values, begin, end
        As for `clear_until`; `end` is finite.
    surface
        The number of a surface of the body.
    """
    solid = formulas.solids[formulas.surfaces[surface].face]
    return _holds_until(lambda there: _is_outside(solid, there, values), piece, begin, end) >= end


def _holds_until(
    holds: Callable[[Sequence[Number]], bool], piece: Piece, begin: float, end: float
) -> float:
    """Return the time until which a condition holds of the states of a piece.

    Parts of the time are tried one after another, longer ones after one in which it holds.
    """
    reached, step = begin, begin / 8 or _FIRST_STEP
    in_balls = piece.in_balls
    for _ in range(_STEPS):
        then = min(reached + step, end)
        during = arb(reached).union(arb(then))
        # Balls are many times quicker than models, and mostly enough.
        if then > reached and (holds(in_balls.at(during)) or holds(piece.at(during))):
            reached, step = then, 2 * step
        elif reached < end and step > _FINEST * max(reached, _FIRST_STEP):
            step /= 2
        else:
            break
    return reached


def _is_outside(solid: Function, there: Sequence[Number], values: list[arb]) -> bool:
    return any(part > 0 for part in solid(there, values))


def _crosses_no_plane(formulas: Formulas, there: Sequence[Number], values: list[arb]) -> bool:
    """Return whether no ball certainly crosses the plane of an end against its normal."""
    for plane in formulas.surfaces[formulas.faces :]:
        normal = plane.normal(there, values)
        rate = sum((n * v for n, v in zip(normal, there[3:6], strict=True)), arb(0))
        if not (plane.distance(there, values)[0] > 0 or rate > 0):
            return False
    return True


def _is_outside_passage(there: Sequence[Number], radius: arb) -> bool:
    outside = there[0] * there[0] + there[1] * there[1] > radius * radius
    return bool(there[2] > 0 or there[2] < 0 or outside)
