"""Rotations by quaternions whose components are parameters, of length 1 or not.

The rotation by q = (w, x, y, z) is R/|q|² with a matrix R of products of the components, for which

    R Rᵀ = |q|⁴

exactly. So lengths along the rows and columns of R are |q|² times those of the scene, and no
condition needs a quotient.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

Quaternion = tuple[sp.Expr, sp.Expr, sp.Expr, sp.Expr]
"""The real part, then the part along x, y and z."""

Matrix = list[list[sp.Expr]]


def squared_norm(quaternion: Quaternion) -> sp.Expr:
    """Return |q|²."""
    return sp.Add(*(part**2 for part in quaternion))


def scaled_rotation(quaternion: Quaternion) -> Matrix:
    """Return R = |q|² times the rotation, in rows; its columns are the turned axes."""
    w, x, y, z = quaternion
    return [
        [w**2 + x**2 - y**2 - z**2, 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), w**2 - x**2 + y**2 - z**2, 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), w**2 - x**2 - y**2 + z**2],
    ]


def times(matrix: Matrix, vector: Sequence[sp.Expr]) -> list[sp.Expr]:
    """Return the product of a matrix and a vector.

    Parameters
    ----------
    matrix
        Rows of three components each.
    vector
        (3,).
    """
    return [sp.Add(*(m * v for m, v in zip(row, vector, strict=True))) for row in matrix]


def transposed(matrix: Matrix) -> Matrix:
    """Return the matrix with rows and columns exchanged."""
    return [list(column) for column in zip(*matrix, strict=True)]
