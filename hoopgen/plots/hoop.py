"""Drawings of ring, backboard and bridge, to scale in any view, far parts first."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from matplotlib.patches import Circle, Polygon
from numpy.typing import ArrayLike, NDArray

from .style import COLOURS, POINTS_PER_INCH
from .views import Points, View

BOARD_THICKNESS = 0.0127
"""Thickness of the board as drawn, m; the model knows its front only."""

# The eye is never behind the board.
_BACKGROUND_ORDER = 4.0
_BEHIND_ORDER, _BEHIND_RANGE = 3.0, 0.01  # drawing order behind the board, and its share of depth
_RING_PIECES = 72
_PIECE_DEPTH = 0.5  # ball radii over which a piece of a path with more points may extend
_MIN_PIECE_POINTS, _MAX_PIECES = 4, 2_000  # points in a piece of a path, at least; pieces, at most


def draw_hoop(axes: Axes, view: View, parameters: Mapping[str, float], scale: float) -> None:
    """Draw ring, backboard and bridge.

    Parameters
    ----------
    axes
        Where.
    view
        From where.
    parameters
        Of the scene.
    scale
        Inches of the picture per metre.
    """
    for face in _prism(_board_outline(parameters), (-BOARD_THICKNESS, 0.0, 0.0)):
        _draw_face(axes, view, face, "#D9DEE2", "#5B6670", _BACKGROUND_ORDER)
    thickness = 2.0 * parameters["wire_radius"]
    for face in _prism(_bridge_outline(parameters), (0.0, 0.0, -thickness)):
        _draw_face(axes, view, face, COLOURS["bridge"], COLOURS["bridge"], _BACKGROUND_ORDER + 0.5)
    wire = _ring_wire(parameters)
    stroke = thickness * scale * POINTS_PER_INCH
    for start in range(_RING_PIECES):
        _draw_stroke(axes, view, wire[start : start + 2], COLOURS["ring"], stroke)


def draw_path(axes: Axes, view: View, path: Points, radius: float) -> None:
    """Draw a path of the ball's centre, shape (n, 3); its near pieces hide far ones.

    Parameters
    ----------
    axes, view
        The axes and the view.
    path
        The path, (n, 3), m.
    radius
        The ball's radius, m.
    """
    for piece in _pieces(view.depth(path), _PIECE_DEPTH * radius * view.near):
        _draw_stroke(axes, view, path[piece], COLOURS["path"], 1.1)


def _pieces(depth: NDArray[np.float64], tolerance: float) -> Iterator[slice]:
    """Return the pieces of a path of about one depth each; the end of each begins the next one."""
    step = max(_MIN_PIECE_POINTS, -(-len(depth) // _MAX_PIECES))
    first, low, high = 0, np.inf, -np.inf
    for start in range(0, len(depth) - 1, step):
        part = depth[start : start + step + 1]
        low, high = min(low, part.min()), max(high, part.max())
        if start > first and high - low > tolerance:
            yield slice(first, start + 1)
            first, low, high = start, part.min(), part.max()
    yield slice(first, len(depth))


def draw_ball(
    axes: Axes,
    view: View,
    centre: ArrayLike,
    radius: float,
    colour: str = "ball",
    *,
    ghost: bool = False,
) -> None:
    """Draw the ball to scale; as a ghost, its outline only, dashed.

    Its colour is one of `COLOURS`, as is that of its edge.

    Parameters
    ----------
    axes, view
        The axes and the view.
    centre
        The ball's centre, (3,), m.
    radius
        The ball's radius, m.
    colour
        The colour.
    ghost
        True for a dashed outline only.
    """
    at = view.flatten(centre)
    depth = drawing_order(view, np.asarray(centre))
    outline = Circle((at[0], at[1]), radius, fill=False, lw=0.8, zorder=depth + 0.01)
    outline.set_edgecolor(COLOURS[f"{colour}-edge"])
    if ghost:
        outline.set_linestyle((0, (3, 2)))
    else:
        fill = Circle((at[0], at[1]), radius, fc=COLOURS[colour], alpha=0.38, lw=0, zorder=depth)
        axes.add_patch(fill)
    axes.add_patch(outline)


def scene_corners(parameters: Mapping[str, float]) -> Points:
    """Return points that span ring, board and bridge, shape (n, 3)."""
    board = _board_outline(parameters)
    reach = parameters["ring_radius"] + parameters["wire_radius"]
    ring = np.array([[reach, 0, 0], [-reach, 0, 0], [0, reach, 0], [0, -reach, 0]], dtype=float)
    return np.vstack([board, board + (-BOARD_THICKNESS, 0.0, 0.0), ring])


def scene_points(parameters: Mapping[str, float]) -> Points:
    """Return points along the ring and the board's edge and on the bridge, shape (n, 3)."""
    bridge = _bridge_outline(parameters)
    shrunk = [
        bridge.mean(axis=0) + share * (bridge - bridge.mean(axis=0)) for share in (1, 0.6, 0.2)
    ]
    outlines = [_board_outline(parameters), *shrunk]
    edges = [
        np.linspace(start, stop, 24)
        for outline in outlines
        for start, stop in zip(outline, np.roll(outline, -1, axis=0), strict=True)
    ]
    return np.vstack([_ring_wire(parameters), *edges])


def _board_outline(parameters: Mapping[str, float]) -> Points:
    half, x = parameters["board_half_width"], -parameters["board_distance"]
    low, high = parameters["board_bottom"], parameters["board_top"]
    return np.array([[x, -half, low], [x, half, low], [x, half, high], [x, -half, high]])


def _bridge_outline(parameters: Mapping[str, float]) -> Points:
    """Return the outline of the bridge's top, from the board to the middle of the ring's wire."""
    half, radius = parameters["bridge_half_width"], parameters["ring_radius"]
    top = parameters["wire_radius"]
    y = np.linspace(-half, half, 9)
    x = -np.sqrt(np.maximum(radius**2 - y**2, 0.0))
    arc = np.stack([x, y, np.full_like(y, top)], axis=1)
    board = -parameters["board_distance"]
    return np.vstack([arc, [[board, half, top], [board, -half, top]]])


def _ring_wire(parameters: Mapping[str, float]) -> Points:
    turn = np.linspace(0.0, 2.0 * np.pi, _RING_PIECES + 1)
    radius = parameters["ring_radius"]
    return np.stack([radius * np.cos(turn), radius * np.sin(turn), np.zeros_like(turn)], axis=1)


def _prism(outline: Points, along: tuple[float, float, float]) -> list[Points]:
    """Return the faces of a prism: an outline extruded along a vector."""
    far = outline + np.asarray(along)
    following = np.roll(outline, -1, axis=0), np.roll(far, -1, axis=0)
    sides = [np.stack(face) for face in zip(outline, *following, far, strict=True)]
    return [far, *sides, outline]


def _draw_face(axes: Axes, view: View, face: Points, fill: str, edge: str, order: float) -> None:
    axes.add_patch(Polygon(view.flatten(face), fc=fill, ec=edge, lw=0.4, alpha=0.8, zorder=order))


def _draw_stroke(axes: Axes, view: View, points: Points, colour: str, width: float) -> None:
    flat = view.flatten(points)
    axes.add_line(
        Line2D(
            flat[:, 0],
            flat[:, 1],
            color=colour,
            lw=width,
            solid_capstyle="round",
            zorder=drawing_order(view, points.mean(axis=0)),
        )
    )


def drawing_order(view: View, point: Points) -> float:
    """Return the drawing order of a point: near over far, all over grid and axes.

    Parameters
    ----------
    view
        The view.
    point
        The point, (3,), m.
    """
    return float(drawing_orders(view, point))


def drawing_orders(view: View, points: Points) -> Points:
    """Return the drawing orders of points, as `drawing_order` does of one.

    Parameters
    ----------
    view
        The view.
    points
        The points, (..., 3), m.
    """
    depth = view.depth(points)
    if view.wall is None:
        return 10.0 + depth
    behind = np.asarray(points)[..., 0] < view.wall
    return np.where(behind, _BEHIND_ORDER + _BEHIND_RANGE * depth, 10.0 + depth)
