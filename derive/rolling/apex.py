"""The apex of the cone that the centre of a rolling ball stays on, and the middle of a torus.

The curvature grows as 1/rho with the distance rho from the axis, without bound towards the apex.
From inside the ball touches all around there. A roll that comes so near ends, flagged. Outside the
apex of a cone is a body of its own, a sphere of centres, so that rho is never so small. Nor is it
on a torus, but where the ball all but fills the hole.
"""

from __future__ import annotations

import sympy as sp

from ..events.predicates import undecided_time, which
from ..ir.kernel import Kernel, decision, loop_kernel
from ..motion.rolling_series import per_width
from ..state.fields import NONE
from ..symbolic.conditionals import Choose, Equal, IfLess, Less, Or, all_of, barrier, minimum
from ..symbolic.rounding import position_error
from .symbols import EventCodes, nearest, stride

NEAREST_TO_AXIS = sp.Rational(1, 2**12)
"""Distance from the axis at which a roll ends, in units of the ball's radius: a thousand times that
at which the neighbouring motion begins (`neighbour.NEIGHBOUR_DISTANCE`), so that the difference of
both motions is about their derivative."""

LARGEST_ERROR = sp.Rational(1, 2**10)
"""Largest error of the position by rho: the square of that error, which no derivative contains, is
then a thousandth of it."""


def apex_kernels(ball_radius: sp.Expr, codes: EventCodes) -> tuple[Kernel, ...]:
    """Return the kernels of a ball near the axis of a cone or a torus; other surfaces have none.

    Parameters
    ----------
    ball_radius
        R_B, m.
    codes
        The indices of events in contact.
    """
    arrives = Less(1, barrier(barrier(NEAREST_TO_AXIS * ball_radius) * per_width))
    half = barrier(sp.Rational(1, 2) / barrier(IfLess(0, per_width, per_width, 1)))
    vague = Less(LARGEST_ERROR, barrier(position_error * per_width))
    return (
        loop_kernel(
            "reaches_apex",
            {
                "stride": Choose(arrives, 0, stride),
                "which": Choose(all_of(arrives, Equal(which, NONE)), codes.apex, which),
                "undecided_time": Choose(Or(arrives, vague), 0, undecided_time),
            },
            "Whether a rolling ball comes too near the axis of the surface.",
            "rho < R_B/4096",
        ),
        decision(
            "near_apex",
            {"nearest": minimum(nearest, IfLess(0, per_width, half, sp.oo))},
            "Half the distance from the axis, within which the curvature hardly changes.",
        ),
    )
