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
from hoopgen.derive import surfaces
from hoopgen.derive.symbolic.symbols import POSITION

import hoopgen
from hoopgen.scene import Scene, SceneError, load_scene
from hoopgen.scene.files import KINDS
from hoopgen.scene.geometry import SceneGeometry
from hoopgen.scene.oblique_bodies import why_not_rolling
from hoopgen.scene.target_points import target_point
from tests.helpers import ROOT
from tests.helpers.slow_scene import Slow
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

NO_DISTANCE = {"surface"}
"""Kinds whose distance the slow reference does not know."""


def scene(folder: Path, kind: str, more: str = "") -> Scene:
    file = folder / f"{kind}.toml"
    file.write_text(
        f"name = 'only_{kind}'\nball_radius = 0.12\ngravity = 9.81\nrestitution = 0.5\n{more}\n"
        f"[bodies.it]\nkind = '{kind}'\n{BODIES[kind]}\n[ends.floor]\nat = -2\n"
    )
    return load_scene(file)


def test_every_kind_of_a_file_has_a_body_here() -> None:
    assert set(BODIES) == set(KINDS)
    assert set(BODIES) >= NO_POINT | NO_ROLLS | NO_DISTANCE


def test_every_kind_is_public_and_on_the_pages_for_users() -> None:
    reference, tour = (
        (ROOT / "docs" / page).read_text("utf-8")
        for page in ("reference/scenes.md", "your-own-scene.md")
    )
    elements = tour.partition("## Elements of a scene")[2].partition("\n## ")[0]
    with pytest.raises(SceneError) as refusal:
        Scene("none", bodies=[1], ball_radius=0.1, gravity=9.81, restitution=0.5)  # type: ignore[list-item]
    for kind, piece in KINDS.items():
        name = piece.__name__
        assert name in hoopgen.scene.__all__
        assert f".. autoclass:: {name}\n" in reference
        assert f"| `{kind}` |" in elements
        assert name in str(refusal.value)


@pytest.mark.parametrize("kind", BODIES)
def test_the_surfaces_of_every_kind_are_exported(tmp_path: Path, kind: str) -> None:
    for surface in scene(tmp_path, kind).derive().surfaces:
        assert type(surface).__name__ in surfaces.__all__


@pytest.mark.parametrize("kind", [kind for kind in BODIES if kind not in NO_DISTANCE])
def test_the_slow_reference_knows_the_distance_of_every_kind(tmp_path: Path, kind: str) -> None:
    found = scene(tmp_path, kind)
    derived, place = found.derive(), np.array([0.2, 0.05, 0.35])
    distances = [face.distance(place) for face in Slow(found).faces]
    assert np.isfinite(distances).all()
    if len(derived.surfaces) > 1:
        return  # the surfaces of a wall go on where the wall does not
    values = dict(zip((one.name for one in found.inputs), found.values(), strict=True))
    numbers = {symbol: values[symbol.name] for symbol in derived.symbols}
    numbers |= dict(zip(POSITION, place, strict=True))
    assert distances == [pytest.approx(float(derived.surfaces[0].distance.subs(numbers)))]


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
        found = scene(tmp_path, kind, "rolls = true")
        assert found.rolls
        assert all(surface.rolling_surface is not None for surface in found.derive().surfaces)


def test_a_ball_rolls_on_no_kind_that_is_not_known_to_have_a_rolling_surface() -> None:
    said = "on a saddle no ball is known to roll; expected none where rolls is true"
    assert why_not_rolling("saddle", []) == ("", said)


@pytest.mark.slow
@pytest.mark.parametrize("kind", BODIES)
def test_a_ball_meets_a_body_of_every_kind(tmp_path: Path, kind: str) -> None:
    engine = numpy_engine(scene(tmp_path, kind), tmp_path)
    shots = engine.simulate([[0.25, 0.02, 0.9, 0, 0, 0, 0, 0, 0]], fields=("first", "contacts"))
    assert shots.first[0] == 0
    assert shots.contacts[0] > 0
