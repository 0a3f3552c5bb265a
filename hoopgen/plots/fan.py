"""Fans: paths of many shots from one place, seen from the side, coloured by how they end."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PathCollection
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Rectangle
from numpy.typing import NDArray

from hoopgen.core.argument_types import check_arguments
from hoopgen.core.parameters import ParameterValues
from hoopgen.core.validation import check_count
from hoopgen.report.provenance import describe_scene
from hoopgen.results.shots import Outcome, Shots
from hoopgen.text.numbers import format_count, format_percent
from hoopgen.text.shorten import brief

from .class_legend import draw_names, names_height
from .fan_paths import Fan, classes_of, gather_fan
from .figure import add_key, add_title, draw_picture, fit_view
from .page import ABOVE, BELOW, LEFT, RIGHT, add_view, lay_pair, new_page, room_left
from .small_multiples import (
    BELOW_GRID,
    Grid,
    Group,
    check_grouping,
    describe_grouping,
    draw_grid,
    group_by_angle,
    group_by_name,
    lay_grid,
)
from .style import COLOURS, EDGES, GRID, PAGE, Inches
from .ticks import few_ticks
from .views import Limits, Panel

if TYPE_CHECKING:
    from hoopgen.results.drawing import Drawn

# Inches.
_MAX_HEIGHT = 3.5
_MAX_HEIGHT_ABOVE, _MAX_HEIGHT_PART = 2.4, 1.7  # all paths above small multiples; one of these

_LINE, _WIDE_LINE = 0.45, 0.75  # points, of many paths and of those of a small panel


@check_arguments
def plot_fan(
    shots: Shots,
    parameters: ParameterValues,
    *,
    paths: int = 120,
    by: str = "auto",
    title: str = "",
    note: str = "",
    width: Inches = PAGE,
    ax: Drawn | None = None,
) -> Drawn:
    """Draw the paths of many shots from the side, to scale.

    In a scene of one's own, paths that are all but level, or on a table that leans, are seen from
    above.

    Parameters
    ----------
    shots
        Of `hoopgen.simulate` with ``record=True``, released in about one direction.
    parameters
        Of the scene; of those that differ from shot to shot the hoop shows the mean.
    paths
        How many are drawn: of the first ones, those that have a path. The key gives the shares of
        all that are valid.
    by
        What has a panel of its own: ``"kind"`` of shot (made or missed, and what was touched),
        ``"outcome"``, or the release ``"elevation"``, at round angles; ``"all"`` for one panel.
        ``"auto"`` parts more than 40 paths by kind, fewer not. Of a scene that is not the article's
        there are ``"outcome"``, which it then stands for, and ``"all"``.
    title
        Above the picture.
    note
        Said below it, after what the picture says itself: how many there are, and their scene.
    width
        Of the page, inches: `hoopgen.plots.COLUMN` or `hoopgen.plots.PAGE`.
    ax
        To draw on, all in one panel, without the part near the ring. The key is to the right of
        them: figures with ``layout="constrained"`` make room for it.

    Returns
    -------
    Figure or Axes
        A page of its own, which notebooks show and `hoopgen.plots.save` writes, not known to
        pyplot; or `ax`, where it is given.

    Raises
    ------
    TypeError
        If `ax` is not axes.
    AttributeError
        If the shots were simulated without their events, outcome, counts or first.
    ValueError
        If none of them has a path, `paths` is not above 0, `by` is none of those, or there are to
        be several panels on `ax`.
    """
    check_count("paths", paths)
    if ax is not None:
        by = _check_single_panel(by)
    fan = gather_fan(shots, parameters, range(min(paths, len(shots))))
    allowed: Sequence[str] = ("all", "outcome")
    usual, made, valid = "outcome", "", _valid(shots)
    if fan.hoop:
        allowed, usual = ("all", "kind", "outcome", "elevation"), "kind"
        made = f", {format_percent(float(np.mean(shots.outcome[valid] == Outcome.MADE)))} made"
    by = check_grouping(by, allowed, len(fan.curves), len(set(fan.classes)), usual)
    drawn = f"{len(fan.curves)} {'is' if len(fan.curves) == 1 else 'are'}"
    simulated = f"{format_count(len(shots), 'shot')}{made}"
    if not valid.all():
        counted = format_count(int(valid.sum()), "valid shot")
        simulated = f"{counted}{made}, and {len(shots) - int(valid.sum()):,} invalid"
    said = f"{simulated}; {drawn} drawn{describe_grouping(by)}."
    description = f"{said} Scene: {describe_scene(shots.scene, parameters)}. {note}"
    key = _key(shots, fan.ends)
    groups = _group_paths(fan, by)
    return draw_picture(
        ax,
        lambda: draw_fan_page(fan, groups, key, title, description, width),
        lambda axes: draw_fan_on(axes, fan, key, title, description),
    )


def _check_single_panel(by: str) -> str:
    """Return the grouping for given axes, which have room for one panel."""
    if by not in ("auto", "all"):
        raise ValueError(f"ax: by {brief(by)} there are several panels; leave ax out, or by")
    return "all"


def _key(shots: Shots, ends: str) -> list[Line2D]:
    """Return the entries of the legend: the classes with their shares, and the line of the ends."""
    classes, codes = classes_of(shots)
    codes = codes[_valid(shots)]
    shares = {classes[code]: float(np.mean(codes == code)) for code in np.unique(codes).tolist()}
    key = [
        Line2D([], [], color=one.line, label=f"{one.words} {format_percent(share)}")
        for one, share in shares.items()
    ]
    return [*key, *key_of_ends(ends)]


def _valid(shots: Shots) -> NDArray[np.bool_]:
    found: NDArray[np.bool_] = shots.outcome != shots.scene.outcomes["INVALID"]
    return found


def key_of_ends(ends: str) -> list[Line2D]:
    """Return the legend's entry for the lines at which shots end, none if `ends` is empty."""
    look: Any = {"color": COLOURS["end"], "lw": 0.9, "ls": (0, (5, 3))}
    return [Line2D([], [], label=ends, **look)] if ends else []


def draw_fan_page(
    fan: Fan,
    groups: list[Group],
    key: list[Line2D],
    title: str,
    note: str,
    width: float,
    wide: float = _LINE,
) -> Figure:
    """Draw all paths on a page, in the article's scene with the part near the ring; or groups.

    Parameters
    ----------
    fan
        The paths.
    groups
        Those that have a panel of their own; none if all share one.
    key
        The entries of the legend.
    title, note
        Above the picture and below its title.
    width
        Of the page, inches.
    wide
        The width of the lines where all share a panel, points.
    """
    foot = names_height([str(line.get_label()) for line in key], width)
    near = fan.near_the_ring() if fan.hoop else None
    grid, panels = _arrange(fan, len(groups), near, foot, width, LEFT)
    if not near:
        shown, ticks = (grid.panels[:1], few_ticks) if grid else (panels, None)
        left = room_left(shown, LEFT, ticks)
        if left > LEFT:
            grid, panels = _arrange(fan, len(groups), near, foot, width, left)
    top = max([panel.top + ABOVE for panel in panels] or [grid.top if grid else 0.0])
    figure = new_page(width, top - foot, title=title, note=note, foot=foot)
    for panel in panels:
        draw_fan(add_view(figure, panel), panel, fan, wide)
    if near:
        _outline(figure.axes[0], near)
    if grid:
        for axes in figure.axes:
            few_ticks(axes)
        places = draw_grid(figure, grid, [group.title for group in groups])
        for axes, panel, group in zip(places, grid.panels, groups, strict=True):
            draw_fan(axes, panel, fan.part(group.members), _WIDE_LINE)
    draw_names(figure, key, width)
    return figure


def _arrange(
    fan: Fan, groups: int, near: Limits | None, foot: float, width: float, left: float
) -> tuple[Grid | None, list[Panel]]:
    """Place the grid of the groups, if there are any, and the panels of all paths above it."""
    grid, panels = None, []
    bottom, tallest = foot + BELOW, _MAX_HEIGHT
    across = width - left - RIGHT
    if groups:
        place = left, foot + BELOW_GRID, across
        part = _MAX_HEIGHT_PART if near else _MAX_HEIGHT
        grid = lay_grid(groups, fan.view, near or fan.limits(), place, width, part)
        bottom, tallest = grid.top + BELOW, _MAX_HEIGHT_ABOVE
    if near and not grid:
        whole = fan.view, fan.limits()
        panels = [*lay_pair(whole, (fan.view, near), width, bottom, tallest)]
    elif near or not grid:
        panels = [Panel.fitted(fan.view, fan.limits(), left, bottom, across, tallest)]
    return grid, panels


def _group_paths(fan: Fan, by: str) -> list[Group]:
    """Return the groups of paths, one a panel; none if all share one."""
    if by == "all":
        return []
    if by == "elevation":
        return group_by_angle(fan.elevations)
    names = [one.words if by == "kind" else one.outcome for one in fan.classes]
    order = [one.words if by == "kind" else one.outcome for one in fan.known]
    return group_by_name(names, list(dict.fromkeys(order)))


def draw_fan_on(
    axes: Axes, fan: Fan, key: list[Line2D], title: str, note: str, wide: float = _LINE
) -> None:
    """Draw all paths on given axes.

    Parameters
    ----------
    axes
        The axes.
    fan, key, title, note, wide
        As of `draw_fan_page`.
    """
    draw_fan(axes, fit_view(axes, fan.view, fan.limits()), fan, wide)
    add_title(axes, title, note)
    add_key(axes, key)


def draw_fan(axes: Axes, panel: Panel, fan: Fan, wide: float = _LINE) -> None:
    """Draw the scene and the paths on axes of `add_view`, wide lines below, then missed shots.

    Parameters
    ----------
    axes
        The axes.
    panel
        Their view and scale.
    fan
        The paths.
    wide
        The width of the lines, points.
    """
    axes.grid(color=GRID, lw=0.5)
    fan.scenery.draw(axes, panel.view, panel.scale)
    if fan.ends:
        fan.scenery.draw_ends(axes, panel.view)
    order = sorted(
        range(len(fan.curves)),
        key=lambda shot: (-fan.classes[shot].width, fan.classes[shot].outcome == "made"),
    )
    lines = PathCollection(
        [fan.curves[shot] for shot in order],
        facecolors="none",
        edgecolors=[fan.classes[shot].line for shot in order],
        linewidths=[fan.classes[shot].width or wide for shot in order],
        linestyles=[fan.classes[shot].stroke for shot in order],
        zorder=10.0,  # between the far half of the ring and the near one
    )
    axes.add_collection(lines)


def _outline(axes: Axes, limits: Limits) -> None:
    """Outline the part that the other panel shows."""
    left, right, bottom, top = limits
    box = Rectangle((left, bottom), right - left, top - bottom, fill=False, ec=EDGES, lw=0.5)
    axes.add_patch(box)
