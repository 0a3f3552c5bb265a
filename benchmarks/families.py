"""Shots that are hard on an event search, from a fixed seed: one family for each way to be hard.

Each is built backwards from the place that is hard: a state there is flown back to a release.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from benchmarks.workloads import SEED, WORKLOADS, States
from hoopgen import FIBA, NBA, PAPER

Floats = NDArray[np.float64]
Shots = tuple[States, Mapping[str, Any]]
"""States, and the parameters to fly them with."""

REACH = PAPER["ball_radius"] + PAPER["wire_radius"]
RING = PAPER["ring_radius"]
TURN = 2 * np.pi


@dataclass(frozen=True)
class Family:
    """Shots of a kind: a word on what is hard, and how to make n of them."""

    key: str
    label: str
    make: Callable[[int], Shots]
    workload: bool = False


def seeded(name: str) -> np.random.Generator:
    key = SEED + sum(ord(letter) << (8 * (place % 6)) for place, letter in enumerate(name))
    return np.random.Generator(np.random.Philox(key))


def tiny(random: np.random.Generator, n: int, low: float = -17, high: float = -3) -> Floats:
    """Numbers of either sign whose size is spread evenly over orders of magnitude."""
    return random.choice([-1.0, 1.0], n) * 10 ** random.uniform(low, high, n)


def spins(random: np.random.Generator, n: int) -> Floats:
    return random.normal(0, 10, (n, 3)) * random.integers(0, 2, (n, 1))


def back(position: Floats, velocity: Floats, spin: Floats, time: Floats) -> States:
    """Return the releases that lead to a position and a velocity after `time`."""
    fall = np.array([0.0, 0.0, PAPER["gravity"]])
    earlier = velocity + fall * time[:, None]
    start = position - time[:, None] * (velocity + fall * time[:, None] / 2)
    return np.concatenate([start, earlier, spin], axis=1)


def around(n: int) -> Shots:
    """Return shots from anywhere around, at any point near the hoop, of any speed."""
    random = seeded("around")
    target = random.uniform((-0.6, -0.6, -0.2), (0.5, 0.6, 0.6), (n, 3))
    time = random.uniform(0.1, 1.5, n)
    angle, distance = random.uniform(0, TURN, n), random.uniform(0, 6, n)
    start = np.stack(
        [
            np.maximum(distance * np.cos(angle), -0.25),
            distance * np.sin(angle),
            random.uniform(-1.5, 2.0, n),
        ],
        axis=1,
    )
    velocity = (target - start) / time[:, None]
    velocity[:, 2] += PAPER["gravity"] * time / 2
    return np.concatenate([start, velocity, spins(random, n)], axis=1), PAPER


def axis_drop(n: int) -> Shots:
    """Down the axis, where rho is 0 or hardly more."""
    random = seeded("axis drop")
    states = np.zeros((n, 9))
    states[:, :2] = np.stack([tiny(random, n, -300), tiny(random, n, -20)], axis=1)
    states[:, :2] *= random.integers(0, 2, (n, 2))
    states[:, 2] = random.uniform(0.2, 2, n)
    states[:, 3:5] = np.stack([tiny(random, n, -300), tiny(random, n, -20)], axis=1)
    states[:, 3:5] *= random.integers(0, 2, (n, 2))
    states[:, 5] = random.uniform(-2, 4, n)
    states[:, 6:] = spins(random, n)
    return states, PAPER


def drop(n: int) -> Shots:
    """Straight down, or nearly, anywhere over the ring and the bridge."""
    random = seeded("drop")
    states = np.zeros((n, 9))
    angle, distance = random.uniform(0, TURN, n), random.uniform(0, 0.4, n)
    states[:, 0] = np.maximum(distance * np.cos(angle), -0.25)
    states[:, 1] = distance * np.sin(angle) * random.integers(0, 2, n)
    states[:, 2] = random.uniform(0.2, 1.5, n)
    states[:, 3:5] = np.stack([tiny(random, n, -20), tiny(random, n, -20)], axis=1)
    states[:, 3:5] *= random.integers(0, 2, (n, 2))
    states[:, 6:] = spins(random, n)
    return states, PAPER


def in_plane(n: int) -> Shots:
    """Return shots in the hoop's plane of symmetry, where the octic factors."""
    random = seeded("in plane")
    target = random.uniform((-0.5, 0, 0.0), (0.4, 0, 0.4), (n, 3))
    time = random.uniform(0.3, 1.3, n)
    start = np.zeros((n, 3))
    start[:, 0], start[:, 2] = random.uniform(0.5, 6, n), random.uniform(-1.5, 1, n)
    velocity = (target - start) / time[:, None]
    velocity[:, 2] += PAPER["gravity"] * time / 2
    spin = np.zeros((n, 3))
    spin[:, 1] = random.normal(0, 15, n)
    return np.concatenate([start, velocity, spin], axis=1), PAPER


def tube(random: np.random.Generator, n: int, low: float, high: float) -> tuple[Floats, ...]:
    """Points where the ball touches the ring: position, normal, and the two directions along."""
    angle, height = random.uniform(0, TURN, n), random.uniform(low, high, n)
    out = np.stack([np.cos(angle), np.sin(angle), np.zeros(n)], axis=1)
    up = np.array([0.0, 0.0, 1.0])
    normal = np.cos(height)[:, None] * out + np.sin(height)[:, None] * up
    along = np.stack([-np.sin(angle), np.cos(angle), np.zeros(n)], axis=1)
    return RING * out + REACH * normal, normal, along, np.cross(normal, along)


def grazing(n: int) -> Shots:
    """Past the ring within 1e-12 m of touching it, on either side of it."""
    random = seeded("grazing")
    position, normal, along, across = tube(random, n, 0, np.pi)
    heading = random.uniform(0, TURN, n)[:, None]
    speed = random.uniform(1, 6, n)[:, None]
    velocity = speed * (np.cos(heading) * along + np.sin(heading) * across)
    position += tiny(random, n, -16, -12)[:, None] * normal
    time = random.uniform(0.005, 0.15, n)
    return back(position, velocity, spins(random, n), time), PAPER


def seam(n: int) -> Shots:
    """At the line where the bridge meets the ring."""
    random = seeded("seam")
    y = random.uniform(-1, 1, n) * PAPER["bridge_half_width"]
    rho = RING + tiny(random, n) * random.integers(0, 8, n).clip(0, 1)
    position = np.stack([-np.sqrt(rho**2 - y**2), y, np.full(n, REACH)], axis=1)
    velocity = random.normal(0, 1.5, (n, 3))
    velocity[:, 2] = -random.uniform(0.5, 5, n)
    return back(position, velocity, spins(random, n), random.uniform(0.01, 0.12, n)), PAPER


def edges(n: int) -> Shots:
    """At the backboard's four edges, and at the bridge's sides and its end at the board."""
    random = seeded("edges")
    board = PAPER["ball_radius"] - PAPER["board_distance"]
    half, bridge = PAPER["board_half_width"], PAPER["bridge_half_width"]
    y = random.uniform(-half, half, n)
    z = random.uniform(PAPER["board_bottom"], PAPER["board_top"], n)
    along = random.uniform(board, -RING, n)
    level = np.full(n, REACH)
    wall = np.full(n, board)
    side = random.choice([-1.0, 1.0], n)
    near = tiny(random, n) * random.integers(0, 8, n).clip(0, 1)
    choices = [
        np.stack([wall, side * half + near, z], axis=1),
        np.stack([wall, y, PAPER["board_bottom"] + near], axis=1),
        np.stack([wall, y, PAPER["board_top"] + near], axis=1),
        np.stack([along, side * bridge + near, level], axis=1),
        np.stack([wall + np.abs(near), np.clip(y, -bridge, bridge), level], axis=1),
    ]
    position = np.array(choices)[random.integers(0, len(choices), n), np.arange(n)]
    velocity = random.normal(0, 1, (n, 3))
    velocity[:, 0] = -random.uniform(0.5, 6, n)
    velocity[:, 2] = np.where(
        position[:, 2] == REACH, -np.abs(velocity[:, 2]) - 0.2, velocity[:, 2]
    )
    return back(position, velocity, spins(random, n), random.uniform(0.02, 0.2, n)), PAPER


def target_edge(n: int) -> Shots:
    """Through the end plane at the very edge of the target."""
    random = seeded("target edge")
    angle = random.uniform(0, TURN, n)
    rho = RING + tiny(random, n)
    depth = 1.5 * REACH  # below the ring, so that the ball can be there
    position = np.stack([rho * np.cos(angle), rho * np.sin(angle), np.full(n, -depth)], axis=1)
    velocity = random.normal(0, 1, (n, 3))
    velocity[:, 2] = -random.uniform(0.0, 1.0, n)
    states = back(position, velocity, spins(random, n), random.uniform(0.0, 0.15, n))
    return states, PAPER | {"end_depth": depth}


def rim(n: int) -> Shots:
    """Slowly on the rim, so that contacts follow one another in microseconds."""
    random = seeded("rim")
    position, normal, along, _ = tube(random, n, 0.3 * np.pi, 0.7 * np.pi)
    position += 10 ** random.uniform(-9, -2, n)[:, None] * normal
    velocity = random.normal(0, 0.15, (n, 3)) + random.normal(0, 0.7, (n, 1)) * along
    return np.concatenate([position, velocity, spins(random, n)], axis=1), PAPER


def with_restitution(restitution: float, n: int) -> Shots:
    """Return the shots from anywhere around, with another restitution."""
    states, parameters = around(n)
    return states, {**parameters, "restitution": restitution}


def other_hoops(n: int) -> Shots:
    """Return shots from anywhere around, each with its own hoop."""
    random = seeded("other hoops")
    states, _ = around(n)
    preset = random.integers(0, 3, n)
    parameters = {
        name: np.array([p[name] for p in (PAPER, NBA, FIBA)])[preset]
        * random.uniform(0.95, 1.05, n)
        for name in PAPER
    }
    parameters["restitution"] = random.uniform(0, 1, n)
    parameters["gravity"] = random.uniform(1, 20, n)
    return states, parameters


def _workload(make: Callable[[int], States], n: int) -> Shots:
    return make(n), PAPER


FAMILIES = (
    *(Family(w.key, w.label, partial(_workload, w.make), True) for w in WORKLOADS),
    Family("around", "from anywhere around", around),
    Family("drop", "straight down", drop),
    Family("axis", "down the axis, rho 0 or tiny", axis_drop),
    Family("plane", "in the plane of symmetry", in_plane),
    Family("grazing", "within 1e-12 m of a touch", grazing),
    Family("seam", "at the seam of ring and bridge", seam),
    Family("edges", "at the edges of board and bridge", edges),
    Family("target", "at the edge of the target", target_edge),
    Family("rim", "slowly on the rim", rim),
    Family("e0", "restitution 0", partial(with_restitution, 0.0)),
    Family("e001", "restitution 0.01", partial(with_restitution, 0.01)),
    Family("e099", "restitution 0.99", partial(with_restitution, 0.99)),
    Family("e1", "restitution 1", partial(with_restitution, 1.0)),
    Family("hoops", "every shot its own hoop", other_hoops),
)
