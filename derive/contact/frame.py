"""The contact frame (Eqs. 7-10).

Eq. 7 of the article picks the axis along which the normal is *largest*; for the backboard and the
bridge Eq. 8 is then 0/0. The article means the axis of the smallest component, which is used here.
"""

from __future__ import annotations

import sympy as sp

from ..symbolic.conditionals import IfAtMost
from ..symbolic.symbols import NORMAL


def frame_from_axis(normal: sp.Matrix, axis: int) -> sp.Matrix:
    """Return R = [n1 n2 n3] (Eqs. 8-10) built from the coordinate axis `axis` (0, 1 or 2).

    Parameters
    ----------
    normal
        The unit normal, (3,).
    axis
        The number of a coordinate axis to which the normal is not parallel.

    Returns
    -------
    Matrix
        (3, 3), whose columns are orthonormal; the last one is the normal.
    """
    unit = sp.Matrix([sp.Integer(i == axis) for i in range(3)])
    tangent = unit - normal.dot(unit) * normal
    # |n1'|² = 1 - n_axis² for a unit normal: written so, it is exact when n_axis is 0.
    n1 = tangent / sp.sqrt(1 - normal[axis] ** 2)
    n2 = normal.cross(n1)
    return sp.Matrix.hstack(n1, n2, normal)


def contact_frame() -> sp.Matrix:
    """Return R (Eq. 10) with the axis of the smallest component of the normal (see above)."""
    normal = sp.Matrix(NORMAL)
    size = [component**2 for component in NORMAL]
    frames = [frame_from_axis(normal, axis) for axis in range(3)]
    return sp.Matrix(
        3,
        3,
        lambda i, j: _of_smallest([frame[i, j] for frame in frames], size),
    )


def _of_smallest(values: list[sp.Expr], sizes: list[sp.Expr]) -> sp.Expr:
    """Return the value with the smallest size, the first of equals."""
    y_or_z = IfAtMost(sizes[1], sizes[2], values[1], values[2])
    x_or_z = IfAtMost(sizes[0], sizes[2], values[0], y_or_z)
    return IfAtMost(sizes[0], sizes[1], x_or_z, y_or_z)
