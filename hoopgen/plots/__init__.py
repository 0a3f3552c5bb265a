"""Pictures. Needs matplotlib; lengths are drawn to scale, in metres."""

from hoopgen.plots.aim_points import plot_aim_points
from hoopgen.plots.aims import plot_aim
from hoopgen.plots.fan import plot_fan
from hoopgen.plots.film import save_film
from hoopgen.plots.landings import plot_landings
from hoopgen.plots.maps import plot_map
from hoopgen.plots.shares import plot_estimate
from hoopgen.plots.style import COLOURS, COLUMN, FORMATS, PAGE, save, style
from hoopgen.plots.trajectory import plot_trajectory

__all__ = [
    "COLOURS",
    "COLUMN",
    "FORMATS",
    "PAGE",
    "plot_aim",
    "plot_aim_points",
    "plot_estimate",
    "plot_fan",
    "plot_landings",
    "plot_map",
    "plot_trajectory",
    "save",
    "save_film",
    "style",
]
