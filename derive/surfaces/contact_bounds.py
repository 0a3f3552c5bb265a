"""Bounds (Eq. 2) of the point of contact, on surfaces where that is no linear map of the centre.

The ball with its centre at p touches the surface at q = p - R n(p). The normal turns at a rate of
at most kappa, the surface's `curvature`, so that

    |dq| = |dp - R dn| <= (1 + R kappa) |dp|.

A bound g that is a length as a function of q is thus one of p after a division by 1 + R kappa. On a
torus kappa contains 1/rho, and on a cone it is 2/rho, with the distance rho from the axis: near it
small errors of p move q far.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Protocol

import sympy as sp

from ..symbolic.conditionals import barrier
from ..symbolic.symbols import POSITION
from .bounds import as_length

ROUNDINGS = 12
"""By what a bound is divided for the roundings of q: a decision allows for four of a length, of
which a bound of q takes all, and q adds at most 44. Those are 2 for an offset from the centre, up
to 14 for turning it (8 of a component, as a vector), as many for turning it back, and a dozen for
the normal's sums, quotients and roots; what a division by rho amplifies, 1 + R kappa contains."""


class Touched(Protocol):
    """A surface of which the normal and its rate are known."""

    @property
    def curvature(self) -> sp.Expr:
        """Bound on the rate (1/m) at which the normal turns along the contact surface."""

    def nearest_point(self, ball_radius: sp.Expr) -> list[sp.Expr]:
        """Return the point of the body that a ball touches."""


@dataclass(frozen=True)
class ContactBounds:
    """Bounds (Eq. 2) of the point of contact.

    Attributes
    ----------
    polynomials
        Polynomials in the coordinates x, y, z of that point, at most 0 where the body exists.
    ball_radius
        R, m.
    """

    polynomials: tuple[sp.Expr, ...]
    ball_radius: sp.Expr


@dataclass(frozen=True)
class ContactPath:
    """The point of contact q as a function of the ball's centre p, and how fast it moves.

    Attributes
    ----------
    place
        q, (3,), m.
    stretch
        A bound on |Dq|.
    bend
        A bound on |D²q|, 1/m.
    per_range
        1/s, 1/m: both bounds hold while the centre moves by at most s.
    rates
        q' on the part of a box that the ball is on or moves onto, (3,), m/s; None where q is
        smooth.
    crease
        The distance of the centre from the nearest place where Dq jumps, m; None if there is none.
    """

    place: Sequence[sp.Expr]
    stretch: sp.Expr
    bend: sp.Expr
    per_range: sp.Expr
    rates: Sequence[sp.Expr] | None = None
    crease: sp.Expr | None = None


def path_about_axis(
    place: Sequence[sp.Expr],
    ball_radius: sp.Expr,
    linear: sp.Expr,
    radial: sp.Expr,
    per_rho: sp.Expr,
) -> ContactPath:
    """Return the path of the point of contact on a surface about an axis.

    The normal is a linear function of the centre plus a multiple of the unit vector e away from the
    axis, at the distance rho from it. A centre that moves with the speed v turns e by v/rho at
    most, and bends it by 2/sqrt(3) (v/rho)²: of its parts -2 v_r v_t/rho² along the turn and
    -v_t²/rho² towards the axis, with v_r² + v_t² = v². All holds down to half of rho.

    Parameters
    ----------
    place
        The point of contact, (3,), m.
    ball_radius
        R, m.
    linear
        The size of the linear function's matrix, 1/m.
    radial
        The size of the factor of e.
    per_rho
        1/rho, 1/m.
    """
    turns = barrier(radial * per_rho)
    return ContactPath(
        place,
        barrier(1 + barrier(ball_radius * barrier(linear + 2 * turns))),
        barrier(5 * ball_radius * barrier(turns * per_rho)),
        barrier(2 * per_rho),
    )


def at_contact(
    bounds: Iterable[sp.Expr], surface: Touched, ball_radius: sp.Expr
) -> tuple[sp.Expr, ...]:
    """Return bounds of the point of contact as bounds of the ball's centre, as lengths.

    Those that hold wherever the ball is are left out, as some do at the apex of a cone.

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
    lengths = (as_length(bound).xreplace(there) for bound in bounds)
    return tuple(barrier(g) / stretch for g in lengths if not g.is_nonpositive or g.free_symbols)
