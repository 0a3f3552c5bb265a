"""The lines of the court around a basket, on the floor plan, in metres from the ring's centre."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import ArrayLike, NDArray

from hoopgen.brief import brief
from hoopgen.plots.page import add_view
from hoopgen.plots.panels import Panel
from hoopgen.plots.scene import draw_hoop
from hoopgen.plots.ticks import number
from hoopgen.plots.views import View
from hoopgen.units import FOOT, shown

__all__ = ["COURTS", "FLOOR", "Court", "add_floor", "draw_floor", "find_court", "on_floor"]

FLOOR = View("floor plan", (0.0, 1.0, 0.0), (-1.0, 0.0, 0.0), ("y", "x"))
"""As the shooter sees it: the board at the top, +y to the right."""


_LINES = "#BFBFBF"


@dataclass(frozen=True)
class Court:
    """Measures of a court, m.

    Attributes
    ----------
    baseline
        Behind the board's front.
    free_throw
        The free-throw line, in front of the board's front.
    lane
        Width of the lane.
    circle
        Radius of the free-throw circle.
    arc
        Radius of the three-point arc, about the ring's centre.
    corner
        From the middle of the court to the three-point line in the corners.
    """

    baseline: float
    free_throw: float
    lane: float
    circle: float
    arc: float
    corner: float


COURTS: Mapping[str, Court] = MappingProxyType(
    {
        # NBA Rule Book, rule 1.
        "NBA": Court(4 * FOOT, 15 * FOOT, 16 * FOOT, 6 * FOOT, 23.75 * FOOT, 22 * FOOT),
        # FIBA Official Basketball Rules, article 2, and Equipment.
        "FIBA": Court(1.2, 4.6, 4.9, 1.8, 6.75, 6.6),
    }
)
"""Courts of the rule books."""


def find_court(name: str) -> Court:
    """Return a court by name.

    Raises
    ------
    ValueError
        If there is none.
    """
    if name not in COURTS:
        raise ValueError(f"court: expected {' or '.join(COURTS)}, got {brief(name)}")
    return COURTS[name]


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


def draw_floor(axes: Axes, panel: Panel, court: Court, parameters: Mapping[str, float]) -> None:
    """Draw a floor plan on axes that show it."""
    metres = shown("length").size
    axes.yaxis.set_major_formatter(lambda value, _: number(-value / metres))
    front, half = -parameters["board_distance"], court.lane / 2.0
    baseline, line = front - court.baseline, front + court.free_throw
    lane = [(baseline, -half), (line, -half), (line, half), (baseline, half)]
    turn = np.arccos(min(1.0, court.corner / court.arc))
    arc = court.arc * _circle(turn - np.pi / 2.0, np.pi / 2.0 - turn)
    three = [(baseline, -court.corner), *arc, (baseline, court.corner)]
    circle = court.circle * _circle(0.0, 2.0 * np.pi) + (line, 0.0)
    side = 1.2 * court.corner
    for points in (lane, three, circle, [(baseline, -side), (baseline, side)]):
        flat = on_floor(*np.transpose(points))
        axes.plot(*flat.T, color=_LINES, lw=0.8, zorder=1.0, label="_court")
    draw_hoop(axes, FLOOR, parameters, panel.scale)


def on_floor(x: ArrayLike, y: ArrayLike) -> NDArray[np.float64]:
    """Return places on the court, (n,) both, as points of the floor plan, (n, 2)."""
    places = np.stack([np.asarray(x), np.asarray(y), np.zeros_like(x)], axis=-1)
    return FLOOR.flatten(places)


def _circle(start: float, stop: float) -> NDArray[np.float64]:
    """Return points on the unit circle, (n, 2)."""
    turn = np.linspace(start, stop, 181)
    return np.stack([np.cos(turn), np.sin(turn)], axis=1)
