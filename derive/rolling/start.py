"""A ball that starts on a surface, as the caller says.

In its first turn nothing moves, and no contact happens: the turn only decides, as after a bounce,
whether the ball stays on the surface.

The caller's place of the ball may be off the surface. The formulas of the surface hold on it: there
the normal of a cylinder or a torus is a unit vector, and a ball that rolls does not slip. So the
ball is put onto the surface, along the normal, before anything is decided. A velocity along the
surface has a normal component of roundings, which would decide whether the ball hits the surface at
once: it is taken away. A larger one into the surface is an impact at time 0.

A ball may start where the force that presses it on vanishes, as one that goes on from the end of a
recorded contact. Nothing but roundings then says whether that force is positive. If it vanishes to
the roundings of a roll (`events.py`), and the gap of a flight from there opens, the contact ends.

The judge starts balls in the same way, with the same two limits. Near a limit a shot is flagged.
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
    IfAtMost,
    IfLess,
    Less,
    Not,
    absolute,
    all_of,
    any_of,
    barrier,
    false,
)
from ..symbolic.error_terms import dv, dx
from ..symbolic.symbols import UNIT_ROUNDOFF, normal, position, spin, velocity
from .bounds import place_rounding
from .symbols import STARTS, body, bounce, gap, gap_jerk, lift, mode, uncertain


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


def start_limits(strength: sp.Expr, ball_radius: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Return the speed and the force below which those of a ball at the start are roundings.

    They are 32 u of its speeds, times 1 + |x|/R for the roundings of its place, which turn the
    normal, and 2⁻⁴² of free fall and v²/R, the centripetal acceleration on a curve like the ball.

    Parameters
    ----------
    strength
        The size of the free ball's acceleration, m/s².
    ball_radius
        The radius of the ball, m.

    Returns
    -------
    tuple
        The speed along the normal, m/s, and the force along it per unit mass, m/s².
    """
    speeds = barrier(sum(map(absolute, velocity)) + ball_radius * barrier(sum(map(absolute, spin))))
    digits = barrier(1 + barrier(sum(map(absolute, position))) / ball_radius)
    curved = barrier(barrier(velocity.dot(velocity)) / ball_radius)
    force = barrier(sp.Rational(1, 2**42) * barrier(strength + curved))
    return barrier(32 * UNIT_ROUNDOFF * speeds * digits), force


class Start:
    """A ball that starts on a surface, in a kernel that decides whether it stays there.

    Parameters
    ----------
    strength, ball_radius
        As for `start_limits`.

    Attributes
    ----------
    along
        True if it starts along the surface, to roundings.
    enters
        True if it starts with a velocity into the surface. What is left of one that was taken away
        is less than half the limit.
    departs
        True if its contact ends at once: nothing presses it on, to roundings, and the gap opens.
    may_depart
        True if it is undecided whether that force is one of roundings.
    """

    def __init__(self, strength: sp.Expr, ball_radius: sp.Expr) -> None:
        speed_limit, force_limit = start_limits(strength, ball_radius)
        inward, force = barrier(-velocity.dot(normal)), absolute(lift)
        self.along = all_of(
            Equal(mode, STARTS), AtMost(bounce, speed_limit), AtMost(inward, speed_limit)
        )
        self.enters = all_of(Equal(mode, STARTS), Less(speed_limit / 2, inward))
        opens = all_of(self.along, Less(0, gap_jerk))
        self.departs = all_of(opens, AtMost(force, force_limit))
        near = all_of(Less(force_limit / 2, force), Less(force, 2 * force_limit))
        self.may_depart = all_of(opens, near)


def start_kernels(holders: Sequence[int], ball: Ball, strength: sp.Expr) -> tuple[Kernel, ...]:
    """Return the kernels of a ball that starts on a surface.

    Parameters
    ----------
    holders
        The indices of the surfaces that a ball can roll on, in order; there may be none.
    ball
        The radius and the inertia of the ball.
    strength
        The size of the free ball's acceleration, m/s².
    """
    speed_limit, _ = start_limits(strength, ball.radius)
    outward = barrier(velocity.dot(normal))
    rounding_off = IfAtMost(absolute(outward), speed_limit, outward, 0)
    near_limit = all_of(
        Less(speed_limit / 2, absolute(outward)), Less(absolute(outward), 2 * speed_limit)
    )
    slack = barrier(speed_limit / 32)
    per = barrier(1 / barrier(sp.sqrt(barrier(normal.dot(normal)))))
    off = barrier(gap * per)
    rounding = barrier(place_rounding(ball.radius))
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
        decision(
            "undecided_at_start",
            {"uncertain": Choose(near_limit, 1, uncertain)},
            "1 if it is undecided whether the speed along the normal is a rounding.",
        ),
        loop_kernel(
            "start_velocity_errors",
            {str(d): d + IfLess(d, 0, -slack, slack) for d in dv},
            "Errors with the rounding of a velocity along the surface.",
            "its bound",
        ),
        loop_kernel(
            "velocity_at_start",
            {str(v): v - rounding_off * n for v, n in zip(velocity, normal, strict=True)},
            "Velocity of a ball that starts on a surface, along it if it is so to roundings.",
            "the normal of Table 2",
        ),
    )
