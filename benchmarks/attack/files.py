"""Bytes flipped: damaged files of every kind that hoopgen reads."""

import shutil
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pyarrow as pa
import pyarrow.csv
import pyarrow.parquet
from pyarrow import feather

from .cases import Attack, Attempt, Result
from .processes import Entry, hoopgen, run, said, wrong

ROWS, BATCH = 48, 16
EXTREMES = (0x00, 0x01, 0x7F, 0x80, 0xFF)

WHERE = ("--height", "7ft", "--distance", "13.75ft")
SHARED = ("--release", "height=7ft", "--release", "distance=13.75ft")
PLAYER = ("--elevation", "52deg", "--aim", "5cm", "--scatter", "speed=0.07", *WHERE)

READERS: tuple[tuple[str, ...], ...] = (
    ("batch", "{}", "--out", "results.parquet", *SHARED),
    ("estimate", "--from", "{}", "--shots", "500", *WHERE),
    ("view", "{}", "--out", "page.html", "--sample", "5", *SHARED),
    ("study", "measured.toml", "--out", "answers"),
)
"""Commands that read a table; {} is the file."""

MEASURED = """
[study]
name = "Measured"
[release]
height = "7 ft"
distance = "13.75 ft"
[releases]
file = "{}"
[[question]]
name = "made"
kind = "estimate"
shots = 500
"""

STUDY = """
[study]
name = "A player"
description = "Who throws *free throws*."
seed = 7
[scene]
preset = "nba"
restitution = 0.75
[release]
height = "7 ft"
distance = "13.75 ft"
elevation = "52 deg"
aim = "2 in"
backspin = "3 Hz"
[scatter]
speed = "0.063 m/s"
elevation = "1.3 deg"
[correlation]
speed.elevation = -0.2
[[question]]
name = "made"
title = "How often"
kind = "estimate"
shots = 500
[[question]]
name = "map"
kind = "map"
over.elevation = ["48 deg", "52 deg"]
over.aim = { from = "-6 in", to = "10 in", count = 2 }
shots = 500
"""

SIZES = ("shots", "count", "precision")
"""Keys that say how long a study takes; without them damaged, it takes no longer."""

KEPT: tuple[tuple[str, ...], ...] = (
    ("estimate", *PLAYER, "--shots", "300000", "--folder", "kept"),
    ("map", "--over", "backspin=0:3Hz:2", *PLAYER, "--folder", "kept", "--out", "map.csv"),
    ("study", "study.toml", "--out", "kept"),
)
"""Commands that continue from files that they stored."""


def table() -> pa.Table:
    """Releases, and columns of every layout that are kept as they are."""
    random = np.random.Generator(np.random.Philox(1))
    names = [f"player {k % 7}" if k % 5 else None for k in range(ROWS)]
    return pa.table(
        {
            "speed_mph": random.normal(16, 0.2, ROWS),
            "elevation_deg": random.normal(52, 1, ROWS).astype(np.float32),
            "azimuth_deg": [str(value) for value in random.normal(0, 1, ROWS).round(3)],
            "backspin_hz": pa.array([3, None] * (ROWS // 2), pa.int16()),
            "player": names,
            "team": pa.array(names).dictionary_encode(),
            "marks": [[f"mark {j}" for j in range(k % 3)] for k in range(ROWS)],
            "made": [k % 2 == 0 for k in range(ROWS)],
        }
    )


def _write_tables(folder: Path) -> list[Path]:
    whole = table()
    for compression in ("uncompressed", "lz4", "zstd"):
        path = folder / f"{compression}.feather"
        feather.write_feather(whole, path, compression=compression, chunksize=BATCH)
    with pa.ipc.new_stream(folder / "stream.arrows", whole.schema) as stream:
        stream.write_table(whole, BATCH)
    pa.parquet.write_table(whole, folder / "table.parquet", row_group_size=BATCH)
    flat = whole.drop(["marks", "team"])
    pa.csv.write_csv(flat, folder / "table.csv")
    return sorted(folder.iterdir())


def damaged(random: np.random.Generator, content: bytes, places: Sequence[int]) -> bytes:
    """Change one to five bytes at some of the places; or, one time in eight, cut off the end."""
    if random.integers(8) == 0:
        return content[: random.integers(len(content))]
    changed = bytearray(content)
    for place in random.choice(places, random.integers(1, 6)).tolist():
        how = random.integers(3)
        if how == 0:
            changed[place] ^= 1 << int(random.integers(8))
        elif how == 1:
            changed[place] = int(random.choice(EXTREMES))
        else:
            changed[place] = int(random.integers(256))
    return bytes(changed)


@dataclass(frozen=True)
class Files:
    """The whole files, what commands have kept and come to, and what reads them."""

    tables: Sequence[Path]
    kept: Sequence[tuple[Path, Mapping[str, bytes]]]
    entry: Entry = hoopgen

    def attempt(self, random: np.random.Generator, folder: Path) -> Result:
        """Damage one file, and read it."""
        (folder / "work").mkdir()
        kinds = (self._table, self._study, self._goes_on)
        return kinds[int(random.choice(3, p=[0.6, 0.15, 0.25]))](random, folder)

    def _table(self, random: np.random.Generator, folder: Path) -> Result:
        whole = self.tables[int(random.integers(len(self.tables)))]
        content = whole.read_bytes()
        file = folder / "work" / whole.name
        file.write_bytes(damaged(random, content, range(len(content))))
        (folder / "work" / "measured.toml").write_text(MEASURED.replace("{}", file.name))
        reader = READERS[random.integers(len(READERS))]
        return self._result(folder, [part.replace("{}", file.name) for part in reader])

    def _study(self, random: np.random.Generator, folder: Path) -> Result:
        content, start = STUDY.encode(), 0
        places: list[int] = []
        for line in STUDY.splitlines(keepends=True):
            if not any(size in line for size in SIZES):
                places += range(start, start + len(line))
            start += len(line)
        only_check = bool(random.integers(2))
        content = damaged(random, content, range(len(content)) if only_check else places)
        (folder / "work" / "study.toml").write_bytes(content)
        return self._result(folder, ["study", "study.toml", *["--check"] * only_check])

    def _goes_on(self, random: np.random.Generator, folder: Path) -> Result:
        which = int(random.integers(len(KEPT)))
        command, (whole, wanted) = KEPT[which], self.kept[which]
        shutil.copytree(whole / "work", folder / "work", dirs_exist_ok=True)
        there = sorted((folder / "work" / "kept").rglob("*"))
        files = [file for file in there if file.is_file() and file.stat().st_size]
        file = files[random.integers(len(files))]
        content = file.read_bytes()
        file.write_bytes(damaged(random, content, range(len(content))))
        return self._result(folder, command, None if command[0] == "study" else wanted)

    def _result(
        self, folder: Path, command: Sequence[str], wanted: Mapping[str, bytes] | None = None
    ) -> Result:
        ended = run(command, folder, entry=self.entry)
        what = wrong(ended)
        if not what and ended.status == 0 and wanted is not None and _came(folder) != wanted:
            what = "another result, and not a word"
        return Result(what, said(command), unforeseen=int(ended.unforeseen))


def _came(folder: Path) -> dict[str, bytes]:
    """Return the output of a command and its files, except those that it keeps."""
    files = (f for f in (folder / "work").iterdir() if f.is_file())
    return {"stdout": (folder / "stdout").read_bytes()} | {f.name: f.read_bytes() for f in files}


def write_files(folder: Path) -> Files:
    """Write files that are whole, and the folders that commands leave."""
    (folder / "tables").mkdir()
    tables = _write_tables(folder / "tables")
    kept = []
    for number, command in enumerate(KEPT):
        whole = folder / f"kept-{number}"
        (whole / "work").mkdir(parents=True)
        (whole / "work" / "study.toml").write_text(STUDY)
        ended = run(command, whole)
        assert ended.status == 0, ended.err
        kept.append((whole, _came(whole)))
    return Files(tables, kept)


def prepare(folder: Path) -> Attempt:
    """Write the files."""
    return write_files(folder).attempt


ATTACK = Attack(
    "files",
    "flipped bytes",
    "files",
    "Files with one to five changed bytes or a missing end: Feather (plain, LZ4, ZSTD), Arrow "
    "streams, Parquet and CSV, read by `batch`, `estimate --from`, `view` and `study`; a study "
    "file; stored chunks, identities and answers of `estimate`, `map` and `study`. The attack "
    "fails on a signal, a traceback, a result other than that of whole chunks, more than 4 GB "
    "of address space, or more than 20 s.",
    prepare,
)
