"""Intervals of a share and of a difference of shares, and how many shots a narrow one takes."""

from __future__ import annotations

from fractions import Fraction
from math import sqrt

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.special import ndtri

__all__ = ["least_shots", "newcombe", "wilson"]


def wilson(
    made: ArrayLike, shots: ArrayLike, confidence: float
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return the ends of Wilson's score interval (1927) of a probability.

    Parameters
    ----------
    made, shots
        Whole numbers that broadcast. Of no shots nothing is known: from 0 to 1.
    confidence
        Within 0 and 1.
    """
    n, k = np.asarray(shots, dtype=np.float64), np.asarray(made, dtype=np.float64)
    z = -float(ndtri(0.5 * (1.0 - confidence)))  # near 1 this keeps its digits
    with np.errstate(invalid="ignore"):
        half = z * np.sqrt(k * (n - k) / n + 0.25 * z * z)
    middle, whole = k + 0.5 * z * z, n + z * z
    low = np.where(k > 0, (middle - half) / whole, 0.0)
    high = np.where(k < n, (middle + half) / whole, 1.0)
    return low, high


def newcombe(
    both: int, only_first: int, only_second: int, neither: int, confidence: float
) -> tuple[float, float]:
    """Return the interval of a difference of paired proportions, the first less the second.

    R. G. Newcombe (1998), Improved confidence intervals for the difference between binomial
    proportions based on paired data, Statistics in Medicine 17, method 10: the distances to the
    ends of Wilson's two intervals are combined as the sides of a triangle whose angle is that of
    the correlation, which is corrected for continuity. Of no pairs nothing is known: from -1 to 1.
    """
    pairs = both + only_first + only_second + neither
    if not pairs:
        return -1.0, 1.0
    made = both + only_first, both + only_second
    (low_1, low_2), (high_1, high_2) = wilson(made, pairs, confidence)
    first, second = made[0] / pairs, made[1] / pairs
    # Products of counts outgrow 64 bits: Python's whole numbers do not.
    spread = made[0] * (pairs - made[0]) * made[1] * (pairs - made[1])
    concord, discord = both * neither, only_first * only_second
    excess = max(concord - discord - pairs / 2, 0.0) if concord > discord else concord - discord
    correlation = excess / sqrt(spread) if spread else 0.0

    def combined(one: float, other: float) -> float:
        return sqrt(max(one * one - 2.0 * correlation * one * other + other * other, 0.0))

    difference = first - second
    return (
        float(difference - combined(first - low_1, high_2 - second)),
        float(difference + combined(high_1 - first, second - low_2)),
    )


def least_shots(precision: float, confidence: float, *, paired: bool = False) -> int:
    """Return a number of shots with fewer of which no interval is so narrow.

    With z of the confidence, half of Wilson's interval is narrowest where all n shots end alike:
    z² / (n + z²) / 2. In Newcombe's the correlation is at most 1 - 2 / n, so that half of it is no
    less than that times √(2 / n).
    """
    square = float(ndtri(0.5 * (1.0 - confidence))) ** 2
    if paired:
        return int((square / sqrt(2.0)) ** (2 / 3) * precision ** (-2 / 3) - square)
    # Exactly: the quotient may be larger than any double.
    return int(Fraction(square) / Fraction(2.0 * precision) - Fraction(square))
