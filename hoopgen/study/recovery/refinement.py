"""The fit of whole paths, to the second contact: releases with their backspin.

The fit of the first flight knows no backspin. Two things show it: the flight after the first
contact, which a backspin makes slower or faster, and the Magnus force in air. Position, velocity
and backspin of each track maximize the likelihood of `estimator`, that of Student's t, over the
frames of both flights, times a normal distribution of the backspin: what is known before the track.
The derivatives are those of `paths`; steps are those of Levenberg and Marquardt with the weights of
the iteratively reweighted fit, many tracks at once. The covariance is (e A + P)^-1 with the
efficiency e of the weights, A = Σ D^T D / σ² and P the inverse variance of the backspin.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hoopgen.core.parameters import Value
from hoopgen.simulation.engine import Engine
from hoopgen.study.models.random import normals

from .estimator import EFFICIENCY, MEDIAN_SQUARE, NU, Flags, Floats
from .frames import MIN_FRAMES, OUTLIER, Measured, first_flight
from .paths import VARIED, Paths, follow_paths, part_of

_MAX_STEPS = 30
_COARSE_STEPS = 8
"""Steps in which the frames after the contact count less, as these are far off at first."""

_CUTS = 4
"""Most times that frames from the second contact on are cut off."""

_SETTLED = 1e-2
"""Change of the positions, in standard deviations, at which the steps end."""

_DRAWS = 64
"""Releases drawn from the fit of the first flight, where that leads to no fit of both."""

_STREAM = 90
"""Streams of random numbers from this one on are those of these draws."""

_SKIPPED = 2
"""Most frames between the first contact and the flight after it."""

_ROUGH = 0.02
"""m. The least noise with which the flight after the first contact is looked for, as a parabola."""

_LONGEST = 1.5
"""s after the first contact: later frames do not count."""


@dataclass
class Refined:
    """Releases fitted to whole paths.

    Attributes
    ----------
    variables
        Position, velocity and backspin at the release, (n, 7), SI.
    covariance
        Of these, (n, 7, 7); NaN where the frames do not determine them.
    frames, outliers
        Which frames are in the fit, and which of them are outliers, (n, m).
    residuals
        Measured less fitted positions, (n, m, 3), m.
    squares
        Their squares in units of the noise, (n, m).
    settled
        Whether the fit has ended, (n,).
    """

    variables: Floats
    covariance: Floats
    frames: Flags
    outliers: Flags
    residuals: Floats
    squares: Floats
    settled: Flags


@dataclass(frozen=True)
class Refinement:
    """The fit of whole paths to tracks.

    Attributes
    ----------
    engine, values
        The scene and its parameters, one number each or (n,).
    times
        Of the frames since the release, (n, m), s.
    positions
        (n, m, 3), m.
    noise
        Standard deviation of each coordinate, (3,), m.
    backspin, precision
        What is known before: mean, rad/s, (n,), and inverse variance, (n,), 0 for nothing.
    """

    engine: Engine
    values: Mapping[str, Value]
    times: Floats
    positions: Floats
    noise: Floats
    backspin: Floats
    precision: Floats

    def take(self, rows: NDArray[np.intp]) -> Refinement:
        """Return the fit of some tracks."""
        return Refinement(
            self.engine,
            part_of(self.values, rows),
            self.times[rows],
            self.positions[rows],
            self.noise,
            self.backspin[rows],
            self.precision[rows],
        )

    def fit(
        self, start: Floats, covariance: Floats, measured: Flags, frames: Flags, fall: Floats
    ) -> Refined:
        """Return the most likely releases.

        Parameters
        ----------
        start
            Position and velocity at the release by the first flight, (n, 6).
        covariance
            Their covariance, (n, 6, 6).
        measured
            The frames of the tracks, (n, m).
        frames
            Those of the first flight, (n, m).
        fall
            The acceleration of each ball at rest, (n, 3), m/s².
        """
        variables = np.concatenate([start, self.backspin[:, None]], axis=1)
        able = np.asarray(np.isfinite(start).all(axis=1))
        able &= np.isfinite(covariance).all(axis=(1, 2))
        rows = np.flatnonzero(able)
        settled = np.zeros(len(start), np.bool_)
        used = frames.copy()
        if len(rows):
            part = self.take(rows)
            first = part._paths(variables[rows], False).first
            used[rows] |= part._second_flight(first, measured[rows], frames[rows], fall[rows])
            for _ in range(_CUTS):
                if not len(rows):
                    break
                found, done = self.take(rows)._solve(
                    variables[rows], covariance[rows], used[rows], frames[rows]
                )
                variables[rows], settled[rows] = found, done
                cut = self.take(rows)._before_second(found, used[rows])
                changed = (cut != used[rows]).any(axis=1)
                used[rows] = cut
                settled[rows[changed]] = False
                rows = rows[changed]
        return self._result(variables, used, settled, able)

    def _paths(self, variables: Floats, varied: bool = True) -> Paths:
        return follow_paths(self.engine, self.values, variables, self.times, varied)

    def _second_flight(self, first: Floats, measured: Flags, frames: Flags, fall: Floats) -> Flags:
        """Return the frames of the flight after the first contact, which is about at times (n,)."""
        since = self.times - first[:, None]
        last = np.where(frames, self.times, -np.inf).max(axis=1)
        later = measured & (self.times > last[:, None]) & (since < _LONGEST)
        found = np.zeros_like(frames)
        rows = np.flatnonzero((later.sum(axis=1) >= MIN_FRAMES) & np.isfinite(first))
        if not len(rows):
            return found
        t = np.where(later[rows], since[rows], 0.0)
        straight = np.moveaxis(self.positions[rows], -1, 0).copy()
        straight -= 0.5 * fall[rows].T[..., None] * (t * t)
        straight[:, ~later[rows]] = 0.0
        noise = np.maximum(self.noise, _ROUGH) if self.engine.kernels.PIECES else self.noise
        part = Measured(t, straight, later[rows])
        _, run = first_flight(part, later[rows], noise, detect=True)
        skipped = (later[rows] & (np.cumsum(run, axis=1) == 0)).sum(axis=1)
        good = (run.sum(axis=1) >= MIN_FRAMES) & (skipped <= _SKIPPED)
        found[rows[good]] = run[good]
        return found

    def _before_second(self, variables: Floats, used: Flags) -> Flags:
        """Return the frames before the second contact, less those that the noise may put there."""
        paths = self._paths(variables, False)
        step = np.linalg.norm(np.diff(paths.positions, axis=1), axis=2).max(axis=1, initial=0.0)
        span = np.diff(self.times, axis=1).max(axis=1, initial=0.0)
        with np.errstate(divide="ignore", invalid="ignore"):
            margin = np.nan_to_num(2.0 * self.noise.max() * span / step, nan=0.0, posinf=0.0)
        kept = used & (self.times < (paths.second - margin)[:, None])
        later = kept & (self.times > paths.first[:, None])
        alone = (later.sum(axis=1) < 2)[:, None] & later
        return np.asarray(kept & ~alone)

    def _solve(
        self, variables: Floats, covariance: Floats, used: Flags, first: Flags
    ) -> tuple[Floats, Flags]:
        """Return the most likely variables and whether the steps have ended."""
        off = self._squares(self._paths(variables, False), used)
        scale = self._scale(off, used & ~first)
        far, found = np.flatnonzero(scale > 1.0), variables.copy()
        if len(far):
            size = np.where(first[far], 1.0, scale[far, None])
            found[far], _, _ = self.take(far)._steps(variables[far], used[far], size, _COARSE_STEPS)
        found, cost, done = self._steps(found, used, np.ones(used.shape))
        # Where few frames fit, another contact may be what happened: draws from the first flight.
        off = self._squares(self._paths(found, False), used)
        many = (used & (off > OUTLIER)).sum(axis=1) > 0.25 * (used & ~first).sum(axis=1)
        rows = np.flatnonzero(many & (used & ~first).any(axis=1))
        if len(rows):
            part = self.take(rows)
            best = part._drawn(variables[rows], covariance[rows], used[rows])
            again, lower, ended = part._steps(best, used[rows], np.ones(used[rows].shape))
            better = lower < cost[rows]
            found[rows[better]], done[rows[better]] = again[better], ended[better]
        return found, done

    def _scale(self, off: Floats, late: Flags) -> Floats:
        """Return the factor by which the squares of late frames are too large at first, (n,)."""
        ordered = np.sort(np.where(late, off, np.inf), axis=1)
        middle = np.maximum(late.sum(axis=1) - 1, 0) // 2
        median = np.take_along_axis(ordered, middle[:, None], axis=1)[:, 0]
        return np.where(np.isfinite(median), np.maximum(1.0, median / MEDIAN_SQUARE), 1.0)

    def _drawn(self, variables: Floats, covariance: Floats, used: Flags) -> Floats:
        """Return of draws from the first flight those that fit best, (n, 7)."""
        values, vectors = np.linalg.eigh(covariance)
        root = vectors * np.sqrt(np.maximum(values, 0.0))[:, None, :]
        noise = np.stack([normals(0, _STREAM + k, 0, _DRAWS) for k in range(6)], axis=1)
        rows = np.repeat(np.arange(len(variables)), _DRAWS)
        tried = variables[rows]
        tried[:, :6] += np.einsum("nij,dj->ndi", root, noise).reshape(-1, 6)
        part, use = self.take(rows), used[rows]
        cost = part._cost(part._squares(part._paths(tried, False), use), tried, use, 1.0)
        best = np.argmin(cost.reshape(-1, _DRAWS), axis=1)
        chosen: Floats = tried.reshape(-1, _DRAWS, VARIED)[np.arange(len(variables)), best]
        return chosen

    def _squares(self, paths: Paths, used: Flags) -> Floats:
        """Return the squared residuals in units of the noise, (n, m)."""
        off = (self.positions - paths.positions) / self.noise
        return np.where(used, np.einsum("nmk,nmk->nm", off, off), 0.0)

    def _cost(self, off: Floats, variables: Floats, used: Flags, scale: Floats | float) -> Floats:
        """Return minus twice the logarithm of the likelihood, but for a constant, (n,)."""
        total = np.where(used, (NU + 3.0) * np.log1p(off / scale / NU), 0.0).sum(axis=1)
        known = self.precision * (variables[:, 6] - self.backspin) ** 2
        return np.where(np.isfinite(total), total + known, np.inf)

    def _steps(
        self, variables: Floats, used: Flags, scale: Floats, most: int = _MAX_STEPS
    ) -> tuple[Floats, Floats, Flags]:
        """Return the variables at the largest likelihood, its cost, and whether it was reached."""
        found = variables.copy()
        cost = np.full(len(found), np.inf)
        done = np.zeros(len(found), np.bool_)
        damping = np.full(len(found), 1e-3)
        moving = np.arange(len(found))
        tried = found.copy()
        normal = np.zeros((len(found), VARIED, VARIED))
        slope = np.zeros((len(found), VARIED))
        for _ in range(most):
            part, use, size = self.take(moving), used[moving], scale[moving]
            paths = part._paths(tried[moving])
            off = part._squares(paths, use)
            new = part._cost(off, tried[moving], use, size)
            better = new <= cost[moving]
            rows = moving[better]
            found[rows], cost[rows] = tried[rows], new[better]
            weights = use * (NU + 3.0) / (NU + off / size) / size
            normal[rows], slope[rows] = (
                one[better] for one in part._equations(paths, tried[moving], weights)
            )
            damping[moving] *= np.where(better, 0.2, 10.0)
            step, far = self._next(normal[moving], slope[moving], damping[moving])
            ended = better & (far <= _SETTLED)
            done[moving[ended]] = True
            hopeless = (damping[moving] > 1e8) | ~np.isfinite(step).all(axis=1)
            done[moving[hopeless & np.isfinite(cost[moving]) & (far <= 1.0)]] = True
            keep = ~(ended | hopeless)
            moving = moving[keep]
            if not len(moving):
                break
            tried[moving] = found[moving] + step[keep]
        return found, cost, done

    def _equations(self, paths: Paths, variables: Floats, weights: Floats) -> tuple[Floats, Floats]:
        """Return the normal equations: matrix (n, 7, 7) and right side (n, 7)."""
        matrix = self._matrix(paths, weights)
        matrix[:, 6, 6] += self.precision
        used = (weights > 0.0)[..., None]
        off = np.where(used, (self.positions - paths.positions) / self.noise**2, 0.0)
        jacobian = np.where(used[..., None], paths.jacobian, 0.0)
        right = np.einsum("nmki,nmk,nm->ni", jacobian, off, weights, optimize=True)
        right[:, 6] += self.precision * (self.backspin - variables[:, 6])
        return matrix, right

    def _matrix(self, paths: Paths, weights: Floats) -> Floats:
        """Return Σ w D^T D / σ², (n, 7, 7)."""
        jacobian = np.where((weights > 0.0)[..., None, None], paths.jacobian, 0.0)
        jacobian = jacobian / self.noise[:, None]
        weighted = jacobian * weights[..., None, None]
        return np.asarray(np.einsum("nmki,nmkj->nij", weighted, jacobian))

    def _next(self, matrix: Floats, right: Floats, damping: Floats) -> tuple[Floats, Floats]:
        """Return the next steps, (n, 7), and how far they go in standard deviations, (n,)."""
        diagonal = np.diagonal(matrix, axis1=1, axis2=2)
        size = np.sqrt(np.where(diagonal > 0.0, diagonal, 1.0))
        scaled = matrix / (size[:, :, None] * size[:, None, :])
        scaled[:, range(VARIED), range(VARIED)] += damping[:, None]
        step = np.full(right.shape, np.nan)
        able = np.isfinite(scaled).all(axis=(1, 2)) & np.isfinite(right).all(axis=1)
        step[able] = np.linalg.solve(scaled[able], (right / size)[able][..., None])[..., 0]
        with np.errstate(invalid="ignore"):
            far = np.sqrt(np.einsum("ni,ni->n", step, right / size))
        return step / size, far

    def _result(self, variables: Floats, used: Flags, settled: Flags, able: Flags) -> Refined:
        """Return the fit with its covariance and residuals."""
        shape = (*used.shape, 3)
        covariance = np.full((len(used), VARIED, VARIED), np.nan)
        residuals, off = np.full(shape, np.nan), np.zeros(used.shape)
        outliers = np.zeros_like(used)
        rows = np.flatnonzero(able)
        if len(rows):
            part = self.take(rows)
            paths = part._paths(variables[rows])
            off[rows] = part._squares(paths, used[rows])
            residuals[rows] = part.positions - paths.positions
            share = part._leverages(paths, used[rows])
            outliers[rows] = used[rows] & (off[rows] / (1.0 - share) > OUTLIER)
            kept = (used[rows] & ~outliers[rows]).astype(np.float64)
            matrix = part._matrix(paths, kept)
            matrix[:, 6, 6] += part.precision / EFFICIENCY
            covariance[rows] = _inverse(matrix) / EFFICIENCY
        residuals[~used] = np.nan
        return Refined(variables, covariance, used, outliers, residuals, off, settled)

    def _leverages(self, paths: Paths, used: Flags) -> Floats:
        """Return the share of each frame's own error that the fit takes up, (n, m), below 1."""
        matrix = self._matrix(paths, used.astype(np.float64))
        matrix[:, 6, 6] += self.precision
        inverse = np.nan_to_num(_inverse(matrix))
        jacobian = np.where(used[..., None, None], paths.jacobian, 0.0) / self.noise[:, None]
        share = np.einsum("nmki,nij,nmkj->nm", jacobian, inverse, jacobian) / 3.0
        return np.asarray(np.clip(share, 0.0, 0.95))


def _inverse(matrices: Floats) -> Floats:
    """Return the inverses of symmetric matrices, NaN of those that are singular in doubles."""
    diagonal = np.diagonal(matrices, axis1=1, axis2=2)
    able = np.asarray(np.isfinite(matrices).all(axis=(1, 2)))
    able &= (diagonal > 0.0).all(axis=1)
    size = np.sqrt(np.where(able[:, None], diagonal, 1.0))
    scaled = matrices / (size[:, :, None] * size[:, None, :])
    able[able] = np.linalg.cond(scaled[able]) < 1e12
    found = np.full(matrices.shape, np.nan)
    found[able] = np.linalg.inv(scaled[able])
    return np.asarray(found / (size[:, :, None] * size[:, None, :]))
