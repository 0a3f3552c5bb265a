"""
One shot, to scale
==================

The article's missed free throw: ring, backboard, and past the ring.
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
# What happened on the way is in the event log, one row a contact.

for event in path.events:
    print((*hoopgen.SURFACES, "end")[event["surface"]], f"at {event['time']:.4f} s")

# %%
# The same shot, in motion: turn it with the mouse.

hoopgen.view(shots, title="A missed free throw")
