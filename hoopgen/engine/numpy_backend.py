"""The driver of the generated event loop in NumPy: blocks of shots, results and the log.

A block holds the shots in flight as columns. Each iteration takes all of them to their next event;
shots that end leave the columns, and others take their place. The stages of the generated module
make all decisions.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from threading import Lock
from types import ModuleType

import numpy as np
from numpy.typing import NDArray

from .numpy_flights import Column, Flights, Floats, Inputs
from .result_arrays import LOG, ResultArrays, need_bounds

BLOCK_SIZE = 1 << 14
"""Shots that are simulated together; their arrays fit the second-level cache."""

MIN_SHOTS_PER_THREAD = 1 << 11
"""Number of shots that cost hardly less than twice as many: at the end, threads merge so few."""


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
    *,
    tightening: bool = True,
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
    tightening
        Whether bounds on errors are tightened for the shots that end uncertain without, and are not
        capped, as in all engines.
    """
    if out.event_counts is not None:
        out.event_counts[:] = 0
    job = {
        "most_contacts": float(max_contacts),
        "time_limit": time_limit,
        "tightening": 0.0,
        **_switches(kernels, out),
    }
    last = last or SharedTail(1, len(states))
    bounds = need_bounds(kernels, out.arrays)
    inputs, most = Inputs(states, parameters, leaving, first), min(last.shots, BLOCK_SIZE)
    flights = Flights(kernels, bounds, job, inputs, most)
    with np.errstate(all="ignore"):
        done = _simulate(kernels, flights, None, out, stopped, last)
        if not (done and tightening and flights.loose):
            return
        loose = np.sort(np.concatenate(flights.loose))
        wanted = {name: own for name, own in out.arrays.items() if need_bounds(kernels, [name])}
        if out.event_errors is not None:  # then the log is written again
            wanted |= {name: out.arrays[name] for name in LOG}
            out.arrays["event_counts"][loose] = 0
        for inputs in flights.inputs:
            ends = np.array([inputs.first, inputs.first + len(inputs.states)])
            start, stop = np.searchsorted(loose, ends)
            rows, again = loose[start:stop] - inputs.first, job | {"tightening": 1.0}
            shots = Flights(kernels, bounds, again, inputs, min(len(rows), BLOCK_SIZE))
            tail = SharedTail(1, len(rows))
            _simulate(kernels, shots, rows, ResultArrays(**wanted), stopped, tail)


def _simulate(
    kernels: ModuleType,
    flights: Flights,
    rows: NDArray[np.int64] | None,
    out: ResultArrays,
    stopped: Callable[[], bool],
    last: SharedTail,
) -> bool:
    """Simulate shots to their ends; return whether that is done, also for those that joined them.

    Parameters
    ----------
    kernels
        As for `run`.
    flights
        The shots in flight, none yet.
    rows
        The rows of the shots in what is given for them; None: all.
    out, stopped, last
        As for `run`.
    """
    (inputs,) = flights.inputs
    begun, shots = 0, len(inputs.states) if rows is None else len(rows)
    while not stopped():
        flying = len(flights.row)
        if begun < shots:
            if flying < BLOCK_SIZE // 2:
                end = min(begun + BLOCK_SIZE - flying, shots)
                own = slice(begun, end) if rows is None else rows[begun:end]
                row = np.arange(begun, end) if rows is None else rows[begun:end]
                flights.begin(inputs.columns(kernels, own), row + inputs.first, out)
                begun = end
        elif not last.go_on(flights):
            return False
        if not len(flights.row):
            if begun < shots:
                continue
            return True
        flights.advance(out)
    return False


def _switches(kernels: ModuleType, out: ResultArrays) -> dict[str, float]:
    """Return the numbers that are 1 if a result which needs them is wanted, 2 if the log has it."""
    found: dict[str, float] = {}
    logged = out.event_errors is not None
    for result in kernels.RESULTS:
        if result.switch:
            wanted = 2.0 if logged else float(getattr(out, result.name) is not None)
            found[result.switch] = max(found.get(result.switch, 0.0), wanted)
    return found
