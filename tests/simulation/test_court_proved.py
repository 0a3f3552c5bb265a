"""`COURT`: the bounds of shots that are not estimated are proved, and those of others hold, too."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest
from hoopgen.derive.errors.provisional import LARGEST_PLACE

import hoopgen
from benchmarks.workloads import WORKLOADS
from hoopgen import COURT, NBA_COURT, Shots
from hoopgen.judge.certificate import Certificate
from hoopgen.simulation.engine import Engine
from tests.helpers.court_shots import all_kinds
from tests.helpers.effort import trials

pytest.importorskip("flint")

FIELDS = (
    *("outcome", "contacts", "counts", "time", "state", "rolls", "slip_left"),
    *("uncertain", "estimated", "time_error", "state_error"),
)
OPTIONS = {"record": True, "max_contacts": 14}
SLIPPERY = NBA_COURT | {
    **dict.fromkeys(("ring_friction", "backboard_friction", "bridge_friction"), 0.2),
    "tangential_restitution": 0.1,
}
LIMIT = float(LARGEST_PLACE)
SCENES = {"paper": None, "nba": NBA_COURT, "slippery": SLIPPERY}


def releases() -> np.ndarray:
    """Return free throws, shots that bounce, swirls, and shots from all sides of the hoop."""
    usual = [workload.make(trials(150, at_least=40)) for workload in WORKLOADS[1:4]]
    return np.concatenate([*usual, all_kinds(trials(60, at_least=20))])


@cache
def certified(scene: str) -> Certificate:
    """Return what the judge says of the releases."""
    return COURT.certify(releases(), SCENES[scene], **OPTIONS)


def shares(shots: Shots, proof: Certificate, among: np.ndarray) -> tuple[int, np.ndarray]:
    """Return how many contacts of some shots the judge has, and the largest share of each bound."""
    log, errors = shots.events, proof.event_errors(shots)
    rows = among[log["shot"]] & np.isfinite(errors["time_error"]) & (log["time"] > 0)
    bounds = np.column_stack([log["time_error"], log["state_error"]])[rows]
    found = np.column_stack([errors["time_error"], errors["after_error"]])[rows]
    with np.errstate(invalid="ignore", divide="ignore"):
        return len(found), np.nanmax(np.where(found > 0, found / bounds, 0), axis=0)


def check_ends(shots: Shots, proof: Certificate, among: np.ndarray) -> None:
    """Demand that times and states at the end are within their bounds."""
    known = among & np.isfinite(proof.time)
    assert np.count_nonzero(known) > 0.4 * len(shots)
    off = np.abs(shots.state - proof.state) - proof.state_radius
    assert np.all(off[known] <= np.repeat(shots.state_error[known], 3, axis=1))
    late = np.abs(shots.time - proof.time) - proof.time_radius
    assert np.all(late[known] <= shots.time_error[known])


def check_proved(engine: Engine, scene: str) -> None:
    """Demand that the judge finds nothing wrong, and no larger error."""
    proof = certified(scene)
    shots = engine.simulate(releases(), SCENES[scene], **OPTIONS, fields=FIELDS)
    assert np.all(proof.agrees(shots))
    sure = ~shots.estimated & ~shots.uncertain
    number, largest = shares(shots, proof, sure)
    assert number > len(shots)
    assert np.all(largest <= 1), largest
    assert largest[0] > 0.05
    check_ends(shots, proof, sure)


def check_estimated(engine: Engine, workload: int) -> None:
    """Demand the same of shots that bounce until the proved bounds have grown too large."""
    states = WORKLOADS[workload].make(20_000)
    given = {"max_contacts": 24, "fields": FIELDS}
    found = COURT.simulate(states, **given)
    chosen = np.flatnonzero(found.estimated & ~found.uncertain)[: trials(100, at_least=30)]
    shots = engine.simulate(states[chosen], record=True, **given)
    proof = COURT.certify(states[chosen], record=True, max_contacts=24)
    assert np.all(proof.agrees(shots))
    number, largest = shares(shots, proof, np.ones(len(shots), bool))
    assert number > 10 * len(chosen)
    assert np.all(largest <= 1), largest


def check_rolls(engine: Engine) -> None:
    """Demand that shots that roll are estimated, and hardly any others."""
    for workload, most in zip(WORKLOADS[:4], (0.0, 0.012, 0.02, 0.18), strict=True):
        shots = engine.simulate(workload.make(trials(20_000)), fields=FIELDS)
        rolled = shots.rolls > 0
        assert np.all(shots.estimated[rolled])
        assert np.mean(shots.estimated & ~rolled) <= most
    swirls = WORKLOADS[3].make(trials(2000, at_least=500))
    shots = engine.simulate(swirls, record=True, fields=FIELDS)
    log = shots.events[shots.events["kind"] == hoopgen.Event.IMPACT]
    assert np.all(log["state_error"][~shots.estimated[log["shot"]], 0] <= LIMIT)


def check_time_limit(engine: Engine, limit: float) -> None:
    """Demand that bounds hold at a time limit."""
    states = WORKLOADS[1].make(trials(200, at_least=60))
    given: dict[str, Any] = {"max_contacts": 14, "time_limit": limit}
    shots = engine.simulate(states, NBA_COURT, **given, fields=FIELDS)
    proof = COURT.certify(states, NBA_COURT, **given)
    check_ends(shots, proof, ~shots.estimated & ~shots.uncertain)


def check_start(engine: Engine) -> None:
    """Demand that shots of balls that start on a body are estimated."""
    log = COURT.simulate(WORKLOADS[1].make(200), record=True).events
    row = log[log["kind"] == hoopgen.Event.IMPACT][0]
    shots = engine.simulate(row["after"][None], leaving=[int(row["surface"])], fields=FIELDS)
    assert shots.estimated.all()
    assert not shots.proved.any()


@pytest.mark.parametrize("scene", SCENES)
def test_the_judge_finds_nothing_wrong_and_no_larger_error(scene: str) -> None:
    check_proved(COURT, scene)


@pytest.mark.parametrize("workload", [1, 3])
def test_estimated_bounds_hold_as_well(workload: int) -> None:
    check_estimated(COURT, workload)


def test_hardly_any_shot_is_estimated_but_those_that_roll() -> None:
    check_rolls(COURT)


@pytest.mark.parametrize("limit", [0.9, 1.2])
def test_bounds_hold_at_a_time_limit(limit: float) -> None:
    check_time_limit(COURT, limit)


def test_shots_are_proved_or_estimated() -> None:
    shots = COURT.simulate(WORKLOADS[3].make(2000), fields=FIELDS)
    assert np.array_equal(shots.proved, ~shots.estimated)


@pytest.mark.parametrize("scene", SCENES)
def test_engines_agree_in_every_bit(scene: str) -> None:
    states = np.concatenate([releases(), WORKLOADS[3].make(trials(500))])
    one, other = (
        COURT.simulate(states, SCENES[scene], record=True, backend=name, fields=FIELDS)
        for name in ("c", "numpy")
    )
    assert one.events.tobytes() == other.events.tobytes()
    for name in FIELDS:
        assert getattr(one, name).tobytes() == getattr(other, name).tobytes(), name


def test_a_ball_that_starts_on_a_body_is_estimated() -> None:
    """No lemma says whether it rolls, and its place is rounded onto the body."""
    check_start(COURT)
