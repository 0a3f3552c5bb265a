"""The shots of reaching.py reach the lines of the generated engines, but for those that say why."""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
from typing import Any

import pytest

from tests.helpers import ROOT

pytest.importorskip("coverage")

pytestmark = pytest.mark.slow

NO_MEMORY = {"return 0;": "there is no memory for the job, or a thread's copy of it"}
"""Lines of C that no test reaches, and why."""


def missing(scene: str, target: str) -> list[str]:
    """Return the lines that are not reached, counted in a process that imports the engine anew."""
    command = [sys.executable, "-m", "tests.helpers.line_counts", scene, target]
    ran = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert ran.returncode == 0, ran.stderr
    found: dict[str, Any] = json.loads(ran.stdout.splitlines()[-1])
    assert found["lines"] > {"numpy": 2000, "c": 3000}[target]
    return list(found["missing"])


def test_every_line_of_the_hoop_s_numpy_is_reached() -> None:
    assert missing("hoop", "numpy") == []


@pytest.mark.skipif(
    not (shutil.which("gcc") and shutil.which("gcov")), reason="no gcc that counts lines"
)
@pytest.mark.parametrize("scene", ["hoop", "court"])
def test_every_line_of_c_is_reached_but_for_what_needs_no_memory(scene: str) -> None:
    assert [m for m in missing(scene, "c") if m.partition(": ")[2] not in NO_MEMORY] == []
