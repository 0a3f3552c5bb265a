"""
A table for a shooting machine
==============================

Speed and angle by distance for a machine that releases the ball at one height. The shots go through
the centre of the ring at an entry angle of 45°. The right picture shows which errors of the speed
still score.
"""

import numpy as np
from matplotlib.figure import Figure

import hoopgen
from hoopgen.plots import style

distance, height = np.linspace(1.5, 6, 46), 0.8
aim = hoopgen.aim(height=height, distance=distance, entry=np.radians(45))

# Simulate all speeds around the computed one at every distance.
off = np.linspace(-0.3, 0.3, 601)
states = hoopgen.release(
    aim.speed[:, None] + off, aim.elevation[:, None], height=height, distance=distance[:, None]
)
made = hoopgen.simulate(states.reshape(-1, 9)).made.reshape(len(distance), -1)

with style():
    picture = Figure(figsize=(7.1, 3), layout="constrained")
    left, right = picture.subplots(1, 2)
    left.plot(distance, aim.speed, color="C0")
    left.set(xlabel="distance (m)", ylabel="speed (m/s), solid", title="Settings")
    angle = left.twinx()
    angle.plot(distance, np.degrees(aim.elevation), color="C1", ls="--")
    angle.set_ylabel("elevation (°), dashed")
    right.pcolormesh(distance, off, made.T, cmap="Greens", vmax=1.5, rasterized=True)
    right.axhline(0, color="#222222", lw=0.7)
    right.set(xlabel="distance (m)", ylabel="speed, off by (m/s)", title="Made shots: green")
picture
