"""Scenes of one's own in which a ball rolls on when its bounces have become small."""

import math
import re
import threading
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

import hoopgen
from hoopgen import Event
from hoopgen.codegen.render import render_scene
from hoopgen.engine import numpy_flights
from hoopgen.scene import End, Parameter, Plane, Scene, SceneError, Sphere, Torus
from hoopgen.scene.trial_shots import SHOTS, trial_shots
from hoopgen.simulation.engine import Engine
from tests.helpers import ROOT

pytestmark = [
    pytest.mark.slow,
    pytest.mark.xdist_group("rolling_scenes"),
]  # the bowl is compiled once

BOWL = ROOT / "examples" / "scenes" / "bowl.toml"
ACROSS = 1.0 - 0.05
"""Distance between the centres of the bowl and of a ball that touches it, m."""
GRAVITY = 9.81
BACKENDS: tuple[Any, ...] = ("c", "numpy")


@pytest.fixture(scope="module")
def bowl() -> Engine:
    return hoopgen.compile(hoopgen.load_scene(BOWL))


def _thrown(count: int) -> NDArray[np.float64]:
    random = np.random.default_rng(11)
    states = np.zeros((count, 9))
    states[:, :3] = random.uniform(-0.4, 0.4, (count, 3))
    states[:, 3:6] = random.normal(0, 1, (count, 3))
    states[:, 6:] = random.normal(0, 5, (count, 3))
    return states


def _energy(state: NDArray[np.float64]) -> float:
    """(5/6) v² + s²/3 + g z of a ball that rolls, s its radius times its spin about the normal."""
    normal = -state[:3] / ACROSS
    turn = 0.05 * (state[6:] @ normal)
    return float(5 / 6 * (state[3:6] @ state[3:6]) + turn**2 / 3 + GRAVITY * state[2])


def test_a_ball_in_a_bowl_rolls_until_its_time_is_up(bowl: Engine) -> None:
    shots = bowl.simulate(_thrown(40), time_limit=20, record=True)
    assert set(shots.outcome) == {bowl.outcomes["ENDLESS"]}
    events = shots.events
    begun = events[events["kind"] == Event.ROLL]
    assert np.array_equal(np.unique(begun["shot"]), np.arange(40))
    final = {int(row["shot"]): row["after"] for row in begun}
    for shot, start in final.items():
        state = shots.state[shot]
        assert np.linalg.norm(state[:3]) == pytest.approx(ACROSS, abs=1e-14)
        assert _energy(state) == pytest.approx(_energy(start), rel=1e-12)


@pytest.mark.slow
def test_trial_shots_that_roll_for_ever_take_few_turns(
    bowl: Engine, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A scene of them, such as this one without restitution, compiles in seconds."""
    _, *said = bowl.kernels.PARAMETERS["restitution"]
    monkeypatch.setitem(bowl.kernels.PARAMETERS, "restitution", (0.0, *said))
    advance, turns = numpy_flights.Flights.advance, 0

    def counted(self: numpy_flights.Flights, *given: Any) -> None:
        nonlocal turns
        turns += 1
        assert turns < 500, "a trial shot rolls on and on"
        advance(self, *given)

    monkeypatch.setattr(numpy_flights.Flights, "advance", counted)
    assert trial_shots(bowl.kernels).shape == (SHOTS, 9)


def test_both_engines_roll_the_same(bowl: Engine) -> None:
    fields = ("outcome", "contacts", "time", "state", "uncertain", "state_error")
    made = [
        bowl.simulate(_thrown(6), time_limit=8, fields=fields, backend=backend)
        for backend in ("c", "numpy")
    ]
    for field in fields:
        assert getattr(made[0], field).tobytes() == getattr(made[1], field).tobytes()


def test_without_spin_about_the_normal_it_is_a_pendulum(bowl: Engine) -> None:
    """(1 + kappa) across theta'' = -g sin theta in a plane, with kappa = 2/3."""
    angle, last = 0.9, 3.0
    start = np.zeros(9)
    start[0], start[2] = ACROSS * math.sin(angle), -ACROSS * math.cos(angle)
    start[:3] *= 1 - 1e-12  # a picometre off the wall
    (end,) = bowl.simulate(start, time_limit=last).state

    def pendulum(_: float, theta: NDArray[np.float64]) -> list[float]:
        return [theta[1], -0.6 * GRAVITY / ACROSS * math.sin(theta[0])]

    swung = solve_ivp(pendulum, (0, last), [angle, 0.0], method="DOP853", rtol=1e-12, atol=1e-12).y[
        :, -1
    ]
    assert math.atan2(end[0], -end[2]) == pytest.approx(swung[0], abs=1e-8)
    assert end[4] == end[1] == 0


@pytest.mark.slow
def test_without_rolls_it_bounces_until_it_is_given_up() -> None:
    balls = Scene(
        "bouncing",
        bodies=[Sphere("bowl", radius=1.0, inside=True)],
        ball_radius=0.05,
        gravity=GRAVITY,
        restitution=0.5,
    )
    engine = hoopgen.compile(balls)
    assert not engine.rolls
    shots = engine.simulate(np.array([0.2, 0, 0, 0, 0, 0, 0, 0, 0.0]), max_contacts=60)
    assert shots.outcome[0] == engine.outcomes["CAPPED"]


def test_what_cannot_roll_is_refused(bowl: Engine) -> None:
    floor = Plane("floor", axis="z", at=0.0, within=["x**3"])
    half = Parameter("half", 0.5)
    with pytest.raises(SceneError, match=r"body floor: within 1: .* rolls"):
        Scene(
            "table",
            parameters=[half],
            bodies=[floor],
            ball_radius=0.05,
            gravity=GRAVITY,
            restitution="half",
            rolls=True,
        )
    with pytest.raises(SceneError, match="rolls: expected true or false, got 'yes'"):
        Scene(
            "table",
            bodies=[Plane("floor", axis="z", at=0.0)],
            ball_radius=0.05,
            gravity=GRAVITY,
            restitution=0.5,
            rolls="yes",  # type: ignore[arg-type]
        )
    with pytest.raises(ValueError, match="time_limit: expected a finite time"):
        bowl.simulate(np.zeros(9), time_limit=math.inf)


@pytest.mark.sampled(2)
@pytest.mark.parametrize("backend", ["c", "numpy"])
@pytest.mark.parametrize("restitution", [0.0, 0.3, 0.5])
def test_no_bounce_is_too_small_for_a_plane(restitution: float, backend: str) -> None:
    """The square of a speed is less than the least number long before the speed is."""
    floor = Scene(
        "floor_and_end",
        parameters=[Parameter("restitution", 0.5, unit="1")],
        bodies=[Plane("floor", axis="z", at=0.0)],
        ends={"below": End(at=-1.0)},
        ball_radius=0.05,
        gravity=GRAVITY,
        restitution="restitution",
    )
    engine = hoopgen.compile(floor)
    if backend == "c" and engine.backend != "c":
        pytest.skip("there is no C compiler")
    start = np.array([0, 0, 0.5, 0.1, 0, 0, 0, 0, 0])
    sizes = {"restitution": restitution}
    shots = engine.simulate(start, sizes, backend=backend)
    assert shots.outcome[0] == engine.outcomes["CAPPED"]
    assert shots.contacts[0] == 1000
    assert shots.state[0, 2] == 0.05


@pytest.mark.slow
@pytest.mark.parametrize(("down", "up"), [("-z", 1), ("z", -1)])
def test_on_a_ring_it_rolls_whether_gravity_points_down_its_axis_or_up(down: str, up: int) -> None:
    """Down the axis the series has the ring's own coordinates, elsewhere those of the scene."""
    hoop = Scene(
        "hoop_alone",
        bodies=[Torus("hoop", radius=0.23, wire=0.01)],
        ends={"below": End(at=-0.5, axis="z" if up > 0 else "-z")},
        ball_radius=0.12,
        gravity=GRAVITY,
        down=down,
        restitution=0.3,
        rolls=True,
    )
    engine = hoopgen.compile(hoop)
    states = np.zeros((60, 9))
    random = np.random.default_rng(5)
    states[:, 0], states[:, 1] = random.uniform(0.1, 0.3, 60), random.normal(0, 0.02, 60)
    states[:, 2], states[:, 3:5] = 0.5 * up, random.normal(0, 0.3, (60, 2))
    made = [engine.simulate(states, time_limit=5, backend=b, record=True) for b in BACKENDS]
    assert made[0].state.tobytes() == made[-1].state.tobytes()
    assert np.count_nonzero(made[0].events["kind"] == Event.ROLL) > 3
    assert not np.any(made[0].outcome == engine.outcomes["CAPPED"])


@pytest.mark.slow
@pytest.mark.parametrize("axis", ["x", "z", "-y"])
def test_on_a_plane_alone_it_rolls_as_well(axis: str) -> None:
    """Its normal is the same everywhere: it is not asked where the flight to a contact began."""
    scene = Scene(
        "plain",
        parameters=[Parameter("ball", 0.05)],
        ball_radius="ball",
        gravity=9.81,
        restitution=0.5,
        friction=0.4,
        bodies=[Plane("floor", axis=axis, at=0)],
        ends={},
        rolls=True,
    )
    assert "left_n" in render_scene(scene.derive(), page=False, targets=["c"])["c/plain_loop.h"]


def test_a_thread_needs_little_stack_for_scenes_in_which_balls_roll() -> None:
    """macOS gives one 512 KB: the shots in flight are not on it."""
    states = np.repeat(hoopgen.release(7.2, 0.9, height=2.1, distance=4.2)[None], 100, axis=0)
    expected = hoopgen.simulate(states, scene=hoopgen.COURT, threads=1)
    found: list[hoopgen.Shots] = []

    def work() -> None:
        found.append(hoopgen.simulate(states, scene=hoopgen.COURT, threads=1))

    before = threading.stack_size(1 << 19)
    try:
        thread = threading.Thread(target=work)
        thread.start()
        thread.join()
    finally:
        threading.stack_size(before)
    np.testing.assert_array_equal(found[0].state, expected.state)


@pytest.mark.slow
def test_a_table_in_groups_has_room_for_those_that_wait_to_roll_on() -> None:
    """Their rows are behind those of the others: passes go over twice as many."""
    posts = [Sphere(f"post_{k}", radius="size", centre=(f"{k}*size", 0.0, 0.0)) for k in range(20)]
    bowl = Sphere("bowl", radius="30*size", inside=True)
    scene = Scene(
        "posts",
        parameters=[Parameter("ball", 0.05), Parameter("size", 0.1)],
        ball_radius="ball",
        gravity=9.81,
        restitution=0.5,
        friction=0.4,
        bodies=[bowl, *posts],
        ends={"down": End(at=-5)},
        rolls=True,
    )
    files = render_scene(scene.derive(), page=False)
    sizes = re.findall(r"size_t _g\d+_blocks\[\d+\]\[(.*?)\]", files["c/posts_loop.h"])
    assert set(sizes) == {"LANES_ROWS / LANES_WIDTH"}
    assert "#define LANES_ROWS (2 * LANES_SHOTS)" in files["c/posts.c"]
