"""Rolls on boxes up to bounds, along the axes and turned: on faces, edges and corners.

Each roll is integrated again, with the nearest point of the box and its rate as all that is known
of it: by DOP853, from seam to seam, up to where the normal force vanishes or a bound is passed.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.optimize import brentq, minimize_scalar

pytest.importorskip("flint")

import hoopgen
from hoopgen import Event
from hoopgen.scene import Box, Parameter, Plane, Scene
from hoopgen.simulation.engine import Engine
from tests.helpers.bounded_rolls import bound, turned_bounds
from tests.helpers.effort import occurrences, trials
from tests.scene import test_oblique_rolls as rolls
from tests.scene.test_cone_rolls import energy, turned
from tests.scene.test_oblique_rolls import CENTRE, CLAIMS, SIZE, check_proofs, compare
from tests.scene.test_torus_rolls import agree
from tests.scene.test_turned_boxes import rotation

pytestmark = [
    pytest.mark.slow,
    pytest.mark.xdist_group("bounded_box_rolls"),  # compiled once
]

Floats = NDArray[np.float64]

TURN = ("q0", "q1", "q2", "q3")
BOUNDS = ("x - 0.35 - z/5", "x**2 + (y - 0.2)**2 - 0.16")
ASIDE = 3.0
"""The way along x from the one box to the other, m."""

AXES = np.array([1.0, 0.0, 0.0, 0.0])
OF_SLAB = ("y + x/3 - 0.45", "z/3 - x - 0.35")

FLOOR = -1.2
PLACES = ((-4.0, 0.0, -1.1), (-4.0, 3.0, -1.0))
"""Centres of a box along the axes and of a turned one that stand on the floor, m."""

BESIDE = (
    ("y + (x + 4)/3 - 0.05", "z/3 - (x + 4) - 0.1"),
    ("(x + 4) - 0.1 - z/5", "(x + 4)**2 + (y - 3.1)**2 - 0.2"),
)

SLABS = Scene(
    "boxes_with_bounds_to_roll_on",
    parameters=[
        Parameter("cos_turn", 1.0, "1", sign="any"),
        Parameter("sin_turn", 0.0, "1", sign="any"),
        Parameter("mirror", 1.0, "1", sign="any"),
        *(
            Parameter(name, value, "1", sign="any")
            for name, value in zip(TURN, (0.98, 0.1, 0.05, 0.15), strict=True)
        ),
    ],
    bodies=[
        Box(
            "crate",
            size=SIZE,
            centre=turned(CENTRE),
            orientation=TURN,
            within=turned_bounds(*BOUNDS),
        ),
        Box(
            "slab",
            size=SIZE,
            centre=(CENTRE[0] + ASIDE, *CENTRE[1:]),
            within=["y + (x - 3)/3 - 0.45", "z/3 - (x - 3) - 0.35"],
        ),
        Box("gate", size=SIZE, centre=PLACES[0], within=BESIDE[0]),
        Box(
            "post",
            size=SIZE,
            centre=turned(PLACES[1]),
            orientation=TURN,
            within=turned_bounds(*BESIDE[1]),
        ),
        Plane("floor", at=FLOOR),
    ],
    ball_radius=rolls.BALL,
    gravity=rolls.GRAVITY,
    restitution=0.4,
    rolls=True,
)


@pytest.fixture(scope="module")
def engine() -> Engine:
    return hoopgen.compile(SLABS)


def dropped(count: int, seed: int) -> tuple[Floats, dict[str, Any]]:
    """Return balls that fall onto both boxes in turn, and rotations of the one."""
    states, values = rolls.turned(count, seed)
    states[1::2, 0] += ASIDE
    return states, values


def rolling(own: int, count: int, seed: int) -> tuple[Floats, dict[str, Any]]:
    """Return balls that roll on the topmost face of a box where it is, and rotations of the box."""
    chance = np.random.default_rng(seed)
    turns = chance.normal(0, 1, (8 * count, 4)) if own == 0 else np.tile(AXES, (8 * count, 1))
    axes, half = rotation(turns), np.array(SIZE) / 2
    top = np.argmax(np.abs(axes[:, 2]), axis=1)
    rows = np.arange(len(turns))
    side = np.sign(axes[rows, 2, top])
    local = chance.uniform(-1, 1, (len(turns), 3)) * half
    local[rows, top] = side * half[top]
    normal = side[:, None] * axes[rows, :, top]
    points = np.array(CENTRE) + np.einsum("nij,nj->ni", axes, local)
    speed = chance.normal(0, 0.5, (len(turns), 3))
    speed -= np.sum(speed * normal, axis=1)[:, None] * normal
    spin = np.cross(normal, speed) / rolls.BALL + chance.normal(0, 5, (len(turns), 1)) * normal
    states = np.hstack([points + rolls.BALL * normal, speed, spin])
    within = [bound(one) for one in (OF_SLAB if own else BOUNDS)]
    chosen = np.array([max(one(q) for one in within) < -1e-3 for q in points])
    states, turns = states[chosen][:count], turns[chosen][:count]
    states[:, 0] += ASIDE * own
    return states, dict(zip(TURN, turns.T, strict=True))


@pytest.mark.parametrize("own", range(2))
def test_rolls_on_a_box_end_at_its_bounds_as_in_a_second_formulation(
    engine: Engine, own: int
) -> None:
    check_rolls(engine, own, trials(150, 20))


def check_rolls(engine: Engine, own: int, count: int) -> None:
    """Compare rolls on one box from a face of it on, of which many end at a bound."""
    states, values = rolling(own, count, 1)
    name = ("crate", "slab")[own]
    shots = engine.simulate(states, values, time_limit=2, record=True, leaving=name)
    ends = compared(shots, own, values)
    assert len(ends) > 0.7 * count
    assert sum(kind > 0 for kind in ends) > len(ends) / 10
    assert ends.count(0) > len(ends) / 10


def compared(shots: hoopgen.Shots, own: int, values: dict[str, Any]) -> list[int]:
    """Compare the rolls on one box with the second formulation; return how they ended."""
    turns = np.stack([values[name] for name in TURN], axis=1)
    within = tuple(map(bound, OF_SLAB if own else BOUNDS))
    aside = np.eye(9)[0] * ASIDE * own

    def follow(begin: Any, until: float) -> tuple[int, float, Floats] | None:
        if begin["surface"] != own:
            return None
        turn = AXES if own else turns[begin["shot"]]
        kind, at, state = rolls.rolled_on_box(turn, begin["after"] - aside, until, within)
        return kind, at, state + aside

    return compare(shots, follow)


def test_rolls_after_bounces_end_at_bounds_as_in_a_second_formulation(engine: Engine) -> None:
    states, values = dropped(trials(200, 50), 1)
    shots = engine.simulate(states, values, time_limit=3, record=True)
    assert sum(len(compared(shots, own, values)) for own in range(2)) >= occurrences(41)
    assert not np.any(shots.outcome == engine.outcomes["CAPPED"])


def test_a_ball_that_rolls_straight_on_a_face_leaves_at_the_bound_by_formula(
    engine: Engine,
) -> None:
    """On a level face it rolls steadily, and leaves where q + v t is past a bound."""
    states, values = rolling(1, trials(1000, 300), 3)
    shots = engine.simulate(states, values, time_limit=2, record=True, leaving="slab")
    events, checked = shots.events, 0
    for k in np.flatnonzero((events["kind"] == Event.ROLL) & (events["surface"] == 1)):
        begin = events[k]
        if shots.uncertain[begin["shot"]] or k + 1 == len(events):
            continue
        (x, y, z), (vx, vy, _) = begin["after"][:3], begin["after"][3:6]
        x, z = x - ASIDE, z - rolls.BALL
        ways = (-(y + x / 3 - 0.45) / (vy + vx / 3), (z / 3 - x - 0.35) / vx)
        bounds = min((way for way in ways if way > 0), default=np.inf)
        sides = ((x, vx, 0, 0.5), (y, vy, 1, 0.3))
        edge = min((CENTRE[k] + np.sign(v) * half - p) / v for p, v, k, half in sides)
        if bounds < edge and bounds < 2 - begin["time"]:
            end = events[k + 1]
            assert end["kind"] == Event.LEAVE
            assert end["time"] - begin["time"] == pytest.approx(bounds, abs=1e-9)
            checked += 1
    assert checked > len(states) / 10


@pytest.mark.parametrize("own", range(2))
def test_a_ball_that_rolls_towards_a_box_meets_it_only_where_it_is(
    engine: Engine, own: int
) -> None:
    check_beside(engine, own, trials(1500, 400))


def check_beside(engine: Engine, own: int, count: int = 300) -> None:
    """Compare with the straight line of the ball's centre, and the nearest point of the box."""
    chance = np.random.default_rng(own)
    azimuth, aim = chance.uniform(0, 2 * np.pi, count), chance.uniform(-0.6, 0.6, count)
    out = np.stack([np.cos(azimuth), np.sin(azimuth)], axis=1)
    states = np.zeros((count, 9))
    states[:, :2] = PLACES[own][:2] + 0.9 * out + aim[:, None] * out[:, ::-1] * (1, -1)
    states[:, 2] = FLOOR + rolls.BALL
    states[:, 3:5] = -out * chance.uniform(0.5, 3, (count, 1))
    states[:, 6], states[:, 7] = -states[:, 4] / rolls.BALL, states[:, 3] / rolls.BALL
    states[:, 8] = chance.normal(0, 5, count)
    turns = np.tile(AXES, (count, 1)) if own == 0 else chance.normal(0, 1, (count, 4))
    values = dict(zip(TURN, turns.T, strict=True))
    shots = engine.simulate(states, values, time_limit=5, record=True, leaving="floor")
    axes, half = rotation(turns), np.array(SIZE) / 2
    within = [bound(one) for one in BESIDE[own]]
    events, met, passed = shots.events, 0, 0
    for k in range(count):
        mine = events[events["shot"] == k]
        assert mine["kind"][0] == Event.ROLL
        if shots.uncertain[k]:
            continue

        def nearest(time: float, k: int = k) -> tuple[float, Floats]:
            place = states[k, :3] + time * states[k, 3:6]
            local = axes[k].T @ (place - PLACES[own])
            point = PLACES[own] + axes[k] @ np.clip(local, -half, half)
            return float(np.linalg.norm(place - point)) - rolls.BALL, point

        until = 1.8 / float(np.linalg.norm(states[k, 3:5]))
        # The distance from a box is convex along a line.
        least = minimize_scalar(
            lambda t, nearest=nearest: nearest(t)[0],
            bounds=(0, until),
            method="bounded",
            options={"xatol": 1e-9},
        )
        hits = False
        if least.fun < -1e-9:
            when = brentq(lambda t, nearest=nearest: nearest(t)[0], 0, least.x, xtol=1e-13)
            hits = max(one(nearest(when)[1]) for one in within) <= 0
        if hits:
            met += 1
            assert mine["surface"][1] == 2 + own
            assert mine["time"][1] == pytest.approx(when, abs=1e-7)
        elif len(mine) > 1 and least.fun < -1e-9:
            passed += 1
            assert mine["surface"][1] != 2 + own or mine["time"][1] > until / 2
    assert np.mean(shots.uncertain) < 0.1
    assert met > count / 20  # of the turned box a twelfth is met and certain
    assert passed > count / 20


def test_few_rolls_on_boxes_with_bounds_are_uncertain(engine: Engine) -> None:
    shots = engine.simulate(*dropped(trials(1000, 400), 9), time_limit=3)
    assert np.mean(shots.rolls > 0) > 0.5
    assert np.mean(shots.uncertain) < 0.05


def test_a_ball_that_rolls_on_a_box_with_bounds_keeps_its_energy(engine: Engine) -> None:
    shots = engine.simulate(*dropped(trials(300, 150), 5), time_limit=3, record=True)
    events = shots.events
    begins = np.flatnonzero((events["kind"] == Event.ROLL) & (events["surface"] < 2))
    begins = begins[begins + 1 < len(events)]
    kappa = 2 / 3
    change = energy(events["before"][begins + 1], kappa) - energy(events["after"][begins], kappa)
    assert np.max(np.abs(change)) < 1e-12


def test_contacts_before_a_roll_on_a_box_with_bounds_are_proved_or_flagged(engine: Engine) -> None:
    check_proofs(engine, *dropped(trials(500, 60), 2))


def test_a_box_with_bounds_that_is_turned_about_the_vertical_gives_turned_rolls(
    engine: Engine,
) -> None:
    states, values = (given for given in rolls.turned(trials(400, 200), 6))
    angle = 0.7
    c, s = np.cos(angle), np.sin(angle)
    turn = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
    moved = np.hstack([states[:, k : k + 3] @ turn.T for k in (0, 3, 6)])
    # The quaternion of a turn about z by that angle, times that of the box.
    cosine, sine = np.cos(angle / 2), np.sin(angle / 2)
    w, i, j, k = (values[name] for name in TURN)
    parts = (cosine * w - sine * k, cosine * i - sine * j, cosine * j + sine * i)
    other = dict(zip(TURN, (*parts, cosine * k + sine * w), strict=True))
    other |= {"cos_turn": c, "sin_turn": s}
    given: dict[str, Any] = {"time_limit": 1.5, "fields": CLAIMS}
    first = engine.simulate(states, values, **given)
    agree(first, engine.simulate(moved, other, **given), 0.8, turn, turn, turn)
