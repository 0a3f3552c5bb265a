"""Triangles and extents of boxes, along the axes or turned."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from .boxes import PARTS
from .formulas import Formula
from .meshes import Floats, Mesh, flat
from .parsed_shapes import Shape

__all__ = ["BOXES", "box_extent", "box_mesh"]

BOXES = ("box", "oblique box")
"""Kinds of boxes: along the axes, and turned."""

Number = Callable[[Formula], float]
"""The value of a size of the scene."""


def box_mesh(shape: Shape, number: Number, ball: float) -> Mesh:
    """Return the triangles of the six faces of a box.

    Parameters
    ----------
    shape
        The box.
    number
        The value of its sizes.
    ball
        The ball's radius, m.
    """
    low, high, axes, centre = _placed(shape, number)
    faces = [
        flat(axis, way, float((high if way > 0 else low)[axis]), (low, high), ball, ()).corners
        for axis in range(3)
        for way in (-1, 1)
    ]
    corners = np.concatenate(faces)
    if shape.kind == "oblique box":
        corners = (corners.reshape(-1, 3, 2, 3) @ axes + centre).reshape(corners.shape)
    return Mesh.from_corners(corners)


def box_extent(shape: Shape, number: Number) -> tuple[list[float], list[float]]:
    """Return the corners of the box along the axes that contains a box.

    Parameters
    ----------
    shape, number
        As for `box_mesh`.
    """
    low, high, axes, centre = _placed(shape, number)
    if shape.kind == "box":
        return low.tolist(), high.tolist()
    reach = high @ np.abs(axes)
    return (centre - reach).tolist(), (centre + reach).tolist()


def _placed(shape: Shape, number: Number) -> tuple[Floats, Floats, Floats, Floats]:
    """Return a box's corners along its own axes, these axes in rows, (3, 3), and their origin."""
    sizes = dict(shape.sizes)
    if shape.kind == "box":
        low, high = (
            np.array([number(sizes[f"{end} {axis}"]) for axis in "xyz"]) for end in ("from", "to")
        )
        return low, high, np.eye(3), np.zeros(3)
    half, centre = (
        np.array([number(sizes[f"{argument} {axis}"]) for axis in "xyz"])
        for argument in ("half", "centre")
    )
    quaternion = np.array([number(sizes[f"orientation {part}"]) for part in PARTS])
    w, x, y, z = quaternion / np.linalg.norm(quaternion)
    # Rodrigues' formula; the columns of the rotation are the turned axes.
    across = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    rotation = np.eye(3) + 2.0 * (w * across + across @ across)
    return -half, half, rotation.T, centre
