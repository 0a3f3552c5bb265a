"""Endless rolling on a ring, and the proof that a motion is one.

Between two turning points of the angle around the wire the motion is periodic (Routh): the same
angles, with the same speeds, at other azimuths. If a ball has come from one turning point to the
next, was pressed on throughout, and could have met nothing at any azimuth, nothing ever ends its
motion. The proof holds with margins far above roundings; a motion that is less clear is followed
until the time limit.
"""

from __future__ import annotations

import sympy as sp

from ..contact.ball import Ball
from ..errors.derivative import directional
from ..events.predicates import index, undecided_time, which
from ..ir.kernel import Kernel, decision, loop_kernel
from ..motion import ring_rolling_series
from ..motion.flight import Flight
from ..state.fields import NONE
from ..surfaces import Surface
from ..symbolic.conditionals import (
    Boolean,
    Choose,
    Equal,
    Less,
    Not,
    Or,
    absolute,
    all_of,
    barrier,
    minimum,
)
from ..symbolic.rounding import position_error, velocity_error
from ..symbolic.symbols import POSITION, VELOCITY
from .symbols import (
    EventCodes,
    fastest,
    force,
    force_bend,
    force_rate,
    gap,
    goes_on,
    held,
    nearing,
    stride,
)

circled, azimuth_clearance, climb, half_step = sp.symbols(
    "circled azimuth_clearance climb half_step", real=True
)
"""1 if the ball certainly stays on the ring since a turning point; distance from all else at any
azimuth, m; rate of the angle around the wire, rad/s; half a step from its start or its end, s."""

section_acceleration = sp.Symbol("section_acceleration", nonnegative=True)
"""Bound on the acceleration in the ring's section within a step."""

circles = Boolean("circling")


def ring_kernels(surface: Surface, flight: Flight, ball: Ball) -> dict[str, Kernel]:
    """Return the kernels of rolling on a ring, by part; none if the surface is not a ring.

    Parameters
    ----------
    surface
        The surface on which the ball rolls.
    flight
        The motion between contacts; a ring is rolled on where gravity is along the z axis.
    ball
        The radius and the inertia of the ball.
    """
    found = surface.rolling_surface
    if found is None or found.ring == 0 or not flight.upright:
        return {}
    reach = barrier(1 / found.per_reach)
    rolling = ring_rolling_series.RingRolling(
        found.ring, reach, ball, barrier(flight.strength), flight.surface_force
    )
    kernels = {
        "round_start": (rolling.start(), "Constant terms, in the ring's coordinates."),
        "round_moved": (rolling.moved(), "State of a ball that rolls on the ring at time t."),
        "round_step": (rolling.step(), "Length of a step of the series, and bounds in it."),
        "round_pulled": (
            rolling.pulled() | {"grip_deficit": -sp.oo, "grip_deficit_rate": sp.Integer(0)},
            "Square of the friction that rolling on the ring takes, and its rate.",
        ),
        "swung": (
            _periodic(reach, barrier(flight.strength)),
            "Whether the ball certainly rolls on the ring for ever.",
        ),
    }
    kernels |= {
        f"round_{k}": (
            rolling.next_terms(k),
            f"Coefficients of order {k + 1}, from those of lower order.",
        )
        for k in range(ring_rolling_series.ORDER)
    }
    return {
        part: loop_kernel(f"{surface.name}_{part}", outputs, summary, "Routh's equations")
        for part, (outputs, summary) in kernels.items()
    }


def azimuth_free_kernels(surface: Surface) -> dict[str, Kernel]:
    """Return the kernel of a bound on the distance at any azimuth, if the surface has one."""
    if surface.azimuth_free_distance is None:
        return {}
    distance = barrier(surface.azimuth_free_distance)
    along = dict(zip(POSITION, VELOCITY, strict=True))
    outputs = {"gap": distance, "nearing": directional(distance, along)}
    summary = "Bound below the distance at this height and distance from the axis, and its rate."
    return {"around": loop_kernel(f"{surface.name}_around", outputs, summary, "Table 2")}


def _periodic(reach: sp.Expr, strength: sp.Expr) -> dict[str, sp.Basic]:
    """Return whether the motion was safe since a turning point, and is at the next one."""
    before = sp.Symbol("climb_0", real=True)
    # The distance from a convex body lies above its tangent, to either side of the middle.
    free = Less(
        sp.Rational(1, 2**12) * reach,
        barrier(azimuth_clearance - section_acceleration * barrier(stride**2) / 8),
    )
    least = force + minimum(0, barrier(force_rate)) * stride - force_bend * barrier(stride**2) / 2
    pressed = Less(sp.Rational(1, 2**8) * strength, barrier(least))
    safe = all_of(free, pressed, Equal(which, NONE))
    steep = Less(
        sp.Rational(1, 2**6) * strength * stride, barrier(reach * absolute(climb - before))
    )
    turned = all_of(Less(barrier(before * climb), 0), steep)
    lasts = all_of(safe, turned, Less(0, circled))
    # An error moves a turning point by the change of the energy over the force there.
    per = barrier(1 / reach)
    pull = barrier(strength + fastest**2 * per)
    energy_error = barrier(2**9 * barrier(fastest * velocity_error + pull * position_error))
    known = Less(barrier(energy_error * pull), barrier(sp.Rational(1, 2**12) * reach * strength**2))
    return {
        "circled": Choose(safe, Choose(turned, 1, circled), 0),
        "endless": lasts,
        "undecided_time": Choose(all_of(lasts, Not(known)), 0, undecided_time),
    }


def kernels(codes: EventCodes) -> dict[str, Kernel]:
    """Return the decisions about balls on a ring."""
    on_ring = Equal(held, index)
    tangent = barrier(gap + minimum(0, barrier(nearing * half_step)))
    decisions = (
        decision(
            "circles",
            {"circling": all_of(goes_on, on_ring), "rolling": all_of(goes_on, Not(on_ring))},
            "Whether a ball in contact rolls on the ring.",
        ),
        decision(
            "half_steps",
            {"forth": barrier(stride) / 2, "back": -barrier(stride) / 2},
            "Half a step, from the start and from the end.",
        ),
        loop_kernel(
            "clearance_at_any_azimuth",
            {"azimuth_clearance": minimum(azimuth_clearance, tangent)},
            "Distance from the nearest other surface, at any azimuth.",
            "tangents",
        ),
        decision(
            "rolls_for_ever",
            {"which": Choose(Boolean("endless"), codes.endless, which)},
            "Event: the ball certainly rolls for ever.",
        ),
        decision(
            "still_in_contact",
            {"rolling": Or(goes_on, circles)},
            "Whether a ball goes on in contact, on whichever surface.",
        ),
    )
    return {kernel.name: kernel for kernel in decisions}
