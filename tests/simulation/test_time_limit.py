"""A time limit on the hoop: a shot ends as ENDLESS then, on the path that it takes anyway."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from typing import Any

import numpy as np
import pytest
from hoopgen.derive.ir.event_tree import Call, If, Node
from hoopgen.derive.model import build
from hoopgen.derive.scenes.hoop import HOOP

import hoopgen
from benchmarks.families import FAMILIES
from hoopgen import Outcome
from tests.helpers.effort import trials
from tests.helpers.engines import Simulate
from tests.helpers.hoop_shots import Batch

FIELDS = hoopgen.HOOP.layout.fields
EVERY = tuple(hoopgen.HOOP.layout.results)
END = len(hoopgen.SURFACES)
SWIRL = [0.2286, -0.94488, -0.6096, -0.8382, 2.1336, 3.85572, 0.0, 0.0, 0.0]  # Table 3, case 6b


def same(one: Any, other: Any, name: str, rows: Any = slice(None)) -> bool:
    return bool(getattr(one, name)[rows].tobytes() == getattr(other, name)[rows].tobytes())


@pytest.fixture(scope="module")
def some(mixed: Batch) -> Batch:
    return mixed.take(slice(None, None, 10))


@pytest.mark.sampled(7)
@pytest.mark.parametrize("limit", [0.3, 0.9, 1.4])
def test_what_ends_before_the_limit_is_as_it_was(
    simulate: Simulate, some: Batch, limit: float
) -> None:
    """The other shots are where they were at that time, after the same contacts."""
    whole = simulate(some.states, some.parameters, record=True)
    cut = simulate(some.states, some.parameters, record=True, fields=EVERY, time_limit=limit)
    endless = cut.outcome == Outcome.ENDLESS
    assert 0.1 < endless.mean() < 0.95
    for name in FIELDS:
        assert same(whole, cut, name, ~endless), name
    assert np.all(cut.time[endless] == limit)
    assert np.all(cut.time_error[endless] == 0)
    ends = cut.events[(cut.events["surface"] == END) & endless[cut.events["shot"]]]
    assert np.array_equal(ends["shot"], np.flatnonzero(endless))
    assert np.all(ends["time"] == limit)
    assert np.array_equal(ends["before"], ends["after"])
    assert np.array_equal(ends["after"], cut.state[endless])
    earlier = whole.events[whole.events["time"] < limit]
    kept = cut.events[~((cut.events["surface"] == END) & endless[cut.events["shot"]])]
    for name in earlier.dtype.names or ():
        assert kept[name].tobytes() == earlier[name].tobytes(), name
    for row in np.flatnonzero(endless)[::20]:
        path, ended = whole.trajectory(int(row)), cut.trajectory(int(row))
        assert (ended.duration, ended.outcome) == (limit, Outcome.ENDLESS)
        if path.duration > limit:
            assert np.array_equal(path.at(limit), cut.state[row]), row
        assert np.array_equal(ended.at(limit), cut.state[row])


@pytest.mark.sampled(1)
def test_every_engine_gives_the_bits_of_numpy(simulate: Simulate, some: Batch) -> None:
    options: dict[str, Any] = {"time_limit": 0.9, "fields": EVERY, "record": True}
    wanted = hoopgen.simulate(some.states, some.parameters, backend="numpy", **options)
    found = simulate(some.states, some.parameters, **options)
    for name in (*EVERY, "events"):
        assert same(found, wanted, name), name
    plain = simulate(some.states, some.parameters, time_limit=0.9, fields=FIELDS[:-1])
    for name in FIELDS[:-1]:
        assert same(plain, wanted, name), name


def test_a_limit_that_no_shot_comes_to_changes_nothing(simulate: Simulate, some: Batch) -> None:
    """A ball that can never come down through the end plane is short, and not endless."""
    without = simulate(some.states, some.parameters, fields=EVERY, record=True)
    for limit in (1e3, np.inf, None):
        limited = simulate(
            some.states, some.parameters, fields=EVERY, record=True, time_limit=limit
        )
        for name in (*EVERY, "events"):
            assert same(without, limited, name), name
    assert np.any(without.outcome == Outcome.SHORT)


def test_a_cap_before_the_limit_counts(simulate: Simulate) -> None:
    whole = simulate(SWIRL, record=True)
    times = whole.events["time"]
    between = float(times[4] + times[5]) / 2
    shots = simulate([SWIRL], max_contacts=5, time_limit=between)
    assert (shots.outcome[0], shots.time[0]) == (Outcome.CAPPED, times[4])
    shots = simulate([SWIRL], max_contacts=6, time_limit=between)
    assert (shots.outcome[0], shots.contacts[0]) == (Outcome.ENDLESS, 5)


def test_the_judge_agrees_and_errors_are_within_what_is_claimed(some: Batch) -> None:
    few = some.take(slice(None, None, 7))
    shots = hoopgen.simulate(few.states, few.parameters, fields=EVERY, time_limit=0.9)
    proofs = hoopgen.certify(few.states, few.parameters, time_limit=0.9, processes=1)
    sure = ~shots.uncertain & proofs.decided
    assert sure.mean() > 0.95
    for name in ("outcome", "counts", "first"):
        assert np.array_equal(getattr(shots, name)[sure], getattr(proofs, name)[sure]), name
    endless = sure & (shots.outcome == Outcome.ENDLESS)
    assert np.count_nonzero(endless & (shots.contacts > 0)) > 20
    apart = np.abs(shots.state - proofs.state).reshape(-1, 3, 3).max(axis=2)
    assert np.all((apart <= shots.state_error)[endless])
    assert np.all(proofs.time[endless] == 0.9)
    assert np.all(proofs.time_radius[endless] == 0)


def test_a_contact_within_rounding_of_the_limit_is_uncertain_and_settled() -> None:
    contact = float(hoopgen.simulate(SWIRL, record=True).events["time"][6])
    for limit in (np.nextafter(contact, 0), contact, np.nextafter(contact, 9)):
        assert hoopgen.simulate(SWIRL, time_limit=limit).uncertain[0]
        settled = hoopgen.simulate(SWIRL, time_limit=limit, settle=True, record=True)
        proof = hoopgen.certify(SWIRL, time_limit=limit)[0]
        assert not settled.uncertain[0]
        assert (settled.outcome[0], proof.outcome) == (Outcome.ENDLESS, Outcome.ENDLESS)
        assert settled.events["surface"].tolist() == proof.surfaces
        assert settled.time[0] == limit
    for share in (1 - 1e-8, 1 + 1e-8):
        assert not hoopgen.simulate(SWIRL, time_limit=contact * share).uncertain[0]


@pytest.mark.slow
def test_limits_about_contacts_end_no_shot_otherwise_than_the_exact_one_unflagged() -> None:
    """Nor are errors at the limit larger than their bounds."""
    random, limits = np.random.default_rng(17), trials(60, at_least=12)
    families = {family.key: family.make(8)[0] for family in FAMILIES}
    states = np.concatenate([families[key] for key in ("W2", "W3", "W4", "around", "rim")])
    log = hoopgen.simulate(states, record=True, max_contacts=12).events
    times = random.choice(log["time"], limits)
    shifts = random.choice([-1, 1], limits) * 10 ** random.uniform(-16.5, -8, limits)
    near = flagged = 0
    for limit in times + shifts:
        shots = hoopgen.simulate(states, fields=EVERY, time_limit=limit)
        proofs = hoopgen.certify(states, time_limit=limit, processes=1)
        sure = ~shots.uncertain & proofs.decided
        for name in ("outcome", "counts", "first"):
            assert np.array_equal(getattr(shots, name)[sure], getattr(proofs, name)[sure]), name
        endless = sure & (shots.outcome == Outcome.ENDLESS)
        apart = np.abs(shots.state - proofs.state) - proofs.state_radius
        assert np.all((apart.reshape(-1, 3, 3).max(axis=2) <= shots.state_error)[endless])
        near += np.count_nonzero(endless)
        flagged += np.count_nonzero(shots.uncertain & (shots.outcome != Outcome.CAPPED))
    assert near > 10 * limits
    assert flagged > limits / 20


@pytest.mark.parametrize("value", [0, -1.0, float("nan"), True, "1 s", [1.0], np.timedelta64(1)])
def test_a_time_limit_is_a_positive_number(value: Any) -> None:
    said = "time_limit: expected a positive number of seconds, or None, got"
    for ask in (hoopgen.simulate, hoopgen.certify):
        with pytest.raises((TypeError, ValueError), match=f"^{re.escape(said)}"):
            ask(SWIRL, time_limit=value)


def test_without_a_limit_all_that_is_done_for_it_is_to_ask() -> None:
    """Statements that read the limit stand behind a guard that skips them."""

    def unguarded(nodes: Iterable[Node]) -> Iterator[Call]:
        for node in nodes:
            if isinstance(node, Call):
                yield node
            elif not (isinstance(node, If) and node.truth == "limited" and node.rare):
                yield from unguarded(node.body)

    loop = build(HOOP).loop
    asked = [node.kernel.name for s in loop.stages.values() for node in unguarded(s)]
    assert asked.count("limited") == 1
    assert not {"expiry", "expired", "ends_by_time_limit", "carry_time"} & set(asked)
    assert {"expiry", "expired", "ends_by_time_limit", "carry_time"} < loop.called


def test_what_errors_grow_to_after_a_ball_has_exit_time_is_no_uncertainty() -> None:
    """A shot from below the end plane falls for ever: no horizon bounds what its errors grow to."""
    (around,) = (family for family in FAMILIES if family.key == "around")
    states, _ = around.make(4_000)
    shots = hoopgen.simulate(states, hoopgen.PAPER, backend="numpy")
    short = (shots.outcome == hoopgen.Outcome.SHORT) & (shots.contacts > 0)
    assert short.sum() > 100
    assert not shots.uncertain[short].any()


@pytest.mark.slow
@pytest.mark.parametrize("backend", ["c", "numpy"])
def test_a_limit_shortly_after_a_departure_is_on_the_flight(backend: Any) -> None:
    """A ball comes off the ring for up to 2^-7 s before its flight is searched."""
    random, count = np.random.default_rng(1), 300
    angle = random.uniform(-1.5, 1.5, count)
    states = np.zeros((count, 9))
    states[:, 0], states[:, 1] = 0.2286 * np.cos(angle), 0.2286 * np.sin(angle)
    states[:, 2] = 0.135
    states[:, 3:5] = random.normal(0, 0.4, (count, 2))
    states[:, 6:] = random.normal(0, 5, (count, 3))
    parameters = hoopgen.PAPER_COURT | {
        f"{name}_restitution": 0.0 for name in hoopgen.COURT.surfaces
    }
    options: dict[str, Any] = {"scene": hoopgen.COURT, "backend": backend}
    shots = hoopgen.simulate(states, parameters, record=True, **options)
    leaves = shots.events[shots.events["kind"] == hoopgen.Event.LEAVE]
    leaves = leaves[~shots.uncertain[leaves["shot"]]][:40]
    assert len(leaves) > 20
    compared = 0
    for leave in leaves:
        for later in (1e-5, 5e-4, 4e-3):
            limit = float(leave["time"]) + later
            cut = hoopgen.simulate(
                states[leave["shot"]], parameters, time_limit=limit, fields=EVERY, **options
            )
            if cut.uncertain[0] or cut.outcome[0] != Outcome.ENDLESS:
                continue
            place, speed = leave["after"][:3], leave["after"][3:6]
            fall = np.array([0, 0, -0.5 * hoopgen.PAPER["gravity"] * later**2])
            there = place + speed * later + fall
            assert cut.time[0] == limit
            np.testing.assert_allclose(cut.state[0, :3], there, rtol=0, atol=1e-9)
            compared += 1
    assert compared >= 2 * len(leaves)
