"""Rolls on cones, inside and outside, in all directions, up to the ends of their span.

Each roll is integrated again, with the nearest point of the cone and its rate as all that is known
of it: by DOP853, up to where the normal force vanishes or the cone ends.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

pytest.importorskip("flint")

import hoopgen
from hoopgen import Event
from hoopgen.scene import Cone, Parameter, Plane, Scene
from hoopgen.simulation.engine import Engine
from tests.helpers.effort import trials
from tests.scene.test_oblique_rolls import (
    BALL,
    CLAIMS,
    GRAVITY,
    Body,
    check_proofs,
    compare,
    rolled,
)

pytestmark = [
    pytest.mark.slow,
    pytest.mark.xdist_group("cone_rolls"),  # compiled once
]

KAPPA = 2 / 3

Floats = NDArray[np.float64]

FUNNEL = {"apex": (0.0, 0.0, 0.0), "axis": (0.0, 0.0, 1.0), "slope": 1.2, "span": (0.1, 0.5)}
CHUTE = {"apex": (2.0, 0.1, -0.1), "axis": (0.7, 0.2, 0.3), "slope": 0.8, "span": (0.0, 0.9)}
SPIKE = {"apex": (4.0, 0.0, 0.4), "axis": (0.0, 0.0, -1.0), "slope": 1.5, "span": (0.0, 0.5)}
STUMP = {"apex": (6.3, 0.0, 0.1), "axis": (-1.0, 0.1, -0.2), "slope": 0.4, "span": (0.2, 0.9)}
GIVEN: tuple[Mapping[str, Any], ...] = (FUNNEL, CHUTE, SPIKE, STUMP)
INSIDE = (True, True, False, False)


def turned(vector: tuple[float, ...]) -> tuple[str, str, str]:
    """Return a vector that is turned about the z axis by an angle, and then mirrored."""
    x, y, z = vector
    return f"{x}*cos_turn - {y}*sin_turn", f"mirror*({x}*sin_turn + {y}*cos_turn)", f"{z}"


def cones() -> list[Cone]:
    """Return the cones as bodies; the axis of two is a coordinate axis."""
    found = []
    names = ("funnel", "chute", "spike", "stump")
    for name, given, inside in zip(names, GIVEN, INSIDE, strict=True):
        x, y, z = given["axis"]
        axis: Any = ("z" if z > 0 else "-z") if (x, y) == (0, 0) else turned(given["axis"])
        apex = turned(given["apex"])
        sizes = {"slope": given["slope"], "span": given["span"]}
        found.append(Cone(name, inside=inside, apex=apex, axis=axis, **sizes))
    return found


CONES = Scene(
    "cones_to_roll_on",
    parameters=[
        Parameter("cos_turn", 1.0, "1", sign="any"),
        Parameter("sin_turn", 0.0, "1", sign="any"),
        Parameter("mirror", 1.0, "1", sign="any"),
        Parameter("kappa", KAPPA, "1"),
    ],
    bodies=[*cones(), Plane("floor", at=-0.7)],
    ball_radius=BALL,
    gravity=GRAVITY,
    restitution=0.3,
    inertia="kappa",
    rolls=True,
)


@pytest.fixture(scope="module")
def engine() -> Engine:
    return hoopgen.compile(CONES)


def dropped(count: int, seed: int) -> Floats:
    """Return balls that fall onto the cones."""
    chance = np.random.default_rng(seed)
    which = np.arange(count) % 4
    states = np.zeros((count, 9))
    states[:, 0] = np.array([0.0, 2.4, 4.0, 5.8])[which]
    states[:, 1] = np.array([0.0, 0.2, 0.0, 0.05])[which]
    wide = np.array([[0.3, 0.15, 0.3, 0.2], [0.3, 0.15, 0.3, 0.05]])[:, which].T
    states[:, :2] += chance.uniform(-1, 1, (count, 2)) * wide
    states[:, 2] = np.array([0.55, 0.1, 0.6, 0.35])[which] + chance.uniform(0, 0.1, count)
    states[:, 3:5] = chance.normal(0, 0.6, (count, 2)) * np.array([1, 1, 1, 0.3])[which, None]
    states[:, 6:] = chance.normal(0, 5, (count, 3))
    return states


# The second formulation


def height(given: Mapping[str, Any], place: Floats) -> float:
    """Return the way of a place along the axis of a cone, from its apex."""
    axis = np.array(given["axis"])
    return float((place - given["apex"]) @ axis / np.linalg.norm(axis))


def cone(given: Mapping[str, Any]) -> Body:
    """Return a cone, by the generator that is nearest to the ball's centre."""
    apex, unit = np.array(given["apex"]), np.array(given["axis"])
    unit = unit / np.linalg.norm(unit)
    half = np.arctan(given["slope"])

    def nearest(place: Floats) -> tuple[Floats, Floats]:
        across = place - apex - (place - apex) @ unit * unit
        rho = np.linalg.norm(across)
        out = across / rho
        line, around = np.sin(half) * out + np.cos(half) * unit, np.cross(unit, out)
        far = (place - apex) @ line
        share = far * np.sin(half) / rho
        return apex + far * line, np.outer(line, line) + share * np.outer(around, around)

    low, high = given["span"]
    ends = (lambda q: low - height(given, q), lambda q: height(given, q) - high)
    return Body(nearest, ends)


def on_apex(given: Mapping[str, Any]) -> Body:
    """Return the apex of a cone, which a ball touches that is nearer to it than to the side."""
    apex = np.array(given["apex"])
    return Body(lambda _: (apex, np.zeros((3, 3))))


def before_side(given: Mapping[str, Any], state: Floats) -> float:
    """Return how far a ball outside is before the side of a cone, along the axis."""
    sine = np.sin(np.arctan(given["slope"]))
    return -height(given, state[:3]) - BALL * sine


def follower(own: int) -> Callable[[Any, float], tuple[int, float, Floats] | None]:
    """Return the function that integrates a roll on a cone of the scene."""
    given = GIVEN[own]
    axis = np.array(given["axis"])

    def seam(time: float, now: Floats) -> float:
        return -before_side(given, now) if time > 1e-9 else -1e-9

    def follow(begin: Any, until: float) -> tuple[int, float, Floats] | None:
        if begin["surface"] != own:
            return None
        state = begin["after"]
        before = before_side(given, state)
        tipped = before > 1e-12 or (before > -1e-12 and state[3:6] @ axis < 0)
        if tipped and not INSIDE[own]:
            return rolled(on_apex(given), state, until, seam)
        return rolled(cone(given), state, until)

    return follow


@pytest.mark.parametrize("own", range(4))
def test_rolls_on_a_cone_are_those_of_a_second_formulation(engine: Engine, own: int) -> None:
    """They end where the normal force vanishes, or where the point of contact passes an end."""
    states = dropped(trials(400, 200), 1)[own::4]
    shots = engine.simulate(states, time_limit=3, record=True)
    ends = compare(shots, follower(own))
    assert len(ends) > len(states) / 3
    assert not np.any(shots.outcome == engine.outcomes["CAPPED"])


def on_side(own: int, far: Floats, azimuth: Floats, speed: Floats, aside: Floats) -> Floats:
    """Return balls a millimetre above the side of a cone, which will roll along it.

    So far from the apex along a generator, m, with a speed towards the apex and one around the
    axis, m/s, which is any vector.
    """
    given, side = GIVEN[own], -1 if INSIDE[own] else 1
    unit = np.array(given["axis"]) / np.linalg.norm(given["axis"])
    half = np.arctan(given["slope"])
    first = np.cross(unit, [0.3, 0.5, 0.1])
    first /= np.linalg.norm(first)
    second = np.cross(unit, first)
    out = np.cos(azimuth)[:, None] * first + np.sin(azimuth)[:, None] * second
    line, around = np.sin(half) * out + np.cos(half) * unit, np.cross(unit, out)
    normal = side * (np.cos(half) * out - np.sin(half) * unit)
    place = given["apex"] + far[:, None] * line + BALL * normal + [0, 0, 1e-3]
    velocity = aside[:, None] * around - speed[:, None] * line
    return np.hstack([place, velocity, np.cross(normal, velocity) / BALL])


def test_a_ball_rolls_over_the_apex_of_a_cone(engine: Engine) -> None:
    """The apex takes the ball over from the side, and the side from the apex."""
    count = trials(60, 30)
    chance = np.random.default_rng(3)
    far = chance.uniform(0.05, 0.15, count)
    climb = far * np.cos(np.arctan(SPIKE["slope"])) + BALL * (1 - np.sin(np.arctan(1.5)))
    speed = np.sqrt(2 * GRAVITY / (1 + KAPPA) * (climb + chance.uniform(0, 0.02, count)))
    states = on_side(2, far, chance.uniform(0, 6, count), speed, chance.normal(0, 0.03, count))
    shots = engine.simulate(states, time_limit=2, record=True)
    ends = compare(shots, follower(2))
    rolls = shots.events[shots.events["kind"] == Event.ROLL]
    tipped = np.array([before_side(SPIKE, row["after"]) > -1e-12 for row in rolls])
    assert np.count_nonzero(tipped[rolls["surface"] == 2]) > count / 2
    assert ends.count(1) > count / 2
    row = rolls[tipped & (rolls["surface"] == 2)][0]
    path = shots.trajectory(int(row["shot"])).at(row["time"] + np.linspace(0, 1e-2, 5))
    assert np.linalg.norm(path[:, :3] - SPIKE["apex"], axis=1) == pytest.approx(BALL, abs=1e-12)


def test_few_rolls_on_cones_are_uncertain(engine: Engine) -> None:
    shots = engine.simulate(dropped(trials(400, 200), 9), time_limit=3)
    assert np.mean(shots.rolls > 0) > 0.8
    assert np.mean(shots.uncertain) < 0.05


def test_a_ball_that_rolls_straight_to_the_apex_inside_ends_flagged(engine: Engine) -> None:
    """On the lowest generator of the chute, on which it stays: nothing turns it aside."""
    unit = np.array(CHUTE["axis"]) / np.linalg.norm(CHUTE["axis"])
    turns = np.linspace(0, 2 * np.pi, 20001)
    still = np.zeros_like(turns)
    heights = on_side(1, still + 0.3, turns, still, still)[:, 2]
    count = trials(10, 5)
    lowest = np.full(count, turns[np.argmin(heights)])
    speed = np.linspace(1.2, 2, count)
    states = on_side(1, np.full(count, 0.3), lowest, speed, np.zeros(count))
    # Where the plane through the axis is vertical.
    across = np.cross(unit, [0, 0, 1])
    across /= np.linalg.norm(across)
    states[:, :3] -= np.outer((states[:, :3] - CHUTE["apex"]) @ across, across)
    states[:, 3:6] -= np.outer(states[:, 3:6] @ across, across)
    states[:, 6:] = np.outer(states[:, 6:] @ across, across)
    shots = engine.simulate(states, time_limit=2)
    assert np.all(shots.outcome == engine.outcomes["CAPPED"])
    assert shots.uncertain.all()
    place = shots.state[:, :3] - CHUTE["apex"]
    rho = np.linalg.norm(place - np.outer(place @ unit, unit), axis=1)
    assert np.all((rho < BALL / 4096) & (rho > 0.7 * BALL / 4096))


def energy(states: Floats, kappa: float) -> Floats:
    """Return the energy of balls per unit mass."""
    turned = kappa * BALL**2 * np.sum(states[:, 6:] ** 2, axis=1)
    return np.asarray((np.sum(states[:, 3:6] ** 2, axis=1) + turned) / 2 + GRAVITY * states[:, 2])


@pytest.mark.parametrize("kappa", [0.4, 2 / 3, 1.0])
def test_a_ball_that_rolls_keeps_its_energy(engine: Engine, kappa: float) -> None:
    shots = engine.simulate(
        dropped(trials(200, 80), 5), {"kappa": kappa}, time_limit=3, record=True
    )
    events = shots.events
    begins = np.flatnonzero((events["kind"] == Event.ROLL) & (events["surface"] < 4))
    begins = begins[begins + 1 < len(events)]
    change = energy(events["before"][begins + 1], kappa) - energy(events["after"][begins], kappa)
    assert np.max(np.abs(change)) < 1e-12
    assert np.max(events["time"][begins + 1] - events["time"][begins]) > 1


def test_contacts_before_a_roll_on_a_cone_are_proved_or_flagged(engine: Engine) -> None:
    check_proofs(engine, dropped(trials(200, 60), 2), None)


def test_a_scene_that_is_turned_and_mirrored_gives_turned_and_mirrored_rolls(
    engine: Engine,
) -> None:
    """The spin, an axial vector, is mirrored the other way."""
    states = dropped(trials(300, 120), 6)
    angle, mirror = 0.7, -1.0
    c, s = np.cos(angle), np.sin(angle)
    turn = np.diag([1, mirror, 1]) @ np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
    axial = mirror * turn
    moved = np.hstack([states[:, :3] @ turn.T, states[:, 3:6] @ turn.T, states[:, 6:] @ axial.T])
    values = {"cos_turn": c, "sin_turn": s, "mirror": mirror}
    first = engine.simulate(states, time_limit=2, fields=CLAIMS)
    other = engine.simulate(moved, values, time_limit=2, fields=CLAIMS)
    sure = ~(first.uncertain | other.uncertain)
    assert np.count_nonzero(sure) > 0.9 * len(states)
    assert np.array_equal(first.outcome[sure], other.outcome[sure])
    assert np.array_equal(first.rolls[sure], other.rolls[sure])
    for k, by in enumerate((turn, turn, axial)):
        part = slice(3 * k, 3 * k + 3)
        off = np.linalg.norm(first.state[sure, part] @ by.T - other.state[sure, part], axis=1)
        allowed = first.state_error[sure, k] + other.state_error[sure, k]
        # The turn itself rounds the start, by some units in the last place.
        assert np.all(off <= 4 * allowed), np.max(off / allowed)
