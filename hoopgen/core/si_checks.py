"""Checks that values are in SI units: degrees, turns a minute and centimetres are refused."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np
from numpy.typing import ArrayLike

MAX_LENGTH = 100.0
"""m. No court is so long, nor so high: what exceeds it is in centimetres."""

MAX_SPEED = 100.0
"""m/s. No ball is thrown half as fast: what exceeds it is in centimetres a second."""

MAX_SPIN = 100.0
"""rad/s, sixteen turns a second: by it the surface of a basketball is faster than its flight."""


def check_angles(name: str, angles: Mapping[str, ArrayLike]) -> None:
    """Raise an error if angles are degrees by their median: radians are within a turn.

    Parameters
    ----------
    name
        The argument, for the error message.
    angles
        Angles by name, rad.

    Raises
    ------
    ValueError
        The message begins with `name`.
    """
    for angle, median in _medians_above(2 * np.pi, angles):
        raise ValueError(
            f"{name}: {angle} is in radians, and these are more than a turn: {median:.6g}. Degrees "
            f"would be np.radians(...), or in a table a column {angle}_deg"
        )


def check_spins(name: str, spins: Mapping[str, ArrayLike]) -> None:
    """Raise an error if spins are rpm or degrees a second by their median.

    Parameters
    ----------
    name
        The argument, for the error message.
    spins
        Spins by name, rad/s.

    Raises
    ------
    ValueError
        The message begins with `name`.
    """
    for spin, median in _medians_above(MAX_SPIN, spins):
        raise ValueError(
            f"{name}: {spin} is in rad/s, and these are more than {MAX_SPIN:g}, "
            f"{MAX_SPIN / (2 * np.pi):.0f} turns a second: {median:.6g}. In rpm they would be "
            f"2*np.pi/60 times that, in degrees a second np.radians(...); in a table a column "
            f"{spin}_rpm or {spin}_deg_s"
        )


def check_lengths(name: str, lengths: Mapping[str, ArrayLike]) -> None:
    """Raise an error if lengths are centimetres by their median: no court has `MAX_LENGTH`.

    Parameters
    ----------
    name
        The argument, for the error message.
    lengths
        Lengths by name, m.

    Raises
    ------
    ValueError
        The message begins with `name`.
    """
    for length, median in _medians_above(MAX_LENGTH, lengths):
        raise ValueError(
            f"{name}: {length} is in m, and these are more than {MAX_LENGTH:g}: {median:.6g}. "
            f"Centimetres would be 0.01 times that, or in a table a column {length}_cm"
        )


def check_speeds(name: str, speeds: Mapping[str, ArrayLike]) -> None:
    """Raise an error if speeds are centimetres a second by their median.

    Parameters
    ----------
    name
        The argument, for the error message.
    speeds
        Speeds by name, m/s.

    Raises
    ------
    ValueError
        The message begins with `name`.
    """
    for speed, median in _medians_above(MAX_SPEED, speeds):
        raise ValueError(
            f"{name}: {speed} is in m/s, and these are more than {MAX_SPEED:g}: {median:.6g}. "
            f"Centimetres a second would be 0.01 times that, or in a table a column {speed}_cm_s"
        )


def _medians_above(
    limit: float, given: Mapping[str, ArrayLike]
) -> Iterator[tuple[str, np.float64]]:
    """Yield the variables whose median size exceeds a limit, with that median."""
    for name, value in given.items():
        sizes = np.abs(np.asarray(value, dtype=np.float64))
        if not np.any(sizes > limit):
            continue
        sizes = sizes[np.isfinite(sizes)]
        # Of two values the less counts: one bad row of a batch loses no other.
        if sizes.size and (median := np.quantile(sizes, 0.5, method="lower")) > limit:
            yield name, median


def check_deviations(name: str, deviations: Mapping[str, ArrayLike]) -> None:
    """Raise an error if standard deviations of angles are degrees: half a radian or more.

    With 0.5 rad, 28.6 degrees, every third throw would be off by more than that, and a twentieth by
    twice as much. The smallest deviation that is measured of players is half a degree.

    Parameters
    ----------
    name
        The argument, for the error message.
    deviations
        Standard deviations of angles by name, rad.

    Raises
    ------
    ValueError
        The message begins with `name`.
    """
    for angle, given in deviations.items():
        value = float(np.asarray(given))
        if value >= MAX_DEVIATION:
            raise ValueError(
                f"{name}: {angle} is in radians, and {value:.6g} is a standard deviation of "
                f"{np.degrees(value):.3g} degrees; expected less than {MAX_DEVIATION}. Degrees "
                f"would be np.radians({value:.6g})"
            )


MAX_DEVIATION = 0.5
"""rad. Standard deviations of the angle of a release are below; see `check_deviations`."""
