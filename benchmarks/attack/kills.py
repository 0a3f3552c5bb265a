"""Kills: work that is ended by SIGKILL at any moment, and gone on with."""

import shutil
import signal
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pyarrow.parquet

from .cases import Attack, Attempt, Result
from .files import PLAYER, SHARED, STUDY, table
from .processes import SECONDS, Ended, Entry, hoopgen, run, said, wrong

KILLS = 3
"""At most, in a case."""

LONG = STUDY.replace("shots = 500", "shots = 200_000")

_MAP = ("--over", "backspin=0:3Hz:5", "--shots", "80000")

COMMANDS: tuple[tuple[str, ...], ...] = (
    ("estimate", *PLAYER, "--shots", "600000", "--folder", "kept"),
    ("map", *PLAYER, *_MAP, "--folder", "kept", "--out", "map.csv"),
    ("batch", "releases.parquet", "--out", "results.parquet", *SHARED),
    ("study", "study.toml", "--out", "kept"),
)

ROWS = 200_000
"""Rows of the table: four chunks."""


@dataclass(frozen=True)
class Whole:
    """A command, what it leaves when nothing disturbs it, and how long that takes (s)."""

    command: Sequence[str]
    left: Mapping[str, bytes]
    seconds: float


def _left(folder: Path) -> dict[str, bytes]:
    """Return the output of a command, and all files after it."""
    work = folder / "work"
    files = {str(f.relative_to(work)): f for f in sorted(work.rglob("*")) if f.is_file()}
    return {name: f.read_bytes() for name, f in {**files, "stdout": folder / "stdout"}.items()}


@dataclass(frozen=True)
class Kills:
    """The files that commands are given, the commands, and what runs them."""

    given: Path
    wholes: Sequence[Whole]
    entry: Entry = hoopgen

    def attempt(self, random: np.random.Generator, folder: Path) -> Result:
        """Kill a command, up to three times, and let it end; each time with some threads."""
        whole = self.wholes[int(random.integers(len(self.wholes)))]
        moments = random.uniform(0, 1.1 * whole.seconds, random.integers(1, KILLS + 1)).tolist()
        shutil.copytree(self.given, folder / "work")
        after = ", ".join(f"{moment:.2f}" for moment in moments)
        command = f"{said(whole.command)}   killed after {after} s"
        killed = 0  # less than `moments` if it ended before
        for seconds in (*moments, 10 * SECONDS):
            threads = str(random.integers(1, 4))
            ended = run(
                [*whole.command, "--threads", threads], folder, entry=self.entry, seconds=seconds
            )
            killed += ended.status == -signal.SIGKILL
            if ended.status != -signal.SIGKILL and (what := wrong(ended)):
                return Result(what, command, unforeseen=int(ended.unforeseen))
        return Result(_otherwise(ended, _left(folder), whole.left), command, tries=killed)


def _otherwise(ended: Ended, left: Mapping[str, bytes], wanted: Mapping[str, bytes]) -> str:
    """Describe how the end differs from that of an undisturbed run."""
    if ended.status != 0:
        return wrong(ended) or f"does not go on: {ended.err.strip()}"
    names = sorted(name for name in {**left, **wanted} if left.get(name) != wanted.get(name))
    return f"not what an undisturbed run leaves: {', '.join(names)}" if names else ""


def undisturbed(command: Sequence[str], given: Path, folder: Path) -> Whole:
    """Run a command that nothing disturbs."""
    shutil.copytree(given, folder / "work")
    start = time.monotonic()
    ended = run(command, folder, seconds=10 * SECONDS)
    assert ended.status == 0, ended.err
    return Whole(command, _left(folder), time.monotonic() - start)


def write_files(folder: Path) -> Path:
    """Write what the commands are given."""
    folder.mkdir()
    (folder / "study.toml").write_text(LONG)
    releases = table().select(["speed_mph", "elevation_deg", "azimuth_deg", "player"])
    rows = np.random.Generator(np.random.Philox(2)).integers(0, len(releases), ROWS)
    pyarrow.parquet.write_table(releases.take(rows), folder / "releases.parquet")
    return folder


def prepare(folder: Path) -> Attempt:
    """Run all commands undisturbed."""
    given = write_files(folder / "given")
    run(["--version"], folder)  # the server begins, which takes a while
    wholes = [undisturbed(c, given, folder / str(number)) for number, c in enumerate(COMMANDS)]
    return Kills(given, wholes).attempt


ATTACK = Attack(
    "kills",
    "kills",
    "kills",
    "`estimate --folder`, `map --folder`, `batch` and `study`, ended by SIGKILL at random "
    "moments up to three times and then continued, each time with another number of threads. "
    "The output and every file must be byte for byte those of an undisturbed run.",
    prepare,
)
