"""The surfaces that a rolling ball meets near an edge, or that take it over where it comes to one.

A surface takes a ball over without an impact where both touch it, with one normal, and it moves
neither off nor into them: at an edge of the surface below, or at a bound of its own.
"""

from __future__ import annotations

import sympy as sp

from ..events.predicates import index, undecided_time, which
from ..events.root_finder import first_root
from ..ir.kernel import Kernel, decision, loop_kernel
from ..state.fields import NONE
from ..symbolic.conditionals import (
    AtMost,
    Boolean,
    Choose,
    Equal,
    Less,
    Not,
    Or,
    absolute,
    all_of,
    any_of,
    barrier,
    false,
    maximum,
    minimum,
)
from ..symbolic.error_terms import dx, earliest_delay, greatest
from ..symbolic.symbols import velocity
from .bounds import (
    bound_curvature,
    bound_distance,
    bound_rate,
    near_edge,
    on_bound,
    roundings,
    until_met,
)
from .settling import tolerance
from .symbols import (
    EventCodes,
    fastest,
    gap,
    gap_curvature,
    nearing,
    normal_cosine,
    outside_time,
    stride,
    strongest,
)

enters, lingers = map(Boolean, ("enters", "lingers"))
"""True of a ball that comes in over a bound of the surface beside it; that moves along one."""

edge_delay, entry_delay = sp.symbols("edge_delay entry_delay", nonnegative=True)
"""Bounds on the errors of the times at which the ball reaches an edge of the surface below it, and
a bound of the surface beside it, s."""

bound_shift, edge_shift, entry_shift = sp.symbols("bound_shift edge_shift entry_shift", real=True)
"""Shares of the carried errors in the distance within a bound, m, and in those times, s."""

_NO_EVENT = Equal(which, NONE)

_WITHIN = AtMost(outside_time, 0)


def edge_delay_of(landing: sp.Expr) -> sp.Expr:
    """Return a bound on the delay of a crossing of a bound, by the sizes of the errors alone."""
    return barrier(barrier(4 * greatest(dx) + landing) / barrier(absolute(bound_rate)))


def entering(ball_radius: sp.Expr) -> tuple[Kernel, ...]:
    """Return the kernels of a ball that comes in over a bound of a surface beside it.

    Parameters
    ----------
    ball_radius
        R_B.
    """
    landing, near_enough = roundings(ball_radius)
    bends = barrier(2 * strongest + bound_curvature * fastest**2)
    size = barrier(absolute(bound_distance))
    own = edge_delay_of(landing)
    # The path does not depend on errors, which are there to decide what is undecided.
    comes = all_of(AtMost(size, landing), Less(0, bound_rate))
    steep = all_of(
        Less(0, bound_rate), Less(barrier(8 * bends * near_enough), barrier(bound_rate**2))
    )
    return (
        decision(
            "no_entry",
            {str(enters): false, str(lingers): false, str(entry_delay): 0, str(entry_shift): 0},
            "Start values: the ball comes over no bound of a surface.",
        ),
        loop_kernel(
            "entering_bound",
            {
                str(enters): Or(enters, comes),
                str(lingers): Or(lingers, all_of(AtMost(size, near_enough), Not(steep))),
                str(entry_delay): Choose(comes, maximum(entry_delay, own), entry_delay),
                str(entry_shift): Choose(comes, -bound_shift / bound_rate, entry_shift),
            },
            "Whether a rolling ball comes in over a bound of a surface beside it.",
            "a parabola below the distance",
        ),
    )


def continues_contact(
    ball_radius: sp.Expr,
    gap_change: sp.Expr | int = 0,
    speed_change: sp.Expr | int = 0,
    within: sp.Basic = _WITHIN,
) -> sp.Basic:
    """Return whether a rolling ball stays in contact if a surface takes it over where it is.

    Both surfaces touch the ball there, with one normal, and it moves neither off nor into them.

    Parameters
    ----------
    ball_radius
        R_B.
    gap_change, speed_change
        By how much more the gap and its rate may be off, m and m/s.
    within
        Whether the ball is within the bounds of that surface.
    """
    allowed = barrier(tolerance(ball_radius))
    slow = barrier(allowed * barrier(1 + barrier(sum(map(absolute, velocity))) / ball_radius))
    return all_of(
        Less(1 - sp.Rational(1, 2**20), normal_cosine),
        AtMost(absolute(gap), barrier(allowed + gap_change)),
        AtMost(absolute(nearing), barrier(slow + speed_change)),
        within,
    )


def meeting_kernels(ball_radius: sp.Expr, codes: EventCodes) -> tuple[Kernel, ...]:
    """Return the kernels of other surfaces near an edge of the one below, or at bounds of theirs.

    Parameters
    ----------
    ball_radius
        R_B.
    codes
        The indices of events in contact.
    """
    return (
        *entering(ball_radius),
        _meets(ball_radius, True, codes),
        _meets(ball_radius, False, codes),
        _meets(ball_radius, True, codes, True),
    )


def _meets(ball_radius: sp.Expr, bounded: bool, codes: EventCodes, entered: bool = False) -> Kernel:
    """Return the kernel that detects where a ball that rolls near an edge meets another surface.

    A surface whose normal is about that of the surface under the ball, and which the ball all but
    touches at the edge, is not met before: it may take the ball over there.

    A surface below that has no edge may continue, too, as the wire around a hole does in the green:
    along the line where both touch the ball, the other surface begins at a bound. A ball that is
    `entered` there comes over it at a certain time, at which the gap is zero, and its rate as well.
    The gap alone would not decide: before and after it is -k s²/2 at the way s from that line.
    """
    landing, near_enough = roundings(ball_radius)
    bends = barrier(strongest + gap_curvature * fastest**2)
    touches = AtMost(absolute(gap) if bounded else gap, landing)
    continues = all_of(near_edge, Less(1 - sp.Rational(1, 2**20), normal_cosine))
    sunk = barrier(-tolerance(ball_radius))
    shallow = AtMost(gap, barrier(sp.Rational(1, 2**18) * ball_radius))
    defers = all_of(continues, shallow, AtMost(sunk, gap))
    misfits = all_of(continues, Less(gap, sunk), AtMost(barrier(64 * sunk), gap))
    inside = (AtMost(outside_time, 0), Not(defers))
    meets = all_of(touches, Less(nearing, 0), *inside)
    grazes = all_of(
        AtMost(absolute(gap), near_enough),
        Not(Less(barrier(8 * bends * near_enough), barrier(nearing**2))),
        *inside,
        *((Less(nearing, 0),) if bounded else ()),
    )
    met = until_met(strongest, fastest) if bounded else first_root(gap, nearing, bends)
    root = barrier(Choose(touches, first_root(tolerance(ball_radius), nearing, bends), met))
    if entered:
        # Out of bounds the ball may touch the plane of a surface, but not the surface.
        root = Choose(
            all_of(touches, Less(1 - sp.Rational(1, 2**20), normal_cosine), Less(0, outside_time)),
            0,
            root,
        )
    # `maximum` would keep a parabola that is zero throughout, which limits no step.
    later = maximum(outside_time, Choose(defers, sp.oo, barrier(minimum(sp.oo, root))))
    if entered:
        return _taken_over(ball_radius, codes, meets, grazes, misfits, later)
    first = all_of(meets, _NO_EVENT)
    return loop_kernel(
        "beside_bounded_body" if bounded else "beside_body_at_edge",
        {
            "stride": Choose(meets, 0, minimum(stride, later)),
            "which": Choose(first, index, which),
            "undecided_time": Choose(
                any_of(grazes, misfits, all_of(meets, Or(on_bound, Not(_NO_EVENT)))),
                0,
                undecided_time,
            ),
            "earliest_delay": Choose(
                first, barrier(2 * near_enough / absolute(nearing)), earliest_delay
            ),
        },
        "Whether a rolling ball meets a surface within its bounds; else a time for which it "
        "cannot.",
        "parabolas below the distances",
    )


def _taken_over(
    ball_radius: sp.Expr,
    codes: EventCodes,
    meets: sp.Basic,
    grazes: sp.Basic,
    misfits: sp.Basic,
    later: sp.Expr,
) -> Kernel:
    """Return the kernel of `_meets` for a surface that may take the ball over from a torus."""
    _, near_enough = roundings(ball_radius)
    taken = all_of(enters, continues_contact(ball_radius))
    strikes = all_of(meets, Not(taken))
    delay = Choose(taken, barrier(16 * entry_delay), barrier(2 * near_enough / absolute(nearing)))
    first = all_of(Or(strikes, taken), _NO_EVENT)
    event = Choose(taken, codes.over_edge, index)
    return loop_kernel(
        "beside_entered_body",
        {
            "stride": Choose(Or(strikes, taken), 0, minimum(stride, later)),
            "which": Choose(first, event, which),
            "undecided_time": Choose(
                any_of(
                    all_of(any_of(grazes, misfits, all_of(meets, on_bound)), Not(taken)),
                    all_of(Or(strikes, taken), Not(_NO_EVENT)),
                    all_of(taken, lingers),
                ),
                0,
                undecided_time,
            ),
            "earliest_delay": Choose(first, delay, earliest_delay),
            str(edge_delay): Choose(taken, maximum(edge_delay, entry_delay), edge_delay),
            str(edge_shift): Choose(taken, entry_shift, edge_shift),
        },
        "Whether a ball on a torus meets a surface, or that takes it over at a bound; else a time "
        "for which neither can be.",
        "parabolas below the distances",
    )
