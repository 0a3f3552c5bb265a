"""Triangles of bodies along an axis or any direction, made upright and turned to their place."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from .bounds import is_along, linear_powers
from .meshes import (
    Bound,
    Box,
    Floats,
    Mesh,
    contact_mesh,
    cut,
    drop_outside,
    flat,
    grid,
    join,
    room_slack,
    walls,
)
from .parsed_shapes import Shape
from .sizes import Number, turn_angles, vector

FLAT = ("inclined plane", "disc")
OBLIQUE = (*FLAT, "cylinder", "oblique cylinder", "cone")
"""Kinds of bodies with a direction, and those of them that are flat."""

_TURN_PIECES, _MAX_ROWS = 48, 60


@dataclass(frozen=True)
class _Frame:
    """Axes of a body, of which the third is its direction.

    Attributes
    ----------
    axes
        The unit vectors of the axes in rows, (3, 3), right-handed.
    origin
        Its origin, (3,), m.
    """

    axes: Floats
    origin: Floats

    def place(self, points: Floats) -> Floats:
        """Return points (..., 3) of the frame in the scene's coordinates."""
        return np.asarray(points @ self.axes + self.origin)

    def box(self, room: Box) -> Box:
        """Return the lowest and the highest coordinates of a room in the frame."""
        corners = np.stack(np.meshgrid(*np.stack(room).T, indexing="ij"), -1).reshape(-1, 3)
        found = (corners - self.origin) @ self.axes.T
        return found.min(axis=0), found.max(axis=0)

    def height(self, points: Floats) -> Floats:
        """Return the coordinates of points (..., 3) of the scene along the third axis."""
        return np.asarray((points - self.origin) @ self.axes[2])


def oblique_mesh(
    shape: Shape, number: Number, bounds: Sequence[Bound], room: Box, ball: float
) -> Mesh:
    """Return the triangles of a body with a direction, cut to a room.

    Parameters
    ----------
    shape
        The body.
    number, room, ball
        As for `hoopgen.scene.revolution_geometry.revolution_mesh`.
    bounds
        Its bounds, besides its circle or its span; of a cone they are functions of its points.
    """
    if shape.kind == "cone":
        return _cone(shape, number, bounds, room, ball)
    if shape.kind.endswith("cylinder"):
        return _cylinder(shape, number, bounds, room, ball)
    if shape.kind == "disc":
        origin = vector(shape, number, "centre")
    else:
        direction = vector(shape, number, "direction")
        length = float(np.linalg.norm(direction))
        origin = number(shape["at"]) / length * direction / length
    frame = _Frame(oblique_axes(shape, number), origin)
    low, high = frame.box(room)
    if not low[2] <= 0.0 <= high[2]:
        return Mesh.from_corners(np.empty((0, 3, 6)))
    placed = [_placed(bound, frame) for bound in bounds]
    if shape.kind == "disc":
        radius = number(shape["radius"])
        low, high = (np.array([way * radius, way * radius, 0.0]) for way in (-1.0, 1.0))
        placed.append(lambda points: points[..., 0] ** 2 + points[..., 1] ** 2 - radius**2)
    mesh = flat(2, 1, 0.0, (low, high), ball, placed)
    return cut(_turned(mesh, frame), (), walls(room))


def oblique_axes(shape: Shape, number: Number) -> Floats:
    """Return the unit vectors, in rows, (3, 3), of axes of which the third is a body's direction.

    Parameters
    ----------
    shape
        The body.
    number
        The value of its sizes.
    """
    if shape.kind in ("cylinder", "torus"):
        axis = shape.axis[0]
        return np.eye(3)[[(axis + 1) % 3, (axis + 2) % 3, axis]]
    direction = vector(shape, number, "direction")
    third = direction / np.linalg.norm(direction)
    first = np.cross(np.eye(3)[int(np.argmin(np.abs(third)))], third)
    first /= np.linalg.norm(first)
    return np.stack([first, np.cross(third, first), third])


def _origin(shape: Shape, number: Number) -> Floats:
    """Return the point from which the span of a body of revolution is measured."""
    if shape.kind == "cone":
        return vector(shape, number, "apex")
    spanned = not {"span from", "span to"}.isdisjoint(dict(shape.sizes))
    return vector(shape, number, "centre" if spanned or shape.kind == "cylinder" else "axis")


def _placed(bound: Bound, frame: _Frame) -> Bound:
    return lambda points: bound(frame.place(points))


def _turned(mesh: Mesh, frame: _Frame) -> Mesh:
    points, centres = frame.place(mesh.corners[..., :3]), frame.place(mesh.corners[..., 3:])
    return Mesh(np.concatenate([points, centres], -1), frame.place(mesh.rims), mesh.parts)


# Bodies of revolution


def _cylinder(
    shape: Shape, number: Number, bounds: Sequence[Bound], room: Box, ball: float
) -> Mesh:
    frame = _Frame(oblique_axes(shape, number), _origin(shape, number))
    radius = number(shape["radius"])
    low, high = _visible_span(frame, radius, room)
    ends = _ends(shape, number)
    low, high = max(low, ends[0]), min(high, ends[1])
    if not low < high:
        return Mesh.from_corners(np.empty((0, 3, 6)))
    step = 2.0 * np.pi * radius / _TURN_PIECES if bounds else radius  # bounds may be curves
    count = int(np.clip(np.ceil((high - low) / step), 1, _MAX_ROWS))
    heights, rows = np.linspace(low, high, count + 1), np.full(count + 1, radius)
    if shape.kind == "cylinder":
        pairs = zip(shape.bounds, bounds, strict=True)
        bounds = [bound for terms, bound in pairs if not is_along(terms, shape.axis[0])]
    whole = cut(_revolved(shape, frame, heights, rows, np.array([1.0, 0.0]), ball), bounds)
    if not shape.inside:
        # Bounds hold for a ball beside the rim.
        caps = (
            _cap(frame, at, radius, way, ball, ball, bounds) for way, at in ((-1, low), (1, high))
        )
        whole = join(whole, *caps)
    mesh, beside = cut(whole, (), walls(room)), -ball if shape.inside else ball
    return _with_rims(mesh, frame, heights, rows, ends, walls(room), bounds, beside)


def _cone(shape: Shape, number: Number, bounds: Sequence[Bound], room: Box, ball: float) -> Mesh:
    frame = _Frame(oblique_axes(shape, number), vector(shape, number, "apex"))
    slope, ends = number(shape["slope"]), _ends(shape, number)
    high = min(float(frame.box(room)[1][2]), ends[1])
    low = max(0.0, ends[0])
    if not low < high:
        return Mesh.from_corners(np.empty((0, 3, 6)))
    heights = np.linspace(low, high, _TURN_PIECES // 2 + 1)
    rows = slope * heights
    cosine = 1.0 / np.sqrt(1.0 + slope**2)
    side = _revolved(shape, frame, heights, rows, np.array([cosine, -slope * cosine]), ball)
    side = cut(side, bounds, walls(room), touched=True)
    if shape.inside:
        return _with_rims(side, frame, heights, rows, ends, walls(room), bounds)
    caps = [
        cut(_cap(frame, at, slope * at, way, ball, 0.0, ()), bounds, walls(room), touched=True)
        for way, at in ((-1, low), (1, high))
        if at in ends and at > 0.0
    ]
    return join(side, *caps)


def _ends(shape: Shape, number: Number) -> tuple[float, float]:
    """Return the ends of a span; of a cylinder along an axis they are bounds."""
    sizes = dict(shape.sizes)
    low, high = (sizes.get(f"span {end}") for end in ("from", "to"))
    first = 0.0 if shape.kind == "cone" else -np.inf
    first, last = first if low is None else number(low), np.inf if high is None else number(high)
    if shape.kind == "cylinder":
        axis = shape.axis[0]
        for terms in (terms for terms in shape.bounds if is_along(terms, axis)):
            found = {powers: number(factor) for powers, factor in terms}
            steep = found[linear_powers(axis)]
            end = -found.get((0, 0, 0), 0.0) / steep if steep else np.inf
            first, last = (max(first, end), last) if steep < 0.0 else (first, min(last, end))
    return first, last


def _visible_span(frame: _Frame, radius: float, room: Box) -> tuple[float, float]:
    """Return the part of an axis around which a whole cylinder is in the room.

    If that is less than half of the axis in the room, it is the part that may be near the room.
    """
    slack = room_slack(room)
    whole, axis = (_axis_span(frame, size, room) for size in (radius, 0.0))
    if whole[1] - whole[0] > 0.5 * max(0.0, axis[1] - axis[0]):
        return whole[0] - slack, whole[1] + slack
    low, high = frame.box(room)
    return float(low[2]) - slack, float(high[2]) + slack


def _axis_span(frame: _Frame, radius: float, room: Box) -> tuple[float, float]:
    """Return the ends of the part of an axis about which circles are in the room."""
    reach = radius * np.sqrt(np.maximum(1.0 - frame.axes[2] ** 2, 0.0))
    with np.errstate(divide="ignore", invalid="ignore"):
        ways = [
            (side + way * reach - frame.origin) / frame.axes[2]
            for side, way in zip(room, (1.0, -1.0), strict=True)
        ]
    lows, highs = np.fmin(*ways), np.fmax(*ways)
    across = frame.axes[2] != 0.0
    return float(np.max(lows[across])), float(np.min(highs[across]))


def _revolved(
    shape: Shape, frame: _Frame, heights: Floats, radii: Floats, slope: Floats, ball: float
) -> Mesh:
    """Return the side of a body of revolution; its normal has an outward and an axial part."""
    u = turn_angles(_TURN_PIECES)
    circle = np.stack([np.cos(u), np.sin(u)], -1)
    heights, radii = heights[::-1], radii[::-1]  # counterclockwise as seen from outside
    points = np.empty((len(heights), _TURN_PIECES, 3))
    points[..., :2] = radii[:, None, None] * circle
    points[..., 2] = heights[:, None]
    unit = np.empty_like(points)
    unit[..., :2], unit[..., 2] = slope[0] * circle, slope[1]
    normals = -unit if shape.inside else unit
    corners = grid(contact_mesh(points, normals, ball), (False, True))
    if shape.inside:
        corners = corners[:, ::-1]
    parts = np.arange(len(corners)) // (2 * _TURN_PIECES)
    places = corners[..., :3]
    real = ~np.all(places == np.roll(places, -1, axis=1), axis=2).any(axis=1)
    return _turned(Mesh.from_corners(corners[real], parts[real]), frame)


def _circle(frame: _Frame, at: float, radius: float) -> Floats:
    u = turn_angles(_TURN_PIECES)
    points = np.stack([radius * np.cos(u), radius * np.sin(u), np.full(len(u), at)], -1)
    return frame.place(points)


def _cap(
    frame: _Frame,
    at: float,
    radius: float,
    way: int,
    ball: float,
    beside: float,
    bounds: Sequence[Bound],
) -> Mesh:
    """Return an end face, which nothing touches: a body without one would look hollow."""
    rim = _circle(frame, at, radius)
    middle = np.broadcast_to(frame.place(np.array([0.0, 0.0, at])), rim.shape)
    turn = (rim, np.roll(rim, -1, axis=0))
    corners = np.stack([middle, *turn[::way]], 1)
    asked = corners + beside / radius * (corners - middle[:, None])
    left = cut(Mesh.from_corners(np.concatenate([corners, asked], -1)), bounds).corners
    left[..., 3:] = left[..., :3] + way * ball * frame.axes[2]
    return Mesh.from_corners(left)


def _with_rims(
    mesh: Mesh,
    frame: _Frame,
    heights: Floats,
    radii: Floats,
    ends: tuple[float, float],
    room: Sequence[Bound],
    bounds: Sequence[Bound],
    beside: float = 0.0,
) -> Mesh:
    """Return a mesh with the lines of its ends, as far as they are in a room and within bounds.

    The bounds are those of points at a distance from the line, away from the axis.
    """
    found = [mesh.rims]
    for at, radius in ((float(heights[0]), radii[0]), (float(heights[-1]), radii[-1])):
        if at in ends and radius > 0.0 and len(mesh.corners):
            line, asked = (_circle(frame, at, float(size)) for size in (radius, radius + beside))
            inside = np.full(len(line), True)
            for bound in bounds:
                inside &= bound(asked) <= 0.0
            segments = np.stack([line, np.roll(line, -1, axis=0)], 1)
            segments = segments[np.logical_and(inside, np.roll(inside, -1))]
            found.append(drop_outside(segments, *room))
    return Mesh(mesh.corners, np.concatenate(found), mesh.parts)


def oblique_extent(
    shape: Shape, number: Number, near: Box | None = None
) -> tuple[list[float], list[float]]:
    """Return the corners of the box that contains a body with a direction.

    Parameters
    ----------
    shape
        The body.
    number
        The value of its sizes.
    near
        Of a cylinder without an end only the part beside this box is meant; None: all of it.
    """
    if shape.kind == "inclined plane":
        return [-np.inf] * 3, [np.inf] * 3
    direction = oblique_axes(shape, number)[2]
    reach = np.sqrt(np.maximum(1.0 - direction**2, 0.0))
    if shape.kind == "disc":
        circles = [(vector(shape, number, "centre"), number(shape["radius"]))]
    else:
        origin = _origin(shape, number)
        slope, radius = (
            number(shape[name]) if name in dict(shape.sizes) else 0.0
            for name in ("slope", "radius")
        )
        ends = np.array(_ends(shape, number))
        if near is not None and not slope:
            beside = _Frame(oblique_axes(shape, number), origin).box(near)
            ends = np.where(np.isfinite(ends), ends, [beside[0][2], beside[1][2]])
        circles = []
        for end in map(float, ends):
            with np.errstate(invalid="ignore"):
                shift = np.where(direction == 0.0, 0.0, end * direction)
            circles.append((origin + shift, radius + slope * end if slope else radius))
    with np.errstate(invalid="ignore"):  # of a cone without an end
        low = np.min([middle - radius * reach for middle, radius in circles], axis=0)
        high = np.max([middle + radius * reach for middle, radius in circles], axis=0)
    low, high = np.where(np.isnan(low), -np.inf, low), np.where(np.isnan(high), np.inf, high)
    return low.tolist(), high.tolist()
