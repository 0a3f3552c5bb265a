"""Where rebounds go: directions as the shooter sees them, on the floor plan, and their shares."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patheffects import withStroke
from numpy.typing import NDArray

from hoopgen.phrases import percent
from hoopgen.plots.court import on_floor
from hoopgen.plots.style import DARK, INK
from hoopgen.plots.views import Points
from hoopgen.study.rebounds import SECTORS, check_height, directions, sector
from hoopgen.units import shown

__all__ = ["at_height", "draw_sectors"]

_REACH, _WRITTEN = 1.1, 1.22
"""Of lines between sectors and of their shares: in radii of the circle that holds most balls."""

_INSIDE = 0.05
"""Of the view: shares that would be outside stand so far from its border."""


def at_height(height: float | None, *, sectors: bool) -> str:
    """Say at which height balls are, and what is written of sectors; nothing of balls on the floor.

    Raises
    ------
    TypeError, ValueError
        If it is no height above the floor.
    """
    if height is None:
        return ""
    unit = shown("length")
    said = f"{check_height(height) / unit.size:.{unit.decimals}f}".rstrip("0").rstrip(".")
    bold = "; in bold, shares of the directions as the shooter sees them" if sectors else ""
    return f" at {said} {unit.symbol} above the floor{bold}"


def draw_sectors(axes: Axes, points: Points, place: tuple[float, float], radius: float) -> None:
    """Draw lines between the sectors around the ring, and write the share of the balls in each.

    Parameters
    ----------
    axes
        A floor plan.
    points
        The balls, (n, 2), m.
    place
        From where they are seen.
    radius
        Of the circle that holds most of them, m.
    """
    there = sector(directions(points, place))
    ahead = np.arctan2(place[1], place[0])  # back to the shooter
    half = np.pi / len(SECTORS)
    for number, middle in enumerate(SECTORS.values()):
        # To the shooter's left is around the ring against its angle.
        edge, at = ahead - middle - half, ahead - middle
        ends = np.outer([0.0, _REACH * radius], [np.cos(edge), np.sin(edge)])
        axes.plot(*on_floor(*ends.T).T, color=DARK, lw=0.5, ls=(0, (1, 2)), label="_sector")
        share = float(np.mean(there == number))
        (where,) = _WRITTEN * radius * on_floor([np.cos(at)], [np.sin(at)])
        axes.text(
            *_inside(axes, where),
            percent(share, 0),
            ha="center",
            va="center",
            fontsize=8.0,
            fontweight="bold",
            color=INK,
            path_effects=[withStroke(linewidth=2.5, foreground="white")],
            clip_on=True,
        )


def _inside(axes: Axes, where: NDArray[np.float64]) -> tuple[float, float]:
    """Return the nearest place on the way to the ring that is well inside the view."""
    nearer = 1.0
    for at, (low, high) in zip(where.tolist(), (axes.get_xlim(), axes.get_ylim()), strict=True):
        margin = _INSIDE * (high - low)
        end = high - margin if at > 0.0 else low + margin
        # Where the ring itself is at the border, there is no better place.
        nearer = min(nearer, max(end / at, 0.0)) if abs(at) > abs(end) else nearer
    x, y = (nearer * where).tolist()
    return x, y
