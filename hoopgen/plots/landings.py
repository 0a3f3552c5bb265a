"""Floor plans of the places at which missed balls reach the floor."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure
from matplotlib.patches import Circle
from matplotlib.patheffects import withStroke
from matplotlib.ticker import MaxNLocator
from numpy.typing import ArrayLike

from hoopgen.core.argument_types import check_arguments
from hoopgen.core.parameters import ParameterValues, means, of_scene
from hoopgen.core.units import display_unit
from hoopgen.core.validation import as_doubles
from hoopgen.engine.compiled_scene import CompiledScene
from hoopgen.hoop.court_lines import Court, find_court
from hoopgen.report.provenance import describe_scene
from hoopgen.simulation.hoop import HOOP
from hoopgen.text.numbers import format_percent
from hoopgen.text.shorten import brief

from .figure import add_title, draw_picture, fit_view
from .floor_plan import FLOOR, add_floor, draw_floor, on_floor
from .page import ABOVE, BELOW, LEFT, add_axes, new_page
from .sectors import at_height, draw_sectors
from .style import COLOURS, DARK, PAGE, SHARE_COLOURS, Inches
from .views import Limits, Panel, Points

if TYPE_CHECKING:
    from hoopgen.results.drawing import Drawn

# Inches.
_BAR, _BAR_GAP, _BAR_LABELS = 0.12, 0.1, 0.55
_MAX_HEIGHT = 5.0

_CIRCLE_SHARES = (0.5, 0.9)
"""Shares of the balls within the circles."""

_LABEL_ANGLE = np.radians(-35.0)  # on the circle, from the middle of the court
_VISIBLE_SHARE = 0.995  # of the balls; the few that go furthest do not set the limits
_MARGIN = 0.3  # m
_MAX_CELLS = 500  # along a side, at most

_DENSE_SHARE = 0.9
"""Share of the balls that are where the density is no greater than the darkest shade stands for."""

_OUTLIER_FACTOR = 2.0
"""Times that density: with no more somewhere, the darkest shade is that of the greatest."""

_DISTANCE_NOTE = "Distances are from the point of the floor below the ring's centre."

_PLAN = replace(FLOOR, labels=("y from the ring's centre", "x from the ring's centre"))


def _share(height: float | None) -> str:
    what = "land there" if height is None else "come down there"
    return f"balls that {what} (% per {display_unit('length').symbol}²)"


@check_arguments
def plot_landings(
    x: ArrayLike,
    y: ArrayLike,
    parameters: ParameterValues,
    *,
    place: tuple[float, float] | None = None,
    height: float | None = None,
    court: str | None = None,
    scene: CompiledScene = HOOP,
    title: str = "",
    note: str = "",
    width: Inches = PAGE,
    ax: Drawn | None = None,
) -> Drawn:
    """Draw how densely balls reach the floor around the basket, to scale.

    Parameters
    ----------
    x, y
        Where the ball's centre is at floor level, (n,), m from the ring's centre: the measures
        floor_x and floor_y of the missed shots. NaN where a ball never gets there: it is counted,
        and has no place. Without any place the picture is empty, and says why.
    parameters
        Of the scene; of those that differ from shot to shot the hoop shows the mean.
    place
        Where the shots are released, x and y, m.
    height
        Of rebounds, m above the floor: x and y are rebound_x and rebound_y at that catching height,
        in place of floor_x and floor_y. With a `place` it is said how many go in which direction,
        seen from there.
    court
        Whose lines are drawn, of `hoopgen.hoop.court_lines.COURTS`; by default FIBA's for a hoop
        nearest to that preset, else the NBA's.
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
        If x and y are not (n,) both, or there is no such court.
    """
    parameters = of_scene(parameters, scene.table)
    lines = find_court(court, parameters)
    points, misses = _points(x, y)
    if place is not None and as_doubles("place", place, "x and y").shape != (2,):
        raise ValueError(f"place: expected x and y, got {brief(place)}")
    hoop = means(parameters)
    shares, away = _CIRCLE_SHARES if len(points) else (), np.hypot(*points.T)
    circles = {share: float(np.quantile(away, share)) for share in shares}
    caught = at_height(height, sectors=place is not None and len(points) > 0)
    note = f"Scene: {describe_scene(scene, parameters)}. {note}"
    places = _Landings(points, misses, circles, place, hoop, lines, note, height, caught)
    return draw_picture(
        ax, lambda: _draw(places, title, width), lambda axes: _draw_on(axes, places, title)
    )


def _points(x: ArrayLike, y: ArrayLike) -> tuple[Points, int]:
    """Return the valid places, (n, 2), and the number of balls."""
    columns = as_doubles("x", x), as_doubles("y", y)
    if columns[0].ndim != 1 or columns[0].shape != columns[1].shape:
        raise ValueError(f"x, y: expected (n,) both, got {columns[0].shape}, {columns[1].shape}")
    points = np.stack(columns, axis=1)
    return points[np.isfinite(points).all(axis=1)], len(points)


@dataclass(frozen=True)
class _Landings:
    """Landing places (n, 2) of missed balls, circles that contain shares, and the surroundings."""

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
    def full_note(self) -> str:
        """The note of the picture: how many landings it shows, its circles and the scene."""
        if not len(self.points):
            return f"{self._nowhere} {self.note}"
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
        return f"{said}. Circles hold shares of those that {down}. {_DISTANCE_NOTE} {self.note}"

    @property
    def _nowhere(self) -> str:
        """The reason why there is no place."""
        if not self.misses:
            return "No shot was missed."
        down = "reaches the floor" if self.height is None else f"comes down{self.caught}"
        return f"None of {self.misses:,} {'miss' if self.misses == 1 else 'misses'} {down}."

    @property
    def limits(self) -> Limits:
        """The limits of the view."""
        radius = max(self.circles.values(), default=0.0)
        return _limits(self.points, radius, self.scene, self.place, self.court)

    def draw(self, axes: Axes, limits: Limits) -> PolyCollection | None:
        """Draw everything but the floor on a floor plan; return the cells, None without a place."""
        cells = None
        if len(self.points):
            shown = on_floor(*self.points.T)
            cells = _draw_density(axes, shown, limits, self.scene["ball_radius"])
            _limit_shades(cells)
        for share, radius in self.circles.items():
            _draw_circle(axes, radius, share)
        if self.height is not None and self.place is not None and self.circles:
            draw_sectors(axes, self.points, self.place, max(self.circles.values()))
        if self.place is not None:
            _draw_release(axes, *on_floor(*self.place).tolist())
        return cells


def _draw(places: _Landings, title: str, width: float) -> Figure:
    """Draw the places on a page, the floor to scale."""
    beside = LEFT + _BAR_GAP + _BAR + _BAR_LABELS
    panel = Panel.fitted(_PLAN, places.limits, LEFT, BELOW, width - beside, _MAX_HEIGHT)
    page = panel.width + beside, panel.top + ABOVE
    figure = new_page(*page, title=title, note=places.full_note)
    axes = add_floor(figure, panel, places.court, places.scene)
    cells = places.draw(axes, panel.limits)
    if cells is None:
        return figure
    left_of_bar = panel.left + panel.width + _BAR_GAP
    bar = add_axes(figure, left_of_bar, panel.bottom, _BAR, panel.height, "bar")
    figure.colorbar(cells, cax=bar, label=_share(places.height))
    bar.yaxis.set_major_locator(MaxNLocator(steps=[1, 2, 5, 10]))
    return figure


def _draw_on(axes: Axes, places: _Landings, title: str) -> None:
    """Draw the places on given axes."""
    panel = fit_view(axes, _PLAN, places.limits)
    draw_floor(axes, panel, places.court, places.scene)
    cells = places.draw(axes, panel.limits)
    add_title(axes, title, places.full_note)
    if cells is None:
        return
    figure = axes.figure
    assert figure is not None
    ticks = MaxNLocator(steps=[1, 2, 5, 10])
    figure.colorbar(cells, ax=axes, label=_share(places.height), ticks=ticks)


def _draw_release(axes: Axes, across: float, up: float) -> None:
    """Mark the place of the releases on the floor plan."""
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
    """Return limits around nearly all balls, the circles, the lane and the shooter."""
    front, half = -scene["board_distance"], court.lane / 2.0
    far = (1.0 - _VISIBLE_SHARE) / 2.0
    corners = [
        *(np.quantile(points, [far, 1.0 - far], axis=0) if len(points) else ()),
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
    wide = max(spread * len(points) ** -0.25, finest, float((high - low).max()) / _MAX_CELLS)
    step = np.array([wide, wide * np.sqrt(3.0)])
    count = np.ceil((high - low) / step).astype(int)
    high = low + count * step
    share = 100.0 / len(points) / (step.prod() / 2.0) * display_unit("length").size ** 2
    inside = points[((points >= low) & (points <= high)).all(axis=1)]
    return axes.hexbin(
        inside[:, 0],
        inside[:, 1],
        C=np.full(len(inside), share),
        reduce_C_function=np.sum,
        gridsize=(int(count[0]), int(count[1])),
        extent=(low[0], high[0], low[1], high[1]),
        cmap=SHARE_COLOURS,
        vmin=0.0,
        linewidths=0.2,
        antialiaseds=False,
        rasterized=True,
        zorder=0.5,
    )


def _limit_shades(cells: PolyCollection) -> None:
    """Limit the scale so that its darkest shade stands for all extreme densities.

    A ring throws many balls to almost one place; with a shade of its own it would leave all others
    pale. The bar of colours then ends in an arrow.
    """
    density = np.sort(np.asarray(cells.get_array(), dtype=np.float64))
    upto = np.cumsum(density)
    if not upto.size or not upto[-1]:
        return
    most = float(density[np.searchsorted(upto, _DENSE_SHARE * upto[-1])])
    if density[-1] > _OUTLIER_FACTOR * most:
        shades: Any = cells.get_cmap().copy()  # whose annotation of what follows is too narrow
        shades.colorbar_extend = "max"
        cells.set_cmap(shades)
        cells.set_clim(0.0, most)


def _draw_circle(axes: Axes, radius: float, share: float) -> None:
    """Draw the circle about the point below the ring's centre that holds a share of the balls."""
    axes.add_patch(Circle((0.0, 0.0), radius, fill=False, ec=DARK, lw=0.8, ls=(0, (4, 2))))
    at = radius * np.sin(_LABEL_ANGLE), -radius * np.cos(_LABEL_ANGLE)
    unit = display_unit("length")
    axes.text(
        *at,
        f"{format_percent(share, 0)} within {radius / unit.size:.2f} {unit.symbol}",
        ha="center",
        va="center",
        fontsize=7.0,
        path_effects=[withStroke(linewidth=2.5, foreground="white")],
    )
