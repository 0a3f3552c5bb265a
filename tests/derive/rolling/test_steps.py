"""A step of a rolling ball: its bounds, the events that shorten it, its errors, and departure.

The kernels are called one by one, as the event loop calls them, and held against the motion itself.
"""

from __future__ import annotations

import math
from typing import Any

import mpmath
import numpy as np
import pytest
from hoopgen.derive.motion import rolling_series
from hoopgen.generated.numpy import court

pytest.importorskip("flint")

from tests.derive.rolling import test_contact_phase
from tests.derive.rolling.test_contact_phase import GRAVITY, NBA, REACH, RING_RADIUS, Rolling

ERRORS = tuple(f"d{name}" for name in ("x", "y", "z", "vx", "vy", "vz", "wx", "wy", "wz"))
STILL: dict[str, Any] = {"position_error": 0.0, "velocity_error": 0.0, "which": -1.0}
STILL |= {"undecided_time": math.inf, "earliest_delay": 0.0, "clock": 0.0, "time_limit": 60.0}
"""A ball without errors, of which no event is known."""


class OnBoard(Rolling):
    """A ball that rolls over the upper front edge of the board, by the kernels alone.

    The angle `a` from upwards and its rate, and the speed along the edge.
    """

    def __init__(self, a: float, turn: float, along: float, s: float) -> None:
        super().__init__(90.0)
        a, ball = math.radians(a), NBA["ball_radius"]
        normal = np.array([math.sin(a), 0.0, math.cos(a)])
        edge = np.array([-NBA["board_distance"], 0.2, NBA["board_top"]])
        velocity = ball * turn * np.array([math.cos(a), 0.0, -math.sin(a)])
        velocity += np.array([0.0, along, 0.0])
        spin = (np.cross(normal, velocity) + s * normal) / ball
        state = np.concatenate([edge + ball * normal, velocity, spin])
        self.values |= dict(zip(("x", "y", "z", "vx", "vy", "vz"), state[:6], strict=True))
        self.values |= dict(zip(("wx", "wy", "wz"), state[6:], strict=True))
        self.values["turn_rate"] = s

    def call(self, name: str) -> None:
        """Evaluate a kernel of this module's."""
        kernel = getattr(court, name)
        given = [self.values[argument] for argument in court.ARGUMENTS[name]]
        self.values |= dict(zip(court.OUTPUTS[name], kernel(*given), strict=True))

    def expand(self) -> None:
        """Take the series at the place where the ball is."""
        for name in ("backboard_normal", "backboard_rolling_surface", "roll_start"):
            self.call(name)
        for order in range(rolling_series.ORDER):
            self.call(f"roll_{order}")
        self.call("roll_step")

    def step(self, most: float) -> None:
        """Move the ball by so much time, or by a step of the series, and onto the surface."""
        self.values["t"] = min(most, self["stride"])
        for name in ("roll_moved", "backboard_normal", "backboard_distance", "roll_placed"):
            self.call(name)
        self.clock += self["t"]

    @property
    def energy(self) -> float:
        """Per unit mass."""
        squared = sum(self[f"v{axis}"] ** 2 for axis in "xyz")
        return 5 / 6 * squared + self["turn_rate"] ** 2 / 3 + GRAVITY * self["z"]


EDGES = ((1.0, 1.0, 0.0, 0.0), (10.0, 2.0, 0.5, 0.3), (40.0, -3.0, -1.0, -0.8))


def balls() -> list[Any]:
    """Return functions that make a ball on the ring, or on the board's edge."""
    made: list[Any] = [lambda a=start: Rolling(*a) for start in test_contact_phase.SWIRLS]
    made += [lambda a=start: OnBoard(*a) for start in EDGES]
    return [*made, lambda: Rolling(150.0, -6.0, 1.5, 0.5, 0.0)]


@pytest.mark.parametrize("kind", range(7))
def test_speed_acceleration_and_force_stay_within_a_step_s_bounds(kind: int) -> None:
    """Taylor's theorem: N is off its tangent by at most half its second derivative's bound."""
    make = balls()[kind]
    ball = make()
    ball.expand()
    step = ball["stride"]
    assert step > 1e-3
    bounds = {name: ball[name] for name in ("fastest", "strongest", "force_bend")}
    force, rate, reached = ball["force"], ball["force_rate"], 0.0
    for k in range(1, 9):
        there, time = make(), step * k / 8
        there.expand()
        there.step(time)
        there.expand()
        assert math.hypot(*(there[f"v{axis}"] for axis in "xyz")) <= bounds["fastest"] + 1e-12
        assert math.hypot(*(there[f"v{axis}_1"] for axis in "xyz")) <= bounds["strongest"] + 1e-9
        off = abs(there["force"] - force - rate * time)
        assert off <= bounds["force_bend"] * time**2 / 2 + 1e-11
        reached = max(reached, 2 * off / (bounds["force_bend"] * time**2))
    assert reached > 1e-3


@pytest.mark.parametrize("start", EDGES)
def test_energy_and_the_distance_from_the_edge_stay(start: tuple[float, ...]) -> None:
    ball = OnBoard(*start)
    before, turned = ball.energy, ball["turn_rate"]
    while ball.clock < 0.05:
        ball.expand()
        ball.step(0.05 - ball.clock)
        across = math.hypot(ball["x"] + NBA["board_distance"], ball["z"] - NBA["board_top"])
        assert across == pytest.approx(NBA["ball_radius"], rel=0, abs=1e-15)
        assert abs(ball.energy - before) < 1e-13
    # On a straight edge the spin about the normal changes with the speed along it.
    assert (turned == 0.0) == (abs(ball["turn_rate"]) < 1e-12)


@pytest.mark.parametrize("start", EDGES)
def test_the_normal_force_is_what_the_edge_presses_with(start: tuple[float, ...]) -> None:
    """N = g cos a - R_B a'², whatever the speed along the edge and the spin about the normal."""
    ball = OnBoard(*start)
    ball.expand()
    angle, turn, *_ = start
    expected = GRAVITY * math.cos(math.radians(angle)) - NBA["ball_radius"] * turn**2
    assert ball["force"] == pytest.approx(expected, rel=1e-14)


@pytest.mark.parametrize("kind", [3, 4])
def test_no_step_passes_the_end_of_the_normal_force(kind: int) -> None:
    """And few are needed to come there."""
    ball, step = balls()[kind](), 0
    while step < 150:
        ball.expand()
        assert ball["force"] > -1e-12
        ball.values |= STILL
        ball.call("leaving_force")
        if ball["which"] >= 0:
            break
        ball.step(math.inf)
        step += 1
    assert ball["which"] == 6.0  # after three surfaces, an end plane, time and beginning
    assert 3 < step < 140
    assert abs(ball["force"]) < 1e-12


TO_THE_BRIDGE = ((100.0, 0.0, 0.6, 0.0, 120.0), (91.0, 0.0, 0.8, 0.1, 130.0))


@pytest.mark.parametrize("start", TO_THE_BRIDGE)
def test_no_step_goes_into_another_body(start: tuple[float, ...]) -> None:
    """A ball rolls along the ring to the bridge."""
    ball, step = Rolling(*start), 0
    while step < 80:
        ball.expand()
        ball.values |= STILL | {"index": 2.0}
        ball.call("bridge_beside")
        assert ball["gap"] > -1e-14
        ball.call("beside_body")
        if ball["which"] >= 0:
            break
        ball.step(math.inf)
        step += 1
    assert ball["which"] == 2.0
    assert 3 < step < 60
    assert ball["stride"] == 0.0
    assert abs(ball["gap"]) < 1e-13
    assert ball["undecided_time"] == math.inf


def test_no_bound_below_the_distance_is_passed_where_a_surface_curves_towards_the_ball() -> None:
    """A ball on the straightest way to the farther wall of a round room of radius 1/c."""
    random = np.random.default_rng(2)
    for _ in range(200):
        radius, speed, push = random.uniform([0.3, 0.1, 0.0], [3.0, 5.0, 20.0])
        gap, toward = radius * random.uniform(0.01, 0.9), speed * random.uniform(-1, 1)
        across = math.sqrt(speed**2 - toward**2)
        given = dict.fromkeys(court.ARGUMENTS["beside_body"], 0.0) | STILL
        given |= {"gap": gap, "nearing": -toward, "gap_curvature": 1 / radius, "index": 1.0}
        # Within the step it goes no faster than it does after it.
        given |= {"stride": 0.05, "strongest": push, "fastest": speed + 0.05 * push}
        given |= {"p_ball_radius": 0.1}
        named = court.ARGUMENTS["beside_body"]
        found = dict(
            zip(
                court.OUTPUTS["beside_body"],
                court.beside_body(*(given[name] for name in named)),
                strict=True,
            )
        )
        t = float(found["stride"])
        # From the middle: gap = radius - |place|, pushed straight to the wall.
        place = radius - gap + toward * t + push * t**2 / 2
        assert radius - math.hypot(place, across * t) >= -1e-12


def leaving(ball: Rolling, thrown: bool) -> None:
    """Give the ball what a departure takes."""
    ball.values |= {"free_time": math.inf} | STILL
    ball.call("ring_rolling_surface")
    ball.call("ring_normal")
    ball.call("ring_separation")
    assert (ball["lift"] > 1e-6) == thrown
    with np.errstate(invalid="ignore"):  # a root that is not chosen
        ball.call("separated")


DEPARTURES = (
    ((95.0, 0.0, 0.5, 0.0, 30.0), False),
    ((91.0, 0.0, 0.0, 0.0, 0.0), False),
    ((80.0, -2.0, 0.7, 0.4, 0.0), False),
    ((60.0, 8.0, 1.0, 0.0, 10.0), True),
    ((90.0, 12.0, 2.0, 0.0, 10.0), True),
)


@pytest.mark.parametrize(("start", "thrown"), DEPARTURES)
def test_a_ball_that_departs_is_off_the_ring_for_as_long_as_is_said(
    start: tuple[float, ...], thrown: bool
) -> None:
    """At forty digits, from the computed state on; and it is said of more than a moment."""
    ball = Rolling(*start)
    if not thrown:
        ball.leave()
    leaving(ball, thrown)
    when = ball["when"]
    assert 1e-5 < when <= 2**-7
    assert ball["undecided_time"] == math.inf
    with mpmath.workdps(40):
        x, y, z, vx, vy, vz = (mpmath.mpf(ball[name]) for name in court.STATE[:6])

        def gap(t: Any) -> Any:
            over = mpmath.hypot(x + vx * t, y + vy * t) - RING_RADIUS
            return mpmath.hypot(over, z + vz * t - GRAVITY * t**2 / 2)

        begun = gap(mpmath.mpf(0))
        gaps = [gap(mpmath.mpf(when) * k / 64) - begun for k in range(1, 65)]
    assert abs(begun - REACH) < 1e-15
    # At once after it only roundings of the state count.
    assert all(found > -1e-17 for found in gaps)
    assert gaps[-1] > 0


def test_a_ball_that_departs_meets_no_other_body_meanwhile() -> None:
    """The time is the first root of a parabola, a quarter of it is flown."""
    for gap, nearing in ((0.01, -1.0), (1e-6, 0.5), (0.0, 0.5)):
        ball = Rolling(91.0)
        ball.leave()
        ball.values |= {"free_time": math.inf} | STILL
        for name in ("ring_rolling_surface", "ring_normal", "ring_separation"):
            ball.call(name)
        given = {"gap": gap, "nearing": nearing, "gap_curvature": 1 / 0.2}
        ball.values |= given
        ball.call("neighbour_free_time")
        free = ball["free_time"]
        speed = sum(abs(ball[f"v{axis}"]) for axis in "xyz") + GRAVITY * 2**-7
        bends = GRAVITY + speed**2 / 0.2
        left = gap + nearing * free - bends * free**2 / 2
        assert left == pytest.approx(0.0, abs=1e-12)
        ball.call("separated")
        assert ball["when"] <= free / 4


@pytest.mark.parametrize(
    ("gap", "nearing", "crosses"),
    [
        (0.01, -1.0, False),
        (-1e-12, -1.0, False),
        (-1e-12, -1e-3, True),
        (0.0, 0.5, False),
        (-1e-3, 0.0, False),
        (-1e-6, 1e-3, True),
        (0.0, 0.0, True),
    ],
)
def test_a_ball_that_departs_crosses_no_end_plane_in_certainty(
    gap: float, nearing: float, crosses: bool
) -> None:
    """The shot is undecided if a gap that bends as much can become positive and negative again."""
    ball = Rolling(91.0)
    ball.leave()
    ball.values |= {"free_time": math.inf, "undecided_time": math.inf}
    ball.values |= {"gap": gap, "nearing": nearing, "gap_curvature": 0.0}
    ball.call("end_plane_free_time")
    assert math.isinf(ball["free_time"]) == (gap <= 0.0)
    assert ball["undecided_time"] == (0.0 if crosses else math.inf)
    longest = min(ball["free_time"], 2**-7)
    times = np.linspace(0.0, longest, 200)
    found = False
    for turn in np.linspace(0.0, longest, 40):
        # It bends forwards until the turn and backwards after it.
        after = np.maximum(times - turn, 0.0)
        gaps = gap + nearing * times + GRAVITY * (times**2 / 2 - after**2)
        in_front = np.maximum.accumulate(gaps > 1e-15)
        found |= bool(np.any(in_front & (gaps < -1e-15)))
    assert found <= crosses


@pytest.mark.parametrize("kind", [1, 2, 4, 5])
def test_errors_after_a_step_are_those_of_a_motion_that_begins_with_them(kind: int) -> None:
    """The difference quotient of a motion far closer, or farther, is the same to its order."""
    ball = balls()[kind]()
    ball.expand()
    random = np.random.default_rng(kind)
    errors = dict(zip(ERRORS, random.normal(size=9) * 1e-10, strict=True))
    time = 0.5 * ball["stride"]

    def moved(scale: float) -> dict[str, float]:
        other = balls()[kind]()
        for name in court.STATE:
            other.values[name] += scale * errors[f"d{name}"]
        if isinstance(other, OnBoard):
            for name in ("backboard_normal", "roll_turn_rate", "backboard_distance"):
                other.call(name)
            other.call("roll_placed")
        other.expand()
        other.values["stride"] = 1.0
        other.step(time)
        return {name: other[name] for name in court.STATE}

    ball.values |= errors | STILL
    ball.call("neighbour_scale")
    ball.call("neighbour")
    scale = ball["neighbour_scale"]
    start = {name: ball[name] for name in court.STATE}
    for name in court.STATE:
        assert ball[f"far_{name}"] == pytest.approx(start[name] + scale * errors[f"d{name}"])
    far = moved(scale)
    ball.values |= {f"far_{name}": value for name, value in far.items()}
    ball.values["stride"], missed = 1.0, 1e-13
    ball.step(time)
    ball.values |= {"stride": time, "missed": missed}
    ball.call("compared")
    # A hundred times nearer.
    (one, other), nearer = (moved(sign * scale / 100) for sign in (1, -1)), scale / 50
    for name in court.STATE:
        expected = (one[name] - other[name]) / nearer
        found = ball[f"d{name}"]
        unit = (NBA["ball_radius"] if name[0] == "w" else 1.0) * abs(found - expected)
        assert unit < 1e-3 * max(map(abs, errors.values())) + 1e-11
        # Further from zero by the truncation error of the velocity, and the roundings.
        if name[0] == "v":
            change = (far[name] - ball[name]) / scale
            assert abs(found) - abs(change) >= missed
