"""Reading of a scene as its author wrote it: arguments become formulas, or are refused."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence, Sized
from dataclasses import dataclass
from itertools import islice
from typing import Any

from hoopgen.text.shorten import brief, join_names

from . import pieces
from .air import added_parameters, check_switches
from .bounds import LinearMap, Map, Terms, bounds, degrees, terms
from .boxes import read_box
from .contact_laws import Contact, contact, is_infinite
from .directions import Vector
from .errors import wrong
from .formulas import ONE, POSITION, ZERO, Formula, constant, name
from .gravity import MAX_INERTIA, MIN_INERTIA, check_rolling, read_gravity
from .inputs import Input, Inputs
from .limits import current
from .names import check_apart, check_faces, check_name, check_names
from .oblique_bodies import (
    ObliqueBody,
    read_cone,
    read_disc,
    read_inclined_plane,
    read_oblique_cylinder,
    read_plane_normal,
    read_span,
    read_torus,
)
from .parsed_shapes import RevolvedShape, Shape
from .revolution import read_revolution

SIGNS = ("positive", "nonnegative", "any")

AXES = {
    f"{sign}{axis}": (k, -1 if sign else 1) for sign in ("", "-") for k, axis in enumerate("xyz")
}
"""Number of the coordinate and sign of the direction, by the name of an axis."""


@dataclass(frozen=True)
class ParsedScene:
    """A scene whose arguments are formulas."""

    name: str
    inputs: tuple[Input, ...]
    ball_radius: Formula
    gravity: Formula
    inertia: Formula
    down: tuple[int, int] | Vector
    rolls: bool
    air: bool
    bodies: tuple[Shape, ...]
    ends: tuple[Shape, ...]


def read_scene(
    scene: str,
    *,
    parameters: Sequence[pieces.Parameter],
    bodies: Sequence[pieces.Body],
    ends: Mapping[str, pieces.End],
    ball_radius: pieces.Size,
    gravity: pieces.Size,
    inertia: pieces.Size,
    down: str | pieces.Direction,
    rolls: bool,
    air: bool,
    contacts: Mapping[str, pieces.Size | None],
    as_written: bool = False,
) -> ParsedScene:
    """Return a scene as formulas.

    Parameters
    ----------
    scene
        Its name.
    parameters, bodies, ends, ball_radius, gravity, inertia, down, rolls, air
        As its author gave them: of any type.
    contacts
        What contacts are like with bodies that do not say it themselves.
    as_written
        As for `Inputs`.

    Raises
    ------
    SceneError
        If something is wrong; names the body and the argument.
    """
    check_name(scene, "", scene)
    check_switches(scene, rolls, air)
    inputs = Inputs(scene, _parameters(scene, parameters, air), as_written)
    reader = _Reader(inputs)
    ball = reader.size("", "ball_radius", ball_radius, sign="positive")
    along = reader.axis("", "down", down) if isinstance(down, str) else None
    fall, way = read_gravity(inputs, gravity, down, along)
    turning = reader.size(
        "", "inertia", inertia, sign="positive", lower=MIN_INERTIA, upper=MAX_INERTIA, unit="1"
    )
    bodies = _check_list(scene, "bodies", bodies, pieces.Body)
    if not bodies:
        raise wrong(scene, "", "bodies", "expected at least one, got none")
    if not isinstance(ends, Mapping):
        raise wrong(scene, "", "ends", f"expected names and ends, got {brief(ends)}")
    finishes = _check_list(scene, "ends", list(ends.values()), pieces.End)
    _check_bounds(scene, (*bodies, *finishes))
    check_names(scene, "body", (body.name for body in bodies))
    check_names(scene, "end", ends)
    units = {parameter.name: parameter.unit for parameter in inputs.all if parameter.own}
    check_apart(scene, units, (body.name for body in bodies), ends)
    check_faces(scene, bodies)
    radius = reader.formula("", "ball_radius", ball_radius)
    shapes = tuple(_body(reader, body, radius, contacts) for body in bodies)
    if rolls:
        asked = ((one.name, one.kind, degrees(one.bounds)) for one in shapes)
        check_rolling(inputs, fall, asked)
    finished = tuple(_end(reader, own, end) for own, end in zip(ends, finishes, strict=True))
    return ParsedScene(scene, inputs.all, ball, fall, turning, way, rolls, air, shapes, finished)


def _check_list(scene: str, argument: str, given: Any, kind: type) -> list[Any]:
    if isinstance(given, str | Mapping) or not isinstance(given, Iterable):
        raise wrong(scene, "", argument, f"expected a list, got {brief(given)}")
    found = _check_count(scene, argument, given)
    for one in found:
        if not isinstance(one, kind) or type(one) is pieces.Body:
            *names, last = (one.__name__ for one in pieces.BODIES)
            expected = "End" if kind is pieces.End else f"{', '.join(names)} or {last}"
            raise wrong(scene, "", argument, f"expected {expected}, got {brief(one)}")
    return found


def _check_count(scene: str, argument: str, given: Iterable[Any]) -> list[Any]:
    """Return a list, checked against the limit of its name."""
    limits = current()
    found = list(islice(given, getattr(limits, argument) + 1))
    exact = isinstance(given, Sized)
    count = len(given) if isinstance(given, Sized) else len(found)
    if excess := limits.excess(argument, count, exact=exact):
        raise wrong(scene, "", argument, excess)
    return found


def _check_bounds(scene: str, pieces_within: Iterable[Any]) -> None:
    """Check the number of bounds before any is read; lists are checked later."""
    given = [one.within for one in pieces_within]
    lists = (within for within in given if isinstance(within, Sequence))
    if excess := current().excess("bounds", sum(len(w) for w in lists if not isinstance(w, str))):
        raise wrong(scene, "", "within", excess)


def _parameters(scene: str, given: Any, air: bool) -> tuple[Input, ...]:
    if isinstance(given, str | Mapping) or not isinstance(given, Iterable):
        raise wrong(scene, "", "parameters", f"expected a list, got {brief(given)}")
    inputs = []
    own = _check_count(scene, "parameters", given)
    for one in (*own, *(added_parameters(own) if air else ())):
        if not isinstance(one, pieces.Parameter):
            raise wrong(scene, "", "parameters", f"expected Parameter, got {brief(one)}")
        inputs.append(_parameter(scene, one))
    check_names(scene, "parameter", (made.name for made in inputs))
    return tuple(inputs)


def _parameter(scene: str, given: pieces.Parameter) -> Input:
    check_name(scene, "parameter", given.name)
    owner = f"parameter {given.name}"
    if given.sign not in SIGNS:
        raise wrong(scene, owner, "sign", f"expected {join_names(SIGNS)}; got {brief(given.sign)}")
    for argument in ("unit", "summary", "latex"):
        if not isinstance(getattr(given, argument), str):
            raise wrong(scene, owner, argument, "expected text")
    if not isinstance(given.infinite, bool):
        said = f"expected true or false, got {brief(given.infinite)}"
        raise wrong(scene, owner, "infinite", said)
    plain = Inputs(scene, ())
    default = math.inf
    if not (given.infinite and is_infinite(given.default)):
        default = plain.number(owner, "default", plain.read(owner, "default", given.default))
    upper = given.upper
    if upper is not None:
        upper = plain.number(owner, "upper", plain.read(owner, "upper", upper))
    made = Input(
        given.name,
        name(given.name),
        default,
        given.unit,
        given.summary,
        given.sign,
        upper,
        given.latex,
        infinite=given.infinite,
    )
    if not made.allows(default):
        raise wrong(scene, owner, "default", f"expected a number {made.allowed}, got {default:g}")
    return made


@dataclass(frozen=True)
class _Reader:
    """A reader of arguments as formulas."""

    inputs: Inputs

    def formula(self, owner: str, argument: str, given: object) -> Formula:
        """Return a size as a formula of the parameters."""
        return self.inputs.read(owner, argument, given)

    def size(self, owner: str, argument: str, given: object, **allowed: Any) -> Formula:
        """Return a size as an input."""
        return self.inputs.add(owner, argument, self.formula(owner, argument, given), **allowed)

    def point(self, owner: str, argument: str, given: object) -> dict[str, Formula]:
        """Return three sizes as formulas, by name."""
        if isinstance(given, str) or not isinstance(given, Sequence) or len(given) != 3:
            raise self.inputs.wrong(owner, argument, f"expected three sizes, got {brief(given)}")
        return {
            f"{argument} {axis}": self.formula(owner, f"{argument} {axis}", value)
            for axis, value in zip(POSITION, given, strict=True)
        }

    def add(self, owner: str, formulas: Mapping[str, Formula]) -> dict[str, Formula]:
        """Return formulas as inputs."""
        return {argument: self.inputs.add(owner, argument, f) for argument, f in formulas.items()}

    def axis(self, owner: str, argument: str, given: object) -> tuple[int, int]:
        """Return coordinate and direction."""
        if not isinstance(given, str) or given not in AXES:
            raise self.inputs.wrong(
                owner, argument, f"expected one of {join_names(AXES)}; got {brief(given)}"
            )
        return AXES[given]

    def flag(self, owner: str, argument: str, given: object) -> bool:
        """Return a truth value, checked."""
        if not isinstance(given, bool):
            raise self.inputs.wrong(owner, argument, f"expected true or false, got {brief(given)}")
        return given


def _body(
    reader: _Reader, body: pieces.Body, ball: Formula, contacts: Mapping[str, pieces.Size | None]
) -> Shape:
    owner, kind = f"body {body.name}", type(body).__name__.lower()
    law = contact(reader.inputs, owner, body, contacts)
    there: Map | LinearMap | None = None
    if isinstance(body, pieces.Plane):
        shape, there = _plane(reader, owner, body, ball)
    elif isinstance(body, pieces.Disc):
        shape, there = _oblique(body.name, read_disc(reader, owner, body, ball))
    elif isinstance(body, pieces.Cone):
        shape, there = _oblique(body.name, read_cone(reader, owner, body, ball))
    elif isinstance(body, pieces.Sphere | pieces.Cylinder):
        shape, there = _curved(reader, owner, body, ball)
    elif isinstance(body, pieces.Torus):
        turned, sizes, axis = read_torus(reader, owner, body, ball)
        shape = Shape(body.name, turned, sizes, axis)
    elif isinstance(body, pieces.Box):
        turned, sizes = read_box(reader, owner, body)
        shape = Shape(body.name, turned, sizes)
    elif isinstance(body, pieces.Revolution):
        return _revolution(reader, owner, body, ball, law)
    elif isinstance(body, pieces.Surface):
        shape, there = _surface(reader, owner, body, ball), Map()
    else:
        raise reader.inputs.wrong(owner, "", f"no such body: {type(body).__name__}")
    extra = shape.bounds + bounds(reader.inputs, owner, body.within, there)
    own = shape.kind or kind
    return Shape(body.name, own, shape.sizes, shape.axis, shape.inside, law, extra, shape.condition)


def _revolution(
    reader: _Reader, owner: str, body: pieces.Revolution, ball: Formula, law: Contact
) -> Shape:
    sizes, profile = read_revolution(reader, owner, body, ball)
    found = bounds(reader.inputs, owner, body.within)
    return RevolvedShape(body.name, "revolution", sizes, law=law, bounds=found, profile=profile)


def _oblique(own: str, found: ObliqueBody) -> tuple[Shape, Map | LinearMap | None]:
    return Shape(own, found.kind, found.sizes, inside=found.inside), found.there


def _plane(
    reader: _Reader, owner: str, body: pieces.Plane, ball: Formula
) -> tuple[Shape, Map | LinearMap | None]:
    along, vector, at = read_plane_normal(reader, owner, body)
    if along is None:
        return _oblique(body.name, read_inclined_plane(reader, owner, vector, at, ball))
    axis, way = along
    sizes = (("at", reader.inputs.add(owner, "at", at)),)
    shift = [constant(-way) * ball if k == axis else ZERO for k in range(3)]
    there = Map(shift=(shift[0], shift[1], shift[2]))
    return Shape(body.name, "plane", sizes, (axis, way)), there


def _curved(
    reader: _Reader, owner: str, body: pieces.Sphere | pieces.Cylinder, ball: Formula
) -> tuple[Shape, Map | LinearMap | None]:
    """Return a sphere or a cylinder: the point of contact lies towards its centre or axis."""
    if isinstance(body, pieces.Cylinder) and not isinstance(body.axis, str):
        return _oblique(body.name, read_oblique_cylinder(reader, owner, body, ball))
    radius = reader.formula(owner, "radius", body.radius)
    centre = reader.point(owner, "centre", body.centre)
    inside = reader.flag(owner, "inside", body.inside)
    sizes = {"radius": reader.inputs.add(owner, "radius", radius, sign="positive")}
    room = radius - ball if inside else radius + ball
    if inside:
        reader.inputs.check_above(owner, "radius", radius, ball, "the ball does not fit inside")
    factor, axis = radius / room, (2, 1)
    across: tuple[int, ...] = (0, 1, 2)
    extra: tuple[Terms, ...] = ()
    if isinstance(body, pieces.Cylinder):
        axis = reader.axis(owner, "axis", body.axis)
        across = tuple(k for k in range(3) if k != axis[0])
        extra = _span(reader, owner, body.span, axis[0])
    if body.within or extra:
        scale = [factor if k in across else ONE for k in range(3)]
        parts = list(centre.values())
        shift = [parts[k] - factor * parts[k] if k in across else ZERO for k in range(3)]
    else:
        scale, shift = [ONE] * 3, [ZERO] * 3
    if isinstance(body, pieces.Cylinder):
        centre = {a: f for k, (a, f) in enumerate(centre.items()) if k in across}
    sizes |= reader.add(owner, centre)
    made = Shape(body.name, "", tuple(sizes.items()), axis, inside, None, extra)
    return made, Map((scale[0], scale[1], scale[2]), (shift[0], shift[1], shift[2]))


def _span(reader: _Reader, owner: str, given: object, axis: int) -> tuple[Terms, ...]:
    found: list[Terms] = []
    for argument, formula in read_span(reader, owner, given).items():
        way = -1 if argument == "span from" else 1
        offset = reader.inputs.add(owner, argument, constant(-way) * formula)
        powers = tuple(int(k == axis) for k in range(3))
        found.append((((powers[0], powers[1], powers[2]), constant(way)), ((0, 0, 0), offset)))
    return tuple(found)


def _surface(reader: _Reader, owner: str, body: pieces.Surface, ball: Formula) -> Shape:
    named = {"ball_radius": ball}
    condition = terms(reader.inputs, owner, "condition", body.condition, also=named)
    return Shape(body.name, "", (), condition=condition)


def _end(reader: _Reader, own: str, end: pieces.End) -> Shape:
    owner = f"end {own}"
    axis = reader.axis(owner, "axis", end.axis)
    sizes = (("at", reader.size(owner, "at", end.at)),)
    found = bounds(reader.inputs, owner, end.within)
    return Shape(own, "end", sizes, axis, bounds=found)
