"""Fixtures of all tests, and which of them `make test` leaves to `make test-slow`."""

from __future__ import annotations

import gc
import signal
from collections import defaultdict
from collections.abc import Callable, Mapping, Sequence
from decimal import localcontext
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

import hoopgen
from hoopgen.core.garbage import THRESHOLDS
from tests.helpers import hoop_shots
from tests.helpers.effort import scaled_names, spread, trials
from tests.helpers.engines import ENGINES, Simulate, simulate_on
from tests.helpers.hoop_shots import Batch
from tests.helpers.march import Flown, March
from tests.helpers.own_scenes import compile_soonest

if signal.getsignal(signal.SIGINT) == signal.SIG_IGN:
    # A shell's job in the background ignores Ctrl-C, and so would what tests start and stop.
    signal.signal(signal.SIGINT, signal.default_int_handler)


def pytest_sessionstart() -> None:
    """Look for garbage seldom, and compile scenes of one's own soonest.

    Both save time: SymPy's expressions and all test modules are much to look through, and most
    tests of such scenes compile for longer than they fly.
    """
    gc.set_threshold(*THRESHOLDS)
    compile_soonest()


def pytest_collection_finish() -> None:
    """Look for garbage no more among what stays to the end: modules and tests."""
    gc.collect()
    gc.freeze()


@pytest.hookimpl(tryfirst=True)  # before `-m` selects
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Mark as slow what opens a browser or is left out by a sample, as scaled what may scale.

    The sample of a test is of its cases that are not slow, that of a file is of such tests. Below
    effort 1 a share of the slow cases of each test is run.
    """
    families = defaultdict[tuple[str, int], list[pytest.Item]](list)
    for item in items:
        fixtures = getattr(item, "fixturenames", ())
        if "browser" in fixtures:
            item.add_marker("slow")
        scaled = scaled_names(item.path) | scaled_names(Path(__file__))
        if scaled.intersection([getattr(item, "originalname", item.name), *fixtures]):
            item.add_marker("scaled")
        if item.get_closest_marker("slow"):
            continue
        for node, mark in item.iter_markers_with_node("sampled"):
            family = item.nodeid.partition("[")[0] if node is item else node.nodeid
            families[family, mark.args[0]].append(item)
            break  # the mark that is nearest
    for (_, count), members in families.items():
        kept = {(2 * k + 1) * len(members) // (2 * count) for k in range(count)}
        for number, item in enumerate(members):
            if number not in kept:
                item.add_marker("slow")
    cases = defaultdict[str, list[pytest.Item]](list)
    for item in items:
        if item.get_closest_marker("slow"):
            cases[item.nodeid.partition("[")[0]].append(item)
    sample = {item for members in cases.values() for item in spread(members)}
    others = {item for members in cases.values() for item in members} - sample
    config.hook.pytest_deselected(items=list(others))
    items[:] = [item for item in items if item not in others]


@pytest.fixture(scope="session", params=ENGINES)
def simulate(request: pytest.FixtureRequest) -> Simulate:
    """`hoopgen.simulate` on one engine; every test that asks for it is run on each."""
    return simulate_on(request.param)


@pytest.fixture(scope="session")
def families() -> Callable[[int, int], dict[str, NDArray[np.float64]]]:
    """Shots by kind: so many of each, from a seed."""
    return hoop_shots.families


@pytest.fixture(scope="session")
def mixed() -> Batch:
    """At effort 1 over 2e4 shots of all kinds, a tenth with a hoop of their own."""
    # Kind after kind, so that NumPy's blocks of long shots are few.
    states = np.concatenate(
        list(hoop_shots.families(trials(3000, at_least=1000), seed=20130515).values())
    )
    random = np.random.default_rng(17)
    others = random.random(len(states)) < 0.1
    spread = {
        "ball_radius": (0.10, 0.13),
        "ring_radius": (0.20, 0.30),
        "board_distance": (0.35, 0.45),
        "bridge_half_width": (0.01, 0.30),
        "restitution": (0.0, 1.0),
        "gravity": (1.6, 25.0),
        "end_depth": (0.01, 0.12),
    }
    parameters = dict(hoopgen.PAPER)
    for name, (low, high) in spread.items():
        own = random.uniform(low, high, len(states))
        parameters[name] = np.where(others, own, hoopgen.PAPER[name])
    return Batch(states, parameters)


@pytest.fixture(scope="session")
def fly() -> Callable[..., Flown]:
    """One shot to 50 digits, by a method that shares nothing with the engines."""

    def fly(
        state: Sequence[float],
        parameters: Mapping[str, float] = hoopgen.PAPER,
        max_contacts: int = 40,
    ) -> Flown:
        with localcontext() as context:
            context.prec = 50
            return March(parameters).fly(state, max_contacts)

    return fly
