"""Columns of a table of releases: which says what, and in which unit.

The unit is in the column's name: ``speed_mph``, ``elevation_deg``, ``height_ft``; SI where none is,
but an angle or a spin has its unit there. A column of any other name is read where a caller says
as which variable: ``{"speed": "release_speed_mph"}``, or ``{"speed_mph": "Release speed"}``.
"""

from __future__ import annotations

import json
from collections.abc import Container, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache
from shlex import quote
from typing import Any

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from hoopgen.core.units import UNIT_REQUIRED, UNITS, Kind, column_name, unit_size, unit_symbol
from hoopgen.core.variables import STATE
from hoopgen.engine.compiled_scene import CompiledScene
from hoopgen.scene.lookup import STATES, variables_of
from hoopgen.simulation.hoop import HOOP
from hoopgen.study.measures.measures import MEASURES
from hoopgen.study.models.plausible import limits_of
from hoopgen.study.models.release_model import check_turns, from_columns
from hoopgen.text.shorten import cut, join_names

from .delimited import parsed
from .suggestions import likely_variable, near_variable, stems


@dataclass(frozen=True)
class Column:
    """The place of a variable's numbers.

    Attributes
    ----------
    limits
        The least and the largest number that is plausible, in SI.
    """

    name: str  # of the column
    unit: float  # its size in SI
    infinite: bool = False  # whether a number in it may be infinite
    limits: tuple[float, float] = field(default=(-np.inf, np.inf), compare=False)


@cache
def _kinds(scene: CompiledScene) -> dict[str, Kind]:
    """Return the kinds of quantities of the variables and state components in columns."""
    return {name: one.kind for name, one in {**STATES, **variables_of(scene)}.items()}


_ANY = (-np.inf, np.inf)

CONTACTS = "_contacts"
"""Suffix of the name of a body, in results."""

NAMED = "units in names"
"""Key of the metadata "hoopgen" of a file whose columns keep to this. Files of older
versions do not say it, and their bare angles and spins are SI, as they were then."""


def columns_of(
    table: pa.Schema | Iterable[str],
    own: Iterable[str] = (),
    given: Iterable[str] = (),
    scene: CompiledScene = HOOP,
    columns: Mapping[str, str] | None = None,
    *,
    implausible: bool = False,
) -> dict[str, Column]:
    """Return the columns with the variables of a table's shots, or with their states.

    Columns z or vx, vy, vz … say that rows are states. Those named like one of
    `hoopgen.study.measures.measures.MEASURES`, with a unit or without, are results, and let alone.
    Capital letters are as good as small ones.

    Parameters
    ----------
    table
        Its columns: names; or its schema, which tells of files that older versions wrote, with bare
        angles in radians and spins in rad/s.
    own
        Column not to be read although it is named like a variable.
    given
        Variables that are known from elsewhere; columns of them are not read.
    scene
        In which the shots are flown; where it has no hoop, rows are states.
    columns
        Names of columns by the variable that they are read as, whatever they are called. The unit
        is at the end of either name: ``{"speed": "release_speed_mph"}``, ``{"speed_mph": "v"}``.
    implausible
        Whether numbers that `hoopgen.study.models.plausible` excludes are read, too.

    Returns
    -------
    dict
        By variable or component of the state.
    """
    found: dict[str, Column] = {}
    names = list(table.names if isinstance(table, pa.Schema) else table)
    old = isinstance(table, pa.Schema) and _is_old(table)
    own, given = list(own), list(given)
    known = set(names)
    absent = [name for name in own if name not in known]
    if absent:
        raise ValueError(f"own: no column {join_names(absent)}; there are {join_names(names)}")
    mapped = _mapped(columns or {}, names, given, scene)
    clear = {*own, *mapped}
    for column in names:
        variable, unit = (
            mapped[column]
            if column in mapped
            else ("", None)
            if column in clear
            else variable_of(column, scene)
        )
        if variable in found:
            raise ValueError(
                f"columns {cut(found[variable].name)} and {cut(column)} both say {variable}; "
                "keep one, or list the other in own"
            )
        if variable and variable not in given:
            if unit is None and not old:
                raise ValueError(_no_unit(column, variable, scene))
            infinite = variable in scene.infinite
            limits = limits_of(variable) if scene.has_hoop and not implausible else _ANY
            found[variable] = Column(column, 1.0 if unit is None else unit, infinite, limits)
    _ask(names, clear | {one.name for one in found.values()}, {*found, *given}, _kinds(scene))
    _check(found, given, names, scene)
    return found


def _mapped(
    columns: Mapping[str, str], names: Sequence[str], given: Iterable[str], scene: CompiledScene
) -> dict[str, tuple[str, float]]:
    """Return the variable and the size of the unit of columns that a caller names."""
    known, found = set(names), dict[str, tuple[str, float]]()
    for name, column in columns.items():
        where = f"columns: {cut(name)}={cut(column)}"
        variable, unit = variable_of(name, scene)
        if not variable:
            raise ValueError(
                f"{where}: {cut(name)} is no variable; one of {', '.join(_kinds(scene))}"
            )
        if variable in given:
            raise ValueError(f"{where}: {variable} is given for all rows; leave one out")
        if column not in known:
            raise ValueError(f"{where}: no column {cut(column)}; there are {join_names(names)}")
        if column in found:
            raise ValueError(f"{where}: the column is read as {found[column][0]} already")
        kind = _kinds(scene)[variable]
        size = unit_at_end(column, kind)
        if name.strip().lower() != variable.lower():  # that name has a unit, too
            if size not in (None, unit):
                raise ValueError(f"{where}: the two names have different units; keep one")
            size = unit
        if size is None and kind in UNIT_REQUIRED:
            *others, last = (
                f"{column_name(variable, one)}={cut(column)}" for one in UNIT_REQUIRED[kind]
            )
            raise ValueError(f"{where}: the unit is not known; write {', '.join(others)} or {last}")
        found[column] = (variable, 1.0 if size is None else size)
    return found


def unit_at_end(column: str, kind: Kind) -> float | None:
    """Return the size in SI of the unit at the end of a column's name; None where there is none.

    Parameters
    ----------
    column
        The name of the column.
    kind
        The kind of quantity that the unit is looked for in.
    """
    sizes = (unit_size(unit, kind) for _, unit in stems(column) if unit)
    return next((size for size in sizes if size is not None), None)


def variable_of(column: str, scene: CompiledScene = HOOP) -> tuple[str, float | None]:
    """Return the variable that a column's name says, or none, and the size of its unit in SI.

    There is no size where there is no variable, or the unit is needed and not there.

    Parameters
    ----------
    column
        The name of the column, ``speed_mph``.
    scene
        The scene whose variables are looked for.

    Returns
    -------
    tuple
        The name of the variable, empty for none; and the size of the unit, None where there is no
        variable or the needed unit is missing.

    Raises
    ------
    ValueError
        If the name is that of a variable and what follows is no unit of it.
    """
    kinds = _kinds(scene)
    plain = column.strip()
    if plain not in kinds:  # a parameter of a scene of one's own may have capital letters
        plain = plain.lower()
    if plain in kinds:
        return plain, None if kinds[plain] in UNIT_REQUIRED else 1.0
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
        bare = [] if kind in UNIT_REQUIRED else [name]
        allowed = dict.fromkeys([*bare, *(column_name(name, one) for one in UNITS[kind])])
        raise ValueError(
            f"column {cut(column)}: {cut(unit)} is no unit of {name}; "
            f"expected {', '.join(allowed)}. "
            f"If it is a column of your own, list it in own (--own {quote(cut(column))})"
        )
    return "", None


def _no_unit(column: str, variable: str, scene: CompiledScene) -> str:
    kind = _kinds(scene)[variable]
    *others, last = (column_name(variable, unit) for unit in UNIT_REQUIRED[kind])
    return (
        f"column {cut(column)} has no unit: name it {', '.join(others)} or {last}. "
        f"If it is a column of your own, list it in own (--own {quote(cut(column))}); if its "
        "name cannot change, say "
        f"--column {quote(f'{(others or [last])[0]}={cut(column)}')}"
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
            raise ValueError(
                f"column {cut(column)} nearly names {variable}: is it meant? "
                f"{_meant(column, variable, kind)}; if it is a column of your own, list it in own "
                f"(--own {quote(cut(column))})"
            )


def _meant(column: str, variable: str, kind: Kind) -> str:
    """Describe the reading of a column as a variable, in the unit of its name."""
    size = unit_at_end(column, kind)
    if size is None and kind in UNIT_REQUIRED:
        return f"Name it with its unit, such as {column_name(variable, UNIT_REQUIRED[kind][0])}"
    spelled = column_name(variable, unit_symbol(size or 1.0, kind))
    said = quote(f"{variable}={cut(column)}")
    return f"Name it {spelled}, or say so with --column {said}, columns={{{variable!r}: ...}}"


def _is_old(schema: pa.Schema) -> bool:
    """Return whether an older version wrote the file."""
    told = (schema.metadata or {}).get(b"hoopgen")
    try:
        return told is not None and NAMED not in json.loads(told)
    except ValueError:
        return False


def _check(
    found: Mapping[str, Column], given: Sequence[str], names: Sequence[str], scene: CompiledScene
) -> None:
    """Refuse columns that do not say how a shot is released."""
    if not (found or scene.has_hoop):
        raise _no_states(names, scene)
    if not found:
        raise ValueError(f"no column says how a shot is released: {join_names(names) or 'none'}")
    said = {name: column.name for name, column in found.items()} | {name: name for name in given}
    taken = {column.name for column in found.values()}
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
        kinds = _kinds(scene)
        absent = set(kinds) - set(said)
        likely = {name: likely_variable(name, kinds, absent) for name in names if name not in taken}
        meant = [quote(f"{one}={cut(name)}") for name, one in likely.items() if one]
        asked = f" Did you mean --column {' --column '.join(meant)}?" if meant else ""
        raise ValueError(f"{error}. The columns are {join_names(names)}.{asked}") from None


def _no_states(names: Sequence[str], scene: CompiledScene) -> ValueError:
    return ValueError(
        f"no column says how a shot is released: in the scene {scene.name} rows are states, "
        f"{' '.join(STATE)}. The columns are {join_names(names)}"
    )


def values(
    table: pa.Table, columns: Mapping[str, Column], comma: bool = False, *, check: bool = True
) -> dict[str, NDArray[np.float64]]:
    """Return the numbers of a table's columns, in SI; text may have decimal commas.

    Parameters
    ----------
    comma
        Whether numbers in text may have decimal commas.
    check
        Whether angles in radians that are degrees, by their median, are refused.

    Returns
    -------
    dict
        By variable, (n,) each; NaN where a cell is empty, no number, infinite where it may not be,
        or implausible.
    """
    found = {name: numbers(table, column, comma) for name, column in columns.items()}
    if check:  # what says its unit, and another one, is that
        bare = {name: column for name, column in found.items() if columns[name].unit == 1.0}
        check_turns("columns", bare, found)
    return {name: _plausible(found[name], column) for name, column in columns.items()}


def _plausible(found: NDArray[np.float64], column: Column) -> NDArray[np.float64]:
    low, high = column.limits
    return np.where((found >= low) & (found <= high), found, np.nan)


def numbers(table: pa.Table, column: Column, comma: bool = False) -> NDArray[np.float64]:
    """Return the numbers of a column as `values` does, implausible ones too.

    Parameters
    ----------
    table
        A part of the table.
    column
        The column, with the size of its unit in SI.
    comma
        True if numbers have a decimal comma.

    Returns
    -------
    ndarray
        (n,), in SI; NaN where a cell is no number.
    """
    cells = table[column.name]
    if not pa.types.is_dictionary(cells.type):
        return _read(cells, column, comma)
    # Each different text is read once, however many rows share it.
    parts = [
        _taken(_read(pa.chunked_array([part.dictionary]), column, comma), part.indices)
        for part in cells.chunks
    ]
    return np.concatenate([np.empty(0), *parts])


def _taken(found: NDArray[np.float64], indices: Any) -> NDArray[np.float64]:
    """Return numbers by index; NaN where there is none."""
    places = indices.cast(pa.int64()).fill_null(len(found)).to_numpy()
    taken: NDArray[np.float64] = np.append(found, np.nan)[places]
    return taken


def _read(cells: Any, column: Column, comma: bool) -> NDArray[np.float64]:
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
    found = cells.cast(pa.float64(), safe=False).to_numpy() * column.unit
    there = np.isfinite(found) | (column.infinite & (found == np.inf))
    return np.where(there, found, np.nan)
