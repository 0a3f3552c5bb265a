"""The driver of the generated event loop in NumPy: blocks of shots, results and the log.

A block holds the shots in flight as columns. Each iteration takes all of them to their next event;
shots that end leave the columns, and others take their place. The stages of the generated module
make all decisions.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from threading import Lock
from types import ModuleType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .result_arrays import ResultArrays, need_bounds

Floats = NDArray[np.float64]
Column = Floats | float

BLOCK_SIZE = 1 << 14
"""Shots that are simulated together; their arrays fit the second-level cache."""

MIN_SHOTS_PER_THREAD = 1 << 11
"""Number of shots that cost hardly less than twice as many: at the end, threads merge so few."""

DOUBLES_PER_LINE = 8
"""Doubles in a cache line. Arrays that do not begin with a line are written at half the speed."""


class Room:
    """Scratch rows of kernels, shared by all of them."""

    def __init__(self, kernels: ModuleType, shots: int) -> None:
        rows, width = kernels.ROWS, -(-shots // DOUBLES_PER_LINE) * DOUBLES_PER_LINE
        room = np.empty(rows * width + DOUBLES_PER_LINE)
        first = -(room.ctypes.data // room.itemsize) % DOUBLES_PER_LINE
        # A list, of which each row is cut anew: an array of them takes five times as long.
        self._rows = list(room[first:][: rows * width].reshape(rows, width))
        self._few, self._none = kernels.FEW, kernels.NO_ROWS

    def __call__(self, shots: int) -> tuple[Floats | None, ...]:
        """Return rows of so many shots; for few shots none, and the kernel allocates arrays."""
        return self._none if shots < self._few else tuple([row[:shots] for row in self._rows])


class Flights:
    """Shots of a block that are in flight.

    Parameters
    ----------
    kernels
        A generated module.
    bounds
        Whether anything that bounds errors is wanted.
    job
        Inputs that are the same for all shots, by name.
    most
        Largest number of shots in flight.
    """

    def __init__(self, kernels: ModuleType, bounds: bool, job: dict[str, float], most: int) -> None:
        name = "bounded" if bounds else "plain"
        stages = ("validate", "start", "detect", "resolve")
        self._validate, self._start, self._detect, self._resolve = (
            getattr(kernels, f"{stage}_{name}") for stage in stages
        )
        self._starts = {f.name: f.start for f in kernels.FIELDS if bounds or not f.is_diagnostic}
        self._types = {f.name: f.dtype for f in kernels.FIELDS}
        self._kept = (*self._starts, *kernels.VARIABLES.values())
        self._state, self._results = kernels.STATE, kernels.RESULTS
        self._invalid = float(kernels.Outcome.INVALID)
        # Plain integers: of an enumeration's members NumPy asks for attributes in Python code, and
        # drops what is raised there, which may be the KeyboardInterrupt of Ctrl-C.
        self._kinds = {kind.name: int(kind) for kind in kernels.Event}
        self._end = len(kernels.BODIES)
        self._tallies = [result.name for result in kernels.RESULTS if result.is_counted]
        self._job, self._bounds = job, bounds
        self._room = Room(kernels, min(most, BLOCK_SIZE))
        self.row = np.empty(0, np.int64)
        self._columns: dict[str, Any] = dict.fromkeys(self._kept, np.empty(0))

    def begin(self, given: dict[str, Column], row: NDArray[np.int64], out: ResultArrays) -> None:
        """Add shots by their columns; one that cannot start ends at once.

        Parameters
        ----------
        given
            Columns by name, each (n,) or a number.
        row
            The row of each shot in the results, (n,).
        out
            The result arrays.
        """
        shots = len(row)
        fresh = self._job | {
            name: np.full(shots, start, self._types[name]) if start is not None else given[name]
            for name, start in self._starts.items()
        }
        fresh |= {name: given[name] for name in self._kept if name not in self._starts}
        self._validate(fresh, shots, self._room)
        self._start(fresh, shots, self._room)
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

    def advance(self, out: ResultArrays) -> None:
        """Advance every shot to its next event; write and remove those that end."""
        columns = self._columns | self._job
        self._detect(columns, len(self.row), self._room)
        before = self._states(columns) if out.events is not None else None
        for name in self._tallies:
            if (tally := getattr(out, name)) is not None:
                body = self._bodies(columns)
                met = np.flatnonzero((body >= 0.0) & (body < self._end))
                tally[self.row[met], body[met].astype(np.int64)] += 1
        if before is None and not self._bounds:
            # Nothing is left to do for one that ends and touches nothing.
            over = np.logical_not(columns["touches"]) & (columns["outcome"] >= 0.0)
            columns = self._ended(columns, over, out)
        self._resolve(columns, len(self.row), self._room)
        if before is not None:
            self._record(columns, before, out)
        columns = self._ended(columns, columns["outcome"] >= 0.0, out)
        self._columns = {name: columns[name] for name in self._kept}

    def _ended(self, columns: dict[str, Any], over: Any, out: ResultArrays) -> dict[str, Any]:
        """Write and remove shots that are over; return the columns of the others."""
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
        """Add the shots in flight of another instance at the same stage."""
        if not len(self.row):
            self._columns, self.row = other._columns, other.row
        elif len(other.row):
            for name, own in self._columns.items():
                if np.ndim(own):
                    self._columns[name] = np.concatenate([own, other._columns[name]])
            self.row = np.concatenate([self.row, other.row])

    def _bodies(self, columns: dict[str, Any]) -> Floats:
        """Return the body of each shot's event, of which a kernel may say one number for all."""
        return np.broadcast_to(columns["body"], len(self.row))

    def _states(self, columns: dict[str, Any]) -> Floats:
        return np.stack([columns[name] for name in self._state], axis=1)

    def _record(self, columns: dict[str, Any], before: Floats, out: ResultArrays) -> None:
        assert out.events is not None
        assert out.event_counts is not None
        bodies = self._bodies(columns)
        happened = np.flatnonzero(bodies >= 0.0)
        row = self.row[happened]
        rows = (row, out.event_counts[row])
        body, end = bodies[happened].astype(np.int64), self._end
        staying = body - end - 1
        kinds = np.where(staying % 2, self._kinds["LEAVE"], self._kinds["ROLL"])
        kinds[body < end], kinds[body == end] = self._kinds["IMPACT"], self._kinds["END"]
        out.events["shot"][rows] = row
        out.events["surface"][rows] = np.where(staying < 0, body, staying // 2)
        out.events["kind"][rows] = kinds
        out.events["time"][rows] = columns["clock"][happened]
        out.events["before"][rows] = before[happened]
        out.events["after"][rows] = self._states(columns)[happened]
        out.event_counts[row] += 1


class SharedTail:
    """The last shots of threads, which one of them finishes for all.

    Parameters
    ----------
    threads
        Number of parts.
    shots
        Number of shots of all parts.
    """

    def __init__(self, threads: int, shots: int) -> None:
        self._lock, self._left, self._at_work = Lock(), list[Flights](), threads
        self.shots = shots

    def go_on(self, flights: Flights) -> bool:
        """Return whether a thread continues; False if it left its last shots to others.

        A thread that goes on takes over the shots that others left, as far as its block has room.
        The last thread goes on until no shots are left.
        """
        with self._lock:
            if len(flights.row) <= MIN_SHOTS_PER_THREAD and self._at_work > 1:
                self._at_work -= 1
                self._left.append(flights)
                return False
            while self._left and len(flights.row) + len(self._left[-1].row) <= BLOCK_SIZE:
                flights.join(self._left.pop())
        return True


def run(
    kernels: ModuleType,
    states: Floats,
    parameters: Sequence[Column],
    leaving: NDArray[np.int8] | None,
    max_contacts: int,
    out: ResultArrays,
    stopped: Callable[[], bool] = lambda: False,
    time_limit: float = np.inf,
    first: int = 0,
    last: SharedTail | None = None,
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
        Called between events; the run ends when it returns True.
    time_limit
        Time since the release at which a shot ends, s; infinite: none.
    first
        The row of `out` that the first shot has.
    last
        Shared by runs of other parts of the same shots into the same `out`, without a log.
    """
    if out.event_counts is not None:
        out.event_counts[:] = 0
    job = {
        "most_contacts": float(max_contacts),
        "time_limit": time_limit,
        **_switches(kernels, out),
    }
    last = last or SharedTail(1, len(states))
    flights = Flights(kernels, need_bounds(kernels, out.arrays), job, last.shots)
    begun = 0
    with np.errstate(all="ignore"):
        while not stopped():
            flying = len(flights.row)
            if begun < len(states):
                if flying < BLOCK_SIZE // 2:
                    rows = slice(begun, min(begun + BLOCK_SIZE - flying, len(states)))
                    given = _input_columns(kernels, states, parameters, leaving, rows)
                    flights.begin(given, np.arange(rows.start, rows.stop) + first, out)
                    begun = rows.stop
            elif not last.go_on(flights):
                return
            if not len(flights.row):
                if begun < len(states):
                    continue
                return
            flights.advance(out)


def _switches(kernels: ModuleType, out: ResultArrays) -> dict[str, float]:
    """Return the numbers that are 1 if a result which needs them is wanted."""
    found: dict[str, float] = {}
    for result in kernels.RESULTS:
        if result.switch:
            wanted = getattr(out, result.name) is not None
            found[result.switch] = max(found.get(result.switch, 0.0), float(wanted))
    return found


def _input_columns(
    kernels: ModuleType,
    states: Floats,
    parameters: Sequence[Column],
    leaving: NDArray[np.int8] | None,
    rows: slice,
) -> dict[str, Column]:
    """Return the columns of the caller's inputs for some rows."""
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
    out: ResultArrays,
) -> None:
    """Write the results of the shots that are over."""
    ended = np.flatnonzero(over)
    if not len(ended):
        return
    row = row[ended]
    empty = columns["outcome"][ended] == invalid
    for result in results:
        array = getattr(out, result.name)
        if array is None or result.is_counted:
            continue
        for k, source in enumerate(result.columns):
            values = columns[source][ended]
            if result.is_empty_if_invalid:
                values = np.where(empty, np.nan, values)
            array[(row, k) if result.row else row] = values


def _take(values: Any, rows: NDArray[np.int64]) -> Any:
    """Return rows of a column; a shared number stays."""
    return values.take(rows, None, None, "clip") if np.ndim(values) else values
