"""
A scene of your own
===================

A netball bounces off the top of its post and off the ring, and a golf ball hops into the hole. The
scenes are short files in ``examples/scenes``.
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
