"""
Outcomes of all free throws
===========================

Without scatter each cell of a map is one shot. Its colour shows what the ball touched and whether
it fell through the ring.
"""

import numpy as np

import hoopgen
from hoopgen.plots import plot_map

player = hoopgen.Scatter({"height": 2.1336, "distance": 4.191, "backspin": 6 * np.pi})
over = {
    "speed": np.linspace(6.6, 9.2, 401),
    "elevation": np.radians(np.linspace(38, 75, 301)),
}
plot_map(hoopgen.map(player, over, hoopgen.NBA | {"restitution": 0.75}))
