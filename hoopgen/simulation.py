"""`simulate`: checks its input, shares the shots among threads, and gathers the results."""

from __future__ import annotations

import sys
import threading
from collections.abc import Iterable, Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import cache
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hoopgen.generated.numpy import hoop

from .brief import brief, listed
from .engine import native, numpy_backend
from .engine.arithmetic import check_arithmetic
from .engine.raw import BOUNDS, EVENT, FIELDS, Raw, allocate, allocate_events
from .inputs import check_contacts, check_leaving, check_states, check_threads, check_time_limit
from .parameters import NAMES, PAPER, Value, resolve
from .results import SURFACES, Shots
from .sizes import check_room

CHUNK = 1 << 17
"""Most shots that a thread takes at a time; each chunk costs a call, and lanes idle at its end."""

SHARE = 8
"""Chunks for each of several threads in C, so that they end together; fewer of small ones."""

SMALL = 1 << 12
"""A chunk that is small."""

ROOM = 1 << 16
"""Rows of the event log that a thread makes room for at a time: every contact that could be."""

LEAST = 1 << 12
"""Fewest shots that a thread takes at a time in NumPy, whose every operation costs a call."""

AT_ONCE = 1 << 17
"""Contacts that could be, up to which no thread is started: some hundredths of a second."""


@dataclass(frozen=True)
class _Batch:
    states: NDArray[np.float64]
    parameters: list[Value]
    leaving: NDArray[np.int8] | None
    max_contacts: int
    time_limit: float
    library: native.Library | None
    stop: NDArray[np.int32]

    def stopped(self) -> bool:
        """Return whether no further shots are wanted."""
        return bool(self.stop[0])

    def run(self, start: int, stop: int, out: Raw) -> None:
        """Simulate some of the shots into their rows of `out`."""
        states = self.states[start:stop]
        parameters = [p if isinstance(p, float) else p[start:stop] for p in self.parameters]
        leaving = None if self.leaving is None else self.leaving[start:stop]
        given = (states, parameters, leaving, self.max_contacts, out)
        if self.library is not None:
            self.library.run(*given, self.stop, time_limit=self.time_limit)
        else:
            check_arithmetic()  # the library looks for itself
            numpy_backend.run(hoop, *given, self.stopped, time_limit=self.time_limit)


def simulate(
    states: ArrayLike,
    parameters: Mapping[str, Any] = PAPER,
    *,
    max_contacts: int = 40,
    backend: Literal["auto", "c", "numpy"] = "auto",
    threads: int | None = None,
    fields: Literal["all"] | Iterable[str] = "all",
    record: bool = False,
    leaving: ArrayLike | None = None,
    settle: bool = False,
    time_limit: float | None = None,
) -> Shots:
    """Simulate shots from contact to contact until they end.

    Parameters
    ----------
    states
        Releases, (n, 9) or (9,): x y z (m), vx vy vz (m/s), wx wy wz (rad/s); origin at the ring's
        centre, z up, backboard at negative x. Here and below, entries that are
        masked count as NaN.
    parameters
        Name to value, one for all shots or (n,). `PAPER`, `NBA` and `FIBA` merge with ``|``.
    max_contacts
        A shot with so many contacts ends as capped; at least 1.
    backend
        "auto" is "c" where it was built, else "numpy". The results are the same bits.
    threads
        How many work; None for one on each processor that the process may use. More than four on
        each are not started, nor with NumPy more than have 4096 shots each: they would be in each
        other's way.
    fields
        "all", or the names of the results that are wanted; by name also "time_error" and
        "state_error", the bounds on the errors of time and state. Without "uncertain" and those
        two no errors are bounded, which saves a fifth or more; the path is the same.
    record
        Whether to keep the event log, which `Shots.trajectory` needs.
    leaving
        To go on from recorded `after` states: the surface that each shot touches at the start and
        leaves, an index into `SURFACES` or -1 for none; one for all or (n,).
    settle
        Whether to let `certify` decide the uncertain shots, which then are not; needs the extra
        "certify". A true tie, an exact touch or an exact edge stays uncertain.
    time_limit
        s since the release, of flight and contact: a shot that has not ended then ends as ENDLESS,
        with its state at that time; None for no limit. A shot that can never reach the end plane is
        SHORT all the same, unless the limit comes before its last contact.

    Returns
    -------
    Shots
        By shot, whatever the backend and the number of threads. A shot that cannot be simulated
        is INVALID, with NaN results, and does not disturb the others.

    Raises
    ------
    TypeError, ValueError
        If an argument is not as described; the message says what is.
    RuntimeError
        If backend "c" is asked for and was not built, or cannot be trusted; if this thread rounds
        otherwise than to the nearest double, or takes subnormals for zero.
    ImportError
        If shots are to be settled and the extra is missing.
    """
    releases = check_states(states)
    shots = len(releases)
    values = resolve(parameters, shots)
    most = check_contacts(max_contacts)
    wanted = _fields(fields)
    workers = check_threads(threads)
    if record:
        check_log(shots, most, workers)
    batch = _Batch(
        releases,
        values,
        check_leaving(leaving, shots),
        most,
        check_time_limit(time_limit),
        _library(backend),
        np.zeros(1, np.int32),
    )
    computed = tuple(dict.fromkeys((*wanted, "uncertain"))) if settle else wanted
    out = allocate(shots, len(SURFACES), computed)
    logs = _run(batch, out, workers, record)
    results = dict(out.arrays)
    if record:
        results["events"] = np.concatenate([np.empty(0, EVENT), *logs])
    if settle:
        # Apart from the engines, and not needed without them: it stands on SymPy and python-flint.
        from .judge.settle import settle as decide

        left, limit = batch.leaving, batch.time_limit
        decide(results, releases, parameters, most, leaving=left, time_limit=limit)
    kept = {name: array for name, array in results.items() if name in (*wanted, "events")}
    return Shots(kept, releases, dict(zip(NAMES, values, strict=True)))


def check_log(shots: int, max_contacts: int, threads: int | None = None) -> None:
    """Refuse an event log for which there is no room; arguments as of `simulate`.

    Raises
    ------
    ValueError
        If it would take too much memory.
    """
    # Room is made for every contact that could be, by each thread for the shots it has.
    at_once = min(shots, check_threads(threads) * max(1, ROOM // (max_contacts + 1)))
    rows = at_once * (max_contacts + 1)
    check_room("max_contacts", rows, "events to be recorded at once", EVENT.itemsize + 16)


def _run(batch: _Batch, out: Raw, threads: int, record: bool) -> list[NDArray[Any]]:
    """Run the batch in chunks; return the chunks' event logs, in order."""
    shots = len(batch.states)

    def work(start: int) -> NDArray[Any] | None:
        stop = min(start + size, shots)
        rows = out.rows(start, stop)
        if not record:
            batch.run(start, stop, rows)
            return None
        room = allocate_events(stop - start, batch.max_contacts)
        batch.run(start, stop, rows.joined(room))
        used = np.arange(batch.max_contacts + 1) < room.arrays["event_counts"][:, None]
        log = room.arrays["events"][used]
        log["shot"] += start
        return log

    size = _chunk(shots, threads, batch.library is not None)
    if record:
        size = max(1, min(size, ROOM // (batch.max_contacts + 1)))
    starts = range(0, shots, size)
    # Python sees no Ctrl-C while its main thread is in the engine, so another one goes there.
    main = threading.current_thread() is threading.main_thread()
    if shots * batch.max_contacts <= AT_ONCE or (threads == 1 and not main):
        logs = [work(start) for start in starts]
    else:
        with ThreadPoolExecutor(threads) as pool:
            try:
                logs = list(pool.map(work, starts))
            except BaseException:
                batch.stop[0] = 1
                pool.shutdown(wait=False, cancel_futures=True)
                raise
    return [log for log in logs if log is not None]


def _chunk(shots: int, threads: int, in_c: bool) -> int:
    """Return how many shots a thread takes at a time."""
    own = -(-shots // threads)
    if not in_c:
        return max(own, LEAST)
    if threads > 1:
        own = max(own // SHARE, min(own // 2, SMALL))
    return max(1, min(own, CHUNK))


def _fields(fields: str | Iterable[str]) -> tuple[str, ...]:
    if isinstance(fields, str):
        fields = FIELDS if fields == "all" else (fields,)
    if not isinstance(fields, Iterable):
        raise TypeError(f"fields: expected 'all' or names, got {brief(fields)}")
    wanted = tuple(fields)  # once: they may be an iterator
    unknown = [name for name in wanted if name not in FIELDS + BOUNDS]
    if unknown:
        raise ValueError(
            f"fields: unknown {listed(unknown)}. 'all', or some of {', '.join(FIELDS + BOUNDS)}"
        )
    return wanted


def _library(backend: str) -> native.Library | None:
    if backend not in ("auto", "c", "numpy"):
        raise ValueError(f"backend: expected 'auto', 'c' or 'numpy', got {brief(backend)}")
    if backend == "numpy":
        return None
    library = native.installed()
    if library is None:
        refused = native.load()
        assert isinstance(refused, native.Refused)
        if backend == "c":
            raise RuntimeError(f"backend: 'c' {refused.reason}; {refused.remedy}, or use 'numpy'")
        _say_once(refused)
    return library


@cache
def _say_once(refused: native.Refused) -> None:
    print(
        f"hoopgen: the C engine {refused.reason}; {refused.remedy}. NumPy serves, slower.",
        file=sys.stderr,
    )
