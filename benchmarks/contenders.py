"""The contenders: hoopgen as its users call it, and its peers."""

import os
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Any

import hoopgen
from benchmarks.peers import PEERS
from benchmarks.workloads import States
from hoopgen import COURT, PAPER, PAPER_COURT

CORES = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
RESULTS = ("outcome", "contacts", "time")
"""Fields that every contender returns; a shot takes 1 + 4 + 8 bytes."""


@dataclass(frozen=True)
class Contender:
    """Somebody who flies states, shape (n, 9). Who works on many shots at once flies a workload a
    turn, but no more than `at_most`; the others as many shots as take a fraction of a second."""

    key: str
    label: str
    family: str
    fly: Callable[[States], object]
    at_most: int | None = None


def _ours(key: str, label: str, at_most: int, **arguments: Any) -> Contender:
    fly = partial(hoopgen.simulate, parameters=PAPER, **arguments)
    return Contender(key, label, "hoopgen", fly, at_most)


def contenders() -> tuple[Contender, ...]:
    """hoopgen first: C with all cores and with one, three results and all of them; then NumPy; then
    the peers."""
    many = f"{CORES} threads"
    most, block = 1 << 20, 1 << 16
    three: dict[str, Any] = {"backend": "c", "fields": RESULTS}
    ours = (
        _ours("c_many", f"hoopgen C, {many}", most, threads=CORES, **three),
        _ours("c_one", "hoopgen C, 1 thread", most, threads=1, **three),
        _ours("c_many_all", f"hoopgen C, {many}, all fields", most, backend="c", threads=CORES),
        _ours("c_one_all", "hoopgen C, 1 thread, all fields", most, backend="c", threads=1),
        _ours("numpy", "hoopgen NumPy", block, backend="numpy", fields=RESULTS),
        # The same shots about the whole hoop, to their ends: bounces that accumulate, and rolls.
        Contender(
            "court",
            "hoopgen C, 1 thread, the scene `COURT`",
            "hoopgen",
            partial(
                hoopgen.simulate,
                parameters=PAPER_COURT,
                scene=COURT,
                threads=1,
                **three,
            ),
            most,
        ),
    )
    peers = tuple(
        Contender(
            peer.key,
            peer.label,
            "peer in C" if peer.label.endswith(", C") else "peer in Python",
            partial(peer.fly, parameters=PAPER),
        )
        for peer in PEERS
    )
    return ours + peers
