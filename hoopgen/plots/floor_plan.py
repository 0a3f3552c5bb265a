"""Floor plans: the court's lines around a basket, in metres from the ring's centre."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patheffects import withStroke
from numpy.typing import ArrayLike, NDArray

from hoopgen.core.units import display_unit
from hoopgen.hoop.court_lines import Court, lines_of

from .hoop import draw_hoop
from .page import add_view
from .style import COLOURS, DARK
from .ticks import number
from .views import Panel, View

FLOOR = View("floor plan", (0.0, 1.0, 0.0), (-1.0, 0.0, 0.0), ("y", "x"))
"""The shooter's view: the board at the top, +y to the right."""


_LINES = "#BFBFBF"
_DASHES = (0, (4, 3))
_WIDE_LINE = 2.7  # points of a line over colours, where a metre is an inch


def add_floor(figure: Figure, panel: Panel, court: Court, parameters: Mapping[str, float]) -> Axes:
    """Return axes of a floor plan with lane, free-throw circle, three-point line and hoop.

    Points are drawn on it as `FLOOR` flattens them.

    Parameters
    ----------
    figure
        The page.
    panel
        The place on the page; its view is `FLOOR`.
    court
        Its measures.
    parameters
        Of the scene.
    """
    axes = add_view(figure, panel)
    draw_floor(axes, panel, court, parameters)
    return axes


def draw_floor(
    axes: Axes,
    panel: Panel,
    court: Court,
    parameters: Mapping[str, float],
    *,
    over: bool = False,
) -> None:
    """Draw a floor plan on axes that show it, with dark lines if it lies over colours.

    Parameters
    ----------
    axes
        The axes.
    panel
        Their view and scale.
    court
        The court whose lines are drawn.
    parameters
        The hoop's parameters.
    over
        True if the plan lies over colours.
    """
    metres = display_unit("length").size
    axes.yaxis.set_major_formatter(lambda value, _: number(-value / metres))
    lines = lines_of(court, parameters["board_distance"])
    look: dict[str, Any] = {"color": _LINES, "lw": 0.8}
    if over:
        wide = min(0.9, _WIDE_LINE * panel.scale)
        stroke = withStroke(linewidth=2.7 * wide, foreground=COLOURS["paper"])
        look = {"color": DARK, "lw": wide, "path_effects": [stroke]}
    for name, points in lines.items():
        look["ls"] = _DASHES if name == "inside" else "-"
        axes.plot(*on_floor(*points.T).T, zorder=1.0, label=f"_court {name}", **look)
    draw_hoop(axes, FLOOR, parameters, panel.scale)


def on_floor(x: ArrayLike, y: ArrayLike) -> NDArray[np.float64]:
    """Return places on the court, (n,) both, as points of the floor plan, (n, 2).

    Parameters
    ----------
    x, y
        Coordinates of the scene, m.
    """
    places = np.stack([np.asarray(x), np.asarray(y), np.zeros_like(x)], axis=-1)
    return FLOOR.flatten(places)
