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


_LATER = {
    "certify": "judge",
    "Scatter": "study.models",
    "Resample": "study.models",
    "Grid": "study.models",
    "estimate": "study.estimate",
    "compare": "study.estimate",
    "map": "study.maps",
    "optimum": "study.optimum",
    "margins": "study.margins",
    "bank_or_direct": "study.bank",
    "aim": "study.aim",
    "measure": "study.measures",
    "batch": "study.batch",
    "run_study": "study.toml",
    "view": "viewer",
}
"""Imported when first asked for, since they stand on the extras; and from where."""


def __getattr__(name: str) -> Any:
    if name == "__version__":
        from importlib.metadata import version

        return version("hoopgen")
    if name in _LATER:
        from importlib import import_module

        return getattr(import_module(f"{__name__}.{_LATER[name]}"), name)
    raise AttributeError(f"module 'hoopgen' has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted({*globals(), *_LATER, "__version__"})
