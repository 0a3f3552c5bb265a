"""A floor with the caps of two spheres on it, cut off by planes: curved surfaces with bounds.

One cap is the upper part of a sphere; of the other, half is missing, and a ball may be where the
rest of its sphere would be. Each has a restitution of its own.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp
from hoopgen.derive.contact.no_slip import NoSlip
from hoopgen.derive.scenes.ends import End
from hoopgen.derive.scenes.scene import Scene, parameter
from hoopgen.derive.surfaces import Plane, Sphere, body
from hoopgen.derive.symbolic.symbols import POSITION

_PARAMETERS = (
    parameter("ball", "m", "radius of the ball", 0.05),
    parameter("radius", "m", "radius of both spheres", 0.3),
    parameter("apart", "m", "from the origin to each sphere's centre", 0.5),
    parameter("cut", "m", "height over its centre at which the first sphere is cut", 0.1, "any"),
    parameter("lively", "1", "restitution of the caps", 0.9, "nonnegative", 1),
    parameter("dull", "1", "restitution of the step", 0.4, "nonnegative", 1),
    parameter("gravity", "m/s²", "g", 9.81),
    parameter("depth", "m", "of the plane that ends a shot below the origin", 0.5),
    parameter("goal", "m", "radius about the origin in which a shot is made", 0.4),
)


def _caps() -> Scene:
    symbol = {p.symbol.name: p.symbol for p in _PARAMETERS}
    x, y, z = POSITION
    reach, apart = symbol["radius"] + symbol["ball"], symbol["apart"]
    left, right = ((side, sp.Integer(0), sp.Integer(0)) for side in (-apart, apart))
    lively = NoSlip("lively_impact", symbol["lively"])
    dull = NoSlip("dull_impact", symbol["dull"])
    ground = Plane("ground", (0, 0, 1), -symbol["depth"], sp.Integer(0))
    return Scene(
        name="caps",
        parameters=_PARAMETERS,
        bodies=(
            body(
                Sphere("cap", left, reach, limits=(symbol["cut"] - z,)),
                lively,
            ),
            body(Sphere("half", right, reach, limits=(apart - x,)), lively),
            body(
                Plane(
                    "step",
                    direction=(0, 0, 1),
                    offset=symbol["ball"] - symbol["depth"] / 2,
                    reach=symbol["ball"],
                    limits=(-x - symbol["goal"], x - symbol["goal"], -y - 1, y - 1),
                ),
                dull,
            ),
        ),
        ends=(
            End("made", replace(ground, limits=(sp.sqrt(x**2 + y**2) - symbol["goal"],))),
            End("missed", ground),
        ),
        ball_radius=symbol["ball"],
        gravity=symbol["gravity"],
    )


CAPS = _caps()
