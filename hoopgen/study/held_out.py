"""A best release judged by measured releases that did not choose it: cross-fitting.

The share of the rows that succeed with the release which was best for these very rows is too good,
however many shots are drawn from them. So the rows are cut into folds, groups kept whole; for each
fold the release is searched again with the rows of the others, and the rows of the fold are thrown
with it. All of them together, each judged by a release that it had no part in, are the trials of
the probability (M. Stone (1974), Cross-validatory choice and assessment of statistical predictions,
Journal of the Royal Statistical Society B 36).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from .player import Bounds, Player, Thrown
from .resample import Resample
from .search import search
from .smoothed import smoothed

__all__ = ["FOLDS", "HeldOut", "check_folds", "folds_of", "held_out"]

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
    fold
        Of each row, (m,).
    """

    points: tuple[Mapping[str, float] | None, ...]
    fold: NDArray[np.intp]

    def scored(self, model: Resample, player: Player, fixed: Mapping[str, float]) -> Thrown:
        """Return what becomes of each row, (m,), thrown with the release found without it.

        How far it is from the mean is counted from that of the rows that the release was found
        with: a player who moves the mean knows no other.
        """
        made, valid = np.zeros((2, model.rows), np.bool_)
        kind = np.zeros(model.rows, np.uint8)
        for number, point in enumerate(self.points):
            inside = np.flatnonzero(self.fold == number)
            if point is None:
                valid[inside] = True
                continue
            others = model.each(np.flatnonzero(self.fold != number))
            thrower = replace(player, model=model.each(inside, others.centre))
            thrown = thrower.scored({**fixed, **point}, len(inside))
            made[inside], valid[inside], kind[inside] = thrown.made, thrown.valid, thrown.kind
        return Thrown(made, valid, kind)


def check_folds(model: Resample) -> int:
    """Return into how many folds a sample is cut.

    Raises
    ------
    ValueError
        If there are fewer than two rows or groups.
    """
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
    """Return the fold of each row, (m,), by a seed; those of a group are in one."""
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
    player
        Who throws; its model is replaced.
    model
        The measured releases.
    bounds, fixed, shots, seed
        As for `search`.
    """
    fold, count, points = folds_of(model, seed), check_folds(model), []
    for number in range(count):
        others = smoothed(model, seed, fold != number, 1.0 - 1.0 / count)
        points.append(search(replace(player, model=others), bounds, fixed, shots, seed))
    return HeldOut(tuple(points), fold)
