"""The first event of a flight whose state is off by as much as decisions allow for.

The kernels of a whole flight get a state and bounds on its errors, and `certify` another state
within these. Flights are drawn so that some decision is close: a graze, a tie, an edge, a start at
a plane. Where the kernels find nothing undecided, both have the same event.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hoopgen.derive.errors.contact_frames import CARRIED
from hoopgen.generated.numpy import hoop
from numpy.typing import NDArray

from hoopgen import COURT, HOOP, PAPER, Outcome, certify
from hoopgen.engine.numpy_flights import Room
from hoopgen.simulation.engine import Engine
from tests.helpers.effort import exceptions, occurrences, trials

pytest.importorskip("flint")

Floats = NDArray[np.float64]
STATE = ("x", "y", "z", "vx", "vy", "vz")
RING, BOARD, BRIDGE, END = range(4)
R_H, R = PAPER["ring_radius"], PAPER["ball_radius"] + PAPER["wire_radius"]
FRONT, LOW = PAPER["ball_radius"] - PAPER["board_distance"], -PAPER["end_depth"]
G = PAPER["gravity"]
STEPS = (2.0**-46, 2.0**-38, 2.0**-30)
"""Errors of the place that are tried, m; those of the velocity are up to 64 times as large."""


@dataclass
class Flights:
    """States as columns, and what is close.

    Attributes
    ----------
    there
        Place and velocity at the time of the close decision, (6, n).
    time
        That time, s.
    apart
        The direction in which the place is off what would be a draw, (3, n).
    last
        The surface that was touched last.
    parameters
        Parameters that differ from `PAPER`.
    """

    there: Floats
    time: Floats
    apart: Floats
    last: int = -1
    parameters: Mapping[str, float] = field(default_factory=dict)


Family = Callable[[np.random.Generator, int], Flights]
FAMILIES: dict[str, Family] = {}


def family(make: Family) -> Family:
    """Add a family of flights by its name."""
    FAMILIES[make.__name__.strip("_")] = make
    return make


def _speeds(rng: np.random.Generator, count: int) -> Floats:
    return rng.normal(0, 1, (3, count)) * 10 ** rng.uniform(-1, 0.7, count)


def _times(rng: np.random.Generator, count: int) -> Floats:
    return np.asarray(10 ** rng.uniform(-3, 0, count))


def _on_ring(about: Floats, around: Floats) -> tuple[Floats, Floats]:
    """Return places on the ring, and its normals there."""
    normal = np.array([np.cos(about) * np.cos(around), np.cos(about) * np.sin(around)])
    normal = np.array([*normal, np.sin(about)])
    circle = R_H * np.array([np.cos(around), np.sin(around), 0 * around])
    return circle + R * normal, normal


@family
def _graze_of_the_ring(rng: np.random.Generator, count: int) -> Flights:
    place, normal = _on_ring(*rng.uniform(0, 2 * np.pi, (2, count)))
    velocity = _speeds(rng, count)
    velocity -= np.sum(velocity * normal, axis=0) * normal
    return Flights(np.array([*place, *velocity]), _times(rng, count), normal)


@family
def _tie_of_ring_and_board(rng: np.random.Generator, count: int) -> Flights:
    x = np.full(count, FRONT)
    y = rng.uniform(-0.24, 0.24, count)
    z = np.sqrt(R**2 - (np.hypot(x, y) - R_H) ** 2) * rng.choice([-1, 1], count)
    velocity = _speeds(rng, count)
    velocity[0] = -np.abs(velocity[0])
    velocity[2] = -np.sign(z) * np.abs(velocity[2])
    off = np.array([1.0 + 0 * x, 0 * x, 0 * x])
    return Flights(np.array([x, y, z, *velocity]), _times(rng, count), off)


@family
def _tie_of_board_and_end(rng: np.random.Generator, count: int) -> Flights:
    velocity = _speeds(rng, count)
    velocity[[0, 2]] = -np.abs(velocity[[0, 2]])
    y = rng.uniform(0.4, 0.8, count)
    off = np.array([1 + 0 * y, 0 * y, 0 * y])
    return Flights(np.array([FRONT + 0 * y, y, LOW + 0 * y, *velocity]), _times(rng, count), off)


@family
def _edge_of_the_board(rng: np.random.Generator, count: int) -> Flights:
    y = rng.choice([-1, 1], count) * PAPER["board_half_width"]
    z = rng.uniform(0.2, 0.8, count)
    off = np.array([0 * y, np.sign(y), 0 * y])
    high = rng.random(count) < 0.5
    y, z = np.where(high, rng.uniform(-0.8, 0.8, count), y), np.where(high, PAPER["board_top"], z)
    off = np.where(high, np.array([0, 0, 1])[:, None], off)
    velocity = _speeds(rng, count)
    velocity[0] = -np.abs(velocity[0])
    return Flights(np.array([FRONT + 0 * y, y, z, *velocity]), _times(rng, count), off)


@family
def _edge_of_the_bridge(rng: np.random.Generator, count: int) -> Flights:
    y = rng.choice([-1, 1], count) * PAPER["bridge_half_width"]
    x = rng.uniform(FRONT + 0.001, -0.23, count)
    off = np.array([0 * y, np.sign(y), 0 * y])
    seam = rng.random(count) < 0.5
    inner = rng.uniform(-0.07, 0.07, count)
    circle = np.array([-np.sqrt(R_H**2 - inner**2), inner])
    x, y = np.where(seam, circle[0], x), np.where(seam, inner, y)
    off = np.where(seam, np.array([*circle / R_H, 0 * y]), off)
    velocity = _speeds(rng, count)
    velocity[2] = -np.abs(velocity[2])
    return Flights(np.array([x, y, R + 0 * y, *velocity]), _times(rng, count), off)


@family
def _edge_of_the_target(rng: np.random.Generator, count: int) -> Flights:
    around = rng.uniform(0, 2 * np.pi, count)
    out = np.array([np.cos(around), np.sin(around), 0 * around])
    velocity = _speeds(rng, count)
    velocity[2] = -np.abs(velocity[2])
    place = R_H * out
    place[2] = -0.5
    there = np.array([*place, *velocity])
    return Flights(there, 10 ** rng.uniform(-3, -1, count), out, parameters={"end_depth": 0.5})


def _at_plane(rng: np.random.Generator, count: int, height: float, y: Floats) -> Flights:
    velocity = _speeds(rng, count)
    velocity[0] = np.abs(velocity[0])
    off = np.array([0 * y, 0 * y, 1 + 0 * y])
    return Flights(np.array([FRONT + 0 * y, y, height + 0 * y, *velocity]), 0 * y, off, last=BOARD)


@family
def _start_at_the_end_plane(rng: np.random.Generator, count: int) -> Flights:
    return _at_plane(rng, count, LOW, rng.uniform(0.4, 0.8, count))


@family
def _start_at_the_bridge(rng: np.random.Generator, count: int) -> Flights:
    return _at_plane(rng, count, R, rng.uniform(-0.07, 0.07, count))


@family
def _start_at_the_board(rng: np.random.Generator, count: int) -> Flights:
    y, velocity = rng.uniform(-0.07, 0.07, count), _speeds(rng, count)
    velocity[2] = np.abs(velocity[2])
    off = np.array([1 + 0 * y, 0 * y, 0 * y])
    return Flights(np.array([FRONT + 0 * y, y, R + 0 * y, *velocity]), 0 * y, off, last=BRIDGE)


@family
def _graze_of_the_end_plane(rng: np.random.Generator, count: int) -> Flights:
    velocity = _speeds(rng, count)
    velocity[2] = 0
    x, y = rng.uniform(0.5, 1, (2, count))
    off = np.array([0 * y, 0 * y, 1 + 0 * y])
    return Flights(np.array([x, y, LOW + 0 * y, *velocity]), _times(rng, count), off)


@family
def _slowly_to_the_board(rng: np.random.Generator, count: int) -> Flights:
    y, z = rng.uniform(-0.8, 0.8, count), rng.uniform(0.2, 0.8, count)
    velocity = _speeds(rng, count)
    velocity[0] = -(10 ** rng.uniform(-12, -5, count))
    off = np.array([1 + 0 * y, 0 * y, 0 * y])
    return Flights(np.array([FRONT + 0 * y, y, z, *velocity]), _times(rng, count), off)


@family
def _return_to_the_ring(rng: np.random.Generator, count: int) -> Flights:
    place, normal = _on_ring(*rng.uniform(0, 2 * np.pi, (2, count)))
    velocity = _speeds(rng, count)
    along = velocity - np.sum(velocity * normal, axis=0) * normal
    velocity = along + 10 ** rng.uniform(-9, 0, count) * normal
    return Flights(np.array([*place, *velocity]), np.zeros(count), 0 * normal, last=RING)


def started(flights: Flights) -> Floats:
    """Return the states at the start, (6, n)."""
    place, velocity, t = flights.there[:3], flights.there[3:], flights.time
    start = np.array([*(place - velocity * t), *velocity])
    start[2] -= G * t**2 / 2
    start[5] += G * t
    return start


def events(start: Floats, last: int, errors: tuple[Floats, Floats], given: Any) -> Any:
    """Return the event of each flight, its outcome at an end, and whether it is uncertain."""
    count = start.shape[1]
    columns: dict[str, Any] = dict(zip(STATE, start, strict=True)) | {"last": np.full(count, last)}
    columns |= {symbol.name: np.zeros(count, np.float32) for symbol in CARRIED}
    columns["position_bound"], columns["velocity_bound"] = map(np.float32, errors)
    columns |= {name: np.zeros(count) for name in ("clock", "contacts", "uncertain")}
    columns |= {"clock_error": np.zeros(count, np.float32), "most_contacts": 40.0}
    columns |= {hoop.VARIABLES[name]: value for name, value in given.items()}
    columns["last"] = columns["last"].astype(float)
    columns["time_limit"] = np.inf
    with np.errstate(all="ignore"):
        hoop.detect_bounded(columns, count, Room(hoop, count))
    bodies = np.where(columns["touches"], columns["which"], -1.0)
    return bodies, columns["outcome"], columns["uncertain"] > 0


@pytest.mark.parametrize("name", FAMILIES)
def test_a_flight_with_no_close_decision_has_the_event_of_the_true_one(name: str) -> None:
    """Beyond a thousand errors from a draw most are decided."""
    rng, count = np.random.default_rng(sum(map(ord, name))), trials(600)
    flights = FAMILIES[name](rng, count)
    given = {**PAPER, **flights.parameters}
    place = rng.choice(STEPS, count)
    speed = place * rng.choice([1.0, 8.0, 64.0], count)
    total = place + speed * flights.time
    share = 10 ** rng.uniform(-1, 5, count) * rng.choice([-1, 1], count)
    true = started(flights)
    true[:3] += share * total * flights.apart
    signs = rng.choice([-1.0, 1.0], (6, count)) * rng.choice([0, 0.5, 1.0], (6, count))
    if flights.last == RING and not np.any(flights.apart):  # on the ring both times
        signs[:3] *= 0
    computed = true + signs * 0.999 * np.array([place] * 3 + [speed] * 3)
    # A true ball is inside no ring; where it left one, its place counts as on it.
    inside = (np.hypot(np.hypot(*true[:2]) - R_H, true[2]) < R) & (flights.last != RING)
    bodies, outcome, uncertain = events(computed, flights.last, (place, speed), given)
    leaving = None if flights.last < 0 else flights.last
    states = np.zeros((count, 9))
    states[:, :6] = true.T
    judged = certify(
        states,
        given,
        leaving=None if leaving is None else np.full(count, leaving),
        max_contacts=1,
        processes=1,
    )
    own = judged.decided & (judged.outcome != Outcome.INVALID)
    first = np.where(judged.outcome == Outcome.CAPPED, judged.first, -1)
    ends = np.where(bodies >= 0, Outcome.CAPPED, outcome)
    same = (first == bodies) & (judged.outcome == ends)
    decided = own & ~inside & ~uncertain
    assert np.all(same[decided]), (name, np.flatnonzero(decided & ~same)[:3])
    assert np.count_nonzero(decided) >= occurrences(count // 8)
    far = own & ~inside & (np.abs(share) > 1e3)
    assert np.count_nonzero(far & uncertain) <= exceptions(0.4, np.count_nonzero(far))


def at_the_height_of_the_end_plane(count: int) -> Floats:
    """Return shots that meet the board upwards at that height, and leave it downwards."""
    rng = np.random.default_rng(3)
    x, y = rng.uniform(0.3, 0.6, count), rng.uniform(0.55, 0.7, count)
    vx, rising = -rng.uniform(2, 3, count), rng.uniform(0.2, 1, count)
    states = np.zeros((count, 9))
    for row in range(count):
        time = Fraction(x[row]) - Fraction(PAPER["ball_radius"]) + Fraction(PAPER["board_distance"])
        time /= -Fraction(vx[row])
        vz = rising[row] + G * float(time)
        z = -Fraction(PAPER["end_depth"]) - (Fraction(vz) - Fraction(G) * time / 2) * time
        states[row, [0, 1, 2, 3, 5, 7]] = x[row], y[row], float(z), vx[row], vz, 50
    return states


ENGINES = {"hoop": lambda: HOOP, "court": lambda: COURT}


@pytest.fixture(scope="module", params=ENGINES)
def engine(request: pytest.FixtureRequest) -> Engine:
    """Return the engine of the article's scene, or of the whole hoop, whose ball may roll."""
    return ENGINES[request.param]()


def test_a_ball_that_leaves_the_board_at_the_height_of_the_end_plane_is_uncertain(
    engine: Engine,
) -> None:
    """On which side of that plane it is decides whether it misses or never comes to an end."""
    states = at_the_height_of_the_end_plane(trials(60, at_least=20))
    shots, judged = engine.simulate(states), engine.certify(states, processes=1)
    assert np.all(shots.uncertain)
    assert np.any(shots.outcome != judged.outcome)
    moved = states + np.array([0, 0, 1e-9, 0, 0, 0, 0, 0, 0])
    shots, judged = engine.simulate(moved), engine.certify(moved, processes=1)
    assert not np.any(shots.uncertain)
    assert np.all(shots.outcome == judged.outcome)
