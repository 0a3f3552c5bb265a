"""How a table of releases is read: what the caller says, what the file says, and what follows."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hoopgen.engines import HOOP, Engine

from .columns import Column
from .interpretation import Interpretation, interpret
from .limits import MEMORY
from .origin import Origin, settle
from .reasons import InvalidRows, reasons
from .tables import Source

__all__ = ["Interpreted", "Reading"]

_ROWS = 1 << 20
"""Read at a time where all are."""


@dataclass(frozen=True)
class Reading:
    """What a caller says of how a table is read.

    Attributes
    ----------
    format, delimiter, where, memory
        As of `hoopgen.study.tables.Source`; empty for what the file says.
    own
        Columns that are not read, though they are named like variables.
    columns
        Names of columns by the variable that they are read as.
    implausible
        Whether rows with implausible numbers are simulated, too.
    """

    format: str = ""
    delimiter: str = ""
    own: tuple[str, ...] = ()
    columns: Mapping[str, str] = field(default_factory=dict)
    where: tuple[str, ...] = ()
    implausible: bool = False
    memory: int = MEMORY

    @classmethod
    def of(cls, **options: Any) -> Reading:
        """Return one from the options of a function, of which None is the default."""
        given: dict[str, Any] = {n: value for n, value in options.items() if value is not None}
        if isinstance(given.get("where"), str):
            given["where"] = (given["where"],)
        given |= {name: tuple(given[name]) for name in ("own", "where") if name in given}
        return cls(**given)

    def source(self, path: Path, label: str = "") -> Source:
        """Return a file as a table.

        Raises
        ------
        ValueError
            As of `Source`.
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
        scene: Engine = HOOP,
    ) -> Interpreted:
        """Return what the columns of a table say, and how its shots are flown; see `settle`.

        Raises
        ------
        ValueError
            If the table or what is asked for is not as described there.
        """
        asked: dict[str, Any] = {"override": override, "scene": scene, "columns": self.columns}
        origin = settle(table, parameters, release, max_contacts, self.own, **asked)
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
    """A table whose columns are understood.

    Attributes
    ----------
    origin
        What all of its shots share.
    columns
        Where it has the variables of its shots.
    interpretation
        That in words.
    """

    origin: Origin
    columns: Mapping[str, Column]
    interpretation: Interpretation

    def measured(self, table: Source) -> tuple[dict[str, NDArray[np.float64]], InvalidRows]:
        """Return the numbers of all rows, by variable, and the rows without one that is needed.

        Such a row has a NaN there, and its shot is INVALID.

        Parameters
        ----------
        table
            That was interpreted.

        Raises
        ------
        ValueError
            If the file is not of its format.
        """
        invalid = InvalidRows()
        parts: list[dict[str, NDArray[np.float64]]] = []
        for part, numbers in table.numbered(_ROWS):
            given = table.values(part, self.columns, check=not parts)
            rows = np.flatnonzero(np.isnan(np.stack(list(given.values()))).any(axis=0))
            listed = numbers[rows].tolist()
            why = reasons(
                part.take(rows),
                self.columns,
                {name: column[rows] for name, column in given.items()},
                malformed=[table.malformed.get(number, "") for number in listed],
                comma=table.comma,
            )
            invalid.add(listed, why)
            parts.append(given)
        return {
            name: np.concatenate([one[name] for one in parts]) for name in self.columns
        }, invalid
