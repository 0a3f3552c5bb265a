"""`fit_release`: from the measured track of a ball to its release."""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Mapping
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.special import chdtrc, fdtrc

from hoopgen.core.argument_types import check_arguments
from hoopgen.core.parameters import ParameterValues, Value, resolve
from hoopgen.core.validation import as_doubles, check_count
from hoopgen.scene.lookup import SceneLike
from hoopgen.simulation.engine import Engine
from hoopgen.simulation.lookup import engine_of
from hoopgen.simulation.simulate import simulate
from hoopgen.text.shorten import brief

from .axes_check import above_floor, unit_of
from .bends import bends_of
from .estimator import ROUGH, TOLERANCE, Flags, Floats
from .fitted_backspin import LEVEL, with_backspin
from .fitted_releases import FittedReleases
from .frames import (
    MAX_OUTLIERS,
    MIN_FRAMES,
    OUTLIER,
    Measured,
    earliest_frame,
    first_flight,
    noise_of_differences,
    pooled_noise,
)
from .spins import Spins, spins_of
from .tracks import Tracks, as_tracks

_FREE_ROUNDS = 4
"""Rounds after which the flight only becomes shorter, so that a frame at the contact cannot come
and go for ever."""

_NOISE_STEPS = 12
_NOISE_TOLERANCE = 1e-6

TOO_FEW = "too few frames"
UNSETTLED = "the fit and its cut at the first contact do not settle"
NOT_SIMULATED = "the fitted release cannot be simulated"
TWO_FLIGHTS = "frames of two flights"
TOO_LARGE = "residuals too large"
IN_HAND = "frames before the flight begins"
TOO_NOISY = "estimated noise larger than the ball"
OTHER_UNIT = "it falls as if the positions were in {unit}"
ABOVE_FLOOR = "released far above the ring: are these heights above the floor?"


@check_arguments
def fit_release(
    times: ArrayLike,
    positions: ArrayLike,
    *,
    tracks: Iterable[Hashable] | None = None,
    scene: SceneLike = None,
    parameters: ParameterValues | None = None,
    noise: ArrayLike | None = None,
    release_time: ArrayLike | Literal["detect"] | None = None,
    spin: ArrayLike | None = None,
    backspin: ArrayLike | None = None,
    backspin_sd: ArrayLike | None = None,
    rounds: int = 10,
) -> FittedReleases:
    """Fit the releases of measured tracks, each the flight of a ball to its first contact.

    The path from the release to the first contact is a parabola with known acceleration, or a
    flight through the scene's air. It is fitted with errors of Student's t, so that outliers have
    little influence; `hoopgen.study.recovery.estimator` derives the estimate and its covariance,
    `bends` what is different in air. Frames after the
    first contact are left out: the fitted release is simulated in the scene, frames from the time
    of its first contact, or of its end, are cut, and the rest is fitted again, until the set of
    frames is stable.

    Parameters
    ----------
    times
        s, of any clock: (m,) for one track, or one clock for all, or (n, m). Frames need no order
        and no even rate; they are sorted.
    positions
        Of the ball's centre, m, in hoopgen's axes: (m, 3) or (n, m, 3). A frame whose time or
        position is not finite is a gap, and so is one that repeats another, time and place.
    tracks
        Labels of the frames, (m,), where `times` (m,) and `positions` (m, 3) hold many tracks one
        below the other; the releases are in the order in which labels first appear.
    scene
        As for `hoopgen.simulate`: in which the first contact is found.
    parameters
        Of the scene, among them gravity; one number or one a track, (n,).
    noise
        Standard deviation of a coordinate of a frame, m: one number or (3,). The errors of frames
        are taken to be independent, which those of a smoothed track are not. None: estimated from
        the residuals of all tracks together, by coordinate.
    release_time
        s, on the clock of `times`, one or (n,): frames before are in the hand and left out. None:
        the first frame of the track is the release. "detect": the release is the earliest frame
        that is consistent with the parabola.
    spin
        rad/s, (3,) or (n, 3); 0 if neither this nor `backspin` is given. The positions of a flight
        without air do not determine the spin.
    backspin
        rad/s about the horizontal axis across the fitted flight, one or (n,), in place of `spin`.
    backspin_sd
        Standard deviation of what is known of the backspin before the track, rad/s, one or (n,).
        With it the backspin is fitted, too: by the flight after the first contact, which is in the
        fit then, and in air by the force on the spinning ball. `math.inf` for no knowledge, where
        `backspin` may be missing. The contact is that of the scene, whose restitutions, frictions
        and places of bodies are taken to be known. None: the backspin is known exactly.
    rounds
        Most times that the cut at the first contact is made.

    Returns
    -------
    FittedReleases
        By track. A track that cannot be fitted has NaN, and changes no other.

    Raises
    ------
    TypeError, ValueError
        If an argument is not as described, or the flights of the scene are no parabolas; the
        message names the argument.
    """
    engine = engine_of(scene)
    measured = as_tracks(times, positions, tracks)
    values = resolve(parameters, len(measured), engine.table)
    given = _noise(noise)
    spins = spins_of(spin, backspin, backspin_sd, len(measured))
    start, detect = _release_times(release_time, measured)
    problem = _Problem(engine, values, measured, given, start, detect, spins)
    problem.settle(check_count("rounds", rounds))
    return problem.result()


class _Problem:
    """The fit of many tracks while it is under way."""

    def __init__(
        self,
        engine: Engine,
        values: Mapping[str, Value],
        tracks: Tracks,
        noise: Floats | None,
        start: Floats,
        detect: bool,
        spins: Spins,
    ) -> None:
        self.engine, self.values, self.tracks = engine, values, tracks
        self.spins, self.detect, self.release = spins, detect, start
        t = tracks.times
        self.bends = bends_of(engine, values, t, np.zeros(len(t)) if detect else start, spins)
        there: Flags = tracks.measured & np.isfinite(self.bends.fall).all(axis=1, keepdims=True)
        there &= t <= self.bends.longest
        if not detect:
            slack = 1e-9 + 1e-12 * np.abs(np.nan_to_num(tracks.first))
            there &= t >= (start - slack)[:, None]
        self.there = there
        self._straighten()
        self.given = noise
        self.degrees = np.inf if noise is not None else 0.0
        self.noise = noise_of_differences(self.measured) if noise is None else noise
        self.unknown = bool(np.isnan(self.noise).any())  # no track has three frames
        if self.unknown:
            self.noise = np.ones(3)
        self.settled = np.zeros(len(tracks), np.bool_)
        self.impossible = np.zeros(len(tracks), np.bool_)

    def _straighten(self) -> None:
        """Take the bend of the flights off the positions."""
        positions = np.moveaxis(self.tracks.positions, -1, 0) - self.bends.offsets()
        positions[:, ~self.there] = 0.0
        self.measured = Measured(self.tracks.times, positions, self.there)

    def settle(self, rounds: int) -> None:
        """Fit the flights; those in air again with the bend of the flights fitted before."""
        if self.bends.rough:
            known, self.given = (self.given, self.noise), np.maximum(self.noise, self.bends.rough)
            self.noise = self.given
            self._settle(rounds)
            self.given, self.noise = known
        else:
            self._settle(rounds)
        for _ in range(self.bends.passes):
            if not self.bends.follow(self.lines, self.noise).any():
                break
            self._straighten()
            self.settled[:] = False
            self._settle(rounds)
        else:
            self.settled &= ~self.bends.follow(self.lines, self.noise)

    def _settle(self, rounds: int) -> None:
        """Fit, cut at the first contact, and fit again."""
        everything = self.measured.frames
        self.lines, self.frames = first_flight(
            self.measured, everything, self.noise, detect=self.detect
        )
        if self.detect:
            begin = np.argmax(self.frames, axis=1)
            self.release = np.take_along_axis(self.measured.times, begin[:, None], axis=1)[:, 0]
        for number in range(rounds):
            rows = np.flatnonzero(~self.settled)
            if not len(rows):
                break
            self._refit(rows, ROUGH)
            if self.given is None:
                self._estimate_noise()
            chosen = self._flight(rows)
            if number >= _FREE_ROUNDS:
                chosen &= self.frames[rows]
            self.settled[rows] = (chosen == self.frames[rows]).all(axis=1)
            self.frames[rows] = chosen
        self._refit(np.arange(len(self.tracks)))
        for _ in range(_NOISE_STEPS if self.given is None else 0):
            before = self.noise
            self._estimate_noise()
            self._refit(np.arange(len(self.tracks)))
            if np.all(np.abs(self.noise - before) <= _NOISE_TOLERANCE * before):
                break

    def _refit(self, rows: NDArray[np.intp], tolerance: float = TOLERANCE) -> None:
        """Fit the frames of some tracks, beginning with the parabolas that they have."""
        part, start = self.measured.take(rows), self.lines.take(rows)
        lost = ~np.isfinite(start.slope).all(axis=0)
        fitted = part.fit(self.frames[rows], self.noise, start, tolerance)
        if lost.any():
            again = part.take(lost).fit(self.frames[rows][lost], self.noise, None, tolerance)
            fitted.put(lost, again)
        self.lines.put(rows, fitted)

    def _estimate_noise(self) -> None:
        self.noise, self.degrees = pooled_noise(self.measured, self.lines, self.frames, self.noise)

    def _flight(self, rows: NDArray[np.intp]) -> Flags:
        """Return the frames from the release to the first contact of some fitted tracks."""
        part, lines = self.measured.take(rows), self.lines.take(rows)
        states = self.states(rows)
        own = {n: np.asarray(v)[rows] if np.ndim(v) else v for n, v in self.values.items()}
        shots = simulate(
            states, own, scene=self.engine, max_contacts=1, fields=("outcome", "contacts", "time")
        )
        ended = (shots.contacts > 0) | (shots.outcome < len(self.engine.kernels.ENDS))
        invalid = shots.outcome == self.engine.outcomes["INVALID"]
        self.impossible[rows] = invalid
        end = np.where(ended & ~invalid, shots.time + self.release[rows], np.inf)
        # A frame so near to the contact that the noise may have put it before is not needed.
        fallen = self.bends.fall[rows] * shots.time[:, None]
        speed = np.linalg.norm(states[:, 3:6] + fallen, axis=1)
        with np.errstate(divide="ignore", invalid="ignore"):
            margin = np.nan_to_num(2.0 * self.noise.max() / speed, nan=0.0, posinf=0.0)
        frames = part.frames & (part.times < (end - margin)[:, None])
        if self.detect:
            begin = earliest_frame(part, lines, frames, self.noise)
            columns = np.arange(frames.shape[1])
            frames &= columns >= begin[:, None]
            found = np.take_along_axis(part.times, begin[:, None], axis=1)[:, 0]
            self.release[rows] = np.where(frames.any(axis=1), found, np.nan)
        return np.asarray(frames)

    def states(self, rows: Any = slice(None)) -> Floats:
        """Return the states at the release, (n, 9)."""
        return self.bends.states(self.lines.take(rows), self.release[rows], rows)

    def result(self) -> FittedReleases:
        """Return the releases, and which of them are credible."""
        tracks, part = self.tracks, self.measured
        off = part.squares(self.lines, self.noise)
        outliers = part.outliers(self.lines, self.frames, self.noise)
        kept = self.frames & ~outliers
        fitted = np.isfinite(self.states()[:, :6]).all(axis=1) & (kept.sum(axis=1) >= MIN_FRAMES)
        covariance = self.bends.covariance(self.lines, self.release, kept, self.noise)
        fitted &= np.isfinite(covariance).all(axis=(1, 2)) & (not self.unknown)
        states = np.where(fitted[:, None], self.states(), np.nan)
        covariance[~fitted] = np.nan
        reasons = self._reasons(fitted, off, outliers, kept)
        residuals = np.moveaxis(part.positions - self.lines.at(part.times), 0, -1)
        residuals[~self.frames] = np.nan
        found = FittedReleases(
            states=states,
            covariance=covariance,
            time=np.where(fitted, self.release + tracks.first, np.nan),
            residuals=tracks.as_given(residuals, np.nan),
            noise=np.full(3, np.nan) if self.unknown else self.noise.copy(),
            degrees=self.degrees,
            frames=tracks.as_given(self.frames, False),
            outliers=tracks.as_given(outliers, False),
            counts=np.stack([self.frames.sum(axis=1), outliers.sum(axis=1)], axis=1),
            credible=np.array([not reason for reason in reasons], np.bool_),
            reason=reasons,
            labels=tracks.labels,
            backspin=self.spins.backspin,
            spin_given=self.spins.given,
            parameters=self.values,
            scene=self.engine,
        )
        if self.spins.precision is None:
            return found
        frames = self.there, self.frames
        fall, misfits = self.bends.fall, (TOO_LARGE, TWO_FLIGHTS, IN_HAND)
        # In air a wrong backspin bends the first flight otherwise, too.
        undecided = np.array([one in misfits for one in reasons], np.bool_)
        undecided &= bool(self.engine.kernels.PIECES)
        return with_backspin(found, tracks, frames, self.release, fall, self.spins, undecided)

    def _reasons(self, fitted: Flags, off: Floats, outliers: Flags, kept: Flags) -> tuple[str, ...]:
        """Return why each track is not credible, "" for one that is."""
        counts = kept.sum(axis=1)
        free = np.maximum(3.0 * counts - 6.0, 1.0)
        total = np.where(kept, off, 0.0).sum(axis=1)
        if self.given is not None:
            chance = chdtrc(free, total)
        else:  # the noise has an error of its own
            chance = fdtrc(free, max(3.0 * self.degrees, 1.0), total / free)
        many = outliers.sum(axis=1) > MAX_OUTLIERS * self.frames.sum(axis=1)
        large = fitted & (many | (chance < LEVEL))
        two = np.zeros(len(counts), np.bool_)
        two[large & many] = self._other_flight(np.flatnonzero(large & many), outliers)
        early = np.zeros(len(counts), np.bool_)
        if not self.detect:  # one may be an outlier, two are in the hand
            order = np.cumsum(self.frames, axis=1)
            early = (outliers & (order <= 2)).sum(axis=1) >= 2
        noisy = np.zeros(len(counts), np.bool_)
        if self.given is None and self.engine.has_hoop:  # wrong units bend all tracks alike
            noisy |= fitted & (self.noise.max() > np.asarray(self.values["ball_radius"]))
        everywhere = np.zeros(len(counts), np.bool_)
        unit, floor = "", False
        if self.engine.has_hoop:
            unit = unit_of(self.measured, self.lines, self.frames, self.bends.fall)
            floor = above_floor(self.states()[fitted, 2])
        found = np.full(len(counts), "", dtype=object)
        for reason, which in (
            (TOO_LARGE, large),
            (TWO_FLIGHTS, two),
            (IN_HAND, early & fitted),
            (UNSETTLED, ~self.settled),
            (TOO_NOISY, noisy),
            (ABOVE_FLOOR, everywhere | floor),
            (OTHER_UNIT.format(unit=unit), everywhere | bool(unit)),
            (NOT_SIMULATED, self.impossible),
            (TOO_FEW, ~fitted),
        ):
            found[which] = reason
        return tuple(map(str, found))

    def _other_flight(self, rows: NDArray[np.intp], outliers: Flags) -> Flags:
        """Return whether the outliers of tracks lie on a parabola of their own."""
        part, other = self.measured.take(rows), outliers[rows]
        lines = part.fit(other, self.noise)
        lying = other & (part.squares(lines, self.noise) <= OUTLIER)
        counts = other.sum(axis=1)
        return np.asarray((counts > MIN_FRAMES) & (lying.sum(axis=1) >= 0.8 * counts))


def _noise(noise: ArrayLike | None) -> Floats | None:
    if noise is None:
        return None
    given = as_doubles("noise", noise, "a standard deviation in m, or three")
    if given.shape not in ((), (3,)) or not np.all((given > 0.0) & (given < np.inf)):
        raise ValueError(
            f"noise: expected a standard deviation above 0 in m, or three, got {brief(noise)}"
        )
    return np.array(np.broadcast_to(given, 3))


def _release_times(release_time: Any, tracks: Tracks) -> tuple[Floats, bool]:
    """Return the release of each track since its first frame, and whether it is unknown."""
    count = len(tracks)
    if release_time is None:
        return np.zeros(count), False
    if isinstance(release_time, str):
        if release_time != "detect":
            raise ValueError(
                f'release_time: expected s, "detect" or None, got {brief(release_time)}'
            )
        return np.zeros(count), True
    given = as_doubles("release_time", release_time, 's, "detect" or None')
    if given.shape not in ((), (count,)):
        raise ValueError(
            f"release_time: expected one number or {count}, one a track; got shape {given.shape}"
        )
    return np.broadcast_to(given, (count,)) - tracks.first, False
