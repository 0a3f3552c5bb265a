"""Explanations of own scenes: their laws, numbers, letters and sections."""

from __future__ import annotations

import re
from functools import cache
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
import sympy as sp
from hoopgen.derive.contact.ball import Ball
from hoopgen.derive.contact.friction import CoulombFriction
from hoopgen.derive.contact.no_slip import NoSlip
from hoopgen.derive.scenes import COURT, HOOP
from hoopgen.derive.symbolic.letters import LAWS, SERIES
from hoopgen.derive.symbolic.notation import ARGUMENTS
from hoopgen.derive.symbolic.symbols import ParameterSymbol, normal, spin, velocity
from mpmath import mp, mpf

import hoopgen
from hoopgen.codegen.derivation.contacts import ContactText, FrictionText, contact_text
from hoopgen.codegen.derivation.premises import PREMISES
from hoopgen.codegen.derivation.scene_notation import SceneNotation, parameter_letters
from hoopgen.scene import Box, End, Parameter, Plane, Scene, Sphere
from tests.helpers import ROOT
from tests.helpers.effort import trials
from tests.helpers.latex_reader import read

pytestmark = pytest.mark.xdist_group("kernels")

EXAMPLES = ROOT / "examples" / "scenes"


def own_scene(**contact: Any) -> Scene:
    """Two spheres of the same number, a lively and a dull body, and a box off the origin."""
    return Scene(
        "alley",
        parameters=[
            Parameter("left_width", 0.25, summary="to the left"),
            Parameter("right_width", 0.25, summary="to the right"),
            Parameter("lively", 0.95, "1", "restitution of the bumper"),
        ],
        ball_radius=0.05,
        gravity=9.81,
        restitution=0.6,
        bodies=[
            Plane("wall_a", axis="x", at="-left_width"),
            Plane("wall_b", axis="-x", at="right_width"),
            Sphere("bumper", radius=0.1, centre=(0.3, 0, 0), restitution="lively", **contact),
            Sphere("knob", radius=0.1, centre=(0.3, 0, 0.5)),
            Box("step", size=(0.5, 0.5, 0.5), centre=(0.3, 0, -1)),
        ],
        ends={"out": End(at=-2)},
    )


@cache
def page(rough: bool = False) -> str:
    return own_scene(**({"friction": 0.4} if rough else {})).explain()


def laws(text: str) -> dict[str, list[str]]:
    """Return the table of laws: its cells, by body."""
    table = text[text.index("| body | law |") :].partition("\n\n")[0]
    rows = [[cell.strip() for cell in row.split("|")[1:-1]] for row in table.splitlines()[2:]]
    return {name: cells for name, *cells in rows}


def values(text: str) -> dict[str, str]:
    """Return the usual value of each parameter, by name."""
    rows = re.findall(r"^\| \$[^|]*\$ \| `(\w+)` \| [^|]* \| ([^|]*) \|", text, re.M)
    return {name: value.strip() for name, value in rows}


@pytest.mark.slow
def test_each_body_has_its_own_law_and_constants() -> None:
    found = laws(page())
    assert found["bumper"][1] == r"$e_{\mathrm{lively}}$"
    assert found["wall_a"][1] == found["wall_b"][1] == found["knob"][1] == "$e$"
    numbers = values(page())
    assert (numbers["lively"], numbers["restitution"]) == ("0.95", "0.6")
    golf = laws(hoopgen.load_scene(EXAMPLES / "golf.toml").explain())
    assert golf["green"][1] == golf["edge"][1] == r"$e_{\mathrm{turf}}$"
    assert golf["cup"][1] == r"$e_{\mathrm{cup}}$"


@pytest.mark.slow
def test_equal_numbers_of_two_bodies_stay_two() -> None:
    numbers = values(page())
    assert numbers["bumper_radius"] == numbers["knob_radius"] == "0.1"
    assert numbers["bumper_centre_x"] == numbers["knob_centre_x"] == "0.3"
    assert numbers["left_width"] == numbers["right_width"] == "0.25"
    assert numbers["inertia"] == "2/3"
    letters = re.findall(r"^\| \$([^|]*)\$ \| `(\w+)` \| [^|]* \| [\d.e/-]+ \|", page(), re.M)
    assert len({letter for letter, _ in letters}) == len(letters) == len(numbers)


@pytest.mark.slow
def test_one_number_of_the_scene_is_one() -> None:
    assert not [name for name in values(page()) if name.endswith("_restitution")]
    assert len(re.findall(r"`restitution` \| 1 \| 0\.6 \|", page())) == 1


@pytest.mark.slow
def test_numbers_are_the_decimals_that_the_scene_gives() -> None:
    """The distance from 0.3 to half of 0.5 is written 0.05, not as the doubles' difference."""
    assert 0.3 - 0.25 != 0.05
    numbers = values(page())
    assert (numbers["step_from_x"], numbers["step_to_x"]) == ("0.05", "0.55")
    assert not re.search(r"\d\.\d{12}", page())


@pytest.mark.slow
def test_what_engines_compute_with_is_not_changed_by_what_readers_are_told() -> None:
    scene = own_scene()
    inputs = {i.name: i.default for i in scene.inputs}
    assert inputs["step_from_x"] == 0.3 - 0.25
    scene.explain()
    assert {i.name: i.default for i in scene.inputs} == inputs
    assert "knob_radius" not in inputs


@pytest.mark.slow
def test_the_page_says_how_a_scene_of_one_s_own_is_made() -> None:
    assert "make generate" not in page()
    assert "hoopgen.load_scene" in page()
    assert "test_derive_document" not in page()
    from hoopgen.codegen.render import render_scene

    files = render_scene(own_scene().derive(), page=False)
    assert not [name for name, text in files.items() if "make generate" in text]


@pytest.mark.slow
def test_sizes_have_letters_and_not_words() -> None:
    for text in (page(), page(rough=True)):
        assert not re.search(r"\\text\{[a-z]+ (radius|width|at|centre|restitution)", text)
        for row in re.findall(r"^\| \$([^|]*)\$ \| `\w+` \| m \|", text, re.M):
            assert "\\text" not in row


@pytest.mark.slow
def test_no_section_is_empty() -> None:
    """Nor is there one of what a scene does not have."""
    bowl = hoopgen.load_scene(EXAMPLES / "bowl.toml").explain()
    for text in (page(), bowl):
        headings = list(re.finditer(r"^(#+) (.*)$", text, re.M))
        for here, after in pairwise(headings):
            between = text[here.end() : after.start()].strip()
            deeper = len(after[1]) > len(here[1])
            assert between or deeper, here[2]
    assert "Arrival on a plane" not in bowl
    assert "The ring's search" not in page()


# Letters


def test_one_letter_has_one_meaning() -> None:
    """But for a margin that is an argument under two names."""
    letters: dict[str, set[str]] = {}
    for name, letter in (ARGUMENTS | LAWS).items():
        letters.setdefault(letter.latex, set()).add(name)
    for name, letter in SERIES.items():
        if len(name) > 2:
            letters.setdefault(letter.latex, set()).add(name)
    shared = {latex: names for latex, names in letters.items() if len(names) > 1}
    assert shared == {r"m_\ell": {"tilt", "leaving_margin"}}
    held = {"D", "L", "R", "q", "V^2", "w", "M", "c"}
    assert not held & set(letters)
    assert not [latex for latex in letters if "/" in latex], "a name is no quotient"


def test_a_result_has_the_letter_of_what_it_is() -> None:
    """A time of closest approach has a time's letter, and a distance in contact a length's."""
    text = (ROOT / "generated" / "derivation.md").read_text("utf-8")
    meeting = text[text.index("#### plane_root") :].partition("#### ")[2].partition("#### ")[0]
    assert r"\check t &\leftarrow" in meeting
    assert ARGUMENTS["nearest"].latex not in meeting


@pytest.mark.parametrize("scene", [HOOP, COURT])
def test_parameters_have_letters_of_their_own(scene: Any) -> None:
    own = parameter_letters(scene)
    ours = {letter.latex for letter in ARGUMENTS.values()}
    assert len(set(own.values())) == len(own)
    assert not ours & set(own.values())


@pytest.mark.slow
def test_rolls_in_air_and_over_edges_are_explained() -> None:
    floor = Plane("floor", at=-0.5, within=["x"])
    given = {"bodies": [floor], "ball_radius": 0.05, "gravity": 9.81, "restitution": 0.3}
    assert ": edges\n" in Scene("windy_floor", **given, rolls=True, air=True).explain()


def test_a_letter_that_is_ours_is_not_a_parameter_s() -> None:
    scene = Scene(
        "pit",
        parameters=[Parameter("depth", 1.0, latex="T"), Parameter("depth_", 2.0)],
        ball_radius=0.05,
        gravity=9.81,
        restitution=0.5,
        bodies=[Sphere("ball", radius="depth", centre=("depth_", 0, 0))],
    ).derive()
    own = parameter_letters(scene)
    assert own["depth"] != "T"
    assert len(set(own.values())) == len(own)


# Contacts, as they are printed

BALL = ParameterSymbol("ball_radius", positive=True), ParameterSymbol("inertia", positive=True)


def printed(
    text: ContactText, law: Any, letters: SceneNotation, random: np.random.Generator
) -> None:
    """Compare a law with what a reader of the page computes, at a random motion."""
    rough = text.friction
    assert isinstance(rough, FrictionText)
    names: dict[str, mpf] = {}
    for size in set().union(*(e.free_symbols for e in _sizes(law))):
        names[letters(size)] = mpf(float(random.uniform(0.1, 0.9)))
    numbers = dict(zip((*velocity, *spin), random.normal(size=6), strict=True))
    n = random.normal(size=3)
    n /= np.linalg.norm(n)
    v, w = (np.array([numbers[s] for s in part]) for part in (velocity, spin))
    if v @ n > 0:
        v, n = v, -n
    # What a reader does with it.
    radius = names["R_B"]
    own = {
        key: read(str(_latex(size, letters)), names)
        for key, size in zip(("e_0", r"\mu", "e_t", "v_0"), _constants(law), strict=True)
    }
    v_n = mpf(float(v @ n))
    v_t = [mpf(float(a)) - v_n * mpf(float(b)) for a, b in zip(v, n, strict=True)]
    turned = [mpf(float(a)) for a in np.cross(w, n)]
    u = [a - read(rough.arm, names) * b for a, b in zip(v_t, turned, strict=True)]
    size = mp.sqrt(sum(a * a for a in u))
    known = names | own | {r"\lvert\mathbf{u}\rvert": size, r"\lvert v_n\rvert": -v_n}
    for line in rough.impulse.lines:
        known[line.left] = read(line.right, known)
    impulse, e = known[r"\lambda"], known["e"]
    along = [a / size for a in u]
    after = [
        t - impulse * a - e * v_n * mpf(float(b)) for t, a, b in zip(v_t, along, n, strict=True)
    ]
    cross = np.cross(n, [float(a) for a in along])
    spun = [
        mpf(float(a)) + read(rough.turned, names) * impulse * mpf(float(c))
        for a, c in zip(w, cross, strict=True)
    ]
    # What the kernels compute.
    moved = law.after(normal, velocity, spin, Ball(*BALL))
    inputs = dict(zip((*velocity, *spin, *normal), (*v, *w, *n), strict=True))
    for symbol in set().union(*(e.free_symbols for part in moved for e in part)):
        if isinstance(symbol, ParameterSymbol):
            inputs[symbol] = (
                float(radius) if symbol.name == "ball_radius" else float(names[letters(symbol)])
            )
    for exact, told in zip((*moved[0], *moved[1]), (*after, *spun), strict=True):
        value = float(sp.sympify(exact).subs(inputs).doit().subs(inputs))
        assert abs(value - float(told)) < 1e-12
    # And the energy: never more than before.
    lost = read(rough.lost.lines[0].right, known | {"e": e})
    inertia = read(text.inertia, names)
    energy = [
        sum(float(a) ** 2 for a in first)
        + float(inertia) * float(radius) ** 2 * sum(float(a) ** 2 for a in second)
        for first, second in ((v, w), (after, spun))
    ]
    assert abs((energy[1] - energy[0]) / 2 - float(lost)) < 1e-12
    assert lost <= 0


def _constants(law: CoulombFriction) -> tuple[sp.Expr, ...]:
    return law.restitution, law.friction, law.tangential, law.falling


def _sizes(law: CoulombFriction) -> tuple[sp.Expr, ...]:
    return (*_constants(law), *BALL)


def _latex(size: sp.Expr, letters: SceneNotation) -> str:
    return letters(size) if size.is_Symbol else str(sp.latex(size))


@pytest.mark.sampled(1)
@pytest.mark.parametrize("seed", range(trials(6)))
def test_coulombs_law_as_printed_is_what_the_kernels_compute(seed: int) -> None:
    """Slip, impulse, velocity, spin and energy, with the coefficients that the page prints."""
    letters = SceneNotation(COURT)
    law = COURT.bodies[0].law
    assert isinstance(law, CoulombFriction)
    printed(contact_text(COURT, letters), law, letters, np.random.default_rng(seed))


@pytest.mark.slow
def test_a_scene_s_page_has_no_law_that_it_has_not() -> None:
    assert "**Coulomb's friction.**" not in page()
    assert "**No slip.**" in page()
    assert {type(law) for law in HOOP.laws} == {NoSlip}
    assert contact_text(HOOP, SceneNotation(HOOP)).friction is None


@pytest.mark.slow
def test_a_scene_s_page_has_the_laws_that_it_has() -> None:
    assert "**Coulomb's friction.**" in page(rough=True)
    assert laws(page(rough=True))["bumper"][:3] == [
        "friction",
        r"$e_{\mathrm{lively}}$",
        r"$\mu_{\mathrm{bumper}}$",
    ]


# Statements


def test_every_lemma_is_proved_and_every_choice_says_where_it_is_tested() -> None:
    """On either page; the numbers of the court's page continue those of the hoop's."""
    pages = (ROOT / "generated" / name for name in ("derivation.md", "derivation_court.md"))
    text = "".join(page.read_text(encoding="utf-8") for page in pages)
    parts = re.split(r"^#{2,4} ", text, flags=re.M)
    lemmas = [part for part in parts if part.startswith("Lemma ")]
    choices = [part for part in parts if part.startswith("Choice ")]
    assert len(lemmas) > 25
    for part in lemmas:
        assert "*Proof" in part, part.splitlines()[0]
        assert r"$\square$" in part, part.splitlines()[0]
    for part in choices:
        assert "chosen" in part, part.splitlines()[0]
        assert re.search(r"`(?:tests/[\w/]+\.py|make \w+)`", part), part.splitlines()[0]
        assert "*Proof.*" not in part
    numbers = [int(n) for n in re.findall(r"^### (?:Lemma|Choice) (\d+):", text, re.M)]
    assert numbers == list(range(1, len(numbers) + 1))
    titles = {
        re.sub(r"^(?:Lemma|Choice) \d+: |^Definition: ", "", h)
        for h in re.findall(r"^### (.*)$", text, re.M)
    }
    assert titles <= {statement.title for statement in PREMISES.values()}


def test_tests_that_the_pages_name_exist() -> None:
    root = ROOT
    for name in ("derivation.md", "derivation_court.md"):
        text = (root / "generated" / name).read_text(encoding="utf-8")
        for found in set(re.findall(r"`((?:tests|derive)/[\w/]+\.py)`", text)):
            assert (root / found).exists(), found


@pytest.mark.slow
def test_a_turned_box_is_explained() -> None:
    """The matrix of its quaternion stands on the page, and on no page without such a box."""
    turned = Box("step", size=(0.5, 0.5, 0.5), orientation={"axis": (1, 2, 3), "angle": "30deg"})
    given: dict[str, Any] = {"ball_radius": 0.05, "gravity": 9.81, "restitution": 0.6}
    text = Scene("turned", bodies=[turned], ends={"out": End(at=-2)}, **given).explain()
    said = r"$\mathcal{R} \mathcal{R}^T = \lvert \mathbf{q} \rvert^4$ exactly"
    assert said in text
    assert "orientation" in text
    assert said not in page()
