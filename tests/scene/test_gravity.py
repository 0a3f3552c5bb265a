"""Gravity of any size, zero included, and in any direction, which may differ from shot to shot."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

import hoopgen
from hoopgen.scene import (
    Box,
    Cone,
    Cylinder,
    Disc,
    End,
    Parameter,
    Plane,
    Revolution,
    Scene,
    SceneError,
    Sphere,
    Torus,
)
from hoopgen.scene.files import parse_scene
from hoopgen.scene.geometry import SceneGeometry
from hoopgen.simulation.engine import Engine
from tests.helpers.effort import exceptions, occurrences, trials
from tests.helpers.slow_scene import Slow

# One worker: each scene is compiled once.
pytestmark = [pytest.mark.xdist_group("gravity")]

Floats = NDArray[np.float64]

BALL, MOST = 0.0625, 8
PULL = Parameter("pull", 0.0, "m/s²", "gravity", sign="nonnegative")
WAYS = [Parameter(f"way_{k}", default, "1", sign="any") for k, default in enumerate((0, 0, -1), 1)]
DOWN = tuple(way.name for way in WAYS)

AROUND = [
    Sphere("globe", radius=0.4),
    Plane("wall", axis="x", at=-2),
    Plane("ramp", normal=(1, 1, -2), point=(0, 0, 2)),
    Box("brick", size=(0.4, 0.3, 0.2), centre=(1.2, 0.2, 0.1)),
    Torus("wheel", radius=0.4, wire=0.05, centre=(0, 1.3, 0), axis="y"),
    Cylinder("pole", radius=0.1, centre=(1, -1, 0), axis="x"),
    Cylinder("rod", radius=0.08, centre=(-1, -1, 0.3), axis=(1, 2, 2), span=(-0.5, 0.5)),
    Disc("plate", radius=0.3, centre=(-1, 0.6, 0.9), axis=(0.3, 0, 1)),
    Cone("spike", apex=(0.5, 0.4, -1), axis=(0.2, 0.1, -1), slope=0.6, span=(0.0, 0.5)),
]


def surroundings(name: str, **given: Any) -> Scene:
    """Return a scene of bodies of all kinds."""
    usual: dict[str, Any] = {
        "bodies": AROUND,
        "ball_radius": BALL,
        "restitution": 0.75,
        "ends": {"gone": End(axis="-x", at=-4)},
    }
    return Scene(name, **(usual | given))


FLOATING = surroundings("floating", gravity=0)
SWUNG = surroundings("swung", parameters=[PULL, *WAYS], gravity="pull", down=DOWN)
SIZED = surroundings(
    "sized",
    parameters=[PULL],
    gravity="pull",
    bodies=[AROUND[0], AROUND[1], AROUND[3]],
)


@pytest.fixture(scope="module")
def floating() -> Engine:
    return hoopgen.compile(FLOATING)


@pytest.fixture(scope="module")
def swung() -> Engine:
    return hoopgen.compile(SWUNG)


@pytest.fixture(scope="module")
def sized() -> Engine:
    return hoopgen.compile(SIZED)


def thrown(count: int, seed: int) -> Floats:
    """Return balls thrown about among the bodies."""
    chance = np.random.default_rng(seed)
    states = np.zeros((count, 9))
    states[:, :3] = chance.uniform((-1.6, -1.6, -1.2), (1.6, 1.6, 1.2), (count, 3))
    states[:, 3:6] = chance.normal(0, 2, (count, 3))
    states[:, 6:] = chance.normal(0, 10, (count, 3))
    return states


def gravities(count: int, seed: int) -> dict[str, Floats]:
    """Return sizes of gravity, a third of them zero and a third tiny, in random directions."""
    chance = np.random.default_rng(seed)
    kinds = (np.zeros(count), chance.uniform(1, 20, count), 10.0 ** chance.uniform(-14, 0, count))
    ways = chance.normal(0, 1, (count, 3))
    ways[::5, 1] = 0.0  # some lie in a plane, and across the axis of a body
    return {"pull": np.choose(np.arange(count) % 3, kinds), **dict(zip(DOWN, ways.T, strict=True))}


def check_against_the_judge(engine: Engine, states: Floats, values: Mapping[str, Any]) -> None:
    names = ("outcome", "uncertain", "counts", "time", "state", "time_error", "state_error")
    shots = engine.simulate(states, values, max_contacts=MOST, record=True, fields=names)
    twice = engine.simulate(states, values, max_contacts=MOST, backend="numpy", fields=names)
    for name in names:
        both = (np.asarray(getattr(found, name)) for found in (shots, twice))
        assert len({found.tobytes() for found in both}) == 1, name
    proofs = hoopgen.certify(states, values, scene=engine, max_contacts=MOST)
    # The judge leaves hardly any shot undecided; whatever it proves, the engines found or flagged.
    assert np.sum(~proofs.decided) < exceptions(0.001, len(states))
    assert proofs.agrees(shots)[proofs.decided].all()
    valid = shots.outcome != engine.outcomes["INVALID"]
    assert valid.mean() > 0.7
    pull = np.asarray(values.get("pull", 0.0))
    # Tiny gravity leaves open whether a plane is met after millions of seconds; and a ball that is
    # capped has bounced along a wall for many metres.
    usual = valid & ((pull == 0.0) | (pull > 1e-6))
    usual &= shots.outcome != engine.outcomes["CAPPED"]
    assert np.sum(shots.uncertain & usual) < exceptions(0.001, len(states))
    assert (shots.counts[valid].sum(axis=0) > occurrences(len(states) // 400)).all()
    sure = valid & ~shots.uncertain & proofs.decided
    away = np.abs(shots.state - proofs.state).reshape(-1, 3, 3).max(axis=2)
    claimed = shots.state_error + proofs.state_error
    assert (away <= claimed)[sure].all()
    late = np.abs(shots.time - proofs.time)
    assert (late <= shots.time_error + proofs.time_error)[sure].all()


@pytest.mark.slow
def test_without_gravity_shots_are_those_of_the_judge(floating: Engine) -> None:
    check_against_the_judge(floating, thrown(trials(10_000, at_least=300), 1), {})


@pytest.mark.slow
def test_gravity_of_any_size_and_direction_in_each_shot_is_that_of_the_judge(
    swung: Engine,
) -> None:
    count = trials(10_000, at_least=300)
    check_against_the_judge(swung, thrown(count, 2), gravities(count, 3))


@pytest.mark.slow
def test_a_size_that_differs_from_shot_to_shot_is_that_of_the_judge(sized: Engine) -> None:
    count = trials(10_000, at_least=300)
    values = {"pull": gravities(count, 4)["pull"]}
    check_against_the_judge(sized, thrown(count, 5), values)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["floating", "swung"])
def test_contacts_and_ends_are_those_of_a_slow_reference(
    name: str, request: pytest.FixtureRequest
) -> None:
    engine: Engine = request.getfixturevalue(name)
    made = FLOATING if name == "floating" else SWUNG
    count = trials(200, at_least=20)
    states = thrown(count, 6)
    values = {} if name == "floating" else gravities(count, 7)
    shots = engine.simulate(states, values, max_contacts=5, record=True, time_limit=3.0)
    compared = 0
    for row in np.flatnonzero(shots.outcome != engine.outcomes["INVALID"]):
        slow = Slow(made, {n: float(v[row]) for n, v in values.items()})
        flown = slow.fly(states[row], 5, 3.0)
        if flown.close or shots.uncertain[row]:
            continue
        events = shots.events[shots.events["shot"] == row]
        events = events[events["surface"] < len(made.bodies)]
        assert events["surface"].tolist() == [body for body, _ in flown.contacts], row
        times = [time for _, time in flown.contacts]
        np.testing.assert_allclose(events["time"], times, rtol=0, atol=1e-8)
        assert engine.outcomes(int(shots.outcome[row])).name.lower() == flown.outcome, row
        compared += 1
    assert compared > occurrences(count // 2)


def turned_scene(name: str, turn: Floats) -> Scene:
    """Return bodies of every kind, turned, and gravity with them."""
    x, y, z, w = map(float, Rotation.from_matrix(turn).as_quat())

    def way(*parts: float) -> tuple[float, float, float]:
        first, second, third = map(float, turn @ parts)
        return first, second, third

    return Scene(
        name,
        ball_radius=BALL,
        gravity=9.75,
        down=way(0.2, -0.3, -1),
        restitution=0.75,
        bodies=[
            Plane("floor", normal=way(0, 0.25, 1), point=way(0, 0, -1)),
            Sphere("globe", radius=0.3, centre=way(0.2, 0.1, 0)),
            Cylinder("rod", radius=0.1, centre=way(-0.5, 0.2, 0), axis=way(1, 2, 1)),
            Disc("plate", radius=0.5, centre=way(0.5, -0.5, 0.2), axis=way(0.3, 0, 1)),
            Torus("wheel", radius=0.3, wire=0.05, centre=way(-0.4, -0.7, 0.5), axis=way(0.3, 1, 0)),
            Cone(
                "spike", apex=way(0.6, 0.8, 0.5), axis=way(0.1, 0.2, -1), slope=0.5, span=(0, 0.6)
            ),
            Box(
                "brick",
                size=(0.5, 0.4, 0.3),
                centre=way(-0.8, -0.3, -0.4),
                orientation=(w, x, y, z),
            ),
            Revolution(
                "cup",
                profile=[(0.1, 0), (0.3, 0.3)],
                centre=way(1.0, 0.2, -0.5),
                axis=way(0.2, 0.1, 1),
            ),
        ],
    )


@pytest.mark.slow
def test_a_scene_turned_with_its_gravity_gives_the_turned_shots() -> None:
    """As far as the errors of both allow; the turned sizes are rounded, too."""
    turn = np.linalg.qr(np.random.default_rng(8).normal(0, 1, (3, 3)))[0]
    turn *= np.linalg.det(turn)
    one, other = (
        hoopgen.compile(turned_scene(name, of))
        for name, of in (("straight", np.eye(3)), ("aslant", turn))
    )
    count = trials(1000, at_least=200)
    states = thrown(count, 9)
    names = ("outcome", "uncertain", "counts", "state", "state_error")
    given: dict[str, Any] = {"max_contacts": 4, "time_limit": 2.0, "fields": names}
    there = np.einsum("ij,nkj->nki", turn, states.reshape(-1, 3, 3)).reshape(-1, 9)
    found, turned = one.simulate(states, **given), other.simulate(there, **given)
    sure = (found.outcome != one.outcomes["INVALID"]) & ~found.uncertain & ~turned.uncertain
    assert sure.mean() > 0.5
    assert (found.counts == turned.counts)[sure].all()
    assert (found.outcome == turned.outcome)[sure].all()
    assert (found.counts[sure].sum(axis=0) > occurrences(count // 200)).all()
    back = np.einsum("ij,nkj->nki", turn, found.state.reshape(-1, 3, 3)).reshape(-1, 9)
    away = np.abs(back - turned.state).reshape(-1, 3, 3).max(axis=2)
    assert (away <= found.state_error + turned.state_error)[sure].all()


BRICK = surroundings(
    "bricked",
    parameters=[PULL, *WAYS],
    gravity="pull",
    down=DOWN,
    bodies=[Box("brick", size=(0.6, 0.5, 0.4))],
    ends={},
)


@pytest.mark.slow
def test_a_pull_to_the_side_that_is_a_rounding_error_makes_no_shot_uncertain() -> None:
    """Without an end or a time limit, the sideways roots of a box come after 1e16 s."""
    engine = hoopgen.compile(BRICK)
    states = thrown(300, 11)
    states[:, :3] *= (0.3, 0.3, 0.2)
    states[:, 2] += 0.7  # above the box
    given: dict[str, Any] = {"time_limit": math.inf, "max_contacts": MOST}
    pulls = {"pull": 9.75, "way_1": 6e-17}
    straight, aslant = (
        engine.simulate(states, pulls | own, record=True, **given) for own in ({"way_1": 0}, {})
    )
    capped = (
        straight.outcome == engine.outcomes["CAPPED"]
    )  # after many bounces the errors are large
    assert capped.sum() < 10
    assert not straight.uncertain[~capped].any()
    assert not aslant.uncertain[~capped].any()
    np.testing.assert_array_equal(aslant.counts[~capped], straight.counts[~capped])
    assert aslant.contacts.sum() > 50
    proofs = hoopgen.certify(states, pulls, scene=engine, **given)
    assert proofs.agrees(aslant)[proofs.decided].all()
    assert proofs.decided.mean() > 0.9


CORRIDOR = Scene(
    "corridor",
    parameters=[PULL],
    ball_radius=0.25,
    gravity="pull",
    restitution=1,
    friction=0,
    bodies=[Plane("left", axis="x", at=-1), Plane("right", axis="-x", at=-1)],
    ends={"below": End(at=-8)},
)


@pytest.fixture(scope="module")
def corridor() -> Engine:
    return hoopgen.compile(CORRIDOR)


@pytest.mark.slow
def test_without_gravity_a_ball_goes_to_and_fro_at_constant_speed(corridor: Engine) -> None:
    """These times are exact doubles; without friction the speed along the walls is kept."""
    states = np.zeros((3, 9))
    states[:, 3] = 1.5
    states[1, 5] = -1.0
    shots = corridor.simulate(states, {"pull": [0.0, 0.0, 9.75]}, max_contacts=6, record=True)
    first = shots.events[shots.events["shot"] == 0]
    np.testing.assert_array_equal(first["time"], 0.5 + np.arange(6))
    assert shots.outcome.tolist() == [
        corridor.outcomes["CAPPED"],
        corridor.outcomes["CAPPED"],
        corridor.outcomes["BELOW"],
    ]
    slow = corridor.simulate(
        states[1], {"pull": 0.0}, max_contacts=20, fields=["outcome", "time", "time_error"]
    )
    assert slow.outcome == corridor.outcomes["BELOW"]
    np.testing.assert_allclose(slow.time, 8.0, rtol=0, atol=4 * slow.time_error[0])


@pytest.mark.slow
def test_a_ball_that_meets_nothing_ends_at_the_time_limit_or_short(corridor: Engine) -> None:
    states = np.zeros((2, 9))
    states[0, 4] = 1.0  # along both walls; the second ball stands still
    for pull in (0.0, 1e-12):
        limited = corridor.simulate(states, {"pull": pull}, time_limit=5.0)
        assert (limited.outcome == corridor.outcomes["ENDLESS"]).all()
        np.testing.assert_array_equal(limited.time, 5.0)
        assert not limited.uncertain.any()
    unlimited = corridor.simulate(states, {"pull": 0.0}, time_limit=math.inf)
    assert (unlimited.outcome == corridor.outcomes["SHORT"]).all()


@pytest.mark.slow
@pytest.mark.parametrize("pull", [-1.0, math.nan, math.inf])
def test_gravity_that_is_not_allowed_makes_its_own_row_invalid(
    corridor: Engine, pull: float
) -> None:
    states = np.zeros((2, 9))
    states[:, 3] = 1.0
    shots = corridor.simulate(states, {"pull": [pull, 0.0]}, max_contacts=3)
    assert (shots.outcome == corridor.outcomes["INVALID"]).tolist() == [True, False]


def test_a_direction_that_is_zero_makes_its_own_row_invalid_not_the_others() -> None:
    values = SWUNG.values({"pull": 9.75, "way_3": np.array([-1.0, 0.0])})
    found = {one.name: np.broadcast_to(v, 2) for one, v in zip(SWUNG.inputs, values, strict=True)}
    assert found["gravity_z"][0] == -9.75
    assert np.isnan(found["gravity_z"][1])


@pytest.mark.parametrize(
    ("given", "said"),
    [
        (
            {"gravity": -1},
            r"gravity: expected a number of at least 0, got -1; down is its direction",
        ),
        ({"gravity": -1, "down": (1, 0, -1)}, r"gravity: expected a number of at least 0, got -1"),
        ({"down": (0, 0, 0)}, r"down: has no direction: all three sizes are 0"),
        ({"down": "w"}, r"down: expected one of x, y, z"),
        ({"down": (1, 0)}, r"down: expected three sizes, or tilt and towards"),
        ({"gravity": 0, "rolls": True}, r"rolls: .* cannot be 0; expected gravity above 0"),
        (
            {"gravity": "pull", "parameters": [PULL], "rolls": True},
            r"rolls: .* cannot be 0: declare its sign as positive",
        ),
        (
            {"gravity": "pull", "parameters": [PULL], "down": (1, 0, -1), "rolls": True},
            r"rolls: .* cannot be 0: declare its sign as positive",
        ),
    ],
)
def test_what_gravity_cannot_be_is_said_when_the_scene_is_made(
    given: dict[str, Any], said: str
) -> None:
    usual: dict[str, Any] = {"bodies": [Plane("floor")], "gravity": 9.75}
    with pytest.raises(SceneError, match=said):
        surroundings("refused", **(usual | given))


def test_a_direction_along_an_axis_is_that_axis() -> None:
    along = surroundings("along", gravity=9.75, down=(0, -2, 0))
    assert along.read == surroundings("along", gravity=9.75, down="-y").read
    tilted = surroundings("along", gravity=9.75, down={"tilt": "90deg", "towards": "-90deg"})
    assert tilted.read == along.read


def test_a_file_has_the_same_directions() -> None:
    text = """
        name = "aslant"
        ball_radius = 0.0625
        gravity = 9.75
        down = DOWN
        restitution = 0.5
        [bodies.floor]
        kind = "plane"
    """
    angles = parse_scene(text.replace("DOWN", '{ tilt = "120deg", towards = "30deg" }').encode())
    inputs = {one.name: one.default for one in angles.inputs}
    size = 9.75 * math.sin(math.radians(120))
    np.testing.assert_allclose(
        [inputs[f"gravity_{axis}"] for axis in "xyz"],
        [size * math.cos(math.pi / 6), size / 2, -9.75 / 2],
        rtol=1e-14,
        atol=0,
    )
    vector = parse_scene(text.replace("DOWN", '[3, 0, "-4"]').encode())
    inputs = {one.name: one.default for one in vector.inputs}
    np.testing.assert_allclose(
        [inputs["gravity_x"], inputs["gravity_z"]], [5.85, -7.8], rtol=1e-15, atol=0
    )


def test_pictures_are_turned_so_that_gravity_points_down() -> None:
    chance = np.random.default_rng(10)
    for way in (*chance.normal(0, 1, (20, 3)), (1e-9, 0, 1), (0, 0, -1), (0, 0, 1)):
        values = dict(zip(DOWN, map(float, way), strict=True))
        found = SWUNG.values({"pull": 2.0, **values})
        own = {one.name: float(v) for one, v in zip(SWUNG.inputs, found, strict=True)}
        seen = SceneGeometry(SWUNG, own)
        turn, names = seen.upright
        np.testing.assert_allclose(turn @ turn.T, np.eye(3), rtol=0, atol=1e-15)
        assert np.linalg.det(turn) > 0
        np.testing.assert_allclose(turn @ seen.acceleration, (0, 0, -2), rtol=0, atol=1e-15)
        assert len(set(names)) == 3


@pytest.mark.slow
def test_a_page_refuses_shots_of_different_directions(swung: Engine, tmp_path: Any) -> None:
    values = {"pull": 9.75, "way_1": np.array([0.0, 0.5])}
    shots = swung.simulate(thrown(2, 11), values, max_contacts=2, record=True)
    with pytest.raises(ValueError, match=r"the direction of gravity differs from shot to shot"):
        hoopgen.view(shots, path=tmp_path / "shots.html")


@pytest.mark.slow
def test_the_derivation_says_that_gravity_may_be_zero() -> None:
    page = surroundings("page", parameters=[PULL], gravity="pull", bodies=AROUND[:1]).explain()
    assert "Here the acceleration $a$ may be zero along an axis." in page
