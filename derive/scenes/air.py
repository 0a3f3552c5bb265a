"""The air, its parameters, and the kernel of one step of a flight through it."""

from __future__ import annotations

import sympy as sp

from ..ir.kernel import Kernel, kernel
from ..motion.air import AirConstants, AirSeries
from ..symbolic.conditionals import barrier, minimum
from ..symbolic.rounding import position_error, velocity_error
from ..symbolic.symbols import POSITION, STATE, VELOCITY
from .hoop import HOOP
from .scene import parameter

_OF_HOOP = {p.name: p for p in HOOP.parameters}

PARAMETERS = (
    _OF_HOOP["gravity"],
    _OF_HOOP["ball_radius"],
    parameter("ball_mass", "kg", "m, mass of the ball", 0.624, latex="m"),
    parameter("air_density", "kg/m³", "density of the air", 1.20, "nonnegative", latex=r"\varrho"),
    parameter("drag_coefficient", "1", "C_d of the ball", 0.5, "nonnegative", latex="C_d"),
    parameter(
        "lift_coefficient",
        "1",
        "C_m, of the Magnus force over the surface's speed",
        0.6,
        "any",
        latex="C_m",
    ),
    parameter(
        "drag_smoothing_speed",
        "m/s",
        "v_s, below which the drag is linear in the speed",
        0.05,
        latex="v_s",
    ),
)
"""The parameters of a flight through air."""

longest = sp.Symbol("longest", nonnegative=True)
"""Time until which the flight is wanted, s."""


def air_step() -> Kernel:
    """Return the kernel of one step of a flight, with proved bounds on its errors."""
    series = AirSeries(AirConstants(*(p.symbol for p in PARAMETERS)))
    step = barrier(minimum(longest, series.step), "h")
    place, moving = series.at(step)
    errors = series.errors(step, position_error, velocity_error)
    after = dict(zip([s.name for s in (*POSITION, *VELOCITY)], [*place, *moving], strict=True))
    names = (position_error.name, velocity_error.name)
    return kernel(
        "air_step",
        {"step": step, **after, **dict(zip(names, errors, strict=True))},
        (
            longest,
            *STATE,
            position_error,
            velocity_error,
            *(p.symbol for p in PARAMETERS),
        ),
        "One step of a flight through air: time, position, velocity, and bounds on their errors.",
        "Taylor's series of gravity, buoyancy, drag and Magnus force; Gronwall's lemma",
    )
