"""Flights that are a sequence of pieces, such as those through air, followed for a time."""

from __future__ import annotations

from collections.abc import Mapping
from types import ModuleType
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

LONGEST_SEARCH = 60.0
"""s: a ball that still rises, or has not come down, after so long is given up."""

_HALVINGS = 60
"""Halvings of a piece, no longer than 1 s, until neighbouring doubles bound a time in it."""

_Z, _VZ = 2, 5

Floats = NDArray[np.float64]


def fly_in_pieces(
    kernels: ModuleType, times: ArrayLike, states: Floats, inputs: Mapping[str, Any]
) -> Floats:
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
        States at the end, (..., 9); NaN for a duration that is negative, infinite or NaN.
    """
    shape = np.broadcast_shapes(np.shape(times), states.shape[:-1])
    left = np.broadcast_to(np.asarray(times, np.float64), shape).reshape(-1).copy()
    now, own = _rows(states, shape, inputs)
    now[~((left >= 0.0) & np.isfinite(left))] = np.nan
    going = np.flatnonzero((left > 0.0) & np.isfinite(left))
    with np.errstate(all="ignore"):
        while len(going):
            begun = _begin(kernels, now[going], {name: v[going] for name, v in own.items()})
            time = np.minimum(left[going], begun["piece"])
            now[going] = _moved(kernels, now[going], begun, time)
            left[going] -= time
            going = going[left[going] > 0.0]
    return now.reshape(*shape, now.shape[1])


def vary_in_pieces(
    kernels: ModuleType, times: Floats, states: Floats, given: Mapping[str, Any]
) -> dict[str, Floats]:
    """Return the variations of position and velocity after free flights, piece by piece.

    Parameters
    ----------
    kernels
        As for `fly_in_pieces`.
    times
        Durations of the flights, s, none of them negative, (m,).
    states
        States at the beginning, (m, 9).
    given
        By name the variables of the parameters, numbers or (m,), their changes, numbers or (k, m),
        and the variations of the state at the beginning, (k, m).

    Returns
    -------
    dict
        The variations at the end by name, (k, m).
    """
    left, now = times.copy(), states.copy()
    names = kernels.OUTPUTS["vary_flight"]
    ended = {name: np.array(given[name]) for name in names}
    going = np.flatnonzero(left > 0.0)
    while len(going):
        own = {name: v[..., going] if np.ndim(v) else v for name, v in {**given, **ended}.items()}
        begun = _begin(kernels, now[going], own, varied=True)
        time = np.minimum(left[going], begun["piece"])
        for name, value in _evaluate(kernels, "vary_flight", begun | {"t": time}).items():
            ended[name][:, going] = value
        now[going] = _moved(kernels, now[going], begun, time)
        left[going] -= time
        going = going[left[going] > 0.0]
    return ended


class FlownPieces:
    """Flights whose pieces are kept, so that states within them are found at once.

    Parameters
    ----------
    kernels
        As for `fly_in_pieces`.
    states
        States at the beginning, (m, 9).
    until
        The latest time of each flight at which its state is asked for, s, (m,).
    inputs
        The variables of the parameters, each a number or (m,).
    """

    def __init__(
        self, kernels: ModuleType, states: Floats, until: Floats, inputs: Mapping[str, Any]
    ) -> None:
        self._kernels = kernels
        names = [name for name in kernels.ARGUMENTS["flight"] if name != "t"]
        now, since = states.copy(), np.zeros(len(states))
        begins, series = [], []
        going = np.arange(len(states))
        while len(going):
            own = {name: v[going] if np.ndim(v) else v for name, v in inputs.items()}
            begun = _begin(kernels, now[going], own)
            begins.append(np.full(len(states), np.inf))
            begins[-1][going] = since[going]
            series.append(np.full((len(names), len(states)), np.nan))
            series[-1][:, going] = [np.broadcast_to(begun[name], len(going)) for name in names]
            now[going] = _moved(kernels, now[going], begun, begun["piece"])
            since[going] += begun["piece"]
            going = going[since[going] <= until[going]]
        self._names, self._begins, self._series = names, np.array(begins), np.array(series)

    def at(self, flights: NDArray[np.intp], times: Floats) -> dict[str, Any]:
        """Return position and velocity at some times of flights, by name.

        Parameters
        ----------
        flights
            The flights, by their numbers, (j,).
        times
            s since their beginnings, (j,).
        """
        piece = np.maximum((self._begins[:, flights] <= times).sum(axis=0) - 1, 0)
        given = dict(zip(self._names, self._series[piece, :, flights].T, strict=True))
        given["t"] = times - self._begins[piece, flights]
        return _evaluate(self._kernels, "flight", given)


def apex_in_pieces(
    kernels: ModuleType, states: Floats, inputs: Mapping[str, Any]
) -> tuple[Floats, Floats]:
    """Return when balls in flight stop rising, and their states then.

    Parameters
    ----------
    kernels, states, inputs
        As for `fly_in_pieces`.

    Returns
    -------
    tuple of ndarray
        s, (...), 0 for a ball that falls; and (..., 9). NaN for one that rises longer than
        `LONGEST_SEARCH`.
    """
    return _fall_to(kernels, states, np.zeros(()), inputs, _VZ)


def descend_in_pieces(
    kernels: ModuleType, states: Floats, level: ArrayLike, inputs: Mapping[str, Any]
) -> tuple[Floats, Floats]:
    """Return when balls in flight come down to a height, and their states then.

    Parameters
    ----------
    kernels, states, inputs
        As for `fly_in_pieces`.
    level
        Height z of their centres, m; it broadcasts with the states, (...).

    Returns
    -------
    tuple of ndarray
        s, (...), and (..., 9); NaN for a ball that is below and does not rise to that height.
    """
    height = np.asarray(level, np.float64)
    risen, top = apex_in_pieces(kernels, states, inputs)
    fallen, there = _fall_to(kernels, top, height, inputs, _Z)
    below = top[..., _Z] < height
    return np.where(below, np.nan, risen + fallen), np.where(below[..., None], np.nan, there)


def _fall_to(
    kernels: ModuleType, states: Floats, level: Floats, inputs: Mapping[str, Any], component: int
) -> tuple[Floats, Floats]:
    """Return when a component that falls is first at most a level, and the states then."""
    shape = np.broadcast_shapes(states.shape[:-1], np.shape(level))
    now, own = _rows(states, shape, inputs)
    level = np.broadcast_to(level, shape).reshape(-1)
    since = np.where(np.isnan(now).any(axis=1), np.nan, 0.0)
    going = np.flatnonzero(now[:, component] > level)
    with np.errstate(all="ignore"):
        while len(going):
            begun = _begin(kernels, now[going], {name: v[going] for name, v in own.items()})
            piece = begun["piece"].copy()
            there = _moved(kernels, now[going], begun, piece)
            ends = there[:, component] <= level[going]
            low, high = np.zeros_like(piece), piece.copy()
            for _ in range(_HALVINGS if ends.any() else 0):
                middle = (low + high) / 2
                met = _moved(kernels, now[going], begun, middle)[:, component] <= level[going]
                low, high = np.where(met, low, middle), np.where(met, middle, high)
            time = np.where(ends, high, piece)
            now[going] = np.where(ends[:, None], _moved(kernels, now[going], begun, time), there)
            since[going] += time
            since[going] = np.where(since[going] <= LONGEST_SEARCH, since[going], np.nan)
            going = going[~ends & ~np.isnan(since[going])]
    now[np.isnan(since)] = np.nan
    return since.reshape(shape), now.reshape(*shape, now.shape[1])


def _rows(
    states: Floats, shape: tuple[int, ...], inputs: Mapping[str, Any]
) -> tuple[Floats, dict[str, Any]]:
    """Return states as rows (n, 9), and the variables of the parameters as columns (n,)."""
    rows = np.broadcast_to(states, (*shape, states.shape[-1])).reshape(-1, states.shape[-1])
    columns = {n: np.broadcast_to(value, shape).reshape(-1) for n, value in inputs.items()}
    return rows.copy(), columns


def _begin(
    kernels: ModuleType, states: Floats, inputs: Mapping[str, Any], varied: bool = False
) -> dict[str, Any]:
    """Return the variables of a piece of flights that begin at states (n, 9).

    Where variations are among the inputs, those of the piece are among the variables.
    """
    values = {**inputs, **dict(zip(kernels.STATE, states.T, strict=True))}
    for name in kernels.PIECES:
        for key, one in _evaluate(kernels, name, values).items():
            column = np.asarray(one, np.float64)  # some kernels are in single precision
            values[key] = column if column.ndim else np.broadcast_to(column, len(states))
        if varied and f"vary_{name}" in kernels.ARGUMENTS:
            values.update(_evaluate(kernels, f"vary_{name}", values))
    return values


def _evaluate(kernels: ModuleType, name: str, values: Mapping[str, Any]) -> dict[str, Any]:
    """Return the outputs of a kernel by name."""
    given = (values[argument] for argument in kernels.ARGUMENTS[name])
    return dict(zip(kernels.OUTPUTS[name], getattr(kernels, name)(*given), strict=True))


def _moved(kernels: ModuleType, states: Floats, begun: Mapping[str, Any], time: Floats) -> Floats:
    """Return the states (n, 9) at times within a piece."""
    moved = np.stack([*_evaluate(kernels, "flight", {**begun, "t": time}).values()], axis=1)
    return np.concatenate([moved, states[:, moved.shape[1] :]], axis=1)
