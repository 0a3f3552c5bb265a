"""
The effect of backspin
======================

The probability that a player makes the shot, over backspin and for two restitutions. The argument
``ax`` draws a picture on axes of your own.
"""

import numpy as np
from matplotlib.figure import Figure

import hoopgen
from hoopgen.plots import plot_map, style

errors = {"speed": 0.07, "elevation": np.radians(1.3), "azimuth": np.radians(1)}
release = {"aim": 0.04, "elevation": np.radians(54), "height": 2.1336, "distance": 4.191}
spins = 2 * np.pi * np.arange(0, 5.1, 0.25)

with style():
    picture = Figure(figsize=(7.1, 3), layout="constrained")
    for axes, restitution in zip(picture.subplots(1, 2, sharey=True), (0.6, 0.8), strict=True):
        scene = hoopgen.PAPER | {"restitution": restitution}
        found = hoopgen.map(hoopgen.Scatter(release, errors), {"backspin": spins}, scene)
        plot_map(found, ax=axes, title=f"PAPER, restitution {restitution}", note="")
picture
