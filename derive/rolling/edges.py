"""The edges of a surface with bounds, which a ball in contact rolls over, and its bounds beside it.

A body does not exist outside its bounds. A ball that rolls on it is off it as soon as its point of
contact is past a bound g. At that instant another body takes it over if the ball touches that body
and does not move off it or into it, as a body does whose contact surface continues this one.
Otherwise the ball flies. It was pressed onto the surface by N, so the flight takes it behind the
surface, where the gap is -N t²/2 and nothing of this surface is met. An edge itself is no body: a
scene that wants a slow ball to pivot about it has a body there, or uses a box.
"""

from __future__ import annotations

import sympy as sp

from ..contact.ball import Ball
from ..events.predicates import index, undecided_time, which
from ..events.root_finder import first_root
from ..ir.kernel import Kernel, decision, loop_kernel
from ..motion.flight import Flight
from ..state.fields import NONE
from ..symbolic.conditionals import (
    AtMost,
    Boolean,
    Choose,
    Equal,
    IfLess,
    Less,
    Not,
    Or,
    absolute,
    all_of,
    any_of,
    barrier,
    maximum,
    minimum,
)
from ..symbolic.error_terms import dv, dw, earliest_delay, greatest
from ..symbolic.rounding import velocity_error
from ..symbolic.symbols import normal, spin, velocity
from .bounds import (
    bound_curvature,
    bound_distance,
    bound_rate,
    longest,
    near_edge,
    on_bound,
    roundings,
)
from .meeting import bound_shift, continues_contact, edge_delay, edge_delay_of, edge_shift
from .settling import tolerance
from .symbols import (
    EventCodes,
    fastest,
    nearest,
    normal_cosine,
    outside_distance,
    outside_time,
    press,
    stride,
    strongest,
)

edge_distance, successor = sp.symbols("edge_distance successor", real=True)
"""Distance from the nearest edge, m; index of the surface that takes the ball over there."""

before = sp.Matrix(sp.symbols("before_x before_y before_z", real=True))
after = sp.Matrix(sp.symbols("after_x after_y after_z", real=True))
"""Acceleration of the ball before an edge; on the surface that takes it over there."""

over_edge, falls_off = map(Boolean, ("over_edge", "falls_off"))
"""True of a ball that is past an edge of the surface below; of one that flies off an edge."""

_NO_EVENT = Equal(which, NONE)


def _reaches(ball_radius: sp.Expr, codes: EventCodes) -> Kernel:
    """Return the kernel that detects where a rolling ball reaches an edge of its surface."""
    landing, near_enough = roundings(ball_radius)
    bends = barrier(2 * strongest + bound_curvature * fastest**2)
    arrives = all_of(AtMost(bound_distance, landing), Less(bound_rate, 0))
    first = all_of(arrives, _NO_EVENT)
    grazes = all_of(
        AtMost(absolute(bound_distance), near_enough),
        Not(Less(barrier(8 * bends * near_enough), barrier(bound_rate**2))),
    )
    clear = barrier(Choose(AtMost(bound_distance, landing), tolerance(ball_radius), bound_distance))
    root = minimum(stride, longest(fastest), first_root(clear, bound_rate, bends))
    own = edge_delay_of(landing)
    return loop_kernel(
        "reaches_edge",
        {
            "stride": Choose(arrives, 0, root),
            "which": Choose(first, codes.over_edge, which),
            "undecided_time": Choose(
                any_of(
                    grazes,
                    all_of(arrives, Not(Or(_NO_EVENT, Equal(which, codes.over_edge)))),
                ),
                0,
                undecided_time,
            ),
            "earliest_delay": Choose(
                first, barrier(2 * near_enough / absolute(bound_rate)), earliest_delay
            ),
            str(edge_distance): minimum(edge_distance, bound_distance),
            str(edge_delay): Choose(arrives, maximum(edge_delay, own), edge_delay),
            str(edge_shift): Choose(first, -bound_shift / bound_rate, edge_shift),
        },
        "Whether a rolling ball is past an edge of its surface; else a time for which it is not.",
        "a parabola below the distance",
    )


def _successor(ball_radius: sp.Expr) -> Kernel:
    """Return the kernel that lets a surface take over a ball at the edge of another one.

    The place of an edge has no error, so that the gap there has roundings alone. The speed off the
    surface has an error as small as the angle between the normals.
    """
    landing, near_enough = roundings(ball_radius)
    size = barrier(sum(map(absolute, velocity)))
    angle = barrier(sp.sqrt(barrier(absolute(1 - normal_cosine))))
    speed_error = barrier(
        barrier(4 * angle + sp.Rational(1, 2**22)) * velocity_error + sp.Rational(1, 2**47) * size
    )
    fits = continues_contact(ball_radius)
    unclear = all_of(
        continues_contact(ball_radius, landing, speed_error),
        Not(continues_contact(ball_radius, -landing, -speed_error)),
    )
    # Two bounds at one place may be lengths of different scales, and round differently.
    at_bound = all_of(on_bound, AtMost(outside_distance, near_enough), Less(0, outside_time))
    nearly = continues_contact(ball_radius, within=at_bound)
    taken = Not(Less(successor, 0))
    return loop_kernel(
        "succeeds",
        {
            str(successor): Choose(all_of(fits, Not(taken)), index, successor),
            "undecided_time": Choose(
                any_of(unclear, nearly, all_of(fits, taken)), 0, undecided_time
            ),
        },
        "Whether a surface takes over a ball at the edge of another one.",
        "both contact surfaces touch there, with one normal",
    )


def _edge_errors(flight: Flight, ball: Ball) -> Kernel:
    """Return the errors after an edge, at which the forces change at an uncertain time.

    A ball that is there dt later has the acceleration a of before for so long in the place of the
    one a' of after: its velocity is off by (a - a') dt more, and its spin as friction changes. It
    flies if no surface takes it over, or one that does not press it on. An error along the path is
    a delay alone, and remains one: dx = v dt, dv = a' dt. What the vector of errors does not
    contain counts with a sixteenth of what it could be.
    """
    down = sp.Matrix(list(flight.acceleration))
    flies = Or(Less(successor, 0), AtMost(press, 0))
    change = [
        barrier(a - Choose(flies, fall, b)) for a, fall, b in zip(before, down, after, strict=True)
    ]
    per = barrier(1 / barrier(ball.inertia * ball.radius))
    twists = [barrier(-c) * per for c in normal.cross(sp.Matrix(change))]
    speed = barrier(sum(map(absolute, velocity)) + ball.radius * barrier(sum(map(absolute, spin))))
    disturbance, _ = flight.disturbance(speed)
    disturbed = barrier(2 * disturbance)
    size = barrier(greatest(change) + disturbed)
    late = barrier(edge_delay / 16)
    unit = barrier(size * late + disturbed * edge_delay)
    outputs: dict[str, sp.Expr] = {}
    for errors, rates, rounding in (
        (dv, change, unit),
        (dw, twists, barrier(unit * per)),
    ):
        for error, rate in zip(errors, rates, strict=True):
            moved = barrier(error + rate * edge_shift)
            outputs[str(error)] = moved + IfLess(moved, 0, -rounding, rounding)
    return loop_kernel(
        "edge_errors",
        outputs,
        "Errors with those of the time at which the ball is at the edge.",
        "the change of the forces times the delay",
    )


def edge_kernels(flight: Flight, ball: Ball, codes: EventCodes) -> tuple[Kernel, ...]:
    """Return the kernels of edges and bounds that all surfaces share.

    Parameters
    ----------
    flight, ball, codes
        As for `derive.rolling.contact_phase.kernels`.
    """
    return (
        decision(
            "no_edge",
            {
                str(edge_delay): 0,
                str(edge_shift): 0,
                str(edge_distance): sp.oo,
                "press": 0,
                **{str(a): 0 for a in (*before, *after)},
            },
            "Start values: the ball is at no edge.",
        ),
        decision(
            "near_edge",
            {
                str(near_edge): AtMost(edge_distance, sp.Rational(1, 2**9) * ball.radius),
                "normal_cosine": -1,
            },
            "Whether a rolling ball is near an edge of its surface.",
        ),
        _reaches(ball.radius, codes),
        loop_kernel(
            "beside_edge",
            {"nearest": minimum(nearest, absolute(bound_distance))},
            "Distance to the nearest edge of the surface that the ball bounces on.",
            "Eq. 2",
        ),
        decision(
            "at_edge",
            {str(over_edge): Equal(which, codes.over_edge)},
            "Whether a rolling ball is past an edge of its surface.",
        ),
        decision(
            "taking_over",
            {"here": Equal(successor, index)},
            "Whether a surface is the one that takes the ball over.",
        ),
        _successor(ball.radius),
        _edge_errors(flight, ball),
    )
