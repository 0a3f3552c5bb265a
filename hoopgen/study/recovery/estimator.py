"""The robust fit of flights: straight lines once the fall is added, with weights of Student's t.

Without air a flight is p + v τ + a τ²/2 with known acceleration a: less the last term every
coordinate is a straight line in τ. The errors of a frame are the residuals r of its three
coordinates, each divided by its standard deviation σ, and s = |r|². The estimate is the maximum of
the likelihood of a three-dimensional Student t with ν = `NU` degrees of freedom (K. L. Lange, R. J.
A. Little and J. M. G. Taylor (1989), Robust statistical modeling using the t distribution, Journal
of the American Statistical Association 84), found by iteratively reweighted least squares with the
weight w(s) = (ν + 3) / (ν + s) of a frame.

It is an M-estimator with ψ(r) = w(|r|²) r. If the errors are normal, its covariance is that of
least squares divided by the efficiency e = B² / A (P. J. Huber (1981), Robust statistics, Section
7.6), where A = E[w² s] / 3 and B = E[w s] / 3, the latter equal to the mean derivative of ψ by
Stein's lemma, and s has the chi-square distribution with three degrees of freedom. With
H = √(πν/2) exp(ν/2) erfc(√(ν/2)) the means are E[1 / (ν + s)] = 1 - H and, by its derivative,
E[1 / (ν + s)²] = H / (2ν) + H/2 - 1/2.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import erfc, exp, pi, sqrt
from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]

NU = 5.0
"""Degrees of freedom of the t distribution whose likelihood is maximal. A smaller number bounds the
influence of outliers more tightly, and costs efficiency if there are none."""


def efficiency(nu: float) -> float:
    """Return the efficiency of the fit if the errors are normal: 1 is that of least squares."""
    h = sqrt(0.5 * pi * nu) * exp(0.5 * nu) * erfc(sqrt(0.5 * nu))
    first, second = 1.0 - h, 0.5 * (h / nu + h - 1.0)
    slope = (nu + 3.0) * (1.0 - nu * first) / 3.0
    square = (nu + 3.0) ** 2 * (first - nu * second) / 3.0
    return slope * slope / square


EFFICIENCY = efficiency(NU)
"""0.927: the standard errors are 1.039 times those of least squares with normal errors."""

MEDIAN_SQUARE = 2.3659738843753377
"""Median of the chi-square distribution with three degrees of freedom."""

_COARSE_STEPS = 4
"""First steps of the iteration, whose scale is no less than the median of the residuals, so that
the fit begins with what most frames say."""

_MAX_STEPS = 100
TOLERANCE = 1e-9
ROUGH = 1e-3
"""Largest changes of a position, in standard deviations of a frame, at which the iteration of a fit
ends, and of one that only chooses frames."""

_TRACKS = 4096
"""Tracks that are fitted together, few enough that their arrays stay in the processor's cache."""


@dataclass
class Lines:
    """Straight lines through the frames of tracks, less their fall.

    Attributes
    ----------
    centre
        Weighted mean of the times, (n,), s.
    middle
        Positions at that time, (3, n), m.
    slope
        Velocities, (3, n), m/s; less the fall, those at time 0.
    """

    centre: Floats
    middle: Floats
    slope: Floats

    def at(self, times: Floats) -> Floats:
        """Return the positions at times of each track, (n, m), as (3, n, m)."""
        found = self.slope[..., None] * (times - self.centre[:, None])
        found += self.middle[..., None]
        return found

    def take(self, rows: Any) -> Lines:
        """Return the lines of some tracks."""
        return Lines(self.centre[rows], self.middle[:, rows], self.slope[:, rows])

    def put(self, rows: Any, others: Lines) -> None:
        """Replace the lines of some tracks.

        Parameters
        ----------
        rows
            The indices of the tracks.
        others
            Their new lines.
        """
        self.centre[rows], self.middle[:, rows] = others.centre, others.middle
        self.slope[:, rows] = others.slope

    @classmethod
    def empty(cls, tracks: int) -> Lines:
        """Return lines of NaN."""
        rows = np.full((3, tracks), np.nan)
        return cls(np.full(tracks, np.nan), rows, rows.copy())


def weighted_lines(times: Floats, positions: Floats, weights: Floats) -> Lines:
    """Return the weighted least squares lines of tracks.

    Parameters
    ----------
    times
        (n, m), s, finite.
    positions
        (3, n, m), finite.
    weights
        (n, m), 0 for frames that do not count. Tracks with fewer than two get NaN.
    """
    with np.errstate(divide="ignore", invalid="ignore"):
        total = weights.sum(axis=1)
        centre = np.einsum("nm,nm->n", weights, times) / total
        middle = np.einsum("nm,knm->kn", weights, positions) / total
        since = times - centre[:, None]
        moment = weights * since
        spread = np.einsum("nm,nm->n", moment, since)
        slope = np.einsum("nm,knm->kn", moment, positions) / spread
    return Lines(centre, middle, slope)


def squares(lines: Lines, times: Floats, positions: Floats, noise: Floats) -> Floats:
    """Return the squared residuals of frames in units of the noise, (n, m).

    Parameters
    ----------
    lines
        The lines of the n tracks.
    times
        The times of the frames, (n, m), s.
    positions
        The positions in them, (3, n, m), m.
    noise
        The standard deviation of each coordinate, (3,), m.
    """
    off = lines.at(times)
    np.subtract(positions, off, out=off)
    off /= noise[:, None, None]
    return np.asarray(np.einsum("knm,knm->nm", off, off))


def robust_lines(
    times: Floats,
    positions: Floats,
    frames: Flags,
    noise: Floats,
    start: Lines | None = None,
    tolerance: float = TOLERANCE,
) -> Lines:
    """Return the most likely lines of tracks, with errors of Student's t.

    Parameters
    ----------
    times
        (n, m), s, finite.
    positions
        (3, n, m), m, finite: positions less the fall.
    frames
        (n, m): which frames count.
    noise
        Standard deviations of the coordinates, (3,), m.
    start
        Lines with which the iteration begins; None for those of least squares.
    tolerance
        Largest change of a position at which the iteration ends, in standard deviations.
    """
    found = Lines.empty(len(times))
    for first in range(0, len(times), _TRACKS):
        part = slice(first, first + _TRACKS)
        before = None if start is None else start.take(part)
        arrays = times[part], positions[:, part], frames[part]
        found.put(part, _iterated(*arrays, noise, before, tolerance))
    return found


def _iterated(
    times: Floats,
    positions: Floats,
    frames: Flags,
    noise: Floats,
    start: Lines | None,
    tolerance: float,
) -> Lines:
    counts = frames.astype(np.float64)
    lines = weighted_lines(times, positions, counts) if start is None else start
    moving = np.flatnonzero(counts.sum(axis=1) >= 2.0)
    for step in range(_MAX_STEPS):
        if not len(moving):
            break
        t, y, use = times[moving], positions[:, moving], counts[moving]
        before = lines.take(moving)
        off = squares(before, t, y, noise)
        if start is None and step < _COARSE_STEPS:
            off /= np.maximum(1.0, _medians(off, frames[moving]) / MEDIAN_SQUARE)[:, None]
        weights = use * ((NU + 3.0) / (NU + off))
        after = weighted_lines(t, y, weights)
        lines.put(moving, after)
        # A straight line changes most at one of the ends of the track.
        ends = np.stack([t.min(axis=1), t.max(axis=1)], axis=1)
        change = np.abs(after.at(ends) - before.at(ends)) / noise[:, None, None]
        far = np.max(change, axis=(0, 2)) > tolerance
        moving = moving[far | (start is None and step < _COARSE_STEPS)]
    return lines


def _medians(values: Floats, frames: Flags) -> Floats:
    """Return the median of each track over the frames that count."""
    ordered = np.sort(np.where(frames, values, np.inf), axis=1)
    middle = np.maximum(frames.sum(axis=1) - 1, 0) // 2
    return np.take_along_axis(ordered, middle[:, None], axis=1)[:, 0]


def line_covariance(times: Floats, frames: Flags) -> Floats:
    """Return the covariance of position and velocity at time 0, for noise 1.

    Parameters
    ----------
    times
        (n, m), s.
    frames
        (n, m): which frames count as observations.

    Returns
    -------
    ndarray
        (n, 2, 2); NaN where no two frames have different times.
    """
    with np.errstate(divide="ignore", invalid="ignore"):
        _, total, centre, since = _about_their_mean(times, frames)
        slope = 1.0 / np.einsum("nm,nm->n", since, since)
        found = np.empty((len(times), 2, 2))
        found[:, 0, 0] = 1.0 / total + centre * centre * slope
        found[:, 0, 1] = found[:, 1, 0] = -centre * slope
        found[:, 1, 1] = slope
    found[~np.isfinite(found).all(axis=(1, 2))] = np.nan
    return found / EFFICIENCY


def _about_their_mean(times: Floats, frames: Flags) -> tuple[Floats, Floats, Floats, Floats]:
    """Return whether frames count as 0 and 1, how many do, their mean time, and times since it."""
    counts = frames.astype(np.float64)
    total = counts.sum(axis=1)
    centre = np.einsum("nm,nm->n", counts, times) / total
    return counts, total, centre, (times - centre[:, None]) * counts


def leverages(times: Floats, frames: Flags) -> Floats:
    """Return the share of each frame's own error that the fit takes up, (n, m), below 1.

    Parameters
    ----------
    times
        The times of the frames, (n, m), s.
    frames
        Whether each frame counts, (n, m).
    """
    with np.errstate(divide="ignore", invalid="ignore"):
        counts, total, _, since = _about_their_mean(times, frames)
        spread = np.einsum("nm,nm->n", since, since)
        found = counts / total[:, None] + since**2 / spread[:, None]
    return np.where(frames & np.isfinite(found), np.minimum(found, 0.95), 0.0)
