"""Measured releases in place of scatter: over a map, in a search, in every place that asks."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.helpers.commands import run, succeed

for _library in ("matplotlib", "pyarrow", "pydantic", "scipy", "xarray"):
    pytest.importorskip(_library)

import xarray as xr  # noqa: E402

import hoopgen  # noqa: E402
from hoopgen.core.variables import STATE  # noqa: E402
from hoopgen.study.jobs.objective import Player  # noqa: E402
from hoopgen.study.models.resample import Resample  # noqa: E402
from hoopgen.study.models.scatter import Scatter  # noqa: E402
from hoopgen.studyfile import check_study, run_study  # noqa: E402
from hoopgen.studyfile.reading import StudyError  # noqa: E402

DEGREE = np.pi / 180
_random = np.random.default_rng(11)
THROWN = {
    "speed": _random.normal(7.17, 0.07, 300),
    "elevation": _random.normal(52, 1.3, 300) * DEGREE,
    "azimuth": _random.normal(0, 1, 300) * DEGREE,
}
HERE = {"backspin": 6 * np.pi, "height": 2.1336, "distance": 4.191}
MEASURED = Resample({**THROWN, **HERE})
SHOTS = 3000


def agrees(cell: Any, found: hoopgen.study.questions.estimate_result.Estimate) -> None:
    counts = [cell[name].item() for name in ("made", "capped", "invalid", "uncertain")]
    assert counts == [found.made, found.capped, found.invalid, found.uncertain]
    assert cell["probability"].item() == found.probability


def test_a_cell_is_an_estimate_of_the_same_releases() -> None:
    values = [0.65, 0.75]
    dataset = hoopgen.map(MEASURED, {"restitution": values}, shots=SHOTS, seed=4)
    for place, value in enumerate(values):
        scene = hoopgen.PAPER | {"restitution": value}
        found = hoopgen.estimate(MEASURED, scene, shots=SHOTS, seed=4)
        agrees(dataset.isel(restitution=place), found)


def test_what_was_not_measured_is_mapped_over() -> None:
    left = {name: value for name, value in HERE.items() if name != "distance"}
    dataset = hoopgen.map(Resample({**THROWN, **left}), {"distance": [4.0, 4.2]}, shots=SHOTS)
    for place, value in enumerate((4.0, 4.2)):
        found = hoopgen.estimate(Resample({**THROWN, **HERE, "distance": value}), shots=SHOTS)
        agrees(dataset.isel(distance=place), found)
    assert dataset["height"].item() == HERE["height"]
    assert json.loads(dataset.attrs["columns"]) == [*THROWN, *left]


def test_the_mean_of_what_was_measured_is_moved() -> None:
    dataset = hoopgen.map(MEASURED, {"speed": [7.3]}, shots=SHOTS)
    moved = 7.3 + (THROWN["speed"] - THROWN["speed"].mean())
    agrees(
        dataset.isel(speed=0),
        hoopgen.estimate(Resample({**THROWN, **HERE, "speed": moved}), shots=SHOTS),
    )


def test_what_stands_for_what_was_measured_moves_its_mean() -> None:
    dataset = hoopgen.map(MEASURED, {"aim": [0.05]}, shots=SHOTS)
    mean = {name: float(np.mean(column)) for name, column in {**THROWN, **HERE}.items()}
    del mean["speed"]
    aimed = Scatter({**mean, "aim": 0.05}).draw(0, 1).columns["speed"].item()
    moved = aimed + (THROWN["speed"] - THROWN["speed"].mean())
    agrees(
        dataset.isel(aim=0),
        hoopgen.estimate(Resample({**THROWN, **HERE, "speed": moved}), shots=SHOTS),
    )


def test_states_vary_in_their_scene_alone() -> None:
    drawn = MEASURED.draw(0, 200).states
    states = Resample(dict(zip(STATE, drawn.T, strict=True)))
    dataset = hoopgen.map(states, {"restitution": [0.6]}, shots=SHOTS)
    found = hoopgen.estimate(states, hoopgen.PAPER | {"restitution": 0.6}, shots=SHOTS)
    agrees(dataset.isel(restitution=0), found)
    with pytest.raises(ValueError, match="these are states, of which speed cannot be varied"):
        hoopgen.map(states, {"speed": [7.0]}, shots=10)


@pytest.mark.slow
def test_an_optimum_moves_the_mean_of_the_measured_releases() -> None:
    best = hoopgen.optimum(MEASURED, ["elevation", "aim"], shots=SHOTS, margins=["speed"])
    moved = dict(THROWN)
    for name in ("speed", "elevation"):
        moved[name] = best.arguments[name] + (THROWN[name] - THROWN[name].mean())
    found = hoopgen.estimate(Resample({**moved, **HERE}), shots=SHOTS).sample
    before = hoopgen.estimate(MEASURED, shots=SHOTS).sample
    assert found is not None
    assert before is not None
    assert found.value > before.value
    assert best.shots == len(THROWN["speed"])  # each row is judged once
    assert best.margins["speed"].steady is not None
    assert json.loads(json.dumps(best.as_dict(), allow_nan=False))["model"]["model"] == "resample"
    assert best.lead(best)[0] == 0.0


@pytest.mark.slow
def test_margins_and_bank_shots_take_them_too() -> None:
    found = hoopgen.margins(MEASURED, names=["speed"], shots=500)["speed"]
    assert found.value == pytest.approx(THROWN["speed"].mean(), rel=1e-15, abs=0.0)
    assert found.steady is not None
    both = hoopgen.bank_or_direct(MEASURED, [(1.5, 2.6)], shots=500)
    assert (both["probability"] > 0.0).all()


@pytest.mark.parametrize("question", [hoopgen.map, hoopgen.optimum])
def test_another_model_is_refused(question: Any) -> None:
    with pytest.raises(TypeError, match=r"model: expected a Scatter or a Resample, got \{"):
        question(dict(HERE), {"speed": [7.0, 7.2]})
    with pytest.raises(ValueError, match="release: height already in over"):
        question(Scatter(HERE, {"speed": 0.1}), {"height": [2.0, 2.2]})


def test_the_words_are_the_same() -> None:
    assert Scatter(release=HERE, sd={"speed": 0.1}).identity()["release"] == HERE
    with pytest.raises(TypeError, match="mean"):
        Scatter(mean=HERE)  # type: ignore[call-arg]


def test_a_player_is_equal_to_one_of_the_same_releases() -> None:
    assert Resample({**THROWN, **HERE}) == MEASURED != Resample(THROWN)
    assert Player(MEASURED) == Player(Resample({**THROWN, **HERE}))


# From a file


@pytest.fixture
def table(tmp_path: Path) -> Path:
    file = tmp_path / "throws.csv"
    degrees = {n: c / DEGREE if n != "speed" else c for n, c in THROWN.items()}
    head = "speed,elevation_deg,azimuth_deg"
    np.savetxt(file, np.stack([*degrees.values()], -1), "%.17g", ",", header=head, comments="")
    return file


GIVEN = ["--backspin", "3Hz", "--height", "7ft", "--distance", "13.75ft"]


def read(table: Path) -> Resample:
    columns = np.loadtxt(table, delimiter=",", skiprows=1).T
    speed, elevation, azimuth = columns
    given: Mapping[str, Any] = {"height": 7 * 0.3048, "distance": 13.75 * 0.3048}
    angles = {"elevation": elevation * DEGREE, "azimuth": azimuth * DEGREE}
    return Resample({"speed": speed, **angles, "backspin": 3 * (2 * np.pi), **given})


@pytest.mark.slow
def test_on_the_command_line_map_and_optimum_take_a_file(table: Path, tmp_path: Path) -> None:
    file = tmp_path / "map.nc"
    asked = ["map", "--from", str(table), *GIVEN, "--over", "restitution=0.6,0.7", "--shots", "500"]
    result = succeed(*asked, "--out", str(file))
    wanted = hoopgen.map(read(table), {"restitution": [0.6, 0.7]}, shots=500)
    assert (
        xr.load_dataset(file, engine="scipy")["made"].values.tolist()
        == wanted["made"].values.tolist()
    )
    asked = ["optimum", "--from", str(table), *GIVEN, "--over", "elevation", "--over", "aim"]
    result = succeed(*asked, "--shots", "500", "--json")
    best = hoopgen.optimum(read(table), ["elevation", "aim"], shots=500)
    assert json.loads(result.stdout)["made"] == best.made
    result = run(*asked, "--scatter", "speed=0.1")
    assert "--scatter is about a release, and --from has many" in result.stderr


STUDY = """
[study]
name = "Measured"
[release]
height = "7 ft"
distance = "13.75 ft"
backspin = "3 Hz"
[releases]
file = "throws.csv"
[[question]]
kind = "map"
name = "map"
over.restitution = [0.6, 0.7]
shots = 500
[[question]]
kind = "optimum"
name = "best"
over = ["elevation", "aim"]
shots = 500
margins = []
"""


@pytest.mark.slow
def test_in_a_study_map_and_optimum_take_a_file(table: Path, tmp_path: Path) -> None:
    (tmp_path / "study.toml").write_text(STUDY)
    run_study(tmp_path / "study.toml", tmp_path / "out")
    dataset = xr.load_dataset(tmp_path / "out" / "map" / "map.nc", engine="scipy")
    wanted = hoopgen.map(read(table), {"restitution": [0.6, 0.7]}, shots=500)
    assert dataset["made"].values.tolist() == wanted["made"].values.tolist()
    answer = json.loads((tmp_path / "out" / "best" / "answer.json").read_text(encoding="utf-8"))
    best = hoopgen.optimum(read(table), ["elevation", "aim"], shots=500, margins=[])
    assert answer["numbers"]["made"] == best.made


def test_what_measured_releases_cannot_is_said_before_any_work(table: Path, tmp_path: Path) -> None:
    (tmp_path / "study.toml").write_text(STUDY.replace('height = "7 ft"\n', ""))
    with pytest.raises(StudyError, match="missing height"):
        check_study(tmp_path / "study.toml")
