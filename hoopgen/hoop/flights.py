"""Free flights at a hoop, along parabolas or through air; the parameters of a scene say which."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hoopgen.core.air_scene import air_scene
from hoopgen.generated.numpy import hoop

from .air import AIR_DEFAULTS

__all__ = ["Flights", "is_in_air"]

Floats = NDArray[np.float64]


def is_in_air(parameters: Iterable[str]) -> bool:
    """Return whether parameters of these names are those of a scene in air."""
    return set(AIR_DEFAULTS) <= set(parameters)


@dataclass(frozen=True)
class Flights:
    """Free flights with parameters of their own.

    Attributes
    ----------
    parameters
        Parameters of the scene by name, (n,) each, SI units; those of the air and `ball_radius` are
        used only if all of the air's are there.
    """

    parameters: Mapping[str, Floats]

    @staticmethod
    def used(parameters: Mapping[str, ArrayLike]) -> dict[str, Floats]:
        """Return the parameters that matter to flights; a gravity that is not given is NaN."""
        names = ("gravity", *(("ball_radius", *AIR_DEFAULTS) if is_in_air(parameters) else ()))
        return {name: np.asarray(parameters.get(name, np.nan), np.float64) for name in names}

    @classmethod
    def of(cls, used: Mapping[str, Floats], shape: tuple[int, ...]) -> Flights:
        """Return flights as rows.

        Parameters
        ----------
        used
            Parameters, as of `used`, numbers or arrays.
        shape
            The shape to which they broadcast; its entries are the rows.
        """
        return cls({n: np.broadcast_to(value, shape).ravel() for n, value in used.items()})

    def at(self, rows: NDArray[np.intp]) -> Flights:
        """Return the flights of some rows."""
        return Flights({name: value[rows] for name, value in self.parameters.items()})

    def eased(self, part: float) -> Flights:
        """Return the flights in air of a part of the density."""
        if not is_in_air(self.parameters):
            return self
        density = part * self.parameters["air_density"]
        return Flights({**self.parameters, "air_density": density})

    def fly(self, times: Floats, states: Floats) -> Floats:
        """Return the states after free flights.

        Parameters
        ----------
        times
            Durations, s, (..., n).
        states
            States at the beginning, (..., n, 9).

        Returns
        -------
        ndarray
            States at the end, (..., n, 9); NaN where a duration is negative or not finite.
        """
        if is_in_air(self.parameters):
            scene = air_scene()
            return scene.fly(times, states, {**scene.parameters, **self.parameters})
        x, y, z, vx, vy, vz = np.moveaxis(states[..., :6], -1, 0)
        moved = hoop.flight(times, x, y, z, vx, vy, vz, self.parameters["gravity"])
        past = np.where(times >= 0.0, 0.0, np.nan)
        return np.concatenate([np.stack(moved, -1) + past[..., None], states[..., 6:]], -1)

    def fall(self, states: Floats) -> Floats:
        """Return the states at which balls come down to the ring's height, (n, 9), NaN if not.

        Parameters
        ----------
        states
            States at the beginning, (n, 9).
        """
        if is_in_air(self.parameters):
            scene = air_scene()
            return scene.fall(states, 0.0, {**scene.parameters, **self.parameters})[1]
        with np.errstate(invalid="ignore"):
            times, _ = hoop.descent(states[:, 2], states[:, 5], 0.0, self.parameters["gravity"])
            return self.fly(np.asarray(times), states)
