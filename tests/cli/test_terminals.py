"""Terminals that do not have every sign: a question mark for it, and no command fails."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from hoopgen.cli import _COMMANDS, main
from tests.helpers.commands import output

for _library in ("flint", "matplotlib", "pyarrow", "pydantic", "scipy", "sympy", "xarray"):
    pytest.importorskip(_library)

STUDY = """
[study]
name = "Würfe × ≥"
[release]
aim = "5 cm"
elevation = "52 deg"
height = "7 ft"
distance = "13.75 ft"
[scatter]
speed = 0.07
[[question]]
kind = "estimate"
name = "probability"
title = "Ω"
shots = 1000
"""

EVERY = """
import sys
from hoopgen.cli import main

place = "--height 7ft --distance 13.75ft".split()
throw = ["--speed", "7.2", "--elevation", "51deg", *place]
player = ["--elevation", "52deg", *place, "--scatter", "speed=0.07", "--shots", "500"]
table = ["table.csv", "--release", "height=7ft", "--release", "distance=4m"]
commands = [
    (0, ["--help"]),
    *((0, [name, "--help"]) for name in main.commands),
    (0, ["paper"]),
    (0, ["shot", *throw]),
    (2, ["shot", "--speed", "7\\u2265"]),
    (0, ["certify", *throw]),
    (0, ["estimate", "--aim", "5cm", *player]),
    (0, ["map", "--over", "elevation=45deg:60deg:3", "--over", "speed=7:7.5:3", *place]),
    (0, ["optimum", "--over", "aim", "--seed", "3", *player]),
    (0, ["aim", *place, "--entry", "45deg"]),
    (2, ["aim", *place, "--entry=-60deg"]),
    (0, ["batch", *table, "--out", "results.parquet"]),
    (0, ["view", *table, "--out", "page.html"]),
    (0, ["study", "study.toml"]),
    (0, ["study", "--reference"]),
]
for wanted, command in commands:
    try:
        main(command)
    except SystemExit as end:
        if end.code != wanted:
            sys.exit(f"{command}: {end.code}")
"""


@pytest.mark.parametrize(
    "environment",
    [
        {"PYTHONIOENCODING": "cp437"},
        {"PYTHONIOENCODING": "latin-1"},
        {"LC_ALL": "C", "PYTHONCOERCECLOCALE": "0", "PYTHONUTF8": "0"},
    ],
    ids=["cp437", "latin-1", "C"],
)
@pytest.mark.slow
def test_no_command_fails_for_a_sign_that_the_terminal_has_not(
    environment: dict[str, str], tmp_path: Path
) -> None:
    (tmp_path / "study.toml").write_text(STUDY, encoding="utf-8")
    rows = "7.1,52,Ω\n7.2,51,≥\n"
    (tmp_path / "table.csv").write_text(f"speed,elevation_deg,note\n{rows}", encoding="utf-8")
    ran = subprocess.run(
        [sys.executable, "-c", EVERY],
        env={**os.environ, **environment},
        cwd=tmp_path,
        capture_output=True,
        check=False,
    )
    assert ran.returncode == 0, ran.stderr.decode("ascii", "replace")
    assert b"codec" not in ran.stderr


def test_the_tour_shows_all_of_every_summary_in_eighty_columns(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setenv("COLUMNS", "80")
    text = output("--help")
    for name in _COMMANDS:
        summary = main.commands[name].short_help or ""
        assert 0 < len(summary) <= 60, name
        assert any(line.split() == [name, *summary.split()] for line in text.splitlines()), name
