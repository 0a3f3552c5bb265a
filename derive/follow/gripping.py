"""When friction is asked for more than there is, while a ball rolls: a watch, no decision.

Rolling takes F along the surface, and grip lasts while |F| is at most mu N. The ball is taken to
roll on all the same; when it first would not is recorded. Looked at are the ends of the steps of
the series, with the rate at which F² - mu² N² changes there; between two of them it is a cubic. An
excess that begins and is over within one step is not seen.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from ..contact.law import Law
from ..errors.tangent import clock
from ..flight.rolling import SHARE, term
from ..ground.choice import Choose, Equal, Less, Truth, every, hold, largest, smallest
from ..ground.kernel import Kernel
from .settling import made

grip_lost, taut, taut_rate, taut_clock = sp.symbols(
    "grip_lost taut taut_rate taut_clock", real=True
)
"""When friction was first asked for more than there is, infinite if never; F² - mu² N² at the end
of the step before, its rate, and when that was."""
drag, drag_rate, force, force_rate, strain, strain_rate = sp.symbols(
    "drag drag_rate force force_rate strain strain_rate", real=True
)
"""F², N and F² - mu² N², per unit mass, and their rates."""
loses = Truth("loses")

STEPS = 4
"""Of Newton's method from the straight line between the ends; the cubic is nearly straight."""


def kernels(acceleration: Sequence[sp.Expr]) -> tuple[Kernel, ...]:
    """Return what all surfaces share."""
    n, turned = ([term(f"n{axis}", k) for axis in "xyz"] for k in (0, 1))
    m, twisted = ([term(f"t{axis}", k) for axis in "xyz"] for k in (0, 1))
    s, spun = term("turn_rate", 0), term("turn_rate", 1)
    pressing, pressed = (
        hold(sum(a * c for a, c in zip(acceleration, row, strict=True) if a != 0))
        for row in (n, turned)
    )
    pull = [
        hold(SHARE * (s * t - (a - pressing * c)))
        for t, a, c in zip(m, acceleration, n, strict=True)
    ]
    change = [
        hold(SHARE * (spun * t + s * dt + pressed * c + pressing * dc))
        for t, dt, c, dc in zip(m, twisted, n, turned, strict=True)
    ]
    squared = sum(f**2 for f in pull)
    first = every(Less(0, strain), Equal(grip_lost, sp.oo))
    return (
        made(
            "pulled",
            {
                "drag": squared,
                "drag_rate": 2 * sum(f * r for f, r in zip(pull, change, strict=True)),
                "strain": -sp.oo,
                "strain_rate": 0,
            },
            "The square of the friction that rolling takes, per unit mass, and its rate.",
            "F = beta (-a_t + s n × n')",
        ),
        made(
            "untaut",
            {"taut": sp.oo},
            "A contact begins, of which nothing is known yet.",
            "Table 1",
        ),
        made("losing", {"loses": first}, "Whether grip would not last any more.", "F² > mu² N²"),
        made(
            "lost_grip",
            {"grip_lost": Choose(every(Less(taut, sp.oo), Less(taut, strain)), _when(), clock)},
            "When friction began to be asked for more than there is.",
            "a cubic between the ends of a step",
        ),
        made(
            "tightened",
            {"taut": strain, "taut_rate": strain_rate, "taut_clock": clock},
            "What the next end of a step is seen beside.",
            "Table 1",
        ),
    )


def strained(law: Law) -> Kernel:
    """Return by how much the friction of rolling exceeds what a law allows, in squares."""
    friction = hold(law.coefficient**2) if law.coefficient != sp.oo else sp.oo
    if friction == sp.oo:
        outputs = {"strain": -sp.oo, "strain_rate": sp.Integer(0)}
    else:
        outputs = {
            "strain": hold(drag) - friction * hold(force**2),
            "strain_rate": hold(drag_rate) - friction * hold(2 * hold(force * force_rate)),
        }
    return made(f"{law.name}_strained", outputs, "F² - mu² N², and its rate.", "Coulomb's law")


def _when() -> sp.Expr:
    """Return the root of Hermite's cubic over the last step."""
    lasting = hold(clock - taut_clock)
    rise = hold(strain - taut)
    begun, ended = hold(lasting * taut_rate), hold(lasting * strain_rate)
    # taut + begun p + bent p² + bow p³ for p from 0 to 1.
    bent, bow = hold(3 * rise - 2 * begun - ended), hold(begun + ended - 2 * rise)
    p = hold(largest(0, smallest(1, hold(-taut / rise))))
    for _ in range(STEPS):
        value = hold(taut + p * hold(begun + p * hold(bent + p * bow)))
        slope = hold(begun + p * hold(2 * bent + 3 * bow * p))
        # Newton's method where the cubic rises, else the ends' line.
        moved = hold(p - value / Choose(Less(0, slope), slope, rise))
        p = hold(largest(0, smallest(1, moved)))
    return taut_clock + p * lasting
