"""Scenes of one's own as data: read without SymPy, refused with the body and the argument."""

from __future__ import annotations

import contextlib
import subprocess
import sys
from typing import Any

import numpy as np
import pytest
from hoopgen.derive.scenes import names
from hypothesis import given, settings
from hypothesis import strategies as st

from hoopgen.scene import (
    Box,
    Cylinder,
    End,
    Parameter,
    Plane,
    Scene,
    SceneError,
    Sphere,
    Surface,
    Torus,
    load_scene,
)
from hoopgen.scene import names as scene_names
from hoopgen.scene.files import parse_scene
from tests.helpers.effort import trials

FLOOR = Plane("floor")
PARAMETERS = (
    Parameter("ball", 0.05),
    Parameter("width", 1.5),
    Parameter("e", 0.7, "1"),
)


def scene(*bodies: Any, **given: Any) -> Scene:
    """Return a scene of these bodies, the rest as usual."""
    usual = {
        "parameters": PARAMETERS,
        "ball_radius": "ball",
        "gravity": 9.81,
        "restitution": "e",
        "ends": {"out": End(at=-2.0)},
    }
    return Scene("own", bodies=bodies, **(usual | given))


def by_name(made: Scene) -> dict[str, Any]:
    return {i.name: i for i in made.inputs}


def test_a_size_is_a_parameter_or_an_input_of_its_own() -> None:
    """Numbers and formulas are computed before a shot; one that is there already is shared."""
    made = scene(
        Sphere("stone", radius="width/3", centre=(0.5, "-width", 0)),
        Sphere("twin", radius="width / 3", centre=("width", "-width", 0.5)),
    )
    inputs = by_name(made)
    assert list(inputs)[:3] == ["ball", "width", "e"]
    assert [i for i in inputs if i.startswith(("stone", "twin"))] == [
        "stone_radius",
        "stone_centre_x",
        "stone_centre_y",
        "twin_centre_z",
    ]
    assert [name for name, i in inputs.items() if i.own] == ["ball", "width", "e"]
    assert inputs["stone_radius"].default == 0.5
    stone, twin = made.read.bodies
    assert str(stone["centre z"]) == "0"
    assert stone["radius"] == twin["radius"]
    assert str(twin["centre x"]) == "width"
    assert twin["centre y"] == stone["centre y"]


def test_the_values_are_those_of_the_shots_parameters() -> None:
    """A parameter that is left out has its default; each shot may have its own value."""
    made = scene(Plane("wall", axis="x", at="-width/2"), FLOOR)
    width = np.array([1.0, 2.0, np.nan])
    values = dict(zip(by_name(made), made.values({"width": width}), strict=True))
    assert list(values["wall_at"][:2]) == [-0.5, -1.0]
    assert np.isnan(values["wall_at"][2])
    assert values["ball"] == 0.05
    assert made.values() == [i.default for i in made.inputs]
    with pytest.raises(ValueError, match=r"unknown widht\. The names are ball, width, e$"):
        made.values({"widht": 1.0})
    with pytest.raises(ValueError, match="unknown wall_at"):
        made.values({"wall_at": 1.0})
    with pytest.raises(TypeError, match="expected a mapping"):
        made.values([1.0])  # type: ignore[arg-type]


def test_a_restitution_holds_its_parameter_to_what_it_may_be() -> None:
    made = by_name(scene(FLOOR, Plane("lid", axis="-z", at=-3, restitution=0)))
    assert (made["e"].sign, made["e"].upper) == ("nonnegative", 1.0)
    assert made["ball"].sign == "positive"


def test_a_bound_of_a_curved_body_is_asked_where_it_is_touched() -> None:
    """A sphere cut off at a height: the ball that touches the rim has its centre further out."""
    made = scene(Sphere("cap", radius=0.5, centre=(0, 0, "-width"), within=["-1.2 - z"]))
    (bound,) = made.read.bodies[0].bounds
    values = dict(zip(by_name(made), made.values(), strict=True))
    rim = np.array([0.0, 0.4, 0.3])  # from the centre, on the sphere
    centre = rim * (0.5 + 0.05) / 0.5 + [0.0, 0.0, -1.5]
    assert sum(
        float(factor.evaluate(values)) * np.prod(centre ** np.array(powers))
        for powers, factor in bound
    ) == pytest.approx(0.0, abs=1e-15)


def test_a_scene_is_the_same_as_another_written_so() -> None:
    one, other = (scene(FLOOR, Torus("ring", radius=0.3, wire="0.01")) for _ in range(2))
    assert one.key == other.key
    assert hash(one) == hash(other)
    assert one.key != scene(FLOOR, Torus("ring", radius=0.3, wire="0.02")).key
    assert one.key != scene(FLOOR, Torus("ring", radius=0.3, wire="0.01"), down="z").key


def test_names_are_those_that_derivation_allows() -> None:
    assert scene_names.PUBLIC.pattern == names.PUBLIC.pattern


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"name": "Own scene"}, "name: expected a small letter"),
        ({"parameters": {"a": 1}}, "parameters: expected a list"),
        ({"parameters": [("a", 1)]}, "parameters: expected Parameter, got ('a', 1)"),
        ({"parameters": [Parameter("x", 1)]}, "parameter x: name: x is a coordinate in formulas"),
        ({"parameters": [Parameter("a b", 1)]}, "parameter 'a b': name: expected"),
        ({"parameters": [Parameter("a", 1), Parameter("a", 2)]}, "parameter a: name: 2 have"),
        ({"parameters": [Parameter("a", -1)]}, "parameter a: default: expected a number above 0"),
        ({"parameters": [Parameter("a", 2, upper=1)]}, "above 0 and at most 1, got 2"),
        ({"parameters": [Parameter("a", "b")]}, "parameter a: default: 'b': unknown name 'b'"),
        ({"parameters": [Parameter("a", 1, sign="+")]}, "parameter a: sign: expected positive"),
        (
            {"ball_radius": "bal"},
            "ball_radius: 'bal': unknown name 'bal'; there are ball, e, width",
        ),
        ({"ball_radius": 0}, "ball_radius: expected a number above 0, got 0"),
        ({"gravity": "-ball"}, "gravity: expected a number above 0"),
        ({"down": "down"}, "down: expected one of x, y, z, -x, -y, -z; got 'down'"),
        ({"bodies": FLOOR}, "bodies: expected a list"),
        ({"bodies": [1]}, "bodies: expected Plane, Sphere"),
        ({"bodies": [FLOOR, FLOOR]}, "body floor: name: 2 have this name"),
        ({"bodies": [Plane("Floor")]}, "body 'Floor': name: expected"),
        ({"ends": [End()]}, "ends: expected names and ends"),
        ({"ends": {"goal": FLOOR}}, "ends: expected End"),
        ({"ends": {"Goal": End()}}, "end 'Goal': name"),
        ({"ends": {"goal": End(within="x")}}, "end goal: within: expected a list"),
        ({"ends": {"goal": End(within=["sqrt(x) - 1"])}}, "end goal: within 1: not polynomial"),
        ({"restitution": None}, "body floor: restitution: missing"),
        ({"restitution": 1.5}, "body floor: restitution: expected a number of at least 0 and"),
    ],
)
def test_what_is_wrong_with_a_scene_is_said(given: dict[str, Any], said: str) -> None:
    usual = {
        "name": "own",
        "parameters": PARAMETERS,
        "ball_radius": "ball",
        "gravity": 9.81,
        "restitution": "e",
        "bodies": [FLOOR],
    }
    if "parameters" in given:
        usual["ball_radius"] = 0.1
    with pytest.raises(SceneError) as refusal:
        Scene(**(usual | given))
    assert said in str(refusal.value)


@pytest.mark.parametrize(
    ("body", "said"),
    [
        (Plane("wall", axis="w"), "axis: expected one of x"),
        (Plane("wall", at="hight"), "at: 'hight': unknown name"),
        (Plane("wall", at="1/(ball - ball)"), "at: '1/(ball - ball)': division by zero"),
        (Plane("wall", at="sqrt(ball - width)"), "at: sqrt"),
        (Plane("wall", within="x"), "within: expected a list of formulas, got 'x'"),
        (Plane("wall", within=["x", "width"]), "within 2: width has none of x, y, z"),
        (Plane("wall", within=["x", "1/y"]), "within 2: not polynomial"),
        (Plane("wall", within=["sqrt(x**2 + y**2) - 1"]), "within 1: not polynomial"),
        (Plane("wall", restitution="-e"), "restitution: expected a number of at least 0"),
        (Plane("wall", restitution=True), "restitution: expected a number or a formula"),
        (Sphere("wall", radius=0), "radius: expected a number above 0, got 0"),
        (Sphere("wall", radius=1, centre=(0, 0)), "centre: expected three sizes"),
        (Sphere("wall", radius=1, centre=(0, "q", 0)), "centre y: 'q': unknown"),
        (
            Sphere("wall", radius=0.04, inside=True),
            "radius: the ball does not fit inside: expected more than 0.05, got 0.04",
        ),
        (Sphere("wall", radius=1, inside="yes"), "inside: expected true or false"),
        (Cylinder("wall", radius="-width"), "radius: expected a number above 0, got -1.5"),
        (
            Cylinder("wall", radius=1, span=(1, 0)),
            "span: expected the lower end first; it ends at 0 before 1",
        ),
        (Cylinder("wall", radius=1, span=3), "span: expected two ends"),
        (Torus("wall", radius=1, wire=-0.1), "wire: expected a number of at least 0, got -0.1"),
        (
            Torus("wall", radius=0.06, wire=0.02),
            "radius: the ball does not fit through: expected more than 0.07, got 0.06",
        ),
        (Torus("wall", radius=1, within=["sqrt(x)"]), "within 1: not polynomial"),
        (Box("wall", size=(1, 1, 1), within="x"), "within: expected a list of formulas"),
        (Box("wall", size=(1, 0, 1)), "size y: expected a number above 0, got 0"),
        (Box("wall", size=1), "size: expected three sizes"),
        (Surface("wall", condition="ball"), "condition: ball has none of x, y, z"),
        (Surface("wall", condition="x/y"), "condition: not polynomial"),
        (Surface("wall", condition="q*x"), "condition: 'q*x': unknown name 'q'"),
    ],
)
def test_a_refusal_names_the_body_and_the_argument(body: Any, said: str) -> None:
    with pytest.raises(SceneError) as refusal:
        scene(FLOOR, body)
    assert str(refusal.value).startswith("scene 'own': body wall: ")
    assert said in str(refusal.value)


@pytest.mark.parametrize("radius", [0.05, "ball", "ball + width/100"])
def test_a_condition_names_the_ball_s_radius(radius: float | str) -> None:
    """The name means the radius of the scene, as if that were written there."""
    named, written = (
        scene(Surface("ramp", condition=f"z - x**2/4 - ({said})"), ball_radius=radius)
        for said in ("ball_radius", radius)
    )
    assert named.read == written.read


def test_readers_see_computed_numbers_as_decimals() -> None:
    plate = Plane("plate", normal=(-1, 0, 2), within=["x**2 + y**2 - 1/9"])
    said = [one.summary for one in scene(plate)._read(as_written=True).inputs]
    assert "within 1 x of body plate: 0.8944271909999159*ball" in said
    assert "within 1 of body plate: 0.19999999999999996*ball**2 - 1/9" in said


def test_a_parameter_called_ball_radius_is_that_parameter_in_a_condition() -> None:
    made = scene(
        Surface("ramp", condition="z - ball_radius"),
        parameters=(*PARAMETERS, Parameter("ball_radius", 0.3)),
    )
    assert [one.default for one in made.inputs if not one.own and "ramp" in one.name] == [-0.3]


# Files

FILE = """
name = "own"
ball_radius = "ball"
gravity = 9.81
restitution = "e"

[parameters]
ball = { default = 0.05, summary = "radius of the ball" }
width = 1.5
e = { default = 0.7, unit = "1" }

[bodies.floor]
kind = "plane"
within = ["x - width"]

[bodies.post]
kind = "cylinder"
radius = 0.1
centre = ["width/2", 0, 0]
span = ["", 1.0]
restitution = 0.5

[ends.out]
at = -2.0
"""


def test_a_file_says_what_a_scene_says(tmp_path: Any) -> None:
    path = tmp_path / "own scene.toml"
    path.write_text(FILE, encoding="utf-8")
    parameters = (Parameter("ball", 0.05, summary="radius of the ball"), *PARAMETERS[1:])
    expected = scene(
        Plane("floor", within=["x - width"]),
        Cylinder("post", radius=0.1, centre=("width/2", 0, 0), span=(None, 1.0), restitution=0.5),
        parameters=parameters,
    )
    assert load_scene(path).key == expected.key
    assert load_scene(str(path)) == load_scene(path)


@pytest.mark.parametrize(
    ("was", "written", "said"),
    [
        ('"own"', "own", "this is not TOML: "),
        ('name = "own"\n', "", "name: missing"),
        ('name = "own"', "name = 3", "name: expected a small letter"),
        ("gravity = 9.81\n", "", "gravity: missing"),
        ("gravity", "gravitas", "unknown gravitas. There are name, parameters, bodies"),
        (
            "[ends.out]",
            "[scene]\ninertia = 1\n[ends.out]",
            "'own': unknown table [scene]. There are",
        ),
        ('name = "own"', "[scene]\nname = 'own'", "own.toml: unknown table [scene]. There are"),
        ('kind = "plane"', 'kind = "plan"', "body floor: kind: expected one of plane, sphere"),
        ('kind = "plane"\n', "", "body floor: kind: expected one of"),
        ("radius = 0.1\n", "", "body post: radius: missing"),
        ("radius = 0.1", "radius = 0.1\nheight = 3", "body post: unknown height. There are rest"),
        ("radius = 0.1", "radius = inf", "body post: radius: expected a finite number, got inf"),
        ("radius = 0.1", "radius = 2020-01-01", "body post: radius: expected a number or a form"),
        ("radius = 0.1", 'radius = "__import__(1)"', "body post: radius: '__import__(1)': unknown"),
        ("width = 1.5", 'width = "ball"', "parameter width: default: 'ball': unknown name 'ball'"),
        ("width = 1.5", "width = [1]", "parameter width: default: expected a number"),
        ("[ends.out]", "[ends]", "end at: expected a table, got -2.0"),
        ("[bodies.floor]", "[bodies.floor.deep]", "body floor: kind: expected"),
        ("at = -2.0", "at = -2.0\nname = 'x'", "end out: unknown name"),
    ],
)
def test_a_wrong_file_is_refused_by_its_name(
    tmp_path: Any, was: str, written: str, said: str
) -> None:
    path = tmp_path / "own.toml"
    assert was in FILE
    path.write_text(FILE.replace(was, written), encoding="utf-8")
    with pytest.raises(SceneError) as refusal:
        load_scene(path)
    assert str(refusal.value).startswith(f"{path}: ")
    assert said in str(refusal.value)


@settings(max_examples=trials(150), deadline=None)
@given(st.data())
def test_a_mangled_file_is_a_scene_or_refused(data: Any) -> None:
    """Whatever is put for some of its text, and cut from it: no other exception."""
    at = data.draw(st.integers(0, len(FILE)))
    cut = data.draw(st.integers(0, 8))
    put = data.draw(
        st.sampled_from(["", '"', "[", "]", "=", "nan", "-", "9" * 5000, "[[[", "é", "'"])
    )
    text = FILE[:at] + put + FILE[at + cut :]
    content = text.encode() + data.draw(st.sampled_from([b"", b"\xff", b"\x00"]))
    with contextlib.suppress(SceneError):
        parse_scene(content)


def test_what_is_too_large_or_nested_too_deep_is_refused() -> None:
    with pytest.raises(SceneError, match="at most 1,000,000 bytes"):
        parse_scene(b"#" * 1_000_001)
    with pytest.raises(SceneError, match="not TOML"):
        parse_scene(b"a = " + b"[" * 100_000)


def test_reading_a_scene_file_imports_no_sympy(tmp_path: Any) -> None:
    path = tmp_path / "own.toml"
    path.write_text(FILE, encoding="utf-8")
    code = (
        "import sys; from hoopgen.scene import load_scene\n"
        f"scene = load_scene({str(path)!r}); scene.values(); scene.key\n"
        "assert not {'sympy', 'jinja2', 'matplotlib'} & set(sys.modules)"
    )
    subprocess.run([sys.executable, "-c", code], check=True, timeout=60)


def test_a_scene_without_a_body_is_refused() -> None:
    with pytest.raises(SceneError, match="bodies: expected at least one, got none"):
        Scene("empty", bodies=[], ball_radius=0.1, gravity=9.81, restitution=0.5)
