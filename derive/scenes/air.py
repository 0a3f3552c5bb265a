"""Scenes in air: the parameters of the air and the ball, and the article's hoop with them."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from ..motion.air_forces import AirConstants
from .court import COURT, INERTIA
from .hoop import HOOP
from .scene import Scene, parameter

AIR_PARAMETERS = (
    parameter("ball_mass", "kg", "m_B, mass of the ball", 0.624, latex="m_B"),
    parameter(
        "air_density", "kg/m³", "density of the air", 1.20, "nonnegative", latex=r"\varrho_a"
    ),
    parameter("drag_coefficient", "1", "C_d of the ball", 0.5, "nonnegative", latex="C_d"),
    parameter(
        "lift_coefficient",
        "1",
        "C_m, Magnus force over that of a lift coefficient of R w / v",
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
"""The parameters that a flight through air adds to a scene's: the mass, the density of the air, the
coefficients of drag and lift, and the speed below which drag is linear."""


def with_air(scene: Scene) -> Scene:
    """Return the scene in air, with the parameters of the air that it lacks after its own.

    Its flights are pieces of series. A ball must be heavier than the air that it displaces.
    """
    own = {p.name: p for p in scene.parameters}
    added = tuple(p for p in AIR_PARAMETERS if p.name not in own)
    symbols = {p.name: p.symbol for p in (*scene.parameters, *added)}
    mass, density, drag, lift, smoothing = (symbols[p.name] for p in AIR_PARAMETERS)
    displaced = density * scene.ball_radius**3 * sp.Rational(4189, 1000)
    return replace(
        scene,
        parameters=(*scene.parameters, *added),
        air=AirConstants(scene.ball_radius, mass, density, drag, lift, smoothing),
        requirements=(*scene.requirements, mass - displaced),
    )


_HOOP_WITH_INERTIA = replace(HOOP, parameters=(*HOOP.parameters, INERTIA), inertia=INERTIA.symbol)

AIR = replace(
    with_air(_HOOP_WITH_INERTIA),
    name="air",
    remarks="The article's hoop, and the ball flies through air: drag, buoyancy and Magnus force.",
)

COURT_AIR = replace(
    with_air(COURT),
    name="court_air",
    remarks=f"{COURT.remarks} The ball flies through air: drag, buoyancy and Magnus force. Where "
    "it rolls, buoyancy and Magnus force press it on or lift it off; along the surface no air "
    "acts.",
)
