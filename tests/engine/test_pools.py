"""Threads stay from one batch to the next, and no longer than a process."""

from __future__ import annotations

import multiprocessing
import threading
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import numpy as np
import pytest

import hoopgen
from hoopgen.engine import native, thread_pools
from hoopgen.simulation import run as run_module
from hoopgen.simulation.hoop import HOOP


def ours() -> set[int | None]:
    return {thread.ident for thread in threading.enumerate() if thread.name.startswith("hoopgen")}


def outcome() -> list[int]:
    states = hoopgen.release(7.0, np.linspace(0.8, 1.0, 64), height=2.1, distance=4.2)
    return hoopgen.simulate(states, backend="numpy", threads=2).outcome.tolist()


@pytest.fixture(autouse=True)
def no_batch_is_small(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(run_module, "MAX_CONTACTS_WITHOUT_THREADS", 1)
    monkeypatch.setattr(run_module, "MIN_SHOTS_PER_THREAD", 16)


def test_the_next_batch_has_the_threads_of_the_last() -> None:
    wanted = outcome()
    assert ours()
    thread_pools.return_pool(last := thread_pools.acquire_pool(2), 2)
    assert outcome() == wanted
    # It took the same pool, and left it to the next one.
    assert thread_pools.acquire_pool(2) is last
    thread_pools.return_pool(last, 2)


@pytest.mark.parametrize("backend", ["c", pytest.param("numpy", marks=pytest.mark.slow)])
def test_where_no_thread_can_be_started_batches_and_studies_run_all_the_same(
    backend: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A browser's Python refuses threads so."""

    def refuse(self: threading.Thread) -> None:
        raise RuntimeError("can't start new thread")

    def answers() -> tuple[list[int], float, float]:
        states = hoopgen.release(7.0, np.linspace(0.8, 1.0, 64), height=2.1, distance=4.2)
        shots = hoopgen.simulate(states, backend=backend, threads=2)
        recorded = hoopgen.simulate(states, backend=backend, threads=2, record=True)
        means = {"speed": 7.1, "elevation": 0.9, "height": 2.1, "distance": 4.2}
        player = hoopgen.Scatter(means, {"speed": 0.1})
        sizes = {"shots": 200_000, "threads": 2, "backend": backend}
        made = hoopgen.estimate(player, **sizes).probability
        return [*shots.outcome.tolist(), len(recorded.events)], made, float(shots.time[0])

    wanted = answers()
    monkeypatch.setattr(thread_pools, "_IDLE", {})
    monkeypatch.setattr(threading.Thread, "start", refuse)
    assert isinstance(thread_pools.acquire_pool(2), thread_pools.SerialExecutor)
    assert answers() == wanted


def test_batches_beside_each_other_have_pools_of_their_own() -> None:
    one, other = thread_pools.acquire_pool(2), thread_pools.acquire_pool(2)
    assert one is not other
    thread_pools.return_pool(one, 2)
    assert thread_pools.acquire_pool(2) is one
    one.shutdown()
    other.shutdown()


@pytest.mark.skipif(
    "fork" not in multiprocessing.get_all_start_methods(), reason="processes do not fork here"
)
def test_a_child_process_starts_threads_of_its_own() -> None:
    wanted = outcome()
    with multiprocessing.get_context("fork").Pool(1) as children:
        assert children.apply_async(outcome).get(timeout=60) == wanted


def test_a_batch_that_fails_leaves_no_pool_behind(monkeypatch: pytest.MonkeyPatch) -> None:
    def broken(*_: object, **__: object) -> None:
        raise RuntimeError("broken")

    outcome()
    idle = thread_pools.acquire_pool(2)
    thread_pools.return_pool(idle, 2)
    monkeypatch.setattr(run_module.numpy_backend, "run", broken)
    with pytest.raises(RuntimeError, match="broken"):
        outcome()
    assert thread_pools.acquire_pool(2) is not idle


@pytest.fixture
def library() -> native.Library:
    if HOOP.library is None:
        pytest.skip("the C engine was not built")
    return HOOP.library


@pytest.fixture
def ran(library: native.Library, monkeypatch: pytest.MonkeyPatch) -> list[threading.Thread]:
    """Return the threads that the engine runs in, one a call."""
    found = []

    class Seen:
        def run(self, *arguments: Any, **options: Any) -> None:
            found.append(threading.current_thread())
            library.run(*arguments, **options)

    monkeypatch.setattr(HOOP, "found", Seen())
    return found


def test_threads_that_share_a_batch_run_each_shot_once(library: native.Library) -> None:
    shots = 5000  # the last that are taken fill no row of lanes
    states = hoopgen.release(7.0, np.linspace(0.7, 1.1, shots), height=2.1, distance=4.2)
    wanted = hoopgen.simulate(states, threads=1)
    out = HOOP.layout.allocate(shots, HOOP.layout.fields)
    share = native.Share(parts=8)
    given = (states, [*hoopgen.PAPER.values()], None, 40, out, np.zeros(1, np.int32))
    with ThreadPoolExecutor(3) as pool:
        for ran in [pool.submit(library.run, *given, share=share) for _ in range(3)]:
            ran.result()
    for name, array in out.arrays.items():
        np.testing.assert_array_equal(array, getattr(wanted, name), strict=True)
    assert share.next.value == shots
    for array in out.arrays.values():
        array.fill(1)
    library.run(*given, share=share)  # nothing is left
    assert all(np.all(array == 1) for array in out.arrays.values())


@pytest.mark.parametrize(
    ("at_once", "interruptible", "works"),
    [(1 << 20, True, True), (0, True, False), (0, False, True)],
)
def test_the_caller_works_too_where_ctrl_c_need_not_wait(
    at_once: int,
    interruptible: bool,
    works: bool,
    ran: list[threading.Thread],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    wanted = hoopgen.simulate([[0.0, 0.0, 1.0, *np.zeros(6)]] * 64, backend="numpy").time
    monkeypatch.setattr(run_module, "MAX_CONTACTS_WITHOUT_THREADS_IN_C", at_once)
    got: list[tuple[threading.Thread, bytes]] = []

    def call() -> None:
        shots = hoopgen.simulate([[0.0, 0.0, 1.0, *np.zeros(6)]] * 64, threads=2)
        got.append((threading.current_thread(), shots.time.tobytes()))

    if interruptible:
        call()
    else:  # Ctrl-C is for the main thread alone
        other = threading.Thread(target=call)
        other.start()
        other.join()
    ((caller, time),) = got
    assert time == wanted.tobytes()
    assert len(ran) == 2
    assert ran.count(caller) == works


@pytest.mark.parametrize(
    ("shots", "max_contacts", "works"), [(1, 40, True), (1, 1 << 19, False), (20_000, 40, True)]
)
def test_the_caller_does_not_work_where_one_shot_may_take_long(
    shots: int,
    max_contacts: int,
    works: bool,
    ran: list[threading.Thread],
) -> None:
    states = [[0.0, 0.0, 1.0, *np.zeros(6)]] * shots
    hoopgen.simulate(states, max_contacts=max_contacts, threads=1)
    assert ran == [threading.current_thread()] if works else threading.current_thread() not in ran
