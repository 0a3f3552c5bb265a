"""`simulate`: checks its input, shares the shots among threads, and gathers the results."""

from __future__ import annotations

import math
import sys
import threading
from collections.abc import Iterable, Iterator, Mapping
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import cache, partial
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .brief import brief, listed
from .engine import native, numpy_backend, pools
from .engine.arithmetic import check_arithmetic
from .engine.raw import Raw
from .engines import HOOP, Engine
from .inputs import check_contacts, check_leaving, check_states, check_threads, check_time_limit
from .parameters import Value, resolve
from .results import Shots
from .scenes import engine_of
from .sizes import check_room

PARTS = 4
"""In C each of several threads takes this part of its share of what is left, again and again: so
they end together, and lanes idle at the end of each thread's last shots alone."""

ROOM = 1 << 16
"""Rows of the event log that a thread makes room for at a time."""

FEW = 40
"""Contacts of a shot that there is room for in the log, at first; for those that have more, it
grows as `MORE` says."""

MORE = 8

LEAST = 1 << 12
"""Fewest shots that a thread takes at a time in NumPy, whose every operation costs a call."""

AT_ONCE = 1 << 17
"""Contacts that could be, up to which no thread is asked: some hundredths of a second in NumPy. In
C so many more ask one more."""

AT_ONCE_IN_C = 1 << 20
"""The same for one thread in C, as `_is_brief` counts; of several the caller's is one, up to so
many."""

STEPS = 1 << 8
"""Most steps that a ball takes in a second of rolling: a few times what swirls in the ring take. A
step costs about what a contact does."""

BODIES = 3
"""With so many a contact costs what `AT_ONCE_IN_C` stands for; each may have to be looked at."""


@dataclass(frozen=True)
class _Batch:
    scene: Engine
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

    def part(self, rows: slice | NDArray[np.intp]) -> _Batch:
        """Return some of the shots."""
        parameters = [p if isinstance(p, float) else p[rows] for p in self.parameters]
        leaving = None if self.leaving is None else self.leaving[rows]
        return replace(self, states=self.states[rows], parameters=parameters, leaving=leaving)

    def run(
        self,
        out: Raw,
        most: int,
        share: native.Share | None = None,
        first: int = 0,
        last: numpy_backend.Last | None = None,
    ) -> None:
        """Simulate the shots into `out`, with so many contacts at most.

        In C those of a share; in NumPy they may be a part of those in `out`, from the first on.
        """
        given = (self.states, self.parameters, self.leaving, most, out)
        if self.library is not None:
            self.library.run(*given, self.stop, time_limit=self.time_limit, share=share)
        else:
            check_arithmetic()  # the library looks for itself
            rest = (self.stopped, self.time_limit, first, last)
            numpy_backend.run(self.scene.kernels, *given, *rest)

    def record(self, out: Raw, most: int) -> NDArray[Any]:
        """Simulate the shots into `out` and return their event log, in order.

        Room is made for `most` contacts of each; shots that have more are simulated again.
        """
        layout, shots = self.scene.layout, len(self.states)
        log = layout.allocate_events(shots, most)
        ended = layout.allocate(shots, {"outcome", "contacts"} - out.arrays.keys())
        whole = out.joined(ended).joined(log)
        self.run(whole, most)
        assert whole.outcome is not None
        assert whole.contacts is not None
        again = np.zeros(shots, np.bool_)
        if most < self.max_contacts and not self.stopped():
            # One with fewer contacts ended for another reason, and would again.
            again = (whole.outcome == self.scene.outcomes["CAPPED"]) & (whole.contacts >= most)
        used = np.arange(layout.log_rows(most)) < log.arrays["event_counts"][:, None]
        logs = [log.arrays["events"][used & ~again[:, None]]]
        more = min(MORE * most, self.max_contacts)
        rows, size = np.flatnonzero(again), max(1, ROOM // (more + 1))
        for some in (rows[k : k + size] for k in range(0, len(rows), size)):
            longer = layout.allocate(len(some), out.arrays)
            logs.append(self.part(some).record(longer, more))
            logs[-1]["shot"] = some[logs[-1]["shot"]]
            for name, array in longer.arrays.items():
                out.arrays[name][some] = array
        events = np.concatenate(logs)
        return events[np.argsort(events["shot"], kind="stable")] if len(logs) > 1 else events


def simulate(
    states: ArrayLike,
    parameters: Mapping[str, Any] | None = None,
    *,
    scene: Any = None,
    max_contacts: int | None = None,
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
        Name to value, one for all shots or (n,); those left out have the scene's usual values. For
        the hoop `PAPER`, its usual ones, `NBA` and `FIBA`; for `COURT` `PAPER_COURT`, `NBA_COURT`
        and `FIBA_COURT`. They merge with ``|``.
    scene
        None for `HOOP`, the article's; `COURT`, the whole hoop with friction; or what `compile`
        takes or has returned.
    max_contacts
        A shot with so many contacts ends as capped; at least 1. None: 40 in the hoop, as in the
        article, elsewhere 1000.
    backend
        "auto" is "c" where it was built, else "numpy". The results are the same bits.
    threads
        How many work; None for one on each processor that the process may use. More than four on
        each are not started, nor more than have some thousands of shots each: they would be in
        each other's way.
    fields
        "all", or the names of the results that are wanted; by name also "time_error" and
        "state_error", the bounds on the errors of time and state, and where a ball may roll
        "grip_lost". Without "uncertain" and those no errors are bounded, which saves a fifth or
        more; the path is the same.
    record
        Whether to keep the event log, which `Shots.trajectory` needs.
    leaving
        To go on from recorded `after` states: the surface that each shot touches at the start and
        leaves, an index into `Shots.surfaces` or -1 for none; one for all or (n,).
    settle
        Whether to let `certify` decide the uncertain shots, which then are not; needs the extra
        "certify". A true tie, an exact touch or an exact edge stays uncertain.
    time_limit
        s since the release, of flight and contact: a shot that has not ended then ends as ENDLESS,
        with its state at that time; so does one that is certain to roll for ever, as soon as that
        is. At most 2^40. None: no limit in the hoop, elsewhere 60. A shot that can never
        reach the end plane is SHORT all the same, unless the limit comes before its last contact.

    Returns
    -------
    Shots
        By shot, whatever the backend and the number of threads. A shot that cannot be simulated
        is INVALID, with NaN results, and does not disturb the others; `why_invalid` says why.

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
    engine = engine_of(scene)
    values = resolve(parameters, shots, engine.table)
    named = dict(zip(engine.table.defaults, values, strict=True))
    most = engine.max_contacts if max_contacts is None else check_contacts(max_contacts)
    wanted = _fields(fields, engine)
    workers = check_threads(threads)
    if record:
        check_log(shots, most, workers, engine)
    batch = _Batch(
        engine,
        releases,
        engine.table.inputs(named),
        check_leaving(leaving, shots, len(engine.surfaces)),
        most,
        _limit(time_limit, engine),
        _library(backend, engine),
        np.zeros(1, np.int32),
    )
    computed = tuple(dict.fromkeys((*wanted, "uncertain"))) if settle else wanted
    out = engine.layout.allocate(shots, computed)
    results = dict(out.arrays)
    if not record and batch.library is not None:
        _share(batch, out, workers)
    else:
        logs = _run(batch, out, workers, record)
    if record:
        results["events"] = np.concatenate([np.empty(0, engine.layout.event), *logs])
    if settle:
        # Apart from the engines, and not needed without them: it stands on SymPy and python-flint.
        from .judge.settle import settle as decide

        left, limit = batch.leaving, batch.time_limit
        decide(results, releases, named, most, scene=engine, leaving=left, time_limit=limit)
        results = {name: array for name, array in results.items() if name in (*wanted, "events")}
    return Shots(results, releases, named, engine)


def _limit(time_limit: float | None, engine: Engine) -> float:
    limit = engine.time_limit if time_limit is None else check_time_limit(time_limit)
    if engine.rolls and not math.isfinite(limit):
        raise ValueError(
            f"time_limit: expected a finite time in the scene {engine.name}, where a ball may roll "
            f"for ever; got {brief(time_limit)}"
        )
    return limit


def check_log(
    shots: int, max_contacts: int, threads: int | None = None, scene: Engine = HOOP
) -> None:
    """Refuse an event log for which there is no room; arguments as of `simulate`.

    Raises
    ------
    ValueError
        If it would take too much memory.
    """
    # Room is made for every contact that could be, by each thread for the shots it has.
    layout = scene.layout
    each = layout.log_rows(max_contacts)
    at_once = min(shots, check_threads(threads) * max(1, ROOM // each))
    row = layout.event.itemsize + 16
    check_room("max_contacts", at_once * each, "events to be recorded at once", row)


def _share(batch: _Batch, out: Raw, threads: int) -> None:
    """Run the batch in C: the threads share its shots."""
    contacts = len(batch.states) * batch.max_contacts
    # A caller waits less for itself than for a thread to wake.
    here = _is_brief(batch) or not _interruptible()
    others = min(threads, contacts // AT_ONCE + 1) - here
    if not others:
        batch.run(out, batch.max_contacts)
        return
    share = native.Share(PARTS * (others + here))
    with _pool(batch, others) as pool:
        work = partial(batch.run, out, batch.max_contacts, share)
        asked = [pool.submit(work) for _ in range(others)]
        if here:
            work()
        for one in asked:
            one.result()


def _run(batch: _Batch, out: Raw, threads: int, record: bool) -> list[NDArray[Any]]:
    """Run the batch in chunks; return the chunks' event logs, in order."""
    shots = len(batch.states)

    def work(start: int) -> NDArray[Any] | None:
        stop = min(start + size, shots)
        part = batch.part(slice(start, stop))
        if not record:
            part.run(out, batch.max_contacts, first=start, last=last)
            return None
        log = part.record(out.rows(start, stop), first)
        log["shot"] += start
        return log

    in_c = batch.library is not None
    size = max(-(-shots // threads), 1 if in_c else LEAST)
    first = min(FEW, batch.max_contacts)
    if record:
        size = max(1, min(size, ROOM // (first + 1)))
    starts = range(0, shots, size)
    last = numpy_backend.Last(len(starts), shots)
    contacts = shots * batch.max_contacts
    if in_c:
        here = _is_brief(batch) and (threads == 1 or contacts <= AT_ONCE)
    else:
        here = contacts <= AT_ONCE
    if here or (threads == 1 and not _interruptible()):
        logs = [work(start) for start in starts]
    else:
        with _pool(batch, threads) as pool:
            logs = list(pool.map(work, starts))
    return [log for log in logs if log is not None]


def _is_brief(batch: _Batch) -> bool:
    """Return whether one thread in C takes some hundredths of a second, whatever the shots do.

    Few shots take as long as the lanes have room for; one may have many contacts, bodies to pass
    and seconds to roll.
    """
    lanes = len(batch.states) + native.WIDTHS[-1] - 1
    steps = batch.max_contacts + (STEPS * batch.time_limit if batch.scene.rolls else 0)
    bodies = max(1, len(batch.scene.surfaces) / BODIES)
    return lanes * steps * bodies <= AT_ONCE_IN_C


def _interruptible() -> bool:
    """Return whether Ctrl-C is for this thread: Python does not see it while that is in C."""
    return threading.current_thread() is threading.main_thread()


@contextmanager
def _pool(batch: _Batch, threads: int) -> Iterator[ThreadPoolExecutor]:
    """Have threads work on a batch; if that fails, they stop."""
    pool = pools.take(threads)
    try:
        yield pool
    except BaseException:
        batch.stop[0] = 1
        pool.shutdown(wait=False, cancel_futures=True)
        raise
    pools.leave(pool, threads)


def _fields(fields: str | Iterable[str], scene: Engine) -> tuple[str, ...]:
    if isinstance(fields, str):
        if fields == "all":
            return scene.layout.fields
        fields = (fields,)
    if not isinstance(fields, Iterable):
        raise TypeError(f"fields: expected 'all' or names, got {brief(fields)}")
    wanted = tuple(fields)  # once: they may be an iterator
    unknown = [name for name in wanted if name not in scene.layout.results]
    if unknown:
        names = ", ".join(scene.layout.fields + scene.layout.bounds)
        raise ValueError(f"fields: unknown {listed(unknown)}. 'all', or some of {names}")
    return wanted


def _library(backend: str, scene: Engine) -> native.Library | None:
    if backend not in ("auto", "c", "numpy"):
        raise ValueError(f"backend: expected 'auto', 'c' or 'numpy', got {brief(backend)}")
    if backend == "numpy":
        return None
    found = scene.found
    if not isinstance(found, native.Refused):
        return found
    if backend == "c":
        raise RuntimeError(f"backend: 'c' {found.reason}; {found.remedy}, or use 'numpy'")
    _say_once(found)
    return None


@cache
def _say_once(refused: native.Refused) -> None:
    print(
        f"hoopgen: the C engine {refused.reason}; {refused.remedy}. NumPy serves, slower.",
        file=sys.stderr,
    )
