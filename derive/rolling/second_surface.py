"""The second surface that a flight begins on, after an impact of a ball in contact with a plane.

A ball that rolls on a plane and hits another body begins its flight on both, the true ball as well
as the computed one. So the errors of its position do not count across the plane, just as on return
to the surface that it touched last (`events.plane.returning_margin`): it lands on the plane after a
low hop, whose time would else be known no better than the error of the position over a small speed.
If the impact throws it onto the plane, both meet at once, and the ball is on the other body still.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from ..events.predicates import index, last, second, when, which
from ..ir.kernel import Kernel, decision
from ..state.fields import NONE
from ..symbolic.conditionals import AtMost, Boolean, Choose, Equal, Less, Not, Or, all_of
from .start import one_of
from .symbols import body, held

first, rested_on = sp.symbols("first rested_on", real=True)
"""Body touched first; the plane that a ball in contact was on before this event. -1: it flew."""

_ELSEWHERE = 2 * NONE
"""Its value for a ball in contact with a surface of another kind."""


def kernels(planes: Sequence[int]) -> dict[str, Kernel]:
    """Return the decisions about the surface that a flight begins on besides the one touched last.

    Parameters
    ----------
    planes
        The indices of the surfaces that a flight may begin on so, in order.
    """
    before = Choose(all_of(AtMost(when, 0), one_of(last, planes)), last, NONE)
    meets = Or(Equal(last, which), Equal(second, which))
    on_plane = one_of(held, planes)
    # A body that holds the ball for no time, and lets it go, has not moved it off the plane.
    still = all_of(Not(on_plane), AtMost(when, 0))
    made = (
        decision("no_rest", {"rested_on": NONE}, "Start value: the ball flew."),
        decision(
            "rest",
            {
                "rested_on": Choose(on_plane, held, _ELSEWHERE),
                "second": Choose(still, second, NONE),
            },
            "Plane that a ball in contact is on before an event.",
        ),
        decision(
            "touched",
            {
                "first": Choose(Less(first, 0), body, first),
                "last": which,
                "second": Choose(
                    Equal(rested_on, NONE), before, Choose(AtMost(0, rested_on), rested_on, NONE)
                ),
            },
            "Body touched first, surface touched last, and the plane that the ball is on besides.",
        ),
        decision(
            "again",
            {"again": all_of(Equal(which, index), meets)},
            "Whether the ball meets a surface again on which its flight began.",
        ),
        decision(
            "returned",
            {"again": all_of(Boolean("of_this_kind"), meets)},
            "Whether the ball meets a surface of a kind again on which its flight began.",
        ),
    )
    return {kernel.name: kernel for kernel in made}
