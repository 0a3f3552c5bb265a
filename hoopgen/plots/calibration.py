"""Pictures of calibrations: predicted probabilities beside shares made."""

from __future__ import annotations

from typing import TYPE_CHECKING

from matplotlib.axes import Axes

from hoopgen.core.argument_types import check_arguments
from hoopgen.text.numbers import format_percent

from .figure import draw_picture
from .style import COLOURS, COLUMN, INK

if TYPE_CHECKING:
    from hoopgen.results.drawing import Drawn
    from hoopgen.study.questions.assess import Assessment


@check_arguments
def plot_calibration(found: Assessment, *, title: str = "", ax: Drawn | None = None) -> Drawn:
    """Draw the share made of shots with similar probabilities against the predicted share.

    On the dashed line both are equal. Bars are the intervals of the shares made; the number of
    shots stands below each.

    Parameters
    ----------
    found
        Of `hoopgen.assess`.
    title
        Above the picture.
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
    return draw_picture(ax, (COLUMN, COLUMN), lambda axes: _draw(found, title, axes))


def _draw(found: Assessment, title: str, axes: Axes) -> None:
    axes.plot([0, 100], [0, 100], ls="--", lw=0.8, color=INK)
    for one in found.bins:
        at, share = 100.0 * one.predicted / one.shots, 100.0 * one.made / one.shots
        error = [[share - 100.0 * one.share_low], [100.0 * one.share_high - share]]
        axes.errorbar(
            at, share, yerr=error, fmt="o", ms=4, color=COLOURS["ring"], capsize=2, lw=0.9
        )
        below = (at, 100.0 * one.share_low)
        axes.annotate(
            f"{one.shots}", below, (0, -8), textcoords="offset points", fontsize=6.5, ha="center"
        )
    axes.set_xlim(-3, 103)
    axes.set_ylim(-3, 103)
    axes.set_aspect("equal")
    axes.set_xlabel("predicted to be made (%)")
    axes.set_ylabel(f"made (%, {format_percent(found.confidence, None)} interval)")
    axes.set_title(title or f"{found.total.made} of {found.total.shots} made", loc="left")
