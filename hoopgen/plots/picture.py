"""A picture of its own, which notebooks show, and pictures on axes that there are already."""

from __future__ import annotations

import io
from collections.abc import Sequence
from typing import Any

from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from hoopgen.plots.panels import Panel
from hoopgen.plots.style import SMALL, style, wrap
from hoopgen.plots.ticks import label_lengths
from hoopgen.plots.views import Limits, View
from hoopgen.printable import printable

__all__ = ["Picture", "add_key", "add_title", "check_axes", "fit_view"]

_DPI = 200
"""Pixels of a picture in a notebook, an inch; twice as many as are shown, for screens that can."""


class Picture(Figure):
    """A figure that a notebook shows as it is, without pyplot.

    IPython knows figures only once pyplot is imported; from then on pyplot's settings hold.
    """

    def _repr_png_(self) -> tuple[bytes, dict[str, int]]:
        width, height = (round(_DPI / 2 * side) for side in self.get_size_inches().tolist())
        with style(), io.BytesIO() as out:
            self.savefig(out, format="png", dpi=_DPI)
            return out.getvalue(), {"width": width, "height": height}


def check_axes(ax: Any) -> Axes:
    """Return the axes to draw on.

    Raises
    ------
    TypeError
        If they are something else, such as all axes of `plt.subplots`.
    """
    if not isinstance(ax, Axes):
        raise TypeError(f"ax: expected one matplotlib Axes, got {type(ax).__name__}")
    return ax


def fit_view(axes: Axes, view: View, limits: Limits) -> Panel:
    """Make axes show a view, to scale and labelled; return it as the panel that they now are."""
    left, right, bottom, top = limits
    axes.set(xlim=(left, right), ylim=(bottom, top), aspect="equal")
    if view.labels is not None:
        label_lengths(axes, view.labels)
    axes.set_axisbelow(True)
    axes.apply_aspect()
    scale = _width(axes) / (right - left)
    return Panel(view, limits, scale, 0.0, 0.0)


def add_title(axes: Axes, title: str, *said: str, formulas: bool = False) -> None:
    """Write a title, in which nothing is mathematics, and what is said below it, broken to fit.

    Parameters
    ----------
    axes
        Above which it stands.
    title, said
        Texts of others too.
    formulas
        Whether there are some in what is said, which then is none of others'.
    """
    head = printable(title)
    lines = [head.replace("$", r"\$") if formulas else head] if title else []
    for text in map(printable, said):
        lines += [line for part in text.splitlines() for line in wrap(part, _width(axes), SMALL)]
    axes.set_title("\n".join(lines), loc="left", fontsize=SMALL, parse_math=formulas)


def add_key(axes: Axes, handles: Sequence[Artist]) -> None:
    """Write the key to the right of axes, over nothing that is drawn on them."""
    if handles:
        axes.legend(
            handles=list(handles),
            loc="upper left",
            bbox_to_anchor=(1.02, 1.0),
            borderaxespad=0.0,
            frameon=False,
            fontsize=SMALL,
        )


def _width(axes: Axes) -> float:
    """Return the width of axes, inches."""
    figure = axes.figure
    assert figure is not None
    return float(axes.get_window_extent().width / figure.dpi)
