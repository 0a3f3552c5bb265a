"""A ball that rolls on a floor inside of a ring that lies there meets the ring from within."""

from __future__ import annotations

import math

import numpy as np
import pytest

import hoopgen
from hoopgen import Event
from hoopgen.scene import Plane, Scene, Torus
from tests.helpers.effort import trials

BALL, WIDE, WIRE, HEIGHT = 0.05, 0.5, 0.04, 0.03


@pytest.mark.slow
def test_a_ball_inside_a_ring_on_the_floor_meets_it_where_a_straight_line_does() -> None:
    scene = Scene(
        "ring_on_floor",
        bodies=[
            Plane("floor"),
            Torus("tyre", radius=WIDE, wire=WIRE, centre=(0.1, 0, HEIGHT), restitution=0.5),
        ],
        ball_radius=BALL,
        gravity=9.81,
        restitution=0,
        rolls=True,
    )
    count = trials(400, 100)
    chance = np.random.default_rng(1)
    far, azimuth, heading = chance.uniform([0, 0, 0], [0.35, 6.28, 6.28], (count, 3)).T
    speed = chance.uniform(0.1, 3, count)
    states = np.zeros((count, 9))
    states[:, :3] = np.stack([far * np.cos(azimuth), far * np.sin(azimuth), far * 0 + BALL], 1)
    states[:, 3:5] = speed[:, None] * np.stack([np.cos(heading), np.sin(heading)], 1)
    states[:, 6], states[:, 7] = -states[:, 4] / BALL, states[:, 3] / BALL
    within = WIDE - math.sqrt((WIRE + BALL) ** 2 - (BALL - HEIGHT) ** 2)
    along = np.sum(states[:, :2] * states[:, 3:5], axis=1)
    time = (-along + np.sqrt(along**2 + speed**2 * (within**2 - far**2))) / speed**2
    states[:, 0] += 0.1
    shots = hoopgen.simulate(
        states, scene=scene, leaving="floor", record=True, max_contacts=1, time_limit=30
    )
    assert not shots.uncertain.any()
    met = shots.events[shots.events["kind"] == Event.IMPACT]
    assert np.array_equal(met["shot"], np.arange(count))
    assert np.all(met["surface"] == 1)
    np.testing.assert_allclose(met["time"], time, rtol=0, atol=1e-12)
