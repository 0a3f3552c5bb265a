"""Triangle meshes of surfaces, cut along bounds, for pictures and pages.

A corner of a triangle is a row of six: the point of the surface, and where the ball's centre is as
it touches there. So the normal is on the way from the one to the other, and bounds are asked of the
centre, as the search asks them.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

Bound = Callable[[Floats], Floats]
"""Function of points (..., 3) whose value is at most 0 where the surface exists."""

Box = tuple[Floats, Floats]
"""The lowest and the highest coordinates."""

_PATCH_CELLS = 16
"""Cells along a side of a flat patch; those that are cut are halved `_MAX_HALVINGS` times."""

_MAX_HALVINGS = 4
_ROOM_CELLS = 40
"""Cells along the longest side of the room, in which a condition's surface is looked for."""


@dataclass(frozen=True)
class Mesh:
    """A mesh of triangles.

    Attributes
    ----------
    corners
        (m, 3, 6), counterclockwise as seen from the side of the ball.
    rims
        Where bounds cut it off, segments (k, 2, 3).
    parts
        Which triangles are near one another, (m,).
    """

    corners: Floats
    rims: Floats
    parts: NDArray[np.int64]

    @classmethod
    def from_corners(cls, corners: Floats, parts: NDArray[np.int64] | None = None) -> Mesh:
        """Return an uncut mesh.

        Parameters
        ----------
        corners
            The triangles, (n, 3, c).
        parts
            The part to which each triangle belongs, (n,); None for one part.
        """
        own = np.zeros(len(corners), np.int64) if parts is None else parts
        return cls(corners, np.empty((0, 2, 3)), own)


def clip(corners: Floats, values: Floats) -> tuple[Floats, Floats, NDArray[np.intp]]:
    """Cut triangles where values at their corners are not below 0.

    Both triangles of an edge find the same bits for where it is cut. Where a corner's own value is
    0, or as good as that, what is left may be a line: `mesh_lines.loops` passes over it.

    Parameters
    ----------
    corners
        (m, 3, c).
    values
        (m, 3).

    Returns
    -------
    tuple
        What is left, the cuts (k, 2, c), and from which triangle each that is left comes.
    """
    inside = values < 0.0
    count = inside.sum(axis=1)
    kept, cuts, rows = [corners[count == 3]], [], [np.flatnonzero(count == 3)]
    for many in (1, 2):
        row = np.flatnonzero(count == many)
        # The corner that is alone comes first.
        lone = np.argmax(inside[row] == (many == 1), axis=1)
        order = (lone[:, None] + np.arange(3)) % 3
        a, b, c = np.moveaxis(np.take_along_axis(corners[row], order[..., None], 1), 1, 0)
        u, v, w = np.take_along_axis(values[row], order, 1).T
        if many == 1:
            ab, ac = _cut(a, b, u, v), _cut(a, c, u, w)
            kept.append(np.stack([a, ab, ac], 1))
            rows.append(row)
        else:
            ab, ac = _cut(b, a, v, u), _cut(c, a, w, u)
            kept += [np.stack([ab, b, c], 1), np.stack([ab, c, ac], 1)]
            rows += [row, row]
        cuts.append(np.stack([ab, ac], 1))
    return np.concatenate(kept), np.concatenate(cuts), np.concatenate(rows)


def _cut(inner: Floats, outer: Floats, low: Floats, high: Floats) -> Floats:
    share = (-low / (high - low))[:, None]
    return np.where(share == 1.0, outer, inner + share * (outer - inner))


def cut(
    mesh: Mesh, bounds: Sequence[Bound], room: Sequence[Bound] = (), *, touched: bool = False
) -> Mesh:
    """Return the part of a mesh within bounds and within a room, whose walls leave no rims.

    Parameters
    ----------
    mesh
        The mesh.
    bounds
        Functions of points (..., 3), at most 0 on the surface.
    room
        The same for the walls of the room.
    touched
        Whether the bounds are those of points of the surface, not of the ball's centre.
    """
    corners, rims, parts = mesh.corners, mesh.rims, mesh.parts
    for bound, real in [*((b, True) for b in bounds), *((b, False) for b in room)]:
        place = slice(3, 6) if real and not touched else slice(0, 3)
        corners, cuts, rows = clip(corners, bound(corners[..., place]))
        parts = parts[rows]
        rims = drop_outside(rims, bound) if len(rims) and not real else rims
        if real:
            rims = np.concatenate([rims, cuts[..., :3]])
    return Mesh(corners, rims, parts)


def join(first: Mesh, *others: Mesh) -> Mesh:
    """Return meshes joined as one, with distinct parts."""
    meshes, parts, free = [first, *others], [first.parts], int(first.parts.max(initial=-1)) + 1
    for other in others:
        parts.append(other.parts + free)
        free += int(other.parts.max(initial=-1)) + 1
    corners = np.concatenate([mesh.corners for mesh in meshes])
    return Mesh(corners, np.concatenate([mesh.rims for mesh in meshes]), np.concatenate(parts))


def room_slack(room: Box) -> float:
    """Return the distance outside of a room that rounding gives and no picture shows, m."""
    return 1e-9 * float((room[1] - room[0]).max())


def walls(room: Box) -> list[Bound]:
    """Return the bounds of a room."""
    (low, high), slack = room, room_slack(room)

    def wall(axis: int, way: int) -> Bound:
        at = high[axis] if way > 0 else -low[axis]
        return lambda points: way * points[..., axis] - at - slack

    return [wall(axis, way) for axis in range(3) for way in (-1, 1)]


def drop_outside(segments: Floats, *bounds: Bound) -> Floats:
    """Return the segments (k, 2, 3) whose two ends are within bounds."""
    for bound in bounds:
        segments = segments[(bound(segments) <= 0.0).all(axis=1)]
    return segments


def grid(points: Floats, around: tuple[bool, bool]) -> Floats:
    """Return the triangles of a grid of rows (n, m, c), closed along either index.

    Parameters
    ----------
    points
        Points in rows, (n, m, c).
    around
        Along which of the two indices the grid is closed.
    """
    n, m = points.shape[:2]
    rows = np.arange(n if around[0] else n - 1)
    columns = np.arange(m if around[1] else m - 1)
    i, j = (index.ravel() for index in np.meshgrid(rows, columns, indexing="ij"))
    a, b = points[i, j], points[(i + 1) % n, j]
    c, d = points[(i + 1) % n, (j + 1) % m], points[i, (j + 1) % m]
    # By turns, so that those of one cell follow each other.
    both = np.stack([np.stack([a, b, c], 1), np.stack([a, c, d], 1)], 1)
    return both.reshape(-1, 3, points.shape[2])


def flat(axis: int, way: int, at: float, room: Box, ball: float, bounds: Sequence[Bound]) -> Mesh:
    """Return a plane in a room, finer at cuts of bounds; two triangles without bounds.

    Parameters
    ----------
    axis
        The axis of the normal, 0 to 2.
    way
        1 or -1: the direction of the normal along it.
    at
        The plane's coordinate along the axis, m.
    room
        The lowest and the highest corner.
    ball
        The ball's radius, m.
    bounds
        Functions of the ball's centre (..., 3), at most 0 on the surface.
    """
    across = [k for k in range(3) if k != axis]
    low, high = room[0][across], room[1][across]
    count = _PATCH_CELLS if bounds else 1
    size = (high - low) / count
    k = np.stack(np.meshgrid(*[np.arange(count)] * 2, indexing="ij"), -1).reshape(-1, 2)
    cells, found = low + k * size, []
    for finer in range(_MAX_HALVINGS + 1):
        quad = _quad(cells, size, axis, way, at, ball)
        if not bounds:
            found.append(quad)
            break
        # Refined where a bound may be crossed: looked at on a grid, which misses what is smaller.
        inner = _samples(quad)
        values = np.stack([bound(inner) for bound in bounds])
        out = (values > 0.0).all(axis=2).any(axis=0)
        whole = (values <= 0.0).all(axis=(0, 2))
        found.append(quad[whole])
        rest = ~out & ~whole
        if finer == _MAX_HALVINGS:
            found.append(quad[rest])
            break
        size = size / 2.0
        steps = np.array([[0, 0], [1, 0], [0, 1], [1, 1]])
        cells = (cells[rest][:, None] + steps * size).reshape(-1, 2)
    quads = np.concatenate(found)
    a, b, c, d = np.moveaxis(quads, 1, 0)
    corners = np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)])
    return cut(Mesh.from_corners(corners), bounds)


def _samples(quads: Floats) -> Floats:
    """Return sample points of quads, (n, k, 3), as places of the ball's centre."""
    steps = np.linspace(0.0, 1.0, 9)
    u, v = (side.ravel() for side in np.meshgrid(steps, steps))
    a, b, _, d = np.moveaxis(quads[..., 3:], 1, 0)
    return np.asarray(a[:, None] + u[:, None] * (b - a)[:, None] + v[:, None] * (d - a)[:, None])


def _quad(cells: Floats, size: Floats, axis: int, way: int, at: float, ball: float) -> Floats:
    steps = np.array([[0, 0], [1, 0], [1, 1], [0, 1]])
    if (way > 0) == (axis == 1):  # the other two coordinates are a left-handed pair for y
        steps = steps[::-1]
    flat = cells[:, None] + steps * size
    points = np.insert(flat, axis, at, axis=-1)
    centres = np.insert(flat, axis, at + way * ball, axis=-1)
    return np.concatenate([points, centres], -1)


def contact_mesh(points: Floats, normals: Floats, ball: float) -> Floats:
    """Return points of a surface with the centres of the ball that touches there.

    Parameters
    ----------
    points
        Points of the surface, (..., 3).
    normals
        Normals there, (..., 3).
    ball
        The ball's radius, m.
    """
    return np.concatenate([points, points + ball * normals], -1)


def level_set(condition: Bound, gradient: Bound, room: Box, ball: float) -> Mesh:
    """Return the surface that a ball touches whose centre is at the zero of a condition.

    The room is cut into cells, and these into tetrahedra, on each of which the condition is as if
    it were flat.

    Parameters
    ----------
    condition
        The function of the ball's centre that is zero at contact.
    gradient
        Its gradient.
    room, ball
        As for `flat`.
    """
    low, high = room[0] - ball, room[1] + ball
    step = float((high - low).max()) / _ROOM_CELLS
    counts = np.ceil((high - low) / step).astype(int) + 1
    axes = [low[k] + step * np.arange(counts[k]) for k in range(3)]
    points = np.stack(np.meshgrid(*axes, indexing="ij"), -1)
    values = condition(points)
    corner = np.array(list(product((0, 1), repeat=3)))
    shifted = [
        tuple(slice(o, counts[k] - 1 + o) for k, o in enumerate(offset)) for offset in corner
    ]
    at = np.stack([points[s] for s in shifted], -2).reshape(-1, 8, 3)
    own = np.stack([values[s] for s in shifted], -1).reshape(-1, 8)
    mixed = (own > 0.0).any(axis=1) & (own <= 0.0).any(axis=1)
    # Six tetrahedra round the diagonal from the first corner to the last.
    paths = [(0, 4, 6, 7), (0, 6, 2, 7), (0, 2, 3, 7), (0, 3, 1, 7), (0, 1, 5, 7), (0, 5, 4, 7)]
    tetrahedra = at[mixed][:, paths].reshape(-1, 4, 3)
    corners = _slices(tetrahedra, own[mixed][:, paths].reshape(-1, 4))
    slope = gradient(corners)
    unit = slope / np.maximum(np.linalg.norm(slope, axis=-1, keepdims=True), 1e-300)
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    away = np.einsum("ij,ij->i", across, unit.mean(axis=1)) < 0.0
    corners[away], unit[away] = corners[away][:, ::-1], unit[away][:, ::-1]
    touched = np.concatenate([corners - ball * unit, corners], -1)
    blocks = np.floor((corners.mean(axis=1) - low) / (5.0 * step)).astype(np.int64)
    return Mesh.from_corners(touched, blocks @ (1, 64, 4096))


_CUT_EDGES = {
    1: ((0, 1), (0, 2), (0, 3)),
    2: ((0, 2), (0, 3), (1, 3), (1, 2)),
    3: ((0, 3), (1, 3), (2, 3)),
}
"""Edges of a tetrahedron from corners inside to corners outside, by the number of those inside."""


def _slices(corners: Floats, values: Floats) -> Floats:
    """Return the triangles (k, 3, 3) in which the zero of values cuts tetrahedra."""
    order = np.argsort(values > 0.0, axis=1, kind="stable")
    corners = np.take_along_axis(corners, order[..., None], 1)
    values = np.take_along_axis(values, order, 1)
    count = (values <= 0.0).sum(axis=1)
    found = []
    for many, edges in _CUT_EDGES.items():
        own, value = corners[count == many], values[count == many]
        cuts = [_cut(own[:, i], own[:, o], value[:, i], value[:, o]) for i, o in edges]
        found.append(np.stack(cuts[:3], 1))
        if many == 2:
            found.append(np.stack([cuts[0], cuts[2], cuts[3]], 1))
    return np.concatenate(found)
