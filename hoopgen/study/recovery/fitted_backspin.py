"""Fitted releases with the backspin, which whole paths and the air show."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy.special import chdtrc, chdtri, fdtrc

from .estimator import Flags, Floats
from .fitted_releases import FittedReleases
from .frames import MAX_OUTLIERS
from .paths import VARIED, release_states
from .refinement import Refined, Refinement
from .spins import Spins
from .tracks import Tracks

AFTER_CONTACT = "frames after the first contact do not fit it"
NO_BACKSPIN = "nothing shows the backspin"
FAR_BACKSPIN = "the fitted backspin is too far from what was known of it"
UNSETTLED_PATH = "the fit of the flight after the contact does not settle"

LEVEL = 0.001
"""Share of good tracks whose residuals are called too large."""


def with_backspin(
    found: FittedReleases,
    tracks: Tracks,
    frames: tuple[Flags, Flags],
    release: Floats,
    fall: Floats,
    spins: Spins,
    undecided: Flags,
) -> FittedReleases:
    """Return releases with fitted backspins.

    Parameters
    ----------
    found
        The releases by the first flights.
    tracks
        The measured tracks, n of them.
    frames
        Which frames there are, and which are those of the first flights, (n, m) each.
    release
        Times of the releases since the first frames, (n,), s.
    fall
        The acceleration of each ball at rest, (n, 3), m/s².
    spins
        What is known of the backspins.
    undecided
        Tracks that are not credible by the first flight, but may be with another backspin, (n,).
    """
    there, flight = frames
    backspin, precision = spins.backspin, spins.precision
    if backspin is None or precision is None:
        raise ValueError("backspin_sd: no backspin is to be fitted")
    credible = found.credible | undecided
    start = np.where(credible[:, None], found.states[:, :6], np.nan)
    times = np.where(there, tracks.times - np.nan_to_num(release)[:, None], 0.0)
    problem = Refinement(
        found.scene, found.parameters, times, tracks.positions, found.noise, backspin, precision
    )
    path = problem.fit(start, found.covariance, there, flight, fall)
    reasons = _reasons(found, path, flight, (backspin, precision), undecided)
    good = credible & np.isfinite(path.covariance).all(axis=(1, 2))
    states, covariance = found.states.copy(), np.zeros((len(found), VARIED, VARIED))
    covariance[:, :6, :6] = found.covariance
    with np.errstate(divide="ignore"):
        covariance[~good, 6, 6] = (1.0 / precision)[~good]
    covariance[~np.isfinite(covariance).all(axis=(1, 2))] = np.nan
    states[good], covariance[good] = release_states(path.variables[good]), path.covariance[good]
    residuals = np.where(
        good[:, None, None], path.residuals, tracks.in_order(found.residuals, np.nan)
    )
    used = np.where(good[:, None], path.frames, flight)
    outliers = np.where(good[:, None], path.outliers, tracks.in_order(found.outliers, False))
    return replace(
        found,
        states=states,
        covariance=covariance,
        residuals=tracks.as_given(residuals, np.nan),
        frames=tracks.as_given(used, False),
        outliers=tracks.as_given(outliers, False),
        counts=np.stack([used.sum(axis=1), outliers.sum(axis=1)], axis=1),
        credible=np.array([not reason for reason in reasons], np.bool_),
        reason=reasons,
        backspin=np.where(good, path.variables[:, 6], backspin),
        backspin_before=(backspin, precision),
    )


def _reasons(
    found: FittedReleases,
    path: Refined,
    flight: Flags,
    before: tuple[Floats, Floats],
    undecided: Flags,
) -> tuple[str, ...]:
    """Return why each track is not credible, "" for one that is.

    With two contacts between two frames another backspin, far from that which was known `before`,
    may fit the frames as well as the true one.
    """
    backspin, precision = before
    counts, outliers = path.frames.sum(axis=1), path.outliers.sum(axis=1)
    kept = path.frames & ~path.outliers
    free = np.maximum(3.0 * kept.sum(axis=1) - VARIED + (precision > 0.0), 1.0)
    total = np.where(kept, path.squares, 0.0).sum(axis=1)
    if np.isinf(found.degrees):
        chance = chdtrc(free, total)
    else:  # the noise has an error of its own
        chance = fdtrc(free, max(3.0 * found.degrees, 1.0), total / free)
    large = (outliers > MAX_OUTLIERS * counts) | (chance < LEVEL)
    after = path.frames & ~flight
    large |= (after & path.outliers).sum(axis=1) > MAX_OUTLIERS * after.sum(axis=1)
    reasons = np.array(found.reason, dtype=object)
    unknown = ~np.isfinite(path.covariance).all(axis=(1, 2))
    far = (path.variables[:, 6] - backspin) ** 2 * precision > chdtri(1.0, LEVEL)
    reasons[undecided & ~large & ~far & path.settled & ~unknown] = ""
    for reason, which in (
        (FAR_BACKSPIN, far),
        (AFTER_CONTACT, large),
        (UNSETTLED_PATH, ~path.settled),
        (NO_BACKSPIN, unknown),
    ):
        reasons[found.credible & which] = reason
    return tuple(map(str, reasons))
