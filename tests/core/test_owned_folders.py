"""Other people's files: whatever a command writes, every byte of them is there afterwards."""

from __future__ import annotations

import os
import signal
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import pytest

from hoopgen.engine.web_assembly import MODULES
from tests.helpers import ROOT
from tests.helpers.commands import run, succeed
from tests.helpers.killed import run_until_sync

for _library in ("matplotlib", "pyarrow", "pydantic", "scipy", "sympy", "xarray"):
    pytest.importorskip(_library)

from hoopgen.codegen import committed  # noqa: E402
from hoopgen.core.owned_folders import MARKER, find_store, locked_store, open_store  # noqa: E402
from hoopgen.scene import cache, compilers  # noqa: E402
from hoopgen.simulation import compile as compiling  # noqa: E402
from hoopgen.studyfile import run_study  # noqa: E402

THEIRS: Mapping[str, bytes] = {
    name: f"of somebody else: {name}".encode()
    for name in (
        "notes.tmp",
        "identity.json",
        "identity.json.tmp",
        "versions.json",
        "study.toml",
        "report.md",
        "answer.json",
        "question.json",
        "lock",
        "chunk-000000000.arrow",
        "chunk-000000000.arrow.tmp",
        "record.json",
        "hoop.c",
        "q/answer.json",
        "q/question.json",
        "q.unfinished/notes.tmp",
        "chunks/chunk-000000001.arrow",
        "pointers/notes",
        f"{'0' * 64}/notes.tmp",
        f"{'0' * 64}/record.json",
        f".{'1' * 64}.lock",
        "numpy/hoop.py",
        "sub/folder/notes.tmp",
    )
}
"""Files that have the names of hoopgen's own, and are not."""

SEEN = ("--elevation", "52deg", "--aim", "5cm", "--height", "7ft", "--distance", "13.75ft")
SCATTER = ("--scatter", "speed=0.07")
ROWS = "speed_m_s,elevation_deg,height_ft,distance_ft\n7.17,52,7,13.75\n"
STUDY = """
[study]
name = "A study"
formats = ["png"]
seed = 1
[release]
height = "7 ft"
distance = "13.75 ft"
elevation = "52 deg"
aim = "2 in"
[scatter]
speed = "0.063 m/s"
elevation = "1.3 deg"
[[question]]
name = "q"
kind = "estimate"
shots = {shots}
figures = {figures}
"""
SCENE = """
name = "post"
ball_radius = 0.05
gravity = 9.81
restitution = 0.5
[bodies.post]
kind = "cylinder"
radius = 0.1
[ends.down]
at = -1.0
"""


def fill(folder: Path, files: Mapping[str, bytes] = THEIRS) -> None:
    """Put files of somebody else into a folder."""
    for name, content in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_bytes(content)


def contents(folder: Path) -> dict[str, bytes]:
    """Return every file of a folder, by its path there; what is a link as where it leads."""
    return {
        path.relative_to(folder).as_posix(): (
            str(path.readlink()).encode() if path.is_symlink() else path.read_bytes()
        )
        for path in sorted(folder.rglob("*"))
        if path.is_symlink() or path.is_file()
    }


def study(folder: Path, shots: int = 2000, figures: str = '["landings"]') -> Path:
    """Write a study file."""
    folder.mkdir(exist_ok=True)
    file = folder / "study-file.toml"
    file.write_text(STUDY.format(shots=shots, figures=figures), encoding="utf-8")
    return file


@pytest.fixture
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The folder of compiled scenes."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "home"))
    monkeypatch.setenv("LOCALAPPDATA", str(tmp_path / "home"))
    monkeypatch.setenv("CC", "/nowhere/cc")
    for known in (compiling._KEY_BY_IDENTITY, compiling._ENGINES):
        known.clear()
    cache.process_store.cache_clear()
    cache._warn_once.cache_clear()
    folder = tmp_path / "home" / "hoopgen" / "scenes"
    folder.mkdir(parents=True, mode=0o700)
    for each in (folder, *folder.parents[:2]):
        each.chmod(0o700)
    return folder


Command = tuple[tuple[str | Path, ...], Path]
"""Arguments, and the folder that they name, or have hoopgen use."""


def batch(folder: Path) -> Command:
    (folder.parent / "in.csv").write_text(ROWS)
    out = folder.with_name("out.parquet")
    return ("batch", folder.parent / "in.csv", "--out", out), folder.with_name("out.parquet.parts")


def generated(folder: Path) -> Command:
    for name in ("derive", "templates"):
        (folder / name).mkdir(parents=True)
    return ("generate", "--root", folder), folder / "generated"


COMMANDS: Mapping[str, Callable[[Path], Command]] = {
    "estimate": lambda f: (("estimate", *SEEN, *SCATTER, "--shots", "500", "--folder", f), f),
    "map": lambda f: (
        ("map", "--over", "backspin=0:3Hz:2", *SEEN, *SCATTER, "--shots", "100")
        + ("--out", f.with_name("map.csv"), "--folder", f),
        f,
    ),
    "optimum": lambda f: (
        ("optimum", "--over", "elevation=50deg:54deg", *SEEN[2:], *SCATTER, "--shots", "100")
        + ("--folder", f),
        f,
    ),
    "aim": lambda f: (
        ("aim", "--entry", "45deg", "--height", "7ft", "--distance", "3:4:1", "--folder", f),
        f,
    ),
    "study": lambda f: (("study", study(f.parent), "--out", f), f),
    "batch": batch,
    "generate": generated,
}


@pytest.mark.parametrize("name", COMMANDS)
def test_a_folder_of_somebody_else_is_refused_and_every_byte_stays(
    name: str, tmp_path: Path
) -> None:
    arguments, folder = COMMANDS[name](tmp_path / "folder")
    folder.mkdir(parents=True)
    fill(folder)
    result = run(*arguments)
    assert result.exit_code == 2, result.output
    (line,) = result.stderr.splitlines()
    assert f"{folder} holds files that hoopgen did not make: " in line
    assert line.endswith("give another folder, one that is empty or does not exist")
    assert "delete" not in line
    assert contents(folder) == THEIRS


@pytest.mark.sampled(1)
@pytest.mark.parametrize("name", [name for name in COMMANDS if name != "generate"])
def test_files_that_somebody_else_adds_later_stay(name: str, tmp_path: Path) -> None:
    """These files have names that the folder's marker does not list."""
    arguments, folder = COMMANDS[name](tmp_path / "folder")
    if name in ("batch", "optimum"):  # whose folder is gone when it is over, or never made
        open_store(folder, "finished chunks")
    else:
        succeed(*arguments)
    own = contents(folder).keys()
    theirs = {name: content for name, content in THEIRS.items() if name not in own}
    theirs = {name: c for name, c in theirs.items() if "q" not in name and "chunk-" not in name}
    if name != "study":
        theirs.pop("identity.json", None)
    fill(folder, theirs)
    succeed(*arguments)
    assert theirs.items() <= contents(folder).items()
    assert (folder / MARKER).is_file()


@pytest.mark.slow
def test_compiling_and_clearing_leave_a_folder_of_somebody_else(home: Path, tmp_path: Path) -> None:
    (tmp_path / "post.toml").write_text(SCENE)
    fill(home)
    result = run("compile", tmp_path / "post.toml")
    assert result.exit_code == 1, result.output  # without a compiler
    why = f"{home} holds files that hoopgen did not make: "
    assert result.stderr.startswith(f"hoopgen: {why}")
    assert result.stderr.splitlines()[0].endswith("scenes are compiled for this process alone.")
    result = run("cache", "--clear")
    assert result.exit_code == 2, result.output
    assert why in result.stderr
    assert contents(home) == THEIRS


@pytest.mark.slow
def test_clearing_removes_scenes_and_leaves_what_somebody_else_put_among_them(
    home: Path, tmp_path: Path
) -> None:
    (tmp_path / "post.toml").write_text(SCENE)
    assert run("compile", tmp_path / "post.toml").exit_code == 1
    (key,) = cache.Cache(home).keys()
    theirs = {name: content for name, content in THEIRS.items() if not name.startswith(".")}
    del theirs[f"{'0' * 64}/record.json"]  # which is a damaged scene
    theirs |= {f"{key}/notes.tmp": b"theirs", ".build-notes/file": b"theirs"}
    fill(home, theirs)
    succeed("cache", "--clear")
    assert {**theirs, MARKER: (home / MARKER).read_bytes()} == contents(home)


@pytest.mark.skipif(os.name != "posix", reason="links need rights elsewhere")
def test_clearing_follows_no_link(home: Path, tmp_path: Path) -> None:
    assert isinstance(cache.user_store(), cache.Cache)
    elsewhere = tmp_path / "elsewhere"
    fill(elsewhere, {"record.json": b"theirs", "module": b"theirs", "abc": b"theirs"})
    for name in ("a" * 64, "pointers", f".build-{'a' * 64}-x"):
        (home / name).symlink_to(elsewhere)
    assert run("cache", "--clear").exit_code == 0
    assert contents(elsewhere) == dict.fromkeys(("record.json", "module", "abc"), b"theirs")


# ---------------------------------------------------------------------- a question is asked anew


@pytest.mark.slow
def test_a_question_that_is_asked_for_more_leaves_other_files_beside_the_answer(
    tmp_path: Path,
) -> None:
    results = tmp_path / "results"
    run_study(study(tmp_path, 1000), results)
    theirs = {"q/notes.tmp": b"mine", "q/chart.png": b"mine", "q/sub/answer.json": b"mine"}
    theirs |= {"notes.txt": b"mine", "chunks/notes": b"mine", "q/chunks/notes": b"mine"}
    fill(results, theirs)
    before = contents(results)
    run_study(study(tmp_path, 2000), results)
    after = contents(results)
    assert theirs.items() <= after.items()
    assert before["q/answer.json"] != after["q/answer.json"]
    assert not (results / "q.unfinished").exists()


@pytest.mark.slow
def test_a_file_of_somebody_else_is_not_replaced_by_a_figure(tmp_path: Path) -> None:
    """The answer to fewer shots had no such figure: the old answer stays, with that file."""
    results = tmp_path / "results"
    run_study(study(tmp_path, 1), results)
    assert not (results / "q" / "landings.png").exists()  # the shot was made
    fill(results / "q", {"landings.png": b"mine"})
    before = contents(results / "q")
    for _ in range(2):
        with pytest.raises((FileExistsError, ExceptionGroup)) as raised:
            run_study(study(tmp_path, 1000), results)
        (error,) = getattr(raised.value, "exceptions", [raised.value])
        assert isinstance(error, FileExistsError)
        assert error.strerror.startswith("hoopgen did not make this file; move it away")
        assert error.filename == str(results / "q" / "landings.png")
        after = contents(results / "q")
        assert {name: after[name] for name in before if "chunks/" not in name} == {
            name: content for name, content in before.items() if "chunks/" not in name
        }
    (results / "q" / "landings.png").unlink()
    run_study(study(tmp_path, 1000), results)
    run_study(study(tmp_path, 1000), tmp_path / "whole")
    assert contents(results / "q") == contents(tmp_path / "whole" / "q")


@pytest.mark.skipif(os.name != "posix", reason="signals are POSIX's")
@pytest.mark.slow
def test_an_old_answer_stays_until_the_new_one_is_there_whenever_it_is_killed(
    tmp_path: Path,
) -> None:
    file, results = study(tmp_path, 1000), tmp_path / "results"
    run_study(file, results)
    old = contents(results / "q")
    study(tmp_path, 2000)
    run_study(file, tmp_path / "whole")
    new = contents(tmp_path / "whole" / "q")
    for sync in range(4, 60, 4):
        ended = run_until_sync(file, results, sync)
        there = contents(results / "q")
        assert there["answer.json"] in (old["answer.json"], new["answer.json"])
        if ended.returncode == 0:
            break
        assert ended.returncode == -signal.SIGKILL, ended.stderr
        if not (results / "q.unfinished" / "answer.json").exists():  # else it is being moved
            whole = new if there["answer.json"] == new["answer.json"] else old
            for name in ("question.json", "landings.png"):
                assert there[name] == whole[name]
    run_study(file, results)
    assert contents(results / "q") == new
    assert not (results / "q.unfinished").exists()


# --------------------------------------------------------------------------------- the one rule


def test_a_folder_is_made_or_used_if_it_is_empty_or_has_the_marker(tmp_path: Path) -> None:
    (tmp_path / "empty").mkdir()
    for folder in (tmp_path / "new", tmp_path / "empty"):
        assert find_store(folder, "a purpose") is None
        made = open_store(folder, "a purpose", ["a", "b-*.txt"])
        assert find_store(folder, "a purpose") == made == open_store(folder, "a purpose", ["a"])
        made.dissolve()
        assert not folder.exists()


@pytest.mark.parametrize(
    ("marker", "said"),
    [
        (b"", "cannot be read"),
        (b"[1]", "cannot be read"),
        (b"\xff", "cannot be read"),
        (b"[" * 100_000, "cannot be read"),
        (b'{"hoopgen": "a purpose"}', "cannot be read"),
        (b'{"hoopgen": "a purpose", "format": 1, "files": ["../notes"]}', "cannot be read"),
        (b'{"hoopgen": "a purpose", "format": 1, "files": ["/notes"]}', "cannot be read"),
        (b'{"hoopgen": "a purpose", "format": 1, "files": [5]}', "cannot be read"),
        (b'{"hoopgen": "a purpose", "format": 2, "files": []}', "another version of hoopgen"),
        (b'{"hoopgen": "a study", "format": 1, "files": []}', "for a study, not for a purpose"),
    ],
)
def test_a_marker_that_says_something_else_is_refused(
    marker: bytes, said: str, tmp_path: Path
) -> None:
    (tmp_path / MARKER).write_bytes(marker)
    (tmp_path / "a").write_bytes(b"theirs")
    with pytest.raises(ValueError, match=said) as raised, locked_store(tmp_path, "a purpose"):
        pass
    assert "give another folder" in str(raised.value)
    assert contents(tmp_path) == {MARKER: marker, "a": b"theirs"}


def test_a_folder_of_an_older_hoopgen_is_refused_in_words(tmp_path: Path) -> None:
    fill(tmp_path, {"identity.json": b"{}", "chunk-000000000.arrow": b""})
    with pytest.raises(ValueError, match=r"folders of hoopgen 0\.2\.0 have no hoopgen\.json"):
        find_store(tmp_path, "finished chunks")


def test_only_what_the_marker_names_is_replaced_or_removed(tmp_path: Path) -> None:
    made = open_store(tmp_path / "own", "a purpose", ["a", "c/a", "b-[0-9].txt"])
    theirs = {"notes": b"1", "b-x.txt": b"1", "c/b": b"1", "d/a": b"1", "notes.tmp": b"1"}
    fill(made.path, theirs)
    for name in ("a", "c/a"):
        made.write(name, "ours")
    (made.path / "b-1.txt").write_bytes(b"ours")
    with pytest.raises(FileExistsError, match="hoopgen did not make this file"):
        made.write("notes", "ours")
    made.remove(["notes", "b-x.txt", "c/b", "d", "a"])
    assert "a" not in contents(made.path)
    with locked_store(made.path, "a purpose") as again:
        again.dissolve()
    assert contents(made.path).keys() == theirs.keys() | {MARKER}
    assert theirs.items() <= contents(made.path).items()


@pytest.mark.skipif(os.name != "posix", reason="links need rights elsewhere")
def test_no_link_is_followed(tmp_path: Path) -> None:
    fill(tmp_path / "elsewhere", {"a": b"theirs", "b": b"theirs"})
    made = open_store(tmp_path / "own", "a purpose", ["a", "b", "c/a"])
    (made.path / "a").symlink_to(tmp_path / "elsewhere" / "a")
    (made.path / "b").symlink_to(tmp_path / "elsewhere" / "b")
    (made.path / "c").symlink_to(tmp_path / "elsewhere")
    with pytest.raises(FileExistsError, match="this is a link"):
        made.write("c/a", "ours")
    made.write("b", "ours")
    made.dissolve()
    assert contents(tmp_path / "elsewhere") == {"a": b"theirs", "b": b"theirs"}
    assert not os.path.lexists(made.path / "a")


def test_what_is_not_whole_goes_with_the_next_start(tmp_path: Path) -> None:
    with locked_store(tmp_path / "own", "a purpose", ["a"]) as made:
        made.write("a", "whole")
    half = made.temporary()
    half.write_bytes(b"half")
    fill(made.path, {"notes.tmp": b"1", ".notes.tmp": b"1"})
    with locked_store(made.path, "a purpose"):
        assert not half.exists()
    assert contents(made.path).keys() == {MARKER, "a", "notes.tmp", ".notes.tmp"}


def test_a_write_that_fails_leaves_what_was_there(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    made = open_store(tmp_path, "a purpose")
    made.write("a", "old")

    def full(*_: Any) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(OSError, match="No space left"):
        made.write("a", "new")
    assert contents(tmp_path)["a"] == b"old"
    assert contents(tmp_path).keys() == {"a", MARKER}


def test_the_marker_of_generated_files_is_one_of_them() -> None:
    root = ROOT / "generated"
    found = find_store(root, committed.PURPOSE)
    assert found is not None
    own = {path.relative_to(root).as_posix() for path in root.rglob("*") if path.is_file()}
    own = {name for name in own if "__pycache__" not in name} - {MARKER, *committed.KEPT}
    own -= {f"wasm/{name}" for name in MODULES}  # compiled of others, with a check of their own
    assert {name for name in found.files if "*" not in name} == own
    assert compilers.library_name() in cache.LIBRARIES
