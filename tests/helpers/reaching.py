"""Shots that reach, between them, every line of the generated engines."""

from __future__ import annotations

import inspect
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from types import ModuleType
from typing import Any

import numpy as np
from numpy.typing import NDArray

import hoopgen
from benchmarks.families import FAMILIES
from hoopgen import COURT, HOOP, NBA_COURT, PAPER, PAPER_COURT
from tests.helpers.court_shots import all_kinds

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Run:
    """A batch, and what it is simulated with."""

    states: Floats
    parameters: Mapping[str, Any]
    max_contacts: int = 40
    time_limit: float | None = None
    leaving: NDArray[Any] | None = None

    def take(self, rows: slice) -> Run:
        """Return some of the shots, with their own parameters."""
        own = {n: v[rows] if np.ndim(v) else v for n, v in self.parameters.items()}
        leaving = None if self.leaving is None else self.leaving[rows]
        return Run(self.states[rows], own, self.max_contacts, self.time_limit, leaving)


def each(name: str, value: float) -> dict[str, float]:
    """Return a parameter that every body of the court has, by name."""
    return {f"{body}_{name}": value for body in COURT.surfaces}


def free_throws(count: int, seed: int = 5) -> Floats:
    """Return free throws that scatter about the best one."""
    gauss = np.random.default_rng(seed).standard_normal((count, 3))
    return hoopgen.release(
        speed=7.17 + 0.1 * gauss[:, 0],
        elevation=np.radians(52 + 1.3 * gauss[:, 1]),
        azimuth=np.radians(gauss[:, 2]),
        backspin=6 * np.pi,
        height=2.1336,
        distance=4.191,
    )


def soft_throws() -> Floats:
    """Return free throws of which some roll on a soft ring and leave it."""
    random = np.random.default_rng(1)
    return hoopgen.release(
        random.normal(7.17, 0.12, 100),
        random.normal(0.89, 0.03, 100),
        azimuth=random.normal(0.0, 0.02, 100),
        backspin=12.0,
        height=2.13,
        distance=4.19,
    )


def dropped(count: int, centre: tuple[float, ...], spread: tuple[float, ...], seed: int) -> Floats:
    """Return balls about a place and a velocity, within a spread, without spin."""
    states = np.zeros((count, 9))
    away = np.random.default_rng(seed).uniform(-1.0, 1.0, (count, 6))
    states[:, :6] = np.array(centre) + np.array(spread) * away
    return states


def garbage(count: int) -> Floats:
    """Return releases of which each component may be far out of range, or not a number."""
    rng = np.random.default_rng(6)
    odd = [0.0, 1e300, -1e160, np.inf, np.nan, 5e-324, 1e6]
    states = rng.normal(0, 1, (count, 9))
    return np.where(rng.random((count, 9)) < 0.1, rng.choice(odd, (count, 9)), states)


def alike(states: Floats, count: int = 20) -> Iterator[Floats]:
    """Yield each of some shots as a batch of equal ones: loops end for all of them at once."""
    for state in states:
        yield np.tile(state, (count, 1))


def hard(count: int) -> Floats:
    """Return some shots of each family that is hard for the searches."""
    made = [family.make(count)[0] for family in FAMILIES if not family.workload]
    return np.concatenate(made)


def hoop_runs() -> Iterator[Run]:
    """Yield batches at the article's hoop: hard ones, many, garbage, and until a time limit."""
    for family in FAMILIES:
        yield Run(*family.make(200))
    usual = np.concatenate([family.make(400)[0] for family in FAMILIES if family.workload])
    yield Run(usual, PAPER)
    yield Run(usual[::5], PAPER, time_limit=1.0)
    yield Run(usual, {**PAPER, "restitution": np.full(len(usual), PAPER["restitution"])})
    yield Run(garbage(200), PAPER)
    for states in alike(hard(4)):
        yield Run(states, PAPER)
        yield Run(np.concatenate([usual[:40], states[:2]]), PAPER)
    for states in alike(usual[::400], 1100):
        yield Run(states, PAPER)
    log = hoopgen.simulate(usual[::5], record=True).events
    log = log[log["surface"] < len(HOOP.surfaces)]
    yield Run(log["after"], PAPER, leaving=log["surface"])
    for seed in range(8):
        yield Run(fast(14, seed), PAPER)
    yield Run(np.zeros((0, 9)), PAPER)


def fast(count: int, seed: int) -> Floats:
    """Return shots that single precision cannot serve; some of them pass above the ring."""
    rng = np.random.default_rng(seed)
    states = np.zeros((count, 9))
    speed = 10 ** rng.uniform(4, 6)
    states[:, 0], states[:, 2], states[:, 3] = 0.1 * speed, rng.uniform(0.05, 0.4, count), -speed
    return states


def of_each(count: int, seed: int) -> dict[str, Any]:
    """Return parameters for each shot at the whole hoop: extremes, and values between."""
    rng = np.random.default_rng(seed)
    own: dict[str, Any] = {name: np.full(count, value) for name, value in PAPER_COURT.items()}
    for body in COURT.surfaces:
        own[f"{body}_restitution"] = rng.choice([0.0, 0.2, 0.5, 0.7, 1.0], count)
        own[f"{body}_friction"] = rng.choice([0.0, 0.01, 0.05, 0.3, np.inf], count)
    own["tangential_restitution"] = rng.choice([-1.0, 0.0, 0.15, 1.0], count)
    own["restitution_speed"] = rng.choice([1.0, 40.0, np.inf], count)
    own["board_thickness"] = rng.choice([0.02, 0.05, 0.3], count)
    return own


def court_runs() -> Iterator[Run]:
    """Yield batches at the whole hoop: bounces from all sides, and rolls on each body."""
    soft = PAPER_COURT | each("restitution", 0.2)
    for parameters in (PAPER_COURT, NBA_COURT, NBA_COURT | each("friction", 0.05), soft):
        yield Run(all_kinds(60), parameters, time_limit=5.0)
    many = all_kinds(300, seed=1)
    yield Run(many, of_each(len(many), seed=2), time_limit=3.0)
    yield Run(free_throws(1500), PAPER_COURT | each("restitution", 0.3), time_limit=3.0)
    yield Run(free_throws(100, seed=1), NBA_COURT | {"ring_restitution": 0.3}, time_limit=5.0)
    onto = {
        "bridge": ((-0.2, 0.0, 0.3, 0.0, 0.0, 0.0), (0.06, 0.16, 0.16, 0.5, 0.5, 0.5)),
        "ring": ((0.24, 0.0, 0.3, 0.0, 0.3, 0.0), (0.05, 0.0, 0.0, 0.3, 0.3, 0.0)),
        "board": ((-0.53, 0.0, 1.1, 0.0, 0.0, 0.0), (0.17, 1.0, 0.04, 0.3, 0.3, 0.1)),
    }
    for seed, (centre, spread) in enumerate(onto.values()):
        states = dropped(300, centre, spread, seed)
        states[::2, 6:] = np.random.default_rng(seed).normal(0, 20, (150, 3))
        thick = {"board_thickness": 0.3}
        yield Run(states, soft | thick, time_limit=5.0)
        yield Run(states, soft | thick | each("friction", 0.03), time_limit=5.0)
        yield Run(states, of_each(len(states), seed) | thick, time_limit=5.0)
    yield Run(garbage(200), PAPER_COURT, time_limit=2.0)
    for states in alike(hard(2)):
        yield Run(states, PAPER_COURT, max_contacts=6, time_limit=2.0)
        yield Run(np.concatenate([many[:40], states[:2]]), PAPER_COURT, 6, 2.0)
    for seed in range(8):
        yield Run(fast(14, seed), PAPER_COURT, 6, 2.0)
    for states in alike(many[::700], 1100):
        yield Run(states, PAPER_COURT, max_contacts=6, time_limit=2.0)
    for states in alike(many[::90]):
        yield Run(states, PAPER_COURT, max_contacts=6, time_limit=2.0)
    for states in alike(dropped(12, *onto["ring"], seed=4)):
        yield Run(states, soft | each("friction", 0.02), time_limit=2.0)
    log = hoopgen.simulate(many[::5], scene=COURT, record=True, time_limit=2.0).events
    log = log[log["surface"] < len(COURT.surfaces)][:400]
    yield Run(log["after"], PAPER_COURT, 6, 2.0, leaving=log["surface"])
    yield Run(np.zeros((0, 9)), PAPER_COURT)


RUNS = {"hoop": hoop_runs, "court": court_runs}


def simulate_all(scene: str, backend: str) -> None:
    """Simulate all of a scene's batches: with bounds and without, recorded or not, many or few."""
    engine = {"hoop": HOOP, "court": COURT}[scene]
    every = engine.layout.fields + engine.layout.bounds
    path = tuple(name for name in engine.layout.fields if name != "uncertain")
    for run in RUNS[scene]():
        for part in (run, run.take(slice(None, None, 40)), run.take(slice(1))):
            options: dict[str, Any] = {"max_contacts": part.max_contacts, "backend": backend}
            if part.time_limit is not None:
                options["time_limit"] = part.time_limit
            if part.leaving is not None:
                options["leaving"] = part.leaving
            modes = [(every, True), (path, True)]
            modes += [(fields, False) for fields in (every, engine.layout.fields, path, path[:1])]
            for fields, record in modes:
                given = {**options, "fields": fields, "record": record}
                hoopgen.simulate(part.states, part.parameters, scene=engine, **given)


def call_kernels(module: ModuleType) -> None:
    """Call every kernel once: some serve studies, or the derivation's page, and no event loop."""
    for name in module.ARGUMENTS:
        kernel = getattr(module, name)
        given = [np.full(3, 0.5) for each in inspect.signature(kernel).parameters if each[0] != "_"]
        with np.errstate(all="ignore"):
            kernel(*given)
