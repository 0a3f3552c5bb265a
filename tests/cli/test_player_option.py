"""`coach --from` and `best --from` read tables as `estimate --from` and `batch` do."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.helpers.commands import failure, output

pytest.importorskip("pyarrow")
pytest.importorskip("scipy")

from hoopgen.cli import main
from hoopgen.hoop.court_places import find_place

ROWS = 30


@pytest.fixture
def table(tmp_path: Path) -> Path:
    """Return releases without a place, with a column of another name and of another meaning."""
    file = tmp_path / "releases.txt"
    rows = [f"{7.1 + 0.004 * k};{51 + 0.37 * k % 3};{k % 5 - 2};{k}" for k in range(ROWS)]
    head = "Release Speed;elevation_deg;azimuth_deg;angle"
    file.write_text("\n".join([head, *rows]) + "\n", encoding="utf-8")
    return file


READ = ["--format", "csv", "--delimiter", ";", "--own", "angle", "--column", "speed=Release Speed"]
FEW = ["--shots", "200"]


def test_a_table_is_read_as_its_options_say(table: Path) -> None:
    words = ["coach", "--from", table, *READ, "--release", "height=7ft", *FEW]
    text = output(*words, "--place", "left elbow")
    assert f"{ROWS} releases" in text
    assert "Release Speed as speed" in text
    assert "not read: angle" in text
    assert "height 7 ft, distance" in text
    place = find_place("left elbow").variables
    units = {"distance": "m", "angle": "rad"}
    both = [f"--release={name}={value!r}{units[name]}" for name, value in place.items()]
    assert text == output(*words, *both)


def test_known_errors_of_the_measurement_make_the_spread_smaller(table: Path) -> None:
    here = ["--release", "height=7ft", "--place", "elbow", *FEW]
    words = ["coach", "--from", table, *READ, *here]
    raw, clean = (
        next(line for line in output(*words, *more).splitlines() if line.startswith("speed "))
        for more in ([], ["--instrument", "speed=3cm/s"])
    )
    assert raw != clean
    assert raw.split()[-1] == clean.split()[-1]  # as measured


@pytest.mark.parametrize("command", ["coach", "best"])
def test_an_error_about_a_table_recommends_options_that_there_are(
    command: str, table: Path
) -> None:
    words = [command, "--from", table, *READ]
    said = failure(*words)
    assert (
        "releases.txt: missing height, distance; give --release height=... and "
        "--release distance=... (or --place)" in said
    )
    said = failure(command, "--from", table, *READ[:4])
    assert "--own angle" in said
    assert "(--own" not in said
    for option in ("--own", "--column", "--release", "--place"):
        assert any(option in one.opts for one in main.commands[command].params)
    both = ["--place", "elbow", "--release", "distance=3"]
    assert "--place says where; leave out --release distance" in failure(*words, *both)


def test_estimate_names_its_options_for_a_missing_place(table: Path) -> None:
    said = failure("estimate", "--from", table, *READ)
    assert "missing height, distance; give --height and --distance (or --place)." in said


@pytest.mark.parametrize("command", ["coach", "best"])
@pytest.mark.parametrize(
    "option",
    ["--own x", "--column speed=v", "--delimiter ;", "--release height=2", "--instrument speed=1"],
)
def test_options_of_a_table_need_one(command: str, option: str) -> None:
    assert f"{option.split()[0]}: there is no table; give --from" in failure(
        command, *option.split()
    )
    if command == "best":
        assert "--place: it is of measured releases" in failure(command, "--place", "elbow")
