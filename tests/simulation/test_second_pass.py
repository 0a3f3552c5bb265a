"""Shots that end uncertain are simulated again, with tighter bounds: what that changes."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hoopgen.generated.numpy import hoop

import hoopgen
from benchmarks.families import FAMILIES
from hoopgen import HOOP, PAPER, Outcome
from hoopgen.engine import numpy_backend
from hoopgen.engine.result_arrays import ResultArrays
from tests.helpers.engines import Simulate

BOUNDS = tuple(sorted(hoop.DIAGNOSTIC_RESULTS))
PATH = tuple(result.name for result in hoop.RESULTS if result.name not in BOUNDS)
SHOTS = {family.key: family.make(4000 if family.key == "W4" else 500)[0] for family in FAMILIES}
STATES = np.concatenate([SHOTS[key] for key in ("W2", "W4", "grazing", "seam", "rim")])


def once(states: np.ndarray[Any, Any]) -> ResultArrays:
    """Return all results of shots that are simulated once."""
    out = HOOP.layout.allocate(len(states), PATH + BOUNDS)
    usual = [float(PAPER[name]) for name in hoop.PARAMETERS]
    numpy_backend.run(hoop, states, usual, None, 40, out, tightening=False)
    return out


@pytest.fixture(scope="module")
def first() -> ResultArrays:
    return once(STATES)


def loose(first: ResultArrays) -> Any:
    """Return which shots are simulated again."""
    ended = (first.outcome != Outcome.CAPPED) & (first.contacts > 0)
    return first.uncertain & ended


def test_all_other_shots_and_all_of_the_path_are_as_they_were(
    simulate: Simulate, first: ResultArrays
) -> None:
    shots = simulate(STATES, fields=PATH + BOUNDS)
    again = loose(first)
    assert 0.01 < np.mean(again) < 0.5
    for name in PATH:
        assert getattr(shots, name).tobytes() == getattr(first, name).tobytes(), name
    for name in BOUNDS:
        ours, theirs = getattr(shots, name), getattr(first, name)
        assert ours[~again].tobytes() == theirs[~again].tobytes(), name
    assert not np.any(shots.uncertain & ~first.uncertain)
    certain = again & ~shots.uncertain
    assert np.count_nonzero(certain) > 20
    assert np.count_nonzero(again & shots.uncertain) > 20
    # Each of up to 40 contacts rounds C upwards by 2^-10 besides the whole bound: 4% in all.
    smaller = shots.state_error[certain] <= 1.05 * first.state_error[certain]
    assert np.all(smaller)
    assert np.median(shots.state_error[certain, 0] / first.state_error[certain, 0]) < 0.9


def test_each_of_the_fields_is_the_same_alone_and_with_a_log(
    simulate: Simulate, first: ResultArrays
) -> None:
    states = STATES[loose(first)]
    wanted = simulate(states, fields=PATH + BOUNDS, record=True)
    plain = simulate(states, fields=("outcome",), record=True)
    for name in plain.events.dtype.names or ():
        assert wanted.events[name].tobytes() == plain.events[name].tobytes()
    for name in BOUNDS:
        alone = getattr(simulate(states, fields=(name,)), name)
        assert alone.tobytes() == getattr(wanted, name).tobytes(), name


def test_there_may_be_more_of_them_than_a_list_has_room_for(
    simulate: Simulate, first: ResultArrays
) -> None:
    some = STATES[loose(first)][:40]
    one = simulate(some, fields=PATH + BOUNDS)
    many = simulate(np.tile(some, (700, 1)), fields=PATH + BOUNDS)
    assert 0 < np.count_nonzero(one.uncertain) < len(some)
    for name in PATH + BOUNDS:
        wanted = np.concatenate([getattr(one, name)] * 700)
        assert getattr(many, name).tobytes() == wanted.tobytes(), name


def test_shots_with_parameters_and_surfaces_of_their_own_are_simulated_again_with_these(
    simulate: Simulate,
) -> None:
    log = hoopgen.simulate(SHOTS["W4"], record=True).events
    log = log[(log["surface"] < len(hoopgen.SURFACES)) & (log["kind"] == hoopgen.Event.IMPACT)]
    log = log[:: max(1, len(log) // 2000)]
    restitution = np.linspace(0.5, 0.7, len(log))
    given = log["after"], {**PAPER, "restitution": restitution}
    options = {"leaving": log["surface"], "fields": PATH + BOUNDS}
    wanted = hoopgen.simulate(*given, **options, backend="numpy")
    shots = simulate(*given, **options)
    assert np.any(wanted.uncertain & (wanted.outcome != Outcome.CAPPED))
    for name in PATH + BOUNDS:
        assert getattr(shots, name).tobytes() == getattr(wanted, name).tobytes(), name
