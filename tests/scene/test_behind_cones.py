"""A ball that begins behind the mirror image of a cone and comes out of that: no contact is missed.

The condition of a cone is negative behind its mirror image, too. No end is in the ball's way, so
that the margin of the search exceeds that condition, and the shots may be uncertain.
"""

from __future__ import annotations

import numpy as np
import pytest

import hoopgen
from hoopgen.scene import Cone, End, Parameter, Scene
from hoopgen.simulation.engine import Engine
from tests.helpers.compiled import needs_compiler

pytestmark = [pytest.mark.slow, pytest.mark.xdist_group("behind_cones"), needs_compiler]

FLAT_CONE = Scene(
    "flat_cone",
    parameters=[Parameter("slope", 4.0, "1"), Parameter("ball", 0.1), Parameter("pull", 9.5)],
    bodies=[Cone("cone", axis="y", slope="slope")],
    ball_radius="ball",
    gravity="pull",
    down="z",
    restitution=1.0,
    ends={"out": End(at=-0.8)},
)
"""Gravity points away from the end."""

SHOTS = (
    # slope, ball, pull, place, velocity, time of the first contact
    (
        (4.995411642965537, 0.11209379017350896, 9.549938867998494),
        (-0.519152822, -0.768687903, -0.065014182, 2.683207106, 1.881530859, -0.115505251),
        0.480626,
    ),
    (
        (3.233500733690189, 0.027827949066653805, 9.499279749249535),
        (-0.107035366, -0.396656363, -0.016143924, 0.363178547, 2.361084408, -0.811162437),
        0.162603,
    ),
)


@pytest.fixture(scope="module")
def engine() -> Engine:
    return hoopgen.compile(FLAT_CONE)


def test_a_ball_that_comes_out_of_the_mirror_image_does_not_miss_the_cone(engine: Engine) -> None:
    values, states, times = (np.array(part) for part in zip(*SHOTS, strict=True))
    parameters = dict(zip(("slope", "ball", "pull"), values.T, strict=True))
    states = np.hstack([states, np.zeros((len(states), 3))])
    shots = engine.simulate(states, parameters, max_contacts=1, time_limit=4.0)
    met = (shots.contacts == 1) & (np.abs(shots.time - times) < 1e-5)
    assert (met | shots.uncertain).all()
