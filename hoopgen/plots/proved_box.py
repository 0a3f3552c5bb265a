"""Pictures of proved boxes of releases: how each part of a box is proved to end."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.patches import Patch
from numpy.typing import NDArray

from hoopgen.core.argument_types import check_arguments
from hoopgen.core.variables import STATE_UNITS
from hoopgen.hoop.variables import VARIABLES
from hoopgen.report.quantities import quantity
from hoopgen.text.numbers import format_count, format_percent

from .class_legend import outcome_classes
from .figure import add_key, add_title, draw_picture
from .style import EDGES, GRID, PAGE, Inches

if TYPE_CHECKING:
    from hoopgen.judge import BoxProof
    from hoopgen.results.drawing import Drawn

Numbers = NDArray[np.float64]

_ASPECT = 0.62
"""Height of a page over its width."""

_NOT_PROVED = "not proved"


@check_arguments
def plot_box(
    proof: BoxProof, *, title: str = "", width: Inches = PAGE, ax: Drawn | None = None
) -> Drawn:
    """Draw the parts of a box of releases, each in the colour of how all of it is proved to end.

    The first of the two variables is drawn across, the second up. Parts of which nothing is
    proved are grey: most lie where the outcome, or the bodies that are met, changes.

    Parameters
    ----------
    proof
        Of `hoopgen.certify_box`, of a box in which two variables have a width; with ``survey=True``
        there it shows all of the box.
    title
        Above the picture; by default what is shown.
    width
        Of the page, inches, as of `plot_fan`.
    ax
        To draw on. The key is to the right of them: figures with ``layout="constrained"`` make
        room for it.

    Returns
    -------
    Figure or Axes
        A page of its own, or `ax`; as of `plot_fan`.

    Raises
    ------
    TypeError
        If `ax` is not axes.
    ValueError
        If not two variables of the box have a width.
    """
    if len(proof.variables) != 2:
        given = ", ".join(proof.variables) or "none"
        raise ValueError(f"proof: expected a box of two variables with a width, got {given}")
    parts = format_count(len(proof.outcomes), "part")
    said = title or f"How all releases of a part are proved to end ({parts})"
    return draw_picture(ax, (width, _ASPECT * width), lambda axes: _draw_on(axes, proof, said))


def _draw_on(axes: Axes, proof: BoxProof, title: str) -> None:
    # Where there is a proof, the judge's packages are installed; pictures do without them.
    from hoopgen.judge import UNDECIDED

    units = [{} if name in VARIABLES else {"units": STATE_UNITS[name]} for name in proof.variables]
    shown = [quantity(*one) for one in zip(proof.variables, units, strict=True)]
    low = np.stack([q.convert(end) for q, end in zip(shown, proof.low.T, strict=True)], axis=1)
    high = np.stack([q.convert(end) for q, end in zip(shown, proof.high.T, strict=True)], axis=1)
    shares = np.prod(high - low, axis=1)
    shares /= shares.sum()
    classes = outcome_classes(proof.names)
    colours = {code: (one.outcome, one.colour) for code, one in enumerate(classes)}
    colours[UNDECIDED] = (_NOT_PROVED, GRID)
    key = []
    for code, (words, colour) in colours.items():
        rows = proof.outcomes == code
        if rows.any():
            # A hair line of the same colour closes the seams between parts.
            parts = _corners(low[rows], high[rows])
            axes.add_collection(PolyCollection(parts, facecolor=colour, edgecolor=colour, lw=0.1))
            share = format_percent(float(shares[rows].sum()), 1)
            key.append(Patch(facecolor=colour, edgecolor=EDGES, label=f"{words}, {share}"))
    (left, bottom), (right, top) = low.min(axis=0), high.max(axis=0)
    axes.set(xlim=(left, right), ylim=(bottom, top))
    axes.set(xlabel=shown[0].label, ylabel=shown[1].label)
    add_key(axes, key)
    add_title(axes, title)


def _corners(low: Numbers, high: Numbers) -> list[Numbers]:
    """Return the corners of m rectangles, each (4, 2)."""
    (left, bottom), (right, top) = low.T, high.T
    across = np.stack([left, right, right, left], axis=1)
    up = np.stack([bottom, bottom, top, top], axis=1)
    return list(np.stack([across, up], axis=2))
