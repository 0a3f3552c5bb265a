"""Kinds of shots at a hoop, and sums by kind."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

import hoopgen
from hoopgen.hoop.kinds import TOUCHES, Kind, kinds, sum_by_kind, touches
from hoopgen.study.statistics.tally import Tally

RING, BOARD, BRIDGE = 0, 1, 2


def expected(made: bool, missed: bool, counts: tuple[int, ...], first: int) -> Kind:
    """The kind of a shot, by the descriptions of `Kind`."""
    frame = counts[RING] > 0 or counts[BRIDGE] > 0
    if frame and counts[BOARD]:
        return Kind.BANK_RIM if first == BOARD else Kind.RIM_BOARD
    if frame or counts[BOARD]:
        return Kind.RIM if frame else Kind.BANK
    return Kind.SWISH if made else Kind.AIRBALL if missed else Kind.NONE


def test_kinds_are_as_they_are_described() -> None:
    for counts in itertools.product((0, 1, 300), repeat=3):
        for first in [body for body in range(3) if counts[body]] or [-1]:
            for outcome in hoopgen.Outcome:
                made, missed = outcome.name == "MADE", outcome.name == "MISSED"
                given = np.array([outcome], np.uint8), np.array([counts], np.int32)
                (kind,) = kinds(*given, np.array([first], np.int8))
                assert kind == expected(made, missed, counts, first)


@pytest.mark.parametrize("settings", [1, 4])
def test_a_tally_counts_every_shot_by_kind_and_outcome(settings: int) -> None:
    player = hoopgen.Scatter(
        {"speed": 7.17, "elevation": 0.91, "height": 2.1, "distance": 4.2},
        {"speed": 0.4, "elevation": 0.1, "azimuth": 0.06},
    )
    shots = hoopgen.simulate(player.draw(0, 8_000).states)
    table = Tally.from_shots(shots, settings).table
    outcomes = len(shots.scene.outcomes)
    found = kinds(shots.outcome, shots.counts, shots.first).reshape(settings, -1)
    ends = shots.outcome.reshape(settings, -1)
    for setting, kind, outcome in itertools.product(range(settings), Kind, range(outcomes)):
        both = (found[setting] == kind) & (ends[setting] == outcome)
        assert table[setting, kind, outcome] == both.sum()


def test_sums_by_kind_keep_every_shot() -> None:
    random = np.random.default_rng(3)
    numbers = random.integers(0, 9, (2, TOUCHES, 5))
    assert (sum_by_kind(numbers).sum(axis=1) == numbers.sum(axis=1)).all()
    codes = touches(random.integers(0, 2, (99, 3)).astype(np.int32), np.ones(99, np.int8))
    assert codes.max() < TOUCHES
