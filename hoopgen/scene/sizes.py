"""Numbers of shapes that are drawn: their sizes, and the angles of a turn."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from .formulas import Formula
from .meshes import Floats
from .parsed_shapes import Shape

Number = Callable[[Formula], float]
"""The value of a size of the scene."""


def vector(shape: Shape, number: Number, argument: str) -> Floats:
    """Return three sizes of a shape, (3,); 0 for those that it does not have.

    Parameters
    ----------
    shape, number
        The shape, and the value of its sizes.
    argument
        The name of the vector, such as ``centre``.
    """
    sizes = dict(shape.sizes)
    own = (sizes.get(f"{argument} {axis}") for axis in "xyz")
    return np.array([0.0 if size is None else number(size) for size in own])


def turn_angles(count: int) -> Floats:
    """Return the angles from 0 that divide a turn evenly, (count,)."""
    return np.linspace(0.0, 2.0 * np.pi, count, endpoint=False)
