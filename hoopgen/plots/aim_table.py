"""Releases by distance, with the margins of speed, angle and direction."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from hoopgen.core.argument_types import check_arguments, check_mapping
from hoopgen.core.parameters import ParameterValues
from hoopgen.report.provenance import describe_hoop, describe_release, sentences
from hoopgen.report.quantities import quantity

from .figure import add_title, draw_picture
from .page import new_page
from .style import COLOURS, DARK, GRID, NARROW_PAGE, PAGE, Inches

if TYPE_CHECKING:
    from hoopgen.results.drawing import Drawn

Table = Mapping[str, NDArray[np.float64]]

_VARIABLES = ("speed", "elevation", "entry_angle")
_MARGIN_VARIABLES = ("speed", "elevation", "azimuth")
_NEEDED = (
    *("distance", *_VARIABLES),
    *(f"{end}_{name}" for name in _MARGIN_VARIABLES for end in ("low", "high")),
)
_SHARED_VARIABLES = ("height", "angle", "backspin", "sidespin")
_BAND_COLOUR = "#A6CEE3"
_PANEL_HEIGHT = 1.9  # inches, a panel
_MAX_DOTS = 40  # rows, each with a dot

_BAND_NOTE = (
    "A band is how far one variable alone may be off for the ball still to go in; where there is "
    "none, the aimed release itself misses."
)


@check_arguments
def plot_aim(
    table: Table,
    parameters: ParameterValues,
    *,
    title: str = "",
    note: str | None = None,
    width: Inches = PAGE,
    ax: Drawn | None = None,
) -> Drawn:
    """Draw a table of releases over the distance, with what each of them forgives.

    Parameters
    ----------
    table
        Of `hoopgen.study.questions.aim_table.aim_table`.
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
    check_mapping("table", table)
    check_mapping("parameters", parameters)
    missing = [name for name in _NEEDED if name not in table]
    if missing:
        raise ValueError(f"table: expected that of aim_table; {', '.join(missing)} missing")
    if not np.isfinite(table["speed"]).any():
        raise ValueError("table: expected a release from one distance at least, got none")
    description = _default_note(table, parameters) if note is None else note
    return draw_picture(
        ax,
        lambda: _draw(table, title, description, width),
        lambda axes: _draw_on(axes, table, title, description),
    )


def _draw(table: Table, title: str, note: str, width: float) -> Figure:
    """Draw all panels on a page, variables above margins or beside them."""
    narrow = width < NARROW_PAGE
    rows, columns = (len(_VARIABLES), 2) if narrow else (2, len(_VARIABLES))
    figure = new_page(width, rows * _PANEL_HEIGHT, title=title, note=note, arrange=True)
    grid = figure.subplots(rows, columns, sharex=True, squeeze=False)
    above, below = grid.T if narrow else grid
    for axes, name in zip(above, _VARIABLES, strict=True):
        _draw_variable(axes, name, table)
    for axes, name in zip(below, _MARGIN_VARIABLES, strict=True):
        _draw_band(axes, name, table)
    for axes in grid[-1]:
        axes.set_xlabel(f"distance ({quantity('distance').unit})")
    return figure


def _draw_on(axes: Axes, table: Table, title: str, note: str) -> None:
    """Draw the margin of the speed on given axes."""
    _draw_band(axes, "speed", table)
    axes.set_xlabel(f"distance ({quantity('distance').unit})")
    add_title(axes, title, note)


def _draw_variable(axes: Axes, name: str, table: Table) -> None:
    """Draw a variable of the aimed releases over the distance."""
    unit = quantity("entry" if name == "entry_angle" else name)
    order = np.argsort(table["distance"])
    at, values = (
        quantity("distance").convert(table["distance"][order]),
        unit.convert(table[name][order]),
    )
    marker = "o" if len(at) <= _MAX_DOTS else ""
    axes.plot(at, values, color=COLOURS["path"], lw=1.2, marker=marker, ms=2.4)
    _label_axes(axes, unit.label)


def _draw_band(axes: Axes, name: str, table: Table) -> None:
    """Draw how far a variable alone may be off."""
    unit, order = quantity(name), np.argsort(table["distance"])
    at = quantity("distance").convert(table["distance"][order])
    aimed = table.get(name, np.zeros_like(table["distance"]))  # straight at the ring
    low, high = (unit.convert((table[f"{end}_{name}"] - aimed)[order]) for end in ("low", "high"))
    axes.fill_between(at, low, high, color=_BAND_COLOUR, lw=0.0)
    marker = "o" if len(at) <= _MAX_DOTS else ""
    for end in (low, high):
        axes.plot(at, end, color=COLOURS["path"], lw=0.7, marker=marker, ms=1.8)
    axes.axhline(0.0, color=DARK, lw=0.6)
    label = unit.name.partition(",")[0].removeprefix("release ")
    _label_axes(axes, f"{label} off by ({unit.unit})")


def _label_axes(axes: Axes, label: str) -> None:
    axes.set_ylabel(label)
    axes.grid(color=GRID, lw=0.5)
    axes.set_axisbelow(True)
    axes.margins(x=0.02)


def _default_note(table: Table, parameters: ParameterValues) -> str:
    same = {
        name: float(table[name][0])
        for name in _SHARED_VARIABLES
        if name in table and np.ptp(table[name]) == 0.0 and (table[name][0] or name == "height")
    }
    description = {"scene": describe_hoop(parameters), "release": describe_release(same)}
    return f"{_BAND_NOTE} {sentences(description, scene=True)}"
