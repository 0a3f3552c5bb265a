"""The paths of many shots in any scene but the hoop, from the side, coloured by how they end."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PathCollection
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.path import Path
from numpy.typing import NDArray

from hoopgen.colours import ended
from hoopgen.phrases import counted, percent
from hoopgen.plots.key import draw_names, names_height
from hoopgen.plots.multiples import BELOW, Group, by_name, check_by, draw_grid, lay_grid, say_by
from hoopgen.plots.page import add_view, new_page
from hoopgen.plots.panels import Panel
from hoopgen.plots.picture import add_key, add_title, check_axes, fit_view
from hoopgen.plots.scenery import Scenery, scenery_of
from hoopgen.plots.style import COLOURS, GRID, style
from hoopgen.plots.views import Limits, View
from hoopgen.results import Shots, Trajectory
from hoopgen.told import say_of

__all__ = ["bezier", "draw_paths"]

# Inches.
_LEFT, _RIGHT, _BELOW, _ABOVE = 0.6, 0.12, 0.5, 0.12
_TALLEST = 4.5
_LINE = 0.6  # points
_PIECE = 0.01  # s, of a roll: less than can be seen off a parabola
_MARGIN = 0.03  # of what is drawn


def draw_paths(
    shots: Shots,
    parameters: Mapping[str, Any],
    drawn: Sequence[int],
    *,
    by: str,
    title: str,
    note: str,
    width: float,
    ax: Axes | None,
) -> Figure | Axes:
    """Draw the paths of some shots; all else as for `hoopgen.plots.plot_fan`."""
    flown = {shot: shots.trajectory(shot) for shot in drawn}
    flown = {shot: trajectory for shot, trajectory in flown.items() if len(trajectory.events)}
    if not flown:
        raise ValueError("shots: expected one at least that touches something or ends, got none")
    curves = {shot: bezier(trajectory) for shot, trajectory in flown.items()}
    points = np.concatenate(list(curves.values()))
    scenery = scenery_of(shots.scene, parameters, points)
    view = scenery.look(scenery.views(scenery.upright(points))[0])
    codes = np.asarray(shots.outcome)
    shares = {one.name: float(np.mean(codes == one)) for one in shots.scene.outcomes}
    colour = ended(shots.scene.outcomes.__members__, len(shots.scene.kernels.ENDS))
    paths = [
        Path(view.flatten(scenery.upright(curve)), [Path.MOVETO, *[Path.CURVE3] * (len(curve) - 1)])
        for curve in curves.values()
    ]
    names = [shots.scene.outcomes(int(codes[shot])).name for shot in flown]
    by = check_by(by, ("all", "outcome"), len(names), len(set(names)), "outcome")
    if by == "all":
        groups = [Group("", list(range(len(names))))]
    else:
        groups = by_name([name.lower() for name in names], [name.lower() for name in shares])
    lines = [
        PathCollection(
            [paths[one] for one in group.members],
            facecolors="none",
            edgecolors=[colour[names[one]] for one in group.members],
            linewidths=_LINE,
            zorder=10.0,
        )
        for group in groups
    ]
    key = [
        Line2D([], [], color=colour[name], label=f"{name.lower()} {percent(share)}")
        for name, share in shares.items()
        if share
    ]
    if scenery.said_of_ends:
        ink = COLOURS["end"]
        key.append(Line2D([], [], color=ink, lw=0.9, ls=(0, (5, 3)), label=scenery.said_of_ends))
    limits = _limits(paths, view, scenery)
    shown = f"{len(paths)} {'is' if len(paths) == 1 else 'are'} drawn{say_by(by)}"
    scene = say_of(shots.scene, parameters)
    told = f"{counted(len(shots), 'shot')}, {shown}. Scene: {scene}. {note}"
    with style():
        if ax is not None:
            axes = check_axes(ax)
            panel = fit_view(axes, view, limits)
            add_title(axes, title, told)
            add_key(axes, key)
            _draw(axes, panel, scenery, lines[0])
            return axes
        across = width - _LEFT - _RIGHT
        foot = names_height([str(line.get_label()) for line in key], width)
        if by == "all":
            scale = min(across / (limits[1] - limits[0]), _TALLEST / (limits[3] - limits[2]))
            panel = Panel(view, limits, scale, _LEFT, foot + _BELOW)
            page = _BELOW + panel.height + _ABOVE
            figure = new_page(width, page, title=title, note=told, foot=foot)
            _draw(add_view(figure, panel), panel, scenery, lines[0])
        else:
            grid = lay_grid(
                len(groups), view, limits, (_LEFT, foot + BELOW, across), width, _TALLEST
            )
            page = grid.top - foot
            figure = new_page(width, page, title=title, note=told, foot=foot)
            places = draw_grid(figure, grid, [group.title for group in groups])
            for axes, panel, own in zip(places, grid.panels, lines, strict=True):
                _draw(axes, panel, scenery, own)
        draw_names(figure, key, width)
        return figure


def bezier(trajectory: Trajectory) -> NDArray[np.float64]:
    """Return a path as it is: its start, then two points for each flight (2 n + 1, 3).

    Each flight is a parabola, which is one quadratic Bézier curve; a roll is cut into short ones.
    """
    times, states, _ = trajectory.pieces(_PIECE)
    lasting = np.diff(times)[:, np.newaxis]
    start, velocity = states[:-1, :3], states[:-1, 3:6]
    points = np.stack([start + velocity * lasting / 2.0, states[1:, :3]], axis=1).reshape(-1, 3)
    return np.concatenate([states[:1, :3], points])


def _draw(axes: Axes, panel: Panel, scenery: Scenery, lines: PathCollection) -> None:
    axes.grid(color=GRID, lw=0.5)
    scenery.draw(axes, panel.view, panel.scale)
    scenery.draw_ends(axes, panel.view)
    axes.add_collection(lines)


def _limits(paths: list[Path], view: View, scenery: Scenery) -> Limits:
    boxes = [path.get_extents() for path in paths]
    corners = view.flatten(scenery.corners())
    low = np.min([*(box.min for box in boxes), corners.min(axis=0)], axis=0)
    high = np.max([*(box.max for box in boxes), corners.max(axis=0)], axis=0)
    air = _MARGIN * float((high - low).max())
    (left, bottom), (right, top) = low - air, high + air
    return float(left), float(right), float(bottom), float(top)
