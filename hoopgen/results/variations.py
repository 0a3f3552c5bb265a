"""`Variations`: what `Shots` knows of its derivatives, and the arrays of xarray made of them."""

from __future__ import annotations

from typing import Any, Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hoopgen.core.jacobian import Jacobian
from hoopgen.core.units import UNITS
from hoopgen.core.variables import STATE, STATE_UNITS
from hoopgen.engine.compiled_scene import CompiledScene
from hoopgen.scene.lookup import variables_of


class Variations(Protocol):
    """The variations of some shots with their releases and parameters."""

    @property
    def jacobian(self) -> Jacobian:
        """Derivatives of the end."""

    @property
    def differentiable(self) -> NDArray[np.bool_]:
        """The mask of the shots that have derivatives, (n,)."""

    @property
    def decisions(self) -> tuple[str, ...]:
        """Names of the decisions."""

    def at_events(self, events: NDArray[np.void]) -> Jacobian:
        """Return `Shots.event_jacobian`, given the event log."""

    def change_distance(
        self,
        events: NDArray[np.void],
        covariance: ArrayLike | None,
        release: Jacobian | None,
    ) -> NDArray[np.float64]:
        """Return the distances as `Shots.change_distance` does, given the event log."""


def derivative_arrays(
    jacobian: Jacobian, differentiable: NDArray[np.bool_], scene: CompiledScene
) -> tuple[dict[str, Any], dict[str, Any]]:
    """Return the derivatives of the end as variables and coordinates of an xarray.Dataset.

    Parameters
    ----------
    jacobian
        Derivatives of the state (n, 9, k) and of the time (n, 1, k) at the end of n shots.
    differentiable
        The mask of the shots that have derivatives, (n,).
    scene
        The scene of the shots, which knows the units of its parameters.
    """
    known = variables_of(scene)
    units = [
        STATE_UNITS[name] if name in STATE else next(iter(UNITS[known[name].kind]), "")
        for name in jacobian.names
    ]
    by = "derivative; its unit is that of the result by variable_unit"
    data = {
        "state_derivative": (["shot", "component", "variable"], jacobian["state"], {"note": by}),
        "time_derivative": (["shot", "variable"], jacobian["time"][:, 0], {"note": by}),
        "differentiable": (["shot"], differentiable),
    }
    coordinates = {
        "component": np.array(STATE),
        "unit": ("component", [STATE_UNITS[name] for name in STATE]),
        "variable": np.array(jacobian.names),
        "variable_unit": ("variable", units),
    }
    return data, coordinates


def event_derivative_arrays(
    jacobian: Jacobian, events: NDArray[np.void], scene: CompiledScene
) -> tuple[dict[str, Any], dict[str, Any]]:
    """Return the derivatives at events as variables and coordinates of an xarray.Dataset.

    Parameters
    ----------
    jacobian
        Derivatives of the time (m, 1, k) and of the states before and after (m, 9, k) each event.
    events
        The event log, (m,).
    scene
        The scene of the shots, which knows the names of its surfaces.
    """
    data = {
        "event_time_derivative": (["event", "variable"], jacobian["time"][:, 0]),
        "before_derivative": (["event", "component", "variable"], jacobian["before"]),
        "after_derivative": (["event", "component", "variable"], jacobian["after"]),
    }
    surfaces = np.array([*scene.surfaces, "end"])
    coordinates = {
        "event_shot": ("event", events["shot"]),
        "event_time": ("event", events["time"], {"units": "s"}),
        "event_surface": ("event", surfaces[events["surface"]]),
    }
    return data, coordinates
