"""The limit of friction in rolling: a diagnostic, on which no decision rests.

Rolling takes the friction F along the surface, and the contact grips while |F| is at most mu N. The
ball is taken to roll in any case; the time at which the limit is first exceeded is recorded. The
excess F² - mu² N² and its rate are evaluated at the ends of the steps of the series; between two
ends a cubic interpolates them. An excess that begins and ends within one step is not seen.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from ..contact.ball import Ball
from ..contact.law import Law
from ..ir.kernel import Kernel, decision, loop_kernel
from ..motion.rolling_series import term
from ..symbolic.conditionals import Boolean, Choose, Equal, Less, all_of, barrier, maximum, minimum
from ..symbolic.error_terms import clock

grip_lost, last_grip_deficit, last_grip_deficit_rate, last_grip_clock = sp.symbols(
    "grip_lost last_grip_deficit last_grip_deficit_rate last_grip_clock", real=True
)
"""Time at which the limit was first exceeded, infinite if never; the excess F² - mu² N² one step
before, its rate, and that time."""

rolling_friction, rolling_friction_rate, force, force_rate, grip_deficit, grip_deficit_rate = (
    sp.symbols(
        "rolling_friction rolling_friction_rate force force_rate grip_deficit grip_deficit_rate",
        real=True,
    )
)
"""F², N and F² - mu² N², per unit mass, and their rates."""

loses = Boolean("loses")

NEWTON_STEPS = 4
"""Steps of Newton's method from the straight line between the ends, which the cubic is close to."""


def kernels(acceleration: Sequence[sp.Expr], ball: Ball) -> tuple[Kernel, ...]:
    """Return the kernels of the friction limit that all surfaces share.

    Parameters
    ----------
    acceleration
        That of the free ball, (3,), m/s².
    ball
        The radius and the inertia of the ball.
    """
    n, turned = ([term(f"n{axis}", k) for axis in "xyz"] for k in (0, 1))
    m, twisted = ([term(f"t{axis}", k) for axis in "xyz"] for k in (0, 1))
    s, spun = term("turn_rate", 0), term("turn_rate", 1)
    pressing, pressed = (
        barrier(sum(a * c for a, c in zip(acceleration, row, strict=True) if a != 0))
        for row in (n, turned)
    )
    pull = [
        barrier(ball.friction_share * (s * t - (a - pressing * c)))
        for t, a, c in zip(m, acceleration, n, strict=True)
    ]
    change = [
        barrier(ball.friction_share * (spun * t + s * dt + pressed * c + pressing * dc))
        for t, dt, c, dc in zip(m, twisted, n, turned, strict=True)
    ]
    squared = sum(f**2 for f in pull)
    first = all_of(Less(0, grip_deficit), Equal(grip_lost, sp.oo))
    return (
        loop_kernel(
            "ring_friction",
            {
                "rolling_friction": squared,
                "rolling_friction_rate": 2 * sum(f * r for f, r in zip(pull, change, strict=True)),
                "grip_deficit": -sp.oo,
                "grip_deficit_rate": 0,
            },
            "Square of the friction that rolling takes, per unit mass, and its rate.",
            "F = beta (-a_t + s n × n')",
        ),
        decision(
            "forget_grip_deficit",
            {"last_grip_deficit": sp.oo},
            "Start value of a contact: no excess is known.",
        ),
        loop_kernel(
            "exceeds_grip",
            {"loses": first},
            "Whether friction exceeds its limit for the first time.",
            "F² > mu² N²",
        ),
        loop_kernel(
            "grip_lost_time",
            {
                "grip_lost": Choose(
                    all_of(Less(last_grip_deficit, sp.oo), Less(last_grip_deficit, grip_deficit)),
                    _excess_time(),
                    clock,
                )
            },
            "Time at which friction first exceeded its limit.",
            "a cubic between the ends of a step",
        ),
        decision(
            "remember_grip_deficit",
            {
                "last_grip_deficit": grip_deficit,
                "last_grip_deficit_rate": grip_deficit_rate,
                "last_grip_clock": clock,
            },
            "Excess, rate and time at the end of this step, for the next one.",
        ),
    )


def friction_excess(law: Law) -> Kernel:
    """Return the kernel of the excess of friction over the law's limit, in squares."""
    friction = barrier(law.friction_coefficient**2) if law.friction_coefficient != sp.oo else sp.oo
    if friction == sp.oo:
        outputs = {"grip_deficit": -sp.oo, "grip_deficit_rate": sp.Integer(0)}
    else:
        outputs = {
            "grip_deficit": barrier(rolling_friction) - friction * barrier(force**2),
            "grip_deficit_rate": barrier(rolling_friction_rate)
            - friction * barrier(2 * barrier(force * force_rate)),
        }
    return loop_kernel(
        f"{law.name}_grip_deficit", outputs, "Excess F² - mu² N² and its rate.", "Coulomb's law"
    )


def _excess_time() -> sp.Expr:
    """Return the root of Hermite's cubic over the last step."""
    lasting = barrier(clock - last_grip_clock)
    rise = barrier(grip_deficit - last_grip_deficit)
    begun, ended = barrier(lasting * last_grip_deficit_rate), barrier(lasting * grip_deficit_rate)
    # The cubic is last_grip_deficit + begun p + bent p² + bow p³ for p from 0 to 1.
    bent, bow = barrier(3 * rise - 2 * begun - ended), barrier(begun + ended - 2 * rise)
    p = barrier(maximum(0, minimum(1, barrier(-last_grip_deficit / rise))))
    for _ in range(NEWTON_STEPS):
        value = barrier(last_grip_deficit + p * barrier(begun + p * barrier(bent + p * bow)))
        slope = barrier(begun + p * barrier(2 * bent + 3 * bow * p))
        # Newton's method where the cubic rises, else the slope of the straight line.
        moved = barrier(p - value / Choose(Less(0, slope), slope, rise))
        p = barrier(maximum(0, minimum(1, moved)))
    return last_grip_clock + p * lasting
