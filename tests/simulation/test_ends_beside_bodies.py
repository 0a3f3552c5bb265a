"""Planes that end shots beside a body: on which side of one a flight begins may be undecided."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
import pytest

import hoopgen
from hoopgen import Event
from hoopgen.scene import Scene, load_scene
from hoopgen.simulation.engine import Engine
from tests.helpers.effort import trials

pytest.importorskip("flint")

TEXT = """
name = "{name}"
ball_radius = 0.12
gravity = 9.81
restitution = 0.7
{rolling}

[parameters]
place = {{ default = 1.0, sign = "any" }}

[bodies.ring]
kind = "torus"
radius = 0.235
wire = 0.01

[ends.passed]
axis = "-{axis}"
at = "place"

[ends.missed]
at = -1
"""

ROLLING = "friction = 0.5\nrolls = true"
OPTIONS = {"record": True, "max_contacts": 6}


def ring_with_end(axis: str, *, rolls: bool) -> Scene:
    """Return a ring whose shots end where they pass a plane along an axis, or below it."""
    text = TEXT.format(
        name=f"{'rolling' if rolls else 'bouncing'}_{axis}",
        rolling=ROLLING if rolls else "",
        axis=axis,
    )
    with TemporaryDirectory() as folder:
        file = Path(folder) / "passed.toml"
        file.write_text(text, encoding="utf-8")
        return load_scene(file)


ENGINES: dict[str, Callable[[], Engine]] = {
    f"{axis}{' where balls roll' if rolls else ''}": (
        lambda axis=axis, rolls=rolls: hoopgen.compile(ring_with_end(axis, rolls=rolls))
    )
    for axis in "xyz"
    for rolls in (False, True)
}


@pytest.fixture(scope="module", params=ENGINES)
def engine(request: pytest.FixtureRequest) -> Engine:
    """Return the engine of a scene in which shots end at a wall or at a ceiling."""
    return ENGINES[request.param]()


def test_a_ball_that_touches_the_ring_at_an_end_to_within_a_rounding_is_uncertain(
    engine: Engine,
) -> None:
    """Nothing says whether it has passed the end, and does not come back to it, or is before it."""
    (axis,) = (k for k, letter in enumerate("xyz") if engine.name.endswith(letter))
    count = trials(60, at_least=24)
    rng = np.random.default_rng(1)
    around, off = rng.uniform(0, 6, count), rng.normal(0.235, 0.03, count)
    states = np.zeros((count, 9))
    states[:, 0], states[:, 1] = off * np.cos(around), off * np.sin(around)
    states[:, 2] = rng.uniform(0.2, 0.5, count)
    states[:, 3:6] = rng.normal(0, 0.1, (count, 3))
    log = engine.simulate(states, {"place": -50.0}, **OPTIONS).events
    _, first = np.unique(log["shot"], return_index=True)
    assert np.all(log["kind"][first] == Event.IMPACT)
    places = -log["after"][first, axis]
    differs = np.zeros(count, bool)
    for moved in (places, np.nextafter(places, np.inf), np.nextafter(places, -np.inf)):
        shots = engine.simulate(states, {"place": moved}, **OPTIONS)
        proof = engine.certify(states, {"place": moved}, processes=1, **OPTIONS)
        assert np.all(proof.agrees(shots))
        differs |= shots.uncertain & (shots.contacts != proof.contacts)
    assert np.any(differs)
    for moved in (places + 1e-9, places - 1e-9):
        shots = engine.simulate(states, {"place": moved}, **OPTIONS)
        proof = engine.certify(states, {"place": moved}, processes=1, **OPTIONS)
        assert np.all(proof.agrees(shots))
        assert np.mean(shots.uncertain) < 0.05
