"""Releases by distance, and how far each of speed, angle and direction alone may be off."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypedDict, Unpack, overload

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from hoopgen.plots.page import new_page
from hoopgen.plots.picture import add_title, check_axes
from hoopgen.plots.style import COLOURS, DARK, GRID, NARROW, PAGE, style
from hoopgen.told import in_a_note, say_release, say_scene
from hoopgen.words import quantity

__all__ = ["plot_aim"]

_SHOWN = ("speed", "elevation", "entry_angle")
_OFF = ("speed", "elevation", "azimuth")
_SAME = ("height", "angle", "backspin", "sidespin")
_BAND = "#A6CEE3"
_TALL = 1.9  # inches, a panel
_FEW = 40  # rows, each with a dot

_BANDS = (
    "Within a band, this one alone off, the ball still goes in; where there is none, the aimed "
    "release does not go in itself."
)


class _Options(TypedDict, total=False):
    title: str
    note: str | None
    width: float


@overload
def plot_aim(
    table: Mapping[str, NDArray[np.float64]],
    parameters: Mapping[str, Any],
    *,
    ax: None = None,
    **options: Unpack[_Options],
) -> Figure: ...


@overload
def plot_aim(
    table: Mapping[str, NDArray[np.float64]],
    parameters: Mapping[str, Any],
    *,
    ax: Axes,
    **options: Unpack[_Options],
) -> Axes: ...


def plot_aim(
    table: Mapping[str, NDArray[np.float64]],
    parameters: Mapping[str, Any],
    *,
    title: str = "",
    note: str | None = None,
    width: float = PAGE,
    ax: Axes | None = None,
) -> Figure | Axes:
    """Draw a table of releases over the distance, with what each of them forgives.

    Parameters
    ----------
    table
        Of `hoopgen.study.aim_table.aim_table`.
    parameters
        Of the scene, one number each.
    title
        Above the picture.
    note
        Below the title; by default what the bands are, the scene, and what is the same in all rows.
    width
        Of the page, inches, as of `plot_fan`.
    ax
        To draw on, how far the speed may be off alone.

    Returns
    -------
    Figure or Axes
        A page of its own, or `ax`; as of `plot_fan`.

    Raises
    ------
    TypeError
        If `ax` is not axes.
    ValueError
        If a column is missing, or no row has a release.
    """
    ends = (f"{end}_{name}" for name in _OFF for end in ("low", "high"))
    needed = ("distance", *_SHOWN, *ends)
    missing = [name for name in needed if name not in table]
    if missing:
        raise ValueError(f"table: expected that of aim_table; {', '.join(missing)} missing")
    if not np.isfinite(table["speed"]).any():
        raise ValueError("table: expected a release from one distance at least, got none")
    told = _told(table, parameters) if note is None else note
    rows, columns = (len(_SHOWN), 2) if width < NARROW else (2, len(_SHOWN))
    with style():
        if ax is not None:
            _draw_band(check_axes(ax), "speed", table)
            ax.set_xlabel(f"distance ({quantity('distance').unit})")
            add_title(ax, title, told)
            return ax
        figure = new_page(width, rows * _TALL, title=title, note=told, arrange=True)
        grid = figure.subplots(rows, columns, sharex=True, squeeze=False)
        above, below = grid.T if width < NARROW else grid
        for axes, name in zip(above, _SHOWN, strict=True):
            _draw_aimed(axes, name, table)
        for axes, name in zip(below, _OFF, strict=True):
            _draw_band(axes, name, table)
        for axes in grid[-1]:
            axes.set_xlabel(f"distance ({quantity('distance').unit})")
    return figure


def _draw_aimed(axes: Axes, name: str, table: Mapping[str, NDArray[np.float64]]) -> None:
    """Draw a variable of the aimed releases over the distance."""
    shown = quantity("entry" if name == "entry_angle" else name)
    order = np.argsort(table["distance"])
    at, values = (
        quantity("distance").shown(table["distance"][order]),
        shown.shown(table[name][order]),
    )
    marker = "o" if len(at) <= _FEW else ""
    axes.plot(at, values, color=COLOURS["path"], lw=1.2, marker=marker, ms=2.4)
    _dress(axes, shown.label)


def _draw_band(axes: Axes, name: str, table: Mapping[str, NDArray[np.float64]]) -> None:
    """Draw how far a variable alone may be off."""
    shown, order = quantity(name), np.argsort(table["distance"])
    at = quantity("distance").shown(table["distance"][order])
    aimed = table.get(name, np.zeros_like(table["distance"]))  # straight at the ring
    low, high = (shown.shown((table[f"{end}_{name}"] - aimed)[order]) for end in ("low", "high"))
    axes.fill_between(at, low, high, color=_BAND, lw=0.0)
    marker = "o" if len(at) <= _FEW else ""
    for end in (low, high):
        axes.plot(at, end, color=COLOURS["path"], lw=0.7, marker=marker, ms=1.8)
    axes.axhline(0.0, color=DARK, lw=0.6)
    label = shown.name.partition(",")[0].removeprefix("release ")
    _dress(axes, f"{label} off by ({shown.unit})")


def _dress(axes: Axes, label: str) -> None:
    axes.set_ylabel(label)
    axes.grid(color=GRID, lw=0.5)
    axes.set_axisbelow(True)
    axes.margins(x=0.02)


def _told(table: Mapping[str, NDArray[np.float64]], parameters: Mapping[str, Any]) -> str:
    same = {
        name: float(table[name][0])
        for name in _SAME
        if name in table and np.ptp(table[name]) == 0.0 and (table[name][0] or name == "height")
    }
    told = {"scene": say_scene(parameters), "release": say_release(same)}
    return f"{_BANDS} {in_a_note(told, scene=True)}"
