"""The formulas of a scene of derive/, compiled for ball arithmetic."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache

import sympy as sp

from hoopgen.derive.contact.no_slip import NoSlip
from hoopgen.derive.rolling.settling import small_hop
from hoopgen.derive.rolling.start import start_limits
from hoopgen.derive.scenes import HOOP
from hoopgen.derive.scenes.scene import Scene
from hoopgen.derive.scenes.validity import condition_scales, size_limits, without_assumptions
from hoopgen.derive.surfaces import Box, EndPlane, Plane, Ring, Surface
from hoopgen.derive.surfaces.plane import Flat
from hoopgen.derive.symbolic.conditionals import release
from hoopgen.derive.symbolic.symbols import (
    NORMAL,
    POSITION,
    SPIN,
    VELOCITY,
    normal,
    spin,
    t,
    velocity,
)

from .air import AirFormulas, air_formulas
from .box_parts import box_parts, box_solid, region
from .expressions import Function, compile_expressions

ARRIVAL = sp.Symbol("arrival_speed", positive=True)
"""Along the normal, towards the surface, m/s."""


@dataclass(frozen=True)
class SurfaceFormulas:
    """The formulas of one surface; each function takes (state, parameters).

    Attributes
    ----------
    name
        As in derive/.
    condition
        The polynomial that is zero at a contact and positive outside, as a list of one.
    region
        Of a part of a box, polynomials that are not positive where it is the nearest part; no other
        surface has any.
    patches
        The g of Eq. 2, by part: a contact counts where all of one part hold.
    normal
        n3 at the state's position.
    inside
        Expressions that are all negative exactly when the ball overlaps it.
    distance
        Signed distance, as a list of one.
    rate
        Its derivative by the time along a path, as a list of one; None but for rings and planes.
    face, body
        The surface of the scene that it is, or is a part of, and the body that it belongs to.
    bounded, flat
        Whether it has bounds, and whether it is a plane, along an axis or inclined.
    impact
        (state, parameters, normal) to velocity and spin, of which some are no number where balls do
        not decide what happens; None where a shot ends.
    restitution
        (parameters, (speed,)): of its law at a normal speed, as a list of one; None at the end.
    axis, offset
        Of a plane: the coordinate that its normal points along, and that coordinate at contact,
        as a list of one, from the parameters alone. For any other surface the axis is -1.
    ends
        Where a shot ends: in order, each end's name, the number of its outcome, its bounds, and
        whether it is for a ball alone that has fallen through the scene's passage.
    allows_rolling
        Whether a ball whose bounces accumulate there rolls on.
    """

    name: str
    condition: Function
    region: Function
    patches: tuple[Function, ...]
    normal: Function
    inside: Function
    distance: Function
    rate: Function | None
    face: int
    body: int
    bounded: bool
    flat: bool
    axis: int
    offset: Function
    impact: Function | None
    restitution: Function | None
    ends: tuple[tuple[str, int, Function, bool], ...]
    allows_rolling: bool


@dataclass(frozen=True)
class Formulas:
    """The formulas of a scene.

    Attributes
    ----------
    surfaces
        What can be touched, of a box each face, edge and corner; then the planes that end a shot.
    solids
        (state, parameters), by surface of the scene: all negative exactly where the ball overlaps
        the body.
    faces, bodies
        How many of the surfaces can be touched, and how many bodies there are.
    open_ended
        True if the time limit ends every shot, also one that meets nothing any more.
    without_slip
        True if no ball slips at a contact, so that its motion after it is a polynomial in the
        motion before it and the normal.
    outcomes
        The number of each outcome by name.
    order
        In which they are searched, by body: planes first, whose arrivals then limit the others'
        search, and bodies of many parts last.
    flight
        (state, parameters, (time,)) to position and velocity, on a parabola; None through air.
    air
        The formulas of a flight through air; None without it.
    hop
        (state, parameters, normal): of a ball that leaves a surface, two numbers of which the first
        is less where the hop is too small to be told from rolling; None where no ball rolls.
    start
        (state, parameters): the speed and the force per unit mass along the normal below which
        those of a ball that starts on a surface are roundings; None where no ball rolls.
    passage
        (parameters,) to radius and depth of the scene's passage and gravity; None without one.
    requirements
        (parameters,): each must be positive.
    ball_radius
        The number of the parameter that is the radius of the ball.
    names, signs, lowers, uppers, sizes
        Of the parameters, in order: name, allowed sign, smallest and largest value or None, and
        least and largest size.
    scales
        (parameters,) to the largest coefficient of each polynomial of the scene's own.
    """

    surfaces: tuple[SurfaceFormulas, ...]
    solids: tuple[Function, ...]
    faces: int
    bodies: int
    open_ended: bool
    without_slip: bool
    outcomes: dict[str, int]
    order: tuple[tuple[int, ...], ...]
    flight: Function | None
    air: AirFormulas | None
    hop: Function | None
    start: Function | None
    passage: Function | None
    requirements: Function
    ball_radius: int
    names: tuple[str, ...]
    signs: tuple[str, ...]
    lowers: tuple[float | None, ...]
    uppers: tuple[float | None, ...]
    sizes: tuple[tuple[float, float], ...]
    scales: Function


def _surface(
    surface: Surface, face: int, body: int, is_part: bool, scene: Scene
) -> SurfaceFormulas:
    place, motion = (*POSITION, *VELOCITY), scene.symbols
    axis, offset = -1, sp.Integer(0)
    if isinstance(surface, Plane):
        axis = next(k for k, component in enumerate(surface.direction) if component)
        offset = surface.offset * surface.direction[axis]  # its square is 1

    impact = restitution = None
    if body < len(scene.bodies):
        law = scene.bodies[body].law
        after = law.after(normal, velocity, spin, scene.ball)
        state = (*POSITION, *VELOCITY, *SPIN)
        impact = compile_expressions([e for vector in after for e in vector], state, motion, NORMAL)
        restitution = compile_expressions([law.restitution_at(ARRIVAL)], motion, (ARRIVAL,))

    ends: list[tuple[str, int, Function, bool]] = []
    if isinstance(surface, EndPlane):
        for outcome, part in zip(surface.outcomes, surface.parts, strict=True):
            end = scene.ends[outcome]
            ends.append((end.name, outcome, compile_expressions(part, place, motion), end.passed))

    def by_state(expressions: Sequence[sp.Expr]) -> Function:
        return compile_expressions(expressions, place, motion)

    return SurfaceFormulas(
        surface.name,
        by_state([surface.condition]),
        by_state(region(surface) if is_part else ()),
        tuple(by_state(patch) for patch in surface.patches),
        by_state(list(surface.normal)),
        by_state(surface.inside),
        by_state([surface.distance]),
        by_state([_rate(surface.distance)]) if isinstance(surface, Plane | Ring) else None,
        face,
        body,
        bool(surface.bounds),
        isinstance(surface, Flat),
        axis,
        compile_expressions([offset], motion),
        impact,
        restitution,
        tuple(ends),
        face < len(scene.surfaces) and scene.allows_rolling(scene.surfaces[face]),
    )


def _rate(distance: sp.Expr) -> sp.Expr:
    """Return the derivative of a function of the place by the time."""
    place = zip(POSITION, VELOCITY, strict=True)
    return sp.Add(*(sp.diff(release(distance), at) * speed for at, speed in place))


def _parabola(scene: Scene) -> Function | None:
    if not scene.flight.exact:
        return None
    there = [component for vector in scene.flight.at() for component in vector]
    return compile_expressions(there, (*POSITION, *VELOCITY, *SPIN), scene.symbols, (t,))


def _hop(scene: Scene) -> Function | None:
    if not scene.rolls:
        return None
    sides = small_hop(scene.flight.strength, scene.ball_radius)
    return compile_expressions(sides, (*POSITION, *VELOCITY, *SPIN), scene.symbols, NORMAL)


def _start(scene: Scene) -> Function | None:
    if not scene.rolls:
        return None
    limits = start_limits(scene.flight.strength, scene.ball_radius)
    return compile_expressions(limits, (*POSITION, *VELOCITY, *SPIN), scene.symbols)


def _order(surfaces: Sequence[SurfaceFormulas]) -> tuple[tuple[int, ...], ...]:
    bodies: dict[int, list[int]] = {}
    for k in sorted(range(len(surfaces)), key=lambda k: surfaces[k].axis < 0):
        bodies.setdefault(surfaces[k].face, []).append(k)
    return tuple(sorted(map(tuple, bodies.values()), key=lambda parts: len(parts) > 1))


@cache
def formulas(scene: Scene = HOOP) -> Formulas:
    """Return the scene's formulas, compiled once."""
    parameters = scene.symbols
    faces = zip(scene.surfaces, scene.faces, strict=True)
    touched = [
        (part, face, body, isinstance(surface, Box))
        for face, (surface, body) in enumerate(faces)
        for part in box_parts(surface)
    ]
    gates = [
        (end_plane, len(scene.surfaces) + k, len(scene.bodies), False)
        for k, end_plane in enumerate(scene.end_planes)
    ]
    surfaces = tuple(_surface(*place, scene) for place in (*touched, *gates))
    passage = scene.passage
    return Formulas(
        surfaces,
        tuple(
            compile_expressions(
                box_solid(s) if isinstance(s, Box) else s.inside,
                (*POSITION, *VELOCITY),
                parameters,
            )
            for s in scene.surfaces
        ),
        len(touched),
        len(scene.bodies),
        scene.open_ended,
        all(isinstance(body.law, NoSlip) for body in scene.bodies),
        scene.outcomes,
        _order(surfaces),
        _parabola(scene),
        None if scene.air is None else air_formulas(scene),
        _hop(scene),
        _start(scene),
        None
        if passage is None
        else compile_expressions([*passage.sizes, scene.gravity], parameters),
        compile_expressions(scene.requirements, parameters),
        parameters.index(scene.ball_radius),
        tuple(p.name for p in scene.parameters),
        tuple(p.sign for p in scene.parameters),
        tuple(p.lower for p in scene.parameters),
        tuple(p.upper for p in scene.parameters),
        tuple(
            (float(least), float(most))
            for least, most in (size_limits(scene, p) for p in scene.parameters)
        ),
        compile_expressions(
            condition_scales(scene), [without_assumptions(symbol) for symbol in parameters]
        ),
    )
