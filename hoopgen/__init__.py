"""hoopgen: what a basketball shot will do, from contact to contact.

>>> import hoopgen
>>> states = hoopgen.release(7.17, 0.89, height=2.13, distance=4.19)
>>> hoopgen.simulate(states).outcome
array([0], dtype=uint8)
"""

from __future__ import annotations

from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any

if find_spec(f"{__name__}.generated") is None:
    # In a checkout whose hoopgen/ shadows an installed one: derive/ and its like lie beside it.
    __path__.append(str(Path(__file__).resolve().parent.parent))

from .core.air_scene import register_air
from .core.plotting import register_plotting
from .core.rounding import rounding_to_nearest

if TYPE_CHECKING:
    # What type checkers see: each name is exported with its own type. `_LAZY` is the same list at
    # run time, and a test compares the two.
    from . import plots as plots
    from . import scene as scene
    from .core.event_log import Event as Event
    from .hoop.air import FIBA_AIR as FIBA_AIR
    from .hoop.air import NBA_AIR as NBA_AIR
    from .hoop.air import PAPER_AIR as PAPER_AIR
    from .hoop.court import FIBA_COURT as FIBA_COURT
    from .hoop.court import NBA_COURT as NBA_COURT
    from .hoop.court import PAPER_COURT as PAPER_COURT
    from .hoop.court_air import FIBA_COURT_AIR as FIBA_COURT_AIR
    from .hoop.court_air import NBA_COURT_AIR as NBA_COURT_AIR
    from .hoop.court_air import PAPER_COURT_AIR as PAPER_COURT_AIR
    from .hoop.court_places import place as place
    from .hoop.presets import FIBA as FIBA
    from .hoop.presets import NBA as NBA
    from .hoop.presets import PAPER as PAPER
    from .hoop.releases import release as release
    from .interop import jax as jax
    from .judge import certify as certify
    from .judge import certify_box as certify_box
    from .results.shots import SURFACES as SURFACES
    from .results.shots import Outcome as Outcome
    from .results.shots import Shots as Shots
    from .results.trajectory import Trajectory as Trajectory
    from .scene import Scene as Scene
    from .scene import load_scene as load_scene
    from .simulation.air import AIR as AIR
    from .simulation.compile import compile as compile
    from .simulation.court import COURT as COURT
    from .simulation.court_air import COURT_AIR as COURT_AIR
    from .simulation.hoop import HOOP as HOOP
    from .simulation.invalid_shots import why_invalid as why_invalid
    from .simulation.simulate import simulate as simulate
    from .simulation.tangents import jvp as jvp
    from .simulation.tangents import vjp as vjp
    from .study.measures.measures import measure as measure
    from .study.models.grid import Grid as Grid
    from .study.models.resample import Resample as Resample
    from .study.models.scatter import Scatter as Scatter
    from .study.questions.aim import aim as aim
    from .study.questions.assess import assess as assess
    from .study.questions.bank import bank_or_direct as bank_or_direct
    from .study.questions.batch import batch as batch
    from .study.questions.best_shots import best_shots as best_shots
    from .study.questions.coach import coach as coach
    from .study.questions.compare import compare as compare
    from .study.questions.counterfactual import counterfactual as counterfactual
    from .study.questions.estimate import estimate as estimate
    from .study.questions.map import map as map
    from .study.questions.margins import margins as margins
    from .study.questions.optimum import optimum as optimum
    from .study.questions.solve import solve as solve
    from .study.recovery.calibrate import calibrate as calibrate
    from .study.recovery.fit_release import fit_release as fit_release
    from .studyfile import run_study as run_study
    from .viewer import view as view

    __version__: str

__all__ = [
    "simulate",
    "certify",
    "certify_box",
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
    "PAPER_AIR",
    "NBA_AIR",
    "FIBA_AIR",
    "PAPER_COURT_AIR",
    "NBA_COURT_AIR",
    "FIBA_COURT_AIR",
    "Outcome",
    "Event",
    "SURFACES",
    "Shots",
    "Trajectory",
    "why_invalid",
]


_LAZY = {
    "simulate": "simulation.simulate",
    "jvp": "simulation.tangents",
    "vjp": "simulation.tangents",
    "jax": "interop",
    "why_invalid": "simulation.invalid_shots",
    "compile": "simulation.compile",
    "Scene": "scene",
    "load_scene": "scene",
    "HOOP": "simulation.hoop",
    "COURT": "simulation.court",
    "PAPER_COURT": "hoop.court",
    "NBA_COURT": "hoop.court",
    "FIBA_COURT": "hoop.court",
    "AIR": "simulation.air",
    "PAPER_AIR": "hoop.air",
    "NBA_AIR": "hoop.air",
    "FIBA_AIR": "hoop.air",
    "COURT_AIR": "simulation.court_air",
    "PAPER_COURT_AIR": "hoop.court_air",
    "NBA_COURT_AIR": "hoop.court_air",
    "FIBA_COURT_AIR": "hoop.court_air",
    "release": "hoop.releases",
    "place": "hoop.court_places",
    "PAPER": "hoop.presets",
    "NBA": "hoop.presets",
    "FIBA": "hoop.presets",
    "Outcome": "results.shots",
    "Event": "core.event_log",
    "SURFACES": "results.shots",
    "Shots": "results.shots",
    "Trajectory": "results.trajectory",
    "certify": "judge",
    "certify_box": "judge",
    "Scatter": "study.models.scatter",
    "Resample": "study.models.resample",
    "Grid": "study.models.grid",
    "estimate": "study.questions.estimate",
    "compare": "study.questions.compare",
    "assess": "study.questions.assess",
    "best_shots": "study.questions.best_shots",
    "coach": "study.questions.coach",
    "counterfactual": "study.questions.counterfactual",
    "solve": "study.questions.solve",
    "map": "study.questions.map",
    "optimum": "study.questions.optimum",
    "margins": "study.questions.margins",
    "bank_or_direct": "study.questions.bank",
    "aim": "study.questions.aim",
    "measure": "study.measures.measures",
    "batch": "study.questions.batch",
    "fit_release": "study.recovery.fit_release",
    "calibrate": "study.recovery.calibrate",
    "run_study": "studyfile",
    "view": "viewer",
}
"""Imported when first asked for, and from where: some stand on the extras, and all but `release` on
generated/, which `hoopgen generate` writes."""

_SUBMODULES = ("plots", "scene")
"""Modules that are part of the interface, imported when first asked for too."""


register_plotting(lambda: import_module(f"{__name__}.plots"))
register_air(lambda: import_module(f"{__name__}.simulation.air").AIR)


def _import_public(name: str) -> Any:
    """Return a public name of `_LAZY` or `_SUBMODULES`, imported now."""
    if name == "__version__":
        from .core.extras import version

        return version()
    if name not in (*_LAZY, *_SUBMODULES):
        raise AttributeError(f"module 'hoopgen' has no attribute {name!r}")
    try:
        with rounding_to_nearest():
            if name in _SUBMODULES:
                return import_module(f"{__name__}.{name}")
            found = getattr(import_module(f"{__name__}.{_LAZY[name]}"), name)
    except ImportError as error:
        from .core.extras import explain_import_error

        raise explain_import_error(error, f"hoopgen.{name}") from None
    globals()[name] = found  # the next time it is there
    return found


if not TYPE_CHECKING:  # else every misspelt name would have the type Any
    __getattr__ = _import_public


def __dir__() -> list[str]:
    own = [name for name in globals() if name.startswith("__") and name.endswith("__")]
    return sorted({*own, *__all__, *_LAZY, *_SUBMODULES, "__version__"})
