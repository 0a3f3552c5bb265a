"""Circular arcs in profiles of surfaces of revolution: how they are written, refused and drawn.

No scene is compiled here: `test_arcs.py` does that.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
import pytest

from hoopgen.scene import Revolution, SceneError
from hoopgen.scene.files import parse_scene
from hoopgen.scene.geometry import SceneGeometry
from hoopgen.scene.profile_curves import Arc, Segment, meet, ways_at
from tests.scene.test_profiles import BALL, scene

HALF = math.sqrt(0.5)


def arc(through: Sequence[Any], to: Sequence[Any]) -> dict[str, Any]:
    return {"through": through, "to": to}


def on_circle(centre: Sequence[float], radius: float, *degrees: float) -> list[tuple[float, float]]:
    """Return points of a circle, by their angles from the direction of radii to that of heights."""
    angles = map(math.radians, degrees)
    x, y = centre
    return [(x + radius * math.cos(angle), y + radius * math.sin(angle)) for angle in angles]


@pytest.mark.parametrize(
    ("profile", "said"),
    [
        ([arc((1, 1), (1, 2))] * 2, "profile point 1: the line begins there; expected two sizes"),
        ([(1, 0), {"to": (1, 1)}], "profile point 2 through: missing"),
        ([(1, 0), {"through": (1, 1)}], "profile point 2 to: missing"),
        (
            [(1, 0), arc((1, 1), (1, 2)) | {"radius": 1}],
            "profile point 2: unknown radius. There are through, to",
        ),
        (
            [(1, 0), arc(1, (1, 1))],
            "profile point 2 through: expected two sizes, radius and height",
        ),
        ([(1, 0), arc((1, 1), (2, 2, 2))], "profile point 2 to: expected two sizes, radius and"),
        ([(1, 0), arc(("q", 1), (2, 2))], "profile point 2 through radius: 'q': unknown name 'q'"),
        ([(1, 0), arc((1, 1), (2, "q"))], "profile point 2 to height: 'q': unknown name 'q'"),
        ([(1, 0), arc((-1, 1), (1, 2))], "profile point 2 through radius: expected a number of at"),
        ([(1, 0), arc((2, 1), (1, 0))], "profile point 2: it is point 1 again; expected another"),
        ([(1, 0), arc((1.5, 0.5), (2, 1))], "piece 1: its three points are almost on a straight"),
        ([(1, 0), arc((1.5, 0.501), (2, 1))], "piece 1: its three points are almost on a straight"),
        ([(1, 0), arc((2, 1), (1, 1e-4))], "piece 1: its ends are almost the same point; expected"),
        (
            [(0.3, -0.5), arc((0.02, -0.25), (0.02, 0.25))],
            "piece 1: it crosses the axis: its least radius is",
        ),
        (
            [(1, -1), arc((0, 0), (1, 1))],
            "piece 1: it crosses the axis: its least radius is 0; expected at least 0",
        ),
        (
            [(0, -0.3), arc((0.3 * HALF, -0.3 * HALF), (0.3001, 0))],
            "piece 1: its centre is -7.07391e-05 m from the axis; expected on the axis, or at",
        ),
        ([(1, 0), arc((2, 1), (1, 2)), (2.5, 0.5)], "profile: piece 1 and piece 2 meet; expected"),
        (
            [(1, 0), arc((2, 1), (1, 2)), (1, 3), (3, 3), (1.5, 1)],
            "piece 1 and piece 4 meet; expected a simple line",
        ),
        (
            [(1, 0), arc((2, 1), (1, 2)), (1, 3), (4, 3), arc((1.5, 1), (4, -0.9))],
            "piece 1 and piece 4 meet; expected a simple line",
        ),
        (
            [(1, 0), arc((2, 1), (1, 2)), arc((1.5, 1), (2.5, 0.5))],
            "piece 1 and piece 2 meet; expected a simple line",
        ),
        (
            [(1, 0), arc((2, 1), (1, 2)), arc((2, 1), (1, 0))],
            "piece 1 and piece 2 meet; expected a simple line",
        ),
        ([(1, 0), arc((2, 1), (1, 2)), (2, 2)], "profile: piece 2 turns back onto piece 1"),
    ],
)
def test_what_is_wrong_with_an_arc_is_said(profile: Any, said: str) -> None:
    with pytest.raises(SceneError) as refusal:
        scene(Revolution("cup", profile=profile))
    assert str(refusal.value).startswith("scene 'turned': body cup: profile")
    assert said in str(refusal.value)


def test_pieces_may_touch_where_they_continue_one_another() -> None:
    """Also smoothly, and also two arcs that are one circle, or one arc and its chord."""
    first, last = Arc((1, 0), (2, 1), (1, 2)), Arc((1, 2), (0.5, 1), (1, 0))
    whole = Arc((1, 2), (0, 1), (1, 0))
    assert not meet(first, whole, [(1, 2), (1, 0)])
    assert not meet(first, last, [(1, 2), (1, 0)])
    assert not meet(first, Segment((1, 2), (1, 0)), [(1, 2), (1, 0)])
    smooth = Segment((1, 2), (-1, 2))
    assert ways_at(first, smooth) == pytest.approx((0, 1), abs=1e-15)
    assert not meet(first, smooth, [(1, 2)])
    assert not meet(Segment((0.25, 0), (1, 0)), first, [(1, 0)])
    assert meet(Arc((1, 0), (2, 1), (1, 2)), Arc((2, 1), (1, 2), (0, 1)))


@pytest.mark.slow
def test_two_arcs_through_one_another_are_found_wherever_they_are() -> None:
    """Against points of both, closely spaced."""
    chance, found = np.random.default_rng(1), [0, 0]
    for _ in range(300):
        one, other = (
            Arc(*[tuple(point) for point in chance.uniform(0, 1, (3, 2)).tolist()])
            for _ in range(2)
        )
        if min(abs(one.bend), abs(other.bend)) < 0.05:
            continue
        points, others = (np.array(each.samples(2000)) for each in (one, other))
        away = np.linalg.norm(points[:, None, :] - others[None, ::4, :], axis=-1).min()
        spaced = max(each.sweep * each.radius for each in (one, other)) / 250
        if meet(one, other):
            assert away < spaced
            found[0] += 1
        elif away > spaced:
            found[1] += 1
    assert min(found) > 20


def test_a_file_and_python_give_the_same_arcs() -> None:
    text = b"""
name = "turned"
ball_radius = 0.0625
gravity = 9.75
restitution = 0.75
[parameters]
wide = 0.5
[bodies.cup]
kind = "revolution"
profile = [[0.25, 0], { through = ["wide", 0.25], to = [0.25, 0.5] }]
"""
    cup = Revolution("cup", profile=[(0.25, 0), arc(("wide", 0.25), (0.25, 0.5))])
    assert parse_scene(text).key == scene(cup).key
    assert scene(cup).key != scene(Revolution("cup", profile=[(0.25, 0), (0.25, 0.5)])).key


FACES = {
    # A ball rolls through the bottom of a bowl, which has no tip.
    "bowl": (
        [(0, -0.5), arc((0.5 * HALF, -0.5 * HALF), (0.5, 0))],
        ["outside_1:Sphere", "inside_1:Sphere", "edge_2:Torus"],
    ),
    "globe": ([(0, -0.5), arc((0.5, 0), (0, 0.5))], ["outside_1:Sphere", "inside_1:Sphere"]),
    # Its centre is beyond the axis: it is pointed at both ends.
    "lemon": (
        [(0, -0.4), arc((0.2, 0), (0, 0.4))],
        ["outside_1:RevolvedArc", "inside_1:RevolvedArc", "tip_1:Sphere", "tip_2:Sphere"],
    ),
    # In a groove that is narrower than the ball there is no room for it.
    "ring": (
        [(1, 0), arc((1.05, 0.05), (1, 0.1)), arc((0.95, 0.05), (1, 0))],
        ["outside_1:RevolvedArc", "outside_2:RevolvedArc"],
    ),
    "bottle": (
        [(0.5, 0), (0.5, 1), arc((0.3 + 0.2 * HALF, 1 + 0.2 * HALF), (0.3, 1.2)), (0.2, 1.2)],
        ["outside_1:Cylinder", "inside_1:Cylinder", "outside_2:RevolvedArc"]
        + [
            "inside_2:RevolvedArc",
            "above_3:Plane",
            "below_3:Plane",
            "edge_1:Torus",
            "edge_4:Torus",
        ],
    ),
    # Half a circle between two straight pieces at corners.
    "bead": (
        [(1, 0), (1, 0.5), arc((1.25, 0.75), (1, 1)), (1, 1.5)],
        ["outside_1:Cylinder", "inside_1:Cylinder", "outside_2:RevolvedArc"]
        + ["inside_2:RevolvedArc", "outside_3:Cylinder", "inside_3:Cylinder"]
        + [f"edge_{k}:Torus" for k in (1, 2, 3, 4)],
    ),
    # What parameters may change has an edge at every point.
    "changed": (
        [("wide", 0), ("wide", 1), arc(("wide - 0.1", 1.5), ("wide - 0.2", 1.5))],
        ["outside_1:Cylinder", "inside_1:Cylinder", "outside_2:RevolvedArc"]
        + ["inside_2:RevolvedArc"]
        + [f"edge_{k}:Torus" for k in (1, 2, 3)],
    ),
}


@pytest.mark.parametrize("name", FACES)
def test_an_arc_has_these_faces(name: str) -> None:
    pytest.importorskip("sympy")
    profile, faces = FACES[name]
    derived = scene(Revolution("cup", profile=profile)).derive()
    found = [f"{surface.name}:{type(surface).__name__}" for surface in derived.surfaces]
    assert found == [f"cup_{face}" for face in faces]


DRAWN = {
    "bowl": (0.0, -0.3, 0.5, (-80, 10), True),
    "thin": (1.0, 0.2, 0.05, (-80, 80), False),
    "lemon": (-0.2, 0.0, 0.5, (-60, 60), True),
    "crescent": (1.0, 0.3, 0.4, (-170, 60), True),
}


@pytest.mark.parametrize("axis", ["z", "-x", (0.3, -0.5, 1.0)])
@pytest.mark.parametrize("name", DRAWN)
def test_the_triangles_of_an_arc_have_their_corners_on_it(name: str, axis: Any) -> None:
    """Normals pass through the arc's centre, and every point is in the room that pictures show."""
    x, height, radius, angles, hollow = DRAWN[name]
    low, high = angles
    points = on_circle((x, height), radius, low, (low + high) / 2, high)
    centre = np.array([0.5, 0.25, -0.5])
    cup = Revolution("cup", profile=[points[0], arc(*points[1:])], centre=tuple(centre), axis=axis)
    made = scene(cup)
    values = {i.name: float(v) for i, v in zip(made.inputs, made.values(), strict=True)}
    seen = SceneGeometry(made, values)
    (body,) = seen.bodies(seen.room(centre - 3.0, centre + 3.0))
    unit = {"z": np.array([0, 0, 1.0]), "-x": np.array([-1.0, 0, 0])}.get(
        axis if isinstance(axis, str) else "", np.array([0.3, -0.5, 1.0])
    )
    unit = unit / np.linalg.norm(unit)
    corners = body.mesh.corners.reshape(-1, 6)
    places = []
    for part in (corners[:, :3], corners[:, 3:]):
        along = (part - centre) @ unit
        places.append((part - centre, along, part - centre - along[:, None] * unit))
    (_, along, across), (_, up, _) = places
    rho = np.linalg.norm(across, axis=1)
    assert np.abs(np.hypot(rho - x, along - height) - radius).max() < 1e-12
    # The ball's centre is on the line through the arc's centre, on the side that is drawn.
    out = across / rho[:, None]
    there = np.sum((corners[:, 3:] - centre) * out, axis=1)
    away = np.hypot(there - x, up - height)
    assert np.abs(away - (radius - BALL if hollow else radius + BALL)).max() < 1e-12
    assert body.behind is hollow
    turned = np.degrees(np.arctan2(along - height, rho - x))
    assert turned.min() == pytest.approx(low, abs=1e-9)
    assert turned.max() == pytest.approx(high, abs=1e-9)
