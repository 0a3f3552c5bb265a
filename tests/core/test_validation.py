"""Values from Python that only look like numbers, hide some, or are too large to be shown."""

from __future__ import annotations

import decimal
import fractions
import re
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import hoopgen
from hoopgen import PAPER, Outcome
from hoopgen.core.validation import as_doubles, check_leaving, is_whole
from hoopgen.text.shorten import MAX_LENGTH, MAX_NAMES, brief, cut, join_names

FREE_THROW = hoopgen.release(7.166, 0.892, height=2.4384, distance=4.191, backspin=19.0)
THREE = np.tile(FREE_THROW, (3, 1))
FIELDS = ("outcome", "contacts", "counts", "first", "time", "state", "uncertain")

NO_NUMBERS: list[Any] = [
    "7.1",
    b"7.1",
    ["7.1", "7.2"],
    [7.1, "7.2"],
    np.array(["7.1"]),
    np.array([b"7.1"]),
    np.array(["7.1"], object),
    np.array([b"7.1"], object),
    np.datetime64("2020-01-01"),
    np.array(["2020-01-01"], "datetime64[ns]"),
    np.array([np.datetime64(5, "ns")], object),
    np.timedelta64(7),
    np.array([7], "timedelta64[s]"),
    np.array([np.timedelta64(5, "ns")], object),
    np.ma.array(["7.1"], mask=[True]),
    np.ma.array([7], "timedelta64[s]", mask=[True]),
    np.array([(7.1,)], [("speed", "f8")]),
    None,
    [7.1, None],
    np.array([7.1j], object),
]


# -------------------------------------------------------------------------------------- no numbers


@pytest.mark.parametrize("value", NO_NUMBERS, ids=lambda value: brief(value))
def test_what_only_looks_like_numbers_is_a_type_error(value: Any) -> None:
    with pytest.raises(TypeError, match=r"^speed: expected numbers, got "):
        hoopgen.release(value, 0.9, height=2.1, distance=4.2)
    with pytest.raises(TypeError, match=r"^parameters\['gravity'\]: expected numbers, got "):
        hoopgen.simulate(THREE[: max(np.size(value), 1)], PAPER | {"gravity": value})


@pytest.mark.parametrize("kind", ["U8", "S8", "M8[s]", "m8[s]"])
def test_states_of_text_or_times_are_a_type_error(kind: str) -> None:
    states = np.ones((2, 9), np.int64).astype(kind)
    for given in (states, states.astype(object), states.tolist()):
        with pytest.raises(TypeError, match=r"^states: expected numbers of shape .*, got "):
            hoopgen.simulate(given)


def test_spans_of_time_are_no_whole_numbers() -> None:
    assert is_whole(5)
    assert is_whole(np.uint8(5))
    assert not is_whole(np.timedelta64(5))  # though NumPy has it among the signed integers
    calls: list[Callable[[Any], Any]] = [
        lambda span: hoopgen.simulate(FREE_THROW, max_contacts=span),
        lambda span: hoopgen.simulate(FREE_THROW, threads=span),
        lambda span: hoopgen.simulate(FREE_THROW, leaving=span),
        lambda span: hoopgen.simulate(FREE_THROW, leaving=np.array([span])),
    ]
    for call in calls:
        with pytest.raises(ValueError, match=r"expected (a )?whole number"):
            call(np.timedelta64(1))


@pytest.mark.parametrize("dtype", [bool, np.int8, np.uint64, np.float16, np.longdouble])
def test_every_kind_of_number_is_one(dtype: type) -> None:
    for given in (np.ones(2, dtype), np.ones(2, dtype).astype(object), [dtype(1)] * 2):
        assert as_doubles("x", given).tolist() == [1.0, 1.0]


def test_exact_numbers_are_rounded_to_doubles() -> None:
    given = [decimal.Decimal("1.5"), fractions.Fraction(1, 3), 2**60 + 1]
    assert as_doubles("x", given).tolist() == [1.5, 1 / 3, 2.0**60]


# --------------------------------------------------------------------------------- what is missing


def test_masked_states_are_invalid_rows_and_the_others_as_ever() -> None:
    states = np.ma.array(THREE, mask=np.zeros((3, 9), bool))
    states[1, 3] = np.ma.masked
    wanted, got = hoopgen.simulate(THREE), hoopgen.simulate(states)
    assert got.outcome.tolist() == [wanted.outcome[0], Outcome.INVALID, wanted.outcome[0]]
    assert np.isnan(got.state[1]).all()
    listed_rows = hoopgen.simulate(list(states))
    for field in FIELDS:
        np.testing.assert_array_equal(getattr(got, field)[::2], getattr(wanted, field)[::2])
        np.testing.assert_array_equal(getattr(got, field), getattr(listed_rows, field))


def test_a_masked_parameter_makes_its_row_invalid() -> None:
    # What is behind a mask is anything: here a ball that does not bounce.
    behind = np.ma.array([0.7, 0.0, 0.7], mask=[False, True, False])
    shots = hoopgen.simulate(THREE, PAPER | {"restitution": behind})
    wanted = hoopgen.simulate(FREE_THROW).outcome[0]
    assert shots.outcome.tolist() == [wanted, Outcome.INVALID, wanted]
    with pytest.raises(ValueError, match=r"^parameters\['restitution'\]: expected 0 to 1, got nan"):
        hoopgen.simulate(THREE, PAPER | {"restitution": np.ma.masked})


@pytest.mark.parametrize("dtype", [bool, np.int64, np.float32, np.float64, object])
def test_what_a_mask_hides_is_nan(dtype: type) -> None:
    one = np.ma.array([1, 1], dtype, mask=[False, True])
    np.testing.assert_array_equal(as_doubles("x", one), [1.0, np.nan])
    np.testing.assert_array_equal(as_doubles("x", [one, [1, 1]]), [[1.0, np.nan], [1.0, 1.0]])
    np.testing.assert_array_equal(as_doubles("x", [[one], (one,)]), [[[1.0, np.nan]]] * 2)
    np.testing.assert_array_equal(as_doubles("x", one.filled(1)), [1.0, 1.0])


def test_masked_arguments_of_a_release_are_nan() -> None:
    speed = np.ma.array([7.0, 7.0], mask=[False, True])
    states = hoopgen.release(speed, 0.9, height=2.1, distance=4.2)
    assert np.isfinite(states[0]).all()
    assert np.isnan(states[1, 3:6]).all()


def test_a_masked_time_is_not_on_the_path() -> None:
    path = hoopgen.simulate(FREE_THROW, record=True).trajectory(0)
    with pytest.raises(ValueError, match=r"^t: expected times from 0 to "):
        path.at(np.ma.array([0.1, 0.2], mask=[False, True]))
    with pytest.raises(TypeError, match=r"^t: expected numbers, got '0\.1'"):
        path.at("0.1")  # type: ignore[arg-type]


def test_leaving_has_no_value_for_what_is_missing() -> None:
    masked = np.ma.array([0, 0, 0], mask=[False, True, False])
    with pytest.raises(
        ValueError, match=r"^leaving: expected whole numbers or names, one or 3, got "
    ):
        check_leaving(masked, 3)
    with pytest.raises(
        ValueError, match=r"^leaving: expected whole numbers or names, one or 3, got "
    ):
        check_leaving([[0], [1, 2]], 3)
    kept = check_leaving(np.ma.array([0, 1, -1]), 3)
    assert kept is not None
    assert kept.tolist() == [0, 1, -1]


def test_what_pandas_has_not_is_nan_or_refused() -> None:
    pandas = pytest.importorskip("pandas")
    for dtype in ("Float64", "Int64", "float64"):
        column = pandas.Series([1, None], dtype=dtype)
        np.testing.assert_array_equal(as_doubles("x", column), [1.0, np.nan])
    mixed = pandas.DataFrame({"a": [1.0], "b": pandas.array([None], dtype="Float64")})
    for strange in (mixed, pandas.Series(["1.0"]), pandas.Series(["2020"], dtype="datetime64[s]")):
        with pytest.raises(TypeError, match=r"^x: expected numbers, got "):
            as_doubles("x", strange)


def test_studies_see_masks_too() -> None:
    pytest.importorskip("scipy")
    placed = {"elevation": 0.9, "height": 2.1, "distance": 4.2}
    speed = np.ma.array([7.0, 7.1], mask=[False, True])
    shots = hoopgen.Resample({"speed": speed, **placed})
    assert np.isnan(np.asarray(shots.columns["speed"])).tolist() == [False, True]
    grid = hoopgen.Grid({"speed": speed}, placed)
    assert np.isnan(grid.draw(0, 2).states[:, 3]).tolist() == [False, True]
    assert np.isnan(grid.identity()["axes"]["speed"]).tolist() == [False, True]


# ------------------------------------------------------------------------------------ what is huge


@pytest.mark.parametrize("power", [400, 5000])  # of 5000 digits Python shows none
def test_a_whole_number_too_large_for_a_double_is_said_to_be(power: int) -> None:
    huge = 10**power
    said = r": expected numbers.* below 1\.8e308 in size, got "
    with pytest.raises(ValueError, match=rf"^states{said}"):
        hoopgen.simulate([huge] * 9)
    with pytest.raises(ValueError, match=rf"^parameters\['gravity'\]{said}"):
        hoopgen.simulate(FREE_THROW, PAPER | {"gravity": -huge})
    with pytest.raises(ValueError, match=rf"^speed{said}"):
        hoopgen.release(huge, 0.9, height=2.1, distance=4.2)
    with pytest.raises(ValueError, match=rf"^t{said}"):
        hoopgen.simulate(FREE_THROW, record=True).trajectory(0).at(huge)
    with pytest.raises(ValueError, match=r"^max_contacts: expected a whole number"):
        hoopgen.simulate(FREE_THROW, max_contacts=huge)
    with pytest.raises(ValueError, match=r"^leaving: expected "):
        hoopgen.simulate(FREE_THROW, leaving=huge)


def test_studies_say_so_too() -> None:
    pytest.importorskip("scipy")
    from hoopgen.study.questions.aim_table import aim_table

    huge = 10**400
    placed = {"speed": 7.0, "elevation": 0.9, "height": 2.1, "distance": 4.2}
    player = hoopgen.Scatter(placed, {"speed": 0.1})
    calls: dict[str, Callable[[], Any]] = {
        r"release\['speed'\]": lambda: hoopgen.Scatter({**placed, "speed": huge}),
        r"sd\['speed'\]": lambda: hoopgen.Scatter(placed, {"speed": huge}),
        "correlation: speed and elevation": lambda: hoopgen.Scatter(
            placed, {"speed": 0.1, "elevation": 0.1}, {("speed", "elevation"): huge}
        ),
        r"columns\['speed'\]": lambda: hoopgen.Resample({**placed, "speed": [huge]}),
        r"axes\['speed'\]": lambda: hoopgen.Grid({"speed": [huge]}),
        "shots": lambda: hoopgen.estimate(player, shots=huge),
        "seed": lambda: hoopgen.estimate(player, shots=10, seed=huge),
        "confidence": lambda: hoopgen.estimate(player, shots=10, confidence=huge),
        "precision": lambda: hoopgen.estimate(player, precision=huge),
        "distance": lambda: hoopgen.aim(height=2.1, distance=huge),
        "distances": lambda: aim_table([huge], height=2.1),
    }
    for name, call in calls.items():
        with pytest.raises(ValueError, match=rf"^{name}: expected .*, got \[?10{{50}}") as raised:
            call()
        assert len(str(raised.value)) < 200


MANY = list(range(1_000_000))


@pytest.mark.sampled(5)
@pytest.mark.parametrize(
    "call",
    [
        lambda: hoopgen.simulate([*MANY, "x"]),
        lambda: hoopgen.simulate(FREE_THROW, PAPER | {"gravity": [*MANY, "x"]}),
        lambda: hoopgen.simulate(FREE_THROW, dict.fromkeys(MANY, 1.0)),
        lambda: hoopgen.simulate(FREE_THROW, MANY),  # type: ignore[arg-type]
        lambda: hoopgen.simulate(FREE_THROW, max_contacts=MANY),  # type: ignore[arg-type]
        lambda: hoopgen.simulate(FREE_THROW, threads=MANY),  # type: ignore[arg-type]
        lambda: hoopgen.simulate(FREE_THROW, leaving=MANY),
        lambda: hoopgen.simulate(FREE_THROW, backend=MANY),  # type: ignore[arg-type]
        lambda: hoopgen.simulate(FREE_THROW, fields=map(str, MANY)),
        lambda: hoopgen.simulate(FREE_THROW, fields=["x" * 1_000_000]),
        lambda: hoopgen.release(MANY, MANY[1:], height=2.1, distance=4.2),
        lambda: hoopgen.release("7" * 1_000_000, 0.9, height=2.1, distance=4.2),
        lambda: hoopgen.simulate(FREE_THROW, record=True).trajectory(0).at(MANY),
    ],
)
def test_no_error_is_longer_than_it_helps(call: Callable[[], Any]) -> None:
    with pytest.raises((TypeError, ValueError)) as raised:
        call()
    said = str(raised.value)
    assert len(said) < 1500
    assert "\n" not in said


@pytest.mark.parametrize(
    "value", ["nan", "7.1 m/s", 7, 7.1, None, True, [1, 2], (1.0, 2.0), {"a": 1}, [0.0] * 9]
)
def test_what_is_short_is_shown_as_python_does(value: object) -> None:
    assert brief(value) == repr(value)


class Broken:
    """Something that cannot be shown."""

    def __repr__(self) -> str:
        raise RuntimeError


@pytest.mark.parametrize(
    "value",
    [MANY, np.zeros((1000, 9)), "x" * 1000, b"x" * 1000, 10**5000, {"a": MANY}, [[0.1] * 9] * 9],
    ids=lambda value: type(value).__name__,
)
def test_what_is_long_is_cut_to_one_line(value: object) -> None:
    shown = brief(value)
    assert len(shown) <= MAX_LENGTH
    assert shown.isprintable()
    assert "..." in shown or shown == "<int>"


def test_what_cannot_be_shown_is_named_by_its_type() -> None:
    assert brief(Broken()).startswith("<Broken")


def test_a_text_is_cut_to_one_line_without_control_characters() -> None:
    assert cut("one\r\n  two\x1b[31m") == r"one two\x1b[31m"
    assert cut("") == ""
    assert join_names(range(MAX_NAMES)) == ", ".join(map(str, range(MAX_NAMES)))
    assert join_names(iter(range(MAX_NAMES + 5))).endswith(f"{MAX_NAMES - 1}, and 5 more")


# -------------------------------------------------------------------------------------- once alone


def test_fields_may_be_an_iterator() -> None:
    shots = hoopgen.simulate(FREE_THROW, fields=iter(["outcome", "time"]))
    assert shots.outcome.shape == shots.time.shape == (1,)
    with pytest.raises(AttributeError, match=r"not among the fields asked for: outcome, time"):
        _ = shots.contacts
    with pytest.raises(ValueError, match=r"^fields: unknown speed\. "):
        hoopgen.simulate(FREE_THROW, fields=iter(["outcome", "speed"]))


@pytest.mark.parametrize("fields", [None, 3, 1.5])
def test_fields_that_are_no_names_are_a_type_error(fields: Any) -> None:
    said = re.escape(f"fields: expected 'all' or names, got {fields!r}")
    with pytest.raises(TypeError, match=f"^{said}$"):
        hoopgen.simulate(FREE_THROW, fields=fields)


def test_names_may_be_iterators_wherever_there_are_some() -> None:
    pytest.importorskip("scipy")
    from hoopgen.study.jobs.objective import Player
    from hoopgen.study.questions.search import bounds_of

    shots = hoopgen.simulate(FREE_THROW)
    assert list(hoopgen.measure(FREE_THROW, shots, names=iter(["apex"]))) == ["apex"]
    placed = {"speed": 7.0, "elevation": 0.9, "height": 2.1, "distance": 4.2}
    assert list(hoopgen.margins(hoopgen.Scatter(placed), names=iter(["azimuth"]))) == ["azimuth"]
    assert list(bounds_of(iter(["azimuth"]), placed, Player())) == ["azimuth"]  # type: ignore[arg-type]
