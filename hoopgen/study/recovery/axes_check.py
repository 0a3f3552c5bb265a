"""Tracks that are in other units or axes than they should be, by how they fall and where they are.

Positions in yards look nearly right: the ball falls by 10.7 instead of 9.8. The residuals of all
tracks together say by how much more or less than gravity it falls, with a standard error; if that
is the ratio of a unit of length to the metre, the positions are in it. Heights above the floor look
right everywhere: only the release is as high above the ring as it should be above the floor.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from .estimator import Flags, Floats, Lines
from .frames import Measured

_UNITS: Mapping[str, float] = {"yards": 0.9144, "feet": 0.3048, "inches": 0.0254, "cm": 0.01}
"""Units that positions may be in, and their sizes, m."""

_NEAR = 0.03
"""Relative difference from the ratio of a unit, within which it is named: air changes the fall by a
few percent, yards by nine."""

_SIGMAS = 4.0

_HIGHEST = 0.6
"""m above the ring's plane. The median release is lower: a ball is released below 3.6 m."""


def unit_of(part: Measured, lines: Lines, frames: Flags, fall: Floats) -> str:
    """Return the unit of length that the positions are in by their fall; none for metres.

    Parameters
    ----------
    part, lines, frames
        Tracks, their fitted lines, and the frames of their flights.
    fall
        The acceleration of each, (n, 3), m/s².
    """
    size = np.linalg.norm(fall, axis=1)
    used = np.isfinite(size) & (size > 0.0) & (frames.sum(axis=1) > 3)
    used &= np.isfinite(lines.slope).all(axis=0)
    if not used.any():
        return ""
    rows, some = np.flatnonzero(used), frames[used]
    down = (fall[used] / size[used, None]).T[..., None]
    off = ((part.positions - lines.at(part.times))[:, rows] * down).sum(axis=0)
    count = some.sum(axis=1, keepdims=True)

    def without(values: Floats, shape: Floats) -> Floats:
        """Return values less the multiple of a shape that they contain, by track."""
        part_of = (values * shape * some).sum(axis=1, keepdims=True)
        return np.asarray(
            values - shape * part_of / (shape * shape * some).sum(axis=1, keepdims=True)
        )

    t = part.times[used]
    ones = np.ones_like(t)
    level = t - (t * some).sum(axis=1, keepdims=True) / count
    with np.errstate(invalid="ignore", divide="ignore"):
        bend = without(without(t * t, ones), level)
        rest = without(without(off, ones), level)
    weights = np.where(some & np.isfinite(bend), bend, 0.0)
    rest = np.where(some & np.isfinite(rest), rest, 0.0)
    total = float((weights * weights).sum())
    free = int(some.sum()) - 2 * len(rows) - 1
    if total <= 0.0 or free < 1:
        return ""
    more = float((weights * rest).sum()) / total
    left = np.where(some, rest - more * weights, 0.0)
    error = float(np.sqrt((left * left).sum() / free / total))
    mean = float(size[used].mean())
    ratio, ratio_error = 1.0 + 2.0 * more / mean, 2.0 * error / mean
    if abs(ratio - 1.0) <= _SIGMAS * ratio_error:
        return ""
    for name, length in _UNITS.items():
        if abs(ratio * length - 1.0) <= min(_NEAR, 0.5 * (1.0 / length - 1.0)):
            return name
    return ""


def above_floor(heights: Floats) -> bool:
    """Return whether heights of releases, m above the ring's plane, are above the floor instead."""
    there = heights[np.isfinite(heights)]
    return bool(len(there)) and float(np.median(there)) > _HIGHEST
