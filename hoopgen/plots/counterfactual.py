"""Pictures of counterfactuals: a shot, and it with each of the smallest changes."""

from __future__ import annotations

from dataclasses import replace
from itertools import cycle
from typing import TYPE_CHECKING

from matplotlib.lines import Line2D

from hoopgen.core.argument_types import check_arguments
from hoopgen.study.questions.counterfactual_result import Counterfactual

from .class_legend import Class
from .fan import draw_fan_on, draw_fan_page
from .fan_paths import gather_fan
from .figure import draw_picture
from .style import INK, LINES, PAGE, Inches

if TYPE_CHECKING:
    from hoopgen.results.drawing import Drawn

_WIDE_LINE = 1.0  # points

_COLOURS = (INK, LINES["missed"]["airball"], *[*LINES["made"].values()][1:])
"""Colours of the shot itself, then of the changed ones: none is that of a part of the hoop."""


@check_arguments
def plot_counterfactual(
    answer: Counterfactual, *, title: str = "", width: Inches = PAGE, ax: Drawn | None = None
) -> Drawn:
    """Draw the path of a shot and its paths with the smallest changes, from the side, to scale.

    Parameters
    ----------
    answer
        Of `hoopgen.counterfactual`.
    title
        Above the picture; by default how the shot ends.
    width
        Of the page, inches: `hoopgen.plots.COLUMN` or `hoopgen.plots.PAGE`.
    ax
        To draw on, without the part near the ring. The key is to the right of them: figures with
        ``layout="constrained"`` make room for it.

    Returns
    -------
    Figure or Axes
        A page of its own, or `ax`; as of `plot_fan`.

    Raises
    ------
    TypeError
        If `ax` is not axes.
    ValueError
        If no shot has a path: a shot that neither touches anything nor ends has none.
    """
    colours = cycle(_COLOURS)
    classes = [Class(words, "", *2 * (next(colours),)) for words in answer.names]
    fan = gather_fan(answer.shots, answer.shots.parameters, range(len(classes)))
    fan = replace(fan, classes=[classes[row] for row in fan.rows], known=classes)
    key = [Line2D([], [], color=one.line, label=one.outcome) for one in classes]
    said = title or f"The shot is {answer.outcome}"
    note = f"The smallest change of each variable. Scene: {answer.scene}."
    return draw_picture(
        ax,
        lambda: draw_fan_page(fan, [], key, said, note, width, _WIDE_LINE),
        lambda axes: draw_fan_on(axes, fan, key, said, note, _WIDE_LINE),
    )
