"""The page on scenes of one's own says what happens."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from hoopgen.derive.contact.friction import CoulombFriction

from hoopgen.scene import SceneError, compilers, load_scene
from hoopgen.scene.files import parse_scene
from tests.helpers import ROOT

pytestmark = pytest.mark.slow


PAGE = (ROOT / "docs" / "your-own-scene.md").read_text(encoding="utf-8")


def blocks(language: str) -> list[str]:
    return re.findall(rf"^```{language}(?: \S+)?\n(.*?)^```", PAGE, re.MULTILINE | re.DOTALL)


HOLE, SLIDE, HOURGLASS, CABIN, FRICTION = blocks("toml")


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with the page's file, in which nothing is compiled."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    monkeypatch.setattr(compilers, "compiler", lambda: None)
    Path("hole.toml").write_text(HOLE, encoding="utf-8")
    return tmp_path


@pytest.mark.filterwarnings("ignore:hoopgen")
def test_the_page_s_code_runs_from_the_first_line_to_the_proof(folder: Path) -> None:
    found: dict[str, object] = {}
    first, second, study, edges, on_table = blocks("python")
    exec(first, found)
    holed = found["holed"]
    assert 0 < holed.sum() < holed.size  # type: ignore[attr-defined]
    assert str(found["page"]).startswith("# The derivation of hole")
    exec(second, found)
    assert found["scene"].key == load_scene("hole.toml").key  # type: ignore[attr-defined]
    exec(study, found)
    exec(edges, found)
    assert not found["shot"].uncertain.any()  # type: ignore[attr-defined]
    exec(on_table, found)
    assert 0 < found["found"].shares["holed"] < 1  # type: ignore[attr-defined]


@pytest.mark.parametrize(
    ("was", "written"),
    [
        ("default = 0.054", "default = 0.02"),
        ("radius**2 - x**2 - y**2", "radius - sqrt(x**2 + y**2)"),
        ('radius = "radius"', 'radius = "raduis"'),
    ],
)
def test_what_the_page_says_of_a_wrong_scene_is_said(folder: Path, was: str, written: str) -> None:
    path = folder / "hole.toml"
    text = path.read_text(encoding="utf-8")
    assert was in text
    path.write_text(text.replace(was, written), encoding="utf-8")
    with pytest.raises(SceneError) as refusal:
        load_scene("hole.toml")
    said = [
        line.strip().removesuffix("…")
        for line in PAGE.splitlines()
        if line.startswith("    scene ")
    ]
    assert any(str(refusal.value).startswith(f"hole.toml: {one}".rstrip()) for one in said)


def test_what_the_page_says_of_friction_is_a_scene() -> None:
    made = parse_scene(f'name = "own"\nball_radius = 0.1\ngravity = 9.81\n{FRICTION}'.encode())
    (law,) = made.derive().laws
    assert isinstance(law, CoulombFriction)
    said = (law.restitution, law.friction, law.tangential, law.falling)
    named = {i.name: i.default for i in made.inputs}
    assert [named[symbol.name] for symbol in said] == [0.8, 0.4, 0.1, 40.0]
    assert made.values({"mu": float("inf")})[0] == float("inf")


def test_the_page_s_surfaces_of_revolution_are_a_scene() -> None:
    derived = parse_scene(HOURGLASS.encode()).derive()
    names = {surface.name for surface in derived.surfaces}
    assert [body.name for body in derived.bodies] == ["glass", "cup", "bell"]
    assert {"glass_inside_2", "glass_edge_3", "cup_outside_1", "bell_inside_1"} <= names


def test_the_page_s_inclined_bodies_are_a_scene(tmp_path: Path) -> None:
    path = tmp_path / "slide.toml"
    path.write_text(SLIDE, encoding="utf-8")
    made = load_scene(path)
    assert [body.name for body in made.bodies] == re.findall(r"^\[bodies\.(\w+)\]", SLIDE, re.M)
