"""Damaged and hostile tables: an error of one line that names the file, or a table; never a crash.

What may end the process runs in a process of its own.
"""

from __future__ import annotations

import struct
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from tests.helpers.commands import run, succeed
from tests.helpers.effort import occurrences, trials

pa = pytest.importorskip("pyarrow")
feather = pytest.importorskip("pyarrow.feather")
pq = pytest.importorskip("pyarrow.parquet")
pytest.importorskip("scipy")

import hoopgen  # noqa: E402
from hoopgen.study.tables.columns import columns_of  # noqa: E402
from hoopgen.study.tables.source import Source  # noqa: E402
from hoopgen.viewer.row_sample import sample  # noqa: E402

ROWS = 24

TABLE = pa.table(
    {
        "speed": [7.0 + k / 7 for k in range(ROWS)],
        "elevation_rad": pa.array(["0.9", "0.8"] * (ROWS // 2)).dictionary_encode(),
        "distance": [None if k % 5 == 0 else 4.2 for k in range(ROWS)],
        "height": pa.array(["2.1"] * ROWS, pa.large_string()),
        "id": [f"00{k}" for k in range(ROWS)],
        "list": [[1.0] * (k % 3) for k in range(ROWS)],
    }
)


def _stream(file: Path) -> None:
    with pa.ipc.new_stream(str(file), TABLE.schema) as writer:
        writer.write_table(TABLE, 10)


WRITERS = {
    "table.arrow": _stream,
    "table.feather": lambda file: feather.write_feather(
        TABLE, str(file), compression="uncompressed"
    ),
    "lz4.feather": lambda file: feather.write_feather(TABLE, str(file), compression="lz4"),
    "table.parquet": lambda file: pq.write_table(TABLE, file, row_group_size=10),
}

READ = """
import random, sys
from pathlib import Path
from hoopgen.study.tables.source import Source

def flipped(good, random):
    bad = bytearray(good)
    for _ in range(random.randint(1, 5)):
        place = random.randrange(len(bad))
        bad[place] = random.choice([random.randrange(256), 0, 255, bad[place] ^ 128])
    return bytes(bad)

file, count = Path(sys.argv[1]), int(sys.argv[2])
good, random, read, refused = file.read_bytes(), random.Random(5), 0, 0
for number in range(count):
    file.write_bytes(flipped(good, random))
    source = Source(file)
    try:
        columns = source.columns()
        for table in source.tables(7):
            source.values(table, columns)
            table.to_pydict()
        source.digest()
        read += 1
    except ValueError as error:
        said = str(error)
        if not said.startswith(f"{file}: ") or not said.isprintable():
            sys.exit(f"flips {number}: {said!r}")
        refused += 1
print(read, refused)
"""


def alone(code: str, *arguments: object) -> subprocess.CompletedProcess[str]:
    """Run the code in a Python process of its own."""
    return subprocess.run(
        [sys.executable, "-c", code, *map(str, arguments)],
        capture_output=True,
        text=True,
        check=False,
        timeout=300,
    )


@pytest.mark.parametrize("name", WRITERS)
@pytest.mark.slow
def test_a_file_with_flipped_bytes_is_a_table_or_refused_by_name(name: str, tmp_path: Path) -> None:
    WRITERS[name](tmp_path / name)
    ran = alone(READ, tmp_path / name, trials(400))
    assert ran.returncode == 0, ran.stderr
    read, refused = map(int, ran.stdout.split())
    assert read > occurrences(20)  # else hardly anything was read
    assert refused > occurrences(100)


READ_ON = """
import os, sys
from pathlib import Path
from hoopgen.study.tables.source import Source

read = Source(Path(sys.argv[1])).tables(100)
print(len(next(read)))
os.truncate(sys.argv[1], os.path.getsize(sys.argv[1]) // 3)
try:
    print(sum(map(len, read)))
except ValueError as error:
    print(error)
"""


@pytest.mark.slow
@pytest.mark.parametrize("new", [pa.ipc.new_file, pa.ipc.new_stream])
def test_a_file_cut_off_while_it_is_read_is_refused_by_name(new: Any, tmp_path: Path) -> None:
    file = tmp_path / "table.arrow"
    table = pa.table({"speed": [7.0] * 200_000})
    with new(str(file), table.schema) as writer:
        writer.write_table(table, 20_000)
    ran = alone(READ_ON, file)
    assert ran.returncode == 0, ran.stderr
    first, said = ran.stdout.splitlines()
    assert first == "100"
    assert said.startswith(f"{file}: ")


def _of_huge_length(file: Path) -> None:
    """LZ4, in which a column says that it is 2^60 bytes long."""
    feather.write_feather(pa.table({"speed": [7.0] * 1000}), str(file), compression="lz4")
    content, start = file.read_bytes(), b"\x04\x22\x4d\x18"  # of an LZ4 frame
    before = struct.pack("<q", 8000) + start
    assert content.count(before) == 1
    file.write_bytes(content.replace(before, struct.pack("<q", 1 << 60) + start))


def _of_offsets_far_outside(file: Path) -> None:
    """Text whose last offset is outside of it."""
    table = pa.table({"speed": ["7.0"] * 1000})
    feather.write_feather(table, str(file), compression="uncompressed")
    content, end = file.read_bytes(), struct.pack("<ii", 2997, 3000)
    assert content.count(end) == 1
    file.write_bytes(content.replace(end, struct.pack("<ii", 2997, 4000)))


DAMAGES = {
    "damaged, or larger than the memory: ": _of_huge_length,
    "out of bounds: ": _of_offsets_far_outside,
}

PLACED = {"elevation": 0.9, "height": 2.1, "distance": 4.2}


@pytest.mark.parametrize("said", DAMAGES)
def test_whoever_reads_a_damaged_file_names_it(said: str, tmp_path: Path) -> None:
    file = tmp_path / "table.feather"
    DAMAGES[said](file)
    with pytest.raises(ValueError, match=said) as raised:
        list(Source(file).tables(100))
    assert str(raised.value).startswith(f"{file}: ")
    with pytest.raises(ValueError, match=said):
        hoopgen.batch(file, tmp_path / "out.parquet", release=PLACED)
    with pytest.raises(ValueError, match=said):
        sample(file, 10, release=PLACED)
    assert not (tmp_path / "out.parquet").exists()


@pytest.mark.parametrize("said", DAMAGES)
@pytest.mark.parametrize("command", ["batch", "estimate", "view"])
def test_of_a_damaged_file_a_command_says_one_line(command: str, said: str, tmp_path: Path) -> None:
    file = tmp_path / "table.feather"
    DAMAGES[said](file)
    given = {
        "batch": [str(file), "--out", str(tmp_path / "out.parquet")],
        "view": [str(file), "--out", str(tmp_path / "out.html")],
        "estimate": ["--from", str(file)],
    }
    placed = [f"{name}={value}{'rad' * (name == 'elevation')}" for name, value in PLACED.items()]
    if command == "estimate":
        release = [part for one in placed for part in f"--{one}".split("=")]
    else:
        release = [part for one in placed for part in ("--release", one)]
    result = run(command, *given[command], *release)
    assert result.exit_code == 2
    (line,) = result.stderr.splitlines()
    assert line.startswith(f"hoopgen: error: {file}: ")
    assert said in line


def test_what_a_file_says_of_itself_reaches_no_terminal(tmp_path: Path) -> None:
    file = tmp_path / "table.feather"
    feather.write_feather(pa.table({"\x1b[31mred": [1.0], "long" * 1000: [1.0]}), str(file))
    with pytest.raises(ValueError, match=r"no column says how a shot is released") as raised:
        Source(file).columns()
    said = str(raised.value)
    assert said.isprintable()
    assert "\\x1b[31mred" in said
    assert len(said) < 300


def test_a_column_that_parquet_does_not_have_is_an_error_that_names_the_file(
    tmp_path: Path,
) -> None:
    either = pa.UnionArray.from_dense(
        pa.array([0, 0], pa.int8()), pa.array([0, 1], pa.int32()), [pa.array([1, 2])]
    )
    file = tmp_path / "table.arrow"
    table = pa.table({"speed": [7.0, 7.1], "either": either})
    with pa.ipc.new_file(str(file), table.schema) as writer:
        writer.write_table(table)
    with pytest.raises(ValueError, match=r"table\.arrow: Parquet has no such column: .*union"):
        hoopgen.batch(file, tmp_path / "out.parquet", release=PLACED)


def test_own_columns_may_be_an_iterator() -> None:
    names = ["speed", "elevation_rad", "height", "distance"]
    found = columns_of([*names, "vx"], own=iter(["vx"]))
    assert [column.name for column in found.values()] == names


def test_text_is_kept_as_it_is_and_is_in_no_csv_of_ours(tmp_path: Path) -> None:
    # A spreadsheet takes such text for formulas, where it finds it in CSV.
    formulas = ["=1+1", "+1", "-1", "@sum", "\t=1"]
    file, out = tmp_path / "table.csv", tmp_path / "out.parquet"
    rows = "\n".join(f"7.1,0.9,{text}" for text in formulas)
    file.write_text(f"speed,elevation_rad,player\n{rows}\n", encoding="utf-8")
    hoopgen.batch(file, out, release={"height": 2.1, "distance": 4.2})
    kept = pq.read_table(out)["player"]
    assert kept.type == pa.string()
    assert kept.to_pylist() == formulas
    table = tmp_path / "ours.csv"
    placed = ["--height", "7ft", "--distance", "4m"]
    for command in (
        ["map", "--over", "speed=6:8:2", "--over", "elevation=45deg:60deg:2", "--out", str(table)],
        ["aim", "--entry", "45deg", "--backspin=-1Hz", "--csv", str(table)],
    ):
        succeed(*command, *placed)
        cells = table.read_text(encoding="utf-8").replace("\n", ",").split(",")
        texts = [cell for cell in cells if not _is_number(cell)]
        assert texts
        assert all(text[0].isalpha() for text in texts if text)


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True
