"""Normals of surfaces away from a contact, and changes of distances that are no more than rounding.

The kernels have the normal at a contact, the vector from the nearest point divided by its length
there, R. At any other distance its length is another one, and the unit normal n is that direction.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from hoopgen.core.variables import STATE

from .variations import VariedPath

Floats = NDArray[np.float64]

NORMAL, VELOCITY = ("nx", "ny", "nz"), STATE[3:6]

ROUNDING = 2.0**-44
"""Part of the sizes of its terms below which a change of a distance is none. Where the terms
cancel, as those by the components of the velocity do if a body is passed beside the line of flight,
some roundings are left, and at a smallest distance those of its time, times some hundred."""


def unit_normal(path: VariedPath, face: str, given: Mapping[str, Any]) -> dict[str, Any]:
    """Return the components of the unit normal of a surface at any distance, by name.

    In the core of a body, where there is no normal, they are NaN.

    Parameters
    ----------
    path
        The path, which has the kernels.
    face
        The surface.
    given
        The arguments of kernels by name, positions among them.
    """
    found = path.call(f"{face}_normal", dict(given))
    length = np.sqrt(sum(np.square(found[name]) for name in NORMAL))
    with np.errstate(divide="ignore", invalid="ignore"):
        return {name: found[name] / length for name in NORMAL}


def without_rounding(
    change: Any, given: Mapping[str, Any], moved: Sequence[Any], delay: Any = 0.0
) -> Floats:
    """Return the changes of a distance, (k, j), 0 where they are only rounding.

    A change is n·(δx + v δt). It is 0 at an event on a parallel plane, where δt = -n·δx / n·v.

    Parameters
    ----------
    change
        As computed, (k, j) or what broadcasts to it.
    given
        By name the normal n of the surface and the velocity v, (j,).
    moved
        The three components of δx + v δt, (k, j).
    delay
        The delay δt, s, (k, j); 0 at a fixed time.
    """
    each = zip(NORMAL, VELOCITY, moved, strict=True)
    size = sum(np.abs(given[n]) * (np.abs(d) + np.abs(given[v] * delay)) for n, v, d in each)
    return np.where(np.abs(change) <= ROUNDING * size, 0.0, change)
