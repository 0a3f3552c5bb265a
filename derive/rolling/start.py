"""A ball that starts on a surface, as the caller says.

In its first turn nothing moves, and no contact happens: the turn only decides, as after a bounce,
whether the ball stays on the surface.

The caller's place of the ball may be off the surface. The formulas of the surface hold on it: there
the normal of a cylinder or a torus is a unit vector, and a ball that rolls does not slip. So the
ball is put onto the surface, along the normal, before anything is decided.

A ball may start where the force that presses it on vanishes, as one that goes on from the end of a
recorded contact. Nothing but roundings then says whether that force is positive. If it vanishes to
the roundings of a roll (`events.py`), and the gap of a flight from there opens, the contact ends.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from ..contact.ball import Ball
from ..events.predicates import last
from ..ir.kernel import Kernel, decision, loop_kernel
from ..state.fields import NONE
from ..symbolic.conditionals import (
    AtMost,
    Boolean,
    Choose,
    Equal,
    IfLess,
    Less,
    Not,
    absolute,
    all_of,
    any_of,
    barrier,
    false,
)
from ..symbolic.error_terms import dx
from ..symbolic.symbols import UNIT_ROUNDOFF, normal, position
from .symbols import STARTS, body, bounce, gap, gap_jerk, lift, mode


def one_of(surface: sp.Expr, indices: Sequence[int]) -> sp.Basic:
    """Return whether a surface is one of several.

    Parameters
    ----------
    surface
        The index of the surface.
    indices
        The indices of the others, in order; there may be none.
    """
    runs: list[list[int]] = []
    for own in indices:
        if runs and runs[-1][-1] == own - 1:
            runs[-1][1:] = [own]
        else:
            runs.append([own])
    within = [all_of(AtMost(run[0], surface), AtMost(surface, run[-1])) for run in runs]
    return any_of(*within) if within else false


def parts_at_start(pull: sp.Expr, rounding: sp.Expr) -> sp.Basic:
    """Return whether a ball starts where its contact ends, to the roundings of a roll.

    Parameters
    ----------
    pull
        A bound on what the force that presses the ball on consists of, per unit mass, m/s².
    rounding
        The rounding of a speed, m/s.
    """
    small = barrier(sp.Rational(1, 2**42) * pull)
    return all_of(
        Equal(mode, STARTS),
        AtMost(bounce, rounding),
        AtMost(absolute(lift), small),
        Less(0, gap_jerk),
    )


def start_kernels(holders: Sequence[int], ball: Ball) -> tuple[Kernel, ...]:
    """Return the kernels of a ball that starts on a surface.

    Parameters
    ----------
    holders
        The indices of the surfaces that a ball can roll on, in order; there may be none.
    ball
        The radius and the inertia of the ball.
    """
    per = barrier(1 / barrier(sp.sqrt(barrier(normal.dot(normal)))))
    off = barrier(gap * per)
    rounding = barrier(8 * UNIT_ROUNDOFF * barrier(sum(map(absolute, position)) + ball.radius))
    on_holder = one_of(last, holders)
    starts = Equal(mode, STARTS)
    return (
        decision(
            "started_on_surface",
            {"mode": Choose(on_holder, STARTS, 0)},
            "Whether the ball starts on a surface that it can roll on.",
        ),
        decision(
            "nothing_happens_yet",
            {
                "moves": all_of(Boolean("moves"), Not(starts)),
                "touches": all_of(Boolean("touches"), Not(starts)),
                "body": Choose(starts, NONE, body),
            },
            "Start on a surface: no event, whatever surface the turn is about.",
        ),
        decision(
            "slow_at_start",
            {"slow": starts},
            "Start value for a ball without a contact: whether it may stay where it starts.",
        ),
        decision(
            "off_at_start",
            {"put_on": starts},
            "Whether a ball starts on a surface, which it may be off by the caller's digits.",
        ),
        loop_kernel(
            "placed_at_start",
            {str(p): p - off * n for p, n in zip(position, normal, strict=True)},
            "Place of a ball that starts on a surface, put onto it along the normal.",
            "Table 2",
        ),
        loop_kernel(
            "start_errors",
            {str(d): d + IfLess(d, 0, -rounding, rounding) for d in dx},
            "Errors with the rounding of that place.",
            "its bound",
        ),
    )
