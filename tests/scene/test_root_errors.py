"""Contacts whose own roundings exceed those of the flight are within their claimed errors."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import hoopgen
from hoopgen.judge import Certificate
from hoopgen.scene import Parameter, Plane, Scene, Surface, Torus
from hoopgen.simulation.engine import Engine
from tests.helpers.effort import trials

Floats = NDArray[np.float64]


def floating(name: str, body: Any, air: bool = False) -> Scene:
    """Return a scene with one body and no gravity."""
    return Scene(name, bodies=[body], ball_radius=0.0625, gravity=0, restitution=0.75, air=air)


def expanded(distance: int, sign: str = "") -> Surface:
    """Return a ball of 0.5 m, or a cavity, as an expanded polynomial, so far from the origin."""
    formula = f"x**2 + y**2 + z**2 - {2 * distance}*x + {distance**2 - 0.25}"
    return Surface("body", condition=f"{sign}({formula})")


FAR = floating("far", expanded(100))
FURTHER = floating("further", expanded(10_000))
CAVITY = floating("cavity", expanded(10_000, "-"))
WIDE = floating("wide", Torus("hoop", radius=16, wire=0.15625, axis="x"))
THIN_HOOP = Torus("hoop", radius=16, wire=0.015625, axis="x")
THIN = floating("thin", THIN_HOOP)
GRAZED = floating("grazed", Plane("slope", normal=(1, 2, 2)))
FAR_IN_AIR = floating("far_in_air", expanded(100), air=True)
THIN_IN_AIR = floating("thin_in_air", THIN_HOOP, air=True)
IN_AIR = (FAR_IN_AIR, THIN_IN_AIR)
SCENES = {s.name: s for s in (FAR, FURTHER, CAVITY, WIDE, THIN, GRAZED, *IN_AIR)}
UPRIGHT = Scene(
    "upright",
    parameters=[Parameter(name, 0.8, "1", sign="any") for name in ("east", "north")],
    bodies=[Plane("wall", normal=("east", "north", 0))],
    ball_radius=0.0625,
    gravity=9.81,
    restitution=0.75,
)


def _aimed(name: str, count: int) -> Floats:
    """Return balls thrown at the body of a scene."""
    chance = np.random.default_rng(5)
    states = np.zeros((count, 9))
    states[:, 6:] = chance.normal(0, 10, (count, 3))
    if name == "grazed":
        steep = 10.0 ** chance.uniform(-12, -10, count)
        along = chance.normal(0, 1, (count, 2))
        along /= np.linalg.norm(along, axis=1)[:, None]
        axes = np.array([[2, 1, -2], [2, -2, 1], [1, 2, 2]]) / 3
        way = 10.0 ** chance.uniform(0, 4, count)
        height = 0.0625 + steep * way
        states[:, :3] = height[:, None] * axes[2] - way[:, None] * (along @ axes[:2])
        states[:, 3:6] = along @ axes[:2] - steep[:, None] * axes[2]
        return states
    away = chance.normal(0, 1, (count, 3))
    away /= np.linalg.norm(away, axis=1)[:, None]
    near = chance.uniform(-0.4, 0.4, (count, 3))
    if name.startswith(("wide", "thin")):
        angle = chance.uniform(0, 2 * np.pi, count)
        middle = 16 * np.stack([0 * angle, np.cos(angle), np.sin(angle)], axis=1)
        near *= 0.2
    else:
        middle = np.array([100.0 if name.startswith("far") else 10_000.0, 0, 0])
    states[:, :3] = middle + (0.2 * away if name == "cavity" else 2 * away)
    states[:, 3:6] = chance.uniform(0.5, 4, (count, 1)) * (middle + near - states[:, :3])
    return states


@cache
def _proved(name: str, most: int) -> tuple[Floats, Certificate]:
    """Return balls thrown at the body of a scene, and what the judge proves of them."""
    scene = SCENES[name]
    states = _aimed(name, trials(100, at_least=40) if scene.air else trials(300, at_least=100))
    return states, hoopgen.certify(
        states, scene=scene, max_contacts=most, time_limit=time_limit(scene), processes=1
    )


def time_limit(scene: Scene) -> float:
    """Return a time limit; in air every piece of a flight has to be proved."""
    return 1.5 if scene.air else 3e4


def check_states(engine: Engine, most: int = 1) -> None:
    """Assert that the state after so many contacts is strictly within its claimed errors."""
    states, proof = _proved(engine.name, most)
    names = ("outcome", "uncertain", "contacts", "time", "state", "time_error", "state_error")
    limit = time_limit(SCENES[engine.name])
    shots = engine.simulate(states, max_contacts=most, time_limit=limit, fields=names)
    sure = (shots.outcome != engine.outcomes["INVALID"]) & ~shots.uncertain & proof.decided
    assert (sure & (shots.contacts > 0)).mean() > 0.1
    away = np.abs(shots.state - proof.state).reshape(-1, 3, 3).max(axis=2)
    parts = ("position", "velocity", "spin")
    sure &= shots.contacts > 0
    bounds = (shots.state_error + proof.state_error)[sure]
    ratios = (away[sure] / bounds).max(axis=0)
    worst = dict(zip(parts, ratios, strict=True))
    late = np.abs(shots.time - proof.time)[sure]
    until = (shots.time_error + proof.time_error)[sure]
    timed = late > 0  # a time limit is exact
    worst["time"] = max(late[timed] / until[timed], default=0.0)
    assert max(worst.values()) < 1, worst


def check_returns(engine: Engine) -> None:
    """Assert the same of balls that leave the inside of the thin torus for another place there.

    In air they are there before the first piece of the flight ends.
    """
    chance = np.random.default_rng(9)
    count = trials(300, at_least=100)
    angle = chance.uniform(0, 2 * np.pi, count)
    air = SCENES[engine.name].air
    turned = angle + (chance.uniform(0.3, 0.9, count) if air else chance.uniform(2, 4, count))
    reach = 0.0625 + 0.015625
    states = np.zeros((count, 9))
    states[:, 1:3] = (16 - reach) * np.stack([np.cos(angle), np.sin(angle)], axis=1)
    target = np.stack([np.cos(turned), np.sin(turned)], axis=1)
    states[:, 3] = chance.uniform(-0.8, 0.8, count) * reach
    states[:, 4:6] = 16 * target - states[:, 1:3]
    if air:
        states[:, 3:6] *= 20 / np.linalg.norm(states[:, 3:6], axis=1)[:, None]
    given: Any = {
        "leaving": np.zeros(len(states), dtype=int),
        "max_contacts": 1,
        "time_limit": 1.5,
    }
    proof = hoopgen.certify(states, scene=SCENES[engine.name], processes=1, **given)
    names = ("uncertain", "contacts", "state", "state_error")
    shots = engine.simulate(states, fields=names, **given)
    sure = ~shots.uncertain & proof.decided & (shots.contacts > 0)
    assert sure.mean() > 0.5
    away = np.abs(shots.state - proof.state).reshape(-1, 3, 3).max(axis=2)
    assert (away < shots.state_error + proof.state_error)[sure].all()


def check_upright(engine: Engine) -> None:
    """Assert the same, and that claims are finite, of grazes of an upright wall under gravity."""
    chance = np.random.default_rng(3)
    count = trials(300, at_least=100)
    turned = chance.uniform(0, 2 * np.pi, count)
    normal, along, gravity = np.zeros((count, 3)), np.zeros((count, 3)), np.array([0, 0, -9.81])
    normal[:, :2] = np.stack([np.cos(turned), np.sin(turned)], axis=1)
    along[:, :2] = np.stack([-np.sin(turned), np.cos(turned)], axis=1)
    steep = 10.0 ** chance.uniform(-11, -8, (count, 1))
    lasting = 10.0 ** chance.uniform(-2, 0, (count, 1))
    states = np.zeros((count, 9))
    states[:, 3:6] = along - steep * normal - lasting * gravity
    states[:, :3] = 0.0625 * normal - lasting * states[:, 3:6] - lasting**2 / 2 * gravity
    states[:, 6:] = chance.normal(0, 10, (count, 3))
    parameters = {"east": normal[:, 0].copy(), "north": normal[:, 1].copy()}
    given: Any = {"max_contacts": 1, "time_limit": 30.0}
    proof = hoopgen.certify(states, parameters, scene=UPRIGHT, processes=1, **given)
    names = ("uncertain", "contacts", "state", "state_error")
    shots = engine.simulate(states, parameters, fields=names, **given)
    sure = ~shots.uncertain & proof.decided & (shots.contacts > 0)
    assert sure.mean() > 0.5
    away = np.abs(shots.state - proof.state).reshape(-1, 3, 3).max(axis=2)
    assert np.isfinite(shots.state_error[sure]).all()
    assert (away < shots.state_error + proof.state_error)[sure].all()


@pytest.mark.slow
def test_upright_walls_are_grazed_with_finite_claims() -> None:
    check_upright(hoopgen.compile(UPRIGHT))


@pytest.mark.parametrize("scene", [THIN_IN_AIR, THIN], ids=lambda scene: scene.name)
@pytest.mark.slow
def test_returns_are_within_their_claimed_errors(scene: Scene) -> None:
    check_returns(hoopgen.compile(scene))


CASES = [(name, 1) for name in SCENES] + [("far", 3), ("wide", 3), ("thin", 3)]
"""At 10 km every shot is flagged after its first contact: the body is known to 1e-7 m there."""


@pytest.mark.parametrize(("name", "most"), CASES)
@pytest.mark.sampled(1)
def test_states_are_within_their_claimed_errors(name: str, most: int) -> None:
    check_states(hoopgen.compile(SCENES[name]), most)
