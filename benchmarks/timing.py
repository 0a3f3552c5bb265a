"""Timing: rounds in which everybody takes a turn, and what a single call costs."""

import os
import statistics
import subprocess
import sys
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import partial
from time import perf_counter

import numpy as np

from benchmarks.contenders import Contender
from benchmarks.workloads import States, Workload

TURN = 0.1
"""Seconds that a turn takes at the least, about."""


@dataclass(frozen=True)
class Spread:
    """Median and quartiles."""

    median: float
    lower: float
    upper: float

    @classmethod
    def of(cls, values: Iterable[float]) -> "Spread":
        """Return the spread of some values."""
        lower, median, upper = np.quantile(list(values), [0.25, 0.5, 0.75]).tolist()
        return cls(median, lower, upper)


@dataclass(frozen=True)
class Rates:
    """Shots a second of one contender, round by round, and how many shots it flew in each."""

    shots: int
    rates: tuple[float, ...]

    @property
    def spread(self) -> Spread:
        """The quartiles of the rounds."""
        return Spread.of(self.rates)

    def over(self, other: "Rates") -> Spread:
        """Return the ratio of speeds to another, compared round by round."""
        return Spread.of(a / b for a, b in zip(self.rates, other.rates, strict=True))


def seconds(call: Callable[[], object], repeats: int = 1) -> float:
    """Wall-clock time of a call, the mean of some in a row."""
    start = perf_counter()
    for _ in range(repeats):
        call()
    return (perf_counter() - start) / repeats


def affordable(fly: Callable[[States], object], states: States, budget: float) -> int:
    """Return the number of shots, a power of two from 8, that fly within about `budget` seconds."""
    shots = 8
    while True:
        # The first call in a process may compile or load: not counted.
        taken = min(seconds(partial(fly, states[:shots])) for _ in range(2))
        if taken > budget / 4 or shots >= len(states):
            break
        shots *= 4
    fitting = int(shots * budget / taken)
    return max(8, min(len(states), 1 << (fitting.bit_length() - 1)))


def rounds(
    field: Sequence[Contender], workload: Workload, size: int, count: int, budget: float
) -> dict[str, Rates]:
    """`count` rounds of a workload of `size` shots, by the contenders' keys. Everybody has a turn
    in a round, each round starting with another; who flies a part takes the next part each round. A
    short flight is repeated within its turn: what ran before has left caches and memory cold."""
    states = workload.make(size)
    shots = {
        one.key: min(one.at_most, size) if one.at_most else affordable(one.fly, states, budget)
        for one in field
    }
    repeats = {}
    for one in field:
        fly = partial(one.fly, states[: shots[one.key]])
        fly()
        repeats[one.key] = max(1, round(TURN / seconds(fly)))
    rates: dict[str, list[float]] = {one.key: [] for one in field}
    for turn in range(count):
        first = turn % len(field)
        for one in (*field[first:], *field[:first]):
            n = shots[one.key]
            start = turn * n % (size - n + 1)
            part = states[start : start + n]
            rates[one.key].append(n / seconds(partial(one.fly, part), repeats[one.key]))
    return {key: Rates(shots[key], tuple(values)) for key, values in rates.items()}


def per_shot(
    fly: Callable[[States], object], states: States, sizes: Sequence[int], count: int
) -> dict[int, Spread]:
    """Seconds a shot at each size. Small sizes repeat within a measurement until 10^6 shots."""
    costs: dict[int, list[float]] = {size: [] for size in sizes}
    for size in sizes:
        fly(states[:size])
    for _ in range(count):
        for size in sizes:
            taken = seconds(partial(fly, states[:size]), max(1, 10**6 // size))
            costs[size].append(taken / size)
    return {size: Spread.of(values) for size, values in costs.items()}


def runs(fly: Callable[[States], object], state: States, count: int) -> tuple[float, float]:
    """Mean and standard deviation of `count` runs of one shot, each timed by itself (s)."""
    fly(state)
    times = [seconds(partial(fly, state)) for _ in range(count)]
    return statistics.fmean(times), statistics.pstdev(times)


_FIRST_CALL = """
from time import perf_counter
start = perf_counter()
import numpy
numpy_there = perf_counter()
import hoopgen
hoopgen_there = perf_counter()
hoopgen.simulate(numpy.array([4.191, 0, -0.6096, -4.4, 0, 5.31, 0, 18.85, 0]))
print(numpy_there - start, hoopgen_there - numpy_there, perf_counter() - hoopgen_there)
"""


def first_call(count: int) -> dict[str, Spread]:
    """Return the time of a new process, part by part and together, over `count` processes (s).

    Python keeps compiled modules, as it does after an installation.
    """
    parts: dict[str, list[float]] = {}
    kept = {k: v for k, v in os.environ.items() if k != "PYTHONDONTWRITEBYTECODE"}
    for _ in range(count):
        command = [sys.executable, "-c", _FIRST_CALL]
        done = subprocess.run(command, check=True, capture_output=True, text=True, env=kept)
        output = done.stdout
        importing_numpy, importing, flying = map(float, output.split())
        together = importing_numpy + importing + flying
        for name, value in (
            ("import numpy", importing_numpy),
            ("import hoopgen", importing),
            ("first shot", flying),
            ("together", together),
        ):
            parts.setdefault(name, []).append(value)
    return {name: Spread.of(values) for name, values in parts.items()}
