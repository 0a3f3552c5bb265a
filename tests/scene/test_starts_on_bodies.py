"""Shots that start on a body, named by `leaving`: the ball stays there, or flies off at once."""

from __future__ import annotations

import math
from functools import partial
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

pytest.importorskip("flint")

import hoopgen
from benchmarks.workloads import free_throw
from hoopgen import Event
from hoopgen.core.backend_names import BackendName
from hoopgen.judge import certify
from hoopgen.scene import (
    Cone,
    Cylinder,
    End,
    Parameter,
    Plane,
    Revolution,
    Scene,
    Sphere,
    Torus,
    load_scene,
)
from hoopgen.simulation.engine import Engine
from tests.helpers import ROOT
from tests.helpers.effort import trials

pytestmark = [
    pytest.mark.slow,
    pytest.mark.xdist_group("starts_on_bodies"),  # each scene is compiled once
]

GRAVITY, BALL, RADIUS = 9.81, 0.05, 0.2
ROLLING = 7 / 5
"""Kinetic energy of a rolling solid ball by that of its velocity."""

TABLE = Scene(
    "table_with_sphere",
    bodies=[
        Plane("floor", at=-0.7),
        Sphere("dome", centre=(2, 0, 0), radius=RADIUS),
        Plane("table", normal=[1, 0.5, 4], within=["x - 0.3", "-x - 0.3"]),
        Plane("wall", axis="y", at=-5),
    ],
    ball_radius=BALL,
    gravity=GRAVITY,
    restitution=0.4,
    inertia="2/5",
    rolls=True,
    ends={"past": End(axis="-x", at=-4), "back": End(axis="x", at=-4)},
)
"""A table that leans, a sphere, and a wall."""

FUNNEL = Scene(
    "funnel_below_ceiling",
    bodies=[
        Revolution("funnel", profile=[[0.05, 0], [0.1, 0.2]]),
        Plane("ceiling", at=-3, axis="-z"),
        Plane("floor", at=-0.8),
    ],
    ball_radius=0.02,
    gravity=GRAVITY,
    restitution=0.5,
    ends={"past": End(axis="-x", at=-2)},
)
"""A body of four surfaces before others of one."""

CURVED = Scene(
    "bodies_of_every_curvature",
    bodies=[
        Sphere("dome", radius=0.3),
        Sphere("bowl", centre=(5, 0, 0), radius=0.4, inside=True, within=["x - 6", "4 - x"]),
        Cylinder("log", centre=(10, 0, 0), axis="y", radius=0.3),
        Cylinder(
            "pipe",
            centre=(15, 0, 0),
            axis="y",
            radius=0.4,
            inside=True,
            within=["x - 16", "14 - x"],
        ),
        Cylinder("beam", centre=(20, 0, 0), axis=[1, 2, 2], radius=0.3),
        Cone("funnel", apex=(25, 0, 0), slope=1.2, span=(0.1, 0.8), inside=True),
        Torus("tyre", centre=(30, 0, 0), radius=0.6, wire=0.1),
        Torus("leans", centre=(35, 0, 0), radius=0.6, wire=0.1, axis=[1, 2, 2]),
        Plane("ramp", normal=[1, 0, 4], within=["x - 41", "39 - x"]),
    ],
    parameters=[Parameter("grip", 2.0, infinite=True)],
    friction="grip",
    ball_radius=BALL,
    gravity=GRAVITY,
    restitution=0.4,
    inertia="2/5",
    rolls=True,
)
"""A body of each curvature that a ball can roll on, far from one another."""


SPHERES = Scene(
    "spheres_that_nothing_rolls_on",
    bodies=[Sphere(f"dome_{k}", centre=(k, 0, 0), radius=RADIUS) for k in range(3)],
    ball_radius=BALL,
    gravity=GRAVITY,
    restitution=0.4,
    ends={"past": End(at=-2)},
)
"""Bodies of one kind."""


def _of_length_one(way: list[float]) -> NDArray[np.float64]:
    return np.array(way) / np.linalg.norm(way)


def starts_on_curved() -> dict[str, tuple[NDArray[np.float64], NDArray[np.float64]]]:
    """Return a place of a ball on each body, and the normal there."""
    up, sideways = _of_length_one([0.1, 0.2, 1]), _of_length_one([-0.7, 0, 0.3])
    slant = _of_length_one([-1, 0, 1.2])
    axis = np.array([1, 2, 2]) / 3
    above = _of_length_one(list(np.array([0, 0, 1]) - axis * axis[2]))
    return {
        "dome": ((0.3 + BALL) * up, up),
        "bowl": (np.array([5, 0, 0]) - (0.4 - BALL) * sideways, sideways),
        "log": (np.array([10, 0.1, 0]) + (0.3 + BALL) * np.array([0, 0, 1]), np.array([0, 0, 1])),
        "pipe": (np.array([15, 0.1, 0]) - (0.4 - BALL) * sideways, sideways),
        "beam": (np.array([20, 0, 0]) + 0.2 * axis + (0.3 + BALL) * above, above),
        "funnel": (np.array([25.48, 0, 0.4]) + BALL * slant, slant),
        "tyre": (np.array([30.6, 0, 0]) + (0.1 + BALL) * np.array([0, 0, 1]), np.array([0, 0, 1])),
        "leans": (np.array([35, 0, 0]) + 0.6 * above + (0.1 + BALL) * above, above),
        "ramp": (
            np.array([40, 0, -10]) + BALL * _of_length_one([1, 0, 4]),
            _of_length_one([1, 0, 4]),
        ),
    }


@pytest.fixture(scope="module")
def curved() -> Engine:
    """The bodies of every curvature, compiled."""
    return hoopgen.compile(CURVED)


@pytest.fixture(scope="module")
def table() -> Engine:
    """The table and the sphere, compiled."""
    return hoopgen.compile(TABLE)


@pytest.fixture(scope="module")
def funnel() -> Engine:
    """The funnel below a ceiling, compiled."""
    return hoopgen.compile(FUNNEL)


def rolling_on_table(count: int) -> NDArray[np.float64]:
    """Return states of balls that roll on the table."""
    rng = np.random.default_rng(41)
    normal = np.array([1, 0.5, 4]) / math.sqrt(17.25)
    v = rng.uniform(-1, 1, (count, 3))
    v -= (v @ normal)[:, None] * normal
    states = np.empty((count, 9))
    x, y = rng.uniform(-0.15, 0.15, (2, count))
    states[:, :3] = np.stack([x, y, -(x + 0.5 * y) / 4], 1) + BALL * normal
    states[:, 3:6] = v
    states[:, 6:] = np.cross(normal, v) / BALL + rng.uniform(-9, 9, (count, 1)) * normal
    return states


def test_a_ball_that_starts_on_a_body_rolls_at_once(table: Engine) -> None:
    states = rolling_on_table(trials(200))
    shots = hoopgen.simulate(states, scene=table, leaving="table", record=True)
    events = shots.events[np.searchsorted(shots.events["shot"], np.arange(len(states)))]
    assert np.all(events["kind"] == Event.ROLL)
    assert np.all(events["time"] == 0)
    assert np.mean(shots.uncertain) < 0.03
    np.testing.assert_allclose(events["after"], states, rtol=0, atol=1e-12)


def test_a_ball_that_starts_on_a_body_reaches_its_edge_as_the_closed_form_says(
    table: Engine,
) -> None:
    states = rolling_on_table(trials(200))
    shots = hoopgen.simulate(states, scene=table, leaving="table", record=True)
    leave = shots.events[shots.events["kind"] == Event.LEAVE]
    _, first = np.unique(leave["shot"], return_index=True)
    time, after = leave["time"][first], leave["after"][first]
    own = states[leave["shot"][first]]
    normal = np.array([1, 0.5, 4]) / math.sqrt(17.25)
    down = np.array([0, 0, -GRAVITY]) + GRAVITY * normal[2] * normal
    there = own[:, :3] + own[:, 3:6] * time[:, None] + down * (time**2 / 2 / ROLLING)[:, None]
    assert len(first) > 0.9 * len(states)
    np.testing.assert_allclose(after[:, :3], there, rtol=0, atol=1e-12)


@pytest.mark.parametrize(("share", "rolls"), [(0.3, 1), (0.7, 1), (1.01, 0), (1.5, 0)])
def test_a_ball_on_top_of_a_sphere_rolls_unless_it_is_too_fast(
    table: Engine, share: float, rolls: int
) -> None:
    top = RADIUS + BALL
    speed = share * math.sqrt(GRAVITY * top)
    start = [2, 0, top, speed, 0, 0, 0, speed / BALL, 0]
    shot = hoopgen.simulate(start, scene=table, leaving="dome", record=True, max_contacts=1)
    assert shot.rolls[0] >= rolls
    first = shot.events[0]
    assert (first["kind"] == Event.ROLL) == bool(rolls)
    if rolls:
        leave = shot.events[shot.events["kind"] == Event.LEAVE][0]
        # The force ends where m v²/r = m g cos, with the energy of 7/5 m v²/2.
        cosine = (10 + 7 * share**2) / 17
        assert abs(leave["after"][2] - top * cosine) < 1e-12
    assert not shot.uncertain[0]


def test_a_ball_that_starts_with_a_speed_off_the_body_flies(table: Engine) -> None:
    states = rolling_on_table(trials(200))
    states[:, 3:6] += 2 * np.array([1, 0.5, 4]) / math.sqrt(17.25)
    shots = hoopgen.simulate(states, scene=table, leaving="table", record=True, max_contacts=1)
    assert not shots.uncertain.any()
    assert np.all(shots.rolls == 0)
    assert np.all(shots.events["time"] > 0.1)
    certificate = certify(states, scene=TABLE, leaving="table", max_contacts=1)
    assert certificate.decided.all()
    assert np.all(np.abs(shots.time - certificate.time) < 1e-12)


def test_a_ball_that_starts_from_a_wall_is_certain(table: Engine) -> None:
    states = rolling_on_table(trials(50))
    states[:, 1], states[:, 4] = -5 + BALL, 1
    shots = hoopgen.simulate(states, scene=table, leaving="wall", max_contacts=1)
    assert not shots.uncertain.any()


def test_both_engines_start_on_bodies_with_the_same_bits(table: Engine) -> None:
    states = rolling_on_table(trials(40))
    given: dict[str, Any] = {"scene": table, "leaving": ["table", "floor"] * (len(states) // 2)}
    there, here = (
        hoopgen.simulate(states[: len(given["leaving"])], backend=backend, **given)
        for backend in ("c", "numpy")
    )
    for name in ("outcome", "contacts", "rolls", "time", "state", "uncertain"):
        assert np.array_equal(getattr(there, name), getattr(here, name), equal_nan=True)


@pytest.mark.parametrize("kind", [Event.IMPACT, Event.ROLL])
def test_a_shot_goes_on_from_every_recorded_event(table: Engine, kind: Event) -> None:
    rng = np.random.default_rng(43)
    states = np.concatenate(
        [rng.uniform([-0.2, -0.2, 0.2], [0.2, 0.2, 0.5], (300, 3)), rng.normal(0, 1, (300, 6))], 1
    )
    fields = ("outcome", "uncertain", "time", "time_error")
    shots = hoopgen.simulate(states, scene=table, record=True, fields=fields)
    events = shots.events
    wanted = (events["kind"] == kind) & ~shots.uncertain[events["shot"]]
    ended = [table.outcomes["PAST"], table.outcomes["BACK"]]
    events = events[wanted & np.isin(shots.outcome[events["shot"]], ended)]
    assert len(events) > 50
    on = hoopgen.simulate(events["after"], scene=table, leaving=events["surface"], fields=fields)
    sure = ~on.uncertain
    assert np.mean(sure) > 0.95
    late = on.time + events["time"] - shots.time[events["shot"]]
    claimed = on.time_error + shots.time_error[events["shot"]]
    assert np.all(np.abs(late[sure]) <= claimed[sure])


def test_leaving_names_a_body_also_behind_one_of_several_surfaces(funnel: Engine) -> None:
    up = [0, 0, 1, 0.5, 0, 12, 0, 0, 0]
    shot = hoopgen.simulate(up, scene=funnel, record=True, max_contacts=2)
    after = shot.events["after"][0]
    assert funnel.surfaces[shot.events["surface"][0]] == "ceiling"
    for leaving in ("ceiling", 1, ["ceiling"], np.array(["ceiling"])):
        on = hoopgen.simulate(after, scene=funnel, leaving=leaving, max_contacts=1)
        assert not on.uncertain[0]
        assert on.outcome[0] == funnel.outcomes["CAPPED"]
        assert abs(on.time[0] + shot.events["time"][0] - shot.time[0]) < 1e-12
    proved = certify(after, scene=FUNNEL, leaving="ceiling", max_contacts=1)
    assert proved.decided[0]
    assert hoopgen.why_invalid(after, scene=funnel, leaving="ceiling") == [""]


@pytest.mark.parametrize("off", [-1e-13, 0, 1e-13])
def test_a_small_hop_from_a_body_lasts_as_long_wherever_it_starts(
    funnel: Engine, off: float
) -> None:
    start = [1, 0, -0.78 + off, 0, 0, 1e-6, 0, 0, 0]
    shot = hoopgen.simulate(start, scene=funnel, leaving="floor", max_contacts=1)
    assert abs(shot.time[0] / (2e-6 / GRAVITY) - 1) < 1e-9


@pytest.mark.parametrize("off", [-1e-13, 0, 1e-13])
def test_the_judge_starts_on_the_body_that_is_named(off: float) -> None:
    """The floor is the third body, and the sixth surface."""
    start = [1, 0, -0.78 + off, 0, 0, 1e-6, 0, 0, 0]
    proof = certify(start, scene=FUNNEL, leaving="floor", max_contacts=1)
    assert proof.decided[0]
    assert abs(proof.time[0] / (2e-6 / GRAVITY) - 1) < 1e-9


@pytest.mark.parametrize("side", ["outside", "inside", "edge"])
def test_a_ball_leaves_the_surface_of_a_body_that_it_touches(funnel: Engine, side: str) -> None:
    speed = {"outside": [-2, 0, 1], "inside": [-2, 0.1, 0], "edge": [0.04, 0, -3]}[side]
    place = {"outside": [0.5, 0, 0.1], "inside": [0.02, 0, 0.12], "edge": [0.07, 0, 1]}[side]
    start = [*place, *speed, 0, 0, 0]
    shot = hoopgen.simulate(start, scene=funnel, record=True, max_contacts=2)
    first, second = shot.events[:2]
    assert funnel.surfaces[first["surface"]] == "funnel"
    on = hoopgen.simulate(first["after"], scene=funnel, leaving="funnel", max_contacts=1)
    assert not on.uncertain[0]
    assert abs(on.time[0] + first["time"] - second["time"]) < 1e-12


def test_a_ball_that_leaves_a_thin_wall_is_on_the_side_that_it_touches(funnel: Engine) -> None:
    """Both sides are as near to the ball; it does not touch the wall again at once."""
    rng, count = np.random.default_rng(8), trials(2_000, 300)
    states = np.zeros((count, 9))
    states[:, :2], states[:, 2] = rng.uniform(-0.3, 0.3, (count, 2)), rng.uniform(0.4, 1, count)
    states[:, 3:5] = rng.normal(0, 1, (count, 2))
    shots = hoopgen.simulate(states, scene=funnel, record=True, max_contacts=6)
    events = shots.events[shots.events["surface"] == funnel.surfaces.index("funnel")]
    assert len(events) > count / 20
    on = hoopgen.simulate(
        events["after"], scene=funnel, leaving="funnel", record=True, max_contacts=1
    )
    met = on.events[on.events["surface"] >= 0]
    again = met[met["surface"] == funnel.surfaces.index("funnel")]
    assert np.all(again["time"][~on.uncertain[again["shot"]]] > 1e-9)
    assert np.mean(on.uncertain) < 0.2


def test_an_unknown_body_is_refused_with_the_names(funnel: Engine) -> None:
    with pytest.raises(
        ValueError, match=r"^leaving: expected funnel, ceiling, floor, got 'cieling'"
    ):
        hoopgen.simulate([0] * 9, scene=funnel, leaving="cieling")


@pytest.mark.parametrize("share", [-20, -1.2, -0.8, 0.8, 1.2, 20, 2000])
def test_the_judge_and_the_engines_agree_whether_a_ball_touches_the_body_it_leaves(
    table: Engine, share: float
) -> None:
    """As far off as so many times what is allowed: along the normal of a table that leans."""
    states = rolling_on_table(20)
    states[:, :3] += share * BALL / 1024 * np.array([1, 0.5, 4]) / math.sqrt(17.25)
    given: dict[str, Any] = {"leaving": "table", "max_contacts": 1}
    invalid = table.outcomes["INVALID"]
    for backend in ("c", "numpy"):
        shots = hoopgen.simulate(states, scene=table, backend=backend, **given)
        assert np.all((shots.outcome == invalid) == (abs(share) > 1))
    proof = certify(states, scene=TABLE, **given)
    assert np.all((proof.outcome == invalid) == (abs(share) > 1))


def test_a_ball_is_nearer_to_the_body_it_leaves_than_to_one_that_it_touches_too(
    table: Engine,
) -> None:
    """Beside another body it may not be known; inside that one the reason names it alone."""
    states = np.zeros((2, 9))
    states[0, :3] = [0, -5 + BALL / 2, 1]
    states[1, :3] = [0, 0, 1]
    assert hoopgen.why_invalid(states, scene=table, leaving="table") == [
        "inside the wall",
        "leaving: the ball is away from the table; expected in contact, to 1/1024 of its radius",
    ]


def test_a_ball_that_touches_two_bodies_begins_on_neither_for_certain(table: Engine) -> None:
    """In the corner of table and wall roundings say on which side of the table it is."""
    y = -5 + BALL
    height = (BALL * math.sqrt(17.25) - 0.5 * y) / 4
    states = np.zeros((8, 9))
    states[:, 1], states[:, 4] = y, 1
    states[:, 2] = height + BALL * np.array([1e-12, 1e-14, 0, -1e-14, -1e-12, -5e-4, -2e-3, -0.5])
    shots = hoopgen.simulate(states, scene=table, leaving="wall")
    invalid = shots.outcome == table.outcomes["INVALID"]
    assert np.all(shots.uncertain[1:4])
    assert np.all(invalid[4:])
    reasons = hoopgen.why_invalid(states, scene=table, leaving="wall")
    touches = (
        "leaving: the ball touches the table besides the wall; expected in contact with one body"
    )
    assert reasons[:1] == [""]
    assert set(reasons[1:4]) <= {"", touches}
    assert reasons[4:] == [touches] * 2 + ["inside the table"] * 2


@pytest.mark.parametrize("kind", [Event.IMPACT, Event.ROLL, Event.LEAVE])
def test_every_recorded_event_is_in_contact_with_its_body(table: Engine, kind: Event) -> None:
    """Also at edges, where a ball leaves its body."""
    rng = np.random.default_rng(44)
    states = np.concatenate(
        [rng.uniform([-0.2, -0.2, 0.2], [0.2, 0.2, 0.5], (300, 3)), rng.normal(0, 1, (300, 6))], 1
    )
    events = hoopgen.simulate(states, scene=table, record=True).events
    events = events[events["kind"] == kind]
    assert len(events) > 50
    on = hoopgen.simulate(events["after"], scene=table, leaving=events["surface"])
    assert not np.any(on.outcome == table.outcomes["INVALID"])


def test_a_ball_starts_on_a_body_whatever_its_radius_is_called() -> None:
    engine = hoopgen.compile(
        Scene(
            "marble_on_a_floor",
            parameters=[Parameter("marble", 0.02)],
            bodies=[Plane("floor")],
            ball_radius="marble",
            gravity=9.81,
            restitution=0.5,
            rolls=True,
            ends={"out": End(at=-1)},
        )
    )
    begun = np.zeros((2, 9))
    begun[:, 2:4] = [[0.02, 1], [0.03, 1]]
    shots = engine.simulate(begun, leaving="floor", time_limit=0.5)
    assert shots.outcome.tolist() == [engine.outcomes["ENDLESS"], engine.outcomes["INVALID"]]
    proofs = engine.certify(begun, leaving="floor", time_limit=0.5)
    assert proofs.outcome[1] == engine.outcomes["INVALID"]


OFFS = np.array([0, *(s * 10.0**-k for k in (16, 13, 12, 9, 6, 4) for s in (1, -1)), 9e-4])
"""Distances of a ball from a body, by its radius."""


def off_curved(body: str) -> NDArray[np.float64]:
    """Return states of balls that roll on a body from one place, but for `OFFS`."""
    place, normal = starts_on_curved()[body]
    v = 0.3 * np.cross(normal, _of_length_one([3, 4, 1]))
    states = np.empty((len(OFFS), 9))
    states[:, :3] = place + OFFS[:, None] * BALL * normal
    states[:, 3:6], states[:, 6:] = v, np.cross(normal, v) / BALL + normal
    return states


@pytest.mark.parametrize("grip", [2.0, math.inf])
@pytest.mark.parametrize("body", starts_on_curved())
def test_a_ball_rolls_at_once_whatever_the_last_digits_of_its_place(
    curved: Engine, body: str, grip: float
) -> None:
    """The ball is put onto the body, and rolls as from a place on it."""
    given: dict[str, Any] = {"leaving": body, "time_limit": 0.05, "record": True}
    shots = hoopgen.simulate(off_curved(body), {"grip": grip}, scene=curved, **given)
    assert np.all(shots.contacts == 0)
    assert np.all(shots.rolls == 1)
    assert not shots.uncertain.any()
    begun = shots.events[shots.events["kind"] == Event.ROLL]
    assert np.all(begun["time"] == 0)
    place, _ = starts_on_curved()[body]
    np.testing.assert_allclose(begun["after"][:, :3] - place, 0, rtol=0, atol=1e-14)
    np.testing.assert_allclose(shots.state - shots.state[0], 0, rtol=0, atol=1e-12)


@pytest.mark.parametrize("hop", [-1e-3, 0.0, 1e-6, 1e-4, 0.1])
def test_both_engines_put_balls_onto_bodies_with_the_same_bits(curved: Engine, hop: float) -> None:
    """And none touches its body again and again where it starts, whatever its speed off it."""
    for body, (_, normal) in starts_on_curved().items():
        states = off_curved(body)
        states[:, 3:6] += hop * normal
        given: dict[str, Any] = {"scene": curved, "leaving": body, "time_limit": 0.3}
        there, here = (hoopgen.simulate(states, backend=b, **given) for b in ("c", "numpy"))
        for name in ("outcome", "contacts", "rolls", "time", "state", "uncertain"):
            assert np.array_equal(getattr(there, name), getattr(here, name), equal_nan=True)
        assert np.all(there.outcome != curved.outcomes["CAPPED"])


@pytest.mark.parametrize("off", [-5e-4, -1e-9, -1e-12, 0, 1e-12, 1e-9, 5e-4])
def test_a_ball_that_is_thrown_off_leaves_the_body_whatever_the_last_digits_of_its_place(
    curved: Engine, off: float
) -> None:
    """On top of a dome, too fast to stay: it flies as from the top."""
    top = 0.3 + BALL
    speed = 1.2 * math.sqrt(GRAVITY * top)
    start = [0, 0, top + off * BALL, speed, 0, 0, 0, speed / BALL, 0]
    shot = hoopgen.simulate(start, scene=curved, leaving="dome", time_limit=0.1)
    assert (shot.contacts[0], shot.rolls[0], shot.uncertain[0]) == (0, 0, False)
    fallen = top - GRAVITY * 0.1**2 / 2
    np.testing.assert_allclose(shot.state[0, :3], [0.1 * speed, 0, fallen], rtol=0, atol=1e-14)
    proof = certify(start, scene=CURVED, leaving="dome", time_limit=0.1)
    assert proof.decided[0]
    np.testing.assert_allclose(proof.state[0], shot.state[0], rtol=0, atol=1e-14)


@pytest.mark.parametrize("off", [s * 10.0**-k for k in (16, 12, 9, 6, 4) for s in (1, -1)])
def test_a_ball_on_the_wall_of_a_golf_hole_rolls_whatever_the_last_digits_of_its_place(
    off: float,
) -> None:
    golf = hoopgen.compile(load_scene(ROOT / "examples" / "scenes" / "golf.toml"))
    ball, hole = 0.02135, 0.054
    start = [hole - ball + off * ball, 0, -0.03, 0, 0.5, 0, 0, 0, -0.5 / ball]
    shot = hoopgen.simulate(start, scene=golf, leaving="cup")
    assert shot.outcome[0] == golf.outcomes["HOLED"]
    assert (shot.contacts[0], shot.rolls[0], shot.uncertain[0]) == (0, 1, False)


def check_balls_off_a_body(
    engine: Engine, states: NDArray[np.float64], backend: BackendName = "auto"
) -> None:
    """Balls leave bodies as they have met them, and some distance off."""
    given: dict[str, Any] = {"scene": engine, "backend": backend}
    events = hoopgen.simulate(states, record=True, max_contacts=4, **given).events
    events = events[events["kind"] == Event.IMPACT]
    assert len(set(events["surface"])) > 1
    way = events["after"][:, 3:6] - events["before"][:, 3:6]
    way /= np.linalg.norm(way, axis=1, keepdims=True)
    given |= {"leaving": events["surface"], "max_contacts": 1}
    on = hoopgen.simulate(events["after"], **given)
    assert np.mean(on.uncertain) < 0.05
    for off in (1e-12, -1e-12, 1e-9, 1e-6):
        moved = events["after"].copy()
        moved[:, :3] += off * way
        shots = hoopgen.simulate(moved, **given)
        assert np.all(shots.uncertain)
        assert np.mean(shots.outcome == on.outcome) > 0.9
    settled = hoopgen.simulate(moved, settle=True, **given)
    assert np.mean(settled.uncertain) < 0.05


def drops(count: int, reach: float = 0.15) -> NDArray[np.float64]:
    """Return states of balls that fall onto the funnel, or onto other bodies that reach further."""
    rng = np.random.default_rng(12)
    states = np.zeros((count, 9))
    states[:, 0], states[:, 2] = rng.uniform(-0.1, reach, count), rng.uniform(0.5, 1, count)
    states[:, 3:5] = rng.normal(0, 0.1, (count, 2))
    return states


@pytest.mark.parametrize("backend", ["c", "numpy"])
@pytest.mark.parametrize("scene", [hoopgen.HOOP, FUNNEL, SPHERES], ids=["hoop", "funnel", "domes"])
def test_a_ball_off_a_body_that_it_leaves_where_none_rolls_is_uncertain(
    scene: Any, backend: BackendName
) -> None:
    """Nothing says which of them is where it is; the judge takes it to be the ball."""
    throw = {"hoop": free_throw, FUNNEL.name: drops, SPHERES.name: partial(drops, reach=2.1)}
    engine = hoopgen.compile(scene)
    check_balls_off_a_body(engine, throw[engine.name](trials(100, at_least=60)), backend)


SHELL = Scene(
    "shell_and_dome",
    bodies=[
        Cylinder("pipe", radius=0.5, axis="x", span=(-1, 1), inside=True),
        Sphere("dome", radius=0.5, centre=(3, 0, -0.5), within=["x - 3"]),
    ],
    ball_radius=0.125,
    gravity=GRAVITY,
    restitution=0.5,
    ends={"past": End(at=-2)},
)
"""A shell that balls touch from inside, and half a sphere."""


SUPERBALL = Scene(
    "superball_without_a_bounce",
    bodies=[Sphere("dome", radius=0.5)],
    ball_radius=0.02,
    gravity=GRAVITY,
    restitution=0,
    tangential=1,
    rolls=True,
)
"""A body on which friction turns a ball back and forth on the spot, so that its errors grow."""


def check_balls_behind_a_shell(engine: Engine, backend: BackendName = "auto") -> None:
    """A ball behind a shell, below a bound or beyond one is on neither; others are on the body."""
    states = np.zeros((5, 9))
    states[:, 0] = [0, 3, 3 + 5e-5, 3, 0]
    states[:, 2] = [-0.5 - 0.125, 0.125 - 6.25e-5, 0, 0.125, 0.125 - 0.5]
    states[:, 3], states[:, 5] = [0.1, 0.5, -0.5, -0.5, 0.1], [-1, 1, 1, 1, 1]
    states[2, 2] = math.sqrt(0.625**2 - (states[2, 0] - 3) ** 2) - 0.5
    leaving = ["pipe", "dome", "dome", "dome", "pipe"]
    given: dict[str, Any] = {"max_contacts": 3, "leaving": leaving}
    shots = hoopgen.simulate(states, scene=engine, backend=backend, record=True, **given)
    assert shots.uncertain.tolist() == [True, True, True, False, False]
    assert np.all(certify(states, scene=SHELL, **given).agrees(shots))


@pytest.mark.parametrize("backend", ["c", "numpy"])
def test_a_ball_behind_a_shell_or_below_a_bound_is_not_on_the_body(backend: BackendName) -> None:
    """There another expression than the distance is zero: the shell's thickness, or a bound."""
    check_balls_behind_a_shell(hoopgen.compile(SHELL), backend)


@pytest.mark.parametrize("backend", ["c", "numpy"])
def test_a_ball_that_touches_a_table_from_behind_is_uncertain(
    table: Engine, backend: BackendName
) -> None:
    """A ball behind the table is put onto its front, through it."""
    normal = _of_length_one([1, 0.5, 4])
    states = np.zeros((4, 9))
    states[:, :3] = np.array([1, 1 + 1 / 1100, -1, -1 - 1 / 1100])[:, None] * BALL * normal
    shots = table.simulate(states, leaving="table", time_limit=0.1, backend=backend)
    assert not np.any(shots.outcome == table.outcomes["INVALID"])
    assert shots.uncertain.tolist() == [False, False, True, True]


def check_errors_without_bounds(engine: Engine) -> None:
    """Whatever has no bounds is uncertain, and some shots have none."""
    states = np.zeros((40, 9))
    states[:, 0], states[:, 2] = np.linspace(0.01, 0.4, 40), 1
    fields = ("outcome", "uncertain", "time_error", "state_error")
    shots = engine.simulate(states, max_contacts=8, time_limit=3, fields=fields)
    known = np.isfinite(shots.time_error) & np.isfinite(shots.state_error).all(axis=1)
    assert not np.all(known)
    assert np.all(shots.uncertain | known)


def test_a_ball_whose_errors_have_no_bounds_is_uncertain_also_where_its_bounces_end() -> None:
    check_errors_without_bounds(hoopgen.compile(SUPERBALL))


def test_a_shot_goes_on_from_where_a_ball_has_left_a_body() -> None:
    """There the force on it vanishes to roundings, and friction would not suffice for rolling."""
    states = free_throw(trials(20_000, 4_000))
    fields = ("outcome", "uncertain", "time", "time_error", "slip_left", "rolls", "contacts")
    given: dict[str, Any] = {"scene": hoopgen.COURT, "fields": fields}
    shots = hoopgen.simulate(states, hoopgen.NBA_COURT, record=True, **given)
    leave = shots.events[shots.events["kind"] == Event.LEAVE]
    assert len(leave) > 10
    own = leave["shot"]
    for backend in ("c", "numpy"):
        on = hoopgen.simulate(
            leave["after"], hoopgen.NBA_COURT, leaving=leave["surface"], backend=backend, **given
        )
        assert np.all(on.uncertain <= shots.uncertain[own])
        sure = ~shots.uncertain[own]
        assert np.all((on.outcome == shots.outcome[own])[sure])
        assert not on.slip_left[sure].any()
        late = on.time + leave["time"] - shots.time[own]
        assert np.all(np.abs(late[sure]) <= (on.time_error + shots.time_error[own])[sure])
