"""
Probabilities over places
=========================

A map over x and y is drawn on the court. This player releases at 52° from every place and aims 5 cm
past the ring's centre. From hatched places there is no such flight.
"""

import numpy as np

import hoopgen
from hoopgen.plots import plot_map

player = hoopgen.Scatter(
    {"height": 2.1336, "aim": 0.05, "elevation": np.radians(52), "backspin": 6 * np.pi},
    {"speed": 0.07, "elevation": np.radians(1.3), "azimuth": np.radians(1)},
)
over = {"x": np.linspace(-1, 8.75, 40), "y": np.linspace(-7.25, 7.25, 59)}
plot_map(hoopgen.map(player, over, hoopgen.NBA | {"restitution": 0.75}, shots=1_000))
