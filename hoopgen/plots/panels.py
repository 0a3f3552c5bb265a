"""One view on the page: its axes in metres, the scene, the path and the badges."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Patch
from matplotlib.ticker import MultipleLocator

from hoopgen.core.units import display_unit

from .contact_marks import Mark, draw_badges
from .hoop import draw_ball, draw_path
from .occlusion import is_hidden, runs
from .page import add_view
from .scenery import Scenery
from .style import COLOURS, EDGES, FRAME, GRID, INK, POINTS_PER_INCH
from .ticks import number
from .views import Panel, Points, View

Place = Sequence[float]

_TICK_STEPS = (0.25, 0.5, 1.0, 2.0, 5.0, 10.0)  # between ticks, in the unit shown
_SMALL_TICK_STEPS = (0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1)
_TICK_ROOM = 0.36  # inches
_MIN_TICKS = 3  # ticks on an axis, at least
_MAX_OBSTACLES = 5_000  # points of a path that badges stay clear of
_HIDDEN_ORDER, _DOT_ORDER = 59.0, 60.0  # drawing order, above bodies and paths
_CORNER_GAP = 0.3  # of a step: of two ticks at a corner of the room, one is left out


@dataclass(frozen=True)
class Room:
    """A box along the axes that contains everything drawn, m."""

    low: tuple[float, float, float]
    high: tuple[float, float, float]

    def corners(self) -> Points:
        """Return its corners, shape (8, 3)."""
        sides = np.array([self.low, self.high])
        grid = np.stack(np.meshgrid(*sides.T, indexing="ij"), axis=-1)
        return grid.reshape(-1, 3)


@dataclass(frozen=True)
class Drawing:
    """The content that all views of a shot share, in metres.

    Attributes
    ----------
    path
        The ball's centre, shape (n, 3).
    beats
        Where it is at regular times, shape (m, 3).
    dots
        Where it is at its contacts, shape (k, 3).
    marks
        What is labelled.
    scenery
        What stands around it.
    room
        What is shown.
    views
        The flat ones, the one that shows most first.
    """

    path: Points
    beats: Points
    dots: Points
    marks: tuple[Mark, ...]
    scenery: Scenery
    room: Room
    views: tuple[View, ...]


def draw_panel(figure: Figure, panel: Panel, drawing: Drawing) -> Axes:
    """Draw a view of a shot.

    Parameters
    ----------
    figure, panel
        As for `add_panel`.
    drawing
        The shot.

    Returns
    -------
    matplotlib.axes.Axes
        With equal aspect, labelled with the view's name.
    """
    axes = add_panel(figure, panel)
    draw_view(axes, panel, drawing)
    return axes


def draw_view(axes: Axes, panel: Panel, drawing: Drawing) -> None:
    """Draw a view of a shot on axes that show it.

    Parameters
    ----------
    axes
        The axes.
    panel
        Their view and scale.
    drawing
        The content.
    """
    view = drawing.scenery.look(panel.view)
    written = _draw_floor(axes, panel, drawing) if view.labels is None else []
    if view.labels is not None:
        label_flat_view(axes, panel, drawing)
    radius, before = drawing.scenery.ball_radius, len(axes.patches)
    drawing.scenery.draw(axes, view, panel.scale)
    bodies = axes.patches[before:]
    draw_path(axes, view, drawing.path, radius)
    _draw_hidden_path(axes, view, drawing.path, bodies)
    for mark in drawing.marks:
        if mark.label:
            ghost = mark.kind == "release"
            draw_ball(axes, view, mark.position, radius, drawing.scenery.ball, ghost=ghost)
    for points, size, colour in ((drawing.beats, 2.2, "path"), (drawing.dots, 2.6, "backboard")):
        seen = points[~is_hidden(bodies, view, points)]
        _dots(axes, view.flatten(seen), size, COLOURS[colour])
    lines = np.vstack([thin_rows(drawing.path, _MAX_OBSTACLES), drawing.scenery.points()])
    obstacles = np.vstack([view.flatten(lines), *written])
    draw_badges(axes, view, drawing.marks, obstacles, panel.limits, radius, panel.scale, bodies)


def thin_rows(rows: Points, most: int) -> Points:
    """Return at most so many rows, evenly chosen, with the first and the last.

    Parameters
    ----------
    rows
        The rows, (n, ...).
    most
        The greatest number of rows.
    """
    if len(rows) <= most:
        return rows
    return rows[np.linspace(0, len(rows) - 1, most).astype(np.intp)]


def add_panel(figure: Figure, panel: Panel) -> Axes:
    """Return axes of a view on the page, to scale, with the view's name above.

    Parameters
    ----------
    figure
        The page.
    panel
        The view and its place.
    """
    axes = add_view(figure, panel)
    axes.set_title(panel.view.name, loc="left", fontsize=8.0, color=FRAME, pad=4.0)
    return axes


def label_flat_view(axes: Axes, panel: Panel, drawing: Drawing) -> None:
    """Label a side or top view, and draw the end plane if it appears as a line.

    Parameters
    ----------
    axes, panel, drawing
        As for `draw_view`.
    """
    view = panel.view
    metres = display_unit("length").size
    left, right, bottom, top = panel.limits
    for axis, span in ((axes.xaxis, right - left), (axes.yaxis, top - bottom)):
        axis.set_major_locator(
            MultipleLocator(_step(span, panel.scale, small=drawing.scenery.small))
        )
        axis.set_major_formatter(lambda value, _: number(value / metres))
    axes.grid(color=GRID, lw=0.5)
    axes.set_axisbelow(True)
    drawing.scenery.draw_ends(axes, view)


def _dots(axes: Axes, at: Points, size: float, colour: str) -> None:
    axes.plot(
        at[:, 0],
        at[:, 1],
        ls="none",
        marker="o",
        ms=size,
        mfc=colour,
        mec="none",
        zorder=_DOT_ORDER,
    )


def _draw_hidden_path(axes: Axes, view: View, path: Points, bodies: Sequence[Patch]) -> None:
    """Draw the parts of a path that bodies hide as thin dashed lines over them."""
    for run in runs(is_hidden(bodies, view, path)):
        flat = view.flatten(path[run])
        axes.plot(*flat.T, color=COLOURS["path"], lw=0.6, ls=(0, (3, 2)), zorder=_HIDDEN_ORDER)


def _draw_floor(axes: Axes, panel: Panel, drawing: Drawing) -> list[Points]:
    """Draw the three axes of a 3D view on the edges of its room, and the path's shadow.

    Returns points under its numbers and names, in the picture's metres.
    """
    axes.set_axis_off()
    view, room, floor = panel.view, drawing.room, drawing.room.low[2]
    seen = panel.scale * np.linalg.norm(view.flatten(np.eye(3)), axis=1)
    sides = zip(np.subtract(room.high, room.low), seen, strict=True)
    steps = [_step(*side, small=drawing.scenery.small) for side in sides]
    xs, ys, zs = map(_ticks, room.low, room.high, steps)
    near = np.where(view.towards > 0.0, room.high, room.low)
    names = drawing.scenery.axes
    for x in (room.low[0], *xs, room.high[0]):
        _line(axes, view, (x, room.low[1], floor), (x, room.high[1], floor))
    for y in (room.low[1], *ys, room.high[1]):
        _line(axes, view, (room.low[0], y, floor), (room.high[0], y, floor))
    left = min(room.corners().tolist(), key=lambda corner: float(view.flatten(corner)[0]))
    _line(axes, view, (left[0], left[1], floor), (left[0], left[1], room.high[2]), EDGES)
    clear = [x for x in xs if abs(x - near[0]) > _CORNER_GAP * steps[0]] or xs
    written = [
        *_name_edge(axes, panel, room, 0, names[0], (0.0, near[1], floor), clear),
        *_name_edge(axes, panel, room, 1, names[1], (near[0], 0.0, floor), ys),
    ]
    high = [z for z in zs if z - floor > _CORNER_GAP * steps[2]]
    written += _name_edge(axes, panel, room, 2, names[2], (left[0], left[1], 0.0), high)
    shadow = view.flatten(_project_on_floor(drawing.path, floor))
    axes.plot(shadow[:, 0], shadow[:, 1], color="#B0B0B0", lw=1.0, zorder=1)
    for mark in drawing.marks:
        foot = _project_on_floor(mark.position, floor)
        _line(axes, view, tuple(mark.position), tuple(foot), "#C4C4C4", dashed=True)
    return written


def _project_on_floor(points: Points, floor: float) -> Points:
    """Return the points straight below on the floor."""
    return points * (1.0, 1.0, 0.0) + (0.0, 0.0, floor)


def _step(span: float, scale: float, *, small: bool = False) -> float:
    """Return the distance of ticks, m, on an axis of a span (m) and a scale (inches per metre)."""
    metres = display_unit("length").size
    fine = _TICK_STEPS if span < _MIN_TICKS * _TICK_STEPS[1] * metres else _TICK_STEPS[1:]
    if small and span < _MIN_TICKS * _TICK_STEPS[0] * metres:
        fine = (*_SMALL_TICK_STEPS, *fine)
    coarse = [float(f"{digit}e{k}") for k in range(1, 308) for digit in (2, 5, 10)]
    steps: list[float] = [*fine, *coarse]
    return next(step * metres for step in steps if step * metres * scale >= _TICK_ROOM)


def _ticks(low: float, high: float, step: float) -> list[float]:
    first, last = int(np.ceil(low / step)), int(np.floor(high / step))
    return [step * count for count in range(first, last + 1)]


def _line(
    axes: Axes,
    view: View,
    start: Place,
    stop: Place,
    colour: str = "#DDDDDD",
    *,
    dashed: bool = False,
) -> None:
    flat = view.flatten([start, stop])
    dashes = (0, (2, 2)) if dashed else "-"
    axes.plot(flat[:, 0], flat[:, 1], color=colour, lw=0.6, ls=dashes, zorder=0)


def _name_edge(
    axes: Axes, panel: Panel, room: Room, axis: int, name: str, edge: Place, ticks: list[float]
) -> list[Points]:
    """Label an edge of the room with ticks and the axis' name, on its outer side.

    Returns points under them, in the picture's metres.
    """
    view = panel.view
    along = np.eye(3)[axis]
    middle = view.flatten(edge + (room.low[axis] + room.high[axis]) / 2.0 * along)
    away = middle - view.flatten(room.corners()).mean(axis=0)
    flat = view.flatten(along)
    across = np.array([flat[1], -flat[0]]) / np.hypot(*flat)
    outward = across * np.sign(across @ away)
    unit = display_unit("length")
    notes = [(view.flatten(edge + tick * along), number(tick / unit.size)) for tick in ticks]
    offset = (12.0 if axis == 2 else 9.0) * outward
    for at, text in notes:
        _note(axes, at, offset, text, 7.5)
    turned = 90.0 if axis == 2 else 0.0
    _note(axes, middle, 29.0 * outward, f"{name} ({unit.symbol})", 8.5, turned)
    point = 1.0 / (POINTS_PER_INCH * panel.scale)  # in metres
    texts = [middle + 29.0 * point * outward, *(at + offset * point for at, _ in notes)]
    reach = 5.0 * point * np.array([[0, 0], [1, 0], [-1, 0], [0, 1], [0, -1]])
    return [text + reach for text in texts]


def _note(
    axes: Axes, at: Points, offset: Points, text: str, size: float, rotation: float = 0.0
) -> None:
    axes.annotate(
        text,
        (float(at[0]), float(at[1])),
        (float(offset[0]), float(offset[1])),
        textcoords="offset points",
        ha="center",
        va="center",
        fontsize=size,
        rotation=rotation,
        color=INK,
        annotation_clip=False,
    )
