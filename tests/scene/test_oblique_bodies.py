"""Bodies along any direction in the engines, against the judge: parameters turn them."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import hoopgen
from hoopgen import Event
from hoopgen.scene import Cone, Cylinder, Disc, End, Parameter, Plane, Scene, Torus
from hoopgen.simulation.engine import Engine
from tests.helpers.derived import engine_of
from tests.helpers.effort import exceptions, occurrences, trials
from tests.helpers.own_scenes import compiled_as_for_users
from tests.helpers.slow_scene import Slow

# One worker: each scene is compiled once.
pytestmark = [pytest.mark.slow, pytest.mark.xdist_group("oblique_bodies")]

Floats = NDArray[np.float64]

BALL, GRAVITY, MOST = 0.06, 9.81, 6
CENTRES: Mapping[str, tuple[float, float, float]] = {
    "rod": (0.1, 0.5, 0.1),
    "plate": (-0.8, 0.6, 0.0),
    "pipe": (-0.9, -0.6, 0.2),
    "spike": (0.8, 0.8, 0.3),
    "funnel": (0.7, -0.8, -0.3),
    "hoop": (0.3, 0.1, 0.0),
    "hole": (-0.6, 0.2, 0.3),
}


def own(body: str, what: str) -> tuple[str, str, str]:
    """Return the names of the parameters of a direction or a centre."""
    return f"{body}_{what}_1", f"{body}_{what}_2", f"{body}_{what}_3"


def parameters(*bodies: str) -> list[Parameter]:
    made = [Parameter("steep", 0.7, "1")]
    for body in bodies:
        vector = zip(own(body, "way"), (0.25, -0.5, 1.0), strict=True)
        made += [Parameter(name, value, "1", sign="any") for name, value in vector]
        if body in CENTRES:
            place = zip(own(body, "place"), CENTRES[body], strict=True)
            made += [Parameter(name, value, sign="any") for name, value in place]
    return made


def scene(name: str, names: tuple[str, ...], *bodies: Any, **given: Any) -> Scene:
    return Scene(
        name,
        parameters=parameters(*names),
        bodies=bodies,
        ball_radius=BALL,
        gravity=GRAVITY,
        restitution=0.75,
        **given,
    )


def placed(body: str) -> dict[str, Any]:
    return {"axis": own(body, "way"), "centre": own(body, "place")}


STRAIGHT = scene(
    "straight",
    ("ramp", "rod", "plate"),
    Plane("ramp", normal=own("ramp", "way"), at=-0.9),
    Cylinder("rod", radius=0.08, span=(-0.5, 0.5), **placed("rod")),
    Disc("plate", radius=0.3, **placed("plate")),
    ends={"gone": End(at=-4)},
)
ROUND = scene(
    "round",
    ("spike", "funnel", "pipe"),
    Cone(
        "spike",
        slope="steep",
        axis=own("spike", "way"),
        apex=own("spike", "place"),
        span=(None, 0.7),
    ),
    Cone(
        "funnel",
        slope="steep",
        axis=own("funnel", "way"),
        apex=own("funnel", "place"),
        span=(0.15, 0.6),
        inside=True,
    ),
    Cylinder(
        "pipe",
        radius=0.3,
        span=(-0.4, 0.4),
        inside=True,
        within=["z - pipe_place_3 - steep/2"],
        **placed("pipe"),
    ),
    ends={"gone": End(at=-4)},
)


RINGS = scene(
    "rings",
    ("hoop", "hole", "ramp"),
    Torus("hoop", radius=0.23, wire=0.02, **placed("hoop")),
    Torus("hole", radius="steep/2", **placed("hole")),
    Plane("ramp", normal=own("ramp", "way"), at=-0.9),
    ends={"gone": End(at=-4)},
)


@pytest.fixture(scope="module")
def rings() -> Engine:
    return hoopgen.compile(RINGS)


@pytest.fixture(scope="module")
def straight() -> Engine:
    return hoopgen.compile(STRAIGHT)


@pytest.fixture(scope="module")
def round_bodies() -> Engine:
    return compiled_as_for_users(ROUND)


def turned_at_random(made: Scene, count: int, seed: int) -> dict[str, Any]:
    """Return parameters that turn every body in every shot; the ramp faces up."""
    chance = np.random.default_rng(seed)
    values: dict[str, Any] = {"steep": chance.uniform(0.2, 3.0, count)}
    for name in made.defaults:
        if "_way_" in name:
            values[name] = chance.normal(0, 1, count)
    if "ramp_way_3" in values:
        values["ramp_way_3"] = np.abs(values["ramp_way_3"]) + 0.5
    return values


def aimed(made: Scene, count: int, seed: int) -> Floats:
    """Return shots that fly near the bodies."""
    centres = [CENTRES.get(body.name, (0.0, 0.0, -0.8)) for body in made.bodies]
    return aimed_at(centres, count, seed)


def aimed_at(centres: Sequence[Sequence[float]], count: int, seed: int) -> Floats:
    """Return shots that fly near places, with any spin."""
    chance = np.random.default_rng(seed)
    goal = np.array(centres)[chance.integers(0, len(centres), count)]
    goal = goal + chance.normal(0, 0.15, (count, 3))
    states = np.zeros((count, 9))
    states[:, :3] = goal + chance.normal(0, 0.7, (count, 3))
    time = chance.uniform(0.1, 0.7, (count, 1))
    states[:, 3:6] = (goal - states[:, :3]) / time
    states[:, 5] += GRAVITY * time[:, 0] / 2
    states[:, 6:] = chance.normal(0, 10, (count, 3))
    return states


def check_against_the_judge(engine: Engine, made: Scene, count: int, seed: int) -> None:
    states, values = aimed(made, count, seed), turned_at_random(made, count, seed)
    check_shots(engine, states, values)


def check_shots(engine: Engine, states: Floats, values: Mapping[str, Any]) -> None:
    """Compare both engines with each other and the judge; every body is met."""
    count = len(states)
    names = ("outcome", "uncertain", "counts", "time", "state", "time_error", "state_error")
    shots = engine.simulate(states, values, max_contacts=MOST, record=True, fields=names)
    twice = engine.simulate(states, values, max_contacts=MOST, backend="numpy", fields=names)
    for name in names:
        both = (np.asarray(getattr(found, name)) for found in (shots, twice))
        assert len({found.tobytes() for found in both}) == 1, name
    proofs = hoopgen.certify(states, values, scene=engine, max_contacts=MOST)
    assert proofs.decided.all()
    assert proofs.agrees(shots).all()
    valid = shots.outcome != engine.outcomes["INVALID"]
    assert valid.mean() > 0.7
    assert np.sum(shots.uncertain & valid) < exceptions(0.001, count)
    assert (shots.counts[valid].sum(axis=0) > occurrences(count // 100)).all()
    sure = valid & ~shots.uncertain
    away = np.abs(shots.state - proofs.state).reshape(-1, 3, 3).max(axis=2)
    assert (away <= shots.state_error + proofs.state_error)[sure].all()
    late = np.abs(shots.time - proofs.time)
    assert (late <= shots.time_error + proofs.time_error)[sure].all()


def test_planes_cylinders_and_discs_turn_at_random(straight: Engine) -> None:
    """10,000 shots, each with its own directions: the sequences proved, or flagged."""
    check_against_the_judge(straight, STRAIGHT, trials(10_000, at_least=300), seed=1)


def test_cones_and_pipes_turn_at_random(round_bodies: Engine) -> None:
    """10,000 shots, each with its own directions: the sequences proved, or flagged."""
    check_against_the_judge(round_bodies, ROUND, trials(10_000, at_least=300), seed=2)


def test_tori_turn_at_random(rings: Engine) -> None:
    """10,000 shots, each with its own directions: the sequences proved, or flagged."""
    check_against_the_judge(rings, RINGS, trials(10_000, at_least=300), seed=3)


def test_turned_tori_are_met_where_an_independent_integrator_meets_them(rings: Engine) -> None:
    count = trials(200, at_least=40)
    states, values = aimed(RINGS, count, 9), turned_at_random(RINGS, count, 9)
    usual = {name: float(value) for name, value in RINGS.defaults.items()}
    check_integrator(rings, RINGS, states, values, usual)


def check_integrator(
    engine: Engine, made: Scene, states: Floats, values: Mapping[str, Any], usual: dict[str, float]
) -> None:
    """Compare the contacts of three bodies with those of an integrator that shares no code."""
    count = len(states)
    shots = engine.simulate(states, values, max_contacts=3, record=True, time_limit=3.0)
    compared = np.zeros(3, int)
    for row in np.flatnonzero(shots.outcome != engine.outcomes["INVALID"]):
        slow = Slow(made, usual | {name: float(v[row]) for name, v in values.items()})
        flown = slow.fly(states[row], 3, 3.0)
        if flown.close or shots.uncertain[row]:
            continue
        events = shots.events[(shots.events["shot"] == row) & (shots.events["surface"] < 3)]
        assert events["surface"].tolist() == [body for body, _ in flown.contacts], row
        times = [time for _, time in flown.contacts]
        np.testing.assert_allclose(events["time"], times, rtol=0, atol=1e-8)
        compared += np.bincount(events["surface"], minlength=3)
    assert (compared > occurrences(count // 20)).all()


def rotated(values: Mapping[str, Any], angle: Floats) -> dict[str, Any]:
    """Return the parameters of bodies turned about the vertical."""
    found = dict(values)
    for name in values:
        if name.endswith("_1"):
            first, second = values[name], values[name[:-1] + "2"]
            found[name] = np.cos(angle) * first - np.sin(angle) * second
            found[name[:-1] + "2"] = np.sin(angle) * first + np.cos(angle) * second
    return found


@pytest.mark.parametrize("which", ["straight", "round_bodies", "rings"])
def test_a_scene_turned_about_the_vertical_gives_the_turned_shots(
    which: str, request: pytest.FixtureRequest
) -> None:
    """As far as the errors of both allow: the turned parameters are rounded, too."""
    engine: Engine = request.getfixturevalue(which)
    made = {"straight": STRAIGHT, "round_bodies": ROUND, "rings": RINGS}[which]
    count = trials(1000, at_least=200)
    angle = np.random.default_rng(4).uniform(-math.pi, math.pi, count)
    states, values = aimed(made, count, 5), turned_at_random(made, count, 5)
    if which != "straight":
        values["steep"] = np.full(count, 0.75)
    values |= {
        name: np.full(count, value) for name, value in made.defaults.items() if name not in values
    }
    turn = np.zeros((count, 3, 3))
    turn[:, 0, 0] = turn[:, 1, 1] = np.cos(angle)
    turn[:, 1, 0] = np.sin(angle)
    turn[:, 0, 1] = -turn[:, 1, 0]
    turn[:, 2, 2] = 1.0

    def turned(rows: Floats) -> Floats:
        vectors = np.einsum("nij,nkj->nki", turn, rows.reshape(count, 3, 3))
        return np.asarray(vectors.reshape(count, 9))

    names = ("outcome", "uncertain", "counts", "state", "state_error")
    one = engine.simulate(states, values, max_contacts=MOST, fields=names)
    other = engine.simulate(turned(states), rotated(values, angle), max_contacts=MOST, fields=names)
    sure = (one.outcome != engine.outcomes["INVALID"]) & ~one.uncertain & ~other.uncertain
    assert sure.mean() > 0.7
    assert (one.outcome == other.outcome)[sure].all()
    assert (one.counts == other.counts)[sure].all()
    away = np.abs(turned(one.state) - other.state).reshape(-1, 3, 3).max(axis=2)
    assert (away <= one.state_error + other.state_error)[sure].all()


def test_a_row_without_a_direction_is_invalid_and_the_others_are_not(straight: Engine) -> None:
    states = aimed(STRAIGHT, 3, 6)
    values: dict[str, Any] = {name: np.full(3, 0.5) for name in own("ramp", "way")}
    for name in values:
        values[name][1] = 0.0
    values["ramp_way_2"][2] = math.nan
    shots = straight.simulate(states, values, max_contacts=MOST)
    invalid = shots.outcome == straight.outcomes["INVALID"]
    assert invalid.tolist() == [False, True, True]
    none, zeros, unknown = hoopgen.why_invalid(states, values, scene=straight)
    assert none == ""
    assert zeros.startswith("out of range: direction x of body ramp: ramp_way_1/sqrt(ramp_way_1**2")
    assert " = nan, expected a size of at most " in zeros
    assert unknown == "not finite: ramp_way_2"


def test_the_errors_of_a_cylinder_do_not_depend_on_which_point_of_its_axis_is_given(
    tmp_path: Path,
) -> None:
    """300 m away along the axis: the claims hold, and are no larger."""
    way, near = np.array([0.25, 0.5, 0.75]), np.array([0.125, 0.25, 0.0625])
    count = trials(200, at_least=50)
    chance = np.random.default_rng(8)
    states = np.zeros((count, 9))
    states[:, :3] = near + [0, 0, 0.6] + chance.normal(0, 0.03, (count, 3))
    found = []
    for far in (0.0, 400.0):
        made = Scene(
            "far",
            bodies=[
                Cylinder("rod", radius=0.03, axis=tuple(way), centre=tuple(near - far * way)),
                Plane("floor", at=-0.6),
            ],
            ball_radius=BALL,
            gravity=GRAVITY,
            restitution=0.75,
        )
        engine = engine_of(made, tmp_path)
        names = ("outcome", "uncertain", "counts", "state", "state_error")
        shots = engine.simulate(states, max_contacts=2, record=True, fields=names)
        proofs = engine.certify(states, max_contacts=2)
        assert proofs.agrees(shots).all()
        assert not shots.uncertain.any()
        assert (shots.counts[:, 0] > 0).mean() > 0.8
        away = np.abs(shots.state - proofs.state).reshape(-1, 3, 3).max(axis=2)
        assert (away <= shots.state_error + proofs.state_error).all()
        found.append(np.median(shots.state_error, axis=0))
    assert (found[1] < 4 * found[0]).all()


SLIDE = Scene(
    "slide",
    parameters=[Parameter("lean", 0.25, "1", sign="any"), Parameter("kappa", 2 / 3, "1")],
    bodies=[Plane("ramp", normal=(0.1, "lean", 1))],
    ball_radius=BALL,
    gravity=GRAVITY,
    inertia="kappa",
    restitution=0.4,
    rolls=True,
)


def test_a_ball_rolls_down_an_inclined_plane() -> None:
    """With the acceleration of gravity along it over 1 + kappa; a parameter turns the plane."""
    count = trials(40, at_least=20)
    chance = np.random.default_rng(7)
    values = {"lean": chance.uniform(-0.5, 0.5, count), "kappa": chance.choice([0.4, 2 / 3], count)}
    states = np.zeros((count, 9))
    states[:, 2] = 1.0
    states[:, 3:6] = chance.normal(0, 0.3, (count, 3))
    engine = hoopgen.compile(SLIDE)
    shots = engine.simulate(states, values, time_limit=4.0, record=True)
    twice = engine.simulate(states, values, time_limit=4.0, backend="numpy")
    assert shots.state.tobytes() == twice.state.tobytes()
    begun = shots.events[shots.events["kind"] == Event.ROLL]
    assert begun["shot"].tolist() == list(range(count))
    assert (shots.outcome == engine.outcomes["ENDLESS"]).all()
    normal = np.stack([np.full(count, 0.1), values["lean"], np.ones(count)], 1)
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    fall = GRAVITY * (normal * normal[:, 2:] - [0, 0, 1]) / (1 + values["kappa"][:, None])
    start, time = begun["after"], 4.0 - begun["time"][:, None]
    assert (time > 1.0).all()
    moved = start[:, :3] + start[:, 3:6] * time + fall * time**2 / 2
    assert np.abs(shots.state[:, :3] - moved).max() < 1e-9
    assert np.abs(shots.state[:, 3:6] - (start[:, 3:6] + fall * time)).max() < 1e-9
    assert np.abs(np.sum(shots.state[:, :3] * normal, axis=1) - BALL).max() < 1e-12
    proofs = hoopgen.certify(states, values, scene=engine, time_limit=4.0)
    assert proofs.agrees(shots).all()
