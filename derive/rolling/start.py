"""A ball that starts on a surface, as the caller says.

In its first turn nothing moves, and no contact happens: the turn only decides, as after a bounce,
whether the ball stays on the surface.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from ..events.predicates import last
from ..ir.kernel import Kernel, decision
from ..state.fields import NONE
from ..symbolic.conditionals import AtMost, Boolean, Choose, Equal, Not, all_of, any_of, false
from .symbols import STARTS, body, mode


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


def start_decisions(holders: Sequence[int]) -> tuple[Kernel, ...]:
    """Return the decisions about a ball that starts on a surface.

    Parameters
    ----------
    holders
        The indices of the surfaces that a ball can roll on, in order; there may be none.
    """
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
    )
