"""Points of bodies at which a ball is aimed: the middle of a ring, or of the mouth of a funnel."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hoopgen.text.shorten import brief, join_names

from .formulas import Formula
from .parsed_shapes import RevolvedShape, Shape
from .scene import Scene

Floats = NDArray[np.float64]

_CENTRED = ("sphere", "disc", "torus", "oblique torus", "oblique box")
"""Kinds of bodies of whose sizes the centre is one."""


def target_point(scene: Scene, values: Mapping[str, Any], name: str) -> Floats:
    """Return the point at which a ball is aimed that is to meet a body, (..., 3), m.

    It is the centre of a torus, a disc, a sphere and a box, the middle of the open end of a cone,
    and the middle of the highest circle of a surface of revolution.

    Parameters
    ----------
    scene
        The scene.
    values
        Its inputs by name, numbers or (...).
    name
        Of the body.

    Raises
    ------
    ValueError
        If there is no such body, or it has no such point.
    """
    bodies = {shape.name: shape for shape in scene.read.bodies}
    if name not in bodies:
        raise ValueError(
            f"target: {brief(name)} is no body of the scene {scene.name}, which has "
            f"{join_names(bodies)}"
        )
    shape = bodies[name]
    if isinstance(shape, RevolvedShape):
        places = (_evaluated(one.place, values) for one in shape.profile.vertices)
        circles = np.stack(np.broadcast_arrays(*places))
        highest = np.argmax(circles[..., 2], axis=0)
        return np.asarray(np.take_along_axis(circles, highest[None, ..., None], axis=0)[0])
    if shape.kind in _CENTRED:
        return _vector(shape, values, "centre")
    if shape.kind == "box":
        return np.asarray((_vector(shape, values, "from") + _vector(shape, values, "to")) / 2.0)
    sizes = dict(shape.sizes)
    if shape.kind == "cone" and "span to" in sizes:
        direction = _vector(shape, values, "direction")
        length = np.sqrt(np.sum(direction**2, axis=-1, keepdims=True))
        end = np.asarray(sizes["span to"].evaluate(values), np.float64)[..., None]
        return np.asarray(_vector(shape, values, "apex") + end * (direction / length))
    said = "a cone without a second end of its span" if shape.kind == "cone" else f"a {shape.kind}"
    raise ValueError(
        f"target: the body {name} is {said}, which has no point to aim at; give the point, or the "
        "name of a torus, a disc, a sphere, a box, a cone with its span or a revolution"
    )


def _vector(shape: Shape, values: Mapping[str, Any], argument: str) -> Floats:
    """Return a vector of the sizes of a body; a component that it has not is 0."""
    sizes = dict(shape.sizes)
    return _evaluated([sizes.get(f"{argument} {axis}") for axis in "xyz"], values)


def _evaluated(vector: Sequence[Formula | None], values: Mapping[str, Any]) -> Floats:
    parts = [0.0 if part is None else part.evaluate(values) for part in vector]
    arrays = np.broadcast_arrays(*(np.asarray(part, np.float64) for part in parts))
    return np.stack(arrays, axis=-1)
