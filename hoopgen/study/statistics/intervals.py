"""Confidence intervals: of a share, of a difference of shares, and of a quantile.

The trials are independent, or come in groups (a player's games, say) within which they may be
alike. Of groups a share has Wilson's interval with the effective number of trials, and Student's t
with one degree of freedom fewer than there are groups: with few groups it covers what it says,
where the percentiles of a bootstrap over groups do not.
"""

from __future__ import annotations

from fractions import Fraction
from math import hypot, inf, isinf, isnan, sqrt

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.special import ndtri, stdtrit
from scipy.stats import binom

from hoopgen.generated.numpy import studies

Floats = NDArray[np.float64]
Ends = tuple[float, float]
"""Low and high."""


def wilson_interval(
    made: ArrayLike, shots: ArrayLike, confidence: float, degrees: float = inf
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return the ends of Wilson's score interval (1927) of a probability.

    Parameters
    ----------
    made, shots
        Numbers that broadcast. Of no shots nothing is known: from 0 to 1.
    confidence
        Within 0 and 1.
    degrees
        Degrees of freedom of Student's t, if the variance is estimated, in place of the normal
        distribution.
    """
    n, k = np.asarray(shots, dtype=np.float64), np.asarray(made, dtype=np.float64)
    z = _quantile(degrees, confidence)
    with np.errstate(invalid="ignore"):
        low, high = studies.wilson_interval(k, n, z)
    return low, high


def newcombe_interval(
    both: int, only_first: int, only_second: int, neither: int, confidence: float
) -> tuple[float, float]:
    """Return the interval of a difference of paired proportions, the first less the second.

    R. G. Newcombe (1998), Improved confidence intervals for the difference between binomial
    proportions based on paired data, Statistics in Medicine 17, method 10: the distances to the
    ends of Wilson's two intervals are combined as the sides of a triangle whose angle is that of
    the correlation, which is corrected for continuity. Of no pairs nothing is known: from -1 to 1.

    Parameters
    ----------
    both
        The number of pairs of which both succeed.
    only_first
        The number of pairs of which the first alone succeeds.
    only_second
        The number of pairs of which the second alone succeeds.
    neither
        The number of pairs of which neither succeeds.
    confidence
        The confidence of the interval, from 0 to 1.
    """
    pairs = both + only_first + only_second + neither
    if not pairs:
        return -1.0, 1.0
    made = both + only_first, both + only_second
    (low_1, low_2), (high_1, high_2) = wilson_interval(made, pairs, confidence)
    first, second = made[0] / pairs, made[1] / pairs
    # Products of counts outgrow 64 bits: Python's whole numbers do not.
    spread = made[0] * (pairs - made[0]) * made[1] * (pairs - made[1])
    concord, discord = both * neither, only_first * only_second
    excess = max(concord - discord - pairs / 2, 0.0) if concord > discord else concord - discord
    correlation = excess / sqrt(spread) if spread else 0.0

    ends = (float(low_1), float(high_1)), (float(low_2), float(high_2))
    return combined_interval(first, ends[0], second, ends[1], correlation)


def newcombe_apart(first: float, of_first: Ends, second: float, of_second: Ends) -> Ends:
    """Return the interval of the first share less the second, of samples that do not pair.

    R. G. Newcombe (1998), Interval estimation for the difference between independent proportions,
    Statistics in Medicine 17, method 10: distances to the ends are combined at a right angle.

    Parameters
    ----------
    first
        The first share, from 0 to 1.
    of_first
        The ends of its interval.
    second
        The second share, from 0 to 1.
    of_second
        The ends of its interval.
    """
    return combined_interval(first, of_first, second, of_second, 0.0)


def combined_interval(
    first: float, of_first: Ends, second: float, of_second: Ends, correlation: float
) -> Ends:
    """Return the interval of a difference of two estimates from their intervals.

    G. Y. Zou and A. Donner (2008), Construction of confidence limits about effect measures,
    Statistics in Medicine 27: the distances to the ends are combined as the sides of a triangle
    whose angle is that of the correlation.

    Parameters
    ----------
    first
        The first estimate.
    of_first
        The ends of its interval.
    second
        The second estimate, which is subtracted.
    of_second
        The ends of its interval.
    correlation
        That of the estimates, from -1 to 1.
    """

    def apart(one: float, other: float) -> float:
        return sqrt(max(one * one - 2.0 * correlation * one * other + other * other, 0.0))

    difference = first - second
    return (
        float(difference - apart(first - of_first[0], of_second[1] - second)),
        float(difference + apart(of_first[1] - first, second - of_second[0])),
    )


def grouped_wilson(made: ArrayLike, trials: ArrayLike, confidence: float) -> Ends:
    """Return the interval of a share whose trials come in groups.

    With the effective number of trials, those that would give the variance between the groups
    (Taylor's linearization of the ratio), if they were independent.

    Parameters
    ----------
    made, trials
        By group, (g,). Of fewer than two groups nothing is known: from 0 to 1.
    confidence
        Within 0 and 1.
    """
    m, n = _with_trials(made, trials)
    groups, total = len(n), float(n.sum())
    if groups < 2:
        return 0.0, 1.0
    share = float(m.sum()) / total
    off = m - share * n
    variance = groups / (groups - 1) * float(off @ off) / total**2
    size = share * (1.0 - share) / variance if variance else total
    if not 0.0 < share < 1.0:
        size = float(groups)  # all alike: no more is known than that every group is
    degrees = groups - 1.0
    low, high = wilson_interval(size if share == 1.0 else share * size, size, confidence, degrees)
    return float(low), float(high)


def grouped_difference(
    first: ArrayLike, second: ArrayLike, trials: ArrayLike, confidence: float
) -> Ends:
    """Return the interval of the first share less the second, of pairs that come in groups.

    It is `newcombe_interval` of the intervals of `grouped_wilson` and the correlation between the
    groups.

    Parameters
    ----------
    first, second, trials
        Pairs by group in which the first succeeds, the second does, and all, (g,).
    confidence
        Within 0 and 1.
    """
    a, n = _with_trials(first, trials)
    b, _ = _with_trials(second, trials)
    if len(n) < 2:
        return -1.0, 1.0
    shares = [float(one.sum() / n.sum()) for one in (a, b)]
    ends = [grouped_wilson(one, n, confidence) for one in (a, b)]
    off_a, off_b = (one - share * n for one, share in zip((a, b), shares, strict=True))
    size = float(off_a @ off_a) * float(off_b @ off_b)
    correlation = float(off_a @ off_b) / sqrt(size) if size else 0.0
    return combined_interval(shares[0], ends[0], shares[1], ends[1], correlation)


def _with_trials(made: ArrayLike, trials: ArrayLike) -> tuple[Floats, Floats]:
    """Return both without the groups in which there is no trial."""
    m, n = np.asarray(made, dtype=np.float64), np.asarray(trials, dtype=np.float64)
    return m[n > 0], n[n > 0]


def widened(
    value: float,
    ends: Ends,
    degrees: float,
    variance: float,
    of_variance: float,
    confidence: float,
    least: float,
) -> Ends:
    """Return the interval of an estimate to which another error is added, independent of its own.

    The squares of the distances to the ends add, as in Newcombe's intervals (G. Y. Zou and
    A. Donner (2008), Construction of confidence limits about effect measures, Statistics in
    Medicine 27). So do the variances, whose sum has the degrees of freedom of B. L. Welch (1947),
    The generalization of "Student's" problem when several different population variances are
    involved, Biometrika 34.

    Parameters
    ----------
    value, ends
        The estimate and its interval. Of NaN nothing is known: the ends stay as they are.
    degrees
        Degrees of freedom of that interval; infinite, if it has the normal distribution.
    variance, of_variance
        Of the other error, and its degrees of freedom.
    least
        The smallest value that there is; the greatest is 1.
    """
    low, high = ends
    if isnan(value) or not variance:
        return ends
    before = _quantile(degrees, confidence)
    own = ((high - low) / (2.0 * before)) ** 2
    together = (own + variance) ** 2 / (own**2 / degrees + variance**2 / of_variance)
    after, more = _quantile(together, confidence) / before, before * sqrt(variance)
    return (
        max(value - after * hypot(value - low, more), least),
        min(value + after * hypot(high - value, more), 1.0),
    )


def _quantile(degrees: float, confidence: float) -> float:
    """Return the two-sided quantile of Student's t, or of the normal distribution."""
    tail = 0.5 * (1.0 - confidence)  # near 1 this keeps its digits
    return -float(ndtri(tail) if isinf(degrees) else stdtrit(degrees, tail))


def quantile_ranks(level: float, trials: int, confidence: float) -> tuple[int, int]:
    """Return the ranks between whose values a quantile lies, with the confidence at the least.

    Of sorted values, rank 1 the smallest: so many are below a quantile is binomial. Rank 0 is
    below all values, and ``trials + 1`` above: of so few nothing is known on that side.

    Parameters
    ----------
    level
        The quantile that is meant, from 0 to 1.
    trials
        The number of values.
    confidence
        The least confidence, from 0 to 1.
    """
    tail = 0.5 * (1.0 - confidence)
    # P(B < low) <= tail, and P(B >= high) <= tail, of B values below the quantile.
    low = int(binom.ppf(tail, trials, level))
    high = int(binom.isf(tail, trials, level)) + 1
    return low, high


def least_shots(precision: float, confidence: float, *, paired: bool = False) -> int:
    """Return a number of shots with fewer of which no interval is so narrow.

    With z of the confidence, half of Wilson's interval is narrowest where all n shots end alike:
    z² / (n + z²) / 2. In Newcombe's the correlation is at most 1 - 2 / n, so that half of it is no
    less than that times √(2 / n).

    Parameters
    ----------
    precision
        Half of the width that is wanted, as a share from 0 to 1.
    confidence
        The confidence of the interval, from 0 to 1.
    paired
        Whether it is the interval of a difference of paired shots.
    """
    square = float(ndtri(0.5 * (1.0 - confidence))) ** 2
    if paired:
        return int((square / sqrt(2.0)) ** (2 / 3) * precision ** (-2 / 3) - square)
    # Exactly: the quotient may be larger than any double.
    return int(Fraction(square) / Fraction(2.0 * float(precision)) - Fraction(square))
