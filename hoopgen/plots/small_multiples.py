"""Small multiples: groups of paths, and the grid of their panels on a page."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from hoopgen.text.shorten import brief

from .page import add_view
from .style import NARROW_PAGE, NOTE_SIZE
from .ticks import few_ticks
from .views import Limits, Panel, View

BELOW_GRID = 0.46
"""Inches below a grid, for numbers and a name."""


_MAX_PATHS = 40
"""Paths: more of them in one panel hide one another."""

_TITLE, _GAP = 0.26, 0.14  # inches, above a panel and beside it
_STEPS = MaxNLocator(nbins=5, steps=[1, 2, 5, 10])


@dataclass(frozen=True)
class Group:
    """Paths that share a panel: their common name, and their indices."""

    name: str
    members: list[int]

    @property
    def title(self) -> str:
        """The name of the group and the number of its paths."""
        return f"{self.name} ({len(self.members):,})"


def check_grouping(by: str, allowed: Sequence[str], paths: int, kinds: int, usual: str) -> str:
    """Return the grouping of paths: the given one, or one that suits their number and kinds.

    Parameters
    ----------
    by
        The given grouping.
    allowed
        The groupings that there are.
    paths
        The number of paths.
    kinds
        The number of kinds among them.
    usual
        The grouping for many paths.

    Raises
    ------
    ValueError
        If it is none of "auto" and what is allowed.
    """
    if by not in ("auto", *allowed):
        raise ValueError(f"by: expected auto, {', '.join(allowed)}; got {brief(by)}")
    if by == "auto":
        return usual if paths > _MAX_PATHS and kinds > 1 else "all"
    return by


def describe_grouping(by: str) -> str:
    """Describe how paths are grouped into panels, "" if they are not."""
    how = "release angle" if by == "elevation" else by
    return "" if by == "all" else f", by {how} (how many of each)"


def group_by_name(names: Sequence[str], order: Sequence[str]) -> list[Group]:
    """Group paths by name, in a given order.

    Parameters
    ----------
    names
        The name of each path.
    order
        The names in the order of the groups.
    """
    there = [name for name in order if name in names]
    return [Group(one, [k for k, name in enumerate(names) if name == one]) for one in there]


def group_by_angle(angles: Sequence[float]) -> list[Group]:
    """Group paths by release angle, degrees, at round numbers."""
    edges = _STEPS.tick_values(min(angles), max(angles))
    within = np.clip(np.searchsorted(edges, angles, side="right"), 1, len(edges) - 1)
    return [
        Group(
            f"{edges[k - 1]:g}\N{DEGREE SIGN} to {edges[k]:g}\N{DEGREE SIGN}",
            np.flatnonzero(within == k).tolist(),
        )
        for k in np.unique(within).tolist()
    ]


@dataclass(frozen=True)
class Grid:
    """Panels of one view, all equal, in rows from the top."""

    panels: list[Panel]
    columns: int
    head: float  # inches above a panel, for its title

    @property
    def top(self) -> float:
        """The top of the grid with its titles, inches from the bottom of the page."""
        return self.panels[0].top + self.head

    @property
    def right(self) -> float:
        """The right edge of the grid, inches from the left of the page."""
        return max(panel.left + panel.width for panel in self.panels)


def lay_grid(
    count: int,
    view: View,
    limits: Limits,
    place: tuple[float, float, float],
    page: float,
    tallest: float,
    *,
    head: float = _TITLE,
    most: int = 3,
) -> Grid:
    """Lay out a number of equal panels.

    Parameters
    ----------
    count
        How many.
    view, limits
        Of each.
    place
        Left, bottom and width, inches; the panels' numbers are further left and below.
    page
        Width of the page, inches: on a narrow one there are two in a row, else `most`.
    tallest
        Of a panel, inches.
    head
        The room above a panel for its title, inches.
    most
        The panels in a row.
    """
    left, bottom, width = place
    columns = min(count, 2 if page < NARROW_PAGE else most)
    rows = -(-count // columns)
    across = (width - (columns - 1) * _GAP) / columns
    one = Panel.fitted(view, limits, left, bottom, across, tallest)
    step = one.width + _GAP, one.height + head
    panels = [
        replace(one, left=left + column * step[0], bottom=bottom + (rows - 1 - row) * step[1])
        for row, column in (divmod(number, columns) for number in range(count))
    ]
    return Grid(panels, columns, head)


def draw_grid(figure: Figure, grid: Grid, titles: Sequence[str]) -> list[Axes]:
    """Return the axes of a grid, with titles on all, and numbers and names at its edges.

    Parameters
    ----------
    figure
        The page.
    grid
        The layout.
    titles
        The titles of the panels.
    """
    places: list[Axes] = []
    width, height = figure.get_size_inches()
    below = ""
    for number, (panel, title) in enumerate(zip(grid.panels, titles, strict=True)):
        axes = add_view(figure, panel)
        axes.set_title(title, loc="left", fontsize=NOTE_SIZE, pad=3.0)
        if len(titles) > 1:
            below = axes.get_xlabel()
            axes.set_xlabel("")
            few_ticks(axes)
        if number % grid.columns:
            axes.set_ylabel("")
            axes.tick_params(labelleft=False)
        if number + grid.columns < len(titles):
            axes.tick_params(labelbottom=False)
        places.append(axes)
    first, last = grid.panels[0], grid.panels[min(grid.columns, len(grid.panels)) - 1]
    middle = (first.left + last.left + last.width) / 2.0
    low = grid.panels[-1].bottom - BELOW_GRID + 0.09
    figure.text(middle / width, low / height, below, ha="center", va="center", fontsize=8.5)
    return places
