"""Measured releases, smoothed: what a search for the best release throws.

The share of some hundred rows that succeed is a surface of steps, and its highest one is where
chance put it: the release found there is worse than it need be, and rows that are held out of the
search say so with more scatter than as many shots would have. So every shot of a search is a row
with a little noise on it, as B. W. Silverman and G. A. Young (1987), The bootstrap: to smooth or
not to smooth?, Biometrika 74, do it: the noise is a part h of the difference of two rows, which has
the rows' covariance, and all is drawn together so that the covariance stays as it was. What is said
of a release is judged by rows without noise.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from math import sqrt

import numpy as np
from numpy.typing import NDArray

from hoopgen.core.variables import STATE
from hoopgen.hoop.variables import ALTERNATIVE_VARIABLES, ARGUMENTS

from .random import SMOOTHING, uniforms
from .release_model import Floats
from .resample import EachRow, Resample

_SHOTS = 4_000
"""Number of shots of fewer rows than that: more of them make the surface no smoother than the noise
does."""


@dataclass(frozen=True, eq=False, repr=False)
class Smoothed(EachRow):
    """Measured releases with noise: shot i is row i, after the last one the first again."""

    parts: int = 1  # of how many independent rows, or groups of rows, they are

    @property
    def most(self) -> int:
        """The number of shots."""
        return max(self.rows, _SHOTS)

    @cached_property
    def width(self) -> float:
        """Return h, the noise as a part of the rows' own deviations: Silverman's for a normal one.

        B. W. Silverman (1986), Density estimation for statistics and data analysis, Eq. 4.14.
        """
        columns = len(self._noisy)
        return float((4.0 / (columns + 2.0) / self.parts) ** (1.0 / (columns + 4.0)))

    @property
    def _noisy(self) -> list[str]:
        """Columns of the release; parameters of the scene, which have bounds, are as they are."""
        known = STATE if self.is_state else (*ARGUMENTS, *ALTERNATIVE_VARIABLES)
        return [name for name, one in self.columns.items() if np.ndim(one) and name in known]

    @cached_property
    def _whole(self) -> NDArray[np.intp]:
        """Rows all of whose numbers are finite, between which differences are taken."""
        finite = [np.isfinite(np.asarray(self.columns[name])) for name in self._noisy]
        return np.flatnonzero(np.all(finite, axis=0)) if finite else np.arange(self.rows)

    def _rows(self, start: int, stop: int, seed: int) -> NDArray[np.intp]:
        return np.arange(start, stop) % self.rows

    def noise(self, start: int, stop: int, seed: int = 0) -> dict[str, Floats]:
        """Return the columns of shots `start` to `stop` - 1, (n,) each or one number.

        Parameters
        ----------
        start, stop, seed
            As for `hoopgen.study.models.random.normals`.
        """
        columns = super().noise(start, stop, seed)
        whole, shrunk = self._whole, 1.0 / sqrt(1.0 + self.width**2)
        if len(whole) < 2:
            return columns
        one, other = (
            whole[(uniforms(seed, SMOOTHING + k, start, stop) * len(whole)).astype(np.intp)]
            for k in range(2)
        )
        for name in self._noisy:
            column, centre = np.asarray(self.columns[name]), self.centre[name]
            noise = self.width / sqrt(2.0) * (column[one] - column[other])
            columns[name] = centre + shrunk * (columns[name] + noise - centre)
        return columns


def smoothed(
    model: Resample, seed: int, rows: NDArray[np.bool_] | None = None, part: float = 1.0
) -> Smoothed:
    """Return measured releases with noise, in an order that the seed shuffles.

    Parameters
    ----------
    seed
        From 0 to 2^64 - 1.
    rows
        Which of them, (m,); by default all.
    part
        Which part of the independent rows or groups they are.
    """
    order = model.order(seed)
    chosen = order if rows is None else order[rows[order]]
    about = model.centre if rows is None else model.each(np.flatnonzero(rows)).centre
    parts = max(1, round(part * (model.rows if model.groups is None else model.groups)))
    return Smoothed(model.each(chosen).columns, about=about, parts=parts)
