"""Flights that move away from a box: called so only if the true ball does not come to it."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hoopgen.generated.numpy import court

from hoopgen import PAPER_COURT
from tests.derive.events.test_bounding_boxes import SIZES, plates
from tests.derive.events.test_near_plates import STATE, grazing
from tests.helpers.effort import trials

TIMES = np.linspace(0, 1, 129)
"""Shares of the horizon at which flights are looked at."""

PLATES = ["backboard", "bridge"]
ERRORS = [0.0, 1e-9]


def starts(plate: str, rows: int, seed: int) -> tuple[Any, Any, Any]:
    """Return places that touch a plate on a face, an edge or a corner, and flights from there.

    Returns
    -------
    tuple
        Places and velocities, (rows, 3), and horizons, (rows,).
    """
    rng = np.random.default_rng(seed)
    low, high = map(np.array, plates()[plate])
    side = rng.integers(-1, 2, (rows, 3))
    side[~side.any(axis=1), 2] = 1
    inner = rng.uniform(low, high, (rows, 3))
    point = np.select([side < 0, side > 0], [low + 0 * inner, high + 0 * inner], inner)
    normal = side * rng.uniform(0.05, 1, (rows, 3))
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    place = point + normal * PAPER_COURT["ball_radius"]
    velocity = rng.normal(0, 1, (rows, 3)) * 10 ** rng.uniform(-3, 0.5, (rows, 1))
    velocity += normal * rng.uniform(0, 1, (rows, 1))
    return place, velocity, 10 ** rng.uniform(-3, -0.3, rows)


def approaches(
    plate: str, place: Any, velocity: Any, horizon: Any, errors: float, leaving: float
) -> Any:
    """Return whether flights may come to a plate, by the kernel, if both halves come near it."""
    known: dict[str, Any] = {name: np.float64(value) for name, value in SIZES.items()}
    known |= dict(zip(STATE, (*place.T, *velocity.T), strict=True))
    known |= {
        "leaving": leaving,
        "horizon": horizon,
        "extent": np.abs(place).sum(axis=1),
        "speed": np.abs(velocity).sum(axis=1),
        "position_error": errors,
        "velocity_error": errors,
        "pad": 1e-3,
        "earliest_delay": 0.0,
        "first_near": np.full(len(place), True),
        "later_near": np.full(len(place), True),
    }
    return called(plate, known)


def called(plate: str, known: dict[str, Any]) -> Any:
    """Return whether flights may come to a plate, by the kernel."""
    name = f"{plate}_approaches"
    return getattr(court, name)(*(known[argument] for argument in court.ARGUMENTS[name]))[0]


def squared_distances(plate: str, place: Any, velocity: Any, horizon: Any) -> Any:
    """Return the squared distances from a plate along flights, (rows, times)."""
    low, high = map(np.array, plates()[plate])
    time = horizon[:, None] * TIMES
    path = place[:, None] + velocity[:, None] * time[..., None]
    path[..., 2] -= PAPER_COURT["gravity"] * time**2 / 2
    beyond = np.maximum(path - high, 0) + np.maximum(low - path, 0)
    return np.sum(beyond**2, axis=-1)


@pytest.mark.parametrize("errors", ERRORS)
@pytest.mark.parametrize("plate", PLATES)
def test_a_ball_that_comes_back_to_the_plate_it_left_approaches_it(
    plate: str, errors: float
) -> None:
    """The computed flight is off the true one, which touches the plate at its start."""
    place, velocity, horizon = starts(plate, trials(20_000, at_least=20_000), 5)
    squares = squared_distances(plate, place, velocity, horizon)
    returns = np.min(squares[:, 1:], axis=1) < squares[:, 0]
    rng = np.random.default_rng(6)
    computed = [part + errors * rng.integers(-1, 2, part.shape) for part in (place, velocity)]
    approached = approaches(plate, *computed, horizon, errors, leaving=1.0)
    assert np.all(approached[returns])
    assert np.count_nonzero(returns) > len(returns) / 10
    # Nearly all that do not come back are known to move away.
    assert np.count_nonzero(approached) < 1.3 * np.count_nonzero(returns)


@pytest.mark.parametrize("errors", ERRORS)
@pytest.mark.parametrize("plate", PLATES)
def test_a_ball_that_comes_to_a_plate_approaches_it(plate: str, errors: float) -> None:
    known = grazing(plate, trials(5000, at_least=5000), errors, seed=8)
    known |= {"leaving": 0.0, "first_near": True, "later_near": True}
    assert np.all(called(plate, known))


def test_a_ball_within_its_error_of_a_plate_may_touch_it() -> None:
    """A ball that moves away may have touched the plate where it starts."""
    radius, front = PAPER_COURT["ball_radius"], -PAPER_COURT["board_distance"]
    away = np.array([[1.0, 0.0, 0.0]])
    for beyond, approached in ((1e-12, True), (1e-9, True), (1e-6, False)):
        place = np.array([[front + radius + beyond, 0.0, 0.5]])
        found = approaches("backboard", place, away, np.array([0.1]), 1e-9, leaving=0.0)
        assert bool(found[0]) == approached
    place = np.array([[front + radius, 0.0, 0.5]])
    assert not approaches("backboard", place, away, np.array([0.1]), 1e-9, leaving=1.0)[0]


def test_a_ball_whose_velocity_is_within_its_error_may_come_back() -> None:
    place = np.array([[PAPER_COURT["ball_radius"] - PAPER_COURT["board_distance"], 0.0, 0.5]])
    for speed, approached in ((5e-10, True), (1e-6, False)):
        away = np.array([[speed, 0.0, -0.3]])
        found = approaches("backboard", place, away, np.array([0.1]), 1e-9, leaving=1.0)
        assert bool(found[0]) == approached


def test_where_an_arrival_may_be_late_a_ball_may_come_back() -> None:
    place = np.array([[PAPER_COURT["ball_radius"] - PAPER_COURT["board_distance"], 0.0, 0.5]])
    known: dict[str, Any] = {name: np.float64(value) for name, value in SIZES.items()}
    known |= dict(zip(STATE, (*place.T, *np.array([[1.0], [0.0], [0.0]])), strict=True))
    known |= {"leaving": 1.0, "horizon": 0.1, "extent": 1.0, "speed": 1.0}
    known |= {"position_error": 0.0, "velocity_error": 0.0, "pad": 1e-3}
    assert not called("backboard", known | {"earliest_delay": 0.0})[0]
    assert called("backboard", known | {"earliest_delay": 2e-3})[0]
