"""Grip or slip on a floor: which of both is decided, unless rounding could turn it."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from hoopgen.scene import End, Parameter, Plane, Scene, Sphere
from hoopgen.simulation.engine import Engine
from tests.scene.test_example_scenes import numpy_engine

BALL = 0.125

FLOOR = Scene(
    "rough_floor",
    parameters=[Parameter("mu", 0.25, "1", infinite=True)],
    bodies=[Plane("floor")],
    ball_radius=BALL,
    gravity=8.0,
    restitution=1.0,
    friction="mu",
    ends={"down": End(at=-1.0)},
)
"""A ball that falls a metre comes down with 4 m/s; mu times twice that stops a slip of 5 m/s."""


ESTIMATED = replace(
    FLOOR,
    name="rough_floor_and_ball",
    bodies=[*FLOOR.bodies, Sphere("far", radius=1.0, centre=(100.0, 0.0, -0.5))],
)
"""The same with a body far away that has no proved bounds: there errors are estimated."""


@pytest.fixture(scope="module", params=[FLOOR, ESTIMATED], ids=lambda scene: scene.name)
def floor(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Engine:
    return numpy_engine(request.param, tmp_path_factory.mktemp("floor"))


def test_bounds_on_errors_are_proved_without_the_ball_alone() -> None:
    assert [scene.derive().proves_errors for scene in (FLOOR, ESTIMATED)] == [True, False]


@pytest.mark.sampled(5)
@pytest.mark.parametrize(
    ("apart", "unsure"),
    [(0.0, True), (1e-15, True), (1e-11, False), (-1e-11, False), (-0.4, False), (0.4, False)],
)
def test_the_switch_between_grip_and_slip_is_undecided_within_its_error(
    floor: Engine, apart: float, unsure: bool
) -> None:
    """Calculated by hand: gripping takes 2/5 of the slip, slipping mu (1 + e) times 4 m/s."""
    slip = 5.0 * (1 + apart)
    state: Any = np.zeros(9)
    state[2], state[4] = BALL + 1.0, slip
    options: dict[str, Any] = {"max_contacts": 1, "record": True, "fields": ("uncertain", "state")}
    shots = floor.simulate(state, **options)
    assert bool(shots.uncertain[0]) is unsure
    after = shots.events["after"][0]
    assert after[4] == pytest.approx(slip - min(2 / 5 * slip, 2.0), rel=0, abs=1e-13)
    assert after[6] == pytest.approx(-1.5 * min(2 / 5 * slip, 2.0) / BALL, rel=0, abs=1e-12)


@pytest.mark.parametrize("friction", [0.0, np.inf])
def test_without_friction_or_with_grip_there_is_no_switch(floor: Engine, friction: float) -> None:
    state: Any = np.zeros(9)
    state[2], state[4] = BALL + 1.0, 5.0
    fields = ("uncertain", "state")
    shots = floor.simulate(state, {"mu": friction}, max_contacts=1, record=True, fields=fields)
    assert not shots.uncertain[0]
    expected = 5.0 if friction == 0.0 else 3.0
    assert shots.events["after"][0][4] == pytest.approx(expected, rel=0, abs=1e-13)
