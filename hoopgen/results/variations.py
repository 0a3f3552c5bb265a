"""`Variations`: what `Shots` knows of its derivatives, and the arrays of xarray made of them."""

from __future__ import annotations

from typing import Any, Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hoopgen.core.jacobian import BY_VARIABLE, END_ARRAYS, EVENT_ARRAYS, OF_EVENT, Jacobian
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
    variable, variable_unit = BY_VARIABLE
    by = f"derivative; its unit is that of the result by {variable_unit}"
    arrays = (
        (["shot", "component", variable], jacobian["state"], {"note": by}),
        (["shot", variable], jacobian["time"][:, 0], {"note": by}),
        (["shot"], differentiable),
    )
    coordinates = {
        "component": np.array(STATE),
        "unit": ("component", [STATE_UNITS[name] for name in STATE]),
        variable: np.array(jacobian.names),
        variable_unit: (variable, units),
    }
    return dict(zip(END_ARRAYS, arrays, strict=True)), coordinates


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
    (event, *of_event), (variable, _) = OF_EVENT, BY_VARIABLE
    arrays = (
        ([event, variable], jacobian["time"][:, 0]),
        ([event, "component", variable], jacobian["before"]),
        ([event, "component", variable], jacobian["after"]),
    )
    surfaces = np.array([*scene.surfaces, "end"])
    coordinates = (
        (event, events["shot"]),
        (event, events["time"], {"units": "s"}),
        (event, surfaces[events["surface"]]),
    )
    names = zip(of_event, coordinates, strict=True)
    return dict(zip(EVENT_ARRAYS, arrays, strict=True)), dict(names)
