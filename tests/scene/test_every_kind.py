"""Every kind of body that a scene file may have is known to all that asks for the kind of a body.

A kind is read, drawn, aimed at, rolled on, and simulated in modules of their own, each of which a
new kind has to be added to.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from types import MappingProxyType

import numpy as np
import pytest

from hoopgen.scene import Scene, SceneError, load_scene
from hoopgen.scene.files import KINDS
from hoopgen.scene.geometry import SceneGeometry
from hoopgen.scene.target_points import target_point
from tests.scene.test_example_scenes import numpy_engine

BODIES: Mapping[str, str] = MappingProxyType(
    {
        "plane": "at = 0",
        "sphere": "radius = 0.3",
        "cylinder": "radius = 0.3\naxis = 'x'\nspan = [-0.4, 0.4]",
        "cone": "half_angle = '60deg'\nspan = [0, 0.4]\ninside = true\napex = [0, 0, -0.2]",
        "disc": "radius = 0.3",
        "torus": "radius = 0.3\nwire = 0.1",
        "box": "size = [0.4, 0.4, 0.1]",
        "revolution": "profile = [[0.05, -0.1], [0.4, 0.1]]",
        "surface": "condition = 'z - x**2'",
    }
)
"""A body of each kind, which a ball above it falls on."""

NO_POINT = {"plane", "surface", "cylinder"}
"""Kinds without a point at which one aims."""

NO_ROLLS = {"revolution", "surface"}
"""Kinds on which no ball is known to roll."""


def scene(folder: Path, kind: str, more: str = "") -> Scene:
    file = folder / f"{kind}.toml"
    file.write_text(
        f"name = 'only_{kind}'\nball_radius = 0.12\ngravity = 9.81\nrestitution = 0.5\n{more}\n"
        f"[bodies.it]\nkind = '{kind}'\n{BODIES[kind]}\n[ends.floor]\nat = -2\n"
    )
    return load_scene(file)


def test_every_kind_of_a_file_has_a_body_here() -> None:
    assert set(BODIES) == set(KINDS)
    assert set(BODIES) >= NO_POINT | NO_ROLLS


@pytest.mark.parametrize("kind", BODIES)
def test_a_body_of_every_kind_is_drawn(tmp_path: Path, kind: str) -> None:
    found = scene(tmp_path, kind)
    values = dict(zip((one.name for one in found.inputs), found.values(), strict=True))
    room = np.full(3, -0.5), np.full(3, 0.5)
    (body,) = SceneGeometry(found, values).bodies(room)
    assert len(body.mesh.corners)


@pytest.mark.parametrize("kind", BODIES)
def test_one_aims_at_a_body_of_every_kind_or_reads_why_not(tmp_path: Path, kind: str) -> None:
    found = scene(tmp_path, kind)
    values = dict(zip((one.name for one in found.inputs), found.values(), strict=True))
    if kind in NO_POINT:
        with pytest.raises(ValueError, match=r"^target: the body it is"):
            target_point(found, values, "it")
    else:
        assert np.isfinite(target_point(found, values, "it")).all()


@pytest.mark.parametrize("kind", BODIES)
def test_a_ball_rolls_on_a_body_of_every_kind_or_one_reads_why_not(
    tmp_path: Path, kind: str
) -> None:
    if kind in NO_ROLLS:
        with pytest.raises(SceneError, match="no ball is known to roll"):
            scene(tmp_path, kind, "rolls = true")
    else:
        assert scene(tmp_path, kind, "rolls = true").rolls


@pytest.mark.slow
@pytest.mark.parametrize("kind", BODIES)
def test_a_ball_meets_a_body_of_every_kind(tmp_path: Path, kind: str) -> None:
    engine = numpy_engine(scene(tmp_path, kind), tmp_path)
    shots = engine.simulate([[0.25, 0.02, 0.9, 0, 0, 0, 0, 0, 0]], fields=("first", "contacts"))
    assert shots.first[0] == 0
    assert shots.contacts[0] > 0
