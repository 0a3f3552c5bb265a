"""The page of a scene in air: its formulas, its statements, and no word of a parabola."""

from __future__ import annotations

import re
from functools import cache
from typing import Any

import pytest
from hoopgen.derive.model import Model, build
from hoopgen.derive.motion import air_piece, air_series
from hoopgen.derive.scenes.air import AIR
from hoopgen.derive.scenes.scene import Scene as DerivedScene

from hoopgen.codegen.derivation import PageData, derivation_context
from hoopgen.codegen.derivation.page_entries import FAMILY
from hoopgen.codegen.derivation.scene_notation import SceneNotation
from hoopgen.codegen.render import explanation
from hoopgen.scene import Box, Cylinder, End, Plane, Scene, Sphere
from tests.codegen.derivation.test_document import (
    anchors,
    assert_printed_as_meant,
    assert_whole,
    formulas_of,
)
from tests.helpers import ROOT

# One worker: the derivation takes a few seconds.
pytestmark = [pytest.mark.xdist_group("kernels"), pytest.mark.slow]

SCENES = ["air", "alley"]


def own_scene() -> Scene:
    """A wall, a box, a cylinder, and spheres that share their kernels, in air."""
    return Scene(
        "alley",
        ball_radius=0.05,
        gravity=9.81,
        restitution=0.6,
        bodies=[
            Plane("wall", axis="x", at=-1),
            *(Sphere(f"knob_{k}", radius=0.1, centre=(0.3, 0, k / 2)) for k in range(12)),
            Cylinder("rail", radius=0.02, axis="y", centre=(0.6, 0, 0)),
            Box("step", size=(0.5, 0.5, 0.5), centre=(0.3, 0, -1)),
        ],
        ends={"out": End(at=-2)},
        air=True,
    )


@cache
def derived(scene: str) -> DerivedScene:
    return AIR if scene == "air" else own_scene().derive()


@cache
def model(scene: str) -> Model:
    return build(derived(scene))


@cache
def data(scene: str) -> PageData:
    return derivation_context(model(scene))


@cache
def page(scene: str) -> str:
    return explanation(derived(scene))


@pytest.mark.parametrize("scene", SCENES)
def test_every_printed_formula_is_what_its_kernel_computes(scene: str) -> None:
    letters, count = SceneNotation(derived(scene)), 0
    known = {line.means: line.left for line in data(scene).brief.lines}
    for seed, formulas in enumerate(formulas_of(data(scene), known)):
        if formulas.lines:
            count += assert_printed_as_meant(formulas, letters, seed)
    assert count > 700, count


@pytest.mark.parametrize("scene", SCENES)
def test_every_kernel_is_in_the_table_and_every_link_leads_to_a_heading(scene: str) -> None:
    rows = re.findall(r"^\| \[?`(\w+)`(?:\]\(#\1\))? \| \[", page(scene), re.MULTILINE)
    assert rows == [kernel.name for kernel in model(scene).kernels]
    own = anchors(page(scene))
    assert set(re.findall(r"\(#([^)]*)\)", page(scene))) <= own
    assert [name for name in rows if name not in own and not FAMILY.fullmatch(name)] == []


@pytest.mark.parametrize("scene", SCENES)
def test_formulas_are_whole(scene: str) -> None:
    assert_whole(page(scene))


@pytest.mark.parametrize("scene", SCENES)
def test_every_lemma_is_proved_and_every_choice_says_where_it_is_tested(scene: str) -> None:
    parts = re.split(r"^#{2,4} ", page(scene), flags=re.M)
    lemmas = [part for part in parts if part.startswith("Lemma ")]
    choices = [part for part in parts if part.startswith("Choice ")]
    assert len(lemmas) > 12
    assert len(choices) > 3
    for part in lemmas:
        assert "*Proof" in part, part.splitlines()[0]
        assert r"$\square$" in part, part.splitlines()[0]
    for part in choices:
        assert "chosen" in part, part.splitlines()[0]
        assert re.search(r"`(?:tests/[\w/]+\.py|make \w+)`", part), part.splitlines()[0]
    for found in set(re.findall(r"`((?:tests|derive)/[\w/]+\.py)`", page(scene))):
        assert (ROOT / found).exists(), found


@pytest.mark.parametrize("scene", SCENES)
def test_no_word_is_of_a_flight_without_air(scene: str) -> None:
    """Parabolas are that below a gap, which the search steps along, and the one near a piece."""
    text = page(scene)
    assert re.findall(r"Eq\. 3|Eqs\. 3|apex|[Bb]ernstein|in contact\b.*series|F_a\b", text) == []
    assert "Arrival on a plane" not in text
    assert "Event polynomials" not in text
    for sentence in re.findall(r"[^.]*parabola[^.]*\.", text):
        assert re.search(
            r"step|root|gap|below|behind|margin|\bF\b|that parabola|the chord", sentence
        ), sentence


@pytest.mark.parametrize("scene", SCENES)
def test_numbers_of_the_text_are_those_of_the_derivation(
    scene: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    changed: dict[str, Any] = {"ORDER": 7, "TOLERANCE": 2**-31, "TUBE": 2**-9, "SHORTEST": 2**-11}
    told = data(scene).constants
    for name, value in changed.items():
        owner = air_piece if name in ("TOLERANCE", "SHORTEST") else air_series
        monkeypatch.setattr(owner, name, value)
    after = derivation_context(model(scene)).constants
    assert {name for name in told if told[name] != after[name]} == {
        *("piece_order", "piece_tolerance", "piece_tube", "shortest_piece")
    }
    for name in ("piece_order", "piece_tolerance", "piece_tube", "shortest_piece"):
        assert told[name] in page(scene)


def test_a_scene_has_the_statements_of_its_surfaces() -> None:
    assert "second derivative of the ring's gap along a piece" in page("air")
    assert "second derivative of the ring's gap along a piece" not in page("alley")
    assert "second derivative of a box's gap" in page("alley")
    assert "second derivative of a box's gap" not in page("air")
    assert "disjoint boxes" in page("alley")
