"""The hoop with one law of Coulomb friction for all bodies: contacts grip or slip.

The ball's inertia is a parameter, too. Its errors have proved bounds, as those of the hoop have.
"""

from __future__ import annotations

from dataclasses import replace

from hoopgen.derive.contact.friction import CoulombFriction
from hoopgen.derive.scenes import HOOP
from hoopgen.derive.scenes.scene import Scene, parameter

_OWN = (
    parameter("friction", "1", "mu of every contact", 0.4, "nonnegative", infinite=True),
    parameter("tangential", "1", "e_t, of every contact", 0.15, "any", 1, lower=-1),
    parameter("falling", "m/s", "v0, at which e is half of e0", 40.0, infinite=True),
    parameter("inertia", "1", "kappa of the ball", 2 / 3, upper=1),
)


def _slipping() -> Scene:
    parameters = (*HOOP.parameters, *_OWN)
    given = {p.name: p.symbol for p in parameters}
    law = CoulombFriction(
        "impact",
        given["restitution"],
        given["friction"],
        given["tangential"],
        given["falling"],
    )
    return replace(
        HOOP,
        name="slipping",
        parameters=parameters,
        bodies=tuple(replace(body, law=law) for body in HOOP.bodies),
        inertia=given["inertia"],
    )


SLIPPING = _slipping()
