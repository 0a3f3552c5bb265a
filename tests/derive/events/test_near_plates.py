"""Flights that graze a plate, or a rounded edge or corner of it: none of them is called far."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hoopgen.generated.numpy import court

from hoopgen import PAPER_COURT
from tests.derive.events.test_bounding_boxes import SIZES, plates
from tests.helpers.effort import trials

STATE = ("x", "y", "z", "vx", "vy", "vz")


def grazing(plate: str, rows: int, errors: float, seed: int) -> dict[str, Any]:
    """Return flights, a column each, that graze a plate; errors take them away from it.

    The nearest point is drawn on a face, an edge or a corner, then a direction from it.
    """
    rng = np.random.default_rng(seed)
    low, high = map(np.array, plates()[plate])
    side = rng.integers(-1, 2, (rows, 3))
    side[~side.any(axis=1), 0] = 1
    inner = rng.uniform(low, high, (rows, 3))
    point = np.select([side < 0, side > 0], [low + 0 * inner, high + 0 * inner], inner)
    normal = side * rng.uniform(0.05, 1, (rows, 3))
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    gravity, horizon = PAPER_COURT["gravity"], 10 ** rng.uniform(-2, -0.3, rows)
    time = horizon * rng.choice([0.0, 0.25, 0.5, 0.75, 1.0], rows)
    velocity = rng.normal(0, 1, (rows, 3)) * 10 ** rng.uniform(-2, 0.5, (rows, 1))
    velocity -= np.sum(velocity * normal, axis=1, keepdims=True) * normal
    place = point + normal * PAPER_COURT["ball_radius"] * (1 - 1e-7)
    start = place - velocity * time[:, None]
    start[:, 2] -= gravity * time**2 / 2
    velocity[:, 2] += gravity * time
    known = SIZES | {name: np.float64(value) for name, value in SIZES.items()}
    # The computed flight is further off by all that its errors may be.
    start += errors * np.sign(normal)
    velocity += errors * np.sign(normal)
    known |= dict(zip(STATE, (*start.T, *velocity.T), strict=True))
    return known | {
        "horizon": horizon,
        "extent": np.abs(start).sum(axis=1),
        "speed": np.abs(velocity).sum(axis=1),
        "position_error": errors,
        "velocity_error": errors,
        "pad": 1e-3,
        "earliest_delay": 0.0,
    }


def called_near(plate: str, known: dict[str, Any], part: str) -> Any:
    """Return what a kernel of a plate says of flights: whether they are near."""
    name = f"{plate}_{part}"
    return getattr(court, name)(*(known[argument] for argument in court.ARGUMENTS[name]))[0]


@pytest.mark.parametrize("errors", [0.0, 1e-3])
@pytest.mark.parametrize("plate", ["backboard", "bridge"])
def test_a_plate_that_a_flight_grazes_is_near(plate: str, errors: float) -> None:
    known = grazing(plate, trials(5000, at_least=5000), errors, seed=4)
    name = "half_flight_boxes"
    boxes = getattr(court, name)(*(known[argument] for argument in court.ARGUMENTS[name]))
    known |= dict(zip(court.OUTPUTS[name], boxes, strict=True))
    assert np.all(called_near(plate, known, "near"))
