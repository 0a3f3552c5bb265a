"""The bar of progress: the time left, and work in several stages."""

from __future__ import annotations

import io
import re
import sys
import time

import pytest

import hoopgen
from hoopgen.cli.messages import shown

MINUTE, CHUNKS = 60.0, 100


class _Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> list[float]:
    """Return a clock that the bar reads, with its time as only entry."""
    now = [1e9]
    monkeypatch.setattr(time, "time", lambda: now[0])
    return now


def _seconds_left(text: str) -> int:
    hours, minutes, seconds = map(int, re.findall(r"(\d\d):(\d\d):(\d\d)", text)[-1])
    return 3600 * hours + 60 * minutes + seconds


@pytest.mark.parametrize("before", [0, 1, 40])
def test_the_time_left_leaves_out_the_start_and_what_was_done_before(
    clock: list[float], monkeypatch: pytest.MonkeyPatch, before: int
) -> None:
    terminal = _Terminal()
    monkeypatch.setattr(sys, "stderr", terminal)
    with shown() as progress:
        clock[0] += MINUTE  # a scene is compiled
        for done in range(before, before + 10):
            progress(done, CHUNKS)
            if done > before:
                assert abs(_seconds_left(terminal.getvalue()) - 2 * (CHUNKS - done)) <= 1
            clock[0] += 2.0


def test_another_stage_has_a_clock_of_its_own(
    clock: list[float], monkeypatch: pytest.MonkeyPatch
) -> None:
    terminal = _Terminal()
    monkeypatch.setattr(sys, "stderr", terminal)
    with shown() as progress:
        for done in range(500):
            progress(done, None)
            clock[0] += 0.01
        for done in range(6):
            progress(done, CHUNKS)
            clock[0] += 2.0
    assert abs(_seconds_left(terminal.getvalue()) - 2 * (CHUNKS - 5)) <= 1
    assert "5%" in terminal.getvalue()


@pytest.mark.parametrize("makes", [None, 0.7])
def test_coach_counts_what_it_does(makes: float | None) -> None:
    pytest.importorskip("scipy")
    said: list[tuple[int, int | None]] = []
    player = hoopgen.Scatter(
        {"height": 2.13, "elevation": 0.9, "aim": 0.05, "distance": 4.19},
        {"elevation": 0.02, "azimuth": 0.02},
    )
    hoopgen.coach(player, makes=makes, shots=2000, progress=lambda *now: said.append(now))
    last = [one for one in said if one[1] is not None]
    done = [one for one, _ in last]
    (total,) = {total for _, total in last}
    assert done == sorted(done)
    assert done[0] == 0
    assert done[-1] == total
    assert len(last) < len(said) if makes else len(last) == len(said)
