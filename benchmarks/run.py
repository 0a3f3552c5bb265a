"""The whole comparison: settings in, results out."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import numpy as np

import hoopgen
from benchmarks.contenders import CORES, RESULTS, contenders
from benchmarks.errors import Errors, errors
from benchmarks.machine import Limits, facts, limits
from benchmarks.operations import Counts, operations
from benchmarks.peers import LEFT_OUT, PEERS
from benchmarks.timing import Rates, Spread, first_call, per_shot, rounds, runs, seconds
from benchmarks.workloads import TABLE_3, WORKLOADS, States, free_throw, swish_shot
from hoopgen import COURT, PAPER, PAPER_COURT


@dataclass(frozen=True)
class Settings:
    """The extent of every part of the benchmarks."""

    rounds: int = 9
    budget: float = 0.3
    """Seconds a turn of those who fly a part of a workload."""
    share: int = 1
    """Workloads shrink by this factor."""
    sizes: tuple[int, ...] = (10**4, 10**5, 10**6, 10**7)
    processes: int = 11
    repeats: int = 5
    judged: int = 2000
    judging: float = 4.0
    """Seconds a peer and workload may take for its errors."""


QUICK = Settings(
    rounds=3,
    budget=0.1,
    share=8,
    sizes=(10**4, 10**5, 10**6),
    processes=3,
    repeats=3,
    judged=500,
    judging=1.0,
)


@dataclass(frozen=True)
class Runs:
    """One shot, timed run by run: mean and standard deviation of the article's hundred runs, and
    the mean of `count` (s)."""

    mean: float
    deviation: float
    count: int
    mean_of_many: float


@dataclass(frozen=True)
class Work:
    """The work of a shot of a workload: contacts, hoopgen's arithmetic where its sources are at
    hand; and the share of the shots that hoopgen calls uncertain."""

    contacts: float
    uncertain: float
    counts: Counts | None


@dataclass(frozen=True)
class Results:
    """Everything measured. Rates and errors by workload and contender."""

    facts: dict[str, str]
    rates: dict[str, dict[str, Rates]]
    work: dict[str, Work]
    """Work of a shot, by workload."""
    flatness: dict[int, dict[int, Spread]]
    """Seconds a shot, by threads and number of shots, W2."""
    single: dict[str, Spread]
    """Seconds a call for one shot in a warm process, by backend and shot."""
    settled: Spread
    """Seconds a shot of those that `HOOP` gives up, about the whole hoop, one thread."""
    first: dict[str, Spread]
    table_4: dict[str, dict[str, Runs]]
    """Runs of the article's table 4, by method and shot."""
    limits: Limits
    judge: str
    """Source of the right answers."""
    errors: dict[str, dict[str, Errors]]


def _flatness(settings: Settings) -> dict[int, dict[int, Spread]]:
    states = free_throw(max(settings.sizes))
    return {
        threads: per_shot(
            partial(hoopgen.simulate, backend="c", threads=threads, fields=RESULTS),
            states,
            settings.sizes,
            settings.repeats,
        )
        for threads in sorted({1, CORES})
    }


def _settled(settings: Settings) -> Spread:
    """Free throws that `HOOP` gives up: their bounces accumulate, and most of them roll."""
    throws = free_throw((1 << 20) // settings.share)
    capped = hoopgen.simulate(throws, PAPER).outcome == hoopgen.Outcome.CAPPED
    states = np.resize(throws[capped], ((1 << 17) // settings.share, throws.shape[1]))
    call = partial(
        hoopgen.simulate, states, PAPER_COURT, scene=COURT, backend="c", threads=1, fields=RESULTS
    )
    return Spread.of(seconds(call) / len(states) for _ in range(settings.repeats))


def _single(settings: Settings) -> dict[str, Spread]:
    """Interleaved: every backend and shot once a repeat, each the mean of a hundred calls."""
    shots = {"swish": swish_shot(), "bouncing": TABLE_3["7"]}
    calls = {
        f"{backend}, {name}": partial(hoopgen.simulate, state, backend=backend)
        for backend in ("c", "numpy")
        for name, state in shots.items()
    }
    for call in calls.values():
        call()
    costs: dict[str, list[float]] = {name: [] for name in calls}
    for _ in range(4 * settings.repeats):
        for name, call in calls.items():
            costs[name].append(seconds(call, 100))
    return {name: Spread.of(values) for name, values in costs.items()}


def _table_4(settings: Settings) -> dict[str, dict[str, Runs]]:
    methods: dict[str, Callable[[States], object]] = {
        "hoopgen C": partial(hoopgen.simulate, parameters=PAPER, backend="c"),
        "hoopgen NumPy": partial(hoopgen.simulate, parameters=PAPER, backend="numpy"),
        **{peer.label: partial(peer.fly, parameters=PAPER) for peer in PEERS},
    }

    def measure(method: str, shot: str) -> Runs:
        state = swish_shot() if shot == "swish" else TABLE_3["7"]
        mean, deviation = runs(methods[method], state, 100)
        many = min(100_000, max(100, int(10 * settings.budget / mean)))
        return Runs(mean, deviation, many, runs(methods[method], state, many)[0])

    return {
        method: {shot: measure(method, shot) for shot in ("swish", "bouncing")}
        for method in methods
    }


def run(settings: Settings) -> Results:
    """Measure everything, a line of progress for each part."""

    def say(what: str) -> None:
        print(what, flush=True)

    machine, field = facts(), contenders()
    for line in LEFT_OUT:
        say(line)
    rates: dict[str, dict[str, Rates]] = {}
    work: dict[str, Work] = {}
    for workload in WORKLOADS:
        say(f"{workload.key} {workload.label}")
        size = workload.size // settings.share
        rates[workload.key] = rounds(field, workload, size, settings.rounds, settings.budget)
        states = workload.make(size)
        shots = hoopgen.simulate(states, parameters=PAPER)
        work[workload.key] = Work(
            float(shots.contacts.mean()),
            float(shots.uncertain.mean()),
            operations(states[: settings.judged]),
        )
    say("errors")
    medians = {
        workload: {key: rate.spread.median for key, rate in of_all.items()}
        for workload, of_all in rates.items()
    }
    judge, wrong = errors(settings.judged, medians, settings.judging)
    say("number of shots, single shots, new processes")
    flatness, single = _flatness(settings), _single(settings)
    settled = _settled(settings)
    first = first_call(settings.processes)
    say("Table 4")
    table_4 = _table_4(settings)
    say("limits of the machine")
    return Results(
        machine,
        rates,
        work,
        flatness,
        single,
        settled,
        first,
        table_4,
        limits(settings.repeats),
        judge,
        wrong,
    )
