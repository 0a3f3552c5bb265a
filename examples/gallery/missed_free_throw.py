"""
One shot, to scale
==================

The article's missed free throw touches the ring and the backboard and falls past the ring.
"""

import numpy as np

import hoopgen

free_throw = hoopgen.release(
    7.166, np.radians(51.101), backspin=6 * np.pi, height=2.4384, distance=4.191
)
shots = hoopgen.simulate(free_throw, record=True)
path = shots.trajectory(0)
path.plot(title="A missed free throw")

# %%
# The event log has one row per contact, and one for the end.

for event in path.events:
    print((*hoopgen.SURFACES, "end")[event["surface"]], f"at {event['time']:.4f} s")

# %%
# This page shows the same shot in motion. Turn it with the mouse.

hoopgen.view(shots, title="A missed free throw")
