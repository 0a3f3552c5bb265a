"""Rolls where gravity points in any direction: scenes that each shot turns, gravity with them.

The motion in a turned scene is the turned motion. Rolls are also integrated again in the scene as
it stands before it is turned, with the nearest point of each body as all that is known of it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import SimpleNamespace
from typing import Any, cast

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

pytest.importorskip("flint")

import hoopgen
from hoopgen.scene import (
    Box,
    Cone,
    Cylinder,
    Disc,
    Parameter,
    Plane,
    Scene,
    Sphere,
    Torus,
)
from hoopgen.simulation.engine import Engine
from tests.helpers.effort import exceptions, occurrences, trials
from tests.scene.test_cone_rolls import cone
from tests.scene.test_oblique_rolls import (
    BALL,
    CLAIMS,
    GRAVITY,
    Body,
    check_proofs,
    compare,
    cylinder,
    rolled,
    sphere,
)

pytestmark = [
    pytest.mark.slow,
    pytest.mark.xdist_group("rolls_in_any_gravity"),  # compiled once
]

Floats = NDArray[np.float64]
Values = dict[str, Any]

ENTRIES = tuple(tuple(f"r{i}{j}" for j in range(3)) for i in range(3))
"""The names of the entries of the rotation, by rows."""
QUATERNION = ("q0", "q1", "q2", "q3")

TURN = [
    *(Parameter(ENTRIES[i][j], float(i == j), "1", sign="any") for i in range(3) for j in range(3)),
    *(Parameter(name, float(name == "q0"), "1", sign="any") for name in QUATERNION),
]


def way(*parts: float) -> tuple[str, str, str]:
    """Return a vector that each shot turns, as formulas."""
    sums = ("+".join(f"({p})*{e}" for p, e in zip(parts, row, strict=True) if p) for row in ENTRIES)
    x, y, z = (found or "0" for found in sums)
    return x, y, z


def up(height: float) -> str:
    """Return a bound: the places that are lower than a height before the turn."""
    return "+".join(f"{row[2]}*{axis}" for row, axis in zip(ENTRIES, "xyz", strict=True)) + (
        f"-({height})"
    )


BOWL = {"radius": 0.5, "centre": (4.0, 0.0, 0.2)}
LOG = {"radius": 0.15, "centre": (-2.0, 0.0, 0.0), "axis": (1.0, 0.3, -0.1)}
FUNNEL = {"apex": (8.0, 0.0, -0.3), "axis": (0.0, 0.0, 1.0), "slope": 1.2, "span": (0.1, 0.5)}
PLACES = {"crate": 0.0, "bowl": 4.0, "log": -2.0, "funnel": 8.0, "wheel": 12.0, "dish": 16.0}
HEIGHTS = {"bowl": 0.2}
SPEEDS = {"funnel": 0.8}  # a slower ball falls through
NAMES = tuple(PLACES)

FLAGGED = {"funnel": 0.4}
"""The largest share of uncertain shots: many balls that roll fast on a turned cone are."""


def bodies() -> list[Any]:
    """Return a body of each kind that a ball can roll on, over a table that leans."""
    return [
        Box("crate", size=(0.8, 0.6, 0.4), centre=way(0, 0, -0.3), orientation=QUATERNION),
        Sphere("bowl", radius=0.5, centre=way(4, 0, 0.2), inside=True, within=[up(0.1)]),
        Cylinder(
            "log", radius=0.15, centre=way(-2, 0, 0), axis=way(1, 0.3, -0.1), span=(-0.5, 0.5)
        ),
        Cone(
            "funnel",
            apex=way(8, 0, -0.3),
            axis=way(0, 0, 1),
            slope=1.2,
            span=(0.1, 0.5),
            inside=True,
        ),
        Torus("wheel", radius=0.3, wire=0.1, centre=way(12, 0, 0), axis=way(0.1, 0, 1)),
        Disc("dish", radius=0.6, centre=way(16, 0, 0), axis=way(0.05, 0, 1)),
        Plane("table", normal=way(0, 0.02, 1), point=way(0, 0, -1)),
    ]


WHOLE = Scene(
    "turned_with_gravity",
    parameters=[*TURN, Parameter("pull", GRAVITY, "m/s²")],
    bodies=bodies(),
    ball_radius=BALL,
    gravity="pull",
    down=way(0, 0, -1),
    restitution=0.3,
    rolls=True,
)

WALLED = Scene(
    "wall_along_gravity",
    parameters=TURN,
    bodies=[
        Plane("wall", normal=way(1, 0, 0), point=way(0, 0, 0), restitution=0),
        Plane("table", normal=way(0, 0, 1), point=way(0, 0, -1), restitution=0.5),
    ],
    ball_radius=BALL,
    gravity=GRAVITY,
    down=way(0, 0, -1),
    rolls=True,
)


@pytest.fixture(scope="module")
def engine() -> Engine:
    return hoopgen.compile(WHOLE)


def turns(count: int, seed: int) -> Floats:
    """Return rotations in all directions, (n, 3, 3)."""
    return np.asarray(Rotation.random(count, random_state=seed).as_matrix())


def values_of(turn: Floats) -> Values:
    """Return the parameters of turned scenes."""
    q = Rotation.from_matrix(turn).as_quat()
    entries = {ENTRIES[i][j]: turn[:, i, j] for i in range(3) for j in range(3)}
    return entries | dict(zip(QUATERNION, (q[:, 3], *q[:, :3].T), strict=True))


def turned(turn: Floats, states: Floats) -> Floats:
    """Return turned states."""
    found = np.einsum("nij,nkj->nki", turn, states.reshape(-1, 3, 3))
    return np.asarray(found.reshape(-1, 9))


def dropped(count: int, seed: int) -> Floats:
    """Return balls that fall onto the bodies, before the turn."""
    chance, which = np.random.default_rng(seed), np.arange(count) % len(NAMES)
    states = np.zeros((count, 9))
    states[:, 0] = np.array(list(PLACES.values()))[which]
    states[:, :2] += chance.uniform(-0.25, 0.25, (count, 2))
    states[:, 2] = np.array([HEIGHTS.get(name, 0.35) for name in NAMES])[which]
    states[:, 2] += chance.uniform(0, 0.1, count)
    speeds = np.array([SPEEDS.get(name, 0.3) for name in NAMES])[which]
    states[:, 3:5] = chance.normal(0, 1, (count, 2)) * speeds[:, None]
    states[:, 6:] = chance.normal(0, 5, (count, 3))
    return states


def upright(count: int) -> Floats:
    """Return rotations that turn nothing."""
    return np.broadcast_to(np.eye(3), (count, 3, 3))


def test_a_scene_turned_with_its_gravity_gives_turned_rolls(engine: Engine) -> None:
    """In each shot in another direction, as far as the errors of both allow."""
    count = trials(3000, at_least=300)
    states, turn = dropped(count, 1), turns(count, 2)
    given: Values = {"time_limit": 3, "fields": CLAIMS}
    first = engine.simulate(states, values_of(upright(count)), **given)
    other = engine.simulate(turned(turn, states), values_of(turn), **given)
    sure = ~(first.uncertain | other.uncertain)
    for own, name in enumerate(NAMES):
        shots = slice(own, None, len(NAMES))
        assert (first.rolls > 0)[shots].mean() > 0.8, name
        flagged = np.count_nonzero(~sure[shots])
        assert flagged < exceptions(FLAGGED.get(name, 0.15), len(sure[shots])), name
    for name in ("outcome", "rolls", "counts"):
        assert np.array_equal(getattr(first, name)[sure], getattr(other, name)[sure]), name
    away = np.abs(turned(turn, first.state) - other.state).reshape(-1, 3, 3).max(axis=2)
    assert (away <= first.state_error + other.state_error)[sure].all()


def test_few_balls_that_roll_off_a_turned_box_are_uncertain(engine: Engine) -> None:
    """The search behind the edge needs few steps, though the gap opens slowly."""
    count = len(NAMES) * trials(500, at_least=100)
    states, turn = dropped(count, 3)[:: len(NAMES)], turns(count, 4)[:: len(NAMES)]
    shots = engine.simulate(turned(turn, states), values_of(turn), time_limit=3, record=True)
    leaves = shots.events[shots.events["kind"] == hoopgen.Event.LEAVE]
    assert np.count_nonzero(leaves["surface"] == 0) > len(states) / 2
    assert np.count_nonzero(shots.uncertain) < exceptions(0.1, len(states))


FOLLOWED: Mapping[str, Callable[[], Body]] = {
    "bowl": lambda: sphere(BOWL, lambda q: q[2] - 0.1),
    "log": lambda: cylinder(
        LOG, lambda q: abs((q - LOG["centre"]) @ LOG["axis"] / np.linalg.norm(LOG["axis"])) - 0.5
    ),
    "funnel": lambda: cone(FUNNEL),
}


@pytest.mark.parametrize("name", FOLLOWED)
def test_rolls_in_any_gravity_are_those_of_a_second_formulation(engine: Engine, name: str) -> None:
    """They end where the normal force vanishes, or at an edge: the log, the bowl and the funnel."""
    own, body = NAMES.index(name), FOLLOWED[name]()
    count = len(NAMES) * trials(200, at_least=40)
    states, turn = dropped(count, 5)[own :: len(NAMES)], turns(count, 6)[own :: len(NAMES)]
    shots = engine.simulate(turned(turn, states), values_of(turn), time_limit=3, record=True)
    events = shots.events.copy()
    for part in ("before", "after"):
        events[part] = turned(turn[events["shot"]].transpose(0, 2, 1), events[part])

    def follow(begin: Any, until: float) -> tuple[int, float, Floats] | None:
        return rolled(body, begin["after"], until) if begin["surface"] == own else None

    back = cast(hoopgen.Shots, SimpleNamespace(events=events, uncertain=shots.uncertain))
    compared = len(compare(back, follow))
    assert compared > occurrences(len(states) // 10)
    assert compared > 0


def test_contacts_before_a_roll_in_any_gravity_are_proved_or_flagged(engine: Engine) -> None:
    count = trials(300, at_least=60)
    turn = turns(count, 8)
    check_proofs(engine, turned(turn, dropped(count, 7)), values_of(turn))


def test_a_ball_that_a_wall_stops_is_uncertain_where_gravity_is_along_the_wall() -> None:
    """The force that presses it on is a rounding."""
    engine, count = hoopgen.compile(WALLED), trials(100, at_least=30)
    turn, chance = turns(count, 9), np.random.default_rng(10)
    states = np.zeros((count, 9))
    states[:, 0], states[:, 3] = 0.3, chance.uniform(-3, -2, count)
    shots = engine.simulate(turned(turn, states), values_of(turn), time_limit=0.5)
    assert (shots.counts[:, 0] > 0).all()
    assert shots.uncertain.all()


def test_gravity_that_presses_nothing_on_makes_its_own_row_invalid(engine: Engine) -> None:
    states = dropped(len(NAMES), 11)[:3]
    values = values_of(upright(3)) | {"pull": np.array([GRAVITY, 2.0**-31, 1.62])}
    shots = engine.simulate(states, values, time_limit=1)
    assert (shots.outcome == engine.outcomes["INVALID"]).tolist() == [False, True, False]
    reasons = hoopgen.why_invalid(states, values, scene=engine)
    assert [bool(reason) for reason in reasons] == [False, True, False]
    assert "gravity_z" in reasons[1]


def test_a_direction_of_gravity_that_is_zero_is_named(engine: Engine) -> None:
    values = values_of(upright(1)) | dict.fromkeys((row[2] for row in ENTRIES), 0.0)
    (reason,) = hoopgen.why_invalid(dropped(1, 12), values, scene=engine)
    assert "has to be a number; a direction of length 0" in reason
