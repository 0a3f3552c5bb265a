"""A ball that hits a wall while it rolls on a ramp, hops, and does not bounce on the ramp."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from hoopgen.scene import End, Plane, Scene
from tests.helpers.derived import engine_of
from tests.helpers.effort import trials

RISE = 0.1
RAMP = Scene(
    "ramp",
    bodies=[
        Plane("ramp", normal=(0, -RISE, 1), restitution=0),
        Plane("wall", axis="-x", at=-1, restitution=0.8),
    ],
    ball_radius=0.1,
    gravity=9.81,
    rolls=True,
    ends={"past": End(axis="x", at=-2)},
)


@pytest.mark.sampled(1)
def test_a_ball_that_hops_from_a_wall_rolls_on_without_a_flag(tmp_path: Path) -> None:
    """Its speed off the ramp after it lands is a rounding; every such shot was flagged."""
    up = np.array([0.0, -RISE, 1.0]) / np.hypot(RISE, 1.0)
    states = np.zeros((trials(200), 9))
    states[:, :3] = 0.2 * up
    states[:, 3] = 2.0
    states[:, 4] = np.linspace(-0.5, 0.5, len(states))
    shots = engine_of(RAMP, tmp_path).simulate(states, max_contacts=4, backend="numpy")
    assert (shots.counts == [2, 1]).all()
    assert (shots.rolls == 2).all()
    assert not shots.uncertain.any()
