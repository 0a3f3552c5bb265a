"""
Around the rim
==============

A layup that comes in too flat, from the side: the ball goes around the ring in many small bounces.
Out of the plane of the hoop there is a view in space too.
"""

import hoopgen
from hoopgen.paper import CASES

layup = next(case for case in CASES if case.title == "Improper layup")
shots = hoopgen.simulate(layup.state, record=True)
print(shots)
shots.trajectory(0).plot(title="A layup that swirls")
