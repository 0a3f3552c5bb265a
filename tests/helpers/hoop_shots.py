"""Shots at the hoop, by kind, from fixed seeds: what players do, and what they do not."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

import hoopgen


@dataclass(frozen=True)
class Batch:
    """Releases, and what they are simulated with."""

    states: NDArray[np.float64]
    parameters: Mapping[str, Any]

    def __len__(self) -> int:
        return len(self.states)

    def take(self, rows: Any) -> Batch:
        """Return some of the shots, with their own parameters."""
        own = {n: v[rows] if np.ndim(v) else v for n, v in self.parameters.items()}
        return Batch(self.states[rows], own)


def _rows(count: int, **columns: Any) -> NDArray[np.float64]:
    names = ("x", "y", "z", "vx", "vy", "vz", "wx", "wy", "wz")
    return np.stack([np.broadcast_to(columns.get(n, 0.0), count) for n in names], axis=1)


def families(count: int, seed: int) -> dict[str, NDArray[np.float64]]:
    """Return shots of each kind, by name: what players do, and what they do not."""
    random = np.random.default_rng(seed)
    gauss, between = random.standard_normal, random.uniform
    degree, foot = np.pi / 180, 0.3048
    around, off_axis = between(-np.pi, np.pi, count), between(0.0, 0.5, count)
    return {
        "free throw": hoopgen.release(
            7.166 * (1 + 0.015 * gauss(count)),
            (51.1 + 1.5 * gauss(count)) * degree,
            gauss(count) * degree,
            19 + 4 * gauss(count),
            gauss(count),
            height=8 * foot,
            distance=13.75 * foot,
        ),
        "bank shot": hoopgen.release(
            6.8 + 0.3 * gauss(count),
            (55 + 2 * gauss(count)) * degree,
            (-8 + 3 * gauss(count)) * degree,
            10 * gauss(count),
            height=2.2,
            distance=3.0,
            angle=(45 + 10 * gauss(count)) * degree,
        ),
        "swirl": _rows(
            count,
            x=0.75 * foot,
            y=-3.1 * foot,
            z=-2 * foot,
            vx=-2.75 * foot * (1 + 1e-3 * gauss(count)),
            vy=7.0 * foot * (1 + 1e-3 * gauss(count)),
            vz=12.65 * foot * (1 + 1e-3 * gauss(count)),
            wz=2 * random.random(count),
        ),
        "drop": _rows(
            count,
            x=off_axis * np.cos(around),
            y=off_axis * np.sin(around),
            z=between(0.15, 2.0, count),
            **dict(zip(("vx", "vy", "vz"), 0.3 * gauss((3, count)), strict=True)),
            **dict(zip(("wx", "wy", "wz"), 20 * gauss((3, count)), strict=True)),
        ),
        "bridge": _rows(
            count,
            x=between(-0.2597, -0.235, count),
            y=between(-0.08, 0.08, count),
            z=between(0.1313, 0.6, count),
            **dict(zip(("vx", "vy"), 0.3 * gauss((2, count)), strict=True)),
            vz=gauss(count),
        ),
        "from behind the board": _rows(
            count,
            x=between(-2.0, -0.51, count),
            y=between(-0.5, 0.5, count),
            z=between(-0.8, 1.0, count),
            vx=between(0.5, 4.0, count),
            vy=0.3 * gauss(count),
            vz=4 + 1.5 * gauss(count),
        ),
        "anywhere": _rows(
            count,
            x=between(-1.5, 3.0, count),
            y=between(-1.5, 1.5, count),
            z=between(-1.0, 1.5, count),
            **dict(zip(("vx", "vy"), 3 * gauss((2, count)), strict=True)),
            vz=2 + 4 * gauss(count),
            **dict(zip(("wx", "wy", "wz"), 30 * gauss((3, count)), strict=True)),
        ),
    }
