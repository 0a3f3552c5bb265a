"""Random numbers by counter: what shot i draws depends on the seed, on what it is for, and on i.

Philox (Salmon et al. 2011, *Parallel random numbers: as easy as 1, 2, 3*) is keyed by the seed and
a stream, one for each variable, and counts shots. So a shot is the same whatever the chunks and
threads, and two settings drawn from one seed share their random numbers.
"""

from __future__ import annotations

from math import sqrt

import numpy as np
from numpy.typing import NDArray

from hoopgen.core.validation import check_count
from hoopgen.engine import draws

ROW_OF_RELEASES, ROW_OF_SAMPLE, ORDER_OF_ROWS = 1 << 32, 2 << 32, 3 << 32
SMOOTHING = 4 << 32
POSTERIOR = 5 << 32
"""Streams that choose rows, of measured releases and of a table to look at, that shuffle measured
releases, and from here on smooth them, or draw from the fit of a track; those of variables are far
below. A choice by the numbers that made the rows would not be a random one."""


def uniforms(seed: int, stream: int, start: int, stop: int) -> NDArray[np.float64]:
    """Return numbers of shots `start` to `stop` - 1, uniform in the open interval (0, 1).

    Parameters
    ----------
    seed
        From 0 to 2^64 - 1; the key's lower half.

    Returns
    -------
    ndarray
        (stop - start,), odd multiples of 2^-53.
    """
    return draws.uniforms(check_seed(seed), stream, start, stop)


def normals(seed: int, stream: int, start: int, stop: int) -> NDArray[np.float64]:
    """Return standard normal numbers of shots `start` to `stop` - 1, one from each uniform one.

    The inverse of the distribution, which takes one number for one: nothing is rejected, so that
    the counter stays the shot's index.

    Parameters
    ----------
    seed
        The seed of the random numbers.
    stream
        The number of the stream, which separates the uses of one seed.
    start
        The index of the first shot.
    stop
        The index after that of the last shot.
    """
    one = draws.Noise((stream,), np.ones((1, 1)), np.ones(1))
    numbers: NDArray[np.float64] = one.draw(check_seed(seed), start, stop)[0]
    return numbers


def factor(correlations: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the lower triangular factor of a correlation matrix (Cholesky), in a fixed order.

    LAPACK's sums are in an order of its own, which depends on the processor.

    Parameters
    ----------
    correlations
        (n, n), symmetric.

    Raises
    ------
    numpy.linalg.LinAlgError
        If the matrix is not positive definite.
    """
    given = correlations.tolist()  # Python's numbers take a tenth of the time of NumPy's scalars
    lower = np.zeros_like(correlations).tolist()
    for i, row in enumerate(lower):
        for j in range(i + 1):
            rest = given[i][j]
            for k in range(j):
                rest = rest - row[k] * lower[j][k]
            if i > j:
                row[j] = rest / lower[j][j]
            elif rest > 0.0:
                row[i] = sqrt(rest)
            else:
                raise np.linalg.LinAlgError("the matrix is not positive definite")
    return np.array(lower, np.float64).reshape(correlations.shape)


def check_two_seeds(seed: int) -> int:
    """Return a seed as an int: that of a search, after which there is one for fresh shots."""
    if check_seed(seed) == 2**64 - 1:
        raise ValueError(
            f"seed: expected 2**64 - 2 at most, as the one after it is used too, got {seed}"
        )
    return int(seed)


def check_seed(seed: int) -> int:
    """Return the seed as an int."""
    return check_count(
        "seed", seed, least=0, most=2**64 - 1, expected="a whole number from 0 to 2**64 - 1"
    )
