"""Cylinders and cones are drawn where a ball can touch them, with the lines of their ends."""

from __future__ import annotations

import warnings

import numpy as np
import pytest
from numpy.typing import NDArray

from hoopgen.scene import Cone, Cylinder, End, Scene
from hoopgen.scene.geometry import Body, SceneGeometry
from tests.helpers.effort import trials

BALL, RADIUS = 0.05, 0.3
FAR = np.array([3.0, 3.0, 3.0])


def drawn(body: Cylinder | Cone, low: NDArray[np.float64], high: NDArray[np.float64]) -> Body:
    """Return a body as it is drawn with paths between two corners."""
    scene = Scene(
        "drawn",
        bodies=[body],
        ball_radius=BALL,
        gravity=9.81,
        restitution=0.7,
        ends={"low": End(at=-9)},
    )
    seen = SceneGeometry(
        scene, dict(zip((i.name for i in scene.inputs), scene.values(), strict=True))
    )
    (found,) = seen.bodies(seen.room(low, high))
    return found


def is_on(mesh: NDArray[np.float64], point: NDArray[np.float64]) -> bool:
    """Return whether a point is as near to a triangle's corner as a point of it can be."""
    edges = np.linalg.norm(mesh - np.roll(mesh, 1, axis=1), axis=2).max(axis=1)
    return bool((np.linalg.norm(mesh - point, axis=2).min(axis=1) <= edges).any())


@pytest.mark.parametrize("inside", [False, True])
def test_a_cylinder_without_ends_is_drawn_wherever_the_ball_touches_it(inside: bool) -> None:
    random = np.random.default_rng(5)
    for _ in range(trials(40, at_least=8)):
        axis, angles = random.normal(size=3), random.uniform(0, 2 * np.pi, 2)
        unit = axis / np.linalg.norm(axis)
        aside = np.cross(unit, random.normal(size=3))
        aside /= np.linalg.norm(aside)
        other = np.cross(unit, aside)
        outwards = np.outer(np.cos(angles), aside) + np.outer(np.sin(angles), other)
        points = RADIUS * outwards + random.uniform(-1, 1, (2, 1)) * unit
        balls = points + (-BALL if inside else BALL) * outwards
        body = Cylinder("pipe", radius=RADIUS, axis=axis.tolist(), inside=inside)
        mesh = drawn(body, balls.min(axis=0), balls.max(axis=0)).mesh.corners[..., :3]
        assert all(is_on(mesh, point) for point in points), axis


def test_both_ends_of_a_span_have_their_lines() -> None:
    random = np.random.default_rng(6)
    for _ in range(trials(40, at_least=8)):
        axis = random.normal(size=3).round(1).tolist()
        body = Cylinder("pipe", radius=RADIUS, axis=axis, span=(-0.6, 0.5), inside=True)
        near = np.full(3, 0.3)
        assert len(drawn(body, -near, near).mesh.rims) == 2 * 48, axis


@pytest.mark.parametrize("axis", ["x", [1, 0.5, 0]])
def test_the_ends_of_a_half_pipe_are_half_circles(axis: str | list[float]) -> None:
    body = Cylinder("half", radius=RADIUS, axis=axis, span=(-0.6, 0.6), inside=True, within=["z"])
    found = drawn(body, -FAR, FAR).mesh
    assert found.rims[..., 2].max() < 0.02
    assert found.rims[..., 2].min() == pytest.approx(-RADIUS, abs=1e-3)
    assert found.corners[..., 2].max() < 0.02


def test_a_round_hole_in_a_cylinder_is_open() -> None:
    hole = "0.0144 - (x - 0.15)**2 - y**2"
    body = Cylinder("pipe", radius=RADIUS, axis="x", span=(-0.6, 0.6), within=[hole])
    corners = drawn(body, -FAR, FAR).mesh.corners[..., :3]
    middles = corners.mean(axis=1)
    side = np.abs(np.linalg.norm(middles[:, 1:], axis=1) - RADIUS) < 0.01
    away = np.hypot(middles[side, 0] - 0.15, middles[side, 1])
    assert away.min() > 0.09


def test_a_cone_without_an_end_is_drawn_without_a_warning() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        cup = Cone("cup", axis=[0.2, 0, 1], slope=0.8, inside=True)
        assert len(drawn(cup, np.full(3, -0.2), np.full(3, 0.4)).mesh.corners)


def test_a_hole_along_the_axis_changes_the_view() -> None:
    def planar(*within: str) -> bool:
        body = Cylinder("pipe", radius=RADIUS, axis="x", span=(-0.6, 0.6), within=within)
        ends = {"low": End(at=-9)}
        scene = Scene(
            "seen", bodies=[body], ball_radius=BALL, gravity=9.81, restitution=0.7, ends=ends
        )
        return SceneGeometry(scene, {}).planar

    assert planar()
    assert planar("z")
    assert not planar("0.0144 - (x - 0.15)**2 - y**2")
