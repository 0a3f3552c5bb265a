"""Fans: paths of many shots from one place, seen from the side, coloured by how they end."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PathCollection
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Rectangle
from matplotlib.path import Path
from numpy.typing import NDArray

from hoopgen.core.parameters import ParameterValues
from hoopgen.hoop.kinds import kinds
from hoopgen.report.provenance import describe_scene
from hoopgen.results.shots import Outcome, Shots
from hoopgen.results.trajectory import Trajectory
from hoopgen.text.numbers import format_count, format_percent
from hoopgen.text.shorten import brief

from .class_legend import CLASSES, Class, classify, draw_names, names_height, outcome_classes
from .figure import add_key, add_title, draw_picture, fit_view
from .page import ABOVE, BELOW, LEFT, RIGHT, add_view, lay_pair, new_page
from .scenery import Scenery, scenery_of
from .small_multiples import (
    FOOT,
    Group,
    check_grouping,
    describe_grouping,
    draw_grid,
    group_by_angle,
    group_by_name,
    lay_grid,
)
from .style import COLOURS, EDGES, GRID, PAGE
from .ticks import few_ticks
from .views import Limits, Panel, Points, View, limits_around

if TYPE_CHECKING:
    from hoopgen.results.drawing import Drawn

__all__ = ["Fan", "bezier", "draw_fan", "gather_fan", "plot_fan"]


# Inches.
_MAX_HEIGHT = 3.5
_MAX_HEIGHT_ABOVE, _MAX_HEIGHT_PART = 2.4, 1.7  # all paths above small multiples; one of these

_LINE, _WIDE_LINE = 0.45, 0.75  # points, of many paths and of those of a small panel
_MARGIN = 0.02  # around what is drawn, of its size
_RING_MARGIN = 0.08  # m around ring and board
_ROLL_PIECE_DURATION = 0.01  # s, of a roll: less than can be seen off a parabola


def plot_fan(
    shots: Shots,
    parameters: ParameterValues,
    *,
    paths: int = 120,
    by: str = "auto",
    title: str = "",
    note: str = "",
    width: float = PAGE,
    ax: Drawn | None = None,
) -> Drawn:
    """Draw the paths of many shots from the side, to scale.

    Parameters
    ----------
    shots
        Of `hoopgen.simulate` with ``record=True``, released in about one direction.
    parameters
        Of the scene; of those that differ from shot to shot the hoop shows the mean.
    paths
        How many are drawn: of the first ones, those that have a path. The key gives the shares of
        all.
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
    if paths < 1:
        raise ValueError(f"paths: expected a number above 0, got {brief(paths)}")
    if ax is not None:
        by = _check_single_panel(by)
    fan = gather_fan(shots, parameters, range(min(paths, len(shots))))
    allowed: Sequence[str] = ("all", "outcome")
    usual, made = "outcome", ""
    if fan.hoop:
        allowed, usual = ("all", "kind", "outcome", "elevation"), "kind"
        made = f", {format_percent(float(np.mean(shots.outcome == Outcome.MADE)))} made"
    by = check_grouping(by, allowed, len(fan.curves), len(set(fan.classes)), usual)
    drawn = f"{len(fan.curves)} {'is' if len(fan.curves) == 1 else 'are'}"
    said = f"{format_count(len(shots), 'shot')}{made}; {drawn} drawn{describe_grouping(by)}."
    description = f"{said} Scene: {describe_scene(shots.scene, parameters)}. {note}"
    key = _key(shots, fan.ends)
    groups = _group_paths(fan, by)
    return draw_picture(
        ax,
        lambda: _draw(fan, groups, key, title, description, width),
        lambda axes: _draw_on(axes, fan, key, title, description),
    )


def _check_single_panel(by: str) -> str:
    """Return the grouping for given axes, which have room for one panel."""
    if by not in ("auto", "all"):
        raise ValueError(f"ax: by {brief(by)} there are several panels; leave ax out, or by")
    return "all"


def _classes(shots: Shots) -> tuple[Sequence[Class], NDArray[np.intp]]:
    """Return the classes of a scene's shots, and the index of each shot's."""
    if shots.scene.is_hoop:
        return CLASSES, classify(shots.outcome, kinds(shots.outcome, shots.counts, shots.first))
    names = [name.lower() for name in shots.scene.outcomes.__members__]
    return outcome_classes(names), np.asarray(shots.outcome, np.intp)


def _key(shots: Shots, ends: str) -> list[Line2D]:
    """Return the entries of the legend: the classes with their shares, and the line of the ends."""
    classes, codes = _classes(shots)
    shares = {classes[code]: float(np.mean(codes == code)) for code in np.unique(codes).tolist()}
    key = [
        Line2D([], [], color=one.line, label=f"{one.words} {format_percent(share)}")
        for one, share in shares.items()
    ]
    if ends:
        key.append(Line2D([], [], color=COLOURS["end"], lw=0.9, ls=(0, (5, 3)), label=ends))
    return key


def gather_fan(shots: Shots, parameters: ParameterValues, drawn: Iterable[int]) -> Fan:
    """Return the paths of the valid shots; arguments as for `plot_fan`.

    Parameters
    ----------
    shots
        The recorded shots.
    parameters
        The scene's parameters.
    drawn
        The rows of the shots to draw.

    Raises
    ------
    ValueError
        If none has: short and invalid shots have not.
    """
    flown = {shot: shots.trajectory(shot) for shot in drawn}
    flown = {shot: trajectory for shot, trajectory in flown.items() if len(trajectory.events)}
    if not flown:
        raise ValueError("shots: expected one at least that touches something or ends, got none")
    curves = [bezier(trajectory) for trajectory in flown.values()]
    hoop = None
    if shots.scene.is_hoop:
        hoop = {name: float(np.mean(np.asarray(one, float))) for name, one in parameters.items()}
    points = np.concatenate(curves)
    scenery = scenery_of(shots.scene, hoop or parameters, points)
    releases = [trajectory.release for trajectory in flown.values()]
    view = _side_view(releases)
    if hoop is None:
        view = scenery.look(scenery.views(scenery.upright(points))[0])
    classes, codes = _classes(shots)
    return Fan(
        [_project(scenery.upright(curve), view) for curve in curves],
        [classes[codes[shot]] for shot in flown],
        classes,
        view,
        scenery,
        hoop,
        [_elevation(release) for release in releases],
    )


def _project(points: Points, view: View) -> Path:
    """Return the projection of Bézier curves."""
    return Path(view.flatten(points), [Path.MOVETO, *[Path.CURVE3] * (len(points) - 1)])


def _side_view(releases: list[NDArray[np.float64]]) -> View:
    """Return the view across the line from the releases to the ring."""
    x, y = np.mean([release[:2] for release in releases], axis=0)
    angle = np.arctan2(y, x)
    right = (float(np.cos(angle)), float(np.sin(angle)), 0.0)
    labels = ("from the ring's centre", "above the ring")
    return View("side view", right, (0.0, 0.0, 1.0), labels)


def _elevation(release: NDArray[np.float64]) -> float:
    """Return the angle of a release above the horizontal, degrees."""
    return float(np.degrees(np.arctan2(release[5], np.hypot(release[3], release[4]))))


@dataclass(frozen=True)
class Fan:
    """Projected paths of the ball's centre, each with its class and release angle (°).

    The article's scene has its parameters, `hoop`; there shots have kinds. `known` are the classes
    of the scene, in order.
    """

    curves: list[Path]
    classes: list[Class]
    known: Sequence[Class]
    view: View
    scenery: Scenery
    hoop: Mapping[str, float] | None
    elevations: list[float]

    @property
    def ends(self) -> str:
        """The legend's entry for the lines at which shots end, "" if none are drawn."""
        return "" if self.hoop else self.scenery.said_of_ends

    def part(self, members: Iterable[int]) -> Fan:
        """Return a fan of some of the paths."""
        rows = list(members)
        return replace(
            self,
            curves=[self.curves[row] for row in rows],
            classes=[self.classes[row] for row in rows],
            elevations=[self.elevations[row] for row in rows],
        )

    def limits(self) -> Limits:
        """Return limits around all paths."""
        boxes = [curve.get_extents().get_points() for curve in self.curves]
        points = np.vstack([*boxes, self.view.flatten(self.scenery.corners())])
        return limits_around(points, _MARGIN * float(np.ptp(points, axis=0).max()))

    def near_the_ring(self) -> Limits:
        """Return limits around ring and board."""
        assert self.hoop is not None
        ring, ball = self.hoop["ring_radius"], self.hoop["ball_radius"]
        corners = self.view.flatten(self.scenery.corners())[:, 0]
        left, low = min(float(corners.min()), -ring) - _RING_MARGIN, -self.hoop["end_depth"] - ball
        return left, 3.0 * ring, low, max(3.0 * ring, low + 0.8 * (3.0 * ring - left))


def bezier(trajectory: Trajectory) -> NDArray[np.float64]:
    """Return a path as Bézier curves: its start, then two points for each flight (2 n + 1, 3).

    Each flight is a parabola, which is one quadratic Bézier curve; a roll is cut into short ones.
    """
    times, states, _ = trajectory.pieces(_ROLL_PIECE_DURATION)
    lasting = np.diff(times)[:, np.newaxis]
    start, velocity = states[:-1, :3], states[:-1, 3:6]
    points = np.stack([start + velocity * lasting / 2.0, states[1:, :3]], axis=1).reshape(-1, 3)
    return np.concatenate([states[:1, :3], points])


def _draw(
    fan: Fan, groups: list[Group], key: list[Line2D], title: str, note: str, width: float
) -> Figure:
    """Draw all paths on a page, in the article's scene with the part near the ring; or groups."""
    foot = names_height([str(line.get_label()) for line in key], width)
    near = fan.near_the_ring() if fan.hoop else None
    grid, panels = None, []
    bottom, tallest = foot + BELOW, _MAX_HEIGHT
    if groups:
        place = LEFT, foot + FOOT, width - LEFT - RIGHT
        part = _MAX_HEIGHT_PART if near else _MAX_HEIGHT
        grid = lay_grid(len(groups), fan.view, near or fan.limits(), place, width, part)
        bottom, tallest = grid.top + BELOW, _MAX_HEIGHT_ABOVE
    if near and not grid:
        whole = fan.view, fan.limits()
        panels = [*lay_pair(whole, (fan.view, near), width, bottom, tallest)]
    elif near or not grid:
        across = width - LEFT - RIGHT
        panels = [Panel.fitted(fan.view, fan.limits(), LEFT, bottom, across, tallest)]
    top = max([panel.top + ABOVE for panel in panels] or [grid.top if grid else 0.0])
    figure = new_page(width, top - foot, title=title, note=note, foot=foot)
    for panel in panels:
        draw_fan(add_view(figure, panel), panel, fan)
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


def _group_paths(fan: Fan, by: str) -> list[Group]:
    """Return the groups of paths, one a panel; none if all share one."""
    if by == "all":
        return []
    if by == "elevation":
        return group_by_angle(fan.elevations)
    names = [one.words if by == "kind" else one.outcome for one in fan.classes]
    order = [one.words if by == "kind" else one.outcome for one in fan.known]
    return group_by_name(names, list(dict.fromkeys(order)))


def _draw_on(axes: Axes, fan: Fan, key: list[Line2D], title: str, note: str) -> None:
    """Draw all paths on given axes."""
    draw_fan(axes, fit_view(axes, fan.view, fan.limits()), fan)
    add_title(axes, title, note)
    add_key(axes, key)


def draw_fan(axes: Axes, panel: Panel, fan: Fan, wide: float = _LINE) -> None:
    """Draw the scene and the paths on axes of `add_view`, missed shots below made ones.

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
    order = sorted(range(len(fan.curves)), key=lambda shot: fan.classes[shot].outcome == "made")
    lines = PathCollection(
        [fan.curves[shot] for shot in order],
        facecolors="none",
        edgecolors=[fan.classes[shot].line for shot in order],
        linewidths=wide,
        zorder=10.0,  # between the far half of the ring and the near one
    )
    axes.add_collection(lines)


def _outline(axes: Axes, limits: Limits) -> None:
    """Outline the part that the other panel shows."""
    left, right, bottom, top = limits
    box = Rectangle((left, bottom), right - left, top - bottom, fill=False, ec=EDGES, lw=0.5)
    axes.add_patch(box)
