"""The machine: what it is, how fast it moves memory and multiplies."""

import ctypes
import os
import platform
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import partial
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

import numpy as np

from benchmarks.contenders import CORES
from benchmarks.peers.native import FLAGS, OUR_FLAGS, compiler_version, library
from benchmarks.timing import seconds

PACKAGES = ("hoopgen", "numpy", "scipy", "heyoka")

BYTES_A_SHOT = 9 * 8 + 1 + 4 + 8
"""The state read; outcome, contacts and time written."""


def processor() -> str:
    """Return the processor's name, as far as the system tells."""
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
    except OSError:
        return platform.processor() or platform.machine()
    names = (line.partition(":")[2].strip() for line in lines if line.startswith("model name"))
    return next(names, platform.machine())


def _version(package: str) -> str:
    try:
        return version(package)
    except PackageNotFoundError:
        return "not installed"


def _load() -> str:
    """Processes that ran in the last minute: above zero the machine was not ours alone."""
    try:
        return f"{os.getloadavg()[0]:.2f}"
    except (AttributeError, OSError):
        return "unknown"


def facts() -> dict[str, str]:
    """Everything a reader needs to set the numbers in proportion."""
    return {
        "processor": processor(),
        "cores used": f"{CORES}, {_load()} busy before",
        "system": f"{platform.system()} {platform.machine()}",
        "python": platform.python_version(),
        **{package: _version(package) for package in PACKAGES},
        "compiler of the peers": compiler_version(),
        "flags of the peers": " ".join(FLAGS),
        "flags of hoopgen": " ".join(OUR_FLAGS),
    }


@dataclass(frozen=True)
class Limits:
    """Bytes/s and double operations/s by threads: the latter apart, as fused multiply-adds, and of
    divisions and square roots alone."""

    bandwidth: dict[int, float]
    operations: dict[int, float]
    fused: dict[int, float]
    divisions: dict[int, float]
    roots: dict[int, float]


def _together(work: Callable[[int], object], threads: int) -> float:
    """Seconds until `work`, called once a thread with its number, is done in all; a call into C
    lets the others run."""
    with ThreadPoolExecutor(threads) as pool:
        list(pool.map(lambda _: None, range(threads)))
        return seconds(lambda: list(pool.map(work, range(threads))))


def _bandwidth(threads: int, doubles: int = 1 << 24) -> float:
    """STREAM's triad, a = b + 0.7 c, three arrays far larger than the caches; 24 bytes an
    element, as STREAM counts."""
    arrays = np.ones((3, doubles))
    share = doubles // threads
    triad = library("roofline").triad

    def work(thread: int) -> None:
        parts = arrays[:, thread * share : (thread + 1) * share]
        triad(*(ctypes.c_void_p(part.ctypes.data) for part in parts), ctypes.c_int64(share))

    return 24 * share * threads / _together(work, threads)


def _operations(threads: int, what: str, turns: int, fused: bool = False) -> float:
    flags = (*FLAGS, "-ffp-contract=fast" if fused else "-ffp-contract=off")
    kernel = getattr(library("roofline", flags), what)
    kernel.restype = ctypes.c_double
    done: list[float] = []

    def work(_: int) -> None:
        result = ctypes.c_double()
        done.append(kernel(ctypes.c_int64(turns), ctypes.byref(result)))

    taken = _together(work, threads)
    return sum(done) / taken


def limits(count: int) -> Limits:
    """Return the best of `count` measurements, as STREAM does: others only slow it."""
    threads = sorted({1, CORES})

    def best(measure: Callable[[int], float]) -> dict[int, float]:
        return {n: max(measure(n) for _ in range(count)) for n in threads}

    return Limits(
        best(_bandwidth),
        best(partial(_operations, what="multiply_add", turns=1 << 25)),
        best(partial(_operations, what="multiply_add", turns=1 << 25, fused=True)),
        best(partial(_operations, what="divide", turns=1 << 21)),
        best(partial(_operations, what="root", turns=1 << 21)),
    )
