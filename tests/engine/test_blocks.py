"""Memory of results is used again, and by one array at a time."""

import gc
import os
import sys
import threading
from collections.abc import Callable, Iterator
from types import FrameType
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import hoopgen
from benchmarks import workloads
from hoopgen.engine import array_pool
from tests.helpers.effort import trials

pytestmark = pytest.mark.xdist_group("blocks")  # garbage is looked for once among what stays

LARGE = (array_pool.MIN_BLOCK_SIZE // 8, 3)
DOUBLE = np.dtype(np.float64)


@pytest.fixture(autouse=True)
def nothing_kept() -> Iterator[None]:
    gc.collect()
    gc.freeze()  # what is left stays: the next test need not look through it
    array_pool._FREE.clear()
    yield
    array_pool._FREE.clear()


def place(array: NDArray[np.float64]) -> int:
    return int(array.__array_interface__["data"][0])


def kept() -> int:
    return sum(size * len(free) for size, free in array_pool._FREE.items())


@pytest.mark.slow
def test_memory_of_an_array_that_is_gone_is_used_again() -> None:
    first = array_pool.empty(LARGE, DOUBLE)
    where = place(first)
    del first
    assert kept() >= 8 * np.prod(LARGE)
    assert place(array_pool.empty(LARGE, DOUBLE)) == where


@pytest.mark.slow
def test_blocks_begin_with_a_line_of_the_caches() -> None:
    arrays = [array_pool.empty((LARGE[0] + more, 3), DOUBLE) for more in (0, 5, 7000)]
    assert [place(array) % array_pool.LINE for array in arrays] == [0, 0, 0]


@pytest.mark.parametrize("make", [workloads.swish, workloads.free_throw])
def test_states_written_in_whole_lines_are_those_of_numpy(
    make: Callable[[int], workloads.States],
) -> None:
    """Rows past a block's end, and batches without a block, are written in another way."""
    states = make(array_pool.MIN_BLOCK_SIZE // 72 + 37)
    states[:, 6:] += np.random.default_rng(11).normal(0.0, 1.0, (len(states), 3))
    expected = hoopgen.simulate(states, backend="numpy", fields=("state",)).state
    at_once = hoopgen.simulate(states, backend="c", fields=("state",)).state
    assert place(at_once) % array_pool.LINE == 0
    parts = [
        hoopgen.simulate(part, backend="c", fields=("state",)).state
        for part in np.array_split(states, 7)
    ]
    assert (at_once == expected).all()
    assert (np.concatenate(parts) == expected).all()


def test_memory_that_is_still_looked_at_is_not() -> None:
    first = array_pool.empty(LARGE, DOUBLE)
    first[...] = 1.0
    part, bytes_of_it = first[5:9, 1], memoryview(first)
    del first
    second = array_pool.empty(LARGE, DOUBLE)
    second[...] = 2.0
    assert (part == 1.0).all()
    del part
    assert kept() == 0
    bytes_of_it.release()
    del bytes_of_it
    assert kept() > 0


def test_results_are_plain_arrays_that_may_be_written() -> None:
    array = array_pool.empty(LARGE, DOUBLE)
    assert type(array) is np.ndarray
    assert array.shape == LARGE
    assert array.dtype == DOUBLE
    assert array.flags.c_contiguous
    assert array.flags.writeable
    assert array.flags.aligned


def test_small_arrays_keep_nothing() -> None:
    array = array_pool.empty((7,), DOUBLE)
    assert array.shape == (7,)
    del array
    assert kept() == 0


def test_no_more_is_kept_than_a_limit(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(array_pool, "MAX_IDLE_BYTES", 4 * array_pool.MIN_BLOCK_SIZE)
    arrays = [
        array_pool.empty((k * array_pool.MIN_BLOCK_SIZE // 8,), DOUBLE) for k in (1, 1, 2, 3, 5)
    ]
    while arrays:
        arrays.pop(0)
        assert kept() <= array_pool.MAX_IDLE_BYTES
    assert kept() > 0


def test_one_batch_does_not_change_the_results_of_another() -> None:
    shots = array_pool.MIN_BLOCK_SIZE  # so that the outcomes, of a byte each, have a block, too
    states = np.repeat(hoopgen.release(7.2, 0.9, height=2.1, distance=4.2)[None], shots, axis=0)
    first = hoopgen.simulate(states)
    outcome, before = first.outcome, first.state.copy()
    del first
    other = hoopgen.simulate(states + 1e-3)
    assert not np.array_equal(other.state, before)
    again = hoopgen.simulate(states)
    assert np.array_equal(again.state, before)
    assert np.array_equal(again.outcome, outcome)


def test_threads_take_and_leave_at_the_same_time() -> None:
    failed: list[object] = []
    previous, threading.excepthook = threading.excepthook, failed.append

    def work(seed: int) -> None:
        rng = np.random.default_rng(seed)
        for _ in range(trials(300)):
            array = array_pool.empty(
                (int(rng.integers(1, 12)) * array_pool.MIN_BLOCK_SIZE // 8,), DOUBLE
            )
            array[:4] = seed
            array[-4:] = seed
            assert (array[:4] == seed).all()
            assert (array[-4:] == seed).all()

    unraised: list[object] = []
    before, sys.unraisablehook = sys.unraisablehook, unraised.append
    interval = sys.getswitchinterval()
    sys.setswitchinterval(1e-6)
    try:
        threads = [threading.Thread(target=work, args=(k,)) for k in range(6)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
    finally:
        sys.setswitchinterval(interval)
        threading.excepthook, sys.unraisablehook = previous, before
    assert failed == []
    assert unraised == []
    assert kept() <= array_pool.MAX_IDLE_BYTES


def test_a_collection_of_garbage_may_leave_blocks_at_any_line_of_the_bookkeeping() -> None:
    """At each line another array goes, as if a collection took it there, of a size not yet kept."""
    sizes = iter(range(2, 400))
    waiting = [
        array_pool.empty((next(sizes) * array_pool.MIN_BLOCK_SIZE // 64,), DOUBLE)
        for _ in range(300)
    ]
    unraised: list[object] = []
    before, sys.unraisablehook = sys.unraisablehook, unraised.append
    lines = 0

    def collect(frame: FrameType, event: str, argument: object) -> Any:
        nonlocal lines
        if frame.f_code.co_filename != array_pool.__file__:
            return None
        if event == "line" and waiting:
            lines += 1
            waiting.pop()
        return collect

    traced = sys.gettrace()
    sys.settrace(collect)
    try:
        for _ in range(20):
            first, second = (array_pool.empty(LARGE, DOUBLE) for _ in range(2))
            first[:] = 1.0
            second[:] = 2.0
            assert (first == 1.0).all()
            del first, second
    finally:
        sys.settrace(traced)
        sys.unraisablehook = before
    assert unraised == []
    assert lines > 100
    assert not array_pool._RETURNED  # what came meanwhile was sorted, too
    assert not array_pool._LOCK.locked()
    assert 0 < kept() <= array_pool.MAX_IDLE_BYTES
    assert len({id(block) for free in array_pool._FREE.values() for block in free}) == sum(
        map(len, array_pool._FREE.values())
    )


def test_a_thread_that_is_at_the_blocks_holds_nobody_up() -> None:
    array = array_pool.empty(LARGE, DOUBLE)
    with array_pool._LOCK:
        del array
        assert array_pool.empty(LARGE, DOUBLE).shape == LARGE
    assert kept() == 0
    array = array_pool.empty(LARGE, DOUBLE)
    del array
    assert len(array_pool._RETURNED) == 0
    assert kept() > 0


@pytest.mark.skipif(not hasattr(os, "fork"), reason="there is no fork here")
def test_a_child_process_begins_with_none() -> None:
    array_pool.empty(LARGE, DOUBLE)
    assert kept() > 0
    with array_pool._LOCK:
        child = os.fork()
        if not child:
            array_pool.empty(LARGE, DOUBLE)
            os._exit(
                0
                if kept()
                == 8
                * LARGE[0]
                * LARGE[1]
                // array_pool.BLOCK_SIZE_STEP
                * array_pool.BLOCK_SIZE_STEP
                else 1
            )
    assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 0
