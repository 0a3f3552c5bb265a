"""The validity of a shot: its parameters, and the place where the ball starts."""

from __future__ import annotations

from collections.abc import Sequence, Set

import sympy as sp

from ..motion.flight import Acceleration
from ..surfaces import ImplicitSurface, Surface
from ..symbolic.conditionals import (
    AtMost,
    IfAtMost,
    IfLess,
    Less,
    Not,
    absolute,
    all_of,
    any_of,
    barrier,
    maximum,
    minimum,
    release,
)
from ..symbolic.number_range import MAX_COEFFICIENT, MAX_SIZE, MIN_SIZE
from ..symbolic.symbols import POSITION, UNIT_ROUNDOFF
from .scene import Parameter, Scene

last = sp.Symbol("last", real=True)
"""Index of the surface that the ball touched last, -1 for none; at first, that of its body."""

left_middle, left_reach = sp.symbols("left_middle left_reach", real=True)
"""The middle of the indices of the surfaces of the body that the ball leaves, and half their
number."""

permission = sp.Symbol("allowed", real=True)
"""Positive if the parameters are allowed."""


index, valid_so_far, undecided_so_far = sp.symbols("index valid undecided_time", real=True)
blur, leeway = sp.symbols("blur leeway", real=True)
"""Bound on the rounding of a length, and the distance from a box of surfaces within which it
matters."""

measured, lengths = sp.symbols("measured lengths", nonnegative=True)
"""The sum of the sizes of a scene's lengths, and its copy in a shot."""

_UNITS = ("m", "m/s", "m/s²")
"""Units of parameters that are added to coordinates, speeds and accelerations."""

CERTAIN_DISTANCE_FACTOR = 8
"""A ball so many times further from the box of a surface than the rounding is certainly not
inside the surface: except for roundings, `inside` is no less than the distance from the box."""

MAX_PUT_ON = sp.Rational(1, 2**9)
"""Largest distance by which a ball is put onto a surface that it starts on, by its radius: twice
the distance at which it still touches the body. Behind a shell it is further off."""


def without_assumptions(expression: sp.Basic) -> sp.Basic:
    """Return the expression in symbols without assumptions on their sign."""
    return expression.xreplace({s: s.func(s.name, real=True) for s in expression.free_symbols})


def valid(scene: Scene, tabled: Set[int]) -> dict[str, sp.Expr]:
    """Return whether a ball can start at a finite position, and whether that is undecided.

    A ball is inside a surface if the largest of the surface's `inside` is negative; it is undecided
    if that is within the rounding of its evaluation. From the surface that the ball leaves it must
    have no more distance than that, and be within the bounds: then the ball is on it, as after a
    contact. Further off, and behind it, an arrival there depends on whether the ball or the surface
    is taken to be where it is, and the shot is undecided. Where a ball rolls it is put onto the
    surface (`rolling/start.py`); behind one with bounds, which it may touch, it is undecided.

    **Lemma (start).** Let s be 16 u times the sum S of the sizes of coordinates and lengths. In
    `HOOP` and `COURT`, an `inside` that is larger than s in size, for the ring 4 R s, has the right
    sign.

    *Proof.* Of a plane each is a sum of at most four numbers, or R_H - rho with rho off by 2 u rho:
    off by at most 4 u S, and so is the largest of them. Of a box the coordinates beyond its faces
    are differences of a place and a face, itself a sum of two numbers: together off by at most 3 u
    S, and their length by 8 u S with the roundings of squares, sums, root and difference. Of the
    ring it is d² + z² - R², which is off by u (4 rho |d| + 3 d² + 2 z² + 3 R²) and the rounding of
    the result (`ring/double.py`). If the computed and the exact one had different signs, one of
    them would have |d| and |z| at most R (1 + 2^-20), and it would be off by less than u R (4 rho +
    9 R) < 64 u R S. ∎

    The surfaces with the indices `tabled`, which the loop goes over (`surface_start`), are left
    out, too. For them the outputs contain the rounding, and the distance within which it matters.

    Parameters
    ----------
    scene
        The scene, with its surfaces in order.
    tabled
        Indices of surfaces.

    Returns
    -------
    dict
        `valid` and `undecided_time`, each 1 or 0; for tabled surfaces the two lengths, too, m.
    """
    slack = _slack([measured] if tabled else _sizes(scene))
    verdict: sp.Expr = sp.Integer(1)
    undecided: sp.Expr = sp.Integer(0)
    for index, surface in enumerate(scene.surfaces):
        if index not in tabled:
            so_far = (verdict, undecided)
            verdict, undecided = _with_surface(scene, surface, index, *so_far, slack)
    found = {"valid": verdict, "undecided_time": undecided}
    return found | ({"blur": slack, "leeway": CERTAIN_DISTANCE_FACTOR * slack} if tabled else {})


def left_surface(scene: Scene) -> dict[str, sp.Expr]:
    """Return the surface that the ball leaves, where callers name the body and some have several.

    Of the surfaces of the body it is the one that the ball neither overlaps nor is away from: whose
    largest `inside` is nearest to zero. Both sides of a thin wall have the same `inside`; of these
    it is the one whose condition is nearest to zero. The ball is on that one, and inside none of
    the others: the walls of a thin body, and an edge where they end, are touched together.

    Parameters
    ----------
    scene
        The scene, with its surfaces in order.

    Returns
    -------
    dict
        `last`, `left_middle` and `left_reach`; nothing if each body is one surface.
    """
    if not _have_several_surfaces(scene):
        return {}
    faces: list[list[int]] = [[] for _ in scene.bodies]
    for face, body in enumerate(scene.faces):
        faces[body].append(face)
    surface: sp.Expr = last
    middle: sp.Expr = last
    reach: sp.Expr = sp.Rational(1, 2)
    offset = 0
    for body, own in enumerate(faces):
        if own[0] - body != offset:  # the body before has several
            offset = own[0] - body
            surface = IfLess(last, body, surface, last + offset)
            middle = IfLess(last, body, middle, last + offset)
            reach = IfLess(last, body, reach, sp.Rational(1, 2))
        if len(own) > 1:
            surface = IfLess(last, body, surface, _nearest(scene, own))
            middle = IfLess(last, body, middle, sp.Rational(own[0] + own[-1], 2))
            reach = IfLess(last, body, reach, sp.Rational(len(own), 2))
    return {"last": surface, "left_middle": middle, "left_reach": reach}


def _have_several_surfaces(scene: Scene) -> bool:
    return len(scene.faces) > len(scene.bodies)


def _nearest(scene: Scene, faces: Sequence[int]) -> sp.Expr:
    nearest: sp.Expr = sp.Integer(faces[0])
    least: sp.Expr = sp.oo
    for face in faces:
        shape = scene.surfaces[face]
        inside = map(without_assumptions, shape.inside)
        away = barrier(absolute(barrier(maximum(*inside))))
        if shape.polynomial:
            gap = barrier(without_assumptions(sp.sympify(shape.condition)))
            away = barrier(away + absolute(gap))
        if face == faces[0]:
            least = away
            continue
        nearest, least = IfLess(away, least, face, nearest), barrier(minimum(away, least))
    return nearest


def scene_size(scene: Scene) -> dict[str, sp.Expr]:
    """Return the sum of the sizes of a scene's lengths: one for all shots that share them."""
    return {measured.name: barrier(sum(_sizes(scene)))}


def _sizes(scene: Scene) -> list[sp.Expr]:
    return [sp.Abs(without_assumptions(length)) for length in scene.lengths]


def _slack(lengths: Sequence[sp.Expr]) -> sp.Expr:
    return barrier(16 * UNIT_ROUNDOFF * barrier(sum(map(sp.Abs, POSITION)) + sum(lengths)))


def near_surface(scene: Scene) -> dict[str, sp.Basic]:
    """Return whether a ball starts so near to a surface along an axis that `valid` is evaluated.

    Otherwise the outputs are those of `valid`: the distances have at most four roundings of S, and
    are compared with eight times s. Without an axis along which all surfaces are bounded
    there is no such test.
    """
    room = barrier(CERTAIN_DISTANCE_FACTOR * _slack(_sizes(scene)))
    for axis in range(3):
        found = [
            [barrier(without_assumptions(d)) for d in surface.aside(axis)]
            for surface in scene.surfaces
        ]
        if found and all(found):
            apart = (any_of(*(Less(room, distance) for distance in own)) for own in found)
            known = {"valid": sp.Integer(1), "undecided_time": sp.Integer(0)}
            return {"close": Not(all_of(*apart)), **known}
    return {}


def surface_start(surface: Surface, scene: Scene) -> dict[str, sp.Expr]:
    """Return the validity of the start with one surface more, the one that the loop is at.

    Parameters
    ----------
    surface
        The surface.
    scene
        Its scene.

    Returns
    -------
    dict
        As `valid`.
    """
    so_far = (valid_so_far, undecided_so_far)
    verdict, undecided = _with_surface(scene, surface, index, *so_far, blur)
    return {"valid": verdict, "undecided_time": undecided}


def _with_surface(
    scene: Scene,
    surface: Surface,
    index: sp.Expr | int,
    verdict: sp.Expr,
    undecided: sp.Expr,
    slack: sp.Expr,
) -> tuple[sp.Expr, sp.Expr]:
    several = _have_several_surfaces(scene)
    is_put_on = scene.allows_rolling(surface)
    overlap = barrier(maximum(*map(without_assumptions, surface.inside)))
    left = barrier(absolute((left_middle if several else last) - index))
    own = left_reach if several else sp.Rational(1, 2)
    rounding = barrier(without_assumptions(surface.steepness)) * slack
    near = IfAtMost(absolute(overlap), rounding, 1, undecided)
    distance = barrier(absolute(barrier(without_assumptions(surface.distance))))
    off = undecided
    if not is_put_on:
        off = IfAtMost(distance, slack, IfAtMost(overlap, rounding, undecided, 1), 1)
    elif surface.bounds:  # the ball may touch it from behind
        far = barrier(MAX_PUT_ON * without_assumptions(scene.ball_radius))
        off = IfAtMost(distance, far, undecided, 1)
    if several:  # the ball is on one surface of the body
        off = IfLess(absolute(last - index), sp.Rational(1, 2), off, undecided)
    return (
        IfLess(left, own, verdict, IfAtMost(0, overlap, verdict, 0)),
        IfLess(left, own, off, near),
    )


def allowed(scene: Scene) -> dict[str, sp.Expr]:
    """Return 1 if the parameters are allowed; each condition falls through to the rest or 0."""
    verdict: sp.Expr = sp.Integer(1)
    for requirement in scene.requirements:
        verdict = IfLess(0, without_assumptions(requirement), verdict, 0)
    for parameter in scene.parameters:
        value = without_assumptions(parameter.symbol)
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
    """Return the smallest and the largest size of a parameter (`symbolic/number_range.py`).

    Parameters
    ----------
    scene
        The scene, whose radius of the ball and gravity cannot be arbitrarily small.
    parameter
        One of its parameters.

    Returns
    -------
    tuple
        Both in the parameter's unit; a value of 0 is allowed if the sign allows it.
    """
    falls = parameter.symbol == scene.gravity and scene.flight.falls
    scales = falls or parameter.symbol == scene.ball_radius
    if parameter.infinite:
        return sp.Integer(0), sp.oo
    largest_size = MAX_SIZE if parameter.unit in _UNITS else MAX_COEFFICIENT
    return MIN_SIZE if scales else sp.Integer(0), largest_size


def parameters_in_range(scene: Scene) -> dict[str, sp.Expr]:
    """Return whether all parameters are allowed, and cause neither over- nor underflow.

    A NaN fails every comparison.
    """
    conditions: list[sp.Basic] = []
    for parameter in scene.parameters:
        least, most = size_limits(scene, parameter)
        conditions.append(AtMost(absolute(without_assumptions(parameter.symbol)), most))
        if least != 0:
            conditions.append(AtMost(least, absolute(without_assumptions(parameter.symbol))))
    conditions += (AtMost(1 / MAX_COEFFICIENT, scale) for scale in condition_scales(scene))
    return {"permitted": all_of(Less(0, permission), *conditions)}


def gravity_excess(acceleration: Acceleration) -> sp.Expr:
    """Return g² - 1/S², m²/s⁴, for gravity in any direction: positive where a ball may roll.

    Parameters
    ----------
    acceleration
        That of free fall, m/s².
    """
    return sp.Add(*(component**2 for component in acceleration)) - MIN_SIZE**2


def condition_scales(scene: Scene) -> list[sp.Expr]:
    """Return the size of the largest coefficient of each implicit surface."""
    found = []
    for surface in scene.surfaces:
        if isinstance(surface, ImplicitSurface):
            terms = sp.Poly(release(surface.formula), *POSITION).terms()
            factors = [without_assumptions(factor) for powers, factor in terms if any(powers)]
            if not any(factor.is_Rational for factor in factors):  # which is some whole number
                found.append(maximum(*map(absolute, factors)))
    return found
