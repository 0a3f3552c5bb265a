"""Shots about the whole hoop, by kind, from fixed seeds: above it, below it, behind it."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

# x y z and vx vy vz: the middle, and how far shots lie from it at most.
_KINDS = {
    "from above": ((-0.1, 0, 0.9, 0, 0, 0), (0.5, 0.4, 0.7, 1.5, 1.5, 1.5)),
    "from below": ((-0.1, 0, -0.65, 0, 0, 3.5), (0.6, 0.5, 0.55, 1.6, 1.6, 2.5)),
    "up through the ring": ((0, 0, -0.6, 0, 0, 4), (0.2, 0.2, 0.4, 0.5, 0.5, 2)),
    "behind the board": ((-1.05, 0, 0.5, 2.5, 0, 1.5), (0.55, 1.2, 1, 2.5, 1.4, 3.5)),
    "over the board's edges": ((-0.4, 0.5, 0.9, 0, 0, 0.5), (0.3, 0.7, 0.6, 1.5, 1.5, 1.5)),
    "under the bridge": ((-0.3, 0, -0.6, 0, 0, 4), (0.15, 0.25, 0.3, 0.7, 0.7, 1.5)),
    "anywhere": ((0, 0, 0, 0, 0, 0), (1.5, 1.5, 1.5, 6, 6, 6)),
}

KINDS = tuple(_KINDS)


def thrown(kind: str, count: int, seed: int = 0) -> Floats:
    """Return releases of a kind, (count, 9); some of them overlap a body."""
    rng = np.random.Generator(np.random.PCG64([seed, KINDS.index(kind)]))
    middle, apart = np.array(_KINDS[kind])
    states = np.zeros((count, 9))
    states[:, :6] = middle + apart * rng.uniform(-1, 1, (count, 6))
    states[:, 6:] = rng.normal(0, 25, (count, 3)) * rng.integers(0, 2, (count, 1))
    return states


def all_kinds(count: int, seed: int = 0) -> Floats:
    """Return as many of every kind."""
    return np.concatenate([thrown(kind, count, seed) for kind in KINDS])
