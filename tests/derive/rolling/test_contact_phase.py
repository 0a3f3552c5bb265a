"""A ball that stays in contact: its kernels, its conservation laws, its decisions, both engines."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hoopgen.derive.motion.ring_rolling_series import ORDER
from hoopgen.generated.numpy import court
from hoopgen.generated.numpy.court import Event
from numpy.typing import NDArray

import hoopgen
from hoopgen import COURT, PAPER_COURT
from tests.helpers.effort import trials

pytest.importorskip("flint")

from benchmarks import ring_roll, rolling
from benchmarks.workloads import free_throw

# One worker: the C library of the scene is looked at once.
pytestmark = pytest.mark.xdist_group("rolling")

NBA = PAPER_COURT | {name: v for name, v in hoopgen.NBA.items() if name in PAPER_COURT}
GRAVITY = NBA["gravity"]
RING_RADIUS = NBA["ring_radius"]
REACH = NBA["ball_radius"] + NBA["wire_radius"]


class Rolling:
    """A ball on the ring, stepped by the kernels alone: no event loop, no other body.

    The angle `a` around the wire from outwards and the azimuth `round_` in degrees, the rate `turn`
    of a in rad/s; in m/s the speed P `along` the ring, and `s`, the ball's radius times its spin
    about the normal.
    """

    def __init__(
        self, a: float, turn: float = 0.0, along: float = 0.0, s: float = 0.0, round_: float = 0.0
    ) -> None:
        a, round_ = math.radians(a), math.radians(round_)
        e = np.array([math.cos(round_), math.sin(round_), 0.0])
        over = np.array([-e[1], e[0], 0.0])
        up = np.array([0.0, 0.0, 1.0])
        normal = math.cos(a) * e + math.sin(a) * up
        place = RING_RADIUS * e + REACH * normal
        velocity = REACH * turn * (math.cos(a) * up - math.sin(a) * e) + along * over
        spin = (np.cross(normal, velocity) + s * normal) / NBA["ball_radius"]
        names = [court.VARIABLES[name] for name in court.PARAMETERS]
        self.values: dict[str, Any] = dict(zip(names, NBA.values(), strict=True))
        state = np.concatenate([place, velocity, spin])
        self.values |= dict(zip(court.STATE, state, strict=True))
        self.clock = 0.0

    def call(self, name: str) -> None:
        """Evaluate a kernel on the values there are, and keep what it gives."""
        kernel = getattr(court, name)
        given = [self.values[argument] for argument in court.ARGUMENTS[name]]
        self.values |= dict(zip(court.OUTPUTS[name], kernel(*given), strict=True))

    def __getitem__(self, name: str) -> float:
        return float(self.values[name])

    def expand(self) -> None:
        """Take the series at the place where the ball is."""
        self.call("ring_rolling_surface")
        for name in ("start", *range(ORDER), "step"):
            self.call(f"ring_round_{name}")

    def step(self, most: float) -> None:
        """Move the ball by so much time, or by a step of the series."""
        self.values["t"] = min(most, self["stride"])
        self.call("ring_round_moved")
        self.clock += self["t"]

    def leave(self) -> None:
        """Roll until the normal force is spent."""
        while True:
            self.expand()
            force, rate, bend = self["force"], self["force_rate"], self["force_bend"]
            if force < 1e-14 and rate < 0:
                return
            # No force is spent before a parabola below it is.
            self.step(2 * max(force, 0) / (math.sqrt(rate**2 + 2 * bend * max(force, 0)) - rate))

    def roll(self, duration: float) -> None:
        """Roll for some time."""
        while self.clock < duration:
            self.expand()
            self.step(duration - self.clock)

    @property
    def energy(self) -> float:
        """Per unit mass: translation, rotation with and without spin about the normal, height."""
        self.call("ring_normal")
        self.call("roll_turn_rate")
        squared = sum(self[f"v{axis}"] ** 2 for axis in "xyz")
        return 5 / 6 * squared + self["turn_rate"] ** 2 / 3 + GRAVITY * self["z"]

    @property
    def coordinates(self) -> tuple[float, ...]:
        """Return a in degrees, its rate, P, s, the azimuth in degrees."""
        self.call("ring_normal")
        self.call("roll_turn_rate")
        x, y, z, vx, vy, vz = (self[name] for name in court.STATE[:6])
        rho = math.hypot(x, y)
        a, outwards = math.atan2(z, rho - RING_RADIUS), (x * vx + y * vy) / rho
        turn = (math.cos(a) * vz - math.sin(a) * outwards) / REACH
        along = (x * vy - y * vx) / rho
        return (math.degrees(a), turn, along, self["turn_rate"], math.degrees(math.atan2(y, x)))


# What an integration in 40 digits found: the time and the coordinates when N = 0.
LEAVES = (
    (
        (95.0, 0.0, 0.5, 0.0, 30.0),
        0.487167097561648272,
        (36.9270804145623985, -6.65937949245276254, 0.262830551996618897, -0.323133774692049886)
        + (78.2015484720540274,),
    ),
    ((91.0, 0.0, 0.0, 0.0, 0.0), 0.704767090727255591, (146.94994774794159,)),
)


@pytest.mark.parametrize(("start", "time", "there"), LEAVES)
def test_a_ball_leaves_the_ring_when_and_where_it_should(
    start: tuple[float, ...], time: float, there: tuple[float, ...]
) -> None:
    ball = Rolling(*start)
    ball.leave()
    assert ball.clock == pytest.approx(time, rel=0, abs=1e-13)
    assert ball.coordinates[: len(there)] == pytest.approx(there, rel=1e-13, abs=1e-15)


@pytest.mark.parametrize("a", [60.0, 91.0, 100.0, 130.0])
def test_from_rest_it_leaves_at_six_elevenths_of_the_height(a: float) -> None:
    ball = Rolling(a)
    ball.leave()
    last = math.sin(math.radians(ball.coordinates[0]))
    assert last == pytest.approx(6 / 11 * math.sin(math.radians(a)), rel=0, abs=1e-14)


# Swirls that stay for longer than a second: one nearly steady, two that rise and fall.
SWIRLS = (
    (135.0, 0.0, 0.924, 0.0, 0.0),
    (135.0, -0.1, 0.924, -0.02, 40.0),
    (140.0, -0.4, 1.0, -0.2, 0.0),
)


@pytest.mark.parametrize("start", SWIRLS)
def test_energy_stays_over_a_second_of_rolling(start: tuple[float, ...]) -> None:
    ball = Rolling(*start)
    before = ball.energy
    ball.roll(1.0)
    assert ball["force"] > 0
    assert abs(ball.energy - before) < 1e-12


@pytest.mark.parametrize("start", [*SWIRLS, (95.0, 0.0, 0.5, 0.0, 30.0), (80.0, -2.0, 0.7, 0.4, 0)])
def test_routh_s_equations_are_linear_in_the_angle(start: tuple[float, ...]) -> None:
    """dP/da = (R sin a/rho) P - (2/5) s and ds/da = (R_H/rho) P: no time and no gravity in them."""
    ball = Rolling(*start)
    ball.roll(0.2)
    a, rate, along, s, _ = ball.coordinates
    ball.expand()
    # The rates in time, from the series' terms of the first order.
    x, y, _, vx, vy, _ = (ball[name] for name in court.STATE[:6])
    rho = math.hypot(x, y)
    outwards = (x * vx + y * vy) / rho
    along_rate = (x * ball["vy_1"] - y * ball["vx_1"]) / rho - along * outwards / rho
    sine = math.sin(math.radians(a))
    expected = REACH * sine / rho * along - (1 - 3 / 5) * s
    assert along_rate == pytest.approx(rate * expected, rel=1e-12, abs=1e-13)
    assert ball["turn_rate_1"] == pytest.approx(rate * RING_RADIUS / rho * along, rel=1e-12)


ALONG_THE_TOP = (90.02, 0.05, 0.001, 0.0, 180.0)


@pytest.mark.parametrize("start", [*SWIRLS, ALONG_THE_TOP, (150.0, -6.0, 1.5, 0.5, 0.0)])
def test_speed_and_acceleration_stay_within_a_step_s_bounds(start: tuple[float, ...]) -> None:
    ball = Rolling(*start)
    ball.expand()
    step, fastest, strongest = ball["stride"], ball["fastest"], ball["strongest"]
    for k in range(9):
        there = Rolling(*start)
        there.expand()
        there.step(step * k / 8)
        there.expand()
        assert math.hypot(*(there[f"v{axis}"] for axis in "xyz")) <= fastest * (1 + 1e-12)
        assert math.hypot(*(there[f"v{axis}_1"] for axis in "xyz")) <= strongest * (1 + 1e-9)


def test_a_ball_that_hardly_moves_along_the_top_is_not_taken_for_one_that_falls() -> None:
    """Else it takes thousands of steps along the bridge's edge, which is next to it there."""
    ball = Rolling(*ALONG_THE_TOP)
    ball.expand()
    assert ball["strongest"] < GRAVITY / 50


def test_without_errors_a_bounce_is_looked_at_when_it_may_be_the_last() -> None:
    at = dict.fromkeys(court.ARGUMENTS["leaves_slowly"], 0.0)
    at |= {court.VARIABLES[name]: value for name, value in PAPER_COURT.items()} | {"nz": 1.0}

    def looked(speed: float, error: float) -> tuple[bool, bool]:
        given = at | {"vx": 0.5, "vz": speed, "position_error": error}
        found: dict[str, Any] = {}
        for name in ("leaves_slowly", "nearly"):
            values = getattr(court, name)(*(given[one] for one in court.ARGUMENTS[name]))
            found |= dict(zip(court.OUTPUTS[name], values, strict=True))
        return bool(found["slow"]), bool(found["nearly"])

    assert looked(1e-3, 1e-12) == (False, False)
    assert looked(5e-5, 1e-12) == (True, False)
    assert looked(5e-5, 0.0) == (False, False)
    assert looked(1e-6, 0.0) == looked(1e-6, 1e-12) == (True, True)


# ------------------------------------------------------------------------------- settled shots


def _rolled(shots: hoopgen.Shots) -> NDArray[np.int64]:
    """Return the shots that rolled."""
    return np.unique(shots.events["shot"][shots.events["kind"] == Event.ROLL])


needs_library = pytest.mark.skipif(COURT.library is None, reason="the C engine was not built")


@pytest.mark.slow
@needs_library
def test_settled_shots_roll_as_a_second_formulation_says() -> None:
    found = rolling.Found()
    states = free_throw(1 << 12)
    for restitution in (0.3, 0.5):
        most = found.shots + 10
        rolling.compare(states, rolling.elastic(restitution), 4.0, most, found)
    assert found.shots == 20
    assert found.lodged + found.bouncing + found.rolling <= found.flagged < 20
    assert found.ends.keys() >= {"leaves", "end plane"}
    assert found.wrong == []
    assert found.leaving < 1e-9
    assert np.all(found.ratios <= 1)
    _, share, most = found.bounced()
    assert most <= 1
    assert share > 1e-3


@pytest.mark.slow
@needs_library
def test_errors_of_ever_smaller_bounces_are_claimed_but_not_a_thousand_times() -> None:
    """Held against the same bounces with 400 bits, up to where the ball rolls."""
    found = rolling.Found()
    rolling.compare(free_throw(1 << 13), rolling.elastic(0.7), 4.0, 30, found)
    assert found.shots == 30
    off, share, most = found.bounced()
    assert 1e-16 < off < 1e-12
    assert most <= 1
    assert share > 1e-3


@needs_library
def test_without_restitution_a_ball_leaves_the_bridge_beside_the_ring_that_it_touches() -> None:
    """The ball moves off the ring, leaves a corner, and crosses a seam to a face that holds it."""
    rows = [274, 862, 1462, 1984, 7432]
    states = free_throw(rows[-1] + 1)[rows]
    shots = hoopgen.simulate(states, rolling.elastic(0.0), scene=COURT, time_limit=6.0, record=True)
    assert not np.any(shots.outcome == COURT.outcomes["CAPPED"])
    assert shots.contacts.max() < 100
    at_bridge = shots.events[
        (shots.events["surface"] == 2) & (shots.events["kind"] == Event.IMPACT)
    ]
    low, high = list(ring_roll.boxes(NBA))[1]
    place = at_bridge["before"][:, :3]
    away = np.linalg.norm(place - np.clip(place, low, high), axis=1)
    # A rolling ball has arrived at what it is as near to as its place is known, and nears.
    landing = 2.0**-47 * (np.abs(place).sum(axis=1) + NBA["ball_radius"])
    assert np.all(np.abs(away - NBA["ball_radius"]) <= landing)


@pytest.mark.slow
@needs_library
def test_rolling_from_a_bounce_is_off_by_the_square_of_its_speed() -> None:
    for restitution, throws in ((0.3, 200), (0.5, 300)):
        found = list(rolling.bounces(free_throw(throws), restitution))
        slow = [one.by_limit for one in found if one.speed < 1e-3]
        assert len(slow) > 20
        assert np.median(slow) == pytest.approx(1.0, abs=3e-3)
        fast = [one.by_limit for one in found if one.speed > 1e-2]
        assert np.std(slow) < np.std(fast) / 4


def test_the_second_formulation_leaves_when_and_where_it_should() -> None:
    for start, time, there in LEAVES:
        ball = Rolling(*start)
        state = np.array([ball[name] for name in court.STATE])
        roll = ring_roll.Roll(state, NBA | {"end_depth": 9.0})
        what, when = roll.until(2.0)
        assert what == ring_roll.LEAVES
        # The start is of doubles.
        assert float(when) == pytest.approx(time, rel=0, abs=2e-15)
        a = math.degrees(math.atan2(float(roll.now[1]), float(roll.now[0])))
        assert a == pytest.approx(there[0], rel=1e-15)


@pytest.mark.slow
@needs_library
def test_both_engines_settle_and_roll_to_the_same_bits() -> None:
    scene = rolling.elastic(0.2)
    states = free_throw(1 << 10)
    options: dict[str, Any] = {"scene": COURT, "record": True, "time_limit": 1.6}
    options["fields"] = tuple(COURT.layout.results)
    shots = _rolled(hoopgen.simulate(states, scene, **options))[:8]
    assert len(shots) == 8
    one, other = (
        hoopgen.simulate(states[shots], scene, backend=backend, **options)
        for backend in ("c", "numpy")
    )
    assert {*one.events["kind"]} == {*Event}
    for name in options["fields"]:
        assert np.array_equal(getattr(one, name), getattr(other, name), equal_nan=True), name
    for name in one.events.dtype.names:
        assert np.array_equal(one.events[name], other.events[name]), name


@needs_library
@pytest.mark.parametrize(("restitution", "count"), [(0.7, 5_000), (0.95, 300)])
def test_no_free_throw_with_grip_is_capped(restitution: float, count: int) -> None:
    sizes = rolling.elastic(restitution)
    shots = hoopgen.simulate(free_throw(count), sizes, scene=COURT, time_limit=6.0)
    assert not np.any(shots.outcome == COURT.outcomes["CAPPED"])
    assert not np.any(shots.outcome == COURT.outcomes["INVALID"])


# Free throws that come to swirl inside the ring: their numbers.
FOR_EVER = (8045, 43962, 57130)


@pytest.mark.slow
@needs_library
def test_a_ball_that_rolls_for_ever_ends_as_soon_as_that_is_certain() -> None:
    states = free_throw(FOR_EVER[-1] + 1)[[*FOR_EVER]]
    shots = hoopgen.simulate(states, scene=COURT, record=True, parameters=PAPER_COURT)
    assert np.all(shots.outcome == COURT.outcomes["ENDLESS"])
    assert np.all(shots.time < 4)
    assert not np.any(shots.uncertain)
    ends = shots.events[shots.events["kind"] == Event.END]
    assert np.array_equal(ends["time"], shots.time)
    # It ends there as it would at a time limit, its last step as long to a rounding of the time;
    # and a second formulation rolls on.
    for k, state in enumerate(states):
        limit = float(shots.time[k])
        limited = hoopgen.simulate(state, scene=COURT, time_limit=limit, parameters=PAPER_COURT)
        assert limited.state[0] == pytest.approx(shots.state[k], rel=0, abs=1e-13)
    roll = ring_roll.Roll(shots.state[0], PAPER_COURT)
    assert roll.until(3.0)[0] == ring_roll.TIME


def _proved(ball: Rolling, berth: float) -> bool:
    """Return whether a second of rolling is certain not to end, with so much room beside it."""
    ball.values |= {
        "circled": 0.0,
        "azimuth_clearance": berth,
        "which": -1.0,
        "undecided_time": math.inf,
    }
    ball.values |= {"position_error": 1e-13, "velocity_error": 1e-13}
    while ball.clock < 2.0:
        ball.expand()
        ball.step(math.inf)
        ball.call("ring_swung")
        if ball.values["endless"]:
            return math.isinf(ball["undecided_time"])
    return False


@pytest.mark.slow
def test_rolling_for_ever_takes_two_turning_points_room_and_being_pressed_on() -> None:
    swirl = (140.0, -0.4, 1.0, -0.2)
    assert _proved(Rolling(*swirl), 0.01)
    assert not _proved(Rolling(*swirl), 1e-5)
    # A steady roll turns nowhere; one that falls off is not pressed on.
    assert not _proved(Rolling(135.0, 0.0, 0.9236, 0.0), 0.01)
    assert not _proved(Rolling(95.0, 0.0, 0.5, 0.0), 0.01)


def test_no_place_at_any_azimuth_is_nearer_than_the_bound_says() -> None:
    random = np.random.default_rng(5)
    names = [court.VARIABLES[name] for name in court.PARAMETERS]
    values: dict[str, Any] = dict(zip(names, PAPER_COURT.values(), strict=True))
    count = trials(400)
    rho, z = random.uniform(0.05, 0.5, count), random.uniform(-0.3, 0.4, count)
    round_ = np.linspace(0, 2 * np.pi, 2001)[:, np.newaxis]
    for body in ("backboard", "bridge"):
        there = {"x": rho * np.cos(round_), "y": rho * np.sin(round_), "z": z + 0 * round_}
        there |= {f"v{axis}": 0.0 * round_ for axis in "xyz"}
        given = values | there
        with np.errstate(invalid="ignore"):
            off, around = (
                getattr(court, f"{body}_{name}")(
                    *(given[a] for a in court.ARGUMENTS[f"{body}_{name}"])
                )
                for name in ("distance", "around")
            )
        nearest = np.min(off[0], axis=0)
        assert np.all(around[0][0] <= nearest + 1e-15)
        # In front of it, it is the distance in the court's middle.
        front = rho < PAPER_COURT["ring_radius"]
        assert np.allclose(around[0][0][front], nearest[front], rtol=0, atol=1e-6)


# ----------------------------------------------------------------------------------- odd cases


def _dropped(
    place: tuple[float, float, float], spin: tuple[float, float, float] = (0.0, 0.0, 0.0)
) -> NDArray[np.float64]:
    return np.array([*place, 0.0, 0.0, 0.0, *spin])


def _flown(state: NDArray[np.float64], **sizes: float) -> tuple[str, hoopgen.Shots]:
    shots = hoopgen.simulate(state, PAPER_COURT | sizes, scene=COURT, record=True)
    return COURT.outcomes(int(shots.outcome[0])).name, shots


def _restitution(value: float) -> dict[str, float]:
    return {f"{body}_restitution": value for body in COURT.surfaces}


@pytest.mark.parametrize("ball", [0.03, 0.1])
def test_a_ball_that_drops_onto_the_bridge_comes_to_rest(ball: float) -> None:
    outcome, shots = _flown(_dropped((-0.26, 0, 0.4)), ball_radius=ball, **_restitution(0.5))
    assert outcome == "LODGED"
    assert not shots.uncertain[0]
    assert np.all(shots.events["surface"] == COURT.surfaces.index("bridge"))
    assert np.all(shots.events["kind"] == [*[Event.IMPACT] * (len(shots.events) - 1), Event.ROLL])
    top = ball + PAPER_COURT["wire_radius"]
    assert shots.state[0] == pytest.approx([-0.26, 0, top, 0, 0, 0, 0, 0, 0], abs=1e-15)


def test_so_does_one_whose_normal_is_rounded() -> None:
    outcome, _ = _flown(_dropped((-0.25, 0, 0.5)), **_restitution(0.5))
    assert outcome == "LODGED"


@pytest.mark.parametrize("spin", [10.0, 100.0, 1000.0])
def test_bounces_that_end_with_slip_are_capped(spin: float) -> None:
    state = _dropped((-0.308, 0, 0.05), (spin, 0, 0))
    sizes = {"ball_radius": 0.03, "bridge_friction": 0.05, "bridge_half_width": 0.5}
    outcome, shots = _flown(state, **sizes, **_restitution(0.5))
    assert outcome == "CAPPED"
    assert shots.slip_left[0]
    assert np.all(shots.events["kind"] == Event.IMPACT)
    # All that friction can take from the slip: mu times what the bounces come to.
    drop = 0.05 - 0.04
    pushed = math.sqrt(2 * PAPER_COURT["gravity"] * drop) * 3
    slip = 0.03 * spin - 5 / 2 * 0.05 * pushed
    _, _, _, _, vy, bounce, wx, _, _ = shots.state[0]
    # The shot ends as soon as the bounces that are left cannot take it all.
    left = 5 / 2 * 0.05 * (1 + 0.5) * bounce / (1 - 0.5)
    assert 0 < left < 1e-5
    assert abs(vy + 0.03 * wx) - left == pytest.approx(slip, rel=1e-10)


def test_a_ball_may_roll_for_ever_and_so_needs_a_time_limit() -> None:
    with pytest.raises(ValueError, match="time_limit: expected a finite time in the scene court"):
        hoopgen.simulate(_dropped((0.2, 0, 0.5)), scene=COURT, time_limit=math.inf)


def test_without_restitution_a_ball_settles_at_once() -> None:
    _, shots = _flown(_dropped((0.2, 0.13, 0.3)), **_restitution(0.0))
    kinds = [Event.IMPACT, Event.ROLL, Event.LEAVE, Event.END]
    assert [*shots.events["kind"]] == kinds
    assert shots.events["time"][0] == shots.events["time"][1]


def test_one_that_falls_straight_onto_it_does_too() -> None:
    _, shots = _flown(_dropped((0.235, 0.0, 0.5)), **_restitution(0.0))
    assert [*shots.events["kind"]] == [Event.IMPACT, Event.ROLL]
    assert not shots.uncertain[0]


def test_a_ball_that_loses_nothing_never_settles() -> None:
    state = _dropped((-0.308, 0, 0.3))
    outcome, shots = _flown(state, ball_radius=0.03, **_restitution(1.0))
    assert outcome == "ENDLESS"
    assert np.all(shots.events["kind"][:-1] == Event.IMPACT)
    assert len(shots.events) > 100


# Where the normal force of this roll is spent, friction ends with it; without friction the gap's
# third derivative is below 0, and the ball would be pressed onto the ring.
HELD = (
    "0x1.0c395810624ddp+2 0x0.0p+0 -0x1.381d7dbf487fdp-1 -0x1.188cefb25085dp+2 "
    "-0x1.f09152c1de2a6p-4 0x1.5c880802e9534p+2 -0x1.0acdd6c5cecdcp-1 0x1.2d7a459b37a5cp+4 0x0.0p+0"
)


@pytest.mark.parametrize("backend", ["c", "numpy"])
def test_a_ball_that_flight_would_press_on_is_held_until_it_would_not(backend: Any) -> None:
    if backend == "c" and COURT.backend != "c":
        pytest.skip("the C library was not built")
    state = np.array([float.fromhex(part) for part in HELD.split()])
    sizes = NBA | _restitution(0.5)
    shots = hoopgen.simulate(state, sizes, scene=COURT, record=True, backend=backend)
    assert COURT.outcomes(int(shots.outcome[0])).name == "MISSED"
    assert shots.uncertain[0]
    leaves = shots.events[shots.events["kind"] == Event.LEAVE]
    assert len(leaves) == 1
    # The force is spent, by less than a thousandth of the ball's weight.
    left = ring_roll.Roll(leaves[0]["before"], COURT.parameters | sizes)
    *_, force = left.series()
    assert -1e-3 * sizes["gravity"] < float(force[0]) < 0


@pytest.mark.slow
def test_a_proof_agrees_with_a_shot_that_rolls_as_far_as_it_goes() -> None:
    """The judge bounces on where the ball rolls; the contacts until then are those proved."""
    soft = NBA | _restitution(0.2)
    random = np.random.default_rng(3)
    states = np.zeros((24, 9))
    states[:, :6] = random.normal([0.24, 0, 0.3, 0, 0.3, 0], [0.03, 0, 0, 0.2, 0.2, 0], (24, 6))
    shots = hoopgen.simulate(states, soft, scene=COURT, record=True, time_limit=3)
    proof = hoopgen.certify(states, soft, scene=COURT, max_contacts=16, time_limit=3)
    rolled = np.unique(shots.events["shot"][shots.events["kind"] == Event.ROLL])
    sure = rolled[~shots.uncertain[rolled]]
    assert len(sure) > 3
    assert proof.agrees(shots)[sure].all()
    other = np.roll(np.arange(len(states)), 1)
    wrong = hoopgen.certify(states[other], soft, scene=COURT, max_contacts=16, time_limit=3)
    assert not wrong.agrees(shots)[sure].all()
