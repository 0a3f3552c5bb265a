"""
A shot in motion
================

A free throw as a GIF, four times slower than in reality. `save_film` also writes .mp4 if ffmpeg is
installed.
"""

from pathlib import Path
from tempfile import mkdtemp

import numpy as np

import hoopgen
from hoopgen.plots import save_film

states = hoopgen.release(7.17, np.radians(51), np.radians(2), height=2.1336, distance=4.191)
shots = hoopgen.simulate(states, hoopgen.NBA, record=True)
shot = shots.trajectory(0)
film = save_film(
    shot,
    shot.parameters,
    Path(mkdtemp()) / "missed.gif",
    outcome=shot.outcome,
    title="A free throw",
)
