"""Measured tracks of balls: the arrays of callers, one row a track, frames in order of time."""

from __future__ import annotations

from collections.abc import Hashable, Iterable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hoopgen.core.validation import as_doubles
from hoopgen.text.shorten import brief

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]

_SHAPES = "(m,) and (m, 3), or (n, m) and (n, m, 3)"


@dataclass(frozen=True)
class Tracks:
    """Tracks in one array, padded, the frames of each in order of time.

    Attributes
    ----------
    times
        (n, m), s, since the first frame of the track; 0 where there is no frame.
    positions
        (n, m, 3), m; 0 where there is no frame.
    measured
        (n, m), whether there is a frame.
    first
        Time of the first frame of each track, (n,), s; NaN for a track without frames.
    labels
        Of the tracks, in order.
    """

    times: Floats
    positions: Floats
    measured: Flags
    first: Floats
    labels: tuple[Hashable, ...]
    _places: NDArray[np.intp]  # of each frame among the frames as they were given, flat
    _shape: tuple[int, ...]  # of the times as they were given

    def __len__(self) -> int:
        return len(self.times)

    def as_given(self, values: NDArray[Any], missing: Any) -> NDArray[Any]:
        """Return values of frames, (n, m) or (n, m, 3), in the shape of the caller's arrays.

        Parameters
        ----------
        values
            Values of the n tracks' m frames.
        missing
            The value of frames that a track does not have.
        """
        rest = values.shape[2:]
        found = np.full((int(np.prod(self._shape)), *rest), missing, values.dtype)
        there = self._places >= 0
        found[self._places[there]] = values[there]
        return found.reshape(*self._shape, *rest)

    def in_order(self, values: NDArray[Any], missing: Any) -> NDArray[Any]:
        """Return values of frames in the shape of the caller's arrays, (n, m) or (n, m, 3).

        Parameters
        ----------
        values
            As `as_given` returns them.
        missing
            The value of frames that a track does not have.
        """
        rest = values.shape[len(self._shape) :]
        flat = values.reshape(-1, *rest)
        found = np.full((*self._places.shape, *rest), missing, values.dtype)
        there = self._places >= 0
        found[there] = flat[self._places[there]]
        return found


def as_tracks(times: ArrayLike, positions: ArrayLike, labels: Iterable[Hashable] | None) -> Tracks:
    """Return tracks from a caller's arrays.

    Parameters
    ----------
    times, positions
        One track, (m,) and (m, 3); padded ones, (n, m), or (m,) for all, and (n, m, 3). A frame
        whose time or position is not finite is a gap.
    labels
        The track of each frame, (m,), for frames of many tracks one below the other; a track need
        not be in one piece.

    Raises
    ------
    TypeError, ValueError
        If they are not as described; the message names the argument.
    """
    t = as_doubles("times", times, f"numbers of shape {_SHAPES}")
    xyz = as_doubles("positions", positions, f"numbers of shape {_SHAPES}")
    shape = f"got times {t.shape} and positions {xyz.shape}"
    if labels is not None:
        if t.ndim != 1 or xyz.shape != (len(t), 3):
            raise ValueError(f"tracks: with labels expected times (m,), positions (m, 3), {shape}")
        return _labelled(t, xyz, list(labels))
    if xyz.ndim not in (2, 3) or xyz.shape[-1] != 3:
        raise ValueError(f"positions: expected shape (m, 3) or (n, m, 3), {shape}")
    if t.shape != xyz.shape[:-1]:
        if xyz.ndim != 3 or t.shape != xyz.shape[1:2]:
            raise ValueError(f"times: expected a time for each position, {_SHAPES}; {shape}")
        t = np.broadcast_to(t, xyz.shape[:-1])
    rows = t if t.ndim == 2 else t[None]
    places = np.arange(rows.size).reshape(rows.shape)
    return _ordered(rows, xyz.reshape(*rows.shape, 3), places, tuple(range(len(rows))), t.shape)


def _labelled(times: Floats, positions: Floats, labels: list[Hashable]) -> Tracks:
    """Return tracks of frames that have labels, in the order in which these first appear."""
    if len(labels) != len(times):
        raise ValueError(
            f"tracks: expected a label for each of {len(times)} frames, got {len(labels)}"
        )
    numbers: dict[Hashable, int] = {}
    try:
        track = np.array([numbers.setdefault(one, len(numbers)) for one in labels], np.intp)
    except TypeError:
        text = f"tracks: expected labels such as text or numbers, got {brief(labels)}"
        raise TypeError(text) from None
    if any(one is None or one != one for one in numbers):
        raise ValueError("tracks: a frame has no label")
    counts = np.bincount(track, minlength=len(numbers))
    order = np.argsort(track, kind="stable")
    column = np.empty(len(track), np.intp)
    column[order] = np.arange(len(track)) - np.repeat(np.cumsum(counts) - counts, counts)
    shape = len(numbers), int(counts.max(initial=0))
    places = np.full(shape, -1, np.intp)
    places[track, column] = np.arange(len(track))
    padded = np.full(shape, np.nan)
    padded[track, column] = times
    where = np.full((*shape, 3), np.nan)
    where[track, column] = positions
    return _ordered(padded, where, places, tuple(numbers), times.shape)


def _ordered(
    times: Floats,
    positions: Floats,
    places: NDArray[np.intp],
    labels: tuple[Hashable, ...],
    shape: tuple[int, ...],
) -> Tracks:
    """Return tracks with the frames in order of time, gaps last, and times from the first frame.

    A frame that repeats the one before it, time and place, is taken for a gap: it measures nothing.
    """
    if not times.shape[1]:  # a gap is as good as no frame
        times, positions = np.full((len(times), 1), np.nan), np.full((len(times), 1, 3), np.nan)
        places = np.full(times.shape, -1, np.intp)
    measured = np.isfinite(times) & np.isfinite(positions).all(axis=-1)
    order = _order(times, measured)
    t, xyz = (
        np.take_along_axis(times, order, axis=1),
        np.take_along_axis(positions, order[..., None], axis=1),
    )
    again = (t[:, 1:] == t[:, :-1]) & (xyz[:, 1:] == xyz[:, :-1]).all(axis=-1)
    if again.any():
        there = np.take_along_axis(measured, order[:, 1:], axis=1)
        np.put_along_axis(measured, order[:, 1:], there & ~again, axis=1)
        order = _order(times, measured)
    measured = np.take_along_axis(measured, order, axis=1)
    t = np.take_along_axis(times, order, axis=1)
    xyz = np.take_along_axis(positions, order[..., None], axis=1)
    some = measured.any(axis=1)
    first = np.full(len(times), np.nan)
    first[some] = t[some, 0]
    since = np.where(measured, t - np.where(some, first, 0.0)[:, None], 0.0)
    return Tracks(
        since,
        np.where(measured[..., None], xyz, 0.0),
        measured,
        first,
        labels,
        np.take_along_axis(places, order, axis=1),
        shape,
    )


def _order(times: Floats, measured: Flags) -> NDArray[np.intp]:
    """Return the places of the frames of each track in order of time, of gaps last."""
    return np.argsort(np.where(measured, times, np.inf), axis=1, kind="stable")
