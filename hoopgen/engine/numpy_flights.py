"""The shots in flight of the NumPy engine, as columns of a block.

Each iteration takes all of them to their next event; shots that end leave the columns, and others
take their place. The stages of the generated module make all decisions.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from types import ModuleType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .result_arrays import ResultArrays

Floats = NDArray[np.float64]
Column = Floats | float

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


@dataclass(frozen=True)
class Inputs:
    """The inputs of shots, as the caller gives them.

    Attributes
    ----------
    states, parameters, leaving
        As for `run`.
    first
        The row of the first shot in the results.
    """

    states: Floats
    parameters: Sequence[Column]
    leaving: NDArray[np.int8] | None
    first: int

    def columns(self, kernels: ModuleType, rows: slice | NDArray[np.int64]) -> dict[str, Column]:
        """Return the columns of some of the shots.

        Parameters
        ----------
        kernels
            A generated module.
        rows
            Their rows in `states`.
        """
        states = self.states[rows]
        given: dict[str, Column] = dict(zip(kernels.STATE, states.T.copy(), strict=True))
        for name, value in zip(kernels.VARIABLES.values(), self.parameters, strict=True):
            given[name] = value if np.ndim(value) == 0 else np.asarray(value, np.float64)[rows]
        left = self.leaving
        given["last"] = (
            np.full(len(states), -1.0) if left is None else left[rows].astype(np.float64)
        )
        return given


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
    inputs
        What is given for the shots.
    most
        Largest number of shots in flight.

    Attributes
    ----------
    inputs
        What is given for these and all shots that have joined them.
    loose
        The rows in the results of shots that have ended, and whose bounds may be tightened.
    """

    def __init__(
        self,
        kernels: ModuleType,
        bounds: bool,
        job: dict[str, float],
        inputs: Inputs,
        most: int,
    ) -> None:
        name = "bounded" if bounds else "plain"
        self.inputs = [inputs]
        self.loose: list[NDArray[np.int64]] = []
        tightening = job["tightening"] > 0.0
        self._review = None if tightening else getattr(kernels, f"review_{name}", None)
        stages = ("validate", "start", "detect", "resolve")
        self._validate, self._start, self._detect, self._resolve = (
            getattr(kernels, f"{stage}_{name}") for stage in stages
        )
        fields = [f for f in kernels.FIELDS if bounds or not f.is_diagnostic]
        # What only tightening needs is one number for all shots.
        self._unused = {f.name: np.float32(f.start) for f in fields if f.is_tightening > tightening}
        self._starts = {f.name: f.start for f in fields if f.name not in self._unused}
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
        self._room = Room(kernels, most)
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
        fresh = (
            self._job
            | self._unused
            | {
                name: np.full(shots, start, self._types[name]) if start is not None else given[name]
                for name, start in self._starts.items()
            }
        )
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
        columns = self._columns | self._job | self._unused
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
        if self._review is not None:
            self._review(columns, shots, self._room)
            if len(rows := self.row[over & columns["loose"]]):
                self.loose.append(rows)
        _finish(self._results, self._invalid, columns, self.row, over, out)
        kept = np.flatnonzero(~over)
        if len(kept) == shots:
            return columns
        self.row = self.row[kept]
        return {name: _take(values, kept) for name, values in columns.items()}

    def join(self, other: Flights) -> None:
        """Add the shots of another instance at the same stage."""
        self.inputs += other.inputs
        self.loose += other.loose
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
        if out.event_errors is not None:
            for result in (one for one in self._results if one.switch):
                errors = out.event_errors[result.name]
                for k, source in enumerate(result.columns):
                    values = np.broadcast_to(columns[source], len(self.row))[happened]
                    errors[(*rows, k) if result.row else rows] = values
        out.event_counts[row] += 1


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
