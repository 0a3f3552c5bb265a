"""Small multiples: which of many paths share a panel, and where such panels stand on a page."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from hoopgen.brief import brief
from hoopgen.plots.page import add_view
from hoopgen.plots.panels import Panel
from hoopgen.plots.style import NARROW, SMALL
from hoopgen.plots.ticks import few_ticks
from hoopgen.plots.views import Limits, View

__all__ = [
    "BELOW",
    "Group",
    "Grid",
    "by_angle",
    "by_name",
    "check_by",
    "draw_grid",
    "lay_grid",
    "say_by",
]

BELOW = 0.46
"""Inches below a grid, for numbers and a name."""


_CROWDED = 40
"""Paths: more of them in one panel hide one another."""

_TITLE, _GAP = 0.26, 0.14  # inches, above a panel and beside it
_STEPS = MaxNLocator(nbins=5, steps=[1, 2, 5, 10])


@dataclass(frozen=True)
class Group:
    """Paths that share a panel: what they have in common, and which of those drawn they are."""

    name: str
    members: list[int]

    @property
    def title(self) -> str:
        """Say what they are, and how many."""
        return f"{self.name} ({len(self.members):,})"


def check_by(by: str, allowed: Sequence[str], paths: int, kinds: int, usual: str) -> str:
    """Return by what paths are parted: as asked for, or what suits so many of so many kinds.

    Raises
    ------
    ValueError
        If it is none of "auto" and what is allowed.
    """
    if by not in ("auto", *allowed):
        raise ValueError(f"by: expected auto, {', '.join(allowed)}; got {brief(by)}")
    if by == "auto":
        return usual if paths > _CROWDED and kinds > 1 else "all"
    return by


def say_by(by: str) -> str:
    """Say by what paths are parted, if they are, after how many are drawn."""
    how = "release angle" if by == "elevation" else by
    return "" if by == "all" else f", by {how} (how many of each)"


def by_name(names: Sequence[str], order: Sequence[str]) -> list[Group]:
    """Part paths by what each is called, in an order."""
    there = [name for name in order if name in names]
    return [Group(one, [k for k, name in enumerate(names) if name == one]) for one in there]


def by_angle(angles: Sequence[float]) -> list[Group]:
    """Part paths by their release angles, degrees, at round ones."""
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

    @property
    def top(self) -> float:
        """Of it, with the titles; inches from the bottom of the page."""
        return self.panels[0].bottom + self.panels[0].height + _TITLE


def lay_grid(
    count: int,
    view: View,
    limits: Limits,
    place: tuple[float, float, float],
    page: float,
    tallest: float,
) -> Grid:
    """Place so many panels.

    Parameters
    ----------
    count
        How many.
    view, limits
        Of each.
    place
        Left, bottom and width, inches; the panels' numbers are further left and below.
    page
        Width of the page, inches: on a narrow one there are two in a row, else three.
    tallest
        Of a panel, inches.
    """
    left, bottom, width = place
    columns = min(count, 2 if page < NARROW else 3)
    rows = -(-count // columns)
    across = (width - (columns - 1) * _GAP) / columns
    scale = min(across / (limits[1] - limits[0]), tallest / (limits[3] - limits[2]))
    one = Panel(view, limits, scale, left, bottom)
    step = one.width + _GAP, one.height + _TITLE
    panels = [
        Panel(view, limits, scale, left + column * step[0], bottom + (rows - 1 - row) * step[1])
        for row, column in (divmod(number, columns) for number in range(count))
    ]
    return Grid(panels, columns)


def draw_grid(figure: Figure, grid: Grid, titles: Sequence[str]) -> list[Axes]:
    """Return the axes of a grid: titles on all, numbers at its edges, the name across once."""
    places: list[Axes] = []
    width, height = figure.get_size_inches()
    below = ""
    for number, (panel, title) in enumerate(zip(grid.panels, titles, strict=True)):
        axes = add_view(figure, panel)
        axes.set_title(title, loc="left", fontsize=SMALL, pad=3.0)
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
    low = grid.panels[-1].bottom - BELOW + 0.09
    figure.text(middle / width, low / height, below, ha="center", va="center", fontsize=8.5)
    return places
