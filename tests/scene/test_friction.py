"""Friction, tangential restitution and falling restitution of a body, as a user writes them."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy as sp
from hoopgen.derive.contact.friction import CoulombFriction
from hoopgen.derive.contact.no_slip import NoSlip

from hoopgen.codegen import render
from hoopgen.engine.native import Rejection
from hoopgen.scene import End, Parameter, Plane, Scene, SceneError, Sphere
from hoopgen.scene.files import parse_scene
from hoopgen.simulation.engine import Engine
from tests.helpers.compiled import load_module

PARAMETERS = (
    Parameter("ball", 0.05),
    Parameter("e", 0.7, "1"),
    Parameter("mu", math.inf, "1", infinite=True),
    Parameter("back", 0.1, "1", sign="any"),
    Parameter("v0", 30.0, "m/s", infinite=True),
)
FLOOR = Plane("floor", friction="mu", tangential="back", restitution_speed="v0")


def scene(*bodies: Any, **given: Any) -> Scene:
    usual = {
        "parameters": PARAMETERS,
        "ball_radius": "ball",
        "gravity": 9.81,
        "restitution": "e",
        "ends": {"out": End(at=-2.0)},
    }
    return Scene("own", bodies=bodies, **(usual | given))


def laws(made: Scene) -> list[Any]:
    return [body.law for body in made.derive().bodies]


def engine(made: Scene, folder: Path) -> Engine:
    """Return what simulates a scene on NumPy."""
    derived, name = made.derive(), f"numpy/{made.name}.py"
    path = folder / f"{made.name}.py"
    text = render.render_scene(derived, page=False, targets=["numpy"])[name]
    path.write_text(text, encoding="utf-8")
    return Engine(
        load_module(path),
        find=lambda: Rejection("is not wanted here", ""),
        sources=dict,
        scene=lambda: derived,
        written=made,
    )


# -- Which law


def test_a_body_that_says_nothing_of_friction_has_the_articles_law() -> None:
    """So has one that says what the article's law is."""
    plain = scene(Plane("floor"))
    (law,) = laws(plain)
    assert isinstance(law, NoSlip)
    said = scene(Plane("floor", friction=math.inf, tangential=0, restitution_speed=math.inf))
    assert laws(said) == [law]
    assert said.key == plain.key


def test_a_law_is_made_of_what_a_body_gives_and_the_scene() -> None:
    made = scene(
        FLOOR,
        Plane("wall", axis="x", at=-1, friction=0),
        Sphere("stone", radius=0.1, centre=(1, 1, 0), friction=math.inf, tangential=0),
        Plane("twin", axis="x", at=-2, friction=0),
        tangential="back",
    )
    floor, wall, stone, twin = laws(made)
    symbol = {p.name: p.symbol for p in made.derive().parameters}
    e, mu, back, v0 = (symbol[name] for name in ("e", "mu", "back", "v0"))
    assert floor == CoulombFriction("floor_impact", e, mu, back, v0)
    assert wall == CoulombFriction("wall_impact", e, sp.Integer(0), back, sp.oo)
    assert stone == NoSlip("stone_impact", e)
    assert twin is wall


def test_what_is_allowed_of_a_parameter_is_what_bodies_allow() -> None:
    """An infinite one only where it says so and every use of it allows it."""
    kept = {p.name: p for p in scene(FLOOR).derive().parameters}
    assert (kept["mu"].sign, kept["mu"].infinite, kept["mu"].upper) == ("nonnegative", True, None)
    assert (kept["v0"].sign, kept["v0"].infinite) == ("positive", True)
    back = kept["back"]
    assert (back.sign, back.lower, back.upper, back.infinite) == ("any", -1.0, 1.0, False)
    tame = (*PARAMETERS[:2], Parameter("mu", 0.3, "1"))
    one = {p.name: p for p in scene(Plane("floor", friction="mu"), parameters=tame).inputs}["mu"]
    assert (one.sign, one.infinite) == ("nonnegative", False)
    both = (*PARAMETERS[:2], Parameter("mu", 0.3, "1", infinite=True))
    bodies = (Plane("floor", friction="mu"), Sphere("stone", radius="mu"))
    one = {p.name: p for p in scene(*bodies, parameters=both).inputs}["mu"]
    assert not one.infinite
    e = (PARAMETERS[0], Parameter("e", 0.3, "1"))
    for body in (Plane("floor", tangential="e"), Plane("floor", restitution=1, tangential="e")):
        one = {p.name: p for p in scene(body, parameters=e).inputs}["e"]
        shared = body.restitution is None
        assert (one.sign, one.lower) == ("nonnegative" if shared else "any", -1.0)


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"friction": -0.1}, "body floor: friction: expected a number of at least 0, or inf, got"),
        ({"friction": math.nan}, "body floor: friction: expected a finite number, got nan"),
        ({"friction": -math.inf}, "body floor: friction: expected a finite number, got -inf"),
        ({"friction": "inf"}, "body floor: friction: 'inf': unknown name 'inf'"),
        ({"friction": True}, "body floor: friction: expected a number or a formula, got True"),
        ({"tangential": 1.1}, "tangential: expected a number of at least -1 and at most 1, got"),
        ({"tangential": -1.1}, "tangential: expected a number of at least -1 and at most 1, got"),
        ({"tangential": math.inf}, "body floor: tangential: expected a finite number, got inf"),
        ({"tangential": "mu"}, "body floor: tangential: mu is inf at the defaults"),
        ({"restitution_speed": 0}, "restitution_speed: expected a number above 0, or inf, got 0"),
        ({"restitution_speed": -1}, "restitution_speed: expected a number above 0, or inf, got"),
        ({"restitution": math.inf}, "body floor: restitution: expected a finite number, got inf"),
        ({"restitution": 1.1}, "restitution: expected a number of at least 0 and at most 1, got"),
        ({"at": "mu"}, "body floor: at: mu is inf at the defaults"),
    ],
)
def test_what_is_not_allowed_is_refused_with_body_and_argument(
    given: dict[str, Any], said: str
) -> None:
    with pytest.raises(SceneError) as refusal:
        scene(Plane("floor", **given))
    assert str(refusal.value).startswith("scene 'own': ")
    assert said in str(refusal.value)


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"default": math.inf}, "parameter mu: default: expected a finite number, got inf"),
        ({"default": -math.inf, "infinite": True}, "default: expected a finite number, got -inf"),
        ({"default": math.nan, "infinite": True}, "default: expected a finite number, got nan"),
        ({"default": 1, "infinite": 1}, "parameter mu: infinite: expected true or false, got 1"),
        ({"default": math.inf, "infinite": True, "upper": 2}, "at most 2, or inf, got inf"),
    ],
)
def test_an_infinite_parameter_says_so(given: dict[str, Any], said: str) -> None:
    with pytest.raises(SceneError) as refusal:
        scene(Plane("floor"), parameters=(*PARAMETERS[:2], Parameter("mu", unit="1", **given)))
    assert said in str(refusal.value)


# -- In files

FILE = """\
name = "own"
ball_radius = "ball"
gravity = 9.81
restitution = "e"

[parameters]
ball = 0.05
e = { default = 0.7, unit = "1" }
mu = { default = inf, unit = "1", infinite = true }
back = { default = 0.1, unit = "1", sign = "any" }
v0 = { default = 30.0, unit = "m/s", infinite = true }

[bodies.floor]
kind = "plane"
friction = "mu"
tangential = "back"
restitution_speed = "v0"

[bodies.wall]
kind = "plane"
axis = "x"
at = -1
friction = inf
restitution_speed = inf

[ends.out]
at = -2.0
"""


def test_a_file_says_the_same() -> None:
    read = parse_scene(FILE.encode())
    assert read.key == scene(FLOOR, Plane("wall", axis="x", at=-1)).key
    assert read.defaults["mu"] == math.inf


# -- What it does


@pytest.fixture(scope="module")
def sliding(tmp_path_factory: pytest.TempPathFactory) -> Engine:
    return engine(scene(FLOOR), tmp_path_factory.mktemp("sliding"))


def thrown(shots: int) -> Any:
    """Return balls that come down on the floor along x, without spin."""
    states = np.zeros((shots, 9))
    states[:, 2], states[:, 3], states[:, 5] = 0.05 + 1e-9, 3.0, -2.0
    return states


@pytest.mark.slow
def test_each_shot_has_its_own_friction_infinite_ones_too(sliding: Engine) -> None:
    """Calculated by hand: 3 m/s of slip against mu (1 + e) 2 m/s; gripping takes 2/5 (1 + e_t)."""
    mu = np.array([0.0, 0.1, 0.3, 1.0, np.inf, -0.1, np.nan])
    shots = sliding.simulate(
        thrown(7), {"mu": mu, "v0": np.inf}, max_contacts=1, record=True, time_limit=1.0
    )
    assert (shots.outcome == sliding.outcomes["INVALID"]).tolist() == [False] * 5 + [True] * 2
    first = shots.events["after"][np.diff(shots.events["shot"], prepend=-1) != 0]
    lost = np.minimum(mu[:5] * 1.7 * 2.0, 0.44 * 3.0)
    np.testing.assert_allclose(first[:, 3], 3.0 - lost, rtol=0, atol=1e-8)
    np.testing.assert_allclose(first[:, 7], 1.5 * lost / 0.05, rtol=0, atol=1e-6)
    np.testing.assert_allclose(first[:, 5], 1.4, rtol=0, atol=1e-8)
    assert sliding.certify(thrown(5), {"mu": mu[:5]}, max_contacts=3, time_limit=1.0).decided.all()


def test_a_number_for_all_that_is_not_within_its_limits_is_refused(sliding: Engine) -> None:
    """A parameter limited by its sign alone makes rows invalid instead."""
    with pytest.raises(ValueError, match=r"parameters\['back'\]: expected -1 to 1, got 1.5"):
        sliding.simulate(thrown(1), {"back": 1.5})
    with pytest.raises(ValueError, match=r"parameters\['back'\]: expected -1 to 1, got 1.5"):
        sliding.certify(thrown(1), {"back": 1.5})
    for name, value in (("mu", -1.0), ("mu", math.nan), ("v0", 0.0)):
        shots = sliding.simulate(thrown(2), {name: value}, time_limit=1.0)
        assert (shots.outcome == sliding.outcomes["INVALID"]).all(), name


@pytest.mark.slow
def test_infinite_parameters_of_results_are_kept_in_strict_json(sliding: Engine) -> None:
    shots = sliding.simulate(thrown(2), time_limit=1.0)
    assert shots.parameters["mu"] == math.inf

    def refuse(word: str) -> None:
        raise AssertionError(f"{word} is no JSON")

    written = shots.to_xarray().attrs["parameters"]
    assert json.loads(written, parse_constant=refuse)["mu"] == "inf"
