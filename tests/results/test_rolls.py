"""Balls that roll: where they are in contact, and how texts, pictures and pages say so."""

from __future__ import annotations

import json
import pickle

import numpy as np
import pytest
from numpy.typing import NDArray

import hoopgen
from hoopgen import COURT, PAPER_COURT, Event
from tests.helpers.reaching import soft_throws

Floats = NDArray[np.float64]

SOFT = PAPER_COURT | {"ring_restitution": 0.3}

pytestmark = pytest.mark.xdist_group("court")


@pytest.fixture(scope="module")
def shots() -> hoopgen.Shots:
    states = soft_throws()
    return hoopgen.simulate(states, SOFT, scene=COURT, record=True)


@pytest.fixture(scope="module")
def rolling(shots: hoopgen.Shots) -> list[int]:
    """Shots that roll, and then leave the ring."""
    found = np.unique(shots.events["shot"][shots.events["kind"] == Event.LEAVE]).tolist()
    assert len(found) > 3
    return found


# The path


def test_a_roll_is_followed_to_where_the_engine_has_it(shots: hoopgen.Shots) -> None:
    rolled = 0
    for shot in range(len(shots)):
        path = shots.trajectory(shot)
        for row, start, stop in path.rolls:
            rolled += 1
            np.testing.assert_array_equal(path.at(start), path.events["after"][row])
            last = path.at(np.nextafter(stop, 0.0))
            np.testing.assert_allclose(last, path.events["before"][row + 1], rtol=0, atol=1e-9)
    assert rolled > 10


def test_in_contact_the_ball_lies_on_the_ring_and_does_not_slip(
    shots: hoopgen.Shots, rolling: list[int]
) -> None:
    reach = SOFT["ball_radius"] + SOFT["wire_radius"]
    for shot in rolling:
        path = shots.trajectory(shot)
        ((_, start, stop), *_) = path.rolls
        states = path.at(np.linspace(start, stop, 50, endpoint=False))
        place, velocity, spin = states[:, :3], states[:, 3:6], states[:, 6:]
        wire = place * [1, 1, 0]
        wire *= SOFT["ring_radius"] / np.linalg.norm(wire, axis=1, keepdims=True)
        arm = place - wire
        np.testing.assert_allclose(np.linalg.norm(arm, axis=1), reach, rtol=1e-12)
        touch = velocity - np.cross(spin, SOFT["ball_radius"] / reach * arm)
        np.testing.assert_allclose(touch, 0.0, atol=1e-12)


def test_energy_is_kept_in_contact(shots: hoopgen.Shots, rolling: list[int]) -> None:
    path = shots.trajectory(rolling[0])
    ((_, start, stop), *_) = path.rolls
    states = path.at(np.linspace(start, stop, 50, endpoint=False))
    turning = 2.0 / 3.0 * SOFT["ball_radius"] ** 2 * (states[:, 6:] ** 2).sum(axis=1)
    energy = ((states[:, 3:6] ** 2).sum(axis=1) + turning) / 2.0 + SOFT["gravity"] * states[:, 2]
    np.testing.assert_allclose(energy, energy[0], rtol=0, atol=1e-9)


def test_positions_velocities_and_times_belong_together(
    shots: hoopgen.Shots, rolling: list[int]
) -> None:
    path = shots.trajectory(rolling[0])
    ((_, start, stop), *_) = path.rolls
    middle, step = (start + stop) / 2.0, 1e-5
    before, there, after = path.at([middle - step, middle, middle + step])
    np.testing.assert_allclose((after - before)[:3] / (2.0 * step), there[3:6], atol=1e-6)


@pytest.mark.slow
def test_on_the_bridge_rolls_stop_at_its_seams() -> None:
    # Dropped onto the plate: it rolls over its edges, against the board or onto the ring.
    random = np.random.default_rng(3)
    states = np.zeros((300, 9))
    away = [0.06, 0.16, 0.16, 0.5, 0.5, 0.5] * random.uniform(-1.0, 1.0, (300, 6))
    states[:, :6] = [-0.2, 0.0, 0.3, 0.0, 0.0, 0.0] + away
    soft = PAPER_COURT | {f"{name}_restitution": 0.2 for name in COURT.surfaces}
    flown = hoopgen.simulate(states, soft, scene=COURT, record=True)
    rolled = 0
    for shot in range(len(flown)):
        path = flown.trajectory(shot)
        for row, start, stop in path.rolls:
            event = path.events[row + 1]
            if path.events["surface"][row] != 2 or stop - start > 3.0:
                continue
            rolled += 1
            last = path.at(np.nextafter(stop, 0.0))
            np.testing.assert_allclose(last, event["before"], rtol=0, atol=1e-8)
    assert rolled > 10


def test_a_trajectory_that_was_followed_can_be_sent(
    shots: hoopgen.Shots, rolling: list[int]
) -> None:
    path = shots.trajectory(rolling[0])
    times = np.linspace(0.0, path.duration, 30)
    np.testing.assert_array_equal(pickle.loads(pickle.dumps(path)).at(times), path.at(times))


def test_where_nothing_rolls_nothing_is_followed() -> None:
    states = hoopgen.release(7.17, 0.89, height=2.13, distance=4.19)
    assert hoopgen.simulate(states, record=True).trajectory(0).rolls == []


def test_a_shot_goes_on_from_where_contact_begins(shots: hoopgen.Shots, rolling: list[int]) -> None:
    for shot in rolling[:3]:
        path = shots.trajectory(shot)
        ((row, start, _), *_) = path.rolls
        event = path.events[row]
        on = hoopgen.simulate(event["after"], SOFT, scene=COURT, leaving=int(event["surface"]))
        assert on.outcome[0] == shots.outcome[shot]
        assert start + on.time[0] == pytest.approx(shots.time[shot], rel=0, abs=1e-9)


# In words


def test_the_kinds_of_events_are_public() -> None:
    assert [(one.name, int(one)) for one in Event] == [
        ("IMPACT", 0),
        ("ROLL", 1),
        ("LEAVE", 2),
        ("END", 3),
    ]
    assert all(COURT.kernels.Event[one.name] == one for one in Event)


def test_a_trajectory_says_that_it_rolls(shots: hoopgen.Shots, rolling: list[int]) -> None:
    said = repr(shots.trajectory(rolling[0]))
    assert "rolls on ring" in said
    assert "leaves" not in said


def test_tables_number_impacts_alone(shots: hoopgen.Shots, rolling: list[int]) -> None:
    path = shots.trajectory(rolling[0])
    contacts = int(shots.contacts[rolling[0]])
    assert contacts == (path.events["kind"] == Event.IMPACT).sum() < len(path.events) - 2
    text = path._repr_html_()
    assert f"<td>{contacts}</td>" in text
    assert f"<td>{contacts + 1}</td>" not in text
    assert "rolls on ring" in text
    pytest.importorskip("pandas")
    frame = path.to_pandas()
    assert list(frame.kind) == [Event(kind).name.lower() for kind in path.events["kind"]]


def test_the_command_tells_a_roll(shots: hoopgen.Shots, rolling: list[int]) -> None:
    from hoopgen.cli.shot import _record, _summary

    one = hoopgen.simulate(shots._states[rolling[:1]], SOFT, scene=COURT, record=True)
    ((_, start, stop),) = one.trajectory(0).rolls
    told = _summary(one, shots._states[rolling[0]])
    assert f"rolls      on the ring from {start:.3f} to {stop:.3f} s" in told
    assert "rolls on ring" in told
    assert "leaves ring" in told
    record = _record(one, shots._states[rolling[0]], SOFT)
    kinds = [event["kind"] for event in record["events"]]
    assert kinds.count("impact") == one.contacts[0]
    assert {"roll", "leave", "end"} < {*kinds}


# In pictures


def test_a_picture_s_path_lies_on_the_ball_s(shots: hoopgen.Shots, rolling: list[int]) -> None:
    pytest.importorskip("matplotlib")
    from hoopgen.plots.fan_paths import bezier

    path = shots.trajectory(rolling[0])
    times, states, rolls = path.pieces(0.01)
    np.testing.assert_allclose(states[rolls], path.at(times[rolls]), rtol=0, atol=1e-12)
    assert rolls.any()
    assert not rolls[-1]
    curve = bezier(path)
    halfway = (curve[:-2:2] + 2.0 * curve[1::2] + curve[2::2]) / 4.0
    wanted = path.at((times[:-1] + times[1:]) / 2.0)[:, :3]
    np.testing.assert_allclose(halfway, wanted, rtol=0, atol=2e-5)


def test_marks_say_where_it_rolls_and_number_impacts(
    shots: hoopgen.Shots, rolling: list[int]
) -> None:
    pytest.importorskip("matplotlib")
    from hoopgen.plots.contact_marks import collect_marks

    path = shots.trajectory(rolling[0])
    ((_, start, stop),) = path.rolls
    bodies = dict.fromkeys(COURT.surfaces, "black")
    marks = collect_marks(path.release[:3], path.events, 0.12, path.outcome, bodies)
    assert [mark.text for mark in marks if mark.label == "rolls"] == [
        f"ring {start:.3f}\N{EN DASH}{stop:.3f} s"
    ]
    assert [mark.text for mark in marks if mark.label == "leaves"] == [f"ring {stop:.3f} s"]
    numbers = [mark.label for mark in marks if mark.label[0].isdigit()]
    assert numbers[-1].rpartition("\N{EN DASH}")[2] == str(shots.contacts[rolling[0]])
    assert marks[-1].label == "end"


def test_the_page_has_the_roll_in_pieces(shots: hoopgen.Shots, rolling: list[int]) -> None:
    pytest.importorskip("matplotlib")
    from hoopgen.viewer import page

    one = hoopgen.simulate(shots._states[rolling[:1]], SOFT, scene=COURT, record=True)
    path = one.trajectory(0)
    data = page(one, SOFT).partition('id="data">')[2].partition("</script>")[0]
    (shot,) = json.loads(data)["shots"]
    ((first, end),) = shot["rolls"]
    ((_, start, stop),) = path.rolls
    assert shot["flights"][first][0] == start
    assert shot["flights"][end][0] == stop
    assert [event["kind"] for event in shot["events"]].count("roll") == 1
    assert max(event["number"] for event in shot["events"]) == one.contacts[0]
