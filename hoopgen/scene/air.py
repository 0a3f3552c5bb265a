"""The parameters that a scene in air has besides its own.

The defaults are those of `derive/scenes/air.py`, which a test compares: a scene is read without
SymPy.
"""

from __future__ import annotations

from collections.abc import Sequence

from .pieces import Parameter

__all__ = ["AIR_PARAMETERS", "added_parameters"]

AIR_PARAMETERS = (
    Parameter("ball_mass", 0.624, "kg", "m, mass of the ball", latex="m"),
    Parameter(
        "air_density", 1.2, "kg/m³", "density of the air", sign="nonnegative", latex=r"\varrho"
    ),
    Parameter("drag_coefficient", 0.5, "1", "C_d of the ball", sign="nonnegative", latex="C_d"),
    Parameter(
        "lift_coefficient",
        0.6,
        "1",
        "C_m, Magnus force over that of a lift coefficient of R w / v",
        sign="any",
        latex="C_m",
    ),
    Parameter(
        "drag_smoothing_speed",
        0.05,
        "m/s",
        "v_s, below which the drag is linear in the speed",
        latex="v_s",
    ),
)
"""Mass of the ball, density of the air, coefficients of drag and of the Magnus force, and the speed
below which drag is linear."""


def added_parameters(own: Sequence[Parameter]) -> list[Parameter]:
    """Return the parameters of the air that a scene does not declare itself."""
    names = {one.name for one in own if isinstance(one, Parameter)}
    return [one for one in AIR_PARAMETERS if one.name not in names]
