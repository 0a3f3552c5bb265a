"""Variables and outcomes of a scene: what a study can set, scatter, map over and count."""

from __future__ import annotations

from collections.abc import Container, Iterable, Iterator, Mapping
from functools import cache
from types import MappingProxyType, ModuleType
from typing import TYPE_CHECKING, Any, TypeAlias

from hoopgen.core.units import Kind
from hoopgen.core.variables import KIND_OF, STATE, STATE_UNITS, Variable
from hoopgen.engine.compiled_scene import CompiledScene, infinite_parameters
from hoopgen.hoop.variables import ALTERNATIVE_VARIABLES, ARGUMENTS, VARIABLES
from hoopgen.text.shorten import brief, join_names

from .air import AIR_PARAMETERS
from .scene import Scene

if TYPE_CHECKING:
    from hoopgen.derive.scenes.scene import Scene as Derived

SceneLike: TypeAlias = "Scene | Derived | CompiledScene | None"
"""A scene of one's own, one of derive/, or a compiled one; None is the article's hoop."""


def outcomes_of(scene: CompiledScene) -> tuple[str, ...]:
    """Return the names of a scene's outcomes, in small letters; its ends come first."""
    return tuple(outcome.name.lower() for outcome in scene.outcomes)


# ---------------------------------------------------------------------------------------- variables

_MOVING: Mapping[str, Kind] = MappingProxyType({"m": "length", "m/s": "speed", "rad/s": "spin"})

STATES: Mapping[str, Variable] = MappingProxyType(
    {name: Variable(name, _MOVING[unit], name) for name, unit in STATE_UNITS.items()}
)
"""Components of a state as variables, by name."""


def variables_of(scene: Any) -> Mapping[str, Variable]:
    """Return the variables that a study of a scene can set, scatter and map over, by name.

    Where there is a hoop these are the variables of a release, anywhere else the components of a
    state; and the scene's parameters.

    Parameters
    ----------
    scene
        A `CompiledScene`, or a scene of `hoopgen.scene`.

    Raises
    ------
    ValueError
        If a parameter is named like a component of a state.
    """
    if not isinstance(scene, CompiledScene):
        return _with_states(_written(scene))
    return VARIABLES if scene.is_hoop else _compiled_variables(scene)


def _written(scene: Any) -> dict[str, Variable]:
    own = (one for one in scene.inputs if one.own)
    return {one.name: _parameter(one.name, one.unit, one.infinite) for one in own}


@cache
def _compiled_variables(scene: CompiledScene) -> Mapping[str, Variable]:
    own = _parameters(scene.kernels, scene.parameters, scene.infinite)
    return (
        _with_states(own) if not scene.has_hoop else {**ARGUMENTS, **ALTERNATIVE_VARIABLES, **own}
    )


def _parameters(
    kernels: ModuleType, names: Iterable[str], infinite: Container[str]
) -> dict[str, Variable]:
    """Return the parameters of a scene as variables."""
    units = {name: unit for name, (_, unit, _) in kernels.PARAMETERS.items()}
    return {name: _parameter(name, units.get(name, ""), name in infinite) for name in names}


def _with_states(own: Mapping[str, Variable]) -> Mapping[str, Variable]:
    both = [name for name in own if name in STATE]
    if both:
        raise ValueError(
            f"scene: its parameter {join_names(both)} is named like a component of a state, and a "
            "study could not tell them apart; rename it"
        )
    return {**STATES, **own}


def _parameter(name: str, unit: str, infinite: bool) -> Variable:
    return Variable(name, KIND_OF.get(unit, "number"), name.replace("_", " "), infinite)


class _HoopVariables(Mapping[str, Variable]):
    """Variables of every hoop; those of `COURT` are computed if the article's are not enough."""

    def __getitem__(self, name: str) -> Variable:
        return VARIABLES[name] if name in VARIABLES else _of_all_hoops()[name]

    def __contains__(self, name: object) -> bool:
        # A component of a state is no variable of a hoop: this needs no computation.
        return name in VARIABLES or (name not in STATE and name in _of_all_hoops())

    def __iter__(self) -> Iterator[str]:
        return iter(_of_all_hoops())

    def __len__(self) -> int:
        return len(_of_all_hoops())


@cache
def _of_all_hoops() -> Mapping[str, Variable]:
    from hoopgen.generated.numpy import court  # which has many kernels

    own = _parameters(court, court.PARAMETERS, infinite_parameters(court))
    return {
        **VARIABLES,
        **own,
        **{p.name: _parameter(p.name, p.unit, False) for p in AIR_PARAMETERS},
    }


HOOP_VARIABLES: Mapping[str, Variable] = _HoopVariables()
"""Variables of a shot at any hoop, the article's or `COURT`."""


def check_hoop(what: str, scene: Any) -> None:
    """Refuse a scene without a hoop.

    Parameters
    ----------
    what
        The name of the question, for the error.
    scene
        The scene; None is the article's hoop.

    Raises
    ------
    ValueError
        If the scene has none. The error says which questions any scene can answer.
    """
    if scene is None or (isinstance(scene, CompiledScene) and scene.has_hoop):
        return
    name = getattr(scene, "name", None)
    said = f"the scene {name}" if isinstance(name, str) else brief(scene)
    raise ValueError(
        f"{what}: its question is a hoop's, and {said} has none; estimate, compare, map, optimum, "
        "batch, simulate, certify, plot and view take any scene"
    )
