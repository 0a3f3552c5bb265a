"""The bounds of a surface that a rolling ball is on or beside.

A bound counts as the distance e = -g/S with a number S that is at least the gradient of g. While
the ball moves by at most S/H, where H bounds the second derivatives of g, the gradient of e is at
most 2, so that e bends by at most 2 a + (H/S) v² with bounds on acceleration and speed.

On a cone or a box the bound is one of the point of contact q, which is no linear map of the
centre. With bounds B on |Dq| and N on |D²q| that hold while the centre moves by s, and a number T
that is at least the gradient of g at q, S = T B, and e bends by at most

    2 a + (2 N/B + H B/T) v²

while the ball moves by at most s and by T/(H B): with 1/s added to the factor of v², both hold for
its inverse.
"""

from __future__ import annotations

import sympy as sp

from ..errors.derivative import directional
from ..events.root_finder import first_root
from ..ir.kernel import Kernel, decision, loop_kernel
from ..surfaces import Surface
from ..surfaces.contact_bounds import ContactPath
from ..surfaces.plane import Flat
from ..surfaces.two_sided import TwoSided
from ..symbolic.conditionals import (
    AtMost,
    Boolean,
    Choose,
    Less,
    Not,
    Or,
    absolute,
    all_of,
    barrier,
    false,
    maximum,
    minimum,
    release,
)
from ..symbolic.rounding import position_error
from ..symbolic.symbols import POSITION, UNIT_ROUNDOFF, VELOCITY, position
from .symbols import (
    fastest,
    gap,
    gap_convexity,
    gap_curvature,
    nearing,
    outside_distance,
    outside_time,
    strongest,
)

MAX_DEGREE = 2
"""Highest degree of a bound: the second derivatives of such a polynomial are constant."""

bound_distance, bound_rate, bound_curvature = sp.symbols(
    "bound_distance bound_rate bound_curvature", real=True
)
"""Distance e within a bound, negative past it; its rate; and H/S, 1/m."""

crease = sp.Symbol("crease", nonnegative=True)
"""Distance of the ball from the nearest seam of a box beside it, m."""

on_bound, near_edge = map(Boolean, ("on_bound", "near_edge"))
"""True if a bound is undecided; of a ball near an edge of the surface below."""


def limits(surface: Surface) -> tuple[tuple[sp.Expr, ContactPath | None], ...]:
    """Return the polynomials that bound a surface: it is there where none is positive.

    Each stands with the path of the point of contact, or None if it is one of the ball's centre.
    """
    own = surface.limits if isinstance(surface, Flat | TwoSided) else ()
    path = surface.contact_path
    given = surface.contact_bounds.polynomials if surface.contact_bounds and path else ()
    return (*((limit, None) for limit in own), *((bound, path) for bound in given))


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
    for number, (limit, path) in enumerate(limits(surface)):
        part = f"rim{number}"
        kernels[part] = loop_kernel(
            f"{surface.name}_{part}",
            _as_distance(surface, limit, path, ball_radius),
            "Distance of the ball within a bound, its rate, and how fast the bound bends.",
            "Eq. 2",
        )
    if (path := surface.contact_path) is not None and path.crease is not None:
        kernels["crease"] = loop_kernel(
            f"{surface.name}_crease",
            {str(crease): path.crease},
            "Distance of the ball from where the point of contact changes its direction.",
            "Table 2",
        )
    return kernels


def _as_distance(
    surface: Surface, limit: sp.Expr, path: ContactPath | None, ball_radius: sp.Expr
) -> dict[str, sp.Expr]:
    """Return e, its rate and H/S of a bound, or what stands in its place at a point of contact."""
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
    if path is not None:
        gradient = [slope.as_expr() for slope in slopes]
        return _at_contact(sp.sympify(limit), gradient, steepness, curvature, path)
    per = barrier(1 / barrier(steepness))
    rate = sp.Add(
        *(barrier(slope.as_expr()) * v for slope, v in zip(slopes, VELOCITY, strict=True))
    )
    return {
        str(bound_distance): -barrier(limit) * per,
        str(bound_rate): -barrier(rate) * per,
        str(bound_curvature): barrier(curvature) * per,
    }


def _at_contact(
    limit: sp.Expr,
    gradient: list[sp.Expr],
    steepness: sp.Expr,
    curvature: sp.Expr,
    path: ContactPath,
) -> dict[str, sp.Expr]:
    """Return e, its rate and the factor of v² of a bound of the point of contact."""
    there = dict(zip(POSITION, path.place, strict=True))
    along = dict(zip(POSITION, VELOCITY, strict=True))
    stretch = barrier(path.stretch)
    per = barrier(1 / barrier(barrier(steepness.xreplace(there)) * stretch))
    rates = path.rates or [directional(place, along) for place in path.place]
    slopes = (barrier(slope.xreplace(there)) for slope in gradient)
    rate = sp.Add(*(barrier(s * v) for s, v in zip(slopes, rates, strict=True)))
    of_point = barrier(barrier(2 * path.bend) / stretch)
    of_bound = barrier(curvature * barrier(stretch**2 * per))
    return {
        str(bound_distance): -barrier(limit.xreplace(there)) * per,
        str(bound_rate): -barrier(rate) * per,
        str(bound_curvature): of_point + of_bound + path.per_range,
    }


def _size(coefficient: sp.Expr) -> sp.Expr:
    return absolute(coefficient) if coefficient.has(sp.Add) else sp.Abs(coefficient)


def roundings(ball_radius: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Return the distance at which an event has come, and that within which it is undecided."""
    landing = barrier(sp.Rational(1, 2**47) * barrier(sum(map(absolute, position)) + ball_radius))
    return landing, barrier(2 * position_error + landing)


def place_rounding(ball_radius: sp.Expr) -> sp.Expr:
    """Return a bound on the rounding of a place on a surface, m.

    Parameters
    ----------
    ball_radius
        The radius of the ball, m.
    """
    return 8 * UNIT_ROUNDOFF * barrier(sum(map(absolute, position)) + ball_radius)


def longest(speed: sp.Expr) -> sp.Expr:
    """Return the time for which the gradient of a bound's distance is at most 2."""
    return barrier(1 / barrier(bound_curvature * speed))


def outside(
    ball_radius: sp.Expr,
    name: str,
    acceleration: sp.Expr,
    speed: sp.Expr,
    summary: str,
    creased: bool = False,
) -> Kernel:
    """Return the kernel that bounds the time for which the ball stays outside a bound.

    At a seam of a box the rate of the distance jumps, but it is at most twice the ball's speed.

    Parameters
    ----------
    ball_radius
        R_B.
    name, summary
        The kernel's name, and what it says.
    acceleration, speed
        Bounds on those of the ball while its distance from the bound is extrapolated.
    creased
        True of the bounds of a box.
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
    if creased:
        until_seam = barrier(minimum(barrier(stays), barrier(crease / speed)))
        across = barrier(minimum(longest(speed), first_root(past, -2 * speed, bends)))
        stays = barrier(maximum(until_seam, Choose(Less(landing, past), across, 0)))
        straight = Less(barrier(near_enough * speed), barrier(outward * crease))
        certain = all_of(certain, straight)
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


def until_met(acceleration: sp.Expr, speed: sp.Expr) -> sp.Expr:
    """Return a time for which a surface with bounds is certainly not met from its front.

    A ball behind it meets it only after it has come to its front and turned round. From behind the
    gap bends up by `gap_convexity` times the squared speed at most, as long as the distance from
    the middle of a round body is at least half of what it is now.

    Parameters
    ----------
    acceleration, speed
        Bounds on those of the ball.
    """
    bends = barrier(acceleration + gap_curvature * speed**2)
    rises = barrier(bends + gap_convexity * speed**2)
    returns = maximum(
        0,
        barrier(minimum(sp.oo, first_root(barrier(-gap), -nearing, rises))),
        barrier(minimum(sp.oo, absolute(nearing) / rises)),
    )
    known = barrier(1 / barrier(gap_convexity * speed))
    behind = barrier(minimum(known, barrier(returns)))
    return Choose(Less(gap, 0), behind, first_root(gap, nearing, bends))


def bounds_kernels(ball_radius: sp.Expr) -> tuple[Kernel, ...]:
    """Return the kernels of bounds that all surfaces share.

    Parameters
    ----------
    ball_radius
        R_B.
    """
    summary = "Time for which a rolling ball certainly stays outside the bounds of a"
    motion = (strongest, fastest)
    return (
        decision(
            "unbounded",
            {str(outside_time): 0, str(outside_distance): -sp.oo, str(on_bound): false},
            "Start values: the ball is within all bounds of a surface.",
        ),
        outside(ball_radius, "outside_bound", *motion, f"{summary} surface."),
        outside(ball_radius, "outside_bound_of_box", *motion, f"{summary} box.", creased=True),
        decision(
            "outside_by",
            {str(outside_distance): maximum(outside_distance, -bound_distance)},
            "Distance of the ball from the bounds of a surface.",
        ),
    )
