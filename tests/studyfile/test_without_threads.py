"""A study where no thread can be started, as in a browser: the same answers and files."""

from __future__ import annotations

import threading
from pathlib import Path

import pytest

pytest.importorskip("matplotlib")
pytest.importorskip("pyarrow")
pytest.importorskip("pydantic")
pytest.importorskip("scipy")
pytest.importorskip("xarray")

from hoopgen.engine import thread_pools
from hoopgen.studyfile import run_study
from tests.helpers.effort import trials

STUDY = """\
[study]
name = "Free throws"
seed = 5
formats = ["png"]

[release]
height = "7 ft"
distance = "13.75 ft"
elevation = "52 deg"
aim = "2 in"
backspin = "3 Hz"

[scatter]
speed = "0.07 m/s"
elevation = "1.3 deg"

[[question]]
name = "made"
kind = "estimate"
shots = {shots}

[[question]]
name = "angles"
kind = "map"
over.elevation = {{ from = "48 deg", to = "56 deg", count = 3 }}
shots = 500
"""


def results(folder: Path) -> dict[str, bytes]:
    """Return the answers and tables of a study, by the files that it wrote."""
    folder.mkdir()
    file = folder / "study.toml"
    file.write_text(STUDY.format(shots=trials(50_000)), encoding="utf-8")
    run_study(file, folder / "out", threads=2)
    written = sorted((folder / "out").glob("*/*"))
    return {
        path.relative_to(folder).as_posix(): path.read_bytes()
        for path in written
        if path.suffix in (".csv", ".json", ".parquet")
    }


@pytest.mark.slow
def test_a_study_runs_where_no_thread_can_be_started(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    wanted = results(tmp_path / "with")
    assert {Path(name).parent.name for name in wanted} == {"made", "angles"}

    def refuse(self: threading.Thread) -> None:
        raise RuntimeError("can't start new thread")

    monkeypatch.setattr(thread_pools, "_IDLE", {})
    monkeypatch.setattr(threading.Thread, "start", refuse)
    assert isinstance(thread_pools.acquire_pool(2), thread_pools.SerialExecutor)
    assert results(tmp_path / "without") == wanted
