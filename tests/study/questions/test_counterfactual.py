"""The smallest changes with which shots end otherwise: found, next to each other, proved."""

from __future__ import annotations

import json
import math
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.helpers.commands import RELEASE, failure, output, succeed

pytest.importorskip("scipy")
pytest.importorskip("pyarrow")

import hoopgen
from hoopgen.core.units import use_units
from hoopgen.hoop.arguments import arguments_of
from hoopgen.scene import End, Parameter, Plane, Scene
from hoopgen.study.questions.counterfactual import simulated_like
from hoopgen.study.questions.counterfactual_result import Change, Counterfactual
from hoopgen.study.questions.one_variable import OneShot

DEGREE = np.pi / 180
PLACE: dict[str, Any] = {"height": 2.1336, "distance": 4.191}

WALL = Scene(
    "wall",
    parameters=[Parameter("gap", 0.3)],
    ball_radius=0.1,
    gravity=10.0,
    restitution=0.5,
    bodies=[Plane("wall", axis="x", at=-1.0)],
    ends={"near": End(at=-2.0, within=["x - gap"]), "far": End(at=-2.0)},
)
"""A ball is dropped beside a wall; it ends near to it if x is at most gap."""


def throw(speed: float, elevation: float = 51.0, **others: Any) -> hoopgen.Shots:
    return hoopgen.simulate(hoopgen.release(speed, elevation * DEGREE, **others, **PLACE))


def change(answer: Counterfactual, name: str) -> Change:
    (found,) = (one for one in answer.changes if one.name == name)
    return found


def test_a_miss_without_contacts_is_made_where_the_ball_clears_the_ring() -> None:
    """With 5 contacts or fewer and no chaos: what lies on both sides is simulated again."""
    answer = hoopgen.counterfactual(throw(7.3), prove=False)
    assert not answer.succeeds
    found = change(answer, "speed")
    for speed, made in ((found.unchanged, False), (found.changed, True), (found.value, False)):
        assert bool(throw(speed).made[0]) is made
    assert 0.0 < found.unchanged - found.changed < 1e-4
    assert found.outcome == "made"
    # From there on the shot is made for a twentieth of the change at least, at all values tried.
    beyond = np.linspace(found.changed, found.changed + 0.05 * found.amount, 200)
    states = hoopgen.release(beyond, 51 * DEGREE, **PLACE)
    shots = hoopgen.simulate(states, fields=["outcome", "uncertain"])
    assert np.mean(shots.made | shots.uncertain) > 0.9


def test_values_between_a_shot_and_its_nearest_change_end_as_it_does() -> None:
    made = throw(7.17, 52.0, backspin=18.0)
    assert made.made[0]
    answer = hoopgen.counterfactual(made, steady=0.0, prove=False)
    random = np.random.default_rng(1)
    own = {name: float(value[0]) for name, value in arguments_of(made.releases).items()}
    for one in answer.changes:
        within = one.value + random.random(4000) * 0.999 * (one.unchanged - one.value)
        shots = hoopgen.simulate(hoopgen.release(**(own | {one.name: within})))
        assert np.mean(shots.made | shots.uncertain) > 0.999


def test_the_very_nearest_change_is_no_further_than_a_steady_one() -> None:
    shots = throw(7.1)
    near = change(hoopgen.counterfactual(shots, steady=0.0, prove=False), "speed")
    steady = change(hoopgen.counterfactual(shots, steady=0.5, prove=False), "speed")
    assert abs(near.amount) < abs(steady.amount)


@pytest.mark.slow
@pytest.mark.parametrize("scene", [hoopgen.HOOP, hoopgen.COURT], ids=["hoop", "court"])
def test_both_sides_are_proved(scene: Any) -> None:
    pytest.importorskip("flint")
    states = hoopgen.release(7.3, 51 * DEGREE, backspin=12.0, **PLACE)
    answer = hoopgen.counterfactual(hoopgen.simulate(states, scene=scene))
    assert answer.proved is True
    assert "Proved in ball arithmetic" in str(answer)
    found = [one for one in answer.changes if one.outcome]
    assert found
    assert all(one.proved is True for one in found)
    own = {name: float(value[0]) for name, value in arguments_of(states[None]).items()}
    for one in found:
        sides = np.array([one.unchanged, one.changed])
        proof = hoopgen.certify(hoopgen.release(**(own | {one.name: sides})), scene=scene)
        assert proof.decided.all()
        assert (proof.outcome == scene.outcomes["MADE"]).tolist() == [False, True]


@pytest.mark.slow
def test_where_nothing_chaotic_happens_the_change_is_exact() -> None:
    """A ball that falls past the wall ends near to it while x <= gap: the edge is known."""
    engine = hoopgen.compile(WALL)
    state = np.array([0.25, 0, 0, 0, 0, 0, 0, 0, 0], float)
    answer = hoopgen.counterfactual(
        engine.simulate(state), vary=["x", "vx", "gap"], steady=0.0, prove=False
    )
    assert answer.end == "near"
    assert answer.succeeds
    fallen = math.sqrt(2 * 2.0 / 10.0)
    for name, edge in (("x", 0.3), ("vx", 0.05 / fallen), ("gap", 0.25)):
        found = change(answer, name)
        assert found.changed == pytest.approx(edge, rel=1e-9)
        assert found.unchanged == pytest.approx(edge, rel=1e-9)
        assert found.outcome == "far"


@pytest.mark.slow
def test_another_end_can_count() -> None:
    engine = hoopgen.compile(WALL)
    shots = engine.simulate([0.25, 0, 0, 0, 0, 0, 0, 0, 0])
    answer = hoopgen.counterfactual(shots, vary=["vx"], by="far", prove=False)
    assert not answer.succeeds
    assert answer.sentence.startswith("The shot is near. It is far with ")


def test_a_shot_of_many_with_its_own_parameters() -> None:
    states = hoopgen.release([7.17, 7.3], 51 * DEGREE, **PLACE)
    shots = hoopgen.simulate(states, hoopgen.PAPER | {"restitution": np.array([0.5, 0.7])})
    answer = hoopgen.counterfactual(shots, -1, ["speed", "restitution"], prove=False)
    alone = hoopgen.counterfactual(throw(7.3), vary=["speed", "restitution"], prove=False)
    assert answer.as_dict() == alone.as_dict()
    assert change(answer, "restitution").value == 0.7


def test_spin_along_the_flight_turns_with_it() -> None:
    """`release` has no argument for this part of the spin; it is kept, and its axis turned."""
    states = hoopgen.release(7.3, 51 * DEGREE, 0.02, **PLACE)
    states[6:8] += 9.0 * states[3:5] / np.hypot(*states[3:5])
    answer = hoopgen.counterfactual(hoopgen.simulate(states), prove=False)
    for one in answer.shots.releases:
        assert one[6:8] @ one[3:5] / np.hypot(*one[3:5]) == pytest.approx(9.0)


def test_the_answer_in_words_numbers_and_a_picture() -> None:
    answer = hoopgen.counterfactual(throw(7.3), prove=False)
    assert answer.sentence.startswith("The shot is missed. It is made with 0.0")
    assert " m/s less speed" in answer.sentence
    with use_units("us"):
        assert " mph less speed" in answer.sentence
    record = json.loads(json.dumps(answer.as_dict()))
    assert [one["name"] for one in record["changes"]] == ["speed", "elevation", "azimuth"]
    assert record["proved"] is None
    assert len(answer.shots) == len(answer.names)
    PathCollection = pytest.importorskip("matplotlib.collections").PathCollection
    figure = answer.plot()
    (legend,) = figure.legends
    shot, *changed = answer.names
    assert [text.get_text() for text in legend.get_texts()] == [f"the shot: {shot}", *changed]
    # The shot's path is wide and below; all others but one have gaps.
    for axes in figure.axes:
        (paths,) = (one for one in axes.collections if isinstance(one, PathCollection))
        below, *above = zip(paths.get_linewidths(), paths.get_linestyles(), strict=True)
        assert below[0] > 2.0 * max(width for width, _ in above)
        assert [dashes is None for _, (_, dashes) in above].count(True) == 1
    colours = {line.get_color() for line in legend.get_lines()}
    assert len(colours) == len(answer.names)


@pytest.mark.parametrize(
    ("arguments", "error", "said"),
    [
        ({"vary": ["loft"]}, ValueError, "vary: unknown loft. One of speed, "),
        ({"vary": "speed"}, TypeError, "vary: expected names in a list or a mapping or None, got"),
        ({"vary": []}, ValueError, "vary: expected at least one name"),
        ({"i": 3}, IndexError, "i: expected a shot from -1 to 0, got 3"),
        ({"i": 0.0}, TypeError, "i: expected a whole number, got 0.0"),
        ({"i": "0"}, TypeError, "i: expected a whole number, got '0'"),
        ({"by": "far"}, ValueError, "by: expected made or missed, got 'far'"),
        ({"steady": -1}, ValueError, "steady: expected a number from 0 up, got -1"),
        ({"max_contacts": 1}, ValueError, "max_contacts: with 1, and the time limit of the scene"),
    ],
)
def test_bad_input(arguments: dict[str, Any], error: type[Exception], said: str) -> None:
    with pytest.raises(error) as refusal:
        hoopgen.counterfactual(throw(7.05, 49.0), **arguments)
    assert said in str(refusal.value)


def test_an_invalid_shot_has_no_counterfactual() -> None:
    with pytest.raises(ValueError, match="shot 0 is invalid"):
        hoopgen.counterfactual(hoopgen.simulate(np.full(9, np.nan)))
    endless = hoopgen.simulate(
        hoopgen.release(7.3, 51 * DEGREE, **PLACE), scene=hoopgen.COURT, max_contacts=30
    )
    with pytest.raises(ValueError, match="vary: ring_friction is inf in this shot"):
        hoopgen.counterfactual(endless, vary=["ring_friction"], max_contacts=30, prove=False)


def test_a_parameter_that_is_zero_has_a_range() -> None:
    shots = hoopgen.simulate(hoopgen.release(7.3, 51 * DEGREE, **PLACE), scene=hoopgen.COURT)
    assert shots.parameters["tangential_restitution"] == 0.0
    answer = hoopgen.counterfactual(shots, vary=["tangential_restitution"], prove=False)
    assert answer.changes[0].searched == (-0.25, 0.25)
    dead = hoopgen.simulate(
        hoopgen.release(7.3, 51 * DEGREE, **PLACE), {"restitution": 0.0}, max_contacts=12
    )
    answer = hoopgen.counterfactual(dead, vary=["restitution"], prove=False, max_contacts=12)
    assert answer.changes[0].searched == (0.0, 0.25)


@pytest.mark.slow
def test_a_settled_shot_is_settled_again() -> None:
    pytest.importorskip("flint")
    random = np.random.default_rng(1)
    speeds, elevations = random.normal(7.17, 0.07, 40_000), random.normal(0.9, 0.02, 40_000)
    states = hoopgen.release(speeds, elevations, backspin=6 * np.pi, **PLACE)
    uncertain = states[hoopgen.simulate(states, fields=["uncertain"]).uncertain][:1]
    assert len(uncertain)
    parameters = {name: float(value) for name, value in hoopgen.PAPER.items()}
    one = OneShot(hoopgen.HOOP, uncertain[0], parameters, int(hoopgen.Outcome.MADE))
    for settle in (False, True):
        shots = hoopgen.simulate(uncertain, settle=settle)
        again = simulated_like(shots, 0, one)
        assert bool(again.uncertain[0]) is bool(shots.uncertain[0]) is not settle
        assert again.outcome[0] == shots.outcome[0]


def test_another_time_limit_is_said_to_be_the_cause() -> None:
    state = hoopgen.release(7.3, 51 * DEGREE, **PLACE)
    shots = hoopgen.simulate(state, scene=hoopgen.COURT, time_limit=1.0)
    with pytest.raises(
        ValueError, match="the time limit of the scene, shot 0 ends as MISSED, in t"
    ):
        hoopgen.counterfactual(shots, prove=False)


@pytest.mark.slow
def test_the_command(tmp_path: Path) -> None:
    shot = ["--speed", "7.3", "--elevation", "51deg", "--distance", "4.191", "--height", "2.1336"]
    picture = tmp_path / "changes.svg"
    done = succeed("counterfactual", *shot, "--no-prove", "--picture", str(picture))
    answer = hoopgen.counterfactual(throw(7.3), prove=False)
    assert done.stdout.startswith(answer.sentence)
    assert picture.stat().st_size > 1000
    told = json.loads(succeed("counterfactual", *shot, "--no-prove", "--json").stdout)
    assert [one["name"] for one in told["changes"]] == ["speed", "elevation", "azimuth"]
    assert "unknown loft" in failure("counterfactual", *shot, "--vary", "loft")


@pytest.mark.parametrize("missing", ["flint", "sympy"])
def test_without_the_judge_the_error_names_the_extra_and_the_option(
    monkeypatch: pytest.MonkeyPatch, missing: str
) -> None:
    for name in [one for one in sys.modules if one.startswith("hoopgen.judge")]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.setitem(sys.modules, missing, None)
    said = failure("counterfactual", *RELEASE)
    assert "counterfactual proves its answers, which needs the extra certify: pip install " in said
    assert said.endswith("; or leave the proof out (--no-prove)\n")
    assert "missed" in output("counterfactual", *RELEASE, "--no-prove")
