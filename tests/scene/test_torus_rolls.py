"""Rolls on tori anywhere and about any axis: on rings that lie, lean and stand, outside and within.

Each roll is integrated again, with the nearest point of the torus and its rate as all that is known
of it: by DOP853, up to where the normal force vanishes.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
import pytest
from hoopgen.derive.model import build
from numpy.typing import NDArray

pytest.importorskip("flint")


import hoopgen
from hoopgen import Event
from hoopgen.scene import Cylinder, End, Parameter, Plane, Scene, Torus
from hoopgen.simulation.engine import Engine
from tests.helpers import ROOT
from tests.helpers.derived import DerivedKernels
from tests.helpers.effort import trials
from tests.scene.test_cone_rolls import energy, turned
from tests.scene.test_oblique_rolls import (
    BALL,
    CLAIMS,
    FALL,
    GRAVITY,
    Body,
    check_proofs,
    compare,
    pushed,
    rolled,
)

pytestmark = [
    pytest.mark.slow,
    pytest.mark.xdist_group("torus_rolls"),  # compiled once
]

KAPPA = 2 / 3

Floats = NDArray[np.float64]

LYING_Y = 0.2
LYING = {"centre": (0.0, LYING_Y, 0.0), "axis": (0.0, 0.0, 1.0), "radius": 0.3, "wire": 0.1}
LEANING = {"centre": (2.0, 0.1, -0.1), "axis": (0.3, -0.2, 0.9), "radius": 0.4, "wire": 0.05}
STANDING = {"centre": (4.0, 0.0, 0.0), "axis": (1.0, 0.0, 0.0), "radius": 0.5, "wire": 0.06}
WHEEL = {"centre": (6.3, 0.0, 0.1), "axis": (-1.0, 0.4, 0.2), "radius": 0.35, "wire": 0.2}
GIVEN: tuple[Mapping[str, Any], ...] = (LYING, LEANING, STANDING, WHEEL)
NAMES = ("lying", "leaning", "standing", "wheel")


def tori() -> list[Torus]:
    """Return the tori as bodies; the axis of the one that lies is a coordinate axis."""
    found = []
    for name, given in zip(NAMES, GIVEN, strict=True):
        axis: Any = "z" if name == "lying" else turned(given["axis"])
        sizes = {"radius": given["radius"], "wire": given["wire"]}
        centre: Any = given["centre"] if name != "lying" else (0, "lying_y", 0)
        found.append(Torus(name, centre=turned(centre), axis=axis, **sizes))
    return found


TORI = Scene(
    "tori_to_roll_on",
    parameters=[
        Parameter("cos_turn", 1.0, "1", sign="any"),
        Parameter("sin_turn", 0.0, "1", sign="any"),
        Parameter("mirror", 1.0, "1", sign="any"),
        Parameter("kappa", KAPPA, "1"),
        Parameter("lying_y", LYING_Y, "m", sign="any"),
    ],
    bodies=[*tori(), Plane("floor", at=-0.7)],
    ball_radius=BALL,
    gravity=GRAVITY,
    restitution=0.3,
    inertia="kappa",
    rolls=True,
)


RING = Scene(
    "ring_alone",
    bodies=[Torus("ring", radius=0.3, wire=0.1)],
    ball_radius=BALL,
    gravity=GRAVITY,
    restitution=0.3,
    rolls=True,
)

SIDEWAYS = Scene(
    "tori_across_gravity",
    bodies=[
        Torus("standing", radius=0.5, wire=0.06),
        Torus("lying", radius=0.3, wire=0.1, centre=(0.2, 0.0, -4.0), axis="y"),
        Plane("floor", axis="y", at=-0.7),
    ],
    ball_radius=BALL,
    gravity=GRAVITY,
    down="-y",
    restitution=0.3,
    rolls=True,
)
"""Two of the tori with (y, z, x) in the place of (x, y, z), and the origin in the one that stands:
it is about the z axis, across gravity."""


@pytest.fixture(scope="module")
def engine() -> Engine:
    return hoopgen.compile(TORI)


def on_tube(
    given: Mapping[str, Any],
    azimuth: Floats,
    angle: Floats,
    climb: Floats,
    along: Floats,
    spun: Floats,
) -> Floats:
    """Return balls that touch a torus and roll, by their place and speed on it.

    The angle is that around the wire, from outwards to the axis's side; the speeds are those
    around the wire and along it, and the ball's radius times its spin about the normal, m/s.
    """
    unit, first, second = frame(given)
    out = np.cos(azimuth)[:, None] * first + np.sin(azimuth)[:, None] * second
    normal = np.cos(angle)[:, None] * out + np.sin(angle)[:, None] * unit
    around = np.cos(angle)[:, None] * unit - np.sin(angle)[:, None] * out
    place = given["centre"] + given["radius"] * out + (given["wire"] + BALL) * normal
    velocity = climb[:, None] * around + along[:, None] * np.cross(unit, out)
    spin = (np.cross(normal, velocity) + spun[:, None] * normal) / BALL
    return np.hstack([place, velocity, spin])


def frame(given: Mapping[str, Any]) -> tuple[Floats, Floats, Floats]:
    """Return the unit vector along the axis of a torus, and two across it."""
    unit = np.array(given["axis"]) / np.linalg.norm(given["axis"])
    first = np.cross(unit, [0.3, 0.5, 0.1])
    first /= np.linalg.norm(first)
    return unit, first, np.cross(unit, first)


def dropped(count: int, seed: int) -> Floats:
    """Return balls that fall onto the tori, a little above a place on top of the wire."""
    chance = np.random.default_rng(seed)
    which = np.arange(count) % 4
    states = np.zeros((count, 9))
    for own, given in enumerate(GIVEN):
        chosen = which == own
        many = np.count_nonzero(chosen)
        azimuth, tilt = chance.uniform(0, 2 * np.pi, many), chance.normal(0, 0.3, many)
        unit, first, second = frame(given)
        out = np.cos(azimuth)[:, None] * first + np.sin(azimuth)[:, None] * second
        top = np.arctan2(unit[2], out[:, 2]) + tilt
        still = np.zeros(many)
        states[chosen] = on_tube(GIVEN[own], azimuth, top, still, still, still)
    states[:, 2] += chance.uniform(0.001, 0.02, count)
    states[:, 3:6] = chance.normal(0, 0.2, (count, 3))
    states[:, 6:] = chance.normal(0, 5, (count, 3))
    return states


# The second formulation


def torus(given: Mapping[str, Any]) -> Body:
    """Return a torus, by the point of the wire's surface that is nearest to the ball's centre."""
    centre, wire, radius = np.array(given["centre"]), given["wire"], given["radius"]
    unit = np.array(given["axis"]) / np.linalg.norm(given["axis"])

    def nearest(place: Floats) -> tuple[Floats, Floats]:
        across = place - centre - (place - centre) @ unit * unit
        rho = np.linalg.norm(across)
        out = across / rho
        around = np.cross(unit, out)
        # The nearest point of the centre circle moves around the axis alone.
        middle, moves = centre + radius * out, radius / rho * np.outer(around, around)
        way = place - middle
        far = np.linalg.norm(way)
        normal = way / far
        turns = (np.eye(3) - moves - np.outer(normal, normal)) / far
        return middle + wire * normal, moves + wire * turns

    return Body(nearest)


def follower(own: int) -> Callable[[Any, float], tuple[int, float, Floats] | None]:
    """Return the function that integrates a roll on a torus of the scene."""

    def follow(begin: Any, until: float) -> tuple[int, float, Floats] | None:
        return rolled(torus(GIVEN[own]), begin["after"], until) if begin["surface"] == own else None

    return follow


def rolling(own: int, count: int, seed: int) -> Floats:
    """Return balls that roll on a torus, are pressed onto it, and are all around the wire."""
    chance = np.random.default_rng(seed)
    azimuth, angle = chance.uniform(0, 2 * np.pi, (2, 40 * count))
    climb, along, spun = chance.normal(0, 1, (3, 40 * count)) * np.array([[0.3], [1.5], [0.5]])
    states = on_tube(GIVEN[own], azimuth, angle, climb, along, spun)
    force = np.array([pushed(torus(GIVEN[own]), state)[0] for state in states])
    return states[force > 0.1][:count]


@pytest.mark.parametrize("own", range(4))
def test_rolls_on_a_torus_are_those_of_a_second_formulation(engine: Engine, own: int) -> None:
    """They end where the normal force vanishes: on the wire, beside it, and within the hole."""
    states = rolling(own, trials(100, 50), 1)
    shots = engine.simulate(states, time_limit=1, record=True, leaving=NAMES[own])
    assert len(compare(shots, follower(own))) > 0.6 * len(states)
    assert not np.any(shots.outcome == engine.outcomes["CAPPED"])
    left = shots.events["before"][shots.events["kind"] == Event.LEAVE, :3] - GIVEN[own]["centre"]
    rho = np.linalg.norm(np.cross(left, frame(GIVEN[own])[0]), axis=1)
    assert np.count_nonzero(rho < GIVEN[own]["radius"]) > len(states) / 10


@pytest.mark.parametrize("own", range(4))
def test_rolls_after_bounces_are_those_of_a_second_formulation(engine: Engine, own: int) -> None:
    states = dropped(trials(200, 100), 1)[own::4]
    shots = engine.simulate(states, time_limit=1, record=True)
    assert len(compare(shots, follower(own))) > len(states) / 3
    assert not np.any(shots.outcome == engine.outcomes["CAPPED"])


def away(given: Mapping[str, Any], places: Floats) -> Floats:
    """Return the distances of balls from a torus."""
    unit = frame(given)[0]
    ways = places - given["centre"]
    height = ways @ unit
    rho = np.linalg.norm(ways - np.outer(height, unit), axis=1)
    return np.hypot(rho - given["radius"], height) - given["wire"] - BALL


@pytest.mark.parametrize("own", range(4))
def test_a_ball_that_has_left_a_torus_does_not_come_through_it(engine: Engine, own: int) -> None:
    """Its gap opens as the third power of the time, and it falls onto the torus again."""
    states = rolling(own, trials(60, 30), 4)
    shots = engine.simulate(states, time_limit=0.6, record=True, leaving=NAMES[own])
    through = np.zeros(len(states), bool)
    for k in range(len(states)):
        path = shots.trajectory(k)
        places = path.at(np.linspace(0, path.duration, 200))[:, :3]
        through[k] = away(GIVEN[own], places).min() < -1e-11
    assert not np.any(through & ~shots.uncertain)
    # A search that gives up says so, and its ball flies on.
    assert np.count_nonzero(through) <= max(1, len(states) / 50)


@pytest.mark.parametrize("own", range(4))
def test_the_path_of_a_roll_is_that_of_a_second_formulation(engine: Engine, own: int) -> None:
    states = rolling(own, trials(20, 10), 5)
    shots = engine.simulate(states, time_limit=1, record=True, leaving=NAMES[own])
    for k in np.flatnonzero(~shots.uncertain):
        path, end = shots.trajectory(int(k)), shots.events[shots.events["shot"] == k][1]["time"]
        middle = path.at(np.array([0.6 * end]))[0]
        kind, _, state = rolled(torus(GIVEN[own]), states[k], 0.6 * end)
        assert kind == -1
        assert abs(away(GIVEN[own], middle[None, :3])[0]) < 1e-14
        assert middle[:3] == pytest.approx(state[:3], abs=1e-10)
        assert middle[3:6] == pytest.approx(state[3:6], abs=1e-8)


@pytest.mark.parametrize("kappa", [0.4, 2 / 3, 1.0])
def test_a_ball_that_rolls_keeps_its_energy(engine: Engine, kappa: float) -> None:
    longest = 0.0
    for own, name in enumerate(NAMES):
        states = rolling(own, trials(50, 30), 6)
        given = {"kappa": kappa}
        shots = engine.simulate(states, given, time_limit=3, record=True, leaving=name)
        events = shots.events
        begins = np.flatnonzero((events["kind"] == Event.ROLL) & (events["surface"] == own))
        begins = begins[begins + 1 < len(events)]
        first, last = events["after"][begins], events["before"][begins + 1]
        change = energy(last, kappa) - energy(first, kappa)
        assert np.max(np.abs(change)) < 1e-12
        longest = max(longest, np.max(events["time"][begins + 1] - events["time"][begins]))
    assert longest > 0.5


def test_contacts_before_a_roll_on_a_torus_are_proved_or_flagged(engine: Engine) -> None:
    check_proofs(engine, dropped(trials(120, 40), 2), None)


def agree(
    first: hoopgen.Shots,
    other: hoopgen.Shots,
    share: float,
    *turns: Floats,
    origin: tuple[float, ...] = (0.0, 0.0, 0.0),
) -> None:
    """Check that shots are the same but for a turn of each vector, within the claims of both.

    Places are turned about the origin. At least so large a share of the shots is certain.
    """
    sure = ~(first.uncertain | other.uncertain)
    assert np.count_nonzero(sure) > share * len(sure)
    assert np.array_equal(first.rolls[sure], other.rolls[sure])
    assert np.count_nonzero(first.rolls[sure]) > share * np.count_nonzero(sure) / 2
    vectors = first.state[sure] - np.concatenate([origin, np.zeros(6)])
    for k, by in enumerate(turns):
        part = slice(3 * k, 3 * k + 3)
        off = np.linalg.norm(vectors[:, part] @ by.T - other.state[sure, part], axis=1)
        allowed = first.state_error[sure, k] + other.state_error[sure, k]
        # The turn itself rounds the start, by some units in the last place.
        assert np.all(off <= 4 * allowed), np.max(off / allowed)


def test_a_torus_about_the_origin_and_the_z_axis_is_rolled_on_as_the_ring_is(
    engine: Engine,
) -> None:
    """The ring has series in coordinates of its own."""
    ring = hoopgen.compile(RING)
    states = rolling(0, trials(200, 100), 7)
    states[:, 1] -= LYING_Y
    values = {"lying_y": 0.0}
    first = engine.simulate(states, values, time_limit=0.25, fields=CLAIMS, leaving="lying")
    other = ring.simulate(states, time_limit=0.25, fields=CLAIMS, leaving="ring")
    agree(first, other, 0.8, *[np.eye(3)] * 3)
    fallen = dropped(trials(400, 200), 8)[::4] - np.eye(9)[1] * LYING_Y
    first = engine.simulate(fallen, values, time_limit=0.25, fields=CLAIMS)
    agree(first, ring.simulate(fallen, time_limit=0.25, fields=CLAIMS), 0.8, *[np.eye(3)] * 3)


def test_tori_across_gravity_are_rolled_on_as_those_that_are_turned(engine: Engine) -> None:
    sideways = hoopgen.compile(SIDEWAYS)
    turn = np.roll(np.eye(3), 1, axis=1)
    for own in (0, 2):
        states = rolling(own, trials(200, 80), 9)
        moved = np.hstack([states[:, k : k + 3] @ turn.T for k in (0, 3, 6)])
        moved[:, :3] -= turn @ np.array([4.0, 0.0, 0.0])
        first = engine.simulate(states, time_limit=0.25, fields=CLAIMS, leaving=NAMES[own])
        other = sideways.simulate(moved, time_limit=0.25, fields=CLAIMS, leaving=NAMES[own])
        agree(first, other, 0.6, turn, turn, turn, origin=(4.0, 0.0, 0.0))


def test_a_scene_that_is_turned_and_mirrored_gives_turned_and_mirrored_rolls(
    engine: Engine,
) -> None:
    """The spin, an axial vector, is mirrored the other way."""
    angle, mirror = 0.7, -1.0
    c, s = np.cos(angle), np.sin(angle)
    turn = np.diag([1, mirror, 1]) @ np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
    axial = mirror * turn
    values = {"cos_turn": c, "sin_turn": s, "mirror": mirror}
    states = dropped(trials(200, 100), 6)
    moved = np.hstack([states[:, :3] @ turn.T, states[:, 3:6] @ turn.T, states[:, 6:] @ axial.T])
    first = engine.simulate(states, time_limit=0.5, fields=CLAIMS)
    other = engine.simulate(moved, values, time_limit=0.5, fields=CLAIMS)
    agree(first, other, 0.6, turn, turn, axial)


# A hole elsewhere

HOLE = Scene(
    "hole_elsewhere",
    parameters=[Parameter(name, 0.0, "m", sign="any") for name in ("there_x", "there_y")],
    bodies=[
        Plane("green", within=["0.054**2 - (x - there_x)**2 - (y - there_y)**2"], restitution=0.5),
        Torus("edge", radius=0.054, centre=("there_x", "there_y", 0), restitution=0.5),
        Cylinder(
            "cup",
            radius=0.054,
            inside=True,
            span=(-0.1, 0),
            centre=("there_x", "there_y", 0),
            restitution=0.3,
        ),
    ],
    ball_radius=0.02135,
    gravity=GRAVITY,
    inertia=2 / 5,
    rolls=True,
    ends={"holed": End(at=-0.05)},
)
"""The golf hole of the examples, at any place: its edge is no ring about the origin."""


@pytest.fixture(scope="module")
def hole() -> Engine:
    return hoopgen.compile(HOLE)


def test_a_ball_rolls_into_a_hole_that_is_not_at_the_origin_as_into_one_that_is(
    hole: Engine,
) -> None:
    """The wire around it takes the ball over from the green, and the green from the wire."""
    golf = hoopgen.compile(hoopgen.load_scene(ROOT / "examples" / "scenes" / "golf.toml"))
    count = trials(200, 150)
    chance = np.random.default_rng(3)
    states = np.zeros((count, 9))
    states[:, 0], states[:, 1] = chance.uniform(-0.5, -0.1, count), chance.normal(0, 0.03, count)
    states[:, 2], states[:, 3] = 0.02135, chance.uniform(0.1, 1.2, count)
    states[:, 7] = states[:, 3] / 0.02135
    moved = states + np.concatenate([[0.3, -0.2], np.zeros(7)])
    given: dict[str, Any] = {"time_limit": 2, "leaving": "green", "fields": CLAIMS}
    first = golf.simulate(states, **given)
    other = hole.simulate(moved, {"there_x": 0.3, "there_y": -0.2}, **given)
    agree(other, first, 0.8, *[np.eye(3)] * 3, origin=(0.3, -0.2, 0.0))
    sure = ~(first.uncertain | other.uncertain)
    holed = [
        shots.outcome == engine.outcomes["HOLED"]
        for engine, shots in ((golf, first), (hole, other))
    ]
    assert np.array_equal(*(own[sure] for own in holed))
    assert np.count_nonzero(other.rolls[sure] > 2) > count / 10
    assert not np.any(other.outcome == hole.outcomes["CAPPED"])


# The bounds

NARROW = {"centre": (0.1, 0.2, 0.3), "axis": (-1.0, 0.4, 0.2), "radius": 0.35, "wire": 0.28}
"""A torus with so narrow a hole that its curvature is largest there."""


def kernels_of_narrow() -> Any:
    """Return the kernels of a scene with that torus."""
    body = Torus("narrow", **NARROW)
    scene = Scene(
        "narrow", bodies=[body], ball_radius=BALL, gravity=GRAVITY, restitution=0.3, rolls=True
    )
    return DerivedKernels(build(scene.derive()))


def evaluate(kernels: Any, name: str, known: Mapping[str, Any]) -> dict[str, Any]:
    """Return the results of a kernel, with the default parameters of the scene."""
    given = {kernels.VARIABLES[p]: default for p, (default, *_) in kernels.PARAMETERS.items()}
    given |= known
    values = [given[argument] for argument in kernels.ARGUMENTS[name]]
    return dict(zip(kernels.OUTPUTS[name], getattr(kernels, name)(*values), strict=True))


def around_tube(count: int, seed: int) -> Floats:
    """Return states on that torus, all around the wire."""
    chance = np.random.default_rng(seed)
    azimuth, angle = chance.uniform(0, 2 * np.pi, (2, count))
    climb, along = chance.normal(0, 1, (2, count))
    return on_tube(NARROW, azimuth, angle, climb, along, np.zeros(count))


def normals(places: Floats) -> Floats:
    """Return the normals of that torus nearest to places."""
    unit = frame(NARROW)[0]
    ways = places - NARROW["centre"]
    across = ways - np.outer(ways @ unit, unit)
    from_wire = ways - NARROW["radius"] * across / np.linalg.norm(across, axis=1)[:, None]
    return np.asarray(from_wire / np.linalg.norm(from_wire, axis=1)[:, None])


def test_the_normal_of_a_torus_turns_no_faster_than_its_bound_says() -> None:
    """Along a path on the torus |n'| <= k |v| and |n''| <= k |a| + 2 k² |v|²."""
    kernels = kernels_of_narrow()
    states = around_tube(trials(4000, 1000), 1)
    known = dict(zip(kernels.STATE, states.T, strict=True))
    bound = evaluate(kernels, "narrow_rolling_surface", known)["per_reach"]
    place = states[:, :3]
    step = 1e-4 / (1 + bound * np.linalg.norm(states[:, 3:6], axis=1))
    ahead, behind = (place + side * step[:, None] * states[:, 3:6] for side in (1, -1))
    ahead, behind = (own - away(NARROW, own)[:, None] * normals(own) for own in (ahead, behind))
    swift = np.linalg.norm(ahead - behind, axis=1) / (2 * step)
    pull = np.linalg.norm(ahead - 2 * place + behind, axis=1) / step**2
    turns = np.linalg.norm(normals(ahead) - normals(behind), axis=1) / (2 * step)
    bends = np.linalg.norm(normals(ahead) - 2 * normals(place) + normals(behind), axis=1) / step**2
    assert np.all(turns <= bound * swift * (1 + 1e-6))
    assert np.all(bends <= (bound * pull + 2 * bound**2 * swift**2) * (1 + 1e-3))
    assert np.max(turns / (bound * swift)) > 0.8


def test_a_ball_that_leaves_a_torus_is_off_it_for_as_long_as_is_claimed() -> None:
    """At such a speed that the normal force vanishes, where its rate opens the gap."""
    kernels = kernels_of_narrow()
    states = around_tube(trials(4000, 1000), 2)

    def separation(states: Floats) -> dict[str, Any]:
        known = dict(zip(kernels.STATE, states.T, strict=True))
        return evaluate(kernels, "narrow_separation", known)

    still = states * np.concatenate([np.ones(3), np.zeros(6)])
    weight = separation(still)["lift"]
    share = -weight / (separation(states)["lift"] - weight)
    states = states[share > 0]
    states[:, 3:] *= np.sqrt(share[share > 0])[:, None]
    found = separation(states)
    assert np.max(np.abs(found["lift"])) < 1e-9
    known = dict(zip(kernels.STATE, states.T, strict=True)) | found | {"lift": 0.0 * found["lift"]}
    known |= evaluate(kernels, "narrow_rolling_surface", known)
    known |= {"free_time": np.inf, "time_limit": 60.0, "clock": 0.0, "position_error": 0.0}
    known |= {"velocity_error": 0.0, "undecided_time": np.inf}
    claim = evaluate(kernels, "separated", known)
    opens = claim["undecided_time"] > 0
    assert np.count_nonzero(opens) > len(states) / 4
    for part in (0.1, 0.4, 0.7, 1.0):
        time = part * claim["when"][opens, None]
        places = states[opens, :3] + states[opens, 3:6] * time + FALL * time**2 / 2
        gaps = away(NARROW, places)
        rounding = 1e-15 + 1e-12 * time[:, 0] ** 2
        expected = found["gap_jerk"][opens] * time[:, 0] ** 3 / 6
        assert np.all(gaps > expected / 2 - rounding)
    assert np.median(expected / rounding) > 10
