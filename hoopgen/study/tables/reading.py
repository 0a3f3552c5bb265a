"""Reading of a table of releases, a file or in memory, as the caller and the file say."""

from __future__ import annotations

import os
from collections.abc import Container, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, Protocol

import numpy as np
import pyarrow as pa
import pyarrow.ipc
from numpy.typing import NDArray

from hoopgen.engine.compiled_scene import CompiledScene
from hoopgen.simulation.hoop import HOOP
from hoopgen.text.shorten import brief

from .columns import Column, numbers, variable_of
from .interpretation import Interpretation, interpret
from .invalid_rows import InvalidRows, reasons
from .limits import MEMORY
from .provenance import Origin, resolve_origin
from .source import Source

_ROWS = 1 << 20
"""Read at a time where all are."""

ERROR = "sd_"
"""Prefix of columns of standard errors."""


@dataclass(frozen=True)
class ReadingOptions:
    """The caller's settings for reading a table.

    Attributes
    ----------
    format, delimiter, where, memory
        As of `hoopgen.study.tables.source.Source`; empty for what the file says.
    columns
        Names of columns by the variable that they are read as.
    """

    format: str = ""
    delimiter: str = ""
    own: tuple[str, ...] = ()  # columns that are not read, though they are named like variables
    columns: Mapping[str, str] = field(default_factory=dict)
    where: tuple[str, ...] = ()
    implausible: bool = False  # whether rows with implausible numbers are simulated, too
    memory: int = MEMORY

    @classmethod
    def from_options(cls, **options: Any) -> ReadingOptions:
        """Return one from the options of a function, of which None is the default."""
        given: dict[str, Any] = {n: value for n, value in options.items() if value is not None}
        if isinstance(given.get("where"), str):
            given["where"] = (given["where"],)
        given |= {name: tuple(given[name]) for name in ("own", "where") if name in given}
        return cls(**given)

    def source(self, path: Path, label: str = "") -> Source:
        """Return a file as a table.

        Parameters
        ----------
        path
            The file.
        label
            Its name in messages; by default the path.
        """
        return Source(path, self.format, self.delimiter, label, self.where, self.memory)

    def interpreted(
        self,
        table: Source,
        parameters: Mapping[str, Any] | None = None,
        release: Mapping[str, float] | None = None,
        max_contacts: int | None = None,
        *,
        override: bool = False,
        scene: CompiledScene = HOOP,
    ) -> Interpreted:
        """Return the meaning of a table's columns, and its origin as of `resolve_origin`.

        Parameters
        ----------
        table
            The table, of which the names of columns and the metadata are read.
        parameters, release, max_contacts
            What holds for all shots, besides what the file says; None: nothing.
        override
            True if these replace what the file says.
        scene
            The scene in which the shots are simulated.

        Raises
        ------
        ValueError
            If a column cannot be understood, or contradicts what is given.
        """
        asked: dict[str, Any] = {"override": override, "scene": scene, "columns": self.columns}
        origin = resolve_origin(table, parameters, release, max_contacts, self.own, **asked)
        columns = table.columns(
            *(origin.passed, origin.release, scene, origin.columns), implausible=self.implausible
        )
        said = interpret(
            table.schema().names,
            columns,
            origin.release,
            scene,
            own=origin.own,
            results=origin.results,
            decimal_comma=table.comma,
        )
        return Interpreted(origin, columns, said)


@dataclass(frozen=True)
class Interpreted:
    """A table whose columns are understood."""

    origin: Origin  # what all of its shots share
    columns: Mapping[str, Column]  # where it has the variables of its shots
    interpretation: Interpretation  # that in words

    def measured(self, table: Source) -> tuple[dict[str, NDArray[np.float64]], InvalidRows]:
        """Return the numbers of all rows, by variable, and the rows without one that is needed.

        Such a row has a NaN there, and its shot is INVALID.
        """
        invalid = InvalidRows()
        parts: list[dict[str, NDArray[np.float64]]] = []
        for part, rows_in_file in table.numbered(_ROWS):
            given = table.values(part, self.columns, check=not parts)
            rows = np.flatnonzero(np.isnan(np.stack(list(given.values()))).any(axis=0))
            listed = rows_in_file[rows].tolist()
            why = reasons(
                part.take(rows),
                self.columns,
                {name: column[rows] for name, column in given.items()},
                malformed=[table.malformed.get(number, "") for number in listed],
                comma=table.comma,
            )
            invalid.add(listed, why)
            parts.append(given)
        if not any(len(column) for part in parts for column in part.values()):
            said = f"where: no row of {table} meets it" if table.where else f"{table} has no rows"
            raise ValueError(said)
        return {
            name: np.concatenate([one[name] for one in parts]) for name in self.columns
        }, invalid

    def error_variances(self, table: Source) -> dict[str, NDArray[np.float64]]:
        """Return the variances of the measuring errors of all rows, by variable.

        They are as of `error_variances`.
        """
        return error_variances(table, self.columns, self.origin.engine)


def error_variances(
    table: Source, variables: Container[str], scene: CompiledScene
) -> dict[str, NDArray[np.float64]]:
    """Return the variances of the measuring errors of all rows, by variable.

    They are the squares of columns ``sd_speed_m_s``, as `hoopgen fit` writes them, of some
    variables.

    Parameters
    ----------
    table
        The table.
    variables
        The names of the variables.
    scene
        The scene whose variables they are.

    Returns
    -------
    dict
        (n,) each, in squares of the SI unit; only variables with such a column.
    """
    found = {}
    for name in table.schema().names:
        stem = name.strip().lower()
        variable, unit = variable_of(stem.removeprefix(ERROR), scene)
        if stem.startswith(ERROR) and variable in variables and unit is not None:
            column = Column(name, unit)
            parts = [numbers(part, column, table.comma) for part in table.tables(_ROWS)]
            found[variable] = np.concatenate(parts) ** 2
    return found


_ROWS_WRITTEN = 1 << 16
"""Written at a time."""

# Of Polars; files and the reading of numbers know the others.
_OLDER = {pa.string_view(): pa.large_string(), pa.binary_view(): pa.large_binary()}


class ArrowTable(Protocol):
    """A table in memory that gives its columns as Arrow: of pandas, Polars or Arrow itself."""

    def __arrow_c_stream__(self, requested_schema: object | None = None) -> object:
        """Return a capsule of the table, as the Arrow PyCapsule interface defines it."""


@contextmanager
def sourced(
    source: str | os.PathLike[str] | ArrowTable, reading: ReadingOptions
) -> Iterator[Source]:
    """Give a table to be read from a file, also one in memory.

    Parameters
    ----------
    source
        The name of a file, or a table in memory that has Arrow's C stream.
    reading
        The format, the columns, the rows and the memory that were asked for.

    Raises
    ------
    TypeError
        If it is neither.
    ValueError
        If a table in memory is given a format or a delimiter.
    """
    if isinstance(source, str | os.PathLike):
        yield reading.source(Path(source))
        return
    if not hasattr(source, "__arrow_c_stream__"):
        raise TypeError(
            "source: expected a file, or a table of pandas (from 2.2), Polars or Arrow; "
            f"got {brief(source)}"
        )
    if reading.format or reading.delimiter:
        raise ValueError("format, delimiter: a table in memory has none")
    with TemporaryDirectory(prefix="hoopgen-") as folder:
        file = Path(folder, "source.arrow")
        try:
            reader = pa.RecordBatchReader.from_stream(source)
        except (pa.ArrowInvalid, pa.ArrowTypeError) as error:
            if not hasattr(source, "assign"):  # it is no frame of pandas
                raise ValueError(f"source: {brief(str(error))}") from None
            reader = pa.RecordBatchReader.from_stream(_with_text(source))
        schema = _older(reader.schema)
        with pa.ipc.new_stream(str(file), schema) as stream:
            for batch in reader:
                # In parts, as of a file: a frame may be one batch, however large it is.
                stream.write_table(pa.Table.from_batches([batch]).cast(schema), _ROWS_WRITTEN)
        yield reading.source(file, "the table")


def _with_text(frame: Any) -> Any:
    """Return a frame of pandas whose columns of several types are text, empty cells apart."""
    mixed = [name for name, kind in frame.dtypes.items() if kind.kind == "O"]
    return frame.assign(**{name: frame[name].map(str, na_action="ignore") for name in mixed})


def _older(schema: pa.Schema) -> pa.Schema:
    for index, column in enumerate(schema):
        if column.type in _OLDER:
            schema = schema.set(index, column.with_type(_OLDER[column.type]))
    return schema
