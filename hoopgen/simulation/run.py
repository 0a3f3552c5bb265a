"""`run`: check the input, share the shots among threads, and gather the results."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import Executor
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import partial, wraps
from typing import Any, Concatenate, Literal, ParamSpec, TypedDict

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hoopgen.core.argument_types import check_flag
from hoopgen.core.backend_names import BackendName
from hoopgen.core.memory import check_room
from hoopgen.core.parameters import ParameterValues, Value, resolve
from hoopgen.core.validation import (
    check_contacts,
    check_leaving,
    check_states,
    check_threads,
)
from hoopgen.engine import native, numpy_backend, thread_pools
from hoopgen.engine.arithmetic import is_exact
from hoopgen.engine.compiled_scene import CompiledScene
from hoopgen.engine.cuda import CudaEngine, is_device_array, to_host
from hoopgen.engine.result_arrays import ResultArrays, need_bounds
from hoopgen.results.proof import ProofPremises
from hoopgen.results.shots import Shots

from .backend_choice import Library, device_states, find_library, host_parameters
from .checks import check_backend, check_fields, check_limit
from .shot_variations import Variations
from .start_checks import without_false_starts
from .variations import NEEDED, check_derivatives
from .variations import derivatives as find_derivatives

P = ParamSpec("P")

SHARE_DIVISOR = 4
"""Divisor of a thread's share: in C a thread takes one part of its share at a time. So the
threads end together, and lanes are idle only at the end of each thread's last shots."""

LOG_ROWS_AT_ONCE = 1 << 16
"""Rows of the event log that a thread allocates at a time."""

FIRST_LOG_CONTACTS = 40
"""Contacts of a shot that the log has rows for at first. Shots with more contacts are simulated
again with `LOG_GROWTH` times as many rows."""

LOG_GROWTH = 8

MIN_SHOTS_PER_THREAD = 1 << 12
"""Smallest number of shots that a thread takes at a time in NumPy, where each operation is a
call."""

MAX_CONTACTS_WITHOUT_THREADS = 1 << 17
"""Largest number of possible contacts that are simulated without threads: some hundredths of a
second in NumPy. In C each further multiple of it adds a thread."""

MAX_CONTACTS_WITHOUT_THREADS_IN_C = 1 << 20
"""The same for one thread in C, counted by `_is_brief`. Up to it, the calling thread is one of the
threads."""

MAX_ROLL_STEPS_PER_SECOND = 1 << 8
"""Upper bound of the steps in a second of rolling: a few times those of swirls in the ring. A step
costs about as much as a contact."""

BODIES_PER_CONTACT = 3
"""Number of bodies for which `MAX_CONTACTS_WITHOUT_THREADS_IN_C` assumes a contact's cost: each
body may have to be searched."""


@dataclass(slots=True)
class _Batch:
    scene: CompiledScene
    states: NDArray[np.float64]
    parameters: list[Value]
    leaving: NDArray[np.int8] | None
    max_contacts: int
    time_limit: float
    library: Library | None
    stop: NDArray[np.int32]

    def stopped(self) -> bool:
        """Return whether the run is to end early."""
        return bool(self.stop[0])

    def part(self, rows: slice | NDArray[np.intp]) -> _Batch:
        """Return some of the shots."""
        parameters = [p if isinstance(p, float) else p[rows] for p in self.parameters]
        leaving = None if self.leaving is None else self.leaving[rows]
        return replace(self, states=self.states[rows], parameters=parameters, leaving=leaving)

    def run(
        self,
        out: ResultArrays,
        most: int,
        share: native.Share | None = None,
        first: int = 0,
        last: numpy_backend.SharedTail | None = None,
    ) -> None:
        """Simulate the shots into `out`, with at most so many contacts.

        In C these are the shots of a share; in NumPy they may be the rows of `out` from `first` on.
        """
        given = (self.states, self.parameters, self.leaving, most, out)
        if isinstance(self.library, CudaEngine):
            self.library.run(*given, self.stop, time_limit=self.time_limit)
        elif self.library is not None:
            self.library.run(*given, self.stop, time_limit=self.time_limit, share=share)
        else:
            rest = (self.stopped, self.time_limit, first, last)
            with self.scene.exact_arithmetic():  # in C a call sets it itself
                numpy_backend.run(self.scene.kernels, *given, *rest)

    def record(self, out: ResultArrays, most: int, errors: Sequence[str]) -> NDArray[Any]:
        """Simulate the shots into `out` and return their event log, in order.

        The log has rows for `most` contacts of each; shots with more are simulated again. `errors`
        are the names of the bounds on errors that it has.
        """
        layout, shots = self.scene.layout, len(self.states)
        log = layout.allocate_events(shots, most, errors=bool(errors))
        ended = layout.allocate(shots, {"outcome", "contacts"} - out.arrays.keys())
        whole = out.joined(ended).joined(log)
        self.run(whole, most)
        assert whole.outcome is not None
        assert whole.contacts is not None
        again = np.zeros(shots, np.bool_)
        if most < self.max_contacts and not self.stopped():
            # A shot with fewer contacts ended for another reason, and would do so again.
            again = (whole.outcome == self.scene.outcomes["CAPPED"]) & (whole.contacts >= most)
        used = np.arange(layout.log_rows(most)) < log.arrays["event_counts"][:, None]
        logs = [layout.logged(log, used & ~again[:, None], errors)]
        more = min(LOG_GROWTH * most, self.max_contacts)
        rows, size = np.flatnonzero(again), max(1, LOG_ROWS_AT_ONCE // (more + 1))
        for some in (rows[k : k + size] for k in range(0, len(rows), size)):
            longer = layout.allocate(len(some), out.arrays)
            logs.append(self.part(some).record(longer, more, errors))
            logs[-1]["shot"] = some[logs[-1]["shot"]]
            for name, array in longer.arrays.items():
                out.arrays[name][some] = array
        events = np.concatenate(logs)
        return events[np.argsort(events["shot"], kind="stable")] if len(logs) > 1 else events


class OtherOptions(TypedDict, total=False):
    """Keywords of `run` but for the derivatives."""

    max_contacts: int | None
    backend: BackendName
    threads: int | None
    fields: Literal["all"] | Iterable[str]
    record: bool
    leaving: ArrayLike | None
    settle: bool
    time_limit: float | None


class SimulationOptions(OtherOptions, total=False):
    """Keywords of `run`, which are those of `hoopgen.simulate` but for the scene."""

    derivatives: Iterable[str] | None


def _in_exact_arithmetic(
    run: Callable[Concatenate[CompiledScene, P], Shots],
) -> Callable[Concatenate[CompiledScene, P], Shots]:
    """Return the function with exact arithmetic in the calling thread, which checks the input."""

    @wraps(run)
    def exact(engine: CompiledScene, /, *given: P.args, **options: P.kwargs) -> Shots:
        if is_exact():  # at once, since a call takes microseconds
            return run(engine, *given, **options)
        with engine.exact_arithmetic():
            return run(engine, *given, **options)

    return exact


@_in_exact_arithmetic
def run(
    engine: CompiledScene,
    states: ArrayLike,
    parameters: ParameterValues | None = None,
    *,
    max_contacts: int | None = None,
    backend: BackendName = "auto",
    threads: int | None = None,
    fields: Literal["all"] | Iterable[str] = "all",
    record: bool = False,
    leaving: ArrayLike | None = None,
    settle: bool = False,
    time_limit: float | None = None,
    derivatives: Iterable[str] | None = None,
) -> Shots:
    """Simulate shots in a compiled scene; all else as for `hoopgen.simulate`."""
    check_flag("record", record)
    check_flag("settle", settle)
    backend = check_backend(backend)
    stays = backend == "cuda" and is_device_array(states)
    if stays:
        asked = {"record": record, "settle": settle, "derivatives": derivatives is not None}
        releases = device_states(states, engine, asked)
    else:
        releases = check_states(states)
    if backend == "cuda":
        parameters, leaving = host_parameters(parameters), to_host(leaving)
    shots = len(releases)
    named = resolve(parameters, shots, engine.table)
    most = engine.max_contacts if max_contacts is None else check_contacts(max_contacts)
    wanted = check_fields(fields, engine)
    workers = check_threads(threads)
    by = None if derivatives is None else check_derivatives(derivatives, engine)
    logged = record or by is not None
    errors = engine.layout.logged_errors(wanted) if record else ()
    if logged:
        check_log(shots, most, workers, scene=engine, errors=bool(errors))
    needed = (*(("uncertain",) if settle else ()), *(NEEDED if by is not None else ()))
    computed = tuple(dict.fromkeys((*wanted, *needed))) if needed else wanted
    inputs, left = engine.table.inputs(named), check_leaving(leaving, shots, engine.surfaces)
    limit = check_limit(time_limit, engine)
    bounds = need_bounds(engine.kernels, computed)
    library = find_library(backend, engine, shots, bounds=bounds)
    begun = without_false_starts(engine, releases, inputs, left, library)
    batch = _Batch(engine, begun, inputs, left, most, limit, library, np.zeros(1, np.int32))
    on_gpu = isinstance(library, CudaEngine)
    out = engine.layout.allocate(shots, computed, engine.cuda.empty if stays else None)
    results = dict(out.arrays)
    if on_gpu and not logged:
        batch.run(out, most)
    elif not logged and batch.library is not None:
        _share(batch, out, workers)
    else:
        logs = _run(batch, out, workers, errors if logged else None)
    if logged:
        none = np.empty(0, engine.layout.event_with(errors))
        results["events"] = np.concatenate([none, *logs])
    variations = None  # along the recorded events, which settling does not change
    if by is not None:
        found = find_derivatives(engine, by, named, releases, results, results["events"])
        variations = Variations(engine, named, releases, *found, ~results["uncertain"])
    settled = np.empty(0, np.int64)
    if settle:
        # Imported here, because the judge needs SymPy and python-flint.
        from hoopgen.judge.settle import settle as decide

        settled = decide(results, begun, named, most, scene=engine, leaving=left, time_limit=limit)
    kept = (*wanted, "events") if record else wanted
    if needed or logged != record:
        results = {name: array for name, array in results.items() if name in kept}
    premises = ProofPremises(left, settled)
    return Shots(results, releases, named, engine, premises, variations)


def check_log(
    shots: int,
    max_contacts: int,
    threads: int | None = None,
    *,
    scene: CompiledScene,
    errors: bool = False,
) -> None:
    """Refuse an event log that does not fit in memory; arguments as of `simulate`.

    Parameters
    ----------
    shots
        The number of shots.
    max_contacts
        The limit on the contacts of a shot.
    threads
        The number of threads; None: the processors of this process.
    scene
        The scene.
    errors
        Whether the log has bounds on errors.

    Raises
    ------
    ValueError
        If it would take too much memory.
    """
    # Each thread allocates rows for every possible contact of its shots.
    layout = scene.layout
    each = layout.log_rows(max_contacts)
    at_once = min(shots, check_threads(threads) * max(1, LOG_ROWS_AT_ONCE // each))
    row = layout.event.itemsize + errors * layout.error.itemsize + 16
    check_room("max_contacts", at_once * each, "events to be recorded at once", row)


def _share(batch: _Batch, out: ResultArrays, threads: int) -> None:
    """Run the batch in C; the threads share its shots."""
    contacts = len(batch.states) * batch.max_contacts
    # The calling thread starts at once, while another one has to wake up.
    here = _is_brief(batch) or not _interruptible()
    others = min(threads, contacts // MAX_CONTACTS_WITHOUT_THREADS + 1) - here
    if not others:
        batch.run(out, batch.max_contacts)
        return
    share = native.Share(SHARE_DIVISOR * (others + here))
    with _pool(batch, others) as pool:
        work = partial(batch.run, out, batch.max_contacts, share)
        asked = [pool.submit(work) for _ in range(others)]
        if here:
            work()
        for one in asked:
            one.result()


def _run(
    batch: _Batch, out: ResultArrays, threads: int, errors: Sequence[str] | None
) -> list[NDArray[Any]]:
    """Run the batch in chunks; return the chunks' event logs, in order.

    The logs have the bounds on errors of these names; None: there are no logs.
    """
    shots = len(batch.states)

    def work(start: int) -> NDArray[Any] | None:
        stop = min(start + size, shots)
        part = batch.part(slice(start, stop))
        if errors is None:
            part.run(out, batch.max_contacts, first=start, last=last)
            return None
        log = part.record(out.rows(start, stop), first, errors)
        log["shot"] += start
        return log

    in_c, on_gpu = batch.library is not None, isinstance(batch.library, CudaEngine)
    size = max(-(-shots // threads), 1 if in_c else MIN_SHOTS_PER_THREAD)
    first = min(FIRST_LOG_CONTACTS, batch.max_contacts)
    if errors is not None:
        size = max(1, min(size, LOG_ROWS_AT_ONCE // (first + 1)))
    starts = range(0, shots, size)
    last = numpy_backend.SharedTail(len(starts), shots)
    contacts = shots * batch.max_contacts
    if in_c:
        here = _is_brief(batch) and (threads == 1 or contacts <= MAX_CONTACTS_WITHOUT_THREADS)
    else:
        here = contacts <= MAX_CONTACTS_WITHOUT_THREADS
    if here or on_gpu or (threads == 1 and not _interruptible()):
        logs = [work(start) for start in starts]
    else:
        with _pool(batch, threads) as pool:
            logs = list(pool.map(work, starts))
    return [log for log in logs if log is not None]


def _is_brief(batch: _Batch) -> bool:
    """Return whether one thread in C takes at most some hundredths of a second.

    Few shots take as long as a full vector of lanes. A shot may have many contacts, many bodies,
    and many seconds of rolling.
    """
    lanes = len(batch.states) + native.WIDTHS[-1] - 1
    steps = batch.max_contacts + (
        MAX_ROLL_STEPS_PER_SECOND * batch.time_limit if batch.scene.rolls else 0
    )
    bodies = max(1, len(batch.scene.surfaces) / BODIES_PER_CONTACT)
    return lanes * steps * bodies <= MAX_CONTACTS_WITHOUT_THREADS_IN_C


def _interruptible() -> bool:
    """Return whether this thread receives Ctrl-C; Python does not handle it during a call of C."""
    return threading.current_thread() is threading.main_thread()


@contextmanager
def _pool(batch: _Batch, threads: int) -> Iterator[Executor]:
    """Yield a pool of threads for a batch; they stop if an error is raised."""
    pool = thread_pools.acquire_pool(threads)
    try:
        yield pool
    except BaseException:
        batch.stop[0] = 1
        pool.shutdown(wait=False, cancel_futures=True)
        raise
    thread_pools.return_pool(pool, threads)
