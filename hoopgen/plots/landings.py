"""Where misses go: the places where the ball reaches the floor, on the floor plan."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any, TypedDict, Unpack, overload

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure
from matplotlib.patches import Circle
from matplotlib.patheffects import withStroke
from matplotlib.ticker import MaxNLocator
from numpy.typing import ArrayLike

from hoopgen.engines import HOOP, Engine
from hoopgen.hoop.courts import Court, find_court
from hoopgen.inputs import doubles
from hoopgen.phrases import percent
from hoopgen.plots.court import FLOOR, add_floor, draw_floor, on_floor
from hoopgen.plots.page import add_axes, new_page
from hoopgen.plots.panels import Panel
from hoopgen.plots.picture import add_title, check_axes, fit_view
from hoopgen.plots.sectors import at_height, draw_sectors
from hoopgen.plots.shades import limit_shades
from hoopgen.plots.style import COLOURS, DARK, PAGE, SHADES, style
from hoopgen.plots.views import Limits, Points
from hoopgen.told import say_of
from hoopgen.units import shown

__all__ = ["plot_landings"]


# Inches.
_LEFT, _BELOW, _ABOVE = 0.5, 0.46, 0.08
_BAR, _BAR_GAP, _BAR_LABELS = 0.12, 0.1, 0.55
_TALLEST = 5.0

_WITHIN = (0.5, 0.9)
"""Shares of the balls within the circles."""

_LABELLED = np.radians(-35.0)  # on the circle, from the middle of the court
_SHOWN = 0.995  # of the balls; the few that go furthest do not set the limits
_MARGIN = 0.3  # m
_CELLS = 500  # along a side, at most

_FROM = "Distances are from the point of the floor below the ring's centre."

_PLAN = replace(FLOOR, labels=("y from the ring's centre", "x from the ring's centre"))


def _share(height: float | None) -> str:
    what = "land there" if height is None else "come down there"
    return f"balls that {what} (% per {shown('length').symbol}²)"


class _Options(TypedDict, total=False):
    place: tuple[float, float] | None
    height: float | None
    court: str | None
    scene: Engine
    title: str
    note: str
    width: float


@overload
def plot_landings(
    x: ArrayLike,
    y: ArrayLike,
    parameters: Mapping[str, Any],
    *,
    ax: None = None,
    **options: Unpack[_Options],
) -> Figure: ...


@overload
def plot_landings(
    x: ArrayLike,
    y: ArrayLike,
    parameters: Mapping[str, Any],
    *,
    ax: Axes,
    **options: Unpack[_Options],
) -> Axes: ...


def plot_landings(
    x: ArrayLike,
    y: ArrayLike,
    parameters: Mapping[str, Any],
    *,
    place: tuple[float, float] | None = None,
    height: float | None = None,
    court: str | None = None,
    scene: Engine = HOOP,
    title: str = "",
    note: str = "",
    width: float = PAGE,
    ax: Axes | None = None,
) -> Figure | Axes:
    """Draw how densely balls reach the floor around the basket, to scale.

    Parameters
    ----------
    x, y
        Where the ball's centre is at floor level, (n,), m from the ring's centre: the measures
        floor_x and floor_y of the missed shots. NaN where a ball never gets there: it is counted,
        and has no place.
    parameters
        Of the scene; of those that differ from shot to shot the hoop shows the mean.
    place
        Where the shots are released, x and y, m.
    height
        Of rebounds, m above the floor: x and y are rebound_x and rebound_y at that catching height,
        in place of floor_x and floor_y. With a `place` it is said how many go in which direction,
        seen from there.
    court
        Whose lines are drawn, of `hoopgen.hoop.courts.COURTS`; by default FIBA's for a hoop nearest
        to that preset, else the NBA's.
    scene
        That the shots were simulated in, with a hoop: it is said.
    title
        Above the picture.
    note
        Said below it, after what the picture says itself: how many of them land within it, from
        where distances are, and their scene.
    width
        Of the page, inches, as of `plot_fan`.
    ax
        To draw on; the bar of colours takes its place from them.

    Returns
    -------
    Figure or Axes
        A page of its own, or `ax`; as of `plot_fan`.

    Raises
    ------
    TypeError
        If `ax` is not axes.
    ValueError
        If x and y are not (n,) both, none is a number, or there is no such court.
    """
    lines = find_court(court, parameters)
    points, misses = _points(x, y)
    hoop = {name: float(np.mean(value)) for name, value in parameters.items()}
    circles = {share: float(np.quantile(np.hypot(*points.T), share)) for share in _WITHIN}
    caught = at_height(height, sectors=place is not None)
    told = f"Scene: {say_of(scene, parameters)}. {note}"
    places = _Places(points, misses, circles, place, hoop, lines, told, height, caught)
    with style():
        if ax is not None:
            return _draw_on(check_axes(ax), places, title)
        return _draw(places, title, width)


def _points(x: ArrayLike, y: ArrayLike) -> tuple[Points, int]:
    """Return the places that there are, (n, 2), and of how many balls."""
    columns = doubles("x", x), doubles("y", y)
    if columns[0].ndim != 1 or columns[0].shape != columns[1].shape:
        raise ValueError(f"x, y: expected (n,) both, got {columns[0].shape}, {columns[1].shape}")
    points = np.stack(columns, axis=1)
    there = points[np.isfinite(points).all(axis=1)]
    if not len(there):
        raise ValueError("x, y: expected at least one place, got none that is a number")
    return there, len(points)


@dataclass(frozen=True)
class _Places:
    """Where balls land: x and y, (n, 2), of how many; radii that hold shares; what is around."""

    points: Points
    misses: int
    circles: Mapping[float, float]
    place: tuple[float, float] | None
    scene: Mapping[str, float]
    court: Court
    note: str
    height: float | None
    caught: str

    @property
    def told(self) -> str:
        """Say how many of how many are seen, what the circles hold, and what else there is."""
        left, right, bottom, top = self.limits
        across, up = on_floor(*self.points.T).T
        seen = int(((across >= left) & (across <= right) & (up >= bottom) & (up <= top)).sum())
        beyond, never = len(self.points) - seen, self.misses - len(self.points)
        of = f"{seen:,} of {self.misses:,} {'miss' if self.misses == 1 else 'misses'}"
        others = [f"{beyond:,} beyond it"] * bool(beyond)
        reach = "reaches" if never == 1 else "reach"
        there = "the floor" if self.height is None else "that height"
        others += [f"{never:,} never {reach} {there}"] * bool(never)
        down = "land" if self.height is None else "come down"
        lands = down if seen != 1 else {"land": "lands"}.get(down, "comes down")
        said = ", ".join([f"{of} {lands} within the picture", *others])
        said += f", all{self.caught}" if self.caught else ""
        return f"{said}. Circles hold shares of those that {down}. {_FROM} {self.note}"

    @property
    def limits(self) -> Limits:
        """Bound what is shown."""
        radius = max(self.circles.values())
        return _limits(self.points, radius, self.scene, self.place, self.court)

    def draw(self, axes: Axes, limits: Limits) -> PolyCollection:
        """Draw all but the floor, on a floor plan."""
        shown = on_floor(*self.points.T)
        cells = _draw_density(axes, shown, limits, self.scene["ball_radius"])
        limit_shades(cells)
        for share, radius in self.circles.items():
            _draw_circle(axes, radius, share)
        if self.height is not None and self.place is not None:
            draw_sectors(axes, self.points, self.place, max(self.circles.values()))
        if self.place is not None:
            _draw_release(axes, *on_floor(*self.place).tolist())
        return cells


def _draw(places: _Places, title: str, width: float) -> Figure:
    """Draw the places on a page, the floor to scale."""
    limits = places.limits
    beside = _LEFT + _BAR_GAP + _BAR + _BAR_LABELS
    left, right, bottom, top = limits
    scale = min((width - beside) / (right - left), _TALLEST / (top - bottom))
    panel = Panel(_PLAN, limits, scale, _LEFT, _BELOW)
    body = _BELOW + panel.height + _ABOVE
    figure = new_page(panel.width + beside, body, title=title, note=places.told)
    axes = add_floor(figure, panel, places.court, places.scene)
    cells = places.draw(axes, limits)
    left_of_bar = panel.left + panel.width + _BAR_GAP
    bar = add_axes(figure, left_of_bar, panel.bottom, _BAR, panel.height, "bar")
    figure.colorbar(cells, cax=bar, label=_share(places.height))
    bar.yaxis.set_major_locator(MaxNLocator(steps=[1, 2, 5, 10]))
    return figure


def _draw_on(axes: Axes, places: _Places, title: str) -> Axes:
    """Draw the places on axes that there are."""
    panel = fit_view(axes, _PLAN, places.limits)
    draw_floor(axes, panel, places.court, places.scene)
    cells = places.draw(axes, panel.limits)
    add_title(axes, title, places.told)
    figure = axes.figure
    assert figure is not None
    ticks = MaxNLocator(steps=[1, 2, 5, 10])
    figure.colorbar(cells, ax=axes, label=_share(places.height), ticks=ticks)
    return axes


def _draw_release(axes: Axes, across: float, up: float) -> None:
    """Mark where the shots are released, on the floor plan."""
    axes.plot(across, up, marker="x", ms=5.0, mew=1.2, color=COLOURS["release"], label="release")
    inwards = -6.0 if across > 0.0 else 6.0  # points
    axes.annotate(
        "release",
        (across, up),
        (inwards, 0.0),
        textcoords="offset points",
        ha="right" if across > 0.0 else "left",
        va="center",
        fontsize=7.0,
    )


def _limits(
    points: Points,
    radius: float,
    scene: Mapping[str, float],
    place: tuple[float, float] | None,
    court: Court,
) -> Limits:
    """Show nearly all balls, the circles to both sides, the lane, and the place of the shooter."""
    front, half = -scene["board_distance"], court.lane / 2.0
    far = (1.0 - _SHOWN) / 2.0
    corners = [
        *np.quantile(points, [far, 1.0 - far], axis=0),
        (front - court.baseline, -max(radius, half)),
        (front + court.free_throw, max(radius, half)),
        *([] if place is None else [place]),
    ]
    x, y = np.transpose(corners)
    wide = float(np.abs(y).max()) + _MARGIN
    return -wide, wide, -float(x.max()) - _MARGIN, -float(x.min()) + _MARGIN


def _draw_density(axes: Axes, points: Points, limits: Limits, finest: float) -> PolyCollection:
    """Colour hexagons by the share of the balls in them, in percent of all per m² or ft²."""
    # Scott's width in two dimensions, sd n^(-1/4), so that it shows neither noise nor too little;
    # cells smaller than a ball would only make a large file.
    spread = float(np.sqrt(points.var(axis=0).mean()))
    low, high = np.array(limits[::2]), np.array(limits[1::2])
    wide = max(spread * len(points) ** -0.25, finest, float((high - low).max()) / _CELLS)
    step = np.array([wide, wide * np.sqrt(3.0)])
    count = np.ceil((high - low) / step).astype(int)
    high = low + count * step
    share = 100.0 / len(points) / (step.prod() / 2.0) * shown("length").size ** 2
    inside = points[((points >= low) & (points <= high)).all(axis=1)]
    return axes.hexbin(
        inside[:, 0],
        inside[:, 1],
        C=np.full(len(inside), share),
        reduce_C_function=np.sum,
        gridsize=(int(count[0]), int(count[1])),
        extent=(low[0], high[0], low[1], high[1]),
        cmap=SHADES,
        vmin=0.0,
        linewidths=0.2,
        antialiaseds=False,
        rasterized=True,
        zorder=0.5,
    )


def _draw_circle(axes: Axes, radius: float, share: float) -> None:
    """Draw the circle about the point below the ring's centre that holds a share of the balls."""
    axes.add_patch(Circle((0.0, 0.0), radius, fill=False, ec=DARK, lw=0.8, ls=(0, (4, 2))))
    at = radius * np.sin(_LABELLED), -radius * np.cos(_LABELLED)
    unit = shown("length")
    axes.text(
        *at,
        f"{percent(share, 0)} within {radius / unit.size:.2f} {unit.symbol}",
        ha="center",
        va="center",
        fontsize=7.0,
        path_effects=[withStroke(linewidth=2.5, foreground="white")],
    )
