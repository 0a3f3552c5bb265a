"""Proved bounds in scenes with boxes, with friction and without slip: the judge finds no more.

Shots are free throws, shots that bounce and swirl, and shots that are aimed at edges and corners of
board and bridge from all sides.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import hoopgen
from benchmarks.workloads import WORKLOADS
from hoopgen.scene.files import load_scene
from tests.helpers.effort import trials
from tests.helpers.proved_bounds import bounded_events

FIELDS = ("outcome", "contacts", "counts", "uncertain", "time_error", "state_error")
OPTIONS: dict[str, Any] = {"record": True, "max_contacts": 40}
LAWS = {
    "boxes": 'friction = "mu"\ninertia = "inertia"\nrestitution_speed = "v0"\ntangential = "et"',
    "boxes_without_slip": "",
}
INPUTS = {
    "boxes": 'mu = { default = 0.5, unit = "1" }\n'
    'et = { default = 0.1, unit = "1", sign = "any" }\nv0 = { default = 40, unit = "m/s" }\n'
    'inertia = { default = 0.6666666666666666, unit = "1" }',
    "boxes_without_slip": "",
}

SCENE = """
name = "{name}"
ball_radius = 0.12128
gravity = 9.81
restitution = "e0"
{law}

[parameters]
radius = {{ default = 0.235 }}
wire = {{ default = 0.01 }}
distance = {{ default = 0.381 }}
e0 = {{ default = 0.7, unit = "1" }}
{inputs}

[bodies.ring]
kind = "torus"
radius = "radius"
wire = "wire"

[bodies.board]
kind = "box"
centre = ["-distance - 0.00635", 0, 0.381]
size = [0.0127, 1.8288, 1.0668]

[bodies.bridge]
kind = "box"
centre = ["-(distance + radius)/2", 0, "wire - 0.06"]
size = ["distance - radius", 0.1524, 0.12]

[ends.made]
at = -0.024
within = ["x**2 + y**2 - radius**2"]

[ends.missed]
at = -0.024
"""

BOARD = np.array([[-0.3937, -0.9144, -0.1524], [-0.381, 0.9144, 0.9144]])
BRIDGE = np.array([[-0.381, -0.0762, -0.11], [-0.235, 0.0762, 0.01]])
R_B, G = 0.12128, 9.81


@cache
def engine(name: str, folder: Path) -> hoopgen.Engine:
    """Return the engine of a scene."""
    file = folder / f"{name}.toml"
    file.write_text(SCENE.format(name=name, law=LAWS[name], inputs=INPUTS[name]), encoding="utf-8")
    return hoopgen.compile(load_scene(file))


@pytest.fixture(scope="module", params=list(LAWS))
def scene(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Any:
    """Return the engines, one after the other."""
    return engine(request.param, tmp_path_factory.mktemp("scenes"))


def usual(count: int) -> np.ndarray:
    """Return free throws, shots that bounce, and shots that swirl."""
    return np.concatenate([workload.make(count) for workload in WORKLOADS[1:4]])


def aimed(count: int, seed: int) -> np.ndarray:
    """Return shots at edges and corners, some of them a hair off, from above, below and behind."""
    random = np.random.default_rng(seed)
    sides = np.where((random.random(count) < 0.35)[:, None, None], BOARD, BRIDGE)
    side = random.choice([-1, 0, 1], (count, 3), p=[0.4, 0.2, 0.4])
    inner = sides[:, 0] + (sides[:, 1] - sides[:, 0]) * random.random((count, 3))
    point = np.select([side < 0, side > 0], [sides[:, 0], sides[:, 1]], inner)
    way = random.normal(0, 1, (count, 3))
    way *= np.where(random.random((count, 3)) < 0.8, np.where(side == 0, 1, side * np.sign(way)), 1)
    reach = R_B * (1 + random.choice([0, 1e-3, 0.2], count) * random.normal(0, 1, count))
    there = point + side * random.uniform(0, 1, (count, 3)) * reach[:, None]
    start = there + way * random.uniform(0.3, 1, (count, 1))
    time = random.uniform(0.15, 0.7, (count, 1))
    velocity = (there - start) / time
    velocity[:, 2:] += G * time / 2
    return np.concatenate([start, velocity, random.normal(0, 10, (count, 3))], axis=1)


def check(engine: hoopgen.Engine, states: np.ndarray, least: float) -> hoopgen.Shots:
    """Demand that the judge has the same sequences and no larger errors.

    Parameters
    ----------
    engine
        The scene.
    states
        The releases.
    least
        The least share of valid shots whose bounds are proved and that are not uncertain.
    """
    shots = engine.simulate(states, **OPTIONS, fields=FIELDS)
    proof = engine.certify(states, **OPTIONS)
    assert proof.agrees(shots)[~shots.uncertain].all()
    plates = np.isin(shots.events["surface"], (1, 2))
    assert np.count_nonzero(bounded_events(shots, proof) & plates) > len(states) / 20
    valid = shots.outcome != hoopgen.Outcome.INVALID
    assert np.mean((shots.proved & ~shots.uncertain)[valid]) >= least
    return shots


def test_the_judge_agrees_on_throws_bounces_and_swirls(scene: hoopgen.Engine) -> None:
    check(scene, usual(trials(120, at_least=25)), 0.75)


def test_the_judge_agrees_on_shots_at_edges_and_corners_from_all_sides(
    scene: hoopgen.Engine,
) -> None:
    check(scene, aimed(trials(500, at_least=120), 3), 0.45)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(3))
def test_the_judge_agrees_on_many_shots_at_edges(scene: hoopgen.Engine, seed: int) -> None:
    check(scene, aimed(trials(2000), 10 + seed), 0.45)


def test_c_and_numpy_have_the_same_bits(scene: hoopgen.Engine) -> None:
    states = np.concatenate([usual(300), aimed(1500, 4)])
    one = scene.simulate(states, **OPTIONS, fields=FIELDS)
    other = scene.simulate(states, **OPTIONS, fields=FIELDS, backend="numpy")
    assert one.events.tobytes() == other.events.tobytes()
    for name in FIELDS:
        assert getattr(one, name).tobytes() == getattr(other, name).tobytes(), name
    assert one.proved.tobytes() == other.proved.tobytes()
