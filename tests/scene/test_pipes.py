"""A ball in a pipe along gravity, whose direction is a parameter, meets its wall.

Along such an axis the condition of the wall is of degree 2 in time, not of degree 4: the ball comes
to the wall at a constant speed. No end is in its way, so that nothing else bounds the flight.
"""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

import hoopgen
from hoopgen.scene import Cylinder, End, Parameter, Scene
from hoopgen.simulation.engine import Engine
from tests.helpers.compiled import needs_compiler

pytestmark = [
    pytest.mark.slow,
    pytest.mark.xdist_group("pipes"),
    needs_compiler,
]

PIPE = Scene(
    "pipe_along_gravity",
    parameters=[
        Parameter("lean", 0.2, "1", sign="any"),
        Parameter("aside", 0.0, "1", sign="any"),
    ],
    bodies=[Cylinder("pipe", radius=0.4, axis=("lean", "aside", 1), inside=True)],
    ball_radius=0.05,
    gravity=9.81,
    restitution=0.9,
    ends={"side": End(axis="x", at=-0.8)},
)
"""The end is beyond the wall."""


@pytest.fixture(scope="module")
def engine() -> Engine:
    return hoopgen.compile(PIPE)


def in_the_pipe(rows: int = 60) -> NDArray[np.float64]:
    """Return balls that begin in the pipe and move away from the end."""
    rng = np.random.default_rng(5)
    states = np.zeros((rows, 9))
    states[:, :2] = rng.uniform(-0.2, 0.2, (rows, 2))
    states[:, 3:6] = rng.normal(0, 1, (rows, 3))
    states[:, 3] = 0.1 + np.abs(states[:, 3])
    return states


def test_a_ball_meets_the_wall_of_a_pipe_along_gravity(engine: Engine) -> None:
    states = in_the_pipe()
    shots = engine.simulate(states, {"lean": 0}, max_contacts=1, time_limit=20.0)
    place, velocity = states[:, :2], states[:, 3:5]
    square, mixed = (velocity**2).sum(axis=1), (place * velocity).sum(axis=1)
    room = 0.35**2 - (place**2).sum(axis=1)
    times = (np.sqrt(mixed**2 + square * room) - mixed) / square
    assert (shots.contacts == 1).all()
    sure = ~shots.uncertain
    np.testing.assert_allclose(shots.time[sure], times[sure], rtol=0, atol=1e-9)
    assert sure.mean() > 0.8


def test_a_ball_that_hardly_moves_across_a_pipe_is_flagged(engine: Engine) -> None:
    """The ball meets the wall after an hour, if errors allow it: the degree is not certain."""
    states = np.zeros((20, 9))
    states[:, 3] = np.geomspace(1e-5, 1e-4, len(states))
    states[:, 5] = 3.0
    shots = engine.simulate(states, {"lean": 0}, time_limit=20.0)
    assert shots.uncertain.all()


def test_proofs_in_a_pipe_along_gravity_agree(engine: Engine) -> None:
    pytest.importorskip("flint")
    states = in_the_pipe(20)
    given = {"parameters": {"lean": 0}, "max_contacts": 4, "time_limit": 20.0}
    proof = engine.certify(states, processes=1, **given)  # type: ignore[arg-type]
    shots = engine.simulate(states, record=True, **given)  # type: ignore[arg-type]
    assert proof.decided.sum() > 10
    assert proof.agrees(shots).all()
