"""Pictures for players: what each change of a release is worth."""

from __future__ import annotations

from typing import TYPE_CHECKING

from matplotlib.axes import Axes

from hoopgen.core.argument_types import check_arguments
from hoopgen.core.units import System
from hoopgen.report.provenance import sentences
from hoopgen.study.questions.coach_result import Advice, Coaching, say
from hoopgen.text.escape import printable
from hoopgen.text.numbers import format_percent

from .figure import draw_picture
from .style import COLOURS, INK, NOTE_SIZE, PAGE, wrap

if TYPE_CHECKING:
    from hoopgen.results.drawing import Drawn


_WIDE = 4.2
"""Inches: the width of the note, beside the names of the changes."""


@check_arguments
def plot_coach(found: Coaching, *, title: str = "", ax: Drawn | None = None) -> Drawn:
    """Draw how many more of a hundred shots go in with each change, with the intervals.

    Parameters
    ----------
    found
        Of `hoopgen.coach`.
    title
        Above the picture; by default the place and the share made.
    ax
        To draw on; by default a page of its own.

    Returns
    -------
    Figure or Axes
        A page of its own, or `ax`.

    Raises
    ------
    TypeError
        If `ax` is not axes.
    """
    height = 1.1 + 0.32 * (len(found.spreads) + len(found.habits))
    return draw_picture(ax, (PAGE, height), lambda axes: _draw(found, title, axes))


def _ends(one: Advice, units: System) -> list[str]:
    return [say(one.variable, value, units) for value in (one.before, one.after)]


def _draw(found: Coaching, title: str, axes: Axes) -> None:
    rows: list[tuple[str, Advice, str]] = [
        (f"half the spread: {one.name}", one, COLOURS["ring"]) for one in found.spreads
    ]
    rows += [
        (f"{one.name}: {' to '.join(_ends(one, found.units))}", one, INK) for one in found.habits
    ]
    for at, (_, one, colour) in enumerate(rows):
        gain, low, high = (100.0 * value for value in (one.gain, one.low, one.high))
        axes.barh(at, gain, height=0.62, color=colour, alpha=0.75)
        error = [[max(gain - low, 0.0)], [max(high - gain, 0.0)]]
        axes.errorbar(gain, at, xerr=error, color=INK, capsize=2.5, lw=0.9)
    axes.set_yticks(range(len(rows)), [label for label, _, _ in rows])
    axes.invert_yaxis()
    axes.axvline(0.0, color=INK, lw=0.8)
    level = format_percent(found.confidence, None)
    note = printable(sentences(found.origin, scene=True))
    lines = [f"more made of a hundred shots ({level} interval)", *wrap(note, _WIDE, NOTE_SIZE)]
    axes.set_xlabel("\n".join(lines))
    where = "" if found.place is None else f"{found.place.name}: "
    axes.set_title(
        title or f"{where}{format_percent(found.made)} made; what would help", loc="left"
    )
