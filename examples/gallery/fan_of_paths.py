"""
Paths of a player's shots
=========================

The paths of free throws with normal errors of speed, angle and direction.
"""

import numpy as np

import hoopgen
from hoopgen.plots import plot_fan

scene = hoopgen.NBA | {"restitution": 0.75}
player = hoopgen.Scatter(
    {
        "speed": 7.17,
        "elevation": np.radians(52),
        "backspin": 6 * np.pi,
        "height": 2.1336,
        "distance": 4.191,
    },
    {"speed": 0.07, "elevation": np.radians(1.3), "azimuth": np.radians(1)},
)
states = player.draw(0, 20_000, parameters=scene).states
shots = hoopgen.simulate(states, scene, record=True)
plot_fan(shots, scene)
