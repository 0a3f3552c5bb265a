"""Pictures of counterfactuals: a shot, and it with each of the smallest changes."""

from __future__ import annotations

from dataclasses import replace
from itertools import cycle
from typing import TYPE_CHECKING

from matplotlib.lines import Line2D

from hoopgen.core.argument_types import check_arguments
from hoopgen.study.questions.counterfactual_result import Counterfactual

from .class_legend import Class
from .fan import draw_fan_on, draw_fan_page, key_of_ends
from .fan_paths import gather_fan
from .figure import draw_picture
from .style import LINES, PAGE, Inches

if TYPE_CHECKING:
    from hoopgen.results.drawing import Drawn

_SHOT_WIDTH, _CHANGED_WIDTH = 2.6, 1.1
"""Widths of the line of the shot, below, and of the changed ones, points."""

_SHOT_COLOUR = "#8A8A8A"
_COLOURS = (LINES["missed"]["airball"], *[*LINES["made"].values()][1:])
"""Colours of the changed shots: none is that of a part of the hoop."""

_DASHES: tuple[tuple[float, ...], ...] = ((), (4.0, 2.0), (1.5, 1.5), (5.0, 1.5, 1.0, 1.5))
"""Their lines: where paths coincide, the ones below are seen between the dashes."""


@check_arguments
def plot_counterfactual(
    answer: Counterfactual, *, title: str = "", width: Inches = PAGE, ax: Drawn | None = None
) -> Drawn:
    """Draw the path of a shot and its paths with the smallest changes, from the side, to scale.

    The path of the shot is wide and grey, below the others; those are thin, and all but the first
    are dashed, so that paths that coincide are all seen.

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
    shot, *changed = answer.names
    classes = [Class(f"the shot: {shot}", "", _SHOT_COLOUR, _SHOT_COLOUR, _SHOT_WIDTH)]
    for name, ink, dashes in zip(changed, cycle(_COLOURS), cycle(_DASHES), strict=False):
        classes.append(Class(name, "", ink, ink, _CHANGED_WIDTH, dashes))
    fan = gather_fan(answer.shots, answer.shots.parameters, range(len(classes)))
    fan = replace(fan, classes=[classes[row] for row in fan.rows], known=classes)
    key = [
        Line2D([], [], color=one.line, lw=one.width, ls=one.stroke, label=one.outcome)
        for one in classes
    ]
    key += key_of_ends(fan.ends)
    said = title or f"The shot is {answer.outcome}"
    note = f"The smallest change of each variable. Scene: {answer.scene}."
    return draw_picture(
        ax,
        lambda: draw_fan_page(fan, [], key, said, note, width),
        lambda axes: draw_fan_on(axes, fan, key, said, note),
    )
