"""
A half-pipe
===========

A hollow and a solid ball roll in a pipe that is open at the top. The solid one is quicker from side
to side, by √((1 + 2/3)/(1 + 2/5)) = 1.091, since less of its energy is in its spin.
"""

import numpy as np
from matplotlib.figure import Figure

import hoopgen
from hoopgen.plots import style
from hoopgen.scene import Cylinder, End, Parameter, Scene

ball, pipe = 0.11, 1.5
scene = Scene(
    "half_pipe",
    parameters=[Parameter("inertia", 2 / 3, "1", "I/(m R²) of the ball")],
    bodies=[Cylinder("pipe", radius=pipe, axis="x", inside=True, within=["z + 0.2"])],
    ball_radius=ball,
    gravity=9.81,
    inertia="inertia",
    restitution=0.3,
    rolls=True,
    ends={"through": End(axis="-x", at=-4)},
)

angle, speed = np.radians(50), 0.8  # from the lowest line of the pipe
inward = np.array([0, -np.sin(angle), np.cos(angle)])
position = -(pipe - ball) * inward
velocity = np.array([speed, 0, 0])
state = [*position, *velocity, *np.cross(inward, velocity) / ball]  # it rolls

shots = hoopgen.simulate(
    np.array([state, state]), {"inertia": [2 / 3, 2 / 5]}, scene=scene, leaving="pipe", record=True
)
reached = []  # the times at which the balls first come to the lowest line
with style():
    picture = Figure(figsize=(7.1, 2.6), layout="constrained")
    axes = picture.subplots()
    for i, name in enumerate(("hollow", "solid")):
        path = shots.trajectory(i)
        times = np.linspace(0, path.duration, 600)
        across = path.at(times)[:, 1]
        axes.plot(times, across, label=name)
        before = np.flatnonzero(across < 0)[0] - 1
        reached.append(np.interp(0, -across[before : before + 2], times[before : before + 2]))
    axes.set(xlabel="time (s)", ylabel="across the pipe (m)")
    axes.legend(loc="lower left")
print(f"hollow by solid: {reached[0] / reached[1]:.3f}")
picture

# %%
# Their ways along the pipe differ, too, as the spin turns with the surface.

shots.trajectory(1).plot(title="A solid ball in a half-pipe", three_d=True)
