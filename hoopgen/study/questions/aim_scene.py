"""The flights and the targets of a scene in which a ball is aimed."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hoopgen.core.parameters import ParameterValues
from hoopgen.core.validation import as_doubles
from hoopgen.hoop.flights import Flights
from hoopgen.scene.scene import Scene
from hoopgen.scene.target_points import target_point
from hoopgen.scene.upright import acceleration
from hoopgen.simulation.engine import Engine
from hoopgen.text.shorten import brief

Floats = NDArray[np.float64]


def flights_of(engine: Engine, parameters: ParameterValues) -> Flights:
    """Return the flights of balls in a scene, parabolas or through air.

    Where gravity does not point along -z it is NaN.

    Parameters
    ----------
    engine
        The scene.
    parameters
        All its parameters.

    Raises
    ------
    ValueError
        If it is written for derivation, or its gravity points along -z for no parameters.
    """
    own = {name: as_doubles(f"parameters[{name!r}]", v) for name, v in parameters.items()}
    if engine.has_hoop:
        return Flights.at_hoop(own)
    scene = _written(engine)
    down = acceleration(scene.read, _inputs(scene, own))
    across = np.any(down[..., :2] != 0.0, axis=-1) | (down[..., 2] >= 0.0)
    if np.all(across):
        first = down.reshape(-1, 3)[0] + 0.0
        raise ValueError(
            f"aim: expected a scene whose gravity points along -z; in {engine.name} it is "
            f"({', '.join(f'{part:g}' for part in first)}) m/s²"
        )
    gravity = np.where(across, np.nan, -down[..., 2])
    flying = {name: value for name, value in own.items() if name not in engine.infinite}
    return Flights(gravity, flying, engine if engine.in_air else None)


def target_of(
    engine: Engine, parameters: ParameterValues, target: ArrayLike | str
) -> dict[str, Floats]:
    """Return the components of a target: of a point, or of the point of a body.

    Parameters
    ----------
    engine, parameters
        As for `flights_of`.
    target
        The point, (..., 3), or the name of a body of a scene without a hoop.

    Raises
    ------
    ValueError
        If it is no point, or there is no such body.
    """
    if not isinstance(target, str):
        return components("target", target, "xyz")
    if engine.has_hoop:
        raise ValueError(
            f"target: expected x, y and z, got {brief(target)}; bodies have names to aim at only "
            "in scenes without a hoop"
        )
    scene = _written(engine)
    point = target_point(scene, _inputs(scene, parameters), target)
    return components("target", point, "xyz")


def components(name: str, given: ArrayLike, axes: str) -> dict[str, Floats]:
    """Return the components of a vector by name.

    Parameters
    ----------
    name
        Of the argument.
    given
        The vector, (..., k).
    axes
        The names of its k components, a letter each.

    Raises
    ------
    ValueError
        If its shape is another.
    """
    vector = as_doubles(name, given)
    if not vector.ndim or vector.shape[-1] != len(axes):
        expected = " and ".join(", ".join(axes).rsplit(", ", 1))
        raise ValueError(
            f"{name}: expected {expected}, shape (..., {len(axes)}), got shape {vector.shape}"
        )
    return {f"{name} {axis}": vector[..., k] for k, axis in enumerate(axes)}


def _written(engine: Engine) -> Scene:
    if isinstance(engine.table.written, Scene):
        return engine.table.written
    raise ValueError(
        f"aim: the scene {engine.name} is written for derivation; expected a hoop, or a scene of "
        "the pieces of hoopgen.scene"
    )


def _inputs(scene: Scene, parameters: ParameterValues) -> dict[str, Floats]:
    names = (one.name for one in scene.inputs)
    values = scene.values(parameters)
    return {name: np.asarray(v, np.float64) for name, v in zip(names, values, strict=True)}
