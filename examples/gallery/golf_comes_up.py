"""
A golf ball that comes up again
===============================

A ball that rolls inside a vertical cylinder does not roll down: it goes up and down between two
heights, √(κ/(1 + κ)) times in a turn about the axis, with κ = I/(mR²), which is 2/5 for a solid
ball. (Gualtieri, Tokieda, Advis-Gaete, Carry, Reffet and Guthmann, *Golfer's dilemma*,
American Journal of Physics 74, 497, 2006.) Here the cup of ``examples/scenes/golf.toml`` is a metre
deep, and the ball starts on its wall.
"""

from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

import hoopgen
from hoopgen.plots import style

golf = hoopgen.load_scene(Path("../scenes/golf.toml"))  # from the folder of this script
ball, hole, gravity, kappa = 0.02135, 0.054, 9.81, 2 / 5
circle, speed = hole - ball, 0.6
start = [circle, 0, 0, 0, speed, 0, 0, 0, -speed / ball]  # it rolls along the wall
shot = hoopgen.simulate(
    start, {"cup_depth": 1}, scene=golf, leaving="cup", time_limit=2, record=True
)

times = np.linspace(0, 2, 500)
heights = shot.trajectory(0).at(times)[:, 2]
rate = speed / circle * np.sqrt(kappa / (1 + kappa))
formula = -gravity / (1 + kappa) / rate**2 * (1 - np.cos(rate * times))
print(f"largest difference from the formula: {np.abs(heights - formula).max():.0e} m")

with style():
    picture = Figure(figsize=(7.1, 2.4), layout="constrained")
    axes = picture.subplots()
    axes.plot(times, 100 * heights, label="hoopgen")
    axes.plot(times[::20], 100 * formula[::20], "o", ms=3, label="formula")
    axes.set(xlabel="time (s)", ylabel="height (cm)", ylim=(-16, 4))
    axes.legend(loc="upper right", ncols=2)
picture

# %%
# That is why putts come out of the hole (Holmes, *Putting: how a golf ball and hole interact*,
# American Journal of Physics 59, 129, 1991). This one rolls over the edge at the side
# of the hole, gets eight millimetres deep, goes around the cup on its wall, and leaves it again.

speed = 0.936
putt = [-0.3, 0.0318, ball, speed, 0, 0, 0, speed / ball, 0]
shot = hoopgen.simulate(putt, {"green": 0.2}, scene=golf, leaving="green", record=True)
print(f"the lowest height of the ball: {1000 * shot.events['after'][:, 2].min():.1f} mm")
path = shot.trajectory(0)
path.plot(title="A putt that comes out again", three_d=True)
