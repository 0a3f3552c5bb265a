"""Tables of releases: which columns say what, in which units, and reading them in chunks.

The unit is in the column's name: ``speed_mph``, ``elevation_deg``, ``height_ft``; SI where none is,
but an angle or a spin has its unit there. CSV is read as `hoopgen.study.delimited` says. Reading is
by pyarrow, and holds a few blocks in memory, whatever the file's size; of Arrow, record batches as
they were written. What was read is validated before it is looked at.
"""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Container, Iterable, Iterator, Mapping, Sequence
from contextlib import AbstractContextManager, contextmanager
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from shlex import quote
from types import MappingProxyType
from typing import TypeAlias

import numpy as np
import pyarrow as pa
import pyarrow.ipc
import pyarrow.parquet as pq
from numpy.typing import NDArray

from hoopgen.brief import brief, cut, listed
from hoopgen.parameters import NAMES
from hoopgen.units import NO_BARE, UNITS, Kind, column_name, unit_size
from hoopgen.variables import STATE, VARIABLES, check_angles

from .delimited import check_delimiter, delimiter_of, parsed, read, survey
from .measures import MEASURES
from .models import from_columns
from .near import near_variable

__all__ = ["FORMATS", "NAMED", "Column", "Source", "Stamp", "columns_of", "values", "variable_of"]

FORMATS: Mapping[str, tuple[str, ...]] = MappingProxyType(
    {
        "csv": (".csv",),
        "parquet": (".parquet", ".pq"),
        "arrow": (".arrow", ".arrows", ".feather", ".ipc"),
    }
)
"""Formats of tables, and the suffixes that say so. Arrow is the IPC file, Feather, or stream."""

Stamp: TypeAlias = tuple[int, int]
"""Of a file: its size, and the time of its last change, ns."""

_BLOCK = 1 << 22
"""Bytes of a file that are read at a time; the longest row of CSV."""

_SAID = 300
"""Characters of what Arrow says of a file, which may be in the words of that file."""

_ARROW_FILE = b"ARROW1"


# ------------------------------------------------------------------------------------ columns


@dataclass(frozen=True)
class Column:
    """Where the numbers of a variable are.

    Attributes
    ----------
    name
        Of the column.
    unit
        Its size in SI.
    """

    name: str
    unit: float


def _kinds() -> dict[str, Kind]:
    moving: dict[str, Kind] = {"v": "speed", "w": "spin"}
    state = {name: moving.get(name[0], "length") for name in STATE}
    return state | {name: variable.kind for name, variable in VARIABLES.items()}


_KINDS = _kinds()

NAMED = "units in names"
"""Of what "hoopgen" says in a file's metadata: that its columns keep to this. Files of older
versions do not say it, and their bare angles and spins are SI, as they were then."""


def columns_of(
    table: pa.Schema | Iterable[str], own: Iterable[str] = (), given: Iterable[str] = ()
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
        variable, unit = ("", None) if column in own else variable_of(column)
        if variable in found:
            raise ValueError(
                f"columns {cut(found[variable].name)} and {cut(column)} both say {variable}; "
                "keep one, or list the other in own"
            )
        if variable and variable not in given:
            if unit is None and not old:
                raise ValueError(_no_unit(column, variable))
            found[variable] = Column(column, 1.0 if unit is None else unit)
    _ask(names, {*own, *(column.name for column in found.values())}, {*found, *given})
    _check(found, given, names)
    return found


def variable_of(column: str) -> tuple[str, float | None]:
    """Return the variable that a column's name says, or none, and the size of its unit in SI.

    There is no size where there is no variable, or the unit is needed and not there.
    """
    plain = column.strip().lower()
    if plain in _KINDS:
        return plain, None if _KINDS[plain] in NO_BARE else 1.0
    longer = {
        name: plain.removeprefix(f"{name}_") for name in _KINDS if plain.startswith(f"{name}_")
    }
    for name, unit in longer.items():
        size = unit_size(unit.replace("_per_", "/").replace("_", "/"), _KINDS[name])
        if size is not None:
            return name, size
    if any(f"{plain}_".startswith(f"{measure}_") for measure in MEASURES):
        return "", None  # a result: entry_angle is no entry in angles
    for name, unit in longer.items():
        kind = _KINDS[name]
        bare = [] if kind in NO_BARE else [name]
        allowed = dict.fromkeys([*bare, *(column_name(name, one) for one in UNITS[kind])])
        raise ValueError(
            f"column {cut(column)}: {cut(unit)} is no unit of {name}; "
            f"expected {', '.join(allowed)}. "
            "If it is a column of your own, list it in own"
        )
    return "", None


def _no_unit(column: str, variable: str) -> str:
    *others, last = (column_name(variable, unit) for unit in NO_BARE[_KINDS[variable]])
    return (
        f"column {cut(column)} has no unit: name it {', '.join(others)} or {last}. "
        "If it is a column of your own, list it in own"
    )


def _ask(names: Sequence[str], clear: Container[str], said: Container[str]) -> None:
    """Refuse a column that is likely meant for a variable which nothing else says."""
    for column in names:
        variable = "" if column in clear else near_variable(column, _KINDS)
        if variable and variable not in said:
            kind = _KINDS[variable]
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


def _check(found: Mapping[str, Column], given: Sequence[str], names: Sequence[str]) -> None:
    """Refuse columns that do not say how a shot is released."""
    if not found:
        raise ValueError(f"no column says how a shot is released: {listed(names) or 'none'}")
    said = {name: column.name for name, column in found.items()} | {name: name for name in given}
    states = [said[name] for name in STATE[2:] if name in said]
    others = [said[name] for name in said if name not in (*STATE, *NAMES)]
    if states and others:
        raise ValueError(
            f"{', '.join(states)} say that the rows are states, and {', '.join(others)} "
            "that they are releases; list in own those that are not to be read"
        )
    try:
        from_columns({name: np.empty(0) for name in said})
    except ValueError as error:
        raise ValueError(f"{error}. The columns are {listed(names)}") from None


def values(
    table: pa.Table, columns: Mapping[str, Column], comma: bool = False
) -> dict[str, NDArray[np.float64]]:
    """Return the numbers of a table's columns, in SI; text may have decimal commas.

    Returns
    -------
    dict
        By variable, (n,) each; NaN where a cell is empty, no number, or not finite.

    Raises
    ------
    ValueError
        If a column can hold no numbers, or angles in radians are degrees.
    """
    numbers = {name: _numbers(table, column, comma) for name, column in columns.items()}
    check_angles("columns", numbers)
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
    return np.where(np.isfinite(numbers), numbers, np.nan)


# ------------------------------------------------------------------------------------ reading


@dataclass(frozen=True)
class Source:
    """A file with a table.

    Attributes
    ----------
    path
        The file.
    format
        One of `FORMATS`; by default as the suffix says. All cells of CSV are text; see `typed`.
    delimiter
        Of CSV, one character; by default as its first line says. Where it is no comma, a comma in a
        number is a decimal one.
    label
        What errors call it; by default its path.

    Raises
    ------
    ValueError
        If the format is none of them, or the delimiter no such character.
    """

    path: Path
    format: str = ""
    delimiter: str = ""
    label: str = ""

    def __str__(self) -> str:
        return self.label or str(self.path)

    def __post_init__(self) -> None:
        suffixes = {suffix: name for name, listed in FORMATS.items() for suffix in listed}
        found = self.format or suffixes.get(self.path.suffix.lower(), "")
        if not found:
            raise ValueError(
                f"{self.path}: the suffix is none of {', '.join(suffixes)}; say format"
            )
        if found not in FORMATS:
            raise ValueError(f"format: expected one of {', '.join(FORMATS)}, got {brief(found)}")
        object.__setattr__(self, "format", found)
        if self.delimiter:
            if found != "csv":
                raise ValueError(f"delimiter: {self.path} is {found}; only CSV has one")
            object.__setattr__(self, "delimiter", check_delimiter(self.delimiter))

    @cached_property
    def between(self) -> str:
        """What stands between the cells of CSV."""
        return self.delimiter or delimiter_of(self.path)

    @property
    def comma(self) -> bool:
        """Whether numbers in text have decimal commas."""
        return self.format == "csv" and self.between != ","

    def schema(self) -> pa.Schema:
        """Return the names and types of the columns.

        Raises
        ------
        ValueError
            If the file is not of its format, or two columns have one name.
        """
        with self._opened() as (schema, _):
            return schema

    def columns(self, own: Iterable[str] = (), given: Iterable[str] = ()) -> dict[str, Column]:
        """Return where the table has the variables of its shots; as `columns_of`."""
        schema = self.schema()
        with self._naming():
            return columns_of(schema, own, given)

    def values(
        self, table: pa.Table, columns: Mapping[str, Column]
    ) -> dict[str, NDArray[np.float64]]:
        """Return the numbers of the columns of a part of the table; as `values`."""
        with self._naming():
            return values(table, columns, self.comma)

    def tables(self, rows: int) -> Iterator[pa.Table]:
        """Read the rows in order, lazily, so many in each table; the last has what is left.

        There is at least one table: that of an empty file has no rows.

        Raises
        ------
        ValueError
            If the file is not of its format.
        """
        with self._opened() as (schema, batches):
            yield from _regrouped(schema, map(_validated, batches), rows)

    def typed(self, columns: Mapping[str, Column]) -> pa.Schema:
        """Return the schema with the types that columns of CSV have, once all of it was read.

        Of `columns` they are doubles. Others are whole numbers, numbers or truths if all of their
        cells are; identifiers, with leading zeros or more than 15 digits, are text.
        """
        if self.format != "csv":
            return self.schema()
        numbers = {column.name for column in columns.values()}
        with self._opened() as (schema, batches):
            others = [name for name in schema.names if name not in numbers]
            types = survey(batches, others, self.comma) if others else {}
            return pa.schema([(name, types.get(name, pa.float64())) for name in schema.names])

    def cast(self, table: pa.Table, schema: pa.Schema) -> pa.Table:
        """Return a part of the table with the types of `typed`; no number is null."""
        if self.format != "csv":
            return table
        with self._naming():
            cells = [
                parsed(column, field.type, self.comma)
                for column, field in zip(table.columns, schema, strict=True)
            ]
            return pa.Table.from_arrays(cells, schema=schema)

    def digest(self) -> tuple[str, int | None]:
        """Read the whole file, and return a digest of it and the rows that it seems to have."""
        digest, lines = hashlib.blake2b(digest_size=32), 0
        with self.path.open("rb") as file:
            while block := file.read(_BLOCK):
                digest.update(block)
                lines += block.count(b"\n")
        if self.format == "parquet":
            with self._naming(), pq.ParquetFile(self.path) as table:
                return digest.hexdigest(), table.metadata.num_rows
        return digest.hexdigest(), lines - 1 if self.format == "csv" else None

    def stamp(self) -> Stamp:
        """Return what is the same for as long as nobody writes to the file."""
        with self._naming():
            status = self.path.stat()
        return status.st_size, status.st_mtime_ns

    def check_unchanged(self, stamp: Stamp) -> None:
        """Refuse a file that was written to since it had this stamp.

        Raises
        ------
        ValueError
            If it was.
        """
        if self.stamp() != stamp:
            raise ValueError(
                f"{self}: changed while it was read; begin again when nobody writes to it"
            )

    @contextmanager
    def _opened(self) -> Iterator[tuple[pa.Schema, Iterable[pa.RecordBatch]]]:
        openers = {"csv": self._csv, "parquet": _parquet, "arrow": _arrow}
        with self._naming(), openers[self.format](self.path) as (schema, batches):
            twice = sorted({name for name in schema.names if schema.names.count(name) > 1})
            if twice:
                raise ValueError(f"two columns are named {listed(twice)}")
            yield schema, batches

    def _csv(self, path: Path) -> AbstractContextManager[_Read]:
        return read(path, self.between, _BLOCK)

    @contextmanager
    def _naming(self) -> Iterator[None]:
        """Name the file in errors of reading it."""
        try:
            yield
        except OSError as error:
            if error.errno is None:  # Arrow's word for damage
                raise ValueError(f"{self}: {cut(str(error), _SAID)}") from error
            raise OSError(error.errno, os.strerror(error.errno), str(self.path)) from error
        except MemoryError as error:  # of a length that no file has, or of one that is too long
            said = f"damaged, or larger than the memory: {error or 'there is no more'}"
            raise ValueError(f"{self}: {said}") from error
        except (pa.ArrowException, SystemError) as error:
            raise ValueError(f"{self}: {cut(str(error), _SAID)}") from error
        except ValueError as error:
            raise ValueError(f"{self}: {cut(str(error), 10 * _SAID)}") from error


_Read: TypeAlias = tuple[pa.Schema, Iterable[pa.RecordBatch]]
_Opened = Iterator[_Read]


@contextmanager
def _parquet(path: Path) -> _Opened:
    # Else a row group's pages are all read at once, and it may be all the file.
    with pq.ParquetFile(path, buffer_size=_BLOCK, pre_buffer=False) as file:
        yield file.schema_arrow, file.iter_batches()


@contextmanager
def _arrow(path: Path) -> _Opened:
    # No memory map: a file that becomes shorter while it is read would end the process.
    with pa.OSFile(str(path)) as file:
        if file.read(len(_ARROW_FILE)) != _ARROW_FILE:
            file.seek(0)
            stream = pa.ipc.open_stream(file)
            yield stream.schema, stream
        else:
            blocks = pa.ipc.open_file(file)
            yield blocks.schema, map(blocks.get_batch, range(blocks.num_record_batches))


def _validated(batch: pa.RecordBatch) -> pa.RecordBatch:
    """Return the rows that were read, all of whose offsets and indices lie within them.

    Arrow takes those of a file as they are, and follows them wherever they lead.
    """
    batch.validate(full=True)
    return batch


def _regrouped(
    schema: pa.Schema, batches: Iterable[pa.RecordBatch], rows: int
) -> Iterator[pa.Table]:
    """Give tables of so many rows, whatever the batches have."""
    held: list[pa.RecordBatch] = []
    count, first = 0, True
    for batch in batches:
        while count + batch.num_rows >= rows:
            wanted = rows - count
            yield pa.Table.from_batches([*held, batch.slice(0, wanted)], schema)
            batch, held, count, first = batch.slice(wanted), [], 0, False
        held.append(batch)
        count += batch.num_rows
    if count or first:
        yield pa.Table.from_batches(held, schema)
