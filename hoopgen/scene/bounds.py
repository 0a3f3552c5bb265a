"""Bounds of a body (Eq. 2), made ready for the search: lengths whose gradient is at most 1.

A user's bound is a polynomial in the coordinates of a point of the body; it counts where that is at
most 0. The search asks it of the ball's centre, which is a known linear map away. Half-spaces and
round bounds (a circle about an axis, a sphere) become distances; others are refused.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import reduce
from operator import add

from .formulas import ONE, POSITION, ZERO, Formula, FormulaError, Polynomial, constant, polynomial
from .inputs import Inputs

__all__ = ["Bound", "Half", "Map", "Round", "made"]


@dataclass(frozen=True)
class Half:
    """A half-space: a·p + c <= 0, a of length 1."""

    direction: tuple[Formula, Formula, Formula]
    offset: Formula


@dataclass(frozen=True)
class Round:
    """Within a distance from a point or an axis, sign 1, or beyond it, sign -1."""

    axes: tuple[int, ...]
    centre: tuple[Formula, ...]
    radius: Formula
    sign: int


Bound = Half | Round


@dataclass(frozen=True)
class Map:
    """From the ball's centre p to the point that it touches: q_k = scale_k p_k + shift_k."""

    scale: tuple[Formula, Formula, Formula] = (ONE, ONE, ONE)
    shift: tuple[Formula, Formula, Formula] = (ZERO, ZERO, ZERO)


def made(
    inputs: Inputs, owner: str, within: Sequence[object], there: Map | None = None
) -> tuple[Bound, ...]:
    """Return the bounds of a body or an end.

    Parameters
    ----------
    inputs
        Of the scene; what the bounds need is added.
    owner
        Whose they are, for complaints and names.
    within
        What a user wrote: polynomials that are at most 0 where the body is there.
    there
        From the centre to the body; None: the bounds are the centre's own.

    Raises
    ------
    SceneError
        If one is not polynomial, neither flat nor round, or round where the body is not flat.
    """
    if isinstance(within, str):
        raise inputs.wrong(owner, "within", f"expected a list of formulas, got {within!r}")
    return tuple(
        _bound(inputs, owner, f"within {number}", given, there or Map())
        for number, given in enumerate(within, start=1)
    )


def _bound(inputs: Inputs, owner: str, argument: str, given: object, there: Map) -> Bound:
    formula = inputs.read(owner, argument, given, POSITION)
    try:
        terms = polynomial(formula)
        degree = max((sum(powers) for powers in terms), default=0)
        if degree == 0:
            raise FormulaError(f"{formula} has none of x, y, z")
        if degree == 1:
            return _half(inputs, owner, argument, terms, there)
        return _round(inputs, owner, argument, terms, there)
    except FormulaError as error:
        raise inputs.wrong(owner, argument, error) from None


def _power(axis: int, power: int = 1) -> tuple[int, int, int]:
    powers = [power * (k == axis) for k in range(3)]
    return powers[0], powers[1], powers[2]


def _half(inputs: Inputs, owner: str, argument: str, terms: Polynomial, there: Map) -> Half:
    slopes = [terms.get(_power(k), ZERO) for k in range(3)]
    offset = terms.get((0, 0, 0), ZERO)
    for k in range(3):
        offset = offset + slopes[k] * there.shift[k]
    steep = [k for k in range(3) if slopes[k].number != 0]
    if len(steep) == 1 and slopes[steep[0]].number is not None:
        # Along an axis: the direction is exact.
        axis, slope = steep[0], slopes[steep[0]].number
        assert slope is not None
        size = constant(abs(slope)) * there.scale[axis]
        unit = [constant(int(k == axis) * (1 if slope > 0 else -1)) for k in range(3)]
        return Half((unit[0], unit[1], unit[2]), inputs.add(owner, argument, offset / size))
    scaled = [slope * factor for slope, factor in zip(slopes, there.scale, strict=True)]
    length = reduce(add, (part**2 for part in scaled)).sqrt()
    unit = [
        inputs.add(owner, f"{argument} {axis}", part / length, unit="1")
        for axis, part in zip(POSITION, scaled, strict=True)
    ]
    return Half((unit[0], unit[1], unit[2]), inputs.add(owner, argument, offset / length))


def _round(inputs: Inputs, owner: str, argument: str, terms: Polynomial, there: Map) -> Round:
    axes = tuple(k for k in range(3) if _power(k, 2) in terms)
    known = {_power(k, power) for k in axes for power in (1, 2)} | {(0, 0, 0)}
    squares = [terms[_power(k, 2)] for k in axes]
    factor = squares[0].number if squares else None
    if not set(terms) <= known or factor is None or any(s.number != factor for s in squares):
        raise FormulaError(
            "neither flat nor round: expected such as x - a, or (x - a)**2 + y**2 - r**2, or minus "
            "one of them"
        )
    if any(there.scale[k] != ONE or there.shift[k] != ZERO for k in axes):
        raise FormulaError("round, and this body is not flat: expected a half-space")
    centre = [-terms.get(_power(k), ZERO) / constant(2 * factor) for k in axes]
    rest = terms.get((0, 0, 0), ZERO) / constant(-factor)
    radius = _root(inputs, reduce(add, (part**2 for part in centre), rest))
    named = tuple(
        inputs.add(owner, f"{argument} {POSITION[k]}", part)
        for k, part in zip(axes, centre, strict=True)
    )
    size = inputs.add(owner, argument, radius, sign="positive")
    return Round(axes, named, size, 1 if factor > 0 else -1)


def _root(inputs: Inputs, square: Formula) -> Formula:
    """Return the root of a square; of that of a positive parameter, itself."""
    if square.kind == "**" and square.value == 2:
        base = square.parts[0]
        positive = {i.name for i in inputs.all if i.sign == "positive"}
        if base.kind == "name" and base.value in positive:
            return base
    return square.sqrt()
