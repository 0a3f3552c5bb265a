"""Release models: where the shots of a study come from."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any, Protocol, TypeAlias, runtime_checkable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hoopgen.hoop.presets import NAMES, PAPER
from hoopgen.hoop.variables import resolve_variables
from hoopgen.inputs import doubles
from hoopgen.sizes import check_room
from hoopgen.variables import STATE, Releases, check_names

__all__ = [
    "Floats",
    "Given",
    "ReleaseModel",
    "Scene",
    "check_drawn",
    "from_columns",
    "is_state",
    "spread",
]

Floats: TypeAlias = NDArray[np.float64]
Scene: TypeAlias = Mapping[str, Any]
Given: TypeAlias = Mapping[str, ArrayLike]

_SHOT = 200
"""Bytes that a shot takes while it is drawn."""


@runtime_checkable
class ReleaseModel(Protocol):
    """Anything that releases shots by index."""

    def draw(
        self, start: int, stop: int, seed: int = 0, parameters: Mapping[str, Any] = PAPER
    ) -> Releases:
        """Return shots `start` to `stop` - 1; shot i is the same however it is asked for."""
        ...

    def identity(self) -> dict[str, Any]:
        """Return what tells this model from others, in types that JSON knows."""
        ...


def check_drawn(start: int, stop: int) -> None:
    """Refuse to draw more shots at once than there is memory for."""
    check_room("stop", stop - start, "shots drawn at once", _SHOT)


def is_state(columns: Iterable[str]) -> bool:
    """Return whether columns of these names are states: z or vx, vy, vz say so."""
    return not set(STATE[2:]).isdisjoint(columns)


def spread(states: Floats, scene: Mapping[str, Any], shots: int) -> Releases:
    """Return so many shots of each of m releases, one release after the other.

    Parameters
    ----------
    states
        (m, shots, 9) or what broadcasts to it.
    scene
        Numbers, or what broadcasts to (m, shots).
    """
    apart = [np.shape(value) for value in scene.values()]
    shape = np.broadcast_shapes(states.shape[:-1], (1, shots), *apart)
    return Releases(
        np.broadcast_to(states, (*shape, len(STATE))).reshape(-1, len(STATE)),
        {n: np.broadcast_to(v, shape).ravel() if np.ndim(v) else v for n, v in scene.items()},
        {},
    )


def from_columns(
    columns: Mapping[str, ArrayLike], parameters: Mapping[str, Any] = PAPER
) -> Releases:
    """Return the shots of columns, one number for all or (n,) each: states, or variables.

    Columns z or vx, vy, vz say that they are states.

    Raises
    ------
    ValueError
        If a name is unknown or missing.
    """
    if not is_state(columns):
        return resolve_variables(columns, parameters)
    check_names("columns", columns, (*STATE, *NAMES))
    missing = [name for name in STATE[:6] if name not in columns]
    if missing:
        raise ValueError(f"columns: a state needs {', '.join(missing)} too")
    # A spin that was not measured is none.
    components = [doubles(name, columns.get(name, 0.0)) for name in STATE]
    scene = {name: columns[name] for name in NAMES if name in columns}
    shots = np.broadcast_shapes((1,), *(np.shape(column) for column in columns.values()))
    states = np.empty((*shots, len(STATE)))
    for index, component in enumerate(components):
        states[:, index] = component
    return Releases(states, dict(parameters) | scene, {})
