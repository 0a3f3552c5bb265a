"""Reading of bodies along any direction: inclined planes, discs, cylinders, cones, tori.

With the unit vector u of the direction and the ball's radius R, the sizes that they add are those
of the surface on which the ball's centre is at a contact (`derive/surfaces`).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from hoopgen.text.shorten import brief

from . import pieces
from .bounds import LinearMap, Map
from .directions import (
    Reader,
    Vector,
    aligned,
    angle,
    axis_or_direction,
    direction,
    dot,
    settled,
    vector_inputs,
)
from .formulas import ONE, ZERO, Formula, constant
from .polynomials import Polynomial


@dataclass(frozen=True)
class ObliqueBody:
    """A body along any direction.

    Attributes
    ----------
    kind
        The kind of its shape.
    sizes
        Inputs by argument; those of the direction are "direction x" and so on.
    inside
        Whether it is touched from inside.
    there
        From the ball's centre to the point of contact; None where it is not linear, and bounds are
        kept as those of that point.
    """

    kind: str
    sizes: tuple[tuple[str, Formula], ...]
    inside: bool = False
    there: Map | LinearMap | None = None


# Planes


def read_plane_normal(
    reader: Reader, owner: str, body: pieces.Plane
) -> tuple[tuple[int, int] | None, Vector, Formula]:
    """Return a plane's axis, None if it is oblique, its direction, and its offset along it.

    Parameters
    ----------
    reader, owner, body
        As for `read_disc`.

    Raises
    ------
    SceneError
        If both axis and normal are given, or both `at` and a point.
    """
    if body.axis is not None and body.normal is not None:
        raise reader.inputs.wrong(owner, "normal", "expected axis or normal, got both")
    if body.normal is None:
        given = "z" if body.axis is None else body.axis
        axis: tuple[int, int] | None = reader.axis(owner, "axis", given)
        vector = axis_or_direction(reader, owner, "axis", given)
    else:
        vector = direction(reader.inputs, owner, "normal", body.normal)
        axis = aligned(vector)
    if body.point is None:
        return axis, vector, reader.formula(owner, "at", 0.0 if body.at is None else body.at)
    if body.at is not None:
        raise reader.inputs.wrong(owner, "point", "expected at or point, got both")
    point = reader.point(owner, "point", body.point)
    return axis, vector, settled(dot(vector, tuple(point.values())))


def read_inclined_plane(
    reader: Reader, owner: str, vector: Vector, at: Formula, ball: Formula
) -> ObliqueBody:
    """Return a plane whose normal is along no axis.

    Parameters
    ----------
    reader, owner, ball
        As for `read_disc`.
    vector, at
        Its direction, and the plane's offset along it.
    """
    sizes = vector_inputs(reader.inputs, owner, "direction", vector, "1")
    sizes |= {"at": reader.inputs.add(owner, "at", at)}
    return ObliqueBody("inclined plane", tuple(sizes.items()), there=_beneath(vector, ball))


def _beneath(vector: Vector, ball: Formula) -> Map:
    x, y, z = (-(ball * part) for part in vector)
    return Map(shift=(x, y, z))


def read_disc(reader: Reader, owner: str, body: pieces.Disc, ball: Formula) -> ObliqueBody:
    """Return a disc: the plane through its centre, within its radius of it.

    Parameters
    ----------
    reader
        The reader of the scene's arguments.
    owner
        The body, for error messages.
    body
        The body as its author wrote it.
    ball
        The ball's radius.
    """
    vector = axis_or_direction(reader, owner, "axis", body.axis)
    centre = reader.point(owner, "centre", body.centre)
    sizes = vector_inputs(reader.inputs, owner, "direction", vector, "1")
    sizes |= {"radius": reader.size(owner, "radius", body.radius, sign="positive")}
    sizes |= reader.add(owner, centre)
    at = settled(dot(vector, tuple(centre.values())))
    sizes |= {"at": reader.inputs.add(owner, "at", at)}
    return ObliqueBody("disc", tuple(sizes.items()), there=_beneath(vector, ball))


# Cylinders


def read_oblique_cylinder(
    reader: Reader, owner: str, body: pieces.Cylinder, ball: Formula
) -> ObliqueBody:
    """Return a cylinder along any direction; its span begins at its centre.

    Parameters
    ----------
    reader, owner, body, ball
        As for `read_disc`.

    Raises
    ------
    SceneError
        If a size is not allowed.
    """
    inputs = reader.inputs
    vector = axis_or_direction(reader, owner, "axis", body.axis)
    radius = reader.formula(owner, "radius", body.radius)
    centre = reader.point(owner, "centre", body.centre)
    inside = reader.flag(owner, "inside", body.inside)
    sizes = {"radius": inputs.add(owner, "radius", radius, sign="positive")}
    room = radius - ball if inside else radius + ball
    if inside:
        inputs.check_above(owner, "radius", radius, ball, "the ball does not fit inside")
    sizes |= vector_inputs(inputs, owner, "direction", vector, "1")
    # Nearest to the origin, so that roundings are as small as the ball's place allows.
    way = dot(vector, tuple(centre.values()))
    near = [settled(own - way * part) for own, part in zip(centre.values(), vector, strict=True)]
    sizes |= vector_inputs(inputs, owner, "axis", near)
    span = read_span(reader, owner, body.span)
    if span:
        sizes |= reader.add(owner, centre)
    sizes |= {argument: inputs.add(owner, argument, end) for argument, end in span.items()}
    there = _towards_axis(vector, tuple(centre.values()), radius / room) if body.within else Map()
    return ObliqueBody("oblique cylinder", tuple(sizes.items()), inside, there)


def _towards_axis(vector: Vector, centre: Sequence[Formula], factor: Formula) -> LinearMap:
    """Return the map that brings the ball's centre nearer to an axis by a factor."""
    rest = ONE - factor
    rows: list[Polynomial] = []
    for k, own in enumerate(vector):
        slopes = [rest * own * other for other in vector]
        slopes[k] = slopes[k] + factor
        shift = centre[k] - dot(slopes, centre)
        row: Polynomial = {
            (int(j == 0), int(j == 1), int(j == 2)): slope
            for j, slope in enumerate(slopes)
            if slope != ZERO
        }
        if shift != ZERO:
            row[0, 0, 0] = shift
        rows.append(row)
    return LinearMap((rows[0], rows[1], rows[2]))


def read_span(reader: Reader, owner: str, given: object) -> dict[str, Formula]:
    """Return the ends of a span along an axis as formulas: "span from" and "span to".

    Parameters
    ----------
    reader, owner
        As for `read_disc`.
    given
        The two ends as the author wrote them.

    Raises
    ------
    SceneError
        If there are not two, or they are in the wrong order.
    """
    if isinstance(given, str) or not isinstance(given, Sequence) or len(given) != 2:
        raise reader.inputs.wrong(owner, "span", f"expected two ends, got {brief(given)}")
    found: dict[str, Formula] = {}
    ends: list[float] = []
    for argument, end in zip(("span from", "span to"), given, strict=True):
        if end is None:
            continue
        found[argument] = reader.formula(owner, argument, end)
        ends.append(reader.inputs.number(owner, argument, found[argument]))
    if ends != sorted(ends):
        said = f"expected the lower end first; it ends at {ends[1]:g} before {ends[0]:g}"
        raise reader.inputs.wrong(owner, "span", said)
    return found


# Cones


def read_cone(reader: Reader, owner: str, body: pieces.Cone, ball: Formula) -> ObliqueBody:
    """Return a cone; its span begins at its apex.

    Parameters
    ----------
    reader, owner, body, ball
        As for `read_disc`.

    Raises
    ------
    SceneError
        If a size is not allowed, or the ball does not reach the part of a cone that it is inside.
    """
    inputs = reader.inputs
    vector = axis_or_direction(reader, owner, "axis", body.axis)
    slope = _slope(reader, owner, body)
    named = inputs.add(owner, "slope", slope, sign="positive", unit="1")
    apex = reader.point(owner, "apex", body.apex)
    inside = reader.flag(owner, "inside", body.inside)
    span = read_span(reader, owner, body.span)
    start = span.pop("span from", ZERO)
    if (low := inputs.number(owner, "span from", start)) < 0:
        said = f"expected a number of at least 0, from the apex; got {low:g}"
        raise inputs.wrong(owner, "span from", said)
    per_cosine = settled((ONE + slope**2).sqrt())
    sine, to_apex = settled(ball * slope / per_cosine), settled(ball * per_cosine / slope)
    way = constant(1 if inside else -1)
    sizes = vector_inputs(inputs, owner, "direction", vector, "1")
    sizes |= {"slope": named}
    sizes |= reader.add(owner, apex)
    moved = [
        settled(place + way * part * to_apex)
        for place, part in zip(apex.values(), vector, strict=True)
    ]
    sizes |= vector_inputs(inputs, owner, "contact apex", moved)
    if start != ZERO:
        sizes["span from"] = inputs.add(owner, "span from", start)
    if start != ZERO or not inside:
        nearest = settled(start + way * sine)
        sizes["contact from"] = inputs.add(owner, "contact from", nearest)
    if "span to" in span:
        end = span["span to"]
        if (far := inputs.number(owner, "span to", end)) <= 0:
            said = f"expected a number above 0, from the apex; got {far:g}"
            raise inputs.wrong(owner, "span to", said)
        if inside:
            said = "the ball does not fit so far inside"
            inputs.check_above(owner, "span to", end, settled(to_apex - sine), said)
        sizes["span to"] = inputs.add(owner, "span to", end)
        high = settled(end + way * sine)
        sizes["contact to"] = inputs.add(owner, "contact to", high)
    return ObliqueBody("cone", tuple(sizes.items()), inside)


def read_torus(
    reader: Reader, owner: str, body: pieces.Torus, ball: Formula
) -> tuple[str, tuple[tuple[str, Formula], ...], tuple[int, int]]:
    """Return a torus: the kind of its shape, "" along an axis; its sizes; and that axis.

    Parameters
    ----------
    reader, owner, body, ball
        As for `read_disc`.

    Raises
    ------
    SceneError
        If a size is not allowed.
    """
    inputs = reader.inputs
    room = [
        reader.formula(owner, argument, getattr(body, argument)) for argument in ("radius", "wire")
    ]
    sizes = {
        "radius": reader.size(owner, "radius", body.radius, sign="positive"),
        "wire": reader.size(owner, "wire", body.wire, sign="nonnegative"),
    }
    said = "the ball does not fit through"
    inputs.check_above(owner, "radius", room[0], room[1] + ball, said)
    vector = axis_or_direction(reader, owner, "axis", body.axis)
    axis = aligned(vector)
    if axis is None:
        sizes |= vector_inputs(inputs, owner, "direction", vector, "1")
    sizes |= reader.add(owner, reader.point(owner, "centre", body.centre))
    return "" if axis else "oblique torus", tuple(sizes.items()), axis or (2, 1)


def _slope(reader: Reader, owner: str, body: pieces.Cone) -> Formula:
    """Return the tangent of the half-angle, of whichever of the two is given."""
    if (body.slope is None) == (body.half_angle is None):
        got = "neither" if body.slope is None else "both"
        raise reader.inputs.wrong(owner, "half_angle", f"expected half_angle or slope, got {got}")
    if body.half_angle is None:
        return reader.formula(owner, "slope", body.slope)
    half = angle(reader.inputs, owner, "half_angle", body.half_angle)
    # The nearest double to 90 degrees is below them, but its tangent is no slope.
    if not 0.0 < half < math.pi / 2.0 * (1.0 - 2.0**-50):
        said = f"expected an angle above 0deg and below 90deg, got {brief(body.half_angle)}"
        raise reader.inputs.wrong(owner, "half_angle", said)
    return constant(Fraction(f"{math.tan(half):.15g}"))


# Rolling


MAX_DEGREE = 2
"""Highest degree of a bound of a body over whose edge a ball rolls: `derive/rolling/bounds.py`."""

ROLLING_KINDS = {
    *("plane", "inclined plane", "disc", "sphere", "cylinder", "oblique cylinder"),
    *("cone", "torus", "oblique torus", "box", "oblique box"),
}
"""Kinds of shapes whose surfaces in `derive/surfaces` have a `rolling_surface`."""


def why_not_rolling(kind: str, degrees: Sequence[int]) -> tuple[str, str]:
    """Return the argument of a body on which no ball is known to roll, and why; "" if one is.

    Parameters
    ----------
    kind
        The kind of its shape.
    degrees
        The degree of each of its bounds.
    """
    if kind == "revolution":
        said = "on a revolution no ball is known to roll, since its pieces end at edges"
        return "", f"{said}; expected none where rolls is true"
    if kind == "surface":
        said = "no ball is known to roll beside a surface of your own, whose bends have no bound"
        return "", f"{said}; expected none where rolls is true"
    if kind not in ROLLING_KINDS:
        return "", f"on a {kind} no ball is known to roll; expected none where rolls is true"
    if degrees and kind.removeprefix("oblique ") == "torus":
        said = (
            "no ball is known to roll up to an edge of a torus, only of planes, discs, spheres, "
            "boxes, cylinders and cones"
        )
        return "within", f"{said}; expected none where rolls is true"
    for number, degree in enumerate(degrees, start=1):
        if degree > MAX_DEGREE:
            said = (
                f"no ball is known to roll up to an edge of degree {degree}; expected a degree "
                f"of at most {MAX_DEGREE} where rolls is true"
            )
            return f"within {number}", said
    return "", ""
