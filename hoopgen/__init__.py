"""hoopgen: what a basketball shot will do, from contact to contact.

>>> import hoopgen
>>> states = hoopgen.release(7.17, 0.89, height=2.13, distance=4.19)
>>> hoopgen.simulate(states).outcome
array([0], dtype=uint8)
"""

from __future__ import annotations

from typing import Any

from .parameters import FIBA, NBA, PAPER
from .releases import release
from .results import SURFACES, Outcome, Shots, Trajectory
from .simulation import simulate

__all__ = [
    "simulate",
    "certify",
    "release",
    "PAPER",
    "NBA",
    "FIBA",
    "Outcome",
    "SURFACES",
    "Shots",
    "Trajectory",
]


def __getattr__(name: str) -> Any:
    if name == "__version__":
        from importlib.metadata import version

        return version("hoopgen")
    if name == "certify":
        from .judge import certify

        return certify
    raise AttributeError(f"module 'hoopgen' has no attribute {name!r}")
