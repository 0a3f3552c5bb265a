"""Shots for comparing a scene's C with NumPy: of all sizes, and touching each body."""

from __future__ import annotations

import math
from types import ModuleType

import numpy as np
from numpy.typing import NDArray

from hoopgen.engine import numpy_backend
from hoopgen.engine.result_arrays import Layout
from hoopgen.engine.verification import Batch, batches

SHOTS = 500

TIME_LIMIT = 0.125
"""A time limit in the midst of things, s; the only one where balls may roll for ever, which takes
NumPy long."""

_CANDIDATES = 4096
_MAX_CONTACTS = 8

_SIZES = (-4.0, 4.0)
"""Range of the distances from the origin, m, as exponents of two."""


def trial_batches(kernels: ModuleType) -> list[Batch]:
    """Return the batches with which a scene's C is compared with NumPy.

    Parameters
    ----------
    kernels
        The generated NumPy module of the scene.
    """
    return batches(kernels, trial_shots(kernels), TIME_LIMIT)


def trial_shots(kernels: ModuleType) -> NDArray[np.float64]:
    """Return releases (SHOTS, 9), the same for the same scene.

    Shots at random are flown with NumPy, then others that are like those that touched something.
    Half of what is returned touches, as evenly the bodies as there are such shots.
    """
    rng = np.random.Generator(np.random.PCG64(13))
    size = 2.0 ** rng.uniform(*_SIZES, (_CANDIDATES, 1))
    wide = rng.normal(size=(_CANDIDATES, 9))
    wide[:, :3] *= size
    wide[:, 3:6] *= 5.0 * np.sqrt(size)
    wide[:, 6:] *= 20.0
    near = wide[_touching_rows(kernels, wide, _CANDIDATES // 2, rng)]
    near *= 1.0 + 0.1 * rng.normal(size=near.shape)
    both = np.concatenate([wide, near])
    rows = _touching_rows(kernels, both, SHOTS // 2, rng)
    others = np.setdiff1d(np.arange(len(both)), rows)
    chosen = np.concatenate([rows, rng.permutation(others)[: SHOTS - len(rows)]])
    return np.ascontiguousarray(both[chosen], np.float64)


def _touching_rows(
    kernels: ModuleType, states: NDArray[np.float64], most: int, rng: np.random.Generator
) -> NDArray[np.intp]:
    """Return rows of shots that touch a body, each body about as often."""
    usual = [default for default, _, _ in kernels.PARAMETERS.values()]
    out = Layout(kernels).allocate(len(states), ["counts"])
    out.arrays["counts"][:] = 0
    limit = TIME_LIMIT if kernels.NEEDS_TIME_LIMIT else math.inf
    numpy_backend.run(kernels, states, usual, None, _MAX_CONTACTS, out, time_limit=limit)
    touched = out.arrays["counts"] > 0
    each = [rng.permutation(np.flatnonzero(column)) for column in touched.T]
    chosen: list[int] = []
    for turn in range(max(map(len, each), default=0)):
        chosen += [int(rows[turn]) for rows in each if turn < len(rows)]
        if len(chosen) >= most:
            break
    return np.array(list(dict.fromkeys(chosen))[:most], np.intp)
