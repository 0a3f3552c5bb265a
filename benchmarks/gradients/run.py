"""Errors and times of derivatives, by all who are installed; each number in one dictionary."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from importlib.metadata import PackageNotFoundError, version
from time import perf_counter, process_time
from typing import Any

import numpy as np

import hoopgen
from benchmarks.gradients.ball import (
    BALL,
    SPRING_BALL,
    SPRING_TIMES,
    TIMES,
    floor,
    hoopgen_slopes,
    task_1,
    task_2,
)
from benchmarks.gradients.free_throws import (
    CONTACTS,
    Throw,
    by_differences,
    by_diffrax,
    by_hoopgen,
    error,
    throws,
)
from benchmarks.gradients.peers import EVERYBODY, Peer, mujoco_extremes, slope, taking_part

MANY = 10_000
"""Shots of a batch of hoopgen, whose time is divided by their number."""

PACKAGES = ("heyoka", "diffrax", "jax", "warp-lang", "mujoco", "mujoco-mjx")
"""Distributions whose versions the page gives."""


def _there(name: str) -> bool:
    try:
        return bool(version(name))
    except PackageNotFoundError:
        return False


def _cost(call: Callable[[], object]) -> float:
    """CPU time of one call (s), all threads of the process; repeated until it takes 20 ms."""
    repeats, start = 0, process_time()
    while repeats == 0 or process_time() - start < 0.02:
        call()
        repeats += 1
    return (process_time() - start) / repeats


def costs(
    calls: Mapping[str, Callable[[], object]],
    rounds: int,
    cost: Callable[[Callable[[], object]], float] = _cost,
) -> dict[str, float]:
    """Return the least cost of each call, over rounds in which everybody has a turn.

    Parameters
    ----------
    calls
        The calls by name.
    rounds
        Number of rounds.
    cost
        The cost of one call; by default its CPU time, s.
    """
    least = dict.fromkeys(calls, float("inf"))
    for _ in range(rounds):
        for key, call in calls.items():
            least[key] = min(least[key], cost(call))
    return least


def ball_results(peers: Sequence[Peer], rounds: int) -> dict[str, Any]:
    """Return derivatives of the bouncing ball by each, and times of the last one."""
    right = [BALL.truth(time)[1] for time in TIMES]
    slopes: dict[str, list[float]] = {"hoopgen": hoopgen_slopes()}
    time = TIMES[-1]
    state = np.zeros((MANY, 9))
    state[:, 2], state[:, 4] = BALL.radius + BALL.height, -1.0
    fly = partial(
        hoopgen.simulate,
        scene=floor(time, BALL),
        derivatives=["z"],
        threads=1,
    )
    calls: dict[str, Callable[[], object]] = {
        "hoopgen": partial(fly, state),
        "hoopgen_one": partial(fly, state[0]),
    }
    preparing: dict[str, float] = {}
    for peer in peers:
        print(peer.label, flush=True)
        start, own = perf_counter(), []
        for when in TIMES:
            call = peer.prepare(BALL, when)
            own.append(call())
        preparing[peer.key] = perf_counter() - start
        slopes[peer.key], calls[peer.key] = own, call
    taken = costs(calls, rounds)
    taken["hoopgen"] /= MANY
    return {"times": TIMES, "truth": right, "slopes": slopes, "cost": taken, "before": preparing}


def spring_results(peers: Sequence[Peer]) -> dict[str, Any]:
    """Return derivatives of the ball of MuJoCo's issue by each, and where MuJoCo's ball comes."""
    slopes = {"hoopgen": hoopgen_slopes(SPRING_BALL, SPRING_TIMES)}
    for peer in peers:
        slopes[peer.key] = [slope(peer, time, SPRING_BALL) for time in SPRING_TIMES]
    soft = any(peer.package == "mujoco" for peer in peers)
    return {
        "times": SPRING_TIMES,
        "truth": [SPRING_BALL.truth(time)[1] for time in SPRING_TIMES],
        "slopes": slopes,
        "extremes": mujoco_extremes(SPRING_BALL, SPRING_TIMES[-1]) if soft else None,
    }


def throw_results(rounds: int, each: int, diffrax: bool) -> dict[str, Any]:
    """Return errors of derivatives of free throws, the largest by number of contacts, and times."""
    methods: dict[str, Callable[[Throw], Any]] = {
        "hoopgen": by_hoopgen,
        "differences": by_differences,
    }
    if diffrax:
        methods["diffrax"] = by_diffrax
    errors: dict[str, list[float]] = {key: [] for key in methods}
    taken: dict[str, list[float]] = {key: [] for key in ("hoopgen", "hoopgen_one", *methods)}
    for contacts in CONTACTS:
        print(f"free throws of {contacts} contacts", flush=True)
        own = [throw for throw in throws(each) if throw.contacts == contacts]
        for key, method in methods.items():
            errors[key].append(max(error(method(throw), throw.truth) for throw in own))
        many = np.repeat(own[0].state[None], MANY, axis=0)
        fly = partial(hoopgen.simulate, derivatives=("vx", "vz"), threads=1)
        calls: dict[str, Callable[[], object]] = {
            "hoopgen": partial(fly, many),
            "hoopgen_one": partial(fly, own[0].state),
        }
        if diffrax:
            calls["diffrax"] = partial(by_diffrax, own[0])
        for key, cost in costs(calls, rounds).items():
            taken[key].append(cost / (MANY if key == "hoopgen" else 1))
    del taken["differences"]
    return {"contacts": CONTACTS, "each": each, "errors": errors, "cost": taken}


def run(quick: bool, peers: Sequence[Peer] = EVERYBODY) -> dict[str, Any]:
    """Measure everything."""
    there, absent = taking_part(peers)
    for line in absent:
        print(line)
    diffrax = any(peer.package == "diffrax" for peer in there)
    rounds = 3 if quick else 9
    tasks = {"task_1": task_1(), "task_2": task_2()}
    return {
        "ball": ball_results(there, rounds),
        "spring": spring_results(there),
        "throws": throw_results(rounds, 1 if quick else 3, diffrax),
        "tasks": {key: [part.tolist() for part in both] for key, both in tasks.items()},
        "absent": list(absent),
        "load": os.getloadavg()[0] if hasattr(os, "getloadavg") else float("nan"),
        "versions": {name: version(name) for name in PACKAGES if _there(name)},
    }
