"""The hoop with friction: each body its own restitution and friction, and both fall off alike.

The defaults are like those of real balls, but for the bridge's, on which a ball slips often.
"""

from __future__ import annotations

from dataclasses import replace

from hoopgen.derive.contact.friction import CoulombFriction
from hoopgen.derive.scenes import HOOP
from hoopgen.derive.scenes.scene import Scene, parameter

_REST = {"ring": 0.6, "backboard": 0.8, "bridge": 0.65}
_ROUGH = {"ring": 0.3, "backboard": 0.5, "bridge": 0.15}

_OWN = (
    *(
        parameter(f"{body}_restitution", "1", f"e0 of the {body}", value, "nonnegative", 1)
        for body, value in _REST.items()
    ),
    *(
        parameter(f"{body}_friction", "1", f"mu of the {body}", value, "nonnegative", infinite=True)
        for body, value in _ROUGH.items()
    ),
    parameter("tangential", "1", "e_t, of every contact", 0.15, "any", 1, lower=-1),
    parameter("falling", "m/s", "v0, at which e is half of e0", 40.0, infinite=True),
)


def _rough() -> Scene:
    given = {p.name: p.symbol for p in _OWN}
    bodies = tuple(
        replace(
            body,
            law=CoulombFriction(
                f"{body.name}_impact",
                given[f"{body.name}_restitution"],
                given[f"{body.name}_friction"],
                given["tangential"],
                given["falling"],
            ),
        )
        for body in HOOP.bodies
    )
    kept = tuple(p for p in HOOP.parameters if p.name != "restitution")
    return replace(HOOP, name="rough", parameters=(*kept, *_OWN), bodies=bodies)


ROUGH = _rough()
