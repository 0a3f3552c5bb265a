"""The number of successes of shots with different probabilities."""

from __future__ import annotations

import numpy as np
import pytest

pytest.importorskip("scipy")

from scipy.stats import binom

import hoopgen
from hoopgen.study.statistics.success_counts import count_distribution, count_quantile
from tests.helpers.effort import trials


def shot_by_shot(p: np.ndarray) -> np.ndarray:
    chances = np.ones(1)
    for one in p:
        chances = np.convolve(chances, (1.0 - one, one))
    return chances


def test_blocks_give_what_one_shot_after_another_does() -> None:
    random = np.random.default_rng(1)
    for trial in range(trials(40, 10)):
        count = int(random.integers(1, 700))
        p = random.beta(*random.choice([0.2, 1.0, 5.0], 2), size=count)
        p[: trial % 5] = [0.0, 1.0, 1e-300, 0.5][: min(trial % 5, count)] if trial % 5 < 4 else 1.0
        first, chances = count_distribution(p)
        slow = shot_by_shot(p)
        whole = np.zeros(count + 1)
        kept = min(len(chances), count + 1 - first)
        whole[first : first + kept] = chances[:kept]
        np.testing.assert_allclose(whole, slow, rtol=1e-12, atol=1e-17)
        for at in (0.025, 0.5, 0.975):
            slow_quantile = int(np.searchsorted(np.cumsum(slow), at))
            assert count_quantile(p, at) == slow_quantile


def test_equal_probabilities_are_binomial() -> None:
    for at in (1e-9, 0.025, 0.975):
        assert count_quantile(np.full(50_000, 0.37), at) == binom.ppf(at, 50_000, 0.37)


@pytest.mark.slow
def test_the_work_for_many_shots_is_small() -> None:
    """The distribution for a hundred thousand shots is less than forty deviations long."""
    random = np.random.default_rng(2)
    p = random.uniform(0.0, 1.0, 100_000)
    made = random.uniform(size=len(p)) < p
    deviation = np.sqrt(np.sum(p * (1.0 - p)))
    assert len(count_distribution(p)[1]) < 40 * deviation
    found = hoopgen.assess(p, made)
    spread = 1.96 * deviation
    assert found.total.low == pytest.approx(p.sum() - spread, abs=2)
    assert found.total.high == pytest.approx(p.sum() + spread, abs=2)
