"""Scenes in air: parameters, an independent integrator, and the limit without air."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

import hoopgen
from hoopgen.core.parameters import AIR_DEFAULTS
from hoopgen.scene import End, Parameter, Plane, Scene, SceneError, Sphere, Torus
from hoopgen.scene.files import parse_scene
from hoopgen.simulation.engine import Engine
from tests.helpers.effort import trials
from tests.scene.test_gravity import AROUND, BALL

# One worker: each scene is compiled once.
pytestmark = [pytest.mark.xdist_group("air")]

Floats = NDArray[np.float64]

WANTED = ("outcome", "contacts", "first", "time", "state", "uncertain", "time_error", "state_error")

GLOBE = np.array([2.0, 0.0, 1.0])


@cache
def drop(air: bool = True) -> Engine:
    """Return a floor and a globe, in air or without."""
    bodies = [Plane("floor"), Sphere("globe", centre=tuple(GLOBE), radius=0.4)]
    name = "drop_in_air" if air else "drop"
    given: dict[str, Any] = {"ball_radius": 0.125, "gravity": 9.81, "restitution": 0.7}
    return hoopgen.compile(Scene(name, bodies=bodies, **given, air=air))


def throws(shots: int, seed: int = 1) -> Floats:
    """Return throws towards the globe, with spin."""
    random = np.random.default_rng(seed)
    mean = np.array([-1.0, 0.0, 1.5, 4.0, 0.0, 2.0, 0.0, 0.0, 0.0])
    spread = np.array([0.5, 0.3, 0.5, 1.5, 0.5, 1.5, 20.0, 20.0, 20.0])
    return mean + spread * random.normal(size=(shots, 9))


def acceleration(state: Floats, **changed: float) -> Floats:
    """Return the acceleration of a ball of radius 0.125 m, by the equations of motion."""
    of = AIR_DEFAULTS | changed
    velocity, spin = state[3:6], state[6:9]
    area, volume = np.pi * 0.125**2, 4.0 / 3.0 * np.pi * 0.125**3
    half = of["air_density"] * area / (2.0 * of["ball_mass"])
    speed = np.sqrt(velocity @ velocity + of["drag_smoothing_speed"] ** 2)
    weight = 9.81 * (1.0 - of["air_density"] * volume / of["ball_mass"])
    lift = half * 0.125 * of["lift_coefficient"] * np.cross(spin, velocity)
    return lift - half * of["drag_coefficient"] * speed * velocity - np.array([0.0, 0.0, weight])


def motion(_: float, state: Floats) -> Floats:
    """Return the rate of a state of nine numbers."""
    return np.concatenate([state[3:6], acceleration(state), np.zeros(3)])


def integrate(state: Floats, contacts: int) -> list[tuple[float, int, Floats, Floats]]:
    """Return the first contacts of a throw by DOP853: time, body, states before and after."""

    def floor(_: float, y: Floats) -> float:
        return float(y[2] - 0.125)

    def globe(_: float, y: Floats) -> float:
        return float(np.linalg.norm(y[:3] - GLOBE) - 0.525)

    events: list[Callable[..., float]] = [floor, globe]
    for event in events:
        event.terminal, event.direction = True, -1.0  # type: ignore[attr-defined]
    found, time = [], 0.0
    for _ in range(contacts):
        way = solve_ivp(
            motion,
            (0.0, 20.0),
            state,
            "DOP853",
            rtol=1e-13,
            atol=1e-14,
            events=events,
            max_step=0.05,
        )
        body = int(len(way.t_events[1]) > 0)
        before = way.y_events[body][0]
        normal = np.array([0.0, 0.0, 1.0]) if body == 0 else (before[:3] - GLOBE) / 0.525
        after = before.copy()
        after[3:6], after[6:9] = bounce(before[3:6], before[6:9], normal)
        time += way.t_events[body][0]
        found.append((time, body, before, after))
        state = after
    return found


def bounce(velocity: Floats, spin: Floats, normal: Floats) -> tuple[Floats, Floats]:
    """Return velocity and spin of a thin shell after a contact that grips."""
    radius, share = 0.125, 2.0 / 3.0
    slip = velocity - (velocity @ normal) * normal - radius * np.cross(spin, normal)
    change = -share / (1.0 + share) * slip
    turned = spin - np.cross(normal, change) / (share * radius)
    return velocity + change - 1.7 * (velocity @ normal) * normal, turned


@pytest.mark.slow
def test_shots_are_those_of_an_independent_integrator() -> None:
    states = throws(trials(60, at_least=8))
    shots = hoopgen.simulate(states, scene=drop(), max_contacts=3, record=True, fields="all")
    met = 0
    for row, state in enumerate(states):
        own = shots.events[shots.events["shot"] == row]
        for event, other in zip(own, integrate(state, 3), strict=False):
            time, body, before, after = other
            assert event["surface"] == body
            assert abs(event["time"] - time) < 1e-9
            assert np.abs(event["before"] - before).max() < 1e-8
            assert np.abs(event["after"] - after).max() < 1e-7
            met += body
    assert met > 0


@pytest.mark.slow
def test_without_air_the_results_are_those_of_the_parabola() -> None:
    states = throws(20_000, seed=2)
    own = hoopgen.simulate(
        states, {"air_density": 0.0}, scene=drop(), max_contacts=6, fields=WANTED
    )
    plain = hoopgen.simulate(states, scene=drop(air=False), max_contacts=6, fields=WANTED)
    sure = ~own.uncertain & ~plain.uncertain
    assert sure.mean() > 0.99
    for name in ("outcome", "contacts", "first"):
        assert (getattr(own, name) == getattr(plain, name))[sure].all()
    moving = sure & (own.outcome != own.scene.outcomes.INVALID)
    off = np.abs(own.state - plain.state)[moving].reshape(-1, 3, 3).max(axis=2)
    assert (off <= (own.state_error + plain.state_error)[moving]).all()
    late = np.abs(own.time - plain.time)[moving]
    assert (late <= (own.time_error + plain.time_error)[moving]).all()


@pytest.mark.slow
def test_numpy_and_c_give_the_same_bits() -> None:
    states = throws(500, seed=3)
    by_c = hoopgen.simulate(states, scene=drop(), max_contacts=5, fields=WANTED)
    numpy = hoopgen.simulate(states, scene=drop(), max_contacts=5, fields=WANTED, backend="numpy")
    for name in WANTED:
        assert np.array_equal(getattr(by_c, name), getattr(numpy, name), equal_nan=True)


@pytest.mark.slow
def test_a_trajectory_comes_to_its_events_to_the_bit() -> None:
    shots = hoopgen.simulate(throws(20, seed=4), scene=drop(), max_contacts=4, record=True)
    for row in range(20):
        path = shots.trajectory(row)
        for before, event in zip(path.events[:-1], path.events[1:], strict=True):
            flown = path.scene.fly(event["time"] - before["time"], before["after"], path.parameters)
            assert np.abs(flown - event["before"]).max() < 1e-13


@pytest.mark.slow
def test_no_times_give_no_states() -> None:
    shots = drop().simulate(throws(1), record=True)
    assert shots.trajectory(0).at(np.empty(0)).shape == (0, 9)
    assert shots.trajectory(0).at(np.empty((2, 0))).shape == (2, 0, 9)


@pytest.mark.slow
def test_energy_falls_by_the_work_of_drag_alone() -> None:
    """The Magnus force does no work, and buoyancy makes gravity less."""
    state = np.array([0.0, 0.0, 5.0, 6.0, 1.0, 4.0, 10.0, -30.0, 20.0])
    nodes, weights = np.polynomial.legendre.leggauss(30)
    times = 0.4 * (nodes + 1.0)
    engine = drop()
    path = engine.fly(times, np.tile(state, (30, 1)), engine.parameters)
    speed = np.linalg.norm(path[:, 3:6], axis=1)
    half = 1.2 * np.pi * 0.125**2 / (2.0 * 0.624)
    power = half * 0.5 * np.sqrt(speed**2 + 0.05**2) * speed**2
    work = 0.4 * float(weights @ power)
    end = engine.fly(0.8, state, engine.parameters)
    weight = 9.81 * (1.0 - 1.2 * 4.0 / 3.0 * np.pi * 0.125**3 / 0.624)
    energy = [weight * s[2] + 0.5 * s[3:6] @ s[3:6] for s in (state, end)]
    assert energy[0] - energy[1] == pytest.approx(work, rel=1e-12)


@pytest.mark.slow
def test_a_falling_ball_comes_to_its_terminal_velocity() -> None:
    engine = drop()
    end = engine.fly(30.0, np.array([0.0, 0.0, 1000.0, *[0.0] * 6]), engine.parameters)
    half = 1.2 * np.pi * 0.125**2 * 0.5 / (2.0 * 0.624)
    weight = 9.81 * (1.0 - 1.2 * 4.0 / 3.0 * np.pi * 0.125**3 / 0.624)
    assert -end[5] == pytest.approx(np.sqrt(weight / half), rel=1e-5)


@pytest.mark.slow
def test_what_the_air_cannot_be_is_invalid_and_loses_no_other_row() -> None:
    states = throws(6, seed=5)
    given = {
        "air_density": np.array([1.2, -1.0, np.nan, 1.2, 1.2, 1.2]),
        "ball_mass": np.array([0.6, 0.6, 0.6, 0.0, 0.0098, 0.0099]),
    }
    shots = hoopgen.simulate(states, given, scene=drop(), max_contacts=2)
    invalid = shots.scene.outcomes.INVALID
    # A ball of 0.125 m displaces 9.8175 g of this air.
    assert list(shots.outcome == invalid) == [False, True, True, True, True, False]


@pytest.mark.slow
def test_a_ball_that_can_meet_nothing_more_is_short() -> None:
    """One falls below the end, one rises through it first, one is carried up by its spin."""
    bodies = [Sphere("globe", radius=0.4)]
    given: dict[str, Any] = {"ball_radius": 0.125, "gravity": 9.81, "restitution": 1}
    scene = Scene("above", bodies=bodies, ends={"down": End(at=-1)}, air=True, **given)
    states = np.zeros((3, 9))
    states[:, 2], states[:, 3] = -2.0, 5.0
    states[1, 5] = 9.0
    states[2, 7] = -900.0
    shots = hoopgen.simulate(states, scene=scene, time_limit=3.0)
    named = [shots.scene.outcomes(int(one)).name for one in shots.outcome]
    assert named == ["SHORT", "DOWN", "DOWN"]

    def above(_: float, y: Floats) -> float:
        return float(y[2] + 1.0)

    above.terminal, above.direction = True, -1.0  # type: ignore[attr-defined]
    for state, time in zip(states[1:], shots.time[1:], strict=True):
        way = solve_ivp(motion, (0.0, 3.0), state, "DOP853", rtol=1e-13, atol=1e-14, events=above)
        assert abs(way.t_events[0][0] - time) < 1e-9


def test_a_scene_declares_parameters_of_the_air_itself() -> None:
    mass = Parameter("ball_mass", 0.0459, "kg", "a golf ball")
    given: dict[str, Any] = {"bodies": AROUND[:1], "ball_radius": 0.0213, "gravity": 9.81}
    scene = Scene("golf", parameters=[mass], restitution=0.8, air=True, **given)
    assert scene.defaults == {**AIR_DEFAULTS, "ball_mass": 0.0459}
    with pytest.raises(SceneError, match=r"air: expected true or false, got 'yes'"):
        Scene("golf", restitution=0.8, air="yes", **given)  # type: ignore[arg-type]


def test_a_file_says_that_there_is_air() -> None:
    text = b"""
name = "garden"
air = true
ball_radius = 0.12
gravity = 9.81
restitution = 0.7

[parameters.air_density]
default = 1.0
unit = "kg"

[bodies.floor]
kind = "plane"
"""
    scene = parse_scene(text)
    assert scene.air
    assert scene.defaults["air_density"] == 1.0
    assert scene.defaults["drag_coefficient"] == 0.5


@pytest.mark.slow
def test_bodies_of_all_kinds_are_met_as_without_air() -> None:
    """The density is zero: the searches along pieces find what those along parabolas find."""
    given: dict[str, Any] = {"bodies": AROUND, "ball_radius": BALL, "gravity": 9.81}
    given |= {"restitution": 0.7, "friction": 0.4}
    in_air = hoopgen.compile(Scene("around_in_air", air=True, **given))
    plain = hoopgen.compile(Scene("around", **given))
    random = np.random.default_rng(7)
    states = random.normal(size=(trials(10_000, at_least=2_000), 9))
    states *= np.repeat([1.5, 4.0, 20.0], 3)
    own = in_air.simulate(states, {"air_density": 0.0}, max_contacts=6, fields=WANTED, time_limit=4)
    other = plain.simulate(states, max_contacts=6, fields=WANTED, time_limit=4)
    sure = ~own.uncertain & ~other.uncertain
    assert sure.mean() > 0.98
    same = (own.contacts == other.contacts) & (own.first == other.first)
    assert same[sure].all()
    moving = sure & (own.outcome != in_air.outcomes.INVALID)
    off = np.abs(own.state - other.state)[moving].reshape(-1, 3, 3).max(axis=2)
    assert (off <= (own.state_error + other.state_error)[moving]).all()
    assert set(np.unique(own.first[moving])) >= set(range(len(AROUND)))


SUNKEN = Scene(
    "ring_above_sunken_balls",
    bodies=[Torus("ring", radius=0.235, wire=0.01)],
    ends={"past": End(at=-2), "within": End(at=-0.5, within=["x**2 + y**2 - 0.05"])},
    ball_radius=0.12,
    gravity=9.81,
    restitution=0.7,
    air=True,
)
"""A ring and ends, which balls that rise from below mostly do not come up to."""


def check_sunken_balls(engine: Engine) -> None:
    """A ball that can meet nothing any more is SHORT, wherever its pieces begin."""
    random, count, limit = np.random.default_rng(0), trials(40, at_least=30), 0.2
    states = np.zeros((count, 9))
    states[:, :2] = random.uniform([0, -2], [3, 2], (count, 2))
    states[:, 2], states[:, 3:5] = -3, random.normal(0, 0.5, (count, 2))
    states[:, 5] = 9.81 * limit * random.uniform(0.85, 1.05, count)  # highest about the limit
    shots = engine.simulate(states, time_limit=limit, record=True)
    proofs = engine.certify(states, time_limit=limit, processes=1)
    assert np.all(proofs.agrees(shots))
    assert not np.any(shots.uncertain)
    for outcome in ("SHORT", "ENDLESS"):
        assert np.mean(shots.outcome == engine.outcomes[outcome]) > 0.2


def test_a_ball_that_has_sunk_at_the_time_limit_is_short() -> None:
    pytest.importorskip("flint")
    check_sunken_balls(hoopgen.compile(SUNKEN))
