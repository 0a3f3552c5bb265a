"""Flights in air: the throws, the peers' own equations, grazes, and the page."""

from __future__ import annotations

import numpy as np
import pytest

for _library in ("flint", "matplotlib", "scipy", "sympy"):
    pytest.importorskip(_library)

import hoopgen  # noqa: E402
from benchmarks import air, air_page  # noqa: E402
from benchmarks.errors import MAX_CONTACTS, compare, judge  # noqa: E402
from benchmarks.peers import EVERYBODY, PEERS  # noqa: E402
from benchmarks.timing import Rates  # noqa: E402
from benchmarks.workloads import swish_shot  # noqa: E402
from hoopgen import PAPER_AIR  # noqa: E402

# One worker: the scene is compiled once.
pytestmark = pytest.mark.xdist_group("air")

FLYING = [peer for peer in PEERS if peer.key in air.METHODS]


def test_the_mean_throw_falls_through_the_centre_of_the_ring() -> None:
    state = swish_shot()
    state[3:6] *= air.FASTER
    shot = hoopgen.simulate(state, scene=hoopgen.AIR)
    depth = hoopgen.measure(state, shot, PAPER_AIR, ["depth"])["depth"]
    assert abs(float(depth[0])) < 1e-3


@pytest.mark.slow
@pytest.mark.parametrize("peer", FLYING, ids=lambda peer: peer.key)
def test_peers_fly_the_same_equations(peer: air.Peer) -> None:
    states = air.throws(12)
    shots = hoopgen.AIR.simulate(states, PAPER_AIR, max_contacts=MAX_CONTACTS)
    flown = peer.fly(states, PAPER_AIR)
    sure = ~shots.uncertain & (shots.outcome != hoopgen.Outcome.CAPPED)
    assert sure.sum() >= 10
    assert (flown.outcome == shots.outcome)[sure].all()
    assert (flown.contacts == shots.contacts)[sure].all()
    # An error of 1e-13 m in each flight, grown by the contacts.
    assert np.abs(flown.time - shots.time)[sure].max() < 1e-9


@pytest.mark.slow
def test_hoopgen_agrees_with_the_proofs() -> None:
    states = air.throws(3)
    right = judge(states, PAPER_AIR, hoopgen.AIR)
    found = compare(air.by_hoopgen(states, PAPER_AIR, hoopgen.AIR), right)
    assert found.shots == 3
    assert found.wrong_sequence == 0
    assert found.time_95 < 1e-10


@pytest.mark.slow
def test_grazes_are_proved_and_hoopgen_is_never_wrong_without_saying_so() -> None:
    found = air.grazes(6)
    known = air.proved(found)
    assert known.shape == (2, 6)
    assert known.sum() >= 10
    own = air.tally(found, air._by_hoopgen, known)
    assert (own.missed, own.invented) == (0, 0)
    assert own.uncertain < known.sum()
    blind = air.tally(found, lambda states: (np.full(6, -1), np.zeros(6), np.zeros(6, bool)), known)
    assert blind.missed == known[0].sum()


def test_the_page_counts_and_names_everybody() -> None:
    rates = {key: Rates(8, (1.0, 2.0)) for key in air_page.LABELS}
    errors = {key: air.Errors(10, 0.1, 0.2, 1e-15, 1e-13) for key in ("hoopgen", *air.METHODS)}
    tallies = {key: air.Tally(5, 6, 1, 2, 3) for key in errors}
    results = air.Results((2.0, 1.5), rates, errors, {}, tallies, ("heyoka: left out",))
    page = air_page.as_markdown(results)
    assert all(f"| {label} |" in page for label in air_page.LABELS.values())
    assert "5 throws touch the ring first, and 6 others" in page
    assert "10 proved | 1 | 2 |" in page
    assert "heyoka: left out." in page
    assert {peer.key for peer in EVERYBODY} >= set(air.METHODS)
