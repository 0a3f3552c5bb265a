"""Smooth, labelled contours of shares, within the intervals of the cells.

What is drawn through is a smooth surface: at a cell it is within the cell's interval, between two
cells within what their intervals span. Where no interval is known it goes through the cells.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

import numpy as np
from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.colors import Normalize
from matplotlib.contour import QuadContourSet
from matplotlib.path import Path
from numpy.typing import NDArray

from hoopgen.text.numbers import format_percent

from .style import COLOURS, DARK, SHARE_COLOURS

Numbers = NDArray[np.float64]

MIN_CELLS = 12
"""Cells along an axis, below which nothing is known of how a line runs between them."""

_LIGHT = COLOURS["paper"]
_MAX_BLURS = 12  # a blur of 2.4 cells, where intervals allow it
_FINE_POINTS = 240  # points along an axis
_MIN_CONTOUR_CELLS = 6  # cells: a contour that is not drawn

# Of the width or height of all cells.
_LABEL_EDGE = 0.07  # where contours are not labelled
_LABEL_DISTANCE = 0.11  # between labels, at least
_MIN_LABELLED_LENGTH = 0.15  # a contour without label


def draw_contours(
    axes: Axes,
    across: Numbers,
    up: Numbers,
    shares: Numbers,
    interval: tuple[Numbers, Numbers] | None,
    levels: Sequence[float],
    norm: Normalize,
) -> None:
    """Draw and label contours, each in the colour that stands out on its own.

    Of a grid of fewer than `MIN_CELLS` cells along an axis there are none.

    Parameters
    ----------
    axes
        Where; the cells are drawn there.
    across, up
        Middles of the cells, (n,) and (m,).
    shares, interval
        Of the cells, (n, m), NaN where there is none; and its ends, if they are known.
    levels
        Of the contours.
    norm
        Of the colours of the cells.
    """
    if min(shares.shape) < MIN_CELLS or not levels:
        return
    there = np.isfinite(shares)
    low, high = (shares, shares) if interval is None else interval
    shares, low, high = map(_fill_gaps, (smooth(shares, low, high), low, high))
    xs, *fine = refine(across, shares, low, high)
    ys, surface, *_ = refine(up, *(one.T for one in fine))
    whole = there[:-1, :-1] & there[1:, :-1] & there[:-1, 1:] & there[1:, 1:]
    known = whole[np.ix_(_between(xs, across), _between(ys, up))]
    colours = [
        DARK if _lightness(colormaps[SHARE_COLOURS](norm(level))) > 0.5 else _LIGHT
        for level in levels
    ]
    surface = np.where(known.T, surface, np.nan)
    lines = axes.contour(xs, ys, surface, levels, colors=colours, linewidths=0.6)
    cell = np.array([np.ptp(across) / (len(across) - 1), np.ptp(up) / (len(up) - 1)])
    lines.set_paths([_drop_small(path, _MIN_CONTOUR_CELLS * cell) for path in lines.get_paths()])
    said = partial(format_percent, digits=None)
    axes.clabel(lines, fmt=said, fontsize=6.5, inline_spacing=2, manual=_labels(lines, across, up))


def smooth(shares: Numbers, low: Numbers, high: Numbers) -> Numbers:
    """Return a smooth surface within the interval of each cell; NaN if the cell is NaN.

    Parameters
    ----------
    shares
        The shares of the cells, (n, m).
    low, high
        The ends of their intervals, of the same shape.
    """
    for _ in range(_MAX_BLURS):
        shares = np.clip(_blur(_blur(shares).T).T, low, high)
    return shares


def _blur(values: Numbers) -> Numbers:
    """Return means of three neighbours along the first axis, with weights 1, 2 and 1."""
    weights = np.isfinite(values).astype(np.float64)
    sums = [np.pad(one, ((1, 1), (0, 0))) for one in (np.nan_to_num(values), weights)]
    total, weight = (one[:-2] + 2.0 * one[1:-1] + one[2:] for one in sums)
    found = total / np.maximum(weight, 1.0)
    return np.where(np.isfinite(values), found, np.nan)


def _fill_gaps(values: Numbers) -> Numbers:
    """Fill gaps along a line with the value of the nearest cell."""
    filled = values.copy()
    for _ in range(2):
        for row in filled:
            there = np.flatnonzero(np.isfinite(row))
            if there.size:
                row[:] = np.interp(np.arange(len(row)), there, row[there])
        filled = filled.T
    return np.nan_to_num(filled)


def refine(at: Numbers, values: Numbers, low: Numbers, high: Numbers) -> tuple[Numbers, ...]:
    """Return finer places, with the values and their bounds interpolated there.

    Parameters
    ----------
    at
        In order, (n,).
    values, low, high
        There, (n, m) each.
    """
    count = -(-_FINE_POINTS // (len(at) - 1))
    share = np.linspace(0.0, 1.0, count, endpoint=False)[:, np.newaxis]
    wide = np.diff(at)[:, np.newaxis, np.newaxis]
    start, stop = values[:-1, np.newaxis], values[1:, np.newaxis]
    slopes = np.gradient(values, at, axis=0)[:, np.newaxis]
    cubic = (
        start * (1.0 + 2.0 * share) * (1.0 - share) ** 2
        + stop * (3.0 - 2.0 * share) * share**2
        + wide * share * (1.0 - share) * (slopes[:-1] * (1.0 - share) - slopes[1:] * share)
    )
    least, most = np.minimum(low[:-1], low[1:]), np.maximum(high[:-1], high[1:])
    within = np.clip(cubic, least[:, np.newaxis], most[:, np.newaxis])
    inside = (within.reshape(-1, values.shape[1]), *(np.repeat(e, count, 0) for e in (least, most)))
    places = (at[:-1, np.newaxis] + wide[:, 0] * share[:, 0]).ravel()
    ends = (values, low, high)
    joined = (np.concatenate([one, end[-1:]]) for one, end in zip(inside, ends, strict=True))
    return np.append(places, at[-1]), *joined


def _between(fine: Numbers, at: Numbers) -> NDArray[np.intp]:
    """Return the indices of the two places between which each finer one lies."""
    order = 1.0 if at[-1] > at[0] else -1.0
    found = np.searchsorted(order * at, order * fine, side="right") - 1
    return np.clip(found, 0, len(at) - 2)


def _drop_small(path: Path, least: Numbers) -> Path:
    """Return the contours without those that enclose only a few cells."""
    kept = [line for line in _lines(path) if (np.ptp(line, axis=0) >= least).any()]
    return Path.make_compound_path(*map(Path, kept))


def _lines(path: Path) -> list[Numbers]:
    """Return the contours of a level, (n, 2) each, with all of their points."""
    points = np.asarray(path.vertices)
    if path.codes is None:
        return [points] if len(points) else []
    return np.split(points, np.flatnonzero(path.codes == Path.MOVETO)[1:])


def _labels(lines: QuadContourSet, across: Numbers, up: Numbers) -> list[tuple[float, float]]:
    """Choose a place for the label of each contour: near its middle, off edges and other labels."""
    low = np.array([across.min(), up.min()])
    size = np.array([np.ptp(across), np.ptp(up)])
    chosen: list[tuple[float, float]] = []
    taken = np.empty((0, 2))
    for path in lines.get_paths():
        for contour in _lines(path):
            at = (contour - low) / size
            if np.ptp(at, axis=0).max() < _MIN_LABELLED_LENGTH:
                continue
            apart = np.linalg.norm(at[:, None] - taken, axis=2).min(axis=1, initial=np.inf)
            free = np.flatnonzero(
                (np.abs(at - 0.5).max(axis=1) < 0.5 - _LABEL_EDGE) & (apart > _LABEL_DISTANCE)
            )
            if free.size:
                best = free[np.argmin(np.abs(free - len(at) / 2.0))]
                chosen.append((float(contour[best][0]), float(contour[best][1])))
                taken = np.vstack([taken, at[best]])
    return chosen


def _lightness(colour: tuple[float, float, float, float]) -> float:
    """Return the approximate lightness of a colour, 0 to 1."""
    return float(np.dot([0.2126, 0.7152, 0.0722], colour[:3]))
