"""A plane without bounds is solid, along an axis too; one with bounds is a plate."""

from __future__ import annotations

import numpy as np
import pytest

import hoopgen
from hoopgen.scene import End, Plane, Scene, Sphere
from tests.helpers.compiled import needs_compiler

pytestmark = needs_compiler


def over_a_ball(*planes: Plane, name: str) -> Scene:
    """Return a scene of planes and, below them, a small sphere on which a ball can roll."""
    return Scene(
        name,
        bodies=[*planes, Sphere("pearl", radius=0.05, centre=(0, 0, -0.6))],
        ball_radius=0.12,
        gravity=9.81,
        restitution=0,
        rolls=True,
        ends={"down": End(at=-2)},
    )


LEVEL = over_a_ball(Plane("floor"), name="over_a_pearl")
PLATE = over_a_ball(Plane("floor", within=["x - 1"]), name="plate_over_a_pearl")


@pytest.mark.slow
@pytest.mark.parametrize("depth", [-0.01, 0.1, 0.12, 0.2, 0.4, 50.0])
def test_a_ball_that_starts_behind_a_plane_without_bounds_is_invalid(depth: float) -> None:
    state = [0.01, 0, 0.12 - depth, 0, 0, 0, 0, 0, 0]
    engine = hoopgen.compile(LEVEL)
    (outcome,) = engine.simulate(state).outcome
    assert outcome == engine.outcomes["INVALID" if depth > 0 else "LODGED"]


@pytest.mark.slow
def test_below_a_plate_a_ball_rolls_off_a_sphere_and_falls() -> None:
    state = [0.01, 0, -0.4, 0, 0, 0, 0, 0, 0]
    shot = hoopgen.simulate(state, scene=PLATE, record=True)
    assert shot.events["surface"].tolist() == [1, 1, 1, 2]
    assert not shot.uncertain.any()
    jumps = shot.events["after"][:, :3] - shot.events["before"][:, :3]
    np.testing.assert_allclose(jumps, 0, rtol=0, atol=1e-12)
