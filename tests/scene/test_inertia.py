"""The ball's moment of inertia: impacts and rolls of shells and solid balls, engines and judge."""

import math
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.special import ellipk

import hoopgen
from hoopgen import COURT, Event
from hoopgen.hoop.court import NBA_COURT, PAPER_COURT
from hoopgen.scene import Cylinder, Parameter, Plane, Scene, SceneError, Sphere
from hoopgen.scene.files import parse_scene
from hoopgen.simulation.engine import Engine
from tests.helpers.court_shots import all_kinds
from tests.helpers.effort import exceptions, trials

pytestmark = [
    pytest.mark.xdist_group("inertia"),  # the scene is derived once
]

Floats = NDArray[np.float64]

SHELL, SOLID = 2 / 3, 2 / 5
KAPPAS = (SHELL, SOLID, 1.0, 1 / 64)
EACH_KAPPA = pytest.mark.parametrize("kappa", KAPPAS, ids=("shell", "solid", "hoop", "core"))
GRAVITY, BALL, BOWL, PIPE = 9.81, 0.05, 1.0, 0.3
LENGTH, ACROSS = BOWL - BALL, PIPE - BALL
"""Distances of the ball's centre from the centre of the bowl, and from the axis of the pipe, m."""

WELL = Scene(
    "well",
    parameters=[Parameter("kappa", SOLID, "1"), Parameter("bounce", 0.6, "1")],
    bodies=[
        Sphere("bowl", radius=BOWL, inside=True),
        Cylinder("pipe", radius=PIPE, inside=True, friction=0.4),
    ],
    ball_radius=BALL,
    gravity=GRAVITY,
    inertia="kappa",
    restitution="bounce",
    rolls=True,
)


@pytest.fixture(scope="module")
def well() -> Engine:
    return hoopgen.compile(WELL)


def thrown(count: int) -> Floats:
    """Return balls in the well, above its bottom."""
    random = np.random.default_rng(3)
    states = np.zeros((count, 9))
    states[:, :2] = random.uniform(-0.15, 0.15, (count, 2))
    states[:, 2] = random.uniform(-0.8, -0.3, count)
    states[:, 3:6] = random.normal(0, 0.5, (count, 3))
    states[:, 6:] = random.normal(0, 5, (count, 3))
    return states


# -- Impacts


def normals(places: Floats, surfaces: NDArray[Any], sizes: dict[str, float]) -> Floats:
    """Return the normals of contacts with the ring, and with the front of the board."""
    x, y, z = places.T
    rho = np.hypot(x, y)
    off = np.stack([x - sizes["ring_radius"] * x / rho, y - sizes["ring_radius"] * y / rho, z], 1)
    ring = off / np.linalg.norm(off, axis=1, keepdims=True)
    return np.where((surfaces == 0)[:, None], ring, (1.0, 0.0, 0.0))


@pytest.mark.parametrize("friction", [math.inf, 0.2])
def test_an_impact_keeps_the_angular_momentum_about_the_contact_point(friction: float) -> None:
    """So it does the spin about the normal; without e_t a contact that grips leaves it rolling."""
    count = trials(400)
    kappa = np.repeat(KAPPAS, count)
    states = np.tile(hoopgen.release(7.2, 0.9, height=2.13, distance=4.19), (len(kappa), 1))
    random = np.random.default_rng(5)
    states[:, 3:6] += random.normal(0, 0.15, (len(kappa), 3))
    states[:, 6:] = random.normal(0, 20, (len(kappa), 3))
    sizes: dict[str, Any] = {**PAPER_COURT, "inertia": kappa}
    sizes |= {f"{body}_friction": friction for body in COURT.surfaces}
    log = hoopgen.simulate(states, sizes, scene=COURT, record=True, max_contacts=4).events
    place = log["before"][:, :3]
    front = (log["surface"] == 1) & (place[:, 0] > -PAPER_COURT["board_distance"] + 0.12)
    front &= (np.abs(place[:, 1]) < 0.9) & (place[:, 2] > -0.1) & (place[:, 2] < 0.9)
    log = log[(log["kind"] == Event.IMPACT) & (front | (log["surface"] == 0))]
    assert len(log) > count
    n = normals(log["before"][:, :3], log["surface"], PAPER_COURT)
    own, radius = kappa[log["shot"]][:, None], PAPER_COURT["ball_radius"]
    moved, turned = ((log["after"] - log["before"])[:, part] for part in (slice(3, 6), slice(6, 9)))
    kept = own * radius**2 * turned + radius * np.cross(n, moved)
    size = np.abs(log["before"][:, 3:6]).sum(1) + radius * np.abs(log["before"][:, 6:]).sum(1)
    assert (np.abs(kept).max(1) < 1e-14 * radius * size).all()
    assert (np.abs(np.sum(turned * n, axis=1)) * radius < 1e-14 * size).all()
    after, spin = log["after"][:, 3:6], log["after"][:, 6:]
    across = after - np.sum(after * n, axis=1, keepdims=True) * n
    slip = np.linalg.norm(across - radius * np.cross(spin, n), axis=1)
    if friction == math.inf:
        assert (slip < 1e-13 * size).all()
    else:
        assert 0.1 < np.mean(slip > 1e-3) < 1


# -- Rolls


@pytest.mark.slow
@EACH_KAPPA
def test_a_roll_keeps_its_energy(well: Engine, kappa: float) -> None:
    """(1 + kappa) v²/2 + kappa s²/2 + g z, with s for R_B times the spin about the normal."""
    states = thrown(40)
    shots = well.simulate(states, {"kappa": kappa}, time_limit=6.0, record=True)
    events = shots.events
    begun = {int(row["shot"]): row for row in events[events["kind"] == Event.ROLL]}
    left = set(events["shot"][events["kind"] == Event.LEAVE].tolist())
    checked = 0
    for shot, row in begun.items():
        if shot in left or row["surface"] != 0 or shots.outcome[shot] != well.outcomes["ENDLESS"]:
            continue
        energies = []
        for state in (row["after"], shots.state[shot]):
            normal = -state[:3] / LENGTH
            turn = BALL * (state[6:] @ normal)
            moving = (1 + kappa) * (state[3:6] @ state[3:6]) / 2 + kappa * turn**2 / 2
            energies.append(moving + GRAVITY * state[2])
        assert energies[1] == pytest.approx(energies[0], rel=1e-12)
        checked += 1
    assert checked > 3


@pytest.mark.slow
@EACH_KAPPA
def test_a_ball_in_a_bowl_swings_with_the_period_of_its_pendulum(
    well: Engine, kappa: float
) -> None:
    """T = 4 sqrt((1 + kappa) L/g) K: a solid ball is the faster one."""
    angle = 0.2
    period = 4 * math.sqrt((1 + kappa) * LENGTH / GRAVITY) * float(ellipk(math.sin(angle / 2) ** 2))
    start = np.zeros(9)
    start[0], start[2] = LENGTH * math.sin(angle), -LENGTH * math.cos(angle)
    start[:3] *= 1 - 1e-13
    half, whole = (
        well.simulate(start, {"kappa": kappa, "bounce": 0.0}, time_limit=time).state[0]
        for time in (period / 2, period)
    )
    assert half[0] == pytest.approx(-start[0], abs=1e-10)
    assert whole[0] == pytest.approx(start[0], abs=1e-10)
    assert np.abs(whole[3:6]).max() < 1e-5  # the fall of the first tenth of a picometre


@pytest.mark.slow
@EACH_KAPPA
def test_a_ball_that_rolls_around_in_a_pipe_goes_up_and_down(well: Engine, kappa: float) -> None:
    """v_z'' = -beta Omega² v_z with beta = kappa/(1 + kappa): no ball rolls out at the bottom."""
    rate, spun = 20.0, 0.8
    beta = kappa / (1 + kappa)
    speed = rate * ACROSS
    place, normal = np.array([ACROSS, 0.0, -0.3]), np.array([-1.0, 0.0, 0.0])
    velocity = np.array([0.0, speed, 0.4])
    spin = (np.cross(normal, velocity) + spun * normal) / BALL
    # It arrives with next to no speed, and without restitution it rolls at once.
    nearer = place * np.array([1 - 1e-13, 1, 1])
    time = 0.13
    shots = well.simulate(
        np.concatenate([nearer, velocity, spin]),
        {"kappa": kappa, "bounce": 0.0},
        time_limit=time,
        record=True,
    )
    (begun,) = shots.events[shots.events["kind"] == Event.ROLL]
    start = begun["after"]
    lasts = time - float(begun["time"])
    s = -BALL * (start[6] * start[0] + start[7] * start[1]) / ACROSS
    omega = (start[0] * start[4] - start[1] * start[3]) / ACROSS**2
    swing = math.sqrt(beta) * omega
    pulled = -(1 - beta) * GRAVITY + beta * omega * s
    expected = start[5] * math.cos(swing * lasts) + pulled / swing * math.sin(swing * lasts)
    assert shots.state[0, 5] == pytest.approx(expected, abs=1e-12)
    assert math.hypot(*shots.state[0, :2]) == pytest.approx(ACROSS, abs=1e-15)


@EACH_KAPPA
def test_a_ball_that_rolls_off_the_ring_leaves_it_at_the_angle_of_its_inertia(kappa: float) -> None:
    """From rest, sin a = 2/(3 + kappa) sin a0: sooner than a ball that slides."""
    sizes = {**PAPER_COURT, "ring_restitution": 0.0, "inertia": kappa}
    reach, angle = PAPER_COURT["ball_radius"] + PAPER_COURT["wire_radius"], math.radians(80)
    start = np.zeros(9)
    start[1] = PAPER_COURT["ring_radius"] + reach * math.cos(angle)
    start[2] = reach * math.sin(angle)
    start[2] += 1e-13
    log = hoopgen.simulate(start, sizes, scene=COURT, record=True).events
    (leaves,) = log[log["kind"] == Event.LEAVE]
    assert leaves["after"][2] / reach == pytest.approx(2 / (3 + kappa) * math.sin(angle), rel=1e-11)


# -- Engines and judge


@pytest.mark.slow
def test_engines_agree_for_an_inertia_of_each_shot(well: Engine) -> None:
    count = trials(60)
    states = np.tile(thrown(count), (len(KAPPAS), 1))
    sizes = {"kappa": np.repeat(KAPPAS, count)}
    fields = ("outcome", "contacts", "time", "state", "uncertain", "state_error", "rolls")
    made = [
        well.simulate(states, sizes, time_limit=3.0, fields=fields, backend=backend, record=True)
        for backend in ("c", "numpy")
    ]
    for field in (*fields, "events"):
        assert getattr(made[0], field).tobytes() == getattr(made[1], field).tobytes(), field
    for kappa in KAPPAS:
        own = sizes["kappa"] == kappa
        one = well.simulate(states[own], {"kappa": kappa}, time_limit=3.0, fields=fields)
        assert one.state.tobytes() == made[0].state[own].tobytes()


@pytest.mark.slow
def test_the_judge_knows_the_inertia(well: Engine) -> None:
    """Every certain shot has the sequence that is proved, with its own inertia and no other."""
    count = trials(25)
    states = all_kinds(count, seed=12)
    sizes: dict[str, Any] = {**NBA_COURT, "inertia": np.resize(KAPPAS, len(states))}
    shots = hoopgen.simulate(states, sizes, scene=COURT, max_contacts=12, record=True)
    proof = hoopgen.certify(states, sizes, scene=COURT, max_contacts=12)
    assert proof.agrees(shots).all()
    known = proof.decided & ~shots.uncertain & (shots.outcome != COURT.outcomes["INVALID"])
    assert np.sum(~known) < exceptions(0.5, len(states))
    full = hoopgen.simulate(
        states, sizes, scene=COURT, max_contacts=12, fields=("state", "state_error")
    )
    apart = np.abs(full.state - proof.state).reshape(-1, 3, 3).max(axis=2)
    assert (apart <= full.state_error)[known].all()
    other = hoopgen.certify(states, sizes | {"inertia": SHELL}, scene=COURT, max_contacts=12)
    assert not other.agrees(shots).all()
    own = thrown(trials(40))
    kappa = {"kappa": np.resize(KAPPAS, len(own))}
    certain = well.simulate(own, kappa, time_limit=0.8, record=True)
    assert well.certify(own, kappa, time_limit=0.8).agrees(certain).all()


def test_a_thin_shell_that_is_said_to_be_one_is_the_default() -> None:
    states = all_kinds(trials(60), seed=4)
    fields = ("outcome", "counts", "time", "state", "uncertain", "state_error")
    plain, said = (
        hoopgen.simulate(states, given, scene=COURT, fields=fields)
        for given in (None, {"inertia": 2 / 3})
    )
    for field in fields:
        assert getattr(plain, field).tobytes() == getattr(said, field).tobytes(), field
    assert all(preset["inertia"] == SHELL for preset in (PAPER_COURT, NBA_COURT))
    assert "inertia" not in hoopgen.PAPER


# -- What is allowed


@pytest.mark.parametrize(
    ("given", "said"),
    [
        (0, "expected a number of at least 0.015625 and at most 1, got 0"),
        (-0.4, "expected a number of at least 0.015625 and at most 1, got -0.4"),
        (2, "expected a number of at least 0.015625 and at most 1, got 2"),
        ("3/2", "expected a number of at least 0.015625 and at most 1, got 1.5"),
        (math.nan, "expected a finite number, got nan"),
        (None, "expected a number or a formula, got None"),
        ("solid", "'solid': unknown name 'solid'"),
    ],
)
def test_an_inertia_that_no_ball_has_is_refused(given: Any, said: str) -> None:
    with pytest.raises(SceneError, match=f"scene 'own': inertia: {said}"):
        Scene(
            "own",
            bodies=[Plane("floor")],
            ball_radius=0.05,
            gravity=9.81,
            inertia=given,
            restitution=0.5,
        )


@pytest.mark.slow
@pytest.mark.parametrize("backend", ["c", "numpy"])
def test_a_shot_with_an_inertia_that_no_ball_has_is_invalid(well: Engine, backend: Any) -> None:
    wrong = np.array([SOLID, 0.0, -0.4, -1.0, 2.0, math.nan, math.inf, 1 / 65])
    states = np.tile(thrown(1), (len(wrong), 1))
    shots = well.simulate(states, {"kappa": wrong}, time_limit=1.0, backend=backend)
    invalid = shots.outcome == well.outcomes["INVALID"]
    assert invalid.tolist() == [False] + [True] * (len(wrong) - 1)
    assert np.isnan(shots.state[1:]).all()
    for value in wrong[1:]:
        with pytest.raises(ValueError, match=r"parameters\['kappa'\]: expected 0.015625 to 1, got"):
            well.simulate(states, {"kappa": float(value)}, time_limit=1.0, backend=backend)


def test_a_scene_states_its_inertia_as_a_number_or_a_parameter() -> None:
    plain = Scene("own", bodies=[Plane("floor")], ball_radius=0.05, gravity=9.81, restitution=0.5)
    assert (
        dict(zip((i.name for i in plain.inputs), plain.values(), strict=True))["inertia"] == 2 / 3
    )
    assert "inertia" not in plain.defaults
    text = b"""
name = "own"
ball_radius = 0.05
gravity = 9.81
inertia = "2/5"
restitution = 0.5
[bodies.floor]
kind = "plane"
"""
    found = parse_scene(text)
    assert dict(zip((i.name for i in found.inputs), found.values(), strict=True))["inertia"] == 0.4
    assert found.key != plain.key
    assert WELL.defaults == {"kappa": SOLID, "bounce": 0.6}


FLOOR = Scene(
    "floor",
    parameters=[Parameter("kappa", SOLID, "1")],
    bodies=[Plane("floor")],
    ball_radius=BALL,
    gravity=GRAVITY,
    inertia="kappa",
    restitution=0.5,
)


@pytest.mark.slow
@pytest.mark.parametrize("scene", [FLOOR, pytest.param(WELL, marks=pytest.mark.slow)], ids=str)
def test_the_page_of_a_scene_has_its_inertia(scene: Scene) -> None:
    page = scene.explain()
    assert r"$\kappa\, m_B R_B^2$" in page
    assert (r"\beta = \frac{\kappa}{1 + \kappa}" in page) == (scene is WELL)
