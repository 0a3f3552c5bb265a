"""Shades of a density that a few places hold far more of than all the others."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.collections import PolyCollection

__all__ = ["limit_shades"]

_WITHIN = 0.9
"""Share of the balls that are where the density is no greater than the darkest shade stands for."""

_FAR_MORE = 2.0
"""Times that density: with no more somewhere, the darkest shade is that of the greatest."""


def limit_shades(cells: PolyCollection) -> None:
    """Let the darkest shade stand for all that is far denser than most balls are.

    A ring throws many balls to almost one place; with a shade of its own it would leave all others
    pale. The bar of colours then ends in an arrow.
    """
    density = np.sort(np.asarray(cells.get_array(), dtype=np.float64))
    upto = np.cumsum(density)
    if not upto.size or not upto[-1]:
        return
    most = float(density[np.searchsorted(upto, _WITHIN * upto[-1])])
    if density[-1] > _FAR_MORE * most:
        shades: Any = cells.get_cmap().copy()  # whose annotation of what follows is too narrow
        shades.colorbar_extend = "max"
        cells.set_cmap(shades)
        cells.set_clim(0.0, most)
