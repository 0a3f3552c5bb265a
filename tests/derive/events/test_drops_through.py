"""Flights that are told, in single precision, to drop through the ring: none of them touches it."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from benchmarks.workloads import WORKLOADS
from hoopgen import PAPER
from tests.codegen.test_kernels import evaluate_numpy
from tests.helpers.effort import occurrences, trials
from tests.helpers.kernel_arguments import of_flight

Floats = NDArray[np.float64]
GRAVITY, RADIUS = PAPER["gravity"], PAPER["ring_radius"]
REACH = PAPER["ball_radius"] + PAPER["wire_radius"]


def drops(
    states: Floats, until: Floats | float, off: float = 0.0, **others: float
) -> NDArray[np.bool_]:
    """Return where flights from such states certainly drop through the ring, of other sizes."""
    taken = of_flight(states, PAPER | others, until, off)
    (unproved,) = evaluate_numpy("ring_drops_through", taken, len(states))
    return ~np.asarray(unproved, bool)


def through(place: Floats, velocity: Floats, time: Floats) -> Floats:
    """Return the states, so much time earlier, of balls at such places and velocities."""
    before = place - velocity * time[:, None]
    before[:, 2] -= GRAVITY / 2 * time**2
    moving = velocity.copy()
    moving[:, 2] += GRAVITY * time
    return np.hstack([before, moving, np.zeros_like(before)])


def nearest(states: Floats, until: Floats) -> Floats:
    """Return the least distance of flights from the ring's circle, on a fine grid of times."""
    x, y, z, vx, vy, vz = states.T[:6]
    times = until * np.linspace(0, 1, 2001)[:, None] ** 0.5  # finer towards the end
    rho = np.hypot(x + vx * times, y + vy * times)
    height = z + (vz - GRAVITY / 2 * times) * times
    return np.asarray(np.hypot(rho - RADIUS, height).min(axis=0))


def arrivals(rows: int) -> tuple[Floats, Floats, Floats]:
    """Return places near the hole, velocities there and times since the release."""
    drawn = np.random.default_rng(3)
    turn, around = drawn.uniform(0, 2 * np.pi, (2, rows))
    out, height = 0.4 * np.sqrt(drawn.random(rows)), drawn.uniform(-0.2, 0.2, rows)
    sideways, falling = drawn.uniform(0.2, 6, rows), drawn.uniform(-8, -1, rows)
    place = np.stack([out * np.cos(turn), out * np.sin(turn), height], 1)
    velocity = np.stack([sideways * np.cos(around), sideways * np.sin(around), falling], 1)
    return place, velocity, drawn.uniform(0.2, 1.5, rows)


def test_no_flight_that_drops_through_comes_to_the_wire() -> None:
    place, velocity, time = arrivals(trials(40_000))
    states = through(place, velocity, time)
    through_hole = drops(states, time)
    assert np.count_nonzero(through_hole) > occurrences(500)
    assert nearest(states[through_hole], time[through_hole]).min() > REACH


def test_a_flight_that_touches_by_less_than_the_roundings_does_not_drop_through() -> None:
    """At the horizon it overlaps the far side of the wire by 1e-12 to 1e-8 m, in its plane.

    A ball of a millimetre, because the inflation of a larger one exceeds most roundings.
    """
    drawn, rows = np.random.default_rng(5), trials(20_000)
    around, speed = drawn.uniform(0, 2 * np.pi, rows), drawn.uniform(1.5, 3.0, rows)
    direction = np.stack([np.cos(around), np.sin(around), 0 * around], 1)
    velocity = speed[:, None] * direction
    velocity[:, 2] = drawn.uniform(-7, -5, rows)
    overlap = 10 ** drawn.uniform(-12, -8, rows)
    time = drawn.uniform(0.75, 0.9, rows)
    small = {"ball_radius": 1e-3, "wire_radius": 1e-4}
    for out in (overlap, -RADIUS / 2**9 + 0 * overlap):
        states = through((RADIUS - 1.1e-3 + out)[:, None] * direction, velocity, time)
        assert np.mean(drops(states, time, **small)) == (out is not overlap)


def test_swishes_drop_through_and_others_do_not() -> None:
    swishes = WORKLOADS[0].make(1000)
    vz, fall = swishes[:, 5], swishes[:, 2] + PAPER["end_depth"]
    until = (vz + np.sqrt(vz**2 + 2 * GRAVITY * fall)) / GRAVITY
    assert drops(swishes, until).all()
    assert not drops(swishes, until, off=1e-5).any()
    assert not drops(swishes, np.inf).any()
    assert not drops(np.full((1, 9), np.nan), 1.0).any()
    far = swishes * 1.0
    far[:, 0] += 50.0
    far[:, 3] *= far[:, 0] / swishes[:, 0]
    assert not drops(far, until).any()
    assert not drops(swishes * np.array([1, 1, 1, 1, 1, -1, 1, 1, 1.0]), until).any()
