"""A plank over the ground, whose names and texts the caller gives: the least scene there is."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import sympy as sp
from hoopgen.derive.contact.no_slip import NoSlip
from hoopgen.derive.scenes.ends import End
from hoopgen.derive.scenes.scene import Scene, parameter
from hoopgen.derive.surfaces import Plane, body
from hoopgen.derive.symbolic.symbols import POSITION

PARAMETERS = ("ball", "bounce", "gravity", "half_width", "drop", "cup")
"""Tame names, in calling order."""

TEXT = ("1", "a size")


def plank(
    name: str = "plank",
    parameters: Sequence[str] = PARAMETERS,
    top: str = "top",
    ground: str = "ground",
    law: str = "impact",
    text: tuple[str, str] = TEXT,
    ends: tuple[str, str] = ("made", "missed"),
) -> Scene:
    """Return the scene, every parameter with that unit and summary."""
    unit, summary = text
    defaults = (0.04, 0.75, 9.81, 0.5, 0.7, 0.9)
    given = tuple(
        parameter(own, unit, summary, default)
        for own, default in zip(parameters, defaults, strict=True)
    )
    ball, bounce, gravity, width, drop, cup = (p.symbol for p in given)
    x, y, _ = POSITION
    limits = (-x - width, x - width)
    floor = Plane(ground, direction=(0, 0, 1), offset=-drop, reach=sp.Integer(0))
    face = Plane(top, direction=(0, 0, 1), offset=ball, reach=ball, limits=limits)
    return Scene(
        name=name,
        parameters=given,
        bodies=(body(face, NoSlip(law, bounce)),),
        ends=tuple(
            End(own, replace(floor, limits=limits))
            for own, limits in zip(ends, ((sp.sqrt(x**2 + y**2) - cup,), ()), strict=True)
        ),
        ball_radius=ball,
        gravity=gravity,
    )
