"""`fit_release` in air: exact tracks, errors at their bound, and intervals that hold."""

from __future__ import annotations

import math
from functools import cache

import numpy as np
import pytest

pytest.importorskip("scipy")
pytest.importorskip("sympy")

from scipy.stats import binomtest

import hoopgen
from hoopgen import NBA_AIR, fit_release
from hoopgen.study.recovery.bends import FlightsInAir
from hoopgen.study.recovery.estimator import EFFICIENCY
from hoopgen.study.recovery.fit_release import UNSETTLED
from tests.helpers.effort import trials

from .tracks import SPIN, Floats, noisy

# One worker: the scene is compiled once.
pytestmark = pytest.mark.xdist_group("air")

LONGEST = 1.6  # s


@cache
def throws(count: int, seed: int) -> tuple[Floats, Floats]:
    """Return free throws through air, (n, 9), and the times of their first contacts, (n,)."""
    random = np.random.default_rng(seed)
    states = hoopgen.release(
        random.normal(7.37, 0.1, count),
        np.radians(random.normal(52.0, 2.0, count)),
        np.radians(random.normal(0.0, 1.5, count)),
        SPIN,
        height=2.1336,
        distance=4.191,
    )
    shots = hoopgen.simulate(states, NBA_AIR, scene=hoopgen.AIR, max_contacts=1)
    return states, shots.time


def tracks(states: Floats, contact: Floats, times: Floats) -> Floats:
    """Return positions before the first contacts, (n, m, 3), NaN afterwards."""
    found = hoopgen.AIR.follow(np.broadcast_to(times, (len(states), len(times))), states, NBA_AIR)
    return np.where((times < contact[:, None])[..., None], found, np.nan)


def fit(times: Floats, positions: Floats, **options: object) -> hoopgen.FittedReleases:
    return fit_release(
        times, positions, scene=hoopgen.AIR, parameters=NBA_AIR, backspin=SPIN, **options
    )


def bounds(states: Floats, contact: Floats, times: Floats, noise: float) -> Floats:
    """Return the Cramér-Rao bounds of the errors of states at the release, (n, 6)."""
    step, ends = 1e-4, []
    for sign in (1.0, -1.0):
        moved = np.repeat(states[:, None], 6, axis=1)
        moved[:, np.arange(6), np.arange(6)] += sign * step
        rows = moved.reshape(-1, 9)
        every = np.broadcast_to(times, (len(rows), len(times)))
        ends.append(hoopgen.AIR.follow(every, rows, NBA_AIR).reshape(len(states), 6, len(times), 3))
    design = (ends[0] - ends[1]) / (2.0 * step)
    inside = (times < contact[:, None])[:, None, :, None]
    information = np.einsum("npmk,nqmk->npq", design * inside, design)
    return noise * np.sqrt(np.diagonal(np.linalg.inv(information), axis1=1, axis2=2))


@pytest.mark.slow
@pytest.mark.parametrize("given", [0.01, None])
def test_exact_tracks_give_exact_releases(given: float | None) -> None:
    states, contact = throws(20, 1)
    times = np.arange(0.0, LONGEST, 1 / 60)
    found = fit(times + 100.0, tracks(states, contact, times), noise=given)
    assert found.credible.all()
    # An estimate that changes by less than 1e-4 standard deviations of 1 cm is not improved.
    np.testing.assert_allclose(found.states, states, rtol=0, atol=1e-5 if given else 1e-8)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("rate", "noise"), [(30, 0.02), pytest.param(120, 0.01, marks=pytest.mark.slow)]
)
def test_errors_are_those_of_the_best_estimate(rate: int, noise: float) -> None:
    states, contact = throws(trials(600, 150), rate)
    times = np.arange(0.0, 1.4, 1 / rate)
    found = fit(times, noisy(tracks(states, contact, times), noise, rate), noise=noise)
    size = (found.states - states)[:, :6] / bounds(states, contact, times, noise)
    slack = 3.0 / math.sqrt(2 * len(size))  # three standard errors of a standard deviation
    deviation = np.sqrt(np.mean(size**2, axis=0))
    assert np.all(deviation < 1.1 + slack), deviation
    assert np.all(deviation > 1.0 - slack), deviation
    assert np.sqrt(np.mean(size**2)) == pytest.approx(1 / math.sqrt(EFFICIENCY), abs=slack)


@pytest.mark.slow
@pytest.mark.parametrize("given", [True, pytest.param(False, marks=pytest.mark.slow)])
def test_intervals_hold_as_often_as_they_say(given: bool) -> None:
    states, contact = throws(trials(600, 150), 7)
    times = np.arange(0.0, LONGEST, 1 / 30)
    positions = noisy(tracks(states, contact, times), 0.02, 8)
    found = fit(times, positions, noise=0.02 if given else None)
    off = found.states[:, :6] - states[:, :6]
    spread = np.sqrt(np.diagonal(found.covariance, axis1=1, axis2=2))
    inside = np.abs(off) <= 1.959963984540054 * spread
    for which in inside.T:
        assert binomtest(int(which.sum()), len(which), 0.95).pvalue > 0.01 / 6


@pytest.mark.slow
def test_a_release_before_the_first_frame_or_within_the_track_is_that_of_the_flight() -> None:
    states, contact = throws(20, 3)
    times = np.arange(0.1, LONGEST, 1 / 60)
    positions = tracks(states, contact, times)
    before = fit(times, positions, noise=0.01, release_time=0.0)
    np.testing.assert_allclose(before.states, states, rtol=0, atol=1e-5)
    late = fit(times, positions, noise=0.01, release_time=0.3)
    np.testing.assert_allclose(
        late.states, hoopgen.AIR.fly(0.3, states, NBA_AIR), rtol=0, atol=1e-5
    )
    # What is known later is the same, carried there by the flight.
    size = np.sqrt(np.diagonal(late.covariance, axis1=1, axis2=2))
    assert np.all(size[:, :3] < np.sqrt(np.diagonal(before.covariance, axis1=1, axis2=2))[:, :3])


@pytest.mark.slow
def test_a_release_is_detected_after_frames_in_the_hand() -> None:
    states, contact = throws(20, 4)
    after = np.arange(0.0, LONGEST, 1 / 60)
    before = np.arange(-12, 0) / 60
    since = np.minimum(-before, 0.15)
    way = (since - since**2 / 0.3)[None, :, None]
    held = states[:, None, :3] - states[:, None, 3:6] * way
    positions = np.concatenate([held, tracks(states, contact, after)], axis=1)
    times = np.concatenate([before, after])
    found = fit(times, noisy(positions, 0.005, 2), noise=0.005, release_time="detect")
    assert np.mean(np.abs(found.time) <= 1.5 / 60) > 0.8


@pytest.mark.slow
def test_a_fit_without_air_is_wrong_by_what_air_does() -> None:
    states, contact = throws(50, 5)
    times = np.arange(0.0, LONGEST, 1 / 60)
    positions = noisy(tracks(states, contact, times), 0.02, 6)
    parabolas = fit_release(times, positions, parameters=hoopgen.NBA, noise=0.02)
    ours = fit(times, positions, noise=0.02)
    speed = np.linalg.norm(states[:, 3:6], axis=1)
    off, right = (
        np.nanmean(np.linalg.norm(found.states[:, 3:6], axis=1) - speed)
        for found in (parabolas, ours)
    )
    assert off < -0.1
    assert abs(right) < 0.02


@pytest.mark.slow
def test_tracks_that_are_no_flights_hurt_no_others() -> None:
    states, contact = throws(3, 9)
    times = np.arange(0.0, LONGEST, 1 / 60)
    positions = tracks(states, contact, times)
    wild = np.stack(
        [
            np.full_like(positions[0], np.nan),
            1e4 * np.random.default_rng(0).normal(size=positions[0].shape),
        ]
    )
    found = fit(times, np.concatenate([wild, positions]), noise=0.01)
    assert found.credible.tolist() == [False, False, True, True, True]
    np.testing.assert_allclose(found.states[2:], states, rtol=0, atol=1e-5)


@pytest.mark.slow
def test_a_fit_that_does_not_settle_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    states, contact = throws(3, 1)
    times = np.arange(0.0, LONGEST, 1 / 60)
    monkeypatch.setattr(FlightsInAir, "passes", 1)
    found = fit(times, tracks(states, contact, times), noise=1e-4)
    assert set(found.reason) == {UNSETTLED}


def test_flights_without_air_are_followed_along_their_parabolas() -> None:
    state = np.array([[4.0, 0.5, 0.0, -4.0, 0.1, 5.0, 0.0, 15.0, 0.0]] * 2)
    times = np.array([[0.0, 0.25, 0.5], [0.1, 0.2, 0.3]])
    found = hoopgen.HOOP.follow(times, state, {**hoopgen.NBA, "gravity": np.array([9.81, 9.0])})
    for row, gravity in enumerate((9.81, 9.0)):
        fall = np.array([0.0, 0.0, -0.5 * gravity])
        since = times[row, :, None]
        right = state[row, :3] + state[row, 3:6] * since + fall * since**2
        np.testing.assert_allclose(found[row], right, rtol=0, atol=1e-14)
