"""
A scene of your own
===================

A netball bounces off the top of its post and off the ring, a putt rolls over the edge of its hole
and around the cup, and a ball falls through a funnel into a bottle. These scenes are short files in
``examples/scenes``. The last one is described in Python: a ball rolls off a table, lands on the
floor, and rolls on.
"""

from pathlib import Path

import hoopgen
from hoopgen.scene import Disc, End, Plane, Scene

scenes = Path("../scenes")  # from the folder of this script

netball = hoopgen.load_scene(scenes / "netball.toml")
state = [1.6, 0.258, -0.35, -2.317, -0.301, 4.649, 0, -12, 0]
shots = hoopgen.simulate(state, scene=netball, record=True)
shots.trajectory(0).plot(title="Netball", three_d=True)

# %%

golf = hoopgen.load_scene(scenes / "golf.toml")
state = [-0.4, 0.028, 0.0214, 1.1, 0, 0, 0, 52, 0]
shots = hoopgen.simulate(state, scene=golf, record=True)
shots.trajectory(0).plot(title="Golf", three_d=True)

# %%

funnel = hoopgen.load_scene(scenes / "funnel.toml")
state = [-0.21, -0.038, 0.413, 0.718, -0.072, 0.201, 0, 0, 0]
shots = hoopgen.simulate(state, scene=funnel, record=True)
shots.trajectory(0).plot(title="Funnel", three_d=True)

# %%

table = Scene(
    "table",
    bodies=[Plane("floor"), Disc("table", radius=0.4, centre=(0, 0, 0.75))],
    ball_radius=0.1,
    gravity=9.81,
    restitution=0.6,
    rolls=True,
    ends={"past": End(axis="-x", at=-2.5)},
)
state = [-0.3, 0.1, 0.95, 1.2, -0.2, 0, 0, 0, 0]
shots = hoopgen.simulate(state, scene=table, record=True)
shots.trajectory(0).plot(title="Off a table", three_d=True)
