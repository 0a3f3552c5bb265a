"""A shelf on which balls roll, with what they do there in closed form or as an integral.

The shelf is a box with its top at z = 0, before a wall. A ball rolls against the wall, over the
shelf's edge, across an end plane, into the corner; it bounces ever lower, and it slides.
"""

from __future__ import annotations

import math
from typing import Any

import mpmath
import numpy as np
import pytest
from numpy.typing import NDArray

import hoopgen
from hoopgen import Event
from hoopgen.scene import Box, End, Parameter, Plane, Scene
from hoopgen.simulation.engine import Engine
from tests.helpers.effort import trials
from tests.scene.test_example_scenes import numpy_engine

pytestmark = [pytest.mark.slow, pytest.mark.xdist_group("shelf")]

GRAVITY, BALL = 9.81, 0.05
EDGE, WALL, SIDE, DOWN = 0.5, -0.4, 0.35, -1.0
"""Places of the shelf's end, of the wall, and of the planes at the side and below, m."""

SHELF = Scene(
    "shelf",
    parameters=[
        Parameter("ball", BALL),
        Parameter("e", 0.5, "1"),
        Parameter("mu", math.inf, "1", infinite=True),
    ],
    bodies=[
        Box("shelf", size=(2 * EDGE, 1.0, 0.3), centre=(0, 0, -0.15)),
        Plane("wall", axis="x", at=WALL),
    ],
    ends={"side": End(axis="-y", at=-SIDE), "down": End(at=DOWN)},
    ball_radius="ball",
    gravity=GRAVITY,
    restitution="e",
    friction="mu",
    rolls=True,
)
BOX, PLANE = 0, 1
ALL = ("outcome", "contacts", "time", "state", "uncertain", "time_error", "state_error")
"""Results that are asked for, with bounds on their errors."""

DEAD = {"e": 0.0}
"""Without restitution a ball that is put onto the shelf rolls at once."""


@pytest.fixture(scope="module")
def shelf(tmp_path_factory: pytest.TempPathFactory) -> Engine:
    return numpy_engine(SHELF, tmp_path_factory.mktemp("shelf"))


def rolling(x: float, y: float, vx: float = 0.0, vy: float = 0.0) -> NDArray[np.float64]:
    """Return a ball that comes down on the shelf from a nanometre, and grips without slip."""
    return np.array([x, y, BALL + 1e-9, vx, vy, 0.0, -vy / BALL, vx / BALL, 0.0])


def simulated(shelf: Engine, state: Any, given: dict[str, float], **options: Any) -> hoopgen.Shots:
    wanted = (*ALL, "slip_left", "grip_lost")
    return shelf.simulate(state, given, record=True, fields=wanted, **options)


def kinds(shots: hoopgen.Shots) -> list[tuple[Event, int]]:
    return [(Event(int(e["kind"])), int(e["surface"])) for e in shots.events]


def within_claims(shots: hoopgen.Shots, time: float, state: Any) -> None:
    """Check the end against what is known of it: the claims hold, and are no thousandfold."""
    assert not shots.uncertain[0]
    late = abs(shots.time[0] - time)
    away = np.abs(shots.state[0] - state).reshape(3, 3).max(axis=1)
    # What is known is known to some roundings.
    known = 1e-15 * (1 + np.abs(np.reshape(state, (3, 3))).max(axis=1))
    assert late <= shots.time_error[0] + 1e-15
    assert np.all(away <= shots.state_error[0] + known)
    # Rolling begins half a picometre off at most; claims are 64 times that, and what it grows to.
    assert shots.time_error[0] < 2e-8
    assert np.all(shots.state_error[0] < [2e-8, 1e-7, 1e-6])


def dropped(count: int) -> NDArray[np.float64]:
    """Return balls that fall onto the shelf, with any spin."""
    random = np.random.default_rng(8)
    states = np.zeros((count, 9))
    states[:, 0], states[:, 1] = random.uniform(-0.2, 0.3, count), random.uniform(-0.2, 0.2, count)
    states[:, 2] = random.uniform(0.1, 0.4, count)
    states[:, 3:5] = random.normal(0, 0.2, (count, 2))
    states[:, 6:] = random.normal(0, 5, (count, 3))
    return states


def test_errors_hardly_grow_on_a_face(shelf: Engine) -> None:
    """Balls bounce ever lower and roll; on a face no error of their place turns the normal."""
    shots = shelf.simulate(dropped(trials(400, 100)), {}, fields=(*ALL, "rolls"), time_limit=3)
    assert (shots.rolls > 0).mean() > 0.9
    assert shots.uncertain.mean() < 0.25
    assert np.all(np.median(shots.state_error, axis=0) < [5e-9, 5e-8, 5e-8])


FALL = math.sqrt(2 * 1e-9 / GRAVITY)
"""Time that a ball falls before it rolls, s."""


def test_a_ball_rolls_against_the_wall(shelf: Engine) -> None:
    """The ball keeps its speed until the wall, and bounces off there."""
    speed = 0.4
    shots = simulated(shelf, rolling(0.1, 0.0, -speed), DEAD, time_limit=2.0)
    assert kinds(shots)[:3] == [(Event.IMPACT, BOX), (Event.ROLL, BOX), (Event.IMPACT, PLANE)]
    assert kinds(shots)[3] == (Event.LEAVE, BOX) or kinds(shots)[3][0] == Event.IMPACT
    hit = shots.events[2]
    assert hit["time"] == pytest.approx((0.1 - WALL - BALL) / speed, rel=1e-9)
    assert hit["before"][:6] == pytest.approx([WALL + BALL, 0, BALL, -speed, 0, 0], abs=1e-14)
    assert not shots.uncertain[0] or shots.events["time"][-1] > hit["time"]


def test_a_ball_rolls_across_an_end_plane(shelf: Engine) -> None:
    speed = 0.7
    shots = simulated(shelf, rolling(0.1, -0.3, 0.0, speed), DEAD)
    assert shelf.outcomes(int(shots.outcome[0])).name == "SIDE"
    assert [kind for kind, _ in kinds(shots)] == [Event.IMPACT, Event.ROLL, Event.END]
    time = (SIDE + 0.3) / speed
    within_claims(shots, time, [0.1, SIDE, BALL, 0, speed, 0, -speed / BALL, 0, 0])


def test_beyond_an_end_plane_a_roll_goes_on(shelf: Engine) -> None:
    """A ball crosses an end plane only from its front."""
    limit, speed = 0.05, 1.0
    shots = simulated(shelf, rolling(0.1, 0.4, 0.0, speed), DEAD, time_limit=limit)
    assert shots.outcome[0] == shelf.outcomes["ENDLESS"]
    there = [0.1, 0.4 + speed * limit, BALL, 0, speed, 0, -speed / BALL, 0, 0]
    within_claims(shots, limit, there)


@pytest.mark.parametrize(
    ("start", "uncertain"),
    [((0.1, 0.4, 0.0, 1.0), False), ((0.4, 0.4, 1.0, 0.0), False), ((0.4, SIDE, 1.0, 0.0), True)],
)
def test_behind_an_end_plane_a_ball_leaves_the_edge_once(
    shelf: Engine, start: tuple[float, ...], uncertain: bool
) -> None:
    """The ball departs behind the plane, or undecided within it, and falls."""
    shots = simulated(shelf, rolling(*start), DEAD)
    assert shelf.outcomes(int(shots.outcome[0])).name == "DOWN"
    assert [kind for kind, _ in kinds(shots)] == [Event.IMPACT, Event.ROLL, Event.LEAVE, Event.END]
    fall = math.sqrt(2 * GRAVITY * (BALL - DOWN)) / GRAVITY
    assert shots.time[0] == pytest.approx(0.1 + fall, rel=0, abs=1e-7)
    assert bool(shots.uncertain[0]) is uncertain


def test_errors_grow_with_the_way_that_a_ball_rolls(shelf: Engine) -> None:
    """The velocity is off by what the bounces leave; the place then by that times the time."""
    begun, later = (
        simulated(shelf, rolling(0.1, -0.3, 0.0, 0.1), DEAD, time_limit=limit)
        for limit in (1e-3, 4.0)
    )
    grown = (later.state_error[0][0] - begun.state_error[0][0]) / 64 / (4.0 - 1e-3)
    # The jump to the end of the bounces changes the velocity by 4 (1 + v/R_B) tolerances a second.
    tolerance = BALL / 2**38
    assert 6 * tolerance < grown < 24 * tolerance


def test_a_roll_ends_at_the_time_limit(shelf: Engine) -> None:
    speed, limit = 0.1, 1.5
    shots = simulated(shelf, rolling(0.1, -0.3, 0.0, speed), DEAD, time_limit=limit)
    assert shots.outcome[0] == shelf.outcomes["ENDLESS"]
    there = [0.1, -0.3 + speed * limit, BALL, 0, speed, 0, -speed / BALL, 0, 0]
    within_claims(shots, limit, there)
    assert shots.time[0] == limit


def test_a_ball_rests_where_it_is_put(shelf: Engine) -> None:
    shots = simulated(shelf, rolling(0.1, 0.1), DEAD)
    assert shots.outcome[0] == shelf.outcomes["LODGED"]
    assert kinds(shots) == [(Event.IMPACT, BOX), (Event.ROLL, BOX)]
    within_claims(shots, FALL, [0.1, 0.1, BALL, 0, 0, 0, 0, 0, 0])


# -- Over the edge: the centre goes round it at the ball's radius


def over_the_edge(speed: float, friction: float = math.inf) -> tuple[Any, Any, Any]:
    """Return how far the ball has turned where it leaves, and slips; and after what time.

    With energy (5/6) v² + g R cos a; N = g cos a - v²/R, F = (2/5) g sin a.
    """
    r, g = mpmath.mpf(BALL), mpmath.mpf(GRAVITY)

    def squared(a: Any) -> Any:
        return mpmath.mpf(speed) ** 2 + mpmath.mpf(6) / 5 * g * r * (1 - mpmath.cos(a))

    def time(a: Any) -> Any:
        return mpmath.quad(lambda b: r / mpmath.sqrt(squared(b)), mpmath.linspace(0, a, 9))

    leaves = mpmath.acos(mpmath.mpf(6) / 11 * (1 + 5 * mpmath.mpf(speed) ** 2 / (6 * g * r)))
    if friction == math.inf:
        return leaves, time(leaves), None
    slips = mpmath.findroot(
        lambda a: 0.4 * g * mpmath.sin(a) - friction * (g * mpmath.cos(a) - squared(a) / r),
        (0.0, leaves),
        solver="anderson",
        tol=1e-20,
    )
    return leaves, time(leaves), time(slips)


@pytest.mark.parametrize("speed", [0.1, 0.3, 0.6])
def test_a_ball_rolls_over_the_edge_and_leaves_it(shelf: Engine, speed: float) -> None:
    shots = simulated(shelf, rolling(0.4, 0.2, speed), DEAD)
    angle, lasting, _ = over_the_edge(speed)
    assert shelf.outcomes(int(shots.outcome[0])).name == "DOWN"
    expected = [(Event.IMPACT, BOX), (Event.ROLL, BOX), (Event.LEAVE, BOX), (Event.END, 2)]
    assert kinds(shots) == expected
    leaves = shots.events[2]
    assert leaves["time"] == pytest.approx(
        float(0.1 / mpmath.mpf(speed) + lasting), rel=0, abs=1e-9
    )
    fast = math.sqrt(GRAVITY * BALL * math.cos(angle))
    sine, cosine = float(mpmath.sin(angle)), float(mpmath.cos(angle))
    place = [EDGE + BALL * sine, 0.2, BALL * cosine]
    assert leaves["before"][:3] == pytest.approx(place, rel=0, abs=1e-10)
    moving = [fast * cosine, 0, -fast * sine]
    assert leaves["before"][3:6] == pytest.approx(moving, rel=0, abs=1e-9)
    assert leaves["before"][6:] == pytest.approx([0, fast / BALL, 0], rel=0, abs=1e-7)
    # From there it falls freely.
    drop = place[2] - DOWN
    time = (moving[2] + math.sqrt(moving[2] ** 2 + 2 * GRAVITY * drop)) / GRAVITY
    there = [place[0] + moving[0] * time, 0.2, DOWN, moving[0], 0, moving[2] - GRAVITY * time]
    over = float(0.1 / mpmath.mpf(speed) + lasting) + time
    within_claims(shots, over, [*there, 0, fast / BALL, 0])


@pytest.mark.parametrize("speed", [0.71, 1.0, 3.0])
def test_a_fast_ball_is_thrown_off_at_the_edge(shelf: Engine, speed: float) -> None:
    """Balls faster than v² = g R leave at the seam between top and edge."""
    assert speed**2 > GRAVITY * BALL
    shots = simulated(shelf, rolling(0.4, 0.2, speed), DEAD)
    assert [kind for kind, _ in kinds(shots)] == [Event.IMPACT, Event.ROLL, Event.LEAVE, Event.END]
    time, fall = 0.1 / speed, math.sqrt(2 * GRAVITY * (BALL - DOWN))
    assert shots.events["time"][2] == pytest.approx(time, rel=0, abs=1e-9)
    there = [EDGE + speed * fall / GRAVITY, 0.2, DOWN, speed, 0, -fall, 0, speed / BALL, 0]
    within_claims(shots, time + fall / GRAVITY, there)


@pytest.mark.parametrize(("speed", "friction"), [(0.1, 0.1), (0.3, 0.3), (0.2, 1.0)])
def test_when_friction_no_longer_suffices(shelf: Engine, speed: float, friction: float) -> None:
    """The limit is found by a cubic over a step."""
    given = DEAD | {"mu": friction}
    shots = simulated(shelf, rolling(0.4, 0.2, speed), given)
    *_, slips = over_the_edge(speed, friction)
    assert shots.grip_lost[0] == pytest.approx(0.1 / speed + float(slips), rel=0, abs=1e-5)
    assert math.isinf(simulated(shelf, rolling(0.4, 0.2, speed), DEAD).grip_lost[0])


# -- Bounces that accumulate


@pytest.mark.parametrize("restitution", [0.2, 0.5, 0.8])
def test_bounces_end_when_their_sum_says(shelf: Engine, restitution: float) -> None:
    """The last ones are left out, which are less than a picosecond's fall away."""
    height = 0.3
    state = [0.1, 0.1, BALL + height, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    shots = simulated(shelf, state, {"e": restitution})
    assert shots.outcome[0] == shelf.outcomes["LODGED"]
    assert not shots.uncertain[0]
    log = shots.events
    assert [k for k, _ in kinds(shots)] == [Event.IMPACT] * (len(log) - 1) + [Event.ROLL]
    fall = math.sqrt(2 * height / GRAVITY)
    bounces = np.arange(len(log) - 1)
    times = fall * (1 + 2 * restitution * (1 - restitution**bounces) / (1 - restitution))
    assert log["time"][:-1] == pytest.approx(times, rel=1e-12)
    # The bounce at which it settles has a hop of half the tolerance at most, the one before more.
    hops = (GRAVITY * fall * restitution ** (bounces + 1)) ** 2 / (2 * GRAVITY)
    tolerance = BALL / 2**38
    assert hops[-1] <= tolerance < 4 * hops[-2]


@pytest.mark.parametrize("slip", [0.0, 0.3])
def test_what_the_bounces_leave_out_is_less_than_the_tolerance(shelf: Engine, slip: float) -> None:
    """A ball rolls from where all its bounces would have brought it, to within the tolerance."""
    height, speed, e = 0.02, 0.05, 0.5
    state = [0.1, -0.3, BALL + height, 0.0, speed, 0.0, (slip - speed) / BALL, 0.0, 0.0]
    shots = simulated(shelf, state, {"e": e}, time_limit=2.0)
    assert shots.outcome[0] == shelf.outcomes["ENDLESS"]
    # The first contact stops all slip: v is what momentum leaves, from then on.
    fall = math.sqrt(2 * height / GRAVITY)
    after = speed - 0.4 * slip
    there = -0.3 + speed * fall + after * (2.0 - fall)
    within_claims(shots, 2.0, [0.1, there, BALL, 0, after, 0, -after / BALL, 0, 0])


def test_a_ball_that_slips_through_its_bounces_slides(shelf: Engine) -> None:
    """All bounces together take mu times their impulses, in speed 5/2 of that."""
    height, mu, e, speed = 0.02, 0.05, 0.5, 1.0
    state = [0.1, -0.3, BALL + height, 0.0, 0.0, 0.0, speed / BALL, 0.0, 0.0]
    shots = simulated(shelf, state, {"e": e, "mu": mu})
    assert shots.outcome[0] == shelf.outcomes["CAPPED"]
    assert shots.slip_left[0]
    assert not shots.uncertain[0]
    down = math.sqrt(2 * GRAVITY * height)
    left = speed - 5 / 2 * mu * down * (1 + e) * (1 - e ** shots.contacts[0]) / (1 - e)
    state = shots.state[0]
    assert state[4] + BALL * state[6] == pytest.approx(left, rel=1e-9)
    # It ends as soon as the hop is lower than half the tolerance: no other contact comes.
    hop = (down * e ** shots.contacts[0]) ** 2 / (2 * GRAVITY)
    assert hop <= BALL / 2**38 < hop / e**4


def test_a_slip_that_bounces_can_stop_ends_in_a_roll(shelf: Engine) -> None:
    """Slip is left after each contact but the last ones, and all of it is taken in time."""
    height, mu, e = 0.02, 0.05, 0.5
    down = math.sqrt(2 * GRAVITY * height)
    whole = 5 / 2 * mu * down * (1 + e) / (1 - e)
    for share, outcome in ((0.98, "SIDE"), (1.0 - 1e-7, "SIDE"), (1.0 + 1e-3, "CAPPED")):
        slip = share * whole
        state = [0.1, -0.3, BALL + height, 0.0, 0.0, 0.0, slip / BALL, 0.0, 0.0]
        shots = simulated(shelf, state, {"e": e, "mu": mu})
        # Two fifths of the slip are what friction has taken from the ball's velocity.
        assert shelf.outcomes(int(shots.outcome[0])).name in (outcome, "DOWN"), share
        assert bool(shots.slip_left[0]) is (outcome == "CAPPED")


def test_in_the_corner_a_ball_is_wedged(shelf: Engine) -> None:
    """The surface that stops the ball is undecided; a micrometre off the wall it rests."""
    for aside, uncertain, last in ((0.0, True, Event.IMPACT), (1e-6, False, Event.ROLL)):
        state = [WALL + BALL + aside, 0.0, BALL + 0.01, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
        shots = simulated(shelf, state, {"e": 0.3})
        assert shots.outcome[0] == shelf.outcomes["LODGED"]
        assert shots.state[0][:3] == pytest.approx([WALL + BALL + aside, 0, BALL], rel=0, abs=1e-12)
        assert kinds(shots)[-1] == (last, BOX)
        assert bool(shots.uncertain[0]) is uncertain


def test_both_engines_do_the_same() -> None:
    engine = hoopgen.compile(SHELF)
    if engine.backend != "c":
        pytest.skip("there is no C compiler")
    states = [rolling(0.4, 0.2, 0.1), rolling(0.1, 0.0, -0.4), rolling(0.1, -0.3, 0.0, 0.7)]
    one, other = (
        engine.simulate(states, DEAD, record=True, fields=ALL, backend=b) for b in ("c", "numpy")
    )
    for name in ALL:
        assert getattr(one, name).tobytes() == getattr(other, name).tobytes(), name
