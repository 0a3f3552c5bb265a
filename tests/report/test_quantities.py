"""Numbers in words: one form of percent, counts that agree, flags that are explained."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner

from tests.helpers import ROOT

for _library in ("matplotlib", "pyarrow", "scipy", "xarray"):
    pytest.importorskip(_library)

import pyarrow as pa  # noqa: E402

import hoopgen  # noqa: E402
from hoopgen.cli import main  # noqa: E402
from hoopgen.study.jobs.chunk_store import opened  # noqa: E402
from hoopgen.study.questions.optimum_result import advice  # noqa: E402
from hoopgen.text.numbers import (  # noqa: E402
    format_count,
    format_interval,
    format_percent,
    format_points,
    format_uncertain,
)

PLACE = {"height": 2.1336, "distance": 4.191, "backspin": 6 * np.pi}
SD = {"speed": 0.07, "elevation": np.radians(1.3), "azimuth": np.radians(1)}


@pytest.mark.parametrize(
    ("said", "wanted"),
    [
        (format_count(0, "shot"), "0 shots"),
        (format_count(1, "shot"), "1 shot"),
        (format_count(np.int64(1_000_000), "shot"), "1,000,000 shots"),
        (format_count(1.0, "point"), "1 point"),
        (format_count(0.5, "point"), "0.5 points"),
        (format_percent(0.6789), "67.9%"),
        (format_percent(0.6789, 0), "68%"),
        (format_percent(0.999, None), "99.9%"),
        (format_percent(0.0), "0.0%"),
        (format_percent(1e-6), "<0.1%"),
        (format_percent(float("nan")), "unknown"),
        (format_interval(0.1, 0.2), "10.0% to 20.0%"),
        (format_points(0.0123), "+1.2"),
        (format_points(-0.0123), "\N{MINUS SIGN}1.2"),
        (format_uncertain(5, 0), "5 uncertain"),
        (format_uncertain(8212, 8199), "8,212 uncertain (8,199 of them capped)"),
    ],
)
def test_numbers_in_words(said: str, wanted: str) -> None:
    assert said == wanted


def _lines(file: Path) -> list[str]:
    return file.read_text(encoding="utf-8").splitlines()


def test_percents_are_written_in_one_way() -> None:
    texts = [ROOT / "README.md", *(ROOT / "docs").glob("*.md"), *(ROOT / "examples").glob("*.toml")]
    code = [*(ROOT / "hoopgen").rglob("*.py"), *(ROOT / "benchmarks").rglob("*.py")]
    spaced = re.compile(r"""[0-9}] %(?=["'. ,;:|)]|$)(?! \()""")
    found = [one for file in texts for one in _lines(file) if spaced.search(one)]
    inline = re.compile(r"""\} %["' ]|:\.\d%\}|:%\}""")
    found += [one for file in code for one in _lines(file) if inline.search(one)]
    # The README's lines are what a stranger writes with Python's own format.
    assert [line for line in found if "made.mean()" not in line] == []


def swirl() -> Any:
    """A shot that is capped, with so many errors gathered that it is undecided; and a good one."""
    velocity = [-0.8388886803278828, 2.1344934896526224, 3.8620727516260205]
    state = [0.22860000000000003, -0.94488, -0.6096, *velocity, 0, 0, 0]
    return np.array([state, hoopgen.release(7.17, 0.9, height=2.13, distance=4.19)])


def test_uncertain_shots_that_are_capped_are_said_to_be() -> None:
    shots = hoopgen.simulate(swirl())
    capped = shots.uncertain & (shots.outcome == hoopgen.Outcome.CAPPED)
    assert capped.tolist() == [True, False]
    assert repr(shots).endswith("1 uncertain (1 of them capped); PAPER (the article's))")
    found = hoopgen.estimate(
        hoopgen.Resample(
            dict(zip("xyz", swirl().T[:3], strict=True))
            | {name: swirl()[:, 3 + k] for k, name in enumerate(("vx", "vy", "vz"))}
        ),
        shots=200,
    )
    assert 0 < found.uncertain_capped <= found.uncertain
    assert f"{found.uncertain} uncertain ({found.uncertain_capped} of them capped)" in str(found)


@pytest.mark.slow
def test_an_optimum_is_printed_as_on_the_command_line() -> None:
    model = hoopgen.Scatter(
        {**PLACE, "height": 7 * 0.3048, "distance": 13.75 * 0.3048, "backspin": 3 * (2 * np.pi)},
        {"speed": 0.07},
    )
    best = hoopgen.optimum(model, ["elevation", "aim"], shots=500)
    asked = ["optimum", "--over", "elevation", "--over", "aim", "--height", "7ft", "--distance"]
    asked += ["13.75ft", "--backspin", "3Hz", "--scatter", "speed=0.07", "--shots", "500"]
    result = CliRunner().invoke(main, asked)
    assert result.stdout == f"{best}\n"
    assert repr(best) == str(best) == advice(best)
    assert "within 1 point" in str(best)


def test_results_are_represented_as_they_are_printed() -> None:
    player = hoopgen.Scatter({**PLACE, "speed": 7.17, "elevation": 0.9}, SD)
    for one in (
        hoopgen.estimate(player, shots=100),
        hoopgen.compare(player, player, shots=100),
        hoopgen.margins(player, names=["speed"], shots=100)["speed"],
    ):
        assert repr(one) == str(one)


# The command line

ESTIMATE = ["estimate", "--speed", "7.17", "--elevation", "52deg", "--height", "7ft", "--distance"]
ESTIMATE += ["13.75ft", "--scatter", "speed=0.07", "--shots", "100"]


def said(*arguments: str) -> str:
    result = CliRunner().invoke(main, list(arguments))
    assert result.exit_code == 2, result.output
    assert not result.stdout
    return result.stderr


@pytest.mark.parametrize(
    "arguments",
    [
        [*ESTIMATE, "--versus", "backspin=1Hz", "--versus", "backspin=2Hz"],
        [*ESTIMATE, "--scatter", "speed=0.1"],
        [*ESTIMATE, "--set", "gravity=9.8", "--set", "gravity=9.7"],
        [*ESTIMATE, *2 * ("--correlation", "speed,elevation=0.1")],
        ["optimum", "--over", "aim", "--over", "aim=0:1"],
        ["map", "--over", "speed=1,2", "--over", "speed=3"],
        ["batch", __file__, "--out", "out.parquet", *2 * ("--release", "height=2")],
        ["view", __file__, "--out", "out.html", *2 * ("--release", "height=2")],
        ["shot", *2 * ("--set", "gravity=9.8")],
    ],
)
def test_what_can_be_said_once_is_not_said_twice(arguments: list[str]) -> None:
    assert "is given twice" in said(*arguments)


def test_whole_numbers_may_have_an_exponent() -> None:
    plain, short = (
        CliRunner().invoke(
            main, [*ESTIMATE, "--seed", seed, "--max-contacts", most, "--threads", n]
        )
        for seed, most, n in (("1000", "20", "1"), ("1e3", "2e1", "1e0"))
    )
    assert plain.stdout == short.stdout != ""


@pytest.mark.parametrize("seed", ["1e400000000", "-1", "1.5", "nan", "inf", "x", "", str(2**64)])
def test_no_other_seed_is_taken(seed: str) -> None:
    message = said(*ESTIMATE, f"--seed={seed}")
    assert f"{seed!r} is not a whole number from 0 to {2**64 - 1}" in message


@pytest.mark.parametrize(
    "arguments",
    [
        ["aim", "--distance=-3", "--height", "2"],
        ["aim", "--distance=3,-2", "--height", "2"],
        ["aim", "--distance=-1:3:1", "--height", "2"],
        ["shot", "--distance=-3", "--height", "2", "--speed", "7", "--elevation", "50deg"],
        [*ESTIMATE, "--distance=-3"],
    ],
)
def test_a_negative_distance_is_said_to_be_one(arguments: list[str]) -> None:
    assert re.search(r"'--distance': expected 0 m or more, got '?-\d", said(*arguments))


def test_among_many_a_negative_distance_is_one_invalid_shot() -> None:
    states = hoopgen.release(7.17, 0.9, height=2.13, distance=[4.19, -4.19])
    assert hoopgen.simulate(states).outcome.tolist()[1] == hoopgen.Outcome.INVALID
    found = hoopgen.aim(height=2.0, distance=np.array([4.0, -4.0]))
    assert np.isfinite(found.speed).tolist() == [True, False]


def test_a_table_s_negative_distance_is_an_invalid_row(tmp_path: Path) -> None:
    table = tmp_path / "throws.csv"
    table.write_text(
        "speed,elevation_rad,height,distance\n7.17,0.9,2.13,4.19\n7.17,0.9,2.13,-4.19\n"
    )
    assert hoopgen.batch(table, tmp_path / "out.parquet")["invalid"] == 1
    with pytest.raises(ValueError, match="distance: expected 0 m or more, got -1"):
        hoopgen.batch(
            table, tmp_path / "other.parquet", release={"distance": -1.0}, own=["distance"]
        )


def test_of_many_differences_a_few_are_told(tmp_path: Path) -> None:
    with opened(tmp_path, {f"n{k}": k for k in range(9)}) as folder:
        folder.write(0, pa.table({"a": [1]}))
    other = opened(tmp_path, {f"n{k}": k + 1 for k in range(9)})
    with pytest.raises(ValueError, match=r"; n2 is 2 there and 3 here; and 6 more\. Give"):
        other.__enter__()
