"""A best release judged by measured releases that did not choose it: cross-fitting.

The share of the rows that succeed with the release which was best for these very rows is too good,
however many shots are drawn from them. So the rows are cut into folds, groups kept whole; for each
fold the release is searched again with the rows of the others, and the rows of the fold are thrown
with it. All of them together, each judged by a release that it had no part in, are the trials of
the probability (M. Stone (1974), Cross-validatory choice and assessment of statistical predictions,
Journal of the Royal Statistical Society B 36).

The trials are of the releases of the folds, and the probability that is wanted is that of one more,
which is found with all rows. They are not equally good, and the interval contains that, too. Let
the probability of each be a part that all of them have in common, since they are found with mostly
the same rows in the same way, and a part of its own, of variance tau². The common part cancels
where the release of all rows is compared with the mean of the K others: what is left has the
variance tau² (1 + 1/K), as of one more draw beside a mean of K. With the release of all rows those
of the folds have all their rows in common, with each other fewer: so this is rather too much than
too little. The factor (K - 1)²/K of the jackknife would answer another question, by how much the
releases of other samples would differ. Most of that is the common part, which cancels: of a
statistic to which each row adds its own, the mean of the K values is that of all rows. tau² is the
variance of the K + 1 shares that succeed of the same shots: all rows, smoothed, with noise that
none of the searches knew.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from math import inf

import numpy as np
from numpy.typing import NDArray

from hoopgen.study.jobs.objective import Bounds, Player, Successes
from hoopgen.study.models.resample import Resample
from hoopgen.study.models.smoothed import smoothed
from hoopgen.study.statistics.intervals import widened
from hoopgen.study.statistics.sample import SampleInterval

from .search import search

FOLDS = 5
"""Into which the rows or their groups are cut, if there are as many."""


@dataclass(frozen=True)
class HeldOut:
    """Releases found without a part of the rows, and which rows that are.

    Attributes
    ----------
    points
        By fold: the values found with the rows of the others. None where none that was tried
        succeeds.
    """

    points: tuple[Mapping[str, float] | None, ...]
    fold: NDArray[np.intp]  # of each row, (m,)

    def scored(self, model: Resample, player: Player, fixed: Mapping[str, float]) -> Successes:
        """Return the result of each row, (m,), at the release found without it.

        How far it is from the mean is counted from that of the rows that the release was found
        with: a player who moves the mean knows no other.

        Parameters
        ----------
        model
            The sample of m rows.
        player
            The player, who scatters.
        fixed
            The variables of the release that are not searched, SI and rad.
        """
        made, valid = np.zeros((2, model.rows), np.bool_)
        kind = np.zeros(model.rows, np.uint8)
        for number, point in enumerate(self.points):
            inside = np.flatnonzero(self.fold == number)
            if point is None:
                valid[inside] = True
                continue
            others = model.each(np.flatnonzero(self.fold != number))
            searched_without = replace(player, model=model.each(inside, others.centre))
            fold = searched_without.scored({**fixed, **point}, len(inside))
            made[inside], valid[inside], kind[inside] = fold.made, fold.valid, fold.kind
        return Successes(made, valid, kind)

    def shares(
        self,
        model: Resample,
        player: Player,
        fixed: Mapping[str, float],
        found: Mapping[str, float] | None,
        seed: int,
    ) -> NDArray[np.float64]:
        """Return the shares that succeed of the same shots, with every release, (K + 1,).

        Parameters
        ----------
        model, player, fixed, seed
            As for `held_out`; the shots are those of the next seed.
        found
            The release found with all rows, which is the last. None, of it or of a fold, succeeds
            with no shot.
        """
        common = smoothed(model, seed)
        # How far shots are from the mean is counted as in `scored`. That the smoothing shrinks them
        # towards a mean that is this little off moves them by far less than the noise does.
        centres = [
            model.each(np.flatnonzero(self.fold != number)).centre
            for number in range(len(self.points))
        ]
        shares = np.zeros(len(self.points) + 1)
        each = zip((*self.points, found), (*centres, model.centre), strict=True)
        for number, (point, centre) in enumerate(each):
            if point is not None:
                searched_without = replace(player, model=replace(common, about=centre))
                successes = searched_without.sampled({**fixed, **point}, common.most, seed + 1)
                shares[number] = np.nan_to_num(successes.share[0])
        return shares


def variance_of_choice(shares: NDArray[np.float64]) -> float:
    """Return the variance of the last share's distance from the mean of the others.

    As of independent draws: that of one, tau², and a K-th of it for the mean of K.

    Parameters
    ----------
    shares
        Of the releases of the folds and of that of all rows, as `HeldOut.shares` gives them, or
        differences of them, (K + 1,).
    """
    return float(np.var(shares, ddof=1)) * (1.0 + 1.0 / (len(shares) - 1))


def with_choice(
    found: SampleInterval, shares: NDArray[np.float64], confidence: float, least: float = 0.0
) -> SampleInterval:
    """Return an interval of held-out rows that contains how much the releases differ.

    Parameters
    ----------
    found
        A share of the rows, or a difference of shares, with the interval that takes them for
        trials of one release.
    shares
        As for `variance_of_choice`.
    least
        The smallest value that there is: -1 of a difference.
    """
    folds = len(shares) - 1
    variance = variance_of_choice(shares)
    degrees = inf if found.groups is None else found.groups - 1.0
    ends = found.low, found.high
    low, high = widened(found.value, ends, degrees, variance, folds, confidence, least)
    return replace(found, low=low, high=high)


def check_folds(model: Resample) -> int:
    """Return into how many folds a sample is cut."""
    parts, noun = model.rows, "row"
    if model.groups is not None:
        parts, noun = model.groups, "group"
    if parts < 2:
        raise ValueError(
            f"model: a best release is judged by measured releases that had no part in the search, "
            f"which takes two {noun}s at the least; this has one {noun}"
        )
    return min(FOLDS, parts)


def folds_of(model: Resample, seed: int) -> NDArray[np.intp]:
    """Return the fold of each row, (m,), by a seed; those of a group are in one.

    Parameters
    ----------
    model
        The sample of m rows.
    seed
        The seed of the random numbers.
    """
    order, count = model.order(seed), check_folds(model)
    if model.cluster is None:
        fold = np.empty(model.rows, np.intp)
        fold[order] = np.arange(model.rows) % count
        return fold
    # Groups in the shuffled order of their first rows.
    _, first = np.unique(model.cluster[order], return_index=True)
    turn = np.argsort(np.argsort(first, kind="stable"), kind="stable")
    return np.asarray(turn[model.cluster] % count)


def held_out(
    player: Player,
    model: Resample,
    bounds: Mapping[str, Bounds],
    fixed: Mapping[str, float],
    shots: int,
    seed: int,
) -> HeldOut:
    """Search a release for each fold, with the rows of the others.

    Parameters
    ----------
    bounds, fixed, shots, seed
        As for `search`.
    """
    fold, count, points = folds_of(model, seed), check_folds(model), []
    for number in range(count):
        others = smoothed(model, seed, fold != number, 1.0 - 1.0 / count)
        points.append(search(replace(player, model=others), bounds, fixed, shots, seed))
    return HeldOut(tuple(points), fold)
