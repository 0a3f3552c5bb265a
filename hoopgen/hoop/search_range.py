"""The range of a variable in which changes of one release are looked for."""

from __future__ import annotations

import math
from collections.abc import Mapping

from hoopgen.core.units import DEGREE, TURN

HALF_WIDTHS: Mapping[str, float] = {
    "elevation": 25 * DEGREE,
    "entry": 25 * DEGREE,
    "azimuth": 25 * DEGREE,
    "angle": 25 * DEGREE,
    **dict.fromkeys(("backspin", "sidespin", "wx", "wy", "wz"), 10 * TURN),
    "aim": 1.0,
    "height": 1.0,
    "distance": 1.0,
}
"""Half widths of ranges, SI; that of the distance is no more than the distance itself."""

LIMITS: Mapping[str, tuple[float, float]] = {
    "elevation": (-90 * DEGREE, 90 * DEGREE),
    "entry": (-90 * DEGREE, 90 * DEGREE),
    "restitution": (0.0, 1.0),
}
"""No value beyond these is tried, unless the release itself lies there."""


def search_range(name: str, value: float, scale: float = 0.0) -> tuple[float, float]:
    """Return the range in which to look, about the value of the release.

    Parameters
    ----------
    name
        A variable at a hoop, or a component of a state.
    value
        Its value, SI.
    scale
        Size of similar numbers; without a width of its own, a range is a quarter of the larger of
        value and scale to each side.

    Returns
    -------
    tuple
        Low and high; the value itself is never outside.
    """
    half = HALF_WIDTHS.get(name, 0.25 * max(abs(value), scale))
    if name == "distance":
        half = min(half, abs(value))
    least, most = LIMITS.get(name, (-math.inf, math.inf))
    return min(max(value - half, least), value), max(min(value + half, most), value)
