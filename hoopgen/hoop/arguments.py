"""The inverse of `release`: from states to speed, angles and place, with the derivative.

A release with velocity v at (x, y, z) has the speed |v|, the elevation atan2(vz, |(vx, vy)|), and
as azimuth the heading atan2(-vy, -vx) less the angle atan2(y, x) of its place.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from hoopgen.engine.elementary import arc_tangent, hypotenuse, sine_cosine

from .releases import RING_HEIGHT

Floats = NDArray[np.float64]

FLIGHT_ARGUMENTS = ("speed", "elevation", "azimuth", "height", "distance", "angle")
"""Arguments of `release` that follow from position and velocity, without the spin."""


def arguments_of(states: Floats) -> dict[str, Floats]:
    """Return the arguments of `release` that give the states.

    Parameters
    ----------
    states
        (..., 9). The part of the spin along the flight on the floor plan is left out: `release`
        has no argument for it.

    Returns
    -------
    dict
        All arguments of `release`, (...), m, m/s, rad, rad/s; the azimuth within half a turn.
    """
    x, y, z, vx, vy, vz, wx, wy, wz = np.moveaxis(np.asarray(states, np.float64), -1, 0)
    level, angle = hypotenuse(vy, vx), arc_tangent(y, x)
    heading = arc_tangent(-vy, -vx)
    sine, cosine = sine_cosine(heading)
    return {
        "speed": hypotenuse(vz, level),
        "elevation": arc_tangent(vz, level),
        "azimuth": np.pi - np.mod(np.pi - (heading - angle), 2.0 * np.pi),
        "backspin": wy * cosine - wx * sine,
        "sidespin": wz,
        "height": z + RING_HEIGHT,
        "distance": hypotenuse(y, x),
        "angle": angle,
    }


def arguments_jacobian(states: Floats) -> Floats:
    """Return the derivatives of `FLIGHT_ARGUMENTS` by position and velocity.

    Parameters
    ----------
    states
        (..., 9) or (..., 6): x y z (m), vx vy vz (m/s).

    Returns
    -------
    ndarray
        (..., 6, 6); not finite for a vertical flight, or a place below the ring's centre.
    """
    x, y, _, vx, vy, vz = np.moveaxis(np.asarray(states, np.float64)[..., :6], -1, 0)
    level, reach = hypotenuse(vy, vx), hypotenuse(y, x)
    speed = hypotenuse(vz, level)
    found = np.zeros((*np.shape(x), 6, 6))
    with np.errstate(divide="ignore", invalid="ignore"):
        turn = np.stack([-y / reach**2, x / reach**2], axis=-1)
        found[..., 0, 3:6] = np.stack([vx, vy, vz], axis=-1) / speed[..., None]
        found[..., 1, 3] = -vz * vx / (level * speed**2)
        found[..., 1, 4] = -vz * vy / (level * speed**2)
        found[..., 1, 5] = level / speed**2
        found[..., 2, 0:2] = -turn
        found[..., 2, 3] = -vy / level**2
        found[..., 2, 4] = vx / level**2
        found[..., 3, 2] = 1.0
        found[..., 4, 0] = x / reach
        found[..., 4, 1] = y / reach
        found[..., 5, 0:2] = turn
    return found
