"""Parameters, results and trajectories: what a user holds in hand, and what the README shows."""

from __future__ import annotations

import contextlib
import copy
import io
import json
import math
import pickle
import re
import shlex
import sys
from collections.abc import Mapping
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner
from numpy.typing import NDArray

import hoopgen
from hoopgen import FIBA, NBA, PAPER, Outcome
from hoopgen.cli import main
from hoopgen.text.html import table
from tests.helpers import ROOT
from tests.helpers.engines import Simulate

README = ROOT / "README.md"
EPS = float(np.finfo(np.float64).eps)
FIGURE_7 = [4.191, 0.0, -0.6096, -4.4997624, 0.0, 5.5769256, 0.0, 6 * math.pi, 0.0]
NAMES = (
    *("ball_radius", "ring_radius", "wire_radius", "board_distance", "board_half_width"),
    *("board_bottom", "board_top", "bridge_half_width", "restitution", "gravity", "end_depth"),
)

# ------------------------------------------------------------------------------------- parameters


@pytest.mark.parametrize("preset", [PAPER, NBA, FIBA], ids=["PAPER", "NBA", "FIBA"])
class TestPresets:
    def test_they_have_every_parameter_in_the_order_documented(
        self, preset: Mapping[str, float]
    ) -> None:
        assert tuple(preset) == NAMES

    def test_what_they_share(self, preset: Mapping[str, float]) -> None:
        assert preset["gravity"] == 9.81
        assert preset["restitution"] == 0.70
        assert preset["bridge_half_width"] == 0.0762
        # A product of two rounded numbers, and the same number in decimals.
        assert abs(preset["end_depth"] - 0.2 * preset["ball_radius"]) <= EPS * preset["end_depth"]

    def test_the_boards_lower_edge_is_15_cm_below_the_rings_top(
        self, preset: Mapping[str, float]
    ) -> None:
        below = preset["wire_radius"] - preset["board_bottom"]
        assert abs(below - 0.15) <= 2 * EPS

    def test_they_simulate(self, preset: Mapping[str, float]) -> None:
        assert hoopgen.simulate(FIGURE_7, preset).outcome[0] != Outcome.INVALID


@pytest.mark.parametrize(
    ("preset", "ball", "ring", "wire", "board", "width", "height"),
    [
        (PAPER, 0.12128, 0.2350, 0.0100, 0.3810, 1.8288, 1.0668),
        (NBA, 0.1213, 0.2286 + 0.0079375, 0.0079375, 0.3810, 1.8288, 1.0668),
        (FIBA, 0.1213, 0.2270 + 0.0090, 0.0090, 0.2270 + 0.151, 1.80, 1.05),
    ],
    ids=["PAPER", "NBA", "FIBA"],
)
def test_presets_are_the_hoops_of_their_rule_books(
    preset: Mapping[str, float],
    ball: float,
    ring: float,
    wire: float,
    board: float,
    width: float,
    height: float,
) -> None:
    assert preset["ball_radius"] == ball
    assert preset["ring_radius"] == ring
    assert preset["wire_radius"] == wire
    # A sum of two rounded numbers.
    assert abs(preset["board_distance"] - board) <= EPS * board
    assert preset["board_half_width"] == width / 2
    assert abs(preset["board_top"] - preset["board_bottom"] - height) <= 2 * EPS * height


def test_a_30_inch_ball_and_an_18_inch_ring_are_those_of_the_nba() -> None:
    inch = 0.0254
    assert abs(NBA["ball_radius"] - 30 * inch / (2 * math.pi)) < 5e-5  # four decimals
    inside = 2 * (NBA["ring_radius"] - NBA["wire_radius"])
    assert abs(inside - 18 * inch) <= 2 * EPS


def test_parameters_merge_and_the_right_hand_side_wins() -> None:
    merged = NBA | {"restitution": 0.75}
    assert merged["restitution"] == 0.75
    assert {n: v for n, v in merged.items() if n != "restitution"} == {
        n: v for n, v in NBA.items() if n != "restitution"
    }
    assert dict(PAPER) == (NBA | PAPER)
    assert dict({"restitution": 0.1, "own": 1.0} | NBA) == {**NBA, "own": 1.0}
    assert type(merged) is type({"gravity": 1.0} | NBA) is type(NBA)


def test_merging_leaves_both_sides_alone() -> None:
    before, change = dict(PAPER), {"gravity": 1.6}
    assert (PAPER | change)["gravity"] == 1.6
    assert dict(PAPER) == before
    assert change == {"gravity": 1.6}
    merged = PAPER
    merged |= {"gravity": 1.6}
    assert PAPER["gravity"] == 9.81
    assert merged["gravity"] == 1.6


def test_presets_are_read_only() -> None:
    with pytest.raises(TypeError):
        PAPER["gravity"] = 1.6  # type: ignore[index]
    with pytest.raises(TypeError):
        del PAPER["gravity"]  # type: ignore[attr-defined]
    for method in ("update", "pop", "clear", "setdefault", "popitem"):
        assert not hasattr(PAPER, method)


def test_presets_are_mappings_that_copy_pickle_and_print() -> None:
    assert len(PAPER) == 11
    assert "gravity" in PAPER
    assert PAPER.get("bounce") is None
    assert {**PAPER} == dict(PAPER) == copy.deepcopy(PAPER) == pickle.loads(pickle.dumps(PAPER))
    assert repr(PAPER).startswith("Parameters({'ball_radius': 0.12128, ")
    with pytest.raises(KeyError):
        PAPER["bounce"]


def test_a_plain_dict_and_a_preset_simulate_alike() -> None:
    got, wanted = hoopgen.simulate(FIGURE_7, dict(NBA)), hoopgen.simulate(FIGURE_7, NBA)
    np.testing.assert_array_equal(got.state, wanted.state)


def test_the_order_of_the_names_does_not_matter() -> None:
    backwards = dict(reversed(list(NBA.items())))
    got, wanted = hoopgen.simulate(FIGURE_7, backwards), hoopgen.simulate(FIGURE_7, NBA)
    np.testing.assert_array_equal(got.state, wanted.state)


# ---------------------------------------------------------------------------------------- results


def test_outcomes_and_surfaces_are_numbered_as_documented() -> None:
    assert [o.name for o in Outcome] == [
        *("MADE", "MISSED", "CAPPED", "SHORT", "INVALID", "LODGED", "ENDLESS")
    ]
    assert [int(o) for o in Outcome] == list(range(7))
    assert hoopgen.SURFACES == ("ring", "backboard", "bridge")


def test_shots_have_a_length_and_say_what_they_hold() -> None:
    shots = hoopgen.simulate([FIGURE_7] * 3, fields=["outcome", "time"])
    assert len(shots) == 3
    assert repr(shots) == "Shots(3 shots: 3 missed; PAPER (the article's))"
    few = hoopgen.simulate(FIGURE_7, hoopgen.NBA, fields=["time", "first"])
    assert repr(few) == "Shots(1 shot: time, first; NBA)"
    assert repr(hoopgen.simulate(np.empty((0, 9)), hoopgen.FIBA)) == "Shots(0 shots; FIBA)"


def test_shots_count_what_became_of_them() -> None:
    states = hoopgen.release(7.17, np.linspace(0.7, 1.0, 50_000), height=2.13, distance=4.19)
    states[0] = np.nan
    shots = hoopgen.simulate(states)
    ended = [int((shots.outcome == one).sum()) for one in Outcome]
    assert ended[0] > 100
    assert ended[1] > 100
    said = f"Shots(50,000 shots: {ended[0]:,} made, {ended[1]:,} missed, "
    assert repr(shots).startswith(said)
    assert "1 invalid" in repr(shots)
    assert "short" not in repr(shots)
    assert shots.uncertain.any()
    capped = shots.uncertain & (shots.outcome == hoopgen.Outcome.CAPPED)
    uncertain = f"{shots.uncertain.sum():,} uncertain ({capped.sum():,} of them capped)"
    assert repr(shots).endswith(f"; {uncertain}; PAPER (the article's))")


def test_made_is_true_for_a_made_shot_though_its_code_is_not() -> None:
    shots = hoopgen.simulate([FIGURE_7, [0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]])
    assert shots.outcome.tolist() == [Outcome.MISSED, Outcome.MADE]
    assert shots.made.dtype == np.bool_
    assert shots.made.tolist() == [False, True]
    assert not shots.outcome[1]  # the trap
    with pytest.raises(AttributeError, match=r"^outcome: not among the fields asked for: time"):
        _ = hoopgen.simulate(FIGURE_7, fields=["time"]).made


def test_tab_completion_shows_the_results_that_there_are() -> None:
    shown = set(dir(hoopgen.simulate(FIGURE_7)))
    assert {"outcome", "made", "contacts", "counts", "first", "time", "state"} <= shown
    assert {"uncertain", "trajectory", "parameters"} <= shown
    assert not {"events", "time_error", "state_error"} & shown
    assert "events" in dir(hoopgen.simulate(FIGURE_7, record=True))
    few = hoopgen.simulate(FIGURE_7, fields=["contacts"])
    assert not {"outcome", "made", "time"} & set(dir(few))
    assert all(hasattr(few, name) for name in dir(few))


def test_shots_know_the_scene_they_were_simulated_in() -> None:
    scene = NBA | {"gravity": np.array([9.81, 1.62])}
    shots = hoopgen.simulate([FIGURE_7] * 2, scene, record=True)
    assert tuple(shots.parameters) == NAMES
    assert shots.trajectory(1).parameters == dict(NBA) | {"gravity": 1.62}
    assert shots.trajectory(-1).outcome == shots.outcome[1]
    again = pickle.loads(pickle.dumps(shots))
    np.testing.assert_array_equal(again.state, shots.state)
    assert again.parameters.keys() == shots.parameters.keys()


def test_a_trajectory_says_what_it_is() -> None:
    shots = hoopgen.simulate(FIGURE_7, record=True)
    assert repr(shots.trajectory(0)) == (
        "Trajectory(1.550 s: release, ring, backboard, end; missed)"
    )
    swirl = [0.2286, -0.94488, -0.6096, -0.8382, 2.1336, 3.85572, 0.0, 0.0, 0.0]
    shots = hoopgen.simulate(swirl, record=True)
    assert "release, ring 9 times, end; missed" in repr(shots.trajectory(0))


# ----------------------------------------------------------------------------------------- tables


def some_shots(**options: Any) -> hoopgen.Shots:
    states = hoopgen.release(7.17, np.linspace(0.85, 0.95, 40), height=2.13, distance=4.19)
    states[3] = np.nan
    return hoopgen.simulate(states, **options)


def test_shots_are_a_table_of_pandas() -> None:
    pytest.importorskip("pandas")
    shots = some_shots(fields=[*hoopgen.HOOP.layout.fields, "state_error"])
    frame = shots.to_pandas()
    assert len(frame) == 40
    assert frame.index.name == "shot"
    assert list(frame.outcome) == [Outcome(code).name.lower() for code in shots.outcome]
    assert list(frame["first"].cat.codes) == shots.first.tolist()
    np.testing.assert_array_equal(frame[["x_m", "y_m", "z_m"]], shots.state[:, :3])
    np.testing.assert_array_equal(frame["backboard_contacts"], shots.counts[:, 1])
    np.testing.assert_array_equal(frame["spin_error_rad_s"], shots.state_error[:, 2])
    assert {"time_s", "vx_m_s", "wz_rad_s"} <= {*frame}
    assert list(some_shots(fields=["time"]).to_pandas()) == ["time_s"]


def test_shots_are_a_dataset_of_xarray() -> None:
    pytest.importorskip("xarray")
    gravity = np.linspace(9.7, 9.9, 40)
    dataset = some_shots(parameters=PAPER | {"gravity": gravity}).to_xarray()
    shots = some_shots(parameters=PAPER | {"gravity": gravity})
    assert dict(dataset.sizes) == {"shot": 40, "surface": 3, "component": 9}
    np.testing.assert_array_equal(dataset["state"].sel(component="vz"), shots.state[:, 5])
    np.testing.assert_array_equal(dataset["counts"].sel(surface="bridge"), shots.counts[:, 2])
    np.testing.assert_array_equal(dataset["gravity"], gravity)
    for name, codes in (("outcome", shots.outcome), ("first", shots.first)):
        told = dataset[name].attrs
        assert len(told["flag_meanings"].split()) == len(told["flag_values"])
        assert set(codes.tolist()) <= set(told["flag_values"].tolist())
    assert json.loads(dataset.attrs["parameters"])["restitution"] == 0.7


def test_contacts_are_a_table_of_pandas() -> None:
    pytest.importorskip("pandas")
    path = hoopgen.simulate(FIGURE_7, record=True).trajectory(0)
    frame = path.to_pandas()
    assert list(frame.surface) == ["ring", "backboard", "end"]
    np.testing.assert_array_equal(frame.time_s, path.events["time"])
    np.testing.assert_array_equal(frame[["x_m", "y_m", "z_m"]], path.events["before"][:, :3])
    np.testing.assert_array_equal(frame.after_wz_rad_s, path.events["after"][:, 8])


@pytest.mark.parametrize("missing", ["pandas", "xarray"])
def test_a_table_that_cannot_be_made_says_what_is_missing(
    missing: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, missing, None)
    with pytest.raises(ImportError, match=rf"^to_{missing} needs {missing}: pip install "):
        getattr(some_shots(), f"to_{missing}")()


def test_notebooks_show_shots_and_contacts_as_tables() -> None:
    shots = some_shots(record=True)
    text = shots._repr_html_()
    assert text.count("<tr>") == 1 + 5 + 1 + 5  # head, first ones, a gap, last ones
    assert "<td>invalid</td>" in text
    assert "40 shots: " in text
    text = hoopgen.simulate(FIGURE_7, record=True).trajectory(0)._repr_html_()
    assert text.count("<tr>") == 1 + 1 + 3
    assert "<td>backboard</td>" in text
    assert "<tbody></tbody>" in hoopgen.simulate(np.empty((0, 9)))._repr_html_()


def test_words_in_a_table_are_text() -> None:
    text = table("<b>&", ["<i>"], [["<script>alert(1)</script>"]])
    assert "<script" not in text
    assert "<b>" not in text
    assert "&lt;b&gt;&amp;" in text
    assert "<i>" not in text


def test_what_was_not_asked_for_says_how_to_get_it() -> None:
    shots = hoopgen.simulate(FIGURE_7, fields=["outcome"])
    with pytest.raises(AttributeError, match=r"^time: not among the fields asked for: outcome"):
        shots.time  # noqa: B018
    with pytest.raises(AttributeError, match=r"^events: simulate with record=True"):
        shots.events  # noqa: B018
    with pytest.raises(AttributeError, match=r"^events: simulate with record=True"):
        shots.trajectory(0)
    with pytest.raises(AttributeError, match="has no attribute 'colour'"):
        shots.colour  # noqa: B018
    assert not hasattr(shots, "state")


def test_shots_pickle_and_copy() -> None:
    shots = hoopgen.simulate([FIGURE_7] * 2, record=True)
    for same in (pickle.loads(pickle.dumps(shots)), copy.deepcopy(shots), copy.copy(shots)):
        np.testing.assert_array_equal(same.state, shots.state)
        np.testing.assert_array_equal(same.trajectory(1).events, shots.trajectory(1).events)


# ----------------------------------------------------------------------------------- trajectories

SHOTS = [
    [1.0, 0.0, 1.0, 0.0, 0.5, 2.0, 1.0, 2.0, 3.0],  # touches nothing
    FIGURE_7,
    [np.nan] * 9,
    [0.2286, -0.94488, -0.6096, -0.8382, 2.1336, 3.85572, 0.0, 0.0, 0.0],  # swirls
    [1.0, 0.0, -0.5, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0],  # short, no event
]


@pytest.fixture(scope="module")
def shots(simulate: Simulate) -> hoopgen.Shots:
    return simulate(SHOTS, PAPER | {"gravity": [9.81, 9.81, 9.81, 9.81, 1.6]}, record=True)


def flown(state: NDArray[np.float64], t: float, gravity: float = 9.81) -> NDArray[np.float64]:
    """Give Eq. 3."""
    there = state.copy()
    there[:3] += state[3:6] * t
    there[2] -= gravity * t * t / 2
    there[5] -= gravity * t
    return there


def test_a_trajectory_holds_its_shots_events_and_release(shots: hoopgen.Shots) -> None:
    for row in (0, 1, 3, 4):
        path = shots.trajectory(row)
        assert np.all(path.events["shot"] == row)
        np.testing.assert_array_equal(path.release, SHOTS[row])
        np.testing.assert_array_equal(path.events, shots.events[shots.events["shot"] == row])
        assert path.duration == shots.time[row]
        assert isinstance(path.duration, float)
    assert [shots.trajectory(row).parameters["gravity"] for row in (1, 4)] == [9.81, 1.6]


def test_rows_count_from_the_end_too_and_stop_at_the_last(shots: hoopgen.Shots) -> None:
    np.testing.assert_array_equal(shots.trajectory(-2).events, shots.trajectory(3).events)
    np.testing.assert_array_equal(shots.trajectory(np.int64(1)).release, FIGURE_7)
    for row in (5, -6, 100):
        with pytest.raises(IndexError, match=f"^shot: expected a shot from -5 to 4, got {row}"):
            shots.trajectory(row)


@pytest.mark.parametrize("shape", [(), (1,), (4,), (2, 3), (0,), (2, 0, 3)])
def test_states_have_the_shape_of_the_times(shots: hoopgen.Shots, shape: tuple[int, ...]) -> None:
    path = shots.trajectory(1)
    times = np.linspace(0.0, path.duration, int(np.prod(shape))).reshape(shape)
    states = path.at(times)
    assert states.shape == (*shape, 9)
    assert states.dtype == np.float64
    for index in np.ndindex(shape):
        np.testing.assert_array_equal(states[index], path.at(float(times[index])))


def test_times_may_be_lists_in_any_order(shots: hoopgen.Shots) -> None:
    path = shots.trajectory(1)
    times = [1.2, 0.1, 0.1, 0.99]
    np.testing.assert_array_equal(path.at(times), [path.at(t) for t in times])


def test_at_0_it_is_the_release(shots: hoopgen.Shots) -> None:
    for row in (0, 1, 3, 4):
        np.testing.assert_array_equal(shots.trajectory(row).at(0), SHOTS[row])


def test_at_a_contact_it_is_the_state_after_it(shots: hoopgen.Shots) -> None:
    for row in (0, 1, 3):
        events = shots.trajectory(row).events
        np.testing.assert_array_equal(shots.trajectory(row).at(events["time"]), events["after"])
    path = shots.trajectory(1)
    np.testing.assert_array_equal(path.at(path.duration), shots.state[1])


def test_just_before_a_contact_it_is_the_state_before_it(shots: hoopgen.Shots) -> None:
    path = shots.trajectory(1)
    for event in path.events:
        earlier = path.at(np.nextafter(event["time"], 0.0))
        # An eps of time earlier, and a few roundings.
        speed, size = np.abs(event["before"][3:6]).max(), np.abs(event["before"][:3]).max()
        limit = 4 * EPS * (size + (speed + 9.81) * event["time"])
        assert np.all(np.abs(earlier - event["before"])[:6] <= limit)
        np.testing.assert_array_equal(earlier[6:], event["before"][6:])


@pytest.mark.sampled(4)
def test_the_path_is_continuous_the_velocity_jumps_at_contacts_only(shots: hoopgen.Shots) -> None:
    for row in (1, 3):
        path = shots.trajectory(row)
        times = np.linspace(0.0, path.duration, 4001)
        states = path.at(times)
        step = times[1]
        fastest = np.abs(states[:, 3:6]).max() + 9.81 * step
        assert np.abs(np.diff(states[:, :3], axis=0)).max() <= fastest * step
        jumps = np.abs(np.diff(states[:, 3:5], axis=0)).max(axis=1) > 0.0
        contacts = path.events["time"][:-1]
        between = [np.any((contacts > a) & (contacts <= b)) for a, b in pairwise(times)]
        np.testing.assert_array_equal(jumps, between)


def test_between_events_it_is_equation_3(shots: hoopgen.Shots) -> None:
    path = shots.trajectory(1)
    ring, backboard, _ = path.events
    for origin, start, t in (
        (path.release, 0.0, 0.7),
        (ring["after"], ring["time"], (ring["time"] + backboard["time"]) / 2),
        (backboard["after"], backboard["time"], 1.3),
    ):
        wanted = flown(origin, t - start)
        np.testing.assert_allclose(path.at(t), wanted, rtol=8 * EPS, atol=8 * EPS)


@pytest.mark.parametrize("t", [-1e-300, -1.0, 1e9, np.nan, np.inf, [0.0, -0.1], [[0.1, np.nan]]])
def test_a_time_off_the_path_is_an_error_that_tells_the_range(shots: hoopgen.Shots, t: Any) -> None:
    path = shots.trajectory(1)
    with pytest.raises(ValueError, match=r"^t: expected times from 0 to ") as error:
        path.at(t)
    assert f"{path.duration} s, got {t!r}" in str(error.value)


def test_the_last_instant_is_on_the_path_and_the_next_is_not(shots: hoopgen.Shots) -> None:
    path = shots.trajectory(1)
    path.at(path.duration)
    with pytest.raises(ValueError, match=r"^t: expected times"):
        path.at(np.nextafter(path.duration, 9.0))


def test_a_shot_without_events_is_where_it_was_released(shots: hoopgen.Shots) -> None:
    for row in (2, 4):
        path = shots.trajectory(row)
        assert path.duration == 0.0
        assert len(path.events) == 0
        np.testing.assert_array_equal(path.at(0.0), SHOTS[row])


def test_a_trajectory_is_frozen(shots: hoopgen.Shots) -> None:
    with pytest.raises(AttributeError):
        shots.trajectory(1).outcome = None  # type: ignore[misc]


def test_each_shots_own_gravity_bends_its_path(simulate: Simulate) -> None:
    moon = simulate([SHOTS[0]] * 2, PAPER | {"gravity": [9.81, 1.62]}, record=True)
    for row, gravity in ((0, 9.81), (1, 1.62)):
        got = moon.trajectory(row).at(0.3)
        np.testing.assert_allclose(
            got, flown(np.array(SHOTS[0]), 0.3, gravity), rtol=4 * EPS, atol=0
        )


# ----------------------------------------------------------------------------------------- README


@pytest.mark.slow
def test_the_python_of_the_readme_prints_what_the_readme_says() -> None:
    shown = re.findall(r"```python\n(.*?)```\n\n```text\n(.*?)```", README.read_text("utf-8"), re.S)
    assert len(shown) == 3
    names: dict[str, Any] = {}
    for code, output in shown:
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            exec(code, names)
        assert printed.getvalue() == output


def test_the_commands_of_the_readme_print_what_the_readme_says() -> None:
    shown = re.findall(r"```console\n\$ hoopgen (.*?)\n(.*?)```", README.read_text("utf-8"), re.S)
    assert shown
    for arguments, output in shown:
        assert CliRunner().invoke(main, shlex.split(arguments)).stdout == output


@pytest.mark.parametrize("name", ["PAPER", "NBA", "FIBA"])
def test_the_presets_of_the_readme_are_the_presets(name: str) -> None:
    row = re.search(rf"^\| `{name}` \| (.*) \|$", README.read_text("utf-8"), re.M)
    assert row is not None
    told = [float(cell.removesuffix(" m")) for cell in row[1].split(" | ")]
    keys = ("ball_radius", "ring_radius", "wire_radius", "board_distance", "restitution")
    # Sums of two rounded numbers.
    wanted = [getattr(hoopgen, name)[key] for key in keys]
    np.testing.assert_allclose(told, wanted, rtol=EPS, atol=0)


def test_files_that_the_readme_links_to_exist() -> None:
    links = re.findall(r"\]\(([^):#]+)\)", README.read_text("utf-8"))
    assert [link for link in links if not (README.parent / link).exists()] == []
