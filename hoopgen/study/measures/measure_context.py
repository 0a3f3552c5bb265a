"""Some shots of which something is measured: what is known of them, and how to know more."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hoopgen.core.parameters import Value
from hoopgen.engine.compiled_scene import CompiledScene
from hoopgen.generated.numpy import hoop
from hoopgen.hoop.releases import RING_HEIGHT
from hoopgen.results.shots import Outcome, Shots
from hoopgen.simulation.simulate import simulate

Floats = NDArray[np.float64]


def rows_of(value: Value, rows: slice | NDArray[np.intp]) -> Value:
    """Return a parameter of some shots; one number for all stays.

    Parameters
    ----------
    value
        The parameter, one number or (n,).
    rows
        The shots that are wanted.
    """
    return value if isinstance(value, float) else value[rows]


@dataclass(frozen=True)
class Block:
    """Some shots: releases, results, parameters, their scene, and where rebounds are caught."""

    states: Floats
    results: Mapping[str, NDArray[Any]]
    parameters: Mapping[str, Value]
    scene: CompiledScene
    catching_height: float

    def __len__(self) -> int:
        return len(self.states)

    @cached_property
    def valid(self) -> NDArray[np.bool_]:
        """True for each shot that is valid."""
        return np.asarray(self.results["outcome"] != Outcome.INVALID)

    @cached_property
    def ended(self) -> NDArray[np.bool_]:
        """True for each shot that reached the end plane."""
        outcome = self.results["outcome"]
        return np.asarray((outcome == Outcome.MADE) | (outcome == Outcome.MISSED))

    def parameters_of(self, rows: NDArray[np.intp]) -> dict[str, Value]:
        """Return the parameters of some of the shots."""
        return {name: rows_of(value, rows) for name, value in self.parameters.items()}

    def again(self, rows: NDArray[np.intp], max_contacts: int, **options: Any) -> Shots:
        """Simulate some of the shots up to so many contacts.

        Parameters
        ----------
        rows
            The indices of the shots in this block.
        max_contacts
            The number of contacts at which a shot ends as capped.
        **options
            Further options of `simulate`.
        """
        return simulate(
            self.states[rows],
            self.parameters_of(rows),
            scene=self.scene,
            max_contacts=max_contacts,
            threads=1,
            **options,
        )

    def descent(self, states: Floats, level: ArrayLike) -> tuple[Floats, Floats]:
        """Return when flights from the states come down to a height, and where they are then.

        Parameters
        ----------
        states
            Position, velocity and spin at the starts of the flights, (n, 9), SI.
        level
            The height, one number or (n,), m.

        Returns
        -------
        ndarray, ndarray
            s, (n,), and x y z vx vy vz, (6, n); NaN if never.
        """
        if self.scene.kernels.PIECES:
            time, fallen = self.scene.fall(states, level, self.parameters)
            return time, fallen[:, :6].T
        x, y, z, vx, vy, vz, *_ = states.T
        gravity = self.parameters["gravity"]
        time, falling = hoop.descent(z, vz, level, gravity)
        time = np.where(time >= 0.0, time, np.nan)
        there = np.array(hoop.flight(time, x, y, z, vx, vy, vz, gravity))
        there[5] = np.where(time >= 0.0, falling, np.nan)  # which keeps its digits
        return time, there

    @property
    def floor(self) -> Value:
        """Height of the centre of a ball on the floor, above the ring's plane."""
        return self.parameters["ball_radius"] - RING_HEIGHT
