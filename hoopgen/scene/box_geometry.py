"""Triangles and extents of boxes, along the axes or turned."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from .boxes import PARTS
from .meshes import Bound, Floats, Mesh, flat, join
from .parsed_shapes import Shape
from .sizes import Number, vector

BOXES = ("box", "oblique box")
"""Kinds of boxes: along the axes, and turned."""


def box_mesh(shape: Shape, number: Number, bounds: Sequence[Bound], ball: float) -> Mesh:
    """Return the triangles of the six faces of a box.

    Parameters
    ----------
    shape
        The box.
    number, bounds, ball
        As for `hoopgen.scene.revolution_geometry.revolution_mesh`.
    """
    low, high, axes, centre = _placed(shape, number)

    def turned(points: Floats) -> Floats:
        return points if shape.kind == "box" else np.asarray(points @ axes + centre)

    def placed(bound: Bound) -> Bound:
        return lambda points: bound(turned(points))

    own = [placed(bound) for bound in bounds]
    faces = []
    for axis in range(3):
        for way in (-1, 1):
            at = float((high if way > 0 else low)[axis])
            face = flat(axis, way, at, (low, high), 0.0, own)
            face.corners[..., 3 + axis] += way * ball
            faces.append(face)
    whole = join(*faces)
    corners = whole.corners.reshape(-1, 3, 2, 3)
    parts = np.zeros(len(corners), np.int64)
    return Mesh(turned(corners).reshape(-1, 3, 6), turned(whole.rims), parts)


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
    if shape.kind == "box":
        low, high = (vector(shape, number, end) for end in ("from", "to"))
        return low, high, np.eye(3), np.zeros(3)
    half, centre = (vector(shape, number, argument) for argument in ("half", "centre"))
    quaternion = np.array([number(shape[f"orientation {part}"]) for part in PARTS])
    w, x, y, z = quaternion / np.linalg.norm(quaternion)
    # Rodrigues' formula; the columns of the rotation are the turned axes.
    across = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    rotation = np.eye(3) + 2.0 * (w * across + across @ across)
    return -half, half, rotation.T, centre
