"""The examples do what their comments say, and give hoopgen's results."""

from __future__ import annotations

import os
import re
import shlex
import subprocess
from pathlib import Path

import numpy as np
import pytest

import hoopgen
from hoopgen import PAPER
from tests.helpers import ROOT
from tests.helpers.compiled import needs_compiler

SOURCE = ROOT / "examples" / "shots.c"
COMPILE = "cc -O2 -ffp-contract=off -Igenerated/c examples/shots.c generated/c/hoop.c -lm"

pytestmark = [pytest.mark.slow, needs_compiler, pytest.mark.xdist_group("examples")]


def numbers(initializer: str) -> np.ndarray:
    """Return the numbers between the braces of an initializer of the example."""
    (found,) = re.findall(
        rf"{re.escape(initializer)}[^=]* = {{([^;]*)}};", SOURCE.read_text("utf-8")
    )
    return np.array([float(n) for n in re.findall(r"[-+.\deE]+", found)])


@pytest.fixture(scope="module")
def lines(tmp_path_factory: pytest.TempPathFactory) -> list[list[str]]:
    """Return the example's output, compiled as its head says; CC may name another compiler."""
    head = SOURCE.read_text(encoding="utf-8").partition("*/")[0]
    assert COMPILE in head
    program: Path = tmp_path_factory.mktemp("examples") / "shots"
    _, *flags = shlex.split(COMPILE)
    compiler = shlex.split(os.environ.get("CC", "cc"))
    built = subprocess.run(
        [*compiler, *flags, "-o", str(program)],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
        timeout=300,
    )
    assert built.returncode == 0, built.stderr
    run = subprocess.run([program], capture_output=True, text=True, check=True, timeout=60)
    return [line.split() for line in run.stdout.splitlines()]


def test_the_example_s_hoop_is_that_of_the_article() -> None:
    assert numbers("double hoop").tolist() == list(PAPER.values())


@pytest.mark.parametrize("backend", ["numpy", "auto"])
def test_the_example_prints_what_hoopgen_simulates(lines: list[list[str]], backend: str) -> None:
    """The example prints 17 digits, so the last bit is compared."""
    shots = hoopgen.simulate(numbers("double shots").reshape(-1, 9), backend=backend)
    assert len(lines) == len(shots)
    for row, (outcome, contacts, _, time, _) in enumerate(lines):
        assert hoopgen.Outcome[outcome.upper()] == shots.outcome[row]
        assert int(contacts) == shots.contacts[row]
        assert float(time) == shots.time[row]


def test_the_example_shows_makes_and_misses_with_and_without_contacts(
    lines: list[list[str]],
) -> None:
    assert {line[0] for line in lines} == {"made", "missed"}
    assert {line[1] for line in lines} >= {"0", "1", "2"}
