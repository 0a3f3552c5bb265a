"""Searches, margins and tables of aims in chunks: killed and gone on with, the same bits."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.helpers.commands import run, succeed

for _library in ("matplotlib", "pyarrow", "pydantic", "scipy", "xarray"):
    pytest.importorskip(_library)

import pyarrow as pa  # noqa: E402

import hoopgen  # noqa: E402
from hoopgen.study.jobs import objective as players  # noqa: E402
from hoopgen.study.jobs.task_runner import run_serially, task_runner  # noqa: E402
from hoopgen.study.questions import aim_table as aims  # noqa: E402
from hoopgen.study.questions.aim_table import aim_table  # noqa: E402
from hoopgen.studyfile import run_study, sweeps  # noqa: E402

PLACE = {"height": 2.1336, "distance": 4.191, "backspin": 6 * np.pi}
SD = {"speed": 0.07, "elevation": np.radians(1.3), "azimuth": np.radians(1)}
PLAYER = hoopgen.Scatter(PLACE, SD)
HIGH = hoopgen.Scatter({**PLACE, "elevation": 0.9}, SD)
AIMED = hoopgen.Scatter({**PLACE, "speed": 7.17, "elevation": 0.9}, SD)


@pytest.fixture(autouse=True)
def small(monkeypatch: pytest.MonkeyPatch) -> None:
    """Chunks so small that little work has many."""
    monkeypatch.setattr(players, "TASK", 1 << 11)
    monkeypatch.setattr(aims, "ROWS", 2)


def best(**options: Any) -> Any:
    return hoopgen.optimum(HIGH, {"aim": (0.0, 0.1)}, shots=4_000, margins=["azimuth"], **options)


def forgiven(**options: Any) -> Any:
    return hoopgen.margins(AIMED, names=["azimuth"], shots=4_000, **options)


def table(**options: Any) -> Any:
    found = aim_table([3.0, 3.5, 4.0, 4.5, 5.0], height=2.1, backspin=19.0, **options)
    return {name: column.tolist() for name, column in found.items() if name != "time"}


WORK: dict[str, Callable[..., Any]] = {"optimum": best, "margins": forgiven, "aim": table}


@pytest.mark.sampled(1)
@pytest.mark.parametrize("work", WORK.values(), ids=WORK)
def test_threads_and_folders_change_no_bit(work: Callable[..., Any], tmp_path: Path) -> None:
    wanted = work(threads=1)
    assert work(threads=3, folder=tmp_path / "kept") == wanted
    assert work(threads=2, folder=tmp_path / "kept") == wanted


@pytest.mark.slow
def test_the_size_of_chunks_changes_no_bit(monkeypatch: pytest.MonkeyPatch) -> None:
    wanted = best(), forgiven(), table()
    monkeypatch.setattr(players, "TASK", 700)
    monkeypatch.setattr(aims, "ROWS", 3)
    assert (best(), forgiven(), table()) == wanted


@pytest.mark.slow
@pytest.mark.parametrize("work", WORK.values(), ids=WORK)
def test_what_was_interrupted_is_gone_on_from(
    work: Callable[..., Any], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    wanted = work(folder=tmp_path / "whole")
    whole = sorted(file.name for file in (tmp_path / "whole").glob("chunk-*"))
    enough = len(whole) // 2

    def stop(done: int, total: int | None) -> None:
        if done == enough:
            raise KeyboardInterrupt

    kept = tmp_path / "kept"
    with pytest.raises(KeyboardInterrupt):
        work(folder=kept, threads=1, progress=stop)
    there = len(list(kept.glob("chunk-*")))
    assert enough <= there < len(whole)
    computed: list[int] = []
    owner, name = (aims._TableJob, "compute") if work is table else (players.Player, "count")
    plain = getattr(owner, name)

    def counted(*arguments: Any) -> pa.Table:
        computed.append(1)
        return plain(*arguments)

    monkeypatch.setattr(owner, name, counted)
    fresh: list[int] = []
    assert work(folder=tmp_path / "whole") == wanted
    few, computed[:] = len(computed), []
    assert work(folder=kept, progress=lambda done, total: fresh.append(done)) == wanted
    # What is on disk is read: of the rest what one alone takes is done here, as before.
    assert len(computed) - few == len(whole) - there
    for name in whole:
        assert (kept / name).read_bytes() == (tmp_path / "whole" / name).read_bytes()
    assert fresh == list(range(len(whole) + 1))


@pytest.mark.parametrize(
    "change",
    [{"seed": 1}, {"by": "direct"}, {"tolerance": 0.02}, {"margins": []}, {"shots": 5_000}],
)
@pytest.mark.slow
def test_a_folder_holds_one_search(change: dict[str, Any], tmp_path: Path) -> None:
    options: dict[str, Any] = {"shots": 4_000, "margins": ["azimuth"], "folder": tmp_path}
    over = {"aim": (0.0, 0.1)}
    hoopgen.optimum(HIGH, over, **options)
    with pytest.raises(ValueError, match="holds another job"):
        hoopgen.optimum(HIGH, over, **options | change)
    # The interval is no part of the work.
    hoopgen.optimum(HIGH, over, **options, confidence=0.9)


def test_what_is_wrong_shows_before_a_folder_is_made(tmp_path: Path) -> None:
    for work in (
        lambda **how: hoopgen.optimum(hoopgen.Scatter({"height": 2.0}, SD), {"aim": (0, 1)}, **how),
        lambda **how: hoopgen.optimum(PLAYER, ["elevation", "aim"], margins=["wind"], **how),
        lambda **how: hoopgen.margins(AIMED, names=["aim"], **how),
        lambda **how: aim_table([3.0], height=2.0, by="luck", **how),  # type: ignore[arg-type]
        lambda **how: aim_table([3.0], height=2.0, parameters={"weight": 9.8}, **how),
    ):
        with pytest.raises(ValueError, match=r"missing|unknown|no variable|by: expected"):
            work(folder=tmp_path / "kept")
        assert not (tmp_path / "kept").exists()


def test_a_crew_answers_in_order_however_often_it_is_asked() -> None:
    def task(number: int) -> Callable[[], pa.Table]:
        return lambda: pa.table({"n": [number]})

    asked = [[task(k) for k in range(many)] for many in (1, 0, 7, 2)]
    with task_runner({}, threads=2) as together:
        found = [together(tasks) for tasks in asked]
    assert found == [run_serially(tasks) for tasks in asked]


def test_an_error_in_a_chunk_is_that_of_the_search(monkeypatch: pytest.MonkeyPatch) -> None:
    def fails(*_: Any) -> pa.Table:
        raise ArithmeticError("here")

    tried = players.Player.sampled
    monkeypatch.setattr(players.Player, "count", fails)
    with pytest.raises(ArithmeticError, match="here"), task_runner({}) as together:
        tried(players.Player(PLAYER, runner=together), {"aim": 0.0, "elevation": 0.9}, 5_000)


# On the command line, and in a study

ASKED = {
    "optimum": [
        *["optimum", "--over", "aim=0cm:10cm", "--elevation", "52deg", "--height", "7ft"],
        *[
            "--distance",
            "13.75ft",
            "--scatter",
            "speed=0.07",
            "--shots",
            "4000",
            "--versus",
            "bank",
        ],
    ],
    "aim": ["aim", "--distance", "3m:5m:0.25m", "--height", "7ft"],
}


@pytest.mark.slow
@pytest.mark.parametrize("asked", ASKED.values(), ids=ASKED)
def test_the_commands_keep_their_chunks(asked: list[str], tmp_path: Path) -> None:
    wanted = succeed(*asked)
    for threads in ("1", "2"):
        kept = [*asked, "--folder", str(tmp_path / "kept"), "--threads", threads]
        assert run(*kept).stdout == wanted.stdout
    assert list((tmp_path / "kept").glob("chunk-*.arrow"))
    refused = run(*asked, "--scheduler", "tcp://127.0.0.1:1", "--threads", "1")
    assert "threads: with a scheduler" in refused.stderr


STUDY = """
[study]
name = "Search"
[release]
height = "7 ft"
elevation = "52 deg"
[scatter]
speed = 0.07
[[question]]
kind = "optimum"
name = "best"
release.distance = "13.75 ft"
over.aim = ["0 cm", "10 cm"]
shots = 4000
margins = []
[[question]]
kind = "aim"
name = "table"
distance = [3, 4]
"""


@pytest.mark.slow
def test_a_study_s_searches_are_told_who_works(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    told: dict[str, Any] = {}
    for name in ("optimum", "aim_table"):
        plain = getattr(sweeps, name)

        def spy(*arguments: Any, _name: str = name, _plain: Any = plain, **options: Any) -> Any:
            if "folder" in options:  # else the question is checked alone
                told[_name] = (options["threads"], options["folder"].name)
            return _plain(*arguments, **options)

        monkeypatch.setattr(sweeps, name, spy)
    (tmp_path / "study.toml").write_text(STUDY)
    found = run_study(tmp_path / "study.toml", tmp_path / "out", threads=2)
    assert told == dict.fromkeys(("optimum", "aim_table"), (2, "chunks"))
    assert not list((tmp_path / "out").rglob("chunk-*"))
    answer = json.loads((tmp_path / "out" / "best" / "answer.json").read_text(encoding="utf-8"))
    assert answer["line"] == found["best"].line
