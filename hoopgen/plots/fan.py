"""A fan: the paths of many shots from one place, from the side, coloured by what became of them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from typing import Any, TypedDict, Unpack, overload

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PathCollection
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Rectangle
from matplotlib.path import Path
from numpy.typing import NDArray

from hoopgen.brief import brief
from hoopgen.hoop.kinds import kinds
from hoopgen.phrases import counted, percent
from hoopgen.plots.key import CLASSES, Class, classify, draw_key, key_height
from hoopgen.plots.multiples import (
    BELOW,
    Group,
    by_angle,
    by_name,
    check_by,
    draw_grid,
    lay_grid,
    say_by,
)
from hoopgen.plots.page import add_view, new_page
from hoopgen.plots.panels import Panel
from hoopgen.plots.paths import bezier, draw_paths
from hoopgen.plots.picture import add_key, add_title, check_axes, fit_view
from hoopgen.plots.scene import draw_hoop, scene_corners
from hoopgen.plots.style import EDGES, GRID, NARROW, PAGE, style
from hoopgen.plots.ticks import few_ticks
from hoopgen.plots.views import Limits, View
from hoopgen.results import Outcome, Shots, Trajectory
from hoopgen.told import say_scene

__all__ = ["Fan", "draw_fan", "gather_fan", "plot_fan"]


# Inches.
_LEFT, _RIGHT, _BELOW, _ABOVE, _PAD = 0.55, 0.1, 0.48, 0.08, 0.08
_BETWEEN = 0.68
_TALLEST = 3.5
_TALLEST_ABOVE, _TALLEST_PART = 2.4, 1.7  # of all paths above small multiples, and of one of these

_LINE, _WIDER = 0.45, 0.75  # points, of many paths and of those of a small panel
_MARGIN = 0.08  # m around what is drawn


_BY = ("all", "kind", "outcome", "elevation")


class _Options(TypedDict, total=False):
    paths: int
    by: str
    title: str
    note: str
    width: float


@overload
def plot_fan(
    shots: Shots, parameters: Mapping[str, Any], *, ax: None = None, **options: Unpack[_Options]
) -> Figure: ...


@overload
def plot_fan(
    shots: Shots, parameters: Mapping[str, Any], *, ax: Axes, **options: Unpack[_Options]
) -> Axes: ...


def plot_fan(
    shots: Shots,
    parameters: Mapping[str, Any],
    *,
    paths: int = 120,
    by: str = "auto",
    title: str = "",
    note: str = "",
    width: float = PAGE,
    ax: Axes | None = None,
) -> Figure | Axes:
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
        by = _on_one(by)
    if not shots.scene.is_hoop:
        some = range(min(paths, len(shots)))
        return draw_paths(
            shots, parameters, some, by=by, title=title, note=note, width=width, ax=ax
        )
    place = classify(shots.outcome, kinds(shots.outcome, shots.counts, shots.first))
    shares = {CLASSES[one]: float(np.mean(place == one)) for one in np.unique(place).tolist()}
    fan = gather_fan(shots, parameters, range(min(paths, len(shots))))
    made = percent(float(np.mean(shots.outcome == Outcome.MADE)))
    drawn = f"{len(fan.curves)} {'is' if len(fan.curves) == 1 else 'are'}"
    by = check_by(by, _BY, len(fan.curves), len(set(fan.classes)), "kind")
    groups = _parted(fan, by)
    said = f"{counted(len(shots), 'shot')}, {made} made; {drawn} drawn{say_by(by)}."
    told = f"{said} Scene: {say_scene(parameters)}. {note}"
    with style():
        if ax is not None:
            return _draw_on(check_axes(ax), fan, shares, title, told)
        if groups:
            return _draw_parted(fan, groups, shares, title, told, width)
        return _draw(fan, shares, title, told, width)


def _on_one(by: str) -> str:
    """Return how paths are drawn on axes that there are: all in one panel."""
    if by not in ("auto", "all"):
        raise ValueError(f"ax: by {brief(by)} there are several panels; leave ax out, or by")
    return "all"


def gather_fan(shots: Shots, parameters: Mapping[str, Any], drawn: Iterable[int]) -> Fan:
    """Return the paths of those of some shots that have one; arguments as of `plot_fan`.

    Raises
    ------
    ValueError
        If none has: short and invalid shots have not.
    """
    place = classify(shots.outcome, kinds(shots.outcome, shots.counts, shots.first))
    flown = {shot: shots.trajectory(shot) for shot in drawn}
    flown = {shot: trajectory for shot, trajectory in flown.items() if len(trajectory.events)}
    if not flown:
        raise ValueError("shots: expected one at least that touches something or ends, got none")
    view = _from_the_side([trajectory.release for trajectory in flown.values()])
    return Fan(
        [_curve(trajectory, view) for trajectory in flown.values()],
        [CLASSES[place[shot]] for shot in flown],
        view,
        {name: float(np.mean(value)) for name, value in parameters.items()},
        [_elevation(trajectory.release) for trajectory in flown.values()],
    )


def _elevation(release: NDArray[np.float64]) -> float:
    """Return the angle of a release above the horizontal, degrees."""
    return float(np.degrees(np.arctan2(release[5], np.hypot(release[3], release[4]))))


@dataclass(frozen=True)
class Fan:
    """Paths of the ball's centre, flat, the class and release angle (°) of each; view and scene."""

    curves: list[Path]
    classes: list[Class]
    view: View
    scene: Mapping[str, float]
    elevations: list[float]

    def part(self, members: Iterable[int]) -> Fan:
        """Return some of the paths."""
        own = list(members)
        return replace(
            self,
            curves=[self.curves[one] for one in own],
            classes=[self.classes[one] for one in own],
            elevations=[self.elevations[one] for one in own],
        )

    def limits(self) -> Limits:
        """Bound all of it."""
        boxes = [curve.get_extents() for curve in self.curves]
        corners = self.view.flatten(scene_corners(self.scene))
        low = np.min([*(box.min for box in boxes), corners.min(axis=0)], axis=0) - _MARGIN
        high = np.max([*(box.max for box in boxes), corners.max(axis=0)], axis=0) + _MARGIN
        return float(low[0]), float(high[0]), float(low[1]), float(high[1])

    def near_the_ring(self) -> Limits:
        """Bound the part around ring and board."""
        corners = self.view.flatten(scene_corners(self.scene))[:, 0]
        ring, ball = self.scene["ring_radius"], self.scene["ball_radius"]
        left = min(float(corners.min()), -ring) - _MARGIN
        low = -self.scene["end_depth"] - ball
        return left, 3.0 * ring, low, max(3.0 * ring, low + 0.8 * (3.0 * ring - left))


def _from_the_side(releases: list[NDArray[np.float64]]) -> View:
    """Look across the line from the place of the releases to the ring."""
    x, y = np.mean([release[:2] for release in releases], axis=0)
    angle = np.arctan2(y, x)
    right = (float(np.cos(angle)), float(np.sin(angle)), 0.0)
    labels = ("from the ring's centre", "above the ring")
    return View("side view", right, (0.0, 0.0, 1.0), labels)


def _curve(trajectory: Trajectory, view: View) -> Path:
    """Return a path, flat."""
    points = bezier(trajectory)
    codes = np.full(len(points), Path.CURVE3)
    codes[0] = Path.MOVETO
    return Path(view.flatten(points), codes)


def _draw(fan: Fan, shares: Mapping[Class, float], title: str, note: str, width: float) -> Figure:
    """Draw all of it and the part near the ring, one beside or above the other."""
    key_width = width - 2.0 * _PAD
    foot = key_height(shares, key_width) + _PAD
    panels = _arrange(fan, width, foot)
    top = max(panel.bottom + panel.height for panel in panels)
    figure = new_page(width, top + _ABOVE - foot, title=title, note=note, foot=foot)
    for panel in panels:
        draw_fan(add_view(figure, panel), panel, fan)
    _outline(figure.axes[0], panels[1].limits)
    draw_key(figure, shares, _PAD, foot, key_width, areas=False, lines=True)
    return figure


def _parted(fan: Fan, by: str) -> list[Group]:
    """Return the paths of each panel, none where all share one."""
    if by == "all":
        return []
    if by == "elevation":
        return by_angle(fan.elevations)
    names = {one: one.words if by == "kind" else one.outcome for one in CLASSES}
    return by_name([names[one] for one in fan.classes], list(dict.fromkeys(names.values())))


def _draw_parted(
    fan: Fan,
    groups: list[Group],
    shares: Mapping[Class, float],
    title: str,
    note: str,
    width: float,
) -> Figure:
    """Draw all of it, and below each group near the ring."""
    key_width = width - 2.0 * _PAD
    foot = key_height(shares, key_width) + _PAD
    across, whole, near = width - _LEFT - _RIGHT, fan.limits(), fan.near_the_ring()
    place = _LEFT, foot + BELOW, across
    grid = lay_grid(len(groups), fan.view, near, place, width, _TALLEST_PART)
    scale = min(across / (whole[1] - whole[0]), _TALLEST_ABOVE / (whole[3] - whole[2]))
    above = Panel(fan.view, whole, scale, _LEFT, grid.top + _BELOW)
    top = above.bottom + above.height + _ABOVE
    figure = new_page(width, top - foot, title=title, note=note, foot=foot)
    whole_flight = add_view(figure, above)
    few_ticks(whole_flight)
    draw_fan(whole_flight, above, fan)
    _outline(whole_flight, near)
    places = draw_grid(figure, grid, [group.title for group in groups])
    for axes, panel, group in zip(places, grid.panels, groups, strict=True):
        draw_fan(axes, panel, fan.part(group.members), _WIDER)
    draw_key(figure, shares, _PAD, foot, key_width, areas=False, lines=True)
    return figure


def _draw_on(axes: Axes, fan: Fan, shares: Mapping[Class, float], title: str, note: str) -> Axes:
    """Draw all of it on axes that there are."""
    draw_fan(axes, fit_view(axes, fan.view, fan.limits()), fan)
    add_title(axes, title, note)
    said = {one: f"{one.words} {percent(share)}" for one, share in shares.items()}
    add_key(axes, [Line2D([], [], color=one.line, label=text) for one, text in said.items()])
    return axes


def _arrange(fan: Fan, width: float, foot: float) -> tuple[Panel, Panel]:
    """Place both panels, equally high if beside one another, equally wide if not."""
    whole, near = fan.limits(), fan.near_the_ring()
    forms = [(right - left) / (top - bottom) for left, right, bottom, top in (whole, near)]
    bottom = foot + _BELOW
    if width < NARROW:
        across = width - _LEFT - _RIGHT
        scales = [across / (limits[1] - limits[0]) for limits in (whole, near)]
        lower = Panel(fan.view, near, scales[1], _LEFT, bottom)
        upper = Panel(fan.view, whole, scales[0], _LEFT, bottom + lower.height + _BELOW)
        return upper, lower
    tall = min(_TALLEST, (width - _LEFT - _BETWEEN - _RIGHT) / sum(forms))
    scales = [tall / (limits[3] - limits[2]) for limits in (near, whole)]
    left = Panel(fan.view, near, scales[0], _LEFT, bottom)
    return Panel(fan.view, whole, scales[1], _LEFT + left.width + _BETWEEN, bottom), left


def draw_fan(axes: Axes, panel: Panel, fan: Fan, wide: float = _LINE) -> None:
    """Draw hoop and paths on axes of `add_view`, missed shots below made ones."""
    axes.grid(color=GRID, lw=0.5)
    draw_hoop(axes, panel.view, fan.scene, panel.scale)
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
    """Show which part the other panel has."""
    left, right, bottom, top = limits
    box = Rectangle((left, bottom), right - left, top - bottom, fill=False, ec=EDGES, lw=0.5)
    axes.add_patch(box)
