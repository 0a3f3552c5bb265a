"""Proofs in balls that shots are valid: their parameters, their sizes and their start."""

from __future__ import annotations

from collections.abc import Set

import numpy as np
from flint import arb
from numpy.typing import NDArray

from hoopgen.core.start_contact import start_contact
from hoopgen.derive.symbolic.number_range import MAX_COEFFICIENT, MAX_SIZE

from .ball_array import BallArray, Bools, Floats
from .formulas import Formulas
from .roots import Undecided, sign

_MAX_SIZE, _MIN_SCALE = arb(float(MAX_SIZE)), 1 / arb(float(MAX_COEFFICIENT))


def valid(formulas: Formulas, state: list[arb], values: list[arb], leaving: int) -> bool:
    """Return whether all parameters are allowed and the ball is inside no surface.

    Parameters
    ----------
    formulas
        The formulas of the scene.
    state
        The release, nine balls.
    values
        The kernels' inputs.
    leaving
        The body that the ball leaves at the start, or -1.
    """
    if not all(abs(component) <= _MAX_SIZE for component in state):
        return False
    if not all(_allowed(formulas, index, value) for index, value in enumerate(values)):
        return False
    if not all(scale >= _MIN_SCALE for scale in formulas.scales(values)):
        return False
    for requirement in formulas.requirements(values):
        side = sign(requirement)
        if side is None:
            raise Undecided("the parameters are on the edge of what is allowed")
        if side <= 0:
            return False
    own = {surface.face for surface in formulas.surfaces if surface.body == leaving}
    others = [k for k in range(len(formulas.solids)) if k not in own]
    if any(_overlaps(formulas, k, state, values) for k in others):
        return False
    return leaving < 0 or _touches(formulas, own, state, values)


def _touches(formulas: Formulas, own: Set[int], state: list[arb], values: list[arb]) -> bool:
    """Return whether a ball touches the body of some surfaces, as `start_contact` says."""

    def overlap(rows: NDArray[np.int64], moved: Floats) -> tuple[Bools, Bools]:
        del rows
        there = [arb(component) for component in moved[0].tolist()]
        sides = [_side(formulas, k, there, values) for k in range(len(formulas.solids))]
        others = any(side is not False for k, side in enumerate(sides) if k not in own)
        inside = others or any(sides[k] is not False for k in own)
        clear = others or all(sides[k] is not True for k in own)
        return np.array([inside]), np.array([clear])

    radius = np.array([float(values[formulas.ball_radius])])
    begun = np.array([[float(component.mid()) for component in state]])
    away, inside = start_contact(begun, radius, overlap)
    return not (away[0] or inside[0])


def _allowed(formulas: Formulas, index: int, value: arb) -> bool:
    """Return whether the value of a parameter, which is exact, is allowed."""
    least, most = formulas.sizes[index]
    if not least <= abs(value) <= most:
        return False
    sign, lower, upper = formulas.signs[index], formulas.lowers[index], formulas.uppers[index]
    if not (value > 0 if sign == "positive" else sign == "any" or value >= 0):
        return False
    return (lower is None or value >= lower) and (upper is None or value <= upper)


def _side(formulas: Formulas, face: int, state: list[arb], values: list[arb]) -> bool | None:
    """Return whether the ball overlaps a body, None if undecided."""
    sides = [sign(part) for part in formulas.solids[face](state, values)]
    if any(side is not None and side >= 0 for side in sides):
        return False
    return None if None in sides else True


def _overlaps(formulas: Formulas, face: int, state: list[arb], values: list[arb]) -> bool:
    side = _side(formulas, face, state, values)
    if side is None:
        name = next(surface.name for surface in formulas.surfaces if surface.face == face)
        if not all(part.is_finite() for part in formulas.solids[face](state, values)):
            # A Taylor model of it, such as that of a distance from an axis, has no enclosure.
            where = f"where the distance from the {name} has no slope, such as its axis"
            raise Undecided(f"the ball starts at or near a place {where}")
        raise Undecided(f"the ball starts on the edge of the {name}")
    return side


def surely_valid(formulas: Formulas, states: Floats, parameters: Floats) -> Bools:
    """Return which shots are certainly valid and begin on no body.

    Parameters
    ----------
    formulas
        The formulas of the scene.
    states
        The releases, exact, (n, 9).
    parameters
        The kernels' inputs, exact, (n, p). Those that may be zero must be positive here.
    """
    sure = (np.abs(states) <= float(MAX_SIZE)).all(axis=1)
    state = [BallArray.exact(c) for c in np.ascontiguousarray(states.T)]
    values = [BallArray.exact(c) for c in np.ascontiguousarray(parameters.T)]
    limits = zip(
        formulas.sizes, formulas.signs, formulas.lowers, formulas.uppers, values, strict=True
    )
    for (least, most), allowed, lower, upper, value in limits:
        own = value.middle
        sure &= (np.abs(own) >= least) & (np.abs(own) <= most)
        sure &= (own > 0) | (allowed == "any")
        sure &= own >= (-np.inf if lower is None else lower)
        sure &= own <= (np.inf if upper is None else upper)
    scale = BallArray.exact(np.array([1 / float(MAX_COEFFICIENT)]))
    for size in formulas.scales(values):
        sure &= (size - scale).positive()
    for requirement in formulas.requirements(values):
        sure &= requirement.positive()
    for solid in formulas.solids:
        sure &= np.any([part.positive() for part in solid(state, values)], axis=0)
    return np.asarray(sure)
