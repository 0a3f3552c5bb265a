"""The lines of the court around a basket, on the floor plan, in metres from the ring's centre."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patheffects import withStroke
from numpy.typing import ArrayLike, NDArray

from hoopgen.brief import brief
from hoopgen.hoop.presets import nearest_preset
from hoopgen.plots.page import add_view
from hoopgen.plots.panels import Panel
from hoopgen.plots.scene import draw_hoop
from hoopgen.plots.style import COLOURS, DARK
from hoopgen.plots.ticks import number
from hoopgen.plots.views import View
from hoopgen.units import FOOT, shown

__all__ = [
    "COURTS",
    "FLOOR",
    "Court",
    "add_floor",
    "court_of",
    "draw_floor",
    "find_court",
    "lines_of",
    "on_floor",
]

FLOOR = View("floor plan", (0.0, 1.0, 0.0), (-1.0, 0.0, 0.0), ("y", "x"))
"""As the shooter sees it: the board at the top, +y to the right."""


_LINES = "#BFBFBF"
_DASHES = (0, (4, 3))
_WIDE = 2.7  # points of a line over colours, where a metre is an inch


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
    restricted
        Radius of the arc below the basket within which there is no charge.
    half_width, half_length
        From the middle of the court to a sideline, and from a baseline to the division line.
    whole_circle
        Whether the free-throw circle goes on, dashed, inside the lane.
    """

    baseline: float
    free_throw: float
    lane: float
    circle: float
    arc: float
    corner: float
    restricted: float
    half_width: float
    half_length: float
    whole_circle: bool


COURTS: Mapping[str, Court] = MappingProxyType(
    {
        # NBA Rule Book, rule 1, section I and its diagram: 94 ft by 50 ft, the three-point line
        # 3 ft from the sidelines and 23 ft 9 in from the middle of the basket.
        "NBA": Court(
            baseline=4 * FOOT,
            free_throw=15 * FOOT,
            lane=16 * FOOT,
            circle=6 * FOOT,
            arc=23.75 * FOOT,
            corner=22 * FOOT,
            restricted=4 * FOOT,
            half_width=25 * FOOT,
            half_length=47 * FOOT,
            whole_circle=True,
        ),
        # FIBA Official Basketball Rules, articles 2.1 to 2.4, and Equipment: 28 m by 15 m, the
        # free-throw line 5.8 m from the baseline, the three-point line 0.9 m from the sidelines.
        "FIBA": Court(
            baseline=1.2,
            free_throw=4.6,
            lane=4.9,
            circle=1.8,
            arc=6.75,
            corner=6.6,
            restricted=1.25,
            half_width=7.5,
            half_length=14.0,
            whole_circle=False,
        ),
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


def court_of(parameters: Mapping[str, float]) -> str:
    """Return the name of the court that a hoop stands on: FIBA's by its preset, else the NBA's."""
    preset, _ = nearest_preset(parameters)
    return "FIBA" if preset == "fiba" else "NBA"


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
    """Draw a floor plan on axes that show it; where it is drawn over colours, with dark lines."""
    metres = shown("length").size
    axes.yaxis.set_major_formatter(lambda value, _: number(-value / metres))
    lines = lines_of(court, parameters["board_distance"])
    look: dict[str, Any] = {"color": _LINES, "lw": 0.8}
    if over:
        wide = min(0.9, _WIDE * panel.scale)
        stroke = withStroke(linewidth=2.7 * wide, foreground=COLOURS["paper"])
        look = {"color": DARK, "lw": wide, "path_effects": [stroke]}
    for name, points in lines.items():
        look["ls"] = _DASHES if name == "inside" else "-"
        axes.plot(*on_floor(*points.T).T, zorder=1.0, label=f"_court {name}", **look)
    draw_hoop(axes, FLOOR, parameters, panel.scale)


def lines_of(court: Court, board_distance: float) -> dict[str, NDArray[np.float64]]:
    """Return the lines of a half court by name, x and y from the ring's centre, m, (n, 2) each.

    The three-point line and the restricted arc are about the ring's centre, all else is measured
    from the board's front. The arc ends in straight lines up to the plane of the board.
    """
    front, half, side = -board_distance, court.lane / 2.0, court.half_width
    baseline, line = front - court.baseline, front + court.free_throw
    middle = baseline + court.half_length
    turn = np.arccos(min(1.0, court.corner / court.arc))
    arc = court.arc * _circle(turn - np.pi / 2.0, np.pi / 2.0 - turn)
    below = court.restricted * _circle(-np.pi / 2.0, np.pi / 2.0)
    circle = court.circle * _circle(-np.pi / 2.0, np.pi / 2.0) + (line, 0.0)
    lines = {
        "sides": [(middle, -side), (baseline, -side), (baseline, side), (middle, side)],
        "middle": [(middle, -side), (middle, side)],
        "lane": [(baseline, -half), (line, -half), (line, half), (baseline, half)],
        "circle": circle,
        "three": [(baseline, -court.corner), *arc, (baseline, court.corner)],
        "restricted": [(front, -court.restricted), *below, (front, court.restricted)],
    }
    if court.whole_circle:
        lines["inside"] = (2.0 * line, 0.0) + (-1.0, 1.0) * circle
    return {name: np.asarray(points, dtype=np.float64) for name, points in lines.items()}


def on_floor(x: ArrayLike, y: ArrayLike) -> NDArray[np.float64]:
    """Return places on the court, (n,) both, as points of the floor plan, (n, 2)."""
    places = np.stack([np.asarray(x), np.asarray(y), np.zeros_like(x)], axis=-1)
    return FLOOR.flatten(places)


def _circle(start: float, stop: float) -> NDArray[np.float64]:
    """Return points on the unit circle, (n, 2)."""
    turn = np.linspace(start, stop, 181)
    return np.stack([np.cos(turn), np.sin(turn)], axis=1)
