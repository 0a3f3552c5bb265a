"""`assess`: counts that probabilities allow, calibration, likelihoods, players."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

pytest.importorskip("scipy")

from scipy.stats import binom

import hoopgen
from hoopgen import NBA, assess
from tests.helpers.effort import trials


def test_equal_probabilities_allow_what_the_binomial_distribution_does() -> None:
    made = np.arange(40) < 25
    found = assess(np.full(40, 0.7), made)
    assert found.total.predicted == pytest.approx(28.0)
    assert (found.total.low, found.total.high) == tuple(binom.ppf([0.025, 0.975], 40, 0.7))
    assert found.total.made == 25
    assert len(found.bins) == 1
    assert found.log_likelihood == pytest.approx(25 * np.log(0.7) + 15 * np.log(0.3))
    assert found.brier == pytest.approx((25 * 0.3**2 + 15 * 0.7**2) / 40)


@pytest.mark.slow
def test_counts_hold_as_often_as_they_say() -> None:
    random, count, inside = np.random.default_rng(1), trials(400, 200), 0
    p = random.uniform(0.1, 0.95, 60)
    for _ in range(count):
        inside += assess(p, random.uniform(size=60) < p).total.agrees
    # Counts are whole numbers: the interval contains at least what it says, and not much more.
    assert 0.95 - 4 * np.sqrt(0.0475 / count) < inside / count < 0.99


def test_good_predictions_beat_one_share_for_all_and_wrong_ones_do_not() -> None:
    random = np.random.default_rng(2)
    p = random.choice([0.2, 0.9], 300)
    made = random.uniform(size=300) < p
    good, bad = assess(p, made), assess(1.0 - p, made)
    assert good.log_likelihood > good.base_log_likelihood > bad.log_likelihood
    assert good.brier < good.base_brier < bad.brier
    assert all(one.agrees for one in good.bins)
    assert not any(one.agrees for one in bad.bins)
    assert len(good.bins) == 2


def test_simulated_shares_are_no_certainties() -> None:
    exact, simulated = (assess([1.0, 0.0], [0, 0], shots=shots) for shots in (None, 100))
    assert exact.log_likelihood == -np.inf
    assert simulated.log_likelihood == pytest.approx(np.log(0.5 / 101) + np.log(100.5 / 101))


@pytest.mark.slow
def test_players_are_reported_in_feet_and_mph() -> None:
    random, count = np.random.default_rng(3), 60
    states = hoopgen.release(
        random.normal(7.17, 0.07, count),
        random.normal(0.9, 0.0227, count),
        backspin=18.0,
        height=2.1336,
        distance=4.191,
    )
    times = np.arange(0, 0.5, 1 / 60)
    fall = np.array([0, 0, -0.5 * NBA["gravity"]])
    path = states[:, None, :3] + states[:, None, 3:6] * times[:, None] + fall * times[:, None] ** 2
    fitted = hoopgen.fit_release(
        times, path + random.normal(0, 0.01, path.shape), parameters=NBA, backspin=18.0
    )
    made = hoopgen.simulate(states, NBA).made
    players = np.repeat(["Ann", "Bea"], 30)
    found = assess(fitted.made(shots=200), made, player=players, releases=fitted)
    assert set(found.players) == {"Ann", "Bea"}
    assert found.total.agrees
    text = found.report("Ann")
    assert text.startswith("Ann: ")
    assert "mph" in text
    assert " ft" in text
    assert "Bea" in str(found)
    pytest.importorskip("matplotlib")
    axes: Any = found.plot()
    assert axes.axes[0].get_xlabel() == "predicted to be made (%)"


@pytest.mark.parametrize(
    ("arguments", "options", "said"),
    [
        (([0.5], [1, 0]), {}, "made: expected a value for each"),
        (([0.5], [2]), {}, "made: expected true or false"),
        (([1.5], [1]), {}, "probability: expected numbers from 0 to 1"),
        (([np.nan], [1]), {}, "probability: no shot has one"),
        (([0.5], [1]), {"player": ["a", "b"]}, "player: expected a label for each"),
    ],
)
def test_what_cannot_be_assessed_is_refused(arguments: Any, options: Any, said: str) -> None:
    with pytest.raises(ValueError, match=said):
        assess(*arguments, **options)


def test_shots_without_a_probability_are_left_out() -> None:
    found = assess([0.5, np.nan, 0.7], [1, 1, 0])
    assert found.left_out == 1
    assert found.total.shots == 2
    with pytest.raises(ValueError, match="player: expected one of none"):
        found.report("Ann")
