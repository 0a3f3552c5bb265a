"""Free flights, along parabolas or through air; at a hoop the scene's parameters say which."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hoopgen.core.air_scene import FlyingScene, air_scene
from hoopgen.core.parameters import AIR_DEFAULTS
from hoopgen.generated.numpy import hoop

Floats = NDArray[np.float64]


def is_in_air(parameters: Iterable[str]) -> bool:
    """Return whether parameters of these names are those of a scene in air."""
    return set(AIR_DEFAULTS) <= set(parameters)


@dataclass(frozen=True)
class Flights:
    """Free flights, along parabolas or by the motion of a scene.

    Attributes
    ----------
    gravity
        m/s², against z; a number or (n,). Through air it is where a search begins.
    parameters
        Parameters of the scene by name, numbers or (n,), SI units, which `scene` flies with.
    scene
        The scene in air that flies them; None: they are parabolas.
    """

    gravity: Floats
    parameters: Mapping[str, Floats]
    scene: FlyingScene | None

    @classmethod
    def at_hoop(cls, parameters: Mapping[str, ArrayLike]) -> Flights:
        """Return the flights at a hoop, whose parameters say whether it is in air.

        Parameters
        ----------
        parameters
            Parameters of the scene; a gravity that is not given is NaN.
        """
        gravity = np.asarray(parameters.get("gravity", np.nan), np.float64)
        if not is_in_air(parameters):
            return cls(gravity, {}, None)
        names = ("ball_radius", *AIR_DEFAULTS)
        own = {name: np.asarray(parameters.get(name, np.nan), np.float64) for name in names}
        return cls(gravity, {"gravity": gravity, **own}, air_scene())

    @property
    def shape(self) -> tuple[int, ...]:
        """The shape to which gravity and parameters broadcast."""
        return np.broadcast_shapes(self.gravity.shape, *(v.shape for v in self.parameters.values()))

    def spread(self, shape: tuple[int, ...]) -> Flights:
        """Return flights as rows.

        Parameters
        ----------
        shape
            The shape to which they broadcast; its entries are the rows.
        """
        return self._each(lambda value: np.broadcast_to(value, shape).ravel())

    def at(self, rows: NDArray[np.intp]) -> Flights:
        """Return the flights of some rows."""
        return self._each(lambda value: value[rows])

    def _each(self, change: Callable[[Floats], Floats]) -> Flights:
        own = {name: change(value) for name, value in self.parameters.items()}
        return Flights(change(self.gravity), own, self.scene)

    def eased(self, part: float) -> Flights:
        """Return the flights in air of a part of the density."""
        if self.scene is None:
            return self
        density = part * self.parameters["air_density"]
        return replace(self, parameters={**self.parameters, "air_density": density})

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
        if self.scene is not None:
            return self.scene.fly(times, states, {**self.scene.parameters, **self.parameters})
        x, y, z, vx, vy, vz = np.moveaxis(states[..., :6], -1, 0)
        moved = hoop.flight(times, x, y, z, vx, vy, vz, self.gravity)
        past = np.where(times >= 0.0, 0.0, np.nan)
        return np.concatenate([np.stack(moved, -1) + past[..., None], states[..., 6:]], -1)

    def fall(self, states: Floats) -> Floats:
        """Return the states at which balls come down to the ring's height, (n, 9), NaN if not.

        Parameters
        ----------
        states
            States at the beginning, (n, 9).
        """
        if self.scene is not None:
            scene = self.scene
            return scene.fall(states, 0.0, {**scene.parameters, **self.parameters})[1]
        with np.errstate(invalid="ignore"):
            times, _ = hoop.descent(states[:, 2], states[:, 5], 0.0, self.gravity)
            return self.fly(np.asarray(times), states)
