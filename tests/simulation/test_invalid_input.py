"""Input that is wrong, odd or missing: one bad row harms no other, and errors say what to do."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pyarrow as pa
import pytest

import hoopgen
from hoopgen import PAPER, Outcome
from hoopgen.core.parameters import AIR_DEFAULTS, OF_COURT
from hoopgen.engine import native
from hoopgen.simulation import backend_choice
from hoopgen.simulation.hoop import HOOP, hoop_library
from tests.helpers.engines import Simulate
from tests.helpers.hoop_shots import Batch

FIELDS = ("outcome", "contacts", "counts", "first", "time", "state", "uncertain")
NAMES = tuple(PAPER)
STATE = ("x", "y", "z", "vx", "vy", "vz", "wx", "wy", "wz")
FREE_THROW = hoopgen.release(7.166, 0.892, height=2.4384, distance=4.191, backspin=19.0)


def neighbours(count: int) -> Batch:
    """Give free throws, the parameters one per shot."""
    random = np.random.default_rng(5)
    states = np.tile(FREE_THROW, (count, 1))
    states[:, 3:6] *= 1 + 0.01 * random.standard_normal((count, 3))
    return Batch(states, {name: np.full(count, value) for name, value in PAPER.items()})


def assert_only_one_is_invalid(simulate: Simulate, batch: Batch, bad: int) -> None:
    """Check the INVALID row, and that all others are as if it were not there."""
    shots = simulate(batch.states, batch.parameters, record=True)
    assert shots.outcome[bad] == Outcome.INVALID
    assert np.isnan(shots.time[bad])
    assert np.all(np.isnan(shots.state[bad]))
    assert shots.contacts[bad] == 0
    assert shots.counts[bad].tolist() == [0, 0, 0]
    assert shots.first[bad] == -1
    assert not np.any(shots.events["shot"] == bad)

    others = np.delete(np.arange(len(batch)), bad)
    rest = batch.take(others)
    wanted = simulate(rest.states, rest.parameters, record=True)
    assert not np.any(wanted.outcome == Outcome.INVALID)
    for name in FIELDS:
        np.testing.assert_array_equal(getattr(shots, name)[others], getattr(wanted, name))
    np.testing.assert_array_equal(shots.events["shot"], others[wanted.events["shot"]])
    for name in ("surface", "time", "before", "after"):
        np.testing.assert_array_equal(shots.events[name], wanted.events[name])


# ----------------------------------------------------------------------------------- INVALID rows


@pytest.mark.sampled(63)
@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf])
@pytest.mark.parametrize("column", STATE)
def test_a_state_that_is_not_finite_is_invalid(simulate: Simulate, column: str, bad: float) -> None:
    batch = neighbours(11)
    batch.states[4, STATE.index(column)] = bad
    assert_only_one_is_invalid(simulate, batch, 4)


@pytest.mark.sampled(70)
@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf])
@pytest.mark.parametrize("name", NAMES)
def test_a_parameter_that_is_not_finite_is_invalid(
    simulate: Simulate, name: str, bad: float
) -> None:
    batch = neighbours(11)
    batch.parameters[name][7] = bad
    assert_only_one_is_invalid(simulate, batch, 7)


@pytest.mark.sampled(70)
@pytest.mark.parametrize("bad", [0.0, -0.0, -0.1, -5e-324])
@pytest.mark.parametrize(
    "name", [n for n in NAMES if n not in ("restitution", "board_bottom", "board_top")]
)
def test_a_size_or_gravity_that_is_not_above_zero_is_invalid(
    simulate: Simulate, name: str, bad: float
) -> None:
    batch = neighbours(11)
    batch.parameters[name][0] = bad
    assert_only_one_is_invalid(simulate, batch, 0)


@pytest.mark.parametrize("bad", [-5e-324, -0.5, np.nextafter(1.0, 2.0), 7.0])
def test_a_restitution_outside_0_to_1_is_invalid(simulate: Simulate, bad: float) -> None:
    batch = neighbours(11)
    batch.parameters["restitution"][10] = bad
    assert_only_one_is_invalid(simulate, batch, 10)


@pytest.mark.parametrize("value", [0.0, -0.0, 1.0])
def test_restitutions_0_and_1_are_allowed(simulate: Simulate, value: float) -> None:
    assert simulate(FREE_THROW, PAPER | {"restitution": value}).outcome[0] != Outcome.INVALID
    both = simulate([FREE_THROW, FREE_THROW], PAPER | {"restitution": [0.7, value]})
    assert not np.any(both.outcome == Outcome.INVALID)


@pytest.mark.parametrize(
    "change",
    [
        {"ball_radius": 0.225},  # R = R_H in exact arithmetic, and in doubles
        {"ball_radius": 0.3},
        {"wire_radius": 0.2},
        {"ring_radius": 0.12},
        {"ball_radius": 1e200},
    ],
)
def test_a_ball_too_big_for_the_ring_is_invalid(
    simulate: Simulate, change: dict[str, float]
) -> None:
    batch = neighbours(11)
    for name, value in change.items():
        batch.parameters[name][5] = value
    assert_only_one_is_invalid(simulate, batch, 5)


@pytest.mark.sampled(60)
@pytest.mark.parametrize(
    "place",
    [
        (0.235, 0.0, 0.0),  # the wire's centre
        (0.235, 0.0, 0.13),  # on top of the ring, a millimetre deep
        (0.0, -0.11, 0.01),  # in the hole, against the wire
        (-0.30, 0.5, 0.4),  # in the board, from in front
        (-0.45, -0.5, 0.4),  # in the board, from behind
        (-0.381, 0.0, 0.9),  # its middle
        (-0.25, 0.0, 0.10),  # in the bridge, from above
        (-0.25, 0.07, -0.10),  # in the bridge, from below
    ],
)
@pytest.mark.parametrize("speed", [0.0, 5.0, -5.0])
def test_a_ball_that_starts_inside_a_surface_is_invalid(
    simulate: Simulate, place: tuple[float, ...], speed: float
) -> None:
    batch = neighbours(11)
    batch.states[3] = [*place, speed, -speed, speed, 0.0, 0.0, 0.0]
    assert_only_one_is_invalid(simulate, batch, 3)


def against_the_board(gap: float) -> list[float]:
    """Return a ball so far from the middle of the board, by its own radius, that moves off it."""
    x = PAPER["ball_radius"] * (1 + gap) - PAPER["board_distance"]
    return [x, 0.0, 0.6, 1.0, 0.5, 2.0, 0.0, 0.0, 0.0]


@pytest.mark.parametrize("backend", ["auto", "numpy"])
@pytest.mark.parametrize(
    ("gap", "said"),
    [
        (8.0, "away from"),
        (2e-3, "away from"),
        (5e-4, ""),
        (-1e-12, ""),
        (-5e-4, ""),
        (-2e-3, "inside"),
        (-0.5, "inside"),
    ],
)
def test_a_ball_does_not_leave_a_body_that_it_does_not_touch(
    gap: float, said: str, backend: Any
) -> None:
    """Up to 1/1024 of its radius it touches it, whatever the last digits of its place say."""
    states = np.array([FREE_THROW, against_the_board(gap), against_the_board(0.0)])
    leaving = np.array([-1, 1, 1], np.int8)
    shots = hoopgen.simulate(states, leaving=leaving, backend=backend)
    assert (shots.outcome == Outcome.INVALID).tolist() == [False, bool(said), False]
    assert np.isnan(shots.state[1]).all() == bool(said)
    wanted = f"leaving: the ball is {said} the backboard; expected in contact, to 1/1024 of its "
    assert hoopgen.why_invalid(states, leaving=leaving) == [
        "",
        wanted + "radius" if said else "",
        "",
    ]


@pytest.mark.parametrize(
    "place",
    [
        (0.0, 0.0, 0.0),  # in the hole
        (0.235, 0.0, 0.14),  # just above the ring
        (0.235, 0.0, -0.14),  # just below it
        (-0.25, 0.5, 0.4),  # just in front of the board
        (-0.51, 0.5, 0.4),  # just behind it
        (-0.30, 1.0, 0.4),  # beside it: only its flat part counts
        (-0.25, 0.3, 0.0),  # beside ring and bridge
    ],
)
def test_a_ball_that_starts_near_a_surface_is_valid(
    simulate: Simulate, place: tuple[float, ...]
) -> None:
    assert simulate([*place, 0, 0, 0, 0, 0, 0]).outcome[0] != Outcome.INVALID


@pytest.mark.parametrize(
    "change", [{"gravity": -9.81}, {"gravity": np.nan}, {"ring_radius": 0.1}, {"board_top": np.inf}]
)
def test_a_parameter_for_all_that_is_not_allowed_makes_all_rows_invalid(
    simulate: Simulate, change: dict[str, float]
) -> None:
    shots = simulate(neighbours(11).states, PAPER | change)
    assert np.all(shots.outcome == Outcome.INVALID)
    assert np.all(np.isnan(shots.state))


def test_rows_that_are_all_invalid_are_all_invalid(simulate: Simulate) -> None:
    shots = simulate(np.full((23, 9), np.nan), record=True)
    assert np.all(shots.outcome == Outcome.INVALID)
    assert len(shots.events) == 0


# ----------------------------------------------------------------------- input of unusual make-up


def test_an_empty_batch_gives_empty_results(simulate: Simulate) -> None:
    shots = simulate(np.empty((0, 9)), record=True)
    assert len(shots) == 0
    shapes = {name: getattr(shots, name).shape for name in FIELDS}
    assert shapes == dict.fromkeys(FIELDS, (0,)) | {"counts": (0, 3), "state": (0, 9)}
    assert len(shots.events) == 0
    assert shots.events.dtype.names == (*("shot", "surface", "time", "before", "after", "kind"),)
    assert len(simulate(np.empty((0, 9)), PAPER | {"gravity": []})) == 0


def test_one_state_is_a_batch_of_one(simulate: Simulate) -> None:
    alone, batch = simulate(FREE_THROW), simulate(FREE_THROW[None])
    assert len(alone) == 1
    for name in FIELDS:
        np.testing.assert_array_equal(getattr(alone, name), getattr(batch, name))


def _odd_layouts(states: np.ndarray) -> Iterator[tuple[str, Any]]:
    yield "Fortran order", np.asfortranarray(states)
    yield "every other row", np.repeat(states, 2, axis=0)[::2]
    yield "backwards", np.ascontiguousarray(states[::-1])[::-1]
    yield "columns of a wider array", np.concatenate([states, states], axis=1)[:, :9]
    yield "big-endian", states.astype(">f8")
    yield "a list of lists", states.tolist()
    yield "objects that are numbers", states.astype(object)
    shifted = np.frombuffer(b"\0" + states.tobytes(), dtype=np.uint8)[1:]
    yield "unaligned and read-only", shifted.view(np.float64).reshape(states.shape)
    readonly = states.copy()
    readonly.flags.writeable = False
    yield "read-only", readonly


@pytest.mark.parametrize("layout", range(9))
def test_the_layout_of_the_states_does_not_matter(simulate: Simulate, layout: int) -> None:
    batch = neighbours(40)
    name, states = list(_odd_layouts(batch.states))[layout]
    got, wanted = simulate(states), simulate(batch.states)
    for field in FIELDS:
        np.testing.assert_array_equal(getattr(got, field), getattr(wanted, field), err_msg=name)


@pytest.mark.parametrize("dtype", [np.float32, np.float16, np.int64, np.int8, np.uint16, np.bool_])
def test_narrower_numbers_are_the_doubles_they_stand_for(simulate: Simulate, dtype: type) -> None:
    # Straight down the middle from (0, 0, 1), whatever the type.
    states = np.zeros((3, 9), dtype=dtype)
    states[:, 2] = 1
    got, wanted = simulate(states), simulate(states.astype(np.float64))
    assert np.all(got.outcome == Outcome.MADE)
    for field in FIELDS:
        np.testing.assert_array_equal(getattr(got, field), getattr(wanted, field))


def test_parameters_may_be_lists_integers_and_strided_arrays(simulate: Simulate) -> None:
    batch = neighbours(10)
    gravity = np.linspace(9.0, 10.0, 20)[::2]
    strided = simulate(batch.states, PAPER | {"gravity": gravity})
    for same in (gravity.tolist(), gravity.astype(">f8"), gravity.copy()):
        got = simulate(batch.states, PAPER | {"gravity": same})
        np.testing.assert_array_equal(got.state, strided.state)
    whole = simulate(batch.states, PAPER | {"gravity": 10, "restitution": np.array(1)})
    wanted = simulate(batch.states, PAPER | {"gravity": 10.0, "restitution": 1.0})
    np.testing.assert_array_equal(whole.state, wanted.state)


# ----------------------------------------------------------------------------------------- errors


@pytest.mark.parametrize(
    ("states", "given"),
    [
        (np.zeros(8), "(8,)"),
        (np.zeros((3, 8)), "(3, 8)"),
        (np.zeros((3, 10)), "(3, 10)"),
        (np.zeros((9, 3)), "(9, 3)"),
        (np.zeros((2, 3, 9)), "(2, 3, 9)"),
        (np.float64(1.0), "()"),
        ([], "(0,)"),
    ],
)
def test_states_of_another_shape_are_an_error(states: Any, given: str) -> None:
    with pytest.raises(ValueError, match=r"^states: expected shape") as error:
        hoopgen.simulate(states)
    assert f"(n, 9) or (9,), got {given}" in str(error.value)
    assert "x y z vx vy vz wx wy wz" in str(error.value)


@pytest.mark.parametrize(
    "states",
    [
        "nine numbers",
        [["a"] * 9],
        [[object()] * 9],
        [[0.0] * 9, [0.0] * 8],
        None,
        {"x": 1.0},
    ],
)
def test_states_that_are_no_numbers_are_an_error(states: Any) -> None:
    with pytest.raises((TypeError, ValueError), match=r"^states: expected"):
        hoopgen.simulate(states)


def test_states_that_are_complex_are_a_type_error() -> None:
    # NumPy would drop the imaginary part with no more than a warning.
    with pytest.raises(TypeError, match=r"^states: expected numbers"):
        hoopgen.simulate(np.ones((1, 9), dtype=complex))


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"bounce": 0.7}, "unknown bounce"),
        ({"Gravity": 9.8, "ball": 0.1}, "unknown Gravity, ball"),
        ({1: 2.0}, "unknown 1"),
    ],
)
def test_an_unknown_parameter_is_named_and_the_right_ones_listed(
    change: dict[Any, float], said: str
) -> None:
    with pytest.raises(ValueError, match=f"^parameters: {said}") as error:
        hoopgen.simulate(FREE_THROW, PAPER | change)
    assert f"The names are {', '.join(NAMES)}" in str(error.value)


@pytest.mark.parametrize(
    ("parameters", "scene", "said"),
    [
        (hoopgen.NBA_AIR, hoopgen.HOOP, "; give scene=hoopgen.AIR, or COURT_AIR, for these. "),
        (hoopgen.NBA_COURT, hoopgen.AIR, "; give scene=hoopgen.COURT, or COURT_AIR, for these. "),
        (hoopgen.NBA_COURT_AIR, hoopgen.HOOP, "; give scene=hoopgen.COURT_AIR for these. "),
        (
            {"inertia": 0.4},
            hoopgen.HOOP,
            "; give scene=hoopgen.COURT, AIR or COURT_AIR for these. ",
        ),
    ],
)
def test_parameters_of_another_hoop_name_the_scene_that_has_them(
    parameters: Any, scene: Any, said: str
) -> None:
    with pytest.raises(ValueError, match=r"^parameters: unknown ") as error:
        hoopgen.simulate(FREE_THROW, parameters, scene=scene)
    assert said in str(error.value)


def test_the_names_in_that_hint_are_those_that_the_scenes_add() -> None:
    own = set(NAMES)
    assert {*AIR_DEFAULTS, "inertia"} == set(hoopgen.NBA_AIR) - own
    assert {*OF_COURT, "inertia"} == set(hoopgen.NBA_COURT) - own


@pytest.mark.parametrize(
    ("scene", "said"),
    [
        (hoopgen.NBA, "parameters="),
        (Path("golf.toml"), "hoopgen.load_scene reads a file"),
        ("golf.toml", "hoopgen.load_scene reads a file"),
        ("NBA", "scenes are hoopgen.HOOP"),
    ],
)
def test_what_is_no_scene_gets_a_hint_of_what_was_meant(scene: Any, said: str) -> None:
    with pytest.raises(TypeError, match=r"^scene: expected None, a scene") as error:
        hoopgen.simulate(FREE_THROW, scene=scene)
    assert said in str(error.value)


def test_a_table_of_states_is_read_by_the_names_of_its_columns() -> None:
    states = neighbours(40).states
    columns = {name: states[:, index] for index, name in enumerate(STATE)}
    swapped = {"shooter": list("ab") * 20} | {name: columns[name] for name in sorted(STATE)}
    wanted = hoopgen.simulate(states).state.tobytes()
    frames = [swapped, pd.DataFrame(swapped), pa.table(swapped), pd.DataFrame(states)]
    for frame in frames:
        assert hoopgen.simulate(frame).state.tobytes() == wanted
    with pytest.raises(ValueError, match=r"^states: expected columns x .*; vx, wx are missing$"):
        hoopgen.simulate(pd.DataFrame(swapped).drop(columns=["wx", "vx"]))
    with pytest.raises(ValueError, match=r"^states: expected columns of one length"):
        hoopgen.simulate(columns | {"x": [1.0]})
    with pytest.raises(ValueError, match=r"got shapes \(40,\) of x, y, z, .* and \(\) of vx$"):
        hoopgen.simulate(columns | {"vx": -5.0})
    with pytest.raises(TypeError, match=r"^states: wx: expected numbers, got "):
        hoopgen.simulate(columns | {"wx": ["fast"] * 40})


def test_a_mapping_of_numbers_is_one_release() -> None:
    row = dict(zip(STATE, FREE_THROW.tolist(), strict=True))
    assert hoopgen.simulate(row).state.tobytes() == hoopgen.simulate(FREE_THROW).state.tobytes()
    assert hoopgen.why_invalid(row) == [""]
    (reason,) = hoopgen.why_invalid(row | {"vx": 1e20})
    assert reason.startswith("out of range: vx 1e+20")
    for scalar in (5.0, np.float64(5.0)):
        with pytest.raises(
            ValueError, match=r"^states: expected shape \(n, 9\) or \(9,\), got \(\)"
        ):
            hoopgen.why_invalid(scalar)


def test_a_parameter_left_out_has_the_usual_value_and_an_unknown_one_is_an_error_still() -> None:
    for some in (None, {}, {"restitution": 0.5}, {"gravity": np.full(40, 1.6)}):
        batch = neighbours(40)
        left_out = hoopgen.simulate(batch.states, some)
        whole = hoopgen.simulate(batch.states, PAPER | (some or {}))
        assert left_out.state.tobytes() == whole.state.tobytes()
        assert list(left_out.parameters) == list(NAMES)
    with pytest.raises(
        ValueError, match=r"^parameters: unknown bounce\. The names are ball_radius"
    ):
        hoopgen.simulate(FREE_THROW, {"restitution": 0.7, "bounce": 0.7})


@pytest.mark.parametrize("parameters", [0.7, "PAPER", [0.1] * 11, list(PAPER.items())])
def test_parameters_that_are_no_mapping_are_an_error(parameters: Any) -> None:
    with pytest.raises(TypeError, match=r"^parameters: expected a mapping of names to values"):
        hoopgen.simulate(FREE_THROW, parameters)


@pytest.mark.parametrize("value", ["0.7 or so", object(), {"of": 1}])
def test_a_parameter_that_is_no_number_is_an_error(value: Any) -> None:
    with pytest.raises(TypeError, match=r"^parameters\['restitution'\]: expected numbers, got"):
        hoopgen.simulate(FREE_THROW, PAPER | {"restitution": value})


def test_a_parameter_that_is_complex_is_a_type_error() -> None:
    with pytest.raises(TypeError, match=r"^parameters\['gravity'\]: expected numbers"):
        hoopgen.simulate(FREE_THROW, PAPER | {"gravity": np.array(9.81 + 1j)})


@pytest.mark.parametrize("shape", [(2,), (4,), (3, 1), (1, 3), (0,)])
def test_a_parameter_of_another_shape_is_an_error(shape: tuple[int, ...]) -> None:
    with pytest.raises(ValueError, match=r"^parameters\['gravity'\]: expected one") as error:
        hoopgen.simulate(np.tile(FREE_THROW, (3, 1)), PAPER | {"gravity": np.full(shape, 9.81)})
    assert "or 3, one a shot" in str(error.value)
    assert f"got shape {shape}" in str(error.value)


@pytest.mark.parametrize("value", [-0.1, 1.0000001, 7, np.nan, np.inf])
def test_a_restitution_for_all_outside_0_to_1_is_an_error(value: float) -> None:
    with pytest.raises(ValueError, match=r"^parameters\['restitution'\]: expected 0 to 1, got"):
        hoopgen.simulate(FREE_THROW, PAPER | {"restitution": value})


@pytest.mark.parametrize("value", [0, -1, 2**31, 1.5, 40.0, "40", np.nan])
def test_max_contacts_must_be_a_whole_number_from_1(value: Any) -> None:
    said = f"max_contacts: expected a whole number from 1, got {value!r}"
    with pytest.raises(ValueError, match=f"^{re.escape(said)}"):
        hoopgen.simulate(FREE_THROW, max_contacts=value)


@pytest.mark.parametrize("value", [True, np.timedelta64(3, "s"), np.bool_(True)])
def test_neither_truth_nor_time_is_a_whole_number(value: Any) -> None:
    for name in ("max_contacts", "threads"):
        with pytest.raises(ValueError, match=f"^{name}: expected a whole number from 1"):
            hoopgen.simulate(FREE_THROW, **{name: value})


def test_a_whole_number_that_is_too_large_is_told_the_end() -> None:
    with pytest.raises(
        ValueError, match=r"whole number from 1, got 2147483648; at most 2147483647"
    ):
        hoopgen.simulate(FREE_THROW, max_contacts=2**31)


@pytest.mark.parametrize(
    ("value", "said"),
    [(40.0, "got 40.0; give it as an int, 40"), (1e30, "got 1e+30; at most 2147483647")],
)
def test_a_float_that_is_whole_is_told_what_to_give(value: float, said: str) -> None:
    with pytest.raises(ValueError, match=f"{re.escape(said)}$"):
        hoopgen.simulate(FREE_THROW, max_contacts=value)  # type: ignore[arg-type]


@pytest.mark.parametrize("value", [np.int8(3), np.uint64(3), 3])
def test_max_contacts_may_be_any_kind_of_whole_number(value: Any) -> None:
    assert hoopgen.simulate(FREE_THROW, max_contacts=value).contacts[0] <= 3


@pytest.mark.parametrize("value", ["C", "gpu", "", None, 1])
def test_an_unknown_backend_is_an_error_that_lists_them(value: Any) -> None:
    said = f"backend: expected 'auto', 'c', 'numpy' or 'cuda', got {value!r}"
    with pytest.raises(ValueError, match=f"^{re.escape(said)}$"):
        hoopgen.simulate(FREE_THROW, backend=value)


@pytest.mark.parametrize("value", [0, -2, 1.5, "all"])
def test_threads_must_be_a_whole_number_from_1_or_none(value: Any) -> None:
    said = f"threads: expected a whole number from 1, or None, got {value!r}"
    with pytest.raises(ValueError, match=f"^{re.escape(said)}$"):
        hoopgen.simulate(FREE_THROW, threads=value)


@pytest.mark.parametrize(
    ("fields", "unknown"),
    [
        ("times", "times"),
        (["outcome", "speed", "spin"], "speed, spin"),
        (["events"], "events"),
    ],
)
def test_an_unknown_field_is_named_and_the_right_ones_listed(fields: Any, unknown: str) -> None:
    with pytest.raises(ValueError, match=f"^fields: unknown {unknown}") as error:
        hoopgen.simulate(FREE_THROW, fields=fields)
    for name in FIELDS:
        assert name in str(error.value)
    assert "'all'" in str(error.value)


@pytest.mark.parametrize("fields", ["time", ["time"], ("time",), ["time", "time"]])
def test_one_field_may_be_asked_for_in_any_way(fields: Any) -> None:
    shots = hoopgen.simulate(FREE_THROW, fields=fields)
    assert shots.time.shape == (1,)


@pytest.mark.parametrize("value", [1.0, "rim", ["ring", "rim"], [0, 1], 3, -2])
def test_leaving_must_be_a_surface_s_name_its_index_or_minus_1(value: Any) -> None:
    with pytest.raises(ValueError, match=r"^leaving: expected"):
        hoopgen.simulate(FREE_THROW, leaving=value)


def test_options_are_given_by_name() -> None:
    with pytest.raises(TypeError):
        hoopgen.simulate(FREE_THROW, PAPER, 40)  # type: ignore[misc]


# ------------------------------------------------------------------------------------ no compiler


@pytest.fixture
def without_library(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    refused = native.Rejection("was not built", "install again with a C compiler")
    monkeypatch.setattr(HOOP, "found", refused)
    backend_choice._warn_once.cache_clear()
    yield
    backend_choice._warn_once.cache_clear()


@pytest.mark.usefixtures("without_library")
def test_without_the_library_auto_is_numpy_and_one_line_says_so_once(
    capsys: pytest.CaptureFixture[str],
) -> None:
    batch = neighbours(20)
    first, again = hoopgen.simulate(batch.states), hoopgen.simulate(batch.states, backend="auto")
    wanted = hoopgen.simulate(batch.states, backend="numpy")
    for name in FIELDS:
        np.testing.assert_array_equal(getattr(first, name), getattr(wanted, name))
        np.testing.assert_array_equal(getattr(again, name), getattr(wanted, name))
    captured = capsys.readouterr()
    assert captured.out == ""
    (line,) = captured.err.splitlines()
    assert line.startswith("hoopgen: ")
    assert "NumPy" in line


@pytest.mark.usefixtures("without_library")
def test_without_the_library_numpy_asked_for_by_name_says_nothing(
    capsys: pytest.CaptureFixture[str],
) -> None:
    hoopgen.simulate(FREE_THROW, backend="numpy")
    assert capsys.readouterr() == ("", "")


@pytest.mark.usefixtures("without_library")
def test_without_the_library_c_is_an_error_that_names_the_remedy() -> None:
    with pytest.raises(RuntimeError, match=r"^backend: 'c' was not built") as error:
        hoopgen.simulate(FREE_THROW, backend="c")
    assert "install again with a C compiler" in str(error.value)
    assert "'numpy'" in str(error.value)


def test_a_library_that_cannot_be_loaded_is_none(tmp_path: Path) -> None:
    (tmp_path / "_hoop.so").write_bytes(b"not a library")
    found = hoop_library(tmp_path / "_hoop.so")
    assert isinstance(found, native.Rejection)
    assert found.reason == "was not built"


def test_a_width_that_is_not_there_is_an_error() -> None:
    library = HOOP.library
    if library is None:
        pytest.skip("the C engine was not built")
    states = np.ascontiguousarray(FREE_THROW[None])
    values = [np.asarray(v) for v in PAPER.values()]
    stop = np.zeros(1, np.int32)
    with pytest.raises(ValueError, match=r"^width 3: this processor or build does not have it"):
        library.run(states, values, None, 40, HOOP.layout.allocate(1, ()), stop, width=3)


def test_the_reason_names_all_bodies_that_a_ball_is_inside(monkeypatch: pytest.MonkeyPatch) -> None:
    """Their formulas need SymPy, without which a built-in scene runs all the same."""
    pytest.importorskip("sympy")
    state = [-0.37, 0.0, 0.01, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    assert hoopgen.why_invalid(state) == ["inside the backboard and the bridge"]
    monkeypatch.setitem(sys.modules, "hoopgen.derive.symbolic.conditionals", None)
    assert hoopgen.why_invalid(state) == ["inside several surfaces"]
