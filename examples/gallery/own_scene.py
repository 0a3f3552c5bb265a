"""
A scene of your own
===================

A netball bounces off the top of its post and off the ring, a golf ball hops into the hole, and a
ball falls through a funnel into a bottle. The scenes are short files in ``examples/scenes``.
"""

from pathlib import Path

import hoopgen

scenes = Path("../scenes")  # from the folder of this script

netball = hoopgen.load_scene(scenes / "netball.toml")
state = [1.6, 0.258, -0.35, -2.317, -0.301, 4.649, 0, -12, 0]
shots = hoopgen.simulate(state, scene=netball, record=True)
shots.trajectory(0).plot(title="Netball", three_d=True)

# %%

golf = hoopgen.load_scene(scenes / "golf.toml")
state = [-0.55, -0.037, 0.12, 1.57, 0.156, 0.706, 0, 30, 0]
shots = hoopgen.simulate(state, scene=golf, record=True)
shots.trajectory(0).plot(title="Golf", three_d=True)

# %%

funnel = hoopgen.load_scene(scenes / "funnel.toml")
state = [-0.21, -0.038, 0.413, 0.718, -0.072, 0.201, 0, 0, 0]
shots = hoopgen.simulate(state, scene=funnel, record=True)
shots.trajectory(0).plot(title="Funnel", three_d=True)
