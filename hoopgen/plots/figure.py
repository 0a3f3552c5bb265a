"""Figures that notebooks display, and pictures on given axes."""

from __future__ import annotations

import io
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from hoopgen.text.escape import printable

from .style import NOTE_SIZE, style, wrap
from .ticks import label_lengths
from .views import Limits, Panel, View

if TYPE_CHECKING:
    from hoopgen.results.drawing import Drawn

_DPI = 200
"""Pixels of a picture in a notebook, an inch; twice as many as are shown, for screens that can."""


class Picture(Figure):
    """A figure that a notebook displays without pyplot.

    IPython knows figures only once pyplot is imported; from then on pyplot's settings hold.
    """

    def _repr_png_(self) -> tuple[bytes, dict[str, int]]:
        width, height = (round(_DPI / 2 * side) for side in self.get_size_inches().tolist())
        with style(), io.BytesIO() as out:
            self.savefig(out, format="png", dpi=_DPI)
            return out.getvalue(), {"width": width, "height": height}


def draw_picture(
    ax: Drawn | None,
    page: Callable[[], Figure] | tuple[float, float],
    on: Callable[[Axes], None],
) -> Drawn:
    """Draw a picture on given axes and return them; without any, return a page of its own.

    Parameters
    ----------
    ax
        The axes; None for a page.
    page
        Draws the page; or the size, in inches, of one that has nothing but these axes.
    on
        Draws on axes.

    Raises
    ------
    TypeError
        If `ax` is something else, such as all axes of `plt.subplots`.
    """
    with style():
        if ax is None:
            drawn: Any = page() if callable(page) else Picture(figsize=page, layout="constrained")
            if not callable(page):
                on(drawn.add_subplot())
            return drawn  # type: ignore[no-any-return]
        if not isinstance(ax, Axes):
            raise TypeError(f"ax: expected one matplotlib Axes, got {type(ax).__name__}")
        on(ax)
        return ax


def fit_view(axes: Axes, view: View, limits: Limits) -> Panel:
    """Set up axes for a view, to scale and labelled; return the panel that they are.

    Parameters
    ----------
    axes, view
        The axes and the view.
    limits
        Left, right, bottom and top, m.
    """
    set_view(axes, view, limits)
    axes.apply_aspect()
    return Panel(view, limits, _width(axes) / (limits[1] - limits[0]), 0.0, 0.0)


def set_view(axes: Axes, view: View, limits: Limits) -> None:
    """Give axes the limits and the labels of a view; arguments as for `fit_view`."""
    axes.set(xlim=limits[:2], ylim=limits[2:], aspect="equal", axisbelow=True)
    if view.labels is not None:
        label_lengths(axes, view.labels)


def add_title(axes: Axes, title: str, *said: str, formulas: bool = False) -> None:
    """Add a title without mathematics, and lines below it, wrapped to fit.

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
        lines += [
            line for part in text.splitlines() for line in wrap(part, _width(axes), NOTE_SIZE)
        ]
    axes.set_title("\n".join(lines), loc="left", fontsize=NOTE_SIZE, parse_math=formulas)


def add_key(axes: Axes, handles: Sequence[Artist]) -> None:
    """Add a legend to the right of axes, outside of them.

    Parameters
    ----------
    axes
        The axes.
    handles
        The entries of the legend.
    """
    if handles:
        axes.legend(
            handles=list(handles),
            loc="upper left",
            bbox_to_anchor=(1.02, 1.0),
            borderaxespad=0.0,
            frameon=False,
            fontsize=NOTE_SIZE,
        )


def _width(axes: Axes) -> float:
    """Return the width of axes, inches."""
    figure = axes.figure
    assert figure is not None
    return float(axes.get_window_extent().width / figure.dpi)
