"""Roots on bodies as flat and as large as can be: states are within their claimed errors."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import hoopgen
from hoopgen.judge import Certificate
from hoopgen.scene import Cylinder, End, Parameter, Plane, Scene, Sphere, Surface
from hoopgen.simulation.engine import Engine
from tests.helpers.effort import trials

Floats = NDArray[np.float64]


def facing(name: str, body: Any) -> Scene:
    """Return a scene with one body, whose surface is at x = -1."""
    return Scene(name, bodies=[body], ball_radius=0.0625, gravity=9.75, restitution=0.75)


STEEP = facing("steep", Plane("wall", normal=(1, 0, 1e-4), point=(-1, 0, 0)))
"""Gravity lies nearly along the plane, so that the gap is nearly linear in time."""
DRAWN = facing("drawn", Surface("wall", condition="x + 1 + 1e-4*z"))
"""The same as a condition, which the general search meets."""
FLAT = facing("flat", Surface("dish", condition="x + 1 + 1e-9*z**2"))
LARGE = facing("large", Sphere("globe", radius=1e5, centre=(-100_001, 0, 0)))
ROUND = facing("round", Cylinder("barrel", radius=100, centre=(-101, 0, 0), axis=(0.1, 0.2, 1)))
SCENES = {scene.name: scene for scene in (STEEP, DRAWN, FLAT, LARGE, ROUND)}


@cache
def against_the_wall(name: str, most: int) -> tuple[Floats, Certificate]:
    """Return balls thrown at what stands at x = -1, and what the judge proves of them."""
    chance = np.random.default_rng(3)
    states = np.zeros((trials(400, at_least=100), 9))
    states[:, :3] = chance.uniform((-0.8, -1, -1), (1, 1, 1), (len(states), 3))
    states[:, 3:6] = chance.normal(0, 2, (len(states), 3))
    states[:, 3] = -0.2 - np.abs(states[:, 3])
    states[:, 6:] = chance.normal(0, 10, (len(states), 3))
    return states, hoopgen.certify(
        states, scene=SCENES[name], max_contacts=most, time_limit=20.0, processes=1
    )


def check_states(engine: Engine, most: int = 1) -> None:
    """Assert that the state after so many contacts is within its claimed errors."""
    states, proof = against_the_wall(engine.name, most)
    names = ("outcome", "uncertain", "time", "state", "time_error", "state_error")
    shots = engine.simulate(states, max_contacts=most, time_limit=20.0, fields=names)
    sure = (shots.outcome != engine.outcomes["INVALID"]) & ~shots.uncertain & proof.decided
    assert sure.mean() > 0.6
    away = np.abs(shots.state - proof.state).reshape(-1, 3, 3).max(axis=2)
    assert (away <= shots.state_error + proof.state_error)[sure].all()
    late = np.abs(shots.time - proof.time)
    assert (late <= shots.time_error + proof.time_error)[sure].all()


@pytest.mark.parametrize("most", [1, 3])
@pytest.mark.parametrize("name", list(SCENES))
@pytest.mark.slow
def test_states_at_contacts_are_within_their_claimed_errors(name: str, most: int) -> None:
    check_states(hoopgen.compile(SCENES[name]), most)


@pytest.mark.slow
def test_the_error_of_the_velocity_at_an_end_contains_its_last_rounding() -> None:
    """Gravity is so small that no delay of the end changes the velocity by as much."""
    floating = Scene(
        "hardly_falling",
        bodies=[Plane("floor")],
        ball_radius=0.0625,
        parameters=[Parameter("pull", 1e-5, "m/s²", sign="nonnegative")],
        gravity="pull",
        restitution=0.75,
        ends={"gone": End(axis="x", at=1)},
    )
    state = [4, 0, 2, -1, 0, 0.7, 0, 0, 0]
    shot = hoopgen.compile(floating).simulate(state, fields=("outcome", "state", "state_error"))
    assert shot.state_error[0, 1] >= np.spacing(np.abs(shot.state[0, 3:6]).max()) / 2
