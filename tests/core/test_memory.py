"""Requests far beyond the memory: refused at once, with their size, before any allocation."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import hoopgen
from hoopgen.core import memory as memory_module
from hoopgen.core.memory import check_room, format_bytes, format_whole, memory
from hoopgen.simulation.run import check_log
from tests.helpers.commands import failure

FREE_THROW = hoopgen.release(7.17, 0.89, height=2.1336, distance=4.191)
RELEASE = {"speed": 7.17, "elevation": 0.89, "height": 2.1336, "distance": 4.191}
PLACE = ["--distance", "13.75ft", "--height", "7ft"]
SHOT = ["--speed", "7.17", "--elevation", "51deg", *PLACE]


@pytest.fixture(autouse=True)
def _a_small_machine(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let there be 16 GB everywhere."""
    monkeypatch.setattr(memory_module, "memory", lambda: 16 * 10**9)


# In one place


def test_what_is_there_is_allowed_up_to_its_share(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(memory_module, "memory", lambda: 4_000)
    check_room("shots", 300, "shots", 10)
    said = "shots: 301 shots would take 3.0 kB of memory; of the 4.0 kB there are, at most 75%"
    with pytest.raises(ValueError, match=f"^{re.escape(said)}"):
        check_room("shots", 301, "shots", 10)


def test_memory_is_that_of_the_container_if_that_is_less(tmp_path: Path) -> None:
    limit = tmp_path / "memory.max"
    fresh = memory.__wrapped__
    whole = fresh(limit)  # there is no such file
    assert whole > 2**20
    limit.write_text("max\n")
    assert fresh(limit) == whole
    limit.write_text("123456\n")
    assert fresh(limit) == 123456


@pytest.mark.parametrize(
    ("count", "said"),
    [(7, "7"), (123_456_789, "123,456,789"), (10**11, "1e+11"), (15 * 10**10, "1.5e+11")],
)
def test_long_numbers_are_said_in_short(count: int, said: str) -> None:
    assert format_whole(count) == said


def test_a_number_of_any_size_is_said() -> None:
    assert format_whole(10**6000) == "1e+6000"
    assert format_bytes(10**6000) == "1e+6000 bytes"


@pytest.mark.parametrize(
    ("size", "said"),
    [(999, "999 bytes"), (1500, "1.5 kB"), (8.9e12, "8.9 TB"), (25e9, "25 GB"), (1e22, "1e+22 b")],
)
def test_bytes_are_said_in_their_unit(size: float, said: str) -> None:
    assert format_bytes(int(size)).startswith(said)


# From Python


def scatter() -> hoopgen.Scatter:
    return hoopgen.Scatter(RELEASE, {"speed": 0.07})


TOO_MUCH: dict[str, tuple[Callable[[], Any], str]] = {
    "events": (
        lambda: hoopgen.simulate(FREE_THROW, record=True, max_contacts=2**31 - 1),
        "max_contacts: 2.1e+9 events to be recorded at once would take",
    ),
    "cells": (
        lambda: hoopgen.map(
            hoopgen.Scatter({"height": 2.0, "distance": 4.0}),
            {name: np.linspace(0.1, 0.2, 10**4) for name in ("elevation", "speed", "azimuth")},
        ),
        "over: 1e+12 cells would take 48 TB",
    ),
    "cells that scatter": (
        lambda: hoopgen.map(
            hoopgen.Scatter({"height": 2.0, "distance": 4.0}, {"speed": 0.1}),
            {name: np.linspace(0.1, 0.2, 10**6) for name in ("elevation", "speed")},
        ),
        "over: 1e+12 cells would take 720 TB",
    ),
    "scatter": (lambda: scatter().draw(0, 10**12), "stop: 1e+12 shots drawn at once would take"),
    "noise": (lambda: scatter().noise(5, 10**12 + 5), "stop: 1e+12 shots drawn at once"),
    "resample": (
        lambda: hoopgen.Resample({**RELEASE, "speed": [7.0, 7.2]}).draw(0, 10**12),
        "stop: 1e+12 shots drawn at once would take",
    ),
    "grid": (
        lambda: hoopgen.Grid(
            {"speed": np.arange(1e6) * 1e-5, "backspin": np.arange(1e6) * 1e-5},
            {"height": 2.0, "elevation": 0.9, "distance": 4.0},
        ).draw(0, 10**12),
        "stop: 1e+12 shots drawn at once would take",
    ),
}


@pytest.mark.parametrize("what", TOO_MUCH)
def test_what_no_machine_holds_is_refused_at_once(what: str) -> None:
    pytest.importorskip("scipy")
    call, said = TOO_MUCH[what]
    with pytest.raises(ValueError, match=f"^{re.escape(said)}"):
        call()


def test_shots_of_bank_shots_are_kept_and_so_limited() -> None:
    bank = pytest.importorskip("hoopgen.study.questions.bank")
    player = hoopgen.Scatter({"height": 2.1336, "backspin": 18.0}, {"speed": 0.07})
    with pytest.raises(ValueError, match=r"^shots: 1e\+12 shots would take 48 TB"):
        bank.bank_or_direct(player, [[3.0, 1.0]], shots=10**12)


def test_without_a_log_max_contacts_takes_no_room() -> None:
    shots = hoopgen.simulate(FREE_THROW, max_contacts=2**31 - 1)
    assert shots.outcome.tolist() == hoopgen.simulate(FREE_THROW).outcome.tolist()


def test_room_for_the_log_is_that_of_the_shots_at_once() -> None:
    contacts = 5 * 10**7  # 8.9 GB a shot
    check_log(1, contacts, threads=2, scene=hoopgen.HOOP)
    check_log(10**6, contacts, threads=1, scene=hoopgen.HOOP)
    with pytest.raises(ValueError, match=r"^max_contacts: 100,000,002 events .* 19 GB of memory"):
        check_log(10, contacts, threads=2, scene=hoopgen.HOOP)
    check_log(10**6, 40, threads=100, scene=hoopgen.HOOP)


@pytest.mark.parametrize("shots", [2**63, 10**400])
def test_more_shots_than_are_counted_are_refused(shots: int) -> None:
    pytest.importorskip("scipy")
    with pytest.raises(
        ValueError, match=r"^shots: expected a whole number from 1, got .*; at most"
    ):
        hoopgen.estimate(scatter(), shots=shots)


# A precision


@pytest.mark.parametrize(
    ("precision", "least"), [(1e-300, r"1\.9e\+300"), (5e-324, r"3\.\de\+323")]
)
def test_a_precision_that_takes_too_many_shots_is_refused(precision: float, least: str) -> None:
    pytest.importorskip("scipy")
    with pytest.raises(ValueError, match=f"^precision: {precision} takes {least} shots at least"):
        hoopgen.estimate(scatter(), precision=precision)
    with pytest.raises(ValueError, match=r"^precision: "):
        hoopgen.compare(scatter(), scatter(), precision=precision)


def test_with_shots_said_any_precision_ends() -> None:
    pytest.importorskip("scipy")
    assert hoopgen.estimate(scatter(), shots=200_000, precision=1e-300).shots == 200_000


def test_a_precision_may_be_a_number_of_numpy() -> None:
    intervals = pytest.importorskip("hoopgen.study.statistics.intervals")
    width = np.float32(0.02)
    assert intervals.least_shots(width, 0.95) == intervals.least_shots(float(width), 0.95)


def test_no_interval_is_narrower_than_its_least_shots_allow() -> None:
    intervals = pytest.importorskip("hoopgen.study.statistics.intervals")
    random = np.random.default_rng(1)
    for _ in range(2_000):
        shots, level = int(random.choice([1, 2, 3, 10, 1_000])), float(random.choice([0.5, 0.999]))
        cuts = np.sort(random.choice([0, shots, shots // 2, random.integers(shots + 1)], 3))
        parts = random.permutation(np.diff(cuts, prepend=0, append=shots)).tolist()
        # Half a width is known within some eps of 1, of which it is a difference.
        low, high = intervals.newcombe_interval(*parts, level)
        half = math.nextafter(min(0.5 * (high - low) + 1e-15, 0.99), 1.0)
        assert intervals.least_shots(half, level, paired=True) <= shots
        low, high = intervals.wilson_interval(parts[0], shots, level)
        assert intervals.least_shots(0.5 * float(high - low) + 1e-15, level) <= shots


# On the command line


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["shot", *SHOT, "--max-contacts", "2147483647"], "--max-contacts: 2.1e+9 events"),
        (
            ["map", "--over", "elevation=45deg:60deg:100000000000", "--speed", "7", *PLACE],
            "elevation: 1e+11 values would take 10 TB",
        ),
        (
            ["map", "--over", "elevation=45deg:60deg:100000", "--over", "speed=6:8:100000", *PLACE]
            + ["--over", "azimuth=-1deg:1deg:100"],
            "over: 1e+12 cells would take 48 TB",
        ),
        (
            [
                "map",
                "--over",
                "gravity=-1e308:1e308:3",
                "--aim",
                "0",
                "--elevation",
                "50deg",
                *PLACE,
            ],
            "gravity: from -1e+308 to 1e+308 is further than numbers go",
        ),
        (["aim", "--distance", "1m:2m:5e-324m", "--height", "7ft"], "2 to 10,000 distances"),
        (["estimate", *SHOT, "--scatter", "speed=0.07", "--precision", "1e-300"], "1.9e+300"),
    ],
)
def test_the_command_line_says_it_in_one_line(arguments: list[str], said: str) -> None:
    pytest.importorskip("scipy")
    assert said in failure(*arguments)


STUDY = """[study]
name = "Too much"
[release]
height = "7 ft"
distance = "13.75 ft"
speed = "7.17 m/s"
elevation = "51 deg"
[scatter]
speed = "0.05 m/s"
[[question]]
name = "much"
"""

ANGLES = '{ from = "45 deg", to = "60 deg", count = %s }'


@pytest.mark.parametrize(
    ("question", "said"),
    [
        (
            f'kind = "map"\nover.elevation = {ANGLES % "1e12"}',
            "over.elevation: count: 1e+12 values would take 100 TB",
        ),
        (
            f'kind = "map"\nover.elevation = {ANGLES % "1e5"}\n'
            'over.speed = { from = "6 m/s", to = "8 m/s", count = 1e5 }',
            "over: 1e+10 cells would take 7.2 TB",
        ),
        (
            'kind = "bank"\nplaces.distance = { from = "3 m", to = "4 m", count = 1e6 }\n'
            f"places.angle = {ANGLES % '1e6'}\n"
            "release.speed = 7",
            "places: 1e+12 places would take 400 TB",
        ),
        ('kind = "estimate"\nprecision = 1e-300', "precision: 1e-300 takes 1.9e+300 shots"),
        ('kind = "estimate"\nmax_contacts = 1e12', "max_contacts: expected a whole number from 1"),
        (
            'kind = "estimate"\nmax_contacts = 2147483647\nfigures = ["fan"]',
            "events to be recorded",
        ),
        ('kind = ["estimate"]', 'question #1, kind: expected "estimate", "compare", '),
        ("kind = {}", 'question #1, kind: expected "estimate", "compare", '),
    ],
)
def test_a_study_file_is_refused_before_any_work(question: str, said: str, tmp_path: Path) -> None:
    pytest.importorskip("pydantic")
    file = tmp_path / "study.toml"
    file.write_text(STUDY + question + "\n")
    assert said in failure("study", str(file), "--check")
    assert said in failure("study", str(file))
    assert [path.name for path in tmp_path.iterdir()] == ["study.toml"]
