"""Triangles and extents of surfaces of revolution."""

from __future__ import annotations

from collections.abc import Sequence
from math import ceil

import numpy as np

from .meshes import Bound, Box, Floats, Mesh, contact_mesh, cut, drop_outside, grid, join, walls
from .oblique_geometry import oblique_axes
from .parsed_shapes import RevolvedShape
from .profile import Line
from .profile_curves import Arc, Curve, Place, Segment
from .sizes import Number, turn_angles, vector

_TURN_PIECES, _ROWS = 48, 6


def is_hollow(shape: RevolvedShape) -> bool:
    """Return whether the ball fits inside, so that pictures show the inside, not the outside."""
    return any(line.inner and line.kind != "disc" for line in shape.profile.lines)


def revolution_mesh(
    shape: RevolvedShape, number: Number, bounds: Sequence[Bound], room: Box, ball: float
) -> Mesh:
    """Return the triangles of one side of a surface of revolution, cut to a room.

    Parameters
    ----------
    shape
        The surface.
    number
        The value of its sizes.
    bounds
        Its bounds, functions of its points.
    room
        The lowest and the highest corner.
    ball
        The ball's radius, m.
    """
    axes, centre, curves = _placed(shape, number)
    places = [np.array(curve.samples(_rows(curve))) for curve in curves]
    rise = sum(np.sum(np.diff(p[:, 1]) * (p[1:, 0] + p[:-1, 0])) for p in places)
    side = (1.0 if rise >= 0 else -1.0) * (1.0 if is_hollow(shape) else -1.0)
    u = turn_angles(_TURN_PIECES)
    out = np.stack([np.cos(u), np.sin(u), np.zeros_like(u)], -1) @ axes
    meshes = []
    for curve, profile in zip(curves, places, strict=True):
        radii, heights = profile.T[..., None, None]
        points = centre + radii * out + heights * axes[2]
        radial, axial = side * _left(curve, profile).T[..., None, None]
        normals = np.broadcast_to(radial * out + axial * axes[2], points.shape)
        corners = grid(contact_mesh(points, normals, ball), (False, True))
        flat = corners[..., :3]
        across = np.cross(flat[:, 1] - flat[:, 0], flat[:, 2] - flat[:, 0])
        facing = np.sum(across * (corners[:, 0, 3:] - flat[:, 0]), axis=1)
        corners = np.where((facing < 0.0)[:, None, None], corners[:, ::-1], corners)
        parts = np.arange(len(corners)) // (2 * _TURN_PIECES)
        real = np.linalg.norm(across, axis=1) > 0.0
        meshes.append(Mesh.from_corners(corners[real], parts[real]))
    whole = cut(join(*meshes), bounds, walls(room), touched=True)
    rims = [
        np.stack([circle, np.roll(circle, -1, axis=0)], 1)
        for radius, height in _ends(curves)
        if radius > 0.0
        for circle in [centre + radius * out + height * axes[2]]
    ]
    lines = drop_outside(np.concatenate([np.empty((0, 2, 3)), *rims]), *bounds, *walls(room))
    return Mesh(whole.corners, np.concatenate([whole.rims, lines]), whole.parts)


def _ends(curves: Sequence[Curve]) -> list[Place]:
    """Return the points at which the line ends; none of a closed one."""
    first, last = curves[0].start, curves[-1].end
    return [] if first == last else [first, last]


def _rows(curve: Curve) -> int:
    """Return the number of parts of a piece: on an arc no longer than those of a turn."""
    if isinstance(curve, Segment):
        return _ROWS
    return max(_ROWS, ceil(curve.sweep * _TURN_PIECES / (2.0 * np.pi)))


def _left(curve: Curve, points: Floats) -> Floats:
    """Return the unit vectors to the left of a piece at points of it, (n, 2)."""
    if isinstance(curve, Segment):
        c, s = curve.ways[0]
        return np.broadcast_to([-s, c], points.shape)
    return (curve.centre - points) * (curve.turn / curve.radius)


def _placed(shape: RevolvedShape, number: Number) -> tuple[Floats, Floats, list[Curve]]:
    """Return unit vectors of which the third is the axis, in rows, its origin, and the pieces."""
    points = [(number(v.radius), number(v.height)) for v in shape.profile.vertices]
    curves: list[Curve] = []
    for line in shape.profile.lines:
        start, end = points[line.start], points[line.end]
        if isinstance(line, Line):
            curves.append(Segment(start, end))
        else:
            x, y = map(number, line.middle)
            curves.append(Arc(start, (x, y), end))
    return oblique_axes(shape, number), vector(shape, number, "centre"), curves


def revolution_extent(shape: RevolvedShape, number: Number) -> tuple[list[float], list[float]]:
    """Return the corners of the box along the axes that contains a surface of revolution.

    Parameters
    ----------
    shape, number
        As for `revolution_mesh`.
    """
    axes, centre, curves = _placed(shape, number)
    profile = np.array([point for curve in curves for point in _extremes(curve)])
    reach = profile[:, :1] * np.sqrt(np.maximum(1.0 - axes[2] ** 2, 0.0))
    middles = centre + profile[:, 1:] * axes[2]
    low, high = (middles - reach).min(axis=0), (middles + reach).max(axis=0)
    return low.tolist(), high.tolist()


def _extremes(curve: Curve) -> list[Place]:
    """Return the ends of a piece, and the points of an arc that are drawn."""
    return [curve.start, curve.end] if isinstance(curve, Segment) else curve.samples(_rows(curve))
