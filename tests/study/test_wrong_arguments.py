"""Plausible mistakes in calls: each error names the argument and says what is allowed."""

from __future__ import annotations

from collections.abc import Callable
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
        "shots: expected the Shots of simulate, or a file; got array(",
    ),
    "a release for a model": (
        lambda: hoopgen.margins(THROW),  # type: ignore[arg-type]
        TypeError,
        "model: expected a Scatter or a Resample, got {'distance': 4.2",
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


def test_a_truth_value_of_numpy_is_one() -> None:
    _, jacobian = hoopgen.release(**THROW, jacobian=np.True_)  # type: ignore[call-overload]
    assert jacobian is not None
