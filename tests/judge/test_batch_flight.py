"""Batches that NumPy proves: as the judge proves them one by one, and no tie, touch or edge."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Any

import numpy as np
import pytest

from tests.helpers.effort import occurrences, trials

pytest.importorskip("flint")

import hoopgen
from benchmarks.families import FAMILIES, Family
from benchmarks.workloads import TABLE_3, WORKLOADS, States
from hoopgen.judge import Certificate, Proof, batch, batch_flight, batch_proofs, certify
from hoopgen.judge.formulas import formulas
from tests.judge.test_certify import SQUARE, state

PROVED_AT_ONCE = batch_proofs.BITS
SHOTS = 24
ENOUGH = 160
"""Shots that are enough for a batch."""


def certify_singly(states: Any, parameters: Any = None, **options: Any) -> Certificate:
    """Return proofs in ball arithmetic alone."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(batch, "MIN_BATCH", 10**9)
        return certify(states, parameters, processes=1, **options)


def certify_at_once(states: Any, parameters: Any = None, **options: Any) -> Certificate:
    """Return proofs, of a batch of any size at once."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(batch, "MIN_BATCH", 1)
        patch.setattr(batch_flight, "MIN_SHOTS", 1)
        return certify(states, parameters, processes=1, **options)


def differs(one: Proof, other: Proof) -> bool:
    """Return whether two proofs of one shot contradict each other."""
    if (one.outcome, one.surfaces) != (other.outcome, other.surfaces):
        return True
    own, more = (
        (
            np.array([*proof.times, proof.time, *proof.state]),
            np.array([*proof.time_radii, proof.time_radius, *proof.state_radii]),
        )
        for proof in (one, other)
    )
    return not np.all(np.abs(own[0] - more[0]) <= own[1] + more[1])


def check_as_singly(states: States, parameters: Mapping[str, Any], **options: Any) -> int:
    """Check that what is proved at once is proved, too, shot by shot; return how many are."""
    found = certify_at_once(states, parameters, max_bits=512, **options)
    rows = np.flatnonzero(found.bits == PROVED_AT_ONCE)
    own = {name: value[rows] if np.ndim(value) else value for name, value in parameters.items()}
    true = certify_singly(states[rows], own, max_bits=512, **options)
    for proof, row in zip(true.proofs, rows.tolist(), strict=True):
        assert not (proof.decided and differs(found[row], proof))
    assert np.mean(true.decided) > 0.99 if len(rows) else True
    return len(rows)


@pytest.mark.sampled(6)
@pytest.mark.parametrize("family", FAMILIES, ids=lambda family: family.key)
def test_whatever_is_proved_at_once_is_proved_in_balls_with_the_same_numbers(
    family: Family,
) -> None:
    states, parameters = family.make(trials(SHOTS, at_least=8))
    proved = check_as_singly(states, parameters)
    if family.workload:
        assert proved > 0.8 * len(states)


@cache
def free_throws() -> States:
    return WORKLOADS[1].make(trials(300, at_least=ENOUGH))


def test_nearly_all_free_throws_are_proved_at_once() -> None:
    found = certify(free_throws(), processes=1)
    assert found.decided.all()
    assert np.mean(found.bits == PROVED_AT_ONCE) > 0.97


@pytest.mark.slow
def test_final_times_and_states_are_known_to_more_than_a_double_s_digits() -> None:
    found = certify(
        np.concatenate([free_throws(), WORKLOADS[3].make(trials(200, at_least=200))]), processes=1
    )
    size = np.abs(found.state).reshape(-1, 3, 3).max(axis=2).repeat(3, axis=1)
    rounding = np.spacing(np.abs(found.state)) / 2
    assert np.all(
        found.state_radius <= rounding * (1 + 1e-9) + batch_proofs.KNOWN * size + 2.0**-100
    )
    assert np.all(found.time_radius <= 0.76 * np.spacing(found.time))


@pytest.mark.slow
def test_proofs_do_not_depend_on_the_number_of_processes_or_the_width() -> None:
    states = free_throws()
    one = certify(states, processes=1)
    with pytest.MonkeyPatch.context() as patch:
        for owner in (batch, batch_flight):
            patch.setattr(owner, "WIDTH", 50)
        two = certify(states, processes=2)
    assert np.array_equal(one.outcome, two.outcome)
    for first, second in zip(one.proofs, two.proofs, strict=True):
        assert not differs(first, second)


def test_shots_have_parameters_of_their_own_and_keep_their_order() -> None:
    random, states = np.random.default_rng(13), free_throws()[: trials(60, at_least=20)]
    own = hoopgen.PAPER | {
        "restitution": random.uniform(0.4, 1.0, len(states)),
        "gravity": random.uniform(9.5, 10.0, len(states)),
        "ring_radius": random.uniform(0.22, 0.25, len(states)),
    }
    assert check_as_singly(states, own) > occurrences(30)


@pytest.mark.parametrize("most", [1, 2, 3])
def test_max_contacts_caps_at_once_as_it_does_singly(most: int) -> None:
    states = free_throws()[: trials(40, at_least=20)]
    assert check_as_singly(states, hoopgen.PAPER, max_contacts=most) > len(states) / 2
    found = certify_at_once(states, max_contacts=most)
    assert np.all((found.contacts == most) == (found.outcome == hoopgen.Outcome.CAPPED))


def test_shots_that_may_last_until_the_time_limit_are_proved_singly() -> None:
    states = free_throws()[: trials(40, at_least=20)]
    limit = float(np.median(certify_singly(states).time))
    found = certify_at_once(states, time_limit=limit)
    at_once = found.bits == PROVED_AT_ONCE
    assert at_once.any()
    assert np.all(found.outcome[at_once] != hoopgen.Outcome.ENDLESS)
    assert np.all((found.time < limit) == at_once)


def test_recorded_proofs_and_those_of_balls_on_a_body_are_made_singly() -> None:
    states = free_throws()
    assert certify_at_once(states[:4], record=True).bits.min() > PROVED_AT_ONCE
    leaving = np.full(4, -1)
    leaving[1] = 1
    bits = certify_at_once(states[:4], leaving=leaving).bits
    assert (bits == PROVED_AT_ONCE).tolist() == [True, False, True, True]


@pytest.mark.slow
def test_scenes_with_air_slip_or_rolling_are_proved_singly() -> None:
    for scene in (hoopgen.COURT, hoopgen.AIR):
        assert not batch_flight.is_supported(formulas(hoopgen.scene.definition.definition(scene)))
    assert batch_flight.is_supported(formulas())


# ------------------------------------------------------------------- what must never be proved


EXACT: dict[str, tuple[list[float], dict[str, float]]] = {
    # Both at t = 1/2: x = -t, z = 19/16 - 4 t².
    "a tie of bridge and board": (state((0.0, 0.0, 1.1875), (-1.0, 0.0, 0.0)), {}),
    # Straight up, and straight down, along the ring's outermost line.
    "a touch from below": (state((0.6875, 0.0, -0.03125), (0.0, 0.0, 6.0)), {}),
    "a touch from above": (state((0.0, 0.6875, 1.0)), {}),
    # At t = 1/6 onto the board's edge, y = 1.
    "the board's edge": (state((0.0, 0.75, 0.5), (-3.0, 1.5, 0.0)), {}),
    # At t = 1/4 down to the bridge's edge, y = 1/8, at z = 3/16.
    "the bridge's edge": (state((-1.0, 0.0, 0.4375), (0.0, 0.5, 0.0)), {"board_distance": 2.0}),
    # Down to z = 3/16 at x = -1/2, where ring and bridge meet.
    "the seam of ring and bridge": (state((-0.5, 0.0, 1.1875)), {"board_distance": 2.0}),
    # At t = 1/16 through the end plane, z = -1/16, at x = R_H = 1/2, under the wire.
    "the edge of the target": (
        state((0.0, 0.0, -0.046875), (8.0, 0.0, 0.0)),
        {"ball_radius": 0.015625, "wire_radius": 0.015625},
    ),
}


@pytest.mark.sampled(4)
@pytest.mark.parametrize("name", EXACT)
def test_an_exact_tie_touch_or_edge_is_never_proved_at_once(name: str) -> None:
    """Shots beside it are proved: it is left open for the place that it meets, not for its kind."""
    exact, own = np.array([EXACT[name][0]]), SQUARE | EXACT[name][1]
    assert not np.any(certify_at_once(exact, own, max_bits=256).bits == PROVED_AT_ONCE)
    beside = exact + 1e-6 * np.random.default_rng(14).normal(size=(20, 9))
    assert check_as_singly(beside, own, max_contacts=3) > 10


@pytest.mark.parametrize("case", TABLE_3)
def test_the_article_s_shots_are_proved_at_once(case: str) -> None:
    assert check_as_singly(TABLE_3[case][None, :], hoopgen.PAPER) == 1


def test_what_is_invalid_has_no_end_or_no_restitution_is_left_to_others() -> None:
    # Below the end plane; within the ring, and within the board.
    places = ((0.0, 0.0, -1.0), (0.5, 0.0, 0.0), (-0.55, 0.0, 0.5))
    found = certify_at_once(np.array([*map(state, places), [np.nan] * 9]), SQUARE)
    assert found.outcome.tolist() == [hoopgen.Outcome.SHORT, *[hoopgen.Outcome.INVALID] * 3]
    assert np.all(found.bits > PROVED_AT_ONCE)
    dead = certify_at_once(free_throws()[:4], hoopgen.PAPER | {"restitution": 0.0}, max_bits=256)
    assert np.all(dead.bits > PROVED_AT_ONCE)
