"""Balls that roll on bodies of one kind, whose kernels the loop has once, with a table of sizes."""

from __future__ import annotations

from collections import Counter

import numpy as np
import pytest
from hoopgen.derive import model
from hoopgen.derive.ir.event_tree import Call, walk
from numpy.typing import NDArray

import hoopgen
from hoopgen.scene import Cylinder, Parameter, Plane, Scene, Sphere
from tests.helpers.compiled import needs_compiler

pytestmark = pytest.mark.xdist_group("bodies_alike")

COUNT = 300


def bumpy(spheres: int) -> Scene:
    """Return a floor with balls of two sizes half sunk into it, between two rounded curbs."""
    return Scene(
        f"floor_with_{spheres}_bumps",
        parameters=[
            Parameter("low", 0.3),
            Parameter("high", 0.4),
            Parameter("curb", 0.1),
            Parameter("dull", 0.3, "1"),
        ],
        bodies=[
            Plane("floor", at=0),
            *(
                Sphere(
                    f"bump_{k}",
                    radius="high" if k % 2 else "low",
                    centre=(0.7 * k + 0.1, 0.6 * (k % 2) + 0.1, 0.03 * k - 0.2),
                    restitution="dull" if k % 3 else 0.2,
                )
                for k in range(spheres)
            ),
            *(
                Cylinder(f"curb_{side}", radius="curb", centre=(0, y, 0), axis="x", span=(-1, 3))
                for side, y in (("left", -0.8), ("right", 1.4))
            ),
        ],
        ball_radius=0.1,
        gravity=9.81,
        restitution=0.4,
        friction=1,
        rolls=True,
    )


SCENE = bumpy(4)


@pytest.fixture(scope="module")
def states() -> NDArray[np.float64]:
    random = np.random.default_rng(2)
    found = np.zeros((COUNT, 9))
    found[:, 0] = random.uniform(-0.3, 2.4, COUNT)
    found[:, 1] = random.uniform(-0.8, 1.4, COUNT)
    found[:, 2] = random.uniform(0.5, 0.8, COUNT)
    found[:, 3:6] = random.normal(0, 0.3, (COUNT, 3))
    found[:, 6:] = random.normal(0, 3, (COUNT, 3))
    return found


@pytest.fixture(scope="module")
def parameters() -> dict[str, NDArray[np.float64]]:
    random = np.random.default_rng(3)
    usual = {parameter.name: parameter.default for parameter in SCENE.parameters}
    return {name: value * random.uniform(0.95, 1.05, COUNT) for name, value in usual.items()}


FIELDS = ("outcome", "contacts", "time", "state", "rolls", "uncertain", "time_error", "state_error")


def simulated(
    states: NDArray[np.float64], parameters: dict[str, NDArray[np.float64]], backend: str
) -> hoopgen.Shots:
    """Return the shots on the scene, each with its own sizes."""
    return hoopgen.simulate(
        states, parameters, scene=SCENE, fields=FIELDS, time_limit=5, backend=backend
    )


@needs_compiler
@pytest.mark.slow
def test_each_ball_rolls_on_bodies_of_its_own_sizes(
    states: NDArray[np.float64], parameters: dict[str, NDArray[np.float64]]
) -> None:
    """In C a lane that is done takes the next shot, and its sizes with it."""
    together = simulated(states, parameters, "c")
    plain = simulated(states, parameters, "numpy")
    for name in FIELDS:
        assert getattr(together, name).tobytes() == getattr(plain, name).tobytes(), name
    for k in range(0, COUNT, 10):
        alone = simulated(states[k], {name: of[k] for name, of in parameters.items()}, "c")
        for name in FIELDS:
            assert getattr(alone, name).tobytes() == getattr(together, name)[k].tobytes(), (k, name)
    usual = simulated(states, {}, "c")
    assert np.mean(np.any(usual.state != together.state, axis=1)) > 0.75
    assert np.mean(together.rolls > 1) > 0.5


def test_a_body_more_of_a_kind_adds_no_evaluation_but_its_count() -> None:
    """Neither as bounces end, where each body is compared with each other, nor as a ball rolls."""

    def evaluations(spheres: int) -> Counter[str]:
        stages = model.build(bumpy(spheres).derive()).loop.stages
        nodes = (node for stage in stages.values() for node in walk(stage))
        return Counter(node.kernel.name for node in nodes if isinstance(node, Call))

    four, seven = evaluations(4), evaluations(7)
    assert seven - four == {"here": 3, "counted": 3}
    assert four["bump_0_closing"] == four["bump_0_turning"] - 3 == 1
