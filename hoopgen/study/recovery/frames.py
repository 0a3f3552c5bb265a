"""The frames of a flight: from the release to the first contact, and the noise of their positions.

A frame that lies on a parabola has a squared residual s in units of the noise, which has the
chi-square distribution with three degrees of freedom. A run of frames gains λ - min(s, 3λ) by each
of its frames, λ = `EXPECTED`: the run with the largest sum is the flight. Its ends are those of the
likelihood of a change point, and single outliers, which cost at most 2λ, do not end it.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .estimator import (
    EFFICIENCY,
    ROUGH,
    TOLERANCE,
    Flags,
    Floats,
    Lines,
    leverages,
    robust_lines,
    squares,
)

EXPECTED = 7.814727903251178
"""The 95% quantile of the squared residual of a frame: above it, a frame at an end of the flight
belongs to what comes before or after."""

OUTLIER = 21.10751346616021
"""The squared residual that one frame of 10,000 exceeds by chance: above it, a frame is an
outlier."""

MAX_OUTLIERS = 0.25
"""Largest share of outliers among the frames of a credible track."""

MIN_NOISE = 1e-9
"""m. Smallest estimate of the noise: positions in doubles have rounding errors."""

MIN_FRAMES = 3
"""Frames of the shortest track that is fitted; two leave nothing to judge the fit by."""

_MIN_WINDOW = 5
_GROWTH_STEPS = 4
_GAUSSIAN_MEDIAN = 0.6744897501960817
"""Median of the size of a standard normal number."""

_PREFIXES = tuple((0.0, 0.6**k) for k in range(6))
_WINDOWS = tuple((0.5 * i / k, (0.5 * i + 1.0) / k) for k in (1, 2, 4, 8) for i in range(2 * k - 1))
"""Begins and ends, as parts of the track, of the runs with which the search for a flight begins; if
the release is known, these are at the release."""

_AS_GOOD = 0.5
"""Part of the largest gain from which a run may be the first flight; a bounce may fly longer."""

_MISFIT = 4.0
"""Mean square of residuals, in units of the noise, from which a track does not count for it."""


@dataclass
class Measured:
    """Tracks whose positions are straight lines in time: less the fall since the first frame.

    Attributes
    ----------
    times
        (n, m), s, since the first frame.
    positions
        (3, n, m), m.
    frames
        (n, m), which frames there are.
    """

    times: Floats
    positions: Floats
    frames: Flags

    def __len__(self) -> int:
        return len(self.times)

    def take(self, rows: Any) -> Measured:
        """Return some of the tracks."""
        return Measured(self.times[rows], self.positions[:, rows], self.frames[rows])

    def fit(
        self,
        frames: Flags,
        noise: Floats,
        start: Lines | None = None,
        tolerance: float = TOLERANCE,
    ) -> Lines:
        """Return the robust fit to some frames, as of `robust_lines`.

        Parameters
        ----------
        frames, noise, start, tolerance
            As for `hoopgen.study.recovery.estimator.robust_lines`.
        """
        return robust_lines(self.times, self.positions, frames, noise, start, tolerance)

    def squares(self, lines: Lines, noise: Floats) -> Floats:
        """Return the squared residuals, (n, m), in units of the noise.

        Parameters
        ----------
        lines, noise
            As for `hoopgen.study.recovery.estimator.squares`.
        """
        return squares(lines, self.times, self.positions, noise)

    def outliers(self, lines: Lines, frames: Flags, noise: Floats) -> Flags:
        """Return which of the frames of a fit are outliers, (n, m).

        Parameters
        ----------
        lines, noise
            As for `Measured.squares`.
        frames
            Whether each frame counts, (n, m).
        """
        off = self.squares(lines, noise) / (1.0 - leverages(self.times, frames))
        return frames & (off > OUTLIER)


def noise_of_differences(tracks: Measured) -> Floats:
    """Return a first estimate of the noise, (3,), m, which no contact and no few outliers move.

    It is the median distance of a frame from the line between its neighbours. Without three frames
    in a track it is NaN.
    """
    t, y = tracks.times, tracks.positions
    there = tracks.frames[:, :-2] & tracks.frames[:, 1:-1] & tracks.frames[:, 2:]
    span = t[:, 2:] - t[:, :-2]
    there &= span > 0.0
    with np.errstate(divide="ignore", invalid="ignore"):
        part = (t[:, 2:] - t[:, 1:-1]) / span
        off = y[..., 1:-1] - part * y[..., :-2] - (1.0 - part) * y[..., 2:]
        off = np.abs(off / np.sqrt(1.0 + part**2 + (1.0 - part) ** 2))[:, there]
    if not off.size:
        return np.full(3, np.nan)
    return np.maximum(np.median(off, axis=1) / _GAUSSIAN_MEDIAN, MIN_NOISE)


def pooled_noise(
    tracks: Measured, lines: Lines, frames: Flags, noise: Floats
) -> tuple[Floats, float]:
    """Return the noise of all tracks, from their residuals, and its degrees of freedom.

    The mean square of the residuals that are no outliers by the noise before. Each track takes off
    the degrees of freedom of its fit, which for an M-estimator of efficiency e are 4 - 2 / e for a
    coordinate; tracks that are no flights do not count.

    Parameters
    ----------
    tracks
        The measured tracks, n of them.
    lines
        Their lines.
    frames
        Whether each frame counts, (n, m).
    noise
        The standard deviation of each coordinate before, (3,), m.

    Returns
    -------
    tuple
        Standard deviations, (3,), m; and degrees of freedom of each.
    """
    off = tracks.squares(lines, noise)
    kept = frames & ~tracks.outliers(lines, frames, noise)
    counts = kept.sum(axis=1)
    fitted = (counts >= MIN_FRAMES) & np.isfinite(lines.slope).all(axis=0)
    sums = np.where(kept, off, 0.0).sum(axis=1)
    whole = fitted & (counts >= (1.0 - MAX_OUTLIERS) * frames.sum(axis=1))
    whole &= sums <= _MISFIT * (3.0 * counts - 6.0)
    chosen = whole if whole.any() else fitted
    if not chosen.any():
        return noise, 0.0
    part = tracks.take(chosen)
    residuals = part.positions - lines.take(chosen).at(part.times)
    total = np.einsum("knm,nm->k", residuals**2, kept[chosen].astype(np.float64))
    free = counts[chosen] - (4.0 - 2.0 / EFFICIENCY)
    degrees = float((counts[chosen] - 2.0).sum())
    return np.maximum(np.sqrt(total / free.sum()), MIN_NOISE), degrees


def first_flight(
    tracks: Measured, frames: Flags, noise: Floats, *, detect: bool
) -> tuple[Lines, Flags]:
    """Return the first flight of each track: lines, and which frames lie on them, (n, m).

    Parameters
    ----------
    frames
        (n, m), in which the flight is looked for; it begins with the first of them, or after it if
        `detect` says so.
    """
    lines = tracks.fit(frames, noise, None, ROUGH)
    begin, end, _ = _best_run(tracks, lines, frames, noise, detect)
    lying = frames & (tracks.squares(lines, noise) <= EXPECTED)
    found = _run(begin, end, frames)
    some = frames.any(axis=1)
    last = frames.shape[1] - 1 - np.argmax(frames[:, ::-1], axis=1)
    whole = (lying.sum(axis=1) >= 0.8 * frames.sum(axis=1)) & (end == last)
    whole &= begin == np.argmax(frames, axis=1)
    rest = np.flatnonzero(some & ~whole)
    if len(rest):
        part = tracks.take(rest)
        better, run = _search(part, frames[rest], noise, detect)
        lines.put(rest, better)
        found[rest] = run
    return lines, found


def _search(tracks: Measured, frames: Flags, noise: Floats, detect: bool) -> tuple[Lines, Flags]:
    """Return the first flight, the best of searches that begin with parts of the track."""
    index = np.cumsum(frames, axis=1) - 1
    counts = frames.sum(axis=1, keepdims=True)
    tried = []
    for low, high in _WINDOWS if detect else _PREFIXES:
        least = np.minimum(low * counts, counts - _MIN_WINDOW)
        most = np.maximum(high * counts, least + _MIN_WINDOW)
        run = frames & (index >= least) & (index < most)
        lines = tracks.fit(run, noise, None, ROUGH)
        for _ in range(_GROWTH_STEPS):
            begin, end, _ = _best_run(tracks, lines, frames, noise, detect)
            grown = _run(begin, end, frames)
            grown = np.where((grown.sum(axis=1) >= MIN_FRAMES)[:, None], grown, run)
            if np.array_equal(grown, run):
                break
            lines, run = tracks.fit(grown, noise, lines, ROUGH), grown
        begin, end, gain = _best_run(tracks, lines, frames, noise, detect)
        tried.append((lines, begin, end, gain))
    gains = np.stack([gain for *_, gain in tried])
    begins = np.stack([begin for _, begin, _, _ in tried])
    ends = np.stack([end for _, _, end, _ in tried])
    if detect:
        good = gains >= _AS_GOOD * gains.max(axis=0)
        earliest = np.argmin(np.where(good, ends, np.iinfo(np.int64).max), axis=0)
        reach = np.take_along_axis(ends, earliest[None], axis=0)
        gains = np.where(good & (begins <= reach), gains, -np.inf)
    best = np.argmax(gains, axis=0)
    lines = Lines.empty(len(tracks))
    for number, (one, *_) in enumerate(tried):
        rows = np.flatnonzero(best == number)
        lines.put(rows, one.take(rows))
    rows = np.arange(len(tracks))
    return lines, _run(begins[best, rows], ends[best, rows], frames)


def _best_run(
    tracks: Measured, lines: Lines, frames: Flags, noise: Floats, detect: bool
) -> tuple[NDArray[np.int64], NDArray[np.int64], Floats]:
    """Return the columns of the first and the last frame of the best run, and its gain."""
    off = np.nan_to_num(tracks.squares(lines, noise), nan=np.inf)
    gain = np.where(frames, EXPECTED - np.minimum(off, 3.0 * EXPECTED), 0.0)
    total = np.cumsum(gain, axis=1)
    first = np.argmax(frames, axis=1)
    if detect:
        before = np.concatenate([np.zeros((len(total), 1)), total[:, :-1]], axis=1)
        least = np.minimum.accumulate(before, axis=1)
        end = np.argmax(total - least, axis=1)
        upto = np.arange(total.shape[1]) <= end[:, None]
        # The last of equal minima: gaps before a flight gain nothing.
        reverse = np.where(upto, before, np.inf)[:, ::-1]
        begin = total.shape[1] - 1 - np.argmin(reverse, axis=1)
        return begin, end, np.take_along_axis(total - least, end[:, None], axis=1)[:, 0]
    end = np.argmax(total, axis=1)
    return first, end, np.take_along_axis(total, end[:, None], axis=1)[:, 0]


def earliest_frame(tracks: Measured, lines: Lines, frames: Flags, noise: Floats) -> Any:
    """Return the column of the earliest frame that is consistent with the lines, (n,).

    Parameters
    ----------
    frames
        (n, m), all frames before the end of the flight.
    """
    begin, _, _ = _best_run(tracks, lines, frames, noise, True)
    return begin


def _run(begin: NDArray[np.int64], end: NDArray[np.int64], frames: Flags) -> Flags:
    columns = np.arange(frames.shape[1])
    return frames & (columns >= begin[:, None]) & (columns <= end[:, None])
