"""Names with units: of the keys in JSON, and of columns; those that tables are read by."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from hoopgen.core.units import column_name
from hoopgen.core.variables import STATE, STATE_UNITS
from hoopgen.engine.compiled_scene import CompiledScene
from hoopgen.hoop.variables import VARIABLES
from hoopgen.scene.lookup import variables_of
from hoopgen.simulation.hoop import HOOP

from .measures.measures import MEASURES

_VARIABLE_UNITS = {name: variable.unit for name, variable in VARIABLES.items()}

UNIT_OF: Mapping[str, str] = {
    **STATE_UNITS,
    **_VARIABLE_UNITS,
    **{f"{end}_{name}": unit for end in ("low", "high") for name, unit in _VARIABLE_UNITS.items()},
    **{name: measure.unit for name, measure in MEASURES.items()},
    **HOOP.layout.units,
    **{f"end_{name}": unit for name, unit in HOOP.layout.units.items()},
    "catching_height": "m",
}
"""SI units of the values in results, by name."""


def unit_in(name: str, scene: CompiledScene) -> str:
    """Return the SI unit of a result, or of a variable of a scene; empty where there is none.

    Parameters
    ----------
    name
        The name of a field of results, or of a variable.
    scene
        The scene whose variables and results they are.
    """
    if not scene.is_hoop and name in (own := variables_of(scene)):
        return own[name].unit
    return UNIT_OF.get(name, "")


def named(name: str, scene: CompiledScene = HOOP) -> str:
    """Return the name of a column with its unit, ``time_s``; other names are as they are.

    Parameters
    ----------
    name, scene
        As for `unit_in`.
    """
    return column_name(name, unit_in(name, scene))


COMPONENTS = tuple(map(named, STATE))
"""Components of a state, in order, with their units."""


def in_units(record: Any, scene: CompiledScene = HOOP) -> Any:
    """Return a record whose keys say the units of the numbers, and of lists of them, below.

    A margin, whose variable is one of its values, gets a key ``unit``.

    Parameters
    ----------
    record
        Names and numbers, nested.
    scene
        The scene whose variables and results they are.
    """
    if isinstance(record, list | tuple):
        return [in_units(one, scene) for one in record]
    if not isinstance(record, Mapping):
        return record
    record = {
        name if isinstance(value, Mapping) else named(name, scene): in_units(value, scene)
        for name, value in record.items()
    }
    if "value" in record and record.get("name") in (own := variables_of(scene)):
        record["unit"] = own[record["name"]].unit
    return record


def parameters_named(record: Mapping[str, Any], scene: CompiledScene = HOOP) -> dict[str, Any]:
    """Return parameters of the scene by name, of a record in which names may have units.

    Parameters
    ----------
    record
        Values by name, with a unit at its end or without: ``ball_radius_m`` or ``ball_radius``.
    scene
        The scene whose parameters are picked out.
    """
    plain = {named(name, scene): name for name in scene.table.defaults}
    return {plain.get(name, name): value for name, value in record.items()}
