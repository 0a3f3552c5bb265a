"""The surface that the centre of a rolling ball stays on: a tube of constant radius, or a plane.

Or a cone, whose curvature changes with the distance from its axis.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import sympy as sp

Seam = tuple[sp.Expr, sp.Expr, sp.Expr]


@dataclass(frozen=True)
class ConicalSurface:
    """The cone that the centre of a rolling ball stays on.

    Attributes
    ----------
    axis
        The unit vector along its axis, from the apex into the cone.
    slope
        k, the tangent of the half-angle.
    per_cosine
        The inverse of the cosine of the half-angle, negative inside.
    per_width
        1/rho, where rho is the distance of the ball's centre from the axis, 1/m.
    """

    axis: tuple[sp.Expr, sp.Expr, sp.Expr]
    slope: sp.Expr
    per_cosine: sp.Expr
    per_width: sp.Expr


@dataclass(frozen=True)
class RollingSurface:
    """A tube about a point, a line or a circle around z; a plane; or a cone.

    Attributes
    ----------
    curved
        1 along the axes across which the surface is curved, else 0; of a tube that lies along no
        axis None.
    per_reach
        1/R of the tube, negative on its inside, 0 of a plane. Of a cone 1/rho: a bound on its
        curvature, and on how fast that changes along it, relative to itself.
    ring
        The radius of the circle.
    seams
        The coordinates at which the surface bends differently: a length as a function of the
        ball's centre, its value at the seam, and half the seam's width.
    across
        P, the projection of vectors onto the directions across which a tube in any direction is
        curved, in rows.
    cone
        The cone, which is curved along none of these directions; None for a tube and a plane.
    """

    curved: tuple[sp.Expr, sp.Expr, sp.Expr] | None
    per_reach: sp.Expr
    ring: sp.Expr = sp.Integer(0)
    seams: tuple[Seam, ...] = field(default=())
    across: Sequence[Sequence[sp.Expr]] | None = None
    cone: ConicalSurface | None = None

    @property
    def projection(self) -> list[list[sp.Expr]]:
        """P, also of a tube along an axis."""
        if self.across is not None:
            return [list(row) for row in self.across]
        assert self.curved is not None
        zero = sp.Integer(0)
        return [[own if i == j else zero for j in range(3)] for i, own in enumerate(self.curved)]
