"""Triangles and extents of surfaces of revolution."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from .formulas import Formula
from .meshes import Bound, Box, Floats, Mesh, contact_mesh, cut, drop_outside, grid, join, walls
from .oblique_geometry import oblique_axes
from .parsed_shapes import RevolvedShape

__all__ = ["is_hollow", "revolution_extent", "revolution_mesh"]

_TURN_PIECES, _ROWS = 48, 6

Number = Callable[[Formula], float]
"""The value of a size of the scene."""


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
    axes, centre, profile = _placed(shape, number)
    steps = [profile[line.end] - profile[line.start] for line in shape.profile.lines]
    widths = [profile[line.end][0] + profile[line.start][0] for line in shape.profile.lines]
    rise = sum(step[1] * width for step, width in zip(steps, widths, strict=True))
    side = (1.0 if rise >= 0 else -1.0) * (1.0 if is_hollow(shape) else -1.0)
    u = np.linspace(0.0, 2.0 * np.pi, _TURN_PIECES, endpoint=False)
    out = np.stack([np.cos(u), np.sin(u), np.zeros_like(u)], -1) @ axes
    meshes = []
    for line, step in zip(shape.profile.lines, steps, strict=True):
        shares = np.linspace(0.0, 1.0, _ROWS + 1)[:, None]
        radii, heights = (profile[line.start] + shares * step).T[..., None, None]
        points = centre + radii * out + heights * axes[2]
        radial, axial = side * np.array([-step[1], step[0]]) / np.hypot(*step)
        normals = np.broadcast_to(radial * out + axial * axes[2], points.shape)
        corners = grid(contact_mesh(points, normals, ball), (False, True))
        places = corners[..., :3]
        across = np.cross(places[:, 1] - places[:, 0], places[:, 2] - places[:, 0])
        facing = np.sum(across * (corners[:, 0, 3:] - places[:, 0]), axis=1)
        corners = np.where((facing < 0.0)[:, None, None], corners[:, ::-1], corners)
        parts = np.arange(len(corners)) // (2 * _TURN_PIECES)
        real = np.linalg.norm(across, axis=1) > 0.0
        meshes.append(Mesh.from_corners(corners[real], parts[real]))
    whole = cut(join(*meshes), bounds, walls(room), touched=True)
    rims = [
        np.stack([circle, np.roll(circle, -1, axis=0)], 1)
        for radius, height in profile[_ends(shape)]
        if radius > 0.0
        for circle in [centre + radius * out + height * axes[2]]
    ]
    lines = drop_outside(np.concatenate([np.empty((0, 2, 3)), *rims]), *bounds, *walls(room))
    return Mesh(whole.corners, np.concatenate([whole.rims, lines]), whole.parts)


def _ends(shape: RevolvedShape) -> list[int]:
    """Return the numbers of the points at which the line ends; none of a closed one."""
    lines = shape.profile.lines
    return [] if lines[-1].end == lines[0].start else [lines[0].start, lines[-1].end]


def _placed(shape: RevolvedShape, number: Number) -> tuple[Floats, Floats, Floats]:
    """Return unit vectors of which the third is the axis, in rows, its origin, and the points."""
    sizes = dict(shape.sizes)
    own = (sizes.get(f"centre {axis}") for axis in "xyz")
    centre = np.array([0.0 if size is None else number(size) for size in own])
    points = [[number(v.radius), number(v.height)] for v in shape.profile.vertices]
    return oblique_axes(shape, number), centre, np.array(points)


def revolution_extent(shape: RevolvedShape, number: Number) -> tuple[list[float], list[float]]:
    """Return the corners of the box along the axes that contains a surface of revolution.

    Parameters
    ----------
    shape, number
        As for `revolution_mesh`.
    """
    axes, centre, profile = _placed(shape, number)
    reach = profile[:, :1] * np.sqrt(np.maximum(1.0 - axes[2] ** 2, 0.0))
    middles = centre + profile[:, 1:] * axes[2]
    low, high = (middles - reach).min(axis=0), (middles + reach).max(axis=0)
    return low.tolist(), high.tolist()
