"""hoopgen: what a basketball shot will do, from contact to contact.

>>> import hoopgen
>>> states = hoopgen.release(7.17, 0.89, height=2.13, distance=4.19)
>>> hoopgen.simulate(states).outcome
array([0], dtype=uint8)
"""

from __future__ import annotations

from .parameters import FIBA, NBA, PAPER
from .releases import release
from .results import SURFACES, Outcome, Shots, Trajectory
from .simulation import simulate

__all__ = [
    "simulate",
    "release",
    "PAPER",
    "NBA",
    "FIBA",
    "Outcome",
    "SURFACES",
    "Shots",
    "Trajectory",
]


def __getattr__(name: str) -> str:
    if name == "__version__":
        from importlib.metadata import version

        return version("hoopgen")
    raise AttributeError(f"module 'hoopgen' has no attribute {name!r}")
