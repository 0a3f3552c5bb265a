"""Proved errors of recorded events: exact numbers, planted errors, and where the proof ends."""

from __future__ import annotations

from fractions import Fraction
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from tests.helpers.effort import trials

pytest.importorskip("flint")

import hoopgen
from benchmarks.workloads import TABLE_3, WORKLOADS
from hoopgen.core.event_log import Event
from hoopgen.judge import Certificate, certify
from tests.judge.test_certify import ONTO_THE_BRIDGE, SMALL_BALL, SQUARE, on_court

ERRORS = ("time_error", "before_error", "after_error")


def logged(shots: hoopgen.Shots, events: NDArray[np.void]) -> Any:
    """Return what `event_errors` reads of shots, with another event log."""

    class Log(SimpleNamespace):
        def __len__(self) -> int:
            return len(shots)

    given = {"releases": shots.releases, "parameters": shots.parameters}
    return Log(events=events, scene=shots.scene, **given)


def columns(rows: NDArray[np.void]) -> NDArray[np.float64]:
    """Return the seven bounds of each row."""
    return np.column_stack([rows[name] for name in ERRORS])


def simulated(states: Any, parameters: Any = None) -> tuple[hoopgen.Shots, Certificate]:
    shots = hoopgen.simulate(states, parameters, record=True)
    return shots, certify(states, parameters, record=True, processes=1)


def exact_errors(proof: Any, row: int, event: np.void) -> list[tuple[Fraction, Fraction]]:
    """Return for time and each component the least and the greatest error that is possible."""
    truth = proof.events[row]
    pairs = [(truth.time, event["time"])]
    pairs += [*zip(truth.before, event["before"], strict=True)]
    pairs += [*zip(truth.after, event["after"], strict=True)]
    found = []
    for one, number in pairs:
        scale = Fraction(2) ** one.exponent
        away = abs(one.middle * scale - Fraction(float(number)))
        found.append((max(Fraction(0), away - one.radius * scale), away + one.radius * scale))
    return found


def test_the_bounds_are_the_errors_in_whole_numbers_rounded_up() -> None:
    """Bounds that were rounded to nearest would be too small for half of the numbers."""
    states = np.concatenate([WORKLOADS[1].make(trials(60)), [TABLE_3["6b"]]])
    shots, proofs = simulated(states)
    found = proofs.event_errors(shots)
    assert len(found) == len(shots.events)
    np.testing.assert_array_equal(found["shot"], shots.events["shot"])
    np.testing.assert_array_equal(found["surface"], shots.events["surface"])
    assert np.isfinite(columns(found)).all()
    starts = np.searchsorted(found["shot"], np.arange(len(shots)))
    for row, (event, bounds) in enumerate(zip(shots.events, found, strict=True)):
        shot = int(event["shot"])
        errors = exact_errors(proofs[shot], row - int(starts[shot]), event)
        groups = [errors[:1], *(errors[k : k + 3] for k in range(1, 19, 3))]
        given = [bounds["time_error"], *bounds["before_error"], *bounds["after_error"]]
        for bound, group in zip(given, groups, strict=True):
            most = max(greatest for _, greatest in group)
            assert most <= Fraction(float(bound)) <= most * (1 + Fraction(1, 2**25))
            assert max(least for least, _ in group) > most * (1 - Fraction(1, 2**10)) or most == 0


def test_the_last_event_s_errors_are_within_what_the_engine_claims() -> None:
    states = WORKLOADS[1].make(trials(200))
    shots = hoopgen.simulate(
        states,
        record=True,
        fields=("outcome", "time", "state", "uncertain", "time_error", "state_error"),
    )
    found = certify(states, record=True, processes=1).event_errors(shots)
    ends = np.flatnonzero(shots.events["kind"] == Event.END)
    own = shots.events["shot"][ends]
    sure = ~shots.uncertain[own]
    assert np.all(found["time_error"][ends][sure] <= shots.time_error[own][sure])
    assert np.all(found["after_error"][ends][sure] <= shots.state_error[own][sure])


def test_where_doubles_are_exact_the_errors_are_zero_and_a_planted_one_is_seen() -> None:
    """A bounce off the board with numbers that are sums of few powers of two."""
    # x = -t meets -1/2 at t = 1/2; the velocity after it is no double (3/5).
    states = np.array([[0.0, 0.25, 0.0, -1.0, 0.0, 3.0, 0.0, 0.0, 0.0]])
    shots, proofs = simulated(states, SQUARE)
    first = proofs.event_errors(shots)[0]
    assert first["time_error"] == 0.0
    assert first["before_error"].tolist() == [0.0, 0.0, 0.0]
    assert first["after_error"][0] == 0.0
    assert 0.0 < first["after_error"][1] <= 2.0**-52
    events = shots.events.copy()
    events["time"][0] += 2.0**-40
    events["before"][0, 4] -= 2.0**-30
    events["after"][0, 8] += 2.0**-20
    planted = proofs.event_errors(logged(shots, events))[0]
    assert 2.0**-40 <= planted["time_error"] <= 2.0**-40 * (1 + 2.0**-25)
    assert planted["before_error"][0] == planted["before_error"][2] == 0.0
    assert 2.0**-30 <= planted["before_error"][1] <= 2.0**-30 * (1 + 2.0**-25)
    assert planted["after_error"][2] == pytest.approx(2.0**-20, rel=1e-6)


def test_from_the_first_event_that_is_not_as_proved_on_nothing_is_said() -> None:
    shots, proofs = simulated(np.array([TABLE_3["5d"], TABLE_3["7"]]))
    events = shots.events.copy()
    assert events["surface"].tolist() == [0, 1, 2, 3, 0, 1, 3]
    events["surface"][1] = 2
    found = np.isfinite(columns(proofs.event_errors(logged(shots, events))))
    assert found.all(axis=1).tolist() == [True, False, False, False, True, True, True]
    assert not found[1:4].any()


def test_an_undecided_proof_bounds_the_events_before_its_question() -> None:
    """Off the board into a corner, where the judge cannot go on without restitution."""
    states = np.array([[0.5, 0.0, 0.5, -4.0, 0.0, 1.0, 0.0, 20.0, 0.0]])
    given = SQUARE | {"restitution": 0.0}
    shots = hoopgen.simulate(states, given, record=True)
    proofs = certify(states, given, record=True, max_bits=512)
    found = columns(proofs.event_errors(shots))
    known = len(proofs[0].events)
    assert not proofs.decided[0]
    assert known > 0
    assert np.isfinite(found[:known]).all()
    assert np.isnan(found[known:]).all()


def test_of_a_roll_nothing_is_said() -> None:
    states = np.array([ONTO_THE_BRIDGE])
    shots = hoopgen.simulate(states, SMALL_BALL, scene=hoopgen.COURT, record=True)
    begun = int(np.flatnonzero(shots.events["kind"] == Event.ROLL)[0])
    found = columns(on_court(states).event_errors(shots))
    assert np.isfinite(found[:begun]).all()
    assert np.isnan(found[begun:]).all()


def test_a_wrong_argument_is_said() -> None:
    shots, proofs = simulated(np.array([TABLE_3["7"]] * 2))
    with pytest.raises(ValueError, match="shots: expected 2, as many as were proved; got 1"):
        proofs.event_errors(hoopgen.simulate(TABLE_3["7"], record=True))
    bare = certify(TABLE_3["7"])
    with pytest.raises(ValueError, match=r"certify\(\.\.\., record=True\)"):
        bare.event_errors(hoopgen.simulate(TABLE_3["7"], record=True))
    assert len(proofs.event_errors(shots)) == 6
    other = hoopgen.simulate([TABLE_3["7"], TABLE_3["5a"]], record=True)
    with pytest.raises(ValueError, match="releases that were proved; those of shot 1 differ"):
        proofs.event_errors(other)
    bouncier = hoopgen.simulate([TABLE_3["7"]] * 2, {"restitution": [0.7, 0.71]}, record=True)
    with pytest.raises(ValueError, match="parameters that were proved; those of shot 1 differ"):
        proofs.event_errors(bouncier)
    court = hoopgen.simulate([TABLE_3["7"]] * 2, scene=hoopgen.COURT, record=True)
    with pytest.raises(ValueError, match="in the scene hoop, which was proved; got some in court"):
        proofs.event_errors(court)
