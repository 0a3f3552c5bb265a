"""
Landing places of misses
========================

The density of the places where the missed free throws of a player reach the floor.
"""

import numpy as np

import hoopgen
from hoopgen.plots import plot_landings

scene = hoopgen.NBA | {"restitution": 0.75}
place = {"height": 2.1336, "distance": 4.191, "backspin": 6 * np.pi}
player = hoopgen.Scatter(
    {**place, "speed": 7.17, "elevation": np.radians(52)},
    {"speed": 0.07, "elevation": np.radians(1.3), "azimuth": np.radians(1)},
)
states = player.draw(0, 200_000, parameters=scene).states
shots = hoopgen.simulate(states, scene)
floor = hoopgen.measure(states, shots, scene, ["floor_x", "floor_y"])
missed = shots.outcome == hoopgen.Outcome.MISSED
plot_landings(floor["floor_x"][missed], floor["floor_y"][missed], scene, place=(4.191, 0))
