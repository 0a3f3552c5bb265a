"""`calibrate`: intervals that hold, and parameters that shots do not tell."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

pytest.importorskip("scipy")

import hoopgen
from hoopgen import NBA, calibrate
from tests.helpers.effort import trials

ERRORS = {"speed": 0.03, "elevation": 0.008, "azimuth": 0.008}
PLACE = {"height": 2.1336, "distance": 4.191, "backspin": 18.0}


def shots(count: int, seed: int, restitution: float, wide: float = 0.12) -> dict[str, Any]:
    """Return measured releases, with how shots of the true ones end."""
    random = np.random.default_rng(seed)
    true = {
        "speed": random.normal(7.2, wide, count),
        "elevation": random.normal(0.9, 0.03, count),
        "azimuth": random.normal(0, 0.02, count),
    }
    ended = hoopgen.simulate(hoopgen.release(**true, **PLACE), NBA | {"restitution": restitution})
    measured = {name: one + ERRORS[name] * random.normal(size=count) for name, one in true.items()}
    return {**measured, **PLACE, "made": ended.made, "contacts": ended.contacts}


def find(table: Any, vary: Any = ("restitution",), **options: Any) -> Any:
    given = {"draws": 40, "errors": ERRORS, "parameters": NBA, **options}
    return calibrate(table, vary, **given)


def test_contacts_and_outcomes_find_the_restitution() -> None:
    found = find(shots(400, 1, 0.55)).values["restitution"]
    assert found.low < 0.55 < found.high
    assert found.high - found.low < 0.3
    assert found.bounded == (True, True)
    assert found.profile.max() == 0.0


def test_outcomes_alone_say_less_than_contacts() -> None:
    table = shots(400, 2, 0.6)
    both = find(table).values["restitution"]
    del table["contacts"]
    alone = find(table).values["restitution"]
    assert alone.low < 0.6 < alone.high
    assert alone.high - alone.low > both.high - both.low


def test_a_parameter_that_no_shot_shows_is_not_identified() -> None:
    """Shots that swish say nothing of what they do not touch."""
    table = {**PLACE, "speed": np.full(20, 7.18), "elevation": 0.9, "made": np.ones(20)}
    result = find(table, errors={"speed": 0.001})
    found = result.values["restitution"]
    assert not found.identified
    assert (found.low, found.high) == (0.3, 0.95)
    assert "not identified" in str(result)


@pytest.mark.slow
def test_the_intervals_hold() -> None:
    count, inside = trials(40, 25), 0
    for seed in range(count):
        found = find(shots(120, 100 + seed, 0.65), draws=60).values["restitution"]
        inside += found.low <= 0.65 <= found.high
    assert inside / count > 0.95 - 0.02 - 3 * np.sqrt(0.05 * 0.95 / count)


def test_two_parameters_are_varied_together() -> None:
    table = shots(60, 3, 0.6)
    bounds = {"restitution": (0.5, 0.7), "board_distance": (0.37, 0.39)}
    found = find(table, bounds, draws=10)
    assert list(found.values) == list(bounds)
    assert found.parameters["restitution"] == found.values["restitution"].value
    one = find(table, {"restitution": (0.5, 0.7)}, draws=10)
    assert found.log_likelihood >= one.log_likelihood - 1e-9 - 3 * found.noise


def test_fitted_releases_bring_their_errors() -> None:
    random = np.random.default_rng(4)
    times = np.arange(0, 0.5, 1 / 60)
    # To the side too: shots in the plane of symmetry end as none beside it do.
    speed, azimuth = random.normal(7.2, 0.12, 40), random.normal(0.0, 0.02, 40)
    states = hoopgen.release(speed, 0.9, azimuth, **PLACE)
    fall = np.array([0, 0, -0.5 * NBA["gravity"]])
    path = states[:, None, :3] + states[:, None, 3:6] * times[:, None] + fall * times[:, None] ** 2
    noisy = path + random.normal(0, 0.01, path.shape)
    fitted = hoopgen.fit_release(times, noisy, parameters=NBA, noise=0.01, backspin=18.0)
    made = hoopgen.simulate(states, NBA).made
    found = calibrate(fitted, ("restitution",), made=made, parameters=NBA, draws=30)
    assert found.values["restitution"].low <= 0.7 <= found.values["restitution"].high
    with pytest.raises(ValueError, match="errors: fitted releases have their own"):
        calibrate(fitted, ("restitution",), made=made, errors={"speed": 0.1})


@pytest.mark.parametrize(
    ("changes", "options", "said"),
    [
        ({"made": None}, {}, "made"),
        ({"made": np.full(5, 2)}, {}, "made: expected true or false"),
        ({"speed": None}, {}, "table: missing speed"),
        ({}, {"errors": None}, "errors: expected standard errors"),
        ({}, {"vary": ("bounce",)}, "vary: .*bounce"),
        ({}, {"vary": ("board_distance",)}, "vary: board_distance has no usual bounds"),
        ({}, {"vary": {"restitution": (0.9, 0.2)}}, "vary: restitution: expected low below high"),
        ({}, {"vary": ()}, "vary: expected one to three"),
        ({"contacts": np.zeros(3)}, {}, "contacts: expected a number for each"),
    ],
)
def test_what_cannot_be_calibrated_is_refused(changes: Any, options: Any, said: str) -> None:
    table = {name: one for name, one in (shots(5, 5, 0.7) | changes).items() if one is not None}
    with pytest.raises(ValueError, match=said):
        find(table, options.pop("vary", ("restitution",)), **options)
