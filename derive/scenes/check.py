"""Checks of a scene: formulas that are not what the scene declares are refused, with the reason.

Symbolic properties are checked symbolically; all others on random points where the ball touches the
surface, with more digits than doubles have and with the parameters' default values.
"""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import mpmath
import sympy as sp

from ..surfaces import Surface
from ..symbolic.conditionals import Barrier, IfAtMost, IfLess, release
from ..symbolic.symbols import POSITION

if TYPE_CHECKING:
    from .scene import Scene

MAX_DEGREE = 4
"""The highest degree of a condition in x, y, z; its degree in time is twice that."""

_POINTS = 4
_STEPS = 60
_DIGITS = 30
_NEAR = mpmath.mpf(10) ** -10
"""Far above the rounding of a formula that is zero, far below any mistake."""

Function = Callable[..., list[Any]]


def check(scene: Scene) -> None:
    """Check that the formulas of surfaces, ends and laws are what the scene declares.

    Raises
    ------
    ValueError
        Naming the scene, the surface or end, the fault, and what is expected.
    """
    known = {*POSITION, *scene.symbols}
    surfaces = [(f"surface {surface.name}", surface) for surface in scene.surfaces]
    ends = [(f"end {end.name}", end.plane) for end in scene.ends]
    for owner, surface in (*surfaces, *ends):
        try:
            _formulas(surface, known)
            _places(surface, scene)
        except _Refused as reason:
            raise ValueError(f"scene {scene.name}: {owner}: {reason}") from None
    for law in scene.laws:
        arriving = sp.Symbol("speed", positive=True)
        given = (known - set(POSITION)) | {arriving}
        for symbol in _unknown([law.restitution_at(arriving)], given):
            raise ValueError(
                f"scene {scene.name}: law {law.name}: unknown symbol {symbol}; {_known(known)}"
            )


class _Refused(Exception):
    """The reason why a surface is refused."""


def _unknown(expressions: Sequence[sp.Basic], known: set[sp.Symbol]) -> list[str]:
    return sorted({str(s) for e in expressions for s in e.free_symbols - known})


def _known(known: set[sp.Symbol]) -> str:
    return f"expected of {', '.join(sorted(str(symbol) for symbol in known))}"


def _formulas(surface: Surface, known: set[sp.Symbol]) -> None:
    """Check the symbols, the exactness of numbers, and the degree of the polynomial."""
    condition, bounds = release(surface.condition), surface.bounds
    for symbol in _unknown([condition, surface.distance, *surface.normal], known):
        raise _Refused(f"unknown symbol {symbol}; {_known(known)}")
    for place, bound in enumerate(bounds):
        for symbol in _unknown([bound], known):
            raise _Refused(f"bound {place}: unknown symbol {symbol}; {_known(known)}")
    for number in condition.atoms(sp.Float).union(*(b.atoms(sp.Float) for b in bounds)):
        raise _Refused(f"{number} is not exact; expected whole numbers and fractions")
    if not surface.polynomial:
        return
    if not condition.is_polynomial(*POSITION):
        raise _Refused(f"expected a condition polynomial in x, y and z, got {condition}")
    degree = sp.Poly(condition, *POSITION).total_degree()
    if not 0 < degree <= MAX_DEGREE:
        raise _Refused(
            f"expected a condition of degree 1 to {MAX_DEGREE} in x, y and z, got one of {degree}"
        )


def _places(surface: Surface, scene: Scene) -> None:
    """Check normal, distance and bounds on random points."""
    finite = (p for p in scene.parameters if not p.infinite)  # a body is not infinite
    values = {p.symbol: sp.Rational(p.default) for p in finite}
    condition, distance = _function([surface.condition], values), surface.distance
    there = _function([distance, *surface.normal], values)
    bounds = [_function([bound], values) for bound in surface.bounds]
    # The author of a bound with a size has divided it by its gradient.
    undivided = [k for k, bound in enumerate(surface.bounds) if not bound.has(sp.Abs)]
    images = [_function([image], values) for image in surface.images]
    about = [
        mpmath.mpf(str(sp.N(c.xreplace(values), 20)))
        for c in map(sp.sympify, surface.reference_point)
    ]
    halves = (sp.sympify(h).xreplace(values) for h in surface.half_sizes if h is not None)
    reach = 2 * max((mpmath.mpf(str(sp.N(h, 20))) for h in halves), default=mpmath.mpf(1))
    chance = random.Random(surface.name)
    with mpmath.workdps(_DIGITS):
        for _ in range(_POINTS):
            start = [c + reach * mpmath.mpf(chance.uniform(-1, 1)) for c in about]
            for place in undivided:
                _check_bound(place, bounds[place], start)
            point = _touching(condition, start)
            if point is None or any(abs(bound(*point)[0]) < _NEAR for bound in bounds):
                # A torus that meets its axis is zero on its inner part, too; a bound ends there.
                continue
            if not any(image(*point)[0] > 0 for image in images):
                _check_contact(condition, there, point)


_OPERATIONS: dict[type[sp.Basic], Callable[..., Any]] = {
    sp.Add: lambda *terms: sum(terms),
    sp.Mul: lambda *factors: math.prod(factors),
    sp.Pow: mpmath.power,
    sp.Abs: abs,
    IfLess: lambda left, right, then, other: then if left < right else other,
    IfAtMost: lambda left, right, then, other: then if left <= right else other,
}
"""The functions of SymPy's classes and ours; others are those of mpmath with their name."""


def _function(expressions: Sequence[sp.Expr], values: dict[sp.Symbol, sp.Expr]) -> Function:
    """Return the function from x, y, z to the expressions' values at the parameters' values.

    What occurs several times is computed once: written out, a formula is exponentially larger than
    what its parts share.
    """
    places = {symbol: place for place, symbol in enumerate(POSITION)}
    start: list[Any] = [None] * len(places)
    steps: list[tuple[int, Callable[..., Any], list[int]]] = []

    def place_of(part: sp.Basic) -> int:
        if isinstance(part, Barrier):
            return place_of(part.args[0])
        if part not in places:
            number = None
            if not part.args or part.is_number:
                number = mpmath.mpf(sp.N(values.get(part, part), _DIGITS))
            else:
                operation = _OPERATIONS.get(type(part)) or getattr(mpmath, part.func.__name__)
                operands = [place_of(operand) for operand in part.args]
                steps.append((len(start), operation, operands))
            places[part] = len(start)
            start.append(number)
        return places[part]

    with mpmath.workdps(_DIGITS):
        results = [place_of(sp.sympify(expression)) for expression in expressions]

    def function(*position: Any) -> list[Any]:
        found = [*position, *start[len(position) :]]
        for place, operation, operands in steps:
            found[place] = operation(*(found[operand] for operand in operands))
        return [found[result] for result in results]

    return function


def _slopes(function: Function, point: Sequence[Any]) -> list[list[Any]]:
    """Return the derivative of each value along each axis."""
    step = mpmath.mpf(10) ** (-_DIGITS // 3)
    columns = []
    for axis in range(3):
        sides = []
        for way in (step, -step):
            moved = list(point)
            moved[axis] += way
            sides.append(function(*moved))
        columns.append([(a - b) / (2 * step) for a, b in zip(*sides, strict=True)])
    return [list(row) for row in zip(*columns, strict=True)]


def _norm(vector: Sequence[Any]) -> Any:
    return mpmath.sqrt(sum(component**2 for component in vector))


def _touching(condition: Function, start: Sequence[Any]) -> list[Any] | None:
    """Return a point where the condition is zero; None if Newton's method finds none."""
    point = list(start)
    steepest = mpmath.mpf(0)
    for _ in range(_STEPS):
        value, slope = condition(*point)[0], _slopes(condition, point)[0]
        steep = _norm(slope)
        steepest = max(steepest, steep)
        if not mpmath.isfinite(value) or steep == 0:
            return None
        away = value / steep
        if abs(away) < _NEAR**2 * (1 + _norm(point)):
            return point
        if abs(away) < _NEAR and steep < _NEAR / 100 * steepest:
            break
        point = [c - away * s / steep for c, s in zip(point, slope, strict=True)]
    # Steps that only halve the remaining distance approach a point where the gradient is zero.
    if abs(away) < mpmath.mpf(10) ** -6 and steep < mpmath.mpf(10) ** -6 * steepest:
        raise _Refused("the gradient of its condition is zero where the ball touches it")
    return None


def _check_contact(condition: Function, there: Function, point: Sequence[Any]) -> None:
    distance, *normal = there(*point)
    where = ", ".join(mpmath.nstr(c, 4) for c in point)
    if not abs(distance) < _NEAR * (1 + _norm(point)):
        raise _Refused(
            f"its distance is {mpmath.nstr(distance, 4)} at ({where}), where its condition is "
            "zero; expected zero"
        )
    slope = _slopes(there, point)[0]
    off = _norm([n - s for n, s in zip(normal, slope, strict=True)])
    if not (off < 1e-6 and abs(_norm(normal) - 1) < _NEAR):
        raise _Refused(
            f"its normal at ({where}) is ({', '.join(mpmath.nstr(n, 4) for n in normal)}); "
            "expected the gradient of its distance there, a unit vector: "
            f"({', '.join(mpmath.nstr(s, 4) for s in slope)})"
        )
    rising = sum(n * s for n, s in zip(normal, _slopes(condition, point)[0], strict=True))
    if not rising > 0:
        raise _Refused("its condition falls where its distance rises; expected one sign of both")


def _check_bound(place: int, bound: Function, point: Sequence[Any]) -> None:
    steep = _norm(_slopes(bound, point)[0])
    if steep > 1 + 1e-6:
        raise _Refused(
            f"bound {place}: expected a polynomial in x, y and z, or a length; it is no polynomial "
            f"and changes by {mpmath.nstr(steep, 4)} a metre"
        )
