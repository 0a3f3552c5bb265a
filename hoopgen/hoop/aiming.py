"""Releases whose flight comes down through a point, along a parabola or through air.

On a parabola from a place at rest the release is a closed form; through air, or from a place that
moves, it solves a shooting problem.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike

from .flights import Flights
from .parabolas import Arc, Floats, Values, parabola_through
from .releases import states_of
from .shooting import ShootingProblem


def aimed(
    wanted: Mapping[str, Floats],
    reach: Floats,
    rise: Floats,
    flights: Flights,
    arc: Arc = "high",
    *,
    backspin: Floats | float = 0.0,
    sidespin: Floats | float = 0.0,
    moving: tuple[Floats, Floats] | None = None,
) -> Values:
    """Return the releases whose flight comes down through a point, NaN where there is none.

    Parameters
    ----------
    wanted, reach, rise, arc
        As for `parabola_through`.
    flights
        How the ball flies, and its gravity; numbers or arrays.
    backspin, sidespin
        rad/s; on a parabola they do not matter.
    moving
        Velocity of the place of the release, m/s, towards the point and to the left of it, to which
        that of the release is added. None: it does not move.

    Returns
    -------
    dict
        `speed` (m/s), `elevation` and `azimuth` (rad, relative to the place; the azimuth from the
        line to the point, positive to the left), `entry_angle` (rad, below the horizontal) and
        `time` (s); of one shape, that of all arguments that matter.
    """
    if moving is None and flights.scene is None:
        found, possible = parabola_through(wanted, reach, rise, flights.gravity, arc)
        possible = possible & np.isfinite(found["time"])
        found["azimuth"] = np.zeros(())
        return {name: np.where(possible, value, np.nan) for name, value in found.items()}
    velocity = (np.zeros(()), np.zeros(())) if moving is None else moving
    given = {"reach": reach, "rise": rise, "backspin": backspin, "sidespin": sidespin}
    given |= {"ahead": velocity[0], "aside": velocity[1], **wanted}
    shape = np.broadcast_shapes(*map(np.shape, given.values()), flights.shape)
    rows = {
        name: np.broadcast_to(np.asarray(value, np.float64), shape).ravel()
        for name, value in given.items()
    }
    problem = ShootingProblem(
        np.stack([np.where(rows["reach"] > 0.0, rows["reach"], np.nan), rows["rise"]], -1),
        np.stack([rows["backspin"], rows["sidespin"]], -1),
        np.stack([rows["ahead"], rows["aside"]], -1),
        flights.spread(shape),
    )
    with np.errstate(all="ignore"):
        solved = problem.solved({name: rows[name] for name in wanted}, arc)
    return {name: value.reshape(shape) for name, value in solved.items()}


def flown_distance(release: Mapping[str, float], parameters: Mapping[str, ArrayLike]) -> float:
    """Return the distance on the floor plan at which a ball comes down to the ring's height, m.

    Parameters
    ----------
    release
        Arguments of `hoopgen.release`, one number each; spins that are not there are 0.
    parameters
        Parameters of the scene, which say whether it has air.

    Returns
    -------
    float
        NaN if the ball does not rise to the ring's height.
    """
    arguments = dict.fromkeys(("azimuth", "backspin", "sidespin", "angle"), 0.0) | dict(release)
    names = ("speed", "elevation", "azimuth", "backspin", "sidespin", "height", "distance", "angle")
    state = states_of({name: np.asarray(arguments[name], np.float64) for name in names})
    end = Flights.at_hoop(parameters).spread((1,)).fall(state[None])
    return float(np.hypot(*(end[0, :2] - state[:2])))
