"""The bounds of a surface that a rolling ball is on or beside.

A bound counts as the distance e = -g/S with a number S that is at least the gradient of g. While
the ball moves by at most S/H, where H bounds the second derivatives of g, the gradient of e is at
most 2, so that e bends by at most 2 a + (H/S) v² with bounds on acceleration and speed.
"""

from __future__ import annotations

import sympy as sp

from ..events.predicates import index, undecided_time, which
from ..events.root_finder import first_root
from ..ir.kernel import Kernel, decision, loop_kernel
from ..state.fields import NONE
from ..surfaces import Surface
from ..surfaces.plane import Flat
from ..surfaces.two_sided import TwoSided
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
    release,
)
from ..symbolic.error_terms import dx, earliest_delay, greatest
from ..symbolic.rounding import position_error
from ..symbolic.symbols import POSITION, VELOCITY, position, velocity
from .settling import tolerance
from .symbols import (
    EventCodes,
    fastest,
    gap,
    gap_curvature,
    nearing,
    normal_cosine,
    outside_distance,
    outside_time,
    stride,
    strongest,
)

MAX_DEGREE = 2
"""Highest degree of a bound: the second derivatives of such a polynomial are constant."""

bound_distance, bound_rate, bound_curvature = sp.symbols(
    "bound_distance bound_rate bound_curvature", real=True
)
"""Distance e within a bound, negative past it; its rate; and H/S, 1/m."""

on_bound, near_edge = map(Boolean, ("on_bound", "near_edge"))
"""True if a bound is undecided; of a ball near an edge of the surface below."""

enters, lingers = map(Boolean, ("enters", "lingers"))
"""True of a ball that comes in over a bound of the surface beside it; that moves along one."""

edge_delay, entry_delay = sp.symbols("edge_delay entry_delay", nonnegative=True)
"""Bounds on the errors of the times at which the ball reaches an edge of the surface below it, and
a bound of the surface beside it, s."""

_NO_EVENT = Equal(which, NONE)


def limits(surface: Surface) -> tuple[sp.Expr, ...]:
    """Return the polynomials that bound a surface: it is there where none is positive."""
    return surface.limits if isinstance(surface, Flat | TwoSided) else ()


def bound_kernels(surface: Surface, ball_radius: sp.Expr) -> dict[str, Kernel]:
    """Return the kernel of each bound of a surface, by part: "rim0" and so on.

    Parameters
    ----------
    surface
        The surface.
    ball_radius
        R_B.

    Raises
    ------
    ValueError
        If the degree of a bound is above `MAX_DEGREE`.
    """
    kernels = {}
    for number, limit in enumerate(limits(surface)):
        part = f"rim{number}"
        kernels[part] = loop_kernel(
            f"{surface.name}_{part}",
            _as_distance(surface, limit, ball_radius),
            "Distance of the ball within a bound, its rate, and how fast the bound bends.",
            "Eq. 2",
        )
    return kernels


def _as_distance(surface: Surface, limit: sp.Expr, ball_radius: sp.Expr) -> dict[str, sp.Expr]:
    """Return e, its rate and H/S of a bound."""
    polynomial = sp.Poly(release(sp.sympify(limit)), *POSITION)
    if polynomial.total_degree() > MAX_DEGREE:
        raise ValueError(
            f"surface {surface.name}: expected bounds of a degree of at most {MAX_DEGREE} where "
            f"balls roll, got {limit}"
        )
    slopes = [polynomial.diff(place) for place in POSITION]
    bends = [slope.diff(place) for slope in slopes for place in POSITION]
    curvature = sp.Add(*(_size(bend.as_expr()) for bend in bends))
    steepness = sp.Add(
        *(
            _size(c) * sp.Mul(*(sp.Abs(x) ** k for x, k in zip(POSITION, powers, strict=True)))
            for slope in slopes
            for powers, c in slope.terms()
        )
    )
    if curvature == 0:
        constant = [slope.as_expr() for slope in slopes]
        if (sp.Add(*(c**2 for c in constant)) <= 1) == sp.true:
            steepness = sp.Integer(1)
    else:
        steepness = steepness + barrier(curvature * ball_radius)
    per = barrier(1 / barrier(steepness))
    rate = sp.Add(
        *(barrier(slope.as_expr()) * v for slope, v in zip(slopes, VELOCITY, strict=True))
    )
    return {
        str(bound_distance): -barrier(limit) * per,
        str(bound_rate): -barrier(rate) * per,
        str(bound_curvature): barrier(curvature) * per,
    }


def _size(coefficient: sp.Expr) -> sp.Expr:
    return absolute(coefficient) if coefficient.has(sp.Add) else sp.Abs(coefficient)


def roundings(ball_radius: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Return the distance at which an event has come, and that within which it is undecided."""
    landing = barrier(sp.Rational(1, 2**47) * barrier(sum(map(absolute, position)) + ball_radius))
    return landing, barrier(2 * position_error + landing)


def longest(speed: sp.Expr) -> sp.Expr:
    """Return the time for which the gradient of a bound's distance is at most 2."""
    return barrier(1 / barrier(bound_curvature * speed))


def outside(
    ball_radius: sp.Expr, name: str, acceleration: sp.Expr, speed: sp.Expr, summary: str
) -> Kernel:
    """Return the kernel that bounds the time for which the ball stays outside a bound.

    Parameters
    ----------
    ball_radius
        R_B.
    name, summary
        The kernel's name, and what it says.
    acceleration, speed
        Bounds on those of the ball while its distance from the bound is extrapolated.
    """
    landing, near_enough = roundings(ball_radius)
    bends = barrier(2 * acceleration + bound_curvature * speed**2)
    past, outward = barrier(-bound_distance), barrier(-bound_rate)
    moves_out = all_of(AtMost(absolute(past), landing), Less(0, outward))
    certain = all_of(Less(0, outward), Less(barrier(8 * bends * near_enough), barrier(outward**2)))
    # A parabola that is zero throughout has no root, which `minimum` passes over.
    stays = Choose(
        Less(landing, past),
        barrier(minimum(longest(speed), first_root(past, outward, bends))),
        Choose(moves_out, barrier(minimum(longest(speed), barrier(outward / bends))), 0),
    )
    return loop_kernel(
        name,
        {
            str(outside_time): maximum(outside_time, stays),
            str(outside_distance): maximum(outside_distance, past),
            str(on_bound): Or(on_bound, all_of(AtMost(absolute(past), near_enough), Not(certain))),
        },
        summary,
        "a parabola below the distance",
    )


def entering(ball_radius: sp.Expr) -> tuple[Kernel, ...]:
    """Return the kernels of a ball that comes in over a bound of a surface beside it.

    Parameters
    ----------
    ball_radius
        R_B.
    """
    landing, near_enough = roundings(ball_radius)
    bends = barrier(2 * strongest + bound_curvature * fastest**2)
    beside = AtMost(absolute(bound_distance), near_enough)
    certain = all_of(
        Less(0, bound_rate), Less(barrier(8 * bends * near_enough), barrier(bound_rate**2))
    )
    own = barrier(barrier(4 * greatest(dx) + landing) / barrier(absolute(bound_rate)))
    comes = all_of(beside, certain)
    return (
        decision(
            "no_entry",
            {str(enters): false, str(lingers): false, str(entry_delay): 0},
            "Start values: the ball comes over no bound of a surface.",
        ),
        loop_kernel(
            "entering_bound",
            {
                str(enters): Or(enters, comes),
                str(lingers): Or(lingers, all_of(beside, Not(certain))),
                str(entry_delay): Choose(comes, maximum(entry_delay, own), entry_delay),
            },
            "Whether a rolling ball comes in over a bound of a surface beside it.",
            "a parabola below the distance",
        ),
    )


def continues_contact(
    ball_radius: sp.Expr, gap_change: sp.Expr | int = 0, speed_change: sp.Expr | int = 0
) -> sp.Basic:
    """Return whether a rolling ball stays in contact if a surface takes it over where it is.

    Both surfaces touch the ball there, with one normal, and it moves neither off nor into them.

    Parameters
    ----------
    ball_radius
        R_B.
    gap_change, speed_change
        By how much more the gap and its rate may be off, m and m/s.
    """
    allowed = barrier(tolerance(ball_radius))
    slow = barrier(allowed * barrier(1 + barrier(sum(map(absolute, velocity))) / ball_radius))
    return all_of(
        Less(1 - sp.Rational(1, 2**20), normal_cosine),
        AtMost(absolute(gap), barrier(allowed + gap_change)),
        AtMost(absolute(nearing), barrier(slow + speed_change)),
        AtMost(outside_time, 0),
    )


def until_met(bends: sp.Expr) -> sp.Expr:
    """Return a time for which a thin surface is certainly not met from its front.

    Parameters
    ----------
    bends
        A bound on the second derivative of the gap.
    """
    # A ball behind a plate meets it only after it has come to its front and turned round.
    returns = maximum(
        0,
        barrier(minimum(sp.oo, first_root(barrier(-gap), -nearing, bends))),
        barrier(minimum(sp.oo, absolute(nearing) / bends)),
    )
    return Choose(Less(gap, 0), barrier(returns), first_root(gap, nearing, bends))


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
    met = until_met(bends) if bounded else first_root(gap, nearing, bends)
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
    """Return the kernel of `_meets` for a surface that may take the ball over from a ring."""
    _, near_enough = roundings(ball_radius)
    taken = all_of(enters, Not(lingers), continues_contact(ball_radius))
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
                ),
                0,
                undecided_time,
            ),
            "earliest_delay": Choose(first, delay, earliest_delay),
            str(edge_delay): Choose(taken, maximum(edge_delay, entry_delay), edge_delay),
        },
        "Whether a ball on a ring meets a surface, or that takes it over at a bound; else a time "
        "for which neither can be.",
        "parabolas below the distances",
    )


def bounds_kernels(ball_radius: sp.Expr, codes: EventCodes) -> tuple[Kernel, ...]:
    """Return the kernels of bounds that all surfaces share.

    Parameters
    ----------
    ball_radius
        R_B.
    codes
        The indices of events in contact.
    """
    return (
        decision(
            "unbounded",
            {str(outside_time): 0, str(outside_distance): -sp.oo, str(on_bound): false},
            "Start values: the ball is within all bounds of a surface.",
        ),
        outside(
            ball_radius,
            "outside_bound",
            strongest,
            fastest,
            "Time for which a rolling ball certainly stays outside the bounds of a surface.",
        ),
        decision(
            "outside_by",
            {str(outside_distance): maximum(outside_distance, -bound_distance)},
            "Distance of the ball from the bounds of a surface.",
        ),
        *entering(ball_radius),
        _meets(ball_radius, True, codes),
        _meets(ball_radius, False, codes),
        _meets(ball_radius, True, codes, True),
    )
