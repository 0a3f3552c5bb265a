"""The distribution of a fitted release: draws from it, and what the track alone says."""

from __future__ import annotations

from math import isinf

import numpy as np
from numpy.typing import NDArray
from scipy.special import chdtri

from hoopgen.study.models.random import POSTERIOR, normals, uniforms

Floats = NDArray[np.float64]

_LEFT = 1e-3
"""Part of a distribution before the track that is left, so that variances remain finite."""


def draw_errors(
    covariance: Floats, degrees: float, shots: int, seed: int, rows: tuple[int, int]
) -> Floats:
    """Return errors of fits, (n, shots, k).

    Those of each coordinate are of Student's t if the noise was estimated.

    Parameters
    ----------
    covariance
        Of position, velocity and, with k = 7, the backspin, (n, k, k); NaN where there is none.
    degrees
        Degrees of freedom of the noise of each coordinate.
    shots
        Draws of each fit.
    seed
        From 0 to 2^64 - 1.
    rows
        Numbers of the first fit and of that after the last, among all: a fit has the same draws
        whichever others are drawn.
    """
    begin, end = (shots * row for row in rows)
    noise = np.empty((len(covariance), shots, covariance.shape[1]))
    for axis in range(3):
        wide: Floats | float = 1.0
        if not isinf(degrees):
            chances = uniforms(seed, POSTERIOR + 3 * axis + 2, begin, end).reshape(-1, shots)
            free = max(degrees, 1.0)
            wide = np.sqrt(free / chdtri(free, chances))
        for k in range(2):
            plain = normals(seed, POSTERIOR + 3 * axis + k, begin, end).reshape(-1, shots)
            noise[:, :, axis + 3 * k] = plain * wide
    if noise.shape[2] > 6:
        noise[:, :, 6] = normals(seed, POSTERIOR + 9, begin, end).reshape(-1, shots)
    known = np.isfinite(covariance).all(axis=(1, 2))
    root = np.full(covariance.shape, np.nan)
    root[known] = np.linalg.cholesky(covariance[known])
    return np.asarray(noise @ np.swapaxes(root, 1, 2))


def without_prior(
    values: Floats, covariance: Floats, mean: Floats, precision: Floats
) -> tuple[Floats, Floats]:
    """Return values and covariance without a normal distribution of the last value before the fit.

    With the precision q of that, and the column c and the variance v of the last value, these are
    values + c q (last - mean) / (1 - q v) and covariance + c c^T q / (1 - q v).

    Parameters
    ----------
    values, covariance
        Of the fits, (n, k) and (n, k, k).
    mean, precision
        Of the last value before the fit, (n,) each.
    """
    column = covariance[:, :, -1]
    less = (1.0 - _LEFT) * precision
    with np.errstate(invalid="ignore"):
        gain = less / (1.0 - less * column[:, -1])
    moved = values + column * (gain * (values[:, -1] - mean))[:, None]
    wider = covariance + gain[:, None, None] * column[:, :, None] * column[:, None, :]
    return moved, wider
