"""One shot's path in side, top and 3D view, with the ball drawn to scale at its contacts."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from enum import IntEnum
from itertools import pairwise
from typing import Any, Protocol, TypedDict, Unpack, overload

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.text import Text
from numpy.typing import ArrayLike, NDArray

from hoopgen.engines import Engine
from hoopgen.hoop.releases import RING_HEIGHT
from hoopgen.phrases import MINUS
from hoopgen.plots.marks import KEY_ROW, Mark, collect_marks, draw_key, key_rows
from hoopgen.plots.panels import Drawing, Panel, Room, draw_panel, draw_view, some
from hoopgen.plots.picture import Picture, add_key, add_title, check_axes, fit_view
from hoopgen.plots.scenery import Scenery, scenery_of
from hoopgen.plots.style import INK, PAGE, SMALL, style, wrap
from hoopgen.plots.views import Limits, Points, View, oblique
from hoopgen.printable import printable
from hoopgen.told import say_of
from hoopgen.units import shown, shown_system

__all__ = [
    "beats_of",
    "broken",
    "collect",
    "draw_title",
    "flat_limits",
    "plot_trajectory",
    "times_of",
    "told_of",
]


class Path(Protocol):
    """What of `Trajectory` is drawn."""

    @property
    def events(self) -> NDArray[Any]: ...
    @property
    def duration(self) -> float: ...
    @property
    def scene(self) -> Engine: ...
    def at(self, t: ArrayLike) -> NDArray[np.float64]: ...


BEAT = 0.1
"""Seconds between the dots on the path; of a longer shot more, so that there are not too many."""

_BEATS = 100

_RATE = 160  # points of the path a second of flight
_FLIGHT = 480
"""Points of one flight, at most: a parabola cut into n is off by 1/n² of its height at most, here
less than a hundredth of a pixel."""

_PATH = 20_000
"""Points of all flights, at most, and twice the contacts that are drawn: more than a page has."""

# Inches around and between the panels, for their labels.
_LEFT, _RIGHT, _BETWEEN, _BELOW, _ABOVE = 0.62, 0.15, 0.72, 0.5, 0.8
_LINES, _LINE = 2, 0.14  # of what is said below the title, and one of them
_TALLEST, _TALLEST_OVER = 5.6, 4.6  # of side and top views together; over a 3D view
_SLIMMEST = 0.5  # of the flat views: so many times as wide as the longest side of the path
_NARROWEST = 5.3  # of a page, for the title and the key
_WIDEST_BESIDE = 3.2  # of the side and top views, to have the 3D view beside them
_BOX_BELOW = 3.5
_LABELS = 0.48  # around a 3D view
_PAD = 0.06  # m
_ROUND = 0.25  # m: the room's sides
_ELEVATION = np.radians(25.0)
_ALONG, _ACROSS = np.radians(62.0), np.radians(36.0)  # azimuth, for a long and for a wide room


_SHADOW = "Grey in the 3D view: the path straight below on its floor, and lines down to it."


class _Options(TypedDict, total=False):
    outcome: IntEnum | None
    title: str
    three_d: bool | None


@overload
def plot_trajectory(
    trajectory: Path,
    parameters: Mapping[str, float],
    *,
    ax: None = None,
    **options: Unpack[_Options],
) -> Figure: ...


@overload
def plot_trajectory(
    trajectory: Path, parameters: Mapping[str, float], *, ax: Axes, **options: Unpack[_Options]
) -> Axes: ...


def plot_trajectory(
    trajectory: Path,
    parameters: Mapping[str, float],
    *,
    outcome: IntEnum | None = None,
    title: str = "",
    three_d: bool | None = None,
    ax: Axes | None = None,
) -> Figure | Axes:
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
    drawing = collect(trajectory, parameters, outcome)
    if ax is not None:
        if three_d:
            raise ValueError("three_d: on ax there is the side view alone; leave out")
        with style():
            return _draw_on(check_axes(ax), drawing, title, *told_of(trajectory, parameters))
    if three_d is None:
        three_d = not drawing.scenery.is_in_plane(drawing.path)
    with style():
        page = _arrange(drawing, three_d)
        shadow = [_SHADOW] if three_d else []
        told = broken([*told_of(trajectory, parameters), *shadow], page.width)
        room = max(0, len(told) - _LINES) * _LINE
        figure = Picture(figsize=(page.width, page.height + room))
        for panel in page.panels:
            draw_panel(figure, panel, drawing)
        draw_title(figure, title, told)
        draw_key(figure, drawing.marks, page.panels[0].left, 0.12)
    return figure


def broken(told: Sequence[str], width: float) -> list[str]:
    """Break what is said below a title into lines that fit on a page, inches wide."""
    return [line for text in told for line in wrap(text, width - _LEFT, SMALL)]


def _draw_on(axes: Axes, drawing: Drawing, title: str, *told: str) -> Axes:
    """Draw the side view on axes that there are."""
    view = drawing.views[0]
    draw_view(axes, fit_view(axes, view, flat_limits(drawing, view)), drawing)
    add_title(axes, title, *told, formulas=True)
    add_key(axes, [_key_of(mark) for mark in drawing.marks if mark.text])
    return axes


def _key_of(mark: Mark) -> Line2D:
    text = f"{mark.label}  {mark.text}".strip()
    if mark.kind == "line":
        return Line2D([], [], color=mark.colour, label=text, lw=0.9, ls=(0, (5, 3)))
    return Line2D(
        [], [], color=mark.colour, label=text, marker="o", markersize=5.0, linestyle="none"
    )


def collect(trajectory: Path, parameters: Mapping[str, float], outcome: IntEnum | None) -> Drawing:
    """Gather what all views of a shot share; arguments as of `plot_trajectory`."""
    events, duration = trajectory.events, trajectory.duration
    path = trajectory.at(times_of(events["time"], duration))[:, :3]
    scenery = scenery_of(trajectory.scene, parameters, path)
    path = scenery.upright(path)
    beats = scenery.upright(trajectory.at(beats_of(duration))[:, :3])
    events = events.copy()
    events["before"][:, :3] = scenery.upright(events["before"][:, :3])
    dots = some(events["before"], _PATH // 2)[:, :3]
    hoop = trajectory.scene.is_hoop
    bodies = None if hoop else {name: scenery.colours[name] for name in scenery.names}
    line = scenery.said_of_ends
    marks = collect_marks(path[0], events, scenery.ball_radius, outcome, bodies, line)
    return Drawing(path, beats, dots, marks, scenery, _room(path, scenery), scenery.views(path))


def beats_of(duration: float) -> NDArray[np.float64]:
    """Return the times of the dots on the path, s."""
    beat = _beat(duration)
    times = beat * np.arange(1.0, duration / beat + 1.0)
    return times[times < duration]


def _beat(duration: float) -> float:
    """Return the time between dots: 0.1 s, or 0.2, 0.5, 1 ... where that would be too many."""
    longer = (float(f"{digit}e{power}") for power in range(-1, 308) for digit in (2, 5, 10))
    return next(beat for beat in (BEAT, *longer) if duration <= _BEATS * beat)


def times_of(contacts: NDArray[np.float64], duration: float) -> NDArray[np.float64]:
    """Choose times that show each flight as a smooth curve, its ends among them."""
    corners = some(np.unique(np.concatenate([[0.0], contacts, [duration]])), _PATH // 2)
    most = min(_FLIGHT, _PATH // len(corners))
    flights = [
        np.linspace(
            start, stop, max(2, int(_RATE * min(most / _RATE, stop - start))), endpoint=False
        )
        for start, stop in pairwise(corners)
    ]
    return np.concatenate([*flights, [duration]])


def _room(path: Points, scenery: Scenery) -> Room:
    radius = scenery.ball_radius
    points = np.vstack([path - radius, path + radius, scenery.corners()])
    low, high = points.min(axis=0), points.max(axis=0)
    coarse = _ROUND
    if scenery.small:
        coarse = min(_ROUND, 10.0 ** np.floor(np.log10((high - low).max())) / 4.0)
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
    widest = PAGE - _LEFT - _RIGHT
    beside = three_d and across * _TALLEST / up < _WIDEST_BESIDE
    tallest = _TALLEST_OVER if three_d and not beside else _TALLEST
    scale = min(widest / across, tallest / up)
    column = across * scale
    width = PAGE if three_d else max(_LEFT + column + _RIGHT, _NARROWEST)
    left = _LEFT if beside else _LEFT + (width - _LEFT - column - _RIGHT) / 2.0
    key = 0.15 + KEY_ROW * key_rows(drawing.marks, width - _LEFT)
    bottom = key + _BELOW + (_BOX_BELOW if three_d and not beside else 0.0)
    panels: list[Panel] = []
    for view, limits in reversed(flat):
        panels.insert(0, Panel(view, limits, scale, left, bottom))
        bottom += panels[0].height + _BETWEEN
    height = bottom - _BETWEEN + _ABOVE
    if not three_d:
        return _Page(width, height, tuple(panels))
    edge = left + column + 0.1
    box = (edge, key, width - edge, height - key - _ABOVE)
    space = _space_panel(
        drawing, box if beside else (_LEFT, key, width - _LEFT - _RIGHT, _BOX_BELOW - 0.3)
    )
    return _Page(width, height, (*panels, space))


def flat_limits(drawing: Drawing, view: View) -> Limits:
    """Bound what a side or top view shows: the scene and the ball all along its path.

    A path straight up, or along the board, has air on both sides, and titles their room.
    """
    radius = drawing.scenery.ball_radius
    path = view.flatten(drawing.path)
    scene = view.flatten(drawing.scenery.corners())
    points = np.vstack([path - radius, path + radius, scene])
    low, high = points.min(axis=0) - _PAD, points.max(axis=0) + _PAD
    missing = _SLIMMEST * float(np.ptp(drawing.path, axis=0).max()) - (high[0] - low[0])
    air = np.array([max(0.0, float(missing)) / 2.0, 0.0])
    low, high = low - air, high + air
    return float(low[0]), float(high[0]), float(low[1]), float(high[1])


def _space_panel(drawing: Drawing, box: tuple[float, float, float, float]) -> Panel:
    """Fit the 3D view into a box of the page (left, bottom, width, height in inches)."""
    length, breadth, _ = np.subtract(drawing.room.high, drawing.room.low)
    azimuth = _ALONG if length > 1.5 * breadth else _ACROSS
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
    """Give points that bound a 3D view: the room, or if all of it is never filled what is in it."""
    corners = drawing.room.corners()
    if not drawing.scenery.small:
        return corners
    radius = drawing.scenery.ball_radius
    floor = corners[corners[:, 2] == drawing.room.low[2]]
    left = corners[np.argmin(view.flatten(corners)[:, 0])]
    edge = [left[0], left[1], drawing.room.high[2]]
    points = [floor, [edge], drawing.path - radius, drawing.path + radius]
    return np.vstack([*points, drawing.scenery.points()])


def told_of(trajectory: Path, parameters: Mapping[str, float]) -> tuple[str, str]:
    """Say how the ball is released, and in which scene."""
    x, y, z, vx, vy, vz, *spin = (float(value) for value in trajectory.at(np.zeros(1))[0])
    speed = np.hypot(np.hypot(vx, vy), vz)
    angle = np.degrees(np.arctan2(vz, np.hypot(vx, vy)))
    unit, spins, length = shown("speed"), shown("spin"), shown("length")
    # The article's figures say angular velocities, coaches turns a second.
    us = shown_system() == "us"
    sign, symbol, size = ("/2\\pi", spins.symbol, spins.size) if us else ("", "rad/s", 1.0)
    up = f"{angle:.1f}\N{DEGREE SIGN} up{_aside(x, y, vx, vy)}"
    said = f"Released at {speed / unit.size:.2f} {unit.symbol}, {up}"
    turning = [  # no blanks in formulas: lines are broken there
        f"$\\omega_{axis}{sign}={w / size:.4g}$ {symbol}"
        for axis, w in zip("xyz", spin, strict=True)
        if w
    ]
    scene = say_of(trajectory.scene, parameters)
    dots = f"Scene: {scene}. Dots on the path every {_beat(trajectory.duration):g} s."
    turns = ", ".join(turning) or "no spin"
    if not trajectory.scene.is_hoop:
        at = ", ".join(f"{one / length.size:.3f}".replace("-", MINUS) for one in (x, y, z))
        fast = f"{speed / unit.size:.2f} {unit.symbol}"
        return f"Released at {fast}, {turns}; from ({at}) {length.symbol}.", dots
    away, high = (
        f"{one / length.size:.3f} {length.symbol}" for one in (np.hypot(x, y), RING_HEIGHT + z)
    )
    place = f"{away} from the ring's centre, {high} high"
    return f"{said}, {turns}; {place}.", dots


def _aside(x: float, y: float, vx: float, vy: float) -> str:
    """Say how far to a side the ball flies: the azimuth, nothing where it is none."""
    if not ((x or y) and (vx or vy)):
        return ""
    azimuth = np.degrees(np.arctan2(y * vx - x * vy, -x * vx - y * vy))
    if round(abs(azimuth), 1) == 0.0:
        return ""
    return f" and {abs(azimuth):.1f}\N{DEGREE SIGN} to the {'left' if azimuth > 0.0 else 'right'}"


def draw_title(figure: Figure, title: str, told: Sequence[str]) -> Text:
    """Write the title of a page, which is returned, and lines below it."""
    width, height = figure.get_size_inches()
    x = _LEFT / width
    head = printable(title)
    top = 1.0 - 0.16 / height
    written = figure.text(x, top, head, fontsize=10, fontweight="bold", va="center")
    for number, line in enumerate(told):
        y = 1.0 - (0.34 + _LINE * number) / height
        figure.text(x, y, line, fontsize=SMALL, color=INK, va="center", parse_math=True)
    return written
