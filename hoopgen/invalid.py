"""Why shots are invalid, in words."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .engines import Engine
from .inputs import check_leaving, check_states
from .parameters import resolve
from .scenes import engine_of
from .simulation import simulate

__all__ = ["allowed", "not_allowed", "out_of_range", "reason", "why_invalid"]

RADII = {"ball_radius", "ring_radius", "wire_radius"}
"""Parameters of a hoop that have to fit together."""


def why_invalid(
    states: ArrayLike,
    parameters: Mapping[str, Any] | None = None,
    *,
    scene: Any = None,
    leaving: ArrayLike | None = None,
) -> list[str]:
    """Return why each shot is INVALID, in words.

    Parameters
    ----------
    states, parameters, scene, leaving
        As in `simulate`; SI units.

    Returns
    -------
    list of str
        One text for each shot, empty where the shot can be simulated.

    Raises
    ------
    TypeError, ValueError
        If an argument is not as described; the message says what is expected.

    Examples
    --------
    >>> import hoopgen
    >>> hoopgen.why_invalid([0, 0, 1, 1e20, 0, 0, 0, 0, 0])
    ['out of range: vx 1e+20; in a release at most 1.07374e+09']
    """
    releases = check_states(states)
    engine = engine_of(scene)
    left = check_leaving(leaving, len(releases), len(engine.surfaces))
    shots = simulate(
        releases, parameters, scene=scene, leaving=leaving, max_contacts=1, fields=("outcome",)
    )
    values = dict(
        zip(engine.table.defaults, resolve(parameters, len(releases), engine.table), strict=True)
    )
    texts = [""] * len(releases)
    for row in np.flatnonzero(shots.outcome == engine.outcomes["INVALID"]):
        own = {
            name: np.float64(np.broadcast_to(value, len(releases))[row])
            for name, value in values.items()
        }
        last = -1 if left is None else int(left[row])
        texts[row] = reason(releases[row], own, engine, last)
    return texts


def reason(
    state: NDArray[np.float64], parameters: Mapping[str, Any], scene: Engine, leaving: int = -1
) -> str:
    """Return why a shot is invalid that is, as the event loop begins it.

    Parameters
    ----------
    state
        Its release, (9,).
    parameters
        All of the scene, one number each.
    scene
        In which it is invalid.
    leaving
        The body that it leaves at the start, -1 for none.
    """
    wrong = [
        name
        for name, value in parameters.items()
        if not np.isfinite(value) and not (name in scene.infinite and value == np.inf)
    ]
    if wrong:
        return f"not finite: {', '.join(wrong)}"
    if not allowed(scene, parameters):
        names = not_allowed(scene, parameters)
        named = ", ".join(f"{name} {parameters[name]:g}" for name in names) or "several"
        positive = {name for name in names if parameters[name] > 0}
        fits = not (scene.has_hoop and names and positive == set(names) <= RADII)
        return (
            f"parameter not allowed: {named}{'' if fits else '; the ball is too big for the ring'}"
        )
    if sizes := out_of_range(scene, parameters):
        return f"out of range: {'; '.join(sizes)}"
    if not np.isfinite(state).all():
        return "not finite: the release"
    largest = scene.kernels.MAX_SIZE
    large = [
        f"{name} {value:g}"
        for name, value in zip(scene.kernels.STATE, state, strict=True)
        if abs(value) > largest
    ]
    if large:
        return f"out of range: {', '.join(large)}; in a release at most {largest:g}"
    bodies = np.arange(len(scene.surfaces))
    own = {name: float(value) for name, value in parameters.items()}
    # Inside one alone it could start if it left that one.
    shots = scene.simulate(
        np.tile(state, (len(bodies), 1)), own, leaving=bodies, max_contacts=1, fields=("outcome",)
    )
    left = np.flatnonzero(shots.outcome != scene.outcomes["INVALID"])
    inside = [scene.surfaces[index] for index in left if index != leaving]
    return f"inside the {inside[0]}" if len(inside) == 1 else "inside several surfaces"


def allowed(scene: Engine, parameters: Mapping[str, Any]) -> bool:
    """Return whether a scene allows all of its parameters, in their order, one number each."""
    found: bool = _evaluate(scene, "allowed", scene.table.inputs(parameters)) > 0
    return found


def not_allowed(scene: Engine, parameters: Mapping[str, Any]) -> list[str]:
    """Return the parameters with the usual value of any of which the others would be allowed."""
    usual = scene.table.defaults
    return [n for n in parameters if allowed(scene, {**parameters, n: np.float64(usual[n])})]


def out_of_range(scene: Engine, parameters: Mapping[str, Any]) -> list[str]:
    """Return the sizes with which arithmetic could over- or underflow, and what is expected.

    Parameters
    ----------
    scene
        Whose parameters these are.
    parameters
        All of them, one finite number each, allowed.
    """
    inputs = scene.table.inputs(parameters)
    if _evaluate(scene, "parameters_in_range", inputs, allowed=1.0):
        return []
    said = []
    for (name, (least, most)), value in zip(scene.kernels.SIZE_LIMITS.items(), inputs, strict=True):
        if not least <= abs(value) <= most:
            expected = f"{least:g} to {most:g}" if least else f"at most {most:g}"
            said.append(f"{name} {value:g}, expected a size of {expected}")
    return said or ["all coefficients of a surface's formula, which are too small"]


def _evaluate(scene: Engine, kernel: str, inputs: Any, **more: Any) -> Any:
    """Return the first output of a kernel, from the scene's inputs and what else it takes."""
    given = dict(zip(scene.kernels.VARIABLES.values(), map(np.float64, inputs), strict=True)) | more
    with np.errstate(all="ignore"):
        outputs = getattr(scene.kernels, kernel)(
            *(given[name] for name in scene.kernels.ARGUMENTS[kernel])
        )
    return outputs[0]
