"""The article's scene (Table 2): ring, backboard, bridge, and the plane that ends a shot."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from ..contact.no_slip import NoSlip
from ..surfaces import Plane, Ring, body
from ..symbolic.symbols import POSITION
from .ends import End
from .scene import Scene, parameter

_PARAMETERS = (
    parameter("ball_radius", "m", "R_B, radius of the ball", 0.12128, latex="R_B"),
    parameter("ring_radius", "m", "R_H, radius of the wire's centre circle", 0.2350, latex="R_H"),
    parameter("wire_radius", "m", "radius of the ring's wire", 0.0100, latex="R_W"),
    parameter(
        "board_distance", "m", "a_0, from the ring's centre to the backboard", 0.3810, latex="a_0"
    ),
    parameter("board_half_width", "m", "y_B, half the backboard's width", 0.9144, latex="y_B"),
    parameter("board_bottom", "m", "z_B1, height of its lower edge", -0.14, "any", latex="z_{B1}"),
    parameter("board_top", "m", "z_B2, height of its upper edge", 0.9268, "any", latex="z_{B2}"),
    parameter("bridge_half_width", "m", "y_BR, half the bridge's width", 0.0762, latex="y_{BR}"),
    parameter("restitution", "1", "e, of every contact", 0.70, "nonnegative", 1, latex="e"),
    parameter("gravity", "m/s²", "g", 9.81, latex="g"),
    parameter("end_depth", "m", "H, of the end plane below the ring", 0.024256, latex="H"),
)


def _hoop() -> Scene:
    """Return the scene of Table 2, with its gaps filled.

    The bridge ends at the backboard (x >= -a_0). R is the sum of the radii of ball and wire.
    """
    by_name = {p.name: p.symbol for p in _PARAMETERS}
    x, y, z = POSITION
    ball_radius, ring_radius = by_name["ball_radius"], by_name["ring_radius"]
    reach = ball_radius + by_name["wire_radius"]
    board = by_name["board_distance"]
    rho = sp.sqrt(x**2 + y**2)
    half_width, half_bridge = by_name["board_half_width"], by_name["bridge_half_width"]
    bottom = Plane("end", direction=(0, 0, 1), offset=-by_name["end_depth"], reach=sp.Integer(0))
    law = NoSlip("impact", by_name["restitution"])
    return Scene(
        name="hoop",
        parameters=_PARAMETERS,
        bodies=tuple(
            body(face, law)
            for face in (
                Ring("ring", ring_radius, reach),
                Plane(
                    "backboard",
                    direction=(1, 0, 0),
                    offset=ball_radius - board,
                    reach=ball_radius,
                    limits=(
                        -y - half_width,
                        y - half_width,
                        by_name["board_bottom"] - z,
                        z - by_name["board_top"],
                    ),
                ),
                Plane(
                    "bridge",
                    direction=(0, 0, 1),
                    offset=reach,
                    reach=reach,
                    limits=(-y - half_bridge, y - half_bridge, ring_radius - rho, x, -board - x),
                ),
            )
        ),
        ends=(
            End(
                "made",
                replace(bottom, limits=(rho - ring_radius,)),
                "Crossed the end plane downwards inside the target.",
            ),
            End("missed", bottom, "Crossed it outside."),
        ),
        ball_radius=ball_radius,
        gravity=by_name["gravity"],
        requirements=(ring_radius - reach,),
        axes="The origin is the centre of the ring's wire circle, z points up, the backboard is at "
        "negative x.",
        remarks="The bridge ends at the backboard.",
    )


HOOP = _hoop()
