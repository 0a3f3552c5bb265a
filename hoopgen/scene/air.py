"""The parameters that a scene in air has besides its own."""

from __future__ import annotations

from collections.abc import Sequence

from hoopgen.core.parameters import AIR_DEFAULTS
from hoopgen.text.shorten import brief

from .errors import wrong
from .pieces import Parameter

AIR_PARAMETERS = (
    Parameter("ball_mass", AIR_DEFAULTS["ball_mass"], "kg", "m_B, mass of the ball", latex="m_B"),
    Parameter(
        "air_density",
        AIR_DEFAULTS["air_density"],
        "kg/m³",
        "density of the air",
        sign="nonnegative",
        latex=r"\varrho_a",
    ),
    Parameter(
        "drag_coefficient",
        AIR_DEFAULTS["drag_coefficient"],
        "1",
        "C_d of the ball",
        sign="nonnegative",
        latex="C_d",
    ),
    Parameter(
        "lift_coefficient",
        AIR_DEFAULTS["lift_coefficient"],
        "1",
        "C_m, Magnus force over that of a lift coefficient of R w / v",
        sign="any",
        latex="C_m",
    ),
    Parameter(
        "drag_smoothing_speed",
        AIR_DEFAULTS["drag_smoothing_speed"],
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


def check_switches(scene: str, rolls: object, air: object) -> None:
    """Refuse what is neither true nor false.

    Parameters
    ----------
    scene
        The name of the scene.
    rolls, air
        As its author gave them.

    Raises
    ------
    SceneError
        Naming the argument.
    """
    for argument, given in {"rolls": rolls, "air": air}.items():
        if not isinstance(given, bool):
            raise wrong(scene, "", argument, f"expected true or false, got {brief(given)}")
