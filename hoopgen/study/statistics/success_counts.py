"""The number of successes of independent shots, each with a probability of its own.

The distribution is a convolution of as many distributions as there are shots: within blocks shot by
shot, all blocks together; then blocks are joined in pairs. Only positive numbers are multiplied and
added, so that nothing cancels. Tails are cut at every joint, so that a distribution is some forty
standard deviations long, whatever the number of shots is.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

_BLOCK = 64
_CUT = 1e-18
"""Probability that is cut from each tail at each joint: of a million shots less than 1e-13 in all,
below what a confidence that is given as a double can tell from 1."""


def count_distribution(p: Floats) -> tuple[int, Floats]:
    """Return the probabilities of the number of successes.

    Parameters
    ----------
    p
        Probability of each shot, (n,).

    Returns
    -------
    int, ndarray
        The least number that is kept, and the probabilities of it and of those after it.
    """
    blocks = max(1, -(-len(p) // _BLOCK))
    each = np.zeros((blocks, _BLOCK))  # a shot that cannot succeed changes nothing
    each.ravel()[: len(p)] = p
    chances = np.zeros((blocks, _BLOCK + 1))
    chances[:, 0] = 1.0
    for one in each.T:
        moved = chances[:, :-1] * one[:, None]
        chances *= 1.0 - one[:, None]
        chances[:, 1:] += moved
    parts = [_cut(0, row) for row in chances]
    while len(parts) > 1:
        pairs = zip(parts[::2], parts[1::2], strict=False)
        joined = [_cut(a + b, np.convolve(left, right)) for (a, left), (b, right) in pairs]
        parts = joined + parts[len(joined) * 2 :]
    return parts[0]


def count_quantile(p: Floats, at: float) -> int:
    """Return the least number of successes that is not exceeded with probability `at`.

    Parameters
    ----------
    p
        The probability of success of each trial, (n,).
    at
        The probability that is meant, from 0 to 1.
    """
    first, chances = count_distribution(p)
    return min(first + int(np.searchsorted(np.cumsum(chances), at)), len(p))


def _cut(first: int, chances: Floats) -> tuple[int, Floats]:
    """Return a distribution without tails that do not matter."""
    low = int(np.searchsorted(np.cumsum(chances), _CUT))
    high = len(chances) - int(np.searchsorted(np.cumsum(chances[::-1]), _CUT))
    return first + low, chances[low:high]
