"""Pictures of calibrations: the profile of the likelihood of each parameter."""

from __future__ import annotations

from typing import TYPE_CHECKING

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from hoopgen.core.argument_types import check_arguments
from hoopgen.report.quantities import quantity
from hoopgen.text.escape import printable
from hoopgen.text.numbers import format_percent

from .figure import Picture, add_title, draw_picture
from .style import COLOURS, COLUMN, INK, NOTE_SIZE, PAGE, wrap

if TYPE_CHECKING:
    from hoopgen.results.drawing import Drawn
from hoopgen.study.recovery.calibrated_scene import Calibrated, CalibratedScene

_DEEPEST = 8.0
"""Log-likelihood below the maximum that is drawn."""


@check_arguments
def plot_likelihood(found: CalibratedScene, *, title: str = "", ax: Drawn | None = None) -> Drawn:
    """Draw the profile of the log-likelihood of each calibrated parameter, and its interval.

    A parameter whose profile is flat is not told by the shots.

    Parameters
    ----------
    found
        Of `hoopgen.calibrate`.
    title
        Above the picture.
    ax
        To draw on, of one parameter; by default a page of its own.

    Returns
    -------
    Figure or Axes
        A page of its own, or `ax`.

    Raises
    ------
    TypeError, ValueError
        If `ax` is not axes, or given for several parameters.
    """
    if ax is not None and len(found.values) > 1:
        raise ValueError("ax: it is of one parameter; leave it out for several")
    return draw_picture(ax, lambda: _page(found, title), lambda axes: _only(found, title, axes))


def _only(found: CalibratedScene, title: str, axes: Axes) -> None:
    (name,) = found.values
    _draw(name, found.values[name], found, axes)
    add_title(axes, title or f"{found.shots:,} shots", _note(found))


def _note(found: CalibratedScene) -> str:
    return f"Scene: {found.scene_words}."


def _page(found: CalibratedScene, title: str) -> Figure:
    count = len(found.values)
    size = (COLUMN if count == 1 else PAGE, 0.8 * COLUMN)
    figure = Picture(figsize=size, layout="constrained")
    panels = figure.subplots(1, count, sharey=True, squeeze=False)[0]
    for axes, (name, one) in zip(panels, found.values.items(), strict=True):
        _draw(name, one, found, axes)
        axes.label_outer()
    panels[0].set_title(title or f"{found.shots:,} shots", loc="left")
    note = wrap(printable(_note(found)), size[0], NOTE_SIZE)
    figure.supxlabel("\n".join(note), fontsize=NOTE_SIZE)
    return figure


def _draw(name: str, one: Calibrated, found: CalibratedScene, axes: Axes) -> None:
    shown = quantity(name)
    grid = shown.convert(one.grid)
    value, low, high = (v / shown.size for v in (one.value, one.low, one.high))
    axes.axvspan(low, high, color=COLOURS["ring"], alpha=0.15, lw=0)
    axes.plot(grid, one.profile, color=INK, lw=1.1)
    if one.identified:
        axes.plot([value], [0.0], "o", ms=4, color=COLOURS["ring"])
        text = f"{value:.3g} ({low:.3g} to {high:.3g})"
    else:
        text = "not identified"
    axes.annotate(
        text, (0.03, 0.04), xycoords="axes fraction", fontsize=7, ha="left", va="bottom", color=INK
    )
    axes.set_xlim(float(grid[0]), float(grid[-1]))
    axes.set_ylim(-_DEEPEST, 0.5)
    axes.set_xlabel(shown.label)
    level = format_percent(found.confidence, None)
    axes.set_ylabel(f"log-likelihood below the maximum\n(shaded: {level} interval)")
