"""Tangential departure from a surface: for a while the gap certainly opens.

When the normal force vanishes, gap, rate and second derivative are zero. The third derivative is at
least `gap_jerk` - |`gap_snap`| t - C t²/2 with a generous C, so it stays positive for a while. A
ball that is thrown off has a second derivative to begin with. For that while the ball flies without
a search.
"""

from __future__ import annotations

import sympy as sp

from ..contact.ball import Ball
from ..events.predicates import excess, undecided_time
from ..events.root_finder import first_root
from ..ir.kernel import Kernel, decision, loop_kernel
from ..motion import rolling_series
from ..motion.flight import Flight
from ..symbolic.conditionals import (
    AtMost,
    Choose,
    Less,
    Not,
    absolute,
    all_of,
    any_of,
    barrier,
    maximum,
    minimum,
)
from ..symbolic.error_terms import clock
from ..symbolic.rounding import position_error, velocity_error
from ..symbolic.symbols import spin, velocity
from .bounds import outside, roundings, until_met
from .edges import falls_off
from .settling import tolerance
from .symbols import (
    free_time,
    gap,
    gap_curvature,
    gap_jerk,
    gap_snap,
    lift,
    near,
    nearing,
    outside_time,
    time_limit,
)

_OUTSIDE = "Time for which a ball that leaves certainly stays outside the bounds of a"


def departure_kernels(
    flight: Flight, gravity: sp.Expr, ball: Ball, edges: bool = False, oblique: bool = False
) -> tuple[Kernel, ...]:
    """Return the kernels of the first moment of flight after a tangential departure.

    Parameters
    ----------
    flight, ball, oblique
        As for `derive.rolling.contact_phase.kernels`.
    gravity
        The size of free fall, m/s².
    edges
        True if a ball may also come off an edge of the surface.
    """
    per = barrier(absolute(rolling_series.per_reach))
    longest = sp.Rational(1, 2**7)
    turned = barrier(ball.radius * barrier(sum(map(absolute, spin))))
    strength, slope = _strength(flight, gravity, turned, longest)
    speed = barrier(sum(map(absolute, velocity)) + strength * longest)
    # The ball also stays free of a body that it touches and moves away from.
    dipping = barrier(strength + gap_curvature * speed**2)
    away_from = Choose(Less(0, gap), nearing, -nearing)
    unmet = barrier(minimum(free_time, first_root(barrier(maximum(gap, 0)), nearing, dipping)))
    # A ball that touches a surface and moves into it is not behind it, whatever the rounding says.
    landing, _ = roundings(ball.radius)
    met_at_once = all_of(AtMost(absolute(gap), landing), Less(nearing, 0))
    met = barrier(minimum(sp.oo, until_met(strength, speed)))
    until_bounded = barrier(Choose(met_at_once, 0, met))
    # A ball behind an end plane crosses it only after it has come to its front and turned round.
    returns = barrier(
        maximum(
            barrier(first_root(barrier(maximum(-gap, 0)), -nearing, dipping)),
            barrier(absolute(nearing) / dipping),
        )
    )
    rate = barrier(speed * per + sp.sqrt(barrier(strength * per)) + 1 + slope)
    bends = barrier(64 * rate**3 * barrier(strength + speed**2 * per))
    fourth = barrier(absolute(gap_snap) + bends * sp.Rational(1, 2**30))
    opening = minimum(
        barrier(gap_jerk / (2 * fourth)), barrier(sp.sqrt(barrier(gap_jerk / (2 * bends))))
    )
    # Off an edge the gap closes instead: the ball is behind the surface at once.
    off = Choose(falls_off, -lift, lift) if edges else lift
    push = barrier(maximum(0, off))
    thrown_off = minimum(
        barrier(push / barrier(4 * absolute(gap_jerk) + bends * sp.Rational(1, 2**30))),
        barrier(sp.sqrt(barrier(push / (2 * fourth)))),
        barrier(sp.sqrt(barrier(push / (bends * longest)))),
    )
    opens_late = all_of(Less(0, gap_jerk), Not(falls_off)) if edges else Less(0, gap_jerk)
    # A body that takes a ball over, or the edge of a turned box, may throw it off with a third
    # derivative of roundings alone: both bounds hold, and the longer one counts.
    late = maximum(opening, thrown_off) if edges or oblique else opening
    away = barrier(Choose(opens_late, late, thrown_off))
    hop = barrier(minimum(longest, away, barrier(free_time / 4)))
    if not flight.exact:
        hop = barrier(minimum(hop, flight.span))
    lift_error = barrier(
        16
        * per
        * barrier(barrier(strength + speed**2 * per) * position_error + speed * velocity_error)
        + sp.Rational(1, 2**44) * strength
    )
    opens = any_of(Less(barrier(lift_error * rate), gap_jerk), Less(lift_error, lift))
    if edges:
        behind = all_of(
            Less(lift_error, off),
            Less(barrier(8 * (tolerance(ball.radius) + position_error)), barrier(off * hop**2)),
        )
        opens = any_of(all_of(falls_off, behind), all_of(Not(falls_off), opens))
    if not flight.exact:
        opens = all_of(opens, AtMost(excess, 0))
    return (
        decision("no_contact", {"free_time": sp.oo}, "Start value: no surface beside the ball."),
        loop_kernel(
            "neighbour_free_time",
            {"free_time": unmet},
            "Time for which a ball that leaves certainly meets no other body.",
            "a parabola below the distance",
        ),
        outside(ball.radius, "outside_bound_in_flight", strength, speed, f"{_OUTSIDE} surface."),
        outside(
            *(ball.radius, "outside_bound_of_box_in_flight", strength, speed, f"{_OUTSIDE} box."),
            creased=True,
        ),
        loop_kernel(
            "bounded_neighbour_free_time",
            {"free_time": minimum(free_time, maximum(outside_time, until_bounded))},
            "Time for which a ball that leaves certainly meets no other body within its bounds.",
            "parabolas below the distances",
        ),
        loop_kernel(
            "end_plane_free_time",
            {
                "free_time": Choose(Less(0, gap), unmet, free_time),
                "undecided_time": Choose(
                    any_of(Less(0, gap), Less(longest, returns)), undecided_time, 0
                ),
            },
            "Time for which a ball that leaves crosses no end plane; else that is undecided.",
            "a parabola below the distance",
        ),
        loop_kernel(
            "seam_free_time",
            {
                "free_time": Choose(
                    AtMost(absolute(gap), near),
                    free_time,
                    barrier(minimum(free_time, first_root(absolute(gap), away_from, strength))),
                )
            },
            "Time for which it certainly reaches no seam, where the distance bends differently.",
            "a parabola below the distance",
        ),
        loop_kernel(
            "separated",
            {
                # The flight begins after that time, and the time limit may come before.
                "when": maximum(0, minimum(hop, barrier(time_limit - clock))),
                "undecided_time": Choose(opens, undecided_time, 0),
            },
            "Time for which a ball that leaves a surface certainly meets neither it nor another.",
            "Taylor's theorem of the gap",
        ),
    )


def _strength(
    flight: Flight, gravity: sp.Expr, turned: sp.Expr, longest: sp.Expr
) -> tuple[sp.Expr, sp.Expr]:
    """Return bounds on the acceleration, and on its change by the velocity, after a departure.

    Parameters
    ----------
    flight
        The motion between contacts.
    gravity
        The size of free fall, m/s².
    turned
        A bound on the speed of the ball's surface about its centre, m/s.
    longest
        The longest time, s.
    """
    speed = barrier(sum(map(absolute, velocity)) + turned + 2 * gravity * longest)
    disturbance, slope = flight.disturbance(speed)
    return (gravity if disturbance == 0 else barrier(gravity + disturbance)), slope
