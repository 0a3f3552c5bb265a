"""Edges of planes with bounds: a ball rolls up to one, and flies off or is taken over."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from mpmath import mp, mpf
from numpy.typing import NDArray

pytest.importorskip("flint")

from hoopgen.derive.rolling import bounds

import hoopgen
from hoopgen import Event
from hoopgen.judge import certify
from hoopgen.scene import (
    Box,
    Cone,
    Disc,
    End,
    Parameter,
    Plane,
    Scene,
    SceneError,
    Sphere,
    Torus,
    oblique_bodies,
)
from hoopgen.simulation.engine import Engine
from tests.helpers.effort import trials

pytestmark = [
    pytest.mark.slow,
    pytest.mark.xdist_group("edges"),  # each scene is compiled once
]

GRAVITY = 9.81
BALL = 0.05
FIELDS = ("outcome", "contacts", "time", "state", "uncertain", "state_error", "time_error", "rolls")

RAMP = Scene(
    "ramp_with_edges",
    parameters=[Parameter("lean", 0.3, unit="1", sign="any")],
    bodies=[
        Plane("ramp", normal=["lean", 0.1, 1], within=["x - 0.5", "x**2 + y**2 - 0.49"]),
        Sphere("post", radius=0.1, centre=(0.9, -0.1, -0.4)),
    ],
    ball_radius=BALL,
    gravity=GRAVITY,
    restitution=0.5,
    inertia="2/5",
    rolls=True,
    ends={"right": End(at=-1, within=["y"]), "left": End(at=-1)},
)
"""A plate that ends at a line and at a circle, and a post that balls may hit after it."""

HOLE_BALL, HOLE = 0.02, 0.06

GREEN = Scene(
    "green_with_hole",
    bodies=[
        Plane("green", within=[f"{HOLE}**2 - x**2 - y**2"]),
        Torus("edge", radius=HOLE),
    ],
    ball_radius=HOLE_BALL,
    gravity=GRAVITY,
    restitution=0.5,
    inertia="2/5",
    rolls=True,
    ends={"holed": End(at=-0.1), "past": End(axis="-x", at=-2)},
)
"""A plane with a round hole, whose edge is a body."""


TABLE = Scene(
    "table_over_floor",
    bodies=[
        Plane("floor", at=-0.5),
        Plane("table", within=["x - 0.3", "-x - 0.3", "y - 0.3", "-y - 0.3"]),
        Plane("wall", axis="-x", at=-1.5, within=["1 - y"], restitution=0.5),
        Plane("step", at=-1e-4, within=["0.3 - x", "x - 0.4", "y + 0.1", "-y - 0.3"]),
    ],
    ball_radius=BALL,
    gravity=GRAVITY,
    restitution=0,
    rolls=True,
    ends={"past": End(axis="-x", at=-2), "back": End(axis="x", at=-2)},
)
"""A table without thickness over a floor, beside a wall that begins at y = 1, and above a step."""


@pytest.fixture(scope="module")
def table() -> Engine:
    return hoopgen.compile(TABLE)


@pytest.fixture(scope="module")
def ramp() -> Engine:
    return hoopgen.compile(RAMP)


@pytest.fixture(scope="module")
def green() -> Engine:
    return hoopgen.compile(GREEN)


def dropped(count: int, seed: int = 3) -> NDArray[np.float64]:
    """Return balls that fall onto the ramp, with any direction and spin."""
    random = np.random.default_rng(seed)
    states = np.zeros((count, 9))
    states[:, :2] = random.uniform(-0.35, 0.35, (count, 2))
    states[:, 2] = 0.35
    states[:, 3:5] = random.normal(0, 0.5, (count, 2))
    states[:, 6:] = random.normal(0, 5, (count, 3))
    return states


def ramp_exit(state: NDArray[np.float64]) -> tuple[mpf, list[mpf]]:
    """Return when and in which state a ball that rolls on the ramp reaches an edge, exactly.

    Its acceleration is 5/7 of gravity along the plane, and the bounds are polynomials in time.
    """
    sizes = {i.name: mpf(float(v)) for i, v in zip(RAMP.inputs, RAMP.values(), strict=True)}
    direction = [sizes[f"ramp_direction_{axis}"] for axis in "xyz"]
    length = mp.sqrt(mp.fdot(direction, direction))
    normal = [d / length for d in direction]
    fall = mpf(5) / 7 * mpf(GRAVITY)
    pull = [fall * normal[2] * n for n in normal]
    pull[2] -= fall
    place, speed = ([mpf(float(s)) for s in state[k : k + 3]] for k in (0, 3))
    x, y = ([pull[k] / 2, speed[k], place[k]] for k in (0, 1))

    def square(a: list[mpf]) -> list[mpf]:
        return [a[0] ** 2, 2 * a[0] * a[1], a[1] ** 2 + 2 * a[0] * a[2], 2 * a[1] * a[2], a[2] ** 2]

    circle = [p + q for p, q in zip(square(x), square(y), strict=True)]
    for k in range(3):
        circle[2 + k] += sizes["ramp_within_2_x"] * x[k] + sizes["ramp_within_2_y"] * y[k]
    circle[4] += sizes["ramp_within_2"]
    line = [x[0], x[1], x[2] + sizes["ramp_within_1"]]
    roots = [
        root.real
        for bound in (line, circle)
        for root in mp.polyroots(bound, maxsteps=500, extraprec=200)
        if abs(root.imag) < mpf(10) ** -25 and root.real > 0
    ]
    at = min(roots)
    moved = [p + v * at + a * at**2 / 2 for p, v, a in zip(place, speed, pull, strict=True)]
    return at, [*moved, *(v + a * at for v, a in zip(speed, pull, strict=True))]


def edge_rows(shots: hoopgen.Shots) -> list[tuple[Any, Any]]:
    """Return each begin of a roll with the end of that contact."""
    events = shots.events
    rolls = np.flatnonzero(events["kind"] == Event.ROLL)
    assert rolls[-1] + 1 < len(events), "the last roll has no end"
    return [(events[k], events[k + 1]) for k in rolls]


def test_a_ball_leaves_the_edge_where_the_closed_form_says(ramp: Engine) -> None:
    """The time is compared to a few roundings of the clock, over the speed for the place."""
    shots = ramp.simulate(dropped(trials(200)), record=True, time_limit=20)
    compared = 0
    with mp.workdps(40):
        for begin, end in edge_rows(shots):
            assert end["kind"] == Event.LEAVE
            at, moved = ramp_exit(begin["after"])
            speed = float(mp.norm(moved[3:]))
            error = 64 * 2.0**-53 * (1 + 1 / speed)
            assert abs(float(mpf(end["time"]) - mpf(begin["time"]) - at)) <= error
            off = [abs(float(m - mpf(float(s)))) for m, s in zip(moved, end["after"], strict=False)]
            assert max(off) <= 64 * 2.0**-53 * (1 + speed + 1 / speed)
            compared += 1
    assert compared > len(shots) / 4


def test_energy_is_kept_up_to_the_edge(ramp: Engine) -> None:
    shots = ramp.simulate(dropped(60, seed=5), record=True, time_limit=20)

    def energy(state: NDArray[np.float64]) -> float:
        turning = BALL**2 * (state[6:] @ state[6:])
        return float(state[3:6] @ state[3:6] / 2 + turning / 5 + GRAVITY * state[2])

    for begin, end in edge_rows(shots):
        assert energy(end["after"]) == pytest.approx(energy(begin["after"]), rel=1e-13, abs=1e-14)


def test_flights_off_an_edge_end_as_the_judge_proves(ramp: Engine) -> None:
    """The exact state two milliseconds after the edge is flown by the judge to its end."""
    shots = ramp.simulate(dropped(trials(300), seed=7), record=True, time_limit=20, fields=FIELDS)
    later, rows = [], []
    with mp.workdps(40):
        for begin, end in edge_rows(shots):
            if shots.uncertain[begin["shot"]]:
                continue
            _, moved = ramp_exit(begin["after"])
            wait = mpf(1) / 512
            state = [p + v * wait for p, v in zip(moved[:3], moved[3:], strict=True)]
            state += moved[3:]
            state[2] -= mpf(GRAVITY) * wait**2 / 2
            state[5] -= mpf(GRAVITY) * wait
            later.append([*map(float, state), *end["after"][6:]])
            rows.append(int(begin["shot"]))
    proof = certify(np.array(later), scene=RAMP, time_limit=20)
    assert np.count_nonzero(proof.decided) > len(rows) / 2
    again = ramp.simulate(np.array(later), time_limit=20, fields=FIELDS)
    for k, row in enumerate(rows):
        if proof.decided[k]:
            assert proof.outcome[k] == shots.outcome[row]
            assert again.outcome[k] == shots.outcome[row]
            bound = shots.state_error[row, 0] + again.state_error[k, 0] + 1e-14
            assert np.abs(again.state[k, :3] - shots.state[row, :3]).max() <= bound


def test_few_shots_off_an_edge_are_uncertain(ramp: Engine) -> None:
    shots = ramp.simulate(dropped(300), time_limit=20)
    assert np.count_nonzero(shots.uncertain) <= 6
    assert np.count_nonzero(shots.rolls) > 100


@pytest.mark.parametrize("scene", ["ramp", "green"])
def test_both_engines_pass_edges_alike(scene: str, request: pytest.FixtureRequest) -> None:
    engine = request.getfixturevalue(scene)
    states = dropped(12) if scene == "ramp" else putts(np.linspace(0.1, 2.0, 12))
    made = [
        engine.simulate(states, time_limit=5, fields=FIELDS, backend=backend)
        for backend in ("c", "numpy")
    ]
    for field in FIELDS:
        assert getattr(made[0], field).tobytes() == getattr(made[1], field).tobytes(), field


def putts(speeds: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return balls that roll towards the middle of the hole, a nanometre above the green."""
    states = np.zeros((len(speeds), 9))
    states[:, 0], states[:, 2] = -0.2, HOLE_BALL + 1e-9
    states[:, 3], states[:, 7] = speeds, speeds / HOLE_BALL
    return states


def test_a_slow_ball_pivots_about_an_edge_that_is_a_body(green: Engine) -> None:
    """A slow ball leaves where v² = g R cos a: 7/10 v² = 7/10 v0² + g R (1 - cos a)."""
    limit = math.sqrt(GRAVITY * HOLE_BALL)
    for speed in (0.1, 0.2, 0.4, 0.6, 0.9):
        shots = green.simulate(putts(np.array([speed])), record=True, time_limit=20)
        events = shots.events
        assert list(events["kind"][events["kind"] != Event.IMPACT])[:4] == [
            Event.ROLL,
            Event.LEAVE,
            Event.ROLL,
            Event.LEAVE,
        ]
        first, _, taken, left = events[events["kind"] != Event.IMPACT][:4]
        own = float(first["after"][3])
        assert taken["after"][0] == pytest.approx(-HOLE, abs=1e-15)
        assert taken["time"] - first["time"] == pytest.approx(
            (-HOLE - first["after"][0]) / own, rel=1e-13
        )
        if own >= limit:
            assert left["time"] == taken["time"]
            continue
        reach = GRAVITY * HOLE_BALL
        cosine = (1.4 * own**2 + 2 * reach) / (3.4 * reach)
        place = [-HOLE + HOLE_BALL * math.sqrt(1 - cosine**2), 0.0, HOLE_BALL * cosine]
        assert left["after"][:3] == pytest.approx(place, abs=1e-12)
        assert np.sum(left["after"][3:6] ** 2) == pytest.approx(reach * cosine, rel=1e-11)


@pytest.mark.slow
def test_a_ball_rolls_straight_on_from_plane_to_plane() -> None:
    tiles = Scene(
        "tiles_in_a_row",
        bodies=[
            Plane("first", within=["x - 0.5"]),
            Plane("second", within=["0.5 - x", "x - 1"]),
        ],
        ball_radius=BALL,
        gravity=GRAVITY,
        restitution=0.5,
        rolls=True,
        ends={"down": End(at=-1)},
    )
    engine = hoopgen.compile(tiles)
    state = np.array([0, 0, BALL + 1e-9, 0.3, 0.1, 0, -2, 6, 0])
    events = engine.simulate(state, record=True, time_limit=20).events
    left = events[events["kind"] == Event.LEAVE]
    rolled = events[events["kind"] == Event.ROLL]
    assert [row["after"][0] for row in left] == pytest.approx([0.5, 1.0], abs=1e-14)
    speed = rolled[0]["after"][3:5]
    assert left[1]["after"][3:5] == pytest.approx(speed, rel=1e-12)
    assert rolled[1]["time"] == left[0]["time"]


def test_a_ball_passes_a_plate_outside_its_bounds(table: Engine) -> None:
    """Balls roll under the table, off it, past the wall's plane, against it, and onto the step."""
    states = np.zeros((4, 9))
    states[:, 0], states[:, 1] = (-1, 0, 0, 0), (0, 0, 1.2, -0.2)
    states[:, 2], states[:, 3] = (-0.4, 0.1, -0.4, 0.1), (1, 0.8, 1, 0.8)
    shots = table.simulate(states, time_limit=20, record=True)
    assert not shots.uncertain.any()
    assert list(shots.outcome[:2]) == [table.outcomes["PAST"]] * 2
    assert list(shots.rolls[:2]) == [1, 2]
    assert shots.state[:2, 2] == pytest.approx(BALL - 0.5, abs=1e-15)
    assert shots.counts[:, 2].tolist() == [0, 0, 1, 0]
    assert shots.counts[:, 3].tolist() == [0, 0, 0, 1]
    struck = shots.events["after"][shots.events["after"][:, 0] > 1.4]
    struck = struck[np.argmax(struck[:, 1] > 1)]
    assert struck[:2] == pytest.approx([1.5 - BALL, 1.2], abs=1e-14)


def test_errors_grow_by_the_time_that_an_edge_is_uncertain_by(table: Engine) -> None:
    """The ball begins to fall at another time: its velocity changes by gravity times that.

    It is slow, so that its place has by far the larger error. A quarter of it counts in any case.
    """
    state = np.array([0, 0, 0.1, 0.05, 0, 0, 0, 0, 0])
    (begin, end) = edge_rows(table.simulate(state, record=True, time_limit=20))[0]
    before, after = (
        table.simulate(state, time_limit=float(end["time"]) + wait, fields=FIELDS).state_error[0]
        for wait in (-1e-6, 1e-6)
    )
    speed = float(begin["after"][3])
    assert after[1] - before[1] >= GRAVITY * before[0] / speed / 5


@pytest.mark.slow
def test_both_engines_say_alike_that_a_ball_has_rolled_in_air() -> None:
    """Two rolls are a truth value as one is; a value of 2 would be no NumPy bool."""
    windy = Scene(
        "windy_table",
        bodies=[Plane("floor", at=-0.5), Plane("table", within=["x**2 + y**2 - 0.09"])],
        ball_radius=BALL,
        gravity=GRAVITY,
        restitution=0,
        rolls=True,
        air=True,
        ends={"past": End(axis="-x", at=-2)},
    )
    state = np.array([0, 0, 0.1, 0.8, 0, 0, 0, 0, 0])
    engine = hoopgen.compile(windy)
    fields = (*FIELDS, "airless_rolls")
    made = [
        engine.simulate(state, time_limit=20, fields=fields, backend=backend)
        for backend in ("c", "numpy")
    ]
    assert made[0].rolls[0] == 2
    for field in fields:
        assert getattr(made[0], field).tobytes() == getattr(made[1], field).tobytes(), field


@pytest.mark.parametrize(
    ("body", "said"),
    [
        (Plane("one", within=["x**3 - y"]), r"body one: within 1: .* edge of degree 3"),
        (Cone("one", slope=1.0, within=["z**3"]), r"body one: within 1: .* edge of degree 3"),
        (Sphere("one", radius=1.0, within=["x*y*z"]), r"body one: within 1: .* edge of degree 3"),
        (
            Box("one", size=(1, 1, 1), orientation=(1, 0.1, 0, 0), within=["x**3"]),
            r"body one: within 1: .* edge of degree 3",
        ),
        (Torus("one", radius=1.0, within=["x"]), "body one: within: .* edge of a torus"),
    ],
)
def test_what_has_no_edge_to_roll_over_is_refused(body: Any, said: str) -> None:
    with pytest.raises(SceneError, match=said):
        Scene("refused", bodies=[body], ball_radius=BALL, gravity=1, restitution=0.5, rolls=True)


def test_a_disc_has_an_edge_to_roll_over() -> None:
    scene = Scene(
        "disc_alone",
        bodies=[Disc("disc", radius=0.3, axis=(0.1, 0, 1))],
        ball_radius=BALL,
        gravity=GRAVITY,
        restitution=0.5,
        rolls=True,
    )
    assert scene.derive().has_edges


def test_scenes_allow_bounds_of_the_degree_that_the_derivation_does() -> None:
    """Scenes are read without SymPy, so that the number stands twice."""
    assert oblique_bodies.MAX_DEGREE == bounds.MAX_DEGREE
