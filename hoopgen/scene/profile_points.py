"""Reading of the profiles of surfaces of revolution: points, and pieces between them, checked.

A piece of a profile is straight, or a circular arc through a third point.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import dist

from hoopgen.text.shorten import brief, join_names

from .directions import Reader
from .formulas import ZERO, Formula
from .limits import current
from .profile_curves import Arc, Curve, Segment, meet, ways_at

LEAST_SLOPE = 1e-6
"""Least change of the radius by that of the height, or the inverse, of a piece that is a cone: the
apex of a steeper one is so far away that most digits of its place are lost."""

LEAST_BEND = 0.005
"""Least distance of an arc's middle point from its chord, and least chord, relative to the chord
and to the arc's radius. The condition of an arc is a difference of fourth powers of its radius: on
flatter ones most digits of the place of a contact are lost."""

_ARC = ("through", "to")

_OPPOSITE = -1.0 + 1e-9
"""Cosine of the angle at which a profile turns back onto itself."""


@dataclass(frozen=True)
class ProfilePoint:
    """A point of a profile as it is read.

    Attributes
    ----------
    formulas
        Radius and height as formulas of the scene's parameters.
    values
        Their values at the defaults, m.
    """

    formulas: tuple[Formula, Formula]
    values: tuple[float, float]

    @property
    def on_axis(self) -> bool:
        """Whether it lies on the axis."""
        return self.formulas[0] == ZERO


@dataclass(frozen=True)
class ProfilePiece:
    """A piece of a profile as it is read.

    Attributes
    ----------
    start, end
        The numbers of its points.
    middle
        The point through which an arc runs; None of a straight piece.
    curve
        Where it runs at the defaults.
    """

    start: int
    end: int
    middle: ProfilePoint | None
    curve: Curve


def read_profile(
    reader: Reader, owner: str, given: object
) -> tuple[list[ProfilePoint], list[ProfilePiece]]:
    """Return the points of a profile and the pieces between them.

    A line that ends where it begins has that point once.

    Parameters
    ----------
    reader
        The reader of the scene's arguments.
    owner
        The body, for error messages.
    given
        The profile as its author wrote it.

    Raises
    ------
    SceneError
        If it is not a list of points, crosses the axis or itself, or has a piece that is nearly a
        cylinder, nearly flat, or an arc that is nearly straight.
    """
    points, middles = _points(reader, owner, given)
    closed = len(points) > 2 and points[0].formulas == points[-1].formulas
    last = len(points) - 1
    ends = [(k, 0 if closed and k + 1 == last else k + 1) for k in range(last)]
    if closed:
        points = points[:-1]
    found = []
    for number, ((start, end), middle) in enumerate(zip(ends, middles, strict=True), start=1):
        first, final = points[start], points[end]
        if middle is None:
            _check_straight(reader, owner, number, first, final)
            curve: Curve = Segment(first.values, final.values)
        else:
            curve = _arc(reader, owner, number, first, middle, final)
        found.append(ProfilePiece(start, end, middle, curve))
    _check_axis(reader, owner, points, found, closed)
    _check_crossings(reader, owner, points, found)
    return points, found


def _points(
    reader: Reader, owner: str, given: object
) -> tuple[list[ProfilePoint], list[ProfilePoint | None]]:
    """Return the points of a profile, and the middle point of each piece, None if straight."""
    inputs = reader.inputs
    if isinstance(given, str) or not isinstance(given, Sequence):
        raise inputs.wrong(owner, "profile", f"expected a list of points, got {brief(given)}")
    if excess := current().excess("profile_points", len(given)):
        raise inputs.wrong(owner, "profile", excess)
    if len(given) < 2:
        raise inputs.wrong(owner, "profile", f"expected at least two points, got {len(given)}")
    points, middles = [], []
    for number, point in enumerate(given, start=1):
        own = f"profile point {number}"
        middle = None
        if isinstance(point, Mapping):
            if number == 1:
                said = "the line begins there; expected two sizes, radius and height"
                raise inputs.wrong(owner, own, f"{said}; got {brief(point)}")
            for name in _ARC:
                if name not in point:
                    raise inputs.wrong(owner, f"{own} {name}", "missing")
            if strange := [str(name) for name in point if name not in _ARC]:
                said = f"unknown {join_names(strange)}. There are {join_names(_ARC)}"
                raise inputs.wrong(owner, own, said)
            middle = _point(reader, owner, f"{own} through", point["through"])
            point, own = point["to"], f"{own} to"
        points.append(_point(reader, owner, own, point))
        middles.append(middle)
    return points, middles[1:]


def _point(reader: Reader, owner: str, own: str, given: object) -> ProfilePoint:
    inputs = reader.inputs
    if isinstance(given, str) or not isinstance(given, Sequence) or len(given) != 2:
        said = f"expected two sizes, radius and height; got {brief(given)}"
        raise inputs.wrong(owner, own, said)
    named = [f"{own} {what}" for what in ("radius", "height")]
    read = [reader.formula(owner, a, size) for a, size in zip(named, given, strict=True)]
    values = [inputs.number(owner, a, size) for a, size in zip(named, read, strict=True)]
    if values[0] < 0:
        said = f"expected a number of at least 0, got {values[0]:g}"
        raise inputs.wrong(owner, named[0], said)
    if values[0] == 0 and read[0] != ZERO:
        said = "it is 0 at the defaults; expected the number 0, or a number above 0"
        raise inputs.wrong(owner, named[0], said)
    return ProfilePoint((read[0], read[1]), (values[0], values[1]))


def _check_straight(
    reader: Reader, owner: str, number: int, first: ProfilePoint, last: ProfilePoint
) -> None:
    """Raise if a straight piece has no length, or is nearly along the axis or across it."""
    _check_apart(reader, owner, number, first, last)
    steps = [b - a for a, b in zip(first.formulas, last.formulas, strict=True)]
    values = [b - a for a, b in zip(first.values, last.values, strict=True)]
    for what, step, value, across in zip(
        ("radii", "heights"), steps, values, reversed(values), strict=True
    ):
        if step != ZERO and abs(value) < LEAST_SLOPE * abs(across):
            said = f"the {what} of its ends are almost the same; expected the same, or others"
            raise reader.inputs.wrong(owner, f"profile piece {number}", said)


def _check_apart(
    reader: Reader, owner: str, number: int, first: ProfilePoint, last: ProfilePoint
) -> None:
    if first.values == last.values:
        said = f"it is point {number} again; expected another one"
        raise reader.inputs.wrong(owner, f"profile point {number + 1}", said)


def _arc(
    reader: Reader,
    owner: str,
    number: int,
    first: ProfilePoint,
    middle: ProfilePoint,
    last: ProfilePoint,
) -> Arc:
    """Return an arc, checked to be round, and to stay off the axis."""
    inputs, own = reader.inputs, f"profile piece {number}"
    _check_apart(reader, owner, number, first, last)
    made = Arc(first.values, middle.values, last.values)
    if abs(made.bend) < LEAST_BEND:
        said = (
            "its three points are almost on a straight line; expected an arc, or a straight piece"
        )
        raise inputs.wrong(owner, own, said)
    if dist(made.start, made.end) < LEAST_BEND * made.radius:
        said = "its ends are almost the same point; expected two arcs in place of a whole circle"
        raise inputs.wrong(owner, own, said)
    least = made.least_radius
    if least < 0 or (least == 0 and not (first.on_axis or last.on_axis)):
        said = f"it crosses the axis: its least radius is {least:g}; expected at least 0"
        raise inputs.wrong(owner, own, said)
    return made


def _check_axis(
    reader: Reader,
    owner: str,
    points: Sequence[ProfilePoint],
    found: Sequence[ProfilePiece],
    closed: bool,
) -> None:
    """Raise if a point lies on the axis that may not."""
    last = len(points)
    for number, point in enumerate(points, start=1):
        if not point.on_axis:
            continue
        said = ""
        if closed:
            said = "it lies on the axis; no point of a closed profile may"
        elif number not in (1, last):
            said = "it lies on the axis; only the first and the last point may"
        elif last == 2 and found[0].middle is None and all(one.on_axis for one in points):
            said = "it lies on the axis, as the other point does"
        if said:
            raise reader.inputs.wrong(owner, f"profile point {number}", said)


def _check_crossings(
    reader: Reader, owner: str, points: Sequence[ProfilePoint], found: Sequence[ProfilePiece]
) -> None:
    """Raise if two pieces meet anywhere but at the point that they share."""
    for number, piece in enumerate(found, start=1):
        for later, other in enumerate(found[number:], start=number + 1):
            common = {piece.start, piece.end} & {other.start, other.end}
            joints = [
                ways_at(before.curve, after.curve)[1]
                for before, after in ((piece, other), (other, piece))
                if before.end == after.start
            ]
            crossing = meet(piece.curve, other.curve, [points[k].values for k in common])
            if min(joints, default=1.0) <= _OPPOSITE and not (crossing and len(common) == 2):
                said = f"piece {later} turns back onto piece {number}"
                raise reader.inputs.wrong(owner, "profile", said)
            if crossing:
                said = f"piece {number} and piece {later} meet; expected a simple line"
                raise reader.inputs.wrong(owner, "profile", said)
