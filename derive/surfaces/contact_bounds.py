"""Bounds (Eq. 2) of the point of contact, on surfaces where that is no linear map of the centre.

The ball with its centre at p touches the surface at q = p - R n(p). The normal turns at a rate of
at most kappa, the surface's `curvature`, so that

    |dq| = |dp - R dn| <= (1 + R kappa) |dp|.

A bound g that is a length as a function of q is thus one of p after a division by 1 + R kappa. On a
torus kappa contains 1/rho, and on a cone it is 2/rho, with the distance rho from the axis: near it
small errors of p move q far.
"""

from __future__ import annotations

from collections.abc import Iterable

import sympy as sp

from ..symbolic.conditionals import barrier
from ..symbolic.symbols import POSITION
from .bounds import as_length
from .surface import Surface

ROUNDINGS = 12
"""By what a bound is divided for the roundings of q: a decision allows for four of a length, of
which a bound of q takes all, and q adds at most 44. Those are 2 for an offset from the centre, up
to 14 for turning it (8 of a component, as a vector), as many for turning it back, and a dozen for
the normal's sums, quotients and roots; what a division by rho amplifies, 1 + R kappa contains."""


def at_contact(
    bounds: Iterable[sp.Expr], surface: Surface, ball_radius: sp.Expr
) -> tuple[sp.Expr, ...]:
    """Return bounds of the point of contact as bounds of the ball's centre, as lengths.

    Parameters
    ----------
    bounds
        Polynomials in the coordinates x, y, z of a point of the body, at most 0 where it exists.
    surface
        The surface that is touched, on which the ball's centre is.
    ball_radius
        R, m.
    """
    there = dict(zip(POSITION, surface.nearest_point(ball_radius), strict=True))
    # R (1/R + kappa): the number 1 in a sum would count as a length of the scene.
    bend = barrier(barrier(1 / ball_radius) + barrier(surface.curvature))
    stretch = barrier(barrier(ROUNDINGS * ball_radius) * bend)
    return tuple(barrier(as_length(bound).xreplace(there)) / stretch for bound in bounds)
