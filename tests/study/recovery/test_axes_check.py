"""Tracks in other units or axes are told, and good ones are not."""

from __future__ import annotations

import numpy as np
import pytest

pytest.importorskip("scipy")

from hoopgen import NBA, fit_release
from hoopgen.study.recovery.fit_release import ABOVE_FLOOR, OTHER_UNIT
from tests.helpers.effort import trials

from .tracks import noisy, throws


@pytest.mark.sampled(2)
@pytest.mark.parametrize(
    ("unit", "size"), [("yards", 0.9144), ("feet", 0.3048), ("inches", 0.0254), ("cm", 0.01)]
)
@pytest.mark.parametrize("noise", [0.003, 0.02])
def test_the_unit_is_named_by_the_fall(unit: str, size: float, noise: float) -> None:
    times = np.arange(0, 0.8, 1 / 60)
    positions = noisy(throws(12, 3).in_flight(times), noise, 4)
    found = fit_release(times, positions / size, parameters=NBA)
    assert not found.credible.any()
    assert set(found.reason) <= {
        OTHER_UNIT.format(unit=unit),
        "estimated noise larger than the ball",
    }
    if unit == "yards":
        assert set(found.reason) == {OTHER_UNIT.format(unit="yards")}


def test_heights_above_the_floor_are_told() -> None:
    times = np.arange(0, 0.7, 1 / 60)
    positions = noisy(throws(10, 5).in_flight(times), 0.01, 6)
    found = fit_release(times, positions + (0.0, 0.0, 3.048), parameters=NBA)
    assert set(found.reason) == {ABOVE_FLOOR}


@pytest.mark.slow
def test_good_tracks_are_not_suspected() -> None:
    """Whatever the noise and the rate are, and with the ball's slower fall in air."""
    for seed in range(trials(40, 10)):
        random = np.random.default_rng(seed)
        rate, noise = random.choice([25, 60, 240]), random.choice([0.001, 0.01, 0.03])
        times = np.arange(0, random.uniform(0.3, 0.9), 1 / rate)
        flights = throws(8, 100 + seed).in_flight(times)
        slower = flights + np.array([0.0, 0.0, 0.015 * 9.81 / 2]) * (times**2)[None, :, None]
        for positions in (flights, slower):
            found = fit_release(times, noisy(positions, noise, seed), parameters=NBA)
            assert not {ABOVE_FLOOR, *map(_said, ("yards", "feet"))} & set(found.reason)


def _said(unit: str) -> str:
    return OTHER_UNIT.format(unit=unit)
