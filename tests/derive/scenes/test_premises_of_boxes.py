"""The premises of the theorem about bounds, of a ball that comes up past a box."""

from __future__ import annotations

from typing import Any

import numpy as np
from hoopgen.derive.scenes.premises import premises

from tests.derive.test_evaluation import in_doubles
from tests.helpers.effort import occurrences, trials
from tests.helpers.scenes.block import BLOCK

SIZES = {p.name: p.default for p in BLOCK.parameters}
FACES = [f"{side}_{axis}" for side in ("from", "to") for axis in "xyz"]


def holds(values: dict[str, Any]) -> Any:
    """Return whether the premises hold, as computed."""
    found = premises(BLOCK)
    assert found is not None
    return in_doubles(found, values)["holds"].astype(bool)


def test_a_ball_that_comes_up_to_the_end_has_met_no_box_before() -> None:
    """Along the way no place is as near to the box as at a contact; others are refused for it."""
    random, count = np.random.default_rng(1), trials(40_000)
    height, g = -SIZES["depth"], SIZES["gravity"]
    place = np.array(
        [*random.uniform(-3, 3, (2, count)), height - 10 ** random.uniform(-2, 0, count)]
    )
    velocity = np.array(
        [*-place[:2] * random.uniform(0, 0.6, (2, count)), random.uniform(2, 7, count)]
    )
    middle = place + velocity * random.uniform(0, 0.3, count) + random.normal(0, 0.3, (3, count))
    half = 10 ** random.uniform(-2, -0.3, (3, count))
    faces = dict(zip(FACES, (*(middle - half), *(middle + half)), strict=True))
    state = dict(zip(("x", "y", "z", "vx", "vy", "vz"), (*place, *velocity), strict=True))
    values = {**SIZES, **faces, **state, "wx": 0.0, "wy": 0.0, "wz": 0.0, "contacts": 10.0}
    near = holds(values)
    above = holds(values | {"from_z": middle[2] + 5.0, "to_z": middle[2] + 6.0})
    assert not np.any(near & ~above)
    with np.errstate(invalid="ignore"):
        lasting = (velocity[2] - np.sqrt(velocity[2] ** 2 - 2 * g * (height - place[2]))) / g
    least = np.full(count, np.inf)
    for share in np.linspace(0, 1, 200):
        t = lasting * share
        there = place + velocity * t
        there[2] -= g * t**2 / 2
        beyond = np.maximum(np.abs(there - middle) - half, 0)
        least = np.minimum(least, np.sqrt((beyond**2).sum(axis=0)))
    assert np.all(least[near] > SIZES["ball_radius"])
    assert np.count_nonzero(near) > occurrences(2000)
    assert np.count_nonzero(above & ~near) > occurrences(500)
    # Not many are refused that pass the box.
    passing = above & (least > 1.5 * SIZES["ball_radius"])
    assert np.mean(near[passing]) > 0.5
