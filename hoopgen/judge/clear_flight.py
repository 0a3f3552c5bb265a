"""Proof that a box of flights meets nothing for a while, so that it may be followed from there.

The event polynomials of a flight that begins far from all bodies have large coefficients that
cancel near a contact; of a box of flights that costs many times its width. From a place near the
contact on they do not. Pieces of a flight through air are short enough.
"""

from __future__ import annotations

from collections.abc import Sequence

from flint import arb

from .formulas import Formulas
from .pieces import Piece, next_piece

_SLICES = 64
"""Parts of a flight, each of which is proved to be clear by itself."""

_SPLITS = 6
"""Number of times that a part is halved that is not."""


def clear_until(
    formulas: Formulas, state: Sequence[arb], parameters: Sequence[float], end: float
) -> float:
    """Return a time, at most `end`, until which all flights of a box certainly meet nothing.

    In each part of the time, certainly no ball overlaps a body, none crosses the plane of an end
    against its normal, and none crosses the plane of the scene's passage within its disc.

    Parameters
    ----------
    formulas
        The formulas of the scene.
    state
        The states at the release, nine balls.
    parameters
        The kernels' inputs, exact numbers.
    end
        The time of an event of one of them, s.

    Returns
    -------
    float
        s; 0 if nothing is proved, or if the ball flies through air.
    """
    if formulas.air is not None:
        return 0.0
    values = [arb(value) for value in parameters]
    passage = None if formulas.passage is None else formulas.passage(values)
    piece = next_piece(formulas, state, values)
    reached = 0.0
    waiting = [
        (end * k / _SLICES, end * (k + 1) / _SLICES, _SPLITS) for k in reversed(range(_SLICES))
    ]
    while waiting:
        low, high, splits = waiting.pop()
        if _is_clear(formulas, piece, values, passage, arb(low).union(arb(high))):
            reached = high
        elif splits:
            middle = (low + high) / 2
            waiting += [(middle, high, splits - 1), (low, middle, splits - 1)]
        else:
            break
    return reached


def _is_clear(
    formulas: Formulas,
    piece: Piece,
    values: list[arb],
    passage: Sequence[arb] | None,
    times: arb,
) -> bool:
    """Return whether the flights certainly meet nothing at any of the times."""
    there = piece.at(times)
    if any(all(not part > 0 for part in solid(there, values)) for solid in formulas.solids):
        return False
    for plane in formulas.surfaces[formulas.faces :]:
        normal = plane.normal(there, values)
        rate = sum((n * v for n, v in zip(normal, there[3:6], strict=True)), arb(0))
        if not (plane.distance(there, values)[0] > 0 or rate > 0):
            return False
    if passage is None:
        return True
    outside = there[0] * there[0] + there[1] * there[1] > passage[0] * passage[0]
    return bool(there[2] > 0 or there[2] < 0 or outside)
