"""
Rebounds at catching height
===========================

The density of the places where misses from a corner come down to the height of a rebounder's hands,
and the share of each direction. Most of these misses go to the other side of the basket.
"""

import numpy as np

import hoopgen
from hoopgen.plots import plot_landings

scene = hoopgen.NBA | {"restitution": 0.75}
x, y = 0.4, 6.7  # the corner, from the ring's centre
place = {"x": x, "y": y, "height": 2.1336, "backspin": 4 * np.pi}
player = hoopgen.Scatter(
    {**place, "aim": 0.05, "elevation": np.radians(50)},
    {"speed": 0.1, "elevation": np.radians(1.5), "azimuth": np.radians(1.2)},
)
states = player.draw(0, 200_000, parameters=scene).states
shots = hoopgen.simulate(states, scene)
there = hoopgen.measure(states, shots, scene, ["rebound_x", "rebound_y"], catching_height=2.5)
plot_landings(there["rebound_x"], there["rebound_y"], scene, place=(x, y), height=2.5)
