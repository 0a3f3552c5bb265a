"""The events that end a step of a rolling ball: a lost contact, another surface, an end, a limit.

Each condition is a quantity with a bound on its second derivative within the step, so the first
root of a parabola below it bounds how long the event is impossible.
"""

from __future__ import annotations

import sympy as sp

from ..events.predicates import index, undecided_time, which
from ..events.root_finder import first_root
from ..ir.kernel import Kernel, decision, loop_kernel
from ..motion import rolling_series
from ..motion.flight import SurfaceForce
from ..state.fields import NONE
from ..symbolic.conditionals import (
    AtMost,
    Choose,
    Equal,
    IfLess,
    Less,
    Not,
    absolute,
    all_of,
    any_of,
    barrier,
    maximum,
    minimum,
)
from ..symbolic.error_terms import clock, earliest_delay
from ..symbolic.rounding import position_error, velocity_error
from ..symbolic.symbols import position, velocity
from .settling import tolerance
from .symbols import (
    EventCodes,
    fastest,
    force,
    force_bend,
    force_rate,
    friction_force_rate,
    gap,
    gap_curvature,
    near,
    nearing,
    rests,
    stride,
    strongest,
    time_limit,
)

_NO_EVENT = Equal(which, NONE)

_BELOW = "a parabola below the distance"


def step_events(
    gravity: sp.Expr,
    ball_radius: sp.Expr,
    codes: EventCodes,
    besides: SurfaceForce,
    edges: bool = False,
) -> tuple[Kernel, ...]:
    """Return the kernels that shorten a step to the first possible event, and name that event.

    Parameters
    ----------
    gravity
        The size of the free ball's acceleration, m/s².
    ball_radius
        The radius of the ball, m.
    codes
        The codes of events in the event log.
    besides
        The force that presses the ball onto its surface besides its weight.
    edges
        True if a surface may take over a ball that it does not press on.
    """
    return (
        _leaving_force(gravity, ball_radius, codes, besides, edges),
        *_other_surfaces(ball_radius),
        loop_kernel(
            "beside_seam",
            {
                "stride": minimum(
                    stride,
                    first_root(
                        Choose(AtMost(absolute(gap), near), 0, absolute(gap)),
                        Choose(
                            AtMost(absolute(gap), near),
                            absolute(nearing) + sp.Rational(1, 2**20) * fastest,
                            Choose(Less(0, gap), nearing, -nearing),
                        ),
                        barrier(strongest),
                    ),
                )
            },
            "Time for which a rolling ball certainly stays on one part of its surface.",
            _BELOW,
        ),
        decision(
            "beside_time",
            {
                "stride": maximum(0, minimum(stride, barrier(time_limit - clock))),
                "which": _first(Not(Less(clock, time_limit)), sp.Integer(codes.time)),
            },
            "The time limit as an event in contact.",
        ),
        decision(
            "rolled_on",
            {"clock": clock + stride, "rolling": all_of(_NO_EVENT, Not(rests))},
            "Time after a step, and whether another step follows.",
        ),
    )


def _first(condition: sp.Basic, code: sp.Expr) -> sp.Expr:
    """Return the event of the step, which is this one if its condition is the first that holds."""
    return Choose(all_of(condition, _NO_EVENT), code, which)


def _shortened(condition: sp.Basic, root: sp.Expr) -> sp.Expr:
    """Return the step, which ends at once if the condition holds, and at the root at the latest."""
    return Choose(condition, 0, minimum(stride, root))


def _leaving_force(
    gravity: sp.Expr,
    ball_radius: sp.Expr,
    codes: EventCodes,
    besides: SurfaceForce,
    edges: bool,
) -> Kernel:
    """Return the kernel that detects where the normal force vanishes, or the ball is at rest."""
    per = rolling_series.per_reach
    pull = barrier(gravity + fastest**2 * absolute(per))
    small = barrier(sp.Rational(1, 2**44) * pull)
    force_error = barrier(
        small
        + 8 * absolute(per) * barrier(pull * position_error + fastest * velocity_error)
        + 4 * besides.lift_size * barrier(fastest * velocity_error)
    )
    bends = barrier(force_bend + sp.Rational(1, 2**40) * pull)
    spent = any_of(Less(force, -small), all_of(AtMost(force, small), Less(force_rate, 0)))
    # A flight from there opens the gap as -(N' + 2 F·n') t³/6 - N t²/2. If that presses the ball on
    # again, the contact lasts until -N opens the gap.
    opening = barrier(-force_rate - friction_force_rate)
    quickness = barrier(absolute(per) * barrier(fastest**2 * absolute(per) + gravity))
    held_by = barrier(IfLess(opening, 0, opening**2 / barrier(gravity * quickness), 0))
    holds = all_of(spent, Less(small, barrier(force + held_by)))
    if edges:
        # A ball that is taken over with a force off the surface has not come there through N = 0:
        # its gap opens as -N t²/2 at once.
        holds = all_of(holds, Less(sp.Rational(-1, 2**10) * pull, force))
    leaves = all_of(spent, Not(holds))
    still = sp.Rational(1, 2**44)
    pulled = sum(absolute(rolling_series.term(v, 1)) for v in rolling_series.SERIES[:3])
    stopped = all_of(
        AtMost(
            barrier(sum(map(absolute, velocity))),
            still * barrier(sp.sqrt(barrier(gravity * ball_radius))),
        ),
        AtMost(barrier(pulled), still * gravity),
    )
    return loop_kernel(
        "leaving_force",
        {
            "stride": _shortened(
                any_of(leaves, stopped),
                first_root(
                    barrier(Choose(holds, barrier(force + held_by), maximum(force, 0))),
                    force_rate,
                    bends,
                ),
            ),
            "which": _first(leaves, sp.Integer(codes.leaves)),
            "rests": all_of(stopped, Not(leaves)),
            "undecided_time": Choose(
                any_of(
                    holds,
                    all_of(
                        AtMost(absolute(force), force_error),
                        Not(Less(barrier(8 * bends * force_error), force_rate**2)),
                    ),
                ),
                0,
                undecided_time,
            ),
        },
        "Whether the normal force vanishes or the ball rests; else a time for which neither can.",
        "N = 0",
    )


def _other_surfaces(ball_radius: sp.Expr) -> tuple[Kernel, ...]:
    """Return the kernels that detect where a rolling ball meets another surface or an end plane."""
    near_enough = barrier(
        2 * position_error
        + sp.Rational(1, 2**47) * barrier(sum(map(absolute, position)) + ball_radius)
    )
    landing = barrier(sp.Rational(1, 2**47) * barrier(sum(map(absolute, position)) + ball_radius))
    bends = barrier(strongest + gap_curvature * fastest**2)
    meets = all_of(AtMost(gap, landing), Less(nearing, 0))
    crosses = all_of(meets, AtMost(-landing, gap))
    grazes = all_of(
        AtMost(gap, near_enough),
        AtMost(-near_enough, gap),
        Not(Less(barrier(8 * bends * near_enough), barrier(nearing**2))),
    )
    above = barrier(maximum(gap, 0))
    # A surface that the ball touches and does not approach, as where it rolls from one surface onto
    # another, may stay as near as that for a moment.
    clear = barrier(Choose(AtMost(gap, landing), tolerance(ball_radius), gap))
    to_end_plane = Choose(Less(0, gap), first_root(above, nearing, bends), sp.oo)
    delay = barrier(2 * near_enough / barrier(absolute(nearing)))

    def outputs(arrives: sp.Basic, root: sp.Expr) -> dict[str, sp.Basic]:
        return {
            "stride": _shortened(arrives, root),
            "which": _first(arrives, index),
            "undecided_time": Choose(
                any_of(grazes, all_of(arrives, Not(_NO_EVENT))), 0, undecided_time
            ),
            "earliest_delay": Choose(all_of(arrives, _NO_EVENT), delay, earliest_delay),
        }

    return (
        loop_kernel(
            "beside_body",
            outputs(meets, first_root(clear, nearing, bends)),
            "Whether a rolling ball meets another surface; else a time for which it cannot.",
            _BELOW,
        ),
        loop_kernel(
            "beside_end_plane",
            outputs(crosses, to_end_plane),
            "Whether a rolling ball crosses an end plane; else a time for which it cannot.",
            _BELOW,
        ),
    )
