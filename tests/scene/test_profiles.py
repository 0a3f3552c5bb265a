"""Profiles of surfaces of revolution: how they are written, refused and drawn.

No scene is compiled here: `test_revolution.py` does that.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from hoopgen.scene import Parameter, Plane, Revolution, Scene, SceneError
from hoopgen.scene.files import parse_scene
from hoopgen.scene.geometry import SceneGeometry

BALL = 0.0625


def scene(*bodies: Any, **given: Any) -> Scene:
    """Return a scene of these bodies."""
    usual: dict[str, Any] = {
        "parameters": [Parameter("wide", 0.5)],
        "ball_radius": BALL,
        "gravity": 9.75,
        "restitution": 0.75,
    }
    return Scene("turned", bodies=bodies, **(usual | given))


@pytest.mark.parametrize(
    ("profile", "said"),
    [
        ([(1, 0)], "profile: expected at least two points, got 1"),
        ([], "profile: expected at least two points, got 0"),
        ("wide", "profile: expected a list of points, got 'wide'"),
        ([1, 2], "profile point 1: expected two sizes, radius and height; got 1"),
        ([(1, 0), (1, 2, 3)], "profile point 2: expected two sizes, radius and height"),
        ([(1, 0), ("tall", 1)], "profile point 2 radius: 'tall': unknown name 'tall'"),
        ([(1, 0), (1, "z")], "profile point 2 height: 'z': unknown name 'z'"),
        ([(1, 0), (-0.5, 1)], "profile point 2 radius: expected a number of at least 0, got -0.5"),
        ([("wide - 1", 0), (1, 1)], "profile point 1 radius: expected a number of at least 0"),
        ([("wide - 1/2", 0), (1, 1)], "point 1 radius: it is 0 at the defaults; expected the"),
        ([(1, 0), (1, 0), (2, 1)], "profile point 2: it is point 1 again; expected another one"),
        ([(1, 0), (0, 1), (1, 2)], "point 2: it lies on the axis; only the first and the last"),
        ([(0, 0), (0, 1)], "profile point 1: it lies on the axis, as the other point does"),
        ([(0, 0), (1, 1), (1, 2), (0, 0)], "point 1: it lies on the axis; no point of a closed"),
        ([(1, 0), (2, 0), (2, 2), (1.5, -1)], "piece 1 and piece 3 meet; expected a simple line"),
        ([(1, 0), (3, 0), (3, 1), (2, 0)], "piece 1 and piece 3 meet; expected a simple line"),
        ([(1, 0), (2, 0), (1, 0)], "piece 1 and piece 2 meet; expected a simple line"),
        ([(1, 0), (2, 1), (1.5, 0.5)], "profile: piece 2 turns back onto piece 1"),
        ([(1, 0), (1 + 1e-7, 1)], "profile piece 1: the radii of its ends are almost the same"),
        ([(1, 0), (2, 1e-9)], "profile piece 1: the heights of its ends are almost the same"),
        ([(1, k) for k in range(51)], "profile: expected at most 50 points of a profile, got 51"),
    ],
)
def test_what_is_wrong_with_a_profile_is_said(profile: Any, said: str) -> None:
    with pytest.raises(SceneError) as refusal:
        scene(Revolution("cup", profile=profile))
    assert str(refusal.value).startswith("scene 'turned': body cup: profile")
    assert said in str(refusal.value)


def test_what_else_is_refused_is_said() -> None:
    cup = Revolution("cup", profile=[(1, 0), (2, 1)])
    with pytest.raises(SceneError, match="body cup: within 1: 'q': unknown name 'q'"):
        scene(Revolution("cup", profile=[(1, 0), (2, 1)], within=["q"]))
    with pytest.raises(SceneError, match="body cup: on a revolution no ball is known to roll"):
        scene(cup, rolls=True)
    with pytest.raises(SceneError, match="what a face of the revolution cup is called"):
        scene(cup, Plane("cup_edge_2"))
    with pytest.raises(SceneError, match="body cup: axis: has no direction"):
        scene(Revolution("cup", profile=[(1, 0), (2, 1)], axis=(0, 0, 0)))
    scene(cup, Plane("cup_edge"))


def test_more_points_may_be_allowed() -> None:
    points = [(1 + k % 2, k) for k in range(51)]
    made = scene(Revolution("cup", profile=points), limits={"profile_points": 51})
    assert made.limits is not None


def test_a_file_and_python_give_the_same_scene() -> None:
    text = b"""
name = "turned"
ball_radius = 0.0625
gravity = 9.75
restitution = 0.75
[parameters]
wide = 0.5
[bodies.cup]
kind = "revolution"
profile = [[0.25, 0], ["wide", 0.5]]
centre = [1, 2, 3]
axis = [0, 1, "wide"]
"""
    cup = Revolution(
        "cup", profile=[(0.25, 0), ("wide", 0.5)], centre=(1, 2, 3), axis=(0, 1, "wide")
    )
    assert parse_scene(text).key == scene(cup).key


FACES = {
    # A ball fits through a pipe, and touches its rims; not one of its own size.
    "pipe": ([(0.1, 0), (0.1, 1)], ["outside_1", "inside_1", "edge_1", "edge_2"]),
    "rod": ([(BALL, 0), (BALL, 1)], ["outside_1", "edge_1", "edge_2"]),
    "plate": ([(0, 0), (1, 0)], ["above_1", "below_1", "edge_2"]),
    "hat": ([(1, 0), (0, 1)], ["outside_1", "inside_1", "edge_1", "tip_2"]),
    # Inside of a narrow cone there is no room at its wider end.
    "needle": ([(0, 0), (0.06, 1)], ["outside_1", "tip_1", "edge_2"]),
    "ring": (
        [(1, 0), (2, 0), (1, 1), (1, 0)],
        ["above_1", "below_1", "outside_2", "inside_2", "outside_3", "inside_3"]
        + ["edge_1", "edge_2", "edge_3"],
    ),
}


@pytest.mark.parametrize("name", FACES)
def test_a_profile_has_these_faces(name: str) -> None:
    pytest.importorskip("sympy")
    profile, faces = FACES[name]
    derived = scene(Revolution("cup", profile=profile)).derive()
    assert [surface.name for surface in derived.surfaces] == [f"cup_{face}" for face in faces]


@pytest.mark.parametrize("axis", ["z", "-x", (0.3, -0.5, 1.0)])
@pytest.mark.parametrize("name", ["pipe", "rod", "hat", "ring"])
def test_the_triangles_lie_on_the_profile(name: str, axis: Any) -> None:
    """Its normals point to the inside if a ball fits in, and the corners turn about them."""
    profile, _ = FACES[name]
    centre = np.array([0.5, 0.25, -0.5])
    made = scene(Revolution("cup", profile=profile, centre=tuple(centre), axis=axis))
    values = {i.name: float(v) for i, v in zip(made.inputs, made.values(), strict=True)}
    seen = SceneGeometry(made, values)
    low, high = seen.room(centre - 3.0, centre + 3.0)
    (body,) = seen.bodies((low, high))
    unit = {"z": np.array([0, 0, 1.0]), "-x": np.array([-1.0, 0, 0])}.get(
        axis if isinstance(axis, str) else "", np.array([0.3, -0.5, 1.0])
    )
    unit = unit / np.linalg.norm(unit)
    corners = body.mesh.corners
    points = corners[..., :3] - centre
    heights = points @ unit
    radii = np.linalg.norm(points - heights[..., None] * unit, axis=-1)
    starts, steps = np.array(profile[:-1], float), np.diff(np.array(profile, float), axis=0)
    place = np.stack([radii, heights], -1)[..., None, :]
    share = np.clip(np.sum((place - starts) * steps, -1) / np.sum(steps**2, -1), 0, 1)
    away = np.linalg.norm(starts + share[..., None] * steps - place, axis=-1).min(-1)
    assert away.max() < 1e-12
    assert body.behind is (name != "rod")
    normals = (corners[..., 3:] - corners[..., :3]) / BALL
    across = np.cross(corners[:, 1, :3] - corners[:, 0, :3], corners[:, 2, :3] - corners[:, 0, :3])
    assert (np.sum(across * normals[:, 0], axis=1) > 0).all()
    if name in ("pipe", "hat", "rod"):
        outward = np.sum(normals * (points - heights[..., None] * unit), axis=-1)
        assert ((outward >= -1e-12) if name == "rod" else (outward <= 1e-12)).all()
    # Every circle of the profile is in the room that pictures show.
    widest = max(radius for radius, _ in profile)
    assert radii.max() == pytest.approx(widest, rel=1e-12)
