"""States of flights whose backspin is known: a track shows no spin."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from hoopgen.engine.elementary import hypotenuse

Floats = NDArray[np.float64]


def states_with_backspin(position: Floats, velocity: Floats, backspin: Floats) -> Floats:
    """Return states whose spin is a backspin across the flight on the floor plan.

    Parameters
    ----------
    position, velocity
        (..., 3), m and m/s.
    backspin
        (...), rad/s.

    Returns
    -------
    ndarray
        (..., 9); the spin of a vertical flight is NaN, as it has no direction.
    """
    level = hypotenuse(velocity[..., 1], velocity[..., 0])
    with np.errstate(invalid="ignore", divide="ignore"):
        ahead = velocity[..., :2] / level[..., None]
    spin = np.zeros_like(position)
    spin[..., 0] = backspin * ahead[..., 1]
    spin[..., 1] = -backspin * ahead[..., 0]
    return np.concatenate([position, velocity, spin + 0.0], axis=-1)
