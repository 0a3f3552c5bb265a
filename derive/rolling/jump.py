"""The errors of the jump from the last bounce to rolling.

The ball leaves with the speed V off the surface, and rolling is assumed at once, though its bounces
go on for T = 2 V/(N (1 - e)). Contacts change no component of W = v_t + kappa R_B (w × n), from
which the velocity follows as soon as the contact point rests: v = W/(1 + kappa). In flight and in
contact alike

    W' = a_t - v_n n' + kappa R_B w × n'

along the surface, with v_n = 0 for a rolling ball. On a plane n' = 0: after the bounces the ball
has the velocity of one that has rolled all the time. It lags behind it by what it slips, at most
d = 2 F V²/(N² (1 - e²)) + 2 beta |u| V/(N (1 - e)) with the slip u after the last contact.

On a surface of curvature k the three parts of W' differ, too. Each hop begins and ends with the
height 0, so that the integral of v_n n' is that of -h n'', less than h T |n''| with the height
h = V²/(2 N). The spin lags by R_B |dw| that adds up to d/kappa at most, and the normal turns
otherwise, since the ball is elsewhere by d and its centre is higher by h. With the speed U of the
ball and of its surface about its centre that makes at most

    d k U + h T (k |a| + 2 k² U²) + d T k |a|,   and   d + h T k U

for the path. All of it counts twice at least, and with it the roundings. The height counts along
the normal: it is gone when the bounces are. On a cone k is 1/rho, on a torus 1/R + 1/rho: with it
the bounds hold although the curvature, which is less, changes along the surface.
"""

from __future__ import annotations

import sympy as sp

from ..contact.ball import Ball
from ..contact.law import Law
from ..ir.kernel import Kernel, decision, loop_kernel
from ..motion import rolling_series
from ..motion.flight import Flight
from ..symbolic.conditionals import IfLess, absolute, barrier, barrier_all, maximum
from ..symbolic.error_terms import dv, dw, dx, greatest
from ..symbolic.symbols import UNIT_ROUNDOFF, normal, spin, velocity
from .bounds import place_rounding
from .settling import tolerance
from .symbols import bounce, gap, press, rebound, rolling_friction, slip, turning

_LEAST_LOSS = sp.Rational(1, 2**20)
"""Least 1 - e. A ball whose bounces never end only begins to roll where another surface hands it
over, with no more speed off the surface than roundings make."""


def jump_kernels(
    flight: Flight, ball: Ball, bounded: bool, revolved: bool = False
) -> tuple[Kernel, ...]:
    """Return the kernels of the errors after the jump to the limit of the bounces.

    Parameters
    ----------
    flight
        The motion between contacts.
    ball
        The ball.
    bounded
        True if the errors are those of the jump itself, in a scene in which they matter most: over
        the edge of a surface the time at which a ball reaches it is as uncertain as its place, and
        on an inclined plane a ball often rolls between impacts. Elsewhere, and in air, each counts
        as `tolerance`.
    revolved
        True if a ball may roll on a cone, near whose apex even small errors of the place turn the
        normal far, or on a torus.
    """
    return (
        decision(
            "no_bounce",
            {str(s): 0 for s in (rebound, *turning)},
            "Start values: nothing is known of the last bounce.",
        ),
        loop_kernel(
            "jump_errors",
            _errors_of_bounces(flight, ball)
            if bounded
            else _errors_of_tolerance(ball.radius, revolved),
            "Errors with those of the jump to the end of the bounces.",
            "its bound",
        ),
    )


def rebound_kernel(law: Law) -> Kernel:
    """Return the kernel of the restitution of bounces without speed.

    Parameters
    ----------
    law
        The contact law of the surface.
    """
    return loop_kernel(
        f"{law.name}_rebound",
        {str(rebound): law.restitution_at(sp.Integer(0))},
        "Restitution of the lowest bounces.",
        law.source,
    )


def _errors_of_tolerance(ball_radius: sp.Expr, revolved: bool) -> dict[str, sp.Expr]:
    """Return the errors after the jump to the limit of the bounces, which is off by `tolerance`."""
    grown = tolerance(ball_radius)
    speed = sum(map(absolute, velocity))
    rate = barrier(speed / ball_radius)
    if revolved:
        rate = barrier(rate + barrier(speed) * barrier(absolute(rolling_series.per_reach)))
    off = barrier(grown * 4 * (1 + rate))
    return _with((grown,) * 3, (off,) * 3, off / ball_radius)


def _errors_of_bounces(flight: Flight, ball: Ball) -> dict[str, sp.Expr]:
    """Return the errors after the jump, from the last bounce (see the head of this file)."""
    left = barrier(maximum(1 - rebound, _LEAST_LOSS))
    speed = barrier(sum(map(absolute, velocity)) + ball.radius * barrier(sum(map(absolute, spin))))
    bend = barrier(absolute(rolling_series.per_reach))
    turns = barrier(bend * speed)
    pulls = barrier(bend * flight.gravity)
    # A surface that takes the ball over has it at a distance, though of roundings alone.
    pressed = barrier(maximum(0, press))
    off = barrier(sp.sqrt(barrier(bounce**2 + 4 * pressed * absolute(gap))))
    hop = barrier(IfLess(0, press, off / barrier(IfLess(0, press, press, 1)), 0))
    height = barrier(barrier(hop * off) + absolute(gap))
    lasting = barrier(4 * hop / left)
    lag = barrier(
        4 * rolling_friction * hop**2 / left + 4 * barrier(ball.friction_share * slip) * hop / left
    )
    path = barrier(lag + barrier(height * lasting) * turns)
    change = barrier(
        4 * turns * lag
        + barrier(height * lasting) * barrier(2 * pulls + 4 * turns**2)
        + 2 * barrier(lag * lasting) * pulls
    )
    # Without a force onto the surface the ball has no further bounce: what it loses is all.
    lost = barrier(IfLess(0, press, 0, bounce + slip))
    place = barrier(path + place_rounding(ball.radius))
    # The errors of a contact that grips are those of a rolling ball, but for roundings.
    slipping = greatest(
        barrier_all(sp.Matrix(dv) - ball.radius * sp.Matrix(dw).cross(normal))
        - normal * barrier(sp.Matrix(dv).dot(normal))
    )
    pace = barrier(
        change + lost + barrier(ball.friction_share * slipping) + 8 * UNIT_ROUNDOFF * barrier(speed)
    )
    places = [barrier(place + height * absolute(n)) for n in normal]
    return _with(places, (pace,) * 3, pace / ball.radius)


def _with(
    places: list[sp.Expr] | tuple[sp.Expr, ...], paces: tuple[sp.Expr, ...], turn: sp.Expr
) -> dict[str, sp.Expr]:
    """Return the errors, each further from zero by its own."""
    units = zip((*dx, *dv, *dw), (*places, *paces, *(turn,) * 3), strict=True)
    return {str(d): d + IfLess(d, 0, -unit, unit) for d, unit in units}
