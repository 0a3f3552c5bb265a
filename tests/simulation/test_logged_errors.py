"""The bounds on errors in the event log: of the time of each event, and of the state after it."""

from __future__ import annotations

import numpy as np
import pytest

import hoopgen
from benchmarks.families import FAMILIES
from hoopgen import COURT, HOOP, Event, Outcome
from tests.helpers.engines import Simulate

BOUNDS = ("time_error", "state_error")
KEYS = ("W2", "W3", "W4", "grazing", "seam", "rim", "hoops")
SHOTS = {family.key: family.make(400) for family in FAMILIES if family.key in KEYS}
PLAIN = ("shot", "surface", "time", "before", "after", "kind")


@pytest.mark.parametrize("key", SHOTS)
def test_all_engines_log_the_same(simulate: Simulate, key: str) -> None:
    states, parameters = SHOTS[key]
    fields = ("outcome", "uncertain", *BOUNDS)
    wanted = hoopgen.simulate(states, parameters, fields=fields, record=True, backend="numpy")
    shots = simulate(states, parameters, fields=fields, record=True)
    assert shots.events.tobytes() == wanted.events.tobytes()
    # The log changes nothing else, and the end of a shot has the bounds of the shot.
    alone = simulate(states, parameters, fields=fields)
    for name in fields:
        assert getattr(shots, name).tobytes() == getattr(alone, name).tobytes(), name
    plain = simulate(states, parameters, record=True).events
    assert plain.dtype.names == PLAIN
    assert all(shots.events[name].tobytes() == plain[name].tobytes() for name in PLAIN)
    ends = shots.events[shots.events["kind"] == Event.END]
    assert len(ends) > 10
    for name in BOUNDS:
        assert np.array_equal(ends[name], getattr(shots, name)[ends["shot"]], equal_nan=True)


def test_the_log_has_those_that_are_requested() -> None:
    states, parameters = SHOTS["W2"]
    both = hoopgen.simulate(states, parameters, fields=BOUNDS, record=True).events
    assert both.dtype.names == (*PLAIN, *BOUNDS)
    for name in BOUNDS:
        own = hoopgen.simulate(states, parameters, fields=(name,), record=True).events
        assert own.dtype.names == (*PLAIN, name)
        assert own[name].tobytes() == both[name].tobytes()
    none = hoopgen.simulate(np.empty((0, 9)), fields=("state_error",), record=True).events
    assert (len(none), none.dtype.names) == (0, (*PLAIN, "state_error"))


def test_a_contact_has_the_bounds_of_a_shot_that_is_capped_there() -> None:
    """Shots that are simulated twice have tighter ones at each contact."""
    states, parameters = SHOTS["W4"]
    fields = ("outcome", "uncertain", *BOUNDS)
    shots = hoopgen.simulate(states, parameters, fields=fields, record=True)
    impacts = shots.events[shots.events["kind"] == Event.IMPACT]
    number = np.arange(len(impacts)) - np.searchsorted(impacts["shot"], impacts["shot"])
    tighter = same = 0
    for count in (1, 2, 3, 8, 15):
        rows = impacts[number == count - 1]
        capped = hoopgen.simulate(states, parameters, fields=fields, max_contacts=count)
        for name in BOUNDS:
            ours, theirs = rows[name], getattr(capped, name)[rows["shot"]]
            finite = np.isfinite(theirs)
            assert np.all(ours[finite] <= 1.05 * theirs[finite])
            same += np.count_nonzero(ours == theirs)
            tighter += np.count_nonzero(ours < theirs)
    assert same > 1000
    assert tighter > 20


@pytest.mark.parametrize("scene", [HOOP, COURT], ids=str)
def test_the_judge_finds_no_larger_error(scene: hoopgen.Engine) -> None:
    pytest.importorskip("flint")
    states = np.concatenate([SHOTS["W2"][0][:60], SHOTS["W4"][0][:20]])
    fields = ("outcome", "uncertain", *BOUNDS)
    shots = hoopgen.simulate(states, scene=scene, fields=fields, record=True)
    proof = hoopgen.certify(states, scene=scene, record=True)
    found = proof.event_errors(shots)
    sure = ~shots.uncertain[shots.events["shot"]] & np.isfinite(found["time_error"])
    assert np.count_nonzero(sure) > 150
    log, found = shots.events[sure], found[sure]
    assert np.all(found["time_error"] <= log["time_error"])
    assert np.all(found["after_error"] <= log["state_error"])
    # They say something: no bound is a hundred thousand times the error of all of them.
    late = found["after_error"].max(axis=0) > 1e-5 * log["state_error"].max(axis=0)
    assert np.all(late)


def test_a_log_that_had_to_grow_has_them_for_all_its_rows() -> None:
    states, parameters = SHOTS["rim"][0][:30], hoopgen.PAPER_COURT
    options = {"scene": COURT, "record": True, "fields": BOUNDS}
    log = hoopgen.simulate(states, parameters, **options).events
    assert np.bincount(log["shot"]).max() > 60
    slow = hoopgen.simulate(states, parameters, **options, backend="numpy", threads=2).events
    assert log.tobytes() == slow.tobytes()
    assert np.all(log["time_error"] > 0)
    for shot in range(len(states)):
        assert np.all(np.diff(log["time_error"][log["shot"] == shot]) >= 0)


def test_events_of_settled_shots_are_off_by_a_rounding() -> None:
    pytest.importorskip("flint")
    states, _ = SHOTS["grazing"]
    fields = ("outcome", "uncertain", *BOUNDS)
    before = hoopgen.simulate(states[:60], fields=fields, record=True)
    after = hoopgen.simulate(states[:60], fields=fields, record=True, settle=True)
    settled = before.uncertain & ~after.uncertain
    assert np.count_nonzero(settled) > 5
    again = settled[after.events["shot"]]
    assert np.all(after.events["time_error"][again] < 1e-14)
    assert np.all(after.events["state_error"][again] < 1e-13)
    assert np.all(after.events["state_error"][again, 1] > 0)
    assert np.array_equal(after.events[~again], before.events[~settled[before.events["shot"]]])


def test_they_are_columns_of_tables_of_events() -> None:
    pytest.importorskip("pandas")
    shots = hoopgen.simulate(SHOTS["W2"][0][:5], fields=("outcome", *BOUNDS), record=True)
    frame = shots.events_to_pandas()
    names = ["time_error_s", "position_error_m", "velocity_error_m_s", "spin_error_rad_s"]
    assert [name for name in frame.columns if "error" in name] == names
    assert frame["time_error_s"].tolist() == shots.events["time_error"].tolist()
    assert frame[names[1:]].to_numpy().tolist() == shots.events["state_error"].tolist()
    assert Outcome.MADE in shots.outcome
