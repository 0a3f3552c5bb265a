"""Whether a ball has fallen through a ring: a target counts for one that came from above.

The ball passes the ring's disc, z = 0 within the wire's centre circle, downwards or upwards. One
that has come up through it has not fallen through it whatever it does then, unless it had fallen in
before. In a flight it passes upwards once at most, then downwards: at the roots of z, a parabola.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import sympy as sp

from ..flight.parabola import Parabola
from ..ground.choice import (
    AtMost,
    Both,
    Choose,
    Equal,
    Less,
    Not,
    Truth,
    every,
    hold,
    largest,
    size,
    smallest,
    some,
)
from ..ground.kernel import Kernel, decision, kernel
from ..ground.rounding import SAFETY, position_error
from ..ground.symbols import POSITION, UNIT_ROUNDOFF, VELOCITY, t
from ..search.decisions import last, through

x, y, z = POSITION
vx, vy, vz = VELOCITY

outcome, uncertain = sp.symbols("outcome uncertain", real=True)
over = Truth("over")

FALLEN, NEITHER, RISEN = 1, 0, -1
"""Values of `through`: the ball is down through the disc; it has not passed it, or is up again;
it has come up through it without having fallen in."""


@dataclass(frozen=True)
class Passage:
    """The disc of a ring about the z axis, in the plane z = 0; free fall is down.

    Attributes
    ----------
    radius
        Of the disc.
    depth
        A flight that goes on from a record, within the disc's radius and no deeper below it than
        this, is taken to have come from above.
    """

    radius: sp.Expr
    depth: sp.Expr

    @property
    def sizes(self) -> tuple[sp.Expr, sp.Expr]:
        """Both."""
        return self.radius, self.depth


def passed(before: sp.Expr, rises: sp.Basic, falls: sp.Basic) -> sp.Expr:
    """Return what `through` becomes where the ball rises through the disc, falls, or both."""
    up = Choose(rises, Choose(Equal(before, FALLEN), NEITHER, RISEN), before)
    return Choose(Both(falls, Equal(up, NEITHER)), FALLEN, up)


@dataclass(frozen=True)
class _Flown:
    """A flight of time t past the disc.

    Attributes
    ----------
    rises, falls
        Whether the ball passes the disc's plane upwards, and downwards.
    up, down
        Distances from the axis then, squared; where it does not, at an end of the flight.
    height, squared
        z at its end, and D = vz² + 2 g z, of which both passings are the roots.
    """

    rises: sp.Basic
    falls: sp.Basic
    up: sp.Expr
    down: sp.Expr
    height: sp.Expr
    squared: sp.Expr


def _flown(flight: Parabola) -> _Flown:
    if not flight.upright:
        raise ValueError("a ball passes a ring's disc where free fall is down, along -z")
    there, _ = flight.at()
    height, gravity = hold(there[2]), flight.strength
    squared = hold(vz**2 + 2 * gravity * z)
    root, per_g = hold(sp.sqrt(largest(squared, 0))), hold(1 / gravity)

    def away(time: sp.Expr) -> sp.Expr:
        met = hold(smallest(t, largest(0, hold(time * per_g))))
        return hold(hold(x + vx * met) ** 2 + hold(y + vy * met) ** 2)

    # Below at both ends, the ball is above in between: its apex is in the flight, and above.
    arch = every(Less(z, 0), Less(height, 0), Less(0, vz), Less(0, squared))
    arch = Both(arch, Less(vz, hold(gravity * t)))
    return _Flown(
        some(arch, Both(Less(z, 0), AtMost(0, height))),
        some(arch, Both(Less(height, 0), AtMost(0, z))),
        away(vz - root),
        away(vz + root),
        height,
        squared,
    )


def _through(passage: Passage, flight: Parabola) -> dict[str, sp.Basic]:
    """Return `through` after a flight of time t."""
    flown, limit = _flown(flight), hold(passage.radius**2)
    rises = Both(flown.rises, Less(flown.up, limit))
    return {"through": passed(through, rises, Both(flown.falls, Less(flown.down, limit)))}


def _astray(passage: Passage, flight: Parabola) -> dict[str, sp.Basic]:
    """Return where that is in doubt.

    With e a bound on the error of z throughout the flight, a true passing is where |z| <= e: within
    sqrt(8 e / g) of the computed one, the difference of the roots of D and of any D' within 2 g e.
    Whether there is one is in doubt where the ball is so near the plane at an end of the flight, or
    at an apex with |D| <= 4 g e; not if it surely is outside the disc then. What the time of a
    contact is off by is part of the position's error at the start of the next flight.
    """
    flown, gravity = _flown(flight), flight.strength
    there, moving = flight.rounding(t)
    per_g = hold(1 / gravity)
    # What z is off by, and what D is by its own roundings, as a height.
    off = hold(SAFETY * there.error + 8 * UNIT_ROUNDOFF * hold(vz**2 * per_g))
    late = hold(sp.sqrt(hold(8 * off * per_g)) + 8 * UNIT_ROUNDOFF * hold(size(vz) * per_g + t))
    slack = hold(SAFETY * (there.error + moving.magnitude * late))
    near = smallest(hold(sp.sqrt(flown.up)), hold(sp.sqrt(flown.down)))
    starts = every(Less(0, position_error), AtMost(size(z), position_error))
    stops = AtMost(size(flown.height), off)
    turns = every(Less(z, 0), Less(flown.height, 0), Less(0, vz))
    turns = Both(turns, AtMost(size(flown.squared), hold(4 * gravity * off)))
    vague = Both(some(starts, stops, turns), AtMost(near, hold(passage.radius + slack)))

    def edge(passes: sp.Basic, squared: sp.Expr) -> sp.Basic:
        return Both(passes, AtMost(size(hold(hold(sp.sqrt(squared)) - passage.radius)), slack))

    sides = some(edge(flown.rises, flown.up), edge(flown.falls, flown.down))
    return {"unsure": some(vague, sides)}


def _admitted(passage: Passage) -> dict[str, sp.Basic]:
    """Return `through` at the start; a release has passed nothing yet."""
    squared, limit = hold(x**2 + y**2), hold(passage.radius**2)
    below = every(AtMost(0, last), Less(z, 0), AtMost(-passage.depth, z))
    near = AtMost(size(hold(squared - limit)), 8 * UNIT_ROUNDOFF * hold(squared + limit))
    return {
        "through": Choose(Both(below, Less(squared, limit)), FALLEN, NEITHER),
        "uncertain": Choose(every(below, near, Less(outcome, 0)), 1, uncertain),
    }


def _passed_in_contact(passage: Passage) -> dict[str, sp.Basic]:
    """Return `through` after a step in contact: a ball on the ring is far from the disc's edge."""
    within = Less(hold(x**2 + y**2), hold(passage.radius**2))
    rises = every(Not(over), AtMost(0, z), within)
    falls = every(over, Less(z, 0), within)
    return {"through": passed(through, rises, falls)}


def passage_kernels(
    passage: Passage, flight: Parabola, order: Iterable[sp.Symbol]
) -> dict[str, Kernel]:
    """Return the kernels of a scene with a passage."""
    symbols = (last, outcome, uncertain, through, *order)
    made = (
        kernel(
            "passing_start",
            _admitted(passage),
            symbols,
            "Whether a ball starts as one that has fallen through the ring.",
            "Table 2, success",
        ),
        kernel(
            "passing",
            _through(passage, flight),
            symbols,
            "1 for a ball that is down through the ring's disc, -1 for one that came up, else 0.",
            "Eq. 3, its roots in the ring's plane",
        ),
        kernel(
            "passing_doubt",
            _astray(passage, flight),
            symbols,
            "Where that lies within its error.",
            "running error analysis",
        ),
        decision(
            "passing_from",
            {"over": AtMost(0, z)},
            "Whether a ball in contact is over the ring's disc, or beside it.",
        ),
        decision(
            "passing_in_contact",
            _passed_in_contact(passage),
            "The same for a ball in contact, after a step.",
        ),
    )
    return {k.name: k for k in made}
