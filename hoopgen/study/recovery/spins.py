"""The spin of a release: what is known of it besides the positions."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hoopgen.core.si_checks import check_spins
from hoopgen.core.validation import as_doubles
from hoopgen.text.shorten import brief

from .backspin import states_with_backspin

Floats = NDArray[np.float64]

_FIRST_BACKSPIN = 4.0 * np.pi
"""rad/s: 2 Hz, with which a search begins of which nothing is known."""


@dataclass(frozen=True)
class Spins:
    """The spin at the release, as it is given.

    Attributes
    ----------
    spin
        Spin vector of all tracks (3,) or of each (n, 3), rad/s.
    backspin
        Backspin of each track, (n,), rad/s, in place of `spin`; None if it is not given.
    given
        True if either was given.
    precision
        Inverse variance of what is known of each backspin, (n,), 1/(rad/s)², 0 for nothing; None
        if the spin is taken to be known exactly.
    """

    spin: Floats
    backspin: Floats | None
    given: bool
    precision: Floats | None = None

    def states(self, position: Floats, velocity: Floats, rows: Any) -> Floats:
        """Return states of some tracks, (n, 9).

        Parameters
        ----------
        position
            The positions at release, (n, 3), m.
        velocity
            The velocities at release, (n, 3), m/s.
        rows
            The indices of these n tracks.
        """
        if self.backspin is not None:
            return states_with_backspin(position, velocity, self.backspin[rows])
        spin = self.spin[rows] if self.spin.ndim == 2 else self.spin
        return np.concatenate([position, velocity, np.broadcast_to(spin, position.shape)], axis=1)


def spins_of(
    spin: ArrayLike | None,
    backspin: ArrayLike | None,
    backspin_sd: ArrayLike | None,
    tracks: int,
) -> Spins:
    """Return the spins that `fit_release` was given, for so many tracks.

    Parameters
    ----------
    spin
        The spin vector, (3,) or (tracks, 3), rad/s; None if it is not given.
    backspin
        The backspin, one number or (tracks,), rad/s; None if it is not given.
    backspin_sd
        Its standard deviation, one number or (tracks,), rad/s, infinite where nothing is known;
        None if it is known exactly.
    tracks
        The number of tracks.
    """
    if spin is not None and backspin is not None:
        raise ValueError("spin, backspin: each gives the spin; leave one out")
    precision = None
    if backspin_sd is not None:
        if spin is not None:
            raise ValueError("backspin_sd: it is of the backspin; leave out spin")
        size = as_doubles("backspin_sd", backspin_sd)
        if size.shape not in ((), (tracks,)):
            raise ValueError(f"backspin_sd: expected one number or {tracks}, got {size.shape}")
        if not np.all(size > 0.0):
            raise ValueError(
                f"backspin_sd: expected standard deviations above 0, got {brief(backspin_sd)}"
            )
        if backspin is None and np.isfinite(size).any():
            raise ValueError("backspin_sd: of which mean? Give backspin, or inf for no knowledge")
        precision = np.broadcast_to(1.0 / (size * size), (tracks,)).copy()
        backspin = _FIRST_BACKSPIN if backspin is None else backspin
    if backspin is not None:
        back = as_doubles("backspin", backspin)
        if back.shape not in ((), (tracks,)):
            raise ValueError(f"backspin: expected one number or {tracks}, got shape {back.shape}")
        check_spins("backspin", {"backspin": back})
        return Spins(np.zeros(3), np.broadcast_to(back, (tracks,)).copy(), True, precision)
    whole = as_doubles("spin", (0.0, 0.0, 0.0) if spin is None else spin)
    if whole.shape not in ((3,), (tracks, 3)):
        raise ValueError(f"spin: expected shape (3,) or ({tracks}, 3), got {whole.shape}")
    check_spins("spin", {"spin": whole})
    return Spins(whole, None, spin is not None)
