"""Files are there wholly or not at all, and what cannot be written is told before the work."""

from __future__ import annotations

import errno
import io
import os
import re
import signal
import stat
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import hoopgen
from hoopgen.core.files import atomic_file, atomic_text_file, check_folder, check_output, write
from tests.helpers.commands import run, succeed

POSIX = pytest.mark.skipif(os.name == "nt", reason="permissions, links and pipes as of POSIX")

BEFORE = b"what was there before\n" * 100

PLACE = ["--distance", "13.75ft", "--height", "7ft"]
SHOT = ["shot", "--speed", "7.17", "--elevation", "51deg", *PLACE]
BANK = ["bank", "--distance", "4m", "--height", "7ft", "--scatter", "speed=0.07"]
MAP = ["map", "--over", "elevation=50deg:53deg:3", "--over", "speed=7:7.4:3", *PLACE]
AIM = ["aim", "--distance", "4m,5m", "--height", "7ft"]


# One file


def test_a_file_is_whole_or_as_it_was(tmp_path: Path) -> None:
    file = tmp_path / "file.csv"
    assert write(file, BEFORE) == file
    with pytest.raises(ZeroDivisionError), atomic_file(file) as out:  # noqa: PT012
        out.write(b"half")
        out.flush()
        raise ZeroDivisionError
    assert file.read_bytes() == BEFORE
    with atomic_text_file(file) as text:
        text.write("é\r\nall\n")
    assert file.read_bytes() == "é\r\nall\n".encode()
    assert [path.name for path in tmp_path.iterdir()] == ["file.csv"]


KILLED = """
import os, signal, sys
from hoopgen.core.files import atomic_file
with atomic_file(sys.argv[1]) as out:
    out.write(b"half")
    out.flush()
    os.kill(os.getpid(), signal.SIGKILL)
"""


@POSIX
def test_a_file_is_as_it_was_after_a_kill(tmp_path: Path) -> None:
    file = tmp_path / "file.csv"
    file.write_bytes(BEFORE)
    killed = subprocess.run([sys.executable, "-c", KILLED, str(file)], check=False)
    assert killed.returncode == -signal.SIGKILL
    assert file.read_bytes() == BEFORE


@POSIX
@pytest.mark.parametrize("mask", [0o022, 0o077])
def test_permissions_are_those_of_a_plain_open(mask: int, tmp_path: Path) -> None:
    plain, new, there = (tmp_path / name for name in ("plain", "new", "there"))
    before = os.umask(mask)
    try:
        plain.write_bytes(b"")
        write(new, b"")
        there.write_bytes(b"")
        there.chmod(0o640)
        write(there, b"more")
    finally:
        os.umask(before)
    assert stat.S_IMODE(new.stat().st_mode) == stat.S_IMODE(plain.stat().st_mode) == 0o666 & ~mask
    assert stat.S_IMODE(there.stat().st_mode) == 0o640
    assert there.read_bytes() == b"more"


@POSIX
def test_a_link_stays_and_its_file_is_written(tmp_path: Path) -> None:
    (tmp_path / "far").mkdir()
    link, file = tmp_path / "link.csv", tmp_path / "far" / "file.csv"
    link.symlink_to(file)
    for content in (b"made", b"made anew"):
        write(link, content)
        assert link.is_symlink()
        assert file.read_bytes() == content
    assert [path.name for path in file.parent.iterdir()] == ["file.csv"]


@POSIX
def test_what_has_a_name_until_it_is_whole_takes_the_place_of_links_and_pipes(
    tmp_path: Path,
) -> None:
    link, pipe, part = (tmp_path / name for name in ("link", "pipe", "part.tmp"))
    link.symlink_to(tmp_path / "far")
    os.mkfifo(pipe)
    for place in (link, pipe):
        with atomic_file(place, part) as out:
            out.write(BEFORE)
        assert not place.is_symlink()
        assert place.read_bytes() == BEFORE
    assert {path.name for path in tmp_path.iterdir()} == {"link", "pipe"}


@POSIX
def test_a_pipe_is_written_as_it_is(tmp_path: Path) -> None:
    pipe = tmp_path / "pipe.csv"
    os.mkfifo(pipe)
    with subprocess.Popen(["cat", str(pipe)], stdout=subprocess.PIPE) as reader:
        try:
            succeed(*MAP, "--out", str(pipe))
            read, _ = reader.communicate(timeout=60)
        finally:
            reader.kill()
    assert read.startswith(b"elevation_rad,speed_m_s,")
    assert stat.S_ISFIFO(pipe.stat().st_mode)


@POSIX
@pytest.mark.parametrize("piped", [True, False])
@pytest.mark.slow
def test_stdout_is_written_as_it_is(piped: bool, tmp_path: Path) -> None:
    command = [sys.executable, "-m", "hoopgen", *AIM, "--csv", "/dev/stdout"]
    if piped:
        said = subprocess.run(command, check=True, capture_output=True).stdout
        assert b"\ndistance_m,angle_deg," in said
        return
    file = tmp_path / "stdout"
    with file.open("wb") as out:
        subprocess.run(command, check=True, stdout=out)
        assert os.path.samestat(os.fstat(out.fileno()), file.stat())
    assert file.read_bytes().startswith(b"distance_m,angle_deg,")


# A full disk


class Full(io.FileIO):
    """A file on a disk that is full after some bytes, of which the first ones are written."""

    left = 200

    def write(self, data: Any, /) -> int:
        part = bytes(data)[: self.left]
        if not part:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        self.left -= len(part)
        return super().write(part)


def fill_the_disk(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let every file that is opened to be written meet the end of the disk."""
    plain = Path.open

    def opened(path: Path, mode: str = "r", *arguments: Any, **options: Any) -> Any:
        if mode == "wb":
            return io.BufferedWriter(Full(path, mode))
        return plain(path, mode, *arguments, **options)

    monkeypatch.setattr(Path, "open", opened)


def _missed() -> Any:
    return hoopgen.simulate(hoopgen.release(7.3, 0.9, height=2.1, distance=4.2), record=True)


def _picture(file: Path) -> None:
    plots = pytest.importorskip("hoopgen.plots")
    plots.save(plots.plot_trajectory(_missed().trajectory(0), hoopgen.PAPER), file)


def _page(file: Path) -> None:
    viewer = pytest.importorskip("hoopgen.viewer")
    viewer.view(_missed(), hoopgen.PAPER, file)


def _table(file: Path) -> None:
    aim = pytest.importorskip("hoopgen.study.questions.aim_table")
    aim.write_csv(file, {"distance": np.arange(100.0)})


def _command(*arguments: str) -> Callable[[Path], None]:
    def ran(file: Path) -> None:
        pytest.importorskip("xarray")
        result = run(*arguments, str(file))
        assert result.exit_code == 2
        assert result.stderr.splitlines()[-1] == (
            f"hoopgen: error: {file}: {os.strerror(errno.ENOSPC)}"
        )
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), str(file))

    return ran


WRITERS: dict[str, Callable[[Path], None]] = {
    "picture.svg": _picture,
    "picture.png": _picture,
    "picture.pdf": _picture,
    "page.html": _page,
    "table.csv": _table,
    "map.nc": _command(*MAP, "--out"),
    "map.csv": _command(*MAP, "--out"),
    "shot.svg": _command(*SHOT, "--picture"),
    "shot.html": _command(*SHOT, "--view"),
    "aim.csv": _command(*AIM, "--csv"),
}


@pytest.mark.sampled(3)
@pytest.mark.parametrize("name", WRITERS)
def test_a_full_disk_costs_nothing_that_was_there(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file = tmp_path / name
    file.write_bytes(BEFORE)
    fill_the_disk(monkeypatch)
    with pytest.raises(OSError, match=re.escape(os.strerror(errno.ENOSPC))) as raised:
        WRITERS[name](file)
    assert raised.value.filename == str(file)
    assert file.read_bytes() == BEFORE
    assert [path.name for path in tmp_path.iterdir()] == [name]


LIMITED = """
import resource, sys
from hoopgen.cli import main
resource.setrlimit(resource.RLIMIT_FSIZE, (1500, 1500))
main(sys.argv[1:])
"""


@pytest.mark.slow
@POSIX
@pytest.mark.parametrize(
    "arguments",
    [
        [*SHOT, "--view"],
        pytest.param([*SHOT, "--picture"], marks=pytest.mark.slow),
        pytest.param([*MAP, "--out"], marks=pytest.mark.slow),
    ],
)
def test_a_write_that_the_system_refuses_is_one_line(arguments: list[str], tmp_path: Path) -> None:
    pytest.importorskip("xarray")
    pytest.importorskip("matplotlib.font_manager")  # whose cache is a file
    suffix = {"--view": ".html", "--picture": ".svg", "--out": ".nc"}[arguments[-1]]
    file = tmp_path / f"file{suffix}"
    file.write_bytes(BEFORE)
    command = [sys.executable, "-c", LIMITED, *arguments, str(file)]
    done = subprocess.run(command, check=False, capture_output=True, text=True)
    assert done.returncode == 2
    assert done.stderr == f"hoopgen: error: {file}: {os.strerror(errno.EFBIG)}\n"
    assert file.read_bytes() == BEFORE
    assert [path.name for path in tmp_path.iterdir()] == [file.name]


# Before the work


@pytest.fixture
def idle(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let nothing be worked on."""

    def worked(*_: Any, **__: Any) -> None:
        raise AssertionError("work has begun")

    for name in ("simulate", "map", "batch"):
        monkeypatch.setattr(hoopgen, name, worked, raising=False)
    monkeypatch.setattr("hoopgen.study.questions.aim_table.aim_table", worked)
    monkeypatch.setattr("hoopgen.study.questions.bank.bank_or_direct", worked)
    monkeypatch.setattr("hoopgen.simulation.article.run", worked)
    monkeypatch.setattr("hoopgen.viewer.row_sample.sample", worked)


COMMANDS: dict[str, tuple[list[str], str]] = {
    "--picture of a shot": ([*SHOT, "--picture"], ".svg"),
    "--view": ([*SHOT, "--view"], ".html"),
    "a film of a shot": ([*SHOT, "--picture"], ".gif"),
    "--picture of an aim": ([*AIM, "--picture"], ".svg"),
    "--picture of a map": ([*MAP, "--picture"], ".png"),
    "--picture of bank shots": ([*BANK, "--picture"], ".pdf"),
    "map --out": ([*MAP, "--out"], ".nc"),
    "aim --csv": ([*AIM, "--csv"], ".csv"),
    "batch --out": (["batch", __file__, "--out"], ".parquet"),
    "view --out": (["view", __file__, "--out"], ".html"),
}


@pytest.mark.parametrize("command", COMMANDS)
@pytest.mark.parametrize("wrong", ["no folder", "a folder", "in a file"])
def test_a_place_that_cannot_be_written_is_told_before_the_work(
    command: str, wrong: str, tmp_path: Path, idle: None
) -> None:
    for needed in ("xarray", "pyarrow", "matplotlib"):
        pytest.importorskip(needed)
    arguments, suffix = COMMANDS[command]
    folder, file = tmp_path / "none", tmp_path / "file"
    file.write_bytes(BEFORE)
    path = {"no folder": folder, "a folder": tmp_path, "in a file": file}[wrong] / f"out{suffix}"
    if wrong == "a folder":
        path.mkdir()
    result = run(*arguments, str(path))
    assert result.exit_code == 2, result.output
    said = {"no folder": str(folder), "a folder": "is a directory", "in a file": str(file)}[wrong]
    assert said in result.stderr
    assert result.stderr.count("\n") == 1
    assert not folder.exists()


@pytest.mark.parametrize("command", ["--picture of a shot", "--view", "map --out", "view --out"])
def test_so_is_a_suffix_that_nobody_writes(command: str, tmp_path: Path, idle: None) -> None:
    pytest.importorskip("xarray")
    arguments, _ = COMMANDS[command]
    result = run(*arguments, str(tmp_path / "out.txt"))
    assert result.exit_code == 2
    assert "'out.txt' ends in none of ." in result.stderr


def test_so_is_a_folder_of_pictures_below_a_file(tmp_path: Path, idle: None) -> None:
    pytest.importorskip("matplotlib")
    file = tmp_path / "file"
    file.write_bytes(BEFORE)
    result = run("paper", "--out", str(file / "figures"))
    assert result.exit_code == 2
    assert f"{file}: {os.strerror(errno.ENOTDIR)}" in result.stderr


@POSIX
def test_what_may_not_be_written_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    file, folder = tmp_path / "file.csv", tmp_path / "folder"
    file.write_bytes(BEFORE)
    folder.mkdir()
    file.chmod(0o444)
    folder.chmod(0o555)

    def access(path: Any, mode: int) -> bool:
        """Judge by the owner's permissions, which root is above."""
        return bool(Path(path).stat().st_mode >> 6 & mode == mode)

    monkeypatch.setattr(os, "access", access)
    said = re.escape(os.strerror(errno.EACCES))
    for check, path, named in (
        (check_output, file, file),
        (check_output, folder / "new.csv", folder),
        (check_folder, folder, folder),
        (check_folder, folder / "new" / "newer", folder),
    ):
        with pytest.raises(PermissionError, match=said) as raised:
            check(path)
        assert raised.value.filename == str(named)
    folder.chmod(0o755)
    assert check_output(folder / "new.csv") == folder / "new.csv"
    assert check_folder(folder / "new" / "newer") == folder / "new" / "newer"


@POSIX
def test_a_batch_writes_the_file_that_a_link_leads_to(tmp_path: Path) -> None:
    pytest.importorskip("pyarrow")
    (tmp_path / "far").mkdir()
    link, file = tmp_path / "link.parquet", tmp_path / "far" / "file.parquet"
    link.symlink_to(file)
    table = tmp_path / "throws.csv"
    table.write_text("speed,elevation_rad\n7.2,0.9\n")
    hoopgen.batch(table, link, release={"height": 2.1, "distance": 4.2})
    assert link.is_symlink()
    assert file.read_bytes().startswith(b"PAR1")
    assert [path.name for path in file.parent.iterdir()] == ["file.parquet"]
