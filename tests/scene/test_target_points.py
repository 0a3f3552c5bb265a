"""The points of bodies at which a ball is aimed, against their sizes by hand."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from hoopgen.scene import (
    Box,
    Cone,
    Cylinder,
    Disc,
    Parameter,
    Plane,
    Revolution,
    Scene,
    Sphere,
    Torus,
)
from hoopgen.scene.pieces import Body
from hoopgen.scene.target_points import target_point

LEAN, UP = 0.3, 1.6

BODIES: list[tuple[Body, tuple[float, float, float]]] = [
    (Cone("funnel", apex=[0, 0, "up"], slope=1, inside=True, span=[0.4, 0.9]), (0, 0, UP + 0.9)),
    (
        Cone("leaning", apex=[1, 0, 0], axis=[3, 0, 4], slope=1, span=[0, 0.5]),
        (1.3, 0.0, 0.4),
    ),
    (Torus("ring", radius=0.3, wire=0.02, centre=[4, 1, "up"], axis=["lean", 0, 1]), (4, 1, UP)),
    (Torus("flat", radius=0.3, wire=0.02), (0, 0, 0)),
    (Disc("tray", radius=0.3, centre=[2, -2, "up"], axis=[0.1, 0, 1]), (2, -2, UP)),
    (Sphere("globe", radius=0.2, centre=[2, "lean", 1]), (2, LEAN, 1)),
    (Box("crate", size=[0.4, 0.4, 0.3], centre=[1, 3, "lean"]), (1, 3, LEAN)),
    (
        Box("turned", size=[0.4, 0.4, 0.3], centre=[1, 3, "lean"], orientation={"yaw": "30deg"}),
        (1, 3, LEAN),
    ),
    (
        Revolution("bell", profile=[[0.5, 0], [0.3, "up"]], centre=[0, -3, 1], axis=[3, 0, 4]),
        (0.6 * UP, -3.0, 1.0 + 0.8 * UP),
    ),
    # The highest circle is not at an end of the profile.
    (Revolution("roof", profile=[[0.5, 0.1], [0.3, 0.4], [0.1, 0.2]]), (0.0, 0.0, 0.4)),
    (Revolution("down", profile=[[0.5, 0.1], [0.3, 0.4]], axis="-z"), (0.0, 0.0, -0.1)),
]
SOLID = [
    (Plane("floor"), "a plane"),
    (Cylinder("mast", radius=0.1), "a cylinder"),
    (Cone("endless", slope=1), "a cone without a second end of its span"),
]


def scene_of(body: Body) -> Scene:
    """Return a scene of one body."""
    return Scene(
        "alone",
        parameters=[
            Parameter("lean", LEAN, "m", "a length", sign="any"),
            Parameter("up", UP, "m", "another"),
        ],
        ball_radius=0.05,
        gravity=9.81,
        restitution=0.5,
        bodies=[body],
    )


def inputs(scene: Scene, parameters: dict[str, Any]) -> dict[str, NDArray[np.float64]]:
    """Return the inputs of a scene by name."""
    values = scene.values(parameters)
    return {one.name: np.asarray(v) for one, v in zip(scene.inputs, values, strict=True)}


@pytest.mark.parametrize(("body", "middle"), BODIES, ids=lambda one: getattr(one, "name", ""))
def test_the_point_is_the_middle_of_the_body(
    body: Body, middle: tuple[float, float, float]
) -> None:
    scene = scene_of(body)
    found = target_point(scene, inputs(scene, {}), body.name)
    np.testing.assert_allclose(found, middle, rtol=0.0, atol=4e-16)


def test_the_point_follows_the_parameters_of_each_row() -> None:
    for body, column in ((BODIES[0][0], 2), (BODIES[2][0], 2), (BODIES[6][0], 2)):
        scene = scene_of(body)
        rows = target_point(scene, inputs(scene, {"up": [1.0, 2.0], "lean": [0.3, 1.3]}), body.name)
        assert rows.shape == (2, 3)
        np.testing.assert_allclose(np.diff(rows[:, column]), 1.0, rtol=0.0, atol=1e-15)
    scene = scene_of(BODIES[8][0])
    rows = target_point(scene, inputs(scene, {"up": [1.0, 2.0]}), "bell")
    np.testing.assert_allclose(rows[:, 0], [0.6, 1.2], rtol=0.0, atol=4e-16)


@pytest.mark.parametrize(("body", "said"), SOLID, ids=lambda one: getattr(one, "name", ""))
def test_a_body_without_a_middle_is_refused(body: Body, said: str) -> None:
    scene = scene_of(body)
    with pytest.raises(ValueError, match=rf"^target: the body {body.name} is {said}, which has no"):
        target_point(scene, inputs(scene, {}), body.name)
    with pytest.raises(ValueError, match=rf"^target: 'other' is no body of .* has {body.name}$"):
        target_point(scene, inputs(scene, {}), "other")
