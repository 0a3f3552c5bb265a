"""Threads stay from one batch to the next, and no longer than a process."""

from __future__ import annotations

import multiprocessing
import threading

import numpy as np
import pytest

import hoopgen
from hoopgen import simulation
from hoopgen.engine import pools


def ours() -> set[int | None]:
    return {thread.ident for thread in threading.enumerate() if thread.name.startswith("hoopgen")}


def outcome() -> list[int]:
    states = hoopgen.release(7.0, np.linspace(0.8, 1.0, 64), height=2.1, distance=4.2)
    return hoopgen.simulate(states, backend="numpy", threads=2).outcome.tolist()


@pytest.fixture(autouse=True)
def no_batch_is_small(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(simulation, "AT_ONCE", 0)
    monkeypatch.setattr(simulation, "LEAST", 16)


def test_the_next_batch_has_the_threads_of_the_last() -> None:
    wanted = outcome()
    first = ours()
    assert first
    assert outcome() == wanted
    assert ours() == first


def test_batches_beside_each_other_have_pools_of_their_own() -> None:
    one, other = pools.take(2), pools.take(2)
    assert one is not other
    pools.leave(one, 2)
    assert pools.take(2) is one
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
    def broken(*_: object) -> None:
        raise RuntimeError("broken")

    outcome()
    idle = pools.take(2)
    pools.leave(idle, 2)
    monkeypatch.setattr(simulation._Batch, "run", broken)
    with pytest.raises(RuntimeError, match="broken"):
        outcome()
    assert pools.take(2) is not idle
