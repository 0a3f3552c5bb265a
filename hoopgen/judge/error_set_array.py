"""The error sets of many shots, kept as Q r from contact to contact (Lohner's method).

Each contact leaves models of the state with slopes M by the last error set, and radii ρ. Carried on
as radii, what is in ρ would be wrapped anew at every contact. So the state lies in c + M e + ρ e',
and in c + Q (r e'') with

    r = |Q⁻¹ M| 1 + |Q⁻¹| ρ,

whatever the matrix Q is; one with orthogonal columns along the slopes makes r small. Computed are
Qᵀ M and |Qᵀ| ρ. With ε the largest entry of |I - Qᵀ Q|, Q⁻¹ = (I - (I - Qᵀ Q))⁻¹ Qᵀ, and the sum
of the geometric series is at most I + ε/(1 - 9 ε) 1 1ᵀ in each entry, if 9 ε < 1. That is less than
I + 1.1 ε 1 1ᵀ where ε < 2^-20; elsewhere the error set becomes a box, Q = I. The products Qᵀ Q and
Qᵀ M have roundings of at most 10 u times the sums of the terms' sizes. Columns of Q are nearly 1
long. So this is at most 11 u in ε, and in Qᵀ m, with m a column of M, 11 u |m| in Euclid's norm:
no more than 1.1 times 11 u times the sum of |Qᵀ m|. The new slopes Q r are rounded by u times their
sizes, which is at most 2 u times the sum of the lengths r across each side. With `PRODUCTS` = 32 u
in ε, twice ε times that sum is enough for all three.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from .ball_array import OUTWARDS, TINY, UNIT, Floats
from .model_array import SLOPES, ModelArray

PRODUCTS = 32 * UNIT
SCALES = np.array([1.0, 1.0, 1.0, 8.0, 8.0, 8.0, 64.0, 64.0, 64.0])[:, None]
"""Typical sizes of position (m), velocity (m/s) and spin (rad/s), relative to one another; powers
of two, so that dividing by them rounds nothing. They decide how the sides of the parallelepiped
lie, and nothing that has to be proved."""

_PASSES = 2
"""Passes of Gram and Schmidt's method, after which columns are orthogonal but for roundings."""


def condensed(state: Sequence[ModelArray]) -> list[ModelArray]:
    """Return the models of states with all errors as one error set.

    Parameters
    ----------
    state
        Nine models; some have slopes.
    """
    shots = len(state[0].high)
    none = np.zeros((SLOPES, shots))
    slopes = np.array([none if m.slopes is None else m.slopes for m in state]) / SCALES[:, None]
    radii = np.array([m.radius for m in state]) / SCALES
    sides = _sides(slopes, radii)
    gram = np.einsum("kin,kjn->ijn", sides, sides)
    skew = np.abs(gram - np.eye(SLOPES)[:, :, None]).max(axis=(0, 1)) + PRODUCTS
    boxed = ~(skew < 2.0**-20)
    sides[:, :, boxed] = np.eye(SLOPES)[:, :, None]
    skew[boxed] = PRODUCTS
    onto = np.abs(np.einsum("kin,kjn->ijn", sides, slopes)).sum(axis=1)
    lengths = onto + np.einsum("kin,kn->in", np.abs(sides), radii)
    lengths = (lengths + 2 * skew * lengths.sum(axis=0)) * OUTWARDS + TINY
    found = sides * lengths * SCALES[:, None]
    return [
        ModelArray(m.high, m.low, np.zeros(shots), own) for m, own in zip(state, found, strict=True)
    ]


def _sides(slopes: Floats, radii: Floats) -> Floats:
    """Return nearly orthogonal directions, (9, 9, n), a column each (Gram and Schmidt).

    A small part of the identity gives columns a direction that have none.
    """
    size = np.abs(slopes).sum(axis=1) + radii
    added = radii + 2.0**-40 * size.max(axis=0)
    columns = slopes + np.eye(SLOPES)[:, :, None] * added
    sides: Floats = np.zeros_like(columns)
    for j in range(SLOPES):
        own = columns[:, j]
        for _ in range(_PASSES):
            before = sides[:, :j]
            own = own - np.einsum("kin,in->kn", before, np.einsum("kin,kn->in", before, own))
            own = own / np.sqrt((own * own).sum(axis=0))
        sides[:, j] = own
    return sides
