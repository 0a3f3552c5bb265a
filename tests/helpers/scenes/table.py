"""A table with a dome on it: the ball bounces, falls off, and lands in a cup or beside it."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp
from hoopgen.derive.contact.no_slip import NoSlip
from hoopgen.derive.scenes.ends import End
from hoopgen.derive.scenes.scene import Scene, parameter
from hoopgen.derive.surfaces import Plane, Sphere, body
from hoopgen.derive.symbolic.symbols import POSITION

_PARAMETERS = (
    parameter("half_length", "m", "half the table's length, along x", 0.8),
    parameter("half_width", "m", "half its width, along y", 0.5),
    parameter("dome_x", "m", "where on the table's length the dome stands", 0.1, "any"),
    parameter("dome_z", "m", "height of its centre over the table top", -0.05, "any"),
    parameter("dome_radius", "m", "its radius", 0.2),
    parameter("bounce", "1", "restitution of every contact", 0.75, "nonnegative", 1),
    parameter("acceleration", "m/s²", "of free fall", 9.81),
    parameter("marble", "m", "radius of the ball", 0.04),
    parameter("table_height", "m", "from where the centre is on the ground to the top", 0.7),
    parameter("cup_x", "m", "where the cup stands", 1.1, "any"),
    parameter("cup_radius", "m", "its radius", 0.25),
)


def _table() -> Scene:
    """Return the scene; the origin is in the middle of the table's top."""
    by_name = {p.name: p.symbol for p in _PARAMETERS}
    x, y, _ = POSITION
    ball = by_name["marble"]
    law = NoSlip("impact", by_name["bounce"])
    ground = Plane(
        "ground", direction=(0, 0, 1), offset=-by_name["table_height"], reach=sp.Integer(0)
    )
    cup = sp.sqrt((x - by_name["cup_x"]) ** 2 + y**2) - by_name["cup_radius"]
    length, width = by_name["half_length"], by_name["half_width"]
    return Scene(
        name="table",
        parameters=_PARAMETERS,
        bodies=(
            body(
                Plane(
                    "top",
                    direction=(0, 0, 1),
                    offset=ball,
                    reach=ball,
                    limits=(-x - length, x - length, -y - width, y - width),
                ),
                law,
            ),
            body(
                Sphere(
                    "dome",
                    centre=(by_name["dome_x"], sp.Integer(0), by_name["dome_z"]),
                    radius=by_name["dome_radius"] + ball,
                ),
                law,
            ),
        ),
        ends=(End("made", replace(ground, limits=(cup,))), End("missed", ground)),
        ball_radius=ball,
        gravity=by_name["acceleration"],
    )


TABLE = _table()
