"""Reading of surfaces of revolution: a profile is expanded into the faces that it sweeps.

With the distance rho of the ball's centre from the axis and its height h along it, a straight piece
from (r₁, h₁) to (r₂, h₂) sweeps the side of a cone or of a cylinder, or a flat ring. It runs along
the unit vector (c, s), and the ball touches it where

    0 <= (rho - r₁) c + (h - h₁) s   and   (rho - r₂) c + (h - h₂) s <= 0.

A point of the profile sweeps an edge, which the ball touches where, of each piece that ends there,
it is beyond that end. Both ask the same formula for the sign, so that no gap is between them.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import hypot

from hoopgen.text.shorten import brief

from . import pieces
from .directions import Reader, Vector, axis_or_direction, dot, settled, vector_inputs
from .formulas import ONE, ZERO, Formula, constant
from .limits import current

__all__ = ["Line", "Profile", "Vertex", "read_revolution"]

Sizes = tuple[tuple[str, Formula], ...]

LEAST_SLOPE = 1e-6
"""Least change of the radius by that of the height, or the inverse, of a piece that is a cone: the
apex of a steeper one is so far away that most digits of its place are lost."""

_OPPOSITE = -1.0 + 1e-9
"""Cosine of the angle at which a profile turns back onto itself."""


@dataclass(frozen=True)
class Vertex:
    """A point of a profile.

    Attributes
    ----------
    radius, height
        Its place: inputs.
    place
        The point of the axis at its height: inputs.
    narrow
        Whether the ball does not fit through its circle at the defaults.
    """

    radius: Formula
    height: Formula
    place: Vector
    narrow: bool


@dataclass(frozen=True)
class Line:
    """A straight piece of a profile.

    Attributes
    ----------
    start, end
        The numbers of its points.
    kind
        "cone", "cylinder" or "disc".
    along
        Its unit vector (c, s): inputs.
    signs
        The signs of c and s at the defaults, 0 where one is 0 itself.
    sizes
        What its faces need: inputs by argument.
    inner
        Whether the ball fits inside of it, at the defaults, so far that it touches it there.
    """

    start: int
    end: int
    kind: str
    along: tuple[Formula, Formula]
    signs: tuple[int, int]
    sizes: Sizes
    inner: bool


@dataclass(frozen=True)
class Profile:
    """The line that is turned about the axis.

    Attributes
    ----------
    vertices, lines
        Its points and pieces in order; a line that ends where it begins names that point once.
    fixed
        Whether all of it is numbers, so that nothing changes from shot to shot.
    """

    vertices: tuple[Vertex, ...]
    lines: tuple[Line, ...]
    fixed: bool


@dataclass(frozen=True)
class _Point:
    """A point of a profile as it is read: formulas, and their values at the defaults."""

    formulas: tuple[Formula, Formula]
    values: tuple[float, float]


def read_revolution(
    reader: Reader, owner: str, body: pieces.Revolution, ball: Formula
) -> tuple[Sizes, Profile]:
    """Return the sizes of a surface of revolution, and its profile.

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

    Raises
    ------
    SceneError
        If the profile is not a list of points, crosses the axis or itself, or has a piece that is
        nearly a cylinder or nearly flat.
    """
    inputs = reader.inputs
    points = _points(reader, owner, body.profile)
    closed = len(points) > 2 and points[0].formulas == points[-1].formulas
    ends = _pairs(len(points), closed)
    if closed:
        points = points[:-1]
    _check_axis(reader, owner, points, closed)
    _check_crossings(reader, owner, points, ends)
    vector = axis_or_direction(reader, owner, "axis", body.axis)
    centre = tuple(reader.point(owner, "centre", body.centre).values())
    sizes = vector_inputs(inputs, owner, "direction", vector, "1")
    sizes |= vector_inputs(inputs, owner, "centre", centre)
    radius = inputs.number(owner, "", ball)
    placed = _Placed(reader, owner, vector, centre, ball, radius)
    lines = [placed.line(k, points, *pair) for k, pair in enumerate(ends, start=1)]
    used = [formula for point in points for formula in point.formulas]
    profile = Profile(
        tuple(placed.vertex(k, point) for k, point in enumerate(points, start=1)),
        tuple(lines),
        fixed=not any(formula.names for formula in (*used, ball)),
    )
    return tuple(sizes.items()), profile


# The line


def _points(reader: Reader, owner: str, given: object) -> list[_Point]:
    """Return the points of a profile."""
    inputs = reader.inputs
    if isinstance(given, str) or not isinstance(given, Sequence):
        raise inputs.wrong(owner, "profile", f"expected a list of points, got {brief(given)}")
    if excess := current().excess("profile_points", len(given)):
        raise inputs.wrong(owner, "profile", excess)
    if len(given) < 2:
        raise inputs.wrong(owner, "profile", f"expected at least two points, got {len(given)}")
    found = []
    for number, point in enumerate(given, start=1):
        own = f"profile point {number}"
        if isinstance(point, str) or not isinstance(point, Sequence) or len(point) != 2:
            said = f"expected two sizes, radius and height; got {brief(point)}"
            raise inputs.wrong(owner, own, said)
        named = [f"{own} {what}" for what in ("radius", "height")]
        read = [reader.formula(owner, a, size) for a, size in zip(named, point, strict=True)]
        values = [inputs.number(owner, a, size) for a, size in zip(named, read, strict=True)]
        if values[0] < 0:
            said = f"expected a number of at least 0, got {values[0]:g}"
            raise inputs.wrong(owner, named[0], said)
        if values[0] == 0 and read[0] != ZERO:
            said = "it is 0 at the defaults; expected the number 0, or a number above 0"
            raise inputs.wrong(owner, named[0], said)
        found.append(_Point((read[0], read[1]), (values[0], values[1])))
    return found


def _pairs(count: int, closed: bool) -> list[tuple[int, int]]:
    """Return the numbers of the ends of each piece, of so many points as they are written."""
    last = count - 1
    return [(k, 0 if closed and k + 1 == last else k + 1) for k in range(last)]


def _check_axis(reader: Reader, owner: str, points: Sequence[_Point], closed: bool) -> None:
    """Raise if a point lies on the axis that may not."""
    last = len(points)
    for number, point in enumerate(points, start=1):
        if point.formulas[0] != ZERO:
            continue
        said = ""
        if closed:
            said = "it lies on the axis; no point of a closed profile may"
        elif number not in (1, last):
            said = "it lies on the axis; only the first and the last point may"
        elif last == 2 and all(one.formulas[0] == ZERO for one in points):
            said = "it lies on the axis, as the other point does"
        if said:
            raise reader.inputs.wrong(owner, f"profile point {number}", said)


def _check_crossings(
    reader: Reader, owner: str, points: Sequence[_Point], ends: Sequence[tuple[int, int]]
) -> None:
    """Raise if two pieces meet anywhere but at the point that they share, or a piece is none."""
    places = [point.values for point in points]
    segments = [(places[a], places[b]) for a, b in ends]
    for number, (start, end) in enumerate(segments, start=1):
        if start == end:
            said = f"it is point {number} again; expected another one"
            raise reader.inputs.wrong(owner, f"profile point {number + 1}", said)
    count = len(segments)
    for number, piece in enumerate(segments):
        for later in range(number + 1, count):
            shared = len({*ends[number]} & {*ends[later]})
            if shared == 1 and later in (number + 1, count - 1):
                back = _cosine(piece, segments[later], later == number + 1)
                if back > _OPPOSITE:
                    continue
                said = f"piece {later + 1} turns back onto piece {number + 1}"
                raise reader.inputs.wrong(owner, "profile", said)
            if _meet(piece, segments[later]):
                said = f"piece {number + 1} and piece {later + 1} meet; expected a simple line"
                raise reader.inputs.wrong(owner, "profile", said)


Place = tuple[float, float]
Segment = tuple[Place, Place]


def _cosine(first: Segment, second: Segment, follows: bool) -> float:
    """Return the cosine of the angle between two pieces that share a point, one after the other."""
    if not follows:
        first, second = second, first
    (a, b), (c, d) = ([q - p for p, q in zip(*piece, strict=True)] for piece in (first, second))
    return (a * c + b * d) / (hypot(a, b) * hypot(c, d))


def _side(piece: Segment, point: Place) -> float:
    (a, b), (c, d) = piece
    return (c - a) * (point[1] - b) - (d - b) * (point[0] - a)


def _meet(first: Segment, second: Segment) -> bool:
    """Return whether two pieces have a point in common."""

    def between(piece: Segment, point: Place) -> bool:
        low, high = ([f(p, q) for p, q in zip(*piece, strict=True)] for f in (min, max))
        return all(a <= p <= b for a, p, b in zip(low, point, high, strict=True))

    sides = [_side(first, p) for p in second], [_side(second, p) for p in first]
    if all(a * b < 0 for a, b in sides):
        return True
    pairs = [(first, p) for p in second], [(second, p) for p in first]
    return any(
        side == 0 and between(piece, point)
        for found, points in zip(sides, pairs, strict=True)
        for side, (piece, point) in zip(found, points, strict=True)
    )


# Its faces


@dataclass(frozen=True)
class _Placed:
    """The axis of a profile, and the ball that touches it."""

    reader: Reader
    owner: str
    vector: Vector
    centre: Sequence[Formula]
    ball: Formula
    ball_radius: float

    def _axis_point(self, argument: str, height: Formula) -> dict[str, Formula]:
        """Return the point of the axis at a height as inputs."""
        there = [
            settled(own + height * part) for own, part in zip(self.centre, self.vector, strict=True)
        ]
        return vector_inputs(self.reader.inputs, self.owner, argument, there)

    def vertex(self, number: int, point: _Point) -> Vertex:
        """Return a point of the profile, as inputs."""
        inputs, own = self.reader.inputs, f"point {number}"
        radius, height = point.formulas
        x, y, z = self._axis_point(own, height).values()
        sign = "nonnegative" if radius == ZERO else "positive"
        return Vertex(
            inputs.add(self.owner, f"{own} radius", radius, sign=sign),
            inputs.add(self.owner, f"{own} height", height),
            (x, y, z),
            narrow=point.values[0] <= self.ball_radius,
        )

    def line(self, number: int, points: Sequence[_Point], start: int, end: int) -> Line:
        """Return a piece of the profile: its kind and sizes."""
        inputs, own = self.reader.inputs, f"piece {number}"
        first, last = points[start], points[end]
        steps = [b - a for a, b in zip(first.formulas, last.formulas, strict=True)]
        values = [b - a for a, b in zip(first.values, last.values, strict=True)]
        signs = [(v > 0) - (v < 0) for v in values]
        for what, step, value, across in zip(
            ("radii", "heights"), steps, values, reversed(values), strict=True
        ):
            if step != ZERO and abs(value) < LEAST_SLOPE * abs(across):
                said = f"the {what} of its ends are almost the same; expected the same, or others"
                raise inputs.wrong(self.owner, f"profile piece {number}", said)
        length = (steps[0] ** 2 + steps[1] ** 2).sqrt()
        unit = []
        for name, step, other, sign in zip("rh", steps, reversed(steps), signs, strict=True):
            share = constant(sign) if other == ZERO else settled(step / length)
            whole = share in (ZERO, ONE, constant(-1))
            unit.append(
                share if whole else inputs.add(self.owner, f"{own} along {name}", share, unit="1")
            )
        kind = "cylinder" if steps[0] == ZERO else "disc" if steps[1] == ZERO else "cone"
        widest = max(first.values[0], last.values[0])
        upright = abs(values[1]) / hypot(*values)
        return Line(
            start,
            end,
            kind,
            (unit[0], unit[1]),
            (signs[0], signs[1]),
            tuple(self._sizes(own, kind, first, steps, signs)),
            inner=kind == "disc" or widest > self.ball_radius * upright,
        )

    def _sizes(
        self,
        own: str,
        kind: str,
        first: _Point,
        steps: Sequence[Formula],
        signs: Sequence[int],
    ) -> Iterator[tuple[str, Formula]]:
        """Yield the inputs that the faces of a piece need, by argument."""
        inputs, (radius, height) = self.reader.inputs, first.formulas
        if kind == "cylinder":
            yield "radius", inputs.add(self.owner, f"{own} radius", radius, sign="positive")
            way = dot(self.vector, self.centre)
            near = [
                settled(c - way * part) for c, part in zip(self.centre, self.vector, strict=True)
            ]
            found = vector_inputs(inputs, self.owner, f"{own} axis", near)
            yield from (
                (f"axis {axis}", part) for axis, part in zip("xyz", found.values(), strict=True)
            )
        elif kind == "disc":
            at = settled(dot(self.vector, self.centre) + height)
            yield "at", inputs.add(self.owner, f"{own} at", at)
        else:
            slope = settled(constant(signs[0] * signs[1]) * steps[0] / steps[1])
            yield (
                "slope",
                inputs.add(self.owner, f"{own} slope", slope, sign="positive", unit="1"),
            )
            apex = height - radius * steps[1] / steps[0]
            away = self.ball * (ONE + slope**2).sqrt() / slope
            for side, sign in (("outside", -1), ("inside", 1)):
                shifted = apex + constant(sign * signs[0] * signs[1]) * away
                found = self._axis_point(f"{own} {side} apex", settled(shifted))
                parts = zip("xyz", found.values(), strict=True)
                yield from ((f"{side} apex {axis}", part) for axis, part in parts)
