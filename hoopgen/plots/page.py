"""A page: title and note at the top, room for pictures, room for a key at the bottom."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.layout_engine import ConstrainedLayoutEngine

from hoopgen.text.escape import printable

from .figure import Picture, set_view
from .style import INK, NARROW_PAGE, wrap
from .views import Limits, Panel, View

LEFT, RIGHT, BELOW, ABOVE = 0.58, 0.1, 0.48, 0.1
"""Room around axes to scale for their numbers and names, inches; `room_left` of long numbers."""

# Inches.
_BETWEEN = 0.68  # two views beside one another
_MARGIN = 0.1
_EDGE = 0.03  # between the name of an axis and the edge of the page
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
    """Return axes at a fixed place of the page, in inches.

    Parameters
    ----------
    figure
        The page.
    left, bottom, width, height
        The place, inches.
    label
        The label by which the axes are known.
    """
    across, up = figure.get_size_inches()
    place = (left / across, bottom / up, width / across, height / up)
    axes = figure.add_axes(place, label=label)
    axes.set_in_layout(False)
    return axes


def add_view(figure: Figure, panel: Panel) -> Axes:
    """Return axes of a side view or a plan, to scale, labelled.

    Parameters
    ----------
    figure
        The page.
    panel
        The view and its place.
    """
    place = panel.left, panel.bottom, panel.width, panel.height
    axes = add_axes(figure, *place, panel.view.name)
    set_view(axes, panel.view, panel.limits)
    return axes


def room_left(
    panels: Sequence[Panel], room: float, set_ticks: Callable[[Axes], None] | None = None
) -> float:
    """Return the room left of panels for the numbers and the names of their y axes, inches.

    Parameters
    ----------
    panels
        Those at the left edge of the page.
    room
        The least room, inches, which short numbers need.
    set_ticks
        Sets the ticks of the axes of a panel; by default they are those of `add_view`.
    """
    height = max(panel.top for panel in panels) + 1.0
    figure = Figure(figsize=(max(panel.left + panel.width for panel in panels), height))
    for panel in panels:
        axes = add_view(figure, panel)
        if set_ticks is not None:
            set_ticks(axes)
        labels = axes.yaxis.get_tightbbox()
        if labels is not None:
            needed = (axes.get_window_extent().x0 - labels.x0) / figure.dpi
            room = max(room, float(needed) + _EDGE)
    return room


def lay_pair(
    first: tuple[View, Limits],
    second: tuple[View, Limits],
    width: float,
    bottom: float,
    tallest: float,
) -> tuple[Panel, Panel]:
    """Place two views, equally high beside one another; equally wide, one above the other.

    They are one above the other on a narrow page.

    Parameters
    ----------
    first, second
        The views and their limits, from the left or from the top.
    width, bottom
        The width of the page, and where the panels begin, inches.
    tallest
        The greatest height of two views beside one another, inches.
    """
    room = width - LEFT - RIGHT
    sizes = [(right - left, top - low) for _, (left, right, low, top) in (first, second)]
    if width < NARROW_PAGE:
        lower = Panel(*second, room / sizes[1][0], LEFT, bottom)
        return Panel(*first, room / sizes[0][0], LEFT, lower.top + BELOW + ABOVE), lower
    tall = min(tallest, (room - _BETWEEN) / sum(across / up for across, up in sizes))
    one, other = (tall / up for _, up in sizes)
    beside = Panel(*first, one, LEFT, bottom)
    return beside, Panel(*second, other, LEFT + beside.width + _BETWEEN, bottom)


def stack_views(
    views: Sequence[tuple[View, Limits]], scale: float, left: float, bottom: float, gap: float
) -> list[Panel]:
    """Place views of one scale one above the other, the first on top.

    Parameters
    ----------
    views
        The views and their limits.
    scale
        Inches of the page per metre.
    left, bottom, gap
        The place of the lowest, and the room between two, inches.
    """
    panels: list[Panel] = []
    for view, limits in reversed(views):
        panels.append(Panel(view, limits, scale, left, bottom))
        bottom = panels[-1].top + gap
    return panels[::-1]
