"""
Probabilities over aim and angle
================================

With scatter each cell is a probability: how often a player who aims there makes the shot.
"""

import numpy as np

import hoopgen
from hoopgen.plots import plot_map

player = hoopgen.Scatter(
    {"height": 2.1336, "distance": 4.191, "backspin": 6 * np.pi},
    {"speed": 0.07, "elevation": np.radians(1.3), "azimuth": np.radians(1)},
)
over = {
    "aim": np.linspace(-0.15, 0.25, 41),
    "elevation": np.radians(np.linspace(44, 64, 41)),
}
plot_map(hoopgen.map(player, over, hoopgen.NBA | {"restitution": 0.75}, shots=2_000))
