"""A ring on a wall, a ring off the origin, a leaning one, and two surfaces of free formulas.

The formulas are an egg, and a saddle that is cut off round, by a bound that is no length.
"""

from __future__ import annotations

import sympy as sp
from hoopgen.derive.contact.no_slip import NoSlip
from hoopgen.derive.scenes.ends import End
from hoopgen.derive.scenes.scene import Scene, parameter
from hoopgen.derive.surfaces import ImplicitSurface, Plane, Torus, body, torus
from hoopgen.derive.symbolic.symbols import POSITION

_PARAMETERS = (
    parameter("ball", "m", "radius of the ball", 0.05),
    parameter("ring", "m", "radius of all rings' wire circles", 0.2),
    parameter("wire", "m", "radius of their wires", 0.02),
    parameter("wall_x", "m", "where the wall is that one of them hangs on", -0.8, "any"),
    parameter("aside", "m", "how far the others are from the origin", 0.5),
    parameter("egg", "m", "half the egg's width, to the centre of a ball on it", 0.2),
    parameter("saddle", "1/m", "how much the saddle bends", 0.5),
    parameter("wide", "m", "radius at which it is cut off", 0.9),
    parameter("bounce", "1", "restitution of every contact", 0.8, "nonnegative", 1),
    parameter("gravity", "m/s²", "g", 9.81),
    parameter("depth", "m", "of the plane that ends a shot below the origin", 1.5),
)


def _rings() -> Scene:
    symbol = {p.symbol.name: p.symbol for p in _PARAMETERS}
    x, y, z = POSITION
    ball, zero, radius, aside = symbol["ball"], sp.Integer(0), symbol["ring"], symbol["aside"]
    reach, law = symbol["wire"] + ball, NoSlip("impact", symbol["bounce"])
    leaning = (zero, sp.Rational(5, 13), sp.Rational(12, 13))
    egg = symbol["egg"]
    faces = (
        torus("hung", (symbol["wall_x"] + reach, zero, zero), (1, 0, 0), radius, reach),
        Torus("level", (aside, aside, zero), (0, 0, 1), radius, reach),
        torus("leaning", (aside, -aside, zero), leaning, radius, reach),
        Plane("wall", (1, 0, 0), symbol["wall_x"] + ball, ball),
        ImplicitSurface(
            "egg", x**2 + y**2 + (z**2 / 2) * (1 + z / (2 * egg)) - egg**2, (z - 2 * egg,)
        ),
        ImplicitSurface(
            "saddle",
            z + aside - symbol["saddle"] * (x**2 - y**2),
            (x**2 + y**2 - symbol["wide"] ** 2,),
        ),
    )
    return Scene(
        name="rings",
        parameters=_PARAMETERS,
        bodies=tuple(body(face, law) for face in faces),
        ends=(
            End(
                "made",
                Plane(
                    "ground",
                    (0, 0, 1),
                    -symbol["depth"],
                    zero,
                    (sp.sqrt(x**2 + y**2) - symbol["wide"],),
                ),
            ),
            End("missed", Plane("ground", (0, 0, 1), -symbol["depth"], zero)),
        ),
        ball_radius=ball,
        gravity=symbol["gravity"],
    )


RINGS = _rings()
