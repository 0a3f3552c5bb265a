"""Flights that begin next to where a bounded surface would go on: on either side of it.

There no rounding error, but the error that a search first allows for, hides on which side the ball
is. It must not pass a contact that comes soon after.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

pytest.importorskip("flint")

from hoopgen.scene import Cone, End, Scene, Sphere
from tests.helpers.derived import engine_of
from tests.helpers.effort import occurrences, trials

BALL, RADIUS = 0.05, 0.5
BODIES = {
    "sphere": Sphere("bowl", radius=RADIUS, inside=True, within=["z"]),
    "cone": Cone("bowl", apex=(0, 0, -RADIUS), slope=1, span=(0.1, RADIUS), inside=True),
}


def beside(body: str, count: int, seed: int) -> NDArray[np.float64]:
    """Return balls above the rim, within micrometres of the surface that would go on there.

    They move away from it, towards the other side of the bowl or down to the same one.
    """
    chance = np.random.default_rng(seed)
    height = chance.uniform(0.001, 0.05, count)
    room = RADIUS - BALL
    if body == "sphere":
        rho, normal = np.sqrt(room**2 - height**2), np.stack([-room + 0 * height, -height], 1)
    else:
        height += -BALL * np.sqrt(0.5) + 2 * BALL * np.sqrt(0.5)
        rho, normal = RADIUS + height - BALL * np.sqrt(2), np.tile([-1.0, 1.0], (count, 1))
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    away = chance.choice([-1, 1], count) * 10 ** chance.uniform(-9, -3, count)
    flat = np.stack([rho, height], 1) - away[:, None] * normal
    tangent = np.stack([normal[:, 1], -normal[:, 0]], 1)
    tangent *= np.where(tangent[:, 1:] > 0, -1, 1)
    speed = chance.uniform(0.5, 20, (count, 1))
    way = speed * (tangent + normal * 10 ** chance.uniform(-3, 0, (count, 1)))
    angle = chance.uniform(-np.pi, np.pi, count)
    turn = np.stack([np.cos(angle), np.sin(angle)], 1)
    states = np.zeros((count, 9))
    for k, rows in enumerate((flat, way)):
        states[:, 3 * k : 3 * k + 2] = rows[:, :1] * turn
        states[:, 3 * k + 2] = rows[:, 1]
    return states


@pytest.mark.slow
@pytest.mark.parametrize("body", BODIES)
def test_a_contact_soon_after_a_start_beside_the_surface_is_met(body: str, tmp_path: Path) -> None:
    """3,000 shots at full effort: the sequences proved, or flagged."""
    made = Scene(
        "rim",
        bodies=[BODIES[body]],
        ball_radius=BALL,
        gravity=9.81,
        restitution=0.75,
        ends={"gone": End(at=-1)},
    )
    engine = engine_of(made, tmp_path)
    count = trials(3000, at_least=1000)
    shots = engine.simulate(beside(body, count, 1), max_contacts=2, record=True)
    proofs = engine.certify(beside(body, count, 1), max_contacts=2)
    assert proofs.agrees(shots).all()
    valid = shots.outcome != engine.outcomes["INVALID"]
    assert valid.all()
    assert np.sum(shots.uncertain) < count / 100
    assert (shots.contacts > 0).sum() > occurrences(count // 2)
