"""Maps of outcomes, kinds or probabilities over one, two or three variables."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import QuadMesh
from matplotlib.colors import ListedColormap, Normalize
from matplotlib.figure import Figure, FigureBase
from matplotlib.patches import Patch, PathPatch
from matplotlib.path import Path
from matplotlib.ticker import FuncFormatter, MaxNLocator
from numpy.typing import NDArray

from hoopgen.core.argument_types import check_arguments
from hoopgen.hoop.court_lines import Court, find_court
from hoopgen.text.numbers import format_percent

from .class_legend import draw_names, names_height
from .contours import draw_contours
from .figure import add_key, add_title, draw_picture, fit_view
from .floor_plan import FLOOR, draw_floor, on_floor
from .map_cells import Cells, read_cells
from .page import LEFT, RIGHT, add_axes, new_page
from .small_multiples import BELOW_GRID, draw_grid, lay_grid
from .style import COLOURS, DARK, EDGES, GRID, NARROW_PAGE, NOTE_SIZE, PAGE, SHARE_COLOURS, Inches
from .views import Limits, limits_around

if TYPE_CHECKING:
    import xarray as xr

    from hoopgen.results.drawing import Drawn

_BAND_COLOUR = "#A6CEE3"
_LIGHT = COLOURS["paper"]

_LEVELS, _FEW_LEVELS = (MaxNLocator(nbins=n, steps=[1, 2, 5, 10]) for n in (8, 4))

_BEST_NOTE = "\N{WHITE CIRCLE} best"

# Inches.
_STRIP_HEIGHT = 0.9
_PANEL_ASPECT = 0.62  # of a panel, in its width
_LABELS = 0.3
_PAD = 0.08

# Inches of a page with a court.
_HEAD = 0.14
_BAR, _BAR_LABELS = 0.12, 0.62
_MAX_HEIGHT, _MIN_WIDTH = 6.0, 3.4

_FLOOR_MARGIN = 0.25  # m, around what a floor plan shows
_HATCH_NOTE = "Hatched: no such flight."


@check_arguments
def plot_map(
    dataset: xr.Dataset,
    *,
    of: str | None = None,
    title: str = "",
    note: str | None = None,
    court: str | None = None,
    width: Inches = PAGE,
    ax: Drawn | None = None,
) -> Drawn:
    """Draw a map of `hoopgen.map`.

    Over one variable a probability is a line with its interval; over two it is colours, a cell
    each, with contours that keep within the intervals, if there are a dozen cells along both. The
    best cell is marked. Kinds and outcomes are colours. Cells that have no flight are hatched. A
    third variable gives a panel for each of its values.

    Over x and y, places on the floor at a hoop, it is drawn on the court as the shooter sees it:
    to scale, the board at the top.

    Parameters
    ----------
    dataset
        As `hoopgen.map` gives it, its coordinates in SI units and in order; the first dimension is
        drawn across, the second up.
    of
        ``"probability"``, or of single shots ``"kind"`` or ``"outcome"``; by default the first
        that there is. With scatter, of a scene of one's own, one of its ends; by default the first.
    title
        Above the picture.
    note
        Below the title; by default what is the same in all cells, the scatter, the number of shots
        and the seed; on `ax`, where several maps may share one, the scene alone.
    court
        Whose lines are drawn, of `hoopgen.hoop.court_lines.COURTS`; by default FIBA's for a hoop
        nearest to that preset, else the NBA's.
    width
        Of the page, inches, as of `plot_fan`.
    ax
        To draw on, a map over one or two variables. A bar of colours takes its place from them; the
        key of kinds is to the right: figures with ``layout="constrained"`` make room for it.

    Returns
    -------
    Figure or Axes
        A page of its own, or `ax`; as of `plot_fan`.

    Raises
    ------
    TypeError
        If `ax` is not axes.
    ValueError
        If the dataset has not what is to be shown, has no dimension or too many, a coordinate
        is not numbers in order, or there is no such court.
    """
    shown = read_cells(dataset, of)
    lines = find_court(court, shown.hoop or {})
    said = shown.scene if note is None else note
    lined = shown.of == "probability" and len(shown.axes) == 1
    hatched = _HATCH_NOTE if shown.nowhere.any() and not lined else ""
    shown = replace(shown, note=f"{shown.note if note is None else note} {hatched}".strip())
    return draw_picture(
        ax,
        lambda: _draw(shown, title, width, lines, lined=lined),
        lambda axes: _draw_on(axes, shown, title, f"{said} {hatched}".strip(), lines),
    )


def _draw(shown: Cells, title: str, width: float, court: Court, *, lined: bool) -> Figure:
    """Draw a map on a page."""
    if lined:
        return _plot_line(shown, title, width)
    if shown.hoop is not None:
        return _plot_courts(shown, title, width, court)
    return _plot_panels(shown, title, width)


def _plot_line(shown: Cells, title: str, width: float) -> Figure:
    """Draw a probability over one variable."""
    body = 2.4 if width < NARROW_PAGE else 3.2
    figure = new_page(width, body, title=title, note=shown.note, arrange=True)
    _draw_line(figure.subplots(), shown)
    return figure


def _draw_on(axes: Axes, shown: Cells, title: str, note: str, court: Court) -> None:
    """Draw a map on given axes."""
    (panel, *more) = shown.panels()
    if more:
        third = shown.axes[2].quantity.name
        raise ValueError(
            f"ax: over a third variable, {third}, there is a panel for each of its "
            f"{1 + len(more)} values; select one, dataset.sel(name=value, method='nearest'), or "
            "leave ax out"
        )
    if panel.of == "probability" and len(panel.axes) == 1:
        _draw_line(axes, panel)
    else:
        axes.set_xlabel(panel.axes[0].quantity.label, parse_math=False)
        if len(panel.axes) > 1:
            axes.set_ylabel(panel.axes[1].quantity.label, parse_math=False)
        else:
            axes.set_yticks([])
    if panel.hoop is not None:
        draw_floor(axes, fit_view(axes, FLOOR, _limits(panel, court)), court, panel.hoop, over=True)
    if panel.classes:
        draw_classes(axes, panel)
        add_key(axes, _swatches(panel))
    elif len(panel.axes) > 1:
        figure = axes.figure
        assert figure is not None
        _draw_probabilities(figure, [axes], [panel])
    add_title(axes, title, note, axes.get_title(loc="left"))


def _draw_line(axes: Axes, shown: Cells) -> None:
    """Draw a probability over one variable, with its interval."""
    axis, top = shown.axes[0], shown.values
    if shown.interval is not None:
        known = np.isfinite(shown.values)  # without a flight anything may be, which says nothing
        low, top = (np.where(known, bound, np.nan) for bound in shown.interval)
        share = f"{format_percent(shown.confidence, 0)} " if shown.confidence else ""
        alone = " of the simulation alone" if shown.measured else ""
        axes.fill_between(
            axis.values, low, top, color=_BAND_COLOUR, lw=0, label=f"{share}interval{alone}"
        )
    axes.plot(axis.values, shown.values, color=COLOURS["path"], lw=1.2, label="estimate")
    best = shown.best()
    if best is not None:
        _mark(axes, shown.at(best)[0], float(shown.values[best]))
        axes.set_title(f"{_BEST_NOTE} {shown.say(best)}", loc="left", fontsize=NOTE_SIZE)
    axes.set_xlabel(axis.quantity.label, parse_math=False)
    axes.set_ylabel(shown.label, parse_math=False)
    axes.yaxis.set_major_formatter(FuncFormatter(_in_percent))
    # Of axes that share a scale, all that is on them is seen.
    others = [one.dataLim.y1 for one in axes.get_shared_y_axes().get_siblings(axes)]
    axes.set_ylim(0.0, 1.08 * max(float(np.nanmax(top, initial=0.01)), *others))
    axes.margins(x=0.0)
    axes.grid(color=GRID, lw=0.5)
    axes.set_axisbelow(True)
    if shown.interval is not None:
        axes.legend(frameon=False, fontsize=NOTE_SIZE)


def _plot_panels(shown: Cells, title: str, width: float) -> Figure:
    """Draw a map over two variables, one for each value of the third; a strip over one."""
    panels = shown.panels()
    columns = min(len(panels), 2 if width < NARROW_PAGE else 3)
    rows = -(-len(panels) // columns)
    foot = names_height([one.words for one in shown.present], width)
    tall = _STRIP_HEIGHT if len(shown.axes) == 1 else _PANEL_ASPECT * width / columns + _LABELS
    figure = new_page(width, rows * tall, title=title, note=shown.note, foot=foot, arrange=True)
    grid = figure.subplots(rows, columns, sharex=True, sharey=True, squeeze=False)
    for empty in grid.flat[len(panels) :]:
        empty.remove()
    places = list(grid.flat[: len(panels)])
    for axes, panel in zip(places, panels, strict=True):
        if len(panels) > 1:
            axes.set_title(panel.note, loc="left", fontsize=NOTE_SIZE)
    for axes in places[-columns:]:
        axes.tick_params(labelbottom=True)
    across, *up = [axis.quantity.label for axis in shown.axes]
    for axes in places[(rows - 1) * columns :]:
        axes.set_xlabel(across)
    for axes in places[::columns]:
        axes.set_ylabel(up[0] if up else "")
    if not up:
        places[0].set_yticks([])
    _fill(figure, places, shown, width)
    return figure


def _swatches(shown: Cells) -> list[Patch]:
    return [Patch(fc=one.colour, ec=EDGES, lw=0.4, label=one.words) for one in shown.present]


def _draw_cells(axes: Axes, panel: Cells, **colours: Any) -> QuadMesh:
    """Colour the cells, and hatch those that have no flight.

    Colours alone are pixels, all else stays vectors.
    """
    flat = panel.flat()
    across = flat.axes[0].edges()
    up = flat.axes[1].edges() if len(flat.axes) > 1 else np.array([0.0, 1.0])
    nowhere = np.atleast_2d(flat.nowhere.T)
    values = np.where(nowhere, np.nan, np.atleast_2d(flat.values.T))
    mesh = axes.pcolormesh(across, up, values, rasterized=True, **colours)
    mesh.set_zorder(0.5)
    if nowhere.any():
        axes.add_patch(_hatches(across, up, nowhere))
    return mesh


def _hatches(across: NDArray[Any], up: NDArray[Any], cells: NDArray[np.bool_]) -> PathPatch:
    """Return the hatching of some cells, (up, across), as one shape."""
    corners = []
    for row, line in enumerate(cells):
        ends = np.flatnonzero(np.diff(np.concatenate([[False], line, [False]])))
        for first, last in ends.reshape(-1, 2):
            (left, right), (low, high) = across[[first, last]], up[[row, row + 1]]
            corners += [(left, low), (right, low), (right, high), (left, high), (left, low)]
    codes = [Path.MOVETO, Path.LINETO, Path.LINETO, Path.LINETO, Path.CLOSEPOLY]
    shape = Path(np.array(corners), codes * (len(corners) // 5))
    return PathPatch(shape, fc="none", ec=EDGES, lw=0.0, hatch="/////", zorder=0.6)


def draw_classes(axes: Axes, panel: Cells) -> None:
    """Colour cells by the class of their shots, over one or two axes.

    Parameters
    ----------
    axes
        The axes.
    panel
        The cells.
    """
    colours = ListedColormap([one.colour for one in panel.classes])
    _draw_cells(axes, panel, cmap=colours, norm=Normalize(-0.5, len(panel.classes) - 0.5))


def _draw_probabilities(
    figure: FigureBase, places: Sequence[Axes], panels: Sequence[Cells], bar_on: Axes | None = None
) -> None:
    top = max(float(np.nanmax(panel.values, initial=0.01)) for panel in panels)
    steps = _LEVELS if len(panels) == 1 else _FEW_LEVELS
    levels = steps.tick_values(0.0, top)
    norm = Normalize(0.0, levels[-1])
    inner = [float(level) for level in levels[1:-1] if level < top]
    for axes, panel in zip(places, panels, strict=True):
        flat = panel.flat()
        mesh = _draw_cells(axes, panel, cmap=SHARE_COLOURS, norm=norm)
        if len(flat.axes) > 1:
            across, up = (axis.values for axis in flat.axes)
            draw_contours(axes, across, up, flat.values, flat.interval, inner, norm)
        best = panel.best()
        if best is not None:
            _mark(axes, *panel.point(best))
            said = f"{_BEST_NOTE} {panel.say(best)}"
            if len(panels) > 1:
                said = f"{panel.note}\n{_BEST_NOTE} {format_percent(float(panel.values[best]))}"
            axes.set_title(said, loc="left", fontsize=NOTE_SIZE)
    taken: dict[str, Any] = {"ax": list(places), "pad": 0.02} if bar_on is None else {"cax": bar_on}
    bar = figure.colorbar(mesh, label=panels[0].label, ticks=levels, **taken)
    bar.ax.yaxis.set_major_formatter(FuncFormatter(_in_percent))
    assert bar.solids is not None
    bar.solids.set_rasterized(True)


# ------------------------------------------------------------------------------------ on the court


def _plot_courts(shown: Cells, title: str, width: float, court: Court) -> Figure:
    """Draw a map over places on the floor, on a court for each value of the third variable."""
    panels = shown.panels()
    foot = names_height([one.words for one in shown.present], width)
    beside = RIGHT + (0.0 if shown.classes else _BAR + _BAR_LABELS)
    lines = (len(panels) > 1) + (shown.of == "probability")  # said above each
    place, rows = (LEFT, foot + BELOW_GRID, width - LEFT - beside), -(-len(panels) // 2)
    grid = lay_grid(
        *(len(panels), FLOOR, _limits(shown, court), place, width, _MAX_HEIGHT / rows),
        head=_PAD + _HEAD * lines,
        most=2,
    )
    wide = grid.right + beside
    height = grid.top - foot
    figure = new_page(max(wide, _MIN_WIDTH), height, title=title, note=shown.note, foot=foot)
    notes = [panel.note if len(panels) > 1 else "" for panel in panels]
    places = draw_grid(figure, grid, notes)
    for axes, one, panel in zip(places, grid.panels, panels, strict=True):
        assert panel.hoop is not None
        draw_floor(axes, one, court, panel.hoop, over=True)
    bar = None
    if not shown.classes:
        low, high = grid.panels[-1].bottom, grid.panels[0].top
        bar = add_axes(figure, wide - _BAR - _BAR_LABELS, low, _BAR, high - low, "bar")
    _fill(figure, places, shown, width, bar)
    return figure


def _fill(
    figure: Figure, places: Sequence[Axes], shown: Cells, width: float, bar: Axes | None = None
) -> None:
    """Draw the panels of a map on their axes, and the legend of its classes."""
    panels = shown.panels()
    if not shown.classes:
        _draw_probabilities(figure, places, panels, bar)
        return
    for axes, panel in zip(places, panels, strict=True):
        draw_classes(axes, panel)
    draw_names(figure, _swatches(shown), width)


def _limits(shown: Cells, court: Court) -> Limits:
    """Return limits around the cells, the basket and the lane up to the baseline."""
    assert shown.hoop is not None
    front, half = -shown.hoop["board_distance"], court.lane / 2.0
    x, y = [front - court.baseline, front + court.free_throw], [-half, half]
    ends = [axis.edges()[[0, -1]] for axis in shown.flat().axes[:2]]
    return limits_around(np.concatenate([on_floor(x, y), np.transpose(ends)]), _FLOOR_MARGIN)


def _mark(axes: Axes, x: float, y: float) -> None:
    (mark,) = axes.plot([x], [y], marker="o", ms=5.0, zorder=5.0, clip_on=False, label="_best")
    mark.set(mfc=_LIGHT, mec=DARK, mew=0.9)


def _in_percent(value: float, _: int | None = None) -> str:
    return f"{100.0 * value:.6g}"
