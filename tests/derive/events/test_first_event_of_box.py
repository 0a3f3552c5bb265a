"""The first event of a flight beside a box, whose state is off by as much as decisions allow for.

As in `test_first_event.py`: the kernels of a whole flight get a state and bounds on its errors, and
the judge another state within these. Where the kernels find nothing undecided, both have the same
event.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory
from types import ModuleType
from typing import Any

import numpy as np
import pytest
from hoopgen.derive.errors.contact_frames import CARRIED
from numpy.typing import NDArray

from hoopgen.engine.numpy_flights import Room
from hoopgen.simulation.engine import Engine
from tests.helpers.compiled import load_module
from tests.helpers.derived import engine_of
from tests.helpers.effort import exceptions, occurrences, trials
from tests.helpers.scenes.block import BLOCK

pytest.importorskip("flint")

Floats = NDArray[np.float64]
Family = Callable[[np.random.Generator, int], tuple[Floats, Floats, Floats]]
STATE = ("x", "y", "z", "vx", "vy", "vz")
RING, BOX = 0, 1
SIZES = {p.name: p.default for p in BLOCK.parameters}
FACES = [f"{side}_{axis}" for side in ("from", "to") for axis in "xyz"]
R_B, R_H, G = SIZES["ball_radius"], SIZES["ring_radius"], SIZES["gravity"]
R = R_B + SIZES["wire_radius"]
BOARD = {"from_x": -0.3937, "to_x": -0.381, "from_y": -0.9144, "to_y": 0.9144} | {
    "from_z": -0.1524,
    "to_z": 0.9144,
}
"""A board behind the ring."""
STEPS = (2.0**-46, 2.0**-38, 2.0**-30)
"""Errors of the place that are tried, m; those of the velocity are up to 64 times as large."""


@cache
def block() -> tuple[Engine, ModuleType]:
    """Return the scene's engine, and its generated module."""
    with TemporaryDirectory() as folder:
        engine = engine_of(BLOCK, Path(folder))
        return engine, load_module(Path(folder) / "block.py")


def on_box(
    rng: np.random.Generator, count: int, sizes: Mapping[str, float] = SIZES
) -> tuple[Floats, Floats]:
    """Return places at contacts, a hundredth of a millimetre or more from seams, and normals."""
    low, high = (np.array([sizes[n] for n in names])[:, None] for names in (FACES[:3], FACES[3:]))
    side = rng.choice([-1, 0, 1], (3, count))
    side[0, ~side.any(axis=0)] = 1
    inner = low + 1e-4 + (high - low - 2e-4) * rng.random((3, count))
    away = side * 10 ** rng.uniform(-2, 0, (3, count))
    normal = away / np.sqrt((away**2).sum(axis=0))
    return np.select([side < 0, side > 0], [low, high], inner) + R_B * normal, normal


def _speeds(rng: np.random.Generator, count: int) -> Floats:
    return rng.normal(0, 1, (3, count)) * 10 ** rng.uniform(-1, 0.7, count)


def _graze(rng: np.random.Generator, count: int) -> tuple[Floats, Floats, Floats]:
    place, normal = on_box(rng, count)
    velocity = _speeds(rng, count)
    velocity -= np.sum(velocity * normal, axis=0) * normal
    return np.array([*place, *velocity]), 10 ** rng.uniform(-3, 0, count), normal


def _slow(rng: np.random.Generator, count: int) -> tuple[Floats, Floats, Floats]:
    there, time, normal = _graze(rng, count)
    there[3:] -= normal * 10 ** rng.uniform(-10, -3, count)
    return there, time, normal


def _seam(rng: np.random.Generator, count: int) -> tuple[Floats, Floats, Floats]:
    """Return contacts within errors of a seam, grazing or not."""
    there, time, normal = _graze(rng, count)
    axis, row = rng.integers(0, 3, count), np.arange(count)
    sides = np.array([SIZES[n] for n in FACES]).reshape(2, 3)[rng.integers(0, 2, count), axis]
    there[axis, row] = sides
    e = there[:3] - np.clip(there[:3], *np.array([SIZES[n] for n in FACES]).reshape(2, 3, 1))
    size = np.sqrt((e**2).sum(axis=0))
    there[:3] += e * (R_B / np.where(size > 0, size, 1) - 1)
    there[3:] -= normal * 10 ** rng.uniform(-6, 0.5, count)
    return there, time, np.eye(3)[axis].T


def _tie_with_end(rng: np.random.Generator, count: int) -> tuple[Floats, Floats, Floats]:
    place, normal = on_box(rng, count, SIZES | {"from_z": 0.3, "to_z": 0.3 + 2e-4})
    velocity = _speeds(rng, count)
    velocity -= normal * np.maximum(0, np.sum(velocity * normal, axis=0)) * 2
    velocity[2] = -np.abs(velocity[2])
    place[2] = 0.3
    e = place[:2] - np.clip(place[:2], *np.array([SIZES[n] for n in FACES]).reshape(2, 3, 1)[:, :2])
    size = np.hypot(*e)
    place[:2] += e * (R_B / np.where(size > 0, size, 1) - 1)
    return np.array([*place, *velocity]), 10 ** rng.uniform(-3, 0, count), normal


def _tie_with_ring(rng: np.random.Generator, count: int) -> tuple[Floats, Floats, Floats]:
    x = np.full(count, BOARD["to_x"] + R_B)
    y = rng.uniform(-0.24, 0.24, count)
    z = np.sqrt(R**2 - (np.hypot(x, y) - R_H) ** 2) * rng.choice([-1, 1], count)
    velocity = _speeds(rng, count)
    velocity[0] = -np.abs(velocity[0])
    velocity[2] = -np.sign(z) * np.abs(velocity[2])
    off = np.array([1.0 + 0 * x, 0 * x, 0 * x])
    return np.array([x, y, z, *velocity]), 10 ** rng.uniform(-3, 0, count), off


def _return(rng: np.random.Generator, count: int) -> tuple[Floats, Floats, Floats]:
    place, normal = on_box(rng, count)
    velocity = _speeds(rng, count)
    velocity -= np.sum(velocity * normal, axis=0) * normal
    velocity += 10 ** rng.uniform(-9, 0, count) * normal
    return np.array([*place, *velocity]), np.zeros(count), 0 * normal


FAMILIES: dict[str, tuple[Family, int, dict[str, float]]] = {
    "graze": (_graze, -1, {}),
    "slow": (_slow, -1, {}),
    "seam": (_seam, -1, {}),
    "tie with the end": (_tie_with_end, -1, {"depth": -0.3}),
    "tie with the ring": (_tie_with_ring, -1, BOARD),
    "return": (_return, BOX, {}),
}
"""Flights with a close decision: what makes them, the surface that was left, and the sizes."""


def events(start: Floats, last: int, errors: tuple[Floats, Floats], given: Any) -> Any:
    """Return the event of each flight, its outcome at an end, and whether it is uncertain."""
    _, kernels = block()
    count = start.shape[1]
    columns: dict[str, Any] = dict(zip(STATE, start, strict=True))
    columns |= {symbol.name: np.zeros(count, np.float32) for symbol in CARRIED}
    columns["position_bound"], columns["velocity_bound"] = map(np.float32, errors)
    columns |= {name: np.zeros(count) for name in ("clock", "contacts", "uncertain")}
    columns |= {"clock_error": np.zeros(count, np.float32), "most_contacts": 40.0}
    columns |= {kernels.VARIABLES[name]: value for name, value in given.items()}
    columns |= {"last": np.full(count, float(last)), "time_limit": np.inf}
    with np.errstate(all="ignore"):
        kernels.detect_bounded(columns, count, Room(kernels, count))
    bodies = np.where(columns["touches"], columns["which"], -1.0)
    return bodies, columns["outcome"], columns["uncertain"] > 0


def _within(state: Floats, given: Mapping[str, float]) -> Any:
    """Return whether a ball overlaps the box or the ring."""
    low, high = np.array([given[n] for n in FACES]).reshape(2, 3, 1)
    beyond = state[:3] - np.clip(state[:3], low, high)
    ring = np.hypot(np.hypot(*state[:2]) - R_H, state[2])
    return ((beyond**2).sum(axis=0) < R_B**2) | (ring < R)


@pytest.mark.parametrize("name", FAMILIES)
def test_a_flight_with_no_close_decision_has_the_event_of_the_true_one(name: str) -> None:
    """Beyond a thousand errors from a draw most are decided."""
    make, last, changes = FAMILIES[name]
    rng, count = np.random.default_rng(sum(map(ord, name))), trials(600)
    there, time, off = make(rng, count)
    given = SIZES | changes
    true = np.array([*(there[:3] - there[3:] * time), *there[3:]])
    true[2] -= G * time**2 / 2
    true[5] += G * time
    place = rng.choice(STEPS, count)
    speed = place * rng.choice([1.0, 8.0, 64.0], count)
    share = 10 ** rng.uniform(-1, 5, count) * rng.choice([-1, 1], count)
    true[:3] += share * (place + speed * time) * off
    signs = rng.choice([-1.0, 1.0], (6, count)) * rng.choice([0, 0.5, 1.0], (6, count))
    if last == BOX:  # on the box both times
        signs[:3] *= 0
    computed = true + signs * 0.999 * np.array([place] * 3 + [speed] * 3)
    # A true ball is inside no body; where it left one, its place counts as on it.
    inside = _within(true, given) & (last != BOX)
    bodies, outcome, uncertain = events(computed, last, (place, speed), given)
    states = np.zeros((count, 9))
    states[:, :6] = true.T
    leaving = None if last < 0 else np.full(count, last)
    judged = block()[0].certify(states, given, leaving=leaving, max_contacts=1, processes=1)
    own = judged.decided & (judged.outcome != BLOCK.outcomes["invalid"]) & ~inside
    capped = BLOCK.outcomes["capped"]
    first = np.where(judged.outcome == capped, judged.first, -1)
    ends = np.where(bodies >= 0, capped, outcome)
    same = (first == bodies) & (judged.outcome == ends)
    decided = own & ~uncertain
    assert np.all(same[decided]), (name, np.flatnonzero(decided & ~same)[:3])
    assert np.count_nonzero(decided) >= occurrences(75)
    far = own & (np.abs(share) > 1e3)
    assert np.count_nonzero(far & uncertain) <= exceptions(0.55, np.count_nonzero(far))
