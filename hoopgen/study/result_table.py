"""The table of results: the rows of a source, what became of them, and what is counted of them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import partial

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from hoopgen.brief import brief, listed
from hoopgen.hoop.kinds import ended_in
from hoopgen.scenes import outcomes_of

from .columns import Column
from .event_log import EVENTS, event_log, log_schema
from .flights import Flights
from .groups import Group, GroupCounts
from .named import named
from .origin import Origin
from .reasons import InvalidRows, reasons, shot_reason
from .rebounds import caught_at
from .sinks import Sink
from .tables import Source

__all__ = ["Results"]


@dataclass
class Results:
    """What is written: the rows of a table, and what became of them.

    Attributes
    ----------
    source, columns
        The table, and where it has the variables of its shots.
    shots
        What all flights share.
    origin
        What the table says of its shots.
    prefix
        Of the names of the results.
    reason
        Whether a column says why a row is invalid.
    group
        The column by whose values results are counted; None for none.
    log, log_schema
        Takes the event log, if there is one; and that one's schema, known once `schema` is.
    outcomes
        Counts of the rows that were written, by code.
    invalid
        Rows of the source that are.
    """

    source: Source
    columns: Mapping[str, Column]
    shots: Flights
    origin: Origin
    prefix: str
    reason: bool
    group: str | None
    log: Sink | None = None
    log_schema: pa.Schema = field(default=None, init=False)
    outcomes: NDArray[np.int64] = field(init=False)
    invalid: InvalidRows = field(default_factory=InvalidRows, init=False)

    def __post_init__(self) -> None:
        self.outcomes = np.zeros(len(self.shots.scene.outcomes), np.int64)
        self._types = self.source.typed(self.columns)
        self._kept = self._types.names
        self._counts: GroupCounts | None = None
        if self.group is not None:
            if self.group not in self._kept:
                raise ValueError(
                    f"group: {self.source} has no column {brief(self.group)}; the columns are "
                    f"{listed(self._kept)}"
                )
            self._counts = GroupCounts(self.group, outcomes_of(self.shots.scene))

    @property
    def ended(self) -> tuple[str, ...]:
        """Return the names of the outcomes that shots of the scene can have."""
        scene = self.shots.scene
        if scene.has_hoop:
            return tuple(one.name.lower() for one in ended_in(scene.rolls))
        return outcomes_of(scene)

    @property
    def groups(self) -> dict[str, Group]:
        """Return the results by group."""
        return {} if self._counts is None else self._counts.groups(self.ended)

    def schema(self, scene: str) -> pa.Schema:
        """Return that of the results; arguments that shots cannot have are refused here.

        Former results are left out where new ones have their names.

        Parameters
        ----------
        scene
            In words.

        Raises
        ------
        ValueError
            If columns of the source have the names of results.
        """
        types = self._types
        read = pa.schema([types.field(column.name) for column in self.columns.values()])
        empty = self.source.values(read.empty_table(), self.columns)
        results = list(self.shots.results(empty).schema)
        if self.shots.events:
            self.log_schema = log_schema(results.pop().type)
        if self.reason:
            results.append(pa.field("reason", pa.string()))
        results = [column.with_name(self.prefix + column.name) for column in results]
        names = [column.name for column in results]
        former = set(self.origin.results)
        if not former.isdisjoint(names):
            self._kept = [name for name in types.names if name not in former]
        both = sorted({*names} & {*self._kept}, key=names.index)
        if both:
            raise ValueError(
                f"{self.source}: has columns named like results: {listed(both)}; give a prefix"
            )
        height = caught_at(self.shots.measures, self.shots.catching_height)
        more = {named(name): value for name, value in height.items()}
        still = [name for name in self.origin.results if name in self._kept]
        about = self.origin.metadata(scene, **more, results=[*still, *names])
        kept = [types.field(name) for name in self._kept]
        return pa.schema([*kept, *results], {**(types.metadata or {}), **about})

    def table(
        self, read: pa.Table, numbers: NDArray[np.int64], results: pa.Table, schema: pa.Schema
    ) -> pa.Table:
        """Return the next rows, with their results, and count them.

        Parameters
        ----------
        read, numbers
            Rows of the source, and their numbers there.
        results
            What became of them.
        schema
            As of `schema`.
        """
        outcomes = _codes(results["outcome"])
        rows = np.flatnonzero(outcomes == self.shots.scene.outcomes["INVALID"])
        why = self._reasons(read, rows, numbers)
        self.invalid.add(numbers[rows].tolist(), why)
        if self.log is not None:
            self.log(event_log(results[EVENTS], int(self.outcomes.sum())))
            results = results.drop_columns([EVENTS])
        self.outcomes += np.bincount(outcomes, minlength=len(self.outcomes))
        cast = self.source.cast(read, self._types)
        if self._counts is not None:
            self._counts.add(cast[self._counts.column], outcomes)
        cells = [*cast.select(self._kept).columns, *results.columns]
        if self.reason:
            told: NDArray[np.object_] = np.full(read.num_rows, None)
            told[rows] = why
            cells.append(pa.array(told, pa.string()))
        return pa.Table.from_arrays(cells, schema=schema)

    def _reasons(
        self, read: pa.Table, rows: NDArray[np.int64], numbers: NDArray[np.int64]
    ) -> list[str]:
        if not len(rows):
            return []
        taken = read.take(rows)
        given = self.source.values(taken, self.columns, check=False)
        found = self.shots.releases(given)
        malformed = [self.source.malformed.get(number, "") for number in numbers[rows].tolist()]
        scene, comma = self.shots.scene, self.source.comma
        return reasons(
            *(taken, self.columns, given),
            partial(shot_reason, found, scene=scene),
            malformed=malformed,
            comma=comma,
        )


def _codes(column: pa.ChunkedArray) -> NDArray[np.int64]:
    """Return the outcomes of rows as numbers."""
    parts = [part.indices.to_numpy(zero_copy_only=False) for part in column.chunks]
    return np.concatenate([np.empty(0, np.int64), *parts])
