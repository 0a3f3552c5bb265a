"""Measures of a shot, against its event log, its trajectory, and more digits."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest
import sympy as sp
from hoopgen.derive.scenes.hoop import HOOP
from hoopgen.derive.studies import measures as derived
from hoopgen.derive.surfaces import Ring
from hoopgen.derive.symbolic.conditionals import release as unheld
from hoopgen.derive.symbolic.symbols import POSITION, VELOCITY, t
from hoopgen.generated.numpy import hoop
from mpmath import mp, mpf
from numpy.typing import NDArray

import hoopgen
from hoopgen.hoop.kinds import Kind, kinds
from hoopgen.hoop.releases import RING_HEIGHT
from hoopgen.study.measures import measure_context, measures
from hoopgen.study.measures.measures import MEASURES, measure, nearest
from tests.helpers.derived import decided
from tests.helpers.effort import trials
from tests.helpers.hoop_shots import Batch

Floats = NDArray[np.float64]
EPS = float(np.finfo(np.float64).eps)
DIGITS = 40
RING, BOARD, BRIDGE = range(3)
RECORDED = trials(3000, at_least=1500)
"""Shots whose event logs are looked into."""

GRAVITY = HOOP.gravity


# The formulas


@pytest.mark.parametrize("falling", [True, False])
def test_the_descent_is_at_the_height_and_falling(falling: bool) -> None:
    """Rising and falling balls take different forms of one root."""
    found = {name: decided(e, falling) for name, e in derived.descent(HOOP.flight).items()}
    place, velocity = HOOP.flight.at(found["time"])
    assert sp.simplify(place[2] - derived.level) == 0
    assert sp.simplify(velocity[2] - found["vz"]) == 0
    values = {POSITION[2]: 3, derived.level: 1, VELOCITY[2]: -2 if falling else 2, GRAVITY: 5}
    assert found["vz"].subs(values) < 0
    assert found["time"].subs(values) > 0


def test_the_apex_is_where_the_ball_neither_rises_nor_falls() -> None:
    found = {name: decided(e, True) for name, e in derived.apex(HOOP.flight).items()}
    place, velocity = HOOP.flight.at(found["time"])
    assert sp.simplify(velocity[2]) == 0
    assert sp.simplify(place[2] - found["height"]) == 0
    falling = [e.subs(VELOCITY[2], -1) for e in derived.apex(HOOP.flight).values()]
    assert falling == [0, POSITION[2]]


def test_past_and_left_are_the_place_s_own_axes() -> None:
    """A turn that takes the line of sight to (1, 0): lengths and handedness are kept."""
    x, y = POSITION[:2]
    past, left = (unheld(e) for e in derived.line_of_sight().values())
    assert sp.simplify(past**2 + left**2 - x**2 - y**2) == 0
    jacobian = sp.Matrix([past, left]).jacobian([x, y])
    assert sp.simplify(jacobian.det()) == 1
    centre = {x: derived.place_x, y: derived.place_y}
    away = sp.sqrt(derived.place_x**2 + derived.place_y**2)
    assert sp.simplify(past.subs(centre, simultaneous=True) + away) == 0
    assert sp.simplify(left.subs(centre, simultaneous=True)) == 0


@pytest.mark.slow
def test_the_bend_of_the_squared_distance_is_as_stated() -> None:
    """G'' = 2 V² + 2 (vz² + 2 g z) - 6 g z_t - 2 R_H L²/rho³, and `rate` is G'."""
    (x, y, z), (vx, vy, vz) = POSITION, VELOCITY
    radius = sp.Symbol("radius", positive=True)
    there, _ = HOOP.flight.at()
    rho = sp.sqrt(there[0] ** 2 + there[1] ** 2)
    square = (rho - radius) ** 2 + there[2] ** 2
    stated = 2 * (vx**2 + vy**2) + 2 * (vz**2 + 2 * GRAVITY * z) - 6 * GRAVITY * there[2]
    stated -= 2 * radius * (x * vy - y * vx) ** 2 / rho**3
    assert sp.simplify(sp.diff(square, t, 2) - stated) == 0
    rate = unheld(derived.nearness(Ring("ring", radius, sp.Integer(0)), HOOP.flight)["rate"])
    assert sp.simplify(sp.diff(square, t) - rate) == 0


def _flights(count: int, seed: int) -> tuple[Floats, Floats]:
    """Give flights about the ring, (count, 6), and their durations; some through the very axis."""
    random = np.random.default_rng(seed)
    start, arrival = random.normal(0, 1, (count, 3)), random.uniform(0.1, 1.0, count)
    goal = random.normal(0, 0.3, (count, 3))
    way = (goal - start) / arrival[:, None]
    way[:, 2] += 9.81 * arrival / 2
    start[::5, 1], way[::5, 1] = 0.0, 0.0
    start[1::5, :2] *= 1e-9
    way[1::10, :2] *= 1e-9
    return np.hstack([start, way]), arrival * random.uniform(0.5, 2.0, count)


def _nearness(flights: Floats, time: Floats, half: Floats | float) -> dict[str, Floats]:
    sizes = [hoopgen.PAPER[n] for n in ("ball_radius", "ring_radius", "wire_radius", "gravity")]
    with np.errstate(all="ignore"):
        outputs = hoop.ring_nearness(time, *flights.T, half, *sizes)
    return dict(zip(hoop.OUTPUTS["ring_nearness"], outputs, strict=True))


@pytest.mark.parametrize("width", [1e-3, 0.03, 0.3])
def test_no_place_in_a_cell_is_nearer_than_its_bound(width: float) -> None:
    """And where it promises at most one minimum, the rate changes its sign at most once."""
    flights, durations = _flights(trials(4000), seed=11)
    half = np.minimum(width, durations / 2)
    middle = half + np.random.default_rng(12).uniform(0, 1, len(half)) * (durations - 2 * half)
    cell = _nearness(flights, middle, half)
    inside = np.linspace(-1, 1, 101)[:, None] * half + middle
    at = [_nearness(flights, time, 0.0) for time in inside]
    nearest = np.min([each["gap"] for each in at], axis=0)
    assert np.all(nearest >= cell["lower"] - cell["resolution"])
    single = cell["concavity"] < 0
    assert 0.1 < single.mean() < 1.0
    rates = np.array([each["rate"] for each in at])[:, single]
    # A rate within rounding of zero has no sign.
    assert np.all(np.diff(rates, axis=0) >= -1e-12)


def test_the_resolution_is_a_few_roundings_of_the_flight() -> None:
    """Against 40 digits the distance is within a quarter of it; which is far below a micrometre."""
    flights, durations = _flights(trials(500), seed=13)
    found = _nearness(flights, durations, 0.0)
    for row in range(len(flights)):
        with mp.workdps(DIGITS):
            exact = _distance([mpf(v) for v in flights[row].tolist()], mpf(durations[row].item()))
            assert abs(found["gap"][row].item() - exact) <= found["resolution"][row] / 4
    assert found["resolution"].max() < 1e-12


def _distance(flight_: list[Any], time: Any) -> Any:
    """Return the distance of ball and wire in whatever numbers are given, at the preset's sizes."""
    x, y, z, vx, vy, vz = flight_
    sizes = {name: mpf(hoopgen.PAPER[name]) for name in hoopgen.PAPER}
    x, y, z = x + vx * time, y + vy * time, z + vz * time - sizes["gravity"] * time**2 / 2
    off = mp.hypot(mp.hypot(x, y) - sizes["ring_radius"], z)
    return off - sizes["ball_radius"] - sizes["wire_radius"]


def _exactly_nearest(flight_: Floats, duration: float) -> Any:
    """Return the least distance: at an end, or where (rho G'/2)² = 0, of degree 8 in time."""
    with mp.workdps(60):
        x, y, z, vx, vy, vz = (mpf(v) for v in flight_.tolist())
        g, radius, end = mpf(hoopgen.PAPER["gravity"]), mpf(hoopgen.PAPER["ring_radius"]), duration
        times = np.polymul
        across = np.polyadd(times([vx, x], [vx]), times([vy, y], [vy]))  # x vx + y vy
        upward = times([-g / 2, vz, z], [-g, vz])
        rho2 = np.polyadd(times([vx, x], [vx, x]), times([vy, y], [vy, y]))
        total = np.polyadd(across, upward)
        condition = np.polysub(times(times(total, total), rho2), radius**2 * times(across, across))
        roots = mp.polyroots([mpf(c) for c in condition], maxsteps=500, extraprec=600)
        real = [root.real for root in map(mp.mpc, roots) if abs(root.imag) < mpf(10) ** -12]
        inside = [mpf(0), mpf(end), *(time for time in real if 0 < time < end)]
        return min(_distance([x, y, z, vx, vy, vz], time) for time in inside)


@pytest.mark.slow
def test_the_nearest_place_of_a_flight_is_the_nearest_of_all() -> None:
    """Against all stationary points, at 60 digits: within the resolution, below 1e-12 m."""
    flights, durations = _flights(trials(60), seed=14)
    flights = np.delete(flights, np.s_[1::10], axis=0)  # on the axis all along: no such polynomial
    durations = np.delete(durations, np.s_[1::10])
    states = np.hstack([flights, np.zeros((len(flights), 3))])
    with np.errstate(all="ignore"):
        found = nearest(states, durations, dict(hoopgen.PAPER))
    for row, least in enumerate(found.tolist()):
        assert abs(least - _exactly_nearest(flights[row], durations[row])) < 1e-12


@pytest.mark.parametrize(
    ("state", "duration", "where"),
    [
        # All along the axis the wire is R_H away at the least, when the ball is at its height.
        ([0, 0, 1, 0, 0, 0], 1.0, "axis"),
        ([0, 0, -1, 0, 0, 5], 1.2, "axis"),
        # Above the wire's own circle, down to it.
        ([0.235, 0, 1, 0, 0, 0], 1.0, "wire"),
        # No time at all.
        ([1.0, 0, 0, 0, 0, 0], 0.0, "start"),
    ],
)
def test_flights_on_which_bounds_are_infinite(
    state: list[float], duration: float, where: str
) -> None:
    sizes = hoopgen.PAPER
    reach = sizes["ball_radius"] + sizes["wire_radius"]
    expected = {"axis": sizes["ring_radius"], "wire": 0.0, "start": 1.0 - sizes["ring_radius"]}
    with np.errstate(all="ignore"):
        found = nearest(np.array([[*state, 0, 0, 0]]), np.array([duration]), sizes)
    assert found[0] == pytest.approx(expected[where] - reach, abs=1e-13)


# Kinds


@pytest.fixture(scope="module")
def recorded(mixed: Batch) -> tuple[Batch, hoopgen.Shots]:
    """Shots of all kinds with their event logs, and the parameters of each."""
    picked = mixed.take(np.random.default_rng(5).permutation(len(mixed))[:RECORDED])
    own = {n: np.broadcast_to(v, len(picked)).copy() for n, v in picked.parameters.items()}
    batch = Batch(np.array(picked.states), own)
    return batch, hoopgen.simulate(batch.states, own, record=True)


def _log(shots: hoopgen.Shots, shot: int) -> list[int]:
    """Return the surfaces that a shot touches, in order."""
    events = shots.trajectory(shot).events["surface"]
    return [int(surface) for surface in events if surface < len(hoopgen.SURFACES)]


def _kind_of(touched: list[int], outcome: int) -> Kind:
    if not touched:
        ends = {hoopgen.Outcome.MADE: Kind.SWISH, hoopgen.Outcome.MISSED: Kind.AIRBALL}
        return ends.get(hoopgen.Outcome(outcome), Kind.NONE)
    if BOARD not in touched:
        return Kind.RIM
    if touched[0] != BOARD:
        return Kind.RIM_BOARD
    return Kind.BANK if set(touched) == {BOARD} else Kind.BANK_RIM


def test_kinds_are_those_of_the_event_log(recorded: tuple[Batch, hoopgen.Shots]) -> None:
    _, shots = recorded
    found = kinds(shots.outcome, shots.counts, shots.first)
    assert found.dtype == np.uint8
    expected = [_kind_of(_log(shots, i), int(shots.outcome[i])) for i in range(len(shots))]
    assert found.tolist() == expected
    assert set(found.tolist()) == set(Kind)


def test_a_shot_that_touched_something_has_its_kind_however_it_ended() -> None:
    capped, invalid = hoopgen.Outcome.CAPPED, hoopgen.Outcome.INVALID
    counts = np.array([[0, 0, 3], [1, 2, 0], [0, 0, 0]], np.int32)
    outcome = np.array([capped, capped, invalid], np.uint8)
    found = kinds(outcome, counts, np.array([BRIDGE, BOARD, -1], np.int8))
    assert found.tolist() == [Kind.RIM, Kind.BANK_RIM, Kind.NONE]


# Where the ball comes to the ring


def _to_the_ring(batch: Batch, shots: hoopgen.Shots, shot: int) -> Floats:
    """Return the state from which the flight to the ring starts, by the event log."""
    events = shots.trajectory(shot).events
    first = len(events) and int(events["surface"][0]) == BOARD
    return events["after"][0] if first else batch.states[shot]


def test_entry_angle_depth_and_left_right_are_those_of_the_flight_to_the_ring(
    recorded: tuple[Batch, hoopgen.Shots],
) -> None:
    """The measures agree with 40 digits up to roundings.

    A place is off by some roundings of the coordinates flown, times how much further a ball flies
    that comes down at a slant; so is the angle, of 1.
    """
    batch, shots = recorded
    found = measure(batch.states, shots, batch.parameters, ["entry_angle", "depth", "left_right"])
    seen = 0
    for shot in range(len(shots)):
        values = {name: column[shot] for name, column in found.items()}
        if shots.outcome[shot] == hoopgen.Outcome.INVALID:
            assert np.isnan(list(values.values())).all()
            continue
        start = _to_the_ring(batch, shots, shot)
        with mp.workdps(DIGITS):
            x, y, z, vx, vy, vz, *_ = (mpf(v) for v in start.tolist())
            g = mpf(batch.parameters["gravity"][shot].item())
            under = vz**2 + 2 * g * z
            time = (vz + mp.sqrt(under)) / g if under >= 0 else mpf(-1)
            if time < 0:
                assert np.isnan(list(values.values())).all()
                continue
            seen += 1
            fall, level = mp.sqrt(under), mp.hypot(vx, vy)
            there_x, there_y = x + vx * time, y + vy * time
            from_x, from_y = (mpf(v) for v in batch.states[shot, :2].tolist())
            away = mp.hypot(from_x, from_y)
            ahead = (-from_x / away, -from_y / away)
            depth = there_x * ahead[0] + there_y * ahead[1]
            left = there_x * -ahead[1] + there_y * ahead[0]
            steep = float((vz**2 + 2 * g * abs(z)) / under)  # how much larger than their difference
            flown = float(abs(x) + abs(y) + 2 * level * time)
            assert abs(values["depth"] - depth) <= 8 * EPS * flown * steep
            assert abs(values["left_right"] - left) <= 8 * EPS * flown * steep
            assert abs(values["entry_angle"] - mp.atan2(fall, level)) <= 8 * EPS * steep
    assert seen > RECORDED / 2


def test_a_ball_off_the_board_alone_goes_where_it_is_said_to(
    recorded: tuple[Batch, hoopgen.Shots],
) -> None:
    """Its trajectory comes down through the ring's plane at that depth and to that side."""
    batch, shots = recorded
    kind = kinds(shots.outcome, shots.counts, shots.first)
    found = measure(batch.states, shots, batch.parameters, ["depth", "left_right"])
    banked = np.flatnonzero((kind == Kind.BANK) & (shots.contacts == 1) & ~np.isnan(found["depth"]))
    assert len(banked) > 20
    for shot in banked[:50]:
        path = shots.trajectory(int(shot))
        contact, end = path.events["time"]
        low, high = (
            max(contact, contact + path.events["after"][0][5] / path.parameters["gravity"]),
            end,
        )
        for _ in range(60):
            middle = (low + high) / 2
            low, high = (middle, high) if path.at(middle)[2] > 0 else (low, middle)
        x, y, *_ = path.at(low)
        from_x, from_y = batch.states[shot, :2] / np.hypot(*batch.states[shot, :2])
        # Bisected to the last digits of the time, at some m/s.
        assert found["depth"][shot] == pytest.approx(-from_x * x - from_y * y, abs=1e-13)
        assert found["left_right"][shot] == pytest.approx(from_y * x - from_x * y, abs=1e-13)


def test_left_is_the_shooter_s_left_and_past_is_beyond_the_centre() -> None:
    given = {"height": 2.1336, "distance": 4.191, "angle": np.array([0.0, 1.0, -2.0])}
    left = hoopgen.release(7.0, 0.9, azimuth=0.1, **given)
    far = hoopgen.release(9.0, 0.9, **given)
    for states, check in ((left, "left_right"), (far, "depth")):
        found = measure(states, hoopgen.simulate(states))
        assert np.all(found[check] > 0.1)
    # Straight from the shooter's place there is no side.
    np.testing.assert_allclose(found["left_right"], 0.0, rtol=0, atol=32 * EPS)


def test_the_state_of_a_shot_capped_at_one_contact_is_that_after_it(
    recorded: tuple[Batch, hoopgen.Shots],
) -> None:
    """The flight off the board starts there."""
    batch, shots = recorded
    touched = np.flatnonzero(shots.contacts > 0)
    own = {name: value[touched] for name, value in batch.parameters.items()}
    capped = hoopgen.simulate(batch.states[touched], own, max_contacts=1)
    first = np.searchsorted(shots.events["shot"], touched)
    np.testing.assert_array_equal(capped.state, shots.events["after"][first])
    np.testing.assert_array_equal(capped.time, shots.events["time"][first])


# Apex, end and floor


def test_the_apex_is_the_highest_place_up_to_the_first_contact(
    recorded: tuple[Batch, hoopgen.Shots],
) -> None:
    """No place on the path is higher, and one is as high up to g dt²/8."""
    batch, shots = recorded
    apex = measure(batch.states, shots, batch.parameters, ["apex"])["apex"]
    steps, before = 400, 0
    for shot in range(600):
        path = shots.trajectory(shot)
        if shots.outcome[shot] == hoopgen.Outcome.INVALID or not len(path.events):
            continue
        first = path.events["time"][0]
        times = np.linspace(0.0, first, steps + 1)
        x, y, z, vx, vy, vz, *_ = path.release
        heights = (
            hoop.flight(times, x, y, z, vx, vy, vz, path.parameters["gravity"])[2] + RING_HEIGHT
        )
        coarse = path.parameters["gravity"] * (first / steps) ** 2 / 8
        roundings = (
            8 * EPS * (RING_HEIGHT + abs(vz) * first + path.parameters["gravity"] * first**2)
        )
        assert heights.max() - roundings <= apex[shot] <= heights.max() + coarse + roundings
        before += first < vz / path.parameters["gravity"]
    assert before > 20, "some balls touch something on their way up"


def test_a_short_shot_has_the_apex_of_its_flight() -> None:
    state = [1.0, 0.0, -1.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0]
    found = measure(state, hoopgen.simulate(state), names=["apex", "end_x", "floor_x"])
    assert found["apex"][0] == pytest.approx(RING_HEIGHT - 1.0 + 4.0 / (2 * 9.81), rel=2 * EPS)
    assert np.isnan(found["end_x"][0])
    assert found["floor_x"][0] == 1.0


def test_a_ball_thrown_down_is_highest_in_the_hand() -> None:
    state = [1.0, 0.0, -0.3, 0.0, 0.0, -2.0, 0.0, 0.0, 0.0]
    assert measure(state, hoopgen.simulate(state), names=["apex"])["apex"] == RING_HEIGHT - 0.3


def test_the_end_is_the_state_at_the_end_plane(recorded: tuple[Batch, hoopgen.Shots]) -> None:
    batch, shots = recorded
    found = measure(batch.states, shots, batch.parameters)
    ended = np.isin(shots.outcome, [hoopgen.Outcome.MADE, hoopgen.Outcome.MISSED])
    for name, k in {"x": 0, "y": 1, "vx": 3, "vy": 4, "vz": 5}.items():
        expected = np.where(ended, shots.state[:, k], np.nan)
        np.testing.assert_array_equal(found[f"end_{name}"], expected)


def test_the_floor_is_where_the_flight_from_the_end_comes_to_it(
    recorded: tuple[Batch, hoopgen.Shots],
) -> None:
    """At that time Eq. 3 has the ball on the floor, at that place, at that velocity."""
    batch, shots = recorded
    found = measure(batch.states, shots, batch.parameters)
    lands = np.isin(
        shots.outcome,
        [hoopgen.Outcome.MADE, hoopgen.Outcome.MISSED, hoopgen.Outcome.SHORT],
    )
    x, y, z, vx, vy, vz, *_ = shots.state.T
    level = batch.parameters["ball_radius"] - RING_HEIGHT
    gravity = batch.parameters["gravity"]
    # Released below the floor and never above it, a short one does not come to it.
    lands &= (z > level) | (vz > 0) & (vz**2 / (2 * gravity) > level - z)
    assert np.array_equal(~np.isnan(found["floor_x"]), lands)
    fall = (found["floor_time"] - shots.time)[lands]
    moved = hoop.flight(fall, *(c[lands] for c in (x, y, z, vx, vy, vz)), gravity[lands])
    speed = np.abs(shots.state[lands, 3:6]).sum(axis=1) + gravity[lands] * fall
    # The difference of two times has lost the digits of the larger.
    error = 8 * EPS * (RING_HEIGHT + speed * (1 + found["floor_time"][lands]))
    for name, k in {"x": 0, "y": 1, "vx": 3, "vy": 4, "vz": 5}.items():
        assert np.all(
            np.abs(moved[k] - found[f"floor_{name}"][lands]) <= error * (1 + gravity[lands])
        )
    assert np.all(np.abs(moved[2] - level[lands]) <= error * (1 + gravity[lands]))
    assert np.all(found["floor_vz"][lands] <= 0)


# Clearance


def _path_distance(
    batch: Batch, shots: hoopgen.Shots, shot: int, steps: int
) -> tuple[float, float]:
    """Return the least distance of ball and wire at many places of a path, and its possible error.

    The true least can be less by what the fastest ball moves in half a step.
    """
    path = shots.trajectory(shot)
    times = np.linspace(0.0, path.duration, steps)
    states = path.at(times)
    sizes = {name: value[shot] for name, value in batch.parameters.items()}
    off = np.hypot(np.hypot(*states[:, :2].T) - sizes["ring_radius"], states[:, 2])
    fastest = np.linalg.norm(states[:, 3:6], axis=1).max() + sizes["gravity"] * times[1]
    least = off.min() - sizes["ball_radius"] - sizes["wire_radius"]
    return least, fastest * times[1] / 2


def test_the_clearance_is_the_least_distance_on_the_whole_path(
    recorded: tuple[Batch, hoopgen.Shots],
) -> None:
    batch, shots = recorded
    clearance = measure(batch.states, shots, batch.parameters, ["clearance"])["clearance"]
    clear = np.flatnonzero((shots.counts[:, RING] == 0) & (shots.time > 0))
    around = clear[shots.contacts[clear] > 0]
    assert len(around) > 100
    for shot in np.concatenate([clear[:300], around[:300]]):
        least, coarse = _path_distance(batch, shots, int(shot), 1000)
        assert least - coarse <= clearance[shot] <= least + 1e-12, shot


def test_the_clearance_is_zero_just_where_the_ring_was_touched(
    recorded: tuple[Batch, hoopgen.Shots],
) -> None:
    batch, shots = recorded
    clearance = measure(batch.states, shots, batch.parameters, ["clearance"])["clearance"]
    touched = shots.counts[:, RING] > 0
    assert np.all(clearance[touched] == 0)
    away = ~touched & (shots.outcome != hoopgen.Outcome.INVALID)
    assert np.all(clearance[away] > 0)


def test_the_path_of_a_capped_shot_ends_at_its_last_contact() -> None:
    """Off the board alone: what it would come to later is not on its path."""
    state = hoopgen.release(7.2, 0.95, height=2.1, distance=3.5)
    whole, capped = hoopgen.simulate(state), hoopgen.simulate(state, max_contacts=1)
    assert whole.first[0] == capped.first[0] == BOARD
    recorded = hoopgen.simulate(state, max_contacts=1, record=True)
    one = Batch(state[None], {n: np.array([v]) for n, v in hoopgen.PAPER.items()})
    least, coarse = _path_distance(one, recorded, 0, 5000)
    found = measure(state, capped, names=["clearance"])["clearance"][0]
    assert least - coarse <= found <= least + 1e-12
    assert measure(state, whole, names=["clearance"])["clearance"][0] < found


# All of them


def _some(mixed: Batch) -> Batch:
    return mixed.take(np.random.default_rng(6).permutation(len(mixed))[:400])


def _equal(
    left: Mapping[str, Floats], right: Mapping[str, Floats], rows: Any = slice(None)
) -> None:
    assert left.keys() == right.keys()
    for name in left:
        np.testing.assert_array_equal(left[name][rows], right[name][rows], err_msg=name)


@pytest.mark.slow
def test_each_shot_is_measured_on_its_own(mixed: Batch, monkeypatch: pytest.MonkeyPatch) -> None:
    """Whatever the blocks; with its own parameters given as arrays or as numbers."""
    batch = _some(mixed)
    shots = hoopgen.simulate(batch.states, batch.parameters)
    whole = measure(batch.states, shots, batch.parameters)
    monkeypatch.setattr(measures, "BLOCK", 7)
    _equal(measure(batch.states, shots, batch.parameters), whole)
    for shot in range(0, len(batch), 13):
        own = {n: float(v[shot]) if np.ndim(v) else v for n, v in batch.parameters.items()}
        alone = measure(batch.states[shot], hoopgen.simulate(batch.states[shot], own), own)
        _equal({n: v[0] for n, v in alone.items()}, {n: v[shot] for n, v in whole.items()}, ...)


def test_a_bad_row_is_nan_and_does_not_disturb_the_others(mixed: Batch) -> None:
    batch = _some(mixed)
    plain = measure(
        batch.states, hoopgen.simulate(batch.states, batch.parameters), batch.parameters
    )
    states = np.array(batch.states)
    states[3, 4] = np.nan
    states[50] = [0.235, 0, 0, 0, 0, 0, 0, 0, 0]  # inside the wire
    states[60, 3:6] = 1e300
    restitution = np.full(len(states), 0.7)
    restitution[70] = 2.0
    own = batch.parameters | {
        "restitution": np.where(restitution > 1, 2.0, batch.parameters["restitution"])
    }
    shots = hoopgen.simulate(states, own)
    found = measure(states, shots, own)
    bad = [3, 50, 70]
    assert np.all(shots.outcome[bad] == hoopgen.Outcome.INVALID)
    assert all(np.isnan(column[bad]).all() for column in found.values())
    others = np.setdiff1d(np.arange(len(states)), [*bad, 60])
    _equal(found, plain, others)


def test_no_shots_have_no_measures() -> None:
    states = np.empty((0, 9))
    found = measure(states, hoopgen.simulate(states))
    assert list(found) == list(MEASURES)
    assert all(column.shape == (0,) for column in found.values())


def test_only_what_is_wanted_is_asked_for_and_computed(monkeypatch: pytest.MonkeyPatch) -> None:
    """The fields that a measure names are enough; nothing is simulated again for what is not."""
    state = hoopgen.release(7.2, 0.9, height=2.1336, distance=4.191)
    whole = measure(state, hoopgen.simulate(state))
    for name, each in MEASURES.items():
        shots = hoopgen.simulate(state, fields=each.fields)
        _equal(measure(state, shots, names=[name]), {name: whole[name]})
    shots = hoopgen.simulate(state, fields=("outcome",))
    with pytest.raises(AttributeError, match="state"):
        measure(state, shots, names=["floor_x"])

    def never(*arguments: Any, **options: Any) -> None:
        raise AssertionError

    monkeypatch.setattr(measure_context, "simulate", never)
    shots = hoopgen.simulate(state)
    assert shots.contacts[0] > 0
    measure(state, shots, names=["end_x", "floor_time"])
    assert measure(state, shots, names=[]) == {}


def test_every_measure_says_what_it_is() -> None:
    for name, each in MEASURES.items():
        assert each.name == name
        assert each.unit in ("m", "rad", "s", "m/s")
        assert each.label
        assert each.summary.endswith(".")
    wanted = {"entry_angle", "depth", "left_right", "apex", "clearance", "end_x", "floor_vz"}
    assert wanted <= set(MEASURES)


def test_wrong_arguments_are_named() -> None:
    state = hoopgen.release(7.2, 0.9, height=2.1336, distance=4.191)
    shots = hoopgen.simulate(state)
    with pytest.raises(ValueError, match=r"^names: unknown entry\. One of entry_angle, "):
        measure(state, shots, names=["entry"])
    with pytest.raises(ValueError, match=r"^states: expected the 1 releases of shots, got 2$"):
        measure(np.stack([state, state]), shots)
    with pytest.raises(ValueError, match="parameters: unknown weight"):
        measure(state, shots, {"weight": 9.81})
