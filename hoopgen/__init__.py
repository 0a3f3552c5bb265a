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
    from .court import COURT, FIBA_COURT, NBA_COURT, PAPER_COURT
    from .engines import HOOP
    from .events import Event
    from .hoop.presets import FIBA, NBA, PAPER
    from .hoop.releases import release
    from .invalid import why_invalid
    from .results import SURFACES, Outcome, Shots, Trajectory
    from .simulation import simulate

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


_LATER = {
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

_ROOMS = ("plots", "scene")
"""Modules that are part of the interface, imported when first asked for too."""


def __getattr__(name: str) -> Any:
    if name == "__version__":
        from .installed import version

        return version()
    if name not in (*_LATER, *_ROOMS):
        raise AttributeError(f"module 'hoopgen' has no attribute {name!r}")
    from importlib import import_module

    try:
        if name in _ROOMS:
            return import_module(f"{__name__}.{name}")
        found = getattr(import_module(f"{__name__}.{_LATER[name]}"), name)
    except ImportError as error:
        from .installed import explained

        raise explained(error, f"hoopgen.{name}") from None
    globals()[name] = found  # the next time it is there
    return found


def __dir__() -> list[str]:
    own = [name for name in globals() if name.startswith("__") and name.endswith("__")]
    return sorted({*own, *__all__, *_LATER, *_ROOMS, "__version__"})
