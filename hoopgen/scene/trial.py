"""Shots with which a scene's C is compared with NumPy: of all sizes, and such as touch bodies."""

from __future__ import annotations

from types import ModuleType

import numpy as np
from numpy.typing import NDArray

from hoopgen.engine import numpy_backend
from hoopgen.engine.raw import Layout

__all__ = ["SHOTS", "trial"]

SHOTS = 1000

_WIDE = 4096
_CONTACTS = 8

_SIZES = (-4.0, 4.0)
"""Of the distances from the origin, m, as powers of two."""


def trial(kernels: ModuleType) -> NDArray[np.float64]:
    """Return releases (SHOTS, 9), the same for the same scene.

    Shots at random are flown with NumPy, then others that are like those that touched something.
    Half of what is returned touches, as evenly the bodies as there are such shots.
    """
    rng = np.random.Generator(np.random.PCG64(13))
    size = 2.0 ** rng.uniform(*_SIZES, (_WIDE, 1))
    wide = rng.normal(size=(_WIDE, 9))
    wide[:, :3] *= size
    wide[:, 3:6] *= 5.0 * np.sqrt(size)
    wide[:, 6:] *= 20.0
    near = wide[_touching(kernels, wide, _WIDE // 2, rng)]
    near *= 1.0 + 0.1 * rng.normal(size=near.shape)
    both = np.concatenate([wide, near])
    rows = _touching(kernels, both, SHOTS // 2, rng)
    others = np.setdiff1d(np.arange(len(both)), rows)
    chosen = np.concatenate([rows, rng.permutation(others)[: SHOTS - len(rows)]])
    return np.ascontiguousarray(both[chosen], np.float64)


def _touching(
    kernels: ModuleType, states: NDArray[np.float64], most: int, rng: np.random.Generator
) -> NDArray[np.intp]:
    """Return rows of shots that touch something, each body about as often."""
    usual = [default for default, _, _ in kernels.PARAMETERS.values()]
    out = Layout(kernels).allocate(len(states), ["counts"])
    out.arrays["counts"][:] = 0
    numpy_backend.run(kernels, states, usual, None, _CONTACTS, out)
    touched = out.arrays["counts"] > 0
    each = [rng.permutation(np.flatnonzero(column)) for column in touched.T]
    chosen: list[int] = []
    for turn in range(max(map(len, each), default=0)):
        chosen += [int(rows[turn]) for rows in each if turn < len(rows)]
        if len(chosen) >= most:
            break
    return np.array(list(dict.fromkeys(chosen))[:most], np.intp)
