"""A table of releases in, a Parquet file of results out: every row, in order, whatever happens."""

from __future__ import annotations

import io
import json
import os
import signal
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import hoopgen
from hoopgen.cli.messages import shown
from tests.helpers.commands import run, succeed

pa = pytest.importorskip("pyarrow")
pq = pytest.importorskip("pyarrow.parquet")

from hoopgen.core.units import FOOT  # noqa: E402
from hoopgen.hoop.kinds import Kind, hoop_outcomes, kinds  # noqa: E402
from hoopgen.study.jobs import chunks  # noqa: E402
from hoopgen.study.measures.measures import MEASURES, measure  # noqa: E402
from hoopgen.study.named_units import named  # noqa: E402
from hoopgen.study.questions import batch as study_batch  # noqa: E402
from hoopgen.study.tables import flights  # noqa: E402
from hoopgen.study.tables.columns import NAMED  # noqa: E402
from hoopgen.study.tables.source import Source  # noqa: E402

ROWS = 500
PLACE = {"height": 2.1, "distance": 4.2}
COMPONENTS = ("x", "y", "z", "vx", "vy", "vz", "wx", "wy", "wz")


def throws(rows: int = ROWS) -> dict[str, Any]:
    """Columns of throws that do all that a throw can, in feet and degrees; and columns besides."""
    random = np.random.default_rng(8)
    return {
        "id": np.arange(rows),
        "speed_ft_s": random.normal(7.0, 0.5, rows) / FOOT,
        "player": [f"player {k % 5}" for k in range(rows)],
        "elevation_deg": random.normal(52, 6, rows),
        "azimuth_deg": random.normal(0, 3, rows),
        "backspin_hz": random.normal(3, 1, rows),
        "restitution": random.uniform(0.5, 0.9, rows),
    }


def simulated(columns: Mapping[str, Any], parameters: Mapping[str, Any] = hoopgen.PAPER) -> Any:
    """States, results and scene of the same throws, all at once."""
    states = hoopgen.release(
        columns["speed_ft_s"] * FOOT,
        columns["elevation_deg"] * (np.pi / 180),
        columns["azimuth_deg"] * (np.pi / 180),
        columns["backspin_hz"] * (2 * np.pi),
        **PLACE,
    )
    scene = {**parameters, "restitution": columns["restitution"]}
    return states, hoopgen.simulate(states, scene), scene


@pytest.fixture
def source(tmp_path: Path) -> Path:
    """The throws in a Parquet file."""
    pq.write_table(pa.table(throws()), tmp_path / "throws.parquet")
    return tmp_path / "throws.parquet"


def stored(file: Path, columns: Mapping[str, Any]) -> None:
    """Write a table in the format of the suffix."""
    table = pa.table(columns)
    if file.suffix == ".csv":
        pa.csv.write_csv(table, file)
    elif file.suffix == ".parquet":
        pq.write_table(table, file)
    else:
        with pa.ipc.new_file(file, table.schema) as out:
            out.write_table(table)


def read(file: Path) -> Any:
    return pq.ParquetFile(file).read()


def same(table: Any, other: Any) -> None:
    """Check that two tables have the same columns, NaN being itself."""
    assert table.column_names == other.column_names
    for name in table.column_names:
        ours, theirs = table[name].to_pylist(), other[name].to_pylist()
        if pa.types.is_floating(table[name].type):
            np.testing.assert_array_equal(theirs, ours)
        else:
            assert theirs == ours


def names(column: Any) -> list[str | None]:
    return column.to_pylist()  # type: ignore[no-any-return]


# Results


def test_results_are_those_of_the_shots_row_by_row(source: Path, tmp_path: Path) -> None:
    outcomes = hoopgen.batch(
        source,
        tmp_path / "out.parquet",
        parameters=hoopgen.NBA,
        release=PLACE,
        measures=list(MEASURES),
        rows=77,
    )
    table, columns = read(tmp_path / "out.parquet"), throws()
    states, shots, scene = simulated(columns, hoopgen.NBA)
    assert table.select(list(columns)) == pa.table(columns)
    assert names(table["outcome"]) == [hoopgen.Outcome(k).name.lower() for k in shots.outcome]
    kind = kinds(shots.outcome, shots.counts, shots.first)
    assert names(table["kind"]) == [Kind(k).name.lower() for k in kind]
    first = [hoopgen.SURFACES[k] if k >= 0 else None for k in shots.first]
    assert names(table["first"]) == first
    assert table["contacts"].to_pylist() == shots.contacts.tolist()
    for surface, counts in zip(hoopgen.SURFACES, shots.counts.T, strict=True):
        assert table[f"{surface}_contacts"].to_pylist() == counts.tolist()
    assert table["uncertain"].to_pylist() == shots.uncertain.tolist()
    ended = shots.outcome <= hoopgen.Outcome.MISSED
    for name, numbers in zip(("time", *COMPONENTS), (shots.time, *shots.state.T), strict=True):
        expected = np.where(ended, numbers, np.nan)
        np.testing.assert_array_equal(table[named(f"end_{name}")].to_numpy(), expected)
    for name, numbers in measure(states, shots, scene).items():
        np.testing.assert_array_equal(table[named(name)].to_numpy(), numbers)
    counts = np.bincount(shots.outcome, minlength=len(hoop_outcomes(False)))
    assert list(outcomes.values()) == counts.tolist()
    assert list(outcomes) == [outcome.name.lower() for outcome in hoop_outcomes(False)]
    assert np.all(counts[: hoopgen.Outcome.INVALID] > 0), "throws of every kind"


@pytest.mark.parametrize("name", ["throws.csv", "throws.arrow"])
def test_formats_differ_in_nothing(name: str, source: Path, tmp_path: Path) -> None:
    table = pa.table(throws())
    if name.endswith("csv"):
        pa.csv.write_csv(table, tmp_path / name)
    else:
        with pa.ipc.new_stream(str(tmp_path / name), table.schema) as writer:
            writer.write_table(table, 90)
    hoopgen.batch(source, tmp_path / "a.parquet", release=PLACE)
    hoopgen.batch(tmp_path / name, tmp_path / "b.parquet", release=PLACE)
    ours, theirs = read(tmp_path / "a.parquet"), read(tmp_path / "b.parquet")
    results = ours.column_names[len(table.column_names) :]
    same(theirs.select(results), ours.select(results))
    own = theirs.select(table.column_names)
    assert own.schema.types == table.schema.types
    assert own == table


@pytest.mark.parametrize("suffix", ["arrow", "arrows", "feather"])
def test_results_in_arrow_are_those_in_parquet_and_are_read_again(
    suffix: str, source: Path, tmp_path: Path
) -> None:
    out, again = tmp_path / f"a.{suffix}", tmp_path / "again.parquet"
    hoopgen.batch(source, out, release=PLACE, rows=100)
    hoopgen.batch(source, tmp_path / "a.parquet", release=PLACE, rows=100)
    opened = pa.ipc.open_stream if suffix == "arrows" else pa.ipc.open_file
    with pa.memory_map(str(out)) as file:
        table = opened(file).read_all()
    parquet = read(tmp_path / "a.parquet")
    words = [pa.types.is_dictionary(kind) for kind in table.schema.types]
    assert any(words) == (suffix == "arrows"), "programs read words in files more easily as text"
    same(table.cast(parquet.schema), parquet)
    hoopgen.batch(out, again)
    same(read(again), parquet)


def test_states_are_simulated_as_they_are(tmp_path: Path) -> None:
    states, shots, _ = simulated(throws() | {"restitution": 0.7})
    columns = {f"{name}_{unit}": states[:, k] for k, (name, unit) in enumerate(STATE_UNITS)}
    pq.write_table(pa.table(columns), tmp_path / "states.parquet")
    hoopgen.batch(tmp_path / "states.parquet", tmp_path / "out.parquet")
    table = read(tmp_path / "out.parquet")
    assert table["contacts"].to_pylist() == shots.contacts.tolist()


STATE_UNITS = [(name, ("m", "m_s", "rad_s")[k // 3]) for k, name in enumerate(COMPONENTS)]


def test_a_row_without_a_number_is_invalid_and_disturbs_no_other(tmp_path: Path) -> None:
    lines = ["speed,elevation_deg,restitution,note"]
    lines += ["7.1,52,0.7,a", "fast,52,0.7,b", "7.1,,0.7,c", "7.1,52,,d", "7.1,52,1.5,e"]
    (tmp_path / "t.csv").write_text("\n".join(lines), encoding="utf-8")
    outcomes = hoopgen.batch(tmp_path / "t.csv", tmp_path / "out.parquet", release=PLACE)
    table = read(tmp_path / "out.parquet")
    assert names(table["outcome"])[1:] == ["invalid"] * 4
    alone = hoopgen.simulate(hoopgen.release(7.1, np.radians(52), **PLACE))
    assert names(table["outcome"])[0] == hoopgen.Outcome(int(alone.outcome[0])).name.lower()
    assert table["end_time_s"][0].as_py() == alone.time[0]
    assert names(table["kind"])[1] == "none"
    assert names(table["note"]) == list("abcde")
    assert outcomes["invalid"] == 4


@pytest.mark.parametrize("rows", [2, 100])
def test_in_csv_cells_that_are_no_number_stay_as_they_are(tmp_path: Path, rows: int) -> None:
    lines = ["speed;elevation_deg;restitution;note", "7,10;52;0,7;1,5", "7,2;;0,7;n/a"]
    lines += ["fast;about 50;0,7;", ";52,5;0,7;-"]
    (tmp_path / "t.csv").write_text("\n".join(lines), encoding="utf-8")
    for source in ("t.csv", "out.csv"):  # results are read like any table
        counts = hoopgen.batch(tmp_path / source, tmp_path / "new.csv", release=PLACE, rows=rows)
        assert counts["invalid"] == 3
        (tmp_path / "new.csv").rename(tmp_path / "out.csv")
        text = (tmp_path / "out.csv").read_text(encoding="utf-8")
        assert [line.split(',"')[:3] for line in text.splitlines()[2:]] == [
            ['"7.10"', '52",0.7', '1,5"'],
            ['"7.2"', '",0.7', 'n/a"'],
            ['"fast"', 'about 50",0.7', '"'],
            ['""', '52.5",0.7', '-"'],
        ]
    hoopgen.batch(tmp_path / "t.csv", tmp_path / "out.parquet", release=PLACE)
    assert read(tmp_path / "out.parquet")["speed"].to_pylist() == [7.1, 7.2, None, None]


def test_own_columns_of_any_type_are_kept(tmp_path: Path) -> None:
    own = {
        "speed": [7.0, 7.2, 7.1],
        "elevation_rad": [0.9, 0.9, 0.9],
        "when": pa.array([1, 2, None], pa.timestamp("ms")),
        "path": [[1.0, 2.0], [], None],
        "team": pa.array(["a", "b", "a"]).dictionary_encode(),
        "distance_to_defender": [1, 2, 3],
    }
    table = pa.table(own).replace_schema_metadata({"source": "tracking"})
    with pa.ipc.new_file(str(tmp_path / "t.arrow"), table.schema) as writer:
        writer.write_table(table, 2)
    hoopgen.batch(
        *(tmp_path / "t.arrow", tmp_path / "out.parquet"),
        release=PLACE,
        own=["distance_to_defender"],
        rows=2,
    )
    result = read(tmp_path / "out.parquet")
    assert result.select(list(own)).to_pydict() == table.to_pydict()
    assert result.schema.metadata[b"source"] == b"tracking"


def test_units_and_settings_are_in_the_file(source: Path, tmp_path: Path) -> None:
    scene = hoopgen.NBA | {"gravity": 9.8}
    hoopgen.batch(
        *(source, tmp_path / "out.parquet"),
        parameters=scene,
        release=PLACE,
        measures=["entry_angle"],
        max_contacts=7,
    )
    schema = read(tmp_path / "out.parquet").schema
    units = {field.name: (field.metadata or {}).get(b"unit") for field in schema}
    assert units["end_time_s"] == b"s"
    assert units["end_x_m"] == b"m"
    assert units["end_vz_m_s"] == b"m/s"
    assert units["end_wy_rad_s"] == b"rad/s"
    assert units["entry_angle_rad"] == b"rad"
    assert units["contacts"] is None
    assert json.loads(schema.metadata[b"hoopgen"]) == {
        "version": hoopgen.__version__,
        "preset": "nba",
        "scene": "NBA, gravity 9.8 m/s², restitution by row",
        "parameters": dict(scene),
        "release": PLACE,
        "max_contacts": 7,
        "own": [],
        "columns": {},
        "results": schema.names[len(throws()) :],
        NAMED: True,
    }


def test_a_table_without_rows_gives_one(tmp_path: Path) -> None:
    (tmp_path / "t.csv").write_text("speed,elevation_deg\n", encoding="utf-8")
    outcomes = hoopgen.batch(tmp_path / "t.csv", tmp_path / "out.parquet", release=PLACE)
    assert not any(outcomes.values())
    assert len(read(tmp_path / "out.parquet")) == 0


# The same bytes


def test_neither_threads_nor_place_nor_time_change_a_byte(source: Path, tmp_path: Path) -> None:
    (tmp_path / "other").mkdir()
    copy = tmp_path / "other" / "copy.pq"
    copy.write_bytes(source.read_bytes())
    hoopgen.batch(source, tmp_path / "a.parquet", release=PLACE, threads=1, rows=60)
    hoopgen.batch(
        copy, tmp_path / "other" / "b.parquet", release=PLACE, threads=3, rows=60, format="parquet"
    )
    assert (tmp_path / "a.parquet").read_bytes() == (tmp_path / "other/b.parquet").read_bytes()
    assert {file.name for file in (tmp_path / "other").iterdir()} == {"copy.pq", "b.parquet"}


def test_chunks_change_no_row(source: Path, tmp_path: Path) -> None:
    hoopgen.batch(source, tmp_path / "a.parquet", release=PLACE, rows=23)
    hoopgen.batch(source, tmp_path / "b.parquet", release=PLACE)
    same(read(tmp_path / "a.parquet"), read(tmp_path / "b.parquet"))


KILLED = """
import os, signal, sys
from pathlib import Path
import hoopgen

source, out, count = Path(sys.argv[1]), Path(sys.argv[2]), int(sys.argv[3])
left, replace = [count], Path.replace

def named(self, target):
    replace(self, target)
    left[0] -= 1
    if left[0] == 0:
        os.kill(os.getpid(), signal.SIGKILL)

Path.replace = named
hoopgen.batch(source, out, release={"height": 2.1, "distance": 4.2}, rows=100, threads=1)
"""


@pytest.mark.parametrize("count", [4, 7, 8])
@pytest.mark.slow
def test_a_batch_that_was_killed_goes_on_to_the_same_bytes(
    count: int, source: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    whole, out = tmp_path / "whole.parquet", tmp_path / "out.parquet"
    hoopgen.batch(source, whole, release=PLACE, rows=100)
    # Files that get their names: the marker, the identity, five chunks, the results.
    killed = subprocess.run(
        [sys.executable, "-c", KILLED, str(source), str(out), str(count)], check=False
    )
    assert killed.returncode == -signal.SIGKILL
    assert out.exists() == (count == 8)
    simulations = []

    def simulate(states: Any, *arguments: Any, **options: Any) -> hoopgen.Shots:
        simulations.append(len(states))
        return hoopgen.simulate(states, *arguments, **options)

    monkeypatch.setattr("hoopgen.study.tables.flights.simulate", simulate)
    hoopgen.batch(source, out, release=PLACE, rows=100)
    assert sum(simulations) == ROWS - 100 * min(count - 2, 5)
    assert out.read_bytes() == whole.read_bytes()
    assert {file.name for file in tmp_path.iterdir()} == {source.name, whole.name, out.name}


def test_chunks_of_another_table_or_setting_are_not_taken(source: Path, tmp_path: Path) -> None:
    out = tmp_path / "out.parquet"
    stopped = pytest.raises(KeyboardInterrupt)

    def stop(done: int, total: int | None) -> None:
        if done == 2:
            raise KeyboardInterrupt

    with stopped as raised:
        hoopgen.batch(source, out, release=PLACE, rows=100, progress=stop)
    assert raised.value.__notes__ == [
        f"finished chunks are in {out}.parts: the same call goes on from there"
    ]
    assert not out.exists()
    with pytest.raises(ValueError, match=r"another job: max_contacts is 40 there and 3 here\. "):
        hoopgen.batch(source, out, release=PLACE, rows=100, max_contacts=3)
    table = pa.table(throws() | {"id": np.arange(1, ROWS + 1)})
    pq.write_table(table, source)
    with pytest.raises(ValueError, match=r"another job: source\.digest is "):
        hoopgen.batch(source, out, release=PLACE, rows=100)


def test_whole_numbers_may_be_numpy_s(source: Path, tmp_path: Path) -> None:
    given = {"rows": np.int64(100), "max_contacts": np.int32(5)}
    for out, options in (("a", given), ("b", {name: int(n) for name, n in given.items()})):
        hoopgen.batch(source, tmp_path / f"{out}.parquet", release=PLACE, **options)
    assert (tmp_path / "a.parquet").read_bytes() == (tmp_path / "b.parquet").read_bytes()


@pytest.mark.sampled(4)
@pytest.mark.parametrize("name", ["throws.csv", "throws.parquet", "throws.arrow"])
@pytest.mark.parametrize("when", ["before it is read", "while", "after the last chunk"])
def test_a_source_that_changes_meanwhile_gives_no_result(
    when: str, name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    source, out = tmp_path / name, tmp_path / "out.parquet"
    stored(source, throws())
    out.write_bytes(b"old")
    digest = Source.digest

    def change() -> None:
        changed = tmp_path / f"new-{name}"
        stored(changed, throws() | {"speed_ft_s": np.full(ROWS, 20.0)})
        changed.replace(source)
        os.utime(source, ns=(0, 0))  # however coarse the clock of the file system is

    def changed_after(table: Source) -> tuple[str, int | None]:
        found = digest(table)
        if when == "before it is read":
            change()
        return found

    def progress(done: int, total: int | None) -> None:
        if done == {"while": 1, "after the last chunk": 5}.get(when):
            change()

    monkeypatch.setattr(Source, "digest", changed_after)
    with pytest.raises(ValueError, match=rf"{name}: changed while it was read"):
        hoopgen.batch(source, out, release=PLACE, rows=100, threads=1, progress=progress)
    assert out.read_bytes() == b"old"
    monkeypatch.undo()
    # What was kept is of the table that the digest was taken of.
    stored(source, throws())
    hoopgen.batch(source, out, release=PLACE, rows=100)
    hoopgen.batch(source, tmp_path / "whole.parquet", release=PLACE, rows=100)
    assert out.read_bytes() == (tmp_path / "whole.parquet").read_bytes()


@pytest.mark.slow
def test_a_full_disk_is_told_and_the_old_file_stays(
    source: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    out = tmp_path / "out.parquet"
    hoopgen.batch(source, out, release=PLACE, rows=100)
    before = out.read_bytes()
    limited = (
        "import resource\n"
        "resource.setrlimit(resource.RLIMIT_FSIZE, (60_000, resource.RLIM_INFINITY))\n"
    )
    ran = subprocess.run(
        [sys.executable, "-c", limited + KILLED, str(source), str(out), "0"],
        check=False,
        capture_output=True,
        text=True,
    )
    assert (
        f"File too large; finished chunks are kept, and the same call goes on from there: '{out}"
        in ran.stderr
    )
    assert out.read_bytes() == before
    assert len(list((tmp_path / "out.parquet.parts").glob("chunk-*"))) == 5
    assert not list((tmp_path / "out.parquet.parts").glob("*.tmp"))
    hoopgen.batch(source, out, release=PLACE, rows=100)
    assert out.read_bytes() == before


# Bad input


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ({"release": {"height": 2.1}}, r"throws\.parquet: variables: missing distance"),
        ({"release": {"hight": 2.1}}, r"release: unknown hight; is height meant\? One of speed, "),
        ({"release": PLACE | {"aim": [0.1]}}, r"release\['aim'\]: expected one number"),
        ({"measures": ["deep"]}, r"measures: unknown deep; is depth meant\? One of entry_angle, "),
        ({"max_contacts": 0}, "max_contacts: expected a whole number from 1, got 0"),
        ({"max_contacts": 2.5}, "max_contacts: expected a whole number from 1, got 2.5"),
        ({"rows": 0}, "rows: expected a whole number from 1, got 0"),
        ({"rows": 2.5}, "rows: expected a whole number from 1, got 2.5"),
        ({"parameters": {"bounce": 9.8}}, "parameters: unknown bounce. The names are ball_radius"),
        (
            {"parameters": hoopgen.PAPER | {"gravity": [9.8]}},
            r"parameters\['gravity'\]: expected one number; those by shot are a column",
        ),
        ({"own": ["who"]}, "own: no column who"),
        ({"format": "xls"}, "format: expected one of csv, parquet, arrow"),
        ({"out": "out.nc"}, r"out: expected a file \.csv, \.tsv, \.parquet, .* or \.ipc, got"),
        ({"out": "throws.parquet"}, r"out: .* is the source"),
        ({"out": "none/out.parquet"}, "out: there is no folder .*none"),
    ],
)
def test_bad_arguments_are_refused_before_anything_is_written(
    options: dict[str, Any], said: str, source: Path, tmp_path: Path
) -> None:
    given: dict[str, Any] = {"release": PLACE, "out": "out.parquet", **options}
    with pytest.raises(ValueError, match=said):
        hoopgen.batch(source, tmp_path / given.pop("out"), **given)
    assert [file.name for file in tmp_path.iterdir()] == [source.name]


def test_columns_named_like_results_need_a_prefix(source: Path, tmp_path: Path) -> None:
    table = pa.table(throws() | {"outcome": ["?"] * ROWS, "depth_m": np.zeros(ROWS)})
    pq.write_table(table, source)
    out = tmp_path / "out.parquet"
    with pytest.raises(ValueError, match="named like results: outcome, depth_m; give a prefix"):
        hoopgen.batch(source, out, release=PLACE, measures=["depth"])
    hoopgen.batch(source, out, release=PLACE, measures=["depth"], prefix="hoopgen_")
    result = read(out)
    assert result.select(table.column_names) == table
    assert {"hoopgen_outcome", "hoopgen_depth_m", "hoopgen_end_x_m"} < {*result.column_names}


# Reasons

WRONG = {
    "speed,elevation_deg,restitution,height\n": "",
    "7.1,52,0.7,2.1\n": "",
    "fast,,0.7,2.1\n": "no number in speed: 'fast'; no value in elevation_deg",
    "inf,52,0.7,2.1\n": "not finite: speed",
    "7.1,52,1.5,2.1\n": (
        "parameter not allowed: restitution 1.5; restitution has to be from 0 to 1"
    ),
    "7.1,52,0.7,3.048\n": "inside the ring",
    "7.1,52,,2.1\n": "no value in restitution",
    "1e308,52,0.7,1e308\n": "",
    "nan,52,0.7,2.1\n": "no value in speed",
}
RING = {"distance": float(hoopgen.PAPER["ring_radius"])}


def test_rows_that_are_invalid_are_listed_and_say_why(tmp_path: Path) -> None:
    (tmp_path / "t.csv").write_text("".join(WRONG), encoding="utf-8")
    expected = list(WRONG.values())[1:]
    for rows in (2, 100):
        out = tmp_path / f"{rows}.parquet"
        given: dict[str, Any] = {"release": RING, "rows": rows}
        result = hoopgen.batch(tmp_path / "t.csv", out, reason=True, **given)
        told = [text or "" for text in names(read(out)["reason"])]
        invalid = [name == "invalid" for name in names(read(out)["outcome"])]
        assert [bool(text) for text in told] == invalid
        assert [text for text, known in zip(told, expected, strict=True) if known] == [
            *filter(None, expected)
        ]
        listed = [(row, text) for row, text in enumerate(told, 1) if text]
        assert result.invalid == tuple(listed[:5])
        without = hoopgen.batch(tmp_path / "t.csv", out, **given)
        assert without.invalid == result.invalid
        assert "reason" not in read(out).column_names


def test_an_aim_that_no_speed_reaches_is_a_reason() -> None:
    table = pa.table({"aim": [0.0, -9.0], "elevation_deg": [52.0, 52.0]})
    result = hoopgen.batch(table, release=PLACE, reason=True)
    assert result.invalid == ((2, "no speed brings the ball down through the point aimed at"),)


def test_the_command_says_what_was_read_and_what_is_invalid(tmp_path: Path) -> None:
    (tmp_path / "t.csv").write_text(
        "id;speed_mph;elevation_deg\n01;16,1;52\n" + "02;x;52\n" * 7, encoding="utf-8"
    )
    place = ["--release", "height=7ft", "--release", "distance=13.75ft"]
    result = succeed("batch", tmp_path / "t.csv", "--out", tmp_path / "out.csv", *place, "--reason")
    lines = result.stdout.splitlines()[1:-1]
    assert lines[:5] == [
        "read: speed_mph as speed in mph, elevation_deg as elevation in deg, with decimal commas",
        "not read: id",
        "given: height 2.1336 m, distance 4.191 m",
        "assumed: azimuth 0°, backspin 0 Hz, sidespin 0 Hz, angle 0°",
        "invalid: row 2: no number in speed_mph: 'x'",
    ]
    assert lines[8:] == [
        "invalid: row 6: no number in speed_mph: 'x'",
        "invalid: and 2 more; by cause 7 no number in speed_mph",
    ]
    result = run("batch", tmp_path / "t.csv", "--out", tmp_path / "out.csv", *place)
    assert "\ninvalid: --reason writes why into a column\n" in result.stdout


# Tables in memory, and CSV out


class Foreign:
    """A table of which nothing is known but that it speaks Arrow, as Polars' do."""

    def __init__(self, table: Any) -> None:
        self._table = table

    def __arrow_c_stream__(self, requested_schema: Any = None) -> Any:
        return self._table.__arrow_c_stream__(requested_schema)


@pytest.mark.sampled(2)
@pytest.mark.parametrize("kind", ["pandas", "arrow", "foreign"])
def test_tables_in_memory_give_what_files_do(kind: str, source: Path, tmp_path: Path) -> None:
    hoopgen.batch(source, tmp_path / "a.parquet", release=PLACE, rows=60)
    table = pa.table(throws())
    if kind == "pandas":
        pytest.importorskip("pandas")
    words = table.schema.get_field_index("player")
    viewed = table.set_column(words, "player", table["player"].cast(pa.string_view()))
    given = {"arrow": lambda: table, "foreign": lambda: Foreign(viewed), "pandas": table.to_pandas}
    result = hoopgen.batch(given[kind](), release=PLACE, rows=60)
    assert result.path is None
    same(result.to_arrow(), read(tmp_path / "a.parquet"))
    written = hoopgen.batch(given[kind](), tmp_path / "b.parquet", release=PLACE)
    assert dict(written) == dict(result)
    same(read(tmp_path / "b.parquet"), read(tmp_path / "a.parquet"))
    if kind == "pandas":
        assert len(result.to_pandas()) == ROWS
    assert {file.name for file in tmp_path.iterdir()} == {source.name, "a.parquet", "b.parquet"}


def test_what_is_no_table_is_refused() -> None:
    with pytest.raises(TypeError, match="source: expected a file, or a table of pandas"):
        hoopgen.batch([1, 2], release=PLACE)
    with pytest.raises(ValueError, match=r"^the table: variables: missing height"):
        hoopgen.batch(pa.table({"speed": [7.0], "elevation_deg": [52.0]}))
    with pytest.raises(ValueError, match="format, delimiter: a table in memory has none"):
        hoopgen.batch(pa.table(throws(3)), release=PLACE, format="csv")


@pytest.mark.slow
def test_csv_of_results_can_be_read_again(source: Path, tmp_path: Path) -> None:
    scene = hoopgen.NBA | {"gravity": 9.8}
    given: dict[str, Any] = {"release": PLACE, "parameters": scene, "measures": list(MEASURES)}
    hoopgen.batch(source, tmp_path / "a.parquet", rows=60, **given)
    written = hoopgen.batch(source, tmp_path / "a.csv", rows=60, **given)
    ours, theirs = read(tmp_path / "a.parquet"), written.to_arrow()
    for name in ours.column_names:
        if not pa.types.is_floating(ours[name].type):
            wanted = [None if cell == "" else cell for cell in theirs[name].to_pylist()]
            assert ours[name].to_pylist() == wanted
        else:
            numbers = theirs[name].to_numpy().astype(float)
            np.testing.assert_array_equal(numbers, ours[name].to_numpy())
    again = hoopgen.batch(tmp_path / "a.csv", prefix="again_")
    assert dict(again) == dict(written)
    table = again.to_arrow()
    for name in ("kind", "contacts", "end_time_s", "end_wy_rad_s"):
        theirs_again = [cell or None for cell in table[f"again_{name}"].to_pylist()]
        if name in ("kind", "contacts"):
            assert theirs_again == [cell or None for cell in ours[name].to_pylist()]
        else:
            # A constant in a column is the same double; so are the shots.
            np.testing.assert_array_equal(table[f"again_{name}"].to_numpy(), ours[name].to_numpy())


@pytest.mark.slow
def test_csv_is_the_same_bytes_whatever_computes(source: Path, tmp_path: Path) -> None:
    for name, threads in (("a", 1), ("b", 2)):
        hoopgen.batch(source, tmp_path / f"{name}.csv", release=PLACE, threads=threads, rows=60)
    assert (tmp_path / "a.csv").read_bytes() == (tmp_path / "b.csv").read_bytes()
    assert len(list(tmp_path.iterdir())) == 3


def test_what_csv_cannot_say_is_refused_before_the_work(tmp_path: Path) -> None:
    lists = pa.table({**throws(3), "path": [[1.0], [], None]})
    with pytest.raises(ValueError, match="the table: CSV has no such column: "):
        hoopgen.batch(lists, tmp_path / "out.csv", release=PLACE)
    assert not list(tmp_path.iterdir())


# The command


HERE = ["--release", "height=2.1", "--release", "distance=4.2m"]


def test_the_command_writes_what_the_function_does(source: Path, tmp_path: Path) -> None:
    options = ["--preset", "nba", "--set", "gravity=9.8", "--measure", "depth", "--threads", "1"]
    result = succeed("batch", source, "--out", tmp_path / "a.parquet", *HERE, *options)
    assert result.stderr == ""
    outcomes = hoopgen.batch(
        source,
        tmp_path / "b.parquet",
        parameters=hoopgen.NBA | {"gravity": 9.8},
        release=PLACE,
        measures=["depth"],
    )
    assert (tmp_path / "a.parquet").read_bytes() == (tmp_path / "b.parquet").read_bytes()
    assert result.stdout.startswith(f"500 shots: {outcomes['made']} made, ")


def test_a_table_of_aims_is_one_of_releases(tmp_path: Path) -> None:
    aims, results = tmp_path / "aims.csv", tmp_path / "results.parquet"
    places = ["--distance", "4m,4.5m,40m", "--height", "7ft", "--speed", "8", "--backspin", "3Hz"]
    succeed("aim", *places, "--csv", str(aims))
    succeed("batch", aims, "--out", results, "--measure", "entry_angle", "--measure", "depth")
    table = read(results)
    assert names(table["outcome"]) == ["made", "made", "invalid"]  # the last is out of reach
    wanted = np.radians([float(cell) for cell in names(table["entry_angle_deg"])[:2] if cell])
    # The table has ten digits; the ball comes down where it was aimed at, as steeply as was said.
    np.testing.assert_allclose(table["entry_angle_rad"].to_numpy()[:2], wanted, rtol=0, atol=1e-8)
    np.testing.assert_allclose(table["depth_m"].to_numpy()[:2], 0.0, rtol=0, atol=1e-8)


def test_the_command_fails_in_one_line(source: Path, tmp_path: Path) -> None:
    for arguments, said in [
        ([*HERE, "--measure", "deep"], "--measure: unknown deep"),
        ([], "throws.parquet: missing height, distance; give --release height=... and "),
        ([*HERE, "--threads", 2, "--scheduler", "tcp://127.0.0.1:1"], "threads: with a scheduler"),
    ]:
        result = run("batch", source, "--out", tmp_path / "out.parquet", *arguments)
        assert result.exit_code == 2
        assert said in result.stderr
        assert result.stderr.count("\n") == 1
        assert result.stdout == ""


class _Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


def test_the_command_is_told_the_delimiter(tmp_path: Path) -> None:
    (tmp_path / "t.csv").write_text("a;a;a|speed|elevation_deg\n007|7,1|52\n", encoding="utf-8")
    out = tmp_path / "out.parquet"
    assert "column" in run("batch", tmp_path / "t.csv", "--out", out, *HERE).stderr
    succeed("batch", tmp_path / "t.csv", "--out", out, *HERE, "--delimiter", "|")
    assert read(out).column_names[0] == "a;a;a"
    assert read(out)["speed"].to_pylist() == [7.1]


def test_progress_is_shown_on_a_terminal_and_there_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    terminal, file = _Terminal(), io.StringIO()
    for stream in (terminal, file):
        monkeypatch.setattr(sys, "stderr", stream)
        with shown() as progress:
            for done in range(4):
                progress(done, None)
            for done in range(4, 9):
                progress(done, 8)
    assert "50%" in terminal.getvalue()
    assert "100%" in terminal.getvalue()
    assert file.getvalue() == ""


def test_an_interrupted_command_says_how_to_go_on(
    source: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def interrupted(*arguments: Any, **options: Any) -> Any:
        next(chunks.run(*arguments, **options))
        raise KeyboardInterrupt

    monkeypatch.setattr(study_batch, "run", interrupted)
    result = run("batch", source, "--out", tmp_path / "out.parquet", *HERE)
    assert result.exit_code == 130
    assert f"{tmp_path / 'out.parquet'}.parts: the same command goes on" in result.stderr
    assert result.stderr.endswith("hoopgen: error: interrupted\n")


@pytest.mark.parametrize("count", [3, 128, 129, 200])
def test_the_last_of_many_bodies_has_its_name(count: int) -> None:
    names = [f"Wall_{number}" for number in range(count)]
    column = flights._words(np.array([count - 1, -1, 0], np.int16), names)
    assert column.to_pylist() == [f"wall_{count - 1}", None, "wall_0"]
    assert column.type.index_type == (pa.int8() if count <= 128 else pa.int16())
