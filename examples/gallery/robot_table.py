"""
A shooter's table
=================

For a machine that releases the ball at one height: speed and angle by distance, through the middle
of the ring at an entry angle of 45°, and how far off the speed may be.
"""

import numpy as np
from matplotlib.figure import Figure

import hoopgen
from hoopgen.plots import style

distance, height = np.linspace(1.5, 6, 46), 0.8
aim = hoopgen.aim(height=height, distance=distance, entry=np.radians(45))

# All speeds around the one aimed at, at every distance: which of them score?
off = np.linspace(-0.3, 0.3, 601)
states = hoopgen.release(
    aim.speed[:, None] + off, aim.elevation[:, None], height=height, distance=distance[:, None]
)
made = hoopgen.simulate(states.reshape(-1, 9)).made.reshape(len(distance), -1)

with style():
    picture = Figure(figsize=(7.1, 3), layout="constrained")
    left, right = picture.subplots(1, 2)
    left.plot(distance, aim.speed, color="C0")
    left.set(xlabel="distance (m)", ylabel="speed (m/s), solid", title="What to set")
    angle = left.twinx()
    angle.plot(distance, np.degrees(aim.elevation), color="C1", ls="--")
    angle.set_ylabel("elevation (°), dashed")
    right.pcolormesh(distance, off, made.T, cmap="Greens", vmax=1.5, rasterized=True)
    right.axhline(0, color="#222222", lw=0.7)
    right.set(xlabel="distance (m)", ylabel="speed, off by (m/s)", title="What still scores: green")
picture
