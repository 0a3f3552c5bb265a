"""Passings of the disc near its edge: what errors of the state may turn is undecided."""

from __future__ import annotations

import numpy as np
import pytest

pytest.importorskip("flint")

from tests.derive.scenes.test_passage import GRAVITY, RADIUS, of_kernels, truth
from tests.helpers.effort import trials


@pytest.mark.sampled(1)
@pytest.mark.parametrize("error", [1e-12, 1e-8, 1e-5])
def test_a_passing_near_the_edge_is_undecided_if_errors_turn_it(error: float) -> None:
    """Slow falls too, whose time an error of the height changes most."""
    count = trials(1500, at_least=1500)
    rng = np.random.Generator(np.random.PCG64(12))
    angle = rng.uniform(0, 2 * np.pi, count)
    times, sinks = rng.uniform(0.05, 0.5, count), 10 ** rng.uniform(-3, 0.5, count)
    velocity = rng.normal(0, 2, (count, 3))
    # At its passing it sinks so fast, and is so far within the edge, or without.
    off = RADIUS + 3 * error * rng.uniform(-1, 1, count) * np.where(sinks < 0.1, 1 / sinks, 1)
    velocity[:, 2] = GRAVITY * times - sinks
    states = np.zeros((count, 9))
    states[:, 0] = off * np.cos(angle) - velocity[:, 0] * times
    states[:, 1] = off * np.sin(angle) - velocity[:, 1] * times
    states[:, 2] = (sinks + GRAVITY * times / 2) * times - GRAVITY * times**2
    states[:, 3:6] = velocity
    lasting, before = times + 0.05, np.zeros(count)
    through, unsure = of_kernels(states[:, :6], lasting, before, np.full(count, error))
    turned = np.zeros(count, np.bool_)
    for _ in range(3):
        moved = states[:, :6] + error * rng.uniform(-1, 1, (count, 6))
        others = [truth(s, t, 0) for s, t in zip(moved, lasting, strict=True)]
        turned |= through != np.array(others)
    assert turned.sum() > count / 20
    assert not (turned & ~unsure).any()
