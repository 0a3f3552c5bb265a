"""The surface that the centre of a rolling ball stays on: a tube of constant radius, or a plane."""

from __future__ import annotations

from dataclasses import dataclass, field

import sympy as sp


@dataclass(frozen=True)
class RollingSurface:
    """A tube about a point, a line along an axis or a circle around z; or a plane."""

    curved: tuple[sp.Expr, sp.Expr, sp.Expr]
    per_reach: sp.Expr
    ring: sp.Expr = sp.Integer(0)
    seams: tuple[tuple[sp.Expr, sp.Expr, sp.Expr], ...] = field(default=())
