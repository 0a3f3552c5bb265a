"""Flights that are a sequence of pieces, such as those through air, followed for a time."""

from __future__ import annotations

from collections.abc import Mapping
from types import ModuleType
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["fly_in_pieces"]


def fly_in_pieces(
    kernels: ModuleType, times: ArrayLike, states: NDArray[np.float64], inputs: Mapping[str, Any]
) -> NDArray[np.float64]:
    """Return the states after free flights, piece by piece as in the event loop.

    Parameters
    ----------
    kernels
        The generated NumPy module of the scene.
    times
        Durations of the flights, s; they broadcast with the states, (...).
    states
        States at the beginning, (..., 9).
    inputs
        The variables of the parameters, each a number or (...).

    Returns
    -------
    ndarray
        States at the end, (..., 9). A flight of negative duration, or one that is not a number, is
        not a number.
    """
    shape = np.broadcast_shapes(np.shape(times), states.shape[:-1])
    left = np.broadcast_to(np.asarray(times, np.float64), shape).reshape(-1).copy()
    now = np.broadcast_to(states, (*shape, states.shape[-1])).reshape(len(left), -1).copy()
    own = {name: np.broadcast_to(value, shape).reshape(-1) for name, value in inputs.items()}
    left[~(left >= 0.0) | ~np.isfinite(left)] = np.nan
    now[np.isnan(left)] = np.nan
    going = np.flatnonzero(left > 0.0)
    with np.errstate(all="ignore"):
        while len(going):
            values = {name: value[going] for name, value in own.items()}
            values |= dict(zip(kernels.STATE, now[going].T, strict=True))
            for name in kernels.PIECES:
                _evaluate(kernels, name, values)
            values["t"] = np.minimum(left[going], values["piece"])
            moved = _evaluate(kernels, "flight", values)
            now[going, : len(moved)] = np.stack(moved, axis=1)
            left[going] -= values["t"]
            going = going[left[going] > 0.0]
    return now.reshape(*shape, -1)


def _evaluate(kernels: ModuleType, name: str, values: dict[str, Any]) -> list[Any]:
    """Evaluate a kernel with values by name, which get its outputs; return these."""
    given = (values[argument] for argument in kernels.ARGUMENTS[name])
    found = [np.broadcast_to(made, values["x"].shape) for made in getattr(kernels, name)(*given)]
    if name != "flight":
        values.update(zip(kernels.OUTPUTS[name], found, strict=True))
    return found
