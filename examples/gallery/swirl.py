"""
Around the rim
==============

A layup comes in too flat from the side, and the ball moves around the ring in many small bounces.
The path leaves the plane of symmetry, so the picture also has a view in space.
"""

import hoopgen
from hoopgen.simulation.article import CASES

layup = next(case for case in CASES if case.title == "Improper layup")
shots = hoopgen.simulate(layup.state, record=True)
print(shots)
shots.trajectory(0).plot(title="A layup that swirls")
