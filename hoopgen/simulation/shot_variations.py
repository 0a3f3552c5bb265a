"""`Variations`: the derivatives of shots, and the distances that follow from them on demand."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hoopgen.core.jacobian import Jacobian
from hoopgen.core.parameters import Value
from hoopgen.core.validation import as_doubles
from hoopgen.engine.compiled_scene import CompiledScene

from .event_variations import event_derivatives
from .margins import change_distance, decision_names

Floats = NDArray[np.float64]

ROUNDING = 64 * np.finfo(np.float64).eps
"""Relative error that a covariance may have, from the roundings of its own computation."""


@dataclass(frozen=True)
class Variations:
    """The variations of some shots with their releases and parameters.

    Attributes
    ----------
    scene, parameters, releases
        Of the shots.
    jacobian, differentiable
        As of `variations.derivatives`.
    certain
        The shots of which no decision is uncertain, (n,).
    """

    scene: CompiledScene
    parameters: Mapping[str, Value]
    releases: Floats
    jacobian: Jacobian
    differentiable: NDArray[np.bool_]
    certain: NDArray[np.bool_]

    @property
    def decisions(self) -> tuple[str, ...]:
        """Names of the decisions, `decision_names`."""
        return decision_names(self.scene)

    def at_events(self, events: NDArray[np.void]) -> Jacobian:
        """Return `Shots.event_jacobian`, given the event log."""
        names, own = self.jacobian.names, (self.parameters, self.releases)
        return event_derivatives(self.scene, names, *own, self.certain, events)

    def change_distance(
        self,
        events: NDArray[np.void],
        covariance: ArrayLike | None,
        release: Jacobian | None,
    ) -> Floats:
        """Return `Shots.change_distance`, given the event log.

        Parameters
        ----------
        events
            The event log.
        covariance, release
            As for `Shots.change_distance`.
        """
        names = self.jacobian.names
        size = (1, len(names), len(names))
        spread = np.broadcast_to(np.eye(len(names)), size)
        if release is not None:
            spread = Jacobian({"state": spread}, names).chain(release, shots=len(self.releases))[
                "state"
            ]
        if covariance is not None:
            root = _root_of_covariance(covariance, spread.shape[2], len(self.releases))
            spread = spread @ root
        return change_distance(
            self.scene,
            names,
            self.parameters,
            self.releases,
            events,
            self.differentiable,
            spread,
        )


def _root_of_covariance(given: ArrayLike, variables: int, shots: int) -> Floats:
    """Return L of a covariance L L', (1 or n, j, j), or raise an error if it is none."""
    matrix = as_doubles("covariance", given)
    shapes = ((variables, variables), (shots, variables, variables))
    if matrix.shape not in shapes:
        raise ValueError(
            f"covariance: expected shape {shapes[0]} or {shapes[1]}, for {variables} variables; "
            f"got {matrix.shape}"
        )
    own = matrix.reshape(-1, variables, variables)
    largest = np.abs(own).max(axis=(1, 2), initial=0.0)
    slack = ROUNDING * variables * largest
    if not np.all(np.isfinite(own)) or np.any(
        np.abs(own - own.swapaxes(1, 2)).max(axis=(1, 2)) > slack
    ):
        raise ValueError("covariance: expected a symmetric matrix of finite numbers")
    # Variances may differ by many orders of magnitude between units: scaled, each is 1.
    diagonal = np.diagonal(own, axis1=1, axis2=2)
    scale = np.sqrt(np.maximum(diagonal, 0.0))
    inverse = np.where(scale > 0.0, 1.0 / np.where(scale > 0.0, scale, 1.0), 0.0)
    values, vectors = np.linalg.eigh(inverse[:, :, None] * own * inverse[:, None, :])
    if (
        np.any(values < -ROUNDING * variables)
        or np.any(diagonal < 0.0)
        or np.any(own[scale == 0.0] != 0.0)
    ):
        raise ValueError("covariance: expected no negative variance in any direction")
    root: Floats = scale[:, :, None] * vectors * np.sqrt(np.maximum(values, 0.0))[:, None, :]
    return root
