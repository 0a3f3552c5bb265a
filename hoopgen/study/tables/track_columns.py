"""Columns of a table of tracks: time and position of a ball, a row each frame.

The unit is at the end of the column's name, ``time_ms``, ``x_ft``; SI where none is. A column of
any other name is read where a caller says as what: ``{"time_ms": "Timestamp"}``.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from shlex import quote

from hoopgen.core.units import unit_size, unit_symbol
from hoopgen.text.shorten import cut, join_names

from .columns import Column

FRAME = ("time", "x", "y", "z")
"""Numbers in a row of a table of tracks, besides the label of the track."""

TIME_UNITS: Mapping[str, float] = {
    "s": 1.0,
    "sec": 1.0,
    "seconds": 1.0,
    "ms": 1e-3,
    "milliseconds": 1e-3,
    "us": 1e-6,
    "microseconds": 1e-6,
    "ns": 1e-9,
    "min": 60.0,
    "minutes": 60.0,
}
"""Units of time in the names of columns, and their sizes in s."""


def frame_columns(
    names: Sequence[str], columns: Mapping[str, str] | None = None
) -> dict[str, Column]:
    """Return the columns of time and position, by `FRAME`.

    Parameters
    ----------
    names
        Of the table's columns.
    columns
        Names of columns by what they are read as; the unit is at the end of either name.

    Raises
    ------
    ValueError
        If one is missing, two say the same, or a unit is none.
    """
    found: dict[str, Column] = {}
    mapped: dict[str, tuple[str, float]] = {}
    for name, column in (columns or {}).items():
        where = f"columns: {cut(name)}={cut(column)}"
        said, unit = _meaning(name)
        if not said:
            raise ValueError(f"{where}: {cut(name)} is none of {', '.join(FRAME)}")
        if column not in names:
            raise ValueError(f"{where}: no column {cut(column)}; there are {join_names(names)}")
        if column in mapped:
            raise ValueError(f"{where}: the column is read as {mapped[column][0]} already")
        own = _unit_at_end(column, said)
        if unit is not None and own not in (None, unit):
            raise ValueError(f"{where}: the two names have different units; keep one")
        mapped[column] = said, next((one for one in (unit, own) if one is not None), 1.0)
    given = {said for said, _ in mapped.values()}
    for column in names:
        said, unit = mapped.get(column) or _meaning(column)
        if not said or (column not in mapped and said in given):
            continue
        if said in found:
            both = f"{cut(found[said].name)} and {cut(column)}"
            text = f"--column {said}={cut(column)}"
            raise ValueError(f"columns {both} both say {said}; keep one, or say {text}")
        found[said] = Column(column, 1.0 if unit is None else unit)
    missing = [one for one in FRAME if one not in found]
    if missing:
        raise ValueError(
            f"columns: none says {join_names(missing)}; the columns are {join_names(names)}. "
            f"Name it {missing[0]}_{'s' if missing[0] == 'time' else 'm'}, or say "
            f"--column {quote(f'{missing[0]}=NAME')}"
        )
    return {one: found[one] for one in FRAME}


def describe_columns(columns: Mapping[str, Column], track: str | None, rest: Iterable[str]) -> str:
    """Describe in lines as what the columns are read.

    Parameters
    ----------
    columns
        As of `frame_columns`.
    track
        The column of the tracks' labels; None where all rows are one track.
    rest
        Columns that are not read.
    """
    read = [] if track is None else [f"{cut(track)} as track"]
    for name, one in columns.items():
        units = TIME_UNITS.items() if name == "time" else ()
        unit = next((word for word, size in units if size == one.unit), "")
        read.append(f"{cut(one.name)} as {name} in {unit or unit_symbol(one.unit, 'length')}")
    lines = [f"read: {', '.join(read)}"]
    lines += ["read: all rows are one track"] if track is None else []
    left = join_names(rest)
    return "\n".join([*lines, *([f"not read: {left}"] if left else [])])


def _meaning(name: str) -> tuple[str, float | None]:
    """Return the meaning of a name, if it has one, and the size of its unit."""
    plain = name.strip().lower()
    for one in FRAME:
        if plain == one:
            return one, None
        if plain.startswith(f"{one}_"):
            unit = _size(plain.removeprefix(f"{one}_"), one)
            if unit is not None:
                return one, unit
    return "", None


def _unit_at_end(column: str, said: str) -> float | None:
    _, _, last = column.strip().lower().replace(" ", "_").rpartition("_")
    return _size(last, said)


def _size(unit: str, said: str) -> float | None:
    return TIME_UNITS.get(unit) if said == "time" else unit_size(unit, "length")
