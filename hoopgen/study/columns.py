"""Columns of a table of releases: which says what, and in which unit.

The unit is in the column's name: ``speed_mph``, ``elevation_deg``, ``height_ft``; SI where none is,
but an angle or a spin has its unit there.
"""

from __future__ import annotations

import json
from collections.abc import Container, Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from shlex import quote

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from hoopgen.brief import cut, listed
from hoopgen.engines import HOOP, Engine
from hoopgen.scenes import STATES, variables_of
from hoopgen.units import NO_BARE, UNITS, Kind, column_name, unit_size
from hoopgen.variables import STATE

from .delimited import parsed
from .measures import MEASURES
from .models import check_turns, from_columns
from .near import near_variable

__all__ = ["CONTACTS", "NAMED", "Column", "columns_of", "values", "variable_of"]


@dataclass(frozen=True)
class Column:
    """Where the numbers of a variable are.

    Attributes
    ----------
    name
        Of the column.
    unit
        Its size in SI.
    infinite
        Whether a number in it may be infinite.
    """

    name: str
    unit: float
    infinite: bool = False


@cache
def _kinds(scene: Engine) -> dict[str, Kind]:
    """Return what the variables and components of states that columns may say measure."""
    return {name: one.kind for name, one in {**STATES, **variables_of(scene)}.items()}


CONTACTS = "_contacts"
"""After the name of a body, in results."""

NAMED = "units in names"
"""Of what "hoopgen" says in a file's metadata: that its columns keep to this. Files of older
versions do not say it, and their bare angles and spins are SI, as they were then."""


def columns_of(
    table: pa.Schema | Iterable[str],
    own: Iterable[str] = (),
    given: Iterable[str] = (),
    scene: Engine = HOOP,
) -> dict[str, Column]:
    """Return where a table has the variables of its shots, or their states.

    Columns z or vx, vy, vz … say that rows are states. Those named like one of
    `hoopgen.study.measures.MEASURES`, with a unit or without, are results, and let alone. Capital
    letters are as good as small ones.

    Parameters
    ----------
    table
        Its columns: names; or its schema, which tells of files that older versions wrote, with bare
        angles in radians and spins in rad/s.
    own
        Columns that are not to be read, though they are named like variables.
    given
        Variables that are known from elsewhere; columns of them are not read.
    scene
        In which the shots are flown; where it has no hoop, rows are states.

    Returns
    -------
    dict
        By variable or component of the state.

    Raises
    ------
    ValueError
        If a column's unit is unknown or needed and not there, two say the same, states and
        releases are mixed, something is missing, or a name is nearly that of a variable which no
        column says.
    """
    found: dict[str, Column] = {}
    names = list(table.names if isinstance(table, pa.Schema) else table)
    old = isinstance(table, pa.Schema) and _is_old(table)
    own, given = list(own), list(given)
    absent = [name for name in own if name not in names]
    if absent:
        raise ValueError(f"own: no column {listed(absent)}; there are {listed(names)}")
    for column in names:
        variable, unit = ("", None) if column in own else variable_of(column, scene)
        if variable in found:
            raise ValueError(
                f"columns {cut(found[variable].name)} and {cut(column)} both say {variable}; "
                "keep one, or list the other in own"
            )
        if variable and variable not in given:
            if unit is None and not old:
                raise ValueError(_no_unit(column, variable, scene))
            infinite = variable in scene.infinite
            found[variable] = Column(column, 1.0 if unit is None else unit, infinite)
    _ask(
        names, {*own, *(column.name for column in found.values())}, {*found, *given}, _kinds(scene)
    )
    _check(found, given, names, scene)
    return found


def variable_of(column: str, scene: Engine = HOOP) -> tuple[str, float | None]:
    """Return the variable that a column's name says, or none, and the size of its unit in SI.

    There is no size where there is no variable, or the unit is needed and not there.
    """
    kinds = _kinds(scene)
    plain = column.strip()
    if plain not in kinds:  # a parameter of a scene of one's own may have capital letters
        plain = plain.lower()
    if plain in kinds:
        return plain, None if kinds[plain] in NO_BARE else 1.0
    if plain.removesuffix(CONTACTS) in scene.surfaces and plain.endswith(CONTACTS):
        return "", None  # a result; a parameter may be called like a body
    longer = {
        name: plain.removeprefix(f"{name}_") for name in kinds if plain.startswith(f"{name}_")
    }
    for name, unit in longer.items():
        size = unit_size(unit.replace("_per_", "/").replace("_", "/"), kinds[name])
        if size is not None:
            return name, size
    if any(f"{plain}_".startswith(f"{measure}_") for measure in MEASURES):
        return "", None  # a result: entry_angle is no entry in angles
    for name, unit in longer.items():
        kind = kinds[name]
        bare = [] if kind in NO_BARE else [name]
        allowed = dict.fromkeys([*bare, *(column_name(name, one) for one in UNITS[kind])])
        raise ValueError(
            f"column {cut(column)}: {cut(unit)} is no unit of {name}; "
            f"expected {', '.join(allowed)}. "
            "If it is a column of your own, list it in own"
        )
    return "", None


def _no_unit(column: str, variable: str, scene: Engine) -> str:
    kind = _kinds(scene)[variable]
    *others, last = (column_name(variable, unit) for unit in NO_BARE[kind])
    return (
        f"column {cut(column)} has no unit: name it {', '.join(others)} or {last}. "
        "If it is a column of your own, list it in own"
    )


def _ask(
    names: Sequence[str],
    clear: Container[str],
    said: Container[str],
    kinds: Mapping[str, Kind],
) -> None:
    """Refuse a column that is likely meant for a variable which nothing else says."""
    for column in names:
        variable = "" if column in clear else near_variable(column, kinds)
        if variable and variable not in said:
            kind = kinds[variable]
            spelled = column_name(variable, next(iter(NO_BARE.get(kind, UNITS[kind]))))
            raise ValueError(
                f"column {cut(column)} nearly names {variable}: is it meant? Name it with its "
                f"unit, such as {spelled}; if it is a column of your own, list it in own "
                f"(--own {quote(cut(column))})"
            )


def _is_old(schema: pa.Schema) -> bool:
    """Whether an older version wrote the file."""
    told = (schema.metadata or {}).get(b"hoopgen")
    try:
        return told is not None and NAMED not in json.loads(told)
    except ValueError:
        return False


def _check(
    found: Mapping[str, Column], given: Sequence[str], names: Sequence[str], scene: Engine
) -> None:
    """Refuse columns that do not say how a shot is released."""
    if not (found or scene.has_hoop):
        raise _no_states(names, scene)
    if not found:
        raise ValueError(f"no column says how a shot is released: {listed(names) or 'none'}")
    said = {name: column.name for name, column in found.items()} | {name: name for name in given}
    states = [said[name] for name in STATE[2:] if name in said]
    others = [said[name] for name in said if name not in (*STATE, *scene.table.defaults)]
    if states and others:
        raise ValueError(
            f"{', '.join(states)} say that the rows are states, and {', '.join(others)} "
            "that they are releases; list in own those that are not to be read"
        )
    if not (states or scene.has_hoop):
        raise _no_states(names, scene)
    try:
        from_columns({name: np.empty(0) for name in said}, scene.parameters)
    except ValueError as error:
        raise ValueError(f"{error}. The columns are {listed(names)}") from None


def _no_states(names: Sequence[str], scene: Engine) -> ValueError:
    return ValueError(
        f"no column says how a shot is released: in the scene {scene.name} rows are states, "
        f"{' '.join(STATE)}. The columns are {listed(names)}"
    )


def values(
    table: pa.Table, columns: Mapping[str, Column], comma: bool = False
) -> dict[str, NDArray[np.float64]]:
    """Return the numbers of a table's columns, in SI; text may have decimal commas.

    Returns
    -------
    dict
        By variable, (n,) each; NaN where a cell is empty, no number, or infinite where it may not
        be.

    Raises
    ------
    ValueError
        If a column can hold no numbers, or angles in radians are degrees.
    """
    numbers = {name: _numbers(table, column, comma) for name, column in columns.items()}
    check_turns("columns", numbers, numbers)
    return numbers


def _numbers(table: pa.Table, column: Column, comma: bool) -> NDArray[np.float64]:
    cells = table[column.name]
    if pa.types.is_dictionary(cells.type):
        cells = cells.cast(cells.type.value_type)
    kind = cells.type
    if pa.types.is_string(kind) or pa.types.is_large_string(kind):
        cells = parsed(cells, pa.float64(), comma)
    elif not (
        pa.types.is_integer(kind)
        or pa.types.is_floating(kind)
        or pa.types.is_decimal(kind)
        or pa.types.is_null(kind)
    ):
        raise ValueError(f"column {column.name}: expected numbers, got {kind}")
    numbers = cells.cast(pa.float64(), safe=False).to_numpy() * column.unit
    there = np.isfinite(numbers) | (column.infinite & (numbers == np.inf))
    return np.where(there, numbers, np.nan)
