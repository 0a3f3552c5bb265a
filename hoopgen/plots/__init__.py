"""Pictures. Needs matplotlib; lengths are drawn to scale, in metres."""

from .aim_points import plot_aim_points
from .aim_table import plot_aim
from .animation import save_film
from .best_shots import plot_best_shots
from .calibration import plot_calibration
from .coach import plot_coach
from .coach_page import plot_coach_shots, write_coach_page
from .counterfactual import plot_counterfactual
from .estimates import plot_estimate
from .fan import plot_fan
from .landings import plot_landings
from .likelihood import plot_likelihood
from .maps import plot_map
from .proved_box import plot_box
from .style import COLOURS, COLUMN, FORMATS, PAGE, save, style
from .trajectory import plot_trajectory

__all__ = [
    "COLOURS",
    "COLUMN",
    "FORMATS",
    "PAGE",
    "plot_aim",
    "plot_aim_points",
    "plot_best_shots",
    "plot_box",
    "plot_calibration",
    "plot_coach",
    "plot_coach_shots",
    "plot_counterfactual",
    "plot_estimate",
    "plot_fan",
    "plot_landings",
    "plot_likelihood",
    "plot_map",
    "plot_trajectory",
    "save",
    "save_film",
    "style",
    "write_coach_page",
]
