"""Commands that read a file of results read their options in the scene that the file says."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.helpers.commands import failure, run, succeed

pytest.importorskip("pyarrow")
pytest.importorskip("scipy")

RELEASES = "speed,elevation_deg,height,distance\n" + "".join(
    f"{7.1 + 0.01 * k:.2f},{51 + k % 3},2.1,4.2\n" for k in range(12)
)


@pytest.fixture
def results(tmp_path: Path) -> Path:
    """Return results of releases in COURT."""
    table, file = tmp_path / "releases.csv", tmp_path / "results.csv"
    table.write_text(RELEASES, encoding="utf-8")
    words = ("--scene", "court", "--preset", "nba", "--set", "ring_restitution=0.6")
    succeed("batch", table, "--out", file, *words)
    return file


CHANGED = ("--set", "ring_restitution=0.5", "--override")


@pytest.mark.parametrize("first", [False, True])
def test_options_name_the_parameters_of_the_files_scene(
    results: Path, tmp_path: Path, first: bool
) -> None:
    """Also where they stand before the file."""
    shots = ("--shots", 200)
    for words in (("estimate", "--from", results, *shots), ("coach", "--from", results, *shots)):
        command, *rest = words
        ordered = (command, *CHANGED, *rest) if first else (*words, *CHANGED)
        assert "court, NBA, ring_restitution 0.5" in succeed(*ordered).output
    out = ("--out", tmp_path / "changed.csv")
    ordered = ("batch", *CHANGED, results, *out) if first else ("batch", results, *out, *CHANGED)
    assert "ring_restitution 0.5" in succeed(*ordered).output
    said = failure("estimate", "--from", results, "--set", "restitution=0.5", "--override")
    assert "'restitution' is none of ball_radius, " in said
    assert "ring_restitution" in said


def test_a_scene_that_is_replaced_is_said(results: Path) -> None:
    words = ("--from", results, "--scene", "hoop", "--override", "--shots", 200)
    for command in ("estimate", "coach"):
        said = run(command, *words)
        assert said.exit_code == 0
        assert "results.csv is of another scene, which --override replaces: PAPER" in said.stderr
