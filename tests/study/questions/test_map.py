"""Maps: each cell is what it would be alone, and the dataset says what it holds."""

from __future__ import annotations

import csv
import itertools
import json
import math
import pickle
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray as xr

import hoopgen
from hoopgen import Outcome, Scatter, estimate
from hoopgen.cli.types import AXIS
from hoopgen.hoop.kinds import Kind, kinds
from hoopgen.hoop.variables import VARIABLES, resolve_variables
from hoopgen.study.named_units import named
from hoopgen.study.questions import map_dataset, sweep
from hoopgen.study.tables.columns import columns_of
from tests.helpers import contents
from tests.helpers.commands import output, run

DEGREE = math.pi / 180
PLACE = {"height": 2.1336, "distance": 4.191}
SD = {"speed": 0.07, "elevation": 1.3 * DEGREE, "azimuth": DEGREE}
CORRELATION = {("speed", "elevation"): -0.4}
OVER = {"elevation": np.radians([48, 52, 56]), "speed": np.array([7.0, 7.1, 7.2, 7.3])}
REST = PLACE | {"backspin": 6 * math.pi}


@pytest.fixture(autouse=True)
def small_chunks(monkeypatch: pytest.MonkeyPatch) -> None:
    """Few cells and few shots in a chunk, so that small maps have many."""
    monkeypatch.setattr(sweep, "CHUNK", 600)
    monkeypatch.setattr(sweep, "BLOCK", 256)


def cells(dataset: xr.Dataset, over: Any) -> Any:
    """Yield the values and the cell of every combination."""
    for place in itertools.product(*(range(len(values)) for values in over.values())):
        at = dict(zip(over, place, strict=True))
        yield {name: float(over[name][i]) for name, i in at.items()}, dataset.isel(at)


# With scatter


@pytest.mark.parametrize(
    ("over", "release", "sd"),
    [
        (OVER, REST, SD),
        ({"aim": [-0.05, 0.0, 0.05], "entry": [0.7, 0.8]}, REST, SD),
        ({"x": [2.0, 3.0], "y": [-2.0, 0.5]}, {"height": 2.1, "aim": 0.05, "elevation": 0.95}, SD),
        ({"restitution": [0.6, 0.8], "ball_radius": [0.11, 0.12]}, REST | {"entry": 0.75}, SD),
        ({"gravity": [9.7, 9.9]}, REST | {"entry": 0.75}, SD | {"restitution": 0.05}),
        ({"speed": [7.1]}, REST | {"elevation": 0.9, "restitution": 0.65}, SD),
        (
            {"backspin": [0.0, 19.0], "height": [1.9, 2.2], "azimuth": [0.0, 0.02]},
            {"distance": 4.0, "aim": 0.0, "elevation": 0.9},
            SD | {"restitution": 0.02, "height": 0.02},
        ),
    ],
    ids=lambda value: ",".join(value),
)
def test_a_cell_is_the_estimate_of_its_release(over: Any, release: Any, sd: Any) -> None:
    scene = hoopgen.NBA
    dataset = hoopgen.map(Scatter(release, sd, CORRELATION), over, scene, shots=300, seed=5)
    assert dataset["probability"].dims == tuple(over)
    for at, cell in cells(dataset, over):
        alone = estimate(Scatter(release | at, sd, CORRELATION), scene, shots=300, seed=5)
        is_the_estimate(cell, alone, set(map_dataset.number_labels(hoopgen.HOOP)) - ROLLING)


ROLLING = {"lodged", "endless"}
"""Outcomes that a shot has only where balls roll."""


def is_the_estimate(cell: xr.Dataset, alone: Any, counts: set[str]) -> None:
    """Assert that all numbers of a cell are there, and are those of an estimate."""
    numbers = {"probability", "low", "high", *counts}
    assert set(cell.data_vars) == numbers | {"share"}
    assert {name: cell[name].item() for name in numbers} == {n: getattr(alone, n) for n in numbers}
    shares = dict(zip(cell["kind"].values.tolist(), cell["share"].values.tolist(), strict=True))
    assert shares == alone.shares


def test_where_balls_roll_a_cell_is_the_estimate_too() -> None:
    """All counts are compared, on a dead rim, where some balls come to rest or roll for ever."""
    scene: dict[str, Any] = {"scene": hoopgen.COURT, "shots": 300, "seed": 5}
    parameters = hoopgen.NBA_COURT | {"ring_restitution": 0.3}
    over = {"speed": [7.1, 7.25]}
    release = REST | {"elevation": 0.9}
    dataset = hoopgen.map(Scatter(release, SD), over, parameters, **scene)
    for at, cell in cells(dataset, over):
        alone = estimate(Scatter(release | at, SD), parameters, **scene)
        is_the_estimate(cell, alone, set(map_dataset.number_labels(hoopgen.COURT)))
    assert dataset["rolled"].values.all()


def test_a_probability_that_cannot_be_is_not_a_number() -> None:
    dataset = hoopgen.map(
        Scatter(REST | {"entry": 0.75}, SD), {"restitution": [0.7, 1.2]}, shots=50
    )
    assert dataset["invalid"].values.tolist() == [0, 50]
    assert np.isnan(dataset["probability"].values).tolist() == [False, True]
    assert (dataset["low"][1].item(), dataset["high"][1].item()) == (0.0, 1.0)


def test_a_scatter_of_zero_is_a_scatter() -> None:
    dataset = hoopgen.map(
        Scatter(REST | {"elevation": 0.9}, {"speed": 0}), {"speed": [7.0, 7.17]}, shots=20
    )
    assert set(dataset["probability"].values) <= {0.0, 1.0}
    assert dataset["shots"].values.tolist() == [20, 20]


def test_by_default_a_cell_has_10_000_shots() -> None:
    dataset = hoopgen.map(Scatter(REST | {"elevation": 0.9}, SD), {"speed": [7.1]})
    assert dataset["shots"].values.tolist() == [10_000]


# Without


def test_without_scatter_a_cell_is_one_shot() -> None:
    dataset = hoopgen.map(Scatter(REST), OVER, hoopgen.FIBA)
    assert set(dataset.data_vars) == {"outcome", "kind", "uncertain"}
    for at, cell in cells(dataset, OVER):
        shot = resolve_variables(REST | at, hoopgen.FIBA)
        one = hoopgen.simulate(shot.states, shot.parameters)
        assert cell["outcome"].item() == one.outcome[0]
        assert cell["kind"].item() == kinds(one.outcome, one.counts, one.first)[0]
        assert cell["uncertain"].item() == one.uncertain[0]


def test_codes_are_named_as_the_cf_conventions_want() -> None:
    dataset = hoopgen.map(Scatter(REST), OVER)
    for name, codes in (("outcome", Outcome), ("kind", Kind)):
        variable = dataset[name]
        assert variable.dtype == variable.attrs["flag_values"].dtype == np.uint8
        assert variable.attrs["flag_values"].tolist() == [code.value for code in codes]
        assert variable.attrs["flag_meanings"].split() == [code.name.lower() for code in codes]
    assert dataset["uncertain"].dtype == bool


def test_scatter_of_nothing_is_none() -> None:
    assert "outcome" in hoopgen.map(Scatter(REST, {}), OVER)


# The dataset


def test_coordinates_have_units_and_names() -> None:
    over = {"entry": [0.7, 0.8], "restitution": [0.6, 0.7], "gravity": [9.8]}
    dataset = hoopgen.map(Scatter(REST | {"aim": 0.05}, SD), over, shots=20)
    assert list(dataset.sizes) == [*over, "kind"]
    for name in (*over, *REST, "aim"):
        assert dataset[name].attrs["long_name"] == VARIABLES[name].label
    units = {name: dataset[name].attrs["units"] for name in dataset.coords if name != "kind"}
    assert units == {
        "entry": "rad",
        "restitution": "1",
        "gravity": "m/s2",
        "height": "m",
        "distance": "m",
        "backspin": "rad/s",
        "aim": "m",
    }
    assert dataset["entry"].values.tolist() == [0.7, 0.8]
    assert dataset["aim"].item() == 0.05
    assert dataset["kind"].values.tolist() == [kind.name.lower() for kind in Kind]
    assert all("long_name" in dataset[name].attrs for name in dataset.variables)
    assert "90% interval" in str(
        hoopgen.map(Scatter(REST, SD), over, shots=9, confidence=0.9)["low"].attrs
    )


def test_attributes_say_what_made_it() -> None:
    dataset = hoopgen.map(
        Scatter(REST | {"entry": 0.8, "ball_radius": 0.12}, SD, CORRELATION),
        {"restitution": [0.6]},
        hoopgen.NBA,
        shots=20,
        seed=2**64 - 1,
        max_contacts=30,
        confidence=0.9,
    )
    assert dataset.attrs["source"] == f"hoopgen {hoopgen.__version__}"
    assert dataset.attrs["Conventions"].startswith("CF-")
    assert int(dataset.attrs["seed"]) == 2**64 - 1
    assert dataset.attrs["confidence"] == 0.9
    assert dataset.attrs["max_contacts"] == 30
    assert json.loads(dataset.attrs["sd"]) == SD
    assert json.loads(dataset.attrs["correlation"]) == [["speed", "elevation", -0.4]]
    parameters = json.loads(dataset.attrs["parameters"])
    assert parameters == {
        **{name: value for name, value in hoopgen.NBA.items() if name != "restitution"},
        "ball_radius": 0.12,
    }


@pytest.mark.parametrize("sd", [None, SD])
def test_it_goes_to_netcdf_and_back(tmp_path: Path, sd: Any) -> None:
    dataset = hoopgen.map(
        Scatter(REST, sd or {}), OVER, **({"shots": 30, "seed": 2**63} if sd else {})
    )
    dataset.to_netcdf(tmp_path / "map.nc", engine="scipy")
    with xr.open_dataset(tmp_path / "map.nc", engine="scipy") as file:
        read = file.load()
    xr.testing.assert_equal(read, dataset)
    for name in dataset.variables:
        assert list(read[name].attrs) == list(dataset[name].attrs)
    assert read.attrs == dataset.attrs


# The same result


@pytest.mark.sampled(6)
@pytest.mark.parametrize("sd", [None, SD])
@pytest.mark.parametrize("chunk", [1, 7, 5000])
@pytest.mark.parametrize("block", [7, 50, 5000])
def test_chunks_threads_and_backends_change_nothing(
    sd: Any, chunk: int, block: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    def made(**how: Any) -> xr.Dataset:
        return hoopgen.map(Scatter(REST, sd or {}), OVER, shots=60 if sd else None, **how)

    wanted = made(threads=1)
    monkeypatch.setattr(sweep, "BLOCK", block)
    monkeypatch.setattr(sweep, "CHUNK", max(chunk, block))
    xr.testing.assert_identical(made(threads=2), wanted)
    if chunk == 5000:
        xr.testing.assert_identical(made(backend="numpy"), wanted)


def job(model: Scatter, over: Any, shots: int) -> sweep.Sweep:
    return sweep.Sweep(over, model, hoopgen.PAPER, shots, 0, 40, "auto", hoopgen.HOOP)


def test_a_chunk_may_be_computed_by_another_process() -> None:
    work = job(Scatter(REST, SD, CORRELATION), OVER, 100)
    there = pickle.loads(pickle.dumps(work))
    assert there.compute(1).equals(work.compute(1))
    assert there.identity() == json.loads(json.dumps(work.identity()))


@pytest.mark.parametrize("sd", [None, SD])
def test_a_folder_is_gone_on_from(tmp_path: Path, sd: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sweep, "CHUNK", 5)
    monkeypatch.setattr(sweep, "BLOCK", 5)
    shots = {"shots": 12} if sd else {}
    wanted = hoopgen.map(Scatter(REST, sd or {}), OVER, **shots, folder=tmp_path)
    lost = sorted(tmp_path.glob("chunk-*.arrow"))[1]
    lost.unlink()
    said: list[tuple[int, int | None]] = []
    again = hoopgen.map(
        Scatter(REST, sd or {}),
        OVER,
        **shots,
        folder=tmp_path,
        progress=lambda *now: said.append(now),
    )
    xr.testing.assert_identical(again, wanted)
    chunks = len(list(tmp_path.glob("chunk-*.arrow")))
    assert chunks > 2
    assert said == [(done, chunks) for done in range(chunks + 1)]
    with pytest.raises(ValueError, match="there and"):
        hoopgen.map(Scatter(REST | {"sidespin": 1.0}, sd or {}), OVER, **shots, folder=tmp_path)


@pytest.fixture
def thrown(monkeypatch: pytest.MonkeyPatch) -> list[tuple[int, int]]:
    """Return the cell and number of each sampled shot, once for each time it is sampled."""
    found: list[tuple[int, int]] = []
    counted = sweep.Sweep.counted

    def noted(work: Any, chunk: int, start: int, stop: int, *before: Any) -> Any:
        found.extend(itertools.product(range(*work.cells(chunk)), range(start, stop)))
        return counted(work, chunk, start, stop, *before)

    monkeypatch.setattr(sweep.Sweep, "counted", noted)
    return found


@pytest.mark.sampled(1)
@pytest.mark.parametrize("first", [1, 100, 256, 300])
def test_a_folder_can_be_asked_for_more_shots_and_only_the_rest_is_thrown(
    first: int, tmp_path: Path, thrown: list[tuple[int, int]]
) -> None:
    """The runs end within the chunks of every cell, at their end, and in further ones."""
    model, most = Scatter(REST, SD), 600  # more than two blocks
    wanted = hoopgen.map(model, OVER, shots=most, folder=tmp_path / "at-once")
    hoopgen.map(model, OVER, shots=first, folder=tmp_path / "more")
    few = contents(tmp_path / "more")
    thrown.clear()
    found = hoopgen.map(model, OVER, shots=most, folder=tmp_path / "more", threads=2)
    xr.testing.assert_identical(found, wanted)
    assert sorted(thrown) == sorted(itertools.product(range(12), range(first, most)))
    whole = contents(tmp_path / "more")
    assert whole == contents(tmp_path / "at-once")
    assert whole.keys() > few.keys() or first == 300
    # And for fewer again, which costs nothing of it.
    again = hoopgen.map(model, OVER, shots=first, folder=tmp_path / "more")
    xr.testing.assert_identical(again, hoopgen.map(model, OVER, shots=first))
    assert contents(tmp_path / "more") == whole


def test_many_cells_are_in_chunks_of_many(monkeypatch: pytest.MonkeyPatch) -> None:
    """Whatever the number of shots: not one file for a few hundred shots."""
    monkeypatch.setattr(sweep, "CHUNK", 1 << 17)
    monkeypatch.setattr(sweep, "BLOCK", 1 << 14)
    for cells, shots, chunks in ((12, 100, 2), (5000, 100, 64), (5000, 20_000, 128)):
        over = {"speed": np.linspace(7.0, 8.0, cells)}
        assert job(Scatter(REST | {"elevation": 0.9}, SD), over, shots).chunks == chunks


def test_whole_numbers_may_be_numpy_s(tmp_path: Path) -> None:
    given = {"shots": np.int64(20), "seed": np.uint8(3), "max_contacts": np.int64(5)}
    plain = {name: int(value) for name, value in given.items()}
    maps = [hoopgen.map(Scatter(REST, SD), OVER, **one, folder=tmp_path) for one in (given, plain)]
    xr.testing.assert_identical(*maps)


@pytest.mark.parametrize(
    ("change", "error", "message"),
    [
        ({"over": {}}, ValueError, "over: expected a variable and its values at the least"),
        ({"over": {"pace": [1.0]}}, ValueError, "over: unknown pace. One of speed"),
        ({"over": {"speed": 7.0}}, ValueError, r"over\['speed'\]: expected a list of numbers"),
        ({"over": {"speed": []}}, ValueError, r"over\['speed'\]: expected a list of numbers"),
        ({"over": {"speed": ["a"]}}, TypeError, r"over\['speed'\]: expected numbers"),
        (
            {"over": {"height": [2.0]}},
            ValueError,
            "release: height already in over; leave out of one",
        ),
        ({"release": PLACE}, ValueError, "variables: expected speed and elevation, or aim"),
        ({"release": {"elevation": 0.9}}, ValueError, "variables: missing height, distance"),
        ({"release": {"elevations": 0.9}}, ValueError, "release: unknown elevations"),
        (
            {"release": PLACE | {"elevation": [0.9]}},
            ValueError,
            r"release\['elevation'\]: expected one number, got \[0.9\]",
        ),
        (
            {"release": PLACE | {"elevation": 0.9, "aim": 0.1}},
            ValueError,
            "aim takes the place of speed; got both",
        ),
        ({"sd": {"aim": 0.1}}, ValueError, "sd: unknown aim"),
        ({"sd": {}, "shots": 10}, ValueError, "shots: without scatter all shots of a cell are one"),
        ({"shots": 0}, ValueError, "shots: expected a whole number from 1"),
        ({"parameters": {"weight": 9.8}}, ValueError, "parameters: unknown weight"),
        ({"confidence": 0}, ValueError, "confidence: expected a number within 0 and 1"),
        ({"seed": 1.5}, ValueError, "seed: expected a whole number"),
        ({"max_contacts": 0}, ValueError, "max_contacts: expected a whole number from 1"),
        ({"max_contacts": 2.5}, ValueError, "max_contacts: expected a whole number from 1"),
    ],
)
def test_what_is_wrong_is_said(
    tmp_path: Path, change: Any, error: type[Exception], message: str
) -> None:
    given: dict[str, Any] = {"over": {"speed": [7.1, 7.2]}, "release": REST | {"elevation": 0.9}}
    given |= {"sd": SD, "folder": tmp_path / "kept"} | change
    release, sd, over = (given.pop(name) for name in ("release", "sd", "over"))
    with pytest.raises(error, match=message):
        hoopgen.map(Scatter(release, sd), over, **given)
    assert not (tmp_path / "kept").exists()


# On the command line

FREE_THROW = ["--height", "7ft", "--distance", "13.75ft", "--backspin", "3Hz"]
GRID = ["map", "--over", "elevation=48deg:56deg:3", "--over", "speed=7.0,7.1,7.2,7.3"]
SCATTER = ["--scatter", "speed=0.07", "--scatter", "elevation=1.3deg", "--scatter", "azimuth=1deg"]


def test_netcdf_is_what_the_library_gives(tmp_path: Path) -> None:
    out = tmp_path / "map.nc"
    arguments = [*GRID, *FREE_THROW, *SCATTER, "--shots", "50", "--seed", "3", "--preset", "fiba"]
    text = output(*arguments, "--out", str(out))
    over = {"elevation": np.linspace(48 * DEGREE, 56 * DEGREE, 3), "speed": OVER["speed"]}
    wanted = hoopgen.map(Scatter(REST, SD), over, hoopgen.FIBA, shots=50, seed=3)
    with xr.open_dataset(out, engine="scipy") as file:
        xr.testing.assert_equal(file.load(), wanted)
        assert file.attrs == wanted.attrs
    best = wanted.isel(wanted["probability"].argmax(...))
    assert text.splitlines()[0] == "map    3 elevation × 4 speed, 50 shots each"
    assert text.splitlines()[1].startswith(f"best   {100 * best['probability'].item():.1f}% made (")
    assert f"at elevation {best['elevation'].item() / DEGREE:.1f}°" in text


def test_csv_has_a_row_for_each_cell_in_columns_that_batch_reads(tmp_path: Path) -> None:
    out = tmp_path / "map.csv"
    text = output(*GRID, *FREE_THROW, "--out", str(out))
    wanted = hoopgen.map(Scatter(REST), OVER)
    with out.open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == 12
    for row, (at, cell) in zip(rows, cells(wanted, OVER), strict=True):
        read = {name: float(row[named(name)]) for name in at}
        assert read == pytest.approx(at, rel=1e-15)
        assert Outcome[row["outcome"].upper()] == cell["outcome"].item()
        assert Kind[row["kind"].upper()] == cell["kind"].item()
        assert row["uncertain"] == str(cell["uncertain"].item())
    # The scene too, and nothing else that would be read.
    assert set(columns_of(rows[0])) == {*OVER, *REST, *hoopgen.PAPER}
    assert {n: float(rows[0][n]) for n in hoopgen.PAPER} == dict(hoopgen.PAPER)
    assert {"elevation_rad", "speed_m_s", "height_m", "backspin_rad_s"} <= {*rows[0]}
    made = np.mean(wanted["outcome"].values == Outcome.MADE)
    assert text.startswith("map    3 elevation × 4 speed, one shot each\nshots  ")
    assert f"{100 * made:.1f}% made" in text


def test_json_has_the_cells_in_order_and_what_all_share() -> None:
    given = [*FREE_THROW, *SCATTER, "--shots", "40", "--seed", "3"]
    record = json.loads(output(*GRID, *given, "--json"))
    wanted = hoopgen.map(Scatter(REST, SD), OVER, shots=40, seed=3)
    assert record["over"] == {
        "elevation_rad": pytest.approx(OVER["elevation"].tolist(), rel=1e-15),
        "speed_m_s": OVER["speed"].tolist(),
    }
    assert record["cells"]["made"] == wanted["made"].values.ravel().tolist()
    assert record["cells"]["share_rim"] == wanted["share"].sel(kind="rim").values.ravel().tolist()
    assert record["best"]["probability"] == max(record["cells"]["probability"])
    assert record["setting"]["sd"].keys() == {"speed_m_s", "elevation_rad", "azimuth_rad"}
    assert record["setting"]["release"].keys() == {"height_m", "distance_m", "backspin_rad_s"}
    assert record["setting"]["parameters"]["ring_radius_m"] == hoopgen.PAPER["ring_radius"]
    assert (record["seed"], record["scene"]) == (3, "PAPER (the article's)")
    single = json.loads(output(*GRID, *FREE_THROW, "--json"))
    codes = hoopgen.map(Scatter(REST), OVER)["outcome"].values.ravel()
    assert single["cells"]["outcome"] == [Outcome(code).name.lower() for code in codes]


def test_csv_has_the_shares_of_kinds(tmp_path: Path) -> None:
    out = tmp_path / "map.csv"
    output(*GRID, *FREE_THROW, *SCATTER, "--shots", "40", "--out", str(out))
    with out.open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    for row in rows:
        shares = [float(row[f"share_{kind.name.lower()}"]) for kind in Kind]
        assert sum(shares) == pytest.approx(1.0, rel=1e-15)
        assert float(row["probability"]) == int(row["made"]) / 40


def test_aim_and_places_may_be_mapped_over() -> None:
    text = output(
        *["map", "--over", "x=2m:4m:3", "--over", "y=-1,1", "--aim", "5cm", "--entry", "45deg"],
        *["--height", "7ft"],
    )
    assert text.startswith("map    3 x × 2 y, one shot each")


def test_where_nothing_can_be_simulated_it_says_so() -> None:
    arguments = ["--over", "restitution=1.1,1.2", *FREE_THROW, "--entry", "45deg", *SCATTER]
    text = output("map", *arguments, "--shots", "5")
    assert "\nbest   none: no cell can be simulated\n\nscene    PAPER" in text


@pytest.mark.slow
def test_a_picture_is_drawn(tmp_path: Path) -> None:
    out = tmp_path / "map.svg"
    output(*GRID, *FREE_THROW, *SCATTER, "--shots", "40", "--picture", str(out))
    assert out.read_text(encoding="utf-8").startswith("<?xml")


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ([*GRID, *FREE_THROW, "--out", "map.txt"], "'map.txt' ends in none of .nc, .csv"),
        ([*GRID, *FREE_THROW, "--over", "speed=7:8:3"], "'--over': speed is given twice"),
        ([*GRID, *FREE_THROW, "--speed", "7"], "--speed and --over speed: leave one out"),
        (["map", *FREE_THROW], "missing --over"),
        (["map", "--over", "speed=7:8", *FREE_THROW], "speed: '7:8' is neither from:to:count"),
        (["map", "--over", "speed=7:8:1", *FREE_THROW], "speed: '7:8:1' is neither from:to:count"),
        (["map", "--over", "speed=7:8:x", *FREE_THROW], "speed: '7:8:x' is neither from:to:count"),
        (["map", "--over", "speed=7,b", *FREE_THROW], "speed: 'b' is not a number with a unit"),
        (["map", "--over", "tempo=7:8:3"], "'tempo' is none of speed"),
        ([*GRID, *FREE_THROW, "--shots", "10"], "without scatter all shots of a cell are one"),
    ],
)
def test_what_is_wrong_on_the_command_line_is_said(arguments: list[str], message: str) -> None:
    result = run(*arguments)
    assert result.exit_code == 2
    assert message in result.stderr
    assert result.stderr.count("\n") == 1


def test_axes_take_units() -> None:
    read = AXIS.convert("elevation=45deg:1rad:3", None, None)
    assert read[0] == "elevation"
    np.testing.assert_array_equal(read[1], np.linspace(45 * DEGREE, 1.0, 3))
    assert AXIS.convert("height = 6ft8in, 2", None, None)[1].tolist() == [80 * 0.0254, 2.0]
