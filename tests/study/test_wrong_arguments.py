"""Plausible mistakes in calls: each error names the argument and says what is allowed."""

from __future__ import annotations

from collections.abc import Callable
from inspect import isfunction
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import hoopgen

THROW = {"speed": 7.2, "elevation": 0.9, "height": 2.0, "distance": 4.2}
STATE = hoopgen.release(**THROW)
SD = {"speed": 0.07, "elevation": 0.02}
REST = {"elevation": 0.9, "height": 2.0, "distance": 4.2}
MAPPING = "expected a mapping of names to values, got"
FLAG = "expected True or False, got"


def model() -> Any:
    return hoopgen.Scatter(THROW, SD)


WRONG: dict[str, tuple[Callable[[], Any], type[Exception], str]] = {
    "deviations in a list": (
        lambda: hoopgen.Scatter(THROW, [0.07, 0.02]),  # type: ignore[arg-type]
        TypeError,
        f"sd: {MAPPING} [0.07, 0.02]",
    ),
    "a state for a release": (
        lambda: hoopgen.Scatter(STATE.tolist(), SD),
        TypeError,
        f"release: {MAPPING} [4.2, 0.0, ",
    ),
    "a matrix of correlations": (
        lambda: hoopgen.Scatter(THROW, SD, [[1.0]]),  # type: ignore[arg-type]
        TypeError,
        f"correlation: {MAPPING} [[1.0]]",
    ),
    "a correlation of one name": (
        lambda: hoopgen.Scatter(THROW, SD, {"speed": 0.5}),  # type: ignore[dict-item]
        TypeError,
        "correlation: expected pairs of names, got 'speed'",
    ),
    "a path for columns": (
        lambda: hoopgen.Resample("shots.csv"),  # type: ignore[arg-type]
        TypeError,
        f"columns: {MAPPING} 'shots.csv'",
    ),
    "no columns": (
        lambda: hoopgen.Resample({}),
        ValueError,
        "columns: expected columns of one length and at least one row, got shapes none",
    ),
    "a column with decimal commas": (
        lambda: hoopgen.Resample(REST | {"speed": ["7,1", "7,2"]}),  # type: ignore[dict-item]
        TypeError,
        "columns['speed']: expected numbers, got ['7,1', '7,2']",
    ),
    "names for axes": (
        lambda: hoopgen.Grid(["speed"]),  # type: ignore[arg-type]
        TypeError,
        f"axes: {MAPPING} ['speed']",
    ),
    "names for a map": (
        lambda: hoopgen.map(model(), ["speed"]),  # type: ignore[arg-type]
        TypeError,
        f"over: {MAPPING} ['speed']",
    ),
    "a name for a map": (
        lambda: hoopgen.map(model(), "speed"),  # type: ignore[arg-type]
        TypeError,
        f"over: {MAPPING} 'speed'",
    ),
    "a preset's name for parameters": (
        lambda: hoopgen.simulate(STATE, "nba"),  # type: ignore[arg-type]
        TypeError,
        f"parameters: {MAPPING} 'nba'",
    ),
    "a misspelt parameter": (
        lambda: hoopgen.simulate(STATE, {"restituton": 0.7}),
        ValueError,
        "parameters: unknown restituton; is restitution meant? The names are ball_radius, ",
    ),
    "a misspelt deviation": (
        lambda: hoopgen.Scatter(THROW, {"sped": 0.07}),
        ValueError,
        "sd: unknown sped; is speed meant? One of speed, ",
    ),
    "two unknown deviations": (
        lambda: hoopgen.Scatter(THROW, {"sped": 0.07, "elevaton": 0.02}),
        ValueError,
        "sd: unknown sped, elevaton. One of speed, ",
    ),
    "one measure as text": (
        lambda: hoopgen.estimate(model(), measures="depth"),
        TypeError,
        "measures: expected names in a list or a mapping, got 'depth'",
    ),
    "a state for shots, measured": (
        lambda: hoopgen.measure(STATE, STATE),  # type: ignore[arg-type]
        TypeError,
        "shots: expected the Shots of simulate, got array(",
    ),
    "a state for shots, viewed": (
        lambda: hoopgen.view(STATE),  # type: ignore[arg-type]
        TypeError,
        "shots: expected the Shots of simulate or the path of a file, got array(",
    ),
    "a release for a model": (
        lambda: hoopgen.margins(THROW),  # type: ignore[arg-type]
        TypeError,
        "model: expected a Scatter or a Resample, got {'distance': 4.2",
    ),
    "a release for a setting": (
        lambda: hoopgen.compare(model(), THROW),  # type: ignore[arg-type]
        TypeError,
        "second: expected a Scatter, a Resample, or what else draws at random",
    ),
    "three things for a setting": (
        lambda: hoopgen.compare((model(), {}, None), model()),  # type: ignore[arg-type]
        TypeError,
        "first: expected a release model or a pair of it and parameters, got (",
    ),
    "text for a derivative": (
        lambda: hoopgen.release(**THROW, jacobian="no"),  # type: ignore[call-overload]
        TypeError,
        f"jacobian: {FLAG} 'no'",
    ),
    "text for a proof": (
        lambda: hoopgen.counterfactual(
            hoopgen.simulate(STATE, record=True),
            prove="no",  # type: ignore[arg-type]
        ),
        TypeError,
        f"prove: {FLAG} 'no'",
    ),
    "text for an override": (
        lambda: hoopgen.batch("shots.csv", override="no"),  # type: ignore[arg-type]
        TypeError,
        f"override: {FLAG} 'no'",
    ),
    "a number for a flag of rows": (
        lambda: hoopgen.batch("shots.csv", implausible=1),  # type: ignore[arg-type]
        TypeError,
        f"implausible: {FLAG} 1",
    ),
    "text for reasons": (
        lambda: hoopgen.batch("shots.csv", reason="yes"),  # type: ignore[arg-type]
        TypeError,
        f"reason: {FLAG} 'yes'",
    ),
    "text for the event log": (
        lambda: hoopgen.simulate(STATE, record="x"),  # type: ignore[arg-type]
        TypeError,
        f"record: {FLAG} 'x'",
    ),
    "text for settling": (
        lambda: hoopgen.simulate(STATE, settle="no"),  # type: ignore[arg-type]
        TypeError,
        f"settle: {FLAG} 'no'",
    ),
    "a number for derivatives": (
        lambda: hoopgen.simulate(STATE, derivatives=1),  # type: ignore[arg-type]
        TypeError,
        "derivatives: expected names in a list or a mapping, got 1",
    ),
    "an array for a backend": (
        lambda: hoopgen.simulate(STATE, backend=np.zeros(2)),  # type: ignore[arg-type]
        ValueError,
        "backend: expected 'auto', 'c', 'numpy' or 'cuda', got array(",
    ),
    "an array for a scene": (
        lambda: hoopgen.simulate(STATE, scene=STATE),  # type: ignore[arg-type]
        TypeError,
        "scene: expected None, a scene, or what hoopgen.compile returns; got array(",
    ),
    "a preset's name for a scene": (
        lambda: hoopgen.simulate(STATE, scene="nba"),  # type: ignore[arg-type]
        TypeError,
        "scene: expected None, a scene, or what hoopgen.compile returns; got 'nba'; scenes are "
        "hoopgen.HOOP, COURT, AIR, COURT_AIR; parameters=hoopgen.NBA or FIBA is a hoop",
    ),
    "a file for a scene": (
        lambda: hoopgen.compile("own.toml"),  # type: ignore[arg-type]
        TypeError,
        "scene: expected None, a scene, or what hoopgen.compile returns; got 'own.toml'; "
        "hoopgen.load_scene reads a file",
    ),
    "results without a scene for shots": (
        lambda: hoopgen.measure(STATE, SimpleNamespace(outcome=[0], events=[])),  # type: ignore[arg-type]
        TypeError,
        "shots: expected the Shots of simulate, got namespace(",
    ),
    "a number for fields": (
        lambda: hoopgen.simulate(STATE, fields=[np.zeros(2)]),  # type: ignore[list-item]
        TypeError,
        "fields: expected 'all' or names, got [array(",
    ),
    "a speed in centimetres a second": (
        lambda: hoopgen.release(717.0, 0.9, height=2.1, distance=4.2),
        ValueError,
        "release: speed is in m/s, and these are more than 100: 717. Centimetres a second would be "
        "0.01 times that, or in a table a column speed_cm_s",
    ),
    "a player in centimetres a second": (
        lambda: hoopgen.Scatter(THROW | {"speed": 717.0}, SD),
        ValueError,
        "release: speed is in m/s, and these are more than 100: 717. ",
    ),
    "a release in centimetres": (
        lambda: hoopgen.release(7.2, 0.9, height=200, distance=420),
        ValueError,
        "release: height is in m, and these are more than 100: 200. Centimetres would be 0.01 "
        "times that, or in a table a column height_cm",
    ),
    "a player in centimetres": (
        lambda: hoopgen.Scatter(THROW | {"distance": 420.0}, SD),
        ValueError,
        "release: distance is in m, and these are more than 100: 420. ",
    ),
    "a place aimed from in centimetres": (
        lambda: hoopgen.aim(height=2.0, distance=420.0),
        ValueError,
        "aim: distance is in m, and these are more than 100: 420. ",
    ),
    "a map of no number": (
        lambda: hoopgen.map(
            hoopgen.Scatter(REST, {"elevation": 0.02}), {"speed": [7.0, float("nan")]}
        ),
        ValueError,
        "over['speed']: expected numbers, got NaN among [7.0, nan]",
    ),
    "true for a function": (
        lambda: hoopgen.estimate(model(), progress=True),  # type: ignore[arg-type]
        TypeError,
        "progress: expected a function or None, got True",
    ),
    "a list for a folder": (
        lambda: hoopgen.estimate(model(), folder=["a"]),  # type: ignore[arg-type]
        TypeError,
        "folder: expected the path of a file or None, got ['a']",
    ),
    "a list for a way in": (
        lambda: hoopgen.margins(model(), by=["any"]),  # type: ignore[arg-type]
        TypeError,
        "by: expected text, got ['any']",
    ),
    "text for a group": (
        lambda: hoopgen.Resample(REST | {"speed": [7.1, 7.2]}, "ab"),
        TypeError,
        "group: expected a label for each row, got 'ab'",
    ),
    "text for a shot": (
        lambda: hoopgen.simulate(STATE, record=True).trajectory("a"),  # type: ignore[arg-type]
        TypeError,
        "shot: expected a whole number, got 'a'",
    ),
    "text for probabilities' shots": (
        lambda: hoopgen.assess([0.5, 0.6], [1, 0], shots="many"),  # type: ignore[arg-type]
        ValueError,
        "shots: expected a whole number from 1, got 'many'",
    ),
    "a list for weights' parameters": (
        lambda: hoopgen.vjp(STATE, [1, 2], {"time": 1.0}),  # type: ignore[arg-type]
        TypeError,
        f"parameters: {MAPPING} [1, 2]",
    ),
    "a number for a path": (
        lambda: hoopgen.load_scene(1),  # type: ignore[arg-type]
        TypeError,
        "file: expected the path of a file, got 1",
    ),
    "numbers for columns' names": (
        lambda: hoopgen.batch("shots.csv", columns={"speed": 1}),  # type: ignore[dict-item]
        TypeError,
        "columns: expected names of the table's columns, got {'speed': 1}",
    ),
    "a preset's name for a place's parameters": (
        lambda: hoopgen.place("free throw", "nba"),  # type: ignore[arg-type]
        TypeError,
        f"parameters: {MAPPING} 'nba'; presets are mappings, such as hoopgen.NBA",
    ),
    "a court in a list": (
        lambda: hoopgen.place("free throw", court=["NBA"]),  # type: ignore[arg-type]
        ValueError,
        "court: expected NBA or FIBA, got ['NBA']",
    ),
    "a misspelt place": (
        lambda: hoopgen.place("freethrow"),
        ValueError,
        "place: expected one of free throw, ",
    ),
}


@pytest.mark.parametrize("mistake", WRONG)
def test_a_mistake_in_a_call_is_named(mistake: str) -> None:
    call, error, said = WRONG[mistake]
    with pytest.raises(error) as refusal:
        call()
    assert str(refusal.value).startswith(said)


PLOTS: dict[str, tuple[str, dict[str, Any], str]] = {
    "text for a map": (
        "plot_map",
        {"dataset": "a"},
        "dataset: expected an xarray Dataset, got 'a'",
    ),
    "text for a trajectory": (
        "plot_trajectory",
        {"trajectory": "a", "parameters": hoopgen.PAPER},
        "trajectory: expected a trajectory of the shots of simulate, got 'a'",
    ),
    "a width in centimetres": (
        "plot_landings",
        {"x": [1.0], "y": [0.0], "parameters": hoopgen.PAPER, "width": 180},
        "width: expected a number of inches from 2 to 100, got 180",
    ),
    "one number for a place": (
        "plot_landings",
        {"x": [1.0], "y": [0.0], "parameters": hoopgen.PAPER, "place": 4.2},
        "place: expected x and y, got 4.2",
    ),
    "an unknown parameter": (
        "plot_landings",
        {"x": [1.0], "y": [0.0], "parameters": {"a": 1.0}},
        "parameters: unknown a. The names are ball_radius, ",
    ),
    "text for shots": (
        "plot_fan",
        {"shots": "a", "parameters": hoopgen.PAPER},
        "shots: expected the Shots of simulate, got 'a'",
    ),
    "a number for a title": (
        "plot_coach",
        {"found": None, "title": 1},
        "found: expected what coach returns, got None",
    ),
}


@pytest.mark.parametrize("mistake", PLOTS)
def test_a_mistake_in_a_picture_is_named(mistake: str) -> None:
    pytest.importorskip("matplotlib")
    name, arguments, said = PLOTS[mistake]
    with pytest.raises((TypeError, ValueError)) as refusal:
        getattr(hoopgen.plots, name)(**arguments)
    assert str(refusal.value).startswith(said)


def test_a_proof_takes_flags_and_shots() -> None:
    pytest.importorskip("flint")
    with pytest.raises(TypeError, match=f"^record: {FLAG} 'x'"):
        hoopgen.certify(STATE, record="x")  # type: ignore[arg-type]
    with pytest.raises(TypeError, match=r"^shots: expected the Shots of simulate, got 'a'"):
        hoopgen.certify(STATE).agrees("a")  # type: ignore[arg-type]


def test_flags_and_functions_of_progress_are_checked_by_annotation() -> None:
    # A scene is loaded when it is asked for, and may have to be compiled.
    named = {name: getattr(hoopgen, name) for name in dir(hoopgen) if not name.isupper()}
    functions = {name: each for name, each in named.items() if isfunction(each)}

    def taking(annotation: str) -> set[str]:
        return {n for n, each in functions.items() if annotation in each.__annotations__.values()}

    checked = {name for name, each in functions.items() if hasattr(each, "__wrapped__")}
    assert len(checked) >= 18
    # These two check theirs in a function of their own.
    assert taking("bool") - checked == {"release", "simulate"}
    assert taking("Progress | None") <= checked


def test_a_truth_value_of_numpy_is_one() -> None:
    _, jacobian = hoopgen.release(**THROW, jacobian=np.True_)  # type: ignore[call-overload]
    assert jacobian is not None
