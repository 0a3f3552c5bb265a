"""A ball that rolls on a ring: its kernels, and when it is certain that it does so for ever.

Between two turning points of the angle around the wire the motion is to and fro (Routh): the same
angles, with the same speeds, at ever other azimuths. Where a ball has come from one turning point
to the next, has been pressed on all the time, and at no azimuth could have met anything, nothing
ever ends it. All of that holds here by margins far above roundings: what is less clear than that is
followed until the time limit.
"""

from __future__ import annotations

import sympy as sp

from ..errors.tangent import directional
from ..flight import circling
from ..flight.parabola import Parabola
from ..ground.choice import (
    Choose,
    Either,
    Equal,
    Less,
    Not,
    Truth,
    every,
    hold,
    size,
    smallest,
)
from ..ground.kernel import Kernel
from ..ground.rounding import position_error, velocity_error
from ..ground.symbols import POSITION, VELOCITY
from ..search.decisions import doubt, index, which
from ..surfaces import Surface
from .fields import NONE
from .settling import (
    Codes,
    fastest,
    force,
    force_bend,
    force_rate,
    gap,
    goes_on,
    held,
    made,
    nearing,
    stride,
)

circled, berth, climb, leap = sp.symbols("circled berth climb leap", real=True)
"""1: since a turning point the ball is certain not to leave; how far all else is from it, at any
azimuth; the rate of the angle around the wire; and half a step, from its start or its end."""
sway = sp.Symbol("sway", nonnegative=True)
"""Bound on the acceleration in the ring's section within a step."""
circles = Truth("circling")


def on_ring(surface: Surface, flight: Parabola, ball_radius: sp.Expr) -> dict[str, Kernel]:
    """Return what a ball takes that stays on the surface, if that is a ring."""
    tube = surface.tube
    if tube is None or tube.ring == 0 or not flight.upright:
        return {}
    reach = hold(1 / tube.per_reach)
    of = circling.Circling(tube.ring, reach, ball_radius, hold(flight.strength))
    name = surface.name
    kernels = {
        "round_start": (of.start(), "The constant terms, in the ring's coordinates."),
        "round_moved": (of.moved(), "Where a ball that rolls on the ring is at time t."),
        "round_pace": (of.pace(), "A step of the series, and bounds of the motion in it."),
        "round_pulled": (
            of.pulled() | {"strain": -sp.oo, "strain_rate": sp.Integer(0)},
            "The square of the friction that rolling on the ring takes, and its rate.",
        ),
        "swung": (_swung(reach, hold(flight.strength)), "Whether it is certain to roll for ever."),
    }
    kernels |= {
        f"round_{k}": (of.following(k), f"The terms of order {k + 1}, from those before.")
        for k in range(circling.ORDER)
    }
    return {
        part: made(f"{name}_{part}", outputs, summary, "Routh's equations")
        for part, (outputs, summary) in kernels.items()
    }


def aside(surface: Surface) -> dict[str, Kernel]:
    """Return how far a surface is from a ball at any azimuth, if a bound is known."""
    if surface.around is None:
        return {}
    distance = hold(surface.around)
    along = dict(zip(POSITION, VELOCITY, strict=True))
    outputs = {"gap": distance, "nearing": directional(distance, along)}
    said = "A bound below the distance from all places at this height and distance from the axis."
    return {"around": made(f"{surface.name}_around", outputs, said, "Table 2")}


def _swung(reach: sp.Expr, strength: sp.Expr) -> dict[str, sp.Basic]:
    """Return how a step has gone, given the bounds on the motion in it."""
    before = sp.Symbol("climb_0", real=True)
    # The distance from what is convex lies above its tangent, to either side of the middle.
    free = Less(sp.Rational(1, 2**12) * reach, hold(berth - sway * hold(stride**2) / 8))
    least = force + smallest(0, hold(force_rate)) * stride - force_bend * hold(stride**2) / 2
    pressed = Less(sp.Rational(1, 2**8) * strength, hold(least))
    safe = every(free, pressed, Equal(which, NONE))
    steep = Less(sp.Rational(1, 2**6) * strength * stride, hold(reach * size(climb - before)))
    turned = every(Less(hold(before * climb), 0), steep)
    lasts = every(safe, turned, Less(0, circled))
    # An error moves a turning point by what it makes of the energy, over the force there.
    per = hold(1 / reach)
    pull = hold(strength + fastest**2 * per)
    astray = hold(2**9 * hold(fastest * velocity_error + pull * position_error))
    known = Less(hold(astray * pull), hold(sp.Rational(1, 2**12) * reach * strength**2))
    return {
        "circled": Choose(safe, Choose(turned, 1, circled), 0),
        "endless": lasts,
        "doubt": Choose(every(lasts, Not(known)), 0, doubt),
    }


def kernels(codes: Codes) -> dict[str, Kernel]:
    """Return the decisions about balls on a ring."""
    mine = Equal(held, index)
    tangent = hold(gap + smallest(0, hold(nearing * leap)))
    choices = (
        made(
            "circles",
            {"circling": every(goes_on, mine), "rolling": every(goes_on, Not(mine))},
            "Which of the balls in contact are on the ring.",
            "Table 1",
        ),
        made(
            "leaps",
            {"forth": hold(stride) / 2, "back": -hold(stride) / 2},
            "From where half a step is looked over.",
            "Table 1",
        ),
        made("cleared", {"berth": smallest(berth, tangent)}, "What is nearest.", "tangents"),
        made(
            "for_ever",
            {"which": Choose(Truth("endless"), codes.endless, which)},
            "That a ball rolls for ever ends its shot.",
            "Table 1",
        ),
        made("rejoined", {"rolling": Either(goes_on, circles)}, "All that go on.", "Table 1"),
    )
    return {kernel.name: kernel for kernel in choices}
