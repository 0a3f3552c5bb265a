"""The arguments that kernels take of a flight."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


def of_flight(
    states: Floats, parameters: Mapping[str, float], until: Floats | float, off: float
) -> dict[str, Floats]:
    """Return the arguments of a kernel that asks about a flight up to a time.

    Parameters
    ----------
    states
        (n, 6) or (n, 9).
    parameters
        Of the scene, by name.
    until
        The end of the flight, s.
    off
        The error of its positions, m.
    """
    x, y, z, vx, vy, vz = states.T[:6]
    return {
        **{name: np.array([value]) for name, value in parameters.items()},
        **dict(zip(("x", "y", "z", "vx", "vy", "vz"), states.T, strict=False)),
        "extent": abs(x) + abs(y) + abs(z),
        "speed": abs(vx) + abs(vy) + abs(vz),
        "horizon": np.asarray(until, float),
        "position_error": np.array([off]),
        "velocity_error": np.zeros(1),
    }
