"""Releases of parabolas that come down through a point, in closed form."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from hoopgen.engine.elementary import arc_tangent, sine_cosine, tangent
from hoopgen.generated.numpy import hoop

Arc = Literal["high", "low"]
Floats = NDArray[np.float64]
Values = dict[str, Floats]


def parabola_through(
    wanted: Mapping[str, Floats], reach: Floats, rise: Floats, gravity: Floats, arc: Arc = "high"
) -> tuple[Values, NDArray[np.bool_]]:
    """Return the releases of parabolas that come down through a point.

    Parameters
    ----------
    wanted
        One of `entry`, `elevation` (rad) and `speed` (m/s), or none for the slowest release.
    reach, rise
        Horizontal distance and height of the point from the release, m; all broadcast.
    gravity
        m/s².
    arc
        High or low flight of the two with a speed.

    Returns
    -------
    tuple
        `speed`, `elevation`, `entry_angle` (below the horizontal) and `time`, and whether there is
        such a release. Where there is none the values mean nothing.
    """
    with np.errstate(all="ignore"):
        possible = np.asarray(reach > 0.0)
        if "elevation" in wanted:
            slope = tangent(wanted["elevation"])
            possible = possible & (sine_cosine(wanted["elevation"])[1] > 0.0)
        elif "entry" in wanted:
            (slope,) = hoop.slope_of_entry(tangent(wanted["entry"]), reach, rise)
            possible = possible & (sine_cosine(wanted["entry"])[1] > 0.0)
        elif "speed" in wanted:
            low, high = hoop.slopes_of_speed(wanted["speed"], reach, rise, gravity)
            slope = high if arc == "high" else low
            possible = possible & (wanted["speed"] > 0.0)
        else:
            slope, _ = hoop.least_speed(reach, rise, gravity)
        (speed,) = hoop.aimed_speed(slope, reach, rise, gravity)
        (down,) = hoop.entry_slope(slope, reach, rise)
        elevation = wanted.get("elevation", arc_tangent(slope))
        time, _ = hoop.descent(-rise, speed * sine_cosine(elevation)[0], 0.0, gravity)
        found = {
            "speed": wanted.get("speed", speed),
            "elevation": elevation,
            "entry_angle": wanted.get("entry", arc_tangent(down)),
            "time": time,
        }
        return found, possible & (down > 0.0) & np.isfinite(speed)
