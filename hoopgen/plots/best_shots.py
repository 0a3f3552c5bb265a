"""A picture of each place's best shot: the half court, with share made, angle and speed."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

import matplotlib
import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import Normalize
from matplotlib.patches import Rectangle

from hoopgen.core.argument_types import check_arguments
from hoopgen.core.units import DEGREE, display_unit
from hoopgen.hoop.court_lines import find_court
from hoopgen.study.questions.best_shots_result import describe_best_shots

from .figure import add_title, draw_picture, fit_view
from .floor_plan import FLOOR, draw_floor, on_floor
from .style import DARK, PAGE, POINTS_PER_INCH, SHARE_COLOURS

if TYPE_CHECKING:
    import xarray as xr

    from hoopgen.results.drawing import Drawn

_LIGHTEST = 0.5
"""Luminance of a colour below which letters on it are white."""

_HEIGHT = 6.9
_MARGIN = 0.25  # m


@check_arguments
def plot_best_shots(dataset: xr.Dataset, *, title: str = "", ax: Drawn | None = None) -> Drawn:
    """Draw the half court with the best shot from each place.

    In each square stand the share made, the angle and the speed of the best shot; *bank* is a shot
    off the board, and a question mark a place where the other way may be as good, or better.

    Parameters
    ----------
    dataset
        Of `hoopgen.best_shots`.
    title
        Above the picture.
    ax
        To draw on; by default a page of its own.

    Returns
    -------
    Figure or Axes
        A page of its own, or `ax`.

    Raises
    ------
    TypeError
        If `ax` is not axes.
    """
    return draw_picture(ax, (PAGE, _HEIGHT), lambda axes: _draw(dataset, title, axes))


def _draw(dataset: xr.Dataset, title: str, axes: Axes) -> None:
    parameters = json.loads(dataset.attrs["parameters"])
    court = find_court(None, parameters)
    step = dataset.attrs["step"]
    front = -parameters["board_distance"] - court.baseline - _MARGIN
    far = float(dataset["x"].max()) + 0.5 * step + _MARGIN
    side = court.half_width + _MARGIN
    panel = fit_view(axes, FLOOR, (-side, side, -far, -front))
    shares = dataset["probability"].values
    colours, scale = matplotlib.colormaps[SHARE_COLOURS], Normalize(0.0, 1.0)
    places = on_floor(dataset["x"].values, dataset["y"].values)
    speed = display_unit("speed")
    # An inch of the picture has so many points; letters take a share of the square.
    size = min(9.5, 0.21 * POINTS_PER_INCH * step * panel.scale)
    for k, (across, up) in enumerate(places):
        colour = colours(scale(shares[k]))
        corner = (across - 0.5 * step, up - 0.5 * step)
        axes.add_patch(Rectangle(corner, step, step, fc=colour, ec="white", lw=0.6, zorder=0.5))
        ink = "white" if np.dot(colour[:3], (0.2126, 0.7152, 0.0722)) < _LIGHTEST else DARK
        bank = bool(dataset["bank"].values[k])
        mark = ("bank" if bank else "") + ("" if dataset["decided"].values[k] else "?")
        angle = f"{dataset['elevation'].values[k] / DEGREE:.0f}°"
        fast = f"{dataset['speed'].values[k] / speed.size:.1f} {speed.symbol}"
        rows = (
            (0.29, f"{100.0 * shares[k]:.0f}%", 1.15 * size, "bold"),
            (0.0, f"{angle} {fast}", 0.68 * size, "normal"),
            (-0.29, mark, 0.68 * size, "normal"),
        )
        for offset, text, letters, weight in rows:
            axes.text(
                across,
                up + offset * step,
                text,
                fontsize=letters,
                fontweight=weight,
                color=ink,
                ha="center",
                va="center",
                zorder=4.0,
                bbox={"fc": colour, "ec": "none", "pad": 0.8},  # over the lines
            )
    draw_floor(axes, panel, court, parameters, over=True)
    head = title or "Best shot from each place: share made, angle and speed at release"
    add_title(axes, head, describe_best_shots(dataset))
