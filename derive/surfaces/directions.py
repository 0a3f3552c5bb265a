"""Vectors along and across a direction whose components are parameters, of length 1 or not.

The components are doubles, so that the direction's length is 1 up to a few roundings. Conditions
are homogeneous in it: with d × u and d·u for the offset d from a point of the axis,

    rho |u| = |d × u|,   h |u| = d·u

are the distance from the axis and the way along it, exactly, for any vector u.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from ..symbolic.conditionals import barrier

Direction = tuple[sp.Expr, sp.Expr, sp.Expr]


def along(direction: Sequence[sp.Expr], vector: Sequence[sp.Expr]) -> sp.Expr:
    """Return the scalar product of a direction and a vector.

    Parameters
    ----------
    direction, vector
        (3,) each.
    """
    return sp.Add(*(u * c for u, c in zip(direction, vector, strict=True)))


def squared_length(direction: Sequence[sp.Expr]) -> sp.Expr:
    """Return |u|²."""
    return sp.Add(*(u**2 for u in direction))


def per_length(direction: Sequence[sp.Expr]) -> sp.Expr:
    """Return 1/|u|."""
    square = squared_length(direction)
    if square.is_Rational:
        return sp.sqrt(1 / square)
    return barrier(1 / barrier(sp.sqrt(barrier(square))))


def across(direction: Sequence[sp.Expr], vector: Sequence[sp.Expr]) -> list[sp.Expr]:
    """Return d × u, as long as the component of d across u if |u| is 1.

    Parameters
    ----------
    direction
        u, (3,).
    vector
        d, (3,).
    """
    (a, b, c), (u, v, w) = vector, direction
    return [b * w - c * v, c * u - a * w, a * v - b * u]


def squared_distance(direction: Sequence[sp.Expr], vector: Sequence[sp.Expr]) -> sp.Expr:
    """Return |d × u|² = rho² |u|².

    Parameters
    ----------
    direction
        u, (3,), of any length but 0.
    vector
        d, (3,), from a point of the axis.
    """
    return sp.Add(*(part**2 for part in across(direction, vector)))


def perpendicular(direction: Sequence[sp.Expr], vector: Sequence[sp.Expr]) -> list[sp.Expr]:
    """Return d - u (d·u)/|u|², the component of d across u.

    Parameters
    ----------
    direction
        u, (3,), of any length but 0.
    vector
        d, (3,).
    """
    share = barrier(barrier(along(direction, vector)) / barrier(squared_length(direction)))
    return [barrier(c - u * share) for u, c in zip(direction, vector, strict=True)]


def distance_from_axis(direction: Sequence[sp.Expr], vector: Sequence[sp.Expr]) -> sp.Expr:
    """Return rho = |d × u|/|u|.

    Parameters
    ----------
    direction
        u, (3,), of any length but 0.
    vector
        d, (3,), from a point of the axis, m.
    """
    parts = [barrier(part) for part in across(direction, vector)]
    length = barrier(sp.sqrt(barrier(sp.Add(*(part**2 for part in parts)))))
    return barrier(length * per_length(direction))
