"""Maps: what becomes of a shot, or how probably it is made, over one, two or three variables."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Any, TypedDict, Unpack, overload

import numpy as np
from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.collections import QuadMesh
from matplotlib.colors import ListedColormap, Normalize
from matplotlib.contour import QuadContourSet
from matplotlib.figure import Figure, FigureBase
from matplotlib.patches import Patch
from matplotlib.ticker import FuncFormatter, MaxNLocator

from hoopgen.phrases import percent
from hoopgen.plots.cells import Cells, read_cells
from hoopgen.plots.key import CLASSES, draw_key, key_height
from hoopgen.plots.page import new_page
from hoopgen.plots.picture import add_key, add_title, check_axes
from hoopgen.plots.style import COLOURS, DARK, EDGES, GRID, NARROW, PAGE, SHADES, SMALL, style

if TYPE_CHECKING:
    import xarray as xr

__all__ = ["draw_kinds", "plot_map"]

_BAND = "#A6CEE3"
_LIGHT = COLOURS["paper"]

_LEVELS, _FEW_LEVELS = (MaxNLocator(nbins=n, steps=[1, 2, 5, 10]) for n in (8, 4))

_BEST = "\N{WHITE CIRCLE} best"

# Inches.
_STRIP = 0.9
_HEIGHT = 0.62  # of a panel, in its width
_LABELS = 0.3
_PAD = 0.08

# Of a panel's width or height.
_EDGE = 0.07  # where contours are not labelled
_APART = 0.11  # between labels, at least
_SHORT = 0.15  # a contour without label


class _Options(TypedDict, total=False):
    of: str | None
    title: str
    note: str | None
    width: float


@overload
def plot_map(dataset: xr.Dataset, *, ax: None = None, **options: Unpack[_Options]) -> Figure: ...


@overload
def plot_map(dataset: xr.Dataset, *, ax: Axes, **options: Unpack[_Options]) -> Axes: ...


def plot_map(
    dataset: xr.Dataset,
    *,
    of: str | None = None,
    title: str = "",
    note: str | None = None,
    width: float = PAGE,
    ax: Axes | None = None,
) -> Figure | Axes:
    """Draw a map of `hoopgen.map`.

    Over one variable a probability is a line with its interval; over two it is colours with
    contours, a cell each. The best cell is marked. Kinds are colours. A third variable gives a
    panel for each of its values.

    Parameters
    ----------
    dataset
        As `hoopgen.map` gives it, its coordinates in SI units and in order; the first dimension is
        drawn across, the second up.
    of
        ``"probability"`` or ``"kind"``; by default the one that there is. Of a scene of one's own
        one of its ends; by default the first.
    title
        Above the picture.
    note
        Below the title; by default what is the same in all cells, the scatter, the number of shots
        and the seed; on `ax`, where several maps may share one, the scene alone.
    width
        Of the page, inches: `hoopgen.plots.COLUMN` or `hoopgen.plots.PAGE`.
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
        If the dataset has not what is to be shown, has no dimension or too many, or a coordinate
        is not numbers in order.
    """
    shown = read_cells(dataset, of)
    if note is not None:
        shown = replace(shown, note=note)
    with style():
        if ax is not None:
            return _draw_on(check_axes(ax), shown, title, shown.scene if note is None else note)
        if shown.of == "probability" and len(shown.axes) == 1:
            return _plot_line(shown, title, width)
        return _plot_panels(shown, title, width)


def _plot_line(shown: Cells, title: str, width: float) -> Figure:
    """Draw a probability over one variable."""
    body = 2.4 if width < NARROW else 3.2
    figure = new_page(width, body, title=title, note=shown.note, arrange=True)
    _draw_line(figure.subplots(), shown)
    return figure


def _draw_on(axes: Axes, shown: Cells, title: str, note: str) -> Axes:
    """Draw a map on axes that there are."""
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
    if panel.of == "kind":
        draw_kinds(axes, panel)
        present = [CLASSES[place] for place in np.unique(panel.values)]
        add_key(axes, [Patch(fc=one.colour, ec=EDGES, label=one.words) for one in present])
    elif len(panel.axes) > 1:
        figure = axes.figure
        assert figure is not None
        _draw_probabilities(figure, [axes], [panel])
    add_title(axes, title, note, axes.get_title(loc="left"))
    return axes


def _draw_line(axes: Axes, shown: Cells) -> None:
    """Draw a probability over one variable, with its interval."""
    axis, top = shown.axes[0], shown.values
    if shown.interval is not None:
        low, top = shown.interval
        share = f"{percent(shown.confidence, 0)} " if shown.confidence else ""
        axes.fill_between(axis.values, low, top, color=_BAND, lw=0, label=f"{share}interval")
    axes.plot(axis.values, shown.values, color=COLOURS["path"], lw=1.2, label="estimate")
    best = shown.best()
    if best is not None:
        _mark(axes, shown.at(best)[0], float(shown.values[best]))
        axes.set_title(f"{_BEST} {shown.say(best)}", loc="left", fontsize=SMALL)
    axes.set_xlabel(axis.quantity.label, parse_math=False)
    axes.set_ylabel(shown.label, parse_math=False)
    axes.yaxis.set_major_formatter(FuncFormatter(_in_percent))
    axes.set_ylim(0.0, 1.08 * float(np.nanmax(top, initial=0.01)))
    axes.margins(x=0.0)
    axes.grid(color=GRID, lw=0.5)
    axes.set_axisbelow(True)
    if shown.interval is not None:
        axes.legend(frameon=False, fontsize=SMALL)


def _plot_panels(shown: Cells, title: str, width: float) -> Figure:
    """Draw a map over two variables, one for each value of the third; a strip over one."""
    panels = shown.panels()
    columns = min(len(panels), 2 if width < NARROW else 3)
    rows = -(-len(panels) // columns)
    present = [CLASSES[place] for place in np.unique(shown.values)] if shown.of == "kind" else []
    key = dict.fromkeys(present)
    foot = key_height(key, width - 2.0 * _PAD) + _PAD if key else 0.0
    tall = _STRIP if len(shown.axes) == 1 else _HEIGHT * width / columns + _LABELS
    figure = new_page(width, rows * tall, title=title, note=shown.note, foot=foot, arrange=True)
    grid = figure.subplots(rows, columns, sharex=True, sharey=True, squeeze=False)
    for empty in grid.flat[len(panels) :]:
        empty.remove()
    places = list(grid.flat[: len(panels)])
    for axes, panel in zip(places, panels, strict=True):
        if len(panels) > 1:
            axes.set_title(panel.note, loc="left", fontsize=SMALL)
    for axes in places[-columns:]:
        axes.tick_params(labelbottom=True)
    across, *up = [axis.quantity.label for axis in shown.axes]
    for axes in places[(rows - 1) * columns :]:
        axes.set_xlabel(across)
    for axes in places[::columns]:
        axes.set_ylabel(up[0] if up else "")
    if not up:
        places[0].set_yticks([])
    if key:
        for axes, panel in zip(places, panels, strict=True):
            draw_kinds(axes, panel)
        draw_key(figure, key, _PAD, foot, width - 2.0 * _PAD)
    else:
        _draw_probabilities(figure, places, panels)
    return figure


def _draw_cells(axes: Axes, panel: Cells, **colours: Any) -> QuadMesh:
    """Colour the cells; they alone are pixels, all else stays vectors."""
    up = panel.axes[1].edges() if len(panel.axes) > 1 else np.array([0.0, 1.0])
    values = np.atleast_2d(panel.values.T)
    mesh = axes.pcolormesh(panel.axes[0].edges(), up, values, rasterized=True, **colours)
    mesh.set_zorder(0.5)
    return mesh


def draw_kinds(axes: Axes, panel: Cells) -> None:
    """Colour cells by kind; one or two axes."""
    colours = ListedColormap([one.colour for one in CLASSES])
    _draw_cells(axes, panel, cmap=colours, norm=Normalize(-0.5, len(CLASSES) - 0.5))


def _draw_probabilities(
    figure: FigureBase, places: Sequence[Axes], panels: Sequence[Cells]
) -> None:
    top = max(float(np.nanmax(panel.values, initial=0.01)) for panel in panels)
    steps = _LEVELS if len(panels) == 1 else _FEW_LEVELS
    levels = steps.tick_values(0.0, top)
    norm = Normalize(0.0, levels[-1])
    inner = [float(level) for level in levels[1:-1] if level < top]
    for axes, panel in zip(places, panels, strict=True):
        mesh = _draw_cells(axes, panel, cmap=SHADES, norm=norm)
        if inner and min(panel.values.shape) > 1:
            _draw_contours(axes, panel, inner, norm)
        best = panel.best()
        if best is not None:
            _mark(axes, *panel.at(best))
            said = f"{_BEST} {panel.say(best)}"
            if len(panels) > 1:
                said = f"{panel.note}\n{_BEST} {percent(float(panel.values[best]))}"
            axes.set_title(said, loc="left", fontsize=SMALL)
    bar = figure.colorbar(mesh, ax=list(places), label=panels[0].label, ticks=levels, pad=0.02)
    bar.ax.yaxis.set_major_formatter(FuncFormatter(_in_percent))
    assert bar.solids is not None
    bar.solids.set_rasterized(True)


def _draw_contours(axes: Axes, panel: Cells, levels: list[float], norm: Normalize) -> None:
    """Draw and label contours, each in the colour that stands out on its own."""
    across, up = panel.axes
    colours = [
        DARK if _lightness(colormaps[SHADES](norm(level))) > 0.5 else _LIGHT for level in levels
    ]
    lines = axes.contour(
        across.values, up.values, panel.values.T, levels, colors=colours, linewidths=0.6
    )
    said = partial(percent, digits=None)
    axes.clabel(lines, fmt=said, fontsize=6.5, inline_spacing=2, manual=_labels(lines))


def _labels(lines: QuadContourSet) -> list[tuple[float, float]]:
    """Choose a place for the label of each contour: near its middle, off the frame and others."""
    axes = lines.axes
    to_frame = axes.transData + axes.transAxes.inverted()
    chosen: list[tuple[float, float]] = []
    taken = np.empty((0, 2))
    for path in lines.get_paths():
        for contour in map(np.asarray, path.to_polygons(closed_only=False)):
            at = to_frame.transform(contour)
            if np.ptp(at, axis=0).max() < _SHORT:
                continue
            apart = np.linalg.norm(at[:, None] - taken, axis=2).min(axis=1, initial=np.inf)
            free = np.flatnonzero((np.abs(at - 0.5).max(axis=1) < 0.5 - _EDGE) & (apart > _APART))
            if free.size:
                best = free[np.argmin(np.abs(free - len(at) / 2.0))]
                chosen.append((float(contour[best][0]), float(contour[best][1])))
                taken = np.vstack([taken, at[best]])
    return chosen


def _lightness(colour: tuple[float, float, float, float]) -> float:
    """Return about how light a colour is, from 0 to 1."""
    return float(np.dot([0.2126, 0.7152, 0.0722], colour[:3]))


def _mark(axes: Axes, x: float, y: float) -> None:
    (mark,) = axes.plot([x], [y], marker="o", ms=5.0, zorder=5.0, clip_on=False, label="_best")
    mark.set(mfc=_LIGHT, mec=DARK, mew=0.9)


def _in_percent(value: float, _: int | None = None) -> str:
    return f"{100.0 * value:.6g}"
