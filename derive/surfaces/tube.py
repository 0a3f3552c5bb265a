"""What a ball rolls on: the surface that its centre stays on, as a tube of one radius."""

from __future__ import annotations

from dataclasses import dataclass, field

import sympy as sp


@dataclass(frozen=True)
class Tube:
    """A tube about a point, a line along an axis or a circle around z; a plane has no radius.

    Attributes
    ----------
    bent
        1 along the axes across which it is curved, else 0: the normal turns with those components
        of the velocity.
    per_reach
        1/R, negative on its inside; 0 of a plane.
    ring
        R_H of its circle about the origin; 0 if there is none.
    seams
        Coordinates, their values where the ball comes onto another part of the surface, and how
        near to those they count as there.
    """

    bent: tuple[sp.Expr, sp.Expr, sp.Expr]
    per_reach: sp.Expr
    ring: sp.Expr = sp.Integer(0)
    seams: tuple[tuple[sp.Expr, sp.Expr, sp.Expr], ...] = field(default=())
