"""Event detection in balls: every event is certainly the earliest, or the shot is undecided.

The states are exact doubles at the release and balls from the first contact on. What is exact by
construction is kept exact: a ball is on the surface that it left last (the constant term of that
event polynomial is dropped), on a plane one coordinate is the plane's, and with restitution 0 it
leaves with a normal velocity of zero.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import TypeAlias

from flint import arb

from hoopgen.derive.scenes.passage import FALLEN

from . import passage
from .accumulation import Hops
from .arrivals import arrival_at, holds
from .earliest import clear_time, first_on_piece
from .error_set import condensed
from .formulas import Formulas, SurfaceFormulas
from .pieces import Piece, meets_nothing, next_piece
from .roots import Undecided
from .start import left_by, put_on
from .taylor_model import Number, TaylorModel, as_model, ball
from .validity import valid

Found: TypeAlias = tuple[int, Number, list[Number], list[tuple[Piece, Number]]]
"""Surface, time and state of an event, and the pieces of the flight until then."""

_RESTARTS = 4
"""Times that a box of flights is followed from a later state on, before it is undecided."""


@dataclass(frozen=True)
class Event:
    """A contact or the end: surface, time since the release, states (9,) before and after."""

    surface: int
    time: Number
    before: list[Number]
    after: list[Number]


@dataclass
class ProvedFlight:
    """The proved part of a shot.

    Attributes
    ----------
    found
        Of each event the number of its surface, and the time since the event before it.
    hops
        Of a ball whose bounces accumulate: the index of the first event of them; else -1. It has no
        outcome then.
    """

    outcome: int
    time: Number
    state: list[Number]
    events: list[Event] = field(default_factory=list)
    found: list[tuple[int, Number]] = field(default_factory=list)
    hops: int = -1


def fly(
    formulas: Formulas,
    state: Sequence[float] | Sequence[Number],
    parameters: Sequence[float],
    max_contacts: int,
    leaving: int = -1,
    time_limit: float = math.inf,
    known: Sequence[tuple[int, Number]] = (),
) -> ProvedFlight:
    """Return the shot's events and outcome, all proved at the current precision.

    If `leaving` is a body, the release is on it, whatever the last digits of the position say.

    Parameters
    ----------
    formulas
        The formulas of the scene.
    state
        The release: nine exact numbers, or balls; a proof holds for all numbers in them. With
        models of a box of releases it holds for all of the box.
    parameters
        The kernels' inputs, exact numbers.
    max_contacts
        The number of contacts at which a shot is capped.
    leaving
        The body that the ball leaves at the start, or -1.
    time_limit
        The time limit, s.
    known
        The first events of this very shot, as `ProvedFlight.found`, proved at a lower precision:
        which surface comes first is not asked again, and when it does only within that time.

    Raises
    ------
    Undecided
        If some decision cannot be made; its `args[1]` is the shot as far as it is proved.
    """
    values = [arb(value) for value in parameters]
    now: list[Number] = [c if isinstance(c, TaylorModel) else arb(c) for c in state]
    flown = ProvedFlight(formulas.outcomes["short"], arb(0), now)
    try:
        if not valid(formulas, now, values, leaving):
            return ProvedFlight(formulas.outcomes["invalid"], arb.nan(), [arb.nan()] * len(now))
        _follow(formulas, values, max_contacts, leaving, time_limit, known, flown)
    except Undecided as question:
        raise Undecided(question.args[0], flown) from None
    return flown


def _follow(
    formulas: Formulas,
    values: list[arb],
    max_contacts: int,
    leaving: int,
    time_limit: float,
    known: Sequence[tuple[int, Number]],
    flown: ProvedFlight,
) -> None:
    """Add event after event."""
    last = left_by(formulas, flown.state, values, leaving)
    vanishing = 1
    if last >= 0 and formulas.surfaces[last].allows_rolling:
        flown.state, vanishing = put_on(formulas, formulas.surfaces[last], flown.state, values)
    variables = max(len(as_model(component).slopes) for component in flown.state)
    own = formulas.passage
    sizes = None if own is None else own(values)
    hops = None if formulas.hop is None else Hops(formulas.hop)
    through = 1 if sizes is None else passage.at_start(sizes, flown.state, leaving)
    while True:
        if through is None:
            raise Undecided("whether the ball passes the ring's disc")
        start = flown.state
        if flown.events:
            vanishing = 2 if _stops(formulas.surfaces[last], flown, values) else 1
        remaining = None if math.isinf(time_limit) else arb(time_limit) - flown.time
        found = None
        if len(flown.events) < len(known):
            expected = known[len(flown.events)]
            found = _again(formulas, start, values, last, vanishing, expected)
        found = found or _next(formulas, start, values, last, vanishing, remaining)
        if found is None:
            return
        last, time, before, legs = found
        if sizes is not None:
            through = _through(through, sizes, legs, before)
        timed = last == len(formulas.surfaces)
        if timed:
            sunk = meets_nothing(formulas, before, values)
            if sunk is None:
                raise Undecided("whether the ball has sunk at the time limit")
            if sunk:
                return
        flown.found.append((last, time))
        flown.time = arb(time_limit) if timed else flown.time + time
        if last >= formulas.faces:
            flown.state = before
            flown.events.append(Event(formulas.bodies, flown.time, before, before))
            flown.outcome = formulas.outcomes["endless"]
            if not timed:
                flown.outcome = _crossing_outcome(formulas.surfaces[last], before, values, through)
            return
        after = _bounce(formulas.surfaces[last], before, values)
        flown.state = condensed(after, variables) if variables else after
        flown.events.append(Event(formulas.surfaces[last].body, flown.time, before, after))
        full = len(flown.events) >= max_contacts
        if hops is not None:
            surface = formulas.surfaces[last]
            hops.add(surface, _restitution(surface, before, values), after, values)
            flown.hops = hops.begin(len(flown.events), full)
            if flown.hops >= 0:
                return
        if full:
            flown.outcome = formulas.outcomes["capped"]
            return
        if variables:
            flown.time = ball(flown.time)  # models of before know another error set


def _through(
    through: int, sizes: Sequence[arb], legs: Sequence[tuple[Piece, Number]], end: list[Number]
) -> int | None:
    """Return the state of passage after the pieces of a flight, None if undecided."""
    found: int | None = through
    for k, (piece, time) in enumerate(legs):
        if found is None:
            return None
        if piece.exact:
            there = end if k == len(legs) - 1 else piece.at(time)
            found = passage.after(found, sizes, piece.start, there, time)
        else:
            found = passage.after_piece(found, sizes, piece.path, time)
    return found


def _stops(surface: SurfaceFormulas, flown: ProvedFlight, values: list[arb]) -> bool:
    """Return whether the ball left its last surface with no velocity along the normal."""
    return bool(_restitution(surface, flown.events[-1].before, values).is_zero())


def _restitution(surface: SurfaceFormulas, before: list[Number], values: list[arb]) -> Number:
    """Return the restitution of a contact, from the state before it."""
    assert surface.restitution is not None
    normal = surface.normal(before, values)
    speed = -sum((v * n for v, n in zip(before[3:6], normal, strict=True)), arb(0))
    found = surface.restitution(values, (speed,))[0]
    return found if isinstance(found, TaylorModel) else arb(found)


def _crossing_outcome(
    plane: SurfaceFormulas, state: list[Number], values: list[arb], through: int | None
) -> int:
    """Return the outcome of a crossing that counts: the first end whose bounds hold."""
    for name, outcome, bounds, passed in plane.ends:
        if passed and through != FALLEN:
            if through is None:
                raise Undecided("whether the ball passes the ring's disc")
            continue
        counts = holds(bounds, state, values)
        if counts is None:
            raise Undecided(f"the ball crosses the plane {plane.name} on the edge of {name}")
        if counts:
            return outcome
    raise AssertionError(f"the ball crosses the plane {plane.name} where there is no end")


def _again(
    formulas: Formulas,
    state: list[Number],
    values: list[arb],
    last: int,
    vanishing: int,
    expected: tuple[int, Number],
) -> Found | None:
    """Return an event that is known to be the first, at the present precision.

    None if it cannot be found so, as in a flight of several pieces, or at the time limit.
    """
    surface, time = expected
    if formulas.air is not None or surface >= len(formulas.surfaces):
        return None
    piece = next_piece(formulas, state, values)
    zeros = vanishing if surface == last else 0
    arrival = arrival_at(formulas, surface, piece, values, zeros, ball(time).upper())
    if arrival is None or not arrival.certain:
        return None
    return surface, arrival.time, piece.at(arrival.time), [(piece, arrival.time)]


def _next(
    formulas: Formulas,
    state: list[Number],
    values: list[arb],
    last: int,
    vanishing: int,
    remaining: Number | None,
) -> Found | None:
    """Return surface, time and state of the certainly earliest arrival, and the pieces until then.

    None if there is none. The time limit, `remaining` from now, counts as the last surface.
    """
    time = arb(0)
    legs: list[tuple[Piece, Number]] = []
    restarts = 0
    while not meets_nothing(formulas, state, values):
        piece = next_piece(formulas, state, values)
        left = None if remaining is None else remaining - time
        skipped = arb(0)
        if piece.has_models and last < 0 and not legs:
            skipped = clear_time(formulas, piece, values, 0.0, left)
        if skipped > 0:
            found: tuple[int, Number] | None = len(formulas.surfaces) + 1, skipped
        else:
            found = first_on_piece(
                formulas, piece, values, last, vanishing, left, restarts < _RESTARTS
            )
            restarts += 1
        if found is None:
            return None
        place, after = found
        legs.append((piece, after))
        state, time = piece.at(after), time + after
        if place <= len(formulas.surfaces):
            return place, time, state, legs
        last = -1
    return None


def _bounce(surface: SurfaceFormulas, before: list[Number], values: list[arb]) -> list[Number]:
    """Return the state after a contact, with exact components kept exact."""
    assert surface.impact is not None
    after = before[:3] + surface.impact(before, values, surface.normal(before, values))
    if any(component.is_nan() for component in after):
        raise Undecided(f"whether the ball slips on the {surface.name}")
    if surface.axis >= 0:
        after[surface.axis] = surface.offset(values)[0]
        after[3 + surface.axis] = -_restitution(surface, before, values) * before[3 + surface.axis]
    return after
