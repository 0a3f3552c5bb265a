"""`fit_release` with the backspin: derivatives, exact paths, and intervals that hold."""

from __future__ import annotations

import math
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

pytest.importorskip("scipy")

from scipy.stats import binomtest

import hoopgen
from hoopgen import COURT, HOOP, NBA, NBA_COURT, fit_release
from hoopgen.study.recovery.fitted_backspin import AFTER_CONTACT, FAR_BACKSPIN, NO_BACKSPIN
from hoopgen.study.recovery.fitted_releases import FittedReleases
from hoopgen.study.recovery.paths import follow_paths
from hoopgen.study.recovery.posterior import without_prior
from tests.helpers.commands import output
from tests.helpers.effort import trials

from .tracks import Floats, Throws, noisy

MEAN, SPREAD = 18.0, 4.0  # rad/s, of the backspins


@cache
def throws(count: int, seed: int, court: bool = False) -> tuple[Throws, Floats]:
    """Return free throws with their own backspins, and these."""
    random = np.random.default_rng(seed)
    backspin = random.normal(MEAN, SPREAD, count)
    states = hoopgen.release(
        random.normal(7.17, 0.1, count),
        np.radians(random.normal(52.0, 2.0, count)),
        np.radians(random.normal(0.0, 1.5, count)),
        backspin,
        height=2.1336,
        distance=4.191,
    )
    scene, values = (COURT, NBA_COURT) if court else (HOOP, NBA)
    shots = hoopgen.simulate(states, values, scene=scene, record=True)
    first = hoopgen.simulate(states, values, scene=scene, max_contacts=1)
    return Throws(states, first.time, shots.made, shots), backspin


def fit(times: Floats, positions: Floats, **options: Any) -> FittedReleases:
    return fit_release(times, positions, parameters=options.pop("parameters", NBA), **options)


@pytest.mark.parametrize("court", [False, True])
def test_derivatives_are_those_of_differences(court: bool) -> None:
    thrown, backspin = throws(60, 1, court)
    scene, values = (COURT, dict(NBA_COURT)) if court else (HOOP, dict(NBA))
    variables = np.concatenate([thrown.states[:, :6], backspin[:, None]], axis=1)
    times = np.broadcast_to(np.arange(0.0, 1.3, 1 / 30), (60, 39))
    found, step = follow_paths(scene, values, variables, times), 1e-6
    for column in range(7):
        ends = []
        for sign in (1.0, -1.0):
            moved = variables.copy()
            moved[:, column] += sign * step
            ends.append(follow_paths(scene, values, moved, times, False).positions)
        slope = (ends[0] - ends[1]) / (2.0 * step)
        # A frame between two contact times, or a shot beside another way, has no difference.
        off = np.abs(found.jacobian[..., column] - slope) / np.maximum(1.0, np.abs(slope))
        assert np.quantile(off, 0.99) < 1e-6
    assert np.isfinite(found.first).all()


def test_exact_paths_give_exact_backspins() -> None:
    thrown, backspin = throws(60, 2)
    times = np.arange(0.0, 1.6, 1 / 60)
    found = fit(times, thrown.positions(times), noise=1e-3, backspin_sd=math.inf)
    known = found.credible
    assert known.mean() > 0.3  # swishes, and second flights of fewer than three frames, show none
    assert set(found.reason) <= {"", NO_BACKSPIN}
    sharp = known & (found.standard_errors["backspin"] < 0.5)
    assert sharp.sum() > 0.8 * known.sum()
    # The steps end within a hundredth of a standard error.
    off = (found.backspin - backspin) / found.standard_errors["backspin"]
    assert np.abs(off[sharp]).max() < 0.05
    np.testing.assert_allclose(found.states[sharp], thrown.states[sharp], rtol=0, atol=0.03)


@pytest.mark.slow
@pytest.mark.parametrize(("rate", "noise"), [(60, 0.01), (240, 0.02)])
def test_intervals_hold_as_often_as_they_say(rate: int, noise: float) -> None:
    thrown, backspin = throws(trials(1200, 300), rate)
    times = np.arange(0.0, 1.5, 1 / rate)
    positions = noisy(thrown.positions(times), noise, rate)
    found = fit(times, positions, noise=noise, backspin=MEAN, backspin_sd=SPREAD)
    assert found.credible.mean() > 0.95
    true = np.concatenate([thrown.states[:, :6], backspin[:, None]], axis=1)
    values = np.concatenate([found.states[:, :6], found.backspin[:, None]], axis=1)
    spread = np.sqrt(np.diagonal(found.covariance, axis1=1, axis2=2))
    inside = np.abs(values - true) <= 1.959963984540054 * spread
    for which in inside[found.credible].T:
        assert binomtest(int(which.sum()), len(which), 0.95).pvalue > 0.01 / 7
    # A bounce tells far more of the spin than was known, and no bounce nothing.
    after = found.frames & (times >= thrown.contact[:, None])
    bounced = after.any(axis=1) & found.credible
    assert np.median(spread[bounced, 6]) < 0.3 * SPREAD
    swish = found.credible & (found.counts[:, 0] == (times < thrown.contact[:, None]).sum(axis=1))
    np.testing.assert_allclose(spread[swish & ~bounced, 6], SPREAD, rtol=1e-6, atol=0)


@pytest.mark.slow
def test_the_spread_of_a_players_backspin_is_found_without_what_was_assumed() -> None:
    thrown, backspin = throws(300, 5)
    times = np.arange(0.0, 1.5, 1 / 60)
    positions = noisy(thrown.positions(times), 0.01, 6)
    found = fit(times, positions, noise=0.01, backspin=12.0, backspin_sd=10.0)
    player = hoopgen.Scatter.fit(found)
    spread = player.model.sd["backspin"]
    assert abs(player.model.release["backspin"] - backspin.mean()) < 1.0
    assert abs(spread - backspin.std()) < 0.8


@pytest.mark.slow
def test_a_scene_of_another_restitution_does_not_explain_the_bounces() -> None:
    thrown, _ = throws(80, 7)
    times = np.arange(0.0, 1.5, 1 / 60)
    positions = noisy(thrown.positions(times), 0.01, 8)
    found = fit(
        times,
        positions,
        noise=0.01,
        backspin=MEAN,
        backspin_sd=SPREAD,
        parameters=NBA | {"restitution": 0.4},
    )
    assert found.reason.count(AFTER_CONTACT) > 20
    right = fit(times, positions, noise=0.01, backspin=MEAN, backspin_sd=SPREAD)
    assert right.reason.count(AFTER_CONTACT) < 5


def test_a_backspin_far_from_what_was_known_is_not_credible() -> None:
    """Two contacts 10 ms apart, between two frames, look like one with another backspin."""
    random, count, mean = np.random.default_rng(7), 117, 14.0
    backspin = random.normal(mean, SPREAD, 300)
    speed, elevation, azimuth = (random.normal(*of, 300) for of in ((7.17, 0.1), (52, 1.5), (0, 1)))
    angles = np.radians(elevation), np.radians(azimuth)
    states = hoopgen.release(speed, *angles, backspin=backspin, height=2.13, distance=4.19)
    shots = hoopgen.simulate(states[:count], hoopgen.NBA, record=True)
    for shot in range(count):
        path = shots.trajectory(shot)
        times = np.arange(0.0, path.duration, 1 / 30)
        positions = path.at(times)[:, :3] + random.normal(0.0, 0.01, (len(times), 3))
    contacts = path.events["time"][:2]
    assert contacts[1] - contacts[0] < 0.011
    found = fit(times, positions, noise=0.01, backspin=mean, backspin_sd=SPREAD)
    assert found.reason == (FAR_BACKSPIN,)
    assert abs(found.backspin[0] - backspin[shot]) > 10 * SPREAD


def test_tracks_that_end_before_a_contact_show_no_backspin() -> None:
    thrown, _ = throws(20, 9)
    times = np.arange(0.0, 0.7, 1 / 60)
    positions = noisy(thrown.in_flight(times), 0.01, 10)
    free = fit(times, positions, noise=0.01, backspin_sd=math.inf)
    assert set(free.reason) == {NO_BACKSPIN}
    assert np.isnan(free.made(10).probability).all()
    given = fit(times, positions, noise=0.01, backspin=MEAN, backspin_sd=SPREAD)
    plain = fit(times, positions, noise=0.01, backspin=MEAN)
    assert given.credible.all()
    np.testing.assert_allclose(given.backspin, MEAN, rtol=0, atol=1e-6)
    np.testing.assert_allclose(given.states[:, :6], plain.states[:, :6], rtol=0, atol=1e-3)
    np.testing.assert_allclose(given.covariance[:, :6, :6], plain.covariance, rtol=0.05, atol=1e-12)


@pytest.mark.slow
def test_draws_have_the_covariance_of_the_fit() -> None:
    thrown, _ = throws(300, 5)
    times = np.arange(0.0, 1.5, 1 / 60)
    found = fit(
        times,
        noisy(thrown.positions(times), 0.01, 6)[:20],
        noise=0.01,
        backspin=MEAN,
        backspin_sd=SPREAD,
    )
    row = int(np.flatnonzero(found.credible)[0])
    drawn = found.draw(20_000)[row]
    level = np.hypot(drawn[:, 3], drawn[:, 4])
    backspin = (drawn[:, 6] * drawn[:, 4] - drawn[:, 7] * drawn[:, 3]) / level
    own = np.cov(np.concatenate([drawn[:, :6], backspin[:, None]], axis=1).T)
    size = np.sqrt(np.diagonal(found.covariance[row]))
    # Five standard errors of a covariance.
    np.testing.assert_allclose(
        own / np.outer(size, size),
        found.covariance[row] / np.outer(size, size),
        rtol=0,
        atol=5 * math.sqrt(2 / 20_000),
    )


def test_what_was_known_before_is_taken_out_again() -> None:
    alone = np.array([[2.0, 0.3], [0.3, 1.0]])
    value, mean, precision = np.array([0.5, 2.0]), 1.0, 0.7
    whole = np.linalg.inv(alone)
    before = whole.copy()
    before[1, 1] += precision * (1.0 - 1e-3)
    both = np.linalg.inv(before)
    posterior = both @ (whole @ value + np.array([0.0, precision * (1.0 - 1e-3) * mean]))
    found, covariance = without_prior(
        posterior[None], both[None], np.array([mean]), np.array([precision])
    )
    np.testing.assert_allclose(found[0], value, rtol=1e-12, atol=0)
    np.testing.assert_allclose(covariance[0], alone, rtol=1e-12, atol=0)


@pytest.mark.slow
def test_the_command_writes_backspins_with_their_errors(tmp_path: Path) -> None:
    pd = pytest.importorskip("pandas")
    thrown, _ = throws(300, 5)
    times = np.arange(0.0, 1.5, 1 / 60)
    positions = noisy(thrown.positions(times), 0.01, 6)[:20]
    rows = [(k, t, *p) for k, track in enumerate(positions) for t, p in zip(times, track)]  # noqa: B905
    path = tmp_path / "tracks.csv"
    pd.DataFrame(rows, columns=["track", "time", "x", "y", "z"]).to_csv(path, index=False)
    words = ["--preset", "nba", "--noise", "1cm", "--backspin", "18rad/s", "--backspin-sd"]
    output("fit", path, "--out", tmp_path / "r.csv", *words, "4rad/s")
    found = pd.read_csv(tmp_path / "r.csv", skiprows=1)
    here = fit(times, positions, noise=0.01, backspin=MEAN, backspin_sd=SPREAD)
    known = here.credible
    np.testing.assert_allclose(found["backspin_rad_s"][known], here.backspin[known], rtol=1e-6)
    errors = here.standard_errors["backspin"][known]
    np.testing.assert_allclose(found["sd_backspin_rad_s"][known], errors, rtol=1e-4)


@pytest.mark.slow
@pytest.mark.xdist_group("air")
def test_in_air_the_flight_shows_the_backspin_without_a_bounce() -> None:
    pytest.importorskip("sympy")
    from hoopgen import AIR, NBA_AIR

    random = np.random.default_rng(3)
    count = trials(300, 100)
    backspin = random.normal(MEAN, SPREAD, count)
    states = hoopgen.release(
        random.normal(7.37, 0.1, count), np.radians(52.0), 0.0, backspin, height=2.1, distance=4.2
    )
    times = np.arange(0.0, 0.8, 1 / 120)  # before any contact
    positions = AIR.follow(np.broadcast_to(times, (count, len(times))), states, NBA_AIR)
    found = fit_release(
        times,
        noisy(positions, 0.005, 4),
        scene=AIR,
        parameters=NBA_AIR,
        noise=0.005,
        backspin_sd=math.inf,
    )
    assert found.credible.mean() > 0.95
    errors = found.standard_errors["backspin"]
    inside = np.abs(found.backspin - backspin) <= 1.959963984540054 * errors
    assert binomtest(int(inside.sum()), count, 0.95).pvalue > 0.01
    assert np.median(errors) < SPREAD
