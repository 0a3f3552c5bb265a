"""The bend of flights, which is taken off the positions of a track so that a straight line is left.

Without air that is the fall, a t²/2. In air it is the way of the present estimate of the flight,
less the straight line with its position and velocity at the start. The line that is fitted to the
rest gives the next estimate, and so on. Where this settles, the residuals r of the frames fulfil

    Σ w D_line^T r / σ² = 0,

with the design D_line of a straight line, where the most likely flight has that of the flight, D:
the derivatives of its positions by position and velocity at the start. The estimate is that of
instrumental variables (R. J. Bowden and D. A. Turkington (1984), Instrumental variables), whose
covariance is A^-1 B A^-T with A = Σ D_line^T D / σ² and B = Σ D_line^T D_line / σ², divided by the
efficiency of the weights. Drag changes D by a tenth, so hardly anything of the efficiency is lost.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Protocol

import numpy as np

from hoopgen.core.parameters import Value
from hoopgen.simulation.engine import Engine

from .estimator import EFFICIENCY, Flags, Floats, Lines, line_covariance
from .frames import MIN_NOISE
from .spins import Spins

_ROUGH_NOISE = 0.15
"""m. The noise with which flights in air are fitted first, as parabolas: these are so far off."""

_LONGEST = 20.0
"""s. Frames so long after the first one are left out in air."""

_FASTEST = 1e3
"""m/s. A faster ball is no estimate of a flight in air."""

_STEP = 1e-3
"""m/s. Step of the differences for the derivatives of flights by the velocity; a flight's third
derivative is about k_d/v times its first, so that their error is below 1e-8 of it."""

_TRACKS = 256
"""Tracks whose flights in air are followed together, which bounds the memory that this takes."""

_SETTLED = 1e-4
"""Standard deviations of a frame: changes by which an estimate in air is no longer improved, nor by
`MIN_NOISE`."""


class Bends(Protocol):
    """The bend of the flights of tracks.

    Attributes
    ----------
    fall
        The acceleration of each ball at rest, (n, 3), m/s².
    passes
        Most times that the bend is computed from a better estimate.
    rough
        Noise of the first estimate, m; 0 if that is as good as any.
    longest
        Time since the first frame after which frames are left out, s.
    """

    fall: Floats
    passes: int
    rough: float
    longest: float

    def offsets(self) -> Floats:
        """Return the distances of the frames from a straight line, (3, n, m), m."""
        ...

    def states(self, lines: Lines, since: Floats, rows: Any) -> Floats:
        """Return the states of some tracks at times since their first frames, (n, 9).

        Parameters
        ----------
        lines
            Their fitted lines.
        since
            s, (n,).
        rows
            The indices of these tracks.
        """
        ...

    def covariance(self, lines: Lines, since: Floats, frames: Flags, noise: Floats) -> Floats:
        """Return the covariance of position and velocity at times, (n, 6, 6).

        Parameters
        ----------
        lines
            The fitted lines.
        since
            s since the first frames, (n,).
        frames
            Which frames count, (n, m).
        noise
            The standard deviation of each coordinate, (3,), m.
        """
        ...

    def follow(self, lines: Lines, noise: Floats) -> Flags:
        """Compute the bend from an estimate; return the tracks of which that has changed it, (n,).

        Parameters
        ----------
        lines, noise
            As for `Bends.covariance`.
        """
        ...


class Parabolas:
    """Flights with known acceleration, as `Bends`.

    Parameters
    ----------
    fall
        The acceleration, (n, 3), m/s².
    times
        Of the frames, (n, m), s since the first one.
    spins
        The spins at the release.
    """

    passes, rough, longest = 0, 0.0, np.inf

    def __init__(self, fall: Floats, times: Floats, spins: Spins) -> None:
        self.fall, self._times, self._spins = fall, times, spins

    def offsets(self) -> Floats:
        """Return a t²/2, (3, n, m)."""
        return np.asarray(0.5 * self.fall.T[..., None] * (self._times * self._times))

    def follow(self, lines: Lines, noise: Floats) -> Flags:
        """Return that no track has changed: the bend is that of every flight, as of `Bends`."""
        del lines, noise
        return np.zeros(len(self.fall), np.bool_)

    def states(self, lines: Lines, since: Floats, rows: Any) -> Floats:
        """Return the states, as of `Bends.states`."""
        fall = self.fall[rows]
        position = lines.at(since[:, None])[..., 0].T + 0.5 * fall * (since * since)[:, None]
        velocity = lines.slope.T + fall * since[:, None]
        return self._spins.states(position, velocity, rows)

    def covariance(self, lines: Lines, since: Floats, frames: Flags, noise: Floats) -> Floats:
        """Return the covariance, as of `Bends.covariance`."""
        blocks = line_covariance(self._times - since[:, None], frames)
        covariance = np.zeros((len(blocks), 6, 6))
        for axis, size in enumerate(noise):
            covariance[:, axis::3, axis::3] = size * size * blocks
        return covariance


class FlightsInAir:
    """Flights through air, by the scene's own motion, as `Bends`.

    Parameters
    ----------
    engine
        The scene.
    values
        Its parameters, one number each or (n,).
    fall
        The acceleration at rest, (n, 3), m/s².
    times, spins
        As for `Parabolas`.
    release
        Of the tracks whose release is known, s since the first frame, (n,); else 0.
    """

    passes = 12
    rough = _ROUGH_NOISE
    longest = _LONGEST

    def __init__(
        self,
        engine: Engine,
        values: Mapping[str, Value],
        fall: Floats,
        times: Floats,
        release: Floats,
        spins: Spins,
    ) -> None:
        self.fall, self._engine, self._values, self._spins = fall, engine, values, spins
        self._origin = np.minimum(0.0, np.nan_to_num(release))
        self._times = np.minimum(times - self._origin[:, None], _LONGEST)
        self._start = np.full((len(times), 9), np.nan)
        self._bent: Floats = 0.5 * fall.T[..., None] * (self._times * self._times)

    def offsets(self) -> Floats:
        """Return the bend of the flights as last followed, (3, n, m)."""
        return self._bent

    def states(self, lines: Lines, since: Floats, rows: Any) -> Floats:
        """Return the states, as of `Bends.states`."""
        start = self._starts(lines, rows)
        with np.errstate(invalid="ignore"):
            there: Floats = self._engine.fly(since - self._origin[rows], start, self._own(rows))
        return there

    def follow(self, lines: Lines, noise: Floats) -> Flags:
        """Compute the bend of the estimated flights, as of `Bends.follow`."""
        start = self._starts(lines, slice(None))
        change = np.abs(start - self._start)[:, :6].T.reshape(2, 3, -1)
        longest = self._times.max(axis=1, initial=0.0)
        least = np.maximum(_SETTLED * noise, MIN_NOISE)[:, None]
        far = np.max((change[0] + change[1] * longest) / least, axis=0)
        changed = np.isfinite(start).all(axis=1) & ~(far <= 1.0)
        moving = np.flatnonzero(changed)
        for first in range(0, len(moving), _TRACKS):
            rows = moving[first : first + _TRACKS]
            straight = start[rows, :3].T[..., None]
            straight = straight + start[rows, 3:6].T[..., None] * self._times[rows]
            self._bent[:, rows] = self._positions(start[rows], rows) - straight
            self._start[rows] = start[rows]
        return np.asarray(changed)

    def covariance(self, lines: Lines, since: Floats, frames: Flags, noise: Floats) -> Floats:
        """Return the covariance, as of `Bends.covariance`."""
        start = self._starts(lines, slice(None))
        found = np.full((len(start), 6, 6), np.nan)
        known = np.flatnonzero(np.isfinite(start).all(axis=1) & (frames.sum(axis=1) > 1))
        for first in range(0, len(known), _TRACKS):
            rows = known[first : first + _TRACKS]
            found[rows] = self._covariances(start[rows], since[rows], frames[rows], noise, rows)
        return found

    def _covariances(
        self, start: Floats, since: Floats, frames: Flags, noise: Floats, rows: Any
    ) -> Floats:
        """Return the covariance of some tracks."""
        count, times = len(start), self._times[rows]
        design = np.zeros((count, times.shape[1], 3, 6))  # of the flight
        whole = np.zeros((count, 6, 6))  # of the state at the time asked for
        later = since - self._origin[rows]
        for axis in range(3):
            design[:, :, axis, axis] = 1.0
            whole[:, axis, axis] = 1.0
            ends = []
            for sign in (1.0, -1.0):
                moved = start.copy()
                moved[:, 3 + axis] += sign * _STEP
                moved = self._spins.states(moved[:, :3], moved[:, 3:6], rows)
                there = self._engine.fly(later, moved, self._own(rows))
                ends.append((self._positions(moved, rows), there[:, :6]))
            (above, after), (below, before) = ends
            design[..., 3 + axis] = np.moveaxis(above - below, 0, -1) / (2.0 * _STEP)
            whole[:, :, 3 + axis] = (after - before) / (2.0 * _STEP)
        line = np.zeros_like(design)
        for axis in range(3):
            line[:, :, axis, axis] = 1.0
            line[:, :, axis, 3 + axis] = times
        weights = frames[:, :, None, None] / (noise * noise)[:, None]
        turned = np.einsum("nikp,nikq->npq", line * weights, design)
        square = np.einsum("nikp,nikq->npq", line * weights, line)
        found = np.full((count, 6, 6), np.nan)
        able = np.linalg.matrix_rank(turned, hermitian=False) == 6
        inverse = whole[able] @ np.linalg.inv(turned[able])
        found[able] = inverse @ square[able] @ np.swapaxes(inverse, 1, 2)
        return found / EFFICIENCY

    def _starts(self, lines: Lines, rows: Any) -> Floats:
        """Return the states at the earliest time, (n, 9); NaN where there is no estimate."""
        origin = self._origin[rows]
        position, velocity = lines.at(origin[:, None])[..., 0].T, lines.slope.T
        start = self._spins.states(position, velocity, rows)
        with np.errstate(invalid="ignore"):
            fast = ~(np.abs(velocity).max(axis=1) <= _FASTEST)
        return np.where(fast[:, None], np.nan, start)

    def _positions(self, start: Floats, rows: Any) -> Floats:
        """Return the positions at the frames of flights, (3, n, m)."""
        there = self._engine.follow(self._times[rows], start, self._own(rows))
        return np.moveaxis(there, -1, 0)

    def _own(self, rows: Any) -> dict[str, Value]:
        """Return the parameters of some tracks."""
        return {n: np.asarray(v)[rows] if np.ndim(v) else v for n, v in self._values.items()}


def bends_of(
    engine: Engine,
    values: Mapping[str, Value],
    times: Floats,
    release: Floats,
    spins: Spins,
) -> Bends:
    """Return the bend of the flights of tracks in a scene.

    Parameters
    ----------
    engine, values, times, release, spins
        As for `FlightsInAir`.
    """
    tracks = len(times)
    if engine.kernels.PIECES:
        soon = 2.0**-10
        rest = np.zeros((tracks, 9))
        fall = engine.fly(soon, rest, values)[:, :3] * (2.0 / soon**2)
        return FlightsInAir(engine, values, fall, times, release, spins)
    with np.errstate(invalid="ignore", over="ignore"):
        fall = 2.0 * engine.fly(1.0, np.zeros((tracks, 9)), values)[:, :3]
    return Parabolas(np.asarray(fall), times, spins)
