"""Pictures. Needs matplotlib; everything drawn is to scale, in metres."""

from hoopgen.plots.style import COLOURS, FORMATS, save, style
from hoopgen.plots.trajectory import plot_trajectory

__all__ = ["COLOURS", "FORMATS", "plot_trajectory", "save", "style"]
