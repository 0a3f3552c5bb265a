"""
An estimate as bars
===================

The first picture shows how shots end and what they touch, with intervals. The second shows the loss
of the same player without backspin, from the same random numbers.
"""

import numpy as np

import hoopgen
from hoopgen.plots import plot_estimate

scene = hoopgen.NBA | {"restitution": 0.75}
release = {
    "speed": 7.17,
    "elevation": np.radians(52),
    "backspin": 6 * np.pi,
    "height": 2.1336,
    "distance": 4.191,
}
scatter = {"speed": 0.07, "elevation": np.radians(1.3), "azimuth": np.radians(1)}
player = hoopgen.Scatter(release, scatter)
estimated = plot_estimate(hoopgen.estimate(player, scene, shots=20_000))

# %%
without = hoopgen.Scatter(release | {"backspin": 0}, scatter)
compared = hoopgen.compare((player, scene), (without, scene), shots=20_000)
difference = plot_estimate(compared)
