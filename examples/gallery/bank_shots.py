"""
Aim points on the board
=======================

The picture shows, for each place, where the best bank shot touches the board and whether it is
better than the best direct shot.
"""

import numpy as np

import hoopgen
from hoopgen.plots import plot_aim_points

scene = hoopgen.NBA | {"restitution": 0.75}
player = hoopgen.Scatter(
    {"height": 2.1336, "backspin": 6 * np.pi},
    {"speed": 0.07, "elevation": np.radians(1.3), "azimuth": np.radians(1)},
)
distance, angle = np.meshgrid([2.0, 3.0, 4.2], np.radians(np.arange(-60, 61, 30)))
places = np.stack([distance * np.cos(angle), distance * np.sin(angle)], axis=-1)
found = hoopgen.bank_or_direct(player, places.reshape(-1, 2), scene, shots=2_000)
plot_aim_points(found, scene)
