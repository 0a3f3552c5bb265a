"""Lines of meshes: segments chained to lines, and the borders of triangles."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from .meshes import Floats


def chains(segments: Floats) -> list[Floats]:
    """Return segments (k, 2, c) chained to lines (n, c) as long as possible."""
    rows, index = np.unique(segments.reshape(-1, segments.shape[2]), axis=0, return_inverse=True)
    near: dict[int, set[int]] = {}
    for a, b in index.reshape(-1, 2).tolist():
        if a != b:
            near.setdefault(a, set()).add(b)
            near.setdefault(b, set()).add(a)
    found = []
    # Those that end somewhere first, from there; then those that are closed.
    for start in sorted(near, key=lambda row: (len(near[row]) % 2 == 0, row)):
        while near[start]:
            line = [start]
            while near[line[-1]]:
                following = min(near[line[-1]])
                near[line[-1]].remove(following)
                near[following].remove(line[-1])
                line.append(following)
            found.append(rows[line])
    return found


_DIGITS = 12
"""Digits in which corners are equal that triangles share, of the largest number."""

_SPLIT_AT_ONCE = 64
"""Edges at a time, for the memory."""

_ON_EDGE = 1e-9
"""Share of the length of an edge up to which a point lies on it."""


def loops(corners: Floats) -> list[Floats]:
    """Return the closed borders of triangles, (k, c) each.

    Shared corners are equal in their first digits. A corner of finer triangles may lie on the edge
    of a coarser one.
    """
    if not len(corners):
        return []
    points = corners.reshape(-1, corners.shape[2])
    digits = _DIGITS - int(np.ceil(np.log10(np.abs(points).max() + np.finfo(float).tiny)))
    alike = np.round(points, digits)
    _, first, index = np.unique(alike, axis=0, return_index=True, return_inverse=True)
    rows, triangles = points[first], index.reshape(-1, 3)
    # One that is a line has an edge both ways, as if the triangle beside it had a neighbour there.
    triangles = triangles[(triangles != triangles[:, [1, 2, 0]]).all(axis=1)]
    starts, stops = triangles.ravel(), triangles[:, [1, 2, 0]].ravel()
    edges = set(zip(starts.tolist(), stops.tolist(), strict=True))
    alone = sorted((start, stop) for start, stop in edges if (stop, start) not in edges)
    edges = _split(rows, np.array(alone, np.intp).reshape(-1, 2))
    after: dict[int, list[int]] = {}
    for start, stop in sorted(edges):
        if (stop, start) not in edges:
            after.setdefault(start, []).append(stop)
    found = []
    while after:
        start = next(iter(after))
        line = [start]
        while line[-1] in after:
            following = after[line[-1]]
            line.append(following.pop())
            if not following:
                del after[line[-2]]
        found.append(rows[line])
    return found


def _split(rows: Floats, edges: NDArray[np.intp]) -> set[tuple[int, int]]:
    """Return edges (k, 2) between rows of points, divided where the end of another lies on one."""
    ends, found = np.unique(edges), set[tuple[int, int]]()
    for some in np.array_split(edges, len(edges) // _SPLIT_AT_ONCE + 1):
        along = rows[some[:, 1]] - rows[some[:, 0]]
        off = rows[ends] - rows[some[:, 0], None]
        squared = (along**2).sum(axis=1)[:, None]
        share = (off * along[:, None]).sum(axis=2) / squared
        aside = ((off - share[..., None] * along[:, None]) ** 2).sum(axis=2)
        within = (share > _ON_EDGE) & (share < 1.0 - _ON_EDGE) & (aside < _ON_EDGE**2 * squared)
        for (start, stop), shares, there in zip(some.tolist(), share, within, strict=True):
            middle = ends[there][np.argsort(shares[there])].tolist()
            found |= set(pairwise([start, *middle, stop]))
    return found
