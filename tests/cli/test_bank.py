"""``hoopgen bank``: what the library gives, in words, as JSON and in a picture."""

from __future__ import annotations

import json
import math
import re
import shlex
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.helpers.commands import output, run

for _library in ("pyarrow", "scipy", "xarray"):
    pytest.importorskip(_library)

import xarray as xr  # noqa: E402

import hoopgen  # noqa: E402
from hoopgen import Scatter, bank_or_direct  # noqa: E402
from hoopgen.cli import main  # noqa: E402
from hoopgen.study.questions.bank import places_of, verdict  # noqa: E402

pytestmark = pytest.mark.xdist_group("bank")  # the search is made once

DEGREE = math.pi / 180
SD = {"speed": 0.07, "elevation": 1.3 * DEGREE, "azimuth": DEGREE}
RELEASE = {"height": 2.1336, "backspin": 6 * math.pi}
PLAYER = Scatter(RELEASE, SD)

REST = ["--height", "7ft", "--backspin", "3Hz", "--scatter", "speed=0.07"]
REST += ["--scatter", "elevation=1.3deg", "--scatter", "azimuth=1deg"]
BANK = ["bank", *REST]
SIDE = ["--x", "1.5m", "--y", "2.6m"]


@pytest.fixture(scope="module")
def side() -> xr.Dataset:
    return bank_or_direct(PLAYER, [(1.5, 2.6)], hoopgen.NBA, shots=3000, seed=4)


@pytest.mark.slow
def test_one_place_is_told_at_length(side: xr.Dataset) -> None:
    text = output(*BANK, *SIDE, "--preset", "nba", "--shots", "3000", "--seed", "4")
    lines = {line[:9].strip(): line[9:] for line in text.splitlines() if line}
    assert lines["place"] == "3.002 m from the ring, 60.0° around it (x 1.500 m, y 2.600 m)"
    here = side.isel(place=0)
    for way in ("direct", "bank"):
        found = here.sel(way=way)
        assert lines[way].startswith(f"{100 * found.probability.item():.1f}% (")
        assert f"from {found.speed.item():.3f} m/s at " in lines[way]
    touch = f"{100 * here.touch_z.item():.1f} cm above the ring, {100 * here.touch_y.item():.1f} cm"
    assert f"touches the board {touch} to the right of its middle" in lines["bank"]
    assert lines["verdict"].startswith(f"bank less direct {100 * here.difference.item():+.1f} poi")
    assert lines["verdict"].endswith(": the bank shot is better")
    assert lines["shots"] == "3,000 fresh ones of each way, from each place; 95% intervals"
    assert (lines["scene"], lines["seed"]) == ("NBA", "4")
    assert lines["release"] == "backspin 3 Hz, height 2.1336 m"


@pytest.mark.slow
def test_as_json_it_is_what_the_library_gives(side: xr.Dataset) -> None:
    asked = [*BANK, *SIDE, "--preset", "nba", "--shots", "3000", "--seed", "4", "--json"]
    record = json.loads(output(*asked))
    (place,) = record["places"]
    here = side.isel(place=0)
    names = {"touch_y_m": "touch_y", "touch_z_m": "touch_z", "sight_y_m": "sight_y", "x_m": "x"}
    names |= {name: name for name in ("difference", "difference_low", "difference_high")}
    for key, name in names.items():
        assert place[key] == here[name].item()
    for way in ("direct", "bank"):
        found = here.sel(way=way)
        for key, name in (("speed_m_s", "speed"), ("elevation_rad", "elevation"), ("low", "low")):
            assert place[way][key] == found[name].item()
        assert place[way]["probability"] == found.probability.item()
    assert (record["scene"], record["seed"], record["shots"]) == ("NBA", 4, 3000)
    assert record["parameters"]["ring_radius_m"] == hoopgen.NBA["ring_radius"]


@pytest.mark.slow
def test_many_places_are_a_table_and_a_verdict() -> None:
    axes = ["--places", "distance=2m:4m:2", "--places", "angle=0deg,60deg"]
    text = output(*BANK, *axes, "--shots", "500")
    spots = places_of({"distance": [2, 4], "angle": [0, 60 * DEGREE]})
    assert spots.shape == (4, 2)
    dataset = bank_or_direct(PLAYER, spots, shots=500)
    _, head, rule, *rows = text.partition("\n\n")[0].splitlines()
    assert head.split()[:4] == ["dist.", "(m)", "angle", "(°)"]
    assert set(rule) == {"-", " "}
    for row, place in zip(rows, range(4), strict=True):
        cells = row.split()
        here = dataset.isel(place=place)
        assert cells[:2] == [["2.000", "4.000"][place // 2], ["0.0", "60.0"][place % 2]]
        shares = [f"{100 * share:.1f}%" for share in here.probability.values]
        assert cells[4:6] == shares
        assert cells[6] == f"{100 * here.difference.item():+.1f}".replace("-", "\N{MINUS SIGN}")
        assert cells[9:] == [f"{100 * here[name].item():.1f}" for name in ("touch_y", "touch_z")]
    assert verdict(dataset)[2] in text


@pytest.mark.slow
def test_units_and_variables_searched_over_are_handed_on() -> None:
    given = [
        "--distance",
        "10ft",
        "--elevation",
        "55deg",
        "--over",
        "aim=0m:1m",
        "--over",
        "azimuth",
    ]
    text = output(*BANK, *given, "--shots", "300", "--units", "us")
    assert "place    10.00 ft from the ring, 0.0° around it (x 10.00 ft, y 0.00 ft)" in text
    assert text.count(" mph at 55.0°") == 2


@pytest.mark.slow
def test_a_speed_that_is_given_leaves_no_aim_to_search() -> None:
    given = ["--distance", "10ft", "--elevation", "52deg", "--speed", "6.9"]
    text = output(*BANK, *given, "--shots", "300")
    (bank,) = (line for line in text.splitlines() if line.startswith("bank "))
    assert " from 6.900 m/s at 52.0°, " in bank


@pytest.mark.slow
def test_a_picture_without_a_bank_shot_is_refused_in_a_line(tmp_path: Path) -> None:
    over = ["--over", "elevation", "--over", "aim", "--picture", str(tmp_path / "none.svg")]
    refused = run(*BANK, "--x=-1m", "--y", "0", *over, "--shots", "300")
    assert refused.exit_code == 2
    assert "--picture: no place has a bank shot to draw" in refused.output


@pytest.mark.slow
def test_a_place_without_a_bank_shot_says_so() -> None:
    over = ["--over", "elevation", "--over", "aim"]
    text = output(*BANK, "--x=-1m", "--y", "0", *over, "--shots", "300")
    assert "bank     none that was tried goes in" in text
    assert ": the direct shot is better" in text
    record = json.loads(output(*BANK, "--x=-1m", "--y", "0", *over, "--shots", "300", "--json"))
    assert record["places"][0]["bank"]["speed_m_s"] is None
    table = output(*BANK, *over, "--places", "x=-1m", "--places", "y=0,1m", "--shots", "300")
    assert table.splitlines()[3].split()[-2:] == ["-", "-"]


@pytest.mark.slow
def test_a_bank_shot_that_without_errors_misses_the_board_says_so() -> None:
    """Far to the side, an aim with the largest chance may miss the board."""
    text = output(*BANK, "--distance", "25m", "--angle", "85deg", "--shots", "300")
    (bank,) = (line for line in text.splitlines() if line.startswith("bank "))
    assert bank.endswith(", without errors it does not touch the board first")
    assert "nan" not in text


@pytest.mark.slow
def test_the_picture_is_that_of_the_places(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    file = tmp_path / "bank.svg"
    output(*BANK, *SIDE, "--shots", "300", "--picture", str(file))
    assert file.read_text("utf-8").startswith("<?xml")


@pytest.mark.slow
def test_measured_releases_are_moved_to_the_places(tmp_path: Path) -> None:
    file = tmp_path / "releases.csv"
    rows = "\n".join(f"{speed},{angle}" for speed, angle in [(7.1, 50), (7.2, 53), (7.3, 51)])
    file.write_text(f"speed,elevation_deg\n{rows}\n", encoding="utf-8")
    given = ["--from", str(file), "--height", "7ft", *SIDE, "--shots", "300", "--json"]
    record = json.loads(output("bank", *given))
    measured = hoopgen.Resample(
        {"speed": [7.1, 7.2, 7.3], "elevation": np.array([50, 53, 51]) * DEGREE, "height": 2.1336}
    )
    wanted = bank_or_direct(measured, [(1.5, 2.6)], shots=300)
    assert record["places"][0]["difference"] == wanted.difference.item()


@pytest.mark.slow
def test_a_folder_keeps_what_is_finished_of_one_question(tmp_path: Path, side: xr.Dataset) -> None:
    places, few = [(1.5, 2.6), (3.0, 0.0)], {"shots": 500, "over": ["elevation", "aim"]}
    noted: list[int] = []
    wanted = bank_or_direct(PLAYER, places, **few)
    found = bank_or_direct(
        PLAYER, places, **few, folder=tmp_path, progress=lambda done, _: noted.append(done)
    )
    assert found.identical(wanted)
    chunks = sorted(tmp_path.glob("chunk-*"))
    assert noted[-1] == len(chunks) > 2
    files = {file.name: file.read_bytes() for file in tmp_path.iterdir()}
    for lost in chunks[len(chunks) // 2 :]:
        lost.unlink()
    assert bank_or_direct(PLAYER, places, **few, folder=tmp_path, threads=2).identical(wanted)
    assert {file.name: file.read_bytes() for file in tmp_path.iterdir()} == files
    others: list[dict[str, Any]] = [
        {"places": places[:1]},
        {"seed": 1},
        {"shots": 501},
        {"over": {"elevation": (0.8, 1.1), "aim": None}},
        {"parameters": hoopgen.NBA},
    ]
    for other in others:
        with pytest.raises(ValueError, match="holds another job"):
            bank_or_direct(PLAYER, folder=tmp_path, **{"places": places, **few, **other})


def test_what_is_wrong_shows_before_a_folder_is_made(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="expected speed and elevation"):
        bank_or_direct(
            PLAYER, [(2.0, 1.0)], over=["elevation"], folder=tmp_path / "kept", shots=100
        )
    with pytest.raises(ValueError, match=r"places: expected x and y, shape \(n, 2\), got .*0, 2"):
        bank_or_direct(PLAYER, np.empty((0, 2)), folder=tmp_path / "kept", shots=100)
    assert not (tmp_path / "kept").exists()


@pytest.mark.parametrize(
    ("more", "said"),
    [
        ([], "missing --distance (or --place, or --x and --y)"),
        (["--x", "2m"], "places: expected distance and angle, or x and y; got x"),
        (["--distance", "2m", "--y", "1m"], "places: expected distance and angle, or x and y"),
        (["--distance", "2m", "--places", "distance=3m"], "--distance and --places distance=..."),
        (["--places", "height=2m"], "places: expected distance and angle, or x and y; got height"),
        (["--places", "distance=2deg"], "'deg' is not a unit of length"),
        (
            [*SIDE, "--elevation", "50deg", "--over", "elevation"],
            "--elevation and --over elevation: leave one out",
        ),
        ([*SIDE, "--over", "pace"], "'pace' is none of"),
        ([*SIDE, "--picture", "bank.txt"], "bank.txt"),
    ],
)
def test_what_is_wrong_on_the_command_line_is_said(more: list[str], said: str) -> None:
    result = run(*BANK, *more)
    assert (result.exit_code, result.stdout) == (2, "")
    assert said in result.stderr
    assert result.stderr.count("\n") == 1


def test_the_whole_hoop_is_a_scene_too() -> None:
    words = (*SIDE, "--scene", "court", "--preset", "nba", "--over", "aim", "--shots", "100")
    elevated = (*words, "--elevation", "52deg")
    assert "scene    court, NBA\n" in output(*BANK, *elevated)
    record = json.loads(output(*BANK, *elevated, "--json"))
    assert record["scene"] == "court, NBA"
    assert record["parameters"]["board_thickness_m"] == hoopgen.NBA_COURT["board_thickness"]
    assert record["parameters"]["ring_friction"] == 0.5


def test_what_is_given_is_not_searched_over() -> None:
    text = output(*BANK, *SIDE, "--elevation", "50deg", "--shots", "300")
    for way in ("direct", "bank"):
        (line,) = (line for line in text.splitlines() if line.startswith(way))
        assert " at 50.0°" in line


def test_without_scatter_it_says_what_is_missing() -> None:
    result = run("bank", "--height", "7ft", *SIDE)
    assert result.exit_code == 2
    assert "--scatter: expected a deviation above 0" in result.stderr


def test_the_examples_of_the_help_are_commands() -> None:
    command = main.commands["bank"]
    text = re.sub(r"\\\s*\n", " ", (command.epilog or "").partition("Examples:")[2])
    examples = [shlex.split(line) for line in text.splitlines() if line.strip()]
    assert len(examples) > 1
    for program, same, *options in examples:
        assert (program, same) == ("hoopgen", "bank")
        with command.make_context("bank", options):
            pass
