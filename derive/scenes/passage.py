"""The passage of a ball through a ring: a target counts for a ball that came from above.

The ball passes the ring's disc, z = 0 within the wire's centre circle, downwards or upwards. A ball
that has come up through it has not fallen through it, whatever it does then, unless it had fallen
in before. In a flight it passes upwards at most once, then downwards: at the roots of z, a
parabola, or in air as in `passage_in_air`.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import sympy as sp

from ..events.predicates import last, through
from ..ir.kernel import Kernel, decision, kernel
from ..motion.air import AirFlight
from ..motion.flight import Flight
from ..motion.parabola import Parabola
from ..symbolic.conditionals import (
    And,
    AtMost,
    Boolean,
    Choose,
    Equal,
    Less,
    Not,
    absolute,
    all_of,
    any_of,
    barrier,
    maximum,
    minimum,
)
from ..symbolic.rounding import ROUNDING_SLACK, position_error
from ..symbolic.symbols import POSITION, UNIT_ROUNDOFF, VELOCITY, t
from . import passage_in_air

x, y, z = POSITION
vx, vy, vz = VELOCITY

outcome, uncertain = sp.symbols("outcome uncertain", real=True)
over = Boolean("over")

FALLEN, NEITHER, RISEN = 1, 0, -1
"""Values of `through`: the ball is below the disc and came from above; it has not passed the
disc, or is above it again; it has come up through it without having fallen in."""


@dataclass(frozen=True)
class Passage:
    """The disc of a ring about the z axis, in the plane z = 0; gravity acts down.

    Attributes
    ----------
    radius
        The radius of the disc.
    depth
        A ball whose flight is resumed from a record within the disc's radius, no deeper below it
        than this, counts as come from above.
    """

    radius: sp.Expr
    depth: sp.Expr

    @property
    def sizes(self) -> tuple[sp.Expr, sp.Expr]:
        """Radius and depth."""
        return self.radius, self.depth


def next_state(before: sp.Expr, rises: sp.Basic, falls: sp.Basic) -> sp.Expr:
    """Return `through` after the ball has risen through the disc, fallen, or both.

    Parameters
    ----------
    before
        `through` before the flight.
    rises
        The condition that the ball rises through the disc during it.
    falls
        The condition that it falls through the disc, after any rise.
    """
    up = Choose(rises, Choose(Equal(before, FALLEN), NEITHER, RISEN), before)
    return Choose(And(falls, Equal(up, NEITHER)), FALLEN, up)


@dataclass(frozen=True)
class _DiscPassings:
    """The passings of the disc in a flight of time t.

    Attributes
    ----------
    rises, falls
        Whether the ball passes the disc's plane upwards, and downwards.
    up, down
        Squared distances from the axis then; without a passing, at an end of the flight.
    height, squared
        z at its end, and D = vz² + 2 g z, whose roots are both passings.
    """

    rises: sp.Basic
    falls: sp.Basic
    up: sp.Expr
    down: sp.Expr
    height: sp.Expr
    squared: sp.Expr


def _disc_passings(flight: Parabola) -> _DiscPassings:
    """Return the passings of the disc in a flight of time t."""
    there, _ = flight.at()
    height, gravity = barrier(there[2]), flight.strength
    squared = barrier(vz**2 + 2 * gravity * z)
    root, per_g = barrier(sp.sqrt(maximum(squared, 0))), barrier(1 / gravity)

    def away(time: sp.Expr) -> sp.Expr:
        met = barrier(minimum(t, maximum(0, barrier(time * per_g))))
        return barrier(barrier(x + vx * met) ** 2 + barrier(y + vy * met) ** 2)

    # A ball that is below at both ends is above in between if its apex is, within the flight.
    arch = all_of(Less(z, 0), Less(height, 0), Less(0, vz), Less(0, squared))
    arch = And(arch, Less(vz, barrier(gravity * t)))
    return _DiscPassings(
        any_of(arch, And(Less(z, 0), AtMost(0, height))),
        any_of(arch, And(Less(height, 0), AtMost(0, z))),
        away(vz - root),
        away(vz + root),
        height,
        squared,
    )


def _through_in_air(passage: Passage) -> dict[str, sp.Basic]:
    """Return `through` after a piece of a flight, up to time t."""
    limit = barrier(passage.radius**2)
    rises = And(passage_in_air.RISES, Less(passage_in_air.rise_away, limit))
    falls = And(passage_in_air.FALLS, Less(passage_in_air.fall_away, limit))
    return {"through": next_state(through, rises, falls)}


def _through(passage: Passage, flight: Parabola) -> dict[str, sp.Basic]:
    """Return `through` after a flight of time t."""
    passings, limit = _disc_passings(flight), barrier(passage.radius**2)
    rises = And(passings.rises, Less(passings.up, limit))
    return {"through": next_state(through, rises, And(passings.falls, Less(passings.down, limit)))}


def _astray(passage: Passage, flight: Parabola) -> dict[str, sp.Basic]:
    """Return the condition that the passings are undecided.

    **Lemma (passings of the disc).** Let p and v bound the norms of the errors of place and
    velocity at the start, and e the error of z throughout the flight, as `rounding` has it. If the
    condition does not hold, the true ball passes the disc upwards and downwards as the computed one
    does.

    *Proof.* Where the true ball is at z = 0, the computed z is within e of zero. The times at which
    the computed parabola is at c, |c| <= e, are (vz ± sqrt(D - 2 g c))/g: within sqrt(2 e/g) of the
    roots of D, of which `late` has twice that and their roundings. So a true passing is so near to
    a computed one. It exists where that exists, since both balls are on the same sides of the plane
    at both ends of the flight, where |z| > p and |z| > e, and at an apex between them, as |D| > 4 g
    e is twice e in height; unless the computed ball is then outside the disc by more than `slack`,
    and the true one outside, too. At the passings the places differ by at most p + v t and their
    roundings in norm, and by the way flown in `late`: `slack` contains both, and with 8 u V t in it
    the roundings of the distances. The true ball ends the flight later or earlier by a contact's
    delay; the bound on the place at the start of the next flight contains what that makes, and is
    tested there. ∎
    """
    passings, gravity = _disc_passings(flight), flight.strength
    there, moving = flight.rounding(t)
    per_g = barrier(1 / gravity)
    # The error of z, and that of D by its own roundings as a height.
    off = barrier(ROUNDING_SLACK * there.error + 8 * UNIT_ROUNDOFF * barrier(vz**2 * per_g))
    late = barrier(
        sp.sqrt(barrier(8 * off * per_g)) + 8 * UNIT_ROUNDOFF * barrier(absolute(vz) * per_g + t)
    )
    slack = barrier(ROUNDING_SLACK * (there.error + moving.magnitude * late))
    near = minimum(barrier(sp.sqrt(passings.up)), barrier(sp.sqrt(passings.down)))
    starts = all_of(Less(0, position_error), AtMost(absolute(z), position_error))
    stops = AtMost(absolute(passings.height), off)
    turns = all_of(Less(z, 0), Less(passings.height, 0), Less(0, vz))
    turns = And(turns, AtMost(absolute(passings.squared), barrier(4 * gravity * off)))
    undecided = And(any_of(starts, stops, turns), AtMost(near, barrier(passage.radius + slack)))

    def edge(passes: sp.Basic, squared: sp.Expr) -> sp.Basic:
        return And(
            passes, AtMost(absolute(barrier(barrier(sp.sqrt(squared)) - passage.radius)), slack)
        )

    sides = any_of(edge(passings.rises, passings.up), edge(passings.falls, passings.down))
    return {"undecided": any_of(undecided, sides)}


def _admitted(passage: Passage) -> dict[str, sp.Basic]:
    """Return `through` at the start; a release has passed nothing yet."""
    squared, limit = barrier(x**2 + y**2), barrier(passage.radius**2)
    below = all_of(AtMost(0, last), Less(z, 0), AtMost(-passage.depth, z))
    near = AtMost(absolute(barrier(squared - limit)), 8 * UNIT_ROUNDOFF * barrier(squared + limit))
    return {
        "through": Choose(And(below, Less(squared, limit)), FALLEN, NEITHER),
        "uncertain": Choose(all_of(below, near, Less(outcome, 0)), 1, uncertain),
    }


def _passed_in_contact(passage: Passage) -> dict[str, sp.Basic]:
    """Return `through` after a step in contact: a ball on the ring is far from the disc's edge."""
    within = Less(barrier(x**2 + y**2), barrier(passage.radius**2))
    rises = all_of(Not(over), AtMost(0, z), within)
    falls = all_of(over, Less(z, 0), within)
    return {"through": next_state(through, rises, falls)}


def _in_flight(
    passage: Passage, flight: Flight
) -> tuple[dict[str, sp.Basic], dict[str, sp.Basic], dict[str, passage_in_air.Formula]]:
    """Return the outputs of passings in a flight, and in air the kernels that find them.

    The outputs are what is passed, and whether it is undecided.

    Raises
    ------
    TypeError
        If there are none for the flight.
    """
    if isinstance(flight, AirFlight):
        undecided = {"undecided": passage_in_air.undecided(flight, passage.radius)}
        return _through_in_air(passage), undecided, passage_in_air.formulas(flight)
    if isinstance(flight, Parabola):
        return _through(passage, flight), _astray(passage, flight), {}
    raise TypeError(f"no passage along a {type(flight).__name__}")


def passage_kernels(
    passage: Passage, flight: Flight, order: Iterable[sp.Symbol]
) -> dict[str, Kernel]:
    """Return the kernels of a scene with a passage.

    Parameters
    ----------
    passage
        The ring whose disc is passed, and its radius.
    flight
        The motion between contacts.
    order
        The symbols of the scene in the order of arguments.

    Returns
    -------
    dict
        The kernels by name.

    Raises
    ------
    ValueError
        If free fall is not along -z.
    """
    if not flight.upright:
        raise ValueError("a ball passes a ring's disc where free fall is down, along -z")
    symbols = (last, outcome, uncertain, through, *order, *passage_in_air.SYMBOLS)
    passes, undecided, found = _in_flight(passage, flight)
    kernels = (
        *(kernel(name, made[0], symbols, *made[1:]) for name, made in found.items()),
        kernel(
            "passing_start",
            _admitted(passage),
            symbols,
            "Whether a ball counts as fallen through the ring at its start.",
            "Table 2, success",
        ),
        kernel(
            "passing",
            passes,
            symbols,
            "1 for a ball that fell through the ring's disc, -1 for one that came up, else 0.",
            f"{flight.source}, its roots in the ring's plane",
        ),
        kernel(
            "passing_undecided",
            undecided,
            symbols,
            "Whether the passing of the disc lies within its error.",
            "running error analysis",
        ),
        decision(
            "passing_from",
            {"over": AtMost(0, z)},
            "Whether a ball in contact is not below the ring's disc.",
        ),
        decision(
            "passing_in_contact",
            _passed_in_contact(passage),
            "Passing of the ring's disc in a step in contact.",
        ),
    )
    return {k.name: k for k in kernels}
