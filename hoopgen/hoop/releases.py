"""Releases: from speed and angles to states."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Literal, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hoopgen.core.argument_types import check_flag
from hoopgen.core.jacobian import Jacobian
from hoopgen.core.si_checks import check_angles, check_lengths, check_speeds, check_spins
from hoopgen.core.validation import as_doubles
from hoopgen.core.variables import STATE
from hoopgen.engine.draws import release_states, turns
from hoopgen.generated.numpy import studies

RING_HEIGHT = 3.048
"""Height of the ring above the floor, m: 10 ft."""

CATCHING_HEIGHT = 2.5
"""Height of the ball's centre above the floor when a rebound is caught, m. This is a choice and
not a measurement: a tall player who stands reaches about so high, one who jumps reaches higher."""

_ANGLES = ("elevation", "azimuth", "angle")
_SPINS = ("backspin", "sidespin")

_OF_JACOBIAN = ("speed", "backspin", "distance")
"""The arguments of the kernel of the derivatives, beside angles."""

FROM_ZERO: Mapping[str, str] = MappingProxyType({"speed": "m/s", "distance": "m"})
"""Arguments of `release` that are never negative, and their units; an angle gives the direction."""


def from_zero(name: str, values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return values of an argument in `FROM_ZERO`, NaN for negative ones.

    Parameters
    ----------
    name
        The name of the argument.
    values
        Its values, of any shape.

    Raises
    ------
    ValueError
        If it is a single one, and negative.
    """
    negative = values < 0.0
    if not negative.any():
        return values
    if not values.ndim:
        raise ValueError(f"{name}: expected 0 {FROM_ZERO[name]} or more, got {values}")
    return np.where(negative, np.nan, values)


@overload
def release(
    speed: ArrayLike,
    elevation: ArrayLike,
    azimuth: ArrayLike = ...,
    backspin: ArrayLike = ...,
    sidespin: ArrayLike = ...,
    *,
    height: ArrayLike,
    distance: ArrayLike,
    angle: ArrayLike = ...,
) -> NDArray[np.float64]: ...


@overload
def release(
    speed: ArrayLike,
    elevation: ArrayLike,
    azimuth: ArrayLike = ...,
    backspin: ArrayLike = ...,
    sidespin: ArrayLike = ...,
    *,
    height: ArrayLike,
    distance: ArrayLike,
    angle: ArrayLike = ...,
    jacobian: Literal[True],
) -> tuple[NDArray[np.float64], Jacobian]: ...


def release(
    speed: ArrayLike,
    elevation: ArrayLike,
    azimuth: ArrayLike = 0.0,
    backspin: ArrayLike = 0.0,
    sidespin: ArrayLike = 0.0,
    *,
    height: ArrayLike,
    distance: ArrayLike,
    angle: ArrayLike = 0.0,
    jacobian: bool = False,
) -> NDArray[np.float64] | tuple[NDArray[np.float64], Jacobian]:
    """Return the states of shots released from a place on the court.

    All arguments broadcast. Entries that are masked count as NaN.

    Parameters
    ----------
    speed
        m/s. Of many a negative one gives a state of NaN.
    elevation
        Angle of the velocity above the horizontal, rad.
    azimuth
        Direction of the velocity on the floor plan, rad: 0 aims at the ring's centre, positive to
        the shooter's left.
    backspin
        rad/s about the horizontal axis across the line of flight; positive spins the top of the
        ball towards the shooter (wy > 0 for a shot along -x).
    sidespin
        rad/s about the vertical.
    height
        Of the ball's centre above the floor, m; the ring is at 3.048.
    distance
        From the ring's centre on the floor plan, m. Of many a negative one gives a state of NaN.
    angle
        Of the place around the ring's centre, rad: 0 straight in front, on +x, counter-clockwise
        seen from above.
    jacobian
        Whether to return the derivatives of the states, too.

    Returns
    -------
    ndarray
        States of shape (..., 9), the arguments' common shape before the last axis. With `jacobian`
        a tuple of them and their `Jacobian` by the eight arguments, "state" of shape (..., 9, 8),
        with which ``shots.jacobian.chain`` gives derivatives by these arguments.

    Raises
    ------
    TypeError
        If an argument cannot become float64.
    ValueError
        If the shapes do not broadcast, the one speed or distance of all is negative, or units are
        others by the median: angles of more than a turn, spins above `MAX_SPIN`, lengths above
        `MAX_LENGTH`, speeds above `MAX_SPEED`.
    """
    arguments = {
        "speed": speed,
        "elevation": elevation,
        "azimuth": azimuth,
        "backspin": backspin,
        "sidespin": sidespin,
        "height": height,
        "distance": distance,
        "angle": angle,
    }
    arrays = {name: as_doubles(name, value) for name, value in arguments.items()}
    check_lengths("release", {name: arrays[name] for name in ("height", "distance")})
    check_speeds("release", {"speed": arrays["speed"]})
    check_angles("release", {name: arrays[name] for name in _ANGLES})
    check_spins("release", {name: arrays[name] for name in _SPINS})
    states = states_of(arrays)
    if not check_flag("jacobian", jacobian):
        return states
    return states, _jacobian(arrays, states.shape[:-1])


def states_of(arrays: Mapping[str, NDArray[np.float64]]) -> NDArray[np.float64]:
    """Return states as `release` does, without its checks of units.

    Parameters
    ----------
    arrays
        All arguments of `release`.

    Returns
    -------
    ndarray
        As of `release`.

    Raises
    ------
    ValueError
        If the shapes do not broadcast.
    """
    try:
        shape = np.broadcast_shapes(*(array.shape for array in arrays.values()))
    except ValueError:
        shapes = ", ".join(f"{name} {array.shape}" for name, array in arrays.items() if array.ndim)
        raise ValueError(f"release: the shapes do not broadcast: {shapes}") from None
    arrays = {**arrays, **{name: from_zero(name, arrays[name]) for name in FROM_ZERO}}
    return release_states(arrays, shape, RING_HEIGHT)


def _jacobian(arrays: Mapping[str, NDArray[np.float64]], shape: tuple[int, ...]) -> Jacobian:
    """Return the derivatives of states by the arguments of releases."""
    found = studies.release_jacobian(
        **{name: arrays[name] for name in _OF_JACOBIAN}, **turns(arrays)
    )
    by = {name: np.zeros((*shape, len(STATE))) for name in arrays}
    for entry, values in zip(studies.RESULTS["release_jacobian"], found, strict=True):
        component, name = entry.split("_by_")
        by[name][..., STATE.index(component)] = values
    return Jacobian({"state": np.stack(list(by.values()), axis=-1)}, tuple(by))
