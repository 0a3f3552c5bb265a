"""Outlines of triangles in a flat picture."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.colors import to_rgb
from matplotlib.patches import PathPatch
from matplotlib.path import Path

from hoopgen.scene.mesh_lines import chains, loops
from hoopgen.scene.meshes import Mesh

from .hoop import drawing_order
from .views import Points, View

EDGE_ON = 1e-6
"""Cosine of the angle between a normal and the eye below which a surface is seen as a line."""

RIM_ORDER = 4.2
"""Drawing order of lines below paths."""

_MAX_DEPTHS = 16  # groups of segments, each with a drawing order of its own
_LINE_DIGITS = 6  # of the largest coordinate: corners that differ less are one
_NEAR, _PASSES = 5e-4, 6  # of a shape's size, and how often points of its outline are left out


def edge_on(mesh: Mesh, view: View) -> bool:
    """Return whether a mesh is flat and appears as a line.

    Parameters
    ----------
    mesh, view
        The mesh and the view.
    """
    ways = mesh.corners[..., 3:] - mesh.corners[..., :3]
    if not ways.any():  # an end: its ball has no size
        flat = mesh.corners[..., :3].reshape(-1, 3)
        return bool(len(flat)) and bool(np.ptp(view.flatten(flat), axis=0).min() < EDGE_ON)
    size = float(np.abs(ways).max())
    straight = np.ptp(ways.reshape(-1, 3), axis=0).max() < EDGE_ON * size
    return bool(straight and np.abs(ways @ view.towards).max() < EDGE_ON * size)


def draw_edge_on(axes: Axes, view: View, corners: Points, facing: Points, colour: str) -> None:
    """Draw the parts of a curved surface that appear as lines, such as a pipe from its end.

    Parameters
    ----------
    axes, view
        Where, and from where.
    corners, facing
        Of its triangles, (m, 3, 6), and how far each corner's normal points towards the eye.
    colour
        Of the line.
    """
    triangles = view.flatten(corners[(np.abs(facing) < EDGE_ON).all(axis=1)][..., :3])
    if len(triangles):
        edges = np.stack([triangles, np.roll(triangles, 1, axis=1)], axis=2).reshape(-1, 2, 2)
        lines = [_drop_collinear(line) for line in chains(_snap(edges))]
        axes.add_collection(
            LineCollection(lines, colors=[colour], linewidths=1.1, zorder=RIM_ORDER)
        )


def flat_chains(view: View, segments: Points) -> list[Points]:
    """Return segments as lines of a picture, (n, 2) each, as long as possible.

    Parameters
    ----------
    view
        The view.
    segments
        The segments, (k, 2, 3), m.
    """
    return [_drop_collinear(view.flatten(line)) for line in chains(_snap(segments))]


def _snap(points: Points) -> Points:
    """Return points of which those that differ by a rounding are one."""
    largest = float(np.abs(points).max(initial=0.0)) or 1.0
    return np.asarray(np.round(points, _LINE_DIGITS - int(np.ceil(np.log10(largest)))))


def spans(triangles: Points) -> list[Points]:
    """Return the segments that triangles on one line cover, merged."""
    points = triangles.reshape(-1, 2)
    if not len(points):
        return []
    along = points[np.argmax(np.linalg.norm(points - points[0], axis=1))] - points[0]
    order = (triangles @ along).reshape(-1, 3)
    starts, stops = triangles[:, 0] * 0.0, triangles[:, 0] * 0.0
    for ends, pick in ((starts, order.argmin(axis=1)), (stops, order.argmax(axis=1))):
        ends[:] = triangles[np.arange(len(triangles)), pick]
    sort = np.argsort(starts @ along, kind="stable")
    found: list[list[Points]] = []
    for start, stop in zip(starts[sort], stops[sort], strict=True):
        slack = 1e-9 * float(along @ along)
        if found and start @ along <= found[-1][1] @ along + slack:
            found[-1][1] = max(found[-1][1], stop, key=lambda end: float(end @ along))
        else:
            found.append([start, stop])
    return [np.array(ends) for ends in found]


def merge_triangles(corners: Points, view: View, **look: Any) -> PathPatch:
    """Return the union of triangles as one shape.

    Parameters
    ----------
    corners
        The triangles, (n, 3, 3), m.
    view
        The view.
    """
    vertices, codes = [], []
    for line in loops(corners[..., :3]):
        flat = _drop_collinear(view.flatten(line))
        vertices.append(flat)
        codes += [Path.MOVETO, *[Path.LINETO] * (len(flat) - 2), Path.CLOSEPOLY]
    shape = Path(np.concatenate([np.empty((0, 2)), *vertices]), codes)
    return PathPatch(shape, joinstyle="round", **look)


def _drop_collinear(line: Points) -> Points:
    """Return a line without the points that lie nearly between their neighbours.

    Where a line turns back, as a circle does that is seen from the side, it keeps the point.
    """
    near = _NEAR * float(np.ptp(line, axis=0).max())
    for _ in range(_PASSES):
        if len(line) < 5:
            break
        before, at, after = line[:-2:2], line[1:-1:2], line[2::2]
        way, off = after - before[: len(after)], at - before[: len(at)]
        across = np.abs(way[:, 0] * off[:, 1] - way[:, 1] * off[:, 0])
        length = np.linalg.norm(way, axis=1)
        turned = ((way * off).sum(axis=1) < 0.0) | (np.linalg.norm(off, axis=1) > length)
        needed = (across > near * length) | turned
        keep = np.ones(len(line), np.bool_)
        keep[1:-1:2] = needed
        line = line[keep]
    return line


def draw_lines(
    axes: Axes, view: View, lines: Points, colour: str, wide: float, *, behind: bool
) -> None:
    """Draw segments (k, 2, 3), near ones over the ball.

    Parameters
    ----------
    axes, view
        The axes and the view.
    lines
        The segments, (k, 2, 3), m.
    colour
        The colour.
    wide
        The width of the lines, points.
    behind
        True if all lines are below the paths.
    """
    if not len(lines):
        return
    if behind:
        groups = [(np.arange(len(lines)), RIM_ORDER)]
    else:
        depth = view.depth(lines.mean(axis=1))
        count = min(_MAX_DEPTHS, len(lines)) if np.ptp(depth) > EDGE_ON else 1
        rows = np.array_split(np.argsort(depth, kind="stable"), count)
        middle = [lines[group].mean(axis=(0, 1)) for group in rows]
        groups = [(g, drawing_order(view, m)) for g, m in zip(rows, middle, strict=True)]
    for group, order in groups:
        axes.add_collection(
            LineCollection(
                flat_chains(view, lines[group]),
                colors=[mix_with_white(colour, -0.2)],
                linewidths=wide,
                zorder=order,
                capstyle="round",
            )
        )


def mix_with_white(colour: str, white: float) -> tuple[float, float, float]:
    """Return a colour mixed with white, or with black.

    Parameters
    ----------
    colour
        A colour of matplotlib.
    white
        The share of white, 0 to 1, or negative the share of black.
    """
    aim = float(white > 0.0)
    red, green, blue = (c + abs(white) * (aim - c) for c in to_rgb(colour))
    return red, green, blue
