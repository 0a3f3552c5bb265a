"""Rotations of boxes, as they are written in Python and in files."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest
from hoopgen.derive.scenes.check import check
from numpy.typing import NDArray

from hoopgen.scene import Box, Parameter, Scene, SceneError
from hoopgen.scene.definition import definition
from hoopgen.scene.files import parse_scene
from tests.scene.test_turned_boxes import BALL, GRAVITY, product

Floats = NDArray[np.float64]


def quaternion_of(orientation: Any) -> Floats:
    """Return the quaternion that a scene reads; one that turns nothing leaves a box along axes."""
    made = Scene(
        "own",
        bodies=[Box("crate", size=(1, 1, 1), orientation=orientation)],
        ball_radius=BALL,
        gravity=GRAVITY,
        restitution=0.75,
    )
    (shape,) = made.read.bodies
    known = dict(zip((i.name for i in made.inputs), made.values(), strict=True))
    if shape.kind == "box":
        return np.array([1.0, 0.0, 0.0, 0.0])
    parts = (shape[f"orientation {name}"] for name in "wxyz")
    return np.array([float(part.evaluate(known)) for part in parts])


def about(axis: int, degrees: float) -> Floats:
    found = np.zeros(4)
    found[0], found[1 + axis] = (
        math.cos(math.radians(degrees) / 2),
        math.sin(math.radians(degrees) / 2),
    )
    return found


@pytest.mark.parametrize(
    ("orientation", "expected"),
    [
        ({"axis": "z", "angle": "30deg"}, about(2, 30)),
        ({"axis": "-x", "angle": "0.5rad"}, about(0, -math.degrees(0.5))),
        ({"axis": (0, 3, 0), "angle": "-200deg"}, about(1, -200)),
        ({"axis": {"tilt": "90deg"}, "angle": "40deg"}, about(0, 40)),
        ({"yaw": "30deg"}, about(2, 30)),
        ({"pitch": "-20deg"}, about(1, -20)),
        ({"roll": "10deg"}, about(0, 10)),
        ((2, 0, 0, 0), about(0, 0)),
        ((-2, 0, 0, 0), about(0, 0)),
        ({"axis": "z", "angle": "0deg"}, about(0, 0)),
        ((3, 0, 4, 0), np.array([0.6, 0, 0.8, 0])),
        ((0, 0, 0, -7), np.array([0, 0, 0, -1.0])),
        (("1e-9", 0, 0, 0.5), np.array([2e-9, 0, 0, 1.0])),
    ],
)
def test_an_orientation_is_a_quaternion(orientation: Any, expected: Floats) -> None:
    np.testing.assert_allclose(quaternion_of(orientation), expected, rtol=0, atol=1e-15)


def test_yaw_pitch_and_roll_turn_one_after_another() -> None:
    """By yaw about z, by pitch about the new y, by roll about the new x."""
    found = quaternion_of({"yaw": "40deg", "pitch": "-25deg", "roll": "70deg"})
    turned = [about(axis, degrees)[None] for axis, degrees in ((2, 40), (1, -25), (0, 70))]
    expected = product(product(turned[0], turned[1]), turned[2])[0]
    np.testing.assert_allclose(found, expected, rtol=0, atol=2e-15)


@pytest.mark.parametrize(("degrees", "way"), [(90, 1), (-90, -1), (270, -1), (450, 1), (-810, -1)])
def test_a_quarter_turn_has_two_equal_parts(degrees: int, way: int) -> None:
    found = quaternion_of({"axis": "z", "angle": f"{degrees}deg"})
    assert found[3] == way * found[0] > 0 or found[3] == way * found[0] < 0
    assert found[1] == found[2] == 0
    assert abs(found[0]) == pytest.approx(math.sqrt(0.5), rel=1e-15)


EXPECTED = "four sizes w, x, y, z of a quaternion, or axis and angle, or yaw, pitch and roll"


@pytest.mark.parametrize(
    ("orientation", "said"),
    [
        ((0, 0, 0, 0), "orientation: is no rotation: all four sizes are 0"),
        (("q", 0, 0, 0), "orientation: is no rotation: all four sizes are 0 at the defaults"),
        ((math.nan, 0, 0, 1), "orientation w: "),
        ((0, math.inf, 0, 1), "orientation x: "),
        ((1, 0, 0), "orientation: expected four sizes w, x, y, z"),
        ("z", "orientation: expected four sizes w, x, y, z"),
        (3, "orientation: expected four sizes w, x, y, z"),
        ((1, 0, 0, "p"), "orientation z: 'p': unknown name"),
        ({}, f"orientation: expected {EXPECTED}; got none of them"),
        ({"axis": "z"}, "orientation angle: missing"),
        ({"angle": "3deg"}, "orientation axis: missing"),
        ({"axis": "z", "angle": 3}, "orientation angle: expected text with a unit"),
        ({"axis": "w", "angle": "3deg"}, "orientation axis: expected one of x"),
        ({"axis": (0, 0, 0), "angle": "3deg"}, "orientation axis: has no direction"),
        (
            {"axis": "z", "angle": "3deg", "yaw": "1deg"},
            f"orientation: expected {EXPECTED}; got axis, angle, yaw",
        ),
        ({"yaw": "30m"}, "orientation yaw: "),
        ({"heading": "3deg"}, f"orientation: expected {EXPECTED}; got heading"),
    ],
)
def test_a_refusal_names_the_argument(orientation: Any, said: str) -> None:
    with pytest.raises(SceneError) as refusal:
        Scene(
            "own",
            parameters=[Parameter("q", 0.0, "1", sign="any")],
            bodies=[Box("crate", size=(1, 1, 1), orientation=orientation)],
            ball_radius=BALL,
            gravity=GRAVITY,
            restitution=0.75,
        )
    assert str(refusal.value).startswith(f"scene 'own': body crate: {said}")


def test_a_ball_rolls_on_a_turned_box() -> None:
    given: Mapping[str, Any] = {"ball_radius": BALL, "gravity": GRAVITY, "restitution": 0.5}
    for turn, oblique in (("5deg", True), ("0deg", False)):
        box = Box("crate", size=(1, 1, 1), orientation={"axis": "x", "angle": turn})
        assert Scene("own", bodies=[box], rolls=True, **given).derive().rolls_obliquely == oblique


def test_files_turn_boxes() -> None:
    text = """
name = "own"
ball_radius = 0.06
gravity = 9.81
restitution = 0.7
[parameters]
lean = {default = 0.2, unit = "1", sign = "any"}
[bodies.crate]
kind = "box"
size = [0.5, 0.3, 0.2]
orientation = {axis = [0, 0, 1], angle = "30deg"}
[bodies.board]
kind = "box"
size = [0.5, 0.3, 0.2]
orientation = {yaw = "30deg", roll = "5deg"}
[bodies.shelf]
kind = "box"
size = [0.5, 0.3, 0.2]
orientation = [1, "lean", 0, 0]
"""
    made = parse_scene(text.encode())
    assert [shape.kind for shape in made.read.bodies] == ["oblique box"] * 3


@pytest.mark.parametrize("free", [1, 2, 3])
def test_a_parameter_may_turn_a_box_about_one_of_its_axes(free: int) -> None:
    """Entries of its rotation are 0 then, and the scene's check computes with them."""
    quaternion = [1, 0, 0, 0]
    orientation = [*quaternion[:free], "lean", *quaternion[free + 1 :]]
    lean = Parameter("lean", 0.2, "1", sign="any")
    body = Box("crate", size=(0.5, 0.3, 0.2), orientation=orientation)
    scene = Scene(
        "leaning", parameters=[lean], bodies=[body], ball_radius=0.1, gravity=9.81, restitution=0.5
    )
    check(definition(scene))
