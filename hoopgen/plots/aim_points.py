"""Aim points of bank shots on the board by place on the floor, and where the bank is better."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import inf
from typing import TYPE_CHECKING

import numpy as np
from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.collections import Collection, LineCollection
from matplotlib.colors import Normalize
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle
from matplotlib.patheffects import withStroke
from numpy.typing import NDArray

from hoopgen.core.argument_types import check_arguments
from hoopgen.hoop.court_lines import Court, find_court
from hoopgen.hoop.places import Square, on_board, say_on_board, say_on_ring
from hoopgen.hoop.presets import PAPER
from hoopgen.report.provenance import describe_dataset, describe_hoop, sentences

from .figure import add_key, add_title, draw_picture, fit_view
from .floor_plan import FLOOR, add_floor, on_floor
from .hoop import draw_hoop, scene_corners
from .label_placement import Box, place_labels
from .page import ABOVE, BELOW, add_view, lay_pair, new_page
from .style import DARK, PAGE, Inches, letter
from .views import Limits, Panel, View, limits_around

if TYPE_CHECKING:
    import xarray as xr

    from hoopgen.results.drawing import Drawn

Column = NDArray[np.float64]

FRONT = View("front view", (0.0, 1.0, 0.0), (0.0, 0.0, 1.0), ("y", "above the ring"))

_REQUIRED = ("x", "y", "touch_y", "touch_z", "difference_low", "difference_high")

# The colour map suits readers with any colour vision; its pale end is left out.
_COLOUR_MAP, _COLOUR_MAP_END = "plasma", 0.64

# What the interval of the difference says, and the marker that stands for it.
_VERDICTS = (
    ("bank better", "o", 26.0, True),
    ("no difference shown", "D", 14.0, True),
    ("direct better", "o", 20.0, False),
)
"""Said, marker, its area in square points, and whether it is filled."""

_RANGE_VARIABLES = ("touch_y_low", "touch_y_high", "touch_z_low", "touch_z_high")
"""Variables of the dataset that hold the range of touches; older datasets lack them."""

_COLOUR_NOTE = "A colour is a direction from the ring."
_FLOOR_NOTE = "Lines on the floor follow the ball to where it touches the board."
_CROSS_NOTE = "A cross spans nine tenths of the made bank shots, each way."

_NAME_SIZE = 6.5  # points

# Inches.
_LEGEND_HEIGHT = 0.25
_MARGIN = 0.1  # m
_FLOOR_MARGIN = 0.25  # m, around the places


@check_arguments
def plot_aim_points(
    dataset: xr.Dataset,
    parameters: Mapping[str, float],
    *,
    court: str | None = None,
    title: str = "",
    note: str | None = None,
    width: Inches = PAGE,
    ax: Drawn | None = None,
) -> Drawn:
    """Draw where on the board the best bank shots touch it, and the places they come from.

    A place and its point on the board have one colour, by direction from the ring, and one marker,
    which says whether the bank shot is the better there. A cross shows within what range the made
    ones touch the board, and places on the board have names. On the floor plan a line follows
    the ball's centre from each place until the ball touches the board, and leads on to that point.

    Parameters
    ----------
    dataset
        Of `hoopgen.study.questions.bank.bank_or_direct`.
    parameters
        Of the scene, one number each.
    court
        Whose lines are drawn, of `hoopgen.hoop.court_lines.COURTS`; by default FIBA's for a hoop
        nearest to that preset, else the NBA's.
    title
        Above the picture.
    note
        Said below it, after what colours and lines are, from where to where the bank shots aim on
        the board and the direct ones at the ring; by default the scene, and release, scatter
        and seed as far as the dataset says them.
    width
        Of the page, inches, as of `plot_fan`.
    ax
        To draw on, the board without the floor. The key is to the right of them: figures with
        ``layout="constrained"`` make room for it.

    Returns
    -------
    Figure or Axes
        A page of its own, or `ax`; as of `plot_fan`.

    Raises
    ------
    TypeError
        If `ax` is not axes.
    ValueError
        If the dataset lacks a variable, no place has a bank shot, or there is no such court.
    """
    missing = [name for name in _REQUIRED if name not in dataset]
    if missing:
        raise ValueError(f"dataset: expected that of bank_or_direct; {', '.join(missing)} missing")
    parameters = {**PAPER, **parameters}
    lines = find_court(court, parameters)
    columns = {name: np.asarray(dataset[name], dtype=np.float64) for name in _REQUIRED}
    there = np.isfinite(columns["touch_y"])
    if not there.any():
        raise ValueError("dataset: expected a bank shot from one place at least, got none")
    aims: _AimPoints = _AimPoints(
        **{name: column[there] for name, column in columns.items()}, ranges=_ranges(dataset, there)
    )
    description = _default_note(dataset, parameters) if note is None else note
    description = " ".join([*_describe_aims(aims, dataset, parameters), description])
    return draw_picture(
        ax,
        lambda: _draw(aims, parameters, lines, title, description, width),
        lambda axes: _draw_on(axes, aims, parameters, title, description),
    )


@dataclass(frozen=True)
class _AimPoints:
    """Values by place, (n,) each, m, as in the dataset."""

    x: Column
    y: Column
    touch_y: Column
    touch_z: Column
    difference_low: Column
    difference_high: Column
    ranges: NDArray[np.float64] | None

    @property
    def colours(self) -> Column:
        """Colours by direction from the ring, (n, 4)."""
        angle = np.arctan2(self.y, self.x)
        limit = max(float(np.abs(angle).max()), 1e-6)
        return np.asarray(colormaps[_COLOUR_MAP](_COLOUR_MAP_END * Normalize(-limit, limit)(angle)))

    @property
    def verdicts(self) -> NDArray[np.int64]:
        """Place of each in `_VERDICTS`, (n,)."""
        return np.where(self.difference_low > 0.0, 0, np.where(self.difference_high < 0.0, 2, 1))


def _ranges(dataset: xr.Dataset, there: NDArray[np.bool_]) -> NDArray[np.float64] | None:
    """Return the ends of y and of z that hold nine tenths of the made shots, (n, 4), if known."""
    if any(name not in dataset for name in _RANGE_VARIABLES):
        return None
    return np.stack(
        [np.asarray(dataset[name], dtype=np.float64)[there] for name in _RANGE_VARIABLES], axis=1
    )


def _describe_aims(
    aims: _AimPoints, dataset: xr.Dataset, parameters: Mapping[str, float]
) -> list[str]:
    """Describe where the shots aim, by named places on the board and the ring."""
    ends = [int(end(aims.touch_y)) for end in (np.argmin, np.argmax)]
    points = [(float(aims.touch_y[one]), float(aims.touch_z[one])) for one in ends]
    names = list(dict.fromkeys(say_on_board(*point, parameters) for point in points))
    said = [f"Bank shots aim {_join_ends(names)}."]
    if "aim" in dataset and "direct" in dataset["way"].values:
        past = np.asarray(dataset["aim"].sel(way="direct"), dtype=np.float64)
        if np.isfinite(past).any():
            both = (float(end(past)) for end in (np.nanmin, np.nanmax))
            said.append(
                f"Direct ones aim {_join_ends([say_on_ring(one, parameters) for one in both])}."
            )
    return said


def _join_ends(names: list[str]) -> str:
    """Join the names of the first and the last place; a common part is written once."""
    first, last = names[0], names[-1]
    if first == last:
        return f"at {first}"
    number, unit, *where = first.split(" ", 2)
    if where and last.split(" ", 2)[1:] == [unit, *where]:
        first = number  # "from 2 to 7 cm past the centre of the ring"
    return f"from {first} to {last}"


def _default_note(dataset: xr.Dataset, parameters: Mapping[str, float]) -> str:
    described = describe_dataset(dataset)
    scene = described.get("scene") if "scene_sha256" in dataset.attrs else describe_hoop(parameters)
    return sentences({**described, "scene": str(scene)}, scene=True)


def _draw(
    aims: _AimPoints,
    parameters: Mapping[str, float],
    court: Court,
    title: str,
    note: str,
    width: float,
) -> Figure:
    """Draw the board and the floor, one beside or above the other."""
    both = (FRONT, _board(parameters)), (FLOOR, _floor(aims, parameters))
    board, floor = lay_pair(*both, width, _LEGEND_HEIGHT + BELOW, inf)
    figure = new_page(
        width,
        max(board.top, floor.top) + ABOVE - _LEGEND_HEIGHT,
        title=title,
        note=f"{_COLOUR_NOTE} {_FLOOR_NOTE} {_spans(aims)}{note}",
        foot=_LEGEND_HEIGHT,
    )
    front = add_view(figure, board)
    _draw_board(front, board, aims, parameters)
    plan = add_floor(figure, floor, court, parameters)
    board_x = np.full_like(aims.x, -parameters["board_distance"])
    ways = [(aims.x, aims.y), (board_x + parameters["ball_radius"], aims.touch_y)]
    lines = np.stack([on_floor(x, y) for x, y in (*ways, (board_x, aims.touch_y))], axis=1)
    plan.add_collection(LineCollection(list(lines), colors=aims.colours, lw=0.4, zorder=3.0))
    _scatter(plan, on_floor(aims.x, aims.y), aims)
    figure.legend(
        handles=_legend_handles(plan, aims),
        loc="lower left",
        ncols=len(_VERDICTS),
        frameon=False,
        fontsize=7.5,
        handletextpad=0.1,
        columnspacing=1.2,
    )
    return figure


def _draw_on(
    axes: Axes, aims: _AimPoints, parameters: Mapping[str, float], title: str, note: str
) -> None:
    """Draw the board on axes that there are."""
    _draw_board(axes, fit_view(axes, FRONT, _board(parameters)), aims, parameters)
    add_title(axes, title, f"{_COLOUR_NOTE} {_spans(aims)}{note}")
    add_key(axes, _legend_handles(axes, aims))


def _spans(aims: _AimPoints) -> str:
    return "" if aims.ranges is None else f"{_CROSS_NOTE} "


def _draw_board(
    axes: Axes, panel: Panel, aims: _AimPoints, parameters: Mapping[str, float]
) -> None:
    draw_hoop(axes, FRONT, parameters, panel.scale)
    _draw_target(axes, parameters)
    points = np.stack([aims.touch_y, aims.touch_z], axis=1)
    if aims.ranges is not None:
        _draw_ranges(axes, points, aims)
    _name_places(axes, panel, points, parameters)
    _scatter(axes, points, aims)


def _draw_ranges(axes: Axes, points: NDArray[np.float64], aims: _AimPoints) -> None:
    """Draw a cross through each aim point, as wide and as high as its range."""
    assert aims.ranges is not None
    (left, right, low, high), (y, z) = aims.ranges.T, points.T
    across = np.stack([np.stack([left, z], axis=1), np.stack([right, z], axis=1)], axis=1)
    up = np.stack([np.stack([y, low], axis=1), np.stack([y, high], axis=1)], axis=1)
    lines = np.concatenate([across, up])
    colours = np.concatenate([aims.colours, aims.colours])
    axes.add_collection(
        LineCollection(list(lines), colors=colours, lw=0.7, alpha=0.55, zorder=50.0, label="range")
    )


def _name_places(
    axes: Axes, panel: Panel, points: NDArray[np.float64], parameters: Mapping[str, float]
) -> None:
    """Mark places on the board, and write their names where they hide the least."""
    inch = 1.0 / panel.scale
    places = {name.replace(" of the square", ""): at for name, at in on_board(parameters).items()}
    boxes = [
        Box(at, 0.06 * inch, len(name) * letter(_NAME_SIZE) * inch, 0.13 * inch)
        for name, at in places.items()
    ]
    for (name, at), centre in zip(
        places.items(), place_labels(boxes, points, panel.limits), strict=True
    ):
        axes.plot(*at, marker="+", ms=4.0, mew=0.8, color=DARK, zorder=55.0, label="_place")
        axes.annotate(
            name,
            at,
            centre,
            ha="center",
            va="center",
            fontsize=_NAME_SIZE,
            color=DARK,
            zorder=70.0,
            path_effects=[withStroke(linewidth=1.5, foreground="white")],
        )


def _legend_handles(axes: Axes, aims: _AimPoints) -> list[Collection]:
    """Return the entries of the key: the verdicts that occur, as they were drawn last."""
    return [axes.collections[-len(_VERDICTS) + one] for one in np.unique(aims.verdicts)]


def _board(parameters: Mapping[str, float]) -> Limits:
    """Bound the board and the ring from the front."""
    return limits_around(FRONT.flatten(scene_corners(parameters)), _MARGIN)


def _floor(aims: _AimPoints, parameters: Mapping[str, float]) -> Limits:
    """Bound the places on the floor and the whole board."""
    wide = max(float(np.abs(aims.y).max()), parameters["board_half_width"])
    far = max(float(aims.x.max()), parameters["ring_radius"])
    points = np.array([[-wide, -far], [wide, parameters["board_distance"]]])
    return limits_around(points, _FLOOR_MARGIN)


def _draw_target(axes: Axes, parameters: Mapping[str, float]) -> None:
    """Draw the square painted on the board: the middles of its lines."""
    square = Square.from_parameters(parameters)
    half = square.line / 2.0
    corner = square.left + half, square.bottom + half
    size = square.right - square.left - square.line, square.top - square.bottom - square.line
    axes.add_patch(Rectangle(corner, *size, fill=False, ec="white", lw=2.0, zorder=5.0))


def _scatter(axes: Axes, points: NDArray[np.float64], aims: _AimPoints) -> None:
    for one, (label, marker, size, filled) in enumerate(_VERDICTS):
        here = aims.verdicts == one
        axes.scatter(
            points[here, 0],
            points[here, 1],
            s=size,
            marker=marker,
            facecolors=aims.colours[here] if filled else "white",
            edgecolors=DARK if filled else aims.colours[here],
            linewidths=0.5 if filled else 1.2,
            label=label,
            zorder=60.0,
        )
