"""A ball inside a sphere that never lets it out, with the half of a smaller bowl in it.

Spheres seen from inside: one without bounds, and one that is a thin shell within them.
"""

from __future__ import annotations

import sympy as sp
from hoopgen.derive.contact.no_slip import NoSlip
from hoopgen.derive.scenes.ends import End
from hoopgen.derive.scenes.scene import Scene, parameter
from hoopgen.derive.surfaces import Body, Plane, Sphere, body
from hoopgen.derive.symbolic.symbols import POSITION

_PARAMETERS = (
    parameter("ball", "m", "radius of the ball", 0.05),
    parameter("wall", "m", "radius of the sphere around all", 1.0),
    parameter("bowl", "m", "radius of the bowl", 0.4),
    parameter("bowl_x", "m", "where the bowl's centre is", 0.3, "any"),
    parameter("rim", "m", "height of its rim", -0.1, "any"),
    parameter("lively", "1", "restitution of the wall", 0.9, "nonnegative", 1),
    parameter("dull", "1", "restitution of the bowl", 0.6, "nonnegative", 1),
    parameter("gravity", "m/s²", "g", 9.81),
    parameter("depth", "m", "of the plane that ends a shot, below the centre", 0.7),
)


def _chamber() -> Scene:
    symbol = {p.symbol.name: p.symbol for p in _PARAMETERS}
    x, y, z = POSITION
    ball, zero = symbol["ball"], sp.Integer(0)
    centre = (symbol["bowl_x"], zero, zero)
    sides = {"limits": (z - symbol["rim"],), "reach": ball}
    shell = Body(
        "bowl",
        (
            Sphere("hollow", centre, symbol["bowl"] - ball, **sides, inward=True),
            Sphere("outside", centre, symbol["bowl"] + ball, **sides),
        ),
        NoSlip("dull_impact", symbol["dull"]),
    )
    return Scene(
        name="chamber",
        parameters=_PARAMETERS,
        bodies=(
            body(
                Sphere("wall", (zero, zero, zero), symbol["wall"] - ball, inward=True),
                NoSlip("lively_impact", symbol["lively"]),
            ),
            shell,
        ),
        ends=(
            End(
                "made",
                Plane(
                    "ground",
                    (0, 0, 1),
                    -symbol["depth"],
                    zero,
                    (sp.sqrt(x**2 + y**2) - symbol["bowl"],),
                ),
            ),
            End("missed", Plane("ground", (0, 0, 1), -symbol["depth"], zero)),
        ),
        ball_radius=ball,
        gravity=symbol["gravity"],
    )


CHAMBER = _chamber()
