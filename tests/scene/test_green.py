"""Chips onto a green with a hole, whose edge is a wire: rolls on the wire, into the hole and out.

A ball on the wire that comes up again rolls on where the green begins: there both surfaces touch
it, with one normal, and neither stops it.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

import hoopgen
from hoopgen import Event
from hoopgen.scene import Cylinder, End, Scene
from hoopgen.simulation.engine import Engine
from tests.helpers.derived import engine_of
from tests.helpers.effort import exceptions, trials
from tests.helpers.slow_scene import Slow
from tests.scene.test_edges import GRAVITY, GREEN, HOLE, HOLE_BALL, putts

pytestmark = [
    pytest.mark.xdist_group("edges"),  # the scene is compiled once
]

ON_WIRE = 1
"""The index of the wire."""

KAPPA = 2 / 5
SHARE = KAPPA / (1 + KAPPA)

Floats = NDArray[np.float64]


@pytest.fixture(scope="module")
def green() -> Engine:
    return hoopgen.compile(GREEN)


def chips(count: int, seed: int = 1) -> Floats:
    """Return balls that fall onto the green some decimetres from the hole, with any spin."""
    random = np.random.default_rng(seed)
    states = np.zeros((count, 9))
    states[:, 0] = random.uniform(-0.6, -0.2, count)
    states[:, 1] = random.normal(0, 0.03, count)
    states[:, 2] = random.uniform(0.05, 0.3, count)
    states[:, 3] = random.uniform(0.1, 1.2, count)
    states[:, 4] = random.normal(0, 0.1, count)
    states[:, 5] = random.normal(0, 0.5, count)
    states[:, 6:] = random.normal(0, 10, (count, 3))
    return states


def pushed(state: Floats) -> tuple[float, Floats]:
    """Return the normal force on a ball on the wire, and its rates, as BALL's laws say."""
    place, velocity, spin = state[:3], state[3:6], state[6:]
    distance = np.hypot(*place[:2])
    outward = np.array([place[0], place[1], 0]) / distance
    normal = (place - HOLE * outward) / HOLE_BALL
    along = np.array([velocity[0], velocity[1], 0])
    turning = (velocity - HOLE * (along - outward * (outward @ velocity)) / distance) / HOLE_BALL
    fall = np.array([0, 0, -GRAVITY])
    force = float(-fall @ normal - velocity @ turning)
    twist = HOLE_BALL * (spin @ normal) * np.cross(normal, turning)
    friction = SHARE * (twist - fall + (fall @ normal) * normal)
    turns = -np.cross(normal, friction) / (KAPPA * HOLE_BALL)
    return force, np.concatenate([velocity, fall + force * normal + friction, turns])


def rolled(state: Floats) -> tuple[bool, float, Floats]:
    """Return whether the ball leaves the wire, else comes over the green, and when and where."""

    def lost(_: float, now: Floats) -> float:
        return pushed(now)[0]

    def over(time: float, now: Floats) -> float:
        return float(np.hypot(*now[:2]) - HOLE) if time > 1e-9 else -1.0

    lost.terminal = over.terminal = True  # type: ignore[attr-defined]
    lost.direction, over.direction = -1, 1  # type: ignore[attr-defined]
    options = {"rtol": 1e-13, "atol": 1e-15, "method": "DOP853"}
    path = solve_ivp(lambda _, s: pushed(s)[1], (0, 5), state, events=(lost, over), **options)
    leaves = len(path.t_events[0]) > 0
    which = 0 if leaves else 1
    return leaves, path.t_events[which][0], path.y_events[which][0]


@pytest.mark.slow
def test_few_chips_are_uncertain(green: Engine) -> None:
    """They roll onto the wire, off it, and some of them out of the hole again."""
    shots = green.simulate(chips(trials(600, 100)), time_limit=20)
    assert np.count_nonzero(shots.rolls == 2) > len(shots) / 5
    assert np.count_nonzero(shots.rolls > 2) > len(shots) / 100
    assert np.count_nonzero(shots.uncertain) <= exceptions(0.015, len(shots))


@pytest.mark.slow
def test_rolls_on_the_wire_are_those_of_a_second_formulation(green: Engine) -> None:
    shots = green.simulate(chips(trials(200, 100)), time_limit=20, record=True)
    events = shots.events
    begins = np.flatnonzero((events["kind"] == Event.ROLL) & (events["surface"] == ON_WIRE))
    left = back = 0
    for k in begins:
        begin, end, following = events[k : k + 3]
        if end["time"] == begin["time"] or shots.uncertain[begin["shot"]]:
            continue
        leaves, lasting, state = rolled(begin["after"])
        assert end["time"] - begin["time"] == pytest.approx(lasting, abs=1e-11)
        assert end["after"][:3] == pytest.approx(state[:3], abs=1e-11)
        assert end["after"][3:6] == pytest.approx(state[3:6], abs=1e-10)
        taken = following["kind"] == Event.ROLL and following["time"] == end["time"]
        assert taken == (not leaves)
        left, back = left + leaves, back + (not leaves)
    assert left > 10
    assert back > 0


def lip_out() -> Floats:
    """Return a ball that rolls over a side of the hole and comes up again."""
    state = putts(np.array([0.6]))
    state[0, 1] = 0.052
    return state


@pytest.mark.slow
def test_a_ball_that_comes_up_again_goes_back_where_it_came_from(green: Engine) -> None:
    """Rolling without slip can be reversed: so the way back from the green is the way out."""
    events = green.simulate(lip_out(), time_limit=20, record=True).events
    rolls = events[events["kind"] == Event.ROLL]
    assert list(rolls["surface"][:3]) == [0, ON_WIRE, 0]
    returned = rolls[2]["after"].copy()
    returned[:3] += 0.1 * returned[3:6]
    returned[2] += 1e-9  # clearly off the green
    returned[3:] *= -1
    shots = green.simulate(returned, time_limit=20, record=True)
    assert not shots.uncertain.any()
    again = shots.events[shots.events["kind"] == Event.ROLL]
    assert list(again["surface"][:3]) == [0, ON_WIRE, 0]
    assert again[2]["after"][:3] == pytest.approx(rolls[1]["after"][:3], abs=1e-11)
    assert again[2]["after"][3:6] == pytest.approx(-rolls[1]["after"][3:6], abs=1e-10)


@pytest.mark.slow
def test_a_ball_that_the_wire_does_not_press_on_flies_over_it(green: Engine) -> None:
    """The force is N = g - v²/R and grows while the ball crosses the wire at a slant."""
    state = chips(600)[91]
    shots = green.simulate(state, time_limit=20, record=True)
    assert not shots.uncertain.any()
    events = shots.events
    on_wire = np.flatnonzero((events["kind"] == Event.ROLL) & (events["surface"] == ON_WIRE))[0]
    force, _ = pushed(events[on_wire]["after"])
    assert force < -1
    assert events[on_wire + 1]["kind"] == Event.LEAVE
    assert events[on_wire + 1]["time"] == events[on_wire]["time"]


@pytest.mark.slow
def test_straight_putts_leave_the_wire_as_those_a_micrometre_aside(green: Engine) -> None:
    """The wire takes them over exactly at the bound of the green, and throws the faster ones off.

    Those fly on from there: the first body that they touch, and when, are those of a slow search.
    """
    straight = putts(np.linspace(0.3, 1.6, trials(400, 80)))
    aside = straight.copy()
    aside[:, 1] = 1e-6
    shots, others = (green.simulate(s, time_limit=20, record=True) for s in (straight, aside))
    assert not np.count_nonzero(shots.outcome == green.outcomes["CAPPED"])
    assert np.count_nonzero(shots.uncertain) <= np.count_nonzero(others.uncertain)
    sure = ~shots.uncertain & ~others.uncertain
    assert np.count_nonzero(sure) > 0.9 * len(straight)
    assert np.array_equal(shots.outcome[sure], others.outcome[sure])
    assert np.array_equal(shots.rolls[sure], others.rolls[sure])
    slow, thrown = Slow(GREEN), 0
    for row in np.flatnonzero(sure):
        events = shots.events[shots.events["shot"] == row]
        last = int(np.flatnonzero(events["kind"] == Event.ROLL)[1]) + 1
        assert events["kind"][last] == Event.LEAVE
        if events["time"][last] != events["time"][last - 1]:
            continue
        state, following = events["after"][last].copy(), events[last + 1]
        assert state[3] ** 2 > GRAVITY * HOLE_BALL
        wait = 2.0**-8  # clear of the wire
        state[:3] += wait * state[3:6]
        state[2] -= GRAVITY * wait**2 / 2
        state[5] -= GRAVITY * wait
        found = slow.fly(state, 1)
        if found.close:
            continue
        thrown += 1
        at, kind = (
            (found.contacts[0][1], Event.IMPACT) if found.contacts else (found.time, Event.END)
        )
        assert following["kind"] == kind
        assert following["time"] - events["time"][last] == pytest.approx(wait + at, abs=1e-9)
    assert thrown > len(straight) / 2


TROUGH = Scene(
    "trough",
    bodies=[Cylinder("trough", radius=0.3, axis="x", inside=True, span=(-1, 0.5))],
    ball_radius=HOLE_BALL,
    gravity=GRAVITY,
    restitution=0.3,
    inertia="2/5",
    rolls=True,
    ends={"down": End(at=-1)},
)
"""A half pipe and its other half, which end in the air."""


@pytest.mark.slow
def test_a_ball_rolls_along_a_trough_and_off_its_end(tmp_path: Path) -> None:
    """The ball swings from side to side, keeps its energy, and flies from where the trough ends."""
    engine = engine_of(TROUGH, tmp_path)
    random = np.random.default_rng(6)
    states = np.zeros((20, 9))
    states[:, 1] = random.uniform(-0.1, 0.1, 20)
    states[:, 2] = -0.2
    states[:, 3] = random.uniform(0.5, 1.5, 20)
    states[:, 6:] = random.normal(0, 5, (20, 3))
    shots = engine.simulate(states, time_limit=20, record=True)
    assert np.count_nonzero(shots.uncertain) <= 1
    events, left = shots.events, 0

    def energy(state: Floats) -> float:
        turning = HOLE_BALL**2 * (state[6:] @ state[6:])
        return float(state[3:6] @ state[3:6] / 2 + turning / 5 + GRAVITY * state[2])

    for k in np.flatnonzero(events["kind"] == Event.LEAVE):
        begin, end, last = events[k - 1 : k + 2]
        assert abs(end["after"][0] - 0.5) <= 2.0**-47  # where an event has come
        assert energy(end["after"]) == pytest.approx(energy(begin["after"]), rel=1e-12)
        assert last["kind"] == Event.END
        lasting = last["time"] - end["time"]
        there = end["after"][:3] + lasting * end["after"][3:6]
        there[2] -= GRAVITY * lasting**2 / 2
        assert last["after"][:3] == pytest.approx(there, abs=1e-13)
        left += 1
    assert left > 10
