"""hoopgen: what a basketball shot will do, from contact to contact.

>>> import hoopgen
>>> states = hoopgen.release(7.17, 0.89, height=2.13, distance=4.19)
>>> hoopgen.simulate(states).outcome
array([0], dtype=uint8)
"""

from __future__ import annotations

from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any

if find_spec(f"{__name__}.generated") is None:
    # In a checkout whose hoopgen/ shadows an installed one: its rooms lie beside this folder.
    __path__.append(str(Path(__file__).resolve().parent.parent))

if TYPE_CHECKING:
    # What type checkers see: each name is exported with its own type. `_LAZY` is the same list at
    # run time, and a test compares the two.
    from . import plots as plots
    from . import scene as scene
    from .court import COURT as COURT
    from .court import FIBA_COURT as FIBA_COURT
    from .court import NBA_COURT as NBA_COURT
    from .court import PAPER_COURT as PAPER_COURT
    from .engines import HOOP as HOOP
    from .events import Event as Event
    from .hoop.presets import FIBA as FIBA
    from .hoop.presets import NBA as NBA
    from .hoop.presets import PAPER as PAPER
    from .hoop.releases import release as release
    from .invalid import why_invalid as why_invalid
    from .judge import certify as certify
    from .results import SURFACES as SURFACES
    from .results import Outcome as Outcome
    from .results import Shots as Shots
    from .results import Trajectory as Trajectory
    from .scene import Scene as Scene
    from .scene import load_scene as load_scene
    from .scene.compile import compile as compile
    from .simulation import simulate as simulate
    from .study.aim import aim as aim
    from .study.bank import bank_or_direct as bank_or_direct
    from .study.batch import batch as batch
    from .study.compare import compare as compare
    from .study.estimate import estimate as estimate
    from .study.grid import Grid as Grid
    from .study.maps import map as map
    from .study.margins import margins as margins
    from .study.measures import measure as measure
    from .study.optimum import optimum as optimum
    from .study.resample import Resample as Resample
    from .study.scatter import Scatter as Scatter
    from .study.solve import solve as solve
    from .studyfile import run_study as run_study
    from .viewer import view as view

    __version__: str

__all__ = [
    "simulate",
    "certify",
    "compile",
    "release",
    "HOOP",
    "PAPER",
    "NBA",
    "FIBA",
    "COURT",
    "PAPER_COURT",
    "NBA_COURT",
    "FIBA_COURT",
    "Outcome",
    "Event",
    "SURFACES",
    "Shots",
    "Trajectory",
    "why_invalid",
]


_LAZY = {
    "simulate": "simulation",
    "why_invalid": "invalid",
    "compile": "scene.compile",
    "Scene": "scene",
    "load_scene": "scene",
    "HOOP": "engines",
    "COURT": "court",
    "PAPER_COURT": "court",
    "NBA_COURT": "court",
    "FIBA_COURT": "court",
    "release": "hoop.releases",
    "PAPER": "hoop.presets",
    "NBA": "hoop.presets",
    "FIBA": "hoop.presets",
    "Outcome": "results",
    "Event": "events",
    "SURFACES": "results",
    "Shots": "results",
    "Trajectory": "results",
    "certify": "judge",
    "Scatter": "study.scatter",
    "Resample": "study.resample",
    "Grid": "study.grid",
    "estimate": "study.estimate",
    "compare": "study.compare",
    "solve": "study.solve",
    "map": "study.maps",
    "optimum": "study.optimum",
    "margins": "study.margins",
    "bank_or_direct": "study.bank",
    "aim": "study.aim",
    "measure": "study.measures",
    "batch": "study.batch",
    "run_study": "studyfile",
    "view": "viewer",
}
"""Imported when first asked for, and from where: some stand on the extras, and all but `release` on
generated/, which `hoopgen generate` writes."""

_SUBMODULES = ("plots", "scene")
"""Modules that are part of the interface, imported when first asked for too."""


def _import_public(name: str) -> Any:
    """Return a public name of `_LAZY` or `_SUBMODULES`, imported now."""
    if name == "__version__":
        from .installed import version

        return version()
    if name not in (*_LAZY, *_SUBMODULES):
        raise AttributeError(f"module 'hoopgen' has no attribute {name!r}")
    from importlib import import_module

    try:
        if name in _SUBMODULES:
            return import_module(f"{__name__}.{name}")
        found = getattr(import_module(f"{__name__}.{_LAZY[name]}"), name)
    except ImportError as error:
        from .installed import explained

        raise explained(error, f"hoopgen.{name}") from None
    globals()[name] = found  # the next time it is there
    return found


if not TYPE_CHECKING:  # else every misspelt name would have the type Any
    __getattr__ = _import_public


def __dir__() -> list[str]:
    own = [name for name in globals() if name.startswith("__") and name.endswith("__")]
    return sorted({*own, *__all__, *_LAZY, *_SUBMODULES, "__version__"})
