"""A crate over the ground, and a thin board that leans on nothing: boxes with edges and corners."""

from __future__ import annotations

import sympy as sp
from hoopgen.derive.contact.no_slip import NoSlip
from hoopgen.derive.scenes.ends import End
from hoopgen.derive.scenes.scene import Scene, parameter
from hoopgen.derive.surfaces import Box, Plane, body
from hoopgen.derive.symbolic.symbols import POSITION

_PARAMETERS = (
    parameter("ball", "m", "radius of the ball", 0.1213),
    parameter("crate", "m", "half the crate's side", 0.25),
    parameter("distance", "m", "from the origin to the board", 0.4),
    parameter("thickness", "m", "of the board", 0.03),
    parameter("half_width", "m", "half the board's width", 0.45),
    parameter("top", "m", "height of the board's upper edge", 0.5, "any"),
    parameter("lively", "1", "restitution of the board", 0.8, "nonnegative", 1),
    parameter("dull", "1", "restitution of the crate", 0.5, "nonnegative", 1),
    parameter("gravity", "m/s²", "g", 9.81),
    parameter("depth", "m", "of the plane that ends a shot below the origin", 0.9),
)


def _crate() -> Scene:
    symbol = {p.symbol.name: p.symbol for p in _PARAMETERS}
    x, y, _ = POSITION
    ball, half, zero = symbol["ball"], symbol["crate"], sp.Integer(0)
    wide, distance, top = symbol["half_width"], symbol["distance"], symbol["top"]
    crate = Box("crate", (zero, -half, -2 * half), (2 * half, half, zero), ball)
    board = Box(
        "board",
        (-distance - symbol["thickness"], -wide, top - wide),
        (-distance, wide, top),
        ball,
    )
    return Scene(
        name="crate",
        parameters=_PARAMETERS,
        bodies=(
            body(crate, NoSlip("dull_impact", symbol["dull"])),
            body(board, NoSlip("lively_impact", symbol["lively"])),
        ),
        ends=(
            End(
                "made",
                Plane(
                    "ground", (0, 0, 1), -symbol["depth"], zero, (sp.sqrt(x**2 + y**2) - distance,)
                ),
            ),
            End("missed", Plane("ground", (0, 0, 1), -symbol["depth"], zero)),
        ),
        ball_radius=ball,
        gravity=symbol["gravity"],
    )


CRATE = _crate()
