"""A page: title and note at the top, room for pictures, room for a key at the bottom."""

from __future__ import annotations

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.layout_engine import ConstrainedLayoutEngine

from hoopgen.plots.panels import Panel
from hoopgen.plots.picture import Picture
from hoopgen.plots.style import INK, wrap
from hoopgen.plots.ticks import label_lengths
from hoopgen.printable import printable

__all__ = ["add_axes", "add_view", "new_page"]

# Inches.
_MARGIN = 0.1
_TITLE, _NOTE = 0.24, 0.15

_NOTE_SIZE = 7.0  # points


def new_page(
    width: float,
    body: float,
    *,
    title: str = "",
    note: str = "",
    foot: float = 0.0,
    arrange: bool = False,
) -> Figure:
    """Return a page with its head.

    Parameters
    ----------
    width
        Of the page, inches.
    body
        Height of the room for pictures, inches.
    title, note
        At the top; none where empty. The note is broken into lines.
    foot
        Height kept free below, inches.
    arrange
        Whether matplotlib arranges subplots in the body; else axes are added by `add_axes`.
    """
    title, note = printable(title), printable(note)
    lines = wrap(note, width - 2.0 * _MARGIN, _NOTE_SIZE)
    head = _TITLE * bool(title) + _NOTE * len(lines) + (_MARGIN if title or lines else 0.0)
    height = body + head + foot
    figure = Picture(figsize=(width, height))
    if arrange:
        room = (0.0, foot / height, 1.0, body / height)
        figure.set_layout_engine(ConstrainedLayoutEngine(rect=room))
    y = height - _MARGIN / 2.0
    if title:
        at = (_MARGIN / width, (y - _TITLE / 2.0) / height)
        figure.text(*at, title, va="center", fontsize=10.0, fontweight="bold")
        y -= _TITLE
    for number, line in enumerate(lines):
        at = (_MARGIN / width, (y - (number + 0.5) * _NOTE) / height)
        figure.text(*at, line, va="center_baseline", fontsize=_NOTE_SIZE, color=INK)
    return figure


def add_axes(
    figure: Figure, left: float, bottom: float, width: float, height: float, label: str
) -> Axes:
    """Return axes at a place of the page, in inches, which the layout leaves there."""
    across, up = figure.get_size_inches()
    place = (left / across, bottom / up, width / across, height / up)
    axes = figure.add_axes(place, label=label)
    axes.set_in_layout(False)
    return axes


def add_view(figure: Figure, panel: Panel) -> Axes:
    """Return axes of a side view or a plan, to scale, labelled."""
    view, (left, right, bottom, top) = panel.view, panel.limits
    axes = add_axes(figure, panel.left, panel.bottom, panel.width, panel.height, view.name)
    axes.set(xlim=(left, right), ylim=(bottom, top), aspect="equal")
    if view.labels is not None:
        label_lengths(axes, view.labels)
    axes.set_axisbelow(True)
    return axes
