"""A post that ends, a pipe, and a leaning rod: cylinders along several axes, in and outside.

The post is one body of three faces: its side, its flat top, and the rim between them, a ring
thinner than the ball.
"""

from __future__ import annotations

import sympy as sp
from hoopgen.derive.contact.no_slip import NoSlip
from hoopgen.derive.scenes.ends import End
from hoopgen.derive.scenes.scene import Scene, parameter
from hoopgen.derive.surfaces import Body, Cylinder, Plane, Torus, body
from hoopgen.derive.symbolic.symbols import POSITION

_PARAMETERS = (
    parameter("ball", "m", "radius of the ball", 0.06),
    parameter("post", "m", "radius of the post", 0.04),
    parameter("post_x", "m", "where it stands", -0.4, "any"),
    parameter("post_top", "m", "height of its top", 0.2, "any"),
    parameter("pipe", "m", "radius of the pipe along y", 0.3),
    parameter("pipe_x", "m", "where it lies", 0.5, "any"),
    parameter("pipe_end", "m", "half its length", 0.6),
    parameter("rod", "m", "radius of the rod", 0.02),
    parameter("lively", "1", "restitution of post and rod", 0.8, "nonnegative", 1),
    parameter("dull", "1", "restitution of the pipe", 0.5, "nonnegative", 1),
    parameter("gravity", "m/s²", "g", 9.81),
    parameter("depth", "m", "of the plane that ends a shot below the origin", 0.8),
)


def _posts() -> Scene:
    symbol = {p.symbol.name: p.symbol for p in _PARAMETERS}
    x, y, z = POSITION
    ball, zero = symbol["ball"], sp.Integer(0)
    radius, beside, top = symbol["post"], x - symbol["post_x"], symbol["post_top"]
    foot, up = (symbol["post_x"], zero, top), (0, 0, 1)
    around = beside**2 + y**2 - radius**2
    post = Body(
        "post",
        (
            Cylinder("side", foot, up, radius + ball, limits=(z - top,)),
            Plane("cap", up, top + ball, ball, (around,)),
            Torus("rim", foot, up, radius, ball, (-around, top - z)),
        ),
        NoSlip("lively_impact", symbol["lively"]),
    )
    lying, end = (symbol["pipe_x"], zero, zero), symbol["pipe_end"]
    sides = {"limits": (y - end, -y - end, z), "reach": ball}  # its upper half is cut off
    pipe = Body(
        "pipe",
        (
            Cylinder("hollow", lying, (0, 1, 0), symbol["pipe"] - ball, **sides, inward=True),
            Cylinder("outside", lying, (0, 1, 0), symbol["pipe"] + ball, **sides),
        ),
        NoSlip("dull_impact", symbol["dull"]),
    )
    leaning = (sp.Rational(3, 5), zero, sp.Rational(-4, 5))
    rod = Cylinder("rod", (zero, sp.Rational(1, 4), zero), leaning, symbol["rod"] + ball)
    return Scene(
        name="posts",
        parameters=_PARAMETERS,
        bodies=(post, pipe, body(rod, post.law)),
        ends=(
            End(
                "made",
                Plane(
                    "ground", up, -symbol["depth"], zero, (sp.sqrt(x**2 + y**2) - symbol["pipe"],)
                ),
            ),
            End("missed", Plane("ground", up, -symbol["depth"], zero)),
        ),
        ball_radius=ball,
        gravity=symbol["gravity"],
    )


POSTS = _posts()
