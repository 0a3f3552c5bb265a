"""
Margins by distance
===================

Releases with an entry angle of 45° through the ring's centre, and how far the speed, the angle or
the direction alone may be off.
"""

import numpy as np

import hoopgen
from hoopgen.plots import plot_aim
from hoopgen.study.questions.aim_table import aim_table

table = aim_table(
    np.linspace(1, 7, 25), height=2.1336, entry=np.radians(45), parameters=hoopgen.NBA
)
plot_aim(table, hoopgen.NBA)
