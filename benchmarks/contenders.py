"""Who takes part: hoopgen as its users call it, and its peers."""

import os
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import hoopgen
from benchmarks.peers import PEERS
from benchmarks.workloads import PAPER, States

CORES = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
RESULTS = ("outcome", "contacts", "time")
"""What every contender returns, and bytes a shot: 1 + 4 + 8."""


@dataclass(frozen=True)
class Contender:
    """Somebody who flies states, shape (n, 9). `whole` ones fly a workload at its full size, the
    others as many shots as take a fraction of a second."""

    key: str
    label: str
    family: str
    fly: Callable[[States], object]
    whole: bool = False


def _ours(key: str, label: str, whole: bool = True, **arguments: object) -> Contender:
    fly = partial(hoopgen.simulate, parameters=PAPER, **arguments)
    return Contender(key, label, "hoopgen", fly, whole)


def contenders() -> tuple[Contender, ...]:
    """hoopgen first: C with all cores and with one, three results and all of them; then NumPy; then
    the peers."""
    many = f"{CORES} threads"
    ours = (
        _ours("c_many", f"hoopgen C, {many}", backend="c", threads=CORES, fields=RESULTS),
        _ours("c_one", "hoopgen C, 1 thread", backend="c", threads=1, fields=RESULTS),
        _ours("c_many_all", f"hoopgen C, {many}, all fields", backend="c", threads=CORES),
        _ours("c_one_all", "hoopgen C, 1 thread, all fields", backend="c", threads=1),
        _ours("numpy", "hoopgen NumPy", whole=False, backend="numpy", fields=RESULTS),
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
