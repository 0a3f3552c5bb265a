"""Triangles, lines and extents of tori, along an axis or any direction."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from .meshes import Bound, Box, Floats, Mesh, contact_mesh, cut, drop_outside, grid, walls
from .oblique_geometry import oblique_axes
from .parsed_shapes import Shape
from .sizes import Number, turn_angles, vector

_TURN_PIECES, _WIRE_PIECES, _SECTOR_PIECES = 96, 12, 4
"""Pieces of a turn, of a wire's, and of a ring's that are drawn together."""


def torus_mesh(
    shape: Shape, number: Number, bounds: Sequence[Bound], room: Box, ball: float
) -> Mesh:
    """Return the triangles of a torus; none without a wire radius.

    Parameters
    ----------
    shape
        The torus.
    number, bounds, room, ball
        As for `hoopgen.scene.revolution_geometry.revolution_mesh`.
    """
    wire = number(shape["wire"])
    if wire == 0.0:
        return Mesh.from_corners(np.empty((0, 3, 6)))
    circle = _circle(shape, number)
    out = (circle - vector(shape, number, "centre")) / number(shape["radius"])
    v = turn_angles(_WIRE_PIECES)
    unit = np.cos(v)[:, None] * out[:, None] + np.sin(v)[:, None] * oblique_axes(shape, number)[2]
    corners = grid(contact_mesh(circle[:, None] + wire * unit, unit, ball), (True, True))
    parts = np.arange(len(corners)) // (2 * _WIRE_PIECES * _SECTOR_PIECES)
    return cut(Mesh.from_corners(corners, parts), bounds, walls(room), touched=True)


def torus_lines(shape: Shape, number: Number, bounds: Sequence[Bound]) -> Floats:
    """Return the circle of a torus without a wire radius within its bounds, (k, 2, 3).

    Parameters
    ----------
    shape, number, bounds
        As for `torus_mesh`.
    """
    if number(shape["wire"]) != 0.0:
        return np.empty((0, 2, 3))
    line = _circle(shape, number)
    return drop_outside(np.stack([line, np.roll(line, -1, axis=0)], 1), *bounds)


def torus_extent(shape: Shape, number: Number) -> tuple[list[float], list[float]]:
    """Return the corners of the box along the axes that contains a torus.

    Parameters
    ----------
    shape, number
        As for `torus_mesh`.
    """
    unit = oblique_axes(shape, number)[2]
    reach = number(shape["radius"]) * np.sqrt(np.maximum(1.0 - unit**2, 0.0))
    reach += number(shape["wire"])
    centre = vector(shape, number, "centre")
    return (centre - reach).tolist(), (centre + reach).tolist()


def _circle(shape: Shape, number: Number) -> Floats:
    first, second, _ = oblique_axes(shape, number)
    u = turn_angles(_TURN_PIECES)[:, None]
    unit = np.cos(u) * first + np.sin(u) * second
    around: Floats = vector(shape, number, "centre") + number(shape["radius"]) * unit
    return around
