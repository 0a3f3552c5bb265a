"""The driver of the generated event loop in NumPy: blocks of shots, in and out, and the log.

A block holds the shots in flight as columns; each turn takes all of them to their next event. Shots
that end leave the columns, and others take their place. What happens to a shot stands in the stages
of the generated module; nothing here decides anything.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from threading import Lock
from types import ModuleType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .raw import Raw

Floats = NDArray[np.float64]
Column = Floats | float

BLOCK = 1 << 14
"""Shots that are simulated together: their arrays fit the second-level cache."""

LAST = 1 << 11
"""So few shots cost hardly less than twice as many: threads leave them to each other at the end."""

LINE = 8
"""Doubles in a line of the caches: an array that begins within one is written at half the speed."""


class Room:
    """Rows for what a kernel computes on the way: one set for all kernels, which come in turn."""

    def __init__(self, kernels: ModuleType, shots: int) -> None:
        rows, width = kernels.ROWS, -(-shots // LINE) * LINE
        room = np.empty(rows * width + LINE)
        first = -(room.ctypes.data // room.itemsize) % LINE
        # A list, of which each row is cut anew: an array of them takes five times as long.
        self._rows = list(room[first:][: rows * width].reshape(rows, width))
        self._few, self._none = kernels.FEW, kernels.NO_ROWS

    def __call__(self, shots: int) -> tuple[Floats | None, ...]:
        """Return rows of so many shots, or that a kernel is to make arrays of its own."""
        return self._none if shots < self._few else tuple([row[:shots] for row in self._rows])


class Flights:
    """The shots of a block that are in flight.

    Parameters
    ----------
    kernels
        A generated module.
    bounds
        Whether anything that bounds errors is wanted.
    job
        What is the same for all shots, by name.
    most
        Shots of the batch.
    """

    def __init__(self, kernels: ModuleType, bounds: bool, job: dict[str, float], most: int) -> None:
        name = "bounded" if bounds else "plain"
        stages = ("permit", "admit", "reach", "meet")
        self._permit, self._admit, self._reach, self._meet = (
            getattr(kernels, f"{stage}_{name}") for stage in stages
        )
        self._starts = {f.name: f.start for f in kernels.FIELDS if bounds or not f.bounds}
        self._types = {f.name: f.dtype for f in kernels.FIELDS}
        self._kept = (*self._starts, *kernels.VARIABLES.values())
        self._state, self._results = kernels.STATE, kernels.RESULTS
        self._invalid = float(kernels.Outcome.INVALID)
        self._event, self._end = kernels.Event, len(kernels.BODIES)
        self._tallies = [result.name for result in kernels.RESULTS if result.tallied]
        self._job, self._bounds = job, bounds
        self._room = Room(kernels, min(most, BLOCK))
        self.row = np.empty(0, np.int64)
        self._columns: dict[str, Any] = dict.fromkeys(self._kept, np.empty(0))

    def begin(self, given: dict[str, Column], row: NDArray[np.int64], out: Raw) -> None:
        """Add shots, given their columns; one that cannot start ends at once."""
        shots = len(row)
        fresh = self._job | {
            name: np.full(shots, start, self._types[name]) if start is not None else given[name]
            for name, start in self._starts.items()
        }
        fresh |= {name: given[name] for name in self._kept if name not in self._starts}
        self._permit(fresh, shots, self._room)
        self._admit(fresh, shots, self._room)
        for name in self._tallies:
            if (tally := getattr(out, name)) is not None:
                tally[row] = 0
        over = np.asarray(fresh["outcome"] >= 0.0)
        _finish(self._results, self._invalid, fresh, row, over, out)
        begun = np.flatnonzero(~over)
        for name in self._kept:
            own, other = _take(fresh[name], begun), self._columns[name]
            if np.ndim(own) and len(self.row):
                own = np.concatenate([other, own])
            self._columns[name] = own
        self.row = np.concatenate([self.row, row[begun]])

    def advance(self, out: Raw) -> None:
        """Take every shot to its next event; write and drop those that end there."""
        columns = self._columns | self._job
        self._reach(columns, len(self.row), self._room)
        before = self._states(columns) if out.events is not None else None
        for name in self._tallies:
            if (tally := getattr(out, name)) is not None:
                body = columns["body"]
                met = np.flatnonzero((body >= 0.0) & (body < self._end))
                tally[self.row[met], body[met].astype(np.int64)] += 1
        if before is None and not self._bounds:
            # Nothing is left to do for one that ends and touches nothing.
            over = np.logical_not(columns["touches"]) & (columns["outcome"] >= 0.0)
            columns = self._ended(columns, over, out)
        self._meet(columns, len(self.row), self._room)
        if before is not None:
            self._record(columns, before, out)
        columns = self._ended(columns, columns["outcome"] >= 0.0, out)
        self._columns = {name: columns[name] for name in self._kept}

    def _ended(self, columns: dict[str, Any], over: Any, out: Raw) -> dict[str, Any]:
        """Write and drop shots that are over; return the columns of the others."""
        shots = len(self.row)
        for name in self._starts:
            if not np.ndim(columns[name]):  # a kernel that says the same of all shots
                columns[name] = np.full(shots, columns[name], self._types[name])
        over = np.broadcast_to(over, shots)
        _finish(self._results, self._invalid, columns, self.row, over, out)
        kept = np.flatnonzero(~over)
        if len(kept) == shots:
            return columns
        self.row = self.row[kept]
        return {name: _take(values, kept) for name, values in columns.items()}

    def join(self, other: Flights) -> None:
        """Add the shots that another has in flight: both have taken theirs to an event, or none."""
        if not len(self.row):
            self._columns, self.row = other._columns, other.row
        elif len(other.row):
            for name, own in self._columns.items():
                if np.ndim(own):
                    self._columns[name] = np.concatenate([own, other._columns[name]])
            self.row = np.concatenate([self.row, other.row])

    def _states(self, columns: dict[str, Any]) -> Floats:
        return np.stack([columns[name] for name in self._state], axis=1)

    def _record(self, columns: dict[str, Any], before: Floats, out: Raw) -> None:
        assert out.events is not None
        assert out.event_counts is not None
        happened = np.flatnonzero(columns["body"] >= 0.0)
        row = self.row[happened]
        rows = (row, out.event_counts[row])
        body, end = columns["body"][happened].astype(np.int64), self._end
        staying = body - end - 1
        kinds = np.where(staying % 2, self._event.LEAVE, self._event.ROLL)
        kinds[body < end], kinds[body == end] = self._event.IMPACT, self._event.END
        out.events["shot"][rows] = row
        out.events["surface"][rows] = np.where(staying < 0, body, staying // 2)
        out.events["kind"][rows] = kinds
        out.events["time"][rows] = columns["clock"][happened]
        out.events["before"][rows] = before[happened]
        out.events["after"][rows] = self._states(columns)[happened]
        out.event_counts[row] += 1


class Last:
    """What threads that each run a part of the same shots leave to each other: their last ones.

    Parameters
    ----------
    threads
        How many parts there are.
    shots
        Shots of all parts.
    """

    def __init__(self, threads: int, shots: int) -> None:
        self._lock, self._left, self._at_work = Lock(), list[Flights](), threads
        self.shots = shots

    def go_on(self, flights: Flights) -> bool:
        """Return whether a part goes on; it does not if its last shots were left to the others.

        One that does is given what others left, as far as there is room. The last at work goes on
        until there is nothing left.
        """
        with self._lock:
            if len(flights.row) <= LAST and self._at_work > 1:
                self._at_work -= 1
                self._left.append(flights)
                return False
            while self._left and len(flights.row) + len(self._left[-1].row) <= BLOCK:
                flights.join(self._left.pop())
        return True


def run(
    kernels: ModuleType,
    states: Floats,
    parameters: Sequence[Column],
    leaving: NDArray[np.int8] | None,
    max_contacts: int,
    out: Raw,
    stopped: Callable[[], bool] = lambda: False,
    time_limit: float = np.inf,
    first: int = 0,
    last: Last | None = None,
) -> None:
    """Simulate shots and write what `out` has room for.

    Parameters
    ----------
    kernels
        A generated module of NumPy kernels.
    states
        (n, 9), C order; SI units.
    parameters
        A number or an array (n,) for each parameter, in the order of ``kernels.PARAMETERS``.
    leaving
        Surface that each shot touches at the start and leaves, -1 for none.
    stopped
        Asked between events; nothing further is done once it returns True.
    time_limit
        Time since the release at which a shot ends, s; infinite: none.
    first
        The row of `out` that the first shot has.
    last
        What runs of other parts of the same shots, into the same `out`, share; without a log.
    """
    if out.event_counts is not None:
        out.event_counts[:] = 0
    claimed = out.time_error is not None or out.state_error is not None
    job = {
        "most_contacts": float(max_contacts),
        "time_limit": time_limit,
        "claims": float(claimed),
    }
    last = last or Last(1, len(states))
    flights = Flights(kernels, bounded(kernels, out), job, last.shots)
    begun = 0
    with np.errstate(all="ignore"):
        while not stopped():
            flying = len(flights.row)
            if begun < len(states):
                if flying < BLOCK // 2:
                    rows = slice(begun, min(begun + BLOCK - flying, len(states)))
                    given = _given(kernels, states, parameters, leaving, rows)
                    flights.begin(given, np.arange(rows.start, rows.stop) + first, out)
                    begun = rows.stop
            elif not last.go_on(flights):
                return
            if not len(flights.row):
                if begun < len(states):
                    continue
                return
            flights.advance(out)


def bounded(kernels: ModuleType, out: Raw) -> bool:
    """Return whether anything that bounds errors is wanted."""
    return any(r.bounds and getattr(out, r.name) is not None for r in kernels.RESULTS)


def _given(
    kernels: ModuleType,
    states: Floats,
    parameters: Sequence[Column],
    leaving: NDArray[np.int8] | None,
    rows: slice,
) -> dict[str, Column]:
    """Return the columns of some rows that the caller gave."""
    given: dict[str, Column] = dict(zip(kernels.STATE, states[rows].T.copy(), strict=True))
    for name, value in zip(kernels.VARIABLES.values(), parameters, strict=True):
        given[name] = value if np.ndim(value) == 0 else np.asarray(value, np.float64)[rows]
    count = rows.stop - rows.start
    given["last"] = np.full(count, -1.0) if leaving is None else leaving[rows].astype(np.float64)
    return given


def _finish(
    results: Sequence[Any],
    invalid: float,
    columns: dict[str, Any],
    row: NDArray[np.int64],
    over: NDArray[np.bool_],
    out: Raw,
) -> None:
    """Write the results of the shots that are over."""
    ended = np.flatnonzero(over)
    if not len(ended):
        return
    row = row[ended]
    blank = columns["outcome"][ended] == invalid
    for result in results:
        array = getattr(out, result.name)
        if array is None or result.tallied:
            continue
        for k, source in enumerate(result.columns):
            values = columns[source][ended]
            if result.blank:
                values = np.where(blank, np.nan, values)
            array[(row, k) if result.row else row] = values


def _take(values: Any, rows: NDArray[np.int64]) -> Any:
    """Return the rows of a column; what all shots share stays."""
    return values.take(rows, None, None, "clip") if np.ndim(values) else values
