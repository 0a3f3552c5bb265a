"""docs/real-shots.md: the reader and the parabola, on throws that are made up here."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("scipy")

import hoopgen
from benchmarks.real_throws import RING, always, interval, logistic, read, states
from hoopgen import NBA
from hoopgen.core.units import DEGREE, FOOT, INCH, TURN


def written(folder: Path, count: int) -> np.ndarray:
    """Write throws as the data have them; return their releases."""
    random = np.random.default_rng(1)
    released = hoopgen.release(
        random.normal(7.4, 0.05, count),
        random.normal(54, 1, count) * DEGREE,
        random.normal(0, 0.01, count),
        backspin=2.0 * TURN,
        height=2.1,
        distance=4.2,
    )
    for k, (x, y, z, vx, vy, vz, *_) in enumerate(released):
        t = (vz + np.sqrt(vz * vz + 2 * NBA["gravity"] * z)) / NBA["gravity"]
        end_x, end_y = x + vx * t, y + vy * t
        fall = np.degrees(np.arctan2(NBA["gravity"] * t - vz, np.hypot(vx, vy)))
        times = np.arange(-5, 9) / 30
        flown = np.maximum(times, 0.0)
        ball = np.stack(
            [x + vx * flown, y + vy * flown, z + vz * flown - 0.5 * NBA["gravity"] * flown**2]
        )
        there = np.stack([RING - ball[0], -ball[1], ball[2] + 10 * FOOT], axis=1) / FOOT
        hand = there[0] + [0.3, 0.0, 0.0]
        frames = [
            {
                "time": 1000.0 * time,
                "data": {"ball": one.tolist(), "player": {"R_1STFINGER": hand.tolist()}},
            }
            for time, one in zip(times, there, strict=True)
        ]
        trial = {
            "result": "made" if k % 2 else "missed",
            "landing_x": end_y / INCH,
            "landing_y": (NBA["ring_radius"] - end_x) / INCH,
            "entry_angle": fall,
            "tracking": frames,
        }
        (folder / f"BB_FT_P0001_T{k:04}.json").write_text(json.dumps(trial), encoding="utf-8")
    return released


def test_the_parabola_through_hand_and_ring_is_the_throw(tmp_path: Path) -> None:
    released = written(tmp_path, 6)
    throws = read(tmp_path)
    assert throws.made.tolist() == [False, True] * 3
    # The hand lets go between frames: the last one in it is the release itself here.
    found = states(throws, 1, 2.0 * TURN, size=0.0)[:, 0]
    np.testing.assert_allclose(found, released, rtol=0, atol=1e-9)
    np.testing.assert_allclose(throws.fall, -NBA["gravity"], rtol=1e-6, atol=0)


def test_the_assumed_errors_are_those_of_the_draws(tmp_path: Path) -> None:
    written(tmp_path, 2)
    drawn = states(read(tmp_path), 4_000, 0.0)
    assert drawn.shape == (2, 4_000, 9)
    assert np.std(drawn[0, :, 0]) == pytest.approx(2 * INCH, rel=0.05)
    assert not drawn[..., 6:].any()


def test_left_out_throws_are_not_seen(tmp_path: Path) -> None:
    written(tmp_path, 20)
    throws = read(tmp_path)
    before = logistic(throws), always(throws)
    throws.made[3] = ~throws.made[3]
    after = logistic(throws), always(throws)
    for one, other in zip(before, after, strict=True):
        assert one[4] != other[4]
    assert before[0][3] == after[0][3]


def test_intervals_are_no_narrower_than_the_likelihood_says() -> None:
    values = np.linspace(0.3, 0.9, 7)
    likelihood = -0.5 * ((values - 0.6) / 0.05) ** 2
    assert interval(values, likelihood) == "0.6 (0.5 to 0.7)"
    assert interval(values, np.zeros(7)) == "0.3 (below 0.3 to above 0.9)"


def test_a_folder_without_throws_is_refused(tmp_path: Path) -> None:
    with pytest.raises(SystemExit, match="SPL-Open-Data"):
        read(tmp_path)
