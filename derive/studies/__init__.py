"""Kernels of studies: releases through a point, and measures of a flight."""

from __future__ import annotations

import sympy as sp

from ..ir.kernel import Kernel, kernel
from ..motion.parabola import Parabola
from ..scenes.scene import Scene
from ..surfaces import Ring
from . import aiming, measures, noise, release, share

__all__ = ["ARGUMENTS", "DRAWING", "INTERVALS", "SCENELESS", "aiming", "measures", "study_kernels"]

ARGUMENTS = (*aiming.ARGUMENTS, *measures.ARGUMENTS)

_HEADING, _STATE, _JACOBIAN = release.kernels()

DRAWING = (*noise.kernels(), _HEADING, _STATE)
"""The kernels that draw releases, beside the elementary functions."""

INTERVALS = (share.wilson_interval(),)
"""The kernels of intervals, which pages need, too."""

SCENELESS = (*DRAWING, _JACOBIAN, *INTERVALS)
"""The kernels of studies that need no scene."""


def study_kernels(scene: Scene, order: tuple[sp.Symbol, ...]) -> list[Kernel]:
    """Return the kernels of studies: releases through a point, and measures of a flight.

    There are none unless gravity acts along -z: they speak of heights and a floor plan.

    Parameters
    ----------
    scene
        The scene; measures of a ring are of its only ring.
    order
        The symbols of the scene in the order of arguments.
    """
    flight, gravity, source = scene.flight, scene.gravity, "Eq. 3 without its time"
    if not isinstance(flight, Parabola) or not flight.upright:
        return []
    rings = [surface for surface in scene.surfaces if isinstance(surface, Ring)]
    return [
        kernel(
            "aimed_speed",
            aiming.aimed_speed(gravity),
            order,
            "Speed of the flight that goes through a point with a slope of release.",
            f"{source}, solved for the speed",
        ),
        kernel(
            "entry_slope",
            aiming.entry_slope(),
            order,
            "Slope at a point, positive downwards, of the flight with a slope of release.",
            f"derivative of {source}",
        ),
        kernel(
            "slope_of_entry",
            aiming.slope_of_entry(),
            order,
            "Slope of release of the flight that has a slope at a point, positive downwards.",
            f"derivative of {source}, solved for the release",
        ),
        kernel(
            "least_speed",
            aiming.least_speed(gravity),
            order,
            "Slope and speed of the slowest release through a point.",
            f"{source}, least speed: at 45° + atan(rise/reach)/2, v² = g (rise + distance)",
        ),
        kernel(
            "slopes_of_speed",
            aiming.slopes_of_speed(gravity),
            order,
            "Low and high slope of release through a point at a speed.",
            f"{source}, solved for the slope",
        ),
        kernel(
            "descent",
            measures.descent(flight),
            order,
            "Time at which the centre comes down to a height, and its upward velocity then.",
            "Eq. 3, solved",
        ),
        kernel(
            "apex",
            measures.apex(flight),
            order,
            "Time and height of the highest point of the centre.",
            "Eq. 3, its derivative zero",
        ),
        kernel(
            "line_of_sight",
            measures.line_of_sight(),
            order,
            "Distances of a point past the origin and to the left, seen from a place.",
            "components along and across the line of sight",
        ),
        *(
            kernel(
                f"{ring.name}_nearness",
                measures.nearness(ring, flight),
                order,
                "Distance of ball and wire at time t, and what bounds it within half a width of t.",
                "Eq. 3 in Table 2, Taylor's theorem",
            )
            for ring in rings
        ),
    ]
