"""The four workloads, from a fixed seed. Each is a mean shot and a scatter; the first n shots of a
workload are the same whatever n is."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from hoopgen import PAPER
from hoopgen.core.units import FOOT

States = NDArray[np.float64]
"""Rows of x y z vx vy vz wx wy wz, m, m/s, rad/s."""

SEED = 20240614
"""The article's day of publication."""


def in_feet(
    position: tuple[float, float, float],
    velocity: tuple[float, float, float],
    backspin: float = 0.0,
) -> States:
    """One state, shape (9,), from feet and feet per second; backspin in rad/s."""
    return np.array([*(FOOT * np.array(position + velocity)), 0.0, backspin, 0.0])


TABLE_3: Mapping[str, States] = MappingProxyType(
    {
        "5a": in_feet((8, 0, -2), (-9.5, 0, 16)),
        "5b": in_feet((8, 0, -2), (-10.13, 0, 16)),
        "5c": in_feet((8, 0, -2), (-11.5, 0, 16)),
        "5d": in_feet((8, 0, -2), (-8.879, 0, 16)),
        "6a": in_feet((0.75, -3.0, -2), (-3.75, 4.75, 14)),
        "6b": in_feet((0.75, -3.1, -2), (-2.75, 7, 12.65)),
        "7": in_feet((13.75, 0, -2), (-14.763, 0, 18.297), 6 * np.pi),
    }
)
"""The article's Table 3, its typing errors put right, case 6b without spin."""


def swish_shot() -> States:
    """Return the free throw that drops through the ring's centre, 3 Hz of backspin, shape (9,)."""
    x, z, vx = 13.75 * FOOT, -2.0 * FOOT, -4.4
    flight = -x / vx
    vz = -z / flight + 0.5 * PAPER["gravity"] * flight
    return np.array([x, 0.0, z, vx, 0.0, vz, 0.0, 6 * np.pi, 0.0])


def _gauss(name: str, n: int, columns: int) -> NDArray[np.float64]:
    """Row by row, so that a longer workload begins with the shorter one."""
    key = SEED + sum(ord(letter) << (8 * place) for place, letter in enumerate(name))
    return np.random.Generator(np.random.Philox(key)).standard_normal((n, columns))


def swish(n: int) -> States:
    """Return n shots that touch nothing."""
    gauss = _gauss("swish", n, 3)
    states = np.tile(swish_shot(), (n, 1))
    states[:, 3] *= 1 + 5e-4 * gauss[:, 0]
    states[:, 4] = 2e-3 * gauss[:, 1]
    states[:, 5] *= 1 + 5e-4 * gauss[:, 2]
    return states


def free_throw(n: int) -> States:
    """Return n shots of a player's scatter: speed 1.5%, elevation 1.5°, azimuth 1°."""
    gauss = _gauss("free throw", n, 3)
    states = np.tile(swish_shot(), (n, 1))
    _, _, _, vx, _, vz, _, backspin, _ = swish_shot()
    speed = np.hypot(vx, vz) * (1 + 0.015 * gauss[:, 0])
    elevation = np.arctan2(vz, -vx) + np.deg2rad(1.5) * gauss[:, 1]
    azimuth = np.deg2rad(1.0) * gauss[:, 2]
    states[:, 3] = -speed * np.cos(elevation) * np.cos(azimuth)
    states[:, 4] = -speed * np.cos(elevation) * np.sin(azimuth)
    states[:, 5] = speed * np.sin(elevation)
    states[:, 6] = -backspin * np.sin(azimuth)
    states[:, 7] = backspin * np.cos(azimuth)
    return states


def bouncing(n: int) -> States:
    """Return n shots around Table 3, case 7."""
    gauss = _gauss("bouncing", n, 4)
    states = np.tile(TABLE_3["7"], (n, 1))
    states[:, 3] *= 1 + 0.005 * gauss[:, 0]
    states[:, 4] = 0.0225 * gauss[:, 1]
    states[:, 5] *= 1 + 0.005 * gauss[:, 2]
    states[:, 7] *= 1 + 0.005 * gauss[:, 3]
    return states


def swirl(n: int) -> States:
    """Return n shots around Table 3, case 6b."""
    gauss = _gauss("swirl", n, 3)
    states = np.tile(TABLE_3["6b"], (n, 1))
    states[:, 3:6] *= 1 + 1e-3 * gauss
    return states


@dataclass(frozen=True)
class Workload:
    """A named set of shots and the number of them that a full run flies."""

    key: str
    label: str
    make: Callable[[int], States]
    size: int


WORKLOADS = (
    Workload("W1", "swish", swish, 1 << 20),
    Workload("W2", "free throw", free_throw, 1 << 20),
    Workload("W3", "bouncing", bouncing, 1 << 20),
    Workload("W4", "swirl", swirl, 1 << 18),
)
