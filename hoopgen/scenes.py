"""Any scene, as studies, files and the command line see it: by name or file, with its variables."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from importlib import import_module
from pathlib import Path
from types import MappingProxyType
from typing import Any

from .brief import brief, listed
from .engines import HOOP, Engine
from .hoop.variables import ARGUMENTS, INSTEAD, VARIABLES
from .parameters import Parameters
from .units import Kind
from .variables import STATE, STATE_UNITS, Variable

__all__ = [
    "BUILT_IN",
    "HOOPED",
    "STATES",
    "SUFFIX",
    "BuiltIn",
    "check_article",
    "check_hoop",
    "engine_of",
    "is_built_in",
    "outcomes_of",
    "presets_of",
    "scene_from",
    "variables_of",
]


@dataclass(frozen=True)
class BuiltIn:
    """A scene that comes with hoopgen; its module is loaded when it is first asked for.

    Attributes
    ----------
    engine_at, presets_at
        Modules of hoopgen, and the names there of its engine and of its presets.
    """

    engine_at: tuple[str, str]
    presets_at: tuple[str, str]

    @property
    def engine(self) -> Engine:
        """What simulates it."""
        engine: Engine = _found(self.engine_at)
        return engine

    @property
    def presets(self) -> Mapping[str, Parameters]:
        """Its parameters by the name of a preset."""
        presets: Mapping[str, Parameters] = _found(self.presets_at)
        return presets


def _found(at: tuple[str, str]) -> Any:
    module, name = at
    return getattr(import_module(f"{__package__}.{module}"), name)


BUILT_IN: Mapping[str, BuiltIn] = MappingProxyType(
    {
        "hoop": BuiltIn(("engines", "HOOP"), ("hoop.presets", "PRESETS")),
        "court": BuiltIn(("court", "COURT"), ("court", "PRESETS")),
    }
)
"""By the names that they have on the command line and in files, which are those of the engines."""

SUFFIX = ".toml"
"""Of the name of a scene file."""


def is_built_in(text: str) -> bool:
    """Return whether a text names a scene that comes with hoopgen, and no file.

    Raises
    ------
    ValueError
        If it names neither.
    """
    if text in BUILT_IN:
        return True
    if Path(text).suffix.lower() != SUFFIX:
        raise ValueError(
            f"expected {' or '.join(BUILT_IN)}, or a scene file, {SUFFIX}; got {brief(text)}"
        )
    return False


def scene_from(text: str, folder: Path | None = None) -> Any:
    """Return the scene that a text names: one that comes with hoopgen, or that of a scene file.

    A file is read, and nothing in it is run; what it says is not yet compiled, see `engine_of`.

    Parameters
    ----------
    text
        A key of `BUILT_IN`, or a file whose name ends in ``.toml``.
    folder
        That the file is relative to.

    Raises
    ------
    ValueError
        If it is neither, or the file says no scene.
    OSError
        If the file cannot be read.
    """
    if is_built_in(text):
        return BUILT_IN[text].engine
    from .scene.files import load_scene

    return load_scene((folder or Path()) / text)


def engine_of(scene: Any) -> Engine:
    """Return what simulates a scene, compiled if it is one of one's own; of None, the hoop.

    Raises
    ------
    TypeError, ValueError, ImportError
        As of `hoopgen.compile`.
    """
    if scene is None or isinstance(scene, Engine):
        return scene or HOOP
    from .scene.compile import compile  # runs compilers, which the hoop never needs

    return compile(scene)


def presets_of(scene: Engine) -> Mapping[str, Parameters]:
    """Return the presets of a scene by name: none of one of one's own."""
    one = BUILT_IN.get(scene.name)  # a scene of one's own may have the same name
    return one.presets if one is not None and one.engine is scene else {}


def outcomes_of(scene: Engine) -> tuple[str, ...]:
    """Return the names of a scene's outcomes, in small letters; its ends come first."""
    return tuple(outcome.name.lower() for outcome in scene.outcomes)


# ---------------------------------------------------------------------------------------- variables

_KINDS: Mapping[str, Kind] = MappingProxyType(
    {"m": "length", "m/s": "speed", "m/s²": "acceleration", "m/s2": "acceleration"}
)
"""Of a parameter with such a unit; all others are plain numbers, in the unit that they have."""

_MOVING: Mapping[str, Kind] = MappingProxyType({"m": "length", "m/s": "speed", "rad/s": "spin"})

STATES: Mapping[str, Variable] = MappingProxyType(
    {name: Variable(name, _MOVING[unit], name) for name, unit in STATE_UNITS.items()}
)
"""Components of a state."""


def variables_of(scene: Any) -> Mapping[str, Variable]:
    """Return what a study of a scene can set, scatter and map over, by name.

    Where there is a hoop these are the variables of a release, anywhere else the components of a
    state; and the scene's parameters.

    Parameters
    ----------
    scene
        An `Engine`, or a scene of `hoopgen.scene`.

    Raises
    ------
    ValueError
        If a parameter is named like a component of a state.
    """
    if scene is HOOP:
        return VARIABLES
    return _engines_variables(scene) if isinstance(scene, Engine) else _with_states(_written(scene))


def _written(scene: Any) -> dict[str, Variable]:
    own = (one for one in scene.inputs if one.own)
    return {one.name: _parameter(one.name, one.unit, one.infinite) for one in own}


@cache
def _engines_variables(scene: Engine) -> Mapping[str, Variable]:
    units = {name: unit for name, (_, unit, _) in scene.kernels.PARAMETERS.items()}
    own = {
        name: _parameter(name, units.get(name, ""), name in scene.infinite)
        for name in scene.parameters
    }
    return _with_states(own) if not scene.has_hoop else {**ARGUMENTS, **INSTEAD, **own}


def _with_states(own: Mapping[str, Variable]) -> Mapping[str, Variable]:
    both = [name for name in own if name in STATE]
    if both:
        raise ValueError(
            f"scene: its parameter {listed(both)} is named like a component of a state, and a "
            "study could not tell them apart; rename it"
        )
    return {**STATES, **own}


def _parameter(name: str, unit: str, infinite: bool) -> Variable:
    return Variable(name, _KINDS.get(unit, "number"), name.replace("_", " "), infinite)


class _Hooped(Mapping[str, Variable]):
    """Those of the article's scene, and only where they are not enough those of the others too."""

    def __getitem__(self, name: str) -> Variable:
        return VARIABLES[name] if name in VARIABLES else _of_all_hoops()[name]

    def __contains__(self, name: object) -> bool:
        # No component of a state is asked for in vain.
        return name in VARIABLES or (name not in STATE and name in _of_all_hoops())

    def __iter__(self) -> Iterator[str]:
        return iter(_of_all_hoops())

    def __len__(self) -> int:
        return len(_of_all_hoops())


@cache
def _of_all_hoops() -> Mapping[str, Variable]:
    engines = [one.engine for one in BUILT_IN.values()]
    return {
        name: variable
        for engine in engines
        if engine.has_hoop
        for name, variable in variables_of(engine).items()
    }


HOOPED: Mapping[str, Variable] = _Hooped()
"""Variables of a shot at any hoop there is."""


def check_hoop(what: str, scene: Any) -> None:
    """Refuse a scene without a hoop.

    Raises
    ------
    ValueError
        If it has none; says what asks for it, and what a scene of one's own has.
    """
    if scene is None or (isinstance(scene, Engine) and scene.has_hoop):
        return
    name = getattr(scene, "name", None)
    said = f"the scene {name}" if isinstance(name, str) else brief(scene)
    raise ValueError(
        f"{what}: its question is a hoop's, and {said} has none; estimate, compare, map, optimum, "
        "batch, simulate, certify, plot and view take any scene"
    )


def check_article(what: str, scene: Any) -> None:
    """Refuse any scene but the article's hoop, whose formulas and parameters a study is made of.

    Raises
    ------
    ValueError
        If it is another, with or without a hoop; says what asks.
    """
    check_hoop(what, scene)
    if scene is not None and not scene.is_hoop:
        raise ValueError(
            f"{what}: it is computed for HOOP, the article's hoop, and not for the scene "
            f"{scene.name}; estimate, compare, map, optimum, batch, simulate, certify, plot and "
            "view take that"
        )
