"""Arrays that a backend reads and writes, one row a shot."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from types import ModuleType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hoopgen.generated.numpy.hoop import ResultField

from . import array_pool

LOG = ("events", "event_counts", "event_errors")
"""The arrays of the event log, which are last in the targets' structs of results."""


def labels(result: ResultField) -> tuple[str, ...]:
    """Return the names of a result's columns in tables."""
    return result.labels or (result.name,)


def need_bounds(kernels: ModuleType, fields: Iterable[str]) -> bool:
    """Return whether any of a scene's arrays that are wanted needs bounds on errors.

    Parameters
    ----------
    kernels
        The scene's generated NumPy module.
    fields
        The names of the arrays that are wanted.
    """
    wanted = set(fields)
    return "event_errors" in wanted or not kernels.DIAGNOSTIC_RESULTS.isdisjoint(wanted)


class ResultArrays:
    """Result arrays of a batch as attributes; None for fields that are not wanted.

    Parameters
    ----------
    arrays
        Results by name; `events` and `event_counts` are the event log, with rows for
        max_contacts + 1 events of each shot, and the numbers of rows that are used. With the log
        there may be `event_errors`, with as many rows.
    """

    def __init__(self, **arrays: NDArray[Any]) -> None:
        self.arrays = arrays

    def __getattr__(self, name: str) -> NDArray[Any] | None:
        if name.startswith("_"):
            raise AttributeError(name)
        return self.arrays.get(name)

    def rows(self, start: int, stop: int) -> ResultArrays:
        """Return views of the arrays for some of the shots.

        Parameters
        ----------
        start, stop
            The first row, and the row after the last.
        """
        return ResultArrays(**{name: array[start:stop] for name, array in self.arrays.items()})

    def joined(self, other: ResultArrays) -> ResultArrays:
        """Return the union of these arrays and others."""
        return ResultArrays(**self.arrays, **other.arrays)


class Layout:
    """The dtypes and shapes of a scene's results.

    Parameters
    ----------
    kernels
        The scene's generated NumPy module.

    Attributes
    ----------
    results, absent
        Each result by its name, and those of other scenes that this one lacks.
    fields, bounds
        Names of the results that a batch has by default, and of those that it has only by request.
    event
        Type of a row of the event log, with the layout of the C struct.
    error
        Type of the bounds on errors of such a row.
    surfaces
        Number of bodies, which is that of the columns of `counts`.
    rows
        Largest number of rows of the event log for each contact.
    """

    def __init__(self, kernels: ModuleType) -> None:
        self.results: dict[str, ResultField] = {one.name: one for one in kernels.RESULTS}
        self.absent: dict[str, ResultField] = {one.name: one for one in kernels.ABSENT_RESULTS}
        self._rooms: dict[str, tuple[tuple[int, ...], np.dtype[Any]]] = {
            name: ((len(result.columns),) if result.row else (), np.dtype(result.dtype))
            for name, result in self.results.items()
        }
        self.fields = tuple(
            name for name, result in self.results.items() if not result.is_on_request
        )
        self.bounds = tuple(name for name, result in self.results.items() if result.is_on_request)
        self.state_size = len(kernels.STATE)
        self.surfaces = len(kernels.BODIES)
        self.rows = int(kernels.LOG_ROWS)
        self.event = np.dtype(
            [
                ("shot", np.int64),
                ("surface", np.int64),
                ("time", np.float64),
                ("before", np.float64, self.state_size),
                ("after", np.float64, self.state_size),
                ("kind", np.int64),
            ]
        )
        logged = {name: self._rooms[name] for name, one in self.results.items() if one.switch}
        self.error = np.dtype([(name, dtype, shape) for name, (shape, dtype) in logged.items()])

    @property
    def by_column(self) -> tuple[ResultField, ...]:
        """The results in the order of a table's columns.

        Those on request come after all others; last are those of them that only some scenes have.
        """
        last = {True: 2, False: 1}
        order = {
            name: last[bool(one.absence)] if one.is_on_request else 0
            for name, one in self.results.items()
        }
        return tuple(sorted(self.results.values(), key=lambda one: order[one.name]))

    @property
    def counted_results(self) -> tuple[ResultField, ...]:
        """The results of which studies count the shots in which they are not zero."""
        return tuple(result for result in self.results.values() if result.tally)

    @property
    def units(self) -> Mapping[str, str]:
        """The SI unit of each column of results that has one, also of those that it lacks."""
        every = (*self.results.values(), *self.absent.values())
        return {
            label: unit
            for result in every
            if result.units
            for label, unit in zip(labels(result), result.units, strict=True)
        }

    def log_rows(self, max_contacts: int) -> int:
        """Return the rows of the event log that a shot with so many contacts may need."""
        return self.rows * max_contacts + 1

    def row(self, name: str) -> tuple[tuple[int, ...], np.dtype[Any]]:
        """Return the shape and the type of a shot's part of a result.

        Parameters
        ----------
        name
            The name of the result.
        """
        return self._rooms[name]

    def allocate(
        self, shots: int, wanted: Collection[str], new: Callable[..., Any] | None = None
    ) -> ResultArrays:
        """Return uninitialised results of `shots` shots for the wanted fields.

        Parameters
        ----------
        shots
            Number of shots.
        wanted
            Names of the fields.
        new
            Function of a shape and a dtype that returns an array; None for one of NumPy's.
        """
        if new is None:
            # A single shot is the call whose cost in Python counts.
            new = np.empty if shots == 1 else array_pool.empty
        rooms = self._rooms
        return ResultArrays(
            **{
                name: new((shots, *each), dtype)
                for name in wanted
                for each, dtype in (rooms[name],)
            }
        )

    def allocate_events(
        self, shots: int, max_contacts: int, *, errors: bool = False
    ) -> ResultArrays:
        """Return arrays for the event log of so many shots.

        Parameters
        ----------
        shots
            Number of shots.
        max_contacts
            The greatest number of contacts of a shot.
        errors
            Whether the log has bounds on errors.
        """
        rooms = shots, self.log_rows(max_contacts)
        log = ResultArrays(
            events=np.empty(rooms, self.event), event_counts=np.zeros(shots, np.int32)
        )
        return log.joined(ResultArrays(event_errors=np.empty(rooms, self.error))) if errors else log

    def logged_errors(self, wanted: Collection[str]) -> tuple[str, ...]:
        """Return the names of the bounds on errors that the event log has for wanted fields.

        Parameters
        ----------
        wanted
            Names of fields.
        """
        return tuple(name for name in self.error.names or () if name in wanted)

    def logged(self, log: ResultArrays, used: NDArray[np.bool_], wanted: Collection[str]) -> Any:
        """Return rows of an event log, with the bounds on errors that are wanted, (m,).

        Parameters
        ----------
        log
            The arrays of `allocate_events`.
        used
            Which of its rows, (shots, rows).
        wanted
            Names of fields.
        """
        events = log.arrays["events"][used]
        if not (names := self.logged_errors(wanted)):
            return events
        rows = np.empty(len(events), self.event_with(names))
        for name in self.event.names or ():
            rows[name] = events[name]
        for name in names:
            rows[name] = log.arrays["event_errors"][name][used]
        return rows

    def event_with(self, errors: Sequence[str]) -> np.dtype[Any]:
        """Return the type of a row of `Shots.events`, with some bounds on errors.

        Parameters
        ----------
        errors
            Their names.
        """
        return np.dtype([*self.event.descr, *((name, self.error[name]) for name in errors)])
