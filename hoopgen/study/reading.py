"""How a table of releases is read: what the caller says, what the file says, and what follows."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from hoopgen.engines import HOOP, Engine

from .columns import Column
from .interpretation import Interpretation, interpret
from .limits import MEMORY
from .origin import Origin, settle
from .tables import Source

__all__ = ["Interpreted", "Reading"]


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
