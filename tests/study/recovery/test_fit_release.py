"""`fit_release`: errors at their bound, intervals that hold, and frames that are no flight."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

pytest.importorskip("scipy")

from scipy.integrate import quad
from scipy.special import stdtrit
from scipy.stats import binomtest, chi2

import hoopgen
from hoopgen import NBA, fit_release
from hoopgen.core.variables import STATE
from hoopgen.hoop.arguments import FLIGHT_ARGUMENTS, arguments_jacobian, arguments_of
from hoopgen.study.recovery import frames
from hoopgen.study.recovery.estimator import (
    EFFICIENCY,
    MEDIAN_SQUARE,
    efficiency,
    line_covariance,
    weighted_lines,
)
from hoopgen.study.recovery.fit_release import (
    IN_HAND,
    NOT_SIMULATED,
    TOO_FEW,
    TOO_LARGE,
    TOO_NOISY,
    TWO_FLIGHTS,
    UNSETTLED,
)
from hoopgen.study.recovery.fitted_releases import FittedReleases
from tests.helpers import ROOT
from tests.helpers.effort import trials

from .tracks import SPIN, noisy, throws, with_hand

GRAVITY = NBA["gravity"]


def fit(times: Any, positions: Any, **options: Any) -> FittedReleases:
    return fit_release(times, positions, parameters=NBA, **options)


def bounds(times: np.ndarray, inside: np.ndarray, noise: float) -> np.ndarray:
    """Return the Cramér-Rao bounds of the errors of states at time 0, (n, 6)."""
    found = np.empty((len(inside), 6))
    for row, there in zip(found, inside, strict=True):
        design = np.stack([np.ones(there.sum()), times[there]], axis=1)
        size = np.sqrt(np.diag(np.linalg.inv(design.T @ design)))
        row[:] = noise * np.repeat(size, 3)
    return found


# ------------------------------------------------------------------------------------ the constants


@pytest.mark.parametrize("nu", [3.0, 5.0, 8.0])
def test_the_efficiency_is_that_of_its_integrals(nu: float) -> None:
    def mean(function: Any) -> float:
        return float(quad(lambda s: function(s) * chi2.pdf(s, 3), 0.0, np.inf)[0])

    square = mean(lambda s: ((nu + 3) / (nu + s)) ** 2 * s) / 3
    slope = mean(lambda s: (nu + 3) / (nu + s) - 2 / 3 * s * (nu + 3) / (nu + s) ** 2)
    assert efficiency(nu) == pytest.approx(slope**2 / square, rel=1e-7)
    assert mean(lambda s: (nu + 3) / (nu + s) * s) / 3 == pytest.approx(slope, rel=1e-7)


def test_the_quantiles_are_those_of_the_distribution() -> None:
    assert pytest.approx(chi2.isf(0.05, 3), rel=1e-12) == frames.EXPECTED
    assert pytest.approx(chi2.isf(1e-4, 3), rel=1e-10) == frames.OUTLIER
    assert pytest.approx(chi2.median(3), rel=1e-12) == MEDIAN_SQUARE


# ------------------------------------------------------------------------------------- the estimate


@pytest.mark.parametrize("given", [0.01, None])
def test_exact_tracks_give_exact_releases(given: float | None) -> None:
    thrown = throws(50, 1)
    times = np.arange(0.0, 2.0, 1 / 60)
    found = fit(times + 1e4, thrown.positions(times), noise=given, backspin=SPIN)
    assert found.credible.all()
    # The clock's digits: 1e4 s in doubles are exact to 2e-12 s, in which a ball moves 2e-11 m.
    np.testing.assert_allclose(found.states, thrown.states, rtol=0, atol=1e-9)
    np.testing.assert_allclose(found.time, 1e4, rtol=0, atol=1e-9)


@pytest.mark.sampled(2)
@pytest.mark.parametrize(("rate", "noise"), [(30, 0.03), (60, 0.02), (240, 0.01)])
def test_errors_are_those_of_the_best_estimate(rate: int, noise: float) -> None:
    thrown = throws(trials(1500, 300), rate)
    times = np.arange(0.0, 1.4, 1 / rate)
    inside = times < thrown.contact[:, None]
    positions = np.where(inside[..., None], thrown.in_flight(times), np.nan)
    found = fit(times, noisy(positions, noise, rate), noise=noise)
    size = (found.states - thrown.states)[:, :6] / bounds(times, inside, noise)
    least, most = 1.0, 1.1
    slack = 3.0 / math.sqrt(2 * len(size))  # three standard errors of a standard deviation
    deviation = np.sqrt(np.mean(size**2, axis=0))
    assert np.all(deviation < most + slack), deviation
    assert np.all(deviation > least - slack), deviation
    assert np.sqrt(np.mean(size**2)) == pytest.approx(1 / math.sqrt(EFFICIENCY), abs=slack)


def covered(found: Any, thrown: Any, confidence: float = 0.95) -> dict[str, np.ndarray]:
    """Return in which tracks the interval of each quantity has the truth in it."""
    truth = {**arguments_of(thrown.states), **dict(zip(STATE, thrown.states.T, strict=True))}
    ends = found.intervals(confidence)
    assert set(ends) == {*FLIGHT_ARGUMENTS, *STATE[:6]}
    return {
        name: (low <= truth[name]) & (truth[name] <= high) for name, (low, high) in ends.items()
    }


@pytest.mark.slow
@pytest.mark.parametrize("given", [True, False])
def test_intervals_hold_as_often_as_they_say(given: bool) -> None:
    thrown = throws(trials(2000, 400), 7)
    times = np.arange(0.0, 1.6, 1 / 30)
    positions = noisy(thrown.positions(times), 0.02, 8)
    found = fit(times, positions, noise=0.02 if given else None)
    assert found.noise == pytest.approx([0.02] * 3, rel=0.05)
    inside = covered(found, thrown)
    for name, which in inside.items():
        chance = binomtest(int(which.sum()), len(which), 0.95).pvalue
        assert chance > 0.01 / len(inside), (name, which.mean())


@pytest.mark.slow
def test_intervals_hold_with_few_degrees_of_freedom() -> None:
    """Each track alone, with eight frames: six degrees of freedom of the noise."""
    count = trials(150, 60)
    thrown = throws(count, 9)
    times = np.arange(8) / 12
    positions = noisy(thrown.in_flight(times), 0.02, 10)
    held, normal = [], []
    for row in range(count):
        found = fit(times, positions[row])
        assert found.degrees <= 6
        truth = thrown.states[row, :6]
        off = np.abs(found.states[0, :6] - truth)
        size = np.sqrt(np.diag(found.covariance[0]))
        low, high = found.intervals()["vx"]
        assert high - low == pytest.approx(2 * stdtrit(found.degrees, 0.975) * size[3], rel=1e-6)
        ends = found.intervals()
        held.append(
            [
                ends[name][0][0] <= value <= ends[name][1][0]
                for name, value in zip(STATE[:6], truth, strict=True)
            ]
        )
        normal.append(off <= 1.96 * size)
    inside = np.array(held)
    for column in inside.T:
        assert binomtest(int(column.sum()), count, 0.95).pvalue > 0.01 / 6
    # With normal quantiles they would not.
    assert binomtest(int(np.sum(np.array(normal)[:, ::2])), 3 * count, 0.95).pvalue < 0.01


def test_standard_errors_are_those_of_draws() -> None:
    thrown = throws(5, 3)
    times = np.arange(0.0, 1.6, 1 / 30)
    found = fit(times, noisy(thrown.positions(times), 0.02, 4), noise=0.02)
    drawn = arguments_of(found.draw(20_000, seed=5))
    for name in FLIGHT_ARGUMENTS:
        spread = np.std(drawn[name], axis=1)
        np.testing.assert_allclose(found.standard_errors[name], spread, rtol=0.03, atol=0)


@pytest.mark.slow
def test_draws_have_the_covariance_and_the_spin() -> None:
    thrown = throws(3, 3)
    times = np.arange(0.0, 1.6, 1 / 30)
    positions = noisy(thrown.positions(times), 0.02, 4)
    found = fit(times, positions, noise=(0.01, 0.02, 0.03), backspin=SPIN)
    drawn = found.draw(40_000, seed=6)
    size = np.sqrt(np.diagonal(found.covariance, axis1=1, axis2=2))
    for row in range(3):
        off = (drawn[row, :, :6] - found.states[row, :6]) / size[row]
        expected = found.covariance[row] / np.outer(size[row], size[row])
        np.testing.assert_allclose(np.cov(off.T), expected, rtol=0, atol=0.03)
    np.testing.assert_allclose(arguments_of(drawn)["backspin"], SPIN, rtol=1e-12)
    assert np.array_equal(drawn, found.draw(40_000, seed=6))
    assert not np.array_equal(drawn, found.draw(40_000, seed=7))


@pytest.mark.slow
def test_the_covariance_is_of_the_noise_of_each_coordinate() -> None:
    thrown = throws(400, 11)
    times = np.arange(0.0, 1.6, 1 / 30)
    sizes = np.array([0.01, 0.02, 0.04])
    errors = np.random.default_rng(12).normal(size=(400, len(times), 3)) * sizes
    found = fit(times, thrown.positions(times) + errors)
    assert found.noise == pytest.approx(sizes, rel=0.05)
    off = (found.states - thrown.states)[:, :6]
    size = off / np.sqrt(np.diagonal(found.covariance, axis1=1, axis2=2))
    assert np.std(size, axis=0) == pytest.approx(1.0, abs=0.12)


# ------------------------------------------------------------------------------- outliers and gaps


@pytest.mark.sampled(1)
@pytest.mark.parametrize("given", [0.01, None])
def test_outliers_hardly_move_the_estimate(given: float | None) -> None:
    """With 5% outliers of 30 cm errors grow by less than a quarter; of least squares threefold."""
    thrown = throws(500, 13)
    times = np.arange(0.0, 1.0, 1 / 30)
    inside = times < thrown.contact[:, None]
    clean = noisy(np.where(inside[..., None], thrown.in_flight(times), np.nan), 0.01, 14)
    random = np.random.default_rng(15)
    wrong = inside & (random.random(inside.shape) < 0.05)
    aside = random.normal(size=clean.shape)
    aside *= 0.3 / np.linalg.norm(aside, axis=-1, keepdims=True)
    spoilt = clean + np.where(wrong[..., None], aside, 0.0)

    def error(states: np.ndarray) -> np.ndarray:
        return np.sqrt(np.mean((states[:, 3:6] - thrown.states[:, 3:6]) ** 2, axis=0))

    before, after = (fit(times, one, noise=given) for one in (clean, spoilt))
    assert np.all(error(after.states) < 1.25 * error(before.states))
    assert after.credible.mean() > 0.97
    assert after.noise == pytest.approx([0.01] * 3, rel=0.05)
    assert np.mean(after.outliers[wrong]) > 0.99
    assert np.mean(after.outliers[inside & ~wrong]) < 0.001
    inside_interval = covered(after, thrown)
    assert min(which.mean() for which in inside_interval.values()) > 0.92
    plain = np.moveaxis(np.where(inside[..., None], spoilt, 0.0), -1, 0)
    plain[2] += np.where(inside, 0.5 * GRAVITY * times**2, 0.0)
    squares = weighted_lines(np.broadcast_to(times, inside.shape), plain, inside.astype(float))
    assert np.all(error(np.pad(squares.slope.T, ((0, 0), (3, 3)))) > 3 * error(before.states))


@pytest.mark.slow
def test_gaps_and_order_change_nothing() -> None:
    thrown = throws(40, 16)
    times = np.arange(0.0, 1.6, 1 / 60)
    positions = noisy(thrown.positions(times), 0.01, 17)
    random = np.random.default_rng(18)
    gaps = random.random(positions.shape[:2]) < 0.4
    gaps[:, 0] = False
    positions[gaps, 1] = np.nan
    found = fit(times, positions, noise=0.01)
    assert found.credible.mean() > 0.95
    assert not found.frames[gaps].any()
    off = (found.states - thrown.states)[:, :6]
    assert np.std(off / np.sqrt(np.diagonal(found.covariance, axis1=1, axis2=2))) < 1.15
    order = random.permutation(len(times))
    mixed = fit(times[order], positions[:, order], noise=0.01)
    assert np.array_equal(mixed.states, found.states)
    assert np.array_equal(mixed.frames, found.frames[:, order])
    assert np.array_equal(mixed.residuals, found.residuals[:, order], equal_nan=True)
    rows, columns = np.nonzero(np.isfinite(positions).all(axis=-1))
    shuffled = random.permutation(len(rows))
    rows, columns = rows[shuffled], columns[shuffled]
    labels = [f"throw {row}" for row in rows]
    long = fit(times[columns], positions[rows, columns], noise=0.01, tracks=labels)
    number = [int(label.split()[1]) for label in long.labels]
    np.testing.assert_allclose(long.states, found.states[number], rtol=0, atol=1e-9)
    assert np.array_equal(long.frames, found.frames[rows, columns])
    one = fit(times, positions[3], noise=0.01)
    np.testing.assert_allclose(one.states[0], found.states[3], rtol=0, atol=1e-9)
    assert one.residuals.shape == (len(times), 3)
    assert one.frames.shape == times.shape


def test_a_frame_that_is_there_twice_counts_once() -> None:
    thrown = throws(20, 19)
    times = np.arange(0.0, 1.2, 1 / 60)
    positions = noisy(thrown.positions(times), 0.01, 20)
    found = fit(times, positions)
    twice = fit(np.concatenate([times, times]), np.concatenate([positions, positions], axis=1))
    assert found.credible.mean() > 0.8
    assert np.array_equal(twice.states, found.states)
    assert np.array_equal(twice.covariance, found.covariance)
    assert np.array_equal(twice.credible, found.credible)
    assert np.array_equal(twice.frames[:, : len(times)], found.frames)
    assert not twice.frames[:, len(times) :].any()


# ---------------------------------------------------------------------------- the ends of a flight


@pytest.mark.slow
@pytest.mark.parametrize("rate", [30, 120])
def test_frames_after_the_first_contact_are_cut(rate: int) -> None:
    thrown = throws(150, 19)
    times = np.arange(0.0, 2.0, 1 / rate)
    positions = noisy(thrown.positions(times), 0.01, 20)
    there = np.isfinite(positions[..., 0])
    inside = times < thrown.contact[:, None]
    assert np.sum(there & ~inside) > 100
    found = fit(times, positions, noise=0.01)
    assert found.credible.mean() > 0.98
    # At 4 m/s the noise of a frame is 3 ms, and the margin before the contact twice that.
    clear = np.abs(times - thrown.contact[:, None]) > 0.02
    alike = ((found.frames & clear) == (inside & there & clear)).all(axis=1)
    # The noise decides whether a shot that grazes the ring touches it.
    assert alike.mean() > 0.97
    blind = fit_release(times, positions, noise=0.01, parameters=NBA | {"restitution": 0.5})
    assert np.array_equal(blind.frames, found.frames)


@pytest.mark.sampled(1)
@pytest.mark.parametrize(("rate", "noise"), [(30, 0.01), (60, 0.005)])
@pytest.mark.parametrize("given", [True, False])
def test_the_release_is_found_within_a_frame(rate: int, noise: float, given: bool) -> None:
    thrown = throws(200, 21)
    times, positions = with_hand(thrown, rate, 1.6)
    found = fit(
        times + 5.0,
        noisy(positions, noise, rate),
        release_time="detect",
        noise=noise if given else None,
    )
    off = np.round((found.time - 5.0) * rate)
    assert np.mean(np.abs(off) <= 1) > 0.95
    assert found.credible.mean() > 0.97
    # The velocity at the true release is as good as its standard error says.
    velocity = found.states[:, 3:6] + np.outer(found.time - 5.0, [0.0, 0.0, GRAVITY])
    errors = np.stack([found.standard_errors[name] for name in ("vx", "vy", "vz")], axis=1)
    size = (velocity - thrown.states[:, 3:6]) / errors
    assert np.all(np.std(size, axis=0) < 1.25)
    assert np.all(np.abs(np.mean(size, axis=0)) < 0.5)
    # Unless it is looked for, the first frames, in the hand, are no flight.
    spoilt = fit(times + 5.0, noisy(positions, noise, rate), noise=noise)
    assert not spoilt.credible.any()
    assert spoilt.reason.count(IN_HAND) > 150


def test_a_given_release_leaves_out_the_frames_before() -> None:
    thrown = throws(30, 22)
    times, positions = with_hand(thrown, 50, 1.4)
    found = fit(times, noisy(positions, 0.01, 23), noise=0.01, release_time=0.0)
    assert found.credible.all()
    assert not found.frames[:, times < 0].any()
    assert found.frames[:, 12].all()
    np.testing.assert_allclose(found.time, 0.0, rtol=0, atol=1e-12)
    off = (found.states - thrown.states)[:, :6]
    assert np.std(off / np.sqrt(np.diagonal(found.covariance, axis1=1, axis2=2))) < 1.2
    late = fit(times, noisy(positions, 0.01, 23), noise=0.01, release_time=np.full(30, 0.1))
    back = late.states[:, :3] - 0.1 * late.states[:, 3:6] - [0.0, 0.0, 0.5 * GRAVITY * 0.01]
    assert np.abs(back - thrown.states[:, :3]).max() < 0.05


@pytest.mark.parametrize("given", [0.01, None])
def test_two_flights_in_a_track_are_not_credible(given: float | None) -> None:
    thrown = throws(40, 24)
    times = np.arange(0.0, 0.4, 1 / 30)
    first = thrown.in_flight(times)
    positions = np.concatenate([first, first[::-1]], axis=1)
    whole = noisy(positions, 0.01, 25)
    clean = noisy(thrown.in_flight(np.arange(24) / 30), 0.01, 26)
    both = np.concatenate([whole, clean])
    found = fit(np.arange(24) / 30, both, noise=given)
    assert set(found.reason[:40]) == {TWO_FLIGHTS}
    assert found.credible[40:].mean() > 0.95
    assert found.noise == pytest.approx([0.01] * 3, rel=0.15)


def test_tracks_that_are_no_flights_are_not_credible() -> None:
    thrown = throws(8, 27)
    times = np.arange(0.0, 0.8, 1 / 30)
    positions = noisy(thrown.in_flight(times), 0.01, 28)
    slow = positions.copy()
    slow[0, :, 2] += 2.0 * times**2  # another gravity
    slow[1, 2:] = np.nan
    slow[2] = np.nan
    slow[3] = np.random.default_rng(29).normal(size=slow[3].shape)
    slow[4] -= [4.0, 0.0, 0.0]  # begins within the backboard's bodies or beyond
    slow[4, :, 0] = -0.3810 + 0.001 * times
    slow[4, :, 1:] = [0.0, 0.4]
    slow[4, :, 2] -= 0.5 * GRAVITY * times**2
    found = fit(times, slow, noise=0.01)
    assert found.reason[0] in (TOO_LARGE, TWO_FLIGHTS, IN_HAND)
    assert found.reason[1:3] == (TOO_FEW, TOO_FEW)
    assert found.reason[3] in (TOO_LARGE, TWO_FLIGHTS, IN_HAND, TOO_FEW)
    assert found.reason[4] == NOT_SIMULATED
    assert found.credible.tolist() == [False] * 5 + [True] * 3
    assert np.isnan(found.states[1:3]).all()
    assert np.isnan(found.covariance[1:3]).all()
    alone = fit(times, slow[5:], noise=0.01)
    np.testing.assert_allclose(alone.states, found.states[5:], rtol=0, atol=1e-12)
    text = str(found)
    assert "8 tracks, 3 credible" in text
    assert TOO_FEW in text


@pytest.mark.slow
@pytest.mark.parametrize(
    ("length", "duration"), [(1 / 0.3048, 1.0), (1 / 0.0254, 1.0), (1000.0, 1.0), (1.0, 2.0)]
)
def test_tracks_in_other_units_are_not_credible(length: float, duration: float) -> None:
    """All of a table are bent alike, so that its own noise makes no track an exception."""
    times = np.arange(0.0, 1.4, 1 / 30)
    positions = noisy(throws(40, 1).positions(times), 0.01, 2)
    assert fit(times, positions).credible.mean() > 0.9
    found = fit(times * duration, positions * length)
    assert not found.credible.any()
    assert TOO_NOISY in found.reason
    assert TOO_NOISY in str(found)
    assert np.isnan(found.made(10).probability).all()


@pytest.mark.slow
def test_of_releases_that_differ_widely_as_many_go_in_as_the_probabilities_say() -> None:
    """The distribution of a fit is that given the track if all releases are equally likely."""
    random, count = np.random.default_rng(8), trials(6000, 3000)
    states = hoopgen.release(
        random.uniform(6.8, 7.6, count),
        np.radians(random.uniform(45, 59, count)),
        np.radians(random.uniform(-5, 5, count)),
        SPIN,
        height=random.uniform(1.9, 2.4, count),
        distance=random.uniform(3.9, 4.5, count),
    )
    times = np.arange(0.0, 0.6, 1 / 30)  # before any contact
    fall = np.array([0.0, 0.0, -0.5 * GRAVITY])
    flights = states[:, None, :3] + states[:, None, 3:6] * times[:, None]
    found = fit(
        times, noisy(flights + fall * times[:, None] ** 2, 0.03, 9), noise=0.03, backspin=SPIN
    )
    chance = found.made(100).probability[found.credible]
    made = hoopgen.simulate(states, NBA).made[found.credible]
    spread = math.sqrt(np.sum(chance * (1.0 - chance)))
    assert abs(made.sum() - chance.sum()) < 3.5 * spread
    assert spread > 5.0


def test_no_tracks_have_no_releases() -> None:
    none = fit(np.zeros((0, 5)), np.zeros((0, 5, 3)))
    assert len(none) == 0
    assert str(none).startswith("0 tracks, 0 credible")
    made = none.made()
    assert len(made) == 0
    assert str(made).startswith("track")


@pytest.mark.parametrize("confidence", [0, 1, math.nan, "high", None])
def test_a_bad_confidence_is_named(confidence: Any) -> None:
    found = fit(np.zeros((1, 5)), np.zeros((1, 5, 3)))
    for call in (found.intervals, found.made):
        with pytest.raises((TypeError, ValueError), match=r"^confidence: expected a number"):
            call(confidence=confidence)


@pytest.mark.slow
def test_a_cut_that_does_not_settle_says_so() -> None:
    thrown = throws(60, 30)
    times = np.arange(0.0, 2.0, 1 / 120)
    positions = noisy(thrown.positions(times), 0.03, 31)
    once = fit(times, positions, noise=0.03, rounds=1)
    assert UNSETTLED in once.reason
    assert UNSETTLED not in fit(times, positions, noise=0.03).reason


def test_gravity_may_be_one_a_track() -> None:
    thrown = throws(2, 32)
    times = np.arange(0.0, 0.8, 1 / 30)
    positions = thrown.in_flight(times)
    positions[1, :, 2] += 0.5 * (GRAVITY - 1.62) * times**2
    parameters = NBA | {"gravity": np.array([GRAVITY, 1.62])}
    found = fit_release(times, positions, parameters=parameters, noise=0.01)
    assert found.credible.all()
    np.testing.assert_allclose(found.states[:, :6], thrown.states[:, :6], rtol=0, atol=1e-9)
    assert found.made(50).shots.tolist() == [50, 50]


def test_the_court_cuts_at_its_own_contacts() -> None:
    thrown = throws(20, 33)
    times = np.arange(0.0, 0.9, 1 / 30)
    positions = noisy(thrown.in_flight(times), 0.01, 34)
    found = fit_release(
        times, positions, scene=hoopgen.COURT, parameters=hoopgen.NBA_COURT, noise=0.01
    )
    assert found.credible.all()
    assert found.scene is hoopgen.COURT
    assert found.to_pandas()["credible"].all()
    pa = pytest.importorskip("pyarrow")
    assert pa.table(found).to_pandas().equals(found.to_pandas())  # a stream of Arrow


@pytest.mark.slow
def test_a_scene_of_ones_own_has_its_own_contacts_and_ends() -> None:
    scene = hoopgen.compile(hoopgen.load_scene(ROOT / "examples" / "scenes" / "golf.toml"))
    state = np.array([[-0.5, 0.0, 0.3, 1.4, 0.0, 1.0, 0.0, 0.0, 0.0]])
    path = hoopgen.simulate(state, scene=scene, record=True).trajectory(0)
    times = np.arange(0.0, path.duration, 1 / 120)
    found = fit_release(times, path.at(times)[:, :3], scene=scene, noise=0.002)
    assert found.credible.all()
    np.testing.assert_allclose(found.states, state, rtol=0, atol=1e-9)
    contact = path.events["time"][0]
    assert not found.frames[times >= contact].any()
    assert found.frames[times < contact - 0.005].all()
    assert found.made(50).probability[0] == 1.0
    assert list(found.columns())[:3] == ["track", "x_m", "y_m"]


# --------------------------------------------------------------------------------------------- made


@pytest.mark.slow
def test_made_is_the_probability_given_the_track() -> None:
    """Over many shots as many are made as the probabilities say, and they tell shots apart."""
    count = trials(600, 300)
    thrown = throws(count, 35)
    times = np.arange(0.0, 1.6, 1 / 60)
    found = fit(times, noisy(thrown.positions(times), 0.01, 36), noise=0.01, backspin=SPIN)
    made = found.made(shots=300, seed=37)
    known = found.credible
    share, truth = made.probability[known], thrown.made[known]
    assert np.isnan(made.probability[~known]).all()
    assert abs(share.mean() - truth.mean()) < 4 * math.sqrt(
        np.mean(share * (1 - share)) / len(share)
    )
    assert truth[share > 0.9].mean() > 0.85
    assert truth[share < 0.1].mean() < 0.15
    assert np.all((made.low <= made.probability) | ~known)
    assert "95% interval of the simulation" in str(made)
    assert list(made.to_pandas().columns) == ["track", "probability", "low", "high", "shots"]


def test_made_agrees_with_the_true_posterior() -> None:
    """The posterior of known noise, by least squares and NumPy's own normal numbers."""
    thrown = throws(40, 38)
    times = np.arange(0.0, 0.9, 1 / 30)
    positions = noisy(thrown.in_flight(times), 0.02, 39)
    found = fit(times, positions, noise=0.02, backspin=SPIN)
    made = found.made(shots=2000, seed=40).probability
    design = np.stack([np.ones_like(times), times], axis=1)
    covariance = 0.02**2 * np.linalg.inv(design.T @ design)
    random = np.random.default_rng(41)
    truth = []
    for row in range(40):
        straight = positions[row] + np.outer(times**2, [0.0, 0.0, 0.5 * GRAVITY])
        mean = np.linalg.lstsq(design, straight, rcond=None)[0]
        noise = random.multivariate_normal([0.0, 0.0], covariance, (2000, 3))
        states = np.empty((2000, 9))
        states[:, :3], states[:, 3:6] = mean[0] + noise[..., 0], mean[1] + noise[..., 1]
        level = np.linalg.norm(states[:, 3:5], axis=1)
        states[:, 6] = SPIN * states[:, 4] / level
        states[:, 7] = -SPIN * states[:, 3] / level
        states[:, 8] = 0.0
        truth.append(hoopgen.simulate(states, NBA).made.mean())
    # The robust fit is another estimate, with standard errors that are 4% larger.
    assert np.mean(np.abs(made - truth)) < 0.06
    assert abs(np.mean(made) - np.mean(truth)) < 0.03


# ------------------------------------------------------------------------------------ what is given


LINE = np.array([0.0, 0.1, 0.2, 0.3])
FRAMES = np.array([4.0, 0.0, -1.0]) + np.outer(LINE, [-4.0, 0.0, 5.0])


@pytest.mark.parametrize(
    ("times", "positions", "options", "text"),
    [
        ("soon", FRAMES, {}, "times: expected numbers"),
        (LINE, "there", {}, "positions: expected numbers"),
        (LINE, FRAMES[:, :2], {}, "positions: expected shape"),
        (LINE[:3], FRAMES, {}, "times: expected a time for each position"),
        (LINE, FRAMES[:3], {}, "times: expected a time for each position"),
        (LINE, FRAMES, {"tracks": ["a", "b"]}, "tracks: expected a label for each of 4 frames"),
        (LINE, FRAMES, {"tracks": ["a", "b", "c", None]}, "tracks: a frame has no label"),
        (LINE, FRAMES, {"tracks": [[1], 2, 3, 4]}, "tracks: expected labels"),
        (LINE, FRAMES, {"tracks": "abcd"}, "tracks: expected a list or None, got 'abcd'"),
        (LINE, FRAMES[None], {"tracks": [*"abcd"]}, "tracks: with labels expected times (m,)"),
        (LINE, FRAMES, {"noise": 0.0}, "noise: expected a standard deviation above 0"),
        (LINE, FRAMES, {"noise": [1, 2]}, "noise: expected a standard deviation above 0"),
        (LINE, FRAMES, {"noise": "2cm"}, "noise: expected a standard deviation"),
        (LINE, FRAMES, {"release_time": "start"}, 'release_time: expected s, "detect" or None'),
        (LINE, FRAMES, {"release_time": [0, 1]}, "release_time: expected one number or 1"),
        (LINE, FRAMES, {"spin": [1.0, 2.0]}, "spin: expected shape (3,) or (1, 3)"),
        (LINE, FRAMES, {"spin": [0, 0, 1], "backspin": 1}, "spin, backspin: each gives the spin"),
        (LINE, FRAMES, {"backspin": 1080.0}, "backspin: backspin is in rad/s"),
        (LINE, FRAMES, {"backspin_sd": 0.0}, "backspin_sd: expected standard deviations above 0"),
        (LINE, FRAMES, {"backspin_sd": [1.0, 2.0]}, "backspin_sd: expected one number or 1"),
        (LINE, FRAMES, {"backspin_sd": 1.0}, "backspin_sd: of which mean?"),
        (LINE, FRAMES, {"spin": [0, 0, 1], "backspin_sd": 1.0}, "backspin_sd: it is of the"),
        (LINE, FRAMES, {"rounds": 0}, "rounds: expected a whole number from 1"),
        (LINE, FRAMES, {"parameters": {"g": 9.8}}, "parameters: unknown g"),
    ],
)
def test_bad_input_is_one_clear_error(times: Any, positions: Any, options: Any, text: str) -> None:
    with pytest.raises((TypeError, ValueError)) as raised:
        fit_release(times, positions, **options)
    assert str(raised.value).startswith(text)


@pytest.mark.parametrize("frames", [0, 1, 2])
def test_too_few_frames_are_no_error(frames: int) -> None:
    found = fit_release(LINE[:frames], FRAMES[:frames])
    assert found.reason == (TOO_FEW,)
    assert not found.credible[0]
    assert np.isnan(found.states).all()
    assert np.isnan(found.noise).all()
    assert str(found)
    assert found.columns()["credible"].tolist() == [False]
    assert np.isnan(found.made(10).probability[0])
    assert len(fit_release(np.empty((0, 4)), np.empty((0, 4, 3)))) == 0


def test_one_time_for_all_frames_is_too_few() -> None:
    assert fit_release(np.zeros(4), FRAMES, noise=0.01).reason == (TOO_FEW,)


def test_times_that_are_not_finite_are_gaps() -> None:
    times = np.array([0.0, np.nan, 0.2, np.inf])
    assert fit_release(times, FRAMES).reason == (TOO_FEW,)
    assert fit_release(times, FRAMES).frames.tolist() == [True, False, True, False]


# ------------------------------------------------------------------------------- speed and angles


def test_arguments_of_states_are_those_of_the_release() -> None:
    random = np.random.default_rng(42)
    given = {
        "speed": random.uniform(1, 12, 200),
        "elevation": random.uniform(-1.5, 1.5, 200),
        "azimuth": random.uniform(-3.1, 3.1, 200),
        "backspin": random.uniform(-30, 30, 200),
        "sidespin": random.uniform(-30, 30, 200),
        "height": random.uniform(1, 3, 200),
        "distance": random.uniform(0.5, 9, 200),
        "angle": random.uniform(-3.1, 3.1, 200),
    }
    states = hoopgen.release(**given)
    found = arguments_of(states)
    assert list(found) == list(given)
    for name, value in given.items():
        np.testing.assert_allclose(found[name], value, rtol=0, atol=1e-12 * 30)
    step = 1e-6
    for component in range(6):
        moved = [arguments_of(states + sign * step * np.eye(9)[component]) for sign in (1, -1)]
        for row, name in enumerate(FLIGHT_ARGUMENTS):
            slope = (moved[0][name] - moved[1][name]) / (2 * step)
            near = np.abs(slope) < 1e3  # not where an angle jumps by a turn
            np.testing.assert_allclose(
                arguments_jacobian(states)[near, row, component], slope[near], rtol=1e-4, atol=1e-6
            )


def test_the_covariance_at_a_time_is_that_of_the_design() -> None:
    times = np.array([[0.3, 0.4, 0.7, 1.1]])
    design = np.stack([np.ones(4), times[0]], axis=1)
    expected = np.linalg.inv(design.T @ design) / EFFICIENCY
    found = line_covariance(times, np.ones((1, 4), bool))[0]
    np.testing.assert_allclose(found, expected, rtol=1e-12, atol=0)
