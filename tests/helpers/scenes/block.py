"""A ring and a block beside it: a scene whose contacts with a box have proved bounds."""

from __future__ import annotations

import sympy as sp
from hoopgen.derive.contact.no_slip import NoSlip
from hoopgen.derive.scenes.ends import End
from hoopgen.derive.scenes.scene import Scene, parameter
from hoopgen.derive.surfaces import Box, Plane, Ring, body

from hoopgen import PAPER

_PARAMETERS = (
    parameter("ball_radius", "m", "", PAPER["ball_radius"]),
    parameter("ring_radius", "m", "", PAPER["ring_radius"]),
    parameter("wire_radius", "m", "", PAPER["wire_radius"]),
    parameter("restitution", "1", "", PAPER["restitution"], "nonnegative", 1),
    parameter("gravity", "m/s²", "", PAPER["gravity"]),
    parameter("depth", "m", "", PAPER["end_depth"], "any"),
    parameter("from_x", "m", "", -0.75, "any"),
    parameter("to_x", "m", "", -0.39, "any"),
    parameter("from_y", "m", "", 8.69, "any"),
    parameter("to_y", "m", "", 9.42, "any"),
    parameter("from_z", "m", "", 0.11, "any"),
    parameter("to_z", "m", "", 0.53, "any"),
)


def _block() -> Scene:
    symbol = {p.symbol.name: p.symbol for p in _PARAMETERS}
    low, high = (
        (symbol[f"{side}_x"], symbol[f"{side}_y"], symbol[f"{side}_z"]) for side in ("from", "to")
    )
    law = NoSlip("impact", symbol["restitution"])
    reach = symbol["ball_radius"] + symbol["wire_radius"]
    ring = Ring("ring", symbol["ring_radius"], reach)
    return Scene(
        name="block",
        parameters=_PARAMETERS,
        bodies=(body(ring, law), body(Box("block", low, high, symbol["ball_radius"]), law)),
        ends=(End("ended", Plane("end", (0, 0, 1), -symbol["depth"], sp.Integer(0))),),
        ball_radius=symbol["ball_radius"],
        gravity=symbol["gravity"],
    )


BLOCK = _block()
