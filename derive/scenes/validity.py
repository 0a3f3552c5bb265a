"""Whether a shot can be simulated: its parameters, and where the ball starts."""

from __future__ import annotations

from collections.abc import Sequence, Set

import sympy as sp

from ..ground.choice import (
    AtMost,
    IfAtMost,
    IfLess,
    Less,
    Not,
    every,
    hold,
    largest,
    release,
    size,
    some,
)
from ..ground.number_range import MAX_COEFFICIENT, MAX_SIZE, MIN_SIZE
from ..ground.symbols import POSITION, UNIT_ROUNDOFF
from ..surfaces import Free, Surface
from .scene import Parameter, Scene

last = sp.Symbol("last", real=True)
"""Index of the surface that the ball touched last, -1 for none."""

permission = sp.Symbol("allowed", real=True)
"""Positive where the parameters are allowed."""


index, valid_so_far, doubt_so_far = sp.symbols("index valid doubt", real=True)
blur, leeway = sp.symbols("blur leeway", real=True)
"""How much of a length may be rounded; and how far from a box of surfaces that may matter."""

measured, lengths = sp.symbols("measured lengths", nonnegative=True)
"""The sum of the sizes of a scene's lengths, and the same of a shot that has begun."""

_UNITS = ("m", "m/s", "m/s²")
"""Of what is added to coordinates, speeds and accelerations."""

ROOM = 8
"""A ball so many times further from the box of a surface than is rounded is not inside it, nor is
that in doubt: what says so is no less than the distance from the box, but for what is rounded."""


def plain(expression: sp.Basic) -> sp.Basic:
    """Return the expression in symbols that assume nothing of their sign."""
    return expression.xreplace({s: s.func(s.name, real=True) for s in expression.free_symbols})


def valid(scene: Scene, tabled: Set[int]) -> dict[str, sp.Expr]:
    """Return whether a ball can start at a finite position, and whether that is in doubt.

    A ball is inside a surface if the largest of the surface's `inside` is negative; in doubt if
    it is within the rounding of its evaluation. The surface that the ball leaves is not asked.

    Nor are the surfaces of those indices, which the loop goes over (`start`). For them there is
    also how much may be rounded, and the room within which that may matter.
    """
    slack = _slack([measured] if tabled else _sizes(scene))
    verdict: sp.Expr = sp.Integer(1)
    doubt: sp.Expr = sp.Integer(0)
    for index, surface in enumerate(scene.surfaces):
        if index not in tabled:
            verdict, doubt = _asked(surface, index, verdict, doubt, slack)
    found = {"valid": verdict, "doubt": doubt}
    return found | ({"blur": slack, "leeway": ROOM * slack} if tabled else {})


def measure(scene: Scene) -> dict[str, sp.Expr]:
    """Return the sum of the sizes of a scene's lengths: one for all shots that share them."""
    return {measured.name: hold(sum(_sizes(scene)))}


def _sizes(scene: Scene) -> list[sp.Expr]:
    return [sp.Abs(plain(length)) for length in scene.lengths]


def _slack(lengths: Sequence[sp.Expr]) -> sp.Expr:
    return hold(16 * UNIT_ROUNDOFF * hold(sum(map(sp.Abs, POSITION)) + sum(lengths)))


def aside(scene: Scene) -> dict[str, sp.Basic]:
    """Return where a ball starts so near to a surface along an axis that `valid` has to be asked.

    Elsewhere it says what it would. There is none where a surface has no end along any axis.
    """
    room = hold(ROOM * _slack(_sizes(scene)))
    for axis in range(3):
        found = [[hold(plain(d)) for d in surface.aside(axis)] for surface in scene.surfaces]
        if found and all(found):
            apart = (some(*(Less(room, distance) for distance in own)) for own in found)
            known = {"valid": sp.Integer(1), "doubt": sp.Integer(0)}
            return {"close": Not(every(*apart)), **known}
    return {}


def start(surface: Surface) -> dict[str, sp.Expr]:
    """Return the same of one surface more, of the index that the loop is at."""
    verdict, doubt = _asked(surface, index, valid_so_far, doubt_so_far, blur)
    return {"valid": verdict, "doubt": doubt}


def _asked(
    surface: Surface, index: sp.Expr | int, verdict: sp.Expr, doubt: sp.Expr, slack: sp.Expr
) -> tuple[sp.Expr, sp.Expr]:
    overlap = hold(largest(*map(plain, surface.inside)))
    left = hold(sp.Abs(last - index))
    near = IfAtMost(size(overlap), hold(plain(surface.steepness)) * slack, 1, doubt)
    return (
        IfLess(left, sp.Rational(1, 2), verdict, IfAtMost(0, overlap, verdict, 0)),
        IfLess(left, sp.Rational(1, 2), doubt, near),
    )


def allowed(scene: Scene) -> dict[str, sp.Expr]:
    """Return 1 where the parameters are allowed; each condition falls through to the rest or 0."""
    verdict: sp.Expr = sp.Integer(1)
    for requirement in scene.requirements:
        verdict = IfLess(0, plain(requirement), verdict, 0)
    for parameter in scene.parameters:
        value = plain(parameter.symbol)
        if parameter.sign == "positive":
            verdict = IfLess(0, value, verdict, 0)
        if parameter.sign == "nonnegative":
            verdict = IfAtMost(0, value, verdict, 0)
        if parameter.lower is not None:
            verdict = IfAtMost(parameter.lower, value, verdict, 0)
        if parameter.upper is not None:
            verdict = IfAtMost(value, parameter.upper, verdict, 0)
    return {"allowed": verdict}


def size_limits(scene: Scene, parameter: Parameter) -> tuple[sp.Expr, sp.Expr]:
    """Return the least and the largest size of a parameter (`ground/number_range.py`)."""
    scales = parameter.symbol in (scene.ball_radius, scene.gravity)
    if parameter.infinite:
        return sp.Integer(0), sp.oo
    largest_size = MAX_SIZE if parameter.unit in _UNITS else MAX_COEFFICIENT
    return MIN_SIZE if scales else sp.Integer(0), largest_size


def parameters_in_range(scene: Scene) -> dict[str, sp.Expr]:
    """Return where all parameters are allowed, and of sizes that no arithmetic overflows with.

    One that is not a number has no size that is at most any other.
    """
    asked: list[sp.Basic] = []
    for parameter in scene.parameters:
        least, most = size_limits(scene, parameter)
        asked.append(AtMost(size(plain(parameter.symbol)), most))
        if least != 0:
            asked.append(AtMost(least, size(plain(parameter.symbol))))
    asked += (AtMost(1 / MAX_COEFFICIENT, scale) for scale in condition_scales(scene))
    return {"permitted": every(Less(0, permission), *asked)}


def condition_scales(scene: Scene) -> list[sp.Expr]:
    """Return the size of the largest coefficient of each polynomial of one's own."""
    found = []
    for surface in scene.surfaces:
        if isinstance(surface, Free):
            terms = sp.Poly(release(surface.formula), *POSITION).terms()
            factors = [plain(factor) for powers, factor in terms if any(powers)]
            if not any(factor.is_Rational for factor in factors):  # which is some whole number
                found.append(largest(*map(size, factors)))
    return found
