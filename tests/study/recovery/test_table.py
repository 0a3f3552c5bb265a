"""`hoopgen fit`: a table of tracks in, a table of releases out, which other commands read."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

pa = pytest.importorskip("pyarrow")
pd = pytest.importorskip("pandas")
pytest.importorskip("scipy")

import hoopgen  # noqa: E402
from hoopgen.core.units import FOOT  # noqa: E402
from hoopgen.study.recovery.table import fit_table  # noqa: E402
from hoopgen.study.tables.track_columns import frame_columns  # noqa: E402
from tests.helpers.commands import failure, output, succeed  # noqa: E402

from .tracks import Throws, noisy, throws  # noqa: E402

RATE = 30
COUNT = 12


@pytest.fixture(scope="module")
def thrown() -> Throws:
    return throws(COUNT, 50)


@pytest.fixture(scope="module")
def frames(thrown: Throws) -> Any:
    """Return a frame of pandas, a row each frame of the cameras, in no order."""
    times = np.arange(0.0, 1.6, 1 / RATE)
    positions = noisy(thrown.positions(times), 0.01, 51)
    rows, columns = np.nonzero(np.isfinite(positions[..., 0]))
    table = pd.DataFrame(
        {
            "shot": [f"00{row}" for row in rows],
            "player": np.where(rows % 2, "Ann", "Bea"),
            "Timestamp_ms": 1000 * (times[columns] + 7.0),
            **{
                f"{axis}_ft": positions[rows, columns, k] / FOOT
                for k, axis in enumerate(["x", "y", "z"])
            },
        }
    )
    return table.sample(frac=1.0, random_state=52)


@pytest.fixture
def file(frames: Any, tmp_path: Path) -> Path:
    path = tmp_path / "tracks.csv"
    frames.to_csv(path, index=False)
    return path


OPTIONS = ("--track", "shot", "--column", "time=Timestamp_ms", "--preset", "nba")


def read(path: Path) -> Any:
    return pd.read_csv(path, skiprows=1, dtype={"shot": str}).sort_values("shot")


def test_the_command_writes_what_other_commands_read(
    file: Path, thrown: Throws, tmp_path: Path
) -> None:
    out, results = tmp_path / "releases.csv", tmp_path / "results.csv"
    said = output("fit", file, "--out", out, *OPTIONS, "--keep", "player", "--backspin", "18rad/s")
    assert "shot as track, Timestamp_ms as time in ms, x_ft as x in ft" in said
    assert f"{COUNT} tracks, {COUNT} credible" in said
    found = read(out)
    truth = hoopgen.hoop.arguments.arguments_of(thrown.states)
    order = np.argsort([f"00{row}" for row in range(COUNT)])
    for name, column in {"speed": "speed_m_s", "elevation": "elevation_rad"}.items():
        error = found[f"sd_{column}"].to_numpy()
        assert np.all(np.abs(found[column] - truth[name][order]) < 5 * error)
        assert np.all(error < 0.02)
    np.testing.assert_allclose(found["release_time_s"], 7.0, rtol=0, atol=1e-9)
    assert found["player"].tolist() == [("Bea", "Ann")[row % 2] for row in order]
    said = output("batch", out, "--out", results, "--by", "player")
    assert "scene: NBA" in said
    assert "invalid" not in said.split("\n", 2)[2]
    assert "speed_m_s as speed in m/s" in said
    assert "backspin_rad_s as backspin in rad/s" in said
    simulated = read(results)
    direct = hoopgen.simulate(
        hoopgen.release(
            **{
                name: found[hoopgen.study.named_units.named(name)].to_numpy()
                for name in ("speed", "elevation", "azimuth", "backspin", "height", "distance")
            },
            angle=found["angle_rad"].to_numpy(),
        ),
        hoopgen.NBA,
    )
    assert simulated["outcome"].tolist() == [
        one.name.lower() for one in map(hoopgen.Outcome, direct.outcome)
    ]
    said = output("estimate", "--from", out, "--shots", 500, "--group", "player")
    assert "scene    NBA" in said
    assert "2 games" in said or "sample" in said


def test_other_units_and_formats_say_the_same(file: Path, frames: Any, tmp_path: Path) -> None:
    si, us = tmp_path / "si.csv", tmp_path / "us.parquet"
    succeed("fit", file, "--out", si, *OPTIONS)
    succeed("fit", file, "--out", us, *OPTIONS, "--units", "us")
    feet = pd.read_parquet(us).sort_values("shot")
    np.testing.assert_allclose(feet["height_ft"] * FOOT, read(si)["height_m"], rtol=1e-12)
    np.testing.assert_allclose(feet["sd_height_ft"] * FOOT, read(si)["sd_height_m"], rtol=1e-12)
    columns = {"time": "Timestamp_ms"}
    memory = fit_table(frames, track="shot", columns=columns, parameters=hoopgen.NBA)
    assert memory.path is None
    assert sorted(memory.fitted.labels) == sorted(set(frames["shot"]))
    table = memory.fitted.to_pandas().sort_values("track")
    np.testing.assert_allclose(table["speed_m_s"], read(si)["speed_m_s"], rtol=1e-12)


def test_json_has_the_noise(file: Path, tmp_path: Path) -> None:
    said = output("fit", file, "--out", tmp_path / "r.csv", *OPTIONS, "--noise", "1cm", "--json")
    record = json.loads(said)
    assert record["noise"] == [0.01] * 3
    assert record["tracks"] == record["credible"] == COUNT


def test_tracks_that_are_no_flights_become_invalid_rows(
    frames: Any, file: Path, tmp_path: Path
) -> None:
    spoilt = frames.astype({"x_ft": object})
    spoilt.loc[spoilt["shot"] == "001", "x_ft"] = "?"
    late = (spoilt["shot"] == "002") & (spoilt["Timestamp_ms"] > 7050)
    spoilt = spoilt[~late]
    spoilt.loc[spoilt.index[:2], "shot"] = ""
    spoilt.to_csv(file, index=False)
    out = tmp_path / "releases.csv"
    said = output("fit", file, "--out", out, *OPTIONS)
    assert f"{COUNT} tracks, {COUNT - 2} credible" in said
    assert "not credible: 2 too few frames" in said
    assert "without a time or a position" in said
    assert "left out: 2 rows without a track" in said
    assert read(out)["speed_m_s"].isna().sum() == 2
    said = output("batch", out, "--out", tmp_path / "results.csv")
    assert "2 invalid" in said


def test_a_table_without_tracks_is_one(tmp_path: Path, thrown: Throws) -> None:
    times = np.arange(0.0, 0.8, 1 / RATE)
    table = pd.DataFrame(thrown.in_flight(times)[0], columns=["X", "Y", "Z"]).assign(time=times)
    path = tmp_path / "one.csv"
    table.to_csv(path, index=False)
    said = output("fit", path, "--out", tmp_path / "r.csv", "--preset", "nba", "--noise", "1cm")
    assert "read: all rows are one track" in said
    assert "1 track, 1 credible" in said


@pytest.mark.parametrize(
    ("words", "text"),
    [
        (("--track", "name"), "--track: no column name; there are"),
        (("--column", "speed=x_ft"), "speed is none of time, x, y, z"),
        (("--column", "x=name"), "no column name; there are"),
        (("--column", "time_s=Timestamp_ms"), "the two names have different units"),
        ((), "none says time"),
        (("--release-time", "soon"), "--release-time: expected a number of seconds or detect"),
        (
            ("--column", "time=Timestamp_ms", "--noise", "0"),
            "--noise: expected a standard deviation above 0",
        ),
        (("--noise", "2deg"), "is not a unit of length"),
        (("--keep", "club"), "--keep: no column club"),
        (("--scene", "hoop.toml"), "hoop.toml"),
    ],
)
def test_bad_input_is_one_line(words: tuple[str, ...], text: str, file: Path) -> None:
    out = file.with_name("r.csv")
    assert text in failure("fit", file, "--out", out, *words)
    assert not out.exists()


def test_the_source_is_not_written_over(file: Path) -> None:
    assert "FILE reads it, too" in failure("fit", file, "--out", file, *OPTIONS)


def test_names_of_columns_say_units() -> None:
    names = ["Time_s", "x_in", "y_cm", "z", "x_note"]
    found = frame_columns(names)
    assert [(name, one.name) for name, one in found.items()] == [
        ("time", "Time_s"),
        ("x", "x_in"),
        ("y", "y_cm"),
        ("z", "z"),
    ]
    assert [one.unit for one in found.values()] == [1.0, 0.0254, 0.01, 1.0]
    with pytest.raises(ValueError, match=r"^columns z and z_m both say z"):
        frame_columns([*names, "z_m"])
    assert frame_columns([*names, "z_m"], {"z": "z_m"})["z"].name == "z_m"
