"""`FittedReleases`: releases that were fitted to tracks, with their errors."""

from __future__ import annotations

from collections import Counter
from collections.abc import Hashable, Mapping
from dataclasses import dataclass
from functools import cached_property
from math import inf, isinf
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray
from scipy.special import stdtrit

from hoopgen.core.extras import require
from hoopgen.core.parameters import Value
from hoopgen.core.units import System, column_name, display_unit, file_unit
from hoopgen.core.validation import check_count
from hoopgen.core.variables import STATE
from hoopgen.hoop.arguments import FLIGHT_ARGUMENTS, arguments_jacobian, arguments_of
from hoopgen.hoop.variables import ARGUMENTS
from hoopgen.simulation.engine import Engine
from hoopgen.simulation.simulate import simulate
from hoopgen.study.named_units import unit_in
from hoopgen.study.result import Result
from hoopgen.study.statistics.intervals import wilson_interval
from hoopgen.study.statistics.tally import check_share
from hoopgen.text.html import table as rendered
from hoopgen.text.numbers import format_count
from hoopgen.text.tables import table

from .backspin import states_with_backspin
from .fitted_text import first_cells
from .made import MadeGivenTrack
from .posterior import draw_errors, without_prior

if TYPE_CHECKING:
    from pandas import DataFrame
    from pyarrow import Table as ArrowTable

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]

_SHOTS = 1 << 18
"""Shots that are simulated together."""


@dataclass(frozen=True, eq=False, repr=False)
class FittedReleases(Result):
    """Releases fitted to n tracks; NaN for a track that cannot be fitted.

    Attributes
    ----------
    states
        At the release, (n, 9): x y z (m), vx vy vz (m/s), wx wy wz (rad/s). The spin is what was
        given, 0 if nothing was, or the fitted backspin.
    covariance
        Of position and velocity, (n, 6, 6), SI: right if the errors are normal and independent.
        Outliers are not counted as frames in it; that they move the fit a little is not in it, nor
        that parameters and, in air, the spin are not known exactly. With a fitted backspin, which
        is the last variable then, (n, 7, 7).
    time
        Of the release, (n,), s, on the clock of the frames.
    residuals
        Measured less fitted positions of the frames in the fit, m, in the shape of the positions;
        NaN elsewhere.
    noise
        Standard deviation of each coordinate of a frame, (3,), m, given or estimated.
    degrees
        Degrees of freedom of each estimate of the noise; infinite if it was given.
    frames
        Which frames lie between the release and the first contact, in the shape of the times, and
        if the backspin is fitted those of the flight after it: they are in the fit, outliers with
        their small weight.
    outliers
        Which of them are outliers: residuals that one frame of 10,000 has by chance.
    counts
        Number of frames in the fit and of outliers among them, (n, 2).
    credible
        Whether a track is the flight of a ball, (n,).
    reason
        Why it is not, by track: too few frames, residuals too large (a chi-square test at
        0.1%, or more outliers than a quarter of the frames), frames of two flights (the outliers
        lie on another parabola), frames before the flight begins (the first two are outliers),
        the fit or its cut at the first contact does not settle, the estimated noise is larger than
        the ball (all tracks at a hoop are called so; their unit or clock is another one), or the
        fitted release cannot be simulated. Of a backspin: frames after the first contact do not fit
        it, nothing shows it, or it is too far from the one given (0.1%). "" for a credible one.
    labels
        Of the tracks, as given; else their numbers from 0.
    backspin
        rad/s, (n,), if that was given or fitted; else None.
    spin_given
        Whether the spin was given in any way.
    parameters
        Of the scene: one number each, or (n,).
    scene
        In which the first contacts were found.
    backspin_before
        Of a fitted backspin the mean and the inverse variance before the track, (n,) each.
    """

    states: Floats
    covariance: Floats
    time: Floats
    residuals: Floats
    noise: Floats
    degrees: float
    frames: Flags
    outliers: Flags
    counts: NDArray[np.int64]
    credible: Flags
    reason: tuple[str, ...]
    labels: tuple[Hashable, ...]
    backspin: Floats | None
    spin_given: bool
    parameters: Mapping[str, Value]
    scene: Engine
    backspin_before: tuple[Floats, Floats] | None = None

    def __len__(self) -> int:
        return len(self.states)

    @cached_property
    def variables(self) -> Mapping[str, Floats]:
        """Return speed, elevation, azimuth, height, distance and angle, (n,) each; m, m/s, rad."""
        found = arguments_of(self.states)
        return {name: found[name] for name in FLIGHT_ARGUMENTS}

    @cached_property
    def variables_covariance(self) -> Floats:
        """Return the covariance of the errors of `variables`, (n, 6, 6), of first order.

        If the backspin is fitted, it is the last variable, (n, 7, 7).
        """
        jacobian = np.zeros(self.covariance.shape)
        jacobian[:, :6, :6] = arguments_jacobian(self.states)
        jacobian[:, 6:, 6:] = 1.0
        with np.errstate(invalid="ignore"):
            found = np.einsum("nij,njk,nlk->nil", jacobian, self.covariance, jacobian)
        return np.asarray(found)

    @cached_property
    def measured(self) -> tuple[dict[str, Floats], Floats]:
        """Return the arguments that the tracks alone give, with the spin, and their covariance.

        A fitted backspin is here without what was known of it before the track, as `Scatter.fit`
        needs it, which finds out how a player's backspins differ.
        """
        found = dict(self.variables)
        if self.backspin is not None:
            found["backspin"] = np.asarray(self.backspin)
        if self.backspin_before is None:
            return found, self.variables_covariance
        stacked = np.stack([*found.values()], axis=1)
        alone, covariance = without_prior(stacked, self.variables_covariance, *self.backspin_before)
        return dict(zip(found, alone.T, strict=True)), covariance

    @cached_property
    def standard_errors(self) -> Mapping[str, Floats]:
        """Return the standard errors of `variables` and of the components of `states`, (n,) each.

        Those of variables are of first order: the Jacobian times the covariance.
        """
        with np.errstate(invalid="ignore"):
            found = np.sqrt(np.diagonal(self.variables_covariance, axis1=1, axis2=2))
            own = np.sqrt(np.diagonal(self.covariance, axis1=1, axis2=2))
        names = (*FLIGHT_ARGUMENTS, *self.fitted_spin)
        named = dict(zip(names, found.T, strict=True))
        return named | dict(zip(STATE[:6], own.T[:6], strict=True))

    @property
    def fitted_spin(self) -> tuple[str, ...]:
        """The name of the spin if that is fitted, else none."""
        return ("backspin",) if self.covariance.shape[1] > 6 else ()

    def intervals(self, confidence: float = 0.95) -> dict[str, tuple[Floats, Floats]]:
        """Return the ends of confidence intervals, (n,) each, of what has a standard error.

        Quantiles are those of Student's t if the noise was estimated, else normal ones.

        Parameters
        ----------
        confidence
            Within 0 and 1.
        """
        confidence = check_share("confidence", confidence)
        # The t distribution with 1e9 degrees of freedom is the normal one to nine digits.
        times = float(stdtrit(min(max(self.degrees, 1.0), 1e9), 0.5 + 0.5 * confidence))
        values = {**self.variables, **dict(zip(STATE[:6], self.states.T[:6], strict=True))}
        if self.fitted_spin:
            values["backspin"] = np.asarray(self.backspin)
        return {
            name: (values[name] - times * error, values[name] + times * error)
            for name, error in self.standard_errors.items()
        }

    def draw(self, shots: int, seed: int = 0) -> Floats:
        """Return releases from the distribution of each fit.

        Position, velocity and a fitted backspin are normal with the covariance; of Student's t if
        the noise was estimated. A spin that is given is as it is, a backspin across the flight
        that is drawn.

        Parameters
        ----------
        shots
            Of each track.
        seed
            From 0 to 2^64 - 1.

        Returns
        -------
        ndarray
            States, (n, shots, 9); NaN of tracks that cannot be fitted.
        """
        return self._drawn(check_count("shots", shots), seed, 0, len(self))

    def _drawn(self, shots: int, seed: int, first: int, last: int) -> Floats:
        """Return the draws of tracks `first` to `last` - 1."""
        part = slice(first, last)
        errors = draw_errors(self.covariance[part], self.degrees, shots, seed, (first, last))
        drawn = self.states[part, None, :6] + errors[..., :6]
        if self.backspin is not None:
            backspin = self.backspin[part, None]
            if self.fitted_spin:
                backspin = backspin + errors[..., 6]
            return states_with_backspin(drawn[..., :3], drawn[..., 3:], backspin)
        spins = np.broadcast_to(self.states[part, None, 6:], (*drawn.shape[:2], 3))
        return np.concatenate([drawn, spins], axis=2)

    def made(self, shots: int = 1000, seed: int = 0, confidence: float = 0.95) -> MadeGivenTrack:
        """Return the probability that each shot goes in, given its track.

        Releases drawn from the distribution of the fit are simulated in the scene. In a scene
        without a hoop it is the probability of the first end. Nothing but the track counts: before
        it, all releases are taken to be equally likely. Of players whose releases differ less from
        each other than the tracks' errors, more shots go in, or fewer, than these numbers say.

        Parameters
        ----------
        shots
            Simulated for each track.
        seed
            From 0 to 2^64 - 1.
        confidence
            Of the interval, that of the simulation.

        Raises
        ------
        ValueError
            If the scene has no end, or an argument is not as described.
        """
        if not len(self.scene.kernels.ENDS):
            raise ValueError(f"made: the scene {self.scene.name} has no end in which a shot goes")
        confidence = check_share("confidence", confidence)
        shots = check_count("shots", shots)
        counts = np.zeros((len(self), 2), np.int64)
        step = max(1, _SHOTS // shots)
        for first in range(0, len(self), step):
            last = min(first + step, len(self))
            drawn = self._drawn(shots, seed, first, last)
            own = {
                name: np.repeat(np.asarray(value)[first:last], shots) if np.ndim(value) else value
                for name, value in self.parameters.items()
            }
            found = simulate(drawn.reshape(-1, 9), own, scene=self.scene, fields=("outcome",))
            ended = found.outcome.reshape(-1, shots)
            counts[first:last, 0] = np.sum(ended == 0, axis=1)
            counts[first:last, 1] = np.sum(ended != self.scene.outcomes["INVALID"], axis=1)
        counts[~self.credible] = 0
        with np.errstate(invalid="ignore"):
            share = counts[:, 0] / counts[:, 1]
        low, high = wilson_interval(counts[:, 0], counts[:, 1], confidence)
        known = counts[:, 1] > 0
        low, high = np.where(known, low, np.nan), np.where(known, high, np.nan)
        return MadeGivenTrack(share, low, high, counts[:, 1], confidence, self.labels)

    def columns(self, units: System = "si") -> dict[str, Any]:
        """Return the columns of a table of releases, by name with unit.

        Label, speed, angles and place, or in a scene without a hoop the state; the time; standard
        errors; and whether the track is credible. Releases that are not are NaN, so that `batch`
        counts their rows as INVALID and studies leave them out.

        Parameters
        ----------
        units
            "si", or "us" for feet, mph and degrees.
        """
        trusted = self.credible
        arguments = arguments_of(self.states)
        spins: list[str] = ["backspin", "sidespin"] if self.spin_given else []
        values: dict[str, Floats] = {**self.variables, **{n: arguments[n] for n in spins}}
        if not self.scene.has_hoop:
            values = dict(zip(STATE, self.states.T, strict=True))
        columns: dict[str, Any] = {"track": list(self.labels)}
        for name, value in values.items():
            unit, size = file_unit(unit_in(name, self.scene) or ARGUMENTS[name].unit, units)
            columns[column_name(name, unit)] = np.where(trusted, value, np.nan) / size
        columns["release_time_s"] = self.time
        errors = self.standard_errors
        for name in values:
            if name in errors:
                unit, size = file_unit(unit_in(name, self.scene), units)
                columns[column_name(f"sd_{name}", unit)] = (
                    np.where(trusted, errors[name], np.nan) / size
                )
        columns["frames"], columns["outliers"] = self.counts.T
        columns["credible"] = trusted
        columns["fit_reason"] = list(self.reason)
        return columns

    def to_pandas(self) -> DataFrame:
        """Return a pandas.DataFrame, a row each track: what `columns` gives, in SI.

        Raises
        ------
        ImportError
            If pandas is missing: what brings it.
        """
        frame: DataFrame = require("pandas", "to_pandas").DataFrame(self.columns())
        return frame

    def to_arrow(self) -> ArrowTable:
        """Return a pyarrow.Table, a row each track: what `columns` gives, in SI.

        Raises
        ------
        ImportError
            If pyarrow is missing: what brings it.
        """
        found: ArrowTable = require("pyarrow", "to_arrow").table(self.columns())
        return found

    def __arrow_c_stream__(self, requested_schema: object = None) -> object:
        """Return `to_arrow` as a stream of Arrow's C interface, which libraries of tables read.

        Parameters
        ----------
        requested_schema
            The types that the reader prefers, a capsule; None for those that there are.

        Raises
        ------
        ImportError
            If pyarrow is missing: what brings it.
        """
        return self.to_arrow().__arrow_c_stream__(requested_schema)

    def as_dict(self) -> dict[str, Any]:
        """Return the numbers of tracks, and the noise, in types that JSON knows."""
        return {
            "tracks": len(self),
            "credible": int(self.credible.sum()),
            "not_credible": dict(Counter(reason for reason in self.reason if reason)),
            "frames": int(self.counts[:, 0].sum()),
            "outliers": int(self.counts[:, 1].sum()),
            "noise": self.noise.tolist(),
            "noise_degrees": None if self.degrees == inf else self.degrees,
        }

    @property
    def summary(self) -> str:
        """Say in lines how many tracks were fitted, and with which noise."""
        about = self.as_dict()
        unit = display_unit("short")
        each = zip("xyz", self.noise, strict=True)
        noise = ", ".join(f"{axis} {size / unit.size:.2f}" for axis, size in each)
        how = "given" if isinf(self.degrees) else "estimated"
        known = f"noise ({how}, {unit.symbol}): {noise}"
        lines = [
            f"{format_count(len(self), 'track')}, {about['credible']:,} credible; "
            f"{format_count(about['frames'], 'frame')}, "
            f"{format_count(about['outliers'], 'outlier')}",
            "noise: unknown, no track has three frames" if np.isnan(self.noise).any() else known,
        ]
        causes = about["not_credible"].items()
        lines += [f"not credible: {count:,} {reason}" for reason, count in causes]
        return "\n".join(lines)

    def _cells(self) -> tuple[list[str], list[list[str]]]:
        """Return the headings and the rows of the first releases."""
        every = {**dict(zip(STATE, self.states.T, strict=True)), **self.variables}
        if self.backspin is not None:
            every["backspin"] = self.backspin
        names = (*(FLIGHT_ARGUMENTS if self.scene.has_hoop else STATE[:6]), *self.fitted_spin)
        shown = {name: every[name] for name in names}
        return first_cells(shown, self.standard_errors, self.labels, self.reason, self.scene)

    def __str__(self) -> str:
        heads, rows = self._cells()
        text = f"{self.summary}\n\n{table(heads, rows)}" if rows else self.summary
        more = len(self) - len(rows)
        return text + (f"\nand {more:,} more" if more > 0 else "")

    def _repr_html_(self) -> str:
        heads, rows = self._cells()
        return rendered(self.summary.replace("\n", "; "), heads, rows)
