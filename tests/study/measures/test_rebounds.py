"""Rebounds: where and when a miss comes down to the catching height; how they and others spread."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from mpmath import mp, mpf
from numpy.typing import NDArray

from tests.helpers import ROOT
from tests.helpers.commands import run, succeed
from tests.helpers.court_shots import all_kinds
from tests.helpers.effort import occurrences, trials
from tests.helpers.hoop_shots import Batch

for _library in ("matplotlib", "pyarrow", "pydantic", "scipy", "xarray"):
    pytest.importorskip(_library)

import pyarrow.parquet as pq  # noqa: E402

import hoopgen  # noqa: E402
from hoopgen.hoop.court_lines import COURTS, find_court  # noqa: E402
from hoopgen.hoop.releases import CATCHING_HEIGHT, RING_HEIGHT  # noqa: E402
from hoopgen.plots import plot_landings  # noqa: E402
from hoopgen.study.measures.measures import MEASURES, measure  # noqa: E402
from hoopgen.study.measures.rebounds import REBOUNDS, SECTORS, directions, sector  # noqa: E402
from hoopgen.study.statistics import distributions  # noqa: E402
from hoopgen.studyfile import check_study, run_study  # noqa: E402
from hoopgen.studyfile.reading import StudyError  # noqa: E402

Floats = NDArray[np.float64]
EPS = float(np.finfo(np.float64).eps)
FREE_THROW = {"height": 2.1336, "distance": 4.191, "backspin": 6 * np.pi, "elevation": 0.9}
PLAYER = hoopgen.Scatter(
    {**FREE_THROW, "speed": 7.17}, {"speed": 0.07, "elevation": 0.022, "azimuth": 0.018}
)
HEIGHTS = (0.3, CATCHING_HEIGHT, RING_HEIGHT, 3.2, 3.6)
"""Heights from near the floor to above the ring, where the ring turns many balls."""


def _last_flight(batch: Batch, shots: hoopgen.Shots, shot: int) -> tuple[float, Floats]:
    """Return when the last flight begins and the state there, by the event log."""
    events = shots.trajectory(shot).events
    touches = events[events["kind"] != hoopgen.Event.END]
    return (touches["time"][-1], touches["after"][-1]) if len(touches) else (0, batch.states[shot])


def _descent(begin: Floats, gravity: float, height: float) -> Any:
    """Return after how long a flight comes down to a height, at 40 digits; None if never."""
    z, vz, g = mpf(float(begin[2])), mpf(float(begin[5])), mpf(gravity)
    under = vz**2 + 2 * g * (z + mpf(RING_HEIGHT) - mpf(height))
    time = (vz + mp.sqrt(under)) / g if under >= 0 else mpf(-1)
    return time if time >= 0 else None


def _agrees(batch: Batch, shots: hoopgen.Shots, height: float, tolerance: float) -> tuple[int, int]:
    """Hold rebounds against last flights of the log; return how many there are, and are not."""
    found = measure(batch.states, shots, batch.parameters, REBOUNDS, catching_height=height)
    gravity = np.broadcast_to(batch.parameters["gravity"], len(batch)).tolist()
    misses = np.flatnonzero(np.isin(shots.outcome, [hoopgen.Outcome.MISSED, hoopgen.Outcome.SHORT]))
    others = np.setdiff1d(np.arange(len(batch)), misses)
    assert all(np.isnan(column[others]).all() for column in found.values())
    seen = 0
    for shot in misses.tolist():
        start, begin = _last_flight(batch, shots, shot)
        values = {name.removeprefix("rebound_"): found[name][shot] for name in REBOUNDS}
        with mp.workdps(40):
            time = _descent(begin, gravity[shot], height)
            if time is None:
                assert np.isnan(list(values.values())).all(), shot
                continue
            seen += 1
            x, y = (mpf(float(begin[k])) + mpf(float(begin[3 + k])) * time for k in (0, 1))
            # A ball that only just gets so high: its time is as uncertain as a square root near 0.
            fall = float(abs(mpf(float(begin[5])) - mpf(gravity[shot]) * time))
            error = tolerance * (1 + 1 / max(fall, 1e-6)) * (1 + float(np.abs(begin[3:6]).sum()))
            assert abs(values["time"] - (start + time)) <= error
            assert abs(values["x"] - x) <= error
            assert abs(values["y"] - y) <= error
        # Each of the two is within a unit in the last place.
        far = np.hypot(values["x"], values["y"])
        assert abs(values["distance"] - far) <= 2 * np.spacing(far)
        first = shots.trajectory(shot).events["time"][0] if shots.contacts[shot] else np.nan
        np.testing.assert_array_equal(values["delay"], values["time"] - first)
    return seen, len(misses) - seen


@pytest.fixture(scope="module")
def recorded(mixed: Batch) -> tuple[Batch, hoopgen.Shots]:
    """Shots of all kinds, a tenth of them with a hoop of their own, and their logs."""
    picked = mixed.take(
        np.random.default_rng(15).permutation(len(mixed))[: trials(2000, at_least=1000)]
    )
    own = {n: np.broadcast_to(v, len(picked)).copy() for n, v in picked.parameters.items()}
    batch = Batch(np.array(picked.states), own)
    return batch, hoopgen.simulate(batch.states, own, record=True)


@pytest.mark.sampled(2)
@pytest.mark.parametrize("height", HEIGHTS)
def test_a_rebound_is_where_the_last_flight_comes_down_to_the_height(
    recorded: tuple[Batch, hoopgen.Shots], height: float
) -> None:
    """Below the end plane and above it, by 40 digits: a few roundings of times, places, speeds."""
    seen, none = _agrees(*recorded, height, 64 * EPS)
    assert seen > occurrences(100)
    assert none > occurrences(20) or height < RING_HEIGHT


@pytest.mark.slow
def test_so_it_is_on_the_whole_hoop_where_balls_roll() -> None:
    states = all_kinds(trials(150, at_least=150), seed=8)
    shots = hoopgen.simulate(states, scene=hoopgen.COURT, record=True)
    assert np.any(shots.events["kind"] == hoopgen.Event.LEAVE)
    batch = Batch(states, dict(hoopgen.COURT.parameters))
    for height in (CATCHING_HEIGHT, 3.3):
        # After a contact that lasts the state of the log is that of the roll's own steps.
        seen, _ = _agrees(batch, shots, height, 1e-12)
        assert seen > occurrences(100)


def test_a_ball_that_falls_off_the_hoop_below_the_height_has_no_rebound_there() -> None:
    """The ball came down through the height before, and hit the hoop again."""
    states = PLAYER.draw(0, 4000).states
    shots = hoopgen.simulate(states, record=True)
    found = measure(states, shots, names=["rebound_x", "floor_x"], catching_height=3.25)
    none = np.isnan(found["rebound_x"]) & (shots.outcome == hoopgen.Outcome.MISSED)
    assert 20 < none.sum() < (shots.outcome == hoopgen.Outcome.MISSED).sum()
    assert not np.isnan(found["floor_x"][none]).any()


def test_an_airball_is_caught_on_its_only_flight() -> None:
    """Also above the ring, and above the end plane; never before it is thrown."""
    state = hoopgen.release(5.5, 0.9, height=2.1336, distance=4.191)
    shots = hoopgen.simulate(state)
    assert (shots.outcome[0], shots.contacts[0]) == (hoopgen.Outcome.MISSED, 0)
    for height in (2.2, 2.5, 3.0):
        found = measure(state, shots, names=REBOUNDS, catching_height=height)
        time = found["rebound_time"][0]
        fallen = 2.1336 + state[5] * time - 9.81 / 2 * time**2
        assert fallen == pytest.approx(height, rel=0, abs=16 * EPS)
        assert state[5] - 9.81 * time < 0
        assert np.isnan(found["rebound_delay"][0])
    assert np.isnan(measure(state, shots, names=REBOUNDS, catching_height=9.0)["rebound_x"][0])


def test_a_shot_thrown_down_from_below_the_height_has_no_rebound_there() -> None:
    """Its parabola was so high only before the release."""
    state = [2.0, 0.0, -1.0, 0.0, 0.0, -3.0, 0.0, 0.0, 0.0]
    shots = hoopgen.simulate(state)
    assert shots.outcome[0] == hoopgen.Outcome.SHORT
    assert np.isnan(measure(state, shots, names=["rebound_x"])["rebound_x"][0])
    lower = measure(state, shots, names=["rebound_x"], catching_height=1.0)
    assert lower["rebound_x"][0] == 2.0


def test_only_a_ball_above_the_floor_is_caught() -> None:
    states = PLAYER.draw(0, 200).states
    radius = np.where(np.arange(200) % 2, 0.11, 0.12)
    own = hoopgen.PAPER | {"ball_radius": radius}
    shots = hoopgen.simulate(states, own)
    found = measure(states, shots, own, ["rebound_time", "floor_time"], catching_height=0.115)
    missed = shots.outcome == hoopgen.Outcome.MISSED
    assert np.array_equal(~np.isnan(found["rebound_time"]), missed & (radius < 0.115))
    floor = measure(states, shots, own, ["rebound_time"], catching_height=0.12)["rebound_time"]
    same = missed & (radius == 0.12)
    np.testing.assert_allclose(floor[same], found["floor_time"][same], rtol=8 * EPS, atol=0)


# Directions


def test_directions_are_those_that_the_shooter_sees() -> None:
    """Left of the free-throw line, looking along -x, is -y; it turns with the shooter's place."""
    places = np.array([(1.0, 0.0), (0.0, -1.0), (-1.0, 0.0), (0.0, 1.0)])
    expected = np.array([0.0, np.pi / 2, np.pi, -np.pi / 2])
    for turn in (0.0, 0.3, 1.5, -2.0):
        c, s = np.cos(turn), np.sin(turn)
        there, (x, y) = places @ np.array([[c, s], [-s, c]]), (4.0 * c, 4.0 * s)
        apart = directions(there, (x, y)) - expected
        np.testing.assert_allclose(np.remainder(apart + 1, 2 * np.pi), 1, rtol=0, atol=8 * EPS)


def test_the_direction_of_a_rebound_is_that_of_its_place() -> None:
    states = PLAYER.draw(0, 500).states
    found = measure(states, hoopgen.simulate(states))
    places = np.stack([found["rebound_x"], found["rebound_y"]], axis=1)
    seen = directions(places, (4.191, 0.0))
    np.testing.assert_array_equal(found["rebound_angle"], seen)


def test_sectors_are_sixths_about_their_middles() -> None:
    middles = np.array(list(SECTORS.values()))
    half = np.radians(30)
    for off in (-0.999 * half, 0.0, 0.999 * half):
        around = np.arctan2(np.sin(middles + off), np.cos(middles + off))
        assert sector(around).tolist() == list(range(6))
    assert sector([np.pi, -np.pi, np.nan]).tolist() == [3, 3, -1]
    assert sector(0.6) == list(SECTORS).index("near left")


# Estimates


def test_an_estimate_says_the_quantiles_of_measures_within_a_cell() -> None:
    shots, names = 30_000, ["rebound_distance", "rebound_delay", "entry_angle", "floor_vz"]
    found = hoopgen.estimate(PLAYER, shots=shots, measures=names)
    states = PLAYER.draw(0, shots).states
    columns = measure(states, hoopgen.simulate(states), names=names)
    for name, each in found.measured.items():
        column = columns[name][~np.isnan(columns[name])]
        assert each.shots == len(column)
        cell = {"m": 0.01, "s": 0.005, "rad": np.radians(0.25), "m/s": 0.02}[MEASURES[name].unit]
        for level, (value, low, high) in each.quantiles.items():
            assert abs(value - np.quantile(column, level)) <= cell
            assert low < value < high
            # Its interval is that of the share which is below: no more than three times as wide.
            below = np.mean(column < low - cell), np.mean(column > high + cell)
            half = 1.97 * np.sqrt(level * (1 - level) / len(column))
            assert below[0] <= level - half + 1e-3
            assert below[1] <= 1 - level - half + 1e-3


def test_shares_by_sector_are_those_of_the_rebounds() -> None:
    shots = 30_000
    found = hoopgen.estimate(PLAYER, shots=shots, measures=["rebound_angle"], catching_height=2.7)
    states = PLAYER.draw(0, shots).states
    column = measure(
        states, hoopgen.simulate(states), names=["rebound_angle"], catching_height=2.7
    )["rebound_angle"]
    counts = np.bincount(sector(column[~np.isnan(column)]), minlength=6).tolist()
    each = found.measured["rebound_angle"]
    assert list(each.sectors.values()) == counts
    assert list(each.sectors) == list(SECTORS)
    assert each.shots == sum(counts) == found.missed
    assert each.quantiles == {}
    share, low, high = each.shares["back to the shooter"]
    assert low < share == counts[0] / sum(counts) < high
    # The throw is symmetric: as many go left as right, within four deviations.
    left, right = counts[1] + counts[2], counts[4] + counts[5]
    assert abs(left - right) < 4 * np.sqrt(left + right)


def test_the_rest_of_an_estimate_is_the_same_with_measures_as_without() -> None:
    plain = hoopgen.estimate(PLAYER, shots=20_000)
    found = hoopgen.estimate(PLAYER, shots=20_000, measures=["rebound_time", "depth"])
    assert plain.measured == {}
    assert "measured" not in plain.as_dict()
    assert {k: v for k, v in found.as_dict().items() if k != "measured"} == plain.as_dict()
    assert str(found).startswith(str(plain)[: str(plain).index("\n\nscene")])


@pytest.mark.slow
def test_measures_are_counted_the_same_by_whoever_counts(tmp_path: Path) -> None:
    wanted: dict[str, Any] = {"shots": 300_000, "measures": ["rebound_angle", "rebound_distance"]}
    found = hoopgen.estimate(PLAYER, **wanted, threads=1)
    kept = hoopgen.estimate(PLAYER, **wanted, threads=2, folder=tmp_path)
    assert found == kept == hoopgen.estimate(PLAYER, **wanted, folder=tmp_path)
    with pytest.raises(ValueError, match="catching_height"):
        hoopgen.estimate(PLAYER, **wanted, folder=tmp_path, catching_height=2.6)
    with pytest.raises(ValueError, match="measures"):
        hoopgen.estimate(PLAYER, shots=300_000, folder=tmp_path)


def test_values_beyond_the_cells_are_infinite_and_none_are_said(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(distributions, "CELLS", 40)  # ± 20 cm
    found = hoopgen.estimate(PLAYER, shots=2000, measures=["rebound_distance", "left_right"])
    assert found.measured["rebound_distance"].quantiles[0.95] == (np.inf, np.inf, np.inf)
    assert json.dumps(found.as_dict()["measured"], allow_nan=False).count('"inf"') > 3
    assert np.isfinite(found.measured["left_right"].quantiles[0.5]).all()
    assert " inf " in str(found)


def test_of_no_rebounds_nothing_is_said() -> None:
    still = hoopgen.Scatter({**FREE_THROW, "elevation": 0.9, "aim": 0.0})
    wanted = ["rebound_distance", "rebound_angle"]
    found = hoopgen.estimate(still, shots=10, measures=wanted)
    assert found.made == 10
    assert [found.measured[name].shots for name in wanted] == [0, 0]
    assert found.measured["rebound_angle"].shares == {}
    assert "rebound distance (m)" in str(found)
    assert "no rebounds" in str(found)
    json.dumps(found.as_dict(), allow_nan=False)


def test_what_is_said_of_measures_has_its_units() -> None:
    found = hoopgen.estimate(
        PLAYER, shots=20_000, measures=["rebound_distance", "left_right", "rebound_angle"]
    )
    text = str(found)
    assert "rebounds are caught at 2.5 m above the floor" in text
    assert "rebound distance (m)" in text
    assert "−0.00" not in text
    assert f"of {found.missed:,} rebounds, as the shooter sees them" in text
    with hoopgen.core.units.use_units("us"):
        assert "rebounds are caught at 8.2 ft above the floor" in str(found)
        assert "rebound distance (ft)" in str(found)
    told = found.as_dict()["measured"]["rebound_distance"]
    assert (told["unit"], told["catching_height"]) == ("m", 2.5)
    assert "catching_height" not in found.as_dict()["measured"]["left_right"]


@pytest.mark.parametrize(
    ("height", "error", "said"),
    [
        (0, ValueError, "catching_height: expected m above the floor, more than 0 and at most"),
        (250, ValueError, "more than 0 and at most 100, got 250"),
        (-1.0, ValueError, "more than 0 and at most 100, got -1.0"),
        (np.inf, ValueError, "more than 0 and at most 100, got inf"),
        (np.nan, ValueError, "more than 0 and at most 100, got nan"),
        ("2.5 m", TypeError, "catching_height: expected a number, m above the floor, got '2.5 m'"),
        (True, ValueError, "expected a number"),
        ([2.5], ValueError, "expected a number"),
    ],
)
def test_a_catching_height_that_is_none_is_refused(
    height: Any, error: type[Exception], said: str, tmp_path: Path
) -> None:
    states = PLAYER.draw(0, 2).states
    with pytest.raises(error, match=said):
        hoopgen.measure(states, hoopgen.simulate(states), catching_height=height)
    with pytest.raises(error, match=said):
        hoopgen.estimate(PLAYER, shots=10, catching_height=height)
    with pytest.raises(error, match=said):
        hoopgen.batch(_table(tmp_path), tmp_path / "out.csv", catching_height=height)


@pytest.mark.slow
def test_measures_that_there_are_not_are_refused() -> None:
    with pytest.raises(ValueError, match=r"measures: unknown rebound; is rebound_y meant\? One of"):
        hoopgen.estimate(PLAYER, shots=10, measures=["rebound"])
    with pytest.raises(ValueError, match="measures: unknown clearance"):
        hoopgen.estimate(PLAYER, shots=10, scene=hoopgen.COURT, measures=["clearance"])
    bowl = ROOT / "examples" / "scenes" / "bowl.toml"
    ball = hoopgen.Scatter({"x": 0.1, "y": 0.0, "z": 0.5, "vx": 0.0, "vy": 0.0, "vz": 0.0})
    with pytest.raises(ValueError, match="measures"):
        hoopgen.estimate(ball, scene=hoopgen.load_scene(bowl), shots=10, measures=["depth"])


# Tables, files, commands, pictures


def _table(folder: Path) -> Path:
    file = folder / "releases.csv"
    rows = [f"{7.0 + 0.02 * k},52,{0.3 * k}" for k in range(20)]
    file.write_text("\n".join(["speed,elevation_deg,azimuth_deg", *rows, ""]), encoding="utf-8")
    return file


PLACE = {"height": 2.1336, "distance": 4.191}


def test_a_table_says_at_which_height_its_rebounds_are(tmp_path: Path) -> None:
    file, out = _table(tmp_path), tmp_path / "out.parquet"
    wanted: dict[str, Any] = {"release": PLACE, "measures": ["rebound_x", "floor_x"]}
    hoopgen.batch(file, out, **wanted, catching_height=2.75)
    schema = pq.read_schema(out)
    about = schema.field("rebound_x_m").metadata
    assert about == {b"unit": b"m", b"catching_height_m": b"2.75"}
    assert schema.field("floor_x_m").metadata == {b"unit": b"m"}
    hoopgen.batch(file, tmp_path / "out.csv", **wanted, catching_height=2.75)
    about, head, *_ = (tmp_path / "out.csv").read_text(encoding="utf-8").splitlines()
    assert '"rebound_x_m"' in head
    assert json.loads(about.removeprefix("# hoopgen: "))["catching_height_m"] == 2.75
    again = hoopgen.batch(tmp_path / "out.csv", prefix="b_", measures=["rebound_y"]).to_arrow()
    assert {"rebound_x_m", "b_rebound_y_m"} <= set(again.column_names)
    hoopgen.batch(file, tmp_path / "plain.csv", release=PLACE)
    assert "catching_height" not in (tmp_path / "plain.csv").read_text(encoding="utf-8")


def test_chunks_with_another_catching_height_are_not_gone_on_with() -> None:
    from hoopgen.study.tables.flights import Flights

    def identity(measures: tuple[str, ...], height: float) -> dict[str, Any]:
        return Flights({}, {}, measures, 40, hoopgen.HOOP, height).identity()

    assert identity(("rebound_x",), 2.5) != identity(("rebound_x",), 2.6)
    assert identity(("depth",), 2.5) == identity(("depth",), 2.6)
    assert "catching_height" not in identity(("depth",), 2.5)


def test_the_commands_take_measures_and_the_height(tmp_path: Path) -> None:
    player = "--speed 7.17 --elevation 52deg --height 7ft --distance 13.75ft --scatter speed=0.07"
    wanted = [*player.split(), "--shots", 3000, "--measure", "rebound_distance"]
    result = succeed("estimate", *wanted, "--catching-height", "9ft", "--units", "us")
    assert "rebounds are caught at 9 ft above the floor" in result.stdout
    told = json.loads(run("estimate", *wanted, "--json").stdout)
    assert told["measured"]["rebound_distance"]["catching_height_m"] == CATCHING_HEIGHT
    versus = run("estimate", *wanted, "--versus", "backspin=0")
    assert versus.exit_code == 2
    assert "--measure is of one setting, without --versus." in versus.stderr
    none = run("estimate", *wanted, "--catching-height", "0m")
    assert none.exit_code == 2
    assert "--catching-height: expected m above the floor, more than 0" in none.stderr
    out = tmp_path / "out.csv"
    place = ["--release", "height=7ft", "--release", "distance=13.75ft"]
    columns = ["--measure", "rebound_x", "--catching-height", "3m"]
    assert run("batch", _table(tmp_path), "--out", out, *place, *columns).exit_code == 0
    assert "catching_height_m" in out.read_text(encoding="utf-8").splitlines()[0]


STUDY = """\
[study]
name = "Rebounds"
formats = ["svg"]

[release]
height = "7 ft"
distance = "13.75 ft"
elevation = "52 deg"
speed = 7.17

[scatter]
speed = 0.07
azimuth = "1 deg"

[[question]]
kind = "estimate"
name = "where"
title = "Rebounds"
shots = 2000
"""

ASKED = 'measures = ["rebound_distance", "rebound_angle"]\ncatching_height = "9 ft"\n'


def _study(folder: Path, more: str) -> Path:
    file = folder / "study.toml"
    file.write_text(STUDY + more, encoding="utf-8")
    return file


def test_a_study_asks_for_measures_and_draws_rebounds(tmp_path: Path) -> None:
    file = _study(tmp_path, ASKED + 'figures = ["rebounds"]\n')
    answer = run_study(file, threads=1)["where"]
    assert "rebounds are caught at 2.743 m above the floor" in answer.text
    assert answer.numbers["measured"]["rebound_angle"]["catching_height_m"] == 9 * 0.3048
    assert (tmp_path / "study-results" / "where" / "rebounds.svg").is_file()
    with pytest.raises(ValueError, match="catching_height"):
        run_study(_study(tmp_path, ASKED.replace("9 ft", "8 ft") + 'figures = ["rebounds"]\n'))


@pytest.mark.sampled(1)
@pytest.mark.parametrize("name", ["landings", "rebounds"])
def test_a_picture_with_nothing_to_show_costs_no_answer(tmp_path: Path, name: str) -> None:
    """A player who never misses has no places of misses and gets an answer all the same."""
    sure = f'figures = ["fan", "{name}"]\nrelease.speed = 7.2\nscatter = "none"\nshots = 50\n'
    file = tmp_path / "study.toml"
    file.write_text(STUDY.replace("shots = 2000\n", sure), encoding="utf-8")
    answer = run_study(file, threads=1)["where"]
    assert answer.line.startswith("100.0% made")
    assert answer.line.endswith("so there is no picture of where")
    there = {file.name for file in (tmp_path / "study-results" / "where").glob("*.svg")}
    assert there == {"fan.svg"}


def test_a_catching_height_of_nothing_caught_is_refused() -> None:
    thrown = "estimate --speed 7.17 --elevation 52deg --height 7ft --distance 13.75ft"
    more = "--scatter speed=0.1 --shots 100 --measure depth --catching-height 2m"
    result = run(*thrown.split(), *more.split())
    assert (result.exit_code, result.stdout) == (2, "")
    assert "--catching-height is of rebounds" in result.stderr


@pytest.mark.slow
def test_a_study_s_misses_are_on_the_court_of_its_scene(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked: dict[str, Any] = {}

    def drawn(*places: Any, **options: Any) -> Any:
        asked.update(options, parameters=places[2])
        return plot_landings(*places, **options)

    monkeypatch.setattr("hoopgen.plots.plot_landings", drawn)
    file = _study(tmp_path, 'figures = ["landings"]\n')
    told = file.read_text(encoding="utf-8")
    file.write_text(f'scene = {{ file = "court", preset = "fiba" }}\n{told}', encoding="utf-8")
    run_study(file, threads=1)
    assert asked["scene"].name == "court"
    assert find_court(asked.get("court"), asked["parameters"]) == COURTS["FIBA"]


def test_a_study_without_measures_is_the_one_that_it_was(tmp_path: Path) -> None:
    """A folder of results from before there were any can be gone on with."""

    def identity(more: str) -> dict[str, Any]:
        return check_study(_study(tmp_path, more))[0].identity()

    assert not {"measures", "catching_height"} & set(identity(""))
    assert "catching_height" not in identity('measures = ["depth"]\n')
    assert identity('figures = ["rebounds"]\n')["catching_height"] == CATCHING_HEIGHT


@pytest.mark.parametrize(
    ("more", "said"),
    [
        ('catching_height = "0 m"\n', "catching_height: expected m above the floor, more than 0"),
        ('catching_height = "9 kg"\n', "catching_height"),
        ('measures = ["rebound"]\n', "measures"),
    ],
)
def test_a_study_says_what_is_wrong_with_them(tmp_path: Path, more: str, said: str) -> None:
    with pytest.raises(StudyError, match=said):
        check_study(_study(tmp_path, more))


def test_a_place_of_many_balls_leaves_the_others_their_shades() -> None:
    """The darkest shade is for where nine in ten are; an arrow says that there is more."""
    random = np.random.default_rng(3)
    places = random.normal(0, 1, (20_000, 2))
    even = plot_landings(*places.T, hoopgen.NBA, height=2.5)
    (cells,) = even.axes[0].collections
    assert cells.norm.vmax == cells.get_array().max()
    assert cells.get_cmap().colorbar_extend is False
    places[:1000] = (1.5, 0.5)
    figure = plot_landings(*places.T, hoopgen.NBA, height=2.5)
    (cells,) = figure.axes[0].collections
    density = cells.get_array()
    within = density[density <= cells.norm.vmax].sum() / density.sum()
    assert 0.9 <= within < 0.96
    assert density.max() > 2 * cells.norm.vmax
    assert cells.colorbar.extend == "max"


def test_the_picture_says_the_height_and_the_shares_of_the_sectors() -> None:
    places = np.array([(1.0, 0.0)] * 5 + [(0.5, -1.0)] * 3 + [(0.5, 1.0), (-1.0, 0.1)])
    figure = plot_landings(*places.T, hoopgen.NBA, place=(4.191, 0.0), height=2.5)
    (note,) = (text.get_text() for text in figure.texts if text.get_text().startswith("10 of"))
    said = "10 of 10 misses come down within the picture, all at 2.5 m above the floor; in bold, "
    assert note.startswith(f"{said}shares of the")
    plan, bar = figure.axes
    bold = [text for text in plan.texts if text.get_fontweight() == "bold"]
    assert [text.get_text() for text in bold] == ["50%", "30%", "0%", "10%", "0%", "10%"]
    # The shooter's left is at the left of the picture, the shooter below.
    at = np.array([text.get_position() for text in bold])
    assert at[0, 1] < 0 < at[3, 1]
    assert at[1, 0] < 0 < at[5, 0]
    (left, right), (bottom, top) = plan.get_xlim(), plan.get_ylim()
    assert np.all((at > [left, bottom]) & (at < [right, top]))
    assert bar.get_ylabel() == "balls that come down there (% per m²)"
    floor = plot_landings(*places.T, hoopgen.NBA, place=(4.191, 0.0))
    assert not [text for text in floor.axes[0].texts if text.get_fontweight() == "bold"]
    with pytest.raises(ValueError, match="catching_height: expected m above the floor"):
        plot_landings(*places.T, hoopgen.NBA, height=-1.0)
