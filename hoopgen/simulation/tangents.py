"""`jvp` and `vjp`: products of the derivatives of shots with tangents and with cotangents."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Unpack

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hoopgen.core.parameters import ParameterValues, complete
from hoopgen.core.validation import as_doubles
from hoopgen.core.variables import STATE
from hoopgen.results.shots import Shots
from hoopgen.scene.lookup import SceneLike
from hoopgen.text.shorten import brief

from .lookup import engine_of
from .run import OtherOptions, run
from .variations import check_derivatives

Floats = NDArray[np.float64]


def jvp(
    states: ArrayLike,
    parameters: ParameterValues | None,
    tangents: Mapping[str, ArrayLike],
    *,
    scene: SceneLike = None,
    **options: Unpack[OtherOptions],
) -> tuple[Shots, dict[str, Floats]]:
    """Simulate shots, and return how their ends change with the releases and the parameters.

    Parameters
    ----------
    states, parameters, scene
        As for `simulate`.
    tangents
        By component of the state or parameter of the scene its change, one number or (n,).
    options
        Other options of `simulate` but `derivatives`.

    Returns
    -------
    tuple
        The shots, and the changes of "state" (n, 9) and "time" (n,) to first order; NaN where a
        shot is not `Shots.differentiable`.

    Raises
    ------
    TypeError, ValueError
        If an argument is not as described.
    """
    _refuse_derivatives(options, "tangents")
    engine = engine_of(scene)
    if not isinstance(tangents, Mapping):
        raise TypeError(f"tangents: expected changes by name, got {brief(tangents)}")
    names = check_derivatives(tangents, engine, "tangents")
    shots = run(engine, states, parameters, derivatives=names, **options)
    columns = np.empty((len(shots), len(tangents), 1))
    for column, (name, given) in enumerate(tangents.items()):
        change = as_doubles(f"tangents[{name!r}]", given)
        if change.shape not in ((), (len(shots),)):
            raise ValueError(
                f"tangents[{name!r}]: expected one number or {len(shots)}, one a shot; "
                f"got shape {change.shape}"
            )
        columns[:, column, 0] = change
    changes = {result: (matrix @ columns)[..., 0] for result, matrix in shots.jacobian.items()}
    return shots, {"state": changes["state"], "time": changes["time"][:, 0]}


def vjp(
    states: ArrayLike,
    parameters: ParameterValues | None,
    cotangents: Mapping[str, ArrayLike],
    *,
    scene: SceneLike = None,
    **options: Unpack[OtherOptions],
) -> tuple[Shots, dict[str, Floats]]:
    """Simulate shots, and return the gradients of weighted sums of their ends.

    Parameters
    ----------
    states, parameters, scene
        As for `simulate`.
    cotangents
        Weights of "state", (n, 9) or (9,), and of "time", (n,) or one number; one may be missing.
    options
        Other options of `simulate` but `derivatives`.

    Returns
    -------
    tuple
        The shots, and by component of the state and by finite parameter of the scene the derivative
        of each shot's weighted sum, (n,); NaN where a shot is not `Shots.differentiable`.

    Raises
    ------
    TypeError, ValueError
        If an argument is not as described.
    """
    _refuse_derivatives(options, "all variables")
    if not isinstance(cotangents, Mapping):
        raise TypeError(f"cotangents: expected weights by name, got {brief(cotangents)}")
    unknown = [name for name in cotangents if name not in ("state", "time")]
    if unknown or not cotangents:
        what = ", ".join(map(repr, unknown)) or "none"
        raise ValueError(f"cotangents: expected 'state', 'time' or both, got {what}")
    engine = engine_of(scene)
    given = complete(parameters, engine.table)
    finite = (name for name in engine.parameters if np.all(np.isfinite(given[name])))
    shots = run(engine, states, parameters, derivatives=(*STATE, *finite), **options)
    gradient = np.zeros((len(shots), len(shots.jacobian.names)))
    for result, shape in (("state", (len(shots), len(STATE))), ("time", (len(shots),))):
        if result in cotangents:
            weights = as_doubles(f"cotangents[{result!r}]", cotangents[result])
            if weights.shape not in (shape, shape[1:]):
                raise ValueError(
                    f"cotangents[{result!r}]: expected shape {shape} or {shape[1:]}, "
                    f"got {weights.shape}"
                )
            # One row a shot: -1 in place of the length would be ambiguous for no shots.
            rows = np.broadcast_to(weights, shape).reshape(len(shots), 1, int(np.prod(shape[1:])))
            gradient += (rows @ shots.jacobian[result])[:, 0]
    return shots, dict(zip(shots.jacobian.names, gradient.T, strict=True))


def _refuse_derivatives(options: Mapping[str, object], variables: str) -> None:
    if "derivatives" in options:
        raise TypeError(f"derivatives: those by {variables} are returned; leave it out")
