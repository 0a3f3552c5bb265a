"""The surface that the centre of a rolling ball stays on: a tube of constant radius, or a plane.

Or a surface of revolution whose section is a line or a circle: a cone, or a torus.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import sympy as sp

from ..symbolic.conditionals import barrier

Seam = tuple[sp.Expr, sp.Expr, sp.Expr]
Vector = tuple[sp.Expr, sp.Expr, sp.Expr]

_ZERO = sp.Integer(0)


@dataclass(frozen=True)
class RevolvedSurface:
    """The cone or torus that the centre of a rolling ball stays on.

    Where the ball's centre is, e points away from the axis, and rho is the distance from it. With
    the rate Omega of the azimuth the normal turns by n' = v/R + c Omega (u × e).

    Attributes
    ----------
    axis
        u, the unit vector along the axis.
    outward
        e, the unit vector.
    per_width
        1/rho, 1/m.
    per_tube
        1/R, the curvature of the section, 1/m: 0 of a cone.
    azimuth_factor
        c: of a cone the cosine of the half-angle, negative inside; of a torus with the radius R_H
        of the tube's centre circle -R_H/R.
    """

    axis: Vector
    outward: Vector
    per_width: sp.Expr
    per_tube: sp.Expr
    azimuth_factor: sp.Expr


@dataclass(frozen=True)
class RollingSurface:
    """A tube about a point, a line or a circle around z; a plane; a cone; or a torus.

    Attributes
    ----------
    curved
        1 along the axes across which the surface is curved, else 0; of a tube that lies along no
        axis None.
    per_reach
        1/R of the tube, negative on its inside, 0 of a plane. Of a cone 1/rho, of a torus
        1/R + 1/rho: a bound on its curvature, and on how fast that changes along it, relative to
        itself.
    ring
        The radius of the circle around z.
    seams
        The coordinates at which the surface bends differently: a length as a function of the
        ball's centre, its value at the seam, and half the seam's width.
    across
        P, the projection of vectors onto the directions across which a tube in any direction is
        curved, in rows.
    revolved
        The cone or the torus, which is curved along none of these directions; None for a tube and
        a plane.
    """

    curved: Vector | None
    per_reach: sp.Expr
    ring: sp.Expr = _ZERO
    seams: tuple[Seam, ...] = field(default=())
    across: Sequence[Sequence[sp.Expr]] | None = None
    revolved: RevolvedSurface | None = None

    @property
    def projection(self) -> list[list[sp.Expr]]:
        """P, also of a tube along an axis."""
        if self.across is not None:
            return [list(row) for row in self.across]
        assert self.curved is not None
        return [[own if i == j else _ZERO for j in range(3)] for i, own in enumerate(self.curved)]


def toroidal(
    axis: Sequence[sp.Expr],
    across: Sequence[sp.Expr],
    rho: sp.Expr,
    ring_radius: sp.Expr,
    reach: sp.Expr,
) -> RollingSurface:
    """Return the torus that the centre of a ball stays on which rolls on a torus.

    Parameters
    ----------
    axis
        The unit vector along the axis, (3,).
    across
        The way from the axis to the ball's centre, (3,), m.
    rho
        Its length, m.
    ring_radius
        R_H, the radius of the tube's centre circle, m.
    reach
        R, the distance of the ball's centre from that circle, m.
    """
    per_width, per_tube = barrier(1 / rho), barrier(1 / reach)
    u, v, w = axis
    x, y, z = (part * per_width for part in across)
    azimuth_factor = -ring_radius * per_tube
    torus = RevolvedSurface((u, v, w), (x, y, z), per_width, per_tube, azimuth_factor)
    return RollingSurface((_ZERO, _ZERO, _ZERO), per_tube + per_width, revolved=torus)
