"""Tables as people have them: no column is ignored in silence, and no bad row disturbs another."""

from __future__ import annotations

import csv
import datetime
import json
import math
import os
import pickle
import re
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import hoopgen
from tests.helpers.commands import failure, run, succeed

pa = pytest.importorskip("pyarrow")
pq = pytest.importorskip("pyarrow.parquet")
pytest.importorskip("scipy")

from hoopgen.core.units import DEGREE, FOOT, TURN, UNITS, file_unit  # noqa: E402
from hoopgen.simulation.hoop import HOOP  # noqa: E402
from hoopgen.study.models.plausible import PLAUSIBLE  # noqa: E402
from hoopgen.study.statistics.intervals import wilson_interval  # noqa: E402
from hoopgen.study.tables import source as source_module  # noqa: E402
from hoopgen.study.tables.columns import Column, columns_of  # noqa: E402
from hoopgen.study.tables.filters import Condition, parse_conditions  # noqa: E402
from hoopgen.study.tables.source import Source  # noqa: E402

PLACE = {"height": 2.1, "distance": 4.2}
HERE = ("--release", "height=2.1", "--release", "distance=4.2m")
THROWN = {
    "player": ["Ann", "Bea", "Ann", "Cy", "Bea", "Ann"],
    "release_speed_mph": [16.0, 15.8, 15.9, 16.1, 15.7, 15.6],
    "elevation_deg": [52.0, 51.0, 53.0, 52.5, 50.0, 54.0],
    "side_angle_deg": [0.5, -0.5, 0.0, 1.0, 2.0, -1.0],
    "spin_rpm": [180.0, 150.0, 160.0, 170.0, 190.0, 175.0],
    "height_ft": [7.0] * 6,
    "shot_distance_ft": [13.75] * 6,
}
MAPPED = {
    "speed": "release_speed_mph",
    "azimuth": "side_angle_deg",
    "backspin": "spin_rpm",
    "distance": "shot_distance_ft",
}
COLUMNS = [part for name, one in MAPPED.items() for part in ("--column", f"{name}={one}")]
READ = (
    "read: release_speed_mph as speed in mph, elevation_deg as elevation in deg, "
    "side_angle_deg as azimuth in deg, spin_rpm as backspin in rpm, height_ft as height in ft, "
    "shot_distance_ft as distance in ft\n"
    "not read: player\n"
    "assumed: sidespin 0 Hz, angle 0°"
)


def written(file: Path, text: str) -> Path:
    file.write_bytes(text.encode())
    return file


@pytest.fixture
def thrown(tmp_path: Path) -> Path:
    """The throws in a file of CSV."""
    pa.csv.write_csv(pa.table(THROWN), tmp_path / "thrown.csv")
    return tmp_path / "thrown.csv"


def states() -> Any:
    return hoopgen.release(
        np.array(THROWN["release_speed_mph"]) * UNITS["speed"]["mph"],
        np.array(THROWN["elevation_deg"]) * DEGREE,
        np.array(THROWN["side_angle_deg"]) * DEGREE,
        np.array(THROWN["spin_rpm"]) * UNITS["spin"]["rpm"],
        height=np.array(THROWN["height_ft"]) * FOOT,
        distance=np.array(THROWN["shot_distance_ft"]) * FOOT,
    )


# What each column says


def test_columns_of_any_name_are_read_as_a_caller_says() -> None:
    result = hoopgen.batch(pa.table(THROWN), columns=MAPPED)
    table = result.to_arrow()
    shots = hoopgen.simulate(states())
    np.testing.assert_array_equal(table["contacts"].to_numpy(), shots.contacts)
    assert table.column_names[: len(THROWN)] == list(THROWN)
    assert result.read == READ


@pytest.mark.parametrize(
    ("columns", "found"),
    [
        ({"speed": "v_mph"}, Column("v_mph", UNITS["speed"]["mph"])),
        ({"speed_mph": "v"}, Column("v", UNITS["speed"]["mph"])),
        ({"speed": "v"}, Column("v", 1.0)),
        ({"speed_m_s": "v"}, Column("v", 1.0)),
        ({"speed": "Release Speed [ft/s]"}, Column("Release Speed [ft/s]", FOOT)),
        ({"speed": "ball speed (km/h)"}, Column("ball speed (km/h)", UNITS["speed"]["km/h"])),
    ],
)
def test_the_unit_is_at_the_end_of_either_name(columns: dict[str, str], found: Column) -> None:
    names = [*columns.values(), "elevation_deg", "height", "distance"]
    assert columns_of(names, columns=columns)["speed"] == found


@pytest.mark.parametrize(
    ("columns", "said"),
    [
        ({"speed": "nope"}, "columns: speed=nope: no column nope; there are v_mph, "),
        ({"spedo": "v_mph"}, "columns: spedo=v_mph: spedo is no variable; one of x, y, "),
        ({"speed_kph": "v_mph"}, "columns: speed_kph=v_mph: the two names have different units"),
        ({"azimuth": "side"}, "the unit is not known; write azimuth_deg=side or azimuth_rad=side"),
        ({"height": "v_mph"}, "columns: height=v_mph: height is given for all rows"),
        ({"speed": "v_mph", "distance": "v_mph"}, "the column is read as speed already"),
        ({"elevation_deg": "side"}, "columns side and elevation_deg both say elevation"),
    ],
)
def test_a_mapping_that_is_not_clear_is_refused(columns: dict[str, str], said: str) -> None:
    names = ["v_mph", "side", "elevation_deg", "distance"]
    if "distance" not in columns:
        columns = {"speed": "v_mph", **columns} if "speed" not in str(columns) else columns
    with pytest.raises(ValueError, match=re.escape(said)):
        columns_of(names, given=["height"], columns=columns)


LIKELY = {
    "side_angle_deg": "azimuth",
    "court_angle_deg": "angle",
    "spin_rpm": "backspin",
    "spin_rate_rpm": "backspin",
    "Side spin [rpm]": "",
    "weight_lb": "",
    "player": "",
    "quarter": "",
    "spin": "",
    "entry_angle_deg": "",
}


@pytest.mark.parametrize("name", LIKELY)
def test_a_column_that_may_be_meant_is_asked_about_in_its_own_unit(name: str) -> None:
    table = pa.table({"speed": [7.1], "elevation_deg": [52.0], "sidespin_hz": [0.0], name: [1.0]})
    read = hoopgen.batch(table, release=PLACE).read
    hint = f"{name} (did you mean --column {LIKELY[name]}={name}?)"
    assert f"not read: {hint if LIKELY[name] else name}\n" in read
    said = [line for line in read.splitlines() if line.startswith("assumed: ")]
    assert said == ["assumed: azimuth 0°, backspin 0 Hz, angle 0°"]


def test_what_is_missing_says_which_column_may_be_meant() -> None:
    names = ["speed", "elevation_deg", "height", "shot_distance_ft"]
    with pytest.raises(ValueError, match="missing distance") as raised:
        columns_of(names)
    assert str(raised.value).endswith("Did you mean --column distance=shot_distance_ft?")


def test_a_near_miss_is_asked_about_in_its_own_unit() -> None:
    with pytest.raises(ValueError, match="nearly names azimuth") as raised:
        columns_of(["speed", "azimut_deg", "elevation_deg", *PLACE])
    assert "Name it azimuth_deg, or say so with --column azimuth=azimut_deg" in str(raised.value)
    with pytest.raises(ValueError, match="nearly names height") as raised:
        columns_of(["speed", "hight_ft", "elevation_deg", "distance"])
    assert "Name it height_ft, or" in str(raised.value)


def test_states_without_spin_assume_none() -> None:
    columns = {name: [1.0] for name in ("x", "y", "z", "vx", "vy", "vz")}
    read = hoopgen.batch(pa.table(columns)).read
    assert read.endswith("\nassumed: wx 0 rad/s, wy 0 rad/s, wz 0 rad/s")


@pytest.mark.slow
def test_every_command_says_how_it_read_the_table(thrown: Path, tmp_path: Path) -> None:
    scene = ("--preset", "paper")
    batch = succeed("batch", thrown, "--out", tmp_path / "o.csv", *COLUMNS, *scene)
    view = succeed("view", thrown, "--out", tmp_path / "page.html", *COLUMNS, *scene)
    for result in (batch, view):
        assert f"\n{READ}\n" in result.stdout
    measured = ("--from", thrown, *COLUMNS, *scene)
    for command in (
        ("estimate", "--shots", "50"),
        ("map", "--over", "speed=6.9,7.1", "--shots", "20"),
        ("optimum", "--over", "elevation=50deg:55deg", "--shots", "50"),
    ):
        result = succeed(*command, *measured)
        assert result.stdout.endswith(f"\n{READ}\n")
        assert result.stderr == ""
    result = succeed("estimate", "--shots", "50", "--json", *measured)
    assert json.loads(result.stdout)["shots"] == 50
    assert result.stderr == f"\n{READ}\n"


def test_a_page_of_mapped_columns_in_python(thrown: Path, tmp_path: Path) -> None:
    page = hoopgen.view(thrown, path=tmp_path / "page.html", columns=MAPPED)
    assert page.read == READ
    with pytest.raises(ValueError, match="columns: shots are no table"):
        hoopgen.view(hoopgen.simulate(states(), record=True), columns=MAPPED)


def test_an_estimate_of_mapped_columns_is_that_of_columns_so_named(
    thrown: Path, tmp_path: Path
) -> None:
    names = {one: f"{name}_{one.rpartition('_')[2]}" for name, one in MAPPED.items()}
    renamed = pa.table({names.get(name, name): cells for name, cells in THROWN.items()})
    pq.write_table(renamed, tmp_path / "named.parquet")
    command = ("estimate", "--shots", "200", "--json", "--preset", "nba", "--from")
    ours = json.loads(succeed(*command, thrown, *COLUMNS).stdout)
    theirs = json.loads(succeed(*command, tmp_path / "named.parquet").stdout)
    for name in ("made", "missed", "probability"):
        assert ours[name] == theirs[name]


def test_options_of_a_table_need_one() -> None:
    shot = ("--speed", "7.1", "--elevation", "52deg", "--height", "7ft", "--distance", "4m")
    result = run("estimate", *shot, "--scatter", "speed=0.1", "--column", "speed=v_mph")
    assert result.exit_code == 2
    assert "--column: there is no table; give --from" in result.stderr


# Implausible numbers


IMPLAUSIBLE = {
    "elevation_deg": (500.0, "implausible elevation_deg: 500 is not within -90 to 90"),
    "release_speed_mph": (-1.0, "implausible release_speed_mph: -1 is not within 0 to 89.4775"),
    "height_ft": (72.0, "implausible height_ft: 72 is not within 0 to 16.4042"),
    "shot_distance_ft": (-3.0, "implausible shot_distance_ft: -3 is not within 0 to 131.234"),
    "spin_rpm": (1e6, "implausible spin_rpm: 1e+06 is not within -1800 to 1800"),
    "side_angle_deg": (-900.0, "implausible side_angle_deg: -900 is not within -180 to 180"),
}


@pytest.mark.parametrize("name", IMPLAUSIBLE)
def test_an_implausible_row_is_listed_and_left_out_unless_asked_for(name: str) -> None:
    value, reason = IMPLAUSIBLE[name]
    cells = {**THROWN, name: [*THROWN[name][:3], value, *THROWN[name][4:]]}
    result = hoopgen.batch(pa.table(cells), columns=MAPPED, reason=True)
    assert result.invalid == ((4, reason),)
    assert result.causes == {f"implausible {name}": 1}
    plain = hoopgen.batch(pa.table(THROWN), columns=MAPPED).to_arrow()
    rest = [0, 1, 2, 4, 5]
    ours = result.to_arrow().select(plain.column_names).drop_columns([name])
    assert ours.take(rest) == plain.drop_columns([name]).take(rest)
    kept = hoopgen.batch(pa.table(cells), columns=MAPPED, implausible=True)
    assert kept.invalid == () or not kept.invalid[0][1].startswith("implausible")


@pytest.mark.parametrize("rows", [1, 2, 100])
def test_a_wrong_angle_alone_in_a_part_refuses_nothing(rows: int) -> None:
    table = pa.table({"speed": [7.1] * 3, "elevation_rad": [0.9, 0.8, 52.0]})
    result = hoopgen.batch(table, release=PLACE, rows=rows)
    assert result.invalid == ((3, "implausible elevation_rad: 52 is not within -1.5708 to 1.5708"),)
    asked = hoopgen.batch(table, release=PLACE, rows=rows, implausible=True)
    assert asked["invalid"] == 0


def test_means_leave_implausible_rows_out_unless_asked(tmp_path: Path) -> None:
    speeds = [7.1] * 5 + [400.0] * 5
    pq.write_table(pa.table({"speed": speeds, "elevation_deg": [52.0] * 10}), tmp_path / "t.pq")
    command = ("estimate", "--from", tmp_path / "t.pq", "--height", "2.1m", "--distance", "4.2m")
    command = (*command, "--shots", "400", "--preset", "nba")
    text = succeed(*command).stdout
    assert "invalid: row 6: implausible speed: 400 is not within 0 to 40\n" in text
    found, kept = (
        json.loads(succeed(*command, "--json", *more).stdout)
        for more in ((), ("--keep-implausible",))
    )
    assert kept["invalid"] == 0
    assert 100 < found["invalid"] < 300
    assert found["missed"] < kept["missed"]


def test_an_implausible_option_beside_a_table_is_refused_unless_asked_for(tmp_path: Path) -> None:
    pq.write_table(pa.table({"speed": [7.1], "elevation_deg": [52.0]}), tmp_path / "t.pq")
    command = ("batch", tmp_path / "t.pq", "--out", tmp_path / "o.pq", "--release", "height=72ft")
    command = (*command, "--release", "distance=4.2m")
    assert "height: implausible: expected 0 to 5 m, got '72ft'" in failure(*command)
    assert "0 invalid" in succeed(*command, "--keep-implausible").stdout


def test_plausible_limits_hold_everything_that_a_release_takes() -> None:
    assert {"speed", "elevation", "azimuth", "backspin", "sidespin", *PLACE, "angle"} <= {
        *PLAUSIBLE
    }
    for name, (low, high) in PLAUSIBLE.items():
        assert low < high, name
    found = columns_of(["speed", "elevation_deg", "restitution", *PLACE])
    assert found["restitution"].limits == (-math.inf, math.inf)
    assert found["speed"].limits == PLAUSIBLE["speed"]


# Files as people have them

HEADER = "speed,elevation_deg,note"


@pytest.mark.parametrize(
    ("text", "rows"),
    [
        (f"{HEADER}\n7.1,52,a\n7.2,52\n7.3,52,c\n", ["a", None, "c"]),
        (f"{HEADER}\n7.1,52,a\n7.2,52,b,more,cells\n7.3,52,c\n", ["a", None, "c"]),
        (f"{HEADER}\n7.2\n7.3,52,c\n8\n", [None, "c", None]),
        (f"{HEADER}\n\n7.2,52\n\n7.3,52,c\n# 9,9\n7.4,52,d\n", [None, "c", "d"]),
        (f'{HEADER}\n7.1,52,a\n7.2,"52,b\n7.3,52,c\n7.4,52,d\n', ["a", None, "c", "d"]),
        (f'{HEADER}\n7.1,52,"two\nlines",x\n7.4,52,d\n', [None, "d"]),
        (f'{HEADER}\n7.1,52,"two\nlines"\n7.4\n7.5,52,d\n', ["two\nlines", None, "d"]),
    ],
)
@pytest.mark.parametrize("block", [40, 1 << 20])
def test_a_row_with_a_wrong_number_of_cells_is_that_row_alone(
    text: str, rows: list[str], block: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(source_module, "BLOCK", block)
    file = written(tmp_path / "t.csv", text)
    if block == 40 and '"' in text:
        monkeypatch.setattr(source_module, "BLOCK", 60)
    result = hoopgen.batch(file, release=PLACE, reason=True)
    table = result.to_arrow()
    assert table["note"].to_pylist() == rows
    invalid = [outcome == "invalid" for outcome in table["outcome"].to_pylist()]
    assert invalid == [note is None for note in rows]
    for row, reason in result.invalid:
        assert rows[row - 1] is None
        assert re.match(r"[1-9] cells? where the header has 3: '", reason)


def test_many_malformed_rows_stand_in_their_places(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(source_module, "BLOCK", 4096)
    random = np.random.default_rng(11)
    wrong = random.uniform(size=3000) < 0.3
    lines = [f"7.1,{k}" if bad else f"7.1,52,{k}" for k, bad in enumerate(wrong)]
    source = Source(written(tmp_path / "t.csv", "\n".join([HEADER, *lines])))
    read = [table["note"].to_pylist() for table in source.tables(100)]
    assert [len(part) for part in read] == [100] * 30
    assert [one for part in read for one in part] == [
        None if bad else str(k) for k, bad in enumerate(wrong)
    ]
    assert sorted(source.malformed) == (np.flatnonzero(wrong) + 1).tolist()


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("t.tsv", "speed\televation_deg\tnote\n7,1\t52\ta,b\n"),
        ("t.csv", "sep=;\nspeed;elevation_deg;note\n7,1;52;a,b\n"),
        ("t.csv", "\ufeffsep=;\r\nspeed;elevation_deg;note\r\n7,1;52;a,b\r\n"),
        ("t.csv", '"sep=\t"\nspeed\televation_deg\tnote\n7,1\t52\ta,b\n'),
        ("t.csv", "# measured, by hand; in May\n#\n\nspeed;elevation_deg;note\n7,1;52;a,b\n"),
        ("t.csv", '\ufeff# of Ann\nspeed,elevation_deg,note\n7.1,52,"a,b"\n'),
    ],
)
def test_what_stands_before_the_header_is_no_table(name: str, text: str, tmp_path: Path) -> None:
    table = hoopgen.batch(written(tmp_path / name, text), release=PLACE).to_arrow()
    assert table.column_names[:3] == ["speed", "elevation_deg", "note"]
    assert table.select(["speed", "note"]).to_pylist() == [{"speed": 7.1, "note": "a,b"}]


def test_a_cell_that_begins_like_a_comment_is_one(tmp_path: Path) -> None:
    text = "player,speed,elevation_deg\n#23,7.1,52\n#7,7.2,52\n"
    table = hoopgen.batch(written(tmp_path / "t.csv", text), release=PLACE).to_arrow()
    assert table["player"].to_pylist() == ["#23", "#7"]


def test_a_quote_that_is_never_closed_in_a_large_file_says_so(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(source_module, "BLOCK", 1000)
    text = f'{HEADER}\n7.1,52,"a\n' + "7.1,52,b\n" * 500
    with pytest.raises(ValueError, match=r"t\.csv: a row is too long, or a quotation mark is not"):
        list(Source(written(tmp_path / "t.csv", text)).tables(100))


def sheet(file: Path, rows: list[list[Any]]) -> Path:
    openpyxl = pytest.importorskip("openpyxl")
    book = openpyxl.Workbook()
    for row in rows:
        book.active.append(row)
    book.create_sheet("other").append(["speed"])
    book.save(file)
    return file


def test_a_spreadsheet_is_a_table(tmp_path: Path) -> None:
    day = datetime.datetime(2024, 5, 1, 12, 30)
    rows = [
        ["", None],
        ["player", "speed", "elevation_deg", "when", "id", "home"],
        ["Ann", 7.1, 52, day, "007", True],
        [None, None, None],
        ["Bea", "fast", 52, None, "008", False],
        ["Cy", 7.25, 52],
    ]
    result = hoopgen.batch(sheet(tmp_path / "t.xlsx", rows), release=PLACE)
    assert result.invalid == ((2, "no number in speed: 'fast'"),)
    table = result.to_arrow().select(rows[1])
    assert table.to_pydict() == {
        "player": ["Ann", "Bea", "Cy"],
        "speed": [7.1, None, 7.25],
        "elevation_deg": [52.0, 52.0, 52.0],
        "when": ["2024-05-01T12:30:00", "", ""],
        "id": ["007", "008", ""],
        "home": [True, False, None],
    }


@pytest.mark.parametrize("content", [b"", b"PK\x03\x04 no zip", b"speed\n7\n"])
def test_what_is_no_spreadsheet_is_refused_by_name(content: bytes, tmp_path: Path) -> None:
    pytest.importorskip("openpyxl")
    (tmp_path / "t.xlsx").write_bytes(content)
    with pytest.raises(ValueError, match=r"t\.xlsx: is no workbook in \.xlsx"):
        Source(tmp_path / "t.xlsx").schema()


# Results that are read again


@pytest.mark.sampled(2)
@pytest.mark.parametrize("name", ["r.csv", "r.tsv", "r.parquet"])
def test_results_are_simulated_again_in_their_scene(
    name: str, thrown: Path, tmp_path: Path
) -> None:
    scene = hoopgen.NBA | {"gravity": 9.8}
    given: dict[str, Any] = {"parameters": scene, "columns": MAPPED, "reason": True}
    first = hoopgen.batch(thrown, tmp_path / name, max_contacts=7, **given)
    assert "ball_radius" not in str(first.to_arrow().column_names)
    second = hoopgen.batch(tmp_path / name, tmp_path / f"again-{name}", reason=True)
    assert (tmp_path / name).read_bytes() == (tmp_path / f"again-{name}").read_bytes()
    assert second.scene == first.scene == "NBA, gravity 9.8 m/s²"
    assert "\nearlier results, not read: outcome, kind, " in second.read
    with pytest.raises(ValueError, match="got FIBA"):
        hoopgen.batch(tmp_path / name, parameters=hoopgen.FIBA)
    both = hoopgen.batch(tmp_path / name, prefix="again_").to_arrow()
    assert {"outcome", "again_outcome"} < {*both.column_names}
    command = ("estimate", "--from", tmp_path / name, "--shots", "50")
    assert "\nscene    NBA, gravity 9.8 m/s²\n" in succeed(*command).stdout
    page = succeed("view", tmp_path / name, "--out", tmp_path / "page.html")
    assert "scene NBA, gravity 9.8 m/s²" in page.stdout


def test_a_caller_s_own_columns_are_never_replaced(thrown: Path, tmp_path: Path) -> None:
    table = pa.table({**THROWN, "outcome": ["?"] * 6})
    pq.write_table(table, tmp_path / "t.parquet")
    with pytest.raises(ValueError, match="named like results: outcome; give a prefix"):
        hoopgen.batch(tmp_path / "t.parquet", columns=MAPPED)
    out = tmp_path / "o.parquet"
    hoopgen.batch(tmp_path / "t.parquet", out, columns=MAPPED, prefix="a_")
    again = hoopgen.batch(out, prefix="a_").to_arrow()
    assert again == pq.read_table(out)
    with pytest.raises(ValueError, match="named like results: outcome; give a prefix"):
        hoopgen.batch(out)


def test_csv_of_results_has_no_constant_columns(thrown: Path, tmp_path: Path) -> None:
    hoopgen.batch(thrown, tmp_path / "r.csv", columns=MAPPED)
    about, header, *rows = (tmp_path / "r.csv").read_text(encoding="utf-8").splitlines()
    assert json.loads(about.removeprefix("# hoopgen: "))["parameters"] == dict(hoopgen.PAPER)
    assert header.startswith('"player","release_speed_mph","elevation_deg",')
    assert not {"ball_radius_m", "max_contacts", "gravity_m_s2"} & set(header.split('"'))
    assert len(rows) == 6


@pytest.mark.parametrize("about", ["{", "[]", '{"parameters": {}}'])
def test_a_comment_that_cannot_be_understood_is_told(about: str, tmp_path: Path) -> None:
    file = written(tmp_path / "t.csv", f"# hoopgen: {about}\nspeed,elevation_deg\n7.1,52\n")
    with pytest.raises(ValueError, match=r"t\.csv: its metadata hoopgen.* cannot be understood"):
        hoopgen.batch(file, release=PLACE)


@pytest.mark.parametrize("reads", [",", ";"])
@pytest.mark.parametrize("writes", [",", ";", "\t"])
def test_results_that_a_spreadsheet_saved_again_are_read(
    reads: str, writes: str, thrown: Path, tmp_path: Path
) -> None:
    file = tmp_path / "r.csv"
    hoopgen.batch(thrown, file, columns=MAPPED, parameters={"restitution": 0.6})
    about, *lines = file.read_text(encoding="utf-8").splitlines()
    rows = [about.split(reads), *csv.reader(lines)]
    width = max(map(len, rows))
    again = tmp_path / "again.csv"
    with again.open("w", encoding="utf-8-sig", newline="") as saved:
        writer = csv.writer(saved, delimiter=writes)
        writer.writerows([[*row, *[""] * (width - len(row))] for row in rows[:1]] + rows[1:])
    assert again.read_bytes().startswith(b'\xef\xbb\xbf"# hoopgen: {""version')
    found, expected = (hoopgen.batch(one, tmp_path / "o.parquet") for one in (again, file))
    assert (found.scene, dict(found)) == (expected.scene, dict(expected))
    assert "restitution 0.6" in found.scene


@pytest.mark.parametrize("size", [3_000_000, 9_000_000, 20_000_000])
def test_a_comment_line_of_any_length_is_read_or_refused_in_a_line(
    size: int, thrown: Path, tmp_path: Path
) -> None:
    file = tmp_path / "r.csv"
    hoopgen.batch(thrown, file, columns=MAPPED)
    about, rows = file.read_text(encoding="utf-8").split("\n", 1)
    longer = about.replace("{", f'{{"text": "{"x" * size}", ', 1)
    file.write_text(f"{longer}\n{rows}", encoding="utf-8")
    if size < 1 << 24:
        assert len(Source(file).whole()) == 6
        return
    with pytest.raises(ValueError, match=r"its comment line.* is longer than 16,777,216 bytes"):
        Source(file).whole()


def test_results_may_be_in_us_units(thrown: Path, tmp_path: Path) -> None:
    given: dict[str, Any] = {"columns": MAPPED, "measures": ["entry_angle", "depth"]}
    si = hoopgen.batch(thrown, **given).to_arrow()
    us = hoopgen.batch(thrown, units="us", **given).to_arrow()
    pairs = {
        "end_time_s": ("end_time_s", 1.0),
        "end_x_m": ("end_x_ft", FOOT),
        "end_vz_m_s": ("end_vz_mph", UNITS["speed"]["mph"]),
        "end_wy_rad_s": ("end_wy_hz", TURN),
        "entry_angle_rad": ("entry_angle_deg", DEGREE),
        "depth_m": ("depth_ft", FOOT),
    }
    for name, (other, size) in pairs.items():
        np.testing.assert_array_equal(us[other].to_numpy(), si[name].to_numpy() / size)
    assert us.schema.field("end_vz_mph").metadata == {b"unit": b"mph"}
    out = tmp_path / "us.csv"
    succeed("batch", thrown, "--out", out, *COLUMNS, "--units", "us")
    assert '"end_x_ft"' in out.read_text(encoding="utf-8")
    again = hoopgen.batch(out, units="us").to_arrow()
    assert again["end_x_ft"].to_pylist() == us["end_x_ft"].to_pylist()
    with pytest.raises(ValueError, match="units: expected si or us, got 'imperial'"):
        hoopgen.batch(thrown, units="imperial")  # type: ignore[arg-type]


@pytest.mark.parametrize("unit", ["m", "m/s", "rad", "rad/s", "m/s2", "s", ""])
def test_units_of_files_are_read_again(unit: str) -> None:
    name, size = file_unit(unit, "us")
    kinds = [kind for kind, units in UNITS.items() if unit in units and unit]
    for kind in kinds:
        assert UNITS[kind][name] == size
    assert file_unit(unit, "si") == (unit, 1.0)


def test_rpm_is_a_unit_wherever_units_are_read() -> None:
    shot = ("--speed", "7.1", "--elevation", "52deg", "--height", "7ft", "--distance", "4m")
    results = [
        json.loads(succeed("shot", *shot, "--backspin", spin, "--json").stdout)
        for spin in ("180rpm", "180 RPM", "3Hz", "180 revolutions per minute")
    ]
    assert all(result == results[0] for result in results)
    read = columns_of(["speed", "elevation_deg", "backspin_rpm", *PLACE])["backspin"]
    assert read.unit == TURN / 60


# Events, groups, conditions


def test_events_are_those_of_the_shots(thrown: Path, tmp_path: Path) -> None:
    shots = hoopgen.simulate(states(), record=True)
    log = tmp_path / "events.parquet"
    result = hoopgen.batch(thrown, columns=MAPPED, events=log, rows=4)
    assert result.events == log
    table = pq.read_table(log)
    events = shots.events
    assert table["row"].to_pylist() == (events["shot"] + 1).tolist()
    assert table["time_s"].to_pylist() == events["time"].tolist()
    assert table["after_vz_m_s"].to_pylist() == events["after"][:, 5].tolist()
    ours = shots.events_to_arrow()
    assert table.drop_columns(["row", "kind", "surface"]) == ours.drop_columns(
        ["shot", "kind", "surface"]
    ).replace_schema_metadata(None)
    for name in ("kind", "surface"):
        assert table[name].to_pylist() == ours[name].to_pylist()
    succeed("batch", thrown, "--out", tmp_path / "o.csv", *COLUMNS, "--events", tmp_path / "e.csv")
    text = (tmp_path / "e.csv").read_text(encoding="utf-8")
    assert text.startswith('"row","event","time_s","kind","surface","x_m"')
    assert text.count("\n") == len(events) + 1
    assert {file.name for file in tmp_path.iterdir()} == {
        *("thrown.csv", "events.parquet", "o.csv", "e.csv")
    }


def test_events_of_rows_that_are_invalid_or_left_out_are_none(tmp_path: Path) -> None:
    table = pa.table({**THROWN, "spin_rpm": [180.0, None, 160.0, 170.0, 190.0, 175.0]})
    log = tmp_path / "events.csv"
    hoopgen.batch(table, columns=MAPPED, events=log, where="player != Cy", units="us")
    found = pa.csv.read_csv(log)
    assert set(found["row"].to_pylist()) == {1, 3, 4, 5}  # of the results
    assert "after_vx_mph" in found.column_names


@pytest.mark.parametrize(
    ("events", "said"),
    [
        ("e.txt", r"events: expected a file \.csv, \.tsv, \.parquet, .* or \.ipc, got .*e\.txt"),
        ("o.csv", "events: .*o.csv is the file of results"),
        ("thrown.csv", "events: .*thrown.csv is the source"),
    ],
)
def test_a_file_of_events_that_is_none_is_refused(
    events: str, said: str, thrown: Path, tmp_path: Path
) -> None:
    with pytest.raises(ValueError, match=said):
        hoopgen.batch(thrown, tmp_path / "o.csv", columns=MAPPED, events=tmp_path / events)


def test_events_as_a_data_frame() -> None:
    pytest.importorskip("pandas")
    shots = hoopgen.simulate(states(), record=True)
    frame = shots.events_to_pandas()
    assert frame.index.names == ["shot", "event"]
    for shot in range(len(shots)):
        one = shots.trajectory(shot).to_pandas()
        assert frame.loc[shot].equals(one)
    with pytest.raises(AttributeError, match="simulate with record=True"):
        hoopgen.simulate(states()).events_to_pandas()
    with pytest.raises(AttributeError, match="simulate with record=True"):
        hoopgen.simulate(states()).events_to_arrow()


@pytest.mark.parametrize("rows", [2, 100])
def test_groups_have_counts_and_intervals(rows: int, thrown: Path, tmp_path: Path) -> None:
    result = hoopgen.batch(thrown, columns=MAPPED, by="player", rows=rows)
    made = hoopgen.simulate(states()).made
    for player, group in result.groups.items():
        there = np.array([one == player for one in THROWN["player"]])
        count, number = int(made[there].sum()), int(there.sum())
        assert (group.shots["made"], sum(group.shots.values())) == (count, number)
        assert group.probability == count / number
        assert (group.low, group.high) == tuple(map(float, wilson_interval(count, number, 0.95)))
    assert list(result.groups) == ["Ann", "Bea", "Cy"]
    assert pickle.loads(pickle.dumps(result)).groups == result.groups
    command = ("batch", thrown, "--out", tmp_path / "o.csv", *COLUMNS, "--by", "player")
    assert re.search(r"\nplayer  shots .*\n-+ .*\nAnn +3 ", succeed(*command).stdout)


def test_group_is_a_deprecated_name_of_by(thrown: Path, tmp_path: Path) -> None:
    command = ("batch", thrown, "--out", tmp_path / "o.csv", *COLUMNS, "--group", "player")
    old, new = succeed(*command), succeed(*command[:-2], "--by", "player")
    assert old.stdout == new.stdout
    assert old.stderr == "--group is deprecated: use --by\n" + new.stderr
    assert "--group" not in succeed("batch", "--help").stdout
    assert "give --by alone" in failure(*command, "--by", "player")


def test_a_group_that_is_no_column_is_refused() -> None:
    with pytest.raises(ValueError, match="by: the table has no column 'team'; the columns are"):
        hoopgen.batch(pa.table(THROWN), columns=MAPPED, by="team")


@pytest.mark.sampled(8)
@pytest.mark.parametrize(
    ("where", "rows"),
    [
        ("player == Ann", [0, 2, 5]),
        ("player != 'Ann'", [1, 3, 4]),
        ('player = "Ann"', [0, 2, 5]),
        ("release_speed_mph >= 15.9", [0, 2, 3]),
        ("side_angle_deg<0", [1, 5]),
        (["player == Ann", "spin_rpm > 170"], [0, 5]),
        ("player > B", [1, 3, 4]),
        ("spin_rpm <= 1.5e2", [1]),
        ("player == Zoe", []),
    ],
)
@pytest.mark.parametrize("kind", ["csv", "arrow"])
def test_rows_that_meet_conditions_are_chosen(
    where: Any, rows: list[int], kind: str, thrown: Path
) -> None:
    source = thrown if kind == "csv" else pa.table(THROWN)
    ours = hoopgen.batch(source, columns=MAPPED, where=where, rows=2).to_arrow()
    every = hoopgen.batch(source, columns=MAPPED).to_arrow()
    assert ours == every.take(pa.array(rows, pa.int64()))


def test_rows_that_are_left_out_keep_the_numbers_of_others(tmp_path: Path) -> None:
    text = "id,speed,elevation_deg\n1,7.1,52\n2,7.1\n3,fast,52\n4,7.1,520\n"
    file = written(tmp_path / "t.csv", text)
    result = hoopgen.batch(file, release=PLACE, where="id >= 2")
    assert [row for row, _ in result.invalid] == [3, 4]


@pytest.mark.parametrize(
    ("where", "said"),
    [
        ("player", "where: expected a column, one of == != <= >= < >, and a value, such as"),
        ("player ==", "where: expected a column"),
        ("team == Ann", "where: no column 'team'; the columns are player, "),
        ("spin_rpm == fast", "where: column 'spin_rpm' holds numbers; got 'fast'"),
        ("__import__('os').system('true') == 1", "where: no column "),
    ],
)
def test_a_condition_that_is_none_is_refused(where: str, said: str) -> None:
    with pytest.raises(ValueError, match=re.escape(said)):
        hoopgen.batch(pa.table(THROWN), columns=MAPPED, where=where)


def test_identifiers_are_compared_as_text(tmp_path: Path) -> None:
    assert parse_conditions("game == 0022") == (Condition("game", "==", "0022"),)
    text = "game,speed,elevation_deg\n0022,7.1,52\n22,7.1,52\n,7.1,52\n"
    file = written(tmp_path / "t.csv", text)
    for where, games in (("game == 0022", ["0022"]), ("game != 0022", ["22"])):
        table = hoopgen.batch(file, release=PLACE, where=where).to_arrow()
        assert [str(game) for game in table["game"].to_pylist()] == games


def test_conditions_hold_for_every_reader(thrown: Path, tmp_path: Path) -> None:
    options = (*COLUMNS, "--preset", "nba", "--where", "player == Cy")
    page = succeed("view", thrown, "--out", tmp_path / "page.html", *options, "--label", "player")
    assert "1 row of thrown.csv" in page.stdout
    found = json.loads(
        succeed("estimate", "--from", thrown, *options, "--shots", "9", "--json").stdout
    )
    made = hoopgen.simulate(states()[3], hoopgen.NBA).made[0]
    assert found["made"] == 9 * made


# Tables that are made to harm


@pytest.mark.slow
def test_many_columns_take_no_quadratic_time(tmp_path: Path) -> None:
    names = [*(f"column {k}" for k in range(6000)), "speed", "elevation_deg", *PLACE]
    cells = ["1"] * 6000 + ["7.1", "52", "2.1", "4.2"]
    file = written(tmp_path / "t.csv", f"{','.join(names)}\n{','.join(cells)}\n")
    start = time.process_time()
    for _ in range(3):
        Source(file).columns()
    assert time.process_time() - start < 20.0  # a minute each when it was quadratic


LIMITED = """
import resource, sys
import hoopgen
resource.setrlimit(resource.RLIMIT_AS, (3 << 30, 3 << 30))
try:
    print(dict(hoopgen.batch(sys.argv[1], release={"height": 2.1, "distance": 4.2})))
except ValueError as error:
    print(error)
"""


def _shared_text(file: Path) -> None:
    """A text of 100 MB that a thousand rows share, in a few kilobytes."""
    text = pa.DictionaryArray.from_arrays(pa.array([0] * 1000), pa.array(["x" * 10**8]))
    plain = {"speed": [7.1] * 1000, "elevation_deg": [52.0] * 1000}
    pq.write_table(pa.table({**plain, "note": text}), file, compression="zstd")


def _shared_text_in_lists(file: Path) -> None:
    text = pa.DictionaryArray.from_arrays(pa.array([0] * 1000), pa.array(["x" * 10**8]))
    lists = pa.ListArray.from_arrays(pa.array([0, 1000]), text)
    plain = {"speed": [7.1], "elevation_deg": [52.0]}
    pq.write_table(pa.table({**plain, "note": lists}), file, compression="zstd")


def _shared_text_in_arrow(file: Path) -> None:
    text = pa.DictionaryArray.from_arrays(pa.array([0] * 1000), pa.array(["x" * 10**8]))
    table = pa.table({"speed": text, "elevation_deg": [52.0] * 1000})
    with pa.ipc.new_file(str(file), table.schema) as new:
        new.write_table(table)


HARMFUL = {
    "shared.parquet": _shared_text,
    "lists.parquet": _shared_text_in_lists,
    "shared.arrow": _shared_text_in_arrow,
}


@pytest.mark.parametrize("name", HARMFUL)
@pytest.mark.slow
def test_a_small_file_that_takes_all_memory_is_refused(name: str, tmp_path: Path) -> None:
    HARMFUL[name](tmp_path / name)
    ran = subprocess.run(
        [sys.executable, "-c", LIMITED, str(tmp_path / name)],
        capture_output=True,
        text=True,
        check=False,
        timeout=300,
    )
    assert ran.returncode == 0, ran.stderr
    assert re.search(r"column \w+ has [\d,]+ bytes, more than 1,073,741,824; --memory", ran.stdout)


def test_the_limit_can_be_raised(tmp_path: Path) -> None:
    note = pa.DictionaryArray.from_arrays(pa.array([0] * 200), pa.array(["x" * 10**5]))
    table = pa.table({"speed": [7.1] * 200, "elevation_deg": [52.0] * 200, "note": note})
    pq.write_table(table, tmp_path / "t.parquet")
    command = ("batch", tmp_path / "t.parquet", "--out", tmp_path / "o.parquet", *HERE)
    result = run(*command, "--memory", "17MB")
    assert result.exit_code == 2
    assert "column note has 20,000,000 bytes, more than 17,000,000; --memory" in result.stderr
    succeed(*command, "--memory", "30MB")
    assert pq.read_table(tmp_path / "o.parquet")["note"].to_pylist() == table["note"].to_pylist()
    assert "is no size, such as 4GB" in run(*command, "--memory", "much").stderr
    assert "memory: expected at least 16,777,216 bytes" in run(*command, "--memory", "1kB").stderr


def test_a_packed_spreadsheet_is_measured_before_it_is_read(tmp_path: Path) -> None:
    file = sheet(tmp_path / "t.xlsx", [["speed", "note"], *([7.1, "x" * 30_000] for _ in range(2))])
    import zipfile

    with zipfile.ZipFile(file, "a", zipfile.ZIP_DEFLATED) as parts:
        parts.writestr("xl/media/zeros", bytes(20_000_000))
    assert file.stat().st_size < 100_000
    with pytest.raises(ValueError, match=r"t\.xlsx: has [\d,]+ bytes unpacked, more than 16,777"):
        Source(file, memory=1 << 24).schema()
    assert Source(file).schema().names == ["speed", "note"]


def test_pages_that_are_small_in_the_file_alone_are_refused(tmp_path: Path) -> None:
    zeros = pa.table({"speed": np.zeros(4_000_000)})
    packed: dict[str, Any] = {"compression": "zstd", "use_dictionary": False}
    pq.write_table(zeros, tmp_path / "t.parquet", row_group_size=len(zeros), **packed)
    assert (tmp_path / "t.parquet").stat().st_size < 30_000
    with pytest.raises(
        ValueError, match=r"column speed has 32,\d+,\d+ bytes, more than 16,777,216"
    ):
        Source(tmp_path / "t.parquet", memory=1 << 24).schema()
    pq.write_table(zeros.slice(0, 1000), tmp_path / "few.parquet", use_dictionary=False)
    assert Source(tmp_path / "few.parquet", memory=1 << 24).schema().names == ["speed"]


def test_a_frame_of_one_large_batch_is_read_in_parts() -> None:
    rows, limit = 2_000_000, 1 << 24
    table = pa.table({"speed": np.full(rows, 0.01), "elevation_rad": np.full(rows, 0.9)})
    (batch,) = table.to_batches()
    assert batch.nbytes > limit
    read = hoopgen.batch(table, release=PLACE, memory=limit, where="speed > 1")
    assert sum(read.values()) == 0


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="there are no pipes with names")
def test_a_pipe_is_no_table(tmp_path: Path) -> None:
    pipe = tmp_path / "t.csv"
    os.mkfifo(pipe)
    with pytest.raises(ValueError, match=r"t\.csv: is no file, but a pipe"):
        hoopgen.batch(pipe, release=PLACE)


def test_a_cell_of_a_million_characters_and_bytes_of_zero_are_cells(tmp_path: Path) -> None:
    long = "x" * 10**6
    text = f"speed,elevation_deg,note\n7.1,52,{long}\n7.1,{long},a\x00b\n"
    table = hoopgen.batch(written(tmp_path / "t.csv", text), release=PLACE, reason=True).to_arrow()
    assert table["note"].to_pylist() == [long, "a\x00b"]
    assert table["reason"][1].as_py() == f"no number in elevation_deg: '{'x' * 56}..."


def test_nested_columns_are_kept_and_hold_no_numbers(tmp_path: Path) -> None:
    nested = pa.array([[[{"a": "x"}]]])
    table = pa.table({"speed": [7.1], "elevation_deg": [52.0], "deep": nested})
    pq.write_table(table, tmp_path / "t.parquet")
    kept = hoopgen.batch(tmp_path / "t.parquet", release=PLACE).to_arrow()["deep"]
    assert kept.to_pylist() == nested.to_pylist()
    with pytest.raises(ValueError, match="column deep: expected numbers, got list"):
        hoopgen.batch(table, release=PLACE, columns={"backspin_hz": "deep"})
    assert HOOP.has_hoop


# Study files

STUDY = """
[study]
name = "tables"
seed = 3

[scene]
preset = "nba"

[[question]]
name = "rows"
kind = "batch"
file = "thrown.csv"
columns = { speed = "release_speed_mph", azimuth = "side_angle_deg", distance = "shot_distance_ft" }
where = ["player != Cy"]

[[question]]
name = "share"
kind = "estimate"
shots = 100
[question.releases]
file = "thrown.csv"
where = ["player == Ann"]
[question.releases.columns]
speed = "release_speed_mph"
backspin_rpm = "spin_rpm"
distance = "shot_distance_ft"
"""


def test_a_study_reads_tables_alike(thrown: Path, tmp_path: Path) -> None:
    pytest.importorskip("pydantic")
    out = tmp_path / "out"
    hoopgen.run_study(written(tmp_path / "study.toml", STUDY), out)
    answers = {
        name: json.loads((out / name / "answer.json").read_bytes())["numbers"]
        for name in ("rows", "share")
    }
    columns = {name: one for name, one in MAPPED.items() if name != "backspin"}
    given: dict[str, Any] = {"columns": columns, "where": "player != Cy"}
    assert answers["rows"] == hoopgen.batch(thrown, parameters=hoopgen.NBA, **given)
    plain = pa.table(THROWN).filter(pa.compute.equal(pa.array(THROWN["player"]), "Ann"))
    units = {
        "release_speed_mph": ("speed", "mph", "speed"),
        "spin_rpm": ("spin", "rpm", "backspin"),
    }
    sizes = {name: (UNITS[kind][unit], said) for name, (kind, unit, said) in units.items()}
    sizes |= {"elevation_deg": (DEGREE, "elevation"), "height_ft": (FOOT, "height")}
    sizes |= {"shot_distance_ft": (FOOT, "distance")}
    model = hoopgen.Resample(
        {said: plain[name].to_numpy() * size for name, (size, said) in sizes.items()}
    )
    found = hoopgen.estimate(model, hoopgen.NBA, shots=100, seed=3)
    assert answers["share"]["made"] == found.made


@pytest.mark.parametrize(
    ("line", "said"),
    [
        ('where = ["player"]', "where: expected a column, one of"),
        ('columns = ["speed"]', "expected a table, a column name each"),
        ('implausible = "yes"', "expected true or false"),
        ('columns = { speed = "nope" }', "columns: speed=nope: no column nope"),
    ],
)
def test_what_a_study_says_wrong_of_a_table_is_refused(
    line: str, said: str, thrown: Path, tmp_path: Path
) -> None:
    pytest.importorskip("pydantic")
    question = f'[[question]]\nname = "rows"\nkind = "batch"\nfile = "thrown.csv"\n{line}\n'
    file = written(tmp_path / "study.toml", f'[study]\nname = "x"\n{question}')
    with pytest.raises(ValueError, match=re.escape(said)):
        hoopgen.run_study(file, tmp_path / "out")


@pytest.mark.slow
def test_a_malformed_row_in_another_encoding_is_one_line(tmp_path: Path) -> None:
    """The text of such a row cannot be decoded, of which pyarrow printed a traceback."""
    rows = b"speed_m_s,elevation_deg,player\n7.1,52,Ann\n7.1,52,Zo\xeb,1\n"
    (tmp_path / "t.csv").write_bytes(rows)
    command = ["batch", "t.csv", "--out", "o.csv", *HERE]
    done = subprocess.run(
        [sys.executable, "-m", "hoopgen", *command],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 2
    assert done.stderr.splitlines() == [
        "hoopgen: error: t.csv: is not in UTF-8 but, it seems, in Latin-1 or Windows-1252; "
        "save it as UTF-8"
    ]


def test_a_frame_with_columns_of_several_types_loses_only_the_rows_without_a_number() -> None:
    pd = pytest.importorskip("pandas")
    frame = pd.DataFrame(
        {
            "speed_mph": [16.0, "abc", None, 16.2],
            "elevation_deg": 52.0,
            "height_ft": 7.0,
            "distance_ft": 13.75,
            "note": ["a", 1, None, 2.5],
        }
    )
    found = hoopgen.batch(frame).to_pandas()
    assert (found["outcome"] == "invalid").tolist() == [False, True, True, False]
    assert found["note"].iloc[[0, 1, 3]].tolist() == ["a", "1", "2.5"]


def test_conditions_that_no_row_meets_are_named(tmp_path: Path) -> None:
    file = tmp_path / "releases.csv"
    file.write_text("speed_mph,elevation_deg,player\n16,52,Ann\n")
    given = ("estimate", "--from", file, "--where", "player == Bea", "--height", "7ft")
    said = failure(*map(str, (*given, "--distance", "13.75ft", "--shots", "10")))
    assert f"--where: no row of {file} meets it" in said
