"""Pictures of one shot: side, top and 3D view, with the ball to scale at its contacts."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from enum import IntEnum
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from numpy.typing import NDArray

from hoopgen.core.argument_types import check_arguments
from hoopgen.core.parameters import means, of_scene

from .contact_marks import LEGEND_ROW, Mark, collect_marks, draw_mark_legend, mark_legend_rows
from .figure import Picture, add_key, add_title, draw_picture, fit_view
from .page import stack_views
from .panels import Drawing, Room, draw_panel, draw_view, thin_rows
from .scenery import Scenery, scenery_of
from .shot_text import (
    LEFT,
    LINE,
    TITLE,
    FlightPath,
    describe_shot,
    dot_times,
    draw_title,
    wrap_lines,
)
from .style import PAGE
from .views import Limits, Panel, Points, View, oblique

if TYPE_CHECKING:
    from hoopgen.results.drawing import Drawn

_POINT_RATE = 160  # points of the path a second of flight
_MAX_FLIGHT_POINTS = 480
"""Points of one flight, at most: a parabola cut into n is off by 1/n² of its height at most, here
less than a hundredth of a pixel."""

_MAX_PATH_POINTS = 20_000
"""Points of all flights, at most, and twice the contacts that are drawn: more than a page has."""

# Inches around and between the panels, for their labels.
_RIGHT, _GAP, _BELOW, _ABOVE = 0.15, 0.72, 0.5, 0.8
_LINES = 2  # lines below the title for which there is always room
_MAX_HEIGHT, _MAX_HEIGHT_OVER_3D = 5.6, 4.6  # of side and top views together; over a 3D view
_MIN_WIDTH_SHARE = 0.5  # of the flat views: so many times as wide as the longest side of the path
_MIN_WIDTH = 5.3  # of a page, for the title and the key
_MAX_WIDTH_BESIDE_3D = 3.2  # of the side and top views, to have the 3D view beside them
_BELOW_3D_HEIGHT = 3.5
_LABELS = 0.48  # around a 3D view
_PAD = 0.06  # m
_ROOM_STEP = 0.25  # m: the room's sides
_ELEVATION = np.radians(25.0)
_AZIMUTH_LONG, _AZIMUTH_WIDE = np.radians(62.0), np.radians(36.0)  # of a long and a wide room


_SHADOW_NOTE = "Grey in the 3D view: the path straight below on its floor, and lines down to it."


@check_arguments
def plot_trajectory(
    trajectory: FlightPath,
    parameters: Mapping[str, float],
    *,
    outcome: IntEnum | None = None,
    title: str = "",
    three_d: bool | None = None,
    ax: Drawn | None = None,
) -> Drawn:
    """Draw a shot to scale: from the side, from above and, out of plane, in space.

    In a scene of one's own the side view looks across the plane in which the ball moves; where all
    bodies are cylinders across that plane, it is the only view.

    Parameters
    ----------
    trajectory
        ``shots.trajectory(i)`` of `hoopgen.simulate` with ``record=True``.
    parameters
        Of the scene, one number each.
    outcome
        Said beside the end; by default nothing is said.
    title
        Above the picture.
    three_d
        Whether there is a 3D view; by default where the ball leaves the plane of the side view,
        at a hoop the plane y = 0.
    ax
        To draw on, from the side only. The key is to the right of them: figures with
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
        If a 3D view is asked for on `ax`, or the path leads further than 1e290 m.
    """
    drawing = build_drawing(trajectory, parameters, outcome)
    if ax is not None and three_d:
        raise ValueError("three_d: on ax there is the side view alone; leave out")
    in_space = not drawing.scenery.is_in_plane(drawing.path) if three_d is None else three_d
    description = describe_shot(trajectory, parameters)
    return draw_picture(
        ax,
        lambda: _draw(drawing, in_space, title, description),
        lambda axes: _draw_on(axes, drawing, title, *description),
    )


def _draw(drawing: Drawing, three_d: bool, title: str, description: Sequence[str]) -> Figure:
    """Draw all views on a page."""
    page = _arrange(drawing, three_d)
    lines = wrap_lines([*description, *([_SHADOW_NOTE] if three_d else [])], page.width)
    head = TITLE if title else 0.0
    room = max(0, len(lines) - _LINES) * LINE + head - TITLE
    figure = Picture(figsize=(page.width, page.height + room))
    for panel in page.panels:
        draw_panel(figure, panel, drawing)
    draw_title(figure, title, lines, room=head)
    draw_mark_legend(figure, drawing.marks, LEFT, 0.12)
    return figure


def _draw_on(axes: Axes, drawing: Drawing, title: str, *description: str) -> None:
    """Draw the side view on given axes."""
    view = drawing.views[0]
    draw_view(axes, fit_view(axes, view, flat_limits(drawing, view)), drawing)
    add_title(axes, title, *description, formulas=True)
    add_key(axes, [_legend_text(mark) for mark in drawing.marks if mark.text])


def _legend_text(mark: Mark) -> Line2D:
    text = f"{mark.label}  {mark.text}".strip()
    if mark.kind == "line":
        return Line2D([], [], color=mark.colour, label=text, lw=0.9, ls=(0, (5, 3)))
    return Line2D(
        [], [], color=mark.colour, label=text, marker="o", markersize=5.0, linestyle="none"
    )


def build_drawing(
    trajectory: FlightPath, parameters: Mapping[str, float], outcome: IntEnum | None
) -> Drawing:
    """Return the content that all views of a shot share; arguments as for `plot_trajectory`.

    Parameters
    ----------
    trajectory
        The path.
    parameters
        The scene's parameters.
    outcome
        The outcome; None if it is not known.
    """
    parameters = means(of_scene(parameters, trajectory.scene.table))
    events, duration = trajectory.events, trajectory.duration
    path = trajectory.at(path_times(events["time"], duration))[:, :3]
    scenery = scenery_of(trajectory.scene, parameters, path)
    path = scenery.upright(path)
    beats = scenery.upright(trajectory.at(dot_times(duration))[:, :3])
    events = events.copy()
    events["before"][:, :3] = scenery.upright(events["before"][:, :3])
    dots = thin_rows(events["before"], _MAX_PATH_POINTS // 2)[:, :3]
    hoop = trajectory.scene.is_hoop
    bodies = None if hoop else {name: scenery.colours[name] for name in scenery.names}
    line = scenery.said_of_ends
    marks = collect_marks(path[0], events, scenery.ball_radius, outcome, bodies, line)
    return Drawing(path, beats, dots, marks, scenery, _room(path, scenery), scenery.views(path))


def path_times(contacts: NDArray[np.float64], duration: float) -> NDArray[np.float64]:
    """Return times that show each flight as a smooth curve, with its ends.

    Parameters
    ----------
    contacts
        Times of the contacts, s.
    duration
        The duration of the path, s.
    """
    corners = thin_rows(
        np.unique(np.concatenate([[0.0], contacts, [duration]])), _MAX_PATH_POINTS // 2
    )
    most = min(_MAX_FLIGHT_POINTS, _MAX_PATH_POINTS // len(corners))
    flights = [
        np.linspace(
            start,
            stop,
            max(2, int(_POINT_RATE * min(most / _POINT_RATE, stop - start))),
            endpoint=False,
        )
        for start, stop in pairwise(corners)
    ]
    return np.concatenate([*flights, [duration]])


def _room(path: Points, scenery: Scenery) -> Room:
    radius = scenery.ball_radius
    points = np.vstack([path - radius, path + radius, scenery.corners()])
    low, high = points.min(axis=0), points.max(axis=0)
    coarse = _ROOM_STEP
    if scenery.small:
        coarse = min(_ROOM_STEP, 10.0 ** np.floor(np.log10((high - low).max())) / 4.0)
    low, high = np.floor(low / coarse) * coarse, np.ceil(high / coarse) * coarse
    return Room((low[0], low[1], low[2]), (high[0], high[1], high[2]))


@dataclass(frozen=True)
class _Page:
    width: float
    height: float
    panels: tuple[Panel, ...]


def _arrange(drawing: Drawing, three_d: bool) -> _Page:
    """Place the views: side over top, the 3D view beside them or, for a long shot, below."""
    flat = [(view, flat_limits(drawing, view)) for view in drawing.views]
    across = max(right - left for _, (left, right, _, _) in flat)
    up = sum(top - bottom for _, (_, _, bottom, top) in flat)
    widest = PAGE - LEFT - _RIGHT
    beside = three_d and across * _MAX_HEIGHT / up < _MAX_WIDTH_BESIDE_3D
    tallest = _MAX_HEIGHT_OVER_3D if three_d and not beside else _MAX_HEIGHT
    scale = min(widest / across, tallest / up)
    column = across * scale
    width = PAGE if three_d else max(LEFT + column + _RIGHT, _MIN_WIDTH)
    left = LEFT if beside else LEFT + (width - LEFT - column - _RIGHT) / 2.0
    key = 0.15 + LEGEND_ROW * mark_legend_rows(drawing.marks, width - LEFT)
    bottom = key + _BELOW + (_BELOW_3D_HEIGHT if three_d and not beside else 0.0)
    panels = stack_views(flat, scale, left, bottom, _GAP)
    height = panels[0].top + _ABOVE
    if not three_d:
        return _Page(width, height, tuple(panels))
    edge = left + column + 0.1
    box = (edge, key, width - edge, height - key - _ABOVE)
    space = _space_panel(
        drawing, box if beside else (LEFT, key, width - LEFT - _RIGHT, _BELOW_3D_HEIGHT - 0.3)
    )
    return _Page(width, height, (*panels, space))


def flat_limits(drawing: Drawing, view: View) -> Limits:
    """Return the limits of a side or top view: the scene and the ball along its path.

    A path straight up, or along the board, has air on both sides, and titles their room.

    Parameters
    ----------
    drawing
        The content.
    view
        The view.
    """
    radius = drawing.scenery.ball_radius
    path = view.flatten(drawing.path)
    scene = view.flatten(drawing.scenery.corners())
    points = np.vstack([path - radius, path + radius, scene])
    low, high = points.min(axis=0) - _PAD, points.max(axis=0) + _PAD
    missing = _MIN_WIDTH_SHARE * float(np.ptp(drawing.path, axis=0).max()) - (high[0] - low[0])
    air = np.array([max(0.0, float(missing)) / 2.0, 0.0])
    low, high = low - air, high + air
    return float(low[0]), float(high[0]), float(low[1]), float(high[1])


def _space_panel(drawing: Drawing, box: tuple[float, float, float, float]) -> Panel:
    """Fit the 3D view into a box of the page (left, bottom, width, height in inches)."""
    length, breadth, _ = np.subtract(drawing.room.high, drawing.room.low)
    azimuth = _AZIMUTH_LONG if length > 1.5 * breadth else _AZIMUTH_WIDE
    from_left = drawing.path[:, 1].mean() < 0.0
    view = oblique(-azimuth if from_left else azimuth, _ELEVATION)
    corners = view.flatten(_in_space(drawing, view))
    low, high = corners.min(axis=0), corners.max(axis=0)
    size = high - low
    scale = min((box[2] - 2 * _LABELS) / size[0], (box[3] - 2 * _LABELS) / size[1])
    middle, half = (low + high) / 2.0, np.array(box[2:]) / scale / 2.0
    (left, bottom), (right, top) = middle - half, middle + half
    limits = (float(left), float(right), float(bottom), float(top))
    return Panel(view, limits, float(scale), box[0], box[1])


def _in_space(drawing: Drawing, view: View) -> Points:
    """Return points that bound a 3D view: the room, or only its content if that is smaller."""
    corners = drawing.room.corners()
    if not drawing.scenery.small:
        return corners
    radius = drawing.scenery.ball_radius
    floor = corners[corners[:, 2] == drawing.room.low[2]]
    left = corners[np.argmin(view.flatten(corners)[:, 0])]
    edge = [left[0], left[1], drawing.room.high[2]]
    points = [floor, [edge], drawing.path - radius, drawing.path + radius]
    return np.vstack([*points, drawing.scenery.points()])
