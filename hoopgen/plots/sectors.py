"""Shares of rebounds by direction, on the floor plan as the shooter sees it."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patheffects import withStroke
from numpy.typing import NDArray

from hoopgen.core.units import display_unit
from hoopgen.study.measures.rebounds import SECTORS, check_height, directions, sector
from hoopgen.text.numbers import format_percent

from .floor_plan import on_floor
from .style import DARK, INK
from .views import Points

_LINE_LENGTH, _LABEL_DISTANCE = 1.1, 1.22
"""Ends of the lines between sectors, and places of the shares, in radii of the largest circle."""

_BORDER_MARGIN = 0.05
"""Least distance of a sector's share from the border of the view, as a part of the view."""


def at_height(height: float | None, *, sectors: bool) -> str:
    """Describe the height of the balls and the sectors; "" for balls on the floor.

    Parameters
    ----------
    height
        The height above the floor, m; None for the floor.
    sectors
        True if shares of sectors are drawn.

    Raises
    ------
    TypeError, ValueError
        If it is no height above the floor.
    """
    if height is None:
        return ""
    unit = display_unit("length")
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
        ends = np.outer([0.0, _LINE_LENGTH * radius], [np.cos(edge), np.sin(edge)])
        axes.plot(*on_floor(*ends.T).T, color=DARK, lw=0.5, ls=(0, (1, 2)), label="_sector")
        share = float(np.mean(there == number))
        (where,) = _LABEL_DISTANCE * radius * on_floor([np.cos(at)], [np.sin(at)])
        axes.text(
            *_inside(axes, where),
            format_percent(share, 0),
            ha="center",
            va="center",
            fontsize=8.0,
            fontweight="bold",
            color=INK,
            path_effects=[withStroke(linewidth=2.5, foreground="white")],
            clip_on=True,
        )


def _inside(axes: Axes, where: NDArray[np.float64]) -> tuple[float, float]:
    """Return the nearest place towards the ring that is well inside the view."""
    nearer = 1.0
    for at, (low, high) in zip(where.tolist(), (axes.get_xlim(), axes.get_ylim()), strict=True):
        margin = _BORDER_MARGIN * (high - low)
        end = high - margin if at > 0.0 else low + margin
        # Where the ring itself is at the border, there is no better place.
        nearer = min(nearer, max(end / at, 0.0)) if abs(at) > abs(end) else nearer
    x, y = (nearer * where).tolist()
    return x, y
