"""The hoop in a gym: board and bridge are plates, and each body has its own law.

Bodies touch one another, as they do there: the bridge stands on the board's front, and its other
end meets the ring's wire in a narrow lens. A ball cannot get between them.
"""

from __future__ import annotations

import math
from dataclasses import replace

import sympy as sp

from ..contact.ball import MAX_INERTIA, MIN_INERTIA, THIN_SHELL
from ..contact.friction import CoulombFriction
from ..surfaces import Box, Plane, Ring, Surface, body
from ..symbolic.symbols import POSITION
from .ends import End
from .hoop import HOOP
from .passage import Passage
from .scene import Parameter, Scene, parameter

_BODIES = ("ring", "backboard", "bridge")

_SIZES = (
    parameter("board_thickness", "m", "d, from the board's front to its back", 0.0127, latex="d_B"),
    parameter("bridge_depth", "m", "h, from the bridge's top to its underside", 0.12, latex="h_B"),
)

INERTIA = parameter(
    "inertia",
    "1",
    "kappa, the ball's moment of inertia over m R_B²: 2/3 of a thin shell, 2/5 of a solid ball",
    float(THIN_SHELL),
    upper=float(MAX_INERTIA),
    latex=r"\kappa",
    lower=float(MIN_INERTIA),
)
"""The parameter `inertia` of every hoop but the article's."""

_SURFACES = (
    *(
        parameter(
            f"{name}_restitution",
            "1",
            f"e0 of the {name}",
            0.70,
            "nonnegative",
            1,
            latex=f"e_{{{short}}}",
        )
        for name, short in zip(_BODIES, "RBP", strict=True)
    ),
    *(
        parameter(
            f"{name}_friction",
            "1",
            f"mu of the {name}; infinite: every contact grips",
            math.inf,
            "nonnegative",
            latex=rf"\mu_{{{short}}}",
            infinite=True,
        )
        for name, short in zip(_BODIES, "RBP", strict=True)
    ),
    INERTIA,
    parameter(
        "tangential_restitution",
        "1",
        "e_t, of every contact that grips",
        0.0,
        "any",
        1,
        latex="e_t",
        lower=-1,
    ),
    parameter(
        "restitution_speed",
        "m/s",
        "v0, at which e is half of e0; infinite: it does not fall",
        math.inf,
        latex="v_0",
        infinite=True,
    ),
)


def _parameters() -> tuple[Parameter, ...]:
    """Return the parameters of HOOP with a restitution for each body, in their public order."""
    inherited = {p.name: p for p in HOOP.parameters if p.name != "restitution"}
    last = ("gravity", "end_depth")
    first = (p for name, p in inherited.items() if name not in (*last, "bridge_half_width"))
    return (
        *first,
        _SIZES[0],
        inherited["bridge_half_width"],
        _SIZES[1],
        *(inherited[name] for name in last),
        *_SURFACES,
    )


def _court() -> Scene:
    """Return the scene; coordinates are as in HOOP, and so are the ring and the bridge's top."""
    parameters = _parameters()
    by_name = {p.name: p.symbol for p in parameters}
    x, y, _ = POSITION
    ball_radius, ring_radius = by_name["ball_radius"], by_name["ring_radius"]
    wire_radius = by_name["wire_radius"]
    front, half_width = -by_name["board_distance"], by_name["board_half_width"]
    half_bridge = by_name["bridge_half_width"]
    faces: tuple[Surface, ...] = (
        Ring("ring", ring_radius, ball_radius + wire_radius, below=True),
        Box(
            "backboard",
            (front - by_name["board_thickness"], -half_width, by_name["board_bottom"]),
            (front, half_width, by_name["board_top"]),
            ball_radius,
            plate_axis=0,
        ),
        Box(
            "bridge",
            (front, -half_bridge, wire_radius - by_name["bridge_depth"]),
            (-ring_radius, half_bridge, wire_radius),
            ball_radius,
        ),
    )
    bottom = Plane("end", (0, 0, 1), -by_name["end_depth"], sp.Integer(0))
    within = replace(bottom, limits=(sp.sqrt(x**2 + y**2) - ring_radius,))
    return Scene(
        name="court",
        parameters=parameters,
        bodies=tuple(
            body(
                face,
                CoulombFriction(
                    f"{face.name}_impact",
                    by_name[f"{face.name}_restitution"],
                    by_name[f"{face.name}_friction"],
                    by_name["tangential_restitution"],
                    by_name["restitution_speed"],
                ),
            )
            for face in faces
        ),
        ends=(
            End(
                "made",
                within,
                "Fell through the ring, and crossed the end plane inside the target.",
                passed=True,
            ),
            End("missed", bottom, "Crossed the end plane otherwise."),
        ),
        ball_radius=ball_radius,
        gravity=by_name["gravity"],
        inertia=by_name["inertia"],
        requirements=(
            ring_radius - ball_radius - wire_radius,
            by_name["board_distance"] - ring_radius - wire_radius,
            by_name["board_top"] - by_name["board_bottom"],
            half_width - half_bridge,
        ),
        passage=Passage(ring_radius, by_name["end_depth"]),
        rolls=True,
        axes=HOOP.axes,
        remarks="Board and bridge are plates with all their sides; the bridge's top is as high as "
        "the ring's, and it ends above the wire's centre circle. Its depth is a guess; so are "
        "restitutions, frictions and the tangential restitution of the presets, where they are not "
        "the article's.",
    )


COURT = _court()
