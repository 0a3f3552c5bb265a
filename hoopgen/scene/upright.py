"""The rotation of a scene that turns gravity down, for pictures and pages."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .scene_reader import ParsedScene

_PRIME = chr(0x2032)  # after the names of axes that are turned by less than a right angle


def acceleration(read: ParsedScene, values: Mapping[str, Any]) -> NDArray[np.float64]:
    """Return the acceleration of free fall, (3,) or (n, 3), m/s².

    Parameters
    ----------
    read
        The scene.
    values
        Its inputs by name, a number or (n,) each.
    """
    if len(read.down) == 3:
        parts = [np.asarray(part.evaluate(values), dtype=np.float64) for part in read.down]
    else:
        axis, way = read.down
        size = np.asarray(read.gravity.evaluate(values), dtype=np.float64)
        parts = [way * size if k == axis else np.zeros_like(size) for k in range(3)]
    return np.stack(np.broadcast_arrays(*parts), axis=-1)


def upright(
    read: ParsedScene, values: Mapping[str, Any]
) -> tuple[NDArray[np.float64], tuple[str, str, str]]:
    """Return the rotation that turns gravity down, and the names of the axes after it.

    Parameters
    ----------
    read
        The scene.
    values
        Its inputs by name, a number each.

    Returns
    -------
    tuple
        The matrix (3, 3), and three names. If gravity is along an axis, or zero, each row has one
        entry, 1 or -1, and a name has a minus where an axis is seen the other way round. For any
        other direction it is the smallest rotation, and the names have primes.
    """
    if len(read.down) == 2:
        return upright_along(*read.down)
    down = acceleration(read, values)
    size = float(np.linalg.norm(down))
    if not size > 0.0:
        return upright_along(2, -1)
    x, y, z = down / size
    if x == 0.0 and y == 0.0:
        return upright_along(2, 1 if z > 0.0 else -1)
    # Rodrigues' rotation about the horizontal direction across gravity, from it to -z.
    across = np.array([-y, x, 0.0]) / np.hypot(x, y)
    ux, uy, _ = across
    cross = np.array([[0.0, 0.0, uy], [0.0, 0.0, -ux], [-uy, ux, 0.0]])
    turn = np.eye(3) + np.hypot(x, y) * cross + (1.0 + z) * (cross @ cross)
    return turn, (f"x{_PRIME}", f"y{_PRIME}", f"z{_PRIME}")


def upright_along(axis: int, sign: int) -> tuple[NDArray[np.float64], tuple[str, str, str]]:
    """Return the result of `upright` for gravity along an axis.

    Parameters
    ----------
    axis, sign
        Which coordinate, and which way.
    """
    turn = np.roll(np.eye(3), axis - 2, axis=1)
    if sign > 0:
        turn = np.diag([1.0, -1.0, -1.0]) @ turn
    names = []
    for row in turn:
        k = int(np.flatnonzero(row)[0])
        names.append(f"{chr(0x2212) if row[k] < 0 else ''}{'xyz'[k]}")
    return turn, (names[0], names[1], names[2])
