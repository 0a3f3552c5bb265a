"""A ball that rolls on a plate with bounds, and that a dome at its end throws into the plate."""

from __future__ import annotations

import numpy as np
import pytest

from hoopgen import Event
from hoopgen.scene import End, Plane, Scene, Sphere
from hoopgen.simulation.engine import Engine
from tests.helpers.derived import engine_of
from tests.helpers.effort import occurrences, trials

BALL = 0.027
TILT = np.array([0.56, 0.0, 0.83])
PLATE, DOME = 0, 1
WEDGE = Scene(
    "wedge",
    bodies=[
        Plane(
            "plate",
            normal=tuple(TILT),
            point=(-0.286, -0.175, 0),
            within=["-y - 0.168", "-1.13*x + 0.02*y - 0.78*z - 0.218"],
        ),
        Sphere("dome", radius=0.157, centre=(0.214, -0.07, -0.148)),
    ],
    ball_radius=BALL,
    gravity=11,
    restitution=0,
    rolls=True,
    ends={"out": End(at=-0.8)},
)


@pytest.fixture(scope="module")
def wedge(tmp_path_factory: pytest.TempPathFactory) -> Engine:
    return engine_of(WEDGE, tmp_path_factory.mktemp("wedge"))


@pytest.mark.slow
def test_a_ball_on_a_plate_that_is_thrown_into_it_meets_it_at_once(wedge: Engine) -> None:
    """The rounding of its distance said that it was behind the plate, and it went through it."""
    normal = TILT / np.linalg.norm(TILT)
    random = np.random.default_rng(0)
    states = np.zeros((trials(400), 9))
    states[:, :3] = 0.033, -0.106, -0.152
    states[:, :2] += random.uniform(-0.004, 0.004, (len(states), 2))
    states[:, 3:6] = random.normal([-0.014, 0.039, 0.251], 0.05, (len(states), 3))
    states[:, 6:] = 2.7, 9.9, -1.4
    shots = wedge.simulate(states, max_contacts=60, time_limit=4, record=True, backend="numpy")
    events = shots.events
    gap = (events["after"][:, :3] - [-0.286, -0.175, 0]) @ normal - BALL
    thrown = (events["kind"] == Event.IMPACT) & (events["surface"] == DOME) & (abs(gap) < 1e-9)
    thrown &= events["after"][:, 3:6] @ normal < -1e-6
    into = np.flatnonzero(thrown[:-1] & (events["shot"][1:] == events["shot"][:-1]))
    assert len(into) >= occurrences(10)
    assert np.all(events["time"][into + 1] - events["time"][into] < 1e-9)
