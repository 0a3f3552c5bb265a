"""The error set of a box of states, kept as Q r from contact to contact (Lohner's method).

Each contact adds to the models of the state what is not linear in the release. Carried on as balls,
one for each component, that would be wrapped anew at every contact. So it becomes a linear part
too: nine variables more, of a parallelepiped whose sides are nearly orthogonal (Lohner, in
Kaucher, Kulisch and Ullrich (eds.), Computerarithmetic, 1987, pp. 255-286).
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from flint import arb, arb_mat
from numpy.typing import NDArray

from .taylor_model import TaylorModel, as_model

_SCALES = np.array([1.0, 1.0, 1.0, 10.0, 10.0, 10.0, 50.0, 50.0, 50.0])
"""Typical sizes of position (m), velocity (m/s) and spin (rad/s), relative to one another. They
decide how the sides of the parallelepiped lie, and nothing that has to be proved."""


def condensed(state: Sequence[arb | TaylorModel], variables: int) -> list[arb | TaylorModel]:
    """Return the models of a state with all that is not linear in the release as one error set.

    With A the middles of the slopes by the release, M those of the slopes by the last error set,
    and ρ what is left, the state is c + A e + M η + ρ, |ρ| ≤ r. It lies in c + A e + Q η' r' with
    r' = |Q⁻¹ M| 1 + |Q⁻¹| r and η' in [-1, 1]^m, whatever the matrix Q is; Q⁻¹ is a matrix of balls
    that holds the inverse.

    Parameters
    ----------
    state
        The state, nine balls or models.
    variables
        The number of variables of the box. Slopes beyond it are those by the error set.
    """
    models = [as_model(component) for component in state]
    slopes = [[slope.mid() for slope in model.slopes] for model in models]
    left = [sum((s.rad() for s in model.slopes), model.centre.rad()) for model in models]
    # A component that is known exactly, such as the position along a plane's axis, stays exact.
    rows = [
        k for k, own in enumerate(slopes) if left[k] > 0 or any(s != 0 for s in own[variables:])
    ]
    if not rows or not all(model.centre.is_finite() for model in models):
        return list(state)  # nothing to do, or nothing is known
    errors = max(1, *(len(slopes[k]) - variables for k in rows))
    matrix = [
        [
            slopes[k][variables + j] if variables + j < len(slopes[k]) else arb(0)
            for j in range(errors)
        ]
        for k in rows
    ]
    sides = _sides(matrix, [left[k] for k in rows], _SCALES[rows])
    basis = arb_mat(sides.tolist())
    try:
        inverse = basis.inv()
    except ZeroDivisionError:  # not proved to have one; the state keeps the error set that it has
        return list(state)
    carried = (inverse * arb_mat(matrix)).tolist()
    lengths = [
        sum((one.abs_upper() for one in row), arb(0))
        + sum((one.abs_upper() * left[k] for one, k in zip(back, rows, strict=True)), arb(0))
        for row, back in zip(carried, inverse.tolist(), strict=True)
    ]
    found = list(models)
    for place, k in enumerate(rows):
        own = [slopes[k][j] if j < len(slopes[k]) else arb(0) for j in range(variables)]
        own += [
            arb(side) * r.upper() for side, r in zip(sides[place].tolist(), lengths, strict=True)
        ]
        found[k] = TaylorModel(models[k].centre.mid(), own, models[k].range)
    for k in set(range(len(models))) - set(rows):
        own = slopes[k][:variables]
        found[k] = TaylorModel(models[k].centre.mid(), own, models[k].range)
    return list(found)


def _sides(
    matrix: Sequence[Sequence[arb]], left: Sequence[arb], scales: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Return nearly orthogonal directions, in the order of the lengths of the error set's sides."""
    columns = np.array([[float(one) for one in row] for row in matrix]) / scales[:, None]
    columns = np.hstack([columns, np.diag([float(one) for one in left]) / scales[:, None]])
    order = np.argsort(-np.linalg.norm(columns, axis=0))
    orthogonal, _ = np.linalg.qr(columns[:, order], mode="complete")
    sides: NDArray[np.float64] = scales[:, None] * orthogonal
    return sides
