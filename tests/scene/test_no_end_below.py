"""Balls that fall past a body where no end is below: what they cannot meet again is decided.

The surface of a cone, and that of a cylinder that leans, go on for ever in the search, and a ball
falls into most of them again, aeons later. The bodies here end, and so does the search.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import hoopgen
from hoopgen.scene import End, Parameter, Revolution, Scene
from tests.helpers.compiled import needs_compiler
from tests.helpers.effort import exceptions, occurrences, trials
from tests.scene import test_furthest
from tests.scene.test_furthest import PLACE, PROFILE

pytestmark = [
    pytest.mark.slow,
    pytest.mark.xdist_group("no_end_below"),
    needs_compiler,
]

# A cone and its edge: a longer profile takes a minute to derive.
BODIES = test_furthest.BODIES | {
    "bowl": Revolution("it", profile=PROFILE[:2], centre=PLACE, axis=("lean", -0.3, 0.8))
}
GRAVITIES: dict[str, dict[str, Any]] = {
    "down": {"gravity": 9.81},
    "any": {"gravity": "pull", "down": ("lean", 0, -1)},
}


def scene(body: str, gravity: str) -> Scene:
    """Return a body whose axis leans, and an end that stands upright."""
    pull = Parameter("pull", 9.81, "m/s²", sign="nonnegative")
    return Scene(
        f"{body}_{gravity}",
        parameters=[Parameter("lean", 0.5, "1", sign="any"), *([pull] if gravity == "any" else [])],
        bodies=[BODIES[body]],
        ball_radius=0.05,
        restitution=0.7,
        ends={"wall": End(axis="x", at=-2.5)},
        **GRAVITIES[gravity],
    )


def shots(count: int, gravity: str) -> tuple[NDArray[np.float64], dict[str, Any]]:
    """Return balls around the body, half of which fly towards it."""
    chance = np.random.default_rng(5)
    states = np.zeros((count, 9))
    states[:, :3] = np.array(PLACE) + chance.normal(0, 0.5, (count, 3))
    states[:, 3:6] = chance.normal(0, 1, (count, 3))
    states[::2, 3:6] = 3 * (PLACE - states[::2, :3]) + chance.normal(0, 0.3, (len(states[::2]), 3))
    values = {"lean": chance.uniform(-0.6, 0.6, count)}
    if gravity == "any":
        values["pull"] = chance.choice((0.0, 1.6, 9.81), count)
    return states, values


@pytest.mark.parametrize(
    ("body", "gravity"), [*((body, "down") for body in BODIES), ("cone", "any"), ("tube", "any")]
)
def test_few_are_uncertain_and_the_others_are_as_proved(body: str, gravity: str) -> None:
    engine = hoopgen.compile(scene(body, gravity))
    states, values = shots(trials(4000, at_least=1000), gravity)
    found = engine.simulate(states, values, max_contacts=4, time_limit=60.0)
    valid = found.outcome != engine.outcomes["INVALID"]
    assert valid.sum() > len(states) / 2
    assert (found.contacts[valid] > 0).sum() >= occurrences(150)
    assert found.uncertain[valid].sum() <= exceptions(0.003, int(valid.sum()))

    few = slice(0, trials(400, at_least=100))
    given = {name: value[few] for name, value in values.items()}
    proofs = hoopgen.certify(states[few], given, scene=engine, max_contacts=4, time_limit=60.0)
    some = engine.simulate(states[few], given, max_contacts=4, time_limit=60.0, record=True)
    certain = ~some.uncertain
    assert proofs.decided[certain].all()
    assert proofs.agrees(some).all()
