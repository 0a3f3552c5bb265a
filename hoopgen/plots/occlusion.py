"""Hidden points of a picture: those that a body drawn above them covers."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.patches import Patch
from matplotlib.path import Path
from numpy.typing import NDArray

from .hoop import drawing_orders
from .views import Points, View

_MIN_OPACITY = 0.5
"""Opacity of a shape from which on it hides what is behind it."""


def is_hidden(bodies: Sequence[Patch], view: View, points: Points) -> NDArray[np.bool_]:
    """Return whether a body hides each point, (n,).

    Parameters
    ----------
    bodies
        The shapes of the bodies, in the coordinates of the picture.
    view
        The view.
    points
        The points, (n, 3), m.
    """
    flat, orders = view.flatten(points), drawing_orders(view, points)
    found = np.zeros(len(points), np.bool_)
    for body in bodies:
        opacity = body.get_alpha()
        if opacity is not None and opacity < _MIN_OPACITY:
            continue
        below = np.flatnonzero(~found & (orders < body.get_zorder()))
        if len(below):
            found[below] = _within(body.get_path(), flat[below])
    return found


def _within(shape: Path, points: Points) -> NDArray[np.bool_]:
    """Return whether each point, (n, 2), is within a shape; its holes are not."""
    found = np.zeros(len(points), np.bool_)
    for outline in shape.to_polygons():
        found ^= Path(outline).contains_points(points)
    return found


def runs(mask: NDArray[np.bool_]) -> list[slice]:
    """Return the runs of true values of a mask, (n,), each with its two neighbours."""
    ends = np.flatnonzero(np.diff(np.concatenate([[False], mask, [False]]).astype(np.int8)))
    return [slice(max(0, first - 1), last + 1) for first, last in ends.reshape(-1, 2).tolist()]
