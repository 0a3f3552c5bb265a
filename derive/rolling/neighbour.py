"""Errors of a rolling ball, from a neighbouring motion that begins along the vector of errors.

The difference of the two motions after a step, scaled back, is the new vector of errors: a
difference quotient in the place of the derivative of the series.
"""

from __future__ import annotations

import sympy as sp

from ..events.predicates import when
from ..ir.kernel import Kernel, decision, loop_kernel
from ..motion.rolling_series import outward, per_width
from ..symbolic.conditionals import IfLess, absolute, barrier
from ..symbolic.error_terms import dv, dw, dx, greatest
from ..symbolic.symbols import UNIT_ROUNDOFF, normal, position, spin, velocity
from .symbols import gap, missed, stride

NEIGHBOUR_DISTANCE = sp.Rational(1, 2**22)
"""Distance at which the neighbouring motion begins, in units of the ball's radius."""

_STATES = (*position, *velocity, *spin)
_ERRORS = (*dx, *dv, *dw)


def neighbour_kernels(ball_radius: sp.Expr, revolved: bool = False) -> tuple[Kernel, ...]:
    """Return the kernels that propagate errors through a step in contact and a departure.

    Parameters
    ----------
    ball_radius
        R_B, m.
    revolved
        True if a ball may roll on a cone or a torus, from whose axis the neighbouring motion has a
        distance and a direction of its own.
    """
    worst = barrier(
        greatest(dx)
        + sp.Rational(1, 8) * barrier(greatest(dv) + ball_radius * greatest(dw))
        + UNIT_ROUNDOFF * ball_radius
    )
    scale = sp.Symbol("neighbour_scale", positive=True)
    far = {f"far_{s}": s + scale * d for s, d in zip(_STATES, _ERRORS, strict=True)}
    far |= {f"far_{s}": sp.Integer(0) for s in (*normal, gap)}
    if revolved:
        far |= {f"far_{s}": sp.Integer(0) for s in (per_width, *outward)}
    return (
        loop_kernel(
            "neighbour_scale",
            {"neighbour_scale": NEIGHBOUR_DISTANCE * ball_radius / worst},
            "Scale from the errors to the neighbouring motion.",
            "a chosen distance",
        ),
        decision("neighbour", far, "State of a neighbouring motion, along the errors."),
        loop_kernel(
            "compared",
            _compared(scale, ball_radius),
            "Errors after a step, with its roundings and truncation errors.",
            "differences",
        ),
        loop_kernel(
            "carry_hop",
            _after_departure(),
            "Errors after the flight of a departure.",
            "derivative of Eq. 3",
        ),
    )


def _compared(scale: sp.Expr, ball_radius: sp.Expr) -> dict[str, sp.Expr]:
    """Return the errors after a step: the scaled difference of the motions, and its roundings."""
    place_rounding = barrier(
        4 * UNIT_ROUNDOFF * barrier(sum(map(absolute, position)) + ball_radius)
    )
    velocity_rounding = barrier(
        4
        * UNIT_ROUNDOFF
        * barrier(sum(map(absolute, velocity)) + ball_radius * barrier(sum(map(absolute, spin))))
    )
    off = barrier(velocity_rounding + missed)
    roundings = (
        (barrier(place_rounding + missed * stride),) * 3 + (off,) * 3 + (off / ball_radius,) * 3
    )
    outputs = {}
    for s, d, unit in zip(_STATES, _ERRORS, roundings, strict=True):
        change = barrier(barrier(sp.Symbol(f"far_{s}", real=True) - s) / scale)
        outputs[str(d)] = change + IfLess(change, 0, -unit, unit)
    return outputs


def _after_departure() -> dict[str, sp.Expr]:
    """Return the errors of the position after the flight that follows a departure."""
    outputs = {}
    for d, drift, v, p in zip(dx, dv, velocity, position, strict=True):
        moved = barrier(d + drift * when)
        unit = UNIT_ROUNDOFF * barrier(absolute(p) + 2 * absolute(v) * when)
        outputs[str(d)] = moved + IfLess(moved, 0, -unit, unit)
    return outputs
